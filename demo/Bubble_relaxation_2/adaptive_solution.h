// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef BUBBLE_RELAXATION_2_DEMO_ADAPTIVE_SOLUTION_H
#define BUBBLE_RELAXATION_2_DEMO_ADAPTIVE_SOLUTION_H

#include "error_estimate.h"
#include "error_norms.h"
#include "linear_finite_elements.h"
#include "size_from_error.h"

#include <CGAL/npbs_relax.h>

#include <Eigen/Core>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <vector>

/// How meshes follow one another.
enum class Refinement
{
  UNIFORM,        ///< the same d everywhere
  EQUAL_GRADIENT, ///< d from the estimated error, `Equal_error::GRADIENT`
  EQUAL_VALUE     ///< d from the estimated error, `Equal_error::VALUE`
};

struct Adaptive_options
{
  Refinement refinement = Refinement::EQUAL_GRADIENT;
  double first_size = 0.14;    ///< d of the first mesh, everywhere
  double growth = 2;           ///< of the number of nodes from one mesh to the next
  double most_nodes = 102400;  ///< no mesh with more is begun
  double gradation = 0.25;     ///< d grows by no more per unit of length
  double tolerance = 0;        ///< of the estimated error of the gradient; 0: go on as long as `most_nodes` allows
};

/// What a method makes of a mesh.
struct Solved
{
  Eigen::VectorXd values;            ///< at the vertices
  std::function<Error_norms()> error; ///< from the exact solution, computed on demand
};

/// One turn of the loop: a mesh, the solution on it, and its errors.
struct Adaptive_step
{
  std::size_t nodes = 0;
  double smallest_size = 0;     ///< the smallest d at a vertex of the mesh
  Error_norms error;            ///< from the exact solution
  double estimate = 0;          ///< of the error of the gradient, from the computed solution alone
  double mean_quality = 0, minimum_quality = 0;
  double relaxing = 0, solving = 0; ///< seconds; solving is without the evaluation of the error
};

/// the observed power of the number of nodes: the slope of a line through the last steps in logarithms
template <class Error>
double observed_rate(const std::vector<Adaptive_step>& steps, std::size_t how_many, const Error& error)
{
  const std::size_t first = steps.size() - (std::min)(how_many, steps.size());
  double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  for (std::size_t k = first; k < steps.size(); ++k) {
    const double a = std::log(static_cast<double>(steps[k].nodes)), b = std::log(error(steps[k]));
    n += 1;
    x += a;
    y += b;
    xx += a * a;
    xy += a * b;
  }
  return (n * xy - x * y) / (n * xx - x * x);
}

/// The loop: solve, estimate the error, make the next d from it, relax the mesh that is there.
template <class CDT>
class Adaptive_solution
{
public:
  using Mesh = Triangle_arrays<CDT>;
  using Field = CGAL::Interpolated_sizing_field_2<CDT>;

  /// \param cdt the domain; on return the last mesh
  Adaptive_solution(CDT& cdt, const Adaptive_options& options) : m_cdt(cdt), m_options(options) {}

  /// `solve(cdt, mesh)` returns a `Solved`, `look(cdt, step)` sees each mesh.
  /// \throws std::runtime_error if the tolerance is not reached
  template <class Solve, class Look>
  std::vector<Adaptive_step> operator()(const Solve& solve, const Look& look)
  {
    std::vector<Adaptive_step> steps;
    double uniform_size = m_options.first_size;
    relax([&](const auto&) { return uniform_size; });
    for (;;) {
      const Mesh mesh(m_cdt);
      const double start = seconds();
      const Solved solved = solve(m_cdt, mesh);
      const Error_estimate<CDT> estimate(mesh, solved.values);
      m_step.solving = seconds() - start;
      m_step.nodes = mesh.points.size();
      m_step.error = solved.error();
      m_step.estimate = estimate.total();
      steps.push_back(m_step);
      look(m_cdt, m_step);
      if (m_step.estimate <= m_options.tolerance)
        return steps;
      const double nodes = m_options.growth * static_cast<double>(m_step.nodes);
      if (nodes > m_options.most_nodes) {
        check_tolerance();
        return steps;
      }
      if (m_options.refinement == Refinement::UNIFORM) {
        uniform_size /= std::sqrt(m_options.growth);
        relax([&](const auto&) { return uniform_size; });
      } else
        relax(next_size(mesh, estimate, nodes));
    }
  }

private:
  static double seconds()
  {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
  }

  Field next_size(const Mesh& mesh, const Error_estimate<CDT>& estimate, double nodes) const
  {
    const Equal_error equal =
      m_options.refinement == Refinement::EQUAL_GRADIENT ? Equal_error::GRADIENT : Equal_error::VALUE;
    return Size_from_error<CDT>(mesh, estimate.of_triangles(), equal)(m_cdt, nodes, m_options.gradation);
  }

  template <class Sizing>
  void relax(const Sizing& d)
  {
    const double start = seconds();
    const auto report = CGAL::npbs_relax(m_cdt, CGAL::parameters::sizing_function(d));
    m_step.relaxing = seconds() - start;
    m_step.mean_quality = report.quality.mean_quality();
    m_step.minimum_quality = report.quality.minimum_quality();
    m_step.smallest_size = (std::numeric_limits<double>::max)();
    for (auto v : m_cdt.finite_vertex_handles())
      m_step.smallest_size = (std::min)(m_step.smallest_size, d(v->point()));
  }

  void check_tolerance() const
  {
    if (m_options.tolerance == 0)
      return;
    std::ostringstream message;
    message << "the estimated error is " << m_step.estimate << " with " << m_step.nodes << " nodes: the tolerance "
            << m_options.tolerance << " needs more than the " << m_options.most_nodes << " that are allowed";
    throw std::runtime_error(message.str());
  }

  CDT& m_cdt;
  Adaptive_options m_options;
  Adaptive_step m_step; ///< the one that is under way
};

#endif // BUBBLE_RELAXATION_2_DEMO_ADAPTIVE_SOLUTION_H
