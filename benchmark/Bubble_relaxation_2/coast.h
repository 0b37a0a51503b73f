// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef BUBBLE_RELAXATION_2_BENCHMARK_COAST_H
#define BUBBLE_RELAXATION_2_BENCHMARK_COAST_H

#include "../../demo/Bubble_relaxation_2/paper_domains.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <istream>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

/// A part of the sea or a lake: what lies around a point in the water, in a box of longitudes and latitudes.
struct Region
{
  std::string name;
  double west, east, south, north;
  double water_east, water_north; ///< degrees of the point
};

/// \throws std::runtime_error if the file cannot be read
inline std::vector<Region> read_regions(const std::string& file_name)
{
  std::ifstream in(file_name);
  std::vector<Region> regions;
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    Region r;
    if (line.empty() || line[0] == '#')
      continue;
    if (!(words >> r.name >> r.west >> r.east >> r.south >> r.north >> r.water_east >> r.water_north))
      throw std::runtime_error(file_name + ": not a region: " + line);
    regions.push_back(r);
  }
  if (regions.empty())
    throw std::runtime_error(file_name + ": has no regions");
  return regions;
}

/// Makes domains of shore lines.
class Coast
{
  using K = paper::K;
  using Point = paper::Point;
  // the box cuts shore lines
  using CDT = CGAL::Constrained_Delaunay_triangulation_2<
    K, CGAL::Triangulation_data_structure_2<CGAL::Triangulation_vertex_base_2<K>, CGAL::Delaunay_mesh_face_base_2<K>>,
    CGAL::Exact_predicates_tag>;
  using Face_handle = CDT::Face_handle;
  using Edge = CDT::Edge;

public:
  /// \param lines of shores, each after a line that begins with '>', a point in degrees a line, as GMT writes them
  Coast(const Region& region, std::istream& lines) : m_region(region)
  {
    const double w = region.west, e = region.east, s = region.south, n = region.north;
    const std::vector<Point> box{kilometres(w, s), kilometres(e, s), kilometres(e, n), kilometres(w, n)};
    m_cdt.insert_constraint(box.begin(), box.end(), true);
    insert_shores(lines);
    mark_water();
  }

  /// The outlines of the water, its outer one first, in kilometres.
  std::vector<paper::Outline> outlines() const
  {
    std::vector<paper::Outline> result;
    std::set<Edge> seen;
    for (Face_handle f : m_cdt.finite_face_handles())
      for (int i = 0; i < 3; ++i)
        if (is_shore(Edge(f, i)) && seen.count(Edge(f, i)) == 0)
          result.push_back(outline(Edge(f, i), seen));
    for (std::size_t k = 1; k < result.size(); ++k)
      if (area(result[k]) > area(result[0])) // it alone runs counterclockwise
        std::swap(result[0], result[k]);
    return result;
  }

private:
  /// equirectangular, true in the middle of the box
  Point kilometres(double east, double north) const
  {
    constexpr double degree = 111.195;
    return Point(degree * std::cos((m_region.south + m_region.north) / 2 * paper::pi / 180) * east, degree * north);
  }

  void insert_shores(std::istream& lines)
  {
    std::string line;
    CDT::Vertex_handle last;
    while (std::getline(lines, line)) {
      double east = 0, north = 0;
      if (line.empty() || line[0] == '>' || line[0] == '#' || !(std::istringstream(line) >> east >> north)) {
        last = CDT::Vertex_handle();
        continue;
      }
      const CDT::Vertex_handle v = m_cdt.insert(kilometres(east > 180 ? east - 360 : east, north));
      if (last != CDT::Vertex_handle() && last != v)
        m_cdt.insert_constraint(last, v);
      last = v;
    }
  }

  void mark_water()
  {
    std::vector<Face_handle> stack(1, m_cdt.locate(kilometres(m_region.water_east, m_region.water_north)));
    stack[0]->set_in_domain(true);
    while (!stack.empty()) {
      const Face_handle f = stack.back();
      stack.pop_back();
      if (m_cdt.is_infinite(f))
        throw std::runtime_error(m_region.name + ": the water is not in the box");
      for (int i = 0; i < 3; ++i) {
        const Face_handle n = f->neighbor(i);
        if (f->is_constrained(i) || n->is_in_domain())
          continue;
        n->set_in_domain(true);
        stack.push_back(n);
      }
    }
  }

  /// with the water in the face of the edge
  bool is_shore(const Edge& e) const
  {
    return e.first->is_in_domain() && !e.first->neighbor(e.second)->is_in_domain();
  }

  paper::Outline outline(const Edge& first, std::set<Edge>& seen) const
  {
    paper::Outline points;
    for (Edge e = first; seen.insert(e).second;) {
      points.push_back(e.first->vertex(m_cdt.ccw(e.second))->point());
      const CDT::Vertex_handle end = e.first->vertex(m_cdt.cw(e.second));
      e = Edge(e.first, m_cdt.ccw(e.second)); // the edge of the same face that leaves the end
      while (!is_shore(e)) {
        const Face_handle n = e.first->neighbor(e.second);
        e = Edge(n, m_cdt.cw(n->index(end)));
      }
    }
    return points;
  }

  static double area(const paper::Outline& o)
  {
    double twice = 0;
    for (std::size_t i = 0; i < o.size(); ++i) {
      const Point &p = o[i], &q = o[(i + 1) % o.size()];
      twice += (p.x() - o[0].x()) * (q.y() - o[0].y()) - (p.y() - o[0].y()) * (q.x() - o[0].x());
    }
    return twice / 2;
  }

  Region m_region;
  CDT m_cdt;
};

/// The coasts of a folder that are asked for: those of one resolution, or of all that are there; all if none is.
/// \param size d in kilometres
inline std::vector<paper::Domain> read_coasts(const std::string& folder, double size,
                                              const std::vector<std::string>& names)
{
  std::vector<paper::Domain> coasts;
  for (const Region& region : read_regions(folder + "/coasts.txt"))
    for (const char* resolution : {"low", "intermediate", "high"}) {
      const std::string name = region.name + '_' + resolution;
      const auto is_asked_for = [&](const std::string& n) { return n == name || n == region.name; };
      if (!names.empty() && std::none_of(names.begin(), names.end(), is_asked_for))
        continue;
      std::ifstream in(folder + '/' + name + ".txt");
      if (!in)
        continue;
      coasts.push_back({0, name, Coast(region, in).outlines(), [size](const paper::Point&) { return size; }, 0, 0});
    }
  if (coasts.empty())
    throw std::runtime_error(folder + ": has none of the coasts");
  return coasts;
}

#endif // BUBBLE_RELAXATION_2_BENCHMARK_COAST_H
