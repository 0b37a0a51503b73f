// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_ELEMENT_FREE_GALERKIN_SOLUTION_2_H
#define CGAL_ELEMENT_FREE_GALERKIN_SOLUTION_2_H

#include <CGAL/license/Bubble_relaxation_2.h>

#include <CGAL/Bubble_relaxation_2/internal/core/disable_warnings.h>

#include <CGAL/Bubble_relaxation_2/internal/meshless/galerkin/Galerkin_method_2.h>
#include <CGAL/Element_free_Galerkin_error_2.h>
#include <CGAL/Element_free_Galerkin_report_2.h>
#include <CGAL/Moving_least_squares_2.h>

#include <CGAL/number_utils.h>
#include <CGAL/use.h>

#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgBubbleRelaxation2Meshless

The solution that `Element_free_Galerkin_2` found. It keeps what it needs: solver, nodes and triangulation may go
away. Copies share it. All functions may be called by several threads at once.

\tparam Kernel_ the kernel of the triangulation
*/
template <class Kernel_>
class Element_free_Galerkin_solution_2
{
  using Discretization = Bubble_relaxation_2::internal::Galerkin_discretization_2;

public:
  using Kernel = Kernel_;
  using Point_2 = typename Kernel::Point_2;
  using Vector_2 = typename Kernel::Vector_2;
  using Report = Element_free_Galerkin_report_2;
  using Values = typename Moving_least_squares_2<Kernel>::Values; ///< of `evaluate()`

#ifndef DOXYGEN_RUNNING
  Element_free_Galerkin_solution_2(std::shared_ptr<const Discretization> discretization,
                                   std::vector<double> coefficients, const Report& report)
    : m_discretization(std::move(discretization)), m_coefficients(std::move(coefficients)), m_report(report)
  {}
#endif

  /// The coefficients of the shape functions of the nodes. They are not the values at the nodes, since shape
  /// functions of moving least squares do not interpolate. There is none if the callback stopped the solver.
  const std::vector<double>& coefficients() const { return m_coefficients; }

  /// what was done
  const Report& report() const { return m_report; }

  /// returns u_h at `p`. Nobody looks whether it lies in the domain: outside, it is what the nodes around tell, as far
  /// as they do: with the default of `deficient_support` places have a value, worth less the farther they lie outside,
  /// until all nodes look like one from there, at the distance of the domain's width with the quadratic basis.
  /// \throws std::logic_error if the callback stopped the solver
  /// \throws std::invalid_argument if a coordinate is not finite
  /// \throws Deficient_support_error_2 as `Moving_least_squares_2`
  double value(const Point_2& p) const
  {
    check();
    return m_discretization->mls.value(Bubble_relaxation_2::internal::rounded(p), m_coefficients);
  }

  /// returns the gradient of u_h at `p`; see `value()`, which throws the same.
  Vector_2 gradient(const Point_2& p) const
  {
    check();
    return m_discretization->mls.template gradient<Vector_2>(Bubble_relaxation_2::internal::rounded(p), m_coefficients);
  }

  /*!
  returns u_h at many points, and as many orders of derivatives as asked for: `Moving_least_squares_2::evaluate()` with
  the coefficients. This is faster than `value()`, most of all if points that follow each other are near to each other.

  \param points where; see `value()` for those outside
  \param number_of_derivatives 0, 1 or 2
  \param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `concurrency_tag`

  \throws std::logic_error if the callback stopped the solver
  \throws std::invalid_argument, Deficient_support_error_2 as `Moving_least_squares_2::evaluate()`
  */
  template <class NamedParameters = parameters::Default_named_parameters>
  Values evaluate(const std::vector<Point_2>& points, int number_of_derivatives = 0,
                  const NamedParameters& np = parameters::default_values()) const
  {
    check();
    CGAL_USE(np);
    using namespace Bubble_relaxation_2::internal;
    return m_discretization->mls.evaluate(rounded(points), m_coefficients, number_of_derivatives,
                                          threads_of<Concurrency<NamedParameters>>());
  }

  /*!
  returns the error against a function that is known, by Gauss's rule with two points more in each direction of
  each cell than the solver had, and five at least. Where u is singular the cells must be small for it.

  \param u the function
  \param gradient_of_u its gradient

  \tparam Function callable as `double(const Point_2&)`
  \tparam Gradient callable as `Vector_2(const Point_2&)`

  \throws std::logic_error if the callback stopped the solver
  */
  template <class Function, class Gradient>
  Element_free_Galerkin_error_2 error(const Function& u, const Gradient& gradient_of_u) const
  {
    check();
    using namespace Bubble_relaxation_2::internal;
    return error_of_solution(
      *m_discretization, m_coefficients, [&](const Point& p) { return u(Point_2(p.x(), p.y())); },
      [&](const Point& p) {
        const Vector_2 v = gradient_of_u(Point_2(p.x(), p.y()));
        return Direction{CGAL::to_double(v.x()), CGAL::to_double(v.y())};
      });
  }

private:
  void check() const
  {
    if (m_coefficients.empty())
      throw std::logic_error("Bubble_relaxation_2: there is no solution, since the callback stopped the solver");
  }

  std::shared_ptr<const Discretization> m_discretization;
  std::vector<double> m_coefficients;
  Report m_report;
};

} // namespace CGAL

#include <CGAL/Bubble_relaxation_2/internal/core/enable_warnings.h>

#endif // CGAL_ELEMENT_FREE_GALERKIN_SOLUTION_2_H
