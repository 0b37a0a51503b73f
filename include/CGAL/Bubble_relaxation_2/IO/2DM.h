// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_IO_2DM_H
#define CGAL_BUBBLE_RELAXATION_2_IO_2DM_H

#include <CGAL/license/Bubble_relaxation_2.h>

#include <CGAL/Bubble_relaxation_2/internal/core/disable_warnings.h>

#include <CGAL/Bubble_relaxation_2/internal/files/Edge_chains_2.h>
#include <CGAL/Bubble_relaxation_2/internal/files/Tag_groups.h>
#include <CGAL/Bubble_relaxation_2/internal/files/depth.h>
#include <CGAL/Bubble_relaxation_2/internal/files/write_file.h>
#include <CGAL/Mesh_arrays_2.h>

#include <cstddef>
#include <map>
#include <ostream>
#include <string>
#include <vector>

namespace CGAL::IO {

/*!
\ingroup PkgBubbleRelaxation2Files

writes a mesh as a `.2dm` file of SMS, which QGIS, BASEMENT and others read as well: triangles (`E3T`) with their
regions as materials, 1 if there are none, nodes (`ND`) with elevations, and the edges that have a marker as node
strings (`NS`): one for each chain of edges of a marker, which is its number, closed ones with their first node at the
end as well.

A node's z is its elevation, or else minus the vertex data `depth`, or else 0. Other data and names are not kept.

\returns whether it was written

\throws std::invalid_argument as `Mesh_arrays_2::check()` does
*/
inline bool write_2DM(std::ostream& out, const Mesh_arrays_2& mesh)
{
  using namespace Bubble_relaxation_2::internal;
  mesh.check();
  const Plain_numbers plain(out);
  out << "MESH2D\nNUM_MATERIALS_PER_ELEM 1\n";
  const Tag_groups materials(mesh.regions, mesh.region_names);
  for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
    const auto& t = mesh.triangles[k];
    out << "E3T " << k + 1 << ' ' << t[0] + 1 << ' ' << t[1] + 1 << ' ' << t[2] + 1 << ' '
        << (mesh.regions.empty() ? 1 : materials(mesh.regions[k]).number) << '\n';
  }
  const std::vector<double> depth = depths(mesh);
  for (std::size_t k = 0; k < mesh.points.size(); ++k) {
    const double z = mesh.elevations.empty() ? 0 - depth[k] : mesh.elevations[k]; // no "-0"
    out << "ND " << k + 1 << ' ' << mesh.points[k].x() << ' ' << mesh.points[k].y() << ' ' << z << '\n';
  }
  std::map<int, std::vector<Mesh_arrays_2::Edge>> edges_of; // of each marker
  for (std::size_t k = 0; k < mesh.edges.size(); ++k)
    if (mesh.edge_markers[k] != 0)
      edges_of[mesh.edge_markers[k]].push_back(mesh.edges[k]);
  for (const auto& edges : edges_of)
    for (const auto& chain : Edge_chains_2(edges.second).take_chains()) {
      constexpr std::size_t nodes_of_line = 10;
      for (std::size_t k = 0; k < chain.size(); ++k)
        out << (k % nodes_of_line > 0 ? "" : k > 0 ? "\nNS" : "NS") << (k + 1 < chain.size() ? " " : " -")
            << chain[k] + 1;
      out << ' ' << edges.first << '\n';
    }
  return static_cast<bool>(out);
}

/*!
\ingroup PkgBubbleRelaxation2Files

writes a mesh to the file `name`.

\throws std::runtime_error with the name and the reason if it cannot be written; then it is not there
*/
inline void write_2DM(const std::string& name, const Mesh_arrays_2& mesh)
{
  mesh.check();
  Bubble_relaxation_2::internal::write_file(name, [&mesh](std::ostream& out) { write_2DM(out, mesh); });
}

} // namespace CGAL::IO

#include <CGAL/Bubble_relaxation_2/internal/core/enable_warnings.h>

#endif // CGAL_BUBBLE_RELAXATION_2_IO_2DM_H
