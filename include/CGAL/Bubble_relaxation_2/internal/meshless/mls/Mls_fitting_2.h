// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_MLS_MLS_FITTING_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_MLS_MLS_FITTING_2_H

#include <CGAL/Bubble_relaxation_2/internal/meshless/mls/Local_fit_2.h>

#include <CGAL/Deficient_support_error_2.h>
#include <CGAL/number_utils.h>

#include <cstddef>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// Fits at one point after the other, for one thread: searches nodes, and does what is to be done where they do not
/// suffice. `Shapes` are a point's shape functions, of which the nodes, the enlargement and the condition number are
/// set here; the others are up to `Local_fit_2::write()`.
template <class Influence, class Shapes>
class Mls_fitting_2
{
public:
  using Point_2 = typename Influence::Point_2;
  using Query = typename Influence::Query;

  Mls_fitting_2(const Influence& influence, const Mls_options& options, Query& query, Local_fit_2& fit, Shapes& shapes)
    : m_influence(influence), m_options(options), m_query(query), m_fit(fit), m_shapes(shapes)
  {}

  /// returns whether there are shape functions at `p`, after all that may be done for it
  bool fit(const Point_2& p, int number_of_derivatives)
  {
    if (suffices(p, number_of_derivatives, 1))
      return true;
    switch (m_options.deficient_support) {
    case Deficient_support::ENLARGE:
      return enlarge(p, number_of_derivatives);
    case Deficient_support::PSEUDO_INVERSE:
      return true;
    default:
      return false;
    }
  }

  /// what supports times `enlargement` have to be multiplied by further, 1.1 again and again, until the nodes at
  /// `p` suffice; 0 if that does not help
  double sufficient_enlargement(const Point_2& p, double enlargement)
  {
    return suffices(p, 0, enlargement) || enlarge(p, 0) ? m_shapes.enlargement : 0;
  }

  /// that the nodes do not suffice at `p`, the first of so many points, for all of which `enlargement` would do
  Deficient_support_error_2 error(const Point_2& p, double enlargement, std::size_t number_of_points)
  {
    suffices(p, 0, 1);
    return Deficient_support_error_2(CGAL::to_double(p.x()), CGAL::to_double(p.y()), m_shapes.nodes.size(),
                                     m_shapes.condition_number, m_options.maximum_condition_number, enlargement,
                                     number_of_points);
  }

private:
  /// returns whether the nodes at `p` do, with supports that are so much larger
  bool suffices(const Point_2& p, int number_of_derivatives, double enlargement)
  {
    m_shapes.enlargement = enlargement;
    m_query(p, enlargement, m_shapes.nodes);
    m_fit.gather(m_influence, p, m_shapes.nodes, enlargement);
    const bool result = m_fit.solve(m_options, number_of_derivatives);
    m_shapes.condition_number = m_fit.condition_number();
    return result;
  }

  /// Enlarges the supports until the nodes suffice. Once they have all nodes, twice as far from their rims than
  /// when they had just got them, there is nothing to gain: weights hardly differ, and only lengths in units
  /// of the radii go on to shrink. From 1e15 radii away nodes cannot be told from each other.
  bool enlarge(const Point_2& p, int number_of_derivatives)
  {
    int steps_with_all_nodes = 0;
    while (steps_with_all_nodes < 8 && m_shapes.enlargement < 1e15) {
      if (suffices(p, number_of_derivatives, 1.1 * m_shapes.enlargement))
        return true;
      if (m_shapes.nodes.size() == m_influence.size())
        ++steps_with_all_nodes;
    }
    return false;
  }

  const Influence& m_influence;
  const Mls_options& m_options;
  Query& m_query;
  Local_fit_2& m_fit;
  Shapes& m_shapes;
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_MLS_MLS_FITTING_2_H
