// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_FIELDS_REGION_SEARCH_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_FIELDS_REGION_SEARCH_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/reproducible_math.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Flat_triangulation_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Triangle_quadtree_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// The regions in which places lie: one, or all that meet in a place up to rounding.
class Region_search_2
{
public:
  /// \param region of each triangle, `no_index` outside of the domain
  Region_search_2(Flat_triangulation_2 tr, std::vector<Index> region)
    : m_tr(std::move(tr)), m_region(std::move(region)), m_quadtree(m_tr), m_around(m_tr.points.size())
  {
    for (std::size_t t = 0; t < m_region.size(); ++t)
      if (m_region[t] != no_index)
        for (Index v : m_tr.vertices[t])
          add(m_region[t], m_around[v]);
    spread_outside();
  }

  /// calls `visit(region)`, for a region once or more often
  template <class Visit>
  void for_each_region(const Point& q, const Visit& visit) const
  {
    const Index t = locate_or_exit(m_tr, m_quadtree.start(q.x(), q.y()), q).triangle;
    bool is_known = m_tr.inside[t] != 0;
    if (is_known)
      visit(static_cast<std::size_t>(m_region[t]));
    for (int i = 0; i < 3; ++i) {
      const Index n = m_tr.neighbors[t][i];
      if (n != no_index && m_tr.inside[n] && m_region[n] != (m_tr.inside[t] ? m_region[t] : no_index) &&
          is_on_side(t, i, q)) {
        visit(static_cast<std::size_t>(m_region[n]));
        is_known = true;
      }
      if (is_near(m_tr.point(t, i), q))
        for (Index region : m_around[m_tr.vertices[t][i]]) {
          visit(static_cast<std::size_t>(region));
          is_known = true;
        }
    }
    if (!is_known)
      visit(static_cast<std::size_t>(m_region[t]));
  }

private:
  static void add(Index region, std::vector<Index>& regions)
  {
    if (std::find(regions.begin(), regions.end(), region) == regions.end())
      regions.push_back(region);
  }

  /// triangles outside take the region of one beside them, from the domain on
  void spread_outside()
  {
    std::vector<Index> queue = indices_where(m_region.size(), [this](Index t) { return m_region[t] != no_index; });
    for (std::size_t k = 0; k < queue.size(); ++k)
      for (Index n : m_tr.neighbors[queue[k]])
        if (n != no_index && m_region[n] == no_index) {
          m_region[n] = m_region[queue[k]];
          queue.push_back(n);
        }
  }

  /// some roundings of coordinates
  static double tolerance(const Point& q)
  {
    return 16 * std::numeric_limits<double>::epsilon() * (std::max)(std::abs(q.x()), std::abs(q.y()));
  }

  static bool is_near(const Point& p, const Point& q)
  {
    return (std::max)(std::abs(p.x() - q.x()), std::abs(p.y() - q.y())) <= tolerance(p);
  }

  /// whether `q`, which is no farther than its triangle or the one beyond it, lies on a side
  bool is_on_side(Index t, int i, const Point& q) const
  {
    const Point &a = m_tr.point(t, ccw(i)), &b = m_tr.point(t, cw(i));
    const double dx = b.x() - a.x(), dy = b.y() - a.y();
    return std::abs(dx * (q.y() - a.y()) - dy * (q.x() - a.x())) <=
           (std::max)(tolerance(a), tolerance(b)) * length_of(dx, dy);
  }

  Flat_triangulation_2 m_tr;
  std::vector<Index> m_region;
  Triangle_quadtree_2 m_quadtree;
  std::vector<std::vector<Index>> m_around; // regions of the domain around each vertex
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_FIELDS_REGION_SEARCH_2_H
