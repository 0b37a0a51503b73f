// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_IO_WRITE_VTU_OF_CELLS_H
#define CGAL_BUBBLE_RELAXATION_2_IO_WRITE_VTU_OF_CELLS_H

#include <CGAL/license/Bubble_relaxation_2.h>

#include <CGAL/Bubble_relaxation_2/internal/core/disable_warnings.h>

#include <CGAL/Voronoi_dual_2.h>

#include <CGAL/number_utils.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <ostream>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2::internal {

/// Writes the cells of a dual as unstructured grid of VTK.
template <class Dual>
class Cell_writer_2
{
public:
  Cell_writer_2(std::ostream& out, const Dual& dual, const std::vector<double>& values)
    : m_out(out), m_dual(dual), m_values(values), m_soup(dual.polygon_soup())
  {}

  void write() const
  {
    const std::uint16_t one = 1;
    const bool is_little = *reinterpret_cast<const unsigned char*>(&one) == 1;
    m_out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\""
          << (is_little ? "Little" : "Big") << "Endian\" header_type=\"UInt64\">\n"
          << "<UnstructuredGrid>\n<Piece NumberOfPoints=\"" << m_soup.points.size() << "\" NumberOfCells=\""
          << m_soup.polygons.size() + m_soup.segments.size() << "\">\n";
    write_data();
    write_points();
    write_cells();
    m_out << "</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
  }

private:
  static constexpr bool has_numbers =
    std::is_arithmetic<typename Dual::Marker>::value || std::is_enum<typename Dual::Marker>::value;

  /// an array of values of the polygons, then of the segments
  template <class T, class Of_polygon, class Of_segment>
  void write_data(const char* type, const char* name, const Of_polygon& of_polygon, const Of_segment& of_segment) const
  {
    std::vector<T> values;
    for (std::size_t cell : m_soup.cells)
      values.push_back(of_polygon(cell));
    for (const auto& part : m_dual.boundary_parts())
      values.push_back(of_segment(part));
    write_array(type, name, values);
  }

  void write_data() const
  {
    const auto none = [](const auto&) { return std::numeric_limits<double>::quiet_NaN(); }; // a line has no area
    m_out << "<CellData Scalars=\"" << (m_values.empty() ? "area" : "value") << "\">\n";
    if (!m_values.empty())
      write_data<double>("Float64", "value", [&](std::size_t c) { return m_values[c]; }, none);
    write_data<double>("Float64", "area", [&](std::size_t c) { return m_dual.cells()[c].area; }, none);
    write_data<std::int64_t>(
      "Int64", "cell", [](std::size_t c) { return static_cast<std::int64_t>(c); },
      [](const auto& part) { return static_cast<std::int64_t>(part.cell); });
    write_data<std::int32_t>("Int32", "dimension", [](std::size_t) { return 2; }, [](const auto&) { return 1; });
    if constexpr (has_numbers)
      write_data<std::int32_t>(
        "Int32", "marker", [](std::size_t) { return 0; },
        [](const auto& part) { return static_cast<std::int32_t>(part.marker); });
    m_out << "</CellData>\n";
  }

  void write_points() const
  {
    std::vector<double> coordinates;
    for (const auto& p : m_soup.points)
      coordinates.insert(coordinates.end(), {CGAL::to_double(p.x()), CGAL::to_double(p.y()), 0});
    m_out << "<Points>\n";
    write_array("Float64", "Points\" NumberOfComponents=\"3", coordinates);
    m_out << "</Points>\n";
  }

  void write_cells() const
  {
    std::vector<std::int64_t> connectivity, offsets;
    std::vector<std::uint8_t> types;
    const auto add = [&](const auto& all, std::uint8_t type) {
      for (const auto& corners : all) {
        for (std::size_t corner : corners)
          connectivity.push_back(static_cast<std::int64_t>(corner));
        offsets.push_back(static_cast<std::int64_t>(connectivity.size()));
        types.push_back(type);
      }
    };
    add(m_soup.polygons, 7); // VTK_POLYGON
    add(m_soup.segments, 3); // VTK_LINE
    m_out << "<Cells>\n";
    write_array("Int64", "connectivity", connectivity);
    write_array("Int64", "offsets", offsets);
    write_array("UInt8", "types", types);
    m_out << "</Cells>\n";
  }

  template <class T>
  void write_array(const char* type, const char* name, const std::vector<T>& values) const
  {
    const std::uint64_t size = values.size() * sizeof(T);
    std::string bytes(reinterpret_cast<const char*>(&size), sizeof(size));
    bytes.append(reinterpret_cast<const char*>(values.data()), size);
    m_out << "<DataArray type=\"" << type << "\" Name=\"" << name << "\" format=\"binary\">" << base64(bytes)
          << "</DataArray>\n";
  }

  static std::string base64(const std::string& bytes)
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
    return text;
  }

  std::ostream& m_out;
  const Dual& m_dual;
  const std::vector<double>& m_values;
  typename Dual::Polygon_soup m_soup;
};

} // namespace Bubble_relaxation_2::internal

namespace IO {

/*!
\ingroup PkgBubbleRelaxation2FiniteVolumes

\brief writes the cells of a dual for ParaView, in VTK's format `.vtu`: polygons with common corners, and the boundary
parts as lines.

They have the cell data `area` (not a number for lines), `cell`, the number of the cell, `dimension` (2 for polygons, 1
for lines), and `marker` of lines, if `Marker` is a number or an enumeration.

\tparam Dual a `Voronoi_dual_2`
\param out the stream, opened as `std::ios::binary` where that matters
\param dual the dual
\param values of the cells, such as a solution: the cell data `value`; none if it is empty

\returns whether it was written

\throws std::invalid_argument if there are values, but not as many as cells
*/
template <class Dual>
bool write_VTU_of_cells(std::ostream& out, const Dual& dual, const std::vector<double>& values = {})
{
  if (!values.empty() && values.size() != dual.cells().size())
    throw std::invalid_argument("Bubble_relaxation_2: parameter values: there are " + std::to_string(values.size()) +
                                " for " + std::to_string(dual.cells().size()) + " cells");
  Bubble_relaxation_2::internal::Cell_writer_2<Dual>(out, dual, values).write();
  return static_cast<bool>(out);
}

} // namespace IO
} // namespace CGAL

#include <CGAL/Bubble_relaxation_2/internal/core/enable_warnings.h>

#endif // CGAL_BUBBLE_RELAXATION_2_IO_WRITE_VTU_OF_CELLS_H
