// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_BUBBLE_ANSWERS_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_BUBBLE_ANSWERS_2_H

#include <CGAL/Bubble_relaxation_2/internal/Distributed/Box_tree_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Distributed/Numbered_bubbles_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Distributed/Triangle_question_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Distributed/order_in_space.h>
#include <CGAL/Bubble_relaxation_2/internal/Hilbert_curve_2.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <tuple>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// whether all ranks know a bubble: those on the edges of the domain and its corners
inline bool is_on_outline(const Bubbles_2& b, std::size_t i)
{
  return b.is_on_edge(i) || (b.is_corner(i) && b.place[i] != no_index);
}

/// a bubble that the asker of a question did not know
struct Bubble_answer_2
{
  Bubble_record_2 bubble;
  std::int64_t question;
};

/// Answers the questions of other ranks from the bubbles of this one, and none twice to the same rank. A
/// triangle over a part of the domain that its rank hardly knows has a huge disc, so an answer names only
/// some bubbles, those next to the asker; if the triangle outlives them it will be asked about again.
class Bubble_answers_2
{
public:
  static constexpr std::size_t most_bubbles = 12; ///< in one answer: about two stars

  /// keeps references; `own`: this rank's bubbles
  Bubble_answers_2(const Numbered_bubbles_2& own, const Hilbert_curve_2& curve)
    : m_own(own), m_curve(curve)
  {}

  /// the bubble `i` was sent to `rank`
  void note_sent(int rank, Index i) { m_sent[rank].insert(i); }

  /// adds what a question of `rank` asks for
  void operator()(int rank, const Triangle_question_2& question, std::vector<Bubble_answer_2>& answers)
  {
    if (!m_is_collected)
      collect();
    std::unordered_set<Index>& sent = m_sent[rank];
    m_found.clear();
    m_tree.for_each_in(question.box(), [&](std::size_t k) { test(question, m_inner[k], sent); });
    const std::size_t n = (std::min)(m_found.size(), most_bubbles);
    std::partial_sort(m_found.begin(), m_found.begin() + static_cast<std::ptrdiff_t>(n), m_found.end(),
                      [](const Found& f, const Found& g) {
                        return std::tie(f.distance, f.i) < std::tie(g.distance, g.i);
                      });
    for (std::size_t k = 0; k < n; ++k) {
      const std::size_t i = static_cast<std::size_t>(m_found[k].i);
      answers.push_back({record(m_own.bubbles, i, m_own.numbers[i]), question.number});
      sent.insert(m_found[k].i);
    }
  }

private:
  struct Found
  {
    double distance;
    Index i;
  };

  void collect()
  {
    const Bubbles_2& b = m_own.bubbles;
    std::vector<Point> points;
    for (Index i : order_in_space(m_curve, b))
      if (!is_on_outline(b, static_cast<std::size_t>(i))) {
        m_inner.push_back(i);
        points.push_back(b.point(static_cast<std::size_t>(i)));
      }
    m_tree = Box_tree_2(std::move(points));
    m_is_collected = true;
  }

  void test(const Triangle_question_2& question, Index i, const std::unordered_set<Index>& sent)
  {
    const Point p = m_own.bubbles.point(static_cast<std::size_t>(i));
    if (sent.count(i) != 0 || !question.concerns(p))
      return;
    const double dx = p.x() - question.x[question.vertex], dy = p.y() - question.y[question.vertex];
    m_found.push_back(Found{dx * dx + dy * dy, i});
  }

  const Numbered_bubbles_2& m_own;
  const Hilbert_curve_2& m_curve;
  bool m_is_collected = false;
  std::vector<Index> m_inner; // those that others may not know
  Box_tree_2 m_tree;           // of these
  std::map<int, std::unordered_set<Index>> m_sent;
  std::vector<Found> m_found;
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_BUBBLE_ANSWERS_2_H
