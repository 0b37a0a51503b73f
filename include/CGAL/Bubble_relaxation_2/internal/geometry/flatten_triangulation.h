// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_GEOMETRY_FLATTEN_TRIANGULATION_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_GEOMETRY_FLATTEN_TRIANGULATION_H

#include <CGAL/Bubble_relaxation_2/internal/core/Plane_2.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Progress.h>
#include <CGAL/Bubble_relaxation_2/internal/core/in_words.h>
#include <CGAL/Bubble_relaxation_2/internal/core/magnitudes.h>
#include <CGAL/Bubble_relaxation_2/internal/core/parallel_for.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Flat_triangulation_2.h>

#include <CGAL/Bbox_2.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// The numbers of vertices, or of faces, by their addresses. The user's types are forgotten here, so that all that
/// is done with numbers is compiled once. Unlike CGAL's maps it ticks while it grows, which takes long with millions.
class Address_numbers
{
public:
  /// \param size of the objects in memory
  explicit Address_numbers(std::size_t size) : m_size(size) {}

  void add(void* object)
  {
    if (m_addresses.size() == m_first.size())
      grow();
    m_addresses.push_back(object);
    m_next.push_back(no_index);
    enter(m_addresses.size() - 1);
  }

  /// `no_index` if it was not added
  Index operator()(const void* object) const
  {
    Index i = m_first.empty() ? no_index : m_first[bucket(object)];
    while (i != no_index && m_addresses[i] != object)
      i = m_next[i];
    return i;
  }

  const std::vector<void*>& addresses() const { return m_addresses; }

private:
  /// objects that follow each other in memory are in buckets that do so
  std::size_t bucket(const void* object) const
  {
    return reinterpret_cast<std::uintptr_t>(object) / m_size & (m_first.size() - 1);
  }

  void enter(std::size_t i)
  {
    Index& first = m_first[bucket(m_addresses[i])];
    m_next[i] = first;
    first = static_cast<Index>(i);
  }

  void grow()
  {
    const std::size_t n = m_addresses.size();
    assign_in_turn(m_first, (std::max)(2 * n, std::size_t(64)), no_index);
    make_room_for(m_first.size() - n, m_addresses);
    make_room_for(m_first.size() - n, m_next);
    for (std::size_t i = 0; i < n; ++i) {
      tick(i);
      enter(i);
    }
  }

  std::size_t m_size;
  std::vector<void*> m_addresses;
  std::vector<Index> m_first; // the number that was added last to each bucket, of which there is a power of two
  std::vector<Index> m_next;  // the one that was added to the same bucket before
};

/// Vertices and faces of one of CGAL's triangulations by their addresses, which containers have instead of handles:
/// all of them are of one type then.
template <class Triangulation>
struct Handles
{
  using Tds = typename Triangulation::Triangulation_data_structure;
  using Vertex_handle = typename Triangulation::Vertex_handle;
  using Face_handle = typename Triangulation::Face_handle;

  static Vertex_handle vertex(void* address)
  {
    return Tds::Vertex_range::s_iterator_to(*static_cast<typename Tds::Vertex*>(address));
  }

  static Face_handle face(void* address)
  {
    return Tds::Face_range::s_iterator_to(*static_cast<typename Tds::Face*>(address));
  }
};

/// Evaluates a point whose coordinates are lazy numbers: what one becomes in double depends on what was asked of it
/// before, until it has been evaluated.
template <class Point_2>
auto evaluate_lazy(const Point_2& p, int) -> decltype(exact(p), void())
{
  exact(p);
}

template <class Point_2>
void evaluate_lazy(const Point_2&, long)
{}

/// where a point of a user's triangulation lies in its plane, in double
template <class Triangulation, class User_point>
Point point_in_double(const User_point& p)
{
  using Plane = Plane_2<Triangulation>;
  evaluate_lazy(p, 0);
  return Point(CGAL::to_double(Plane::x(p)), CGAL::to_double(Plane::y(p)));
}

/// the same of the corners of a face
template <class Triangulation>
std::array<Point, 3> corners_in_double(typename Triangulation::Face_handle f)
{
  return {point_in_double<Triangulation>(f->vertex(0)->point()), point_in_double<Triangulation>(f->vertex(1)->point()),
          point_in_double<Triangulation>(f->vertex(2)->point())};
}

template <class Triangulation>
Bbox_2 box_of(typename Triangulation::Face_handle f)
{
  const std::array<Point, 3> corners = corners_in_double<Triangulation>(f);
  return CGAL::bbox_2(corners.begin(), corners.end());
}

/// whether all faces around a vertex, infinite ones among them, are of a kind
template <class Triangulation, class Is_of_kind>
bool are_all_around(const Triangulation& t, typename Triangulation::Vertex_handle v, const Is_of_kind& is_of_kind)
{
  auto f = t.incident_faces(v), first = f;
  do
    if (!is_of_kind(f))
      return false;
  while (++f != first);
  return true;
}

/// A user's triangulation in arrays: its finite vertices and faces in the order in which it lists them.
struct Triangulation_copy_2
{
  Flat_triangulation_2 tr;
  Address_numbers vertices, faces; ///< infinite ones have no number

  /// \pre `t` has dimension 2
  template <class Triangulation>
  explicit Triangulation_copy_2(const Triangulation& t)
    : vertices(sizeof(typename Triangulation::Vertex)), faces(sizeof(typename Triangulation::Face))
  {
    tr.points.reserve(t.number_of_vertices());
    tr.vertices.reserve(t.number_of_faces());
    tr.neighbors.reserve(t.number_of_faces());
    for (auto v = t.finite_vertices_begin(); v != t.finite_vertices_end(); ++v)
      add_vertex(&*v, point_in_double<Triangulation>(v->point()));
    for (auto f = t.finite_faces_begin(); f != t.finite_faces_end(); ++f)
      faces.add(&*f);
    add_triangles<Triangulation>();
  }

  /// some faces, finite ones, and their vertices
  template <class Triangulation>
  Triangulation_copy_2(const Triangulation&, const std::vector<typename Triangulation::Face_handle>& some)
    : vertices(sizeof(typename Triangulation::Vertex)), faces(sizeof(typename Triangulation::Face))
  {
    for (const auto& f : some) {
      if (faces(&*f) != no_index)
        continue; // it comes twice
      faces.add(&*f);
      for (int i = 0; i < 3; ++i)
        if (vertices(&*f->vertex(i)) == no_index)
          add_vertex(&*f->vertex(i), point_in_double<Triangulation>(f->vertex(i)->point()));
    }
    add_triangles<Triangulation>();
  }

private:
  using Addresses = std::array<const void*, 3>;

  template <class Triangulation>
  void add_triangles()
  {
    for (void* f : faces.addresses()) {
      const auto& face = *static_cast<typename Triangulation::Face*>(f);
      add_triangle({&*face.vertex(0), &*face.vertex(1), &*face.vertex(2)},
                   {&*face.neighbor(0), &*face.neighbor(1), &*face.neighbor(2)});
    }
  }

  void add_vertex(void* vertex, const Point& p)
  {
    vertices.add(vertex);
    tr.points.push_back(p);
    tick(tr.points.size());
  }

  void add_triangle(const Addresses& v, const Addresses& n)
  {
    tr.vertices.push_back({vertices(v[0]), vertices(v[1]), vertices(v[2])});
    tr.neighbors.push_back({faces(n[0]), faces(n[1]), faces(n[2])});
    tick(tr.neighbors.size());
  }
};

/// \throws std::invalid_argument if a point of the user's triangulation is not finite, or beyond the bound of
/// coordinates
inline void check_coordinates(const std::vector<Point>& points)
{
  for (const Point& p : points)
    if (!is_coordinate(p.x()) || !is_coordinate(p.y()))
      throw std::invalid_argument("Bubble_relaxation_2: a vertex of the triangulation has the coordinates " +
                                  in_words(p.x(), p.y()) + ", which must be " + required_of_coordinates(p.x(), p.y()));
}

/// whether the point of a vertex, given by its address, is lexicographically before that of another one
using Is_before = bool (*)(const void*, const void*);

/// The numbers of a triangulation's vertices in the lexicographic order of their points.
/// \param is_before `nullptr` if it is enough to compare the points as they are rounded to double; those in one place
/// come in the order of their numbers then
inline std::vector<Index> lexicographic_order(const Triangulation_copy_2& copy, Is_before is_before)
{
  std::vector<std::pair<Point, Index>> sorted;
  sorted.reserve(copy.tr.points.size());
  for (const Point& p : copy.tr.points) {
    tick(sorted.size());
    sorted.emplace_back(p, static_cast<Index>(sorted.size()));
  }
  const std::vector<void*>& address = copy.vertices.addresses();
  parallel_sort(Threads(), sorted, [&](const auto& a, const auto& b) {
    return is_before != nullptr ? is_before(address[a.second], address[b.second]) : a < b;
  });
  std::vector<Index> order;
  order.reserve(sorted.size());
  for (const auto& v : sorted)
    order.push_back(v.second);
  return order;
}

/// the position of each number in an order of them
inline std::vector<Index> inverse(const std::vector<Index>& order)
{
  std::vector<Index> position(order.size());
  for (std::size_t k = 0; k < order.size(); ++k)
    position[order[k]] = static_cast<Index>(k);
  return position;
}

/// A triangulation with the vertices in the order of their points and the triangles in the order of their vertices,
/// so that it does not matter how it came about; and which vertices and triangles of another one these were.
struct Sorted_triangulation_2
{
  Flat_triangulation_2 tr;
  std::vector<Index> vertices, triangles;

  /// \throws std::invalid_argument as `check_coordinates()` does
  explicit Sorted_triangulation_2(const Triangulation_copy_2& copy)
  {
    check_coordinates(copy.tr.points);
    vertices = lexicographic_order(copy, nullptr);
    const Flat_triangulation_2& t = copy.tr;
    const std::vector<Index> number = inverse(vertices);
    for (Index v : vertices)
      tr.points.push_back(t.points[v]);
    std::vector<Turned_triangle> turned;
    turned.reserve(t.vertices.size());
    for (const std::array<Index, 3>& corners : t.vertices) {
      const std::array<Index, 3> v{number[corners[0]], number[corners[1]], number[corners[2]]};
      const int first = static_cast<int>(std::min_element(v.begin(), v.end()) - v.begin());
      turned.push_back({{v[first], v[ccw(first)], v[cw(first)]}, static_cast<Index>(turned.size()), first});
    }
    std::sort(turned.begin(), turned.end(),
              [](const Turned_triangle& a, const Turned_triangle& b) { return a.vertices < b.vertices; });
    for (const Turned_triangle& c : turned)
      triangles.push_back(c.triangle);
    const std::vector<Index> position = inverse(triangles);
    for (const Turned_triangle& c : turned) {
      const auto neighbor = [&](int i) {
        const Index n = t.neighbors[c.triangle][i];
        return n == no_index ? no_index : position[n];
      };
      tr.vertices.push_back(c.vertices);
      tr.neighbors.push_back({neighbor(c.first), neighbor(ccw(c.first)), neighbor(cw(c.first))});
      if (!t.inside.empty())
        tr.inside.push_back(t.inside[c.triangle]);
    }
  }

private:
  struct Turned_triangle
  {
    std::array<Index, 3> vertices; // the smallest first
    Index triangle;
    int first; // index of the first vertex in the triangle
  };
};

/// A user's triangulation in sorted arrays.
template <class Triangulation>
struct Flattened_triangulation_2
{
  Flat_triangulation_2 tr;
  std::vector<typename Triangulation::Vertex_handle> vertices; ///< of each point
  std::vector<typename Triangulation::Face_handle> faces;      ///< of each triangle
};

/// \param some nothing, or a vector of faces, of which one may be there twice
/// \pre `t` has dimension 2
template <class Triangulation, class... Faces>
Flattened_triangulation_2<Triangulation> flatten_triangulation(const Triangulation& t, const Faces&... some)
{
  const Triangulation_copy_2 copy(t, some...);
  Sorted_triangulation_2 sorted(copy);
  Flattened_triangulation_2<Triangulation> flat{std::move(sorted.tr), {}, {}};
  for (Index v : sorted.vertices)
    flat.vertices.push_back(Handles<Triangulation>::vertex(copy.vertices.addresses()[v]));
  for (Index f : sorted.triangles)
    flat.faces.push_back(Handles<Triangulation>::face(copy.faces.addresses()[f]));
  return flat;
}

/// A walk through a triangle that is turned over may not end, and its area is none.
/// \param whose of what, in words for the user
/// \throws std::invalid_argument if there is one, as when corners are rounded to `double`
inline void check_orientations(const std::string& whose, const std::vector<Point>& points,
                               const std::vector<std::array<Index, 3>>& triangles)
{
  for (const std::array<Index, 3>& v : triangles) {
    const Point& p = points[v[0]];
    if (CGAL::orientation(p, points[v[1]], points[v[2]]) == RIGHT_TURN)
      throw std::invalid_argument("Bubble_relaxation_2: the " + whose + " has a triangle, at " +
                                  in_words(p.x(), p.y()) +
                                  ", which is turned over when its corners are rounded to double");
  }
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_GEOMETRY_FLATTEN_TRIANGULATION_H
