// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_FIELDS_CHECKED_SIZING_FIELD_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_FIELDS_CHECKED_SIZING_FIELD_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/Progress.h>
#include <CGAL/Bubble_relaxation_2/internal/core/in_words.h>
#include <CGAL/Bubble_relaxation_2/internal/core/magnitudes.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Flat_triangulation_2.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/number_utils.h>

#include <stdexcept>
#include <type_traits>
#include <utility>

namespace CGAL::Bubble_relaxation_2::internal {

[[noreturn]] inline void throw_invalid_size(double x, double y, double d)
{
  throw std::invalid_argument("Bubble_relaxation_2: parameter sizing_function: d" + in_words(x, y) + " = " +
                              in_words(d) + " must be " + required_of_length(d));
}

/// The user's d(x, y) as the simulation calls it: in doubles, and with a clear exception where the
/// value is no length. Instead of a function the user may give a number, of any type that becomes one of
/// the kernel's. `Held`: a function object that is kept, or a reference to one that stays where it is
template <class User_point, class Held>
class Checked_sizing_field_2
{
  using Sizing_function = std::remove_reference_t<Held>;
  using Kernel_number = typename Kernel_traits<User_point>::Kernel::FT;
  static constexpr bool is_function =
    std::is_invocable<const Sizing_function&, const User_point&>::value;
  static_assert(is_function || std::is_convertible<const Sizing_function&, Kernel_number>::value,
                "sizing_function must be callable, as a constant, with a point, or be a number");

public:
  explicit Checked_sizing_field_2(Held&& f) : m_f(std::forward<Held>(f))
  {
    if constexpr (!is_function) // once: lazy numbers are not for several threads
      m_number = CGAL::to_double(static_cast<Kernel_number>(std::as_const(m_f)));
  }

  double operator()(double x, double y) const
  {
    const double d = value(x, y);
    if (!is_within_magnitudes(d))
      throw_invalid_size(x, y, d);
    return d;
  }

private:
  double value([[maybe_unused]] double x, [[maybe_unused]] double y) const
  {
    if constexpr (is_function) {
      tick(); // it may take long
      return CGAL::to_double(std::as_const(m_f)(User_point(x, y)));
    } else {
      return m_number;
    }
  }

  Held m_f;
  double m_number = 0; // if the user gave one
};

/// `f`: a function object, a function, or a number; it is kept if it is a temporary, else it stays where it is
template <class User_point, class Sizing_function>
Checked_sizing_field_2<User_point, Sizing_function> checked_sizing_field(Sizing_function&& f)
{
  return Checked_sizing_field_2<User_point, Sizing_function>(std::forward<Sizing_function>(f));
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_FIELDS_CHECKED_SIZING_FIELD_2_H
