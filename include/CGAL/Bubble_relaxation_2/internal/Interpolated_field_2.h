// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_INTERPOLATED_FIELD_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_INTERPOLATED_FIELD_2_H

#include <CGAL/Bubble_relaxation_2/internal/Flat_triangulation_2.h>

#include <CGAL/Unique_hash_map.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// Values at the vertices of a triangulation, linear in its triangles, constant along the way out of
/// its hull. A query walks from where the thread's last one ended. The value does not depend on that: on
/// an edge, where either triangle may be found, only the edge's ends count, in the order of their numbers.
class Interpolated_field_2
{
public:
  Interpolated_field_2(Flat_triangulation_2 tr, std::vector<double> values)
    : m_tr(std::move(tr)), m_values(std::move(values))
  {
    for (std::size_t t = 0; t < m_tr.number_of_triangles(); ++t)
      for (int i = 0; i < 3; ++i)
        if (m_tr.neighbors[t][i] == no_index)
          m_hull.push_back({m_tr.vertices[t][ccw(i)], m_tr.vertices[t][cw(i)]});
  }

  double operator()(double x, double y) const
  {
    // any triangle of the field will do as a start, one of another field's number as well
    thread_local Index hint = 0;
    const Index start = static_cast<std::size_t>(hint) < m_tr.number_of_triangles() ? hint : 0;
    const Point q(x, y);
    const Index found = locate(m_tr, start, q);
    if (found == no_index)
      return nearest_on_hull(q);
    hint = found;
    return interpolate(found, q);
  }

  double operator()(const Point& p) const { return (*this)(p.x(), p.y()); }

private:
  using Edge = std::array<Index, 2>; // indices of its ends

  double interpolate(Index t, const Point& q) const
  {
    int sides = 0, side = 0, off_side = 0; // sides that `q` lies on, and one that it does not lie on
    for (int i = 0; i < 3; ++i)
      if (CGAL::orientation(m_tr.point(t, ccw(i)), m_tr.point(t, cw(i)), q) == COLLINEAR) {
        ++sides;
        side = i;
      } else {
        off_side = i;
      }
    if (sides == 2) // the vertex where they meet is opposite to the third
      return m_values[m_tr.vertices[t][off_side]];
    if (sides == 0)
      return interpolate_inside(t, q);
    const Edge e{m_tr.vertices[t][ccw(side)], m_tr.vertices[t][cw(side)]};
    return interpolate_on(e, nearest_on(e, q));
  }

  double interpolate_inside(Index t, const Point& q) const
  {
    double sum = 0, weights = 0;
    for (int i = 0; i < 3; ++i) {
      const Point &a = m_tr.point(t, ccw(i)), &b = m_tr.point(t, cw(i));
      const double weight = std::abs((b.x() - a.x()) * (q.y() - a.y()) -
                                     (b.y() - a.y()) * (q.x() - a.x())) / area(t);
      sum += weight * m_values[m_tr.vertices[t][i]];
      weights += weight;
    }
    return weights > 0 ? sum / weights : m_values[m_tr.vertices[t][0]];
  }

  double area(Index t) const
  {
    const Point &a = m_tr.point(t, 0), &b = m_tr.point(t, 1), &c = m_tr.point(t, 2);
    return std::abs((b.x() - a.x()) * (c.y() - a.y()) - (c.x() - a.x()) * (b.y() - a.y()));
  }

  /// where on the edge, from its end with the lower number, in [0,1], is the point next to `q`
  double nearest_on(const Edge& e, const Point& q) const
  {
    const Point &a = m_tr.points[(std::min)(e[0], e[1])], &b = m_tr.points[(std::max)(e[0], e[1])];
    const double dx = b.x() - a.x(), dy = b.y() - a.y();
    const double along = ((q.x() - a.x()) * dx + (q.y() - a.y()) * dy) / (dx * dx + dy * dy);
    return (std::max)(0., (std::min)(1., along));
  }

  double interpolate_on(const Edge& e, double s) const
  {
    return (1 - s) * m_values[(std::min)(e[0], e[1])] + s * m_values[(std::max)(e[0], e[1])];
  }

  /// queries leave the hull by roundings only, where edges of the hull are slanted
  double nearest_on_hull(const Point& q) const
  {
    double least = -1, nearest = 0;
    for (const Edge& e : m_hull) {
      const double s = nearest_on(e, q);
      const Point &a = m_tr.points[(std::min)(e[0], e[1])], &b = m_tr.points[(std::max)(e[0], e[1])];
      const double off = std::hypot(q.x() - a.x() - s * (b.x() - a.x()),
                                    q.y() - a.y() - s * (b.y() - a.y()));
      if (least < 0 || off < least) {
        least = off;
        nearest = interpolate_on(e, s);
      }
    }
    return nearest;
  }

  Flat_triangulation_2 m_tr;
  std::vector<double> m_values;
  std::vector<Edge> m_hull;
};

/// The size that a mesh has: at each vertex the mean length of its edges in the domain.
template <class Cdt, class Is_inside>
Interpolated_field_2 mean_edge_length_field(const Cdt& cdt, const Is_inside& is_inside)
{
  Flat_triangulation_2 tr;
  Unique_hash_map<typename Cdt::Vertex_handle, Index> vertex_index(no_index);
  Unique_hash_map<typename Cdt::Face_handle, Index> face_index(no_index);
  for (auto v : cdt.finite_vertex_handles()) {
    vertex_index[v] = static_cast<Index>(tr.points.size());
    tr.points.push_back(Point(CGAL::to_double(v->point().x()), CGAL::to_double(v->point().y())));
  }
  Index n = 0;
  for (auto f : cdt.finite_face_handles())
    face_index[f] = n++;
  std::vector<double> sum(tr.points.size(), 0), count(tr.points.size(), 0);
  double all = 0, number = 0;
  for (auto f : cdt.finite_face_handles()) {
    tr.vertices.push_back({vertex_index[f->vertex(0)], vertex_index[f->vertex(1)],
                           vertex_index[f->vertex(2)]});
    tr.neighbors.push_back({face_index[f->neighbor(0)], face_index[f->neighbor(1)],
                            face_index[f->neighbor(2)]});
    if (!is_inside(f))
      continue;
    for (int i = 0; i < 3; ++i) { // an inner edge counts twice, from both sides
      const Index a = tr.vertices.back()[ccw(i)], b = tr.vertices.back()[cw(i)];
      const double weight = is_inside(f->neighbor(i)) ? 0.5 : 1;
      const double length = weight * std::sqrt(CGAL::squared_distance(tr.points[a], tr.points[b]));
      for (Index v : {a, b}) {
        sum[v] += length;
        count[v] += weight;
      }
      all += length;
      number += weight;
    }
  }
  for (std::size_t v = 0; v < sum.size(); ++v)
    sum[v] = count[v] > 0 ? sum[v] / count[v] : all / number;
  return Interpolated_field_2(std::move(tr), std::move(sum));
}

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_INTERPOLATED_FIELD_2_H
