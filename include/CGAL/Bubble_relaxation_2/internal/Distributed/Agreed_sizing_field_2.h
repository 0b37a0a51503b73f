// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_AGREED_SIZING_FIELD_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_AGREED_SIZING_FIELD_2_H

#include <CGAL/Bubble_relaxation_2/internal/Distributed/Agreement.h>
#include <CGAL/Bubble_relaxation_2/internal/Flat_triangulation_2.h>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// The user's d on one of several ranks. What it throws is kept until all ranks can throw it; until then d is
/// large, so that little is done in vain.
template <class Sizing>
class Agreed_sizing_field_2
{
public:
  Agreed_sizing_field_2(const Sizing& sizing, Agreement& agreement, double large)
    : expected_number(sizing.expected_number), m_sizing(sizing), m_agreement(agreement), m_large(large)
  {}

  double operator()(double x, double y) const
  {
    double d = m_large;
    if (!m_agreement.has_failed())
      m_agreement.keep([&] { d = m_sizing(x, y); });
    return d;
  }

  double operator()(const Point& p) const { return (*this)(p.x(), p.y()); }

  const double expected_number; ///< of bubbles

private:
  const Sizing& m_sizing;
  Agreement& m_agreement;
  double m_large;
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_AGREED_SIZING_FIELD_2_H
