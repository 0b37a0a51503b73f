// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef BUBBLE_RELAXATION_2_DEMO_OGR_FILE_H
#define BUBBLE_RELAXATION_2_DEMO_OGR_FILE_H

#include "domain.h"
#include "in_quotes.h"
#include "map_projection.h"

#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <deque>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

/// Reads what GDAL reads of maps: polygons are outlines, lines are inner constraints, points stay where they are. What
/// lies in an odd number of polygons is the domain; polygons may share borders. Coordinates in degrees are projected to
/// metres.
class Ogr_reader
{
public:
  /// \param field whose value is the marker of a feature, and the region of a polygon; empty for none
  /// \param crs the reference system that is wanted; empty for that of the file, or one in metres; "none" for
  /// coordinates as they are
  Ogr_reader(const std::string& name, const std::string& field, const std::string& crs)
    : m_field(field),
      m_file((GDALAllRegister(), GDALDataset::Open(name.c_str(), GDAL_OF_VECTOR | GDAL_OF_VERBOSE_ERROR)))
  {
    if (!m_file)
      throw std::runtime_error("cannot be opened: " + Quiet_gdal::reason());
    choose_system(crs);
  }

  Domain read()
  {
    bool has_field = m_field.empty();
    std::string fields;
    for (OGRLayer* layer : m_file->GetLayers()) {
      has_field = has_field || layer->GetLayerDefn()->GetFieldIndex(m_field.c_str()) >= 0;
      for (int k = 0; k < layer->GetLayerDefn()->GetFieldCount(); ++k)
        fields += (fields.empty() ? "" : ", ") + std::string(layer->GetLayerDefn()->GetFieldDefn(k)->GetNameRef());
    }
    if (!has_field)
      throw std::runtime_error("--field: there is no field '" + m_field + "'; there " +
                               (fields.empty() ? "is none" : "are " + fields));
    for (OGRLayer* layer : m_file->GetLayers())
      read_layer(*layer);
    if (m_domain.cdt.number_of_vertices() == 0)
      throw std::runtime_error("there are no points, lines or polygons in it");
    insert_paths();
    if (!m_polygons.empty())
      mark_domain();
    pin_lonely_points(m_domain);
    return std::move(m_domain);
  }

private:
  /// a ring of a polygon, or a line
  struct Path
  {
    std::vector<CDT::Vertex_handle> vertices;
    int marker;
    std::optional<std::size_t> polygon;
    std::string feature; ///< for messages
  };

  struct Polygon
  {
    double area;
    int region;
    std::size_t feature; ///< by its place in m_features
  };

  /// One that has polygons.
  struct Feature
  {
    std::string name;       ///< with an attribute, for messages
    bool has_attribute;     ///< so that it is to be seen in the mesh
    bool is_meshed = false; ///< whether triangles are of it
  };

  /// the system of the domain: what is asked for, else that of the first layer that has one, unless it is in degrees
  void choose_system(const std::string& crs)
  {
    if (crs == "none")
      return;
    OGRLayer* first = nullptr;
    for (OGRLayer* layer : m_file->GetLayers()) {
      if (first == nullptr && layer->GetSpatialRef() != nullptr)
        first = layer;
      check_degrees(*layer);
    }
    if (first == nullptr && !crs.empty())
      throw std::runtime_error("--crs: the file does not tell which reference system its coordinates are in");
    if (first == nullptr)
      return;
    if (!crs.empty())
      m_system = reference_system("--crs", crs);
    else if (first->GetSpatialRef()->IsGeographic())
      m_system = in_metres_around(*first);
    else
      m_system = *first->GetSpatialRef();
    m_system->SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    m_domain.crs = in_wkt(*m_system);
    m_domain.crs_of_file = in_wkt(*first->GetSpatialRef());
  }

  /// GeoJSON is in degrees unless it tells another system, and often does not
  static void check_degrees(OGRLayer& layer)
  {
    OGREnvelope box;
    if (layer.GetSpatialRef() == nullptr || !layer.GetSpatialRef()->IsGeographic() ||
        layer.GetExtent(&box) != OGRERR_NONE)
      return;
    const double x = -box.MinX > box.MaxX ? box.MinX : box.MaxX, y = -box.MinY > box.MaxY ? box.MinY : box.MaxY;
    if (std::abs(x) <= 720 && std::abs(y) <= 90)
      return;
    std::ostringstream text;
    text.precision(10);
    text << layer.GetName() << " is in degrees, or tells no reference system, but x = " << x << ", y = " << y
         << " are no degrees; --crs none takes coordinates as they are";
    throw std::runtime_error(text.str());
  }

  /// equal areas, and lengths true in the middle of a layer
  OGRSpatialReference in_metres_around(OGRLayer& layer)
  {
    OGREnvelope box;
    if (layer.GetExtent(&box) != OGRERR_NONE)
      throw std::runtime_error("there are no points, lines or polygons in it");
    std::ostringstream text;
    text << "+proj=laea +lat_0=" << std::round(50 * (box.MinY + box.MaxY)) / 100
         << " +lon_0=" << std::round(50 * (box.MinX + box.MaxX)) / 100 << " +datum=WGS84 +units=m";
    m_domain.warnings.push_back("degrees are projected to metres by --crs \"" + text.str() +
                                "\"; --crs none takes coordinates as they are");
    return reference_system("--crs", text.str());
  }

  void read_layer(OGRLayer& layer)
  {
    m_projection.reset();
    if (m_system && layer.GetSpatialRef() != nullptr) {
      OGRSpatialReference system = *layer.GetSpatialRef();
      system.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
      if (!system.IsSame(&*m_system))
        m_projection = projection(system, *m_system);
    }
    const int field = m_field.empty() ? -1 : layer.GetLayerDefn()->GetFieldIndex(m_field.c_str());
    for (const auto& feature : layer) {
      m_feature = "feature " + std::to_string(feature->GetFID()) + " of " + layer.GetName();
      if (feature->GetGeometryRef() == nullptr)
        continue;
      const std::unique_ptr<OGRGeometry> straight(feature->GetGeometryRef()->getLinearGeometry());
      const int attribute = field < 0 ? 0 : marker(*feature, field);
      m_features.push_back({m_feature + " (" + m_field + " = " + std::to_string(attribute) + ")", attribute != 0});
      read_geometry(*straight, attribute);
    }
  }

  int marker(OGRFeature& feature, int field) const
  {
    if (!feature.IsFieldSetAndNotNull(field))
      return 0;
    const OGRFieldType type = feature.GetFieldDefnRef(field)->GetType();
    const double value = feature.GetFieldAsDouble(field);
    if ((type != OFTInteger && type != OFTInteger64 && type != OFTReal) || value != std::floor(value) ||
        std::abs(value) > 2e9)
      throw std::runtime_error(m_feature + ": --field: " + in_quotes(feature.GetFieldAsString(field)) +
                               " must be an integer");
    return static_cast<int>(value);
  }

  void read_geometry(const OGRGeometry& geometry, int marker)
  {
    const OGRwkbGeometryType type = wkbFlatten(geometry.getGeometryType());
    if (type == wkbPoint) {
      if (!geometry.IsEmpty())
        read_point(*geometry.toPoint(), marker);
    } else if (type == wkbLineString) {
      read_path(*geometry.toLineString(), marker, {});
    } else if (type == wkbPolygon) {
      m_polygons.push_back({geometry.toPolygon()->get_Area(), marker, m_features.size() - 1});
      for (const OGRLinearRing* ring : *geometry.toPolygon())
        read_path(*ring, marker, m_polygons.size() - 1);
    } else if (OGR_GT_IsSubClassOf(type, wkbGeometryCollection)) {
      for (const OGRGeometry* part : *geometry.toGeometryCollection())
        read_geometry(*part, marker);
    } else {
      throw std::runtime_error(m_feature + ": " + geometry.getGeometryName() +
                               " is none of points, lines and polygons");
    }
  }

  void read_point(const OGRPoint& p, int marker)
  {
    const Point place = projected(p.getX(), p.getY());
    m_domain.cdt.insert(place);
    if (marker != 0)
      m_domain.point_markers[place] = marker;
  }

  void read_path(const OGRSimpleCurve& curve, int marker, std::optional<std::size_t> polygon)
  {
    Path path{{}, marker, polygon, m_feature};
    for (int k = 0; k < curve.getNumPoints(); ++k) {
      const auto hint = path.vertices.empty() ? CDT::Face_handle() : path.vertices.back()->face();
      path.vertices.push_back(m_domain.cdt.insert(projected(curve.getX(k), curve.getY(k)), hint));
    }
    if (polygon && !path.vertices.empty())
      path.vertices.push_back(path.vertices.front()); // where it is closed that is no segment
    m_paths.push_back(std::move(path));
  }

  Point projected(double x, double y) const
  {
    const Point given(x, y);
    if ((m_projection && !m_projection->Transform(1, &x, &y)) || !std::isfinite(x) || !std::isfinite(y))
      throw std::runtime_error(m_feature + ": the point " + to_string(given) + " cannot be projected");
    return Point(x, y);
  }

  /// Inserts all segments, when all points are there, so that what is told of pieces between points holds. Lines give
  /// their markers to pieces of polygons.
  void insert_paths()
  {
    for (const Path& path : m_paths)
      try {
        for (std::size_t k = 1; k < path.vertices.size(); ++k)
          insert_segment(m_domain, path.vertices[k - 1], path.vertices[k]);
      } catch (const Crossing_segments& e) {
        throw std::runtime_error(path.feature + ": " + e.what());
      }
    std::stable_partition(m_paths.begin(), m_paths.end(), [](const Path& path) { return path.polygon.has_value(); });
    for (const Path& path : m_paths)
      for (std::size_t k = 1; k < path.vertices.size(); ++k)
        label(path.vertices[k - 1], path.vertices[k], path);
  }

  void label(CDT::Vertex_handle u, CDT::Vertex_handle v, const Path& path)
  {
    CDT::Vertex_handle w;
    CDT::Face_handle f;
    int i = 0;
    for (; u != v && m_domain.cdt.includes_edge(u, v, w, f, i); u = w) {
      const auto piece = sorted(u->point(), w->point());
      if (path.marker != 0)
        m_domain.segment_markers[piece] = path.marker;
      if (path.polygon)
        m_borders[piece].push_back(*path.polygon);
    }
  }

  /// Marks what lies in an odd number of polygons, from outside over one segment after the other.
  void mark_domain()
  {
    const bool has_regions =
      std::any_of(m_polygons.begin(), m_polygons.end(), [](const Polygon& p) { return p.region != 0; });
    CGAL::Unique_hash_map<CDT::Face_handle, bool> is_reached(false);
    std::deque<std::pair<CDT::Face_handle, std::set<std::size_t>>> next{{m_domain.cdt.infinite_face(), {}}};
    bool is_empty = true;
    for (; !next.empty(); next.pop_front()) {
      const std::set<std::size_t> around = std::move(next.front().second); // the polygons that these faces are in
      CDT::Face_handle first;
      flood(next.front().first, [&](CDT::Face_handle f) {
        if (std::exchange(is_reached[f], true))
          return false;
        f->set_in_domain(around.size() % 2 == 1);
        first = first == CDT::Face_handle() ? f : first;
        for (int i = 0; i < 3; ++i)
          if (f->is_constrained(i) && !is_reached[f->neighbor(i)])
            next.emplace_back(f->neighbor(i), crossed(around, f, i));
        return true;
      });
      if (first == CDT::Face_handle() || around.size() % 2 == 0)
        continue;
      is_empty = false;
      const Polygon& polygon = innermost(around);
      m_features[polygon.feature].is_meshed = true;
      if (has_regions)
        m_domain.regions.push_back({CGAL::centroid(m_domain.cdt.triangle(first)), static_cast<double>(polygon.region)});
    }
    if (is_empty)
      throw std::runtime_error("no face lies in the domain, which is what an odd number of polygons contain");
    warn_of_features_in_holes();
  }

  /// who draws one polygon over another may want both
  void warn_of_features_in_holes()
  {
    std::set<std::size_t> lost;
    for (const Polygon& p : m_polygons)
      if (m_features[p.feature].has_attribute && !m_features[p.feature].is_meshed)
        lost.insert(p.feature);
    if (lost.empty())
      return;
    const std::string& first = m_features[*lost.begin()].name;
    m_domain.warnings.push_back(
      (lost.size() == 1 ? first + " is" : std::to_string(lost.size()) + " features, the first is " + first + ", are") +
      " on no triangle of the domain: what lies in an even number of polygons is a hole; to be meshed, a polygon needs "
      "a hole for it in the one around it");
  }

  std::set<std::size_t> crossed(std::set<std::size_t> polygons, CDT::Face_handle f, int i) const
  {
    const auto found = m_borders.find(sorted(f->vertex(CDT::cw(i))->point(), f->vertex(CDT::ccw(i))->point()));
    if (found != m_borders.end())
      for (const std::size_t p : found->second)
        if (!polygons.insert(p).second)
          polygons.erase(p);
    return polygons;
  }

  const Polygon& innermost(const std::set<std::size_t>& polygons) const
  {
    return m_polygons[*std::min_element(polygons.begin(), polygons.end(), [this](std::size_t p, std::size_t q) {
      return m_polygons[p].area < m_polygons[q].area;
    })];
  }

  Quiet_gdal m_quiet;
  std::string m_field;
  GDALDatasetUniquePtr m_file;
  std::optional<OGRSpatialReference> m_system; // of the domain
  Projection m_projection;                     // of the layer that is read, nothing if it needs none
  std::string m_feature;                       // that is read
  std::vector<Path> m_paths;
  std::vector<Feature> m_features;
  std::vector<Polygon> m_polygons;
  std::map<std::pair<Point, Point>, std::vector<std::size_t>> m_borders; // of polygons, by pieces
  Domain m_domain;
};

#endif // BUBBLE_RELAXATION_2_DEMO_OGR_FILE_H
