// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef BUBBLE_RELAXATION_2_EXAMPLES_DOMAIN_FILE_H
#define BUBBLE_RELAXATION_2_EXAMPLES_DOMAIN_FILE_H

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/WKT.h>
#include <CGAL/Polygon_with_holes_2.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_2;
using CDT = CGAL::Constrained_Delaunay_triangulation_2<
  Kernel,
  CGAL::Triangulation_data_structure_2<CGAL::Triangulation_vertex_base_2<Kernel>,
                                       CGAL::Delaunay_mesh_face_base_2<Kernel>>,
  CGAL::No_constraint_intersection_requiring_constructions_tag>;

/// A domain as files give it.
struct Domain_file
{
  CDT cdt;
  std::vector<CDT::Vertex_handle> pinned; ///< points that are no ends of segments: they stay
  bool has_seeds = false;                 ///< whether holes are told by seeds, else by nesting
  std::vector<Point> holes;
};

/// Reads the tokens of a file of Triangle: numbers, with comments from # to the end of a line.
class Poly_reader
{
public:
  explicit Poly_reader(std::istream& in) : m_in(in) {}

  /// the next line that is not empty, as numbers; at least `least` of them
  std::vector<double> line(std::size_t least, const char* what)
  {
    for (std::string text; std::getline(m_in, text);) {
      ++m_number;
      std::istringstream tokens(text.substr(0, text.find('#')));
      std::vector<double> numbers;
      for (std::string token; tokens >> token;) {
        char* end;
        numbers.push_back(std::strtod(token.c_str(), &end));
        if (*end != '\0' || !std::isfinite(numbers.back()))
          fail("'" + token + "' is not a finite number");
      }
      if (numbers.empty())
        continue;
      if (numbers.size() < least)
        fail(std::string("too few numbers for ") + what);
      return numbers;
    }
    throw std::runtime_error(std::string("the file ends before ") + what);
  }

  std::size_t count(double number, const char* what)
  {
    if (number < 0 || number != std::floor(number) || number > 1e9)
      fail(std::string("bad ") + what);
    return static_cast<std::size_t>(number);
  }

  [[noreturn]] void fail(const std::string& what) const
  {
    throw std::runtime_error("line " + std::to_string(m_number) + ": " + what);
  }

private:
  std::istream& m_in;
  int m_number = 0;
};

inline void insert_segment(CDT& cdt, CDT::Vertex_handle u, CDT::Vertex_handle v)
{
  if (u == v)
    return;
  try {
    cdt.insert_constraint(u, v);
  } catch (const CDT::Intersection_of_constraints_exception&) {
    std::ostringstream message;
    message << "the segment from (" << u->point() << ") to (" << v->point() << ") crosses another";
    throw std::runtime_error(message.str());
  }
}

/// Triangle's .poly: points, segments, seeds of holes. Points may be numbered from 0 or 1.
inline Domain_file read_poly(std::istream& in)
{
  Domain_file domain;
  Poly_reader reader(in);
  std::map<double, CDT::Vertex_handle> vertices;
  const std::size_t points = reader.count(reader.line(1, "the number of points")[0], "number of points");
  for (std::size_t k = 0; k < points; ++k) {
    const std::vector<double> p = reader.line(3, "a point");
    vertices[p[0]] = domain.cdt.insert(Point(p[1], p[2]));
  }
  const std::size_t segments =
    reader.count(reader.line(1, "the number of segments")[0], "number of segments");
  for (std::size_t k = 0; k < segments; ++k) {
    const std::vector<double> s = reader.line(3, "a segment");
    if (vertices.count(s[1]) == 0 || vertices.count(s[2]) == 0)
      reader.fail("a segment ends in a point that does not exist");
    insert_segment(domain.cdt, vertices[s[1]], vertices[s[2]]);
  }
  const std::size_t holes = reader.count(reader.line(1, "the number of holes")[0], "number of holes");
  for (std::size_t k = 0; k < holes; ++k) {
    const std::vector<double> h = reader.line(3, "a hole");
    domain.holes.push_back(Point(h[1], h[2]));
  }
  domain.has_seeds = true;
  return domain;
}

/// WKT: polygons with holes are outlines, lines are inner constraints, points stay where they are.
inline Domain_file read_wkt(std::istream& in)
{
  Domain_file domain;
  std::vector<Point> points;
  std::vector<std::vector<Point>> lines;
  std::vector<CGAL::Polygon_with_holes_2<Kernel>> polygons;
  // line by line: CGAL's reader never returns from a line that starts with something else
  int number = 0;
  for (std::string text; std::getline(in, text);) {
    ++number;
    const std::size_t start = text.find_first_not_of(" \t\r");
    if (start == std::string::npos)
      continue;
    const std::string type = text.substr(start, text.find_first_of(" (", start) - start);
    const std::size_t before = points.size() + lines.size() + polygons.size();
    std::istringstream line(text.substr(start));
    if (std::set<std::string>{"POINT", "LINESTRING", "POLYGON", "MULTIPOINT", "MULTILINESTRING",
                              "MULTIPOLYGON"}.count(type) > 0)
      CGAL::IO::read_WKT(line, points, lines, polygons);
    if (points.size() + lines.size() + polygons.size() == before)
      throw std::runtime_error("line " + std::to_string(number) +
                               ": this is not WKT of points, lines and polygons");
  }
  const auto insert = [&](const std::vector<Point>& line, bool closed) {
    for (const Point& p : line)
      if (!std::isfinite(p.x()) || !std::isfinite(p.y()))
        throw std::runtime_error("a coordinate is not finite");
    for (std::size_t k = closed ? 0 : 1; k < line.size(); ++k)
      insert_segment(domain.cdt, domain.cdt.insert(line[k == 0 ? line.size() - 1 : k - 1]),
                     domain.cdt.insert(line[k]));
  };
  for (const auto& polygon : polygons) {
    insert({polygon.outer_boundary().vertices_begin(), polygon.outer_boundary().vertices_end()}, true);
    for (const auto& hole : polygon.holes())
      insert({hole.vertices_begin(), hole.vertices_end()}, true);
  }
  for (const auto& line : lines)
    insert(line, false);
  for (const Point& p : points)
    domain.cdt.insert(p);
  return domain;
}

/// Reads .poly or .wkt, by the ending of the name.
/// \throws std::runtime_error with the name and the place
inline Domain_file read_domain_file(const std::string& name)
{
  const std::string ending = name.substr((std::min)(name.size(), name.rfind('.')));
  std::ifstream in(name);
  if (!in)
    throw std::runtime_error(name + ": cannot be opened");
  try {
    if (ending != ".poly" && ending != ".wkt")
      throw std::runtime_error("the ending must be .poly or .wkt");
    Domain_file domain = ending == ".poly" ? read_poly(in) : read_wkt(in);
    for (CDT::Vertex_handle v : domain.cdt.finite_vertex_handles())
      if (!domain.cdt.are_there_incident_constraints(v))
        domain.pinned.push_back(v);
    return domain;
  } catch (const std::exception& e) {
    throw std::runtime_error(name + ": " + e.what());
  }
}

#endif // BUBBLE_RELAXATION_2_EXAMPLES_DOMAIN_FILE_H
