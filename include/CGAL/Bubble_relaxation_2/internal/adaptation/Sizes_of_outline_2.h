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
#include <CGAL/Bubble_relaxation_2/internal/adaptation/Part_growth_2.h>
#include <CGAL/Bubble_relaxation_2/internal/adaptation/Part_reading_2.h>
#include <CGAL/Bubble_relaxation_2/internal/adaptation/rim_sizes.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Relaxation_options.h>
#include <CGAL/Bubble_relaxation_2/internal/corners/Cut_domain_2.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_marks_2.h>
#include <CGAL/Bubble_relaxation_2/internal/engine/engine.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Bubble_buckets_2.h>
#include <CGAL/Bubble_relaxation_2/internal/sizes/Outline_sizes_2.h>

#include <algorithm>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// The sizes that a relaxation of the whole domain would follow, found from its outline alone.
template <class Cdt, class Is_inside>
class Sizes_of_outline_2
{
  using Face_handle = typename Cdt::Face_handle;
  using Vertex_handle = typename Cdt::Vertex_handle;

public:
  /// `where`: the faces that are read; all if null. Where the domain goes on beyond them, what was read of it has a rim,
  /// which asks for no sizes.
  template <class NamedParameters>
  Sizes_of_outline_2(const Cdt& cdt, const Is_inside& is_in_domain, const NamedParameters& np, const Sizes_2& wanted,
                    Relaxation_options options, const Part_growth_2<Cdt, Is_inside>* where)
    : m_cdt(cdt), m_is_in_domain(is_in_domain), m_where(where), m_reading(cdt, copy_at_outline(), np), m_wanted(wanted),
      m_forced(1, extent(m_reading.domain), m_reading.domain.bbox().xmin(), m_reading.domain.bbox().ymin(), 0)
  {
    add_pins(is_pinned<Cdt>(np));
    m_reading.given.silent_corners = corners_on_rim(m_reading.domain);
    m_wanted = no_finer_than_edges(m_reading.domain, m_reading.given, m_wanted, options.size_growth);
    options.counts_bubbles = false; // none are made
    m_limits = limit_by_outline(m_reading.domain, m_reading.given, m_wanted, options, options.limit_by_outline);
    add_sharp_corners(options.size_growth);
    add_long_edges();
  }

  const Sizes_2& sizes() const { return m_limits.sizes; }

  /// The same without those beyond circles around sharp corners: a part that has such a corner cuts it off by them.
  const Sizes_2& sizes_of_parts() const { return m_limits.before_cut; }

  /// around corners in which two edges of the domain meet in less than 45 degrees, and beside constraints that stay
  /// though they are too long
  const Bubble_buckets_2& forced_places() const { return m_forced; }

private:
  void add_forced(const Point& p, double size)
  {
    m_forced.insert(0, p.x(), p.y(), size);
  }

  void add_sharp_corners(double growth)
  {
    const std::vector<Point>& silent = m_reading.given.silent_corners;
    for (const Sharp_corner_2& c : sharp_corners(m_reading.domain, growth)) {
      const Point& p = m_reading.domain.corners()[c.corner];
      if (!std::binary_search(silent.begin(), silent.end(), p))
        add_forced(p, m_wanted(p));
    }
  }

  /// constraints that stay, and are far longer than sizes there
  void add_long_edges()
  {
    constexpr double tolerated = 1.5, reach = 1.5; // of which half is a radius, as far as fans of triangles go
    const Domain_2& domain = m_reading.domain;
    for (std::size_t k = 0; k < domain.edges().size(); ++k) {
      const Index e = static_cast<Index>(k);
      if (domain.edges()[k].kind != Edge_kind::PROTECTED)
        continue;
      const double length = domain.length(e);
      const Point middle = domain.point_on_edge(e, 0.5);
      double least = m_limits.sizes(middle);
      for (const Point& end : {domain.source(e), domain.target(e)})
        least = (std::min)(least, m_limits.sizes(end));
      if (length > tolerated * least)
        add_forced(middle, reach * length);
    }
  }

  /// whether a face of the domain is read
  bool is_read(Face_handle f) const
  {
    return !m_cdt.is_infinite(f) && m_is_in_domain(f) && (m_where == nullptr || m_where->contains(f));
  }

  template <class Visitor>
  void for_each_face(const Visitor& visit) const
  {
    if (m_where != nullptr)
      std::for_each(m_where->faces().begin(), m_where->faces().end(), visit);
    else
      for (Face_handle f : m_cdt.finite_face_handles())
        visit(f);
  }

  bool is_rim(Face_handle f, int i) const
  {
    const Face_handle n = f->neighbor(i);
    return !m_cdt.is_infinite(n) && m_is_in_domain(n) && !is_read(n);
  }

  /// A copy of the faces of the domain that have a constraint, or the rim, at a side: they know all of its outline.
  /// \throws std::invalid_argument if an edge of them is shorter than the least length
  Marked_copy_2 copy_at_outline() const
  {
    std::vector<Face_handle> faces;
    for_each_face([&](Face_handle f) {
      bool has_side = false;
      if (m_is_in_domain(f))
        for (int i = 0; i < 3; ++i)
          has_side = has_side || f->is_constrained(i) || is_rim(f, i);
      if (has_side)
        faces.push_back(f);
    });
    Marked_copy_2 result(m_cdt, faces, [this](Face_handle f, int i) { return is_rim(f, i); });
    result.check_lengths();
    return result;
  }

  template <class Is_pinned>
  void add_pins(const Is_pinned& is_pinned)
  {
    std::vector<Vertex_handle> pinned;
    for_each_face([&](Face_handle f) {
      for (int i = 0; i < 3; ++i)
        if (is_pinned(f->vertex(i)))
          pinned.push_back(f->vertex(i));
    });
    sort_each_once(pinned); // before one looks around them
    std::vector<Point>& pins = m_reading.given.pinned;
    pins.clear();
    for (Vertex_handle v : pinned)
      if (!m_cdt.are_there_incident_constraints(v) && is_surrounded(v))
        pins.push_back(point_in_double<Cdt>(v->point()));
    sort_each_once(pins);
  }

  /// whether all faces around a vertex are read
  bool is_surrounded(Vertex_handle v) const
  {
    return are_all_around(m_cdt, v, [this](Face_handle f) { return is_read(f); });
  }

  const Cdt& m_cdt;
  const Is_inside& m_is_in_domain;
  const Part_growth_2<Cdt, Is_inside>* m_where;
  Part_reading_2<Cdt> m_reading;
  Sizes_2 m_wanted;
  Limits_of_outline_2 m_limits{m_wanted, nullptr, nullptr, m_wanted};
  Bubble_buckets_2 m_forced;
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_ADAPTATION_SIZES_OF_OUTLINE_2_H
