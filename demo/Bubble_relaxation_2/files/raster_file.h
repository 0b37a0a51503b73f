// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef BUBBLE_RELAXATION_2_DEMO_RASTER_FILE_H
#define BUBBLE_RELAXATION_2_DEMO_RASTER_FILE_H

#include "domain.h"
#include "map_projection.h"

#include <gdal_priv.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

/// The first band of a raster, as far as a domain needs it: linear between the centres of its cells, and where those around
/// have no value that of the nearest cell with one, since rasters of a sea are often empty on land. May be asked by several
/// threads.
class Raster
{
public:
  /// \throws std::runtime_error with the name and the reason
  Raster(const std::string& name, const Domain& domain)
  try : m_file((GDALAllRegister(), GDALDataset::Open(name.c_str(), GDAL_OF_RASTER | GDAL_OF_VERBOSE_ERROR))) {
    if (!m_file || m_file->GetRasterCount() == 0)
      throw std::runtime_error(m_file ? "has no band; subdatasets have names of their own, which gdalinfo tells"
                                      : "cannot be opened: " + Quiet_gdal::reason());
    std::array<double, 6> to_map;
    if (m_file->GetGeoTransform(to_map.data()) != CE_None || !GDALInvGeoTransform(to_map.data(), m_to_cells.data()))
      throw std::runtime_error("does not tell where its cells are");
    if (!domain.crs.empty()) { // a raster that does not tell its system has that of the domain's file
      const OGRSpatialReference* system = m_file->GetSpatialRef();
      OGRSpatialReference own = system != nullptr ? *system : reference_system("--crs", domain.crs_of_file),
                          of_domain = reference_system("--crs", domain.crs);
      own.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
      if (!own.IsSame(&of_domain))
        m_projection = projection(of_domain, own);
    }
    read_cells(domain);
    find_nearest();
    m_file.reset();
  } catch (const std::exception& e) {
    throw std::runtime_error("--raster: " + name + ": " + e.what());
  }

  /// what to say if there is no value at vertices of the domain; empty if there is one at all
  std::string warning(const Domain& domain) const
  {
    std::size_t empty = 0;
    double farthest = 0;
    Point there;
    for (CDT::Vertex_handle v : domain.cdt.finite_vertex_handles()) {
      const std::array<int, 2> cell = cell_at(in_cells(v->point().x(), v->point().y(), m_projection.get()));
      if (!std::isnan(m_cells[number(cell)]))
        continue;
      ++empty;
      const std::size_t nearest = m_nearest[number(cell)];
      const double far = std::hypot(static_cast<int>(nearest % width()) - cell[0], static_cast<int>(nearest / width()) - cell[1]);
      if (far > farthest || (far == farthest && v->point() < there)) {
        farthest = far;
        there = v->point();
      }
    }
    return empty == 0 ? ""
                      : "no value at " + std::to_string(empty) + " of the domain's vertices; what is nearest is " +
                          "taken, at " + to_string(there) + " from " + std::to_string(std::lround(farthest)) + " cells away";
  }

  /// \throws std::runtime_error outside of the raster
  double operator()(double x, double y) const
  {
    const std::array<double, 2> cell = in_cells(x, y, my_projection());
    std::array<int, 2> first;
    std::array<double, 2> share; // of the cells after the first ones
    for (std::size_t c = 0; c < 2; ++c) {
      const double at = cell[c] - m_begin[c] - 0.5;
      if (!(at >= -0.5 && at <= m_size[c] - 0.5))
        throw std::runtime_error("--raster: there is no value at " + to_string(Point(x, y)));
      first[c] = static_cast<int>(std::floor(at));
      share[c] = at - first[c];
    }
    double sum = 0, weights = 0;
    for (int k = 0; k < 4; ++k) {
      const double weight = (k % 2 ? share[0] : 1 - share[0]) * (k / 2 ? share[1] : 1 - share[1]);
      const int i = std::clamp(first[0] + k % 2, 0, m_size[0] - 1), j = std::clamp(first[1] + k / 2, 0, m_size[1] - 1);
      const double value = m_cells[number({i, j})];
      if (std::isnan(value))
        continue;
      sum += weight * value;
      weights += weight;
    }
    return weights > 0 ? sum / weights : m_cells[m_nearest[number(cell_at(cell))]];
  }

private:
  /// what the domain's box needs, and a few cells more
  void read_cells(const Domain& domain)
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    std::array<double, 2> low{infinity, infinity}, high{-infinity, -infinity};
    for (CDT::Vertex_handle v : domain.cdt.finite_vertex_handles()) {
      const std::array<double, 2> cell = in_cells(v->point().x(), v->point().y(), m_projection.get());
      for (std::size_t c = 0; c < 2; ++c) {
        low[c] = (std::min)(low[c], cell[c]);
        high[c] = (std::max)(high[c], cell[c]);
      }
    }
    const std::array<int, 2> all{m_file->GetRasterXSize(), m_file->GetRasterYSize()};
    for (std::size_t c = 0; c < 2; ++c) { // straight lines between vertices are curved in another projection
      const double margin = 3 + 0.1 * (high[c] - low[c]);
      m_begin[c] = static_cast<int>(std::clamp(std::floor(low[c] - margin), 0., 1. * all[c]));
      m_size[c] = static_cast<int>(std::clamp(std::ceil(high[c] + margin), 0., 1. * all[c])) - m_begin[c];
      if (m_size[c] <= 0)
        throw std::runtime_error("has no cells where the domain is");
    }
    GDALRasterBand& band = *m_file->GetRasterBand(1);
    m_cells.resize(static_cast<std::size_t>(m_size[0]) * static_cast<std::size_t>(m_size[1]));
    if (band.RasterIO(GF_Read, m_begin[0], m_begin[1], m_size[0], m_size[1], m_cells.data(), m_size[0], m_size[1],
                      GDT_Float64, 0, 0, nullptr) != CE_None)
      throw std::runtime_error("cannot be read: " + Quiet_gdal::reason());
    int has_none = 0;
    const double none = band.GetNoDataValue(&has_none), scale = band.GetScale(), offset = band.GetOffset();
    for (double& value : m_cells)
      value = has_none && value == none ? std::nan("") : scale * value + offset;
  }

  /// Finds for each cell the nearest one with a value, by ways from cell to cell across their sides.
  void find_nearest()
  {
    if (std::none_of(m_cells.begin(), m_cells.end(), [](double value) { return std::isnan(value); }))
      return; // nobody will ask
    constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
    m_nearest.assign(m_cells.size(), none);
    std::vector<std::size_t> reached;
    for (std::size_t k = 0; k < m_cells.size(); ++k)
      if (!std::isnan(m_cells[k])) {
        m_nearest[k] = k;
        reached.push_back(k);
      }
    if (reached.empty())
      throw std::runtime_error("has no values where the domain is");
    for (std::size_t n = 0; n < reached.size() && reached.size() < m_cells.size(); ++n) {
      const int i = static_cast<int>(reached[n] % width()), j = static_cast<int>(reached[n] / width());
      for (const std::array<int, 2>& cell : {std::array<int, 2>{i - 1, j}, {i + 1, j}, {i, j - 1}, {i, j + 1}}) {
        if (cell[0] < 0 || cell[0] == m_size[0] || cell[1] < 0 || cell[1] == m_size[1] ||
            m_nearest[number(cell)] != none)
          continue;
        m_nearest[number(cell)] = m_nearest[reached[n]];
        reached.push_back(number(cell));
      }
    }
  }

  std::size_t width() const { return static_cast<std::size_t>(m_size[0]); }

  std::size_t number(const std::array<int, 2>& cell) const
  {
    return static_cast<std::size_t>(cell[1]) * width() + static_cast<std::size_t>(cell[0]);
  }

  /// the cell among those that are read that a place is in or nearest to
  std::array<int, 2> cell_at(const std::array<double, 2>& place) const
  {
    std::array<int, 2> cell;
    for (std::size_t c = 0; c < 2; ++c)
      cell[c] = static_cast<int>(std::clamp(std::floor(place[c] - m_begin[c]), 0., m_size[c] - 1.));
    return cell;
  }

  std::array<double, 2> in_cells(double x, double y, OGRCoordinateTransformation* projection) const
  {
    const Point given(x, y);
    if (projection != nullptr && !projection->Transform(1, &x, &y))
      throw std::runtime_error("the point " + to_string(given) + " cannot be projected");
    std::array<double, 2> cell;
    GDALApplyGeoTransform(const_cast<double*>(m_to_cells.data()), x, y, &cell[0], &cell[1]);
    return cell;
  }

  /// a projection is of one thread only
  OGRCoordinateTransformation* my_projection() const
  {
    thread_local std::map<const Raster*, Projection> of_thread; // rasters live as long as formulas, to the end
    if (!m_projection)
      return nullptr;
    Projection& mine = of_thread[this];
    if (!mine)
      mine.reset(m_projection->Clone());
    return mine.get();
  }

  Quiet_gdal m_quiet;
  GDALDatasetUniquePtr m_file; // until its cells are read
  Projection m_projection;     // from the domain to the raster, nothing if it needs none
  std::array<double, 6> m_to_cells;
  std::array<int, 2> m_begin{}, m_size{}; // of the cells that are read
  std::vector<double> m_cells;            // not a number where there is none
  std::vector<std::size_t> m_nearest;     // of each cell the one whose value is taken; nothing if all have one
};

#endif // BUBBLE_RELAXATION_2_DEMO_RASTER_FILE_H
