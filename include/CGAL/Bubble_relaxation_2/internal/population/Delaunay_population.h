// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_POPULATION_DELAUNAY_POPULATION_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_POPULATION_DELAUNAY_POPULATION_H

#include <CGAL/Bubble_relaxation_2/internal/core/Bubbles_2.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Progress.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Sizes_2.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Team.h>
#include <CGAL/Bubble_relaxation_2/internal/core/vocabulary.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/outline.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Neighbor_sets_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Hole_choice_2.h>
#include <CGAL/Bubble_relaxation_2/internal/population/Local_triangulation_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// Whether bubbles are inserted or deleted. First holes are filled, then crowds are thinned out: a place that gets a bubble
/// and loses it in turns would never come to rest.
enum class Population_step { INSERTION, DELETION };

/// The population control of faces by the triangulation of the bubbles: a hole shows as a large empty circle
/// and gets a bubble in its centre; a crowd shows as a short edge, or as a bubble with four neighbours
/// or less, and loses one. It looks only where bubbles may have moved since it looked last. Edges keep the bubbles that
/// were placed on them, as many as their length asks for.
class Delaunay_population
{
public:
  /// insert where the radius of an empty circle exceeds this times d (0.577 in the hexagonal lattice)
  double largest_radius = 0.645;
  /// delete where two bubbles are nearer than this times their mean size
  double least_distance = 0.62;
  /// delete bubbles of the faces with as many neighbours or less
  int ill_connected = 4;

  Delaunay_population(const Domain_2& domain, const Sizes_2& sizing, Team& team, const Threads& threads)
    : m_domain(domain), m_sizing(sizing), m_team(team), m_threads(threads)
  {}

  /// `touched`: the bubbles that may have moved
  Population_change operator()(const Bubbles_2& bubbles, const Neighbor_sets_2& neighbors,
                               const std::vector<Index>& touched, Population_step step)
  {
    const Local_triangulation_2 mesh(bubbles, neighbors, m_team.share_touched(bubbles, touched), m_threads);
    Population_change change;
    if (step == Population_step::INSERTION)
      change.inserted = fill_holes(bubbles, mesh);
    else
      change.deleted = delete_crowded(bubbles, mesh);
    return change;
  }

private:
  using Triangle = std::array<Index, 3>;

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

  /// bubbles that have to go unless a worse neighbour does
  struct Crowded
  {
    std::vector<double> nearest; ///< of each bubble, infinity for those that stay
    std::vector<Index> ours;     ///< the worst first
  };

  std::vector<Index> delete_crowded(const Bubbles_2& b, const Local_triangulation_2& mesh)
  {
    std::vector<Triangle> triangles;
    triangles.reserve(mesh.triangles().size());
    std::size_t number = 0;
    for (const Triangle& t : mesh.triangles()) {
      tick(number++);
      if (is_inside(b, t))
        triangles.push_back(t);
    }
    m_team.share_triangles(b, triangles);
    const Crowded crowded = find_crowded(b, mesh.touched(), triangles);
    Greedy_choice choice; // the worst first; the neighbours of a deleted bubble get room and stay
    choice.start(b.size());
    add_crowded(b, crowded, triangles, choice);
    decide_together(
      m_team, [&] { return choice.decide([](Index) { return true; }); }, [&] { m_team.share(choice.states()); });
    return indices_where(b.size(), [&choice](Index i) { return choice.is_chosen(i); });
  }

  Crowded find_crowded(const Bubbles_2& b, const std::vector<Index>& touched,
                       const std::vector<Triangle>& triangles)
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    std::vector<int> degree(b.size(), 0);
    std::vector<double> nearest(b.size(), infinity); // distance over mean size, least over neighbours
    std::size_t number = 0;
    for (const Triangle& v : triangles) {
      tick(number++);
      for (int i = 0; i < 3; ++i) {
        if (v[i] != no_index)
          ++degree[v[i]];
        const Index p = v[ccw(i)], q = v[cw(i)];
        if (!is_near(b, p, q))
          continue;
        const double w = relative_distance(b, p, q);
        nearest[p] = (std::min)(nearest[p], w);
        nearest[q] = (std::min)(nearest[q], w);
      }
    }
    Crowded result;
    result.nearest.assign(b.size(), infinity);
    for (Index i : touched)
      if (b.is_ours(i) && b.is_in_face(i) && (degree[i] <= ill_connected || nearest[i] < least_distance)) {
        result.nearest[i] = (std::min)(nearest[i], std::numeric_limits<double>::max());
        result.ours.push_back(i);
      }
    m_team.share(result.nearest);
    sort_indices(result.ours, [&](Index i, Index j) { return is_worse(b, result, i, j); });
    return result;
  }

  static bool is_worse(const Bubbles_2& b, const Crowded& crowded, Index i, Index j)
  {
    const double w_i = crowded.nearest[i], w_j = crowded.nearest[j];
    return w_i < w_j || (w_i == w_j && b.is_before(i, j));
  }

  /// the rivals of crowded bubbles are the neighbours that are to go first
  static void add_crowded(const Bubbles_2& b, const Crowded& crowded, const std::vector<Triangle>& triangles,
                          Greedy_choice& choice)
  {
    if (crowded.ours.empty())
      return;
    std::vector<Index> position(b.size(), no_index);
    for (Index i : crowded.ours)
      position[i] = static_cast<Index>(choice.add(i));
    std::size_t number = 0;
    for (const Triangle& v : triangles) {
      tick(number++);
      for (int i = 0; i < 3; ++i)
        if (v[i] != no_index && position[v[i]] != no_index)
          for (Index j : {v[ccw(i)], v[cw(i)]})
            if (is_near(b, v[i], j) && crowded.nearest[j] < std::numeric_limits<double>::infinity() &&
                is_worse(b, crowded, j, v[i]))
              choice.rivals(static_cast<std::size_t>(position[v[i]])).push_back(j);
    }
  }

  Bubbles_2 fill_holes(const Bubbles_2& b, const Local_triangulation_2& mesh)
  {
    constexpr double apart = 0.9; // new bubbles, in units of their mean size
    std::vector<Hole_2> holes;
    std::size_t number = 0;
    for (const Triangle& t : mesh.triangles()) {
      tick(number++);
      add_hole(b, t, holes);
    }
    Bubbles_2 result;
    internal::fill_holes(
      holes, apart, m_team, m_threads, [](const Hole_2&) { return true; }, result);
    sort_in_space(m_domain, result, m_threads);
    m_team.number(result);
    return result;
  }

  void add_hole(const Bubbles_2& b, const Triangle& v, std::vector<Hole_2>& holes)
  {
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
    if (end.is_blocked() || m_domain.is_on_edge(end.triangle, center))
      return;
    const double d = m_sizing(center);
    if (radius > largest_radius * d)
      holes.push_back(Hole_2{-(radius / d), center.x(), center.y(), d, end.triangle});
  }

  /// whether the circumcentre would be made of roundings: three bubbles on a slanted edge
  static bool is_flat(const Point& p, const Point& q, const Point& r)
  {
    constexpr double flat = 1e-6;
    const double ux = q.x() - p.x(), uy = q.y() - p.y(), vx = r.x() - p.x(), vy = r.y() - p.y();
    return !(ux * vy - uy * vx > flat * (ux * ux + uy * uy + vx * vx + vy * vy));
  }

  /// Whether this rank knows both and they are not on two sides of a hole: then one does not crowd the other.
  static bool is_near(const Bubbles_2& b, Index i, Index j)
  {
    constexpr double far = 3; // ranks know bubbles up to a bit more
    return i != no_index && j != no_index && relative_distance(b, i, j) < far;
  }

  static double relative_distance(const Bubbles_2& b, Index i, Index j)
  {
    const double dx = b.x[i] - b.x[j], dy = b.y[i] - b.y[j];
    return 2 * std::sqrt(dx * dx + dy * dy) / (b.d[i] + b.d[j]);
  }

  const Domain_2& m_domain;
  const Sizes_2& m_sizing;
  Team& m_team;
  const Threads m_threads;
  Index m_hint = 0; // a triangle of the domain near the last point
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_POPULATION_DELAUNAY_POPULATION_H
