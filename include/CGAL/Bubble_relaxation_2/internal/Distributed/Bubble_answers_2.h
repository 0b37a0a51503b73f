// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_BUBBLE_ANSWERS_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_BUBBLE_ANSWERS_2_H

#include <CGAL/Bubble_relaxation_2/internal/Distributed/Numbered_bubbles_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Distributed/Triangle_question_2.h>
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
    if (m_places.empty())
      sort_along_curve();
    m_found.clear();
    const Box box{m_curve.column(question.xmin), m_curve.column(question.xmax),
                  m_curve.row(question.ymin), m_curve.row(question.ymax)};
    search(question, box, 0, 0, Hilbert_curve_2::levels, m_sent[rank]);
    const std::size_t n = (std::min)(m_found.size(), most_bubbles);
    std::partial_sort(m_found.begin(), m_found.begin() + static_cast<std::ptrdiff_t>(n), m_found.end(),
                      [](const Found& f, const Found& g) {
                        return std::tie(f.distance, f.i) < std::tie(g.distance, g.i);
                      });
    for (std::size_t k = 0; k < n; ++k) {
      const std::size_t i = static_cast<std::size_t>(m_found[k].i);
      answers.push_back({record(m_own.bubbles, i, m_own.numbers[i]), question.number});
      note_sent(rank, m_found[k].i);
    }
  }

private:
  using Key = Hilbert_curve_2::Key;

  struct Place
  {
    Key key;
    Index i;
  };

  struct Found
  {
    double distance;
    Index i;
  };

  /// cells
  struct Box
  {
    std::uint32_t first_column, last_column, first_row, last_row;
  };

  void sort_along_curve()
  {
    const Bubbles_2& b = m_own.bubbles;
    for (std::size_t i = 0; i < b.size(); ++i)
      if (!is_on_outline(b, i))
        m_places.push_back(Place{m_curve.key(b.x[i], b.y[i]), static_cast<Index>(i)});
    std::sort(m_places.begin(), m_places.end(), [](const Place& p, const Place& q) {
      return std::tie(p.key, p.i) < std::tie(q.key, q.i);
    });
  }

  /// searches a square of 2^level cells in a row, as far as it is in the box
  void search(const Triangle_question_2& question, const Box& box, std::uint32_t column, std::uint32_t row,
              int level, const std::unordered_set<Index>& sent)
  {
    constexpr std::ptrdiff_t few = 8;
    const bool is_all = level == Hilbert_curve_2::levels;
    if (!is_all && (column > box.last_column >> level || column < box.first_column >> level ||
                    row > box.last_row >> level || row < box.first_row >> level))
      return;
    auto first = m_places.begin(), last = m_places.end();
    if (!is_all) {
      const Key low = Hilbert_curve_2::key_of_cell(column, row, Hilbert_curve_2::levels - level) << 2 * level;
      const Key high = low | ((Key(1) << 2 * level) - 1);
      first = std::lower_bound(first, last, low, [](const Place& p, Key key) { return p.key < key; });
      last = std::upper_bound(first, last, high, [](Key key, const Place& p) { return key < p.key; });
    }
    if (last - first <= few || level == 0) {
      for (; first != last; ++first)
        test(question, first->i, sent);
      return;
    }
    for (std::uint32_t quarter = 0; quarter < 4; ++quarter)
      search(question, box, 2 * column + (quarter & 1), 2 * row + (quarter >> 1), level - 1, sent);
  }

  void test(const Triangle_question_2& question, Index i, const std::unordered_set<Index>& sent)
  {
    const Point p = m_own.bubbles.point(i);
    if (p.x() < question.xmin || p.x() > question.xmax || p.y() < question.ymin || p.y() > question.ymax)
      return;
    if (sent.count(i) != 0 || !question.concerns(p))
      return;
    const double dx = p.x() - question.x[question.vertex], dy = p.y() - question.y[question.vertex];
    m_found.push_back(Found{dx * dx + dy * dy, i});
  }

  const Numbered_bubbles_2& m_own;
  const Hilbert_curve_2& m_curve;
  std::vector<Place> m_places; // of those that others may not know
  std::map<int, std::unordered_set<Index>> m_sent;
  std::vector<Found> m_found;
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_BUBBLE_ANSWERS_2_H
