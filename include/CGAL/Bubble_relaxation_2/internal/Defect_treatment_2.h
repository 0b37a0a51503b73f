// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DEFECT_TREATMENT_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DEFECT_TREATMENT_2_H

#include <CGAL/Bubble_relaxation_2/internal/Bubble_mesh_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Vertex_smoothing_2.h>
#include <CGAL/Bubble_relaxation_2/internal/parallel_for.h>
#include <CGAL/radius_ratio_2.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// q of each triangle of the domain, 1 outside
template <class Concurrency_tag>
std::vector<double> qualities(const Marked_triangulation_2& mesh)
{
  std::vector<double> result(mesh.tr.number_of_triangles());
  parallel_for<Concurrency_tag>(result.size(), [&](std::size_t t) {
    const Index i = static_cast<Index>(t);
    result[t] = mesh.inside[t] != 0
                  ? radius_ratio(mesh.tr.point(i, 0), mesh.tr.point(i, 1), mesh.tr.point(i, 2))
                  : 1.;
  });
  return result;
}

/// the smallest q of the triangles of the domain
template <class Concurrency_tag = Sequential_tag>
double smallest_quality(const Marked_triangulation_2& mesh)
{
  const std::vector<double> q = qualities<Concurrency_tag>(mesh);
  return q.empty() ? 1. : *std::min_element(q.begin(), q.end());
}

/// The last defects. Where vertices have five and seven neighbours the forces press triangles more than
/// they must be pressed. So the vertices of bad triangles are moved for the quality of their triangles
/// alone: in sweeps, of which each takes the vertices around those that moved in the last one, with the
/// constrained Delaunay property restored in between.
template <class Concurrency_tag>
class Defect_treatment_2
{
public:
  /// triangles with less are treated
  double treated_quality = 0.95;
  int number_of_sweeps = 4;

  Defect_treatment_2(const Domain_2& domain, Marked_triangulation_2& mesh, Bubbles_2& bubbles)
    : m_domain(domain), m_mesh(mesh), m_bubbles(bubbles)
  {}

  /// returns the vertices that were moved
  std::vector<Index> operator()()
  {
    Editable_triangulation_2 mesh(m_mesh);
    std::vector<char> was_moved(m_bubbles.size(), 0);
    std::vector<Index> candidates = vertices_of_bad_triangles();
    for (int sweep = 0; sweep < number_of_sweeps && !candidates.empty(); ++sweep) {
      const std::vector<Index> moved = move(mesh, candidates);
      mesh.restore_delaunay(moved);
      for (Index v : moved)
        was_moved[v] = 1;
      candidates = neighbors_of(mesh, moved);
    }
    return marked(was_moved);
  }

private:
  std::vector<Index> vertices_of_bad_triangles() const
  {
    const Flat_triangulation_2& tr = m_mesh.tr;
    const std::vector<double> q = qualities<Concurrency_tag>(m_mesh);
    std::vector<char> marks(m_bubbles.size(), 0);
    for (std::size_t t = 0; t < q.size(); ++t)
      if (q[t] < treated_quality)
        for (Index v : tr.vertices[t])
          marks[v] = m_bubbles.can_move(v);
    return marked(marks);
  }

  static std::vector<Index> marked(const std::vector<char>& marks)
  {
    std::vector<Index> result;
    for (std::size_t v = 0; v < marks.size(); ++v)
      if (marks[v])
        result.push_back(static_cast<Index>(v));
    return result;
  }

  /// tries to move the candidates: neighbours one after the other, others at the same time
  std::vector<Index> move(Editable_triangulation_2& mesh, const std::vector<Index>& candidates)
  {
    const Vertex_smoothing_2 smooth(m_domain, treated_quality);
    std::vector<Index> result;
    std::vector<char> moved;
    for (const std::vector<Index>& independent : independent_sets(mesh, candidates)) {
      moved.assign(independent.size(), 0);
      parallel_for<Concurrency_tag>(
        independent.size(),
        [&](std::size_t k) { moved[k] = smooth(mesh, m_bubbles, independent[k]); }, 64);
      for (std::size_t k = 0; k < independent.size(); ++k)
        if (moved[k])
          result.push_back(independent[k]);
    }
    return result;
  }

  /// the candidates in sets without neighbours, each in the first set that has none of its neighbours
  std::vector<std::vector<Index>> independent_sets(const Editable_triangulation_2& mesh,
                                                   const std::vector<Index>& candidates)
  {
    constexpr unsigned none = 255;
    m_set.resize(m_bubbles.size(), none);
    std::vector<std::vector<Index>> sets;
    for (Index v : candidates) {
      std::uint64_t taken = 0;
      for (const Corner_2& c : mesh.star(v))
        for (Index w : m_mesh.tr.vertices[c.triangle])
          if (m_set[w] != none)
            taken |= std::uint64_t(1) << m_set[w];
      unsigned set = 0;
      while (set < 63 && (taken >> set & 1) != 0)
        ++set;
      if (set == 63)
        continue; // more neighbours than this are not to be treated here
      m_set[v] = static_cast<unsigned char>(set);
      if (set == sets.size())
        sets.emplace_back();
      sets[set].push_back(v);
    }
    for (Index v : candidates)
      m_set[v] = none;
    return sets;
  }

  std::vector<Index> neighbors_of(const Editable_triangulation_2& mesh,
                                  const std::vector<Index>& moved) const
  {
    std::vector<Index> result;
    for (Index v : moved)
      for (const Corner_2& c : mesh.star(v))
        for (Index w : m_mesh.tr.vertices[c.triangle])
          if (m_bubbles.can_move(w))
            result.push_back(w);
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

  const Domain_2& m_domain;
  Marked_triangulation_2& m_mesh;
  Bubbles_2& m_bubbles;
  std::vector<unsigned char> m_set; // of candidates
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DEFECT_TREATMENT_2_H
