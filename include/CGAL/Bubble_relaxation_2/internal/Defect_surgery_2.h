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
#include <CGAL/Bubble_relaxation_2/internal/Patch_operation_2.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// What is still bad when vertices were moved needs one vertex less or more. Operates on the worst triangles,
/// the worst first, on patches that do not overlap.
class Defect_surgery_2
{
public:
  /// `bad_quality`: triangles with less are operated on
  Defect_surgery_2(const Domain_2& domain, const Bubble_mesh_2& mesh, double bad_quality)
    : m_domain(domain), m_mesh(mesh), m_bad_quality(bad_quality)
  {}

  /// what the last call did
  std::size_t number_of_insertions = 0, number_of_deletions = 0;

  /// operates on `most` triangles at most; returns the bubbles if any changed, else none
  Bubbles_2 operator()(std::size_t most)
  {
    std::vector<char> is_taken(m_mesh.triangulation.tr.number_of_triangles(), 0);
    Bubbles_2 result;
    number_of_insertions = number_of_deletions = 0;
    std::vector<Bad_triangle_2> worst = bad_triangles(m_mesh.bubbles, m_mesh.triangulation, m_bad_quality);
    worst.resize((std::min)(most, worst.size()));
    for (const Bad_triangle_2& bad : worst) {
      const Mesh_patch_2 patch(m_mesh.bubbles, m_mesh.triangulation, bad.triangle);
      if (std::any_of(patch.triangles().begin(), patch.triangles().end(),
                      [&](Index n) { return is_taken[n] != 0; }))
        continue;
      Patch_operation_2 operate(m_domain, m_mesh.bubbles, m_mesh.triangulation, patch);
      if (!operate(bad.triangle))
        continue;
      if (result.size() == 0)
        result = m_mesh.bubbles;
      replace(patch, operate.best(), result);
      for (Index n : patch.triangles())
        is_taken[n] = 1;
    }
    result.forget_gone();
    return result;
  }

private:
  /// puts an outcome in the place of a patch
  void replace(const Mesh_patch_2& patch, const Patch_outcome_2& outcome, Bubbles_2& result)
  {
    const std::size_t n = patch.indices().size();
    const Bubbles_2& b = outcome.bubbles;
    std::vector<char> is_left(n, 0);
    for (std::size_t k = 0; k < b.size(); ++k) {
      const std::size_t original = static_cast<std::size_t>(outcome.original[k]);
      if (original >= n) {
        result.add(b.point(k), b.d[k], static_cast<Bubbles_2::Dimension>(b.dimension[k]), b.place[k], b.s[k]);
        ++number_of_insertions;
        continue;
      }
      is_left[original] = 1;
      const Index i = patch.indices()[original];
      result.x[i] = b.x[k];
      result.y[i] = b.y[k];
      result.s[i] = b.s[k];
      if (b.is_in_face(k))
        result.place[i] = b.place[k];
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
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DEFECT_SURGERY_2_H
