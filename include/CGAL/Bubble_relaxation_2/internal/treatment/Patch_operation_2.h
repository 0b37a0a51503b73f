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
#include <CGAL/Bubble_relaxation_2/internal/treatment/Vertex_insertion_2.h>
#include <CGAL/Bubble_relaxation_2/internal/treatment/Vertex_removal_2.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// Tries all that could help a bad triangle, each on a copy of the patch around it: to remove one of its vertices or of the
/// three beyond its sides, or to insert one in its middle or on a side, if there is room. Of the outcomes with the best
/// triangles vertices are moved, which takes longest. The best outcome counts if the worst triangle
/// of the patch gets better, or stays as it is and the second worst gets better, and so on. Obtuse triangles are worse than
/// their q, but no triangle gets worse than the worst of the mesh.
class Patch_operation_2
{
public:
  /// \param smallest the smallest q of all meshes that come out
  /// \pre the edges of `mesh` are labelled
  Patch_operation_2(const Domain_2& domain, const Bubble_mesh_2& mesh, const Mesh_patch_2& patch, double smallest)
    : m_domain(domain), m_whole(mesh), m_patch(patch), m_mesh(patch.mesh()), m_smallest(smallest)
  {}

  /// tries what could help a triangle of the patch; returns whether anything did
  bool operator()(Index t)
  {
    m_defects = defects_of(m_mesh);
    for (std::size_t i = 0; i < m_mesh.bubbles.size(); ++i)
      if (m_mesh.bubbles.is_in_face(i))
        m_hint = m_mesh.bubbles.host[i];
    const Marked_triangles_2& m = m_mesh.triangles;
    const std::array<int, 3> corners = corners_in_order(m, t); // among equal outcomes the first counts
    m_mean_size = mean_size(t, corners);
    for (int i : corners) {
      try_without(m.vertices[t][i]);
      if (const Index n = m.neighbors[t][i]; n != no_index)
        try_without(m.vertices[n][m.index_of_neighbor(n, t)]);
      try_with_on_side(t, i);
    }
    const Point p = m_mesh.point(t, corners[0]), q = m_mesh.point(t, corners[1]), r = m_mesh.point(t, corners[2]);
    if (has_room(CGAL::area(p, q, r) / area_of_unit_triangle))
      try_with(CGAL::centroid(p, q, r), t);
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
  static constexpr Sweeps easy_sweeps{usual_sweeps.most - 1, usual_sweeps.treated_quality};

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

  /// q of a triangle, less if it is obtuse: a slimmer one that is acute is better
  static double worth(const Bubble_mesh_2& mesh, Index t)
  {
    return quality(mesh, t) * (is_obtuse(mesh, t) ? worth_of_obtuse : 1.);
  }

  static Defects defects_of(const Bubble_mesh_2& mesh)
  {
    Defects defects;
    for (std::size_t k = 0; k < mesh.triangles.number_of_triangles(); ++k) {
      const Index t = static_cast<Index>(k);
      if (!has_quality(mesh, t, good_quality)) // better ones are acute
        defects.push_back(worth(mesh, t));
    }
    std::sort(defects.begin(), defects.end());
    return defects;
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
      sum += m_mesh.bubbles.d[m_mesh.triangles.vertices[t][i]];
    return sum / 3;
  }

  void try_without(Index v)
  {
    if (!m_mesh.bubbles.can_move(v))
      return;
    const Vertex_removal_2 remove(m_mesh, v);
    if (may_be_too_many(remove))
      consider(remove, v);
  }

  /// A vertex that may move and has more than six triangles, or three where the domain ends beside it, is not the one too
  /// many.
  static bool may_be_too_many(const Vertex_removal_2& remove)
  {
    return remove.number_of_triangles() <= (remove.is_on_outline() ? 3 : 6);
  }

  /// whether there is room for one more vertex on a side with this squared length, or in a triangle with the area of an
  /// equilateral one with such sides
  bool has_room(double squared_length) const
  {
    return squared_length >= least_room * least_room * m_mean_size * m_mean_size;
  }

  /// tries a vertex in a triangle, or beside it by a rounding
  void try_with(const Point& p, Index t)
  {
    const Index host = m_domain.locate_inside(p, m_hint);
    if (host == no_index)
      return;
    consider([&](Bubble_mesh_2& mesh) {
      mesh.bubbles.add(p, m_mean_size, Bubbles_2::FACE, host);
      return Vertex_insertion_2(mesh).in_face(index_of_inserted(), t);
    });
  }

  void try_with_on_side(Index t, int i)
  {
    const Point p = m_mesh.point(t, ccw(i)), q = m_mesh.point(t, cw(i));
    if (!has_room(CGAL::squared_distance(p, q)))
      return;
    if (m_mesh.triangles.edges[t][i] == no_index) {
      try_with(CGAL::midpoint(p, q), t);
      return;
    }
    const Index u = m_patch.indices()[m_mesh.triangles.vertices[t][ccw(i)]],
                v = m_patch.indices()[m_mesh.triangles.vertices[t][cw(i)]];
    const Index e = edge_of_piece(m_domain, m_whole.bubbles, u, v);
    if (e == no_index || !m_domain.edges()[e].takes_bubbles())
      return;
    const double s =
      0.5 * (position_on(m_domain, m_whole.bubbles, e, u) + position_on(m_domain, m_whole.bubbles, e, v));
    consider([&](Bubble_mesh_2& mesh) {
      mesh.bubbles.add(m_domain.point_on_edge(e, s), m_mean_size, Bubbles_2::EDGE, e, s);
      return Vertex_insertion_2(mesh).on_side(index_of_inserted(), t, i);
    });
  }

  Index index_of_inserted() const { return static_cast<Index>(m_mesh.bubbles.size()); }

  /// Takes an outcome among the candidates. `change(mesh)`: changes a copy of the patch, and returns whether it can.
  /// `removed`: which bubble is not in it any more
  template <class Change>
  void consider(const Change& change, Index removed = no_index)
  {
    Bubble_mesh_2 mesh = m_mesh;
    if (!change(mesh))
      return;
    std::vector<Index> original;
    for (Index i = 0; original.size() < mesh.bubbles.size(); ++i)
      if (i != removed)
        original.push_back(i);
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
      if (m_is_better && m_defects.empty())
        return;
      if (k >= number_of_favourites && (m_is_better || !is_hard))
        return;
      Bubble_mesh_2& mesh = m_candidates[k].outcome.mesh;
      Team alone;
      Smoothing_sweeps_2(m_domain, mesh, alone)(is_hard ? usual_sweeps : easy_sweeps);
      Defects defects = defects_of(mesh);
      if (is_better(defects, m_defects, m_is_better ? 0. : least_gain) && smallest_quality(mesh) >= m_smallest) {
        m_defects = std::move(defects);
        m_is_better = true;
        m_best = std::move(m_candidates[k].outcome);
      }
    }
  }

  const Domain_2& m_domain;
  const Bubble_mesh_2& m_whole; // of which the patch is a part
  const Mesh_patch_2& m_patch;
  const Bubble_mesh_2& m_mesh; // of the patch
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
    : m_domain(domain), m_whole(mesh), m_smallest(smallest)
  {}

  /// tries what could help a triangle of a patch; returns whether it did
  bool operator()(const Mesh_patch_2& patch, Index triangle, Patch_outcome_2& outcome)
  {
    triangle = patch.local_triangle(triangle);
    const std::uint64_t signature = patch.signature(triangle);
    if (m_hopeless.count(signature) != 0)
      return false;
    Patch_operation_2 operate(m_domain, m_whole, patch, m_smallest);
    const bool has_helped = operate(triangle);
    if (has_helped)
      outcome = operate.best();
    else
      m_hopeless.insert(signature);
    return has_helped;
  }

private:
  const Domain_2& m_domain;
  const Bubble_mesh_2& m_whole;
  const double m_smallest;
  std::unordered_set<std::uint64_t> m_hopeless; // signatures of what could not be made better
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_TREATMENT_PATCH_OPERATION_2_H
