// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_OUTLINE_SIMPLIFICATION_FORCED_VERTICES_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_OUTLINE_SIMPLIFICATION_FORCED_VERTICES_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/Relaxation_options.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/flatten_triangulation.h>
#include <CGAL/Bubble_relaxation_2/internal/outline_simplification/Outline_2.h>
#include <CGAL/Bubble_relaxation_2/internal/sizes/Outline_sizes_2.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// How many vertices a mesh has at least because of islands and narrows, whatever outline within the tolerance is
/// taken, if sizes grow as those of `npbs_relax()` do by default. No piece of an island is longer than the island with
/// the tolerance around it, and where two parts of the outline that do not hang together are near to each other, no
/// triangle between them is higher than their distance and the tolerances of both. From there sizes grow, and the rest
/// is an integral. Narrows between parts that do hang together are left out: some of them are bays that may go.
class Forced_vertices_2
{
public:
  Forced_vertices_2(const Outline_2& outline, const Outline_demands_2& demands, const Sizes_2& wanted)
    : m_outline(outline), m_demands(demands), m_wanted(wanted)
  {
    Ordered_outline_2 ordered = along_curve(outline);
    m_order = std::move(ordered.order);
    m_is_measured = m_domain.build(std::move(ordered.points), std::move(ordered.edges)) == Marking_error::NONE;
    if (!m_is_measured)
      return; // no rule has looked yet whether segments cross when rounded
    find_components();
    add_islands();
    add_narrows();
  }

  /// \throws std::length_error if the wanted size alone asks for more than `most` vertices
  void check_wanted(std::size_t most) const
  {
    if (!m_is_measured)
      return;
    Expected_number_of_bubbles count(m_domain, m_wanted, static_cast<double>(most));
    if (const double number = count.integral_over_faces(); number > static_cast<double>(most))
      throw_too_many_bubbles(most, "the domain and the sizing function", number, count);
  }

  /// how many vertices the wanted size alone asks for; they, and those that are forced, are without half of the ones on
  /// the outline; 0 where that is not found
  double wanted() const { return m_is_measured ? integral(m_wanted) : 0; }

  /// how many more there are at least
  double forced(double wanted) const
  {
    if (m_sources.empty() || wanted == 0)
      return 0;
    const Sizes_2 forced(Outline_field_2(m_sources, m_domain.bbox(), default_size_growth));
    return (std::max)(0., integral(smaller_of(m_wanted, forced)) - wanted);
  }

private:
  /// A row of triangles in a channel may be lower by a fifth than it should be.
  static constexpr double size_over_width = 1.25;

  static constexpr long most_calls = 20000000; // of a size, for an integral: a second or some

  /// Of the density, in parts small enough to see what grows from a single island. A rough size takes as many parts as
  /// it asks for vertices, and there is no limit to these: the result is 0 if it would take too many.
  double integral(const Sizes_2& sizes) const
  {
    constexpr double fine = 0.25, infinity = (std::numeric_limits<double>::infinity)();
    long calls = 0;
    const Sizes_2 few([&](double x, double y) { return ++calls > most_calls ? infinity : fine * sizes(x, y); });
    const double sum = Expected_number_of_bubbles(m_domain, few, infinity).integral_over_faces();
    return calls > most_calls ? 0 : fine * fine * sum;
  }

  Index root(Index v)
  {
    while (m_component[v] != v)
      v = m_component[v] = m_component[m_component[v]];
    return v;
  }

  void find_components()
  {
    m_component = indices_below(m_outline.points.size());
    for (const Outline_segment_2& s : m_outline.segments) {
      const Index a = root(s.source), b = root(s.target);
      m_component[(std::max)(a, b)] = (std::min)(a, b); // the first vertex tells which it is
    }
    for (Index& v : m_component) // the first vertices come first
      v = m_component[v];
  }

  /// extents in four directions, and the largest demands
  struct Extents
  {
    std::array<double, 4> least, largest;
    double size = 0, tolerance = 0;
  };

  static std::array<double, 4> projections(const Point& p)
  {
    constexpr double diagonal = 0.70710678118654752;
    return {p.x(), p.y(), diagonal * (p.x() + p.y()), diagonal * (p.x() - p.y())};
  }

  void add_islands()
  {
    std::vector<Extents> extents(m_component.size());
    for (std::size_t v = 0; v < m_component.size(); ++v) {
      Extents& e = extents[m_component[v]];
      const std::array<double, 4> p = projections(m_outline.points[v]);
      for (int k = 0; k < 4; ++k) {
        const bool is_first = e.size == 0;
        e.least[k] = is_first ? p[k] : (std::min)(e.least[k], p[k]);
        e.largest[k] = is_first ? p[k] : (std::max)(e.largest[k], p[k]);
      }
      e.size = (std::max)(e.size, m_demands.size[v]);
      e.tolerance = (std::max)(e.tolerance, m_demands.tolerance[v]);
    }
    for (std::size_t v = 0; v < m_component.size(); ++v)
      if (m_component[v] == static_cast<Index>(v))
        add_island(extents[v]);
  }

  void add_island(const Extents& e)
  {
    constexpr double cosine = 0.92387953251128674; // no direction is farther than 22.5 degrees from one of the four
    double diameter = 0;
    for (int k = 0; k < 4; ++k)
      diameter = (std::max)(diameter, (e.largest[k] - e.least[k]) / cosine);
    if (diameter == 0)
      return; // a vertex alone
    const double d = diameter + 2 * e.tolerance, off = 0.5 * diameter + e.tolerance; // of a piece's end from the middle
    if (d < e.size)
      m_sources.push_back({Point(0.5 * (e.least[0] + e.largest[0]), 0.5 * (e.least[1] + e.largest[1])),
                           d + default_size_growth * off});
  }

  void add_narrows()
  {
    const Flat_triangulation_2& tr = m_domain.triangulation();
    for (std::size_t k = 0; k < tr.number_of_triangles(); ++k)
      for (int i = 0; i < 3 && m_domain.is_inside(static_cast<Index>(k)); ++i) {
        const auto& v = tr.vertices[k];
        const Index p = m_order[v[i]], a = m_order[v[ccw(i)]], b = m_order[v[cw(i)]];
        if (m_component[a] != m_component[b])
          add_narrow(a, b, m_outline.points[b]);
        else if (m_component[a] != m_component[p])
          add_narrow(p, a, nearest_on_segment(m_outline.points[p], m_outline.points[a], m_outline.points[b]));
      }
  }

  /// between a vertex and a place near to another one
  void add_narrow(Index v, Index other, const Point& place)
  {
    const double tolerance = (std::max)(m_demands.tolerance[v], m_demands.tolerance[other]),
                 d = size_over_width * (distance(m_outline.points[v], place) + 2 * tolerance);
    if (d < m_demands.size[v])
      m_sources.push_back({m_outline.points[v], d + default_size_growth * tolerance});
  }

  const Outline_2& m_outline;
  const Outline_demands_2& m_demands;
  const Sizes_2& m_wanted;
  std::vector<Index> m_order; // of the domain's corners the vertices
  Domain_2 m_domain;
  bool m_is_measured;
  std::vector<Index> m_component; // of each vertex the first one of those that hang together with it
  std::vector<Size_source_2> m_sources;
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_OUTLINE_SIMPLIFICATION_FORCED_VERTICES_2_H
