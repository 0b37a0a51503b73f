// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_WRITING_WRITE_MESH_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_WRITING_WRITE_MESH_H

#include <CGAL/Bubble_relaxation_2/internal/core/Progress.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Team.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/outline.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_marks_2.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/mark_domain.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Sliver_opening_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/locate_straight.h>
#include <CGAL/Bubble_relaxation_2/internal/reading/read_input.h>
#include <CGAL/Bubble_relaxation_2/internal/writing/Direct_write_2.h>
#include <CGAL/Bubble_relaxation_2/internal/writing/count_in_domain.h>
#include <CGAL/Bubble_relaxation_2/internal/writing/split_constraint.h>
#include <CGAL/Bubble_relaxation_report_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// Writes bubbles into the triangulation that their domain was read from: old free vertices go, the
/// constraints are split at their bubbles, the bubbles of the faces are inserted, the domain is marked.
/// Vertices of corners, pinned vertices and all outside of the domain are not touched.
template <class Cdt>
class Write_back_2
{
  using Vertex_handle = typename Cdt::Vertex_handle;
  using Face_handle = typename Cdt::Face_handle;
  using Edge = typename Cdt::Edge;
  using Cdt_point = typename Cdt::Point;
  using Plane = Plane_2<Cdt>;
  using Reading = Domain_reading_2<Cdt>;
  using Chain = Constraint_graph_2::Chain;

public:
  Write_back_2(Cdt& cdt, const Reading& reading, const Bubbles_2& bubbles, const Elevations<Cdt>& elevations)
    : m_cdt(cdt), m_reading(reading), m_bubbles(bubbles), m_elevations(elevations)
  {}

  /// returns the faces of the domain
  template <class Tags>
  Domain_faces_2<Cdt> operator()(const Tags& tags)
  {
    for (Index v : m_reading.free) {
      m_cdt.remove(m_reading.vertex(v));
      tell_progress();
    }
    straighten_constraints();
    split_constraints();
    make_hull_convex(m_cdt, m_on_hull);
    for (Vertex_handle v : m_at_slivers)
      check_hull(v);
    for (Vertex_handle v : m_at_slivers)
      restore_delaunay_around(m_cdt, v);
    insert_in_faces();
    Domain_faces_2<Cdt> faces = mark_domain(m_cdt, [this](const auto& visit) {
      this->for_each_piece([&](const Edge& edge, Vertex_handle source, std::size_t chain) {
        const Chain& c = m_reading.graph->chains()[chain];
        visit(edge, source, c.inside_left, c.inside_right);
      });
    });
    tags.write([this](const auto& visit) { this->for_each_piece(visit); });
    return faces;
  }

private:
  /// a vertex has gone, or come
  void tell_progress() { tick(m_done++, m_reading.free.size() + m_bubbles.size()); }

  Vertex_handle corner(Index i) const { return m_reading.vertex(m_reading.graph->corners()[i]); }
  Cdt_point point_of(std::size_t i) const { return point_of_vertex<Cdt>(m_reading, m_bubbles, m_elevations, i); }

  /// Removes the vertices that only split chains, every other one of each chain first, then every fourth: thus none has
  /// many neighbours when it goes, which it would have beside a gap. Constraints come back at the end.
  void straighten_constraints()
  {
    std::vector<std::pair<std::size_t, Vertex_handle>> splits; // each with a 1 if it is to go first, 2, 4, 8 ...
    for (const Chain& c : m_reading.graph->chains()) {
      if constexpr (Has_constraint_hierarchy<Cdt>::value)
        forget_splits(c);
      for (std::size_t k = 1; k <= c.splits.size(); ++k)
        splits.emplace_back(k & (~k + 1), m_reading.vertex(c.splits[k - 1]));
    }
    std::stable_sort(splits.begin(), splits.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    auto& planar = without_hierarchy(m_cdt);
    for (const auto& split : splits) {
      planar.remove_incident_constraints(split.second);
      planar.remove(split.second);
    }
    for (const Chain& c : m_reading.graph->chains())
      if (!c.splits.empty())
        planar.insert_constraint(corner(c.source), corner(c.target));
  }

  /// takes the vertices that only split the chain out of its polylines
  void forget_splits(const Chain& chain)
  {
    if (chain.splits.empty())
      return;
    auto context = *m_cdt.contexts_begin(corner(chain.source), m_reading.vertex(chain.splits.front()));
    auto it = context.current(); // the end of the piece that comes first in the polyline
    const bool is_forward = *it == corner(chain.source);
    if (is_forward)
      ++it;
    for (std::size_t k = 0; k < chain.splits.size(); ++k)
      take_out_of_polyline(m_cdt, context, is_forward ? it++ : it--);
  }

  void split_constraints()
  {
    const std::vector<std::vector<Index>> on_edge =
      bubbles_on_edges(m_reading.domain, m_bubbles);
    m_paths.resize(on_edge.size());
    for (std::size_t e = 0; e < on_edge.size(); ++e) {
      const Chain& chain = m_reading.graph->chains()[e];
      m_path = &m_paths[e];
      add_to_path(corner(chain.source));
      for (Index i : on_edge[e]) {
        split(corner(chain.target), point_of(static_cast<std::size_t>(i)));
        tell_progress();
      }
      while (end_of_path() != corner(chain.target))
        add_to_path(next_towards(end_of_path(), corner(chain.target)).second);
    }
  }

  /// the first edge on the way from `u` straight to `target`, and its other end
  std::pair<Edge, Vertex_handle> next_towards(Vertex_handle u, Vertex_handle target) const
  {
    Face_handle f;
    int i = 0;
    if (m_cdt.is_edge(u, target, f, i))
      return {Edge(f, i), target};
    Vertex_handle next; // a vertex outside of the domain may lie on the constraint
    if (!m_cdt.includes_edge(u, target, next, f, i))
      throw std::runtime_error("Bubble_relaxation_2: a constraint cannot be found again between its new vertices, since "
                               "others lie nearer to it than a rounding");
    return {Edge(f, i), next};
  }

  static Vertex_handle vertex(void* address) { return Handles<Cdt>::vertex(address); }
  Vertex_handle end_of_path() const { return vertex(m_path->back()); }
  void add_to_path(Vertex_handle v) { m_path->push_back(&*v); }

  /// whether `p` comes before `q` on the way from `from` to `to`, which are not in one place
  bool comes_before(const Cdt_point& p, const Cdt_point& q, const Cdt_point& from, const Cdt_point& to) const
  {
    const double dx = CGAL::to_double(Plane::x(to)) - CGAL::to_double(Plane::x(from)),
                 dy = CGAL::to_double(Plane::y(to)) - CGAL::to_double(Plane::y(from));
    // in the larger coordinate, where roundings across the way do not show
    const auto& traits = m_cdt.geom_traits();
    return std::abs(dx) > std::abs(dy) ? traits.compare_x_2_object()(p, q) == (dx > 0 ? SMALLER : LARGER)
                                       : traits.compare_y_2_object()(p, q) == (dy > 0 ? SMALLER : LARGER);
  }

  /// splits the last part of the path to `target` at `p`
  void split(Vertex_handle target, const Cdt_point& p)
  {
    std::pair<Edge, Vertex_handle> next = next_towards(end_of_path(), target);
    while (next.second != target &&
           comes_before(next.second->point(), p, end_of_path()->point(), target->point())) {
      add_to_path(next.second);
      next = next_towards(end_of_path(), target);
    }
    const Cdt_point place = make_room_for(p, target, next);
    const Face_handle f = next.first.first;
    const bool on_hull = m_cdt.is_infinite(f) || m_cdt.is_infinite(f->neighbor(next.first.second));
    add_to_path(split_constraint(m_cdt, place, f, next.first.second));
    if constexpr (std::is_floating_point<typename Cdt::Geom_traits::FT>::value)
      restore_delaunay_around(m_cdt, end_of_path());
    if (on_hull)
      m_on_hull.insert(m_on_hull.end(), {vertex(m_path->end()[-2]), end_of_path(), next.second});
  }

  /// Where the edge `next` on the way to `target` can be split for `p`. If there is no room, slivers beside it are
  /// opened: a vertex out of the domain may lie beside the edge by a rounding.
  /// \throws std::runtime_error if that does not help
  Cdt_point make_room_for(const Cdt_point& p, Vertex_handle target, std::pair<Edge, Vertex_handle>& next)
  {
    constexpr int most_slivers = 1000;
    Faces_in_place faces{*this};
    Sliver_opening_2<Cdt, Faces_in_place> open_sliver(m_cdt, faces);
    for (int opened = 0;; ++opened) {
      const auto [f, i] = next.first;
      if (const std::optional<Cdt_point> place = nearest_valid(p, f, i))
        return *place;
      if (opened == most_slivers || !(open_sliver(f) || open_sliver(f->neighbor(i))))
        throw_too_flat();
      next = next_towards(end_of_path(), target);
    }
  }

  /// changes faces for the opening of slivers, and notes where
  struct Faces_in_place
  {
    Write_back_2& write;

    Face_handle across(Face_handle f, int i) const { return f->neighbor(i); }

    void flip(Face_handle f, int i)
    {
      const Face_handle n = f->neighbor(i);
      for (Vertex_handle v : {f->vertex(0), f->vertex(1), f->vertex(2), n->vertex(write.m_cdt.mirror_index(f, i))})
        if (!write.m_cdt.is_infinite(v)) {
          write.m_at_slivers.push_back(v);
          write.m_on_hull.push_back(v);
        }
      write.m_cdt.flip(f, i);
    }
  };

  /// `p`, or a point some roundings away, so that splitting the edge at it leaves all triangles
  /// counterclockwise; none if there is no such point
  std::optional<Cdt_point> nearest_valid(const Cdt_point& p, Face_handle f, int i) const
  {
    if (splits_validly(m_cdt, p, f, i))
      return p;
    if constexpr (std::is_floating_point<typename Cdt::Geom_traits::FT>::value) {
      constexpr double infinity = std::numeric_limits<double>::infinity();
      for (int reach = 1; reach <= 4; ++reach)
        for (int k = 0; k < 8; ++k) {
          constexpr int sx[] = {1, -1, 0, 0, 1, 1, -1, -1}, sy[] = {0, 0, 1, -1, 1, -1, 1, -1};
          double x = Plane::x(p), y = Plane::y(p);
          for (int r = 0; r < reach; ++r) {
            x = sx[k] == 0 ? x : std::nextafter(x, sx[k] * infinity);
            y = sy[k] == 0 ? y : std::nextafter(y, sy[k] * infinity);
          }
          const Cdt_point near = moved(p, x, y);
          if (splits_validly(m_cdt, near, f, i))
            return near;
        }
    }
    return std::nullopt;
  }

  /// a point at another place; of a terrain, with the same elevation
  static Cdt_point moved([[maybe_unused]] const Cdt_point& p, double x, double y)
  {
    if constexpr (Plane::has_elevation)
      return Plane::point(x, y, Plane::elevation(p));
    else
      return Cdt_point(x, y);
  }

  /// Where slivers were opened, others may hang on single vertices of the hull.
  /// \throws std::runtime_error if they do
  void check_hull(Vertex_handle v) const
  {
    int infinite = 0;
    auto f = m_cdt.incident_faces(v), first = f;
    do
      infinite += m_cdt.is_infinite(f) ? 1 : 0;
    while (++f != first);
    if (infinite > 2)
      throw_too_flat();
  }

  [[noreturn]] static void throw_too_flat()
  {
    throw std::runtime_error("Bubble_relaxation_2: the triangulation is too flat beside a constraint to split it "
                             "there");
  }

  void insert_in_faces()
  {
    Vertex_handle near = m_cdt.finite_vertices_begin(); // bubbles are numbered along a curve: each is near to the last
    for (std::size_t i = 0; i < m_bubbles.size(); ++i)
      if (m_bubbles.is_in_face(i)) {
        near = insert_straight(m_cdt, point_of(i), near);
        tell_progress();
      }
  }

  template <class Visit>
  void for_each_piece(const Visit& visit) const
  {
    for (std::size_t e = 0; e < m_paths.size(); ++e)
      for (std::size_t k = 1; k < m_paths[e].size(); ++k) {
        const Vertex_handle from = vertex(m_paths[e][k - 1]);
        visit(next_towards(from, vertex(m_paths[e][k])).first, from, e);
      }
  }

  Cdt& m_cdt;
  const Reading& m_reading;
  const Bubbles_2& m_bubbles;
  const Elevations<Cdt>& m_elevations;
  std::vector<std::vector<void*>> m_paths; // the vertices of each chain in order
  std::vector<void*>* m_path = nullptr;    // that of the chain that is split
  std::size_t m_done = 0;                  // vertices that have gone or come
  std::vector<Vertex_handle> m_on_hull;    // bubbles on edges of the hull, and their neighbors
  std::vector<Vertex_handle> m_at_slivers; // corners of those that were opened, and of faces beyond them
};

/// Writes a mesh into the triangulation that its domain was read from: the triangles as they are if there is
/// nothing else in it, else by insertion.
template <class Cdt, class Tags>
void write_mesh(Cdt& cdt, const Domain_reading_2<Cdt>& reading, const Bubble_mesh_2& mesh,
                const Elevations<Cdt>& elevations, const Tags& tags, Report& report)
{
  const Phase_timer timer(report.seconds.writing);
  tags.forget_old(cdt, reading);
  if constexpr (Is_plain<Cdt>::value)
    if (Direct_write_2<Cdt>::is_possible(cdt, reading)) {
      Direct_write_2<Cdt>(cdt, reading, mesh, elevations)(tags);
      return;
    }
  count_in_domain(cdt, Write_back_2<Cdt>(cdt, reading, mesh.bubbles, elevations)(tags), report);
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_WRITING_WRITE_MESH_H
