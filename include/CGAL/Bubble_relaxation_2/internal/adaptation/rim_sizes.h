// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_ADAPTATION_RIM_SIZES_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_ADAPTATION_RIM_SIZES_H

#include <CGAL/Bubble_relaxation_2/internal/adaptation/Part_reading_2.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Sizes_2.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_2.h>
#include <CGAL/Bubble_relaxation_2/internal/sizes/Outline_sizes_2.h>

#include <CGAL/Bubble_relaxation_report_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// the length of the shorter edge of the rim at each corner of a part, infinite where there is none
inline std::vector<double> lengths_at_rim(const Domain_2& part)
{
  return lengths_at_corners(part, Edge_kind::RIM);
}

/// those that the rim of a part has, sorted
inline std::vector<Point> corners_on_rim(const Domain_2& part)
{
  const std::vector<double> length = lengths_at_rim(part);
  std::vector<Point> result;
  for (std::size_t c = 0; c < length.size(); ++c)
    if (!std::isinf(length[c]))
      result.push_back(part.corners()[c]);
  std::sort(result.begin(), result.end());
  return result;
}

/// Tells where sizes are too steep for any mesh of the domain.
template <class Cdt, class Is_inside>
class Jump_search_2
{
  using Vertex_handle = typename Cdt::Vertex_handle;

public:
  Jump_search_2(const Cdt& cdt, const Is_inside& is_in_domain, const Sizes_2& sizes)
    : m_cdt(cdt), m_is_in_domain(is_in_domain), m_sizes(sizes)
  {}

  /// whether they are at an edge within some rings around `v`
  bool is_near(Vertex_handle v)
  {
    constexpr int rings = 4; // as far as the large triangles beside a jump are smaller than they should be
    std::set<Vertex_handle> seen{v};
    std::vector<Vertex_handle> ring{v}, next;
    for (int k = 0; k < rings; ++k, ring.swap(next)) {
      next.clear();
      for (Vertex_handle u : ring) {
        auto f = m_cdt.incident_faces(u), first = f;
        do {
          if (m_cdt.is_infinite(f) || !m_is_in_domain(f))
            continue;
          for (int i = 0; i < 3; ++i)
            if (is_steep(f->vertex(Cdt::ccw(i)), f->vertex(Cdt::cw(i))))
              return true;
          for (int i = 0; i < 3; ++i)
            if (seen.insert(f->vertex(i)).second)
              next.push_back(f->vertex(i));
        } while (++f != first);
      }
    }
    return false;
  }

private:
  bool is_steep(Vertex_handle u, Vertex_handle v)
  {
    constexpr double too_steep = Bubble_relaxation_report_2<double>::steep_size_gradient;
    const Point p = point_in_double<Cdt>(u->point()), q = point_in_double<Cdt>(v->point());
    return std::abs(size(u, p) - size(v, q)) > too_steep * std::sqrt(CGAL::squared_distance(p, q));
  }

  /// those of neighbouring places are needed again and again
  double size(Vertex_handle v, const Point& p)
  {
    const auto [found, is_new] = m_known.try_emplace(v, 0);
    if (is_new)
      found->second = m_sizes(p);
    return found->second;
  }

  const Cdt& m_cdt;
  const Is_inside& m_is_in_domain;
  const Sizes_2& m_sizes;
  std::map<Vertex_handle, double> m_known;
};

/// The corners of a part on its rim, where that does not fit sizes since these jump. Sorted. Few rims do not fit.
template <class Cdt, class Is_inside>
std::vector<Point> rim_at_jumps(const Cdt& cdt, const Is_inside& is_in_domain, const Part_reading_2<Cdt>& reading,
                                const Sizes_2& wanted)
{
  constexpr double shortest = 0.9, longest = 1.25; // what has no consequences
  const std::vector<Point>& corners = reading.domain.corners();
  const std::vector<double> length = lengths_at_rim(reading.domain);
  Jump_search_2<Cdt, Is_inside> jumps(cdt, is_in_domain, wanted);
  std::vector<Point> result;
  for (std::size_t c = 0; c < corners.size(); ++c) {
    if (std::isinf(length[c]))
      continue;
    const double misfit = length[c] / wanted(corners[c]);
    if ((misfit < shortest || misfit > longest) && jumps.is_near(reading.vertex(reading.graph->corners()[c])))
      result.push_back(corners[c]);
  }
  std::sort(result.begin(), result.end());
  return result;
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_ADAPTATION_RIM_SIZES_H
