// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_ELEMENT_FREE_GALERKIN_2_H
#define CGAL_ELEMENT_FREE_GALERKIN_2_H

#include <CGAL/license/Bubble_relaxation_2.h>

#include <CGAL/Bubble_relaxation_2/internal/core/disable_warnings.h>

#include <CGAL/Bubble_relaxation_2/internal/core/check_call.h>
#include <CGAL/Bubble_relaxation_2/internal/meshless/galerkin/Galerkin_method_2.h>
#include <CGAL/Bubble_relaxation_enums.h>
#include <CGAL/Bubble_relaxation_parameters.h>
#include <CGAL/Element_free_Galerkin_report_2.h>
#include <CGAL/Element_free_Galerkin_solution_2.h>
#include <CGAL/Influence_domain_2.h>
#include <CGAL/Moving_least_squares_2.h>
#include <CGAL/Poisson_problem_2.h>
#include <CGAL/node_set_2.h>

#include <memory>
#include <utility>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgBubbleRelaxation2Meshless

\brief solves Poisson problems on nodes without a mesh between them, by the element-free Galerkin method
(Belytschko, Lu and Gu, Int. J. Numer. Meth. Engng. 37, 1994; section 3.1 of the paper).

The solution u_h is a sum of the shape functions of moving least squares, one a node, and satisfies the weak form of
the problem against the same functions. Integrals are sums over Gauss points in background cells, which fill the
domain, and on its boundary. Outlines may be of any shape, with holes; what they bound is read as `npbs_relax()` does.
A constraint with the domain on both sides is no boundary. The support of a node is a disc, which a notch or a hole
narrower than it does not cut.

- <b>Integration.</b> Shape functions are no polynomials, and Gauss's rules leave an error that does not fall with the
  distance of nodes: with two points in each direction errors in the H1 norm stay where they are. By
  `consistent_integration` the gradients of test functions are corrected by as little as makes the rule exact for
  solutions that are polynomials of the basis; three points do then. The matrix is not quite symmetric any more.
- <b>Boundary values.</b> Shape functions do not interpolate, so given values are imposed weakly, see
  `Dirichlet_condition`. With `NITSCHE` and `LAGRANGE_MULTIPLIERS`, and with consistent integration, solutions that
  are polynomials of the basis (with multipliers: linear ones) are found exactly up to rounding. `PENALTY` has an error
  of its own, du/dn over the factor; and factors that are too large lock the solution on the boundary.
- <b>Equations</b> are summed up in a fixed order, so that the bits of the solution do not depend on the number of
  threads. Up to 5000 unknowns they are solved by a factorization, above by an iteration; with multipliers, and
  without any given values, always by a factorization, which takes an order longer.

What is read is copied: triangulation and nodes may change or go away. This header needs Eigen, 3.3 or later.

\tparam CDT a `Constrained_Delaunay_triangulation_2`, or a `Constrained_triangulation_plus_2` of one, as in
`npbs_relax()`

\sa `Poisson_problem_2`
\sa `Moving_least_squares_2`
\sa `node_set_2()`
\sa `npbs_place_nodes()`
*/
template <class CDT>
class Element_free_Galerkin_2
{
  using Vector_2 = typename CDT::Geom_traits::Vector_2;
  using Discretization = Bubble_relaxation_2::internal::Galerkin_discretization_2;

public:
  using Kernel = typename CDT::Geom_traits;
  using Point_2 = typename Kernel::Point_2;
  using Nodes = Node_set_2<Point_2>;        ///< the nodes
  using Problem = Poisson_problem_2<Kernel>; ///< what is to be solved
  using Solution = Element_free_Galerkin_solution_2<Kernel>; ///< what comes out

  /*!
  reads the domain and the nodes, and makes the cells of integration.

  \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

  \param cdt the triangulation that bounds the domain; a mesh of it or not
  \param nodes points and sizes, that is distances from neighbours; neighbour sets only matter to `influence_search`
  \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below, those of
  `Moving_least_squares_2` and of `Influence_domain_2`, and `seeds` and `seeds_are_in_domain` as in `npbs_relax()`

  \cgalNamedParamsBegin
    \cgalParamNBegin{support_factor}
      \cgalParamDescription{the radius of a node's support in units of its size}
      \cgalParamType{`double`, positive}
      \cgalParamDefault{2.5}
    \cgalParamNEnd
    \cgalParamNBegin{support_radius}
      \cgalParamDescription{the radius of all supports in units of the coordinates, instead of `support_factor`}
      \cgalParamType{`double`, positive}
      \cgalParamDefault{none; the paper: 0.15}
    \cgalParamNEnd
    \cgalParamNBegin{integration_cells}
      \cgalParamDescription{over which cells integrals are summed. `TRIANGLES`: those of `cdt`, halved while a side is
                            longer than 1.75 times the size of the nearest node. `GRID`: rectangles, those on the
                            boundary in the parts of which the domain consists there; the boundary is cut where
                            the lines of the grid cross it}
      \cgalParamType{`Integration_cells`}
      \cgalParamDefault{`TRIANGLES`; the paper: `GRID`}
    \cgalParamNEnd
    \cgalParamNBegin{grid_cells}
      \cgalParamDescription{the number of cells of `GRID` along x and y: two integers, or one for both}
      \cgalParamType{integers from 1 to 10<sup>5</sup>}
      \cgalParamDefault{such that cells are as wide as the nodes' size in the harmonic mean; the paper: 12}
    \cgalParamNEnd
    \cgalParamNBegin{number_of_gauss_points}
      \cgalParamDescription{points in each direction of a cell, and on each piece of the boundary}
      \cgalParamType{an integer from 1 to 64}
      \cgalParamDefault{3, with the quadratic basis 5; the paper: 2}
    \cgalParamNEnd
    \cgalParamNBegin{consistent_integration}
      \cgalParamDescription{whether gradients of test functions are corrected so that the basis is integrated exactly}
      \cgalParamType{`bool`}
      \cgalParamDefault{`true`; the paper: `false`}
    \cgalParamNEnd
    \cgalParamNBegin{dirichlet_condition}
      \cgalParamDescription{how given values on the boundary are imposed}
      \cgalParamType{`Dirichlet_condition`}
      \cgalParamDefault{`NITSCHE`; the paper: `PENALTY`}
    \cgalParamNEnd
    \cgalParamNBegin{nitsche_factor}
      \cgalParamDescription{the factor of Nitsche's penalty times the size of the nodes; the equations are not definite
                            if it is too small, and errors may be large without any other sign. 10 suffices for
                            bubbles, but not for nodes that lie very close to others on the boundary}
      \cgalParamType{`double`, positive}
      \cgalParamDefault{30}
    \cgalParamNEnd
    \cgalParamNBegin{penalty_factor}
      \cgalParamDescription{the factor of `PENALTY`, in units of one over length}
      \cgalParamType{`double`, positive}
      \cgalParamDefault{80 L/d<sup>2</sup>, where L is the root of the area and d the size of the nodes: about
                        10<sup>4</sup> for 12 x 12 nodes in the unit square. The paper does not tell its own}
    \cgalParamNEnd
    \cgalParamNBegin{residual_tolerance}
      \cgalParamDescription{the largest |b - A x| / (|A| |x| + |b|), in the maximum norm, of the equations' solution}
      \cgalParamType{`double`, positive}
      \cgalParamDefault{10<sup>-12</sup>}
    \cgalParamNEnd
    \cgalParamNBegin{callback}
      \cgalParamDescription{is called with the progress of `solve()`, between 0 and 1; when it returns `false` the
                            solver stops, and the solution is empty. It is not asked while the equations are solved,
                            between 0.7 and 1}
      \cgalParamType{an object that converts to `std::function<bool(double)>`}
      \cgalParamDefault{none}
    \cgalParamNEnd
    \cgalParamNBegin{concurrency_tag}
      \cgalParamDescription{whether integrals are summed by several threads; these call the functions of the problem}
      \cgalParamType{`Sequential_tag` or `Parallel_tag` (which needs TBB)}
      \cgalParamDefault{`Sequential_tag`}
    \cgalParamNEnd
  \cgalNamedParamsEnd

  \throws std::invalid_argument if a parameter is out of its range, if there is no node, if a size is not positive
  and finite, if a coordinate is not finite, if two nodes are in one place and have the same support, or if there is no
  domain with constraints all around it
  \throws std::length_error if the sizes of the nodes or `grid_cells` ask for more than about a thousand cells of
  integration a node
  */
  template <class NamedParameters = parameters::Default_named_parameters>
  Element_free_Galerkin_2(const CDT& cdt, const Nodes& nodes,
                          const NamedParameters& np = parameters::default_values())
  {
    using namespace Bubble_relaxation_2::internal;
    check_flat<CDT>();
    const Galerkin_options options = read_galerkin_options(np);
    Galerkin_nodes_2 rounded_nodes(rounded(nodes.points), nodes.sizes, options);
    Integration_domain_2 domain(Domain_marks_2<CDT>(cdt, np));
    const Influence_domain_2<Kernel> influence(nodes, rounded_nodes.radius, np);
    m_discretization = std::make_shared<const Discretization>(
      options, std::move(rounded_nodes), std::move(domain), influence.search(), read_mls_options(np),
      threads_of<Concurrency<NamedParameters>>());
  }

  /*!
  solves a problem. Exceptions of its functions and of the callback pass through.

  \throws std::invalid_argument if a function of the problem has a value that is not finite, naming both; if the
  domain has several parts that do not touch along edges, and one of them has no Dirichlet boundary; or if the
  problem has no Dirichlet boundary and the integrals of `source` and `neumann` do not add up to 0 within a
  thousandth of the integrals of their absolute values
  \throws std::runtime_error if a support has no Gauss point, if the equations are singular, or if
  `residual_tolerance` is not reached
  \throws Deficient_support_error_2 as `Moving_least_squares_2::evaluate()` for all points of integration
  */
  Solution solve(const Problem& problem) const
  {
    using namespace Bubble_relaxation_2::internal;
    Galerkin_problem rounded;
    if (problem.source)
      rounded.source = [&](const Point& p) { return problem.source(Point_2(p.x(), p.y())); };
    if (problem.dirichlet)
      rounded.dirichlet = [&](const Point& p) { return problem.dirichlet(Point_2(p.x(), p.y())); };
    if (problem.neumann)
      rounded.neumann = [&](const Point& p, const Direction& n) {
        return problem.neumann(Point_2(p.x(), p.y()), Vector_2(n.x, n.y));
      };
    if (problem.is_dirichlet)
      rounded.is_dirichlet = [&](const Point& p) { return problem.is_dirichlet(Point_2(p.x(), p.y())); };
    Element_free_Galerkin_report_2 report;
    std::vector<double> coefficients = solve_galerkin(*m_discretization, rounded, report);
    return Solution(m_discretization, std::move(coefficients), report);
  }

private:
  std::shared_ptr<const Discretization> m_discretization;
};

} // namespace CGAL

#include <CGAL/Bubble_relaxation_2/internal/core/enable_warnings.h>

#endif // CGAL_ELEMENT_FREE_GALERKIN_2_H
