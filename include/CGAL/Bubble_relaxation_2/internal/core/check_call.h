// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_CORE_CHECK_CALL_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_CORE_CHECK_CALL_H

#include <CGAL/Bubble_relaxation_2/internal/core/Plane_2.h>

#include <CGAL/Bubble_relaxation_parameters.h>
#include <CGAL/property_map.h>

#include <functional>
#include <iterator>
#include <string>
#include <type_traits>
#include <utility>

// What a user writes first and what cannot work: both are met at the door, so that a mistake gives one message in plain
// words instead of many from within.

namespace CGAL::Bubble_relaxation_2::internal {

/// whether a type is a pack of named parameters
struct Pack_test
{
  template <class T, class Tag, class Base>
  static std::true_type test(const Named_function_parameters<T, Tag, Base>*);
  static std::false_type test(const void*);
};

template <class T>
struct Is_pack : decltype(Pack_test::test(static_cast<const std::decay_t<T>*>(nullptr)))
{};

/// whether a triangulation knows which of its edges are constrained
template <class Triangulation, class = void>
struct Has_constraints : std::false_type {};

template <class Triangulation>
struct Has_constraints<Triangulation, std::void_t<decltype(std::declval<const Triangulation&>().is_constrained(
                                        std::declval<const typename Triangulation::Edge&>()))>> : std::true_type
{};

template <class Point, class = void>
struct Has_height : std::false_type {};

template <class Point>
struct Has_height<Point, std::void_t<decltype(std::declval<const Point&>().z())>> : std::true_type {};

template <class Range, class = void>
struct Is_range : std::false_type {};

template <class Range>
struct Is_range<Range, std::void_t<decltype(std::begin(std::declval<const Range&>()))>> : std::true_type {};

template <class T>
struct Unwrapped
{
  using type = T;
};

template <class T>
struct Unwrapped<std::reference_wrapper<T>>
{
  using type = T;
};

/// what a visitor refers to if it is a reference
template <class Visitor>
typename Unwrapped<Visitor>::type& unwrapped(Visitor& visitor)
{
  return visitor;
}

/// the type of a parameter's value, `Param_not_found` if it was not given
template <class NamedParameters, class Tag>
using Value_of = typename Unwrapped<std::decay_t<typename internal_np::Lookup_named_param_def<
  Tag, NamedParameters, internal_np::Param_not_found>::type>>::type;

template <class Value>
constexpr bool is_missing = std::is_same<Value, internal_np::Param_not_found>::value;

/// whether a function of points returns what can be a size; what is no function is judged elsewhere
template <class Size, class Point>
constexpr bool returns_size()
{
  if constexpr (std::is_invocable<const Size&, const Point&>::value) {
    using Result = std::decay_t<std::invoke_result_t<const Size&, const Point&>>;
    return !std::is_void<Result>::value && !std::is_same<Result, std::string>::value &&
           !std::is_pointer<Result>::value;
  }
  return true;
}

/// whether the package has a named parameter with this tag
template <class Tag>
struct Is_name : std::false_type {};

#define CGAL_add_named_parameter(X, Y, Z)                                                            \
  template <>                                                                                        \
  struct Is_name<internal_np::X> : std::true_type {};
#include <CGAL/Bubble_relaxation_2/internal/core/parameters_interface.h>
CGAL_add_named_parameter(callback_t, callback, callback)
CGAL_add_named_parameter(neighbor_radius_t, neighbor_radius, neighbor_radius)
CGAL_add_named_parameter(number_of_iterations_t, number_of_iterations, number_of_iterations)
CGAL_add_named_parameter(vertex_is_constrained_t, vertex_is_constrained, vertex_is_constrained_map)
CGAL_add_named_parameter(protect_constraints_t, protect_constraints, protect_constraints)
CGAL_add_named_parameter(visitor_t, visitor, visitor)
#if CGAL_VERSION_NR >= 1050600000
CGAL_add_named_parameter(seeds_t, seeds, seeds)
CGAL_add_named_parameter(seeds_are_in_domain_t, seeds_are_in_domain, seeds_are_in_domain)
#endif
#if CGAL_VERSION_NR >= 1060000000
CGAL_add_named_parameter(sizing_function_t, sizing_function, sizing_function)
CGAL_add_named_parameter(concurrency_tag_t, concurrency_tag, concurrency_tag)
#endif
#undef CGAL_add_named_parameter

/// whether the package has all names of a pack
struct Name_test
{
  template <class T, class Tag, class Base>
  static constexpr bool test(const Named_function_parameters<T, Tag, Base>*)
  {
    return (Is_name<Tag>::value || std::is_same<Tag, internal_np::all_default_t>::value) &&
           test(static_cast<const Base*>(nullptr));
  }
  static constexpr bool test(const void*) { return true; }
};

/// Whether a triangulation is one of those that can be meshed: with constraints, and of points in the plane.
template <class Cdt>
constexpr bool check_triangulation()
{
  static_assert(!std::is_const<Cdt>::value,
                "the triangulation is changed, so it cannot be const; npbs_place_nodes() leaves it alone");
  static_assert(Has_constraints<Cdt>::value,
                "Bubble_relaxation_2 needs a Constrained_Delaunay_triangulation_2 or a "
                "Constrained_triangulation_plus_2: what has no constraints has no domain");
  if constexpr (Has_constraints<Cdt>::value) {
    constexpr bool has_plane = !Has_height<typename Cdt::Point>::value || Plane_2<Cdt>::has_elevation;
    static_assert(has_plane,
                  "Bubble_relaxation_2 needs points in the plane, or those of a terrain with Projection_traits_xy_3, "
                  "Projection_traits_yz_3 or Projection_traits_xz_3; along other directions, rotate the points");
    return has_plane && !std::is_const<Cdt>::value;
  }
  return false;
}

/// Whether what is given as faces can be some.
template <class Faces>
constexpr bool check_faces()
{
  static_assert(Is_range<Faces>::value, "faces must be a range of Face_handle; one face alone is none");
  return Is_range<Faces>::value;
}

/// Whether points lie in the plane; for what has no use for elevations.
template <class Cdt>
constexpr bool check_flat()
{
  static_assert(!Has_height<typename Cdt::Point>::value,
                "this function of Bubble_relaxation_2 needs points in the plane: it takes no terrain");
  return !Has_height<typename Cdt::Point>::value;
}

/// whether a function of places returns what can be an elevation
template <class Elevation, class Cdt>
constexpr bool returns_elevation()
{
  if constexpr (std::is_invocable<const Elevation&, const Place_2<Cdt>&>::value)
    return std::is_convertible<std::invoke_result_t<const Elevation&, const Place_2<Cdt>&>,
                               typename Cdt::Geom_traits::FT>::value;
  return is_missing<Elevation>;
}

/// whether a map, if it was given, is a property map with keys of a kind
template <class Map, class Key, class = void>
struct Has_keys : std::bool_constant<is_missing<Map>>
{};

template <class Map, class Key>
struct Has_keys<Map, Key, std::void_t<typename boost::property_traits<Map>::category>>
  : std::is_convertible<Key, typename boost::property_traits<Map>::key_type>
{};

/// Whether property maps take what they are asked for.
template <class Cdt, class NamedParameters>
constexpr bool check_maps()
{
  using Vertex_handle = typename Cdt::Vertex_handle;
  constexpr bool has_vertices =
    Has_keys<Value_of<NamedParameters, internal_np::vertex_is_constrained_t>, Vertex_handle>();
  static_assert(has_vertices, "vertex_is_constrained_map must be a property map with Vertex_handle as key, such as the "
                              "Boolean_property_map of a set");
  constexpr bool has_edges =
    Has_keys<Value_of<NamedParameters, internal_np::edge_marker_t>, std::pair<Vertex_handle, Vertex_handle>>();
  static_assert(has_edges, "edge_marker_map must be a property map with std::pair<Vertex_handle, Vertex_handle> as "
                           "key, such as Constraint_marker_map_2");
  using Protection = Value_of<NamedParameters, internal_np::protect_constraints_t>;
  constexpr bool has_protection =
    std::is_same<Protection, bool>::value || Has_keys<Protection, std::pair<Vertex_handle, Vertex_handle>>::value;
  static_assert(has_protection, "protect_constraints must be a bool or a property map with std::pair<Vertex_handle, "
                                "Vertex_handle> as key, such as the Boolean_property_map of a set");
  constexpr bool has_faces =
    Has_keys<Value_of<NamedParameters, internal_np::face_region_t>, typename Cdt::Face_handle>();
  static_assert(has_faces, "face_region_map must be a property map with Face_handle as key, such as Face_region_map_2");
  return has_vertices && has_edges && has_protection && has_faces;
}

/// Whether the values of parameters are of types that can be meant.
template <class Cdt, class NamedParameters>
constexpr bool check_values()
{
  constexpr bool has_names = Name_test::test(static_cast<const NamedParameters*>(nullptr));
  static_assert(has_names, "one of the named parameters is CGAL's and none of Bubble_relaxation_2, which would not "
                           "heed it; the wanted length of edges, for example, is sizing_function");
  using Callback = Value_of<NamedParameters, internal_np::callback_t>;
  constexpr bool has_callback = is_missing<Callback> || std::is_invocable_r<bool, Callback&, double>::value;
  static_assert(has_callback, "callback must be callable with a double, the progress, and return a bool, to go on or not");
  using Seeds = Value_of<NamedParameters, internal_np::seeds_t>;
  constexpr bool has_seeds = is_missing<Seeds> || Is_range<Seeds>::value;
  static_assert(has_seeds, "seeds must be a range of points, such as std::vector<Point>; one point alone is none");
  constexpr bool has_size = returns_size<Value_of<NamedParameters, internal_np::sizing_function_t>, Place_2<Cdt>>();
  static_assert(has_size, "sizing_function must return a number, the wanted length of edges at the point");
  using Elevation = Value_of<NamedParameters, internal_np::elevation_function_t>;
  constexpr bool is_for_terrain = is_missing<Elevation> || Plane_2<Cdt>::has_elevation;
  static_assert(is_for_terrain, "elevation_function is for a terrain, a triangulation with Projection_traits_xy_3, "
                                "Projection_traits_yz_3 or Projection_traits_xz_3");
  constexpr bool has_elevation = !is_for_terrain || returns_elevation<Elevation, Cdt>();
  static_assert(has_elevation, "elevation_function must be callable, as a constant, with a Point_2, the place in the "
                               "plane of the projection, and return a number");
  return has_names && has_callback && has_seeds && has_size && is_for_terrain && has_elevation &&
         check_maps<Cdt, NamedParameters>();
}

/// Calls `body` with a pack of named parameters, for a triangulation and parameters that can be meant; a size alone, a
/// number or a function of points, is `sizing_function`. Else one message says what is wrong, and what is returned,
/// a `Result`, keeps the compiler from saying more.
template <class Cdt, class Result, class NamedParameters, class Body>
auto call_checked(const NamedParameters& np, const Body& body)
{
  if constexpr (!Is_pack<NamedParameters>::value)
    return call_checked<Cdt, Result>(
      Bubble_relaxation_parameters::sizing_function(std::decay_t<NamedParameters>(np)), body);
  else if constexpr (!check_triangulation<Cdt>())
    return Result();
  else if constexpr (!check_values<Cdt, NamedParameters>())
    return Result();
  else
    return body(np);
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_CORE_CHECK_CALL_H
