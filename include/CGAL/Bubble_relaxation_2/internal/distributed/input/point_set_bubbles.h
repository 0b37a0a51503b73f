// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_INPUT_POINT_SET_BUBBLES_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_INPUT_POINT_SET_BUBBLES_H

#include <CGAL/Bubble_relaxation_2/internal/core/Bubbles_2.h>
#include <CGAL/Bubble_relaxation_2/internal/core/in_words.h>
#include <CGAL/Bubble_relaxation_2/internal/core/reproducible_math.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_2.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_location_2.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// A property of the points of a `Point_set_3`, which may be missing.
template <class Point_set, class T>
class Point_property
{
public:
  /// \throws std::invalid_argument if it is there with another type: nobody would read what it tells
  Point_property(const Point_set& points, const char* name) : m_is_there(points.template has_property_map<T>(name))
  {
    const std::vector<std::string> names = points.properties();
    if (m_is_there)
      m_map = map_in(points.template property_map<T>(name));
    else if (std::find(names.begin(), names.end(), name) != names.end())
      throw std::invalid_argument("Bubble_relaxation_2: property " + std::string(name) + " of the points must have "
                                  "values of the type " + type + ", not of another one");
  }

  bool is_there() const { return m_is_there; }
  const T& operator[](const typename Point_set::Index& i) const { return m_map[i]; }

private:
  using Map = typename Point_set::template Property_map<T>;

  static constexpr const char* type = std::is_same<T, double>::value ? "double"
                                      : std::is_same<T, int>::value  ? "int"
                                                                     : "std::int64_t";

  static const Map& map_in(const std::pair<Map, bool>& found) { return found.first; } // before CGAL 6

  template <class Optional_map>
  static const Map& map_in(const Optional_map& found) { return *found; }

  bool m_is_there;
  Map m_map;
};

/// Makes bubbles of points. What their properties do not tell is found from the domain: see `read_bubbles()`.
template <class Point_set>
class Point_set_reader_2
{
  using Index_in_set = typename Point_set::Index;

public:
  Point_set_reader_2(const Point_set& points, const Domain_2& domain, bool will_move)
    : m_points(points), m_domain(domain), m_will_move(will_move), m_locate(domain), m_number(points, "global_id"),
      m_size(points, "size"), m_position(points, "position"), m_dimension(points, "dimension"), m_edge(points, "edge")
  {}

  /// adds what it makes of a point to the bubbles
  template <class Sizing>
  void read(const Index_in_set& i, const Sizing& sizing, Bubbles_2& bubbles)
  {
    const Point p(CGAL::to_double(m_points.point(i).x()), CGAL::to_double(m_points.point(i).y()));
    const Location_2 location = locate(i, p);
    const double d = m_size.is_there() ? m_size[i] : sizing(p);
    if (m_size.is_there() && (!(d > 0) || !std::isfinite(d)))
      throw_property("size", d, p, "must be positive and finite");
    bubbles.add(p, d, location.dimension, location.place, location.s);
    if (m_points.has_normal_map()) {
      bubbles.vx.back() = CGAL::to_double(m_points.normal(i).x());
      bubbles.vy.back() = CGAL::to_double(m_points.normal(i).y());
    }
    bubbles.id.push_back(m_number.is_there() ? m_number[i] : no_index);
    if (bubbles.id.back() < 0 && m_number.is_there())
      throw_property("global_id", double(bubbles.id.back()), p, "must not be negative");
  }

private:
  Location_2 locate(const Index_in_set& i, const Point& p)
  {
    Location_2 location = m_locate(p);
    if (!m_dimension.is_there())
      return location;
    const int dimension = m_dimension[i];
    if (dimension < 0 || dimension > 2)
      throw_property("dimension", dimension, p, "must be 0, 1 or 2");
    if (dimension == 0 && location.dimension == Bubbles_2::FACE)
      return Location_2{Bubbles_2::CORNER, no_index, 0}; // pinned
    if (dimension == 0 && location.dimension == Bubbles_2::EDGE && m_will_move)
      throw_property("dimension", 0, p, "pins it, but it lies on an edge of the domain and is no vertex of that");
    if (dimension == 1 && m_edge.is_there() && m_position.is_there())
      return on_edge(m_edge[i], m_position[i], p);
    return location;
  }

  /// as the properties have it: what is found from coordinates may be off by a rounding
  Location_2 on_edge(int edge, double s, const Point& p) const
  {
    if (edge < 0 || static_cast<std::size_t>(edge) >= m_domain.edges().size())
      throw_property("edge", edge, p, "is no edge of the domain");
    if (!(s > 0 && s < 1))
      throw_property("position", s, p, "must be between 0 and 1");
    const Point q = m_domain.point_on_edge(edge, s);
    if (!(length_of(q.x() - p.x(), q.y() - p.y()) <= m_locate.rounding(edge, p)))
      throw_property("position", s, p, "is another point of the edge");
    return Location_2{Bubbles_2::EDGE, edge, s};
  }

  [[noreturn]] static void throw_property(const char* name, double value, const Point& p, const char* what)
  {
    throw std::invalid_argument("Bubble_relaxation_2: property " + std::string(name) + " = " + in_words(value) +
                                " of the point " + in_words(p.x(), p.y()) + " " + what);
  }

  const Point_set& m_points;
  const Domain_2& m_domain;
  const bool m_will_move;
  Domain_location_2 m_locate;
  Point_property<Point_set, std::int64_t> m_number;
  Point_property<Point_set, double> m_size, m_position;
  Point_property<Point_set, int> m_dimension, m_edge;
};

/// Makes bubbles of the points of a `Point_set_3` with points and vectors of two dimensions, in their order.
/// Points may have the properties `global_id` (`std::int64_t`; else all numbers are -1), `size` (`double`; else
/// `sizing(point)`), `dimension`, `edge` (`int`) and `position` (`double`); where the last three do not tell
/// what of the domain a point lies on it is found. Normals are velocities. `will_move`: else it does not matter whether
/// a point is pinned to an edge, which vertices of the domain only can be
/// \throws std::invalid_argument if a point is not finite or not in the domain, or has a property out of range, or if a
/// property has another type
template <class Point_set, class Sizing>
Bubbles_2 read_bubbles(const Point_set& points, const Domain_2& domain, const Sizing& sizing, bool will_move = false)
{
  Point_set_reader_2<Point_set> reader(points, domain, will_move);
  Bubbles_2 result;
  result.make_room_for(points.size());
  for (const typename Point_set::Index& i : points)
    reader.read(i, sizing, result);
  return result;
}

/// Puts bubbles in the place of the points of a `Point_set_3`, with the properties that `read_bubbles()` knows, which
/// are added as far as they are missing. Nothing but memory can be wanting.
template <class Point_set>
void write_bubbles(const Bubbles_2& b, Point_set& points)
{
  const auto number = points.template add_property_map<std::int64_t>("global_id", no_index).first;
  const auto size = points.template add_property_map<double>("size", 0.).first;
  const auto dimension = points.template add_property_map<int>("dimension", 0).first;
  const auto edge = points.template add_property_map<int>("edge", no_index).first;
  const auto position = points.template add_property_map<double>("position", 0.).first;
  points.add_normal_map();
  points.reserve(points.number_of_points() + points.number_of_removed_points() + b.size());
  while (!points.is_empty())
    points.remove(points.end() - 1);
  for (std::size_t i = 0; i < b.size(); ++i) {
    const auto k = *points.insert();
    points.point(k) = typename Point_set::Point_3(b.x[i], b.y[i]); // so it calls them, whatever their dimension
    points.normal(k) = typename Point_set::Vector_3(b.vx[i], b.vy[i]);
    number[k] = b.id[i];
    size[k] = b.d[i];
    dimension[k] = b.dimension[i];
    edge[k] = b.is_on_edge(i) ? b.host[i] : no_index;
    position[k] = b.s[i];
  }
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_INPUT_POINT_SET_BUBBLES_H
