// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_TRANSFER_READ_FACES_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_TRANSFER_READ_FACES_H

#include <CGAL/Bubble_relaxation_2/internal/core/read_options.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_marks_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/flatten_triangulation.h>
#include <CGAL/Bubble_relaxation_2/internal/transfer/Transfer_problem_2.h>

#include <CGAL/Bubble_relaxation_parameters.h>

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// The faces of a user's triangulation between which values are transferred, sorted, with their handles.
template <class Triangulation>
class Face_reading_2
{
public:
  using Vertex_handle = typename Triangulation::Vertex_handle;
  using Face_handle = typename Triangulation::Face_handle;

  /// \param what a name for messages: source or target
  /// \throws std::invalid_argument if there are no faces, one is infinite, a coordinate is not finite, or a triangle is
  /// turned over when its corners are rounded to double
  template <class NamedParameters, class Faces_tag, class Map_tag>
  Face_reading_2(const Triangulation& t, const char* what, const NamedParameters& np, Faces_tag faces_tag,
                 Map_tag map_tag)
    : m_triangulation(t), m_what(what)
  {
    if (t.dimension() < 2)
      throw_error("triangulation has the dimension " + std::to_string(t.dimension()) + ", so it has no faces");
    if constexpr (Is_given<NamedParameters, Faces_tag>::value) {
      for (const auto& f : parameters::get_parameter_reference(np, faces_tag))
        add(f);
    } else if constexpr (Is_given<NamedParameters, Map_tag>::value) {
      const auto map = parameters::get_parameter(np, map_tag);
      add_all([&](Face_handle f) { return static_cast<bool>(get(map, f)); });
    } else {
      add_all(Faces_that_count<Triangulation>(t));
    }
    if (m_face_handles.empty())
      throw_error("has no face that takes part");
    sort();
  }

  const Face_set_2& faces() const { return m_sorted; }
  const std::vector<Vertex_handle>& vertices() const { return m_vertex_handles; } ///< of each point
  const std::vector<Face_handle>& handles() const { return m_face_handles; }      ///< of each triangle

private:
  [[noreturn]] void throw_error(const std::string& words) const
  {
    throw std::invalid_argument("Bubble_relaxation_2: the " + std::string(m_what) + " of a transfer " + words);
  }

  template <class Is_wanted>
  void add_all(const Is_wanted& is_wanted)
  {
    for (auto f = m_triangulation.finite_faces_begin(); f != m_triangulation.finite_faces_end(); ++f)
      if (is_wanted(f))
        add(f);
  }

  void add(Face_handle f)
  {
    if (f == Face_handle())
      throw_error("has an empty handle among its faces");
    if (m_triangulation.is_infinite(f))
      throw_error("has an infinite face among its faces");
    m_face_handles.push_back(f);
  }

  void sort()
  {
    auto flat = flatten_triangulation(m_triangulation, m_face_handles);
    m_sorted = {std::move(flat.tr.points), std::move(flat.tr.vertices)};
    m_vertex_handles = std::move(flat.vertices);
    m_face_handles = std::move(flat.faces);
    check_orientations(std::string(m_what) + " of a transfer", m_sorted.points, m_sorted.triangles);
  }

  const Triangulation& m_triangulation;
  const char* m_what;
  Face_set_2 m_sorted;
  std::vector<Vertex_handle> m_vertex_handles;
  std::vector<Face_handle> m_face_handles;
};

/// What is read of both triangulations of a transfer, and what the parameters say of them, without values.
template <class Source_triangulation, class Target_triangulation>
struct Transfer_reading_2
{
  Face_reading_2<Source_triangulation> source;
  Face_reading_2<Target_triangulation> target;
  Transfer_problem_2 problem;

  template <class NamedParameters>
  Transfer_reading_2(const Source_triangulation& from, const Target_triangulation& to, const NamedParameters& np)
    : source(from, "source", np, internal_np::source_faces, internal_np::source_in_domain_map),
      target(to, "target", np, internal_np::target_faces, internal_np::target_in_domain_map)
  {
    problem.source = source.faces();
    problem.target = target.faces();
    take(np, internal_np::keep_integral, problem.keeps_integral);
  }
};

/// The value of `transfer_method`; those of vertices and of faces are different types.
template <class NamedParameters, class Method>
Method read_transfer_method([[maybe_unused]] const NamedParameters& np, Method by_default)
{
  if constexpr (Is_given<NamedParameters, internal_np::transfer_method_t>::value) {
    const auto method = parameters::get_parameter(np, internal_np::transfer_method);
    static_assert(std::is_same<std::decay_t<decltype(method)>, Method>::value,
                  "transfer_method is a Vertex_transfer for values at vertices, a Face_transfer for values of faces");
    return method;
  } else {
    return by_default;
  }
}

/// The values of vertices or faces. `place(k)` is where the k-th lies, for messages.
/// \throws std::invalid_argument if one is not finite
template <class Handle, class Value_map, class Place>
std::vector<double> read_values(const std::vector<Handle>& handles, const Value_map& map, const Place& place)
{
  std::vector<double> values;
  for (Handle h : handles) {
    values.push_back(CGAL::to_double(get(map, h)));
    if (std::isfinite(values.back()))
      continue;
    const Point& p = place(values.size() - 1);
    throw std::invalid_argument("Bubble_relaxation_2: parameter source_values: the value " + in_words(values.back()) +
                                " at " + in_words(p.x(), p.y()) + " must be finite");
  }
  return values;
}

/// Writes the values of vertices or faces.
template <class Handle, class Value_map>
void write_values(const std::vector<double>& values, const std::vector<Handle>& handles, Value_map& map)
{
  for (std::size_t k = 0; k < values.size(); ++k)
    put(map, handles[k], values[k]);
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_TRANSFER_READ_FACES_H
