// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_ADAPTATION_SIZES_OF_OUTLINE_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_ADAPTATION_SIZES_OF_OUTLINE_2_H

#include <CGAL/Bubble_relaxation_2/internal/adaptation/Misfit_search_2.h>
#include <CGAL/Bubble_relaxation_2/internal/adaptation/Part_reading_2.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Relaxation_options.h>
#include <CGAL/Bubble_relaxation_2/internal/corners/Cut_domain_2.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_marks_2.h>
#include <CGAL/Bubble_relaxation_2/internal/engine/engine.h>

#include <algorithm>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// The sizes that a relaxation of the whole domain would follow, found from its outline alone.
template <class Cdt>
class Sizes_of_outline_2
{
  using Face_handle = typename Cdt::Face_handle;

public:
  template <class Is_inside, class NamedParameters>
  Sizes_of_outline_2(const Cdt& cdt, const Is_inside& is_in_domain, const NamedParameters& np, const Sizes_2& wanted,
                    const Relaxation_options& options)
    : m_reading(cdt, copy_at_outline(cdt, is_in_domain), np), m_wanted(wanted)
  {
    add_pins(cdt, is_in_domain, is_pinned<Cdt>(np));
    m_limits = limit_by_outline(m_reading.domain, m_reading.given, m_wanted, options, options.limit_by_outline);
    for (const Sharp_corner_2& c : sharp_corners(m_reading.domain, options.size_growth)) {
      const Point& p = m_reading.domain.corners()[c.corner];
      m_forced.push_back(Forced_place_2{p, m_wanted(p)});
    }
  }

  const Sizes_2& sizes() const { return m_limits.sizes; }

  /// The same without those beyond circles around sharp corners: a part that has such a corner cuts it off by them.
  const Sizes_2& sizes_of_parts() const { return m_limits.before_cut; }

  /// around corners in which two edges of the domain meet in less than 45 degrees
  const std::vector<Forced_place_2>& forced_places() const { return m_forced; }

private:
  /// A copy of the faces of the domain that have a constraint at a side: they know all of its outline.
  /// \throws std::invalid_argument if an edge of them is shorter than the least length
  template <class Is_inside>
  static Marked_copy_2 copy_at_outline(const Cdt& cdt, const Is_inside& is_in_domain)
  {
    std::vector<Face_handle> faces;
    for (auto f = cdt.finite_faces_begin(); f != cdt.finite_faces_end(); ++f)
      if (is_in_domain(f) && (f->is_constrained(0) || f->is_constrained(1) || f->is_constrained(2)))
        faces.push_back(f);
    Marked_copy_2 result(cdt, faces, [](Face_handle, int) { return false; });
    result.check_lengths();
    return result;
  }

  template <class Is_inside, class Is_pinned>
  void add_pins(const Cdt& cdt, const Is_inside& is_in_domain, const Is_pinned& is_pinned)
  {
    std::vector<Point>& pins = m_reading.given.pinned;
    pins.clear();
    for (auto v = cdt.finite_vertices_begin(); v != cdt.finite_vertices_end(); ++v)
      if (is_pinned(v) && !cdt.are_there_incident_constraints(v) && is_in_domain(v->face()))
        pins.push_back(point_in_double<Cdt>(v->point()));
    std::sort(pins.begin(), pins.end());
  }

  Part_reading_2<Cdt> m_reading;
  Sizes_2 m_wanted;
  Limits_of_outline_2 m_limits{m_wanted, nullptr, nullptr, m_wanted};
  std::vector<Forced_place_2> m_forced;
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_ADAPTATION_SIZES_OF_OUTLINE_2_H
