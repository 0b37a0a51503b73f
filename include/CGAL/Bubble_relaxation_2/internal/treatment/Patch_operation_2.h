// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_TREATMENT_PATCH_OPERATION_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_TREATMENT_PATCH_OPERATION_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/reproducible_math.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/outline.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Marked_triangulation_2.h>
#include <CGAL/Bubble_relaxation_2/internal/treatment/Mesh_patch_2.h>
#include <CGAL/Bubble_relaxation_2/internal/treatment/Smoothing_sweeps_2.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// Tries all that could help a bad triangle, each on a copy of the patch around it: to remove one of its vertices or of the
/// three beyond its sides, or to insert one in its middle or on a side, if there is room. The patch is triangulated; where
/// that has left the best triangles vertices are moved, which takes longest. The best outcome counts if the worst triangle
/// of the patch gets better, or stays as it is and the second worst gets better, and so on. Obtuse triangles are worse than
/// their q, but no triangle gets worse than the worst of the mesh.
class Patch_operation_2
{
public:
  /// \param smallest the smallest q of all meshes that come out
  /// \pre the edges of `mesh` are labelled
  Patch_operation_2(const Domain_2& domain, const Bubble_mesh_2& mesh, const Mesh_patch_2& patch, double smallest)
    : m_domain(domain), m_mesh(mesh), m_bubbles(mesh.bubbles), m_triangles(mesh.triangles), m_patch(patch),
      m_smallest(smallest)
  {}

  /// tries what could help triangle `t`; returns whether anything did
  bool operator()(Index t)
  {
    m_defects = defects_among(m_mesh, m_patch.triangles());
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
    const Point p = m_mesh.point(t, corners[0]), q = m_mesh.point(t, corners[1]), r = m_mesh.point(t, corners[2]);
    if (has_room(CGAL::area(p, q, r) / area_of_unit_triangle))
      try_with(CGAL::centroid(p, q, r), m_mean_size);
    move_vertices(quality(m_mesh, t) < hard_quality);
    return m_is_better;
  }

  const Patch_outcome_2& best() const { return m_best; }

private:
  /// how much the first q of a patch that changes must gain
  static constexpr double least_gain = 0.0005;
  /// triangles with less count as defects
  static constexpr double good_quality = 0.9;
  /// in units of the size at a triangle the shortest side that a vertex can help
  static constexpr double least_room = 0.8;
  /// so many outcomes get their vertices moved
  static constexpr std::size_t number_of_favourites = 3;
  /// The others get it too, until one helps, where the triangle has less: it may be obtuse. So do they get all sweeps.
  static constexpr double hard_quality = 0.84;
  static constexpr int easy_sweeps = Smoothing_sweeps_2::number_of_sweeps - 1;

  using Defects = std::vector<double>; // what bad triangles are worth, the worst first

  struct Candidate
  {
    Defects defects; // before vertices are moved
    Patch_outcome_2 outcome;
  };

  static bool is_obtuse(const Bubble_mesh_2& mesh, Index t)
  {
    for (int i = 0; i < 3; ++i) {
      const Kernel::Vector_2 u = mesh.point(t, ccw(i)) - mesh.point(t, i), v = mesh.point(t, cw(i)) - mesh.point(t, i);
      if (internal::is_obtuse(u * v, u.x() * v.y() - u.y() * v.x()))
        return true;
    }
    return false;
  }

  /// q of a triangle, less a twentieth if it is obtuse: a slimmer one that is acute is better
  static double worth(const Bubble_mesh_2& mesh, Index t)
  {
    return quality(mesh, t) * (is_obtuse(mesh, t) ? 0.95 : 1.);
  }

  static Defects defects_among(const Bubble_mesh_2& mesh, const std::vector<Index>& triangles)
  {
    Defects defects;
    for (Index t : triangles)
      if (mesh.triangles.inside[t] && !has_quality(mesh, t, good_quality)) // better ones are acute
        defects.push_back(worth(mesh, t));
    std::sort(defects.begin(), defects.end());
    return defects;
  }

  static Defects defects_of(const Bubble_mesh_2& mesh)
  {
    std::vector<Index> all(mesh.triangles.number_of_triangles());
    std::iota(all.begin(), all.end(), Index(0));
    return defects_among(mesh, all);
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
    if (!m_patch.bubbles().can_move(removed) || !may_be_too_many(v))
      return;
    Bubbles_2 bubbles = m_patch.bubbles();
    std::vector<Domain_edge_2> edges = m_patch.edges();
    if (bubbles.is_on_edge(removed) && !join(edges, removed))
      return;
    bubbles.remove(removed);
    try_patch(std::move(bubbles), std::move(edges));
  }

  /// A vertex that may move and has more than six triangles, or three where the domain ends beside it, is not the one too
  /// many.
  bool may_be_too_many(Index v) const
  {
    int number = 0, most = 6;
    for (Index t : m_patch.triangles())
      for (int i = 0; i < 3; ++i) {
        if (m_triangles.vertices[t][i] != v)
          continue;
        ++number;
        if (m_triangles.edges[t][ccw(i)] == OUTLINE || m_triangles.edges[t][cw(i)] == OUTLINE)
          most = 3;
      }
    return number <= most;
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

  /// whether there is room for one more vertex on a side with this squared length, or in a triangle with the area of an
  /// equilateral one with such sides
  bool has_room(double squared_length) const
  {
    return squared_length >= least_room * least_room * m_mean_size * m_mean_size;
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
    if (!has_room(CGAL::squared_distance(p, q)))
      return;
    if (m_triangles.edges[t][i] == no_index) {
      try_with(CGAL::midpoint(p, q), m_mean_size);
      return;
    }
    const Index u = m_triangles.vertices[t][ccw(i)], v = m_triangles.vertices[t][cw(i)];
    const Index e = edge_of_piece(m_domain, m_bubbles, u, v);
    if (e == no_index || !m_domain.edges()[e].takes_bubbles)
      return;
    const double s = 0.5 * (position_on(m_domain, m_bubbles, e, u) + position_on(m_domain, m_bubbles, e, v));
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

  /// A bubble that comes to an edge, or goes from it, may put a pinned vertex beside the edge out of the domain.
  static bool holds_all_bubbles(const Bubble_mesh_2& mesh)
  {
    const std::vector<char> is_held = vertices_of_triangles(mesh.triangles, true, mesh.bubbles.size());
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
    Defects defects = defects_of(mesh);
    m_candidates.push_back(Candidate{std::move(defects), {std::move(mesh), std::move(original)}});
  }

  /// moves vertices, first where the worst triangles are best, and keeps the best outcome
  void move_vertices(bool is_hard)
  {
    std::stable_sort(m_candidates.begin(), m_candidates.end(), [](const Candidate& a, const Candidate& b) {
      return is_better(a.defects, b.defects, 0.);
    });
    for (std::size_t k = 0; k < m_candidates.size(); ++k) {
      if (m_is_better ? k >= number_of_favourites || m_defects.empty() : k >= number_of_favourites && !is_hard)
        return;
      Bubble_mesh_2& mesh = m_candidates[k].outcome.mesh;
      Team alone;
      Smoothing_sweeps_2(m_domain, mesh, alone)(is_hard ? Smoothing_sweeps_2::number_of_sweeps : easy_sweeps);
      Defects defects = defects_of(mesh);
      if (is_better(defects, m_defects, m_is_better ? 0. : least_gain) && smallest_quality(mesh) >= m_smallest) {
        m_defects = std::move(defects);
        m_is_better = true;
        m_best = std::move(m_candidates[k].outcome);
      }
    }
  }

  const Domain_2& m_domain;
  const Bubble_mesh_2& m_mesh;
  const Bubbles_2& m_bubbles;            // of it
  const Marked_triangles_2& m_triangles; // of it
  const Mesh_patch_2& m_patch;
  const double m_smallest;
  bool m_is_better = false;
  double m_mean_size = 0;
  std::vector<Candidate> m_candidates;
  Defects m_defects; // of the best outcome
  Index m_hint = 0;  // a triangle of the domain near by
  Patch_outcome_2 m_best;
};

/// Operates on the patches of a mesh, and on none a second time in vain.
class Patch_operations_2
{
public:
  /// \param smallest see `Patch_operation_2`
  Patch_operations_2(const Domain_2& domain, const Bubble_mesh_2& mesh, double smallest)
    : m_domain(domain), m_mesh(mesh), m_smallest(smallest)
  {}

  /// tries what could help a triangle of a patch; returns whether it did
  bool operator()(const Mesh_patch_2& patch, Index triangle, Patch_outcome_2& outcome)
  {
    const std::uint64_t signature = patch.signature(triangle);
    if (m_hopeless.count(signature) != 0)
      return false;
    Patch_operation_2 operate(m_domain, m_mesh, patch, m_smallest);
    const bool has_helped = operate(triangle);
    if (has_helped)
      outcome = operate.best();
    else
      m_hopeless.insert(signature);
    return has_helped;
  }

private:
  const Domain_2& m_domain;
  const Bubble_mesh_2& m_mesh;
  const double m_smallest;
  std::unordered_set<std::uint64_t> m_hopeless; // signatures of what could not be made better
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_TREATMENT_PATCH_OPERATION_2_H
