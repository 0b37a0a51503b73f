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

/// Writes the cells of a dual as MODFLOW has them. All that may be wrong is found before anything is written.
template <class Dual>
class Disv_writer_2
{
public:
  /// \throws std::invalid_argument as `write_DISV()` does
  template <class Top, class Bottom>
  Disv_writer_2(const Dual& dual, const Top& top, const Bottom& bottom, std::size_t number_of_layers)
    : m_dual(dual), m_soup(dual.polygon_soup()), m_number_of_layers(number_of_layers)
  {
    if (number_of_layers == 0)
      throw std::invalid_argument("Bubble_relaxation_2: parameter number_of_layers must be at least 1");
    check_cells_of_groundwater(dual, m_soup);
    m_tops = elevations_at_centers(dual, top, "top");
    m_bottoms = elevations_at_centers(dual, bottom, "bottom");
    for (std::size_t k = 0; k < m_tops.size(); ++k)
      if (!(m_tops[k] > m_bottoms[k]))
        throw std::invalid_argument("Bubble_relaxation_2: top is not above bottom at " +
                                    in_words(x(dual.cells()[k].center), y(dual.cells()[k].center)));
  }

  void write(std::ostream& out) const
  {
    const Plain_numbers plain(out);
    write_block(out, "OPTIONS", [] {});
    write_block(out, "DIMENSIONS", [&] {
      out << "  NLAY " << m_number_of_layers << "\n  NCPL " << m_soup.polygons.size() << "\n  NVERT "
          << m_soup.points.size() << '\n';
    });
    write_block(out, "GRIDDATA", [&] { write_elevations(out); });
    write_block(out, "VERTICES", [&] {
      for (std::size_t k = 0; k < m_soup.points.size(); ++k)
        out << "  " << k + 1 << ' ' << x(m_soup.points[k]) << ' ' << y(m_soup.points[k]) << '\n';
    });
    write_block(out, "CELL2D", [&] { write_cells(out); });
  }

private:
  template <class P>
  static double x(const P& p) { return CGAL::to_double(p.x()); }

  template <class P>
  static double y(const P& p) { return CGAL::to_double(p.y()); }

  /// `begin` and `end` of a block, with what is written between
  template <class Write>
  static void write_block(std::ostream& out, const char* name, const Write& write)
  {
    out << "BEGIN " << name << '\n';
    write();
    out << "END " << name << "\n\n";
  }

  static void write_array(std::ostream& out, const std::vector<double>& values)
  {
    out << "    INTERNAL FACTOR 1.0\n";
    for (double value : values)
      out << value << '\n';
  }

  void write_elevations(std::ostream& out) const
  {
    out << "  TOP\n";
    write_array(out, m_tops);
    out << "  BOTM LAYERED\n";
    for (std::size_t layer = 1; layer <= m_number_of_layers; ++layer) {
      const double share = double(layer) / double(m_number_of_layers);
      std::vector<double> of_layer;
      for (std::size_t k = 0; k < m_tops.size(); ++k)
        of_layer.push_back((1 - share) * m_tops[k] + share * m_bottoms[k]);
      write_array(out, of_layer);
    }
  }

  void write_cells(std::ostream& out) const
  {
    for (std::size_t k = 0; k < m_soup.polygons.size(); ++k) {
      const auto& center = m_dual.cells()[k].center;
      out << "  " << k + 1 << ' ' << x(center) << ' ' << y(center) << ' ' << m_soup.polygons[k].size();
      for (auto corner = m_soup.polygons[k].rbegin(); corner != m_soup.polygons[k].rend(); ++corner) // clockwise
        out << ' ' << *corner + 1;
      out << '\n';
    }
  }

  const Dual& m_dual;
  typename Dual::Polygon_soup m_soup;
  std::size_t m_number_of_layers;
  std::vector<double> m_tops, m_bottoms; // of the cells
};

} // namespace Bubble_relaxation_2::internal

namespace IO {

/*!
\ingroup PkgBubbleRelaxation2Files

writes the cells of a dual as input of MODFLOW 6, package DISV: a discretization of groundwater by vertices. Cells have
the numbers of `dual.cells()`, from 1 on, and their centres are the vertices of the mesh, so that lines of centres are
perpendicular to faces. The length of all coordinates is left undefined.

\tparam CDT, Marker see `Voronoi_dual_2`
\tparam Top, Bottom a number, or a function of points that returns one
\param out takes the file
\param dual the cells
\param top the elevation of the uppermost layer's top
\param bottom the elevation of the lowest layer's bottom
\param number_of_layers between them; all layers of a cell are equally thick

\returns whether it was written

\throws std::invalid_argument if a face has a negative length (see `Voronoi_quality_2`), if the domain touches itself in
a vertex, if `number_of_layers` is 0, or if `top` is not above `bottom` in the centre of a cell, or not finite
*/
template <class CDT, class Marker, class Top, class Bottom>
bool write_DISV(std::ostream& out, const Voronoi_dual_2<CDT, Marker>& dual, const Top& top, const Bottom& bottom,
                std::size_t number_of_layers = 1)
{
  using Writer = Bubble_relaxation_2::internal::Disv_writer_2<Voronoi_dual_2<CDT, Marker>>;
  Writer(dual, top, bottom, number_of_layers).write(out);
  return static_cast<bool>(out);
}

/*!
\ingroup PkgBubbleRelaxation2Files

writes them to the file `name`.

\throws std::invalid_argument as above; then nothing is done to the file
\throws std::runtime_error with the name and the reason if it cannot be written; then it is not there
*/
template <class CDT, class Marker, class Top, class Bottom>
void write_DISV(const std::string& name, const Voronoi_dual_2<CDT, Marker>& dual, const Top& top, const Bottom& bottom,
                std::size_t number_of_layers = 1)
{
  using namespace Bubble_relaxation_2::internal;
  const Disv_writer_2<Voronoi_dual_2<CDT, Marker>> writer(dual, top, bottom, number_of_layers);
  write_file(name, [&writer](std::ostream& out) { writer.write(out); });
}

} // namespace IO
} // namespace CGAL

#include <CGAL/Bubble_relaxation_2/internal/core/enable_warnings.h>

#endif // CGAL_BUBBLE_RELAXATION_2_IO_DISV_H
