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

#include <CGAL/Bubble_relaxation_2/internal/files/in_xml.h>
#include <CGAL/Bubble_relaxation_2/internal/files/write_file.h>
#include <CGAL/Mesh_arrays_2.h>
#include <CGAL/radius_ratio_2.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <ostream>
#include <string>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2::internal {

/// that of this machine, in the words of VTK
inline const char* byte_order()
{
  const std::uint16_t one = 1;
  return *reinterpret_cast<const unsigned char*>(&one) == 1 ? "LittleEndian" : "BigEndian";
}

/// Writes arrays in base64, in lines of XML that any reader takes.
class Vtu_writer
{
public:
  Vtu_writer(std::ostream& out, const Mesh_arrays_2& mesh) : m_out(out), m_mesh(mesh) {}

  void write()
  {
    m_out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"" << byte_order()
          << "\" header_type=\"UInt64\">\n"
          << "<UnstructuredGrid>\n<Piece NumberOfPoints=\"" << m_mesh.points.size() << "\" NumberOfCells=\""
          << m_mesh.triangles.size() + m_mesh.edges.size() << "\">\n";
    write_point_data();
    write_cell_data();
    write_points();
    write_cells();
    m_out << "</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
  }

private:
  static_assert(sizeof(int) == 4 && sizeof(double) == 8, "the types of the arrays are Int32 and Float64");

  void write_point_data()
  {
    m_out << "<PointData>\n";
    array("Int32", "marker", m_mesh.vertex_markers);
    for (const auto& data : m_mesh.vertex_data)
      array("Float64", data.first, data.second);
    m_out << "</PointData>\n";
  }

  void write_cell_data()
  {
    const std::size_t triangles = m_mesh.triangles.size(), cells = triangles + m_mesh.edges.size();
    std::vector<double> q;
    for (const auto& t : m_mesh.triangles)
      q.push_back(CGAL::radius_ratio_2(m_mesh.points[t[0]], m_mesh.points[t[1]], m_mesh.points[t[2]]));
    q.resize(cells, std::numeric_limits<double>::quiet_NaN()); // a line has none
    std::vector<int> dimension(triangles, 2), marker(triangles, 0);
    dimension.resize(cells, 1);
    marker.insert(marker.end(), m_mesh.edge_markers.begin(), m_mesh.edge_markers.end());
    m_out << "<CellData Scalars=\"q\">\n";
    array("Float64", "q", q);
    array("Int32", "dimension", dimension);
    array("Int32", "marker", marker);
    const auto of_triangles = [&](const std::string& name, std::vector<double> values) {
      values.resize(cells, std::numeric_limits<double>::quiet_NaN());
      array("Float64", name, values);
    };
    if (!m_mesh.regions.empty())
      of_triangles("region", m_mesh.regions);
    for (const auto& data : m_mesh.triangle_data)
      of_triangles(data.first, data.second);
    m_out << "</CellData>\n";
  }

  void write_points()
  {
    std::vector<double> coordinates;
    for (std::size_t k = 0; k < m_mesh.points.size(); ++k)
      coordinates.insert(coordinates.end(), {m_mesh.points[k].x(), m_mesh.points[k].y(),
                                             m_mesh.elevations.empty() ? 0 : m_mesh.elevations[k]});
    m_out << "<Points>\n";
    array("Float64", "Points", coordinates, 3);
    m_out << "</Points>\n";
  }

  void write_cells()
  {
    std::vector<std::int64_t> connectivity, offsets;
    std::vector<std::uint8_t> types;
    const auto add = [&](const auto& cells, std::uint8_t type) {
      for (const auto& cell : cells) {
        connectivity.insert(connectivity.end(), cell.begin(), cell.end());
        offsets.push_back(static_cast<std::int64_t>(connectivity.size()));
        types.push_back(type);
      }
    };
    add(m_mesh.triangles, 5); // VTK_TRIANGLE
    add(m_mesh.edges, 3);     // VTK_LINE
    m_out << "<Cells>\n";
    array("Int64", "connectivity", connectivity);
    array("Int64", "offsets", offsets);
    array("UInt8", "types", types);
    m_out << "</Cells>\n";
  }

  template <class T>
  void array(const char* type, const std::string& name, const std::vector<T>& values, int components = 1)
  {
    m_out << "<DataArray type=\"" << type << "\" Name=\"" << in_xml(name);
    if (components > 1)
      m_out << "\" NumberOfComponents=\"" << components;
    m_out << "\" format=\"binary\">";
    const std::uint64_t size = values.size() * sizeof(T);
    std::string bytes(reinterpret_cast<const char*>(&size), sizeof(size));
    bytes.append(reinterpret_cast<const char*>(values.data()), size);
    write_base64(bytes);
    m_out << "</DataArray>\n";
  }

  void write_base64(const std::string& bytes)
  {
    static const char* const digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    const auto byte = [&](std::size_t k) -> unsigned {
      return k < bytes.size() ? static_cast<unsigned char>(bytes[k]) : 0;
    };
    std::string text;
    for (std::size_t k = 0; k < bytes.size(); k += 3) {
      const unsigned three = byte(k) << 16 | byte(k + 1) << 8 | byte(k + 2);
      text += digits[three >> 18];
      text += digits[three >> 12 & 63];
      text += k + 1 < bytes.size() ? digits[three >> 6 & 63] : '=';
      text += k + 2 < bytes.size() ? digits[three & 63] : '=';
    }
    m_out << text;
  }

  std::ostream& m_out;
  const Mesh_arrays_2& m_mesh;
};

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
*/
inline void write_VTU(std::ostream& out, const Mesh_arrays_2& mesh)
{
  mesh.check();
  const Bubble_relaxation_2::internal::Plain_numbers plain(out);
  Bubble_relaxation_2::internal::Vtu_writer(out, mesh).write();
}

/*!
\ingroup PkgBubbleRelaxation2Files

writes a mesh to the file `name`.

\throws std::runtime_error with the name and the reason if it cannot be written; then it is not there
*/
inline void write_VTU(const std::string& name, const Mesh_arrays_2& mesh)
{
  mesh.check();
  Bubble_relaxation_2::internal::write_file(name, [&mesh](std::ostream& out) { write_VTU(out, mesh); });
}

} // namespace IO
} // namespace CGAL

#include <CGAL/Bubble_relaxation_2/internal/core/enable_warnings.h>

#endif // CGAL_BUBBLE_RELAXATION_2_IO_VTU_H
