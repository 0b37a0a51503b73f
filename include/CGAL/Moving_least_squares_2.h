// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_MOVING_LEAST_SQUARES_2_H
#define CGAL_MOVING_LEAST_SQUARES_2_H

#include <CGAL/license/Bubble_relaxation_2.h>

#include <CGAL/Bubble_relaxation_2/internal/core/disable_warnings.h>

#include <CGAL/Bubble_relaxation_2/internal/meshless/mls/Mls_evaluation_2.h>
#include <CGAL/Bubble_relaxation_parameters.h>
#include <CGAL/Deficient_support_error_2.h>
#include <CGAL/Influence_domain_2.h>

#include <CGAL/use.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgBubbleRelaxation2Meshless

Moving least squares: smooth functions of values at scattered nodes, without a mesh.

At a point x each polynomial of the basis is a candidate; the one that fits the values of the nodes around x
best, in the sum of squares with weights that fall with the distance, is taken, and its value at x is the value of the
approximation. It is a sum over nodes, of the values times <em>shape functions</em>, which do not depend on the
values. They sum up to 1, and polynomials of the basis are reproduced. They do not interpolate: the
approximation at a node is not the value that is given there.

The support of a node is the disc in which its weight is positive, its influence domain. Weights and shape functions
have two continuous derivatives as long as all points have enough nodes.

<b>Points with too few nodes,</b> or with nodes in unfavourable places such as along a line, are known by the
condition number of their moment matrix, whose monomials are centred at the point and in units of a third of the
largest support radius there: it exceeds `maximum_condition_number`. What happens then is up to the parameter
`deficient_support`: by default the radii of all supports are multiplied, for this point only, by 1.1 as often
as it takes. Then the basis is reproduced there as well, and derivatives are those of the larger supports; but
from such points to others the shape functions are not continuous.

Nodes are summed up in ascending order, so the bits of a result depend neither on how nodes are searched nor on
threads, nor on what was asked before. Lengths are in units of the support radius, so neither the unit of the
coordinates nor a far origin matters. This header needs Eigen.

\tparam Kernel_ a kernel of \cgal; coordinates are rounded to `double`

\sa `Influence_domain_2`
\sa `Deficient_support_error_2`
*/
template <class Kernel_>
class Moving_least_squares_2
{
public:
  using Kernel = Kernel_;
  using Point_2 = typename Kernel::Point_2;
  using Vector_2 = typename Kernel::Vector_2;
  using Influence = Influence_domain_2<Kernel>; ///< knows the nodes and their supports
  using Query = typename Influence::Query;      ///< searches nodes for one thread

#ifdef DOXYGEN_RUNNING
  /// The shape functions at a point. To use an object again saves the allocation of memory.
  struct Shape_functions
  {
    std::vector<std::int32_t> nodes; ///< the nodes in whose support the point lies, ascending
    /// of each of `nodes`: value, first and second derivatives; empty where they were not asked for
    std::vector<double> values, dx, dy, dxx, dxy, dyy;
    double enlargement = 1;      ///< what the support radii were multiplied by to suffice
    /// an upper bound; exact if above the limit
    double condition_number = 0;
  };

  /// An approximation at many points: an element a point in each array that was asked for.
  struct Values
  {
    std::vector<double> values, dx, dy, dxx, dxy, dyy;
    std::size_t number_of_enlarged_supports = 0; ///< at how many points supports had to be enlarged
    double largest_enlargement = 1;              ///< and the most that they had to be multiplied by
  };
#else
  using Shape_functions = Bubble_relaxation_2::internal::Mls_shapes_2;
  using Values = Bubble_relaxation_2::internal::Mls_values_2;
#endif

  /*!
  takes nodes with their supports from `influence`. It keeps a copy, which shares nodes and search structure with it
  and so costs next to nothing.

  \param influence the nodes; their radii are the support radii
  \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below

  \cgalNamedParamsBegin
    \cgalParamNBegin{mls_basis}
      \cgalParamDescription{the polynomials that are reproduced}
      \cgalParamType{`Moving_least_squares_basis`}
      \cgalParamDefault{`LINEAR`, as in the paper}
    \cgalParamNEnd
    \cgalParamNBegin{mls_weight}
      \cgalParamDescription{the weight of a node over the distance from it}
      \cgalParamType{`Moving_least_squares_weight`}
      \cgalParamDefault{`QUARTIC_SPLINE`, as in the paper}
    \cgalParamNEnd
    \cgalParamNBegin{deficient_support}
      \cgalParamDescription{what is done where the nodes do not suffice}
      \cgalParamType{`Deficient_support`}
      \cgalParamDefault{`ENLARGE`}
    \cgalParamNEnd
    \cgalParamNBegin{maximum_condition_number}
      \cgalParamDescription{the nodes do not suffice where the condition number of the moment matrix is larger}
      \cgalParamType{`double`, from 1 to 10<sup>14</sup>}
      \cgalParamDefault{10<sup>4</sup>; it is about 10 for the linear and 100 for the quadratic basis in packed bubbles}
    \cgalParamNEnd
  \cgalNamedParamsEnd

  \throws std::invalid_argument if a parameter is out of its range, or if there is no node
  */
  template <class NamedParameters = parameters::Default_named_parameters>
  explicit Moving_least_squares_2(Influence influence, const NamedParameters& np = parameters::default_values())
    : m_influence(std::move(influence)),
      m_approximation(m_influence.search(), Bubble_relaxation_2::internal::read_mls_options(np))
  {}

  /// the nodes and their supports
  const Influence& influence() const { return m_influence; }

  /*!
  computes the shape functions at `p` and as many orders of derivatives as asked for. Several threads may do so
  at once, each with a `result` of its own.

  \param p the point
  \param number_of_derivatives 0, 1 or 2
  \param result takes the shape functions

  \throws std::invalid_argument if a coordinate is not finite, or if `number_of_derivatives` is out of its range
  \throws Deficient_support_error_2 if the nodes do not suffice at `p`, with `Deficient_support::REPORT`; with
  `ENLARGE` if no enlargement helps: if all nodes lie along a curve of the basis' degree, or very far away
  */
  void operator()(const Point_2& p, int number_of_derivatives, Shape_functions& result) const
  {
    Query query(m_influence);
    (*this)(p, number_of_derivatives, query, result);
  }

  /// does the same with a search that is fastest if each point is near the last one; one object a thread.
  void operator()(const Point_2& p, int number_of_derivatives, Query& query, Shape_functions& result) const
  {
    m_approximation.find_shapes(Bubble_relaxation_2::internal::rounded(p), number_of_derivatives, query.query(),
                                result);
  }

  /*!
  \brief returns the approximation at `p`.
  \param p the point
  \param coefficients the values at the nodes, in their order: a `std::vector<double>` or what has as many elements,
  `size()` and `operator[]`
  \throws std::invalid_argument if the number of coefficients is not that of the nodes; and as above
  */
  template <class Coefficients>
  double value(const Point_2& p, const Coefficients& coefficients) const
  {
    return m_approximation.value(Bubble_relaxation_2::internal::rounded(p), coefficients);
  }

  /// returns the gradient of the approximation at `p`, with the arguments and exceptions of `value()`.
  template <class Coefficients>
  Vector_2 gradient(const Point_2& p, const Coefficients& coefficients) const
  {
    return m_approximation.template gradient<Vector_2>(Bubble_relaxation_2::internal::rounded(p), coefficients);
  }

  /*!
  returns the approximation at many points, and as many orders of derivatives as asked for. It is fastest if
  points that follow each other are near to each other.

  \param points the points
  \param coefficients as for `value()`
  \param number_of_derivatives 0, 1 or 2
  \param np an optional sequence of \ref bgl_namedparameters "Named Parameters"

  \cgalNamedParamsBegin
    \cgalParamNBegin{concurrency_tag}
      \cgalParamDescription{whether threads are used; the bits of the result do not depend on it}
      \cgalParamType{`Sequential_tag` or `Parallel_tag` (which needs TBB)}
      \cgalParamDefault{`Sequential_tag`}
    \cgalParamNEnd
  \cgalNamedParamsEnd

  \throws std::invalid_argument, Deficient_support_error_2 as above. The latter is about the first of the points
  where the nodes do not suffice, and tells how many there are, and what enlargement of all radii would do for all
  */
  template <class Coefficients, class NamedParameters = parameters::Default_named_parameters>
  Values evaluate(const std::vector<Point_2>& points, const Coefficients& coefficients,
                  int number_of_derivatives = 0,
                  const NamedParameters& np = parameters::default_values()) const
  {
    CGAL_USE(np);
    using namespace Bubble_relaxation_2::internal;
    std::vector<double> numbers(coefficients.size());
    for (std::size_t i = 0; i < numbers.size(); ++i)
      numbers[i] = coefficients[i];
    return m_approximation.evaluate(rounded(points), numbers, number_of_derivatives,
                                    threads_of<Concurrency<NamedParameters>>());
  }

private:
  Influence m_influence;
  Bubble_relaxation_2::internal::Mls_approximation_2 m_approximation;
};

} // namespace CGAL

#include <CGAL/Bubble_relaxation_2/internal/core/enable_warnings.h>

#endif // CGAL_MOVING_LEAST_SQUARES_2_H
