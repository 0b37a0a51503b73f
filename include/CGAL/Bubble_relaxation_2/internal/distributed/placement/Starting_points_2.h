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
#include <iterator>
#include <limits>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

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

  /// Collective. `points`: what this rank has of them.
  /// \throws std::invalid_argument on all ranks if two points have the same coordinates
  Starting_points_2(Communicator& comm, const Domain_2& domain,
                  const Given_mesh_2& given, const Bubbles_2& points)
    : m_comm(comm), m_domain(domain), m_given(given),
      m_outline{given.pinned, given.on_edge, {}, {}}, m_are_points(comm.any(points.size() > 0)),
      m_distribution(domain, comm)
  {
    if (m_are_points)
      distribute(points);
    else
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
  /// a point on an edge of the domain, or a pinned one
  struct Placed
  {
    double x, y, s;
    Index edge;

    bool operator<(const Placed& p) const { return std::tie(edge, s, x, y) < std::tie(p.edge, p.s, p.x, p.y); }
  };

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
    m_points = m_distribution(others, false);
    for (std::size_t i = 0; i < m_points.size(); ++i)
      if (m_points.is_in_face(i))
        m_free.push_back(Free{m_points.point(i), m_points.id[i]});
  }

  void gather_outline(const Bubbles_2& b)
  {
    std::vector<Placed> placed;
    for (std::size_t i = 0; i < b.size(); ++i)
      if (b.is_on_edge(i))
        placed.push_back(Placed{b.x[i], b.y[i], position_on_edge(m_domain, b.host[i], b.point(i)), b.host[i]});
      else if (b.is_corner(i) && b.host[i] == no_index)
        placed.push_back(Placed{b.x[i], b.y[i], 0, no_index});
    placed = gather_records(m_comm, placed);
    std::sort(placed.begin(), placed.end());
    m_outline.on_edge.assign(m_domain.edges().size(), {});
    for (const Placed& p : placed)
      (p.edge == no_index ? m_outline.pinned : m_outline.on_edge[p.edge]).push_back(Point(p.x, p.y));
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

/// The order of a rank's bubbles along the curve. Bubbles stay where they are in memory until the end: what is sorted
/// are their keys.
class Curve_sort_2
{
public:
  Curve_sort_2(const Hilbert_curve_2& curve, Bubbles_2& bubbles) : m_curve(curve), m_bubbles(bubbles)
  {
    m_places.reserve(bubbles.size());
  }

  void add(Index i) { m_places.push_back(Place{m_curve.key(m_bubbles.x[i], m_bubbles.y[i]), i}); }

  void sort() { sort_from(0); }

  /// Collective. Cuts the curve so that all ranks own equally many bubbles. \pre they are sorted
  Hilbert_partition_2 even_partition(Communicator& comm) const
  {
    return internal::even_partition(comm, m_curve, m_places);
  }

  /// Collective. Those that other ranks own go there, and others' come here. \pre they are sorted
  void send_home(Communicator& comm, const Hilbert_partition_2& partition)
  {
    std::vector<Place> home;
    Messages<Bubble_record_2> out;
    partition.for_each_owner(m_places.begin(), m_places.end(), [&](int owner, auto first, auto last) {
      if (owner == comm.rank())
        home.assign(first, last);
      else
        std::transform(first, last, std::back_inserter(out[owner]), [this](const Place& p) {
          return record(m_bubbles, static_cast<std::size_t>(p.index), 0);
        });
    });
    m_places.swap(home);
    const std::size_t own = m_places.size();
    for (const auto& message : deliver(comm, out))
      for (const Bubble_record_2& r : message.second) {
        internal::add(m_bubbles, r);
        add(static_cast<Index>(m_bubbles.size() - 1));
      }
    sort_from(own);
  }

  /// Of bubbles in one place the one of the lowest dimension stays. \pre they are sorted
  void forget_coincident()
  {
    m_places.erase(std::unique(m_places.begin(), m_places.end(),
                               [this](const Place& p, const Place& q) {
                                 return p.key == q.key && m_bubbles.x[p.index] == m_bubbles.x[q.index] &&
                                        m_bubbles.y[p.index] == m_bubbles.y[q.index];
                               }),
                   m_places.end());
  }

  /// Keeps these bubbles in this order and forgets the others, once; makes room for those of other ranks that will be
  /// added.
  void select()
  {
    std::vector<Index> order;
    order.reserve(m_places.size());
    for (const Place& p : m_places)
      order.push_back(p.index);
    m_bubbles.select(order);
  }

private:
  struct Place
  {
    Hilbert_curve_2::Key key;
    Index index;
  };

  /// \pre those before `first` are sorted
  void sort_from(std::size_t first)
  {
    merge_tail(m_places, first, [this](const Place& p, const Place& q) {
      return p.key != q.key ? p.key < q.key : values(p) < values(q);
    });
  }

  std::tuple<double, double, int, Index> values(const Place& p) const
  {
    const Index i = p.index;
    return std::make_tuple(m_bubbles.x[i], m_bubbles.y[i], int(m_bubbles.dimension[i]), i);
  }

  const Hilbert_curve_2 m_curve;
  Bubbles_2& m_bubbles;
  std::vector<Place> m_places;
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_PLACEMENT_STARTING_POINTS_2_H
