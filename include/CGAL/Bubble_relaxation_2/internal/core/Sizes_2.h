// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_CORE_SIZES_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_CORE_SIZES_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/vocabulary.h>

#include <algorithm>
#include <memory>
#include <utility>

namespace CGAL::Bubble_relaxation_2::internal {

/// The wanted distance d(x, y) as the stages see it: a value that is copied like a pointer. The type of what stands
/// behind it, the user's function or a field of this package, is forgotten once, at the door; d is asked so rarely that
/// the call through a pointer does not show.
class Sizes_2
{
public:
  /// `field(x, y)`: the size there; it may refer to what outlives this
  template <class Field>
  explicit Sizes_2(Field field)
    : Sizes_2(
        new Field(std::move(field)), [](const void* f) { delete static_cast<const Field*>(f); },
        [](const void* f, double x, double y) -> double { return (*static_cast<const Field*>(f))(x, y); })
  {}

  double operator()(double x, double y) const { return m_call(m_field.get(), x, y); }
  double operator()(const Point& p) const { return (*this)(p.x(), p.y()); }

  /// how many bubbles these sizes ask for in the domain, when it was counted
  double expected_number = 0;

  /// how many vertices a mesh with these sizes would have if all edges could be as long as d, corners or not; counted
  /// at the same time
  double number_without_corners = 0;

private:
  using Destroy = void (*)(const void*);
  using Call = double (*)(const void*, double, double);

  // the pointer's own classes are the same for all fields: they are compiled once
  Sizes_2(const void* field, Destroy destroy, Call call) : m_field(field, destroy), m_call(call) {}

  std::shared_ptr<const void> m_field;
  Call m_call;
};

/// the smaller of two in each place
inline Sizes_2 smaller_of(const Sizes_2& a, const Sizes_2& b)
{
  return Sizes_2([a, b](double x, double y) { return (std::min)(a(x, y), b(x, y)); });
}

/// `factor` times other sizes
inline Sizes_2 scaled(const Sizes_2& sizes, double factor)
{
  Sizes_2 result([sizes, factor](double x, double y) { return factor * sizes(x, y); });
  result.expected_number = sizes.expected_number / (factor * factor);
  return result;
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_CORE_SIZES_2_H
