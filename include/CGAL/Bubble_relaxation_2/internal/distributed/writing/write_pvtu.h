// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_WRITING_WRITE_PVTU_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_WRITING_WRITE_PVTU_H

#include <CGAL/Bubble_relaxation_2/internal/core/in_words.h>

#include <CGAL/radius_ratio_2.h>

#include <cstddef>
#include <fstream>
#include <ostream>
#include <stdexcept>
#include <string>

namespace CGAL::Bubble_relaxation_2::internal {

/// `name.pvtu` without its end
inline std::string pvtu_stem(const std::string& path)
{
  const std::string end = ".pvtu";
  if (path.size() <= end.size() || path.compare(path.size() - end.size(), end.size(), end) != 0)
    throw std::invalid_argument("Bubble_relaxation_2: the name of the file " + path + " must end with .pvtu");
  return path.substr(0, path.size() - end.size());
}

inline std::string vtu_path(const std::string& stem, int rank)
{
  return stem + "_" + std::to_string(rank) + ".vtu";
}

inline std::string in_xml(const std::string& text)
{
  std::string result;
  for (char c : text) {
    if (c == '&')
      result += "&amp;";
    else if (c == '<')
      result += "&lt;";
    else if (c == '"')
      result += "&quot;";
    else
      result += c;
  }
  return result;
}

/// Calls `array(type, name, n, text)` for what ParaView gets of `n` points or triangles; `text(i)` is what stands there.
template <class Mesh, class Array>
void for_each_point_array(const Mesh& mesh, const Array& array)
{
  const std::size_t n = mesh.number_of_points();
  array("Int64", "global_id", n, [&mesh](std::size_t i) { return std::to_string(mesh.global_id(i)); });
  array("Float64", "size", n, [&mesh](std::size_t i) { return in_words(mesh.size(i)); });
  array("Int32", "rank", n, [&mesh](std::size_t i) { return std::to_string(mesh.owner(i)); });
}

template <class Mesh, class Array>
void for_each_triangle_array(const Mesh& mesh, const Array& array)
{
  const std::size_t n = mesh.number_of_owned_triangles();
  array("Float64", "q", n, [&mesh](std::size_t t) {
    const auto point = [&](std::size_t k) { return mesh.point(static_cast<std::size_t>(mesh.vertices(t)[k])); };
    return in_words(CGAL::to_double(CGAL::radius_ratio_2(point(0), point(1), point(2))));
  });
  array("Int32", "rank", n, [&mesh](std::size_t) { return std::to_string(mesh.rank()); });
}

constexpr const char vtk_head[] = " version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n";
constexpr const char vtk_points[] = "Float64\" NumberOfComponents=\"3";

/// Writes one rank's triangles, and all points that it knows.
template <class Mesh>
void write_vtu(std::ostream& out, const Mesh& mesh)
{
  const auto array = [&out](const char* type, const char* name, std::size_t n, const auto& text) {
    out << "<DataArray type=\"" << type << "\" Name=\"" << name << "\" format=\"ascii\">\n";
    for (std::size_t i = 0; i < n; ++i)
      out << text(i) << "\n";
    out << "</DataArray>\n";
  };
  const std::size_t points = mesh.number_of_points(), triangles = mesh.number_of_owned_triangles();
  out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\"" << vtk_head << "<UnstructuredGrid>\n"
      << "<Piece NumberOfPoints=\"" << points << "\" NumberOfCells=\"" << triangles << "\">\n<PointData>\n";
  for_each_point_array(mesh, array);
  out << "</PointData>\n<CellData Scalars=\"q\">\n";
  for_each_triangle_array(mesh, array);
  out << "</CellData>\n<Points>\n";
  array(vtk_points, "Points", points, [&mesh](std::size_t i) {
    return in_words(CGAL::to_double(mesh.point(i).x())) + " " + in_words(CGAL::to_double(mesh.point(i).y())) + " 0";
  });
  out << "</Points>\n<Cells>\n";
  array("Int64", "connectivity", triangles, [&mesh](std::size_t t) {
    const auto& v = mesh.vertices(t);
    return std::to_string(v[0]) + " " + std::to_string(v[1]) + " " + std::to_string(v[2]);
  });
  array("Int64", "offsets", triangles, [](std::size_t t) { return std::to_string(3 * (t + 1)); });
  array("UInt8", "types", triangles, [](std::size_t) { return std::string("5"); }); // VTK_TRIANGLE
  out << "</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
}

/// writes the file that names those of all ranks
template <class Mesh>
void write_pvtu_header(std::ostream& out, const Mesh& mesh, const std::string& stem)
{
  const auto array = [&out](const char* type, const char* name, std::size_t, const auto&) {
    out << "<PDataArray type=\"" << type << "\" Name=\"" << name << "\"/>\n";
  };
  out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"PUnstructuredGrid\"" << vtk_head
      << "<PUnstructuredGrid GhostLevel=\"0\">\n<PPointData>\n";
  for_each_point_array(mesh, array);
  out << "</PPointData>\n<PCellData Scalars=\"q\">\n";
  for_each_triangle_array(mesh, array);
  out << "</PCellData>\n<PPoints>\n";
  array(vtk_points, "Points", 0, 0);
  out << "</PPoints>\n";
  const std::string name = stem.substr(stem.find_last_of('/') + 1); // beside this file
  for (int rank = 0; rank < mesh.number_of_ranks(); ++rank)
    out << "<Piece Source=\"" << in_xml(vtu_path(name, rank)) << "\"/>\n";
  out << "</PUnstructuredGrid>\n</VTKFile>\n";
}

/// \throws std::runtime_error if the file cannot be written
template <class Write>
void write_file(const std::string& path, const Write& write)
{
  std::ofstream out(path);
  if (out)
    write(out);
  out.close();
  if (!out)
    throw std::runtime_error("Bubble_relaxation_2: the file " + path + " cannot be written");
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_WRITING_WRITE_PVTU_H
