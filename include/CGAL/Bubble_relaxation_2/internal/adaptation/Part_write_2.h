// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_ADAPTATION_PART_WRITE_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_ADAPTATION_PART_WRITE_2_H

#include <CGAL/Bubble_relaxation_2/internal/adaptation/Border_change_2.h>
#include <CGAL/Bubble_relaxation_2/internal/adaptation/Constraint_paths_2.h>
#include <CGAL/Bubble_relaxation_2/internal/adaptation/Delaunay_repair_2.h>
#include <CGAL/Bubble_relaxation_2/internal/adaptation/Face_exchange_2.h>
#include <CGAL/Bubble_relaxation_2/internal/adaptation/Part_reading_2.h>
#include <CGAL/Bubble_relaxation_2/internal/adaptation/Part_vertices_2.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Progress.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/exact_predicates.h>
#include <CGAL/Bubble_relaxation_2/internal/writing/forget_levels.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// Writes the mesh of a part into the triangulation that it was read from. All that can fail is done by `build()`, of
/// which nothing is left if no exchange follows. `find_unwritable()` is for writes that only try.
template <class Cdt>
class Part_write_2
{
  using Vertex_handle = typename Cdt::Vertex_handle;
  using Face_handle = typename Cdt::Face_handle;
  using Side = typename Face_exchange_2<Cdt>::Side;
  using Chain = Constraint_graph_2::Chain;
  using Path = std::vector<Vertex_handle>;
  using Path_change = typename Constraint_paths_2<Cdt>::Change;

public:
  Part_write_2(Cdt& cdt, const std::vector<Face_handle>& part, const Part_reading_2<Cdt>& reading,
               const Bubble_mesh_2& mesh, const Elevations<Cdt>& elevations)
    : m_cdt(cdt), m_part(part), m_reading(reading), m_mesh(mesh), m_exchange(cdt),
      m_vertices(reading, mesh.bubbles, elevations, m_exchange), m_repair(cdt, m_exchange), m_paths(reading)
  {}

  /// what has to change before a mesh can be written
  struct Unwritable
  {
    /// Those have to go: an edge of the rim cannot bear them, or they are beside a constraint by a rounding where there
    /// is no room for that.
    std::vector<Index> bubbles;
    /// Chains at the border of the domain that have to stay as they are, since what is beyond is too flat.
    std::set<std::size_t> borders;

    bool is_none() const { return bubbles.empty() && borders.empty(); }
  };

  /// Nearly always all triangles can become faces as they are, and to see that takes less than to make them.
  /// `borders`: chains of which it is known that they have to stay; then it is only seen whether others have, too
  /// \throws std::runtime_error if the part is too flat beside a constraint
  Unwritable find_unwritable(const std::set<std::size_t>& borders)
  {
    Unwritable found = build_outside(borders);
    if (!borders.empty())
      return {{}, found.borders};
    if (found.is_none())
      found = around_lost();
    if (!found.is_none())
      return found;
    m_is_delaunay = is_delaunay();
    return m_is_delaunay ? found : build_inside();
  }

  /// whether `find_unwritable()` saw that no edge of the triangles is to be flipped
  bool needs_no_flips() const { return m_is_delaunay; }

  /// Makes the new faces of a mesh of which no bubble has to go. `needs_no_flips`: that is known
  void build(bool needs_no_flips)
  {
    m_is_delaunay = needs_no_flips;
    build_outside({});
    build_inside();
    m_exchange.prepare();
  }

  /// the vertices of a chain before
  const Path& old_path(std::size_t chain) const { return m_paths[chain].before; }

  const Path& removed_vertices() const { return m_vertices.removed(); }
  const Path& new_vertices() const { return m_exchange.new_vertices(); }

  /// those in the domain
  std::vector<Face_handle> new_faces() const
  {
    return {m_exchange.new_faces().begin() + static_cast<std::ptrdiff_t>(m_first_inside), m_exchange.new_faces().end()};
  }

  void exchange() noexcept { m_exchange.exchange(); }

  /// there is no way back then
  void finish()
  {
    if constexpr (Has_constraint_hierarchy<Cdt>::value)
      m_paths.change_hierarchy(m_cdt);
    if constexpr (Has_levels<Cdt>::value)
      forget_levels(levels_of(m_cdt), m_vertices.removed());
    m_exchange.finish(m_vertices.removed());
  }

  /// when all is finished
  template <class Tags>
  void write_tags(const Tags& tags)
  {
    tags.write_part(m_reading.domain, m_mesh, [this](Index v) { return m_vertices(v); },
                    [this](Index t) { return m_faces[t]; });
  }

private:
  /// the new faces out of the domain; returns what has to change for them
  Unwritable build_outside(const std::set<std::size_t>& borders)
  {
    take_part();
    m_paths.find(m_mesh.bubbles, m_vertices);
    for (std::size_t e = 0; e < m_paths.size(); ++e) {
      tick(e);
      if (is_changed_border(e) && borders.count(e) == 0 && !change_border(m_reading.graph->chains()[e], m_paths[e]))
        return {{}, {e}};
    }
    if (!m_exchange.is_sound(m_vertices.removed()) || !m_repair.make_hull_convex())
      return {{}, changed_borders()};
    if (Unwritable flat = around(m_repair.flat_faces(0)); !flat.is_none())
      return flat;
    m_repair.flip(0, true);
    m_first_inside = m_exchange.new_faces().size();
    return {};
  }

  /// the new faces of the part; returns what has to change for them
  Unwritable build_inside()
  {
    add_faces();
    link_faces();
    if (m_is_delaunay)
      return {};
    if (Unwritable flat = around(m_repair.flat_faces(m_first_inside)); !flat.is_none())
      return flat;
    m_repair.flip(m_first_inside, false);
    return {unbearable(), {}};
  }

  /// Whether the triangles are counterclockwise where the user's vertices are, which may be rounded, and of a
  /// constrained Delaunay triangulation with the faces beyond the rim.
  bool is_delaunay()
  {
    const Marked_triangles_2& tr = m_mesh.triangles;
    const auto is_legal = [&](std::size_t t, int i) {
      const Index n = tr.neighbors[t][i];
      if (n == no_index || !tr.inside[n])
        return is_bearable(m_vertices(tr.vertices[t][ccw(i)]), m_vertices(tr.vertices[t][cw(i)]),
                           m_vertices(tr.vertices[t][i]));
      return static_cast<std::size_t>(n) < t || tr.edges[t][i] != no_index ||
             !is_in_circle_of(n, m_vertices(tr.vertices[t][i]));
    };
    for (std::size_t t = 0; t < tr.number_of_triangles(); ++t) {
      tick(t);
      if (!tr.inside[t])
        continue;
      const auto& v = tr.vertices[t];
      const Vertex_handle a = m_vertices(v[0]), b = m_vertices(v[1]), c = m_vertices(v[2]);
      if (!is_counterclockwise<Cdt>(a, b, c) || !is_legal(t, 0) || !is_legal(t, 1) || !is_legal(t, 2))
        return false;
    }
    return true;
  }

  bool is_in_circle_of(Index t, Vertex_handle v)
  {
    const auto& corners = m_mesh.triangles.vertices[t];
    return is_in_circle<Cdt>(m_vertices(corners[0]), m_vertices(corners[1]), m_vertices(corners[2]), v);
  }

  /// whether `w` may be opposite to the side of the part from `u` to `v`: not in the circle of a face beyond it
  bool is_bearable(Vertex_handle u, Vertex_handle v, Vertex_handle w) const
  {
    if (m_exchange.open_side(v, u).face != Face_handle()) // an edge of the border, which is constrained
      return true;
    const Side s = beyond(u, v);
    return s.is_constrained || m_cdt.is_infinite(s.face) ||
           !is_in_circle<Cdt>(s.face->vertex(0), s.face->vertex(1), s.face->vertex(2), w);
  }

  void take_part()
  {
    std::size_t number = 0;
    for (Face_handle f : m_part) {
      tick(number++);
      m_exchange.take(f);
    }
    for (Face_handle f : m_part) {
      tick(number++);
      for (int i = 0; i < 3; ++i)
        if (!m_exchange.is_taken(f->neighbor(i)))
          m_beyond[{&*f->vertex(Cdt::ccw(i)), &*f->vertex(Cdt::cw(i))}] = {f, i};
    }
  }

  /// whether a constraint bounds the domain, and gets other vertices
  bool is_changed_border(std::size_t e) const
  {
    const Chain& chain = m_reading.graph->chains()[e];
    return !(chain.inside_left && chain.inside_right) && m_paths[e].before != m_paths[e].after;
  }

  std::set<std::size_t> changed_borders() const
  {
    std::set<std::size_t> result;
    for (std::size_t e = 0; e < m_paths.size(); ++e)
      if (is_changed_border(e))
        result.insert(e);
    return result;
  }

  /// changes the faces on the other side of a constraint at the border of the domain; returns whether that can be done
  bool change_border(const Chain& chain, const Path_change& paths)
  {
    Path before = paths.before, after = paths.after;
    if (!chain.inside_right) { // what is out of the domain is to be on the left
      std::reverse(before.begin(), before.end());
      std::reverse(after.begin(), after.end());
    }
    for (std::size_t k = 0; k + 1 < before.size(); ++k)
      m_exchange.copy(beyond(before[k + 1], before[k]).face);
    Border_change_2<Cdt> change(m_cdt, m_exchange);
    bool is_done = true;
    const auto change_stretch = [&](Vertex_handle u, const Path& old, const Path& added, Vertex_handle v) {
      for (std::size_t k = 0; k < old.size() && is_done; ++k)
        is_done = change.remove(u, old[k], k + 1 < old.size() ? old[k + 1] : v);
      Vertex_handle last = u;
      for (std::size_t k = 0; k < added.size() && is_done; ++k) {
        change.insert(last, added[k], v);
        last = added[k];
      }
    };
    for_each_stretch<Vertex_handle>(before, after, change_stretch);
    return is_done;
  }

  /// the face beyond the side of the part from `u` to `v`; an open side if there is none
  Side beyond(Vertex_handle u, Vertex_handle v) const
  {
    const auto found = m_beyond.find({&*u, &*v});
    if (found == m_beyond.end())
      throw std::runtime_error("Bubble_relaxation_2: an edge of the part got lost; please report this");
    return m_exchange.side(found->second.first, found->second.second);
  }

  void add_faces()
  {
    const Marked_triangles_2& tr = m_mesh.triangles;
    m_faces.resize(tr.number_of_triangles());
    for (std::size_t t = 0; t < tr.number_of_triangles(); ++t) {
      tick(t);
      if (!tr.inside[t])
        continue;
      const auto& v = tr.vertices[t];
      const Vertex_handle a = m_vertices(v[0]), b = m_vertices(v[1]), c = m_vertices(v[2]); // made in this order
      m_faces[t] = m_exchange.add_face(a, b, c);
      if constexpr (Has_domain_mark<typename Cdt::Face>::value)
        m_faces[t]->set_in_domain(true);
    }
  }

  void link_faces()
  {
    const Marked_triangles_2& tr = m_mesh.triangles;
    for (std::size_t t = 0; t < tr.number_of_triangles(); ++t) {
      tick(t);
      for (int i = 0; i < 3 && tr.inside[t]; ++i) {
        const Index n = tr.neighbors[t][i];
        if (n == no_index || !tr.inside[n])
          m_exchange.link(m_faces[t], i, outer_side(m_faces[t], i));
        else if (static_cast<std::size_t>(n) > t)
          m_exchange.link(m_faces[t], i, Side{m_faces[n], tr.index_of_neighbor(n, static_cast<Index>(t)),
                                              tr.edges[t][i] != no_index});
      }
    }
    if (m_exchange.has_open_sides())
      throw std::runtime_error("Bubble_relaxation_2: an edge of the border got lost; please report this");
  }

  /// what a new face has behind a side where the part ends
  Side outer_side(Face_handle f, int i)
  {
    const Vertex_handle u = f->vertex(Cdt::ccw(i)), v = f->vertex(Cdt::cw(i));
    const Side open = m_exchange.open_side(v, u);
    if (open.face == Face_handle())
      return beyond(u, v);
    m_exchange.forget_open_side(v, u);
    return open;
  }

  /// The vertices seen from an edge of the rim in the circle of the face behind it. One that cannot go has been there
  /// before: then it is not this mesh that is not Delaunay, but what lies beyond the rim.
  std::vector<Index> unbearable() const
  {
    std::vector<Index> result;
    for (std::size_t k = m_first_inside; k < m_exchange.new_faces().size(); ++k) {
      tick(k);
      const Face_handle f = m_exchange.new_faces()[k];
      for (int i = 0; i < 3; ++i)
        if (!m_exchange.is_new(f->neighbor(i)) && !f->is_constrained(i) && m_repair.is_illegal(f, i))
          add_conflicts(f, i, result);
    }
    return only_movable(std::move(result));
  }

  /// All at once: beside a needle there may be thousands behind each other.
  void add_conflicts(Face_handle first, int side, std::vector<Index>& bubbles) const
  {
    const Face_handle beyond = first->neighbor(side);
    std::vector<std::pair<Face_handle, int>> to_see{{first, side}};
    std::set<const void*> seen{&*first};
    while (!to_see.empty()) {
      const auto [f, i] = to_see.back();
      to_see.pop_back();
      if (!is_in_circle<Cdt>(beyond->vertex(0), beyond->vertex(1), beyond->vertex(2), f->vertex(i)))
        continue;
      bubbles.push_back(m_vertices.bubble(f->vertex(i)));
      for (int k : {Cdt::ccw(i), Cdt::cw(i)}) {
        const Face_handle n = f->neighbor(k);
        if (!f->is_constrained(k) && m_exchange.is_new(n) && seen.insert(&*n).second)
          to_see.emplace_back(n, m_exchange.side(f, k).index);
      }
    }
  }

  /// What has to change since bubbles are in no triangle: a pinned vertex beside an edge by a rounding may come to lie
  /// beyond bubbles of that.
  Unwritable around_lost() const
  {
    std::vector<char> is_in_triangle(m_mesh.bubbles.size(), 0);
    for (std::size_t t = 0; t < m_mesh.triangles.number_of_triangles(); ++t)
      for (int i = 0; i < 3 && m_mesh.triangles.inside[t]; ++i)
        is_in_triangle[m_mesh.triangles.vertices[t][i]] = 1;
    Unwritable result;
    for (std::size_t i = 0; i < is_in_triangle.size(); ++i)
      if (!is_in_triangle[i]) {
        if (m_mesh.bubbles.can_move(i))
          result.bubbles.push_back(static_cast<Index>(i));
        else
          result.borders = changed_borders();
      }
    return result;
  }

  /// What has to change since faces are flat: bubbles at them that can go, or else all that has changed at the border.
  /// \throws std::runtime_error if there is neither
  Unwritable around(const std::vector<Face_handle>& flat) const
  {
    Unwritable result;
    for (Face_handle f : flat)
      for (int i = 0; i < 3; ++i)
        result.bubbles.push_back(m_vertices.bubble(f->vertex(i)));
    result.bubbles = only_movable(std::move(result.bubbles));
    if (result.bubbles.empty() && !flat.empty())
      result.borders = changed_borders();
    if (result.is_none() && !flat.empty())
      throw std::runtime_error("Bubble_relaxation_2: the triangulation is too flat beside a constraint to change it "
                               "there");
    return result;
  }

  std::vector<Index> only_movable(std::vector<Index> those) const
  {
    sort_each_once(those);
    those.erase(std::remove_if(those.begin(), those.end(),
                               [&](Index i) { return i == no_index || !m_mesh.bubbles.can_move(i); }),
                those.end());
    return those;
  }

  Cdt& m_cdt;
  const std::vector<Face_handle>& m_part;
  const Part_reading_2<Cdt>& m_reading;
  const Bubble_mesh_2& m_mesh;
  Face_exchange_2<Cdt> m_exchange;
  Part_vertices_2<Cdt> m_vertices;
  Delaunay_repair_2<Cdt> m_repair;
  std::map<std::pair<const void*, const void*>, std::pair<Face_handle, int>> m_beyond; // sides by their ends
  Constraint_paths_2<Cdt> m_paths;
  std::vector<Face_handle> m_faces; // of the triangles that are inside
  std::size_t m_first_inside = 0;   // of the new faces
  bool m_is_delaunay = false;       // the triangles, as they are; false if that is not known
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_ADAPTATION_PART_WRITE_2_H
