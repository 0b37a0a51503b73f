// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_FACE_REGION_MAP_2_H
#define CGAL_FACE_REGION_MAP_2_H

#include <CGAL/license/Bubble_relaxation_2.h>

#include <CGAL/Bubble_relaxation_2/internal/core/disable_warnings.h>

#include <CGAL/Bubble_relaxation_2/internal/core/Address_map.h>
#include <CGAL/Bubble_relaxation_2/internal/core/flood_faces.h>

#include <CGAL/property_map.h>

#include <unordered_set>

namespace CGAL {

/*!
\ingroup PkgBubbleRelaxation2Tags

The regions of the faces of a triangulation, such as numbers of materials, for the parameter `face_region_map` of
`npbs_relax()`, and for `Region_sizing_field_2`.

Copies share what they hold. When a triangulation is meshed, the regions of faces that go are forgotten; any other
change of the triangulation leaves the map as it is. Then new faces may come to be where others were in memory, and
have their regions: `clear()` the map and set regions again after insertions and removals of your own.

\cgalModels{ReadWritePropertyMap}

\tparam CDT_ a `Constrained_Delaunay_triangulation_2` or a `Constrained_triangulation_plus_2` of one
\tparam Region a type that can be copied and compared by `==`

\sa `npbs_relax()`
\sa `Region_sizing_field_2`
\sa `Constraint_marker_map_2`
*/
template <class CDT_, class Region = int>
class Face_region_map_2
{
public:
  using CDT = CDT_;
  using Face_handle = typename CDT::Face_handle;

  using key_type = Face_handle;
  using value_type = Region;
  using reference = const Region&;
  using category = boost::read_write_property_map_tag;

  /// \param others the region of the faces that the map is told nothing of
  explicit Face_region_map_2(const Region& others = Region()) : m_regions(others) {}

  /// returns the region of a face.
  const Region& operator()(Face_handle f) const { return m_regions({&*f}); }

  /// sets the region of a face.
  void set(Face_handle f, const Region& region) const { m_regions.set({&*f}, region); }

  /// sets the region of all faces around a face that no constraint separates from it.
  void set_all_around(Face_handle f, const Region& region) const
  {
    std::unordered_set<const void*> reached;
    Bubble_relaxation_2::internal::flood_faces(f, reached, [&](Face_handle g) { set(g, region); });
  }

  /// forgets all regions.
  void clear() const { m_regions.clear(); }

  friend const Region& get(const Face_region_map_2& map, key_type f) { return map(f); }

  friend void put(const Face_region_map_2& map, key_type f, const Region& region) { map.set(f, region); }

#ifndef DOXYGEN_RUNNING
  friend void forget(const Face_region_map_2& map, key_type f) { map.m_regions.forget({&*f}); }
#endif

private:
  Bubble_relaxation_2::internal::Address_map<1, Region> m_regions;
};

} // namespace CGAL

#include <CGAL/Bubble_relaxation_2/internal/core/enable_warnings.h>

#endif // CGAL_FACE_REGION_MAP_2_H
