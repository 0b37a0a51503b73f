// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_TREATMENT_PATCH_OPERATION_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_TREATMENT_PATCH_OPERATION_2_H

#include <CGAL/Bubble_relaxation_2/internal/domain/outline.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Marked_triangulation_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Mesh_stitching_2.h>
#include <CGAL/Bubble_relaxation_2/internal/treatment/Smoothing_sweeps_2.h>

#include <boost/container/flat_map.hpp>
#include <boost/container_hash/hash.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// The surroundings of a triangle as bubbles and edges of their own, so that a change can be tried and
/// forgotten. Bubbles with triangles outside of the patch must stay; they look like corners.
class Mesh_patch_2
{
public:
  /// all triangles of the domain that can be reached from `triangle` in some steps across sides
  Mesh_patch_2(const Bubble_mesh_2& mesh, Index triangle)
    : m_all_bubbles(mesh.bubbles), m_triangles_of_mesh(mesh.triangles)
  {
    collect_triangles(triangle);
    collect_bubbles();
    collect_edges();
  }

  const std::vector<Index>& triangles() const { return m_triangles; } ///< of the mesh, sorted
  const std::vector<Index>& indices() const { return m_indices; }     ///< of the bubbles in the mesh, sorted
  const Bubbles_2& bubbles() const { return m_bubbles; }
  const std::vector<Domain_edge_2>& edges() const { return m_edges; } ///< between bubbles of the patch

  /// what the mesh has in `edges` for a side where it goes on beyond the patch, between two bubbles of the patch;
  /// `other` for all other sides
  Index edge_on_rim(Index source, Index target, Index other) const
  {
    const auto side = m_rim.find({source, target});
    return side == m_rim.end() ? other : side->second;
  }

  /// the number in the patch of a bubble of the mesh that is in it
  Index local(Index i) const
  {
    return static_cast<Index>(std::lower_bound(m_indices.begin(), m_indices.end(), i) -
                              m_indices.begin());
  }

  /// the same for what is the same, seen from a triangle of the patch
  std::size_t signature(Index triangle) const
  {
    std::size_t result = 0;
    const auto add = [&result](const Bubbles_2& b, std::size_t i) {
      boost::hash_combine(result, b.x[i]);
      boost::hash_combine(result, b.y[i]);
    };
    for (std::size_t i = 0; i < m_bubbles.size(); ++i)
      add(m_bubbles, i);
    for (Index v : m_triangles_of_mesh.vertices[triangle])
      add(m_all_bubbles, static_cast<std::size_t>(v));
    return result;
  }

  /// whether the mesh, whose edges are labelled, ends at the patch where the domain does not
  bool is_cut_off() const
  {
    for (Index t : m_triangles)
      for (int i = 0; i < 3; ++i)
        if (m_triangles_of_mesh.neighbors[t][i] == no_index && m_triangles_of_mesh.edges[t][i] != OUTLINE)
          return true;
    return false;
  }

private:
  /// the vertices that move are those up to about two edges away
  static constexpr int reach = 4;

  bool contains(Index t) const
  {
    return t != no_index && std::binary_search(m_triangles.begin(), m_triangles.end(), t);
  }

  void collect_triangles(Index triangle)
  {
    const Marked_triangles_2& m = m_triangles_of_mesh;
    std::vector<Index> front(1, triangle);
    m_triangles = front;
    for (int step = 0; step < reach; ++step) {
      std::vector<Index> next;
      for (Index t : front)
        for (Index n : m.neighbors[t])
          if (n != no_index && m.inside[n] && !contains(n))
            next.push_back(n);
      std::sort(next.begin(), next.end());
      next.erase(std::unique(next.begin(), next.end()), next.end());
      const auto middle = m_triangles.insert(m_triangles.end(), next.begin(), next.end());
      std::inplace_merge(m_triangles.begin(), middle, m_triangles.end());
      front = std::move(next);
    }
  }

  void collect_bubbles()
  {
    const Marked_triangles_2& m = m_triangles_of_mesh;
    for (Index t : m_triangles)
      m_indices.insert(m_indices.end(), m.vertices[t].begin(), m.vertices[t].end());
    std::sort(m_indices.begin(), m_indices.end());
    m_indices.erase(std::unique(m_indices.begin(), m_indices.end()), m_indices.end());
    for (Index i : m_indices)
      m_bubbles.add(m_all_bubbles, i);
    // on the rim: where the domain goes on
    for (Index t : m_triangles)
      for (int i = 0; i < 3; ++i) {
        const Index n = m.neighbors[t][i];
        if (n == no_index || !m.inside[n] || contains(n))
          continue;
        const Index source = local(m.vertices[t][ccw(i)]), target = local(m.vertices[t][cw(i)]);
        m_rim[{source, target}] = m.edges[t][i];
        m_bubbles.dimension[source] = m_bubbles.dimension[target] = Bubbles_2::CORNER;
      }
  }

  /// the rim and the constraints inside
  void collect_edges()
  {
    const Marked_triangles_2& m = m_triangles_of_mesh;
    for (Index t : m_triangles)
      for (int i = 0; i < 3; ++i) {
        const Index n = m.neighbors[t][i];
        const bool goes_on = contains(n);
        if (goes_on && (m.edges[t][i] == no_index || n < t))
          continue;
        m_edges.push_back(Domain_edge_2{local(m.vertices[t][ccw(i)]), local(m.vertices[t][cw(i)]),
                                        true, goes_on});
      }
  }

  const Bubbles_2& m_all_bubbles;
  const Marked_triangles_2& m_triangles_of_mesh;
  std::vector<Index> m_triangles, m_indices;
  Bubbles_2 m_bubbles;
  std::vector<Domain_edge_2> m_edges;
  boost::container::flat_map<std::pair<Index, Index>, Index> m_rim;
};

/// What an operation made of a patch.
struct Patch_outcome_2
{
  Bubble_mesh_2 mesh;
  std::vector<Index> original; ///< of each bubble its number in the patch; inserted ones come after the last

  /// The triangles that take the place of those of the patch, with labels of edges. `number[k]`: what bubble `k` is
  /// called there.
  std::vector<New_triangle_2> triangles(const Mesh_patch_2& patch, const std::vector<Index>& number) const
  {
    std::vector<New_triangle_2> result;
    const Marked_triangles_2& m = mesh.triangles;
    for (std::size_t k = 0; k < m.inside.size(); ++k) {
      if (!m.inside[k])
        continue;
      const Index t = static_cast<Index>(k);
      New_triangle_2 triangle;
      for (int i = 0; i < 3; ++i) {
        triangle.vertices[i] = number[m.vertices[t][i]];
        triangle.edges[i] = label(patch, t, i);
      }
      result.push_back(triangle);
    }
    return result;
  }

private:
  /// the rim of a patch is an edge there, but not where the patch is put
  Index label(const Mesh_patch_2& patch, Index t, int i) const
  {
    const Marked_triangles_2& m = mesh.triangles;
    if (m.edges[t][i] == no_index)
      return no_index;
    return patch.edge_on_rim(original[m.vertices[t][ccw(i)]], original[m.vertices[t][cw(i)]],
                             edge_label(m, t, i));
  }
};

/// Tries all that could help a bad triangle, each on a copy of the patch around it: to remove one of its
/// vertices or of the three beyond its sides, or to insert one in its middle or on a side; the patch is
/// triangulated and its vertices are moved. The best outcome counts if the worst triangle of the patch gets better, or
/// stays as it is and the second worst gets better, and so on.
class Patch_operation_2
{
public:
  Patch_operation_2(const Domain_2& domain, const Bubble_mesh_2& mesh, const Mesh_patch_2& patch)
    : m_domain(domain), m_mesh(mesh), m_bubbles(mesh.bubbles), m_triangles(mesh.triangles), m_patch(patch)
  {}

  /// tries what could help triangle `t`; returns whether anything did
  bool operator()(Index t)
  {
    for (Index n : m_patch.triangles())
      add_defect(m_mesh, n, m_defects);
    std::sort(m_defects.begin(), m_defects.end());
    for (Index i : m_patch.indices())
      if (m_bubbles.is_in_face(i))
        m_hint = m_bubbles.host[i];
    const std::array<int, 3> corners = corners_in_order(m_triangles, t); // among equal outcomes the first counts
    m_mean_size = mean_size(t, corners);
    for (int i : corners) {
      try_without(m_triangles.vertices[t][i]);
      const Index n = m_triangles.neighbors[t][i];
      if (n != no_index && m_triangles.inside[n])
        try_without(m_triangles.vertices[n][m_triangles.index_of_neighbor(n, t)]);
      try_with_on_side(t, i);
    }
    try_with(CGAL::centroid(m_mesh.point(t, corners[0]), m_mesh.point(t, corners[1]), m_mesh.point(t, corners[2])),
             m_mean_size);
    return m_is_better;
  }

  const Patch_outcome_2& best() const { return m_best; }

private:
  /// how much the first q of a patch that changes must gain
  static constexpr double least_gain = 0.01;
  /// triangles with less count as defects
  static constexpr double good_quality = 0.9;

  using Defects = std::vector<double>; // the qualities of bad triangles, the worst first

  static void add_defect(const Bubble_mesh_2& mesh, Index t, Defects& defects)
  {
    const double q = mesh.triangles.inside[t] ? quality(mesh, t) : 1.;
    if (q < good_quality)
      defects.push_back(q);
  }

  static bool is_better(const Defects& after, const Defects& before, double gain)
  {
    for (std::size_t k = 0; k < before.size(); ++k) {
      const double q = k < after.size() ? after[k] : 1.;
      if (q < before[k] || q > before[k] + gain)
        return q > before[k];
    }
    return false;
  }

  double mean_size(Index t, const std::array<int, 3>& corners) const
  {
    double sum = 0;
    for (int i : corners)
      sum += m_bubbles.d[m_triangles.vertices[t][i]];
    return sum / 3;
  }

  void try_without(Index v)
  {
    const Index removed = m_patch.local(v);
    if (!m_patch.bubbles().can_move(removed))
      return;
    Bubbles_2 bubbles = m_patch.bubbles();
    std::vector<Domain_edge_2> edges = m_patch.edges();
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

  void try_with(const Point& p, double d)
  {
    const Index triangle = m_domain.locate_inside(p, m_hint);
    if (triangle == no_index)
      return;
    Bubbles_2 bubbles = m_patch.bubbles();
    bubbles.add(p, d, Bubbles_2::FACE, triangle);
    try_patch(std::move(bubbles), m_patch.edges());
  }

  void try_with_on_side(Index t, int i)
  {
    const Point p = m_mesh.point(t, ccw(i)), q = m_mesh.point(t, cw(i));
    if (m_triangles.edges[t][i] == no_index) {
      try_with(CGAL::midpoint(p, q), m_mean_size);
      return;
    }
    const Index u = m_triangles.vertices[t][ccw(i)], v = m_triangles.vertices[t][cw(i)];
    const Index e = common_edge(u, v);
    if (e == no_index || !m_domain.edges()[e].takes_bubbles)
      return;
    const double s = 0.5 * (position(u, e) + position(v, e));
    Bubbles_2 bubbles = m_patch.bubbles();
    const Index middle = static_cast<Index>(bubbles.size());
    bubbles.add(m_domain.point_on_edge(e, s), m_mean_size, Bubbles_2::EDGE, e, s);
    std::vector<Domain_edge_2> edges = m_patch.edges();
    const Index a = m_patch.local(u), b = m_patch.local(v);
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
    const Bubbles_2& b = m_bubbles;
    if (b.is_on_edge(u))
      return b.host[u];
    if (b.is_on_edge(v))
      return b.host[v];
    return m_domain.edge_between(b.host[u], b.host[v]);
  }

  double position(Index i, Index e) const
  {
    const Bubbles_2& b = m_bubbles;
    return b.is_on_edge(i) ? b.s[i] : b.host[i] == m_domain.edges()[e].source ? 0. : 1.;
  }

  /// A bubble that comes to an edge, or goes from it, may put a pinned vertex beside the edge out of the domain.
  static bool holds_all_bubbles(const Bubble_mesh_2& mesh)
  {
    std::vector<char> is_held(mesh.bubbles.size(), 0);
    for (std::size_t t = 0; t < mesh.triangles.number_of_triangles(); ++t)
      for (Index v : mesh.triangles.vertices[t])
        is_held[v] |= mesh.triangles.inside[t];
    return std::find(is_held.begin(), is_held.end(), 0) == is_held.end();
  }

  void try_patch(Bubbles_2 bubbles, std::vector<Domain_edge_2> edges)
  {
    const std::vector<Index> number = bubbles.indices_left();
    std::vector<Index> original = bubbles.left();
    bubbles.forget_gone();
    for (Domain_edge_2& e : edges) {
      e.source = number[e.source];
      e.target = number[e.target];
    }
    Bubble_mesh_2 mesh{std::move(bubbles), {}};
    if (!try_to_triangulate(edges, mesh) || !holds_all_bubbles(mesh))
      return;
    Team alone;
    Smoothing_sweeps_2(m_domain, mesh, alone)();
    Defects defects;
    for (std::size_t t = 0; t < mesh.triangles.number_of_triangles(); ++t)
      add_defect(mesh, static_cast<Index>(t), defects);
    std::sort(defects.begin(), defects.end());
    if (is_better(defects, m_defects, m_is_better ? 0. : least_gain)) {
      m_defects = std::move(defects);
      m_is_better = true;
      m_best = Patch_outcome_2{std::move(mesh), std::move(original)};
    }
  }

  const Domain_2& m_domain;
  const Bubble_mesh_2& m_mesh;
  const Bubbles_2& m_bubbles;            // of it
  const Marked_triangles_2& m_triangles; // of it
  const Mesh_patch_2& m_patch;
  bool m_is_better = false;
  double m_mean_size = 0;
  Defects m_defects; // of the best outcome
  Index m_hint = 0;  // a triangle of the domain near by
  Patch_outcome_2 m_best;
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_TREATMENT_PATCH_OPERATION_2_H
