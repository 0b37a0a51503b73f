// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_OUTLINE_SIMPLIFICATION_READ_OUTLINE_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_OUTLINE_SIMPLIFICATION_READ_OUTLINE_H

#include <CGAL/Bubble_relaxation_2/internal/core/in_words.h>
#include <CGAL/Bubble_relaxation_2/internal/core/read_options.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_marks_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/flatten_triangulation.h>
#include <CGAL/Bubble_relaxation_2/internal/outline_simplification/Simplified_outline_2.h>
#include <CGAL/Bubble_relaxation_2/internal/reading/read_input.h>

#include <CGAL/Bubble_relaxation_parameters.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <stdexcept>
#include <type_traits>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// Reads the named parameters that steer the simplification.
/// \throws std::invalid_argument naming the parameter and its value
template <class NamedParameters>
Simplification_options read_simplification_options(const NamedParameters& np)
{
  Simplification_options o;
  constexpr bool has_length = Is_given<NamedParameters, internal_np::outline_tolerance_t>::value,
                 has_share = Is_given<NamedParameters, internal_np::relative_outline_tolerance_t>::value;
  if constexpr (has_length) {
    o.tolerance = CGAL::to_double(parameters::get_parameter(np, internal_np::outline_tolerance));
    check_positive("outline_tolerance", o.tolerance);
    o.relative_tolerance = (std::numeric_limits<double>::infinity)(); // a length alone counts everywhere
  }
  if constexpr (has_share) {
    o.relative_tolerance = CGAL::to_double(parameters::get_parameter(np, internal_np::relative_outline_tolerance));
    check_positive("relative_outline_tolerance", o.relative_tolerance);
    if (o.relative_tolerance > 1)
      throw_invalid_parameter("relative_outline_tolerance", o.relative_tolerance,
                              "at most 1, a share of the wanted length of pieces");
  }
  const auto take_number = [&](auto tag, const char* name, double& value) {
    if constexpr (Is_given<NamedParameters, decltype(tag)>::value) {
      value = CGAL::to_double(parameters::get_parameter(np, tag));
      check_not_negative(name, value);
    }
  };
  take_number(internal_np::minimum_island_area, "minimum_island_area", o.minimum_island_area);
  take_number(internal_np::minimum_gap, "minimum_gap", o.minimum_gap);
  take_number(internal_np::corner_angle, "corner_angle", o.corner_angle);
  if (o.corner_angle > 180)
    throw_invalid_parameter("corner_angle", o.corner_angle, "at most 180");
  take_maximum_number_of_bubbles(np, o.maximum_number_of_bubbles);
  return o;
}

/// the wanted size; ten times the tolerance if there is no sizing function
template <class Cdt, class NamedParameters>
Sizes_2 sizes_of_pieces(const NamedParameters& np, const Simplification_options& options)
{
  if (const std::optional<Sizes_2> sizes = given_sizes<typename Cdt::Geom_traits::Point_2>(np))
    return *sizes;
  if (!std::isfinite(options.tolerance))
    throw std::invalid_argument("Bubble_relaxation_2: simplify_outline_2 needs the parameter sizing_function, or "
                                "outline_tolerance, a tenth of it");
  return Sizes_2([size = 10 * options.tolerance](double, double) { return size; });
}

/// What is read from a user's triangulation, and which vertex is what.
template <class Cdt>
class Outline_reading_2
{
public:
  using Vertex_handle = typename Cdt::Vertex_handle;

  Simplification_problem_2 problem;
  std::vector<void*> free; ///< vertices that go: those that are neither pinned nor of a constraint

  template <class NamedParameters>
  Outline_reading_2(const Cdt& cdt, const NamedParameters& np)
    : Outline_reading_2(cdt, np, read_simplification_options(np))
  {}

  Vertex_handle vertex(Index v) const { return Handles<Cdt>::vertex(addresses[v]); }

  Index number(Vertex_handle v) const { return m_numbers(&*v); }

private:
  template <class NamedParameters>
  Outline_reading_2(const Cdt& cdt, const NamedParameters& np, const Simplification_options& options)
    : problem{Outline_2(), {}, {}, false, sizes_of_pieces<Cdt>(np, options), options}
  {
    const Domain_marks_2<Cdt> marks(cdt, np);
    const Sorted_vertices_2 vertices(marks, Vertex_order<Cdt>::is_before());
    addresses = vertices.addresses;
    for (void* v : addresses)
      m_numbers.add(v);
    problem.outline.points = vertices.points;
    problem.outline.given = indices_below(addresses.size());
    check_places();
    read_segments(marks, vertices);
    problem.outline.is_fixed.assign(addresses.size(), 0);
    problem.is_end.assign(addresses.size(), 0);
    fix_pinned(is_pinned<Cdt>(np));
    if constexpr (Has_constraint_hierarchy<Cdt>::value)
      find_ends_of_constraints(cdt);
    if constexpr (Is_given<NamedParameters, internal_np::seeds_t>::value)
      for (const auto& seed : parameters::get_parameter(np, internal_np::seeds))
        problem.seeds.push_back(point_in_double<Cdt>(seed));
    problem.seeds_are_in_domain =
      parameters::choose_parameter(parameters::get_parameter(np, internal_np::seeds_are_in_domain), false);
  }

  /// \throws std::invalid_argument if two vertices are in one place
  void check_places() const
  {
    const std::vector<Point>& p = problem.outline.points;
    for (std::size_t v = 1; v < p.size(); ++v)
      if (p[v - 1] == p[v])
        throw std::invalid_argument("Bubble_relaxation_2: two vertices of the triangulation coincide at " +
                                    in_words(p[v].x(), p[v].y()) + " when rounded to double");
  }

  void read_segments(const Domain_marks_2<Cdt>& marks, const Sorted_vertices_2& vertices)
  {
    const Flat_triangulation_2& tr = marks.tr;
    std::vector<Outline_segment_2>& segments = problem.outline.segments;
    for (std::size_t k = 0; k < tr.number_of_triangles(); ++k)
      for (int i = 0; i < 3; ++i) {
        const Index t = static_cast<Index>(k), n = tr.neighbors[k][i];
        if (!marks.is_constrained(t, i) || (n != no_index && n < t))
          continue;
        const Index a = vertices.number[tr.vertices[k][ccw(i)]], b = vertices.number[tr.vertices[k][cw(i)]];
        const bool left = marks.is_inside(t), right = marks.is_inside(n);
        segments.push_back(a < b ? Outline_segment_2{a, b, left, right, no_index}
                                 : Outline_segment_2{b, a, right, left, no_index});
      }
    problem.outline.sort_segments();
    for (std::size_t e = 0; e < segments.size(); ++e)
      segments[e].origin = static_cast<Index>(e);
  }

  /// vertices stay that are pinned, and those of constraints outside of the domain
  template <class Is_pinned>
  void fix_pinned(const Is_pinned& is_pinned)
  {
    std::vector<char>& is_fixed = problem.outline.is_fixed;
    std::vector<char> is_of_segment(addresses.size(), 0);
    for (const Outline_segment_2& s : problem.outline.segments)
      for (Index v : {s.source, s.target}) {
        is_of_segment[v] = 1;
        if (!s.is_in_domain())
          is_fixed[v] = 1;
      }
    for (std::size_t v = 0; v < addresses.size(); ++v) {
      if (is_pinned(vertex(static_cast<Index>(v))))
        is_fixed[v] = 1;
      else if (!is_of_segment[v])
        free.push_back(addresses[v]);
    }
  }

  /// those at which other constraints go on than before; a closed constraint may start anywhere
  void find_ends_of_constraints(const Cdt& cdt)
  {
    std::vector<std::vector<const void*>> before(addresses.size());
    for (const Outline_segment_2& s : problem.outline.segments) {
      std::vector<const void*> constraints;
      const Vertex_handle a = vertex(s.source), b = vertex(s.target);
      check_is_of_constraint(cdt, a, b);
      for (auto c = cdt.contexts_begin(a, b); c != cdt.contexts_end(a, b); ++c)
        constraints.push_back((*c).id().vl_ptr());
      std::sort(constraints.begin(), constraints.end());
      for (Index v : {s.source, s.target})
        if (before[v].empty())
          before[v] = constraints;
        else if (before[v] != constraints)
          problem.is_end[v] = 1;
    }
  }

  std::vector<void*> addresses;
  Address_numbers m_numbers{sizeof(typename Cdt::Vertex)};
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_OUTLINE_SIMPLIFICATION_READ_OUTLINE_H
