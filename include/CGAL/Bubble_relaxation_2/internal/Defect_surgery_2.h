// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DEFECT_SURGERY_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DEFECT_SURGERY_2_H

#include <CGAL/Bubble_relaxation_2/internal/Bad_triangle_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Mesh_patch_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Mesh_stitching_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Patch_operation_2.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// What is still bad when vertices were moved needs one vertex less or more. Operates on the worst triangles,
/// the worst first, on patches that do not overlap, and puts what comes out in their place.
class Defect_surgery_2
{
public:
  /// `bad_quality`: triangles with less are operated on. \pre the edges of `mesh` are labelled.
  Defect_surgery_2(const Domain_2& domain, const Bubble_mesh_2& mesh, double bad_quality)
    : m_domain(domain), m_mesh(mesh), m_bad_quality(bad_quality)
  {}

  /// what the last call did
  std::size_t number_of_insertions = 0, number_of_deletions = 0;
  bool has_changed_outline = false; ///< then the triangles outside of the domain are still to be made

  /// operates on `most` triangles at most; returns the mesh if it changed, else an empty one
  Bubble_mesh_2 operator()(std::size_t most)
  {
    const std::vector<Operation> operations = operate(most);
    if (operations.empty())
      return {};
    Bubble_mesh_2 result = m_mesh;
    Mesh_stitching_2 stitching(result.triangulation);
    for (const Operation& operation : operations) {
      const std::vector<Index> number = replace_bubbles(operation, result);
      stitching.replace(operation.patch.triangles(), operation.outcome.triangles(operation.patch, number));
    }
    stitching.finish(result.bubbles.indices_left());
    result.bubbles.forget_gone();
    return result;
  }

private:
  struct Operation
  {
    Mesh_patch_2 patch;
    Patch_outcome_2 outcome;
  };

  std::vector<Operation> operate(std::size_t most) const
  {
    std::vector<char> is_taken(m_mesh.triangulation.tr.number_of_triangles(), 0);
    std::vector<Operation> result;
    std::vector<Bad_triangle_2> worst = bad_triangles(m_mesh.bubbles, m_mesh.triangulation, m_bad_quality);
    worst.resize((std::min)(most, worst.size()));
    for (const Bad_triangle_2& bad : worst) {
      Mesh_patch_2 patch(m_mesh.bubbles, m_mesh.triangulation, bad.triangle);
      if (std::any_of(patch.triangles().begin(), patch.triangles().end(),
                      [&](Index n) { return is_taken[n] != 0; }))
        continue;
      Patch_operation_2 operate(m_domain, m_mesh.bubbles, m_mesh.triangulation, patch);
      if (!operate(bad.triangle))
        continue;
      for (Index n : patch.triangles())
        is_taken[n] = 1;
      result.push_back(Operation{std::move(patch), operate.best()});
    }
    return result;
  }

  /// puts the bubbles of an outcome in the place of those of a patch; returns their numbers in the mesh
  std::vector<Index> replace_bubbles(const Operation& operation, Bubble_mesh_2& mesh)
  {
    const std::vector<Index>& indices = operation.patch.indices();
    const Bubbles_2& b = operation.outcome.bubbles;
    std::vector<char> is_left(indices.size(), 0);
    std::vector<Index> number;
    for (std::size_t k = 0; k < b.size(); ++k) {
      const std::size_t original = static_cast<std::size_t>(operation.outcome.original[k]);
      if (original >= indices.size()) {
        number.push_back(insert(b, k, mesh));
        continue;
      }
      is_left[original] = 1;
      number.push_back(indices[original]);
      move(b, k, indices[original], mesh);
    }
    for (std::size_t l = 0; l < indices.size(); ++l)
      if (!is_left[l])
        remove(indices[l], mesh);
    return number;
  }

  Index insert(const Bubbles_2& b, std::size_t k, Bubble_mesh_2& mesh)
  {
    ++number_of_insertions;
    has_changed_outline = has_changed_outline || b.is_on_edge(k);
    mesh.bubbles.add(b.point(k), b.d[k], static_cast<Bubbles_2::Dimension>(b.dimension[k]), b.place[k], b.s[k]);
    mesh.triangulation.tr.points.push_back(b.point(k));
    return static_cast<Index>(mesh.bubbles.size() - 1);
  }

  void move(const Bubbles_2& b, std::size_t k, Index i, Bubble_mesh_2& mesh)
  {
    Bubbles_2& all = mesh.bubbles;
    has_changed_outline = has_changed_outline || (b.is_on_edge(k) && b.point(k) != all.point(i));
    all.x[i] = b.x[k];
    all.y[i] = b.y[k];
    all.s[i] = b.s[k];
    if (b.is_in_face(k))
      all.place[i] = b.place[k];
    mesh.triangulation.tr.points[i] = b.point(k);
  }

  void remove(Index i, Bubble_mesh_2& mesh)
  {
    ++number_of_deletions;
    has_changed_outline = has_changed_outline || mesh.bubbles.is_on_edge(i);
    mesh.bubbles.remove(i);
  }

  const Domain_2& m_domain;
  const Bubble_mesh_2& m_mesh;
  const double m_bad_quality;
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DEFECT_SURGERY_2_H
