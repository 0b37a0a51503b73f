// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef BUBBLE_RELAXATION_2_DEMO_TRIANGLE_FILE_H
#define BUBBLE_RELAXATION_2_DEMO_TRIANGLE_FILE_H

#include "domain.h"
#include "file_names.h"
#include "in_quotes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <istream>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

/// Reads the lines of a file of Triangle: numbers, with comments from # to the end of a line.
class Triangle_reader
{
public:
  explicit Triangle_reader(std::istream& in) : m_in(in) {}

  /// the next line that is not empty, as numbers; at least `least` of them
  std::vector<double> line(std::size_t least, const std::string& what)
  {
    std::vector<double> numbers = next_line();
    if (numbers.empty())
      throw std::runtime_error("the file ends before " + what);
    if (numbers.size() < least)
      fail("too few numbers for " + what);
    return numbers;
  }

  /// the same, empty at the end of the file
  std::vector<double> next_line()
  {
    std::vector<double> numbers;
    for (std::string text; numbers.empty() && std::getline(m_in, text);) {
      ++m_number;
      std::istringstream tokens(text.substr(0, text.find('#')));
      for (std::string token; tokens >> token;) {
        char* end;
        numbers.push_back(std::strtod(token.c_str(), &end));
        if (end != token.c_str() + token.size() || !std::isfinite(numbers.back())) // a token may have zeros in it
          fail(in_quotes(token) + " is not a finite number");
      }
    }
    return numbers;
  }

  std::size_t count(double number, const std::string& what)
  {
    if (number < 0 || number != std::floor(number) || number > 1e9)
      fail("bad " + what);
    return static_cast<std::size_t>(number);
  }

  int marker(double number)
  {
    if (number != std::floor(number) || std::abs(number) > 2e9)
      fail("a marker must be an integer");
    return static_cast<int>(number);
  }

  /// of the line that was read last
  int line_number() const { return m_number; }

  [[noreturn]] void fail(const std::string& what) const
  {
    throw std::runtime_error("line " + std::to_string(m_number) + ": " + what);
  }

private:
  std::istream& m_in;
  int m_number = 0;
};

/// The points of a file with their numbers, which may start from 0 or 1.
struct Numbered_points
{
  struct Numbered_point
  {
    Point point;
    int marker;
    CDT::Vertex_handle vertex;
  };

  std::map<double, Numbered_point> points;

  /// the vertex of a number, inserted when it is needed
  CDT::Vertex_handle vertex(double number, Domain& domain, const Triangle_reader& reader,
                            const char* what)
  {
    const auto found = points.find(number);
    if (found == points.end())
      reader.fail(std::string(what) + " ends in the point " +
                  std::to_string(static_cast<long long>(number)) + ", which does not exist");
    Numbered_point& p = found->second;
    if (p.vertex == CDT::Vertex_handle()) {
      p.vertex = domain.cdt.insert(p.point);
      if (p.marker != 0)
        domain.point_markers[p.point] = p.marker;
    }
    return p.vertex;
  }
};

/// Reads the points of a .node or a .poly.
inline Numbered_points read_points(Triangle_reader& reader, Domain& domain)
{
  Numbered_points result;
  std::vector<double> header = reader.line(1, "the number of points");
  header.resize((std::max)(header.size(), std::size_t(4)), 0);
  const std::size_t points = reader.count(header[0], "number of points"),
                    attributes = reader.count(header[2], "number of attributes"),
                    markers = reader.count(header[3], "number of markers");
  if (points > 0 && header[1] != 0 && header[1] != 2)
    reader.fail("points must have two coordinates");
  for (std::size_t k = 0; k < points; ++k) {
    const std::vector<double> p = reader.line(3 + attributes + markers, "a point");
    const int marker = markers > 0 ? reader.marker(p[3 + attributes]) : 0;
    if (!result.points.insert({p[0], {Point(p[1], p[2]), marker, CDT::Vertex_handle()}}).second)
      reader.fail("two points have this number");
  }
  if (attributes > 0)
    domain.warnings.push_back("attributes of points are not carried to the mesh");
  return result;
}

/// \throws std::runtime_error with the name of the file
template <class Read>
void read_other_file(const std::string& name, const Read& read)
{
  std::ifstream in(name);
  if (!in)
    throw std::runtime_error(name + ": cannot be opened: " + std::strerror(errno));
  try {
    Triangle_reader reader(in);
    read(reader);
  } catch (const std::exception& e) {
    throw std::runtime_error(name + ": " + e.what());
  }
}

/// the points of a .poly, or of the .node beside it if it has none
inline Numbered_points read_points_of_poly(Triangle_reader& reader, const std::string& name,
                                           Domain& domain)
{
  Numbered_points points = read_points(reader, domain);
  if (!points.points.empty())
    return points;
  if (name.empty())
    throw std::runtime_error("there are no points, and standard input has no .node file beside it");
  const std::string other = without_extension(name) + ".node";
  if (!std::filesystem::exists(other))
    throw std::runtime_error("there are no points, and no " + other + " beside it that has them");
  read_other_file(other, [&](Triangle_reader& nodes) { points = read_points(nodes, domain); });
  return points;
}

/// A segment of a file, and where it is there.
struct Numbered_segment
{
  double number;
  int line;
  Point source, target;

  /// whether a piece between vertices on a segment is one of this one
  bool contains(const std::pair<Point, Point>& piece) const
  {
    const auto is_on = [this](const Point& p) {
      return p == source || p == target ||
             (CGAL::collinear(source, p, target) && CGAL::collinear_are_ordered_along_line(source, p, target));
    };
    return is_on(piece.first) && is_on(piece.second);
  }

  std::string text() const
  {
    std::ostringstream text;
    text.precision(15);
    text << number << ", " << Crossing_segments::text({source, target});
    return text.str();
  }
};

/// \param segments those that were read, the last of which crosses another one
[[noreturn]] inline void throw_crossing(const Triangle_reader& reader, const std::vector<Numbered_segment>& segments,
                                        const Crossing_segments& crossing)
{
  const auto other = std::find_if(segments.begin(), segments.end(),
                                  [&](const Numbered_segment& s) { return s.contains(crossing.piece); });
  if (other == segments.end())
    reader.fail(crossing.what());
  reader.fail("segment " + segments.back().text() + ", crosses segment " + other->text() + ", of line " +
              std::to_string(other->line));
}

inline void read_segments(Triangle_reader& reader, Numbered_points& points, Domain& domain)
{
  std::vector<double> header = reader.line(1, "the number of segments");
  header.resize((std::max)(header.size(), std::size_t(2)), 0);
  const std::size_t segments = reader.count(header[0], "number of segments"),
                    markers = reader.count(header[1], "number of markers");
  std::vector<Numbered_segment> read;
  for (std::size_t k = 0; k < segments; ++k) {
    const std::vector<double> s = reader.line(3 + markers, "a segment");
    const CDT::Vertex_handle u = points.vertex(s[1], domain, reader, "a segment"),
                             v = points.vertex(s[2], domain, reader, "a segment");
    const int marker = markers > 0 ? reader.marker(s[3]) : 0;
    read.push_back({s[0], reader.line_number(), u->point(), v->point()});
    try {
      insert_segment(domain, u, v, marker);
    } catch (const Crossing_segments& crossing) {
      throw_crossing(reader, read, crossing);
    }
  }
}

/// the end of a .poly, which need not be there
inline void read_regions(Triangle_reader& reader, Domain& domain)
{
  const std::vector<double> header = reader.next_line();
  if (header.empty())
    return;
  const std::size_t regions = reader.count(header[0], "number of regions");
  for (std::size_t k = 0; k < regions; ++k) {
    const std::vector<double> r = reader.line(4, "a region");
    domain.regions.push_back({Point(r[1], r[2]), r[3], r.size() > 4 ? r[4] : 0});
  }
}

/// Inserts all points, and tells of those that are where others are.
inline void insert_points(Numbered_points& points, const Triangle_reader& reader, Domain& domain)
{
  std::set<CDT::Vertex_handle> vertices;
  std::vector<double> doubles;
  for (const auto& p : points.points)
    if (!vertices.insert(points.vertex(p.first, domain, reader, "a segment")).second)
      doubles.push_back(p.first);
  if (!doubles.empty())
    domain.warnings.push_back(
      std::to_string(doubles.size()) + (doubles.size() == 1 ? " point is" : " points are") +
      " where others are, such as point " + std::to_string(static_cast<long long>(doubles.front())) + " at " +
      to_string(points.points.at(doubles.front()).point));
}

/// Triangle's .poly: points, segments, seeds of holes, regions.
/// \param name of the file, empty for standard input
inline Domain read_poly(std::istream& in, const std::string& name)
{
  Domain domain;
  Triangle_reader reader(in);
  Numbered_points points = read_points_of_poly(reader, name, domain);
  insert_points(points, reader, domain);
  read_segments(reader, points, domain);
  const std::size_t number = reader.count(reader.line(1, "the number of holes")[0], "number of holes");
  std::vector<Point> holes;
  for (std::size_t k = 0; k < number; ++k) {
    const std::vector<double> h = reader.line(3, "a hole");
    holes.push_back(Point(h[1], h[2]));
  }
  read_regions(reader, domain);
  mark_all_but_holes(domain, holes);
  keep_regions_with_faces(domain);
  pin_lonely_points(domain);
  return domain;
}

/// The triangles of an .ele: the numbers of their corners, and the first attribute.
struct Element
{
  std::array<double, 3> corners;
  double attribute;
};

inline std::vector<Element> read_elements(Triangle_reader& reader, bool& has_attributes)
{
  std::vector<double> header = reader.line(1, "the number of triangles");
  header.resize((std::max)(header.size(), std::size_t(3)), 0);
  const std::size_t number = reader.count(header[0], "number of triangles"),
                    nodes = header[1] == 0 ? 3 : reader.count(header[1], "number of nodes");
  has_attributes = header[2] > 0;
  std::vector<Element> elements;
  for (std::size_t k = 0; k < number; ++k) {
    const std::vector<double> e =
      reader.line(1 + (std::max)(nodes, std::size_t(3)) + (has_attributes ? 1 : 0), "a triangle");
    elements.push_back({{e[1], e[2], e[3]}, has_attributes ? e[1 + nodes] : 0});
  }
  return elements;
}

/// Inserts the corners of triangles, and the edges that only one triangle has as segments.
inline void insert_elements(const std::vector<Element>& elements, const Triangle_reader& reader,
                            Numbered_points& points, Domain& domain)
{
  std::map<std::pair<double, double>, int> edges;
  for (const Element& element : elements)
    for (int i = 0; i < 3; ++i) {
      const double a = element.corners[i], b = element.corners[(i + 1) % 3];
      points.vertex(a, domain, reader, "a triangle");
      ++edges[std::minmax(a, b)];
    }
  for (const auto& edge : edges)
    if (edge.second == 1)
      insert_segment(domain, points.vertex(edge.first.first, domain, reader, "a triangle"),
                     points.vertex(edge.first.second, domain, reader, "a triangle"));
}

/// Marks the faces that triangles cover.
inline void mark_elements(const std::vector<Element>& elements, bool has_attributes,
                          const Numbered_points& points, Domain& domain)
{
  CDT::Face_handle hint;
  for (const Element& element : elements) {
    const auto corner = [&](int i) { return points.points.at(element.corners[i]).point; };
    const Point center = CGAL::centroid(corner(0), corner(1), corner(2));
    hint = domain.cdt.locate(center, hint);
    if (hint->is_in_domain() || domain.cdt.is_infinite(hint))
      continue;
    flood(hint, [&](CDT::Face_handle f) {
      const bool is_new = !f->is_in_domain() && !domain.cdt.is_infinite(f);
      f->set_in_domain(true);
      return is_new;
    });
    if (has_attributes)
      domain.regions.push_back({center, element.attribute});
  }
}

/// A mesh of Triangle, .node and .ele, with the segments of the .poly beside them if there is one.
/// Its free vertices are the bubbles to start with.
inline Domain read_triangle_mesh(const std::string& name)
{
  Domain domain;
  const std::string base = without_extension(name);
  Numbered_points points;
  read_other_file(base + ".node", [&](Triangle_reader& reader) { points = read_points(reader, domain); });
  if (std::filesystem::exists(base + ".poly"))
    read_other_file(base + ".poly", [&](Triangle_reader& reader) {
      read_points(reader, domain);
      read_segments(reader, points, domain);
    });
  read_other_file(base + ".ele", [&](Triangle_reader& reader) {
    bool has_attributes = false;
    const std::vector<Element> elements = read_elements(reader, has_attributes);
    insert_elements(elements, reader, points, domain);
    if (domain.cdt.dimension() == 2)
      mark_elements(elements, has_attributes, points, domain);
  });
  return domain;
}

#endif // BUBBLE_RELAXATION_2_DEMO_TRIANGLE_FILE_H
