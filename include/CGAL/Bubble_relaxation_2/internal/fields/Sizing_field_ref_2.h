// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_FIELDS_SIZING_FIELD_REF_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_FIELDS_SIZING_FIELD_REF_2_H

#include <CGAL/Bubble_relaxation_2/internal/geometry/Flat_triangulation_2.h>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// A sizing field of any type, which must outlive this. The simulation is compiled once for it instead of
/// for each user's function; d is asked so rarely that the call through a pointer does not show.
class Sizing_field_ref_2
{
public:
  template <class Field>
  explicit Sizing_field_ref_2(const Field& field)
    : m_field(&field), m_call([](const void* f, double x, double y) -> double {
        return (*static_cast<const Field*>(f))(x, y);
      })
  {}

  double operator()(double x, double y) const { return m_call(m_field, x, y); }
  double operator()(const Point& p) const { return (*this)(p.x(), p.y()); }

private:
  const void* m_field;
  double (*m_call)(const void*, double, double);
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_FIELDS_SIZING_FIELD_REF_2_H
