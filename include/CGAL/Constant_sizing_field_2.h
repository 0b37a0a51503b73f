// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_CONSTANT_SIZING_FIELD_2_H
#define CGAL_CONSTANT_SIZING_FIELD_2_H

#include <CGAL/license/Bubble_relaxation_2.h>

#include <CGAL/Bubble_relaxation_2/internal/core/disable_warnings.h>

#include <CGAL/Bubble_relaxation_2/internal/core/Relaxation_options.h>

namespace CGAL {

/*!
\ingroup PkgBubbleRelaxation2Sizing

The same size everywhere, for code that needs a function of the place; `npbs_relax()` takes the number as well.
(`Uniform_sizing_field_2` is a class of \cgal's 2D Meshes.)

\cgalModels{BubbleSizingField_2}
*/
class Constant_sizing_field_2
{
public:
  using FT = double; ///< the number type of sizes

  /// \throws std::invalid_argument if `size` is not positive and finite
  explicit Constant_sizing_field_2(double size) : m_size(size)
  {
    Bubble_relaxation_2::internal::check_positive("size", size);
  }

  /// returns the size.
  template <class Point_2>
  FT operator()(const Point_2&) const { return m_size; }

private:
  double m_size;
};

} // namespace CGAL

#include <CGAL/Bubble_relaxation_2/internal/core/enable_warnings.h>

#endif // CGAL_CONSTANT_SIZING_FIELD_2_H
