// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_PLACEMENT_PLACE_DISTRIBUTED_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_PLACEMENT_PLACE_DISTRIBUTED_H

#include <CGAL/Bubble_relaxation_2/internal/core/Bubbles_2.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Team.h>
#include <CGAL/Bubble_relaxation_2/internal/corners/Cut_domain_2.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mesh/distributed_triangulate.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Communicator.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Messages.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/parts/Hilbert_partition_2.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/parts/bubble_records.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/parts/distribute_bubbles.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/placement/Placement_team_2.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_2.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Problem_2.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/remove_coincident.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Editable_triangulation_2.h>
#include <CGAL/Bubble_relaxation_2/internal/placement/place_bubbles.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// The bubbles to start from, which are given as points on any ranks; or, if no rank has any, as the vertices of
/// the domain's triangulation, which all ranks have. All ranks get those on the outline and the pinned ones, and
/// each an equal share of the others, along the curve.
class Starting_points_2
{
public:
  /// Collective. `points`: what this rank has of them, in the domain before corners were cut off.
  /// \throws std::invalid_argument on all ranks if two points have the same coordinates
  Starting_points_2(Communicator& comm, const Problem_2& problem, const Bubbles_2& points)
    : m_comm(comm), m_domain(problem.whole_domain())
  {
    if (!comm.any(points.size() > 0)) {
      take_share(problem.given);
      return;
    }
    distribute(points);
    if (problem.cut != nullptr)
      problem.cut->cut(m_here);
    for (std::size_t i = 0; i < m_points.size(); ++i)
      if (m_points.is_in_face(i))
        m_here.free.push_back(m_points.point(i));
    if (!problem.options.placement_is_given && comm.any(!m_here.free.empty()))
      look_around();
  }

  /// what this rank gets of them
  const Given_mesh_2& here() const { return m_here; }

private:
  void take_share(const Given_mesh_2& given)
  {
    const std::size_t n = given.free.size(), ranks = static_cast<std::size_t>(m_comm.size()),
                      rank = static_cast<std::size_t>(m_comm.rank());
    m_here.pinned = given.pinned;
    m_here.on_edge = given.on_edge;
    for (std::size_t k = n * rank / ranks; k < n * (rank + 1) / ranks; ++k) {
      m_here.free.push_back(given.free[k]);
      if (!given.around.empty())
        m_here.around.push_back(given.around[k]);
    }
  }

  void distribute(const Bubbles_2& points)
  {
    gather_outline(points);
    const std::set<Point> pinned(m_here.pinned.begin(), m_here.pinned.end());
    Bubbles_2 others;
    for (std::size_t i = 0; i < points.size(); ++i)
      if (pinned.count(points.point(i)) == 0)
        add_own(others, record(points, i, no_index));
    if (m_comm.rank() == 0)
      for (const Point& p : m_here.pinned) {
        others.add(p, std::numeric_limits<double>::quiet_NaN(), Bubbles_2::CORNER, no_index);
        others.id.push_back(no_index);
      }
    m_points = m_distribution(std::move(others), false);
  }

  void gather_outline(const Bubbles_2& b)
  {
    std::vector<Bubble_record_2> placed;
    for (std::size_t i = 0; i < b.size(); ++i)
      if (b.is_on_edge(i) || (b.is_corner(i) && b.host[i] == no_index)) {
        placed.push_back(record(b, i));
        placed.back().s = b.is_on_edge(i) ? position_on_edge(m_domain, b.host[i], b.point(i)) : 0;
      }
    placed = gather_records(m_comm, placed);
    std::sort(placed.begin(), placed.end(), [](const Bubble_record_2& p, const Bubble_record_2& q) {
      return std::tie(p.host, p.s, p.x, p.y) < std::tie(q.host, q.s, q.x, q.y);
    });
    std::vector<Point> pinned;
    m_here.on_edge.assign(m_domain.edges().size(), {});
    for (const Bubble_record_2& p : placed)
      (p.host == no_index ? pinned : m_here.on_edge[p.host]).push_back(Point(p.x, p.y));
    for (Index i : hilbert_order(hilbert_curve(m_domain), pinned)) // as those of the domain, each once
      m_here.pinned.push_back(pinned[i]);
    m_here.pinned.erase(std::unique(m_here.pinned.begin(), m_here.pinned.end()), m_here.pinned.end());
  }

  /// Collective. How the mesh of all given bubbles looks around those in faces.
  void look_around()
  {
    Distributed_mesh_2 mesh = distributed_triangulate(m_domain, m_points, m_distribution.partition(), m_comm);
    const Editable_triangulation_2 triangulation(mesh);
    for (std::size_t i = 0; i < m_points.size(); ++i)
      if (m_points.is_in_face(i)) {
        std::vector<Point> ring; // counterclockwise from the lexicographically smallest on
        for (const Corner_2& c : triangulation.star(mesh.bubbles.index_of(m_points.id[i])))
          ring.push_back(mesh.point(c.triangle, ccw(c.index)));
        std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end()), ring.end());
        m_here.around.push_back(mesh_star(m_points.point(i), ring));
      }
  }

  Communicator& m_comm;
  const Domain_2& m_domain;
  Given_mesh_2 m_here;
  Point_distribution_2 m_distribution{m_domain, m_comm};
  Bubbles_2 m_points; // if there are points: as many on each rank, with corners and pinned ones
};

/// Collective. The bubbles of all ranks, each on the rank that owns its place: what `place`, which is `place_bubbles()`
/// or `given_bubbles()`, makes of a problem with this rank's share of what is given. `points`: of those to start from,
/// if any rank has some; they take the place of the free vertices of the domain's triangulation. As many come to each
/// rank; of those that cannot be told apart one stays, as `remove_coincident()` has it.
inline Placed_part_2 place_by_all(Communicator& comm, const Problem_2& problem, const Bubbles_2& points,
                                  Bubbles_2 (*place)(const Problem_2&, Team&))
{
  const Starting_points_2 given(comm, problem, points);
  const Problem_2 here{problem.domain, given.here(), problem.options, problem.wanted, problem.sizes};
  Placement_team_2 team(comm);
  Bubbles_2 bubbles = place(here, team);
  comm.agree();
  std::vector<Bubble_record_2> records;
  records.reserve(bubbles.size());
  for (std::size_t i = 0; i < bubbles.size(); ++i)
    if (team.brings(i)) // those of faces have no numbers yet
      records.push_back(record(bubbles, i, bubbles.is_in_face(i) ? no_index : team.number_of(i)));
  bubbles = Bubbles_2();
  Placed_part_2 result = send_home_evenly(comm, hilbert_curve(problem.domain), records);
  remove_confusing_of_ours(comm, problem.domain, result.bubbles);
  remove_those_in_one_place(result.bubbles);
  result.bubbles.forget_gone();
  number_along_curve(comm, result.bubbles);
  return result;
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_PLACEMENT_PLACE_DISTRIBUTED_H
