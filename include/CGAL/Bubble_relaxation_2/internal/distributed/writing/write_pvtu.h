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
#include <CGAL/Bubble_relaxation_2/internal/core/vocabulary.h>
#include <CGAL/Bubble_relaxation_2/internal/files/in_xml.h>
#include <CGAL/Bubble_relaxation_2/internal/files/write_file.h>

#include <CGAL/radius_ratio_2.h>

#include <cstddef>
#include <cstdint>
#include <functional>
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

inline std::string vtu_path(const std::string& stem, int rank)
{
  return stem + "_" + std::to_string(rank) + ".vtu";
}

/// Writes one rank's triangles for ParaView, with the points that they need, and the sides on constraints as lines.
template <class Mesh>
class Vtu_piece_2
{
public:
  /// `of_points`, `of_triangles`: names and values of the user's
  template <class Data>
  Vtu_piece_2(const Mesh& mesh, const Data& of_points, const Data& of_triangles)
    : m_mesh(mesh), m_number(mesh.number_of_points(), -1)
  {
    for (std::size_t i = 0; i < mesh.number_of_owned_points(); ++i)
      take(i);
    for (std::size_t t = 0; t < mesh.number_of_owned_triangles(); ++t)
      for (auto v : mesh.vertices(t))
        take(static_cast<std::size_t>(v));
    find_lines();
    for (std::size_t c = 0; c < mesh.number_of_owned_triangles() + m_lines.size(); ++c)
      m_cells.push_back(c);
    add_data_of_points();
    add_data_of_cells();
    for (const auto& data : of_points)
      m_of_points.push_back({"Float64", data.name, [&data](std::size_t i) { return in_words(data.value(i)); }});
    for (const auto& data : of_triangles)
      add_of_triangles("Float64", data.name, [&data](std::size_t t) { return in_words(data.value(t)); });
  }

  /// of what has to be the same on all ranks
  std::uint64_t hash_of_names() const
  {
    std::uint64_t hash = 0;
    for (const auto* arrays : {&m_of_points, &m_of_cells})
      for (const Array& a : *arrays) {
        for (char c : a.name)
          hash = hash_of_two(hash, static_cast<unsigned char>(c));
        hash = hash_of_two(hash, 256); // a name ends
      }
    return hash;
  }

  void write(std::ostream& out) const
  {
    out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
        << "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<UnstructuredGrid>\n"
        << "<Piece NumberOfPoints=\"" << m_points.size() << "\" NumberOfCells=\"" << m_cells.size() << "\">\n"
        << "<PointData>\n";
    for (const Array& a : m_of_points)
      array(out, a.type, a.name, m_points, a.text);
    out << "</PointData>\n<CellData Scalars=\"q\">\n";
    for (const Array& a : m_of_cells)
      array(out, a.type, a.name, m_cells, a.text);
    out << "</CellData>\n<Points>\n";
    array(out, "Float64\" NumberOfComponents=\"3", "Points", m_points, [&](std::size_t i) {
      const auto p = m_mesh.point(i);
      return in_words(CGAL::to_double(p.x())) + " " + in_words(CGAL::to_double(p.y())) + " 0";
    });
    out << "</Points>\n<Cells>\n";
    const std::size_t triangles = m_mesh.number_of_owned_triangles();
    array(out, "Int64", "connectivity", m_cells, [&](std::size_t c) { return connectivity(c); });
    array(out, "Int64", "offsets", m_cells, [&](std::size_t c) {
      return in_text(c < triangles ? 3 * (c + 1) : 3 * triangles + 2 * (c + 1 - triangles));
    });
    array(out, "UInt8", "types", m_cells, // VTK_TRIANGLE, VTK_LINE
          [&](std::size_t c) { return std::string(is_triangle(c) ? "5" : "3"); });
    out << "</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
  }

  /// the file that names those of all ranks
  void write_header(std::ostream& out, const std::string& stem) const
  {
    const std::string name = stem.substr(stem.find_last_of('/') + 1); // beside this file
    out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"PUnstructuredGrid\" version=\"1.0\" "
        << "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<PUnstructuredGrid GhostLevel=\"0\">\n<PPointData>\n";
    for (const Array& a : m_of_points)
      out << "<PDataArray type=\"" << a.type << "\" Name=\"" << in_xml(a.name) << "\"/>\n";
    out << "</PPointData>\n<PCellData Scalars=\"q\">\n";
    for (const Array& a : m_of_cells)
      out << "<PDataArray type=\"" << a.type << "\" Name=\"" << in_xml(a.name) << "\"/>\n";
    out << "</PCellData>\n<PPoints>\n"
        << "<PDataArray type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\"/>\n</PPoints>\n";
    for (int rank = 0; rank < m_mesh.number_of_ranks(); ++rank)
      out << "<Piece Source=\"" << in_xml(vtu_path(name, rank)) << "\"/>\n";
    out << "</PUnstructuredGrid>\n</VTKFile>\n";
  }

private:
  using Text = std::function<std::string(std::size_t)>;

  /// what is told of each point, or each cell
  struct Array
  {
    const char* type;
    std::string name;
    Text text;
  };

  /// a side of a triangle, by the number of the vertex opposite to it
  struct Line
  {
    std::size_t triangle;
    int i;
  };

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

  std::size_t end(const Line& l, int turn) const
  {
    return static_cast<std::size_t>(m_mesh.vertices(l.triangle)[static_cast<std::size_t>((l.i + turn) % 3)]);
  }

  /// A line is of the rank that owns its end with the smaller id: that knows both triangles.
  void find_lines()
  {
    std::set<std::pair<std::size_t, std::size_t>> known;
    for (std::size_t t = 0; t < m_mesh.number_of_triangles(); ++t)
      for (int i = 0; i < 3; ++i) {
        if (!m_mesh.is_constrained(t, i))
          continue;
        std::size_t a = end({t, i}, 1), b = end({t, i}, 2);
        if (m_mesh.global_id(b) < m_mesh.global_id(a))
          std::swap(a, b);
        if (m_mesh.is_ghost(a) || !known.insert({a, b}).second)
          continue;
        m_lines.push_back({t, i});
        take(a);
        take(b);
      }
  }

  bool is_triangle(std::size_t cell) const { return cell < m_mesh.number_of_owned_triangles(); }

  const Line& line(std::size_t cell) const { return m_lines[cell - m_mesh.number_of_owned_triangles()]; }

  void add_data_of_points()
  {
    m_of_points.push_back({"Int64", "global_id", [this](std::size_t i) { return in_text(m_mesh.global_id(i)); }});
    m_of_points.push_back({"Float64", "size", [this](std::size_t i) { return in_words(m_mesh.size(i)); }});
    m_of_points.push_back({"Int32", "rank", [this](std::size_t i) { return in_text(m_mesh.owner(i)); }});
  }

  void add_data_of_cells()
  {
    add_of_triangles("Float64", "q", [this](std::size_t t) { return in_words(quality(t)); });
    m_of_cells.push_back({"Int32", "rank", [this](std::size_t) { return in_text(m_mesh.rank()); }});
    m_of_cells.push_back({"Int32", "dimension", [this](std::size_t c) { return in_text(is_triangle(c) ? 2 : 1); }});
    if constexpr (std::is_arithmetic<typename Mesh::Marker>::value || std::is_enum<typename Mesh::Marker>::value)
      if (m_mesh.has_markers())
        m_of_cells.push_back({"Float64", "marker", [this](std::size_t c) {
          return is_triangle(c) ? "0" : in_words(static_cast<double>(m_mesh.marker(line(c).triangle, line(c).i)));
        }});
    if constexpr (std::is_arithmetic<typename Mesh::Region>::value || std::is_enum<typename Mesh::Region>::value)
      if (m_mesh.has_regions())
        add_of_triangles("Float64", "region",
                         [this](std::size_t t) { return in_words(static_cast<double>(m_mesh.region(t))); });
  }

  /// lines have none
  void add_of_triangles(const char* type, const std::string& name, const Text& text)
  {
    m_of_cells.push_back({type, name, [this, text](std::size_t c) { return is_triangle(c) ? text(c) : "nan"; }});
  }

  double quality(std::size_t t) const
  {
    const auto& v = m_mesh.vertices(t);
    const auto point = [&](std::size_t k) { return m_mesh.point(static_cast<std::size_t>(v[k])); };
    return CGAL::to_double(CGAL::radius_ratio_2(point(0), point(1), point(2)));
  }

  std::string connectivity(std::size_t c) const
  {
    if (!is_triangle(c))
      return in_text(m_number[end(line(c), 1)]) + " " + in_text(m_number[end(line(c), 2)]);
    std::string text;
    for (auto v : m_mesh.vertices(c))
      text += (text.empty() ? "" : " ") + std::to_string(m_number[static_cast<std::size_t>(v)]);
    return text;
  }

  template <class Text_of>
  static void array(std::ostream& out, const std::string& type, const std::string& name,
                    const std::vector<std::size_t>& indices, const Text_of& text)
  {
    out << "<DataArray type=\"" << type << "\" Name=\"" << in_xml(name) << "\" format=\"ascii\">\n";
    for (std::size_t i : indices)
      out << text(i) << "\n";
    out << "</DataArray>\n";
  }

  const Mesh& m_mesh;
  std::vector<std::size_t> m_points;  // that are written
  std::vector<std::int64_t> m_number; // of each point, in the file
  std::vector<Line> m_lines;
  std::vector<std::size_t> m_cells;   // triangles, then lines
  std::vector<Array> m_of_points, m_of_cells;
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_WRITING_WRITE_PVTU_H
