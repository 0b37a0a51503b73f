// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_READING_READ_DOMAIN_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_READING_READ_DOMAIN_H

#include <CGAL/Bubble_relaxation_2/internal/core/Bubbles_2.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Plane_2.h>
#include <CGAL/Bubble_relaxation_2/internal/core/in_words.h>
#include <CGAL/Bubble_relaxation_2/internal/core/vocabulary.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_2.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_marks_2.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Problem_2.h>
#include <CGAL/Bubble_relaxation_2/internal/reading/Constraint_graph_2.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <stdexcept>
#include <type_traits>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// whether a triangulation is a `Constrained_triangulation_plus_2`, which knows its constraints whole
template <class Cdt>
using Has_constraint_hierarchy = typename Cdt::Constraint_hierarchy_tag;

/// the triangulation in which it keeps its constraints
template <class Cdt>
auto& without_hierarchy(Cdt& cdt)
{
  if constexpr (Has_constraint_hierarchy<Cdt>::value)
    return static_cast<typename Cdt::Triangulation&>(cdt);
  else
    return cdt;
}

/// \throws std::invalid_argument if the hierarchy does not know of a constrained edge. An insertion that throws may
/// leave such, and so may one that rounds the crossing of two constraints.
template <class Cdt, class Vertex_handle>
void check_is_of_constraint(const Cdt& cdt, Vertex_handle u, Vertex_handle v)
{
  if (const_cast<Cdt&>(cdt).is_subconstraint(u, v)) // changes nothing, though CGAL does not say so
    return;
  const auto place = [](Vertex_handle w) {
    return in_words(CGAL::to_double(Plane_2<Cdt>::x(w->point())), CGAL::to_double(Plane_2<Cdt>::y(w->point())));
  };
  throw std::invalid_argument("Bubble_relaxation_2: the edge from " + place(u) + " to " + place(v) +
                              " is constrained, but belongs to no constraint of the triangulation");
}

/// Takes a vertex, which is not an end, out of the polyline of a constraint; its point, too, else it is kept for ever.
template <class Cdt, class Context, class Vertex_iterator>
void take_out_of_polyline(Cdt& cdt, Context& context, Vertex_iterator vertex)
{
  const typename Cdt::Points_in_constraint_iterator point = vertex;
  auto before = vertex, after = vertex;
  cdt.hierarchy_ref().simplify(--before, vertex, ++after);
  context.id().vl_ptr()->erase(point.base());
}

/// The vertices of a user's triangulation in the lexicographic order of their points. In what is read they have the
/// numbers of this order, since the order in which they were inserted must not matter.
struct Sorted_vertices_2
{
  std::vector<Point> points;
  std::vector<void*> addresses;
  std::vector<Index> number; ///< of each vertex of the copy

  /// \param is_before `nullptr` if coordinates are the user's to the last bit. Else some points may be rounded to one
  Sorted_vertices_2(const Triangulation_copy_2& copy, Is_before is_before);
};

/// What the entry points read from a user's triangulation, in arrays: the domain, and which vertex is what.
class Read_domain_2
{
public:
  Domain_2 domain;
  std::unique_ptr<Constraint_graph_2> graph; ///< corners and chains, numbered as in `domain`

  /// vertices inside the domain that no constraint touches: the pinned ones and all others. Only their
  /// points decide their order, whatever the order in which they were inserted.
  std::vector<Index> pinned, free;
  Given_mesh_2 given; ///< where vertices inside and on edges are

  /// Finds out how the mesh looks around the free vertices.
  void look_around(const Marked_copy_2& copy);

protected:
  Read_domain_2(const Marked_copy_2& copy, Is_before is_before);
  ~Read_domain_2(); // not here: the compiled core has what it takes

  /// once it is known which vertices are pinned or given, and which edges are of one constraint only
  void build();

  Sorted_vertices_2 m_vertices;
  std::vector<char> m_is_of_domain, m_is_pinned, m_is_given; // vertices; given as points of a constraint
  std::vector<Constrained_edge_2> m_edges;

private:
  void add_edge(const Marked_copy_2& copy, Index t, int i);

  Marking_error build(const std::vector<char>& is_fixed);

  std::vector<Point> points(const std::vector<Index>& vertices) const;

  /// sorts along a Hilbert curve, so that a search from one vertex to the next is short; returns the points
  std::vector<Point> sort_along_curve(std::vector<Index>& vertices) const;

  /// The neighbours of `v`, counterclockwise from the first one on: a sum depends on the order of its terms.
  void find_ring(const Flat_triangulation_2& tr, Index triangle, Index v, std::vector<Index>& ring) const;
};

/// The order of a triangulation's vertices by their points.
template <class Cdt>
struct Vertex_order
{
  static constexpr Is_before is_before()
  {
    if constexpr (std::is_same<typename Cdt::Geom_traits::FT, double>::value)
      return nullptr;
    else
      return [](const void* u, const void* v) {
        const auto &p = static_cast<const typename Cdt::Vertex*>(u)->point(),
                   &q = static_cast<const typename Cdt::Vertex*>(v)->point();
        const typename Cdt::Geom_traits traits; // that of a projection knows which coordinates count
        const Comparison_result in_x = traits.compare_x_2_object()(p, q);
        return in_x == SMALLER || (in_x == EQUAL && traits.compare_y_2_object()(p, q) == SMALLER);
      };
  }
};

/// What is read from a triangulation of a certain type. It knows the handles of vertices.
template <class Cdt>
class Domain_reading_2 : public Read_domain_2
{
public:
  using Vertex_handle = typename Cdt::Vertex_handle;

  /// `is_pinned(vertex)`: what the user pinned; `said_of_constraints(edges, vertex, stays)` sets which edges are to stay,
  /// and which vertices of edges are no mere splits of a line
  template <class Is_pinned, class Said>
  Domain_reading_2(const Cdt& cdt, const Domain_marks_2<Cdt>& marks, const Is_pinned& is_pinned,
                   const Said& said_of_constraints)
    : Read_domain_2(marks, Vertex_order<Cdt>::is_before())
  {
    said_of_constraints(m_edges, [this](Index v) { return vertex(v); }, m_is_given);
    for (std::size_t v = 0; v < m_is_pinned.size(); ++v)
      if (m_is_of_domain[v])
        m_is_pinned[v] = is_pinned(vertex(static_cast<Index>(v)));
    if constexpr (Has_constraint_hierarchy<Cdt>::value)
      read_hierarchy(cdt, marks);
    build();
  }

  Vertex_handle vertex(Index v) const { return Handles<Cdt>::vertex(m_vertices.addresses[v]); }

  /// Counts pinned vertices of which the mesh will have none.
  template <class Is_pinned>
  void find_pins_outside(const Is_pinned& is_pinned)
  {
    for (std::size_t v = 0; v < m_is_of_domain.size(); ++v)
      if (!m_is_of_domain[v] && is_pinned(vertex(static_cast<Index>(v))) && given.number_of_pins_outside++ == 0)
        given.pin_outside = m_vertices.points[v];
  }

private:
  /// Only vertices that were not given as points of a constraint, on pieces that belong to one constraint only, may
  /// merely split it. Without a hierarchy nothing is known of that.
  void read_hierarchy(const Cdt& cdt, const Domain_marks_2<Cdt>& marks)
  {
    for (auto c = cdt.constraints_begin(); c != cdt.constraints_end(); ++c) {
      const auto first = cdt.vertices_in_constraint_begin(*c), end = cdt.vertices_in_constraint_end(*c);
      Index last = no_index;
      for (auto v = first; v != end; ++v) {
        last = m_vertices.number[marks.vertices(&**v)];
        if (v == first || v.input())
          m_is_given[last] = 1;
      }
      m_is_given[last] = 1;
    }
    for (Constrained_edge_2& e : m_edges)
      if (e.is_in_domain()) {
        const Vertex_handle u = vertex(e.source), v = vertex(e.target);
        check_is_of_constraint(cdt, u, v);
        e.is_of_one_constraint = cdt.number_of_enclosing_constraints(u, v) == 1;
      }
  }
};

/// the vertices of a chain, its corners included
template <class Reading>
std::vector<typename Reading::Vertex_handle> path_of(const Reading& reading, const Constraint_graph_2::Chain& c)
{
  std::vector<typename Reading::Vertex_handle> path{reading.vertex(reading.graph->corners()[c.source])};
  for (Index v : c.splits)
    path.push_back(reading.vertex(v));
  path.push_back(reading.vertex(reading.graph->corners()[c.target]));
  return path;
}

/// the vertex that a bubble of a corner, or of a pinned vertex, stands for
template <class Reading>
typename Reading::Vertex_handle vertex_of_corner(const Reading& reading, const Bubbles_2& bubbles, std::size_t i)
{
  return reading.vertex(bubbles.host[i] != no_index ? reading.graph->corners()[bubbles.host[i]]
                                                    : reading.pinned[bubbles.pin[i]]);
}

/// Where the vertex of another bubble is to be: with exact constructions one on an edge lies there exactly, with others
/// up to rounding. Where points have elevations, it is 0 as long as those are not known.
template <class Cdt, class Reading>
typename Cdt::Point point_of_vertex(const Reading& reading, const Bubbles_2& bubbles, const Elevations<Cdt>& elevations,
                                    std::size_t i)
{
  using Plane = Plane_2<Cdt>;
  using Ft = typename Cdt::Geom_traits::FT;
  const Ft elevation = elevations.empty() ? Ft(0) : elevations[i];
  if constexpr (!std::is_floating_point<Ft>::value)
    if (bubbles.is_on_edge(i)) {
      const Constraint_graph_2::Chain& chain = reading.graph->chains()[bubbles.host[i]];
      const auto &a = reading.vertex(reading.graph->corners()[chain.source])->point(),
                 &b = reading.vertex(reading.graph->corners()[chain.target])->point();
      const Ft s(bubbles.s[i]), ax(Plane::x(a)), ay(Plane::y(a));
      return Plane::point(Ft(ax + s * (Plane::x(b) - ax)), Ft(ay + s * (Plane::y(b) - ay)), elevation);
    }
  return Plane::point(bubbles.x[i], bubbles.y[i], elevation);
}

} // namespace CGAL::Bubble_relaxation_2::internal

#ifndef CGAL_BUBBLE_RELAXATION_2_COMPILED
#include <CGAL/Bubble_relaxation_2/internal/reading/read_domain_impl.h>
#endif

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_READING_READ_DOMAIN_H
