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
#include <cstdint>
#include <fstream>
#include <ostream>
#include <stdexcept>
#include <string>
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

/// Writes one rank's triangles for ParaView, with the points that they need.
template <class Mesh>
class Vtu_piece_2
{
public:
  explicit Vtu_piece_2(const Mesh& mesh) : m_mesh(mesh), m_number(mesh.number_of_points(), -1)
  {
    for (std::size_t i = 0; i < mesh.number_of_owned_points(); ++i)
      take(i);
    for (std::size_t t = 0; t < mesh.number_of_owned_triangles(); ++t)
      for (auto v : mesh.vertices(t))
        take(static_cast<std::size_t>(v));
  }

  void write(std::ostream& out) const
  {
    const std::size_t triangles = m_mesh.number_of_owned_triangles();
    out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
        << "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<UnstructuredGrid>\n"
        << "<Piece NumberOfPoints=\"" << m_points.size() << "\" NumberOfCells=\"" << triangles << "\">\n"
        << "<PointData>\n";
    array(out, "Int64", "global_id", m_points, [&](std::size_t i) { return in_text(m_mesh.global_id(i)); });
    array(out, "Float64", "size", m_points, [&](std::size_t i) { return in_words(m_mesh.size(i)); });
    array(out, "Int32", "rank", m_points, [&](std::size_t i) { return in_text(m_mesh.owner(i)); });
    out << "</PointData>\n<CellData Scalars=\"q\">\n";
    std::vector<std::size_t> cells;
    for (std::size_t t = 0; t < triangles; ++t)
      cells.push_back(t);
    array(out, "Float64", "q", cells, [&](std::size_t t) { return in_words(quality(t)); });
    array(out, "Int32", "rank", cells, [&](std::size_t) { return in_text(m_mesh.rank()); });
    out << "</CellData>\n<Points>\n";
    array(out, "Float64\" NumberOfComponents=\"3", "Points", m_points, [&](std::size_t i) {
      const auto p = m_mesh.point(i);
      return in_words(CGAL::to_double(p.x())) + " " + in_words(CGAL::to_double(p.y())) + " 0";
    });
    out << "</Points>\n<Cells>\n";
    array(out, "Int64", "connectivity", cells, [&](std::size_t t) { return connectivity(t); });
    array(out, "Int64", "offsets", cells, [&](std::size_t t) { return in_text(3 * (t + 1)); });
    array(out, "UInt8", "types", cells, [](std::size_t) { return std::string("5"); }); // VTK_TRIANGLE
    out << "</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
  }

private:
  template <class Number>
  static std::string in_text(Number n)
  {
    return std::to_string(n);
  }

  void take(std::size_t i)
  {
    if (m_number[i] != -1)
      return;
    m_number[i] = static_cast<std::int64_t>(m_points.size());
    m_points.push_back(i);
  }

  double quality(std::size_t t) const
  {
    const auto& v = m_mesh.vertices(t);
    const auto point = [&](int k) { return m_mesh.point(static_cast<std::size_t>(v[k])); };
    return CGAL::to_double(CGAL::radius_ratio_2(point(0), point(1), point(2)));
  }

  std::string connectivity(std::size_t t) const
  {
    std::string text;
    for (auto v : m_mesh.vertices(t))
      text += (text.empty() ? "" : " ") + std::to_string(m_number[static_cast<std::size_t>(v)]);
    return text;
  }

  template <class Text>
  static void array(std::ostream& out, const char* type, const char* name,
                    const std::vector<std::size_t>& indices, const Text& text)
  {
    out << "<DataArray type=\"" << type << "\" Name=\"" << name << "\" format=\"ascii\">\n";
    for (std::size_t i : indices)
      out << text(i) << "\n";
    out << "</DataArray>\n";
  }

  const Mesh& m_mesh;
  std::vector<std::size_t> m_points;  // that are written
  std::vector<std::int64_t> m_number; // of each point, in the file
};

/// the file that names those of all ranks
inline void write_pvtu_header(std::ostream& out, const std::string& stem, int ranks)
{
  const std::string name = stem.substr(stem.find_last_of('/') + 1); // beside this file
  out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"PUnstructuredGrid\" version=\"1.0\" "
      << "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<PUnstructuredGrid GhostLevel=\"0\">\n"
      << "<PPointData>\n<PDataArray type=\"Int64\" Name=\"global_id\"/>\n"
      << "<PDataArray type=\"Float64\" Name=\"size\"/>\n<PDataArray type=\"Int32\" Name=\"rank\"/>\n"
      << "</PPointData>\n<PCellData Scalars=\"q\">\n<PDataArray type=\"Float64\" Name=\"q\"/>\n"
      << "<PDataArray type=\"Int32\" Name=\"rank\"/>\n</PCellData>\n<PPoints>\n"
      << "<PDataArray type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\"/>\n</PPoints>\n";
  for (int rank = 0; rank < ranks; ++rank)
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
