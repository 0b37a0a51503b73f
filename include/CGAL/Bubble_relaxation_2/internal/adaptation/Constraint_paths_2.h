// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_ADAPTATION_CONSTRAINT_PATHS_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_ADAPTATION_CONSTRAINT_PATHS_2_H

#include <CGAL/Bubble_relaxation_2/internal/adaptation/Part_reading_2.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/outline.h>

#include <cstddef>
#include <set>
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// calls `visit(u, old, added, v)` for two vertices that are on both paths, and what is between them
template <class Vertex_handle, class Visitor>
void for_each_stretch(const std::vector<Vertex_handle>& before, const std::vector<Vertex_handle>& after,
                      const Visitor& visit)
{
  std::set<const void*> is_old;
  for (Vertex_handle v : before)
    is_old.insert(&*v);
  auto next_before = before.begin() + 1, next_after = after.begin() + 1;
  for (Vertex_handle u = before.front(); next_after != after.end();) {
    std::vector<Vertex_handle> old, added;
    while (is_old.count(&**next_after) == 0)
      added.push_back(*next_after++);
    while (*next_before != *next_after)
      old.push_back(*next_before++);
    visit(u, old, added, *next_after);
    u = *next_after++;
    ++next_before;
  }
}

/// The vertices along the constraints of a part, and how a hierarchy gets to know them.
template <class Cdt>
class Constraint_paths_2
{
  using Vertex_handle = typename Cdt::Vertex_handle;
  using Chain = Constraint_graph_2::Chain;
  using Path = std::vector<Vertex_handle>;

public:
  /// the vertices of a chain from source to target, before and after
  struct Change
  {
    Path before, after;
  };

  explicit Constraint_paths_2(const Part_reading_2<Cdt>& reading) : m_reading(reading) {}

  /// `vertex_of(bubble)`: makes one if there is none
  template <class Vertex_of_bubble>
  void find(const Bubbles_2& bubbles, Vertex_of_bubble& vertex_of)
  {
    const std::vector<std::vector<Index>> on_edge = bubbles_on_edges(m_reading.domain, bubbles);
    for (std::size_t e = 0; e < on_edge.size(); ++e) {
      const Chain& chain = m_reading.graph->chains()[e];
      Change paths{path_of(m_reading, chain), {corner(chain.source)}};
      for (Index i : on_edge[e])
        paths.after.push_back(vertex_of(i));
      paths.after.push_back(corner(chain.target));
      m_changes.push_back(std::move(paths));
    }
  }

  std::size_t size() const { return m_changes.size(); }
  const Change& operator[](std::size_t chain) const { return m_changes[chain]; }

  /// enters what has changed into the polylines of a hierarchy
  void change_hierarchy(Cdt& cdt) const
  {
    const auto change = [&cdt](Vertex_handle u, const Path& old, const Path& added, Vertex_handle v) {
      for (Vertex_handle w : old) { // follows u on the only polyline that goes there
        auto context = *cdt.contexts_begin(u, w);
        auto it = context.current();
        if (*it == u)
          ++it;
        take_out_of_polyline(cdt, context, it);
      }
      Vertex_handle last = u;
      for (Vertex_handle w : added) {
        cdt.hierarchy_ref().split_constraint(last, v, w);
        last = w;
      }
    };
    for (std::size_t e = 0; e < m_changes.size(); ++e)
      if (m_changes[e].before != m_changes[e].after && m_reading.graph->chains()[e].kind == Edge_kind::TAKES_BUBBLES)
        for_each_stretch(m_changes[e].before, m_changes[e].after, change);
  }

private:
  Vertex_handle corner(Index i) const { return m_reading.vertex(m_reading.graph->corners()[i]); }

  const Part_reading_2<Cdt>& m_reading;
  std::vector<Change> m_changes; // of the chains
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_ADAPTATION_CONSTRAINT_PATHS_2_H
