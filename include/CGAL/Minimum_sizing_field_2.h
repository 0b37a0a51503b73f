// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_MINIMUM_SIZING_FIELD_2_H
#define CGAL_MINIMUM_SIZING_FIELD_2_H

#include <CGAL/license/Bubble_relaxation_2.h>

#include <CGAL/Bubble_relaxation_2/internal/core/disable_warnings.h>

#include <CGAL/number_utils.h>

#include <tuple>
#include <type_traits>
#include <utility>

namespace CGAL {

/*!
\ingroup PkgBubbleRelaxation2Sizing

The smallest of several sizes: `Minimum_sizing_field_2 d(near_the_well, from_the_solution, 0.1)`.

A size that is not a number makes the result not a number, and a negative one makes it negative, so that
`npbs_relax()` complains as it would about the one field. A field may return infinity where it asks for
nothing, as long as another one does not.

\cgalModels{BubbleSizingField_2}

\tparam Fields models of `BubbleSizingField_2`, or types of numbers; at least one. They are copied.
*/
template <class... Fields>
class Minimum_sizing_field_2
{
  static_assert(sizeof...(Fields) > 0, "the minimum of no sizes is no size");

public:
  using FT = double; ///< the number type of sizes

  /// \param fields functions of a point, or numbers
  explicit Minimum_sizing_field_2(Fields... fields) : m_fields(std::move(fields)...) {}

  /// returns the smallest of all sizes at `p`.
  template <class Point_2>
  FT operator()(const Point_2& p) const
  {
    return std::apply(
      [&p](const auto& first, const auto&... others) {
        double least = value(first, p);
        ((least = smaller(least, value(others, p))), ...);
        return least;
      },
      m_fields);
  }

private:
  template <class Field, class Point_2>
  static double value(const Field& field, [[maybe_unused]] const Point_2& p)
  {
    if constexpr (std::is_invocable<const Field&, const Point_2&>::value)
      return CGAL::to_double(field(p));
    else
      return CGAL::to_double(field);
  }

  /// what is not a number wins
  static double smaller(double a, double b) { return b < a || b != b ? b : a; }

  std::tuple<Fields...> m_fields;
};

} // namespace CGAL

#include <CGAL/Bubble_relaxation_2/internal/core/enable_warnings.h>

#endif // CGAL_MINIMUM_SIZING_FIELD_2_H
