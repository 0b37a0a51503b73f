// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_DEFICIENT_SUPPORT_ERROR_2_H
#define CGAL_DEFICIENT_SUPPORT_ERROR_2_H

#include <CGAL/license/Bubble_relaxation_2.h>

#include <CGAL/Bubble_relaxation_2/internal/core/disable_warnings.h>

#include <CGAL/Bubble_relaxation_2/internal/core/in_words.h>

#include <cstddef>
#include <stdexcept>
#include <string>

namespace CGAL {

/*!
\ingroup PkgBubbleRelaxation2Meshless

is thrown where moving least squares have too few nodes, or nodes too badly placed, to be told from garbage.

\sa `Moving_least_squares_2`
*/
class Deficient_support_error_2 : public std::runtime_error
{
public:
  double x, y;                   ///< the point
  std::size_t number_of_nodes;   ///< in whose support it lies
  double condition_number;       ///< of the moment matrix there; infinity if it is singular
  std::size_t number_of_points;  ///< how many of the points that were asked for are so; this is the first
  /// If all radii are multiplied by it the nodes suffice at all points that were asked for, this one and the others:
  /// a power of 1.1, and 0 if at some of them none would do.
  double sufficient_enlargement;

  Deficient_support_error_2(double at_x, double at_y, std::size_t nodes, double condition, double maximum_condition,
                            double enlargement, std::size_t points = 1)
    : std::runtime_error(message(at_x, at_y, nodes, condition, maximum_condition, enlargement, points)), x(at_x),
      y(at_y), number_of_nodes(nodes), condition_number(condition), number_of_points(points),
      sufficient_enlargement(enlargement)
  {}

private:
  static std::string message(double at_x, double at_y, std::size_t nodes, double condition, double maximum_condition,
                             double enlargement, std::size_t points)
  {
    using Bubble_relaxation_2::internal::in_words;
    std::string text = "Bubble_relaxation_2: moving least squares at " + in_words(at_x, at_y) + ": the point lies in "
                       "the supports of " + std::to_string(nodes) + " nodes, whose moment matrix has "
                       "the condition number " + in_words(condition) + ", more than "
                       "maximum_condition_number = " + in_words(maximum_condition) + "; ";
    if (enlargement > 0)
      text += "support radii " + in_words(enlargement) + " times as large would do";
    else
      text += "larger support radii would not help";
    if (points > 1)
      text += (enlargement > 0 ? " for all" : " all") + (" of " + std::to_string(points) + " such points");
    if (!(enlargement > 0))
      text += ": all nodes lie along a curve, or far away";
    return text;
  }
};

} // namespace CGAL

#include <CGAL/Bubble_relaxation_2/internal/core/enable_warnings.h>

#endif // CGAL_DEFICIENT_SUPPORT_ERROR_2_H
