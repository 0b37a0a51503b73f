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
#include <atomic>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// Values at the vertices of a triangulation, linear in its triangles, constant along the way out of
/// its hull. A query walks from where the last one ended. The value does not depend on that: on an
/// edge only the edge's ends count.
class Interpolated_field_2
{
public:
  Interpolated_field_2(Flat_triangulation_2 tr, std::vector<double> values)
    : m_tr(std::move(tr)), m_values(std::move(values)), m_hint(0)
  {
    for (std::size_t t = 0; t < m_tr.number_of_triangles(); ++t)
      for (int i = 0; i < 3; ++i)
        if (m_tr.neighbors[t][i] == no_index)
          m_hull.emplace_back(static_cast<Index>(t), i);
  }

  double operator()(double x, double y) const
  {
    const Point q(x, y);
    const Index found = locate(m_tr, m_hint.load(std::memory_order_relaxed), q);
    if (found == no_index)
      return nearest_on_hull(q);
    m_hint.store(found, std::memory_order_relaxed);
    return interpolate(found, q);
  }

  double operator()(const Point& p) const { return (*this)(p.x(), p.y()); }

private:
  double value(Index t, int i) const { return m_values[m_tr.vertices[t][i]]; }

  double interpolate(Index t, const Point& q) const
  {
    double sum = 0, weights = 0;
    for (int i : vertices_in_order(t)) {
      const Point &a = m_tr.point(t, ccw(i)), &b = m_tr.point(t, cw(i));
      if (CGAL::orientation(a, b, q) == COLLINEAR)
        return on_side(t, i, q).value; // both triangles of the side must give the same bits
      const double weight =
        std::abs((b.x() - a.x()) * (q.y() - a.y()) - (b.y() - a.y()) * (q.x() - a.x()));
      sum += weight * value(t, i);
      weights += weight;
    }
    // in a triangle as thin as the rounding of its points all weights may be zero
    return weights > 0 ? sum / weights : on_side(t, opposite_to_longest_side(t), q).value;
  }

  /// The vertices in the order of their points: the order in which they were inserted must not count.
  std::array<int, 3> vertices_in_order(Index t) const
  {
    std::array<int, 3> order{0, 1, 2};
    std::sort(order.begin(), order.end(),
              [&](int i, int j) { return m_tr.point(t, i) < m_tr.point(t, j); });
    return order;
  }

  int opposite_to_longest_side(Index t) const
  {
    const std::array<int, 3> order = vertices_in_order(t);
    return *std::max_element(order.begin(), order.end(), [&](int i, int j) {
      return CGAL::squared_distance(m_tr.point(t, ccw(i)), m_tr.point(t, cw(i))) <
             CGAL::squared_distance(m_tr.point(t, ccw(j)), m_tr.point(t, cw(j)));
    });
  }

  struct Nearest
  {
    double distance, value;
  };

  /// the point of the side opposite to vertex `i` that is the nearest to `q`
  Nearest on_side(Index t, int i, const Point& q) const
  {
    int from = ccw(i), to = cw(i);
    if (m_tr.point(t, to) < m_tr.point(t, from))
      std::swap(from, to);
    const Point &a = m_tr.point(t, from), &b = m_tr.point(t, to);
    const double dx = b.x() - a.x(), dy = b.y() - a.y();
    const double along = ((q.x() - a.x()) * dx + (q.y() - a.y()) * dy) / (dx * dx + dy * dy);
    const double s = (std::max)(0., (std::min)(1., along));
    return Nearest{std::hypot(q.x() - a.x() - s * dx, q.y() - a.y() - s * dy),
                   (1 - s) * value(t, from) + s * value(t, to)};
  }

  /// queries leave the hull by roundings only, where its sides are slanted
  double nearest_on_hull(const Point& q) const
  {
    Nearest best{-1, 0};
    for (const auto& side : m_hull) {
      const Nearest n = on_side(side.first, side.second, q);
      if (best.distance < 0 || n.distance < best.distance)
        best = n;
    }
    return best.value;
  }

  Flat_triangulation_2 m_tr;
  std::vector<double> m_values;
  std::vector<std::pair<Index, int>> m_hull; // its sides: triangle, and the vertex opposite
  mutable std::atomic<Index> m_hint;
};

struct Edge_length
{
  std::array<Index, 2> ends;
  double length;
};

/// At each vertex the mean length of its edges in the domain. `edges`: both ends and the length of each.
inline std::vector<double> mean_edge_lengths(std::size_t number_of_vertices,
                                             std::vector<Edge_length> edges)
{
  // in the order of lengths, so that sums are rounded the same way whatever the order of the faces is
  std::sort(edges.begin(), edges.end(),
            [](const Edge_length& e, const Edge_length& f) { return e.length < f.length; });
  std::vector<double> sum(number_of_vertices, 0), count(number_of_vertices, 0);
  double all = 0;
  for (const Edge_length& e : edges) {
    for (Index v : e.ends) {
      sum[v] += e.length;
      ++count[v];
    }
    all += e.length;
  }
  for (std::size_t v = 0; v < sum.size(); ++v)
    sum[v] = count[v] > 0 ? sum[v] / count[v] : all / static_cast<double>(edges.size());
  return sum;
}

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
  std::vector<Edge_length> edges;
  for (auto f : cdt.finite_face_handles()) {
    tr.vertices.push_back({vertex_index[f->vertex(0)], vertex_index[f->vertex(1)],
                           vertex_index[f->vertex(2)]});
    tr.neighbors.push_back({face_index[f->neighbor(0)], face_index[f->neighbor(1)],
                            face_index[f->neighbor(2)]});
    for (int i = 0; i < 3 && is_inside(f); ++i) {
      const Index a = tr.vertices.back()[ccw(i)], b = tr.vertices.back()[cw(i)];
      if (a < b || !is_inside(f->neighbor(i))) // else it is added from the other side
        edges.push_back({{a, b}, std::sqrt(CGAL::squared_distance(tr.points[a], tr.points[b]))});
    }
  }
  std::vector<double> sizes = mean_edge_lengths(tr.points.size(), std::move(edges));
  return Interpolated_field_2(std::move(tr), std::move(sizes));
}

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_INTERPOLATED_FIELD_2_H
