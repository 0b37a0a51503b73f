// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_MESH_QUERY_ANSWERS_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_MESH_QUERY_ANSWERS_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/reproducible_math.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/parts/bubble_records.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Bubble_buckets_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Marked_triangulation_2.h>

#include <CGAL/Bbox_2.h>
#include <CGAL/Kernel/global_functions_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

struct Disc_2
{
  double x, y, radius;
};

/// The question whether any point that a rank does not know lies where it would change one of its triangles:
/// in the circumscribed disc, and not beyond a side that is a constraint. What lies beyond such a side is
/// hidden by it, since all of the disc there is cut off by that side; unless it lies on it, and is beyond by a rounding.
struct Triangle_question_2
{
  std::array<double, 3> x, y; ///< the vertices, counterclockwise
  Disc_2 disc; ///< all that matters lies in it
  std::array<std::int32_t, 3> is_hidden; ///< for each vertex, what lies beyond the opposite side
  std::int32_t vertex; ///< points near to this one matter first
  std::int32_t number; ///< of the question, among those of its rank

  Point point(int i) const { return Point(x[i], y[i]); }

  /// exact
  bool concerns(const Point& q, bool is_on_edge) const
  {
    const Point a = point(0), b = point(1), c = point(2);
    if (CGAL::side_of_bounded_circle(a, b, c, q) == ON_UNBOUNDED_SIDE)
      return false;
    for (int i = 0; i < 3; ++i)
      if (!is_on_edge && is_hidden[i] && CGAL::orientation(point(ccw(i)), point(cw(i)), q) == RIGHT_TURN)
        return false;
    return true;
  }
};

/// The circumscribed disc of a triangle, or a bit more; that of the domain's box if rounding hides it.
inline Disc_2 disc_that_matters(const Bubble_mesh_2& mesh, Index t, const Bbox_2& box)
{
  constexpr double margin = 1e-6;
  const Point p = mesh.point(t, 0), q = mesh.point(t, 1), r = mesh.point(t, 2);
  const double ax = q.x() - p.x(), ay = q.y() - p.y(), bx = r.x() - p.x(), by = r.y() - p.y();
  const double a = ax * ax + ay * ay, b = bx * bx + by * by, area2 = ax * by - ay * bx;
  if (!(area2 > margin * (a + b))) {
    const double dx = (box.xmax() - box.xmin()) / 2, dy = (box.ymax() - box.ymin()) / 2;
    return Disc_2{box.xmin() + dx, box.ymin() + dy, (1 + margin) * length_of(dx, dy)};
  }
  const double x = (by * a - ay * b) / (2 * area2), y = (ax * b - bx * a) / (2 * area2);
  const double rounding = 4 * std::numeric_limits<double>::epsilon() * (std::abs(p.x()) + std::abs(p.y()));
  return Disc_2{p.x() + x, p.y() + y, (1 + margin) * length_of(x, y) + rounding};
}

inline Triangle_question_2 make_question(const Bubble_mesh_2& mesh, Index t, const Disc_2& disc, int vertex,
                                         std::int32_t number)
{
  Triangle_question_2 question{};
  for (int i = 0; i < 3; ++i) {
    question.x[i] = mesh.point(t, i).x();
    question.y[i] = mesh.point(t, i).y();
    question.is_hidden[i] = mesh.triangles.edges[t][i] != no_index;
  }
  question.disc = disc;
  question.vertex = vertex;
  question.number = number;
  return question;
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
class Query_answers_2
{
public:
  static constexpr std::size_t most_bubbles = 12; ///< in one answer: about two stars

  /// keeps a reference to this rank's bubbles
  explicit Query_answers_2(const Bubbles_2& own) : m_own(own) {}

  /// the bubble `i` was sent to `rank`
  void note_sent(int rank, Index i) { m_sent[rank].insert(i); }

  /// all ranks got what is on edges
  void note_outline_known()
  {
    m_is_outline_known = true;
    m_inner.reset();
  }

  /// adds what a question of `rank` asks for
  void operator()(int rank, const Triangle_question_2& question, std::vector<Bubble_answer_2>& answers)
  {
    if (!m_inner)
      collect();
    std::unordered_set<Index>& sent = m_sent[rank];
    std::vector<std::pair<double, Index>> found; // by distances
    m_inner->for_each_within(question.disc.x, question.disc.y, question.disc.radius, [&](const auto& e, double) {
      const std::size_t i = static_cast<std::size_t>(e.id);
      if (sent.count(e.id) == 0 && question.concerns(m_own.point(i), m_own.is_on_edge(i))) {
        const double dx = e.x - question.x[question.vertex], dy = e.y - question.y[question.vertex];
        found.emplace_back(dx * dx + dy * dy, e.id);
      }
      return true;
    });
    const std::size_t n = (std::min)(found.size(), most_bubbles);
    std::partial_sort(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(n), found.end());
    for (std::size_t k = 0; k < n; ++k) {
      answers.push_back({record(m_own, static_cast<std::size_t>(found[k].second)), question.number});
      sent.insert(found[k].second);
    }
  }

private:
  void collect()
  {
    const Bubbles_2& b = m_own;
    const bool is_empty = b.size() == 0;
    m_inner.emplace(1., is_empty ? 1. : b.d[0], is_empty ? 0. : b.x[0], is_empty ? 0. : b.y[0], b.size());
    for (std::size_t i = 0; i < b.size(); ++i)
      if (!b.is_corner(i) && !(m_is_outline_known && b.is_on_edge(i)))
        m_inner->insert(static_cast<Index>(i), b.x[i], b.y[i], b.d[i]);
  }

  const Bubbles_2& m_own;
  bool m_is_outline_known = false;
  std::optional<Bubble_buckets_2> m_inner; // those that others may not know
  std::map<int, std::unordered_set<Index>> m_sent;
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_MESH_QUERY_ANSWERS_2_H
