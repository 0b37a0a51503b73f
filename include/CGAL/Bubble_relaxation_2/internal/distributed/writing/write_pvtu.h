// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_WRITING_WRITE_PVTU_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_WRITING_WRITE_PVTU_H

#include <CGAL/Bubble_relaxation_2/IO/VTU.h>
#include <CGAL/Bubble_relaxation_2/internal/files/in_xml.h>
#include <CGAL/Mesh_arrays_2.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <ostream>
#include <set>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// `name.pvtu` without its end
inline std::string pvtu_stem(const std::string& path)
{
  const std::string end = ".pvtu";
  if (path.size() <= end.size() || path.compare(path.size() - end.size(), end.size(), end) != 0)
    throw std::invalid_argument("Bubble_relaxation_2: the name of the file " + path + " must end with .pvtu");
  return path.substr(0, path.size() - end.size());
}

inline std::string vtu_path(const std::string& stem, int rank) { return stem + "_" + std::to_string(rank) + ".vtu"; }

/// adds the sides of a rank's triangles on constraints, each on one rank: the one that owns its end with the smaller
/// id, which knows both triangles
template <class Mesh>
void add_lines(const Mesh& mesh, Mesh_arrays_2& result)
{
  using Marker = typename Mesh::Marker;
  [[maybe_unused]] std::map<int, std::string> no_names;
  result.vertex_markers.assign(mesh.number_of_points(), 0);
  std::set<Mesh_arrays_2::Edge> known;
  for (std::size_t t = 0; t < mesh.number_of_triangles(); ++t)
    for (int i = 0; i < 3; ++i) {
      if (!mesh.is_constrained(t, i))
        continue;
      int marker = 0;
      if constexpr (std::is_arithmetic<Marker>::value || std::is_enum<Marker>::value)
        if (mesh.has_markers())
          marker = as_numbers<int>(std::vector<Marker>{mesh.marker(t, i)}, no_names, "edge_marker_map")[0];
      const auto end = [&](int k) { return static_cast<std::size_t>(mesh.vertices(t)[static_cast<std::size_t>(k)]); };
      Mesh_arrays_2::Edge e{end(ccw(i)), end(cw(i))};
      for (std::size_t v : e)
        result.vertex_markers[v] = (std::max)(result.vertex_markers[v], marker);
      if (mesh.global_id(e[1]) < mesh.global_id(e[0]))
        std::swap(e[0], e[1]);
      if (mesh.is_ghost(e[0]) || !known.insert(e).second)
        continue;
      result.edges.push_back(e);
      result.edge_markers.push_back(marker);
    }
}

/// What a rank writes: its triangles, with all points that it knows. `of_points`, `of_triangles`: the user's, with names
/// \throws std::invalid_argument if data would be there twice, or if a marker or a region is no number for files
template <class Mesh, class Data>
Mesh_arrays_2 arrays_of_part(const Mesh& mesh, const Data& of_points, const Data& of_triangles)
{
  using Region = typename Mesh::Region;
  [[maybe_unused]] std::map<double, std::string> no_names;
  Mesh_arrays_2 result;
  const auto add_data = [](auto& arrays, const std::string& name, std::size_t n, const auto& value) {
    if (name == "marker" || name == "q" || name == "dimension" || arrays.count(name) != 0) // `write_VTU()` adds three
      throw std::invalid_argument("Bubble_relaxation_2: the data '" + name + "' of write_pvtu() are there already");
    std::vector<double> values;
    for (std::size_t i = 0; i < n; ++i)
      values.push_back(static_cast<double>(value(i)));
    arrays[name] = std::move(values);
  };
  const std::size_t points = mesh.number_of_points(), triangles = mesh.number_of_owned_triangles();
  for (std::size_t i = 0; i < points; ++i)
    result.points.emplace_back(CGAL::to_double(mesh.point(i).x()), CGAL::to_double(mesh.point(i).y()));
  add_data(result.vertex_data, "global_id", points, [&](std::size_t i) { return mesh.global_id(i); });
  add_data(result.vertex_data, "size", points, [&](std::size_t i) { return mesh.size(i); });
  add_data(result.vertex_data, "rank", points, [&](std::size_t i) { return mesh.owner(i); });
  for (const auto& data : of_points)
    add_data(result.vertex_data, data.name, points, data.value);
  for (std::size_t t = 0; t < triangles; ++t) {
    Mesh_arrays_2::Triangle triangle;
    std::copy(mesh.vertices(t).begin(), mesh.vertices(t).end(), triangle.begin());
    result.triangles.push_back(triangle);
  }
  if constexpr (std::is_arithmetic<Region>::value || std::is_enum<Region>::value)
    if (mesh.has_regions())
      add_data(result.triangle_data, "region", triangles, [&](std::size_t t) {
        return as_numbers<double>(std::vector<Region>{mesh.region(t)}, no_names, "face_region_map")[0];
      });
  add_data(result.triangle_data, "rank", triangles, [&](std::size_t) { return mesh.rank(); });
  for (const auto& data : of_triangles)
    add_data(result.triangle_data, data.name, triangles, data.value);
  add_lines(mesh, result);
  return result;
}

/// Writes the file that names those of all ranks: `part` is one of them, and all have the same arrays.
inline void write_pvtu_header(std::ostream& out, const Mesh_arrays_2& part, const std::string& stem, int ranks)
{
  const auto array = [&out](const char* type, const std::string& name, const char* more = "") {
    out << "<PDataArray type=\"" << type << "\" Name=\"" << in_xml(name) << "\"" << more << "/>\n";
  };
  out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"PUnstructuredGrid\" version=\"1.0\" byte_order=\"" << byte_order()
      << "\" header_type=\"UInt64\">\n<PUnstructuredGrid GhostLevel=\"0\">\n<PPointData>\n";
  array("Int32", "marker");
  for (const auto& data : part.vertex_data)
    array("Float64", data.first);
  out << "</PPointData>\n<PCellData Scalars=\"q\">\n";
  array("Float64", "q");
  array("Int32", "dimension");
  array("Int32", "marker");
  for (const auto& data : part.triangle_data)
    array("Float64", data.first);
  out << "</PCellData>\n<PPoints>\n";
  array("Float64", "Points", " NumberOfComponents=\"3\"");
  out << "</PPoints>\n";
  const std::string name = stem.substr(stem.find_last_of('/') + 1); // beside this file
  for (int rank = 0; rank < ranks; ++rank)
    out << "<Piece Source=\"" << in_xml(vtu_path(name, rank)) << "\"/>\n";
  out << "</PUnstructuredGrid>\n</VTKFile>\n";
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_WRITING_WRITE_PVTU_H
