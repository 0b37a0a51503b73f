// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_CONSTRAINT_MARKER_MAP_2_H
#define CGAL_CONSTRAINT_MARKER_MAP_2_H

#include <CGAL/license/Bubble_relaxation_2.h>

#include <CGAL/Bubble_relaxation_2/internal/core/disable_warnings.h>

#include <CGAL/Bubble_relaxation_2/internal/core/Address_map.h>
#include <CGAL/Bubble_relaxation_2/internal/core/in_words.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/flatten_triangulation.h>

#include <CGAL/property_map.h>

#include <functional>
#include <iterator>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgBubbleRelaxation2Tags

Markers of the constraints of a triangulation, such as numbers of boundary conditions, for the parameter
`edge_marker_map` of `npbs_relax()`.

It holds a marker for each pair of vertices that it is told, whichever is named first. Copies share what they hold. When
a triangulation is meshed, the markers of edges that go are forgotten; any other change of the triangulation leaves
the map as it is: an edge that a later insertion cuts has no marker any more, and new vertices may come to be where
others were in memory. So markers are set when all constraints are in, best by the `set()` that follows a line, and
after changes of your own again, after `clear()`.

\cgalModels{ReadWritePropertyMap}

\tparam CDT_ a `Constrained_Delaunay_triangulation_2` or a `Constrained_triangulation_plus_2` of one
\tparam Marker a type that can be copied and compared by `==`

\sa `npbs_relax()`
\sa `Face_region_map_2`
*/
template <class CDT_, class Marker = int>
class Constraint_marker_map_2
{
public:
  using CDT = CDT_;
  using Vertex_handle = typename CDT::Vertex_handle;

  using key_type = std::pair<Vertex_handle, Vertex_handle>; ///< the ends of an edge
  using value_type = Marker;
  using reference = const Marker&;
  using category = boost::read_write_property_map_tag;

  /// \param others the marker of the edges that the map is told nothing of
  explicit Constraint_marker_map_2(const Marker& others = Marker()) : m_markers(others) {}

  /// returns the marker of the edge between two vertices.
  const Marker& operator()(Vertex_handle u, Vertex_handle v) const { return m_markers(addresses(u, v)); }

  /// sets the marker of the edge between two vertices.
  void set(Vertex_handle u, Vertex_handle v, const Marker& marker) const { m_markers.set(addresses(u, v), marker); }

  /// sets the marker of all edges of `cdt` on the straight line between two vertices, as `insert_constraint(u, v)` has
  /// left them: vertices on the line cut it.
  /// \throws std::invalid_argument if constraints do not lead on to `v`, as where a crossing of them was rounded, or
  /// a slanted line was meshed. Then no marker is set. A `Constrained_triangulation_plus_2` knows where its constraints
  /// go, and has the next function
  void set(const CDT& cdt, Vertex_handle u, Vertex_handle v, const Marker& marker) const
  {
    std::vector<Vertex_handle> line{u};
    typename CDT::Face_handle f;
    int i = 0;
    for (Vertex_handle next; line.back() != v; line.push_back(next))
      if (!cdt.includes_edge(line.back(), v, next, f, i) || !f->is_constrained(i)) {
        using Bubble_relaxation_2::internal::in_words;
        using Bubble_relaxation_2::internal::point_in_double;
        const auto end = point_in_double<CDT>(line.back()->point()), aim = point_in_double<CDT>(v->point());
        throw std::invalid_argument("Bubble_relaxation_2: no constraint leads straight on from " +
                                    in_words(end.x(), end.y()) + " to " + in_words(aim.x(), aim.y()) +
                                    ": a crossing was rounded, the line was meshed, so that vertices lie "
                                    "beside it by a rounding, or there is none");
      }
    for (std::size_t k = 1; k < line.size(); ++k)
      set(line[k - 1], line[k], marker);
  }

  /// sets the marker of all edges of a constraint of a `Constrained_triangulation_plus_2`, `CDT::Constraint_id`.
  template <class Constraint_id>
  void set(const CDT& cdt, Constraint_id constraint, const Marker& marker) const
  {
    const auto end = cdt.vertices_in_constraint_end(constraint);
    auto u = cdt.vertices_in_constraint_begin(constraint);
    for (auto v = std::next(u); v != end; u = v++)
      set(*u, *v, marker);
  }

  /// forgets all markers.
  void clear() const { m_markers.clear(); }

  friend const Marker& get(const Constraint_marker_map_2& map, const key_type& edge)
  {
    return map(edge.first, edge.second);
  }

  friend void put(const Constraint_marker_map_2& map, const key_type& edge, const Marker& marker)
  {
    map.set(edge.first, edge.second, marker);
  }

#ifndef DOXYGEN_RUNNING
  friend void forget(const Constraint_marker_map_2& map, const key_type& edge)
  {
    map.m_markers.forget(addresses(edge.first, edge.second));
  }
#endif

private:
  using Map = Bubble_relaxation_2::internal::Address_map<2, Marker>;

  static typename Map::Addresses addresses(Vertex_handle u, Vertex_handle v)
  {
    const void *p = &*u, *q = &*v;
    if (std::less<const void*>()(q, p))
      std::swap(p, q);
    return {p, q};
  }

  Map m_markers;
};

} // namespace CGAL

#include <CGAL/Bubble_relaxation_2/internal/core/enable_warnings.h>

#endif // CGAL_CONSTRAINT_MARKER_MAP_2_H
