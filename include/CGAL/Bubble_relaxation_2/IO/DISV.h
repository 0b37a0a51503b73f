// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_IO_DISV_H
#define CGAL_BUBBLE_RELAXATION_2_IO_DISV_H

#include <CGAL/license/Bubble_relaxation_2.h>

#include <CGAL/Bubble_relaxation_2/internal/core/disable_warnings.h>

#include <CGAL/Bubble_relaxation_2/internal/core/in_words.h>
#include <CGAL/Bubble_relaxation_2/internal/files/write_file.h>
#include <CGAL/Voronoi_dual_2.h>

#include <CGAL/number_utils.h>

#include <cmath>
#include <cstddef>
#include <ostream>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2::internal {

/// the elevations of a function of places, or a number, at the centres of the cells
template <class Dual, class Elevation>
std::vector<double> elevations_at_centers(const Dual& dual, const Elevation& elevation, const char* name)
{
  std::vector<double> result;
  for (const auto& cell : dual.cells()) {
    if constexpr (std::is_invocable<const Elevation&, const typename Dual::Point_2&>::value)
      result.push_back(CGAL::to_double(elevation(cell.center)));
    else
      result.push_back(CGAL::to_double(elevation));
    if (!std::isfinite(result.back()))
      throw std::invalid_argument(std::string("Bubble_relaxation_2: parameter ") + name + " is not finite at " +
                                  in_words(CGAL::to_double(cell.center.x()), CGAL::to_double(cell.center.y())));
  }
  return result;
}

/// \throws std::invalid_argument if the cells are no polygons as MODFLOW needs them
template <class Dual>
void check_cells_of_groundwater(const Dual& dual, const typename Dual::Polygon_soup& soup)
{
  const auto& q = dual.quality();
  if (q.number_of_negative_faces > 0)
    throw std::invalid_argument("Bubble_relaxation_2: " + std::to_string(q.number_of_negative_faces) +
                                " faces of cells have negative lengths, the worst across the edge with the midpoint " +
                                in_words(q.smallest_face_x, q.smallest_face_y) + ", so cells are no polygons");
  for (std::size_t k = 1; k < soup.cells.size(); ++k)
    if (soup.cells[k] == soup.cells[k - 1]) {
      const auto& p = dual.cells()[soup.cells[k]].center;
      throw std::invalid_argument("Bubble_relaxation_2: the domain touches itself at " +
                                  in_words(CGAL::to_double(p.x()), CGAL::to_double(p.y())) +
                                  ", so a cell has two polygons");
    }
}

/// `begin` and `end` of a block, with what is written between
template <class Write>
void write_block(std::ostream& out, const char* name, const Write& write)
{
  out << "BEGIN " << name << '\n';
  write();
  out << "END " << name << "\n\n";
}

inline void write_array(std::ostream& out, const std::vector<double>& values)
{
  out << "    INTERNAL FACTOR 1.0\n";
  for (double value : values)
    out << value << '\n';
}

} // namespace Bubble_relaxation_2::internal

namespace IO {

/*!
\ingroup PkgBubbleRelaxation2Files

writes the cells of a dual as input of MODFLOW 6, package DISV: a discretization of groundwater by vertices. Cells have
the numbers of `dual.cells()`, from 1 on, and their centres are the vertices of the mesh, so that lines of centres are
perpendicular to faces. The length of all coordinates is left undefined.

\tparam CDT, Marker see `Voronoi_dual_2`
\tparam Top, Bottom a number, or a function of points that returns one
\param top the elevation of the uppermost layer's top
\param bottom the elevation of the lowest layer's bottom
\param number_of_layers between them; all layers of a cell are equally thick

\throws std::invalid_argument if a face has a negative length (see `Voronoi_quality_2`), if the domain touches itself in
a vertex, if `number_of_layers` is 0, or if `top` is not above `bottom` in the centre of a cell, or not finite
*/
template <class CDT, class Marker, class Top, class Bottom>
void write_DISV(std::ostream& out, const Voronoi_dual_2<CDT, Marker>& dual, const Top& top, const Bottom& bottom,
                std::size_t number_of_layers = 1)
{
  using namespace Bubble_relaxation_2::internal;
  if (number_of_layers == 0)
    throw std::invalid_argument("Bubble_relaxation_2: parameter number_of_layers must be at least 1");
  const auto soup = dual.polygon_soup();
  check_cells_of_groundwater(dual, soup);
  const std::vector<double> tops = elevations_at_centers(dual, top, "top"),
                            bottoms = elevations_at_centers(dual, bottom, "bottom");
  const auto x = [](const auto& p) { return CGAL::to_double(p.x()); };
  const auto y = [](const auto& p) { return CGAL::to_double(p.y()); };
  for (std::size_t k = 0; k < tops.size(); ++k)
    if (!(tops[k] > bottoms[k]))
      throw std::invalid_argument("Bubble_relaxation_2: top is not above bottom at " +
                                  in_words(x(dual.cells()[k].center), y(dual.cells()[k].center)));
  const Plain_numbers plain(out);
  write_block(out, "OPTIONS", [] {});
  write_block(out, "DIMENSIONS", [&] {
    out << "  NLAY " << number_of_layers << "\n  NCPL " << soup.polygons.size() << "\n  NVERT " << soup.points.size()
        << '\n';
  });
  write_block(out, "GRIDDATA", [&] {
    out << "  TOP\n";
    write_array(out, tops);
    out << "  BOTM LAYERED\n";
    for (std::size_t layer = 1; layer <= number_of_layers; ++layer) {
      const double share = double(layer) / double(number_of_layers);
      std::vector<double> of_layer;
      for (std::size_t k = 0; k < tops.size(); ++k)
        of_layer.push_back((1 - share) * tops[k] + share * bottoms[k]);
      write_array(out, of_layer);
    }
  });
  write_block(out, "VERTICES", [&] {
    for (std::size_t k = 0; k < soup.points.size(); ++k)
      out << "  " << k + 1 << ' ' << x(soup.points[k]) << ' ' << y(soup.points[k]) << '\n';
  });
  write_block(out, "CELL2D", [&] {
    for (std::size_t k = 0; k < soup.polygons.size(); ++k) {
      const auto& center = dual.cells()[k].center;
      out << "  " << k + 1 << ' ' << x(center) << ' ' << y(center) << ' ' << soup.polygons[k].size();
      for (auto corner = soup.polygons[k].rbegin(); corner != soup.polygons[k].rend(); ++corner) // clockwise
        out << ' ' << *corner + 1;
      out << '\n';
    }
  });
}

/*!
\ingroup PkgBubbleRelaxation2Files

writes them to the file `name`.

\throws std::runtime_error with the name and the reason if it cannot be written; then it is not there
*/
template <class CDT, class Marker, class Top, class Bottom>
void write_DISV(const std::string& name, const Voronoi_dual_2<CDT, Marker>& dual, const Top& top, const Bottom& bottom,
                std::size_t number_of_layers = 1)
{
  Bubble_relaxation_2::internal::write_file(
    name, [&](std::ostream& out) { write_DISV(out, dual, top, bottom, number_of_layers); });
}

} // namespace IO
} // namespace CGAL

#include <CGAL/Bubble_relaxation_2/internal/core/enable_warnings.h>

#endif // CGAL_BUBBLE_RELAXATION_2_IO_DISV_H
