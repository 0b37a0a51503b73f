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
#include <CGAL/Bubble_relaxation_2/internal/geometry/Marked_triangulation_2.h>

#include <CGAL/Bbox_2.h>
#include <CGAL/Fuzzy_iso_box.h>
#include <CGAL/Kd_tree.h>
#include <CGAL/Kernel/global_functions_2.h>
#include <CGAL/Search_traits_2.h>
#include <CGAL/Search_traits_adapter.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// The question whether any point that a rank does not know lies where it would change one of its triangles:
/// in the circumscribed disc, and not beyond a side that is a constraint. What lies beyond such a side is
/// hidden by it, since all of the disc there is cut off by that side.
struct Triangle_question_2
{
  std::array<double, 3> x, y; ///< the vertices, counterclockwise
  Bbox_2 box; ///< all that matters lies in it
  std::array<std::int32_t, 3> is_hidden; ///< for each vertex, what lies beyond the opposite side
  std::int32_t vertex; ///< points near to this one matter first
  std::int32_t number; ///< of the question, among those of its rank

  Point point(int i) const { return Point(x[i], y[i]); }

  /// exact
  bool concerns(const Point& q) const
  {
    const Point a = point(0), b = point(1), c = point(2);
    if (CGAL::side_of_bounded_circle(a, b, c, q) == ON_UNBOUNDED_SIDE)
      return false;
    for (int i = 0; i < 3; ++i)
      if (is_hidden[i] && CGAL::orientation(point(ccw(i)), point(cw(i)), q) == RIGHT_TURN)
        return false;
    return true;
  }
};

/// Distance from the midpoint of the side `pq` of the triangle `pqr` to the farthest point of the part of
/// its circumscribed disc that lies beyond that side, or a bit more; infinite if rounding hides it.
inline double reach_beyond_side(const Point& p, const Point& q, const Point& r)
{
  constexpr double margin = 1 + 1e-9, rounding = 8 * std::numeric_limits<double>::epsilon();
  const double ax = p.x() - r.x(), ay = p.y() - r.y(), bx = q.x() - r.x(), by = q.y() - r.y();
  const double half = 0.5 * length_of(q.x() - p.x(), q.y() - p.y()) * margin;
  const double dot = ax * bx + ay * by;
  if (dot >= 0) // less than half of the disc
    return half;
  // the angle at r is obtuse: that part is as high as half the side times the tangent of half the angle
  const double cross = std::abs(ax * by - ay * bx) - rounding * (std::abs(ax * by) + std::abs(ay * bx));
  if (!(cross > 0))
    return std::numeric_limits<double>::infinity();
  return half * (std::max)(1., margin * (length_of(ax, ay) * length_of(bx, by) - dot) / cross);
}

/// The part of the plane that matters for the triangle `t`, in a box.
inline Bbox_2 box_that_matters(const Bubble_mesh_2& mesh, Index t, const Bbox_2& domain_box)
{
  Bbox_2 box = mesh.point(t, 0).bbox() + mesh.point(t, 1).bbox() + mesh.point(t, 2).bbox();
  const double largest = (std::max)((std::max)(std::abs(box.xmin()), std::abs(box.xmax())),
                                    (std::max)(std::abs(box.ymin()), std::abs(box.ymax())));
  for (int i = 0; i < 3; ++i) {
    if (mesh.triangles.edges[t][i] != no_index)
      continue;
    const Point p = mesh.point(t, ccw(i)), q = mesh.point(t, cw(i));
    const double radius = reach_beyond_side(p, q, mesh.point(t, i)) +
                          4 * std::numeric_limits<double>::epsilon() * largest;
    if (!std::isfinite(radius))
      return domain_box;
    const double x = p.x() + (q.x() - p.x()) / 2, y = p.y() + (q.y() - p.y()) / 2;
    box += Bbox_2(x - radius, y - radius, x + radius, y + radius);
  }
  return Bbox_2((std::max)(box.xmin(), domain_box.xmin()), (std::max)(box.ymin(), domain_box.ymin()),
                (std::min)(box.xmax(), domain_box.xmax()), (std::min)(box.ymax(), domain_box.ymax()));
}

inline Triangle_question_2 make_question(const Bubble_mesh_2& mesh, Index t, const Bbox_2& box,
                                         int vertex, std::int32_t number)
{
  Triangle_question_2 question{};
  for (int i = 0; i < 3; ++i) {
    question.x[i] = mesh.point(t, i).x();
    question.y[i] = mesh.point(t, i).y();
    question.is_hidden[i] = mesh.triangles.edges[t][i] != no_index;
  }
  question.box = box;
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

  /// adds what a question of `rank` asks for
  void operator()(int rank, const Triangle_question_2& question, std::vector<Bubble_answer_2>& answers)
  {
    if (m_inner.empty())
      collect();
    std::unordered_set<Index>& sent = m_sent[rank];
    std::vector<Bubble> in_box;
    const Bbox_2& box = question.box;
    m_inner.search(std::back_inserter(in_box),
                   Fuzzy_iso_box<Traits>(Point(box.xmin(), box.ymin()), Point(box.xmax(), box.ymax())));
    std::vector<std::pair<double, Index>> found; // by distances
    for (const Bubble& b : in_box)
      if (sent.count(b.second) == 0 && question.concerns(b.first)) {
        const double dx = b.first.x() - question.x[question.vertex], dy = b.first.y() - question.y[question.vertex];
        found.emplace_back(dx * dx + dy * dy, b.second);
      }
    const std::size_t n = (std::min)(found.size(), most_bubbles);
    std::partial_sort(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(n), found.end());
    for (std::size_t k = 0; k < n; ++k) {
      answers.push_back({record(m_own, static_cast<std::size_t>(found[k].second)), question.number});
      sent.insert(found[k].second);
    }
  }

private:
  using Bubble = std::pair<Point, Index>;
  using Traits = Search_traits_adapter<Bubble, First_of_pair_property_map<Bubble>, Search_traits_2<Kernel>>;

  void collect()
  {
    for (std::size_t i = 0; i < m_own.size(); ++i)
      if (!is_on_outline(m_own, i))
        m_inner.insert(Bubble(m_own.point(i), static_cast<Index>(i)));
  }

  const Bubbles_2& m_own;
  Kd_tree<Traits> m_inner; // those that others may not know
  std::map<int, std::unordered_set<Index>> m_sent;
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_MESH_QUERY_ANSWERS_2_H
