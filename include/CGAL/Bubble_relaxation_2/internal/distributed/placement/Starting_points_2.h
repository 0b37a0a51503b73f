// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_PLACEMENT_STARTING_POINTS_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_PLACEMENT_STARTING_POINTS_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/Bubbles_2.h>
#include <CGAL/Bubble_relaxation_2/internal/corners/Cut_domain_2.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mesh/distributed_triangulate.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Communicator.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Messages.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/parts/Hilbert_partition_2.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/parts/bubble_records.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/parts/distribute_bubbles.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_2.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Problem_2.h>
#include <CGAL/Bubble_relaxation_2/internal/placement/place_bubbles.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// The bubbles to start from, which are given as points on any ranks; or, if no rank has any, as the vertices of
/// the domain's triangulation, which all ranks have. All ranks get those on the outline and the pinned ones, and
/// each an equal share of the others.
class Starting_points_2
{
public:
  /// one in a face
  struct Free
  {
    Point point;
    std::int64_t number; ///< along the curve, among all
  };

  /// Collective. `points`: what this rank has of them, in the domain before corners were cut off.
  /// \throws std::invalid_argument on all ranks if two points have the same coordinates
  Starting_points_2(Communicator& comm, const Problem_2& problem, const Bubbles_2& points)
    : m_comm(comm), m_domain(problem.whole_domain()), m_given(problem.given),
      m_are_points(comm.any(points.size() > 0)), m_distribution(m_domain, comm)
  {
    m_outline.pinned = m_given.pinned;
    m_outline.on_edge = m_given.on_edge;
    if (m_are_points) {
      distribute(points);
      if (problem.cut != nullptr)
        problem.cut->cut(m_outline);
    } else
      take_share();
    m_has_free = comm.any(!m_free.empty());
  }

  const Given_mesh_2& outline() const { return m_outline; }

  /// whether there are any in faces
  bool has_free() const { return m_has_free; }

  /// this rank's share of those in faces, along the curve
  const std::vector<Free>& free() const { return m_free; }

  /// Collective. How the mesh of all given bubbles looks around those of `free()`.
  std::vector<Mesh_star_2> stars() const
  {
    if (m_are_points)
      return stars_of_points();
    std::vector<Mesh_star_2> result;
    for (const Free& f : m_free)
      result.push_back(m_given.around[static_cast<std::size_t>(f.number)]);
    return result;
  }

private:
  void take_share()
  {
    const std::size_t n = m_given.free.size(), ranks = static_cast<std::size_t>(m_comm.size()),
                      rank = static_cast<std::size_t>(m_comm.rank());
    for (std::size_t k = n * rank / ranks; k < n * (rank + 1) / ranks; ++k)
      m_free.push_back(Free{m_given.free[k], static_cast<std::int64_t>(k)});
  }

  void distribute(const Bubbles_2& points)
  {
    gather_outline(points);
    Bubbles_2 others;
    for (std::size_t i = 0; i < points.size(); ++i)
      if (!is_pinned(points.point(i)))
        add_own(others, record(points, i, no_index));
    if (m_comm.rank() == 0)
      for (const Point& p : m_outline.pinned) {
        others.add(p, std::numeric_limits<double>::quiet_NaN(), Bubbles_2::CORNER, no_index);
        others.id.push_back(no_index);
      }
    m_points = m_distribution(std::move(others), false);
    for (std::size_t i = 0; i < m_points.size(); ++i)
      if (m_points.is_in_face(i))
        m_free.push_back(Free{m_points.point(i), m_points.id[i]});
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
    m_outline.on_edge.assign(m_domain.edges().size(), {});
    for (const Bubble_record_2& p : placed)
      (p.host == no_index ? m_outline.pinned : m_outline.on_edge[p.host]).push_back(Point(p.x, p.y));
    sort_pinned();
  }

  /// along the curve, as those of the domain are, and each once
  void sort_pinned()
  {
    std::vector<Point>& pinned = m_outline.pinned;
    std::vector<Point> sorted;
    for (Index i : hilbert_order(hilbert_curve(m_domain), pinned))
      sorted.push_back(pinned[i]);
    sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
    pinned.swap(sorted);
    m_pinned_by_place = pinned;
    std::sort(m_pinned_by_place.begin(), m_pinned_by_place.end());
  }

  bool is_pinned(const Point& p) const
  {
    return std::binary_search(m_pinned_by_place.begin(), m_pinned_by_place.end(), p);
  }

  std::vector<Mesh_star_2> stars_of_points() const
  {
    const Distributed_mesh_2 mesh = distributed_triangulate(m_domain, m_points, m_distribution.partition(), m_comm);
    const Marked_triangles_2& tr = mesh.triangles;
    std::vector<Index> beside(mesh.bubbles.size(), no_index); // a triangle at each vertex
    for (std::size_t t = 0; t < tr.number_of_triangles(); ++t)
      for (Index v : tr.vertices[t])
        beside[v] = static_cast<Index>(t);
    std::vector<Mesh_star_2> result;
    std::size_t v = 0;
    for (const Free& f : m_free) { // in the order of their numbers, as the known ones
      while (mesh.bubbles.id[v] != f.number)
        ++v;
      result.push_back(mesh_star(f.point, ring(mesh, beside[v], static_cast<Index>(v))));
    }
    return result;
  }

  /// the neighbours of an inner vertex of the triangle `t`, counterclockwise from the lexicographically smallest on
  static std::vector<Point> ring(const Bubble_mesh_2& mesh, Index start, Index v)
  {
    const Marked_triangles_2& tr = mesh.triangles;
    std::vector<Point> result;
    Index t = start;
    do {
      const int i = tr.vertices[t][0] == v ? 0 : tr.vertices[t][1] == v ? 1 : 2;
      result.push_back(mesh.point(t, ccw(i)));
      t = tr.neighbors[t][ccw(i)];
    } while (t != start);
    std::rotate(result.begin(), std::min_element(result.begin(), result.end()), result.end());
    return result;
  }

  Communicator& m_comm;
  const Domain_2& m_domain;
  const Given_mesh_2& m_given;
  Given_mesh_2 m_outline; // of it, or of the points
  std::vector<Point> m_pinned_by_place;
  bool m_are_points, m_has_free = false;
  Point_distribution_2 m_distribution;
  Bubbles_2 m_points; // if there are points: as many on each rank, with corners and pinned ones
  std::vector<Free> m_free;
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_PLACEMENT_STARTING_POINTS_2_H
