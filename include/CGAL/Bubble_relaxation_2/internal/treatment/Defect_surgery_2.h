// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_TREATMENT_DEFECT_SURGERY_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_TREATMENT_DEFECT_SURGERY_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/Bubbles_2.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Progress.h>
#include <CGAL/Bubble_relaxation_2/internal/core/reproducible_math.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Greedy_choice.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Mesh_stitching_2.h>
#include <CGAL/Bubble_relaxation_2/internal/treatment/Patch_operation_2.h>
#include <CGAL/Bubble_relaxation_2/internal/treatment/Smoothing_sweeps_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// A triangle to be operated on. The worst comes first; among equals its vertices decide.
struct Bad_triangle_2
{
  double quality;
  std::array<std::int64_t, 3> vertices; ///< their numbers among all, in order
  Index triangle;

  bool operator<(const Bad_triangle_2& t) const
  {
    return std::tie(quality, vertices) < std::tie(t.quality, t.vertices);
  }
};

/// what q can be at most where the input fixes angles between two edges, which one triangle has or two share
inline double best_quality(const Bubble_mesh_2& mesh, Index t)
{
  double best = 1;
  for (int i = 0; i < 3; ++i) {
    if (mesh.triangles.edges[t][ccw(i)] == no_index || mesh.triangles.edges[t][cw(i)] == no_index)
      continue;
    const Kernel::Vector_2 u = mesh.point(t, ccw(i)) - mesh.point(t, i),
                           v = mesh.point(t, cw(i)) - mesh.point(t, i);
    const double half = 0.5 * angle_of(u * v, std::abs(u.x() * v.y() - u.y() * v.x()));
    best = (std::min)(best, (std::max)(quality_of_isosceles(half), quality_of_isosceles(half / 2)));
  }
  return best;
}

/// The triangles with q less than `bad_quality` and a vertex from `first` on, see `number_of()`, unless the input does not
/// allow for more; the worst first.
inline std::vector<Bad_triangle_2> bad_triangles(const Bubble_mesh_2& mesh, double bad_quality, std::int64_t first)
{
  const Marked_triangles_2& m = mesh.triangles;
  std::vector<Bad_triangle_2> result;
  for (std::size_t k = 0; k < m.inside.size(); ++k) {
    tick(k);
    const Index t = static_cast<Index>(k);
    if (!m.inside[k] || !has_vertex_from(first, mesh, t) || has_quality(mesh, t, bad_quality))
      continue;
    const double q = quality(mesh, t);
    if (!(q < 0.9 * best_quality(mesh, t)))
      continue;
    Bad_triangle_2 bad{q, {}, t};
    for (int i = 0; i < 3; ++i)
      bad.vertices[i] = number_of(mesh.bubbles, m.vertices[k][i]);
    std::sort(bad.vertices.begin(), bad.vertices.end());
    result.push_back(bad);
  }
  std::sort(result.begin(), result.end());
  return result;
}

/// What is still bad when vertices were moved needs one vertex less or more. Operates on bad triangles, the worst first,
/// on patches that do not overlap, and puts what comes out in their place.
class Defect_surgery_2
{
public:
  /// \param smallest q of the mesh, which does not get smaller
  /// \param first triangles with a vertex from there on are operated on
  /// \pre the edges of `mesh` are labelled
  Defect_surgery_2(const Domain_2& domain, Bubble_mesh_2& mesh, double smallest, std::int64_t first)
    : first_number(first), m_mesh(mesh), m_operate(domain, mesh, smallest)
  {}

  std::int64_t first_number; ///< of the vertices whose triangles are operated on; falls when others before it go

  /// what was done
  std::size_t number_of_insertions = 0, number_of_deletions = 0;
  bool has_changed_outline = false; ///< then the triangles outside of the domain are still to be made

  /// operates on triangles with less than `bad_quality`; returns whether any of them got better
  bool operator()(double bad_quality)
  {
    const std::vector<Bad_triangle_2> worst = bad_triangles(m_mesh, bad_quality, first_number);
    const std::vector<Operation> operations = operate(worst);
    if (operations.empty())
      return false;
    Mesh_stitching_2 stitching(m_mesh);
    m_gone_before_first = 0;
    for (const Operation& operation : operations) {
      const std::vector<Index> number = replace_bubbles(operation);
      stitching.replace(operation.patch.triangles(), triangles_of(operation.outcome.mesh.triangles, number));
    }
    stitching.finish();
    first_number -= m_gone_before_first;
    return true;
  }

private:
  struct Operation
  {
    Mesh_patch_2 patch;
    Patch_outcome_2 outcome;
  };

  std::vector<Operation> operate(const std::vector<Bad_triangle_2>& worst)
  {
    std::vector<std::vector<Index>> triangles; // of their patches, most of which nobody operates on
    std::unordered_map<Index, std::vector<Index>> patches_of; // triangles
    Greedy_choice choice;
    choice.start(worst.size());
    for (std::size_t k = 0; k < worst.size(); ++k) {
      tick();
      triangles.push_back(triangles_around(m_mesh.triangles, worst[k].triangle));
      choice.add(static_cast<Index>(k));
      for (Index t : triangles[k]) {
        std::vector<Index>& before = patches_of[t];
        choice.rivals(k).insert(choice.rivals(k).end(), before.begin(), before.end());
        before.push_back(static_cast<Index>(k));
      }
    }
    std::vector<Operation> result;
    choice.decide([&](Index k) {
      tick();
      Operation operation{Mesh_patch_2(m_mesh, std::move(triangles[k])), {}};
      const bool has_helped = m_operate(operation.patch, worst[k].triangle, operation.outcome);
      if (has_helped)
        result.push_back(std::move(operation));
      return has_helped;
    });
    return result;
  }

  /// `number`: what the bubbles of an outcome are called in the mesh
  static std::vector<New_triangle_2> triangles_of(const Marked_triangles_2& m, const std::vector<Index>& number)
  {
    std::vector<New_triangle_2> result;
    for (std::size_t t = 0; t < m.number_of_triangles(); ++t) {
      const std::array<Index, 3>& v = m.vertices[t];
      result.push_back({{number[v[0]], number[v[1]], number[v[2]]}, m.edges[t]});
    }
    return result;
  }

  /// puts the bubbles of an outcome in the place of those of a patch; returns their numbers in the mesh
  std::vector<Index> replace_bubbles(const Operation& operation)
  {
    const std::vector<Index>& indices = operation.patch.indices();
    const Bubbles_2& b = operation.outcome.mesh.bubbles;
    std::vector<char> is_left(indices.size(), 0);
    std::vector<Index> number;
    for (std::size_t k = 0; k < b.size(); ++k) {
      const std::size_t original = static_cast<std::size_t>(operation.outcome.original[k]);
      if (original >= indices.size()) {
        number.push_back(insert(b, k));
        continue;
      }
      is_left[original] = 1;
      number.push_back(indices[original]);
      move(b, k, indices[original]);
    }
    for (std::size_t l = 0; l < indices.size(); ++l)
      if (!is_left[l])
        remove(indices[l]);
    return number;
  }

  Index insert(const Bubbles_2& b, std::size_t k)
  {
    ++number_of_insertions;
    has_changed_outline = has_changed_outline || b.is_on_edge(k);
    m_mesh.bubbles.make_room_for(1);
    m_mesh.bubbles.add(b, k);
    return static_cast<Index>(m_mesh.bubbles.size() - 1);
  }

  void move(const Bubbles_2& b, std::size_t k, Index i)
  {
    Bubbles_2& all = m_mesh.bubbles;
    has_changed_outline = has_changed_outline || (b.is_on_edge(k) && b.point(k) != all.point(i));
    all.x[i] = b.x[k];
    all.y[i] = b.y[k];
    all.s[i] = b.s[k];
    if (b.is_in_face(k))
      all.host[i] = b.host[k];
  }

  void remove(Index i)
  {
    ++number_of_deletions;
    m_gone_before_first += i < first_number;
    has_changed_outline = has_changed_outline || m_mesh.bubbles.is_on_edge(i);
    m_mesh.bubbles.remove(i);
  }

  Bubble_mesh_2& m_mesh;
  Patch_operations_2 m_operate;
  std::int64_t m_gone_before_first = 0;
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_TREATMENT_DEFECT_SURGERY_2_H
