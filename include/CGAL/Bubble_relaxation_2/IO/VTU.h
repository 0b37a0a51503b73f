// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_IO_VTU_H
#define CGAL_BUBBLE_RELAXATION_2_IO_VTU_H

#include <CGAL/license/Bubble_relaxation_2.h>

#include <CGAL/Bubble_relaxation_2/internal/core/disable_warnings.h>

#include <CGAL/Bubble_relaxation_2/internal/files/Vtu_file.h>
#include <CGAL/Bubble_relaxation_2/internal/files/write_file.h>
#include <CGAL/Mesh_arrays_2.h>
#include <CGAL/radius_ratio_2.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <ostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2::internal {

/// \throws std::invalid_argument if data have the name of what is written anyway: which one counts nobody would know
inline void check_data_names(const Mesh_arrays_2& mesh)
{
  const auto check = [](const auto& data, const std::string& name) {
    if (data.count(name) != 0)
      throw std::invalid_argument("Bubble_relaxation_2: mesh arrays: data must not have the name '" + name +
                                  "', which write_VTU() uses");
  };
  check(mesh.vertex_data, "marker");
  for (const char* name : {"q", "dimension", "marker"})
    check(mesh.triangle_data, name);
  if (!mesh.regions.empty())
    check(mesh.triangle_data, "region");
}

inline void write_point_data(Vtu_file& file, const Mesh_arrays_2& mesh)
{
  file.data("PointData", "", [&] {
    file.array("marker", mesh.vertex_markers);
    for (const auto& data : mesh.vertex_data)
      file.array(data.first, data.second);
  });
}

/// of triangles, then of edges
inline void write_cell_data(Vtu_file& file, const Mesh_arrays_2& mesh)
{
  constexpr double none = std::numeric_limits<double>::quiet_NaN(); // a line has neither q nor a region
  const std::size_t triangles = mesh.triangles.size(), cells = triangles + mesh.edges.size();
  std::vector<double> q;
  for (const auto& t : mesh.triangles)
    q.push_back(CGAL::radius_ratio_2(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]));
  q.resize(cells, none);
  std::vector<std::int32_t> dimension(triangles, 2), marker(triangles, 0);
  dimension.resize(cells, 1);
  marker.insert(marker.end(), mesh.edge_markers.begin(), mesh.edge_markers.end());
  file.data("CellData", "q", [&] {
    file.array("q", q);
    file.array("dimension", dimension);
    file.array("marker", marker);
    const auto of_triangles = [&](const std::string& name, std::vector<double> values) {
      values.resize(cells, none);
      file.array(name, values);
    };
    if (!mesh.regions.empty())
      of_triangles("region", mesh.regions);
    for (const auto& data : mesh.triangle_data)
      of_triangles(data.first, data.second);
  });
}

} // namespace Bubble_relaxation_2::internal

namespace IO {

/*!
\ingroup PkgBubbleRelaxation2Files

writes a mesh as a `.vtu` file of VTK, for ParaView and others: triangles and the edges on constraints as lines, with
the cell data `q` (not a number for lines), `dimension` (2 for triangles, 1 for lines), `marker` (of lines), and
`region` if there are any, and those of `triangle_data`; and the point data `marker` and those of `vertex_data`. It is
XML with arrays in base64.
Names are not kept.

\cgal's function of this name writes what faces and constraints a triangulation has, with no tags.

\returns whether it was written

\throws std::invalid_argument as `Mesh_arrays_2::check()` does, or if data have one of these names
*/
inline bool write_VTU(std::ostream& out, const Mesh_arrays_2& mesh)
{
  using namespace Bubble_relaxation_2::internal;
  mesh.check();
  check_data_names(mesh);
  Vtu_file file(out, mesh.points.size(), mesh.triangles.size() + mesh.edges.size());
  write_point_data(file, mesh);
  write_cell_data(file, mesh);
  std::vector<double> coordinates;
  for (std::size_t k = 0; k < mesh.points.size(); ++k)
    coordinates.insert(coordinates.end(), {mesh.points[k].x(), mesh.points[k].y(),
                                           mesh.elevations.empty() ? 0 : mesh.elevations[k]});
  file.points(coordinates);
  constexpr std::uint8_t triangle = 5, line = 3; // as VTK numbers them
  file.add_cells(mesh.triangles, triangle);
  file.add_cells(mesh.edges, line);
  file.end();
  return static_cast<bool>(out);
}

/*!
\ingroup PkgBubbleRelaxation2Files

writes a mesh to the file `name`.

\throws std::runtime_error with the name and the reason if it cannot be written; then it is not there
*/
inline void write_VTU(const std::string& name, const Mesh_arrays_2& mesh)
{
  mesh.check();
  Bubble_relaxation_2::internal::check_data_names(mesh); // before the file is opened
  Bubble_relaxation_2::internal::write_file(name, [&mesh](std::ostream& out) { write_VTU(out, mesh); });
}

} // namespace IO
} // namespace CGAL

#include <CGAL/Bubble_relaxation_2/internal/core/enable_warnings.h>

#endif // CGAL_BUBBLE_RELAXATION_2_IO_VTU_H
