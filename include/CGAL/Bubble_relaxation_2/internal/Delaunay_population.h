// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DELAUNAY_POPULATION_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DELAUNAY_POPULATION_H

#include <CGAL/Bubble_relaxation_2/internal/Bubble_buckets_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Bubble_mesh_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Local_triangulation_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Neighbor_sets_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Population_change.h>
#include <CGAL/Bubble_relaxation_2/internal/sort_in_space.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// The population control by the triangulation of the bubbles: a hole shows as a large empty circle
/// and gets a bubble in its centre; a crowd shows as a short edge, or as a bubble with four neighbours
/// or less, and loses one. It looks only where bubbles may have moved since it looked last.
template <class Concurrency_tag, class Sizing>
class Delaunay_population
{
public:
  /// insert where the radius of an empty circle exceeds this times d (0.577 in the hexagonal lattice)
  double largest_radius = 0.645;
  /// delete where two bubbles are nearer than this times their mean size
  double least_distance = 0.62;
  /// delete bubbles of the faces with as many neighbours or less
  int ill_connected = 4;

  /// insert between two bubbles of an edge that are farther apart than this times d
  double longest_gap = 1.4;
  /// such a bubble takes the place of bubbles of the faces that are nearer than this times d: they were
  /// pressed into the gap
  double cleared_radius = 0.7;

  Delaunay_population(const Domain_2& domain, const Sizing& sizing)
    : m_domain(domain), m_sizing(sizing)
  {}

  /// `touched`: the bubbles that may have moved
  Population_change operator()(const Bubbles_2& bubbles, const Neighbor_sets_2& neighbors,
                               const std::vector<Index>& touched)
  {
    const auto mesh = Local_triangulation_2::make<Concurrency_tag>(bubbles, neighbors, touched);
    m_change = Population_change();
    m_is_deleted.assign(bubbles.size(), 0);
    delete_crowded(bubbles, mesh);
    insert_in_holes(bubbles, mesh);
    insert_on_edges(bubbles, neighbors);
    std::sort(m_change.deleted.begin(), m_change.deleted.end());
    sort_in_space<Concurrency_tag>(m_domain, m_change.inserted);
    return std::move(m_change);
  }

private:
  using Triangle = std::array<Index, 3>;

  void remove(Index i)
  {
    if (!m_is_deleted[i])
      m_change.deleted.push_back(i);
    m_is_deleted[i] = 1;
  }

  /// whether a triangle belongs to the domain; one with a corner in a face may reach over an edge, but
  /// then bubbles are missing on this edge
  bool is_inside(const Bubbles_2& b, const Triangle& t)
  {
    for (Index i : t)
      if (b.is_in_face(i))
        return true;
    const Point centroid = CGAL::centroid(b.point(t[0]), b.point(t[1]), b.point(t[2]));
    return m_domain.locate_inside(centroid, m_hint) != no_index;
  }

  void delete_crowded(const Bubbles_2& b, const Local_triangulation_2& mesh)
  {
    std::vector<int> degree(b.size(), 0);
    std::vector<double> nearest(b.size(), 1e300); // distance over mean size, least over neighbours
    for (const Triangle& v : mesh.triangles()) {
      if (!is_inside(b, v))
        continue;
      for (int i = 0; i < 3; ++i) {
        const double w = relative_distance(b, v[ccw(i)], v[cw(i)]);
        ++degree[v[i]];
        nearest[v[ccw(i)]] = (std::min)(nearest[v[ccw(i)]], w);
        nearest[v[cw(i)]] = (std::min)(nearest[v[cw(i)]], w);
      }
    }
    // the worst first; the neighbours of a deleted bubble get room and stay
    std::vector<Index> candidates;
    for (Index i : mesh.touched())
      if ((b.is_in_face(i) && degree[i] <= ill_connected) ||
          (b.can_move(i) && nearest[i] < least_distance))
        candidates.push_back(i);
    if (candidates.empty())
      return;
    std::sort(candidates.begin(), candidates.end(), [&](Index i, Index j) {
      return nearest[i] < nearest[j] || (nearest[i] == nearest[j] && i < j);
    });
    const std::vector<std::vector<Index>> around = neighbors_of(candidates, b.size(), mesh);
    std::vector<char> is_kept(b.size(), 0);
    for (std::size_t c = 0; c < candidates.size(); ++c) {
      if (is_kept[candidates[c]])
        continue;
      remove(candidates[c]);
      for (Index j : around[c])
        is_kept[j] = 1;
    }
  }

  /// the neighbours of some bubbles, some twice
  static std::vector<std::vector<Index>> neighbors_of(const std::vector<Index>& some, std::size_t n,
                                                      const Local_triangulation_2& mesh)
  {
    std::vector<Index> position(n, no_index);
    for (std::size_t c = 0; c < some.size(); ++c)
      position[some[c]] = static_cast<Index>(c);
    std::vector<std::vector<Index>> result(some.size());
    for (const Triangle& v : mesh.triangles())
      for (int i = 0; i < 3; ++i)
        if (position[v[i]] != no_index) {
          result[position[v[i]]].push_back(v[ccw(i)]);
          result[position[v[i]]].push_back(v[cw(i)]);
        }
    return result;
  }

  struct Hole
  {
    double radius; // over the size at the centre
    Point center;
    double d;
    Index triangle; // of the domain
  };

  void insert_in_holes(const Bubbles_2& b, const Local_triangulation_2& mesh)
  {
    std::vector<Hole> holes;
    for (const Triangle& t : mesh.triangles())
      add_hole(b, t, holes);
    if (holes.empty())
      return;
    std::sort(holes.begin(), holes.end(), [](const Hole& a, const Hole& c) {
      return a.radius > c.radius || (a.radius == c.radius && a.center < c.center);
    });
    Bubble_buckets_2 inserted(0.9, b.d[0], b.x[0], b.y[0], holes.size());
    for (const Hole& h : holes)
      if (inserted.is_free(h.center.x(), h.center.y(), h.d)) {
        inserted.insert(0, h.center.x(), h.center.y(), h.d);
        m_change.inserted.add(h.center, h.d, Bubbles_2::FACE, h.triangle);
      }
  }

  void add_hole(const Bubbles_2& b, const Triangle& v, std::vector<Hole>& holes)
  {
    if (m_is_deleted[v[0]] || m_is_deleted[v[1]] || m_is_deleted[v[2]])
      return;
    const Point p = b.point(v[0]), q = b.point(v[1]), r = b.point(v[2]);
    if (is_flat(p, q, r))
      return;
    const Point center = CGAL::circumcenter(p, q, r);
    const double radius = std::sqrt(CGAL::squared_distance(center, p));
    // where d jumps, the bubbles around the hole count too; and d is not asked for all triangles
    const double mean = (b.d[v[0]] + b.d[v[1]] + b.d[v[2]]) / 3;
    if (!(radius > largest_radius * mean))
      return;
    const Point centroid = CGAL::centroid(p, q, r);
    const Index start = m_domain.locate_inside(centroid, m_hint);
    if (start == no_index)
      return;
    const Walk_end end = m_domain.walk(start, centroid, center);
    if (end.is_blocked())
      return;
    const double d = m_sizing(center);
    if (radius > largest_radius * d)
      holes.push_back(Hole{radius / d, center, d, end.triangle});
  }

  /// whether the circumcentre would be made of roundings: three bubbles on a slanted edge
  static bool is_flat(const Point& p, const Point& q, const Point& r)
  {
    constexpr double flat = 1e-6;
    const double ux = q.x() - p.x(), uy = q.y() - p.y(), vx = r.x() - p.x(), vy = r.y() - p.y();
    return !(ux * vy - uy * vx > flat * (ux * ux + uy * uy + vx * vx + vy * vy));
  }

  void insert_on_edges(const Bubbles_2& b, const Neighbor_sets_2& neighbors)
  {
    const std::vector<std::vector<Index>> on_edge = bubbles_on_edges(m_domain, b);
    const std::vector<Index> on_corner = bubbles_on_corners(m_domain, b);
    for (std::size_t e = 0; e < on_edge.size(); ++e) {
      Index u = on_corner[m_domain.edges()[e].source];
      double s = 0;
      for (Index v : on_edge[e]) {
        close_gap(b, neighbors, static_cast<Index>(e), u, v, 0.5 * (s + b.s[v]));
        u = v;
        s = b.s[v];
      }
      close_gap(b, neighbors, static_cast<Index>(e), u, on_corner[m_domain.edges()[e].target],
                0.5 * (s + 1));
    }
  }

  void close_gap(const Bubbles_2& b, const Neighbor_sets_2& neighbors, Index e, Index u, Index v,
                 double s)
  {
    if (relative_distance(b, u, v) <= longest_gap)
      return;
    const Point middle = m_domain.point_on_edge(e, s);
    const double d = m_sizing(middle);
    m_change.inserted.add(middle, d, Bubbles_2::EDGE, e, s);
    for (Index end : {u, v})
      for (const Index *j = neighbors.begin(end), *last = neighbors.end(end); j != last; ++j)
        if (b.is_in_face(*j) &&
            CGAL::squared_distance(b.point(*j), middle) < cleared_radius * cleared_radius * d * d)
          remove(*j);
  }

  static double relative_distance(const Bubbles_2& b, Index i, Index j)
  {
    const double dx = b.x[i] - b.x[j], dy = b.y[i] - b.y[j];
    return 2 * std::sqrt(dx * dx + dy * dy) / (b.d[i] + b.d[j]);
  }

  const Domain_2& m_domain;
  const Sizing& m_sizing;
  Population_change m_change;
  std::vector<char> m_is_deleted;
  Index m_hint = 0; // a triangle of the domain near the last point
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DELAUNAY_POPULATION_H
