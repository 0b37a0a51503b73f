// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_FILES_DEPTH_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_FILES_DEPTH_H

#include <CGAL/Mesh_arrays_2.h>

#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// depths of the points, positive downwards: the vertex data of this name, else what elevations tell, else 0
inline std::vector<double> depths(const Mesh_arrays_2& mesh)
{
  const auto found = mesh.vertex_data.find("depth");
  if (found != mesh.vertex_data.end())
    return found->second;
  std::vector<double> result(mesh.elevations);
  for (double& depth : result)
    depth = 0 - depth;
  result.resize(mesh.points.size(), 0);
  return result;
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_FILES_DEPTH_H
