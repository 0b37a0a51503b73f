// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DEFECT_SURGERY_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DEFECT_SURGERY_2_H

#include <CGAL/Bubble_relaxation_2/internal/Defect_treatment_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Mesh_patch_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Population_change.h>
#include <CGAL/radius_ratio_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// What is still bad when vertices were moved needs one vertex less or more. For each such triangle, the
/// worst first, all that could help is tried on a patch around it: to remove one of its vertices or of the
/// three beyond its sides, or to insert one in its middle or on a side; the patch is triangulated and its
/// vertices moved, and the best outcome is kept if the worst triangle of the patch gets better.
class Defect_surgery_2
{
public:
  /// how much the smallest q of a patch must gain
  double least_gain = 0.01;

  /// `bad_quality`: triangles with less are operated on
  Defect_surgery_2(const Domain_2& domain, const Bubble_mesh_2& mesh, double bad_quality)
    : m_domain(domain), m_mesh(mesh), m_bad_quality(bad_quality)
  {}

  /// what the last call did
  std::size_t number_of_insertions = 0, number_of_deletions = 0;

  /// operates on patches that do not overlap, `most` at most; returns the bubbles if any changed, else none
  Bubbles_2 operator()(std::size_t most)
  {
    std::vector<char> is_taken(m_mesh.triangulation.tr.number_of_triangles(), 0);
    Bubbles_2 result;
    number_of_insertions = number_of_deletions = 0;
    for (Index t : bad_triangles(most)) {
      const Mesh_patch_2 patch(m_mesh, t, reach);
      if (std::any_of(patch.triangles().begin(), patch.triangles().end(),
                      [&](Index n) { return is_taken[n] != 0; }))
        continue;
      if (!operate(patch, t))
        continue;
      if (result.size() == 0)
        result = m_mesh.bubbles;
      replace(patch, result);
      for (Index n : patch.triangles())
        is_taken[n] = 1;
    }
    result.forget_gone();
    return result;
  }

private:
  using Sides = std::array<Index, 3>;

  /// steps from triangle to triangle: the vertices that move are those up to about three edges away
  static constexpr int reach = 6;

  double quality(Index t) const
  {
    const Flat_triangulation_2& tr = m_mesh.triangulation.tr;
    return radius_ratio(tr.point(t, 0), tr.point(t, 1), tr.point(t, 2));
  }

  /// the worst first
  std::vector<Index> bad_triangles(std::size_t most) const
  {
    const Marked_triangulation_2& m = m_mesh.triangulation;
    std::vector<std::tuple<double, Point, Index>> found; // among equals the place decides
    for (std::size_t t = 0; t < m.inside.size(); ++t) {
      const Index i = static_cast<Index>(t);
      const double q = m.inside[t] ? quality(i) : 1.;
      if (q < m_bad_quality && q < 0.9 * best_quality(i))
        found.emplace_back(q, m.tr.point(i, 0), i);
    }
    std::sort(found.begin(), found.end());
    std::vector<Index> result;
    for (std::size_t k = 0; k < (std::min)(most, found.size()); ++k)
      result.push_back(std::get<2>(found[k]));
    return result;
  }

  /// what q can be at most where the input fixes an angle, which one triangle has or two share
  double best_quality(Index t) const
  {
    const Marked_triangulation_2& m = m_mesh.triangulation;
    const int i = corner_of_domain(t);
    if (i == -1)
      return 1;
    const Kernel::Vector_2 u = m.tr.point(t, ccw(i)) - m.tr.point(t, i),
                           v = m.tr.point(t, cw(i)) - m.tr.point(t, i);
    const double half = 0.5 * std::atan2(std::abs(u.x() * v.y() - u.y() * v.x()), u * v);
    return (std::max)(quality_of_isosceles(half), quality_of_isosceles(half / 2));
  }

  /// the vertex of a triangle whose angle is that between two edges of the domain, -1 if there is none
  int corner_of_domain(Index t) const
  {
    const auto& edges = m_mesh.triangulation.edges[t];
    for (int i = 0; i < 3; ++i)
      if (edges[ccw(i)] != no_index && edges[cw(i)] != no_index)
        return i;
    return -1;
  }

  /// q of the isosceles triangle with an angle of twice `half` at its tip: 8 sin(a) sin^2(45 - a/2)
  static double quality_of_isosceles(double half)
  {
    const double s = std::sin(half);
    return 4 * s * (1 - s);
  }

  /// tries what could help; leaves the best in `m_best`
  bool operate(const Mesh_patch_2& patch, Index t)
  {
    double smallest = 1;
    for (Index n : patch.triangles())
      smallest = (std::min)(smallest, quality(n));
    m_smallest = smallest + least_gain;
    m_is_better = false;
    const Flat_triangulation_2& tr = m_mesh.triangulation.tr;
    for (int i = 0; i < 3; ++i) {
      try_without(patch, tr.vertices[t][i]);
      const Index n = tr.neighbors[t][i];
      if (n != no_index && m_mesh.triangulation.inside[n])
        try_without(patch, tr.vertices[n][tr.index_of_neighbor(n, t)]);
      try_with_on_side(patch, t, i);
    }
    try_with(patch, CGAL::centroid(tr.point(t, 0), tr.point(t, 1), tr.point(t, 2)), mean_size(t));
    return m_is_better;
  }

  double mean_size(Index t) const
  {
    const auto& v = m_mesh.triangulation.tr.vertices[t];
    const Bubbles_2& b = m_mesh.bubbles;
    return (b.d[v[0]] + b.d[v[1]] + b.d[v[2]]) / 3;
  }

  void try_without(const Mesh_patch_2& patch, Index v)
  {
    const Index removed = patch.local(v);
    if (!patch.bubbles().can_move(removed))
      return;
    Bubbles_2 bubbles = patch.bubbles();
    std::vector<Domain_edge_2> edges = patch.edges();
    if (bubbles.is_on_edge(removed) && !join(edges, removed))
      return;
    bubbles.remove(removed);
    try_patch(std::move(bubbles), std::move(edges));
  }

  /// makes one edge of the two that meet in a bubble
  static bool join(std::vector<Domain_edge_2>& edges, Index removed)
  {
    std::vector<std::size_t> incident;
    for (std::size_t e = 0; e < edges.size(); ++e)
      if (edges[e].source == removed || edges[e].target == removed)
        incident.push_back(e);
    if (incident.size() != 2)
      return false;
    Domain_edge_2 &first = edges[incident[0]], second = edges[incident[1]];
    if (second.source != removed && second.target == removed)
      reverse(second);
    if (first.target != removed)
      reverse(first);
    if (first.inside_left != second.inside_left || first.inside_right != second.inside_right)
      return false;
    first.target = second.target;
    edges.erase(edges.begin() + static_cast<std::ptrdiff_t>(incident[1]));
    return true;
  }

  static void reverse(Domain_edge_2& e)
  {
    std::swap(e.source, e.target);
    std::swap(e.inside_left, e.inside_right);
  }

  void try_with(const Mesh_patch_2& patch, const Point& p, double d)
  {
    Index hint = 0;
    const Index triangle = m_domain.locate_inside(p, hint);
    if (triangle == no_index)
      return;
    Bubbles_2 bubbles = patch.bubbles();
    bubbles.add(p, d, Bubbles_2::FACE, triangle);
    try_patch(std::move(bubbles), patch.edges());
  }

  void try_with_on_side(const Mesh_patch_2& patch, Index t, int i)
  {
    const Flat_triangulation_2& tr = m_mesh.triangulation.tr;
    const Point &p = tr.point(t, ccw(i)), &q = tr.point(t, cw(i));
    if (m_mesh.triangulation.edges[t][i] == no_index) {
      try_with(patch, CGAL::midpoint(p, q), mean_size(t));
      return;
    }
    const Index u = tr.vertices[t][ccw(i)], v = tr.vertices[t][cw(i)];
    const Index e = common_edge(u, v);
    if (e == no_index)
      return;
    const double s = 0.5 * (position(u, e) + position(v, e));
    Bubbles_2 bubbles = patch.bubbles();
    const Index middle = static_cast<Index>(bubbles.size());
    bubbles.add(m_domain.point_on_edge(e, s), mean_size(t), Bubbles_2::EDGE, e, s);
    std::vector<Domain_edge_2> edges = patch.edges();
    const Index a = patch.local(u), b = patch.local(v);
    for (Domain_edge_2& piece : edges)
      if ((piece.source == a && piece.target == b) || (piece.source == b && piece.target == a)) {
        Domain_edge_2 rest = piece;
        piece.target = rest.source = middle;
        edges.push_back(rest);
        break;
      }
    try_patch(std::move(bubbles), std::move(edges));
  }

  /// the edge of the domain that two bubbles lie on
  Index common_edge(Index u, Index v) const
  {
    const Bubbles_2& b = m_mesh.bubbles;
    if (b.is_on_edge(u))
      return b.place[u];
    if (b.is_on_edge(v))
      return b.place[v];
    for (std::size_t e = 0; e < m_domain.edges().size(); ++e) {
      const Domain_edge_2& edge = m_domain.edges()[e];
      if ((edge.source == b.place[u] && edge.target == b.place[v]) ||
          (edge.source == b.place[v] && edge.target == b.place[u]))
        return static_cast<Index>(e);
    }
    return no_index;
  }

  double position(Index i, Index e) const
  {
    const Bubbles_2& b = m_mesh.bubbles;
    return b.is_on_edge(i) ? b.s[i] : b.place[i] == m_domain.edges()[e].source ? 0. : 1.;
  }

  void try_patch(Bubbles_2 bubbles, std::vector<Domain_edge_2> edges)
  {
    std::vector<Index> number(bubbles.size(), no_index), original;
    for (std::size_t i = 0; i < bubbles.size(); ++i)
      if (!bubbles.is_gone(i)) {
        number[i] = static_cast<Index>(original.size());
        original.push_back(static_cast<Index>(i));
      }
    bubbles.forget_gone();
    for (Domain_edge_2& e : edges) {
      e.source = number[e.source];
      e.target = number[e.target];
    }
    std::vector<Point> points;
    for (std::size_t i = 0; i < bubbles.size(); ++i)
      points.push_back(bubbles.point(i));
    Marked_triangulation_2 triangulation;
    if (mark_triangulation(points, edges, triangulation) != Marking_error::NONE)
      return;
    Defect_treatment_2<Sequential_tag>(m_domain, triangulation, bubbles)();
    const double smallest = smallest_quality(triangulation);
    if (smallest > m_smallest) {
      m_smallest = smallest;
      m_is_better = true;
      m_best = std::move(bubbles);
      m_original = std::move(original);
    }
  }

  /// puts the best outcome in the place of a patch
  void replace(const Mesh_patch_2& patch, Bubbles_2& result)
  {
    const std::size_t n = patch.indices().size();
    std::vector<char> is_left(n, 0);
    for (std::size_t k = 0; k < m_best.size(); ++k) {
      if (static_cast<std::size_t>(m_original[k]) >= n) {
        result.add(m_best.point(k), m_best.d[k], static_cast<Bubbles_2::Dimension>(m_best.dimension[k]),
                   m_best.place[k], m_best.s[k]);
        ++number_of_insertions;
        continue;
      }
      is_left[m_original[k]] = 1;
      const Index i = patch.indices()[m_original[k]];
      result.x[i] = m_best.x[k];
      result.y[i] = m_best.y[k];
      result.s[i] = m_best.s[k];
      if (m_best.is_in_face(k))
        result.place[i] = m_best.place[k];
    }
    for (std::size_t l = 0; l < n; ++l)
      if (!is_left[l]) {
        result.remove(patch.indices()[l]);
        ++number_of_deletions;
      }
  }

  const Domain_2& m_domain;
  const Bubble_mesh_2& m_mesh;
  const double m_bad_quality;
  bool m_is_better = false;
  double m_smallest = 0;         // q of the best outcome
  Bubbles_2 m_best;              // bubbles of the best outcome
  std::vector<Index> m_original; // their numbers in the patch; those inserted come after the last
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DEFECT_SURGERY_2_H
