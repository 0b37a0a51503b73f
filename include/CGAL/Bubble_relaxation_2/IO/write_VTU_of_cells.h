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

#include <CGAL/Bubble_relaxation_2/internal/files/Vtu_file.h>
#include <CGAL/Bubble_relaxation_2/internal/files/write_file.h>
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

/// Markers as an array of VTK has them: numbers with digits behind the point stay as they are.
template <class Marker>
using Number_of_marker = std::conditional_t<std::is_floating_point<Marker>::value, double,
                                            std::conditional_t<(sizeof(Marker) > 4), std::int64_t, std::int32_t>>;

/// Writes the cells of a dual as unstructured grid of VTK: polygons, then the boundary parts as lines.
template <class Dual>
class Cell_writer_2
{
public:
  Cell_writer_2(std::ostream& out, const Dual& dual)
    : m_dual(dual), m_soup(dual.polygon_soup()),
      m_file(out, m_soup.points.size(), m_soup.polygons.size() + m_soup.segments.size())
  {}

  /// \param values of the cells, or none
  void write(const std::vector<double>& values)
  {
    using Marker = typename Dual::Marker;
    const auto none = [](const auto&) { return std::numeric_limits<double>::quiet_NaN(); }; // a line has no area
    m_file.data("CellData", values.empty() ? "area" : "value", [&] {
      if (!values.empty())
        array<double>("value", [&](std::size_t c) { return values[c]; }, none);
      array<double>("area", [&](std::size_t c) { return m_dual.cells()[c].area; }, none);
      array<std::int64_t>("cell", [](std::size_t c) { return c; }, [](const auto& part) { return part.cell; });
      array<std::int32_t>("dimension", [](std::size_t) { return 2; }, [](const auto&) { return 1; });
      if constexpr (std::is_arithmetic<Marker>::value || std::is_enum<Marker>::value)
        array<Number_of_marker<Marker>>("marker", [](std::size_t) { return 0; },
                                        [](const auto& part) { return part.marker; });
    });
    std::vector<double> coordinates;
    for (const auto& p : m_soup.points)
      coordinates.insert(coordinates.end(), {CGAL::to_double(p.x()), CGAL::to_double(p.y()), 0});
    m_file.points(coordinates);
    constexpr std::uint8_t polygon = 7, line = 3; // as VTK numbers them
    m_file.add_cells(m_soup.polygons, polygon);
    m_file.add_cells(m_soup.segments, line);
    m_file.end();
  }

private:
  template <class T, class Of_polygon, class Of_line>
  void array(const std::string& name, const Of_polygon& of_polygon, const Of_line& of_line)
  {
    std::vector<T> values;
    for (std::size_t cell : m_soup.cells)
      values.push_back(static_cast<T>(of_polygon(cell)));
    for (const auto& part : m_dual.boundary_parts())
      values.push_back(static_cast<T>(of_line(part)));
    m_file.array(name, values);
  }

  const Dual& m_dual;
  typename Dual::Polygon_soup m_soup;
  Vtu_file m_file;
};

/// \throws std::invalid_argument if there are values, but not as many as cells
template <class Dual>
void check_values_of_cells(const Dual& dual, const std::vector<double>& values)
{
  if (!values.empty() && values.size() != dual.cells().size())
    throw std::invalid_argument("Bubble_relaxation_2: parameter values: there are " + std::to_string(values.size()) +
                                " for " + std::to_string(dual.cells().size()) + " cells");
}

} // namespace Bubble_relaxation_2::internal

namespace IO {

/*!
\ingroup PkgBubbleRelaxation2FiniteVolumes

\brief writes the cells of a dual for ParaView, in VTK's format `.vtu`: polygons with common corners, and the boundary
parts as lines.

They have the cell data `area` (not a number for lines), `cell`, the number of the cell, `dimension` (2 for polygons, 1
for lines), and `marker` of lines, if `Marker` is a number or an enumeration.

\tparam Dual a `Voronoi_dual_2`
\param out the stream
\param dual the dual
\param values of the cells, such as a solution: the cell data `value`; none if it is empty

\returns whether it was written

\throws std::invalid_argument if there are values, but not as many as cells
*/
template <class Dual>
bool write_VTU_of_cells(std::ostream& out, const Dual& dual, const std::vector<double>& values = {})
{
  Bubble_relaxation_2::internal::check_values_of_cells(dual, values);
  Bubble_relaxation_2::internal::Cell_writer_2<Dual>(out, dual).write(values);
  return static_cast<bool>(out);
}

/*!
\ingroup PkgBubbleRelaxation2FiniteVolumes

\brief writes them to the file `name`.

\throws std::invalid_argument if there are values, but not as many as cells
\throws std::runtime_error with the name and the reason if it cannot be written; then it is not there
*/
template <class Dual>
void write_VTU_of_cells(const std::string& name, const Dual& dual, const std::vector<double>& values = {})
{
  Bubble_relaxation_2::internal::check_values_of_cells(dual, values);
  Bubble_relaxation_2::internal::write_file(name,
                                            [&](std::ostream& out) { write_VTU_of_cells(out, dual, values); });
}

} // namespace IO
} // namespace CGAL

#include <CGAL/Bubble_relaxation_2/internal/core/enable_warnings.h>

#endif // CGAL_BUBBLE_RELAXATION_2_IO_WRITE_VTU_OF_CELLS_H
