// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_TRANSFER_TRANSFER_PROBLEM_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_TRANSFER_TRANSFER_PROBLEM_2_H

#include <CGAL/Bubble_relaxation_2/internal/transfer/Face_set_2.h>

#include <CGAL/Transfer_report_2.h>

#include <algorithm>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// Two meshes, and values of the source, at its points or in its triangles.
struct Transfer_problem_2
{
  Face_set_2 source, target;
  std::vector<double> values;
  std::vector<char> is_fixed; ///< points of the target whose values are interpolated ones; none if it is empty
  bool keeps_integral = false;
};

/// Values of the target, and what the user is told.
struct Transferred_values_2
{
  std::vector<double> values;
  Transfer_report_2 report;
};

/// Scales a problem and, in the end, its solution back: nothing in between depends on units. Values that are only
/// interpolated are not scaled, since much smaller ones than the largest would lose bits.
class Transfer_scale_2
{
public:
  Transfer_scale_2(Transfer_problem_2& problem, bool scales_values)
    : m_length(scale_to_unit(problem.source, problem.target)),
      m_value(scales_values ? scale_to_unit(problem.values) : 1)
  {}

  void undo(Transferred_values_2& transferred) const
  {
    Transfer_report_2& r = transferred.report;
    for (double* area : {&r.source_area, &r.target_area, &r.overlap_area, &r.uncovered_area})
      *area = *area / m_length / m_length;
    for (double* integral : {&r.source_integral, &r.overlap_integral, &r.target_integral})
      *integral = *integral / m_length / m_length / m_value;
    for (double& v : transferred.values)
      v /= m_value;
  }

private:
  double m_length, m_value;
};

/// the least and the largest value that something may have
struct Bounds
{
  double least, largest;

  void include(double value)
  {
    least = (std::min)(least, value);
    largest = (std::max)(largest, value);
  }

  void include(const Bounds& other)
  {
    include(other.least);
    include(other.largest);
  }

  double clamp(double value) const { return (std::min)(largest, (std::max)(least, value)); }
};

/// how much of a wanted change, of the same sign as the room for it, can be had
inline double share_in_room(double room, double wanted)
{
  return wanted == 0 ? 1 : (std::max)(0., (std::min)(1., room / wanted));
}

/// Adds `deficit` to the integral, within the bounds: each value gets the same share of the way to its bound, where
/// `weights` are positive. What exceeds all bounds stays out.
inline void spread_within_bounds(double deficit, const std::vector<double>& weights, const std::vector<Bounds>& bounds,
                                 std::vector<double>& values)
{
  const auto end = [&](std::size_t i) { return deficit > 0 ? bounds[i].largest : bounds[i].least; };
  double room = 0;
  for (std::size_t i = 0; i < values.size(); ++i)
    room += weights[i] * (end(i) - values[i]);
  if (deficit == 0 || !(room / deficit > 0))
    return;
  const double share = (std::min)(1., deficit / room);
  for (std::size_t i = 0; i < values.size(); ++i)
    if (weights[i] > 0)
      values[i] = bounds[i].clamp(values[i] + share * (end(i) - values[i]));
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_TRANSFER_TRANSFER_PROBLEM_2_H
