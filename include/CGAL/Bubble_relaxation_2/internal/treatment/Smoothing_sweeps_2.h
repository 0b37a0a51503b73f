// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_TREATMENT_SMOOTHING_SWEEPS_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_TREATMENT_SMOOTHING_SWEEPS_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/Progress.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Team.h>
#include <CGAL/Bubble_relaxation_2/internal/core/parallel_for.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Editable_triangulation_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Greedy_choice.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Marked_triangulation_2.h>
#include <CGAL/Bubble_relaxation_2/internal/treatment/Vertex_smoothing_2.h>

#include <CGAL/radius_ratio_2.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

inline double quality(const Bubble_mesh_2& mesh, Index t)
{
  return radius_ratio(mesh.point(t, 0), mesh.point(t, 1), mesh.point(t, 2));
}

/// whether q of a triangle is at least that
inline bool has_quality(const Bubble_mesh_2& mesh, Index t, double least)
{
  return has_surely_more(mesh, t, least) || quality(mesh, t) >= least;
}

/// the number of a vertex among those of all ranks
inline std::int64_t number_of(const Bubbles_2& b, Index v) { return b.id.empty() ? v : b.id[v]; }

/// whether a triangle has a vertex with this number or a larger one
inline bool has_vertex_from(std::int64_t first, const Bubble_mesh_2& mesh, Index t)
{
  const std::array<Index, 3>& v = mesh.triangles.vertices[t];
  return std::any_of(v.begin(), v.end(), [&](Index i) { return number_of(mesh.bubbles, i) >= first; });
}

/// The smallest q of the triangles that count, 1 if there are none.
inline double smallest_quality(const Bubble_mesh_2& mesh, const std::vector<char>& counts)
{
  double smallest = 1;
  for (std::size_t t = 0; t < counts.size(); ++t) {
    tick(t);
    if (counts[t] && !has_quality(mesh, static_cast<Index>(t), smallest))
      smallest = quality(mesh, static_cast<Index>(t));
  }
  return smallest;
}

inline double smallest_quality(const Bubble_mesh_2& mesh) { return smallest_quality(mesh, mesh.triangles.inside); }

/// How much is done by sweeps.
struct Sweeps
{
  int most;               ///< of them
  double treated_quality; ///< vertices of triangles with a smaller q are moved
};

inline constexpr Sweeps usual_sweeps{4, 0.95};

/// The last defects. Where vertices have five and seven neighbours the forces press triangles more than
/// they must be pressed. So the vertices of bad triangles are moved for the quality of their triangles
/// alone: in sweeps, of which each takes the vertices around those that moved in the last one, with the
/// constrained Delaunay property restored in between. Vertices of other ranks are left to them.
class Smoothing_sweeps_2
{
public:
  Smoothing_sweeps_2(const Domain_2& domain, Bubble_mesh_2& mesh, Team& team, const Threads& threads = Threads())
    : m_threads(threads), m_domain(domain), m_mesh(mesh), m_bubbles(mesh.bubbles), m_team(team)
  {}

  /// Returns the vertices that were moved. It begins with triangles with a vertex from `first` on, see `number_of()`.
  std::vector<Index> operator()(const Sweeps& sweeps = usual_sweeps, std::int64_t first = 0)
  {
    std::optional<Editable_triangulation_2> mesh(std::in_place, m_mesh, &m_log);
    std::vector<char> was_moved(m_bubbles.size(), 0);
    std::vector<Index> candidates = vertices_of_bad_triangles(sweeps.treated_quality, first);
    for (int sweep = 0; sweep < sweeps.most && m_team.any(!candidates.empty() && !is_stop_wanted()); ++sweep) {
      std::vector<Index> moved = move(*mesh, candidates, sweeps.treated_quality);
      mesh->restore_delaunay(moved);
      for (Index v : moved)
        was_moved[v] = 1;
      if (m_team.restore_border(*mesh, moved, was_moved))
        mesh.emplace(m_mesh, &m_log);
      candidates = neighbors_of(*mesh, moved);
    }
    return marked(was_moved);
  }

  /// takes back all moves and flips \pre no other rank has moved vertices, and nobody else has changed the mesh since
  void undo() { m_log.undo(m_mesh); }

private:
  bool may_be_moved(Index v) const { return m_bubbles.can_move(v) && m_bubbles.is_ours(v); }

  std::vector<Index> vertices_of_bad_triangles(double treated_quality, std::int64_t first) const
  {
    std::vector<char> marks(m_bubbles.size(), 0);
    for (std::size_t k = 0; k < m_mesh.triangles.number_of_triangles(); ++k) {
      tick(k);
      const Index t = static_cast<Index>(k);
      if (m_mesh.triangles.inside[k] && has_vertex_from(first, m_mesh, t) && !has_quality(m_mesh, t, treated_quality))
        for (Index v : m_mesh.triangles.vertices[k])
          marks[v] = may_be_moved(v);
    }
    return marked(marks);
  }

  /// tries to move the candidates: neighbours one after the other, others at the same time
  std::vector<Index> move(Editable_triangulation_2& mesh, const std::vector<Index>& candidates, double treated_quality)
  {
    const Vertex_smoothing_2 smooth(m_domain, treated_quality);
    std::vector<std::vector<Index>> independent = independent_sets(mesh, candidates);
    independent.resize(static_cast<std::size_t>(m_team.largest(static_cast<double>(independent.size()))));
    std::vector<Index> result;
    for (const std::vector<Index>& set : independent) {
      std::vector<char> was_moved(set.size(), 0);
      std::vector<Undo_log_2::Vertex> before(set.size());
      parallel_for(
        m_threads, set.size(),
        [&](std::size_t k) {
          before[k] = Undo_log_2::vertex(m_bubbles, set[k]);
          was_moved[k] = smooth(mesh, m_bubbles, set[k]);
        },
        64);
      std::vector<Index> moved;
      for (std::size_t k = 0; k < set.size(); ++k)
        if (was_moved[k]) {
          moved.push_back(set[k]);
          m_log.note(before[k]);
        }
      m_team.share_moved(m_mesh, moved);
      result.insert(result.end(), moved.begin(), moved.end());
    }
    return result;
  }

  enum State : char { IN_NO_SET, UNDECIDED, IN_FIRST_SET }; // the next sets follow

  /// Sets of candidates without neighbours among them: each candidate gets into the first set that none of its
  /// neighbours with a smaller index is in, also of other ranks. Where neighbours are in all sets there may be, it gets
  /// into none.
  std::vector<std::vector<Index>> independent_sets(const Editable_triangulation_2& mesh,
                                                   const std::vector<Index>& candidates) const
  {
    std::vector<char> states(m_bubbles.size(), IN_NO_SET);
    for (Index v : candidates)
      states[v] = UNDECIDED;
    m_team.share(states);
    const auto decide = [&] {
      bool is_open = false;
      std::size_t number = 0;
      for (Index v : candidates) {
        tick(number++);
        if (states[v] == UNDECIDED)
          states[v] = state_of(v, mesh, states);
        is_open = is_open || states[v] == UNDECIDED;
      }
      return is_open;
    };
    decide_together(m_team, decide, [&] { m_team.share(states); });
    std::vector<std::vector<Index>> sets;
    for (Index v : candidates) {
      if (states[v] < IN_FIRST_SET)
        continue;
      const std::size_t set = static_cast<std::size_t>(states[v] - IN_FIRST_SET);
      sets.resize((std::max)(sets.size(), set + 1));
      sets[set].push_back(v);
    }
    return sets;
  }

  static char state_of(Index v, const Editable_triangulation_2& mesh, const std::vector<char>& states)
  {
    constexpr int most = 63; // sets
    std::uint64_t taken = 0;
    for (const Corner_2& c : mesh.star(v))
      for (Index w : mesh.vertices(c.triangle)) {
        if (w >= v || !mesh.is_inside(c.triangle))
          continue;
        if (states[w] == UNDECIDED)
          return UNDECIDED;
        if (states[w] >= IN_FIRST_SET)
          taken |= std::uint64_t(1) << (states[w] - IN_FIRST_SET);
      }
    int set = 0;
    while (set < most && (taken >> set & 1) != 0)
      ++set;
    return static_cast<char>(set < most ? IN_FIRST_SET + set : IN_NO_SET);
  }

  std::vector<Index> neighbors_of(const Editable_triangulation_2& mesh,
                                  const std::vector<Index>& moved) const
  {
    std::vector<char> marks(m_bubbles.size(), 0);
    std::size_t number = 0;
    for (Index v : moved) {
      tick(number++);
      for (const Corner_2& c : mesh.star(v))
        if (mesh.is_inside(c.triangle))
          for (Index w : mesh.vertices(c.triangle))
            marks[w] = may_be_moved(w);
    }
    std::vector<Index> result = marked(marks);
    m_team.add_neighbors_of_others(mesh, result);
    sort_each_once(result);
    return result;
  }

  const Threads m_threads;
  const Domain_2& m_domain;
  Bubble_mesh_2& m_mesh;
  Bubbles_2& m_bubbles;
  Team& m_team;
  Undo_log_2 m_log;
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_TREATMENT_SMOOTHING_SWEEPS_2_H
