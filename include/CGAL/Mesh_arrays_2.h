// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_MESH_ARRAYS_2_H
#define CGAL_MESH_ARRAYS_2_H

#include <CGAL/license/Bubble_relaxation_2.h>

#include <CGAL/Bubble_relaxation_2/internal/core/disable_warnings.h>

#include <CGAL/Bubble_relaxation_2/internal/core/check_call.h>
#include <CGAL/Bubble_relaxation_2/internal/core/in_words.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_marks_2.h>
#include <CGAL/Bubble_relaxation_parameters.h>

#include <CGAL/iterator.h>
#include <CGAL/utility.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgBubbleRelaxation2Files

The mesh of a domain in arrays, with all that files keep of it: what the functions of `CGAL::IO` write. It is made from
a triangulation, which converts to it, or filled by hand.

Points, triangles and edges are numbered from 0 here; the formats number from 0 or 1 as is their custom.

\sa `CGAL::IO::write_MSH()`
\sa `CGAL::IO::write_VTU()`
\sa `CGAL::IO::write_2DM()`
\sa `CGAL::IO::write_ADCIRC()`
\sa `CGAL::IO::write_triangle_files()`
*/
struct Mesh_arrays_2
{
  using Point_2 = Exact_predicates_inexact_constructions_kernel::Point_2;
  using Triangle = std::array<std::size_t, 3>;
  using Edge = std::array<std::size_t, 2>;

  std::vector<Point_2> points;
  std::vector<double> elevations;  ///< the third coordinates of points of a terrain; empty in the plane
  std::vector<int> vertex_markers; ///< the largest marker of the edges at each point, or 0 if none is larger
  std::map<std::string, std::vector<double>> vertex_data; ///< values at the points, by their names; may be filled
  std::vector<Triangle> triangles; ///< of the domain, counterclockwise
  std::vector<double> regions;     ///< of the triangles; empty if there are none
  std::map<std::string, std::vector<double>> triangle_data; ///< the same of triangles, for `CGAL::IO::write_VTU()`
  std::vector<Edge> edges; ///< on constraints: all of the boundary, with the domain on the left, and those inside
  std::vector<int> edge_markers; ///< 0 for none
  std::vector<Point_2> holes;    ///< a point in each hole

  std::map<int, std::string> marker_names;    ///< may be filled: for formats that have names
  std::map<double, std::string> region_names; ///< may be filled

  Mesh_arrays_2() = default;

  /*!
  takes the part of a triangulation that lies in the domain.

  Tags are numbers, enumerators, or names. Names are numbered from 1 in their alphabetical order, the empty one is 0,
  and `marker_names` and `region_names` are filled.

  \tparam CDT as of `npbs_relax()`

  \cgalNamedParamsBegin
    \cgalParamNBegin{seeds}
      \cgalParamDescription{as in `npbs_relax()`}
      \cgalParamType{a range of points}
      \cgalParamDefault{none: the domain are the marked faces, or else those in an odd number of outlines}
    \cgalParamNEnd
    \cgalParamNBegin{seeds_are_in_domain}
      \cgalParamDescription{as in `npbs_relax()`}
      \cgalParamType{`bool`}
      \cgalParamDefault{`false`}
    \cgalParamNEnd
    \cgalParamNBegin{edge_marker_map}
      \cgalParamDescription{markers of constraints}
      \cgalParamType{a model of `ReadablePropertyMap` with `std::pair<CDT::Vertex_handle, CDT::Vertex_handle>` as key,
                     the ends of an edge as `make_sorted_pair()` sorts them, such as `Constraint_marker_map_2`}
      \cgalParamDefault{edges of the boundary have the marker 1, others 0}
    \cgalParamNEnd
    \cgalParamNBegin{face_region_map}
      \cgalParamDescription{regions of faces}
      \cgalParamType{a model of `ReadablePropertyMap` with `CDT::Face_handle` as key, such as `Face_region_map_2`}
      \cgalParamDefault{there are no regions}
    \cgalParamNEnd
    \cgalParamNBegin{output_iterator}
      \cgalParamDescription{takes the vertices in the order of the points, for `vertex_data`}
      \cgalParamType{a model of `OutputIterator` for `CDT::Vertex_handle`}
      \cgalParamDefault{`Emptyset_iterator`}
    \cgalParamNEnd
  \cgalNamedParamsEnd

  \throws std::invalid_argument as `npbs_relax()` does if there is no domain with constraints all around it, or if a
  marker is a number that is no `int`
  */
  template <class CDT, class NamedParameters = parameters::Default_named_parameters
#ifndef DOXYGEN_RUNNING
            , class = std::enable_if_t<Bubble_relaxation_2::internal::Has_constraints<CDT>::value>
#endif
            >
  Mesh_arrays_2(const CDT& cdt, const NamedParameters& np = parameters::default_values());

  /// gives edges of the boundary that have no marker the marker 1, and then its points the largest of their edges, as
  /// Triangle does. Markers that are missing count as 0.
  /// \throws std::invalid_argument as `check()` does
  void mark_boundary();

  /// the edges of the boundary, of which one triangle only is, each with the domain on its left: among `edges`.
  /// \pre their indices are those of points
  std::vector<Edge> boundary_edges() const;

  /// \throws std::invalid_argument if arrays do not belong together: if one is too short, or an index too large or
  /// twice in a triangle or an edge, if an edge comes twice, or if a coordinate, an elevation, a hole or a region is not
  /// finite
  void check() const;

private:
  using Index = Bubble_relaxation_2::internal::Index;
  using Marks = Bubble_relaxation_2::internal::Marked_copy_2;

  std::vector<Index> add_triangles(const Marks& marks);
  std::vector<Index> add_edges(const Marks& marks);
  void add_holes(const Marks& marks);
  void mark_vertices();
};

namespace Bubble_relaxation_2::internal {

/// the same whatever triangle it is seen from
inline Mesh_arrays_2::Edge sorted_edge(std::size_t a, std::size_t b) { return {(std::min)(a, b), (std::max)(a, b)}; }

/// Tags of the user's type as numbers, and their names if they are names. `name`: of the parameter
template <class Number, class Tag>
std::vector<Number> as_numbers(const std::vector<Tag>& tags, [[maybe_unused]] std::map<Number, std::string>& names,
                               [[maybe_unused]] const char* name)
{
  std::vector<Number> result;
  result.reserve(tags.size());
  if constexpr (std::is_convertible<Tag, std::string>::value) {
    std::map<std::string, Number> numbers{{"", 0}}; // which comes first
    for (const Tag& tag : tags)
      numbers[tag] = 0;
    Number next = 0;
    for (auto& n : numbers) {
      n.second = next++;
      if (!n.first.empty())
        names[n.second] = n.first;
    }
    for (const Tag& tag : tags)
      result.push_back(numbers[tag]);
  } else {
    static_assert(std::is_arithmetic<Tag>::value || std::is_enum<Tag>::value,
                  "markers and regions for files must be numbers, enumerators or names");
    for (const Tag& tag : tags) {
      const double value = static_cast<double>(tag); // exact for all that are taken
      if constexpr (std::is_integral<Number>::value) {
        if (!(value >= -2147483648. && value <= 2147483647.) || value != std::floor(value))
          throw std::invalid_argument(std::string("Bubble_relaxation_2: parameter ") + name + ": the marker " +
                                      in_words(value) + " must be an integer of at most 2147483647 in magnitude");
      } else if constexpr (std::is_integral<Tag>::value) {
        if (std::abs(value) >= 9007199254740992.) // where two of them would become one
          throw std::invalid_argument(std::string("Bubble_relaxation_2: parameter ") + name + ": " + in_words(value) +
                                      " must be less than 2^53 in magnitude");
      }
      result.push_back(static_cast<Number>(value));
    }
  }
  return result;
}

} // namespace Bubble_relaxation_2::internal

template <class CDT, class NamedParameters, class>
Mesh_arrays_2::Mesh_arrays_2(const CDT& cdt, const NamedParameters& np)
{
  using namespace Bubble_relaxation_2::internal;
  using Plane = Plane_2<CDT>;
  const Domain_marks_2<CDT> marks(cdt, np);
  const auto vertex = [&marks](Index v) { return Handles<CDT>::vertex(marks.vertices.addresses()[v]); };
  auto out = parameters::choose_parameter(parameters::get_parameter(np, internal_np::output_iterator),
                                          Emptyset_iterator());
  for (const Index v : add_triangles(marks)) {
    *out++ = vertex(v);
    if constexpr (Plane::has_elevation)
      elevations.push_back(CGAL::to_double(Plane::elevation(vertex(v)->point())));
  }
  if constexpr (Is_given<NamedParameters, internal_np::face_region_t>::value) {
    const auto map = parameters::get_parameter(np, internal_np::face_region);
    std::vector<typename boost::property_traits<std::decay_t<decltype(map)>>::value_type> tags;
    for (std::size_t t = 0; t < marks.tr.number_of_triangles(); ++t)
      if (marks.is_inside(static_cast<Index>(t)))
        tags.push_back(get(map, Handles<CDT>::face(marks.faces.addresses()[t])));
    regions = as_numbers(tags, region_names, "face_region_map");
  }
  [[maybe_unused]] const std::vector<Index> ends = add_edges(marks);
  if constexpr (Is_given<NamedParameters, internal_np::edge_marker_t>::value) {
    const auto map = parameters::get_parameter(np, internal_np::edge_marker);
    std::vector<typename boost::property_traits<std::decay_t<decltype(map)>>::value_type> tags;
    for (std::size_t k = 0; k < ends.size(); k += 2)
      tags.push_back(get(map, make_sorted_pair(vertex(ends[k]), vertex(ends[k + 1]))));
    edge_markers = as_numbers(tags, marker_names, "edge_marker_map");
    mark_vertices();
  } else {
    mark_boundary();
  }
  add_holes(marks);
}

/// adds the triangles of the domain and their points; returns which vertices of the triangulation these are
inline std::vector<Mesh_arrays_2::Index> Mesh_arrays_2::add_triangles(const Marks& marks)
{
  constexpr std::size_t none = static_cast<std::size_t>(-1);
  std::vector<Index> vertices;
  std::vector<std::size_t> number(marks.tr.points.size(), none);
  for (std::size_t t = 0; t < marks.tr.number_of_triangles(); ++t) {
    if (!marks.is_inside(static_cast<Index>(t)))
      continue;
    Triangle triangle;
    for (std::size_t i = 0; i < 3; ++i) {
      const Index v = marks.tr.vertices[t][i];
      if (number[v] == none) {
        number[v] = points.size();
        points.push_back(marks.tr.points[v]);
        vertices.push_back(v);
      }
      triangle[i] = number[v];
    }
    triangles.push_back(triangle);
  }
  vertex_markers.assign(points.size(), 0);
  return vertices;
}

/// adds the constrained edges of the domain; returns the ends of each in the triangulation, one after the other
inline std::vector<Mesh_arrays_2::Index> Mesh_arrays_2::add_edges(const Marks& marks)
{
  std::vector<Index> ends;
  std::size_t triangle = 0;
  for (std::size_t k = 0; k < marks.tr.number_of_triangles(); ++k) {
    const Index t = static_cast<Index>(k);
    if (!marks.is_inside(t))
      continue;
    for (int i = 0; i < 3; ++i) {
      const Index n = marks.tr.neighbors[k][i];
      if (!marks.is_constrained(t, i) || (marks.is_inside(n) && n < t))
        continue;
      const int from = Bubble_relaxation_2::internal::ccw(i), to = Bubble_relaxation_2::internal::cw(i);
      edges.push_back({triangles[triangle][from], triangles[triangle][to]});
      ends.insert(ends.end(), {marks.tr.vertices[k][from], marks.tr.vertices[k][to]});
    }
    ++triangle;
  }
  edge_markers.assign(edges.size(), 0);
  return ends;
}

/// Adds a point in each hole: the centroid of its largest triangle. Constraints that do not bound the domain are not
/// among the edges, so they part no hole.
inline void Mesh_arrays_2::add_holes(const Marks& marks)
{
  const auto& tr = marks.tr;
  std::vector<char> is_reached = tr.inside;
  double largest = 0;
  Point_2 point;
  std::vector<Index> stack;
  const auto reach = [&](Index t) {
    if (is_reached[t])
      return;
    is_reached[t] = 1;
    stack.push_back(t);
    const double area = CGAL::area(tr.point(t, 0), tr.point(t, 1), tr.point(t, 2));
    if (area > largest) {
      largest = area;
      point = CGAL::centroid(tr.point(t, 0), tr.point(t, 1), tr.point(t, 2));
    }
  };
  const auto flood = [&] {
    while (!stack.empty()) {
      const Index t = stack.back();
      stack.pop_back();
      for (int i = 0; i < 3; ++i)
        if (tr.neighbors[t][i] >= 0)
          reach(tr.neighbors[t][i]);
    }
  };
  const Index n = static_cast<Index>(tr.number_of_triangles());
  for (Index t = 0; t < n; ++t) // what lies outside of all outlines is no hole
    for (int i = 0; i < 3; ++i)
      if (tr.neighbors[t][i] < 0)
        reach(t);
  flood();
  for (Index t = 0; t < n; ++t) {
    largest = 0;
    reach(t);
    flood();
    if (largest > 0)
      holes.push_back(point);
  }
}

inline void Mesh_arrays_2::mark_vertices()
{
  for (std::size_t k = 0; k < edges.size(); ++k)
    for (const std::size_t v : edges[k])
      vertex_markers[v] = (std::max)(vertex_markers[v], edge_markers[k]);
}

inline void Mesh_arrays_2::mark_boundary()
{
  vertex_markers.resize((std::max)(vertex_markers.size(), points.size()), 0);
  edge_markers.resize((std::max)(edge_markers.size(), edges.size()), 0);
  check();
  using Bubble_relaxation_2::internal::sorted_edge;
  std::vector<Edge> boundary;
  for (const Edge& e : boundary_edges())
    boundary.push_back(sorted_edge(e[0], e[1]));
  std::sort(boundary.begin(), boundary.end());
  for (std::size_t k = 0; k < edges.size(); ++k)
    if (edge_markers[k] == 0 &&
        std::binary_search(boundary.begin(), boundary.end(), sorted_edge(edges[k][0], edges[k][1])))
      edge_markers[k] = 1;
  mark_vertices();
}

inline std::vector<Mesh_arrays_2::Edge> Mesh_arrays_2::boundary_edges() const
{
  std::vector<char> is_on_edge(points.size(), 0);
  for (const Edge& e : edges)
    is_on_edge[e[0]] = is_on_edge[e[1]] = 1;
  std::vector<Edge> sides, boundary; // sides: of triangles, counterclockwise, as far as they may be edges
  for (const Triangle& t : triangles)
    for (std::size_t i = 0; i < 3; ++i)
      if (is_on_edge[t[i]] && is_on_edge[t[(i + 1) % 3]])
        sides.push_back({t[i], t[(i + 1) % 3]});
  std::sort(sides.begin(), sides.end());
  for (const Edge& e : edges) {
    const Edge turned{e[1], e[0]};
    const bool is_left = std::binary_search(sides.begin(), sides.end(), e);
    if (is_left != std::binary_search(sides.begin(), sides.end(), turned))
      boundary.push_back(is_left ? e : turned);
  }
  return boundary;
}

inline void Mesh_arrays_2::check() const
{
  const auto check_size = [](const std::string& name, std::size_t size, std::size_t needed) {
    if (size != needed)
      throw std::invalid_argument("Bubble_relaxation_2: mesh arrays: " + name + " has " + std::to_string(size) +
                                  " values, " + std::to_string(needed) + " are needed");
  };
  const auto check_indices = [this](const char* name, const auto& cells) {
    for (const auto& cell : cells)
      for (std::size_t k = 0; k < cell.size(); ++k) {
        const std::size_t v = cell[k];
        if (v >= points.size())
          throw std::invalid_argument("Bubble_relaxation_2: mesh arrays: " + std::string(name) + " name the point " +
                                      std::to_string(v) + " of " + std::to_string(points.size()));
        if (v == cell[(k + 1) % cell.size()])
          throw std::invalid_argument("Bubble_relaxation_2: mesh arrays: one of " + std::string(name) +
                                      " has the point " + std::to_string(v) + " twice");
      }
  };
  using Bubble_relaxation_2::internal::in_words;
  for (const std::vector<Point_2>* places : {&points, &holes})
    for (const Point_2& p : *places)
      if (!std::isfinite(p.x()) || !std::isfinite(p.y()))
        throw std::invalid_argument("Bubble_relaxation_2: mesh arrays: the point " + in_words(p.x(), p.y()) +
                                    " must be finite");
  for (const double elevation : elevations)
    if (!std::isfinite(elevation))
      throw std::invalid_argument("Bubble_relaxation_2: mesh arrays: the elevation " + in_words(elevation) +
                                  " must be finite");
  check_size("vertex_markers", vertex_markers.size(), points.size());
  if (!elevations.empty())
    check_size("elevations", elevations.size(), points.size());
  for (const auto& data : vertex_data)
    check_size("the vertex data '" + data.first + "'", data.second.size(), points.size());
  for (const auto& data : triangle_data)
    check_size("the triangle data '" + data.first + "'", data.second.size(), triangles.size());
  if (!regions.empty())
    check_size("regions", regions.size(), triangles.size());
  for (const double region : regions)
    if (!std::isfinite(region))
      throw std::invalid_argument("Bubble_relaxation_2: mesh arrays: the region " + in_words(region) +
                                  " must be finite");
  check_size("edge_markers", edge_markers.size(), edges.size());
  check_indices("triangles", triangles);
  check_indices("edges", edges);
  std::vector<Edge> sorted;
  for (const Edge& e : edges)
    sorted.push_back(Bubble_relaxation_2::internal::sorted_edge(e[0], e[1]));
  std::sort(sorted.begin(), sorted.end());
  const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
  if (twice != sorted.end())
    throw std::invalid_argument("Bubble_relaxation_2: mesh arrays: the edge of the points " +
                                std::to_string((*twice)[0]) + " and " + std::to_string((*twice)[1]) + " comes twice");
}

} // namespace CGAL

#include <CGAL/Bubble_relaxation_2/internal/core/enable_warnings.h>

#endif // CGAL_MESH_ARRAYS_2_H
