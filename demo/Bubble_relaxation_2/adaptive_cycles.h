// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef BUBBLE_RELAXATION_2_DEMO_ADAPTIVE_CYCLES_H
#define BUBBLE_RELAXATION_2_DEMO_ADAPTIVE_CYCLES_H

#include "carried_values.h"
#include "corner_singularity.h"
#include "corner_solvers.h"
#include "error_estimate.h"
#include "error_norms.h"
#include "linear_finite_elements.h"
#include "paper_domains.h"
#include "size_from_error.h"

#include <CGAL/Mesh_quality_2.h>
#include <CGAL/npbs_adapt.h>
#include <CGAL/npbs_relax.h>
#include <CGAL/property_map.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <ctime>
#include <functional>
#include <optional>
#include <unordered_map>
#include <vector>

struct Cycle_options
{
  double nodes = 100000;    ///< of the last mesh, about
  double first_size = 0.14; ///< d of the first mesh, everywhere
  double gradation = 0.25;  ///< d grows by no more per unit of length
  double tolerance = 1e-8;  ///< of the solver, of the relative residual
  int most_cycles = 30;
};

/// One turn of the loop: a mesh and the solution on it.
struct Adaptive_cycle
{
  std::size_t vertices = 0, new_vertices = 0;
  double meshing = 0, carrying = 0, sizing = 0, solving = 0; ///< seconds; the last one with the estimate of the error
  Eigen::Index iterations = 0;                 ///< of the solver, which starts from the solution before
  Error_norms error;                           ///< from the exact solution
  double estimate = 0;                         ///< of the error of the gradient
  double minimum_quality = 0;
};

/// Laplace's equation on the L-shape in a loop: solve, estimate the error, and where it asks for it, and there only,
/// make d smaller and the mesh anew.
///
/// All cycles aim at the last mesh: d becomes what the same small error of the gradient in each triangle asks for, but
/// no smaller than a quarter at once, since errors foretell little of a mesh that is much finer. So where the solution
/// is smooth d is right after two or three cycles, each with a sixteenth of the vertices of the next, and those that
/// follow are for the corner only. A d that is nearly small enough stays, else all would change a little each time.
template <class CDT>
class Adaptive_cycles
{
public:
  using Mesh = Triangle_arrays<CDT>;
  using Vertex_handle = typename CDT::Vertex_handle;
  using Field = CGAL::Interpolated_sizing_field_2<CDT>;
  using Exact = Corner_singularity<typename CDT::Geom_traits>;

  explicit Adaptive_cycles(const Cycle_options& options)
    : m_options(options), m_cdt(paper::triangulate<CDT>({Exact::outline()}))
  {}

  /// `look(cycle)` sees each of them.
  template <class Look>
  std::vector<Adaptive_cycle> operator()(const Look& look)
  {
    std::vector<Adaptive_cycle> cycles;
    make_first_mesh();
    for (;;) {
      const Mesh mesh(m_cdt);
      const Error_estimate<CDT> estimate = solve(mesh);
      m_cycle.vertices = mesh.points.size();
      m_cycle.minimum_quality = CGAL::mesh_quality_2(m_cdt).minimum_quality();
      cycles.push_back(m_cycle);
      look(m_cycle);
      if (static_cast<int>(cycles.size()) == m_options.most_cycles || !make_finer(mesh, estimate))
        return cycles;
    }
  }

  /// a mesh made at once with the d of the last one, and the solution on it
  Adaptive_cycle at_once()
  {
    m_cdt = paper::triangulate<CDT>({Exact::outline()});
    m_carried.values.clear();
    m_cycle = Adaptive_cycle();
    const double start = seconds();
    CGAL::npbs_relax(m_cdt, CGAL::parameters::sizing_function(*m_field));
    m_cycle.meshing = seconds() - start;
    const Mesh mesh(m_cdt);
    solve(mesh);
    m_cycle.vertices = m_cycle.new_vertices = mesh.points.size();
    m_cycle.minimum_quality = CGAL::mesh_quality_2(m_cdt).minimum_quality();
    return m_cycle;
  }

  const CDT& mesh() const { return m_cdt; }

private:
  static constexpr double worthwhile = 0.75; ///< of d: what wants more stays as it is
  static constexpr double least_step = 0.6;  ///< other d becomes as small as that at least: npbs_adapt() tells that
  static constexpr double enough = 0.01;     ///< share of the squared error, below which it is no use to go on

  static double seconds()
  {
    return double(std::clock()) / CLOCKS_PER_SEC; // of this process, whatever else runs
  }

  void make_first_mesh()
  {
    const double start = seconds();
    CGAL::npbs_relax(m_cdt, CGAL::parameters::sizing_function(m_options.first_size));
    m_cycle.meshing = seconds() - start;
    m_cycle.new_vertices = m_cdt.number_of_vertices();
  }

  Error_estimate<CDT> solve(const Mesh& mesh)
  {
    const double start = seconds();
    const Linear_element_system<CDT> system(mesh, corner_problem<CDT>());
    const Eigen::VectorXd u = system.solve(m_carried.in_order(mesh), m_options.tolerance, m_cycle.iterations);
    Error_estimate<CDT> estimate(mesh, u);
    m_cycle.solving = seconds() - start;
    m_carried.set(mesh, u);
    m_cycle.estimate = estimate.total();
    m_cycle.error = error_of_linear_elements<Exact>(mesh, u);
    return estimate;
  }

  /// Returns whether the error asks for it.
  bool make_finer(const Mesh& mesh, const Error_estimate<CDT>& estimate)
  {
    m_cycle = Adaptive_cycle();
    double start = seconds();
    if (!set_sizes(mesh, estimate))
      return false;
    m_cycle.sizing = seconds() - start;
    start = seconds();
    m_carried.number_of_new_vertices = 0;
    m_carried.seconds = 0;
    CGAL::npbs_adapt(m_cdt, CGAL::parameters::sizing_function(*m_field)
                              .faces_to_check(faces_around(m_changed))
                              .visitor(std::ref(m_carried)));
    m_cycle.carrying = m_carried.seconds;
    m_cycle.meshing = seconds() - start - m_cycle.carrying;
    m_cycle.new_vertices = m_carried.number_of_new_vertices;
    return true;
  }

  /// Makes d smaller where the error asks for it. Returns whether that is worth while.
  bool set_sizes(const Mesh& mesh, const Error_estimate<CDT>& estimate)
  {
    constexpr double least = 1e-4, most = 1, at_once = 4;
    const std::vector<double> wanted =
      Size_from_error<CDT>(mesh, estimate.of_triangles(), Equal_error::GRADIENT).sizes(m_options.nodes, least, most);
    std::unordered_map<Vertex_handle, double> sizes;
    std::vector<char> is_changed(wanted.size(), 0);
    m_changed.clear();
    for (std::size_t v = 0; v < wanted.size(); ++v) {
      double& d = sizes[mesh.vertices[v]] = m_field ? (*m_field)(mesh.points[v]) : m_options.first_size;
      is_changed[v] = wanted[v] < worthwhile * d;
      if (!is_changed[v])
        continue;
      d = (std::min)((std::max)(wanted[v], d / at_once), least_step * d);
      m_changed.push_back(mesh.vertices[v]);
    }
    double changed = 0, all = 0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      const double square = estimate.of_triangles()[t] * estimate.of_triangles()[t];
      const auto& v = mesh.triangles[t];
      all += square;
      if (is_changed[v[0]] || is_changed[v[1]] || is_changed[v[2]])
        changed += square;
    }
    if (changed < enough * all)
      return false;
    m_field.emplace(m_cdt, boost::make_assoc_property_map(sizes), m_options.gradation);
    return true;
  }

  /// those of the domain; some come twice
  std::vector<typename CDT::Face_handle> faces_around(const std::vector<Vertex_handle>& vertices) const
  {
    std::vector<typename CDT::Face_handle> faces;
    for (const Vertex_handle v : vertices) {
      auto f = m_cdt.incident_faces(v), first = f;
      do
        if (f->is_in_domain())
          faces.push_back(f);
      while (++f != first);
    }
    return faces;
  }

  Cycle_options m_options;
  CDT m_cdt;
  Carried_values<CDT> m_carried{m_cdt};
  std::vector<Vertex_handle> m_changed; ///< those where d became smaller
  std::optional<Field> m_field;         ///< d, after the first mesh
  Adaptive_cycle m_cycle;               ///< the one that is under way
};

#endif // BUBBLE_RELAXATION_2_DEMO_ADAPTIVE_CYCLES_H
