// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef BUBBLE_RELAXATION_2_BENCHMARK_CGAL_MESHERS_H
#define BUBBLE_RELAXATION_2_BENCHMARK_CGAL_MESHERS_H

#include "meshing.h"

#include <CGAL/Bubble_mesh_criteria_2.h>
#include <CGAL/Delaunay_mesh_vertex_base_2.h>
#include <CGAL/Delaunay_mesher_2.h>
#include <CGAL/centroid.h>
#include <CGAL/lloyd_optimize_mesh_2.h>
#include <CGAL/npbs_relax.h>
#include <CGAL/version.h>

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <vector>

/// this package, with its defaults
inline Meshing mesh_with_bubbles(const paper::Domain& domain)
{
  Meshing result;
  paper::CDT cdt = paper::triangulate(domain);
  const double start = cpu_seconds();
  result.triangles = CGAL::npbs_relax(cdt, CGAL::parameters::sizing_function(domain.d)).number_of_triangles;
  result.seconds = cpu_seconds() - start;
  result.mesh = vertices_and_constraints(cdt);
  return result;
}

/// CGAL's 2D Meshes: Delaunay refinement, and Lloyd's optimisation of what it makes. The same d bounds the
/// edges, but a bound is not a wanted length: `scale` times d is what gives as many vertices as asked for.
class Cgal_mesher
{
  // the optimisation wants its own vertices
  using K = paper::K;
  using CDT = CGAL::Constrained_Delaunay_triangulation_2<
    K, CGAL::Triangulation_data_structure_2<CGAL::Delaunay_mesh_vertex_base_2<K>,
                                            CGAL::Delaunay_mesh_face_base_2<K>>>;

public:
  explicit Cgal_mesher(const paper::Domain& domain) : m_domain(domain) {}

  /// looks for the scale that gives about as many vertices
  Cgal_mesher(const paper::Domain& domain, std::size_t wanted_vertices) : m_domain(domain)
  {
    for (int i = 0; i < 6; ++i) {
      const double n = double(refine_and_optimize(0).mesh.points.size());
      const double ratio = n / double(wanted_vertices);
      if (std::abs(ratio - 1) < 0.01)
        break;
      m_scale *= std::sqrt(ratio);
    }
  }

  /// what d is multiplied with
  double scale() const { return m_scale; }

  Meshing refine_and_optimize(int number_of_iterations) const
  {
    CDT cdt = paper::triangulate<CDT>(m_domain.outlines);
    const std::vector<paper::Point> seeds(1, point_in_domain(cdt));
    const auto scaled = [scale = m_scale, &d = m_domain.d](const paper::Point& p) { return scale * d(p); };
    using Criteria = CGAL::Bubble_mesh_criteria_2<CDT, decltype(scaled)>;

    Meshing result;
    const double start = cpu_seconds();
    CGAL::Delaunay_mesher_2<CDT, Criteria> mesher(cdt, Criteria(scaled));
    mesher.set_seeds(seeds.begin(), seeds.end(), true);
    mesher.refine_mesh();
    if (number_of_iterations > 0)
      optimize(cdt, seeds, number_of_iterations);
    result.seconds = cpu_seconds() - start;
    for (const auto& f : cdt.finite_face_handles())
      result.triangles += f->is_in_domain();
    result.mesh = vertices_and_constraints(cdt);
    return result;
  }

private:
  /// the domain is connected: one is enough
  static paper::Point point_in_domain(const CDT& outlines)
  {
    std::size_t t = 0;
    const std::vector<char> is_inside = faces_in_domain(outlines);
    for (CDT::Face_handle f : outlines.all_face_handles())
      if (is_inside[t++])
        return CGAL::centroid(f->vertex(0)->point(), f->vertex(1)->point(), f->vertex(2)->point());
    throw std::runtime_error("the outlines have no inside");
  }

  /// all iterations: neither do vertices freeze nor does it end when they move little
  static void optimize(CDT& cdt, const std::vector<paper::Point>& seeds, int number_of_iterations)
  {
#if CGAL_VERSION_NR < CGAL_VERSION_NUMBER(5, 6, 0)
    CGAL::lloyd_optimize_mesh_2(cdt, CGAL::parameters::max_iteration_number = number_of_iterations,
                                CGAL::parameters::convergence = 0., CGAL::parameters::freeze_bound = 0.,
                                CGAL::parameters::seeds_begin = seeds.begin(),
                                CGAL::parameters::seeds_end = seeds.end(), CGAL::parameters::mark = true);
#else
    CGAL::lloyd_optimize_mesh_2(
      cdt, CGAL::parameters::number_of_iterations(number_of_iterations).convergence(0).freeze_bound(0).seeds(seeds)
             .seeds_are_in_domain(true));
#endif
  }

  const paper::Domain& m_domain;
  double m_scale = 1;
};

#endif // BUBBLE_RELAXATION_2_BENCHMARK_CGAL_MESHERS_H
