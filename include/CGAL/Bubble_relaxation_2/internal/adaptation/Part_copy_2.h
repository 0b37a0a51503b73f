// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_ADAPTATION_PART_COPY_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_ADAPTATION_PART_COPY_2_H

#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_marks_2.h>

#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// Some faces of a user's triangulation in arrays, all in the domain. Their rim, behind which the domain goes on, stays
/// as it is.
template <class Cdt>
class Part_copy_2 : public Marked_copy_2
{
public:
  /// \throws std::invalid_argument as `check_coordinates()` and `check_domain()` do
  template <class Is_inside>
  Part_copy_2(const Cdt& cdt, const std::vector<typename Cdt::Face_handle>& part, const Is_inside& is_in_domain)
    : Marked_copy_2(cdt, part,
                    [&](typename Cdt::Face_handle f, int i) { return is_in_domain(f->neighbor(i)); })
  {
    check_domain();
  }
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_ADAPTATION_PART_COPY_2_H
