// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_SEARCH_NEIGHBOR_EXPANSION_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_SEARCH_NEIGHBOR_EXPANSION_2_H

#include <CGAL/Bubble_relaxation_2/internal/meshless/search/Influence_disc_2.h>

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// The search of section 3.2 of the paper: from the nearest node over neighbour sets, as far as nodes are near
/// enough.
///
/// Why it finds all. Let q be a node within rho of a point p, and not nearest to p. On the way from q straight to p
/// one leaves the Voronoi cell of q at a point z, on an edge that q shares with a node q', and |q' - p| < |q - p|.
/// So if the neighbour sets have all Delaunay edges, then from each node a path leads to the node n nearest to p,
/// in which each node is nearer to p than the one before: a descent ends at n, and an expansion from n that keeps
/// within rho meets the path of each q, backwards, and so finds q.
///
/// A Delaunay edge that the sets lack breaks a path only where it is crossed, at z with |q - z| = |q' - z| <= |q - p|
/// < rho. Let the clearance of a node be the least distance from it to the Voronoi edges of those of its Delaunay
/// edges that the sets lack. Of the lacking edges on the path of q take the last: the expansion meets its q', whose
/// clearance is less than rho. So, whatever the domain, an expansion is complete if all nodes that it meets have a
/// clearance of rho or more, and of |n - p| or more, for the descent. Else it may be incomplete.
///
/// In a convex domain with the fill distance F, where all neighbours nearer than R > 2 F are known, no Voronoi edge
/// of a lacking Delaunay edge has a point in the domain, since a point on it is at least R / 2 away from all nodes.
class Neighbor_expansion_2
{
public:
  /// what a thread keeps from query to query
  struct State
  {
    std::int32_t seed = -1;
    std::uint32_t stamp = 0;
    std::vector<std::uint32_t> stamps;
    std::vector<std::int32_t> queue;
  };

  Neighbor_expansion_2(const std::vector<Influence_disc_2>& discs, const Node_buckets_2& buckets,
                       std::vector<std::size_t> offsets, std::vector<std::int32_t> neighbors)
    : m_discs(discs), m_offsets(std::move(offsets)), m_neighbors(std::move(neighbors))
  {
    check_sets();
    const Influence_extent_2 extent(discs);
    m_is_uniform = extent.smallest == extent.largest;
    find_clearances();
    if (!m_is_uniform)
      find_largest_radii(buckets);
    // Nodes that an expansion meets are within four of the radius that it uses, as `search()` tells: two for the
    // disc that has it, one for the nearest node, and one for the node that is met.
    for (std::size_t i = 0; i < discs.size(); ++i)
      if (std::isfinite(m_clearances[i]) && !is_clear(i, largest_radius(buckets, i, 4)))
        ++m_number_of_obstructed;
  }

  /// the number of nodes whose clearance may not do for some point in an influence domain
  std::size_t number_of_obstructed_nodes() const { return m_number_of_obstructed; }

  /// finds the discs that contain a point, in ascending order; returns false if it may not have found all
  bool search(double x, double y, double factor, State& state, std::vector<std::int32_t>& result) const
  {
    result.clear();
    if (m_discs.empty())
      return true;
    if (factor > 1 && !m_is_uniform)
      return false;
    const std::size_t n = descend(x, y, state);
    const double distance = std::sqrt(m_discs[n].squared_distance(x, y));
    const double rho = slack * factor * largest_radius_around(n, distance);
    if (!is_clear(n, (std::max)(rho, distance)))
      return false;
    return !(distance < rho) || expand(x, y, factor, rho, n, state, result);
  }

private:
  static constexpr double slack = 1 + 1e-9; // covers rounding

  /// of the discs that may contain a point to which a node is the nearest
  struct Largest_radii
  {
    double near; ///< if the point is nearer to it than half its radius
    double far;  ///< if it is not
  };

  const std::int32_t* begin(std::size_t i) const { return m_neighbors.data() + m_offsets[i]; }
  const std::int32_t* end(std::size_t i) const { return m_neighbors.data() + m_offsets[i + 1]; }

  bool is_clear(std::size_t i, double distance) const { return m_clearances[i] >= slack * distance; }

  /// the node from which no neighbour is nearer to a point
  std::size_t descend(double x, double y, State& state) const
  {
    std::size_t n = state.seed >= 0 ? static_cast<std::size_t>(state.seed) : start(x, y);
    double least = m_discs[n].squared_distance(x, y);
    for (bool is_moving = true; is_moving;) {
      is_moving = false;
      for (const std::int32_t *j = begin(n), *last = end(n); j != last; ++j) {
        const double squared = m_discs[static_cast<std::size_t>(*j)].squared_distance(x, y);
        if (squared < least) {
          least = squared;
          state.seed = *j;
          is_moving = true;
        }
      }
      if (is_moving)
        n = static_cast<std::size_t>(state.seed);
    }
    state.seed = static_cast<std::int32_t>(n);
    return n;
  }

  /// the nearest of a few nodes, so many that the walk from there has about as many steps
  std::size_t start(double x, double y) const
  {
    const std::size_t step = (std::max)(
      m_discs.size() / static_cast<std::size_t>(std::cbrt(static_cast<double>(m_discs.size()))), std::size_t(1));
    std::size_t best = 0;
    for (std::size_t i = step; i < m_discs.size(); i += step)
      if (m_discs[i].squared_distance(x, y) < m_discs[best].squared_distance(x, y))
        best = i;
    return best;
  }

  /// breadth first
  bool expand(double x, double y, double factor, double rho, std::size_t n, State& state,
              std::vector<std::int32_t>& result) const
  {
    state.stamps.resize(m_discs.size(), 0);
    if (++state.stamp == 0) {
      std::fill(state.stamps.begin(), state.stamps.end(), 0);
      state.stamp = 1;
    }
    state.queue.assign(1, static_cast<std::int32_t>(n));
    state.stamps[n] = state.stamp;
    for (std::size_t k = 0; k < state.queue.size(); ++k) {
      const std::size_t i = static_cast<std::size_t>(state.queue[k]);
      if (!is_clear(i, rho))
        return false;
      if (m_discs[i].contains(x, y, factor))
        result.push_back(state.queue[k]);
      for (const std::int32_t *j = begin(i), *last = end(i); j != last; ++j) {
        const std::size_t node = static_cast<std::size_t>(*j);
        if (state.stamps[node] == state.stamp || !(m_discs[node].squared_distance(x, y) < rho * rho))
          continue;
        state.stamps[node] = state.stamp;
        state.queue.push_back(*j);
      }
    }
    std::sort(result.begin(), result.end());
    return true;
  }

  /// A bound for the radii of the discs that contain a point p, `distance` away from n, the nearest node to it: the
  /// node of such a disc is less than its radius and `distance` away from n. It is no nearer to p than n is, so
  /// that this is less than two of its radii.
  double largest_radius_around(std::size_t n, double distance) const
  {
    if (m_is_uniform)
      return m_discs[n].radius;
    return slack * distance < 0.5 * m_discs[n].radius ? m_largest_radii[n].near : m_largest_radii[n].far;
  }

  void find_largest_radii(const Node_buckets_2& buckets)
  {
    m_largest_radii.resize(m_discs.size());
    for (std::size_t i = 0; i < m_discs.size(); ++i) {
      const Influence_disc_2& d = m_discs[i];
      Largest_radii& largest = m_largest_radii[i];
      largest.near = largest.far = d.radius; // so what is not within two radii, for being small, does not count
      buckets.for_each(d.x, d.y, slack * 2, [&](std::int32_t j) {
        const Influence_disc_2& other = m_discs[static_cast<std::size_t>(j)];
        largest.far = (std::max)(largest.far, other.radius);
        const double reach = slack * (other.radius + 0.5 * d.radius);
        if (other.squared_distance(d.x, d.y) < reach * reach)
          largest.near = (std::max)(largest.near, other.radius);
      });
    }
  }

  /// the largest radius of the discs that reach a node when they are enlarged by a factor
  double largest_radius(const Node_buckets_2& buckets, std::size_t i, double factor) const
  {
    if (m_is_uniform)
      return m_discs[i].radius;
    double largest = 0;
    buckets.for_each(m_discs[i].x, m_discs[i].y, slack * factor, [&](std::int32_t j) {
      largest = (std::max)(largest, m_discs[static_cast<std::size_t>(j)].radius);
    });
    return largest;
  }

  void check_sets() const
  {
    const std::size_t n = m_discs.size();
    bool is_good = m_offsets.size() == n + 1 && m_offsets.front() == 0 && m_offsets.back() == m_neighbors.size();
    for (std::size_t i = 0; is_good && i < n; ++i)
      is_good = m_offsets[i] <= m_offsets[i + 1];
    if (!is_good)
      throw std::invalid_argument("Bubble_relaxation_2: parameter influence_search: the " + std::to_string(n) +
                                  " nodes have no neighbour sets to expand over: there are " +
                                  std::to_string(m_offsets.size()) + " offsets and " +
                                  std::to_string(m_neighbors.size()) + " neighbours");
    for (std::int32_t j : m_neighbors)
      if (j < 0 || static_cast<std::size_t>(j) >= n)
        throw std::invalid_argument("Bubble_relaxation_2: parameter influence_search: a neighbour set has the index " +
                                    std::to_string(j) + ", of " + std::to_string(n) + " nodes");
  }

  bool has(std::int32_t i, std::int32_t j) const
  {
    const auto k = static_cast<std::size_t>(i);
    return std::find(begin(k), end(k), j) != end(k);
  }

  void lower_clearances(std::int32_t i, std::int32_t j, double clearance)
  {
    if (has(i, j) && has(j, i))
      return;
    for (std::int32_t k : {i, j}) {
      double& c = m_clearances[static_cast<std::size_t>(k)];
      c = (std::min)(c, clearance);
    }
  }

  void find_clearances()
  {
    using Vertex_base = Triangulation_vertex_base_with_info_2<std::int32_t, Kernel>;
    using Delaunay = Delaunay_triangulation_2<Kernel, Triangulation_data_structure_2<Vertex_base>>;

    m_clearances.assign(m_discs.size(), std::numeric_limits<double>::infinity());
    std::vector<std::pair<Kernel::Point_2, std::int32_t>> points;
    for (std::size_t i = 0; i < m_discs.size(); ++i)
      points.emplace_back(Kernel::Point_2(m_discs[i].x, m_discs[i].y), static_cast<std::int32_t>(i));
    const Delaunay delaunay(points.begin(), points.end());
    if (delaunay.number_of_vertices() < points.size()) { // it has one of those in one place, which sets have to link
      std::sort(points.begin(), points.end());
      for (std::size_t k = 1; k < points.size(); ++k)
        if (points[k].first == points[k - 1].first)
          lower_clearances(points[k - 1].second, points[k].second, 0);
    }
    for (const auto& e : delaunay.finite_edges()) {
      const auto u = e.first->vertex(delaunay.ccw(e.second)), v = e.first->vertex(delaunay.cw(e.second));
      double clearance = 0.5 * std::sqrt(CGAL::squared_distance(u->point(), v->point()));
      if (delaunay.dimension() == 2) {
        const auto opposite = delaunay.mirror_vertex(e.first, e.second);
        for (const auto& w : {e.first->vertex(e.second), opposite})
          if (!delaunay.is_infinite(w))
            clearance = (std::max)(clearance, distance_to_voronoi_end(u->point(), v->point(), w->point()));
      }
      lower_clearances(u->info(), v->info(), clearance);
    }
  }

  /// How far u is at least from the end of its Voronoi edge with v that the triangle u v w has, if all of that edge
  /// lies beyond this end: when the angle at w is obtuse. Then it is the radius of the circle, rounded down.
  template <class Point_2>
  static double distance_to_voronoi_end(const Point_2& u, const Point_2& v, const Point_2& w)
  {
    const double ax = u.x() - w.x(), ay = u.y() - w.y(), bx = v.x() - w.x(), by = v.y() - w.y();
    if (!(ax * bx + ay * by < 0))
      return 0;
    const double product = std::sqrt((ax * ax + ay * ay) * (bx * bx + by * by));
    const double rounding = 8 * std::numeric_limits<double>::epsilon() * product;
    const double sine = (std::abs(ax * by - ay * bx) + rounding) / product;
    return (1 - 1e-12) * 0.5 * std::sqrt(CGAL::squared_distance(u, v)) / sine;
  }

  const std::vector<Influence_disc_2>& m_discs;
  std::vector<std::size_t> m_offsets;
  std::vector<std::int32_t> m_neighbors;
  std::vector<double> m_clearances;
  std::vector<Largest_radii> m_largest_radii; ///< empty if all are the same
  bool m_is_uniform = true;
  std::size_t m_number_of_obstructed = 0;
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_SEARCH_NEIGHBOR_EXPANSION_2_H
