// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_WRITING_POINT_REPLACEMENT_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_WRITING_POINT_REPLACEMENT_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/Bubbles_2.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// Replaces the points of a `Point_set_3` by bubbles, in two steps: all that can fail comes first and is undone if
/// it does, or if the second step does not follow.
template <class Point_set>
class Point_replacement_2
{
  using Point_2 = typename Point_set::Point_3; // so it calls them, whatever their dimension
  using Vector_2 = typename Point_set::Vector_3;

public:
  explicit Point_replacement_2(Point_set& points) : m_points(points) {}

  ~Point_replacement_2()
  {
    if (m_is_done)
      return;
    remove(m_number);
    remove(m_size);
    remove(m_dimension);
    remove(m_edge);
    remove(m_position);
    if (m_has_added_normals)
      m_points.remove_normal_map();
  }

  Point_replacement_2(const Point_replacement_2&) = delete;
  Point_replacement_2& operator=(const Point_replacement_2&) = delete;

  /// adds the properties that `read_bubbles()` knows, as far as they are missing, and makes room
  void prepare(const Bubbles_2& b)
  {
    m_bubbles = &b;
    for (std::size_t i = 0; i < b.size(); ++i) { // numbers of a kernel may need memory
      m_places.push_back(Point_2(b.x[i], b.y[i]));
      m_velocities.push_back(Vector_2(b.vx[i], b.vy[i]));
    }
    add("global_id", std::int64_t(no_index), m_number);
    add("size", 0., m_size);
    add("dimension", 0, m_dimension);
    add("edge", int(no_index), m_edge);
    add("position", 0., m_position);
    m_has_added_normals = m_points.add_normal_map().second;
    m_points.reserve(m_points.number_of_points() + m_points.number_of_removed_points() + b.size());
  }

  /// writes the bubbles; there is room for all
  void finish() noexcept
  {
    const Bubbles_2& b = *m_bubbles;
    while (!m_points.is_empty())
      m_points.remove(m_points.end() - 1);
    for (std::size_t i = 0; i < b.size(); ++i) {
      const auto k = *m_points.insert();
      m_points.point(k) = m_places[i];
      m_points.normal(k) = m_velocities[i];
      m_number.map[k] = b.id[i];
      m_size.map[k] = b.d[i];
      m_dimension.map[k] = b.dimension[i];
      m_edge.map[k] = b.is_on_edge(i) ? b.host[i] : no_index;
      m_position.map[k] = b.s[i];
    }
    m_is_done = true;
  }

private:
  template <class T>
  struct Property
  {
    typename Point_set::template Property_map<T> map;
    bool is_added = false;
  };

  template <class T>
  void add(const char* name, const T& value, Property<T>& property)
  {
    const auto result = m_points.template add_property_map<T>(name, value);
    property.map = result.first;
    property.is_added = result.second;
  }

  template <class T>
  void remove(Property<T>& property)
  {
    if (property.is_added)
      m_points.remove_property_map(property.map);
  }

  Point_set& m_points;
  const Bubbles_2* m_bubbles = nullptr;
  std::vector<Point_2> m_places;
  std::vector<Vector_2> m_velocities;
  Property<std::int64_t> m_number;
  Property<double> m_size, m_position;
  Property<int> m_dimension, m_edge;
  bool m_has_added_normals = false, m_is_done = false;
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_WRITING_POINT_REPLACEMENT_2_H
