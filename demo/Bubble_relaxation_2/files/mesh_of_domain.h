// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef BUBBLE_RELAXATION_2_DEMO_MESH_OF_DOMAIN_H
#define BUBBLE_RELAXATION_2_DEMO_MESH_OF_DOMAIN_H

#include "domain.h"

#include <CGAL/Bubble_relaxation_parameters.h>
#include <CGAL/Mesh_arrays_2.h>

#include <cstddef>

/// Gives a mesh the tags of its domain's file: points that have a marker there keep it, and the boundary is marked.
inline void add_tags_of_file(const Domain& domain, CGAL::Mesh_arrays_2& mesh)
{
  mesh.mark_boundary();
  for (std::size_t k = 0; k < mesh.points.size(); ++k) {
    const int own = point_marker(domain, mesh.points[k]);
    if (own != 0)
      mesh.vertex_markers[k] = own;
  }
  if (domain.regions.empty())
    mesh.regions.clear();
}

/// \param regions of the faces
inline CGAL::Mesh_arrays_2 mesh_of(Domain& domain, const Region_map& regions)
{
  CGAL::Mesh_arrays_2 mesh(
    domain.cdt, CGAL::parameters::edge_marker_map(Segment_marker_map{&domain}).face_region_map(regions));
  add_tags_of_file(domain, mesh);
  return mesh;
}

#endif // BUBBLE_RELAXATION_2_DEMO_MESH_OF_DOMAIN_H
