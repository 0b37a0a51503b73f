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
#include <CGAL/Bubble_relaxation_2/internal/Population_change.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// The population control by the triangulation of the bubbles: a hole shows as a large empty circle
/// and gets a bubble in its centre; a crowd shows as a short edge, or as a bubble with four neighbours
/// or less, and loses one.
template <class Sizing>
class Delaunay_population
{
public:
  /// insert where the radius of an empty circle exceeds this times d (0.577 in the hexagonal lattice)
  double largest_radius = 0.66;
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

  Population_change operator()(const Bubbles_2& bubbles) const
  {
    const Marked_triangulation_2 mesh = triangulate(m_domain, bubbles);
    Population_change change;
    change.is_deleted.assign(bubbles.size(), 0);
    delete_crowded(bubbles, mesh, change);
    insert_in_holes(bubbles, mesh, change);
    insert_on_edges(bubbles, mesh, change);
    return change;
  }

private:
  void delete_crowded(const Bubbles_2& b, const Marked_triangulation_2& mesh,
                      Population_change& change) const
  {
    std::vector<int> degree(b.size(), 0);
    std::vector<double> nearest(b.size(), 1e300); // distance over mean size, least over neighbours
    for (std::size_t t = 0; t < mesh.inside.size(); ++t) {
      if (!mesh.inside[t])
        continue;
      for (int i = 0; i < 3; ++i) {
        const Index p = mesh.tr.vertices[t][ccw(i)], q = mesh.tr.vertices[t][cw(i)];
        ++degree[p];
        const double w = relative_distance(b, p, q);
        nearest[p] = (std::min)(nearest[p], w);
        nearest[q] = (std::min)(nearest[q], w);
      }
    }
    // the worst first; the neighbours of a deleted bubble get room and stay
    std::vector<Index> candidates;
    for (std::size_t i = 0; i < b.size(); ++i)
      if ((b.is_in_face(i) && degree[i] <= ill_connected) ||
          (!b.is_corner(i) && nearest[i] < least_distance))
        candidates.push_back(static_cast<Index>(i));
    std::sort(candidates.begin(), candidates.end(), [&](Index i, Index j) {
      return nearest[i] < nearest[j] || (nearest[i] == nearest[j] && i < j);
    });
    if (candidates.empty())
      return;
    std::vector<char> is_candidate(b.size(), 0), is_kept(b.size(), 0);
    for (Index i : candidates)
      is_candidate[i] = 1;
    std::vector<std::vector<Index>> neighbors(b.size());
    for (std::size_t t = 0; t < mesh.inside.size(); ++t)
      if (mesh.inside[t])
        for (int i = 0; i < 3; ++i)
          if (is_candidate[mesh.tr.vertices[t][i]]) {
            neighbors[mesh.tr.vertices[t][i]].push_back(mesh.tr.vertices[t][ccw(i)]);
            neighbors[mesh.tr.vertices[t][i]].push_back(mesh.tr.vertices[t][cw(i)]);
          }
    for (Index i : candidates) {
      if (is_kept[i])
        continue;
      change.is_deleted[i] = 1;
      for (Index j : neighbors[i])
        is_kept[j] = 1;
    }
  }

  void insert_in_holes(const Bubbles_2& b, const Marked_triangulation_2& mesh,
                       Population_change& change) const
  {
    struct Hole
    {
      double radius; // over the size at the centre
      Point center;
      double d;
      Index triangle; // of the domain
    };
    std::vector<Hole> holes;
    Index hint = 0;
    for (std::size_t t = 0; t < mesh.inside.size(); ++t) {
      if (!mesh.inside[t])
        continue;
      const std::array<Index, 3>& v = mesh.tr.vertices[t];
      if (change.is_deleted[v[0]] || change.is_deleted[v[1]] || change.is_deleted[v[2]])
        continue;
      const Point &p = mesh.tr.points[v[0]], &q = mesh.tr.points[v[1]], &r = mesh.tr.points[v[2]];
      const Point center = CGAL::circumcenter(p, q, r);
      const double radius = std::sqrt(CGAL::squared_distance(center, p));
      // a cheap test first: d is not asked for all triangles
      if (!(radius > 0.8 * largest_radius * (std::min)({b.d[v[0]], b.d[v[1]], b.d[v[2]]})))
        continue;
      const Point centroid = CGAL::centroid(p, q, r);
      const Index start = m_domain.locate(centroid, hint);
      if (start == no_index || !m_domain.is_inside(start))
        continue;
      hint = start;
      const Walk_end end = m_domain.walk(start, centroid, center);
      if (end.is_blocked())
        continue;
      // where d jumps, the bubbles around the hole count too
      const double d = m_sizing(center), mean = (b.d[v[0]] + b.d[v[1]] + b.d[v[2]]) / 3;
      if (radius > largest_radius * (std::max)(d, mean))
        holes.push_back(Hole{radius / d, center, d, end.triangle});
    }
    if (holes.empty())
      return;
    std::sort(holes.begin(), holes.end(), [](const Hole& a, const Hole& c) {
      return a.radius > c.radius || (a.radius == c.radius && a.center < c.center);
    });
    Bubble_buckets_2 inserted(0.9, b.d[0], b.x[0], b.y[0], holes.size());
    for (const Hole& h : holes)
      if (inserted.for_each_near(h.center.x(), h.center.y(), h.d,
                                 [](Index, double, double) { return false; })) {
        inserted.insert(0, h.center.x(), h.center.y(), h.d);
        change.inserted.add(h.center, h.d, Bubbles_2::FACE, h.triangle);
      }
  }

  /// A gap is an edge of the mesh on the domain's boundary or on a constraint, so the only bubbles that
  /// can have been pressed into it are opposite to it in its triangles.
  void insert_on_edges(const Bubbles_2& b, const Marked_triangulation_2& mesh,
                       Population_change& change) const
  {
    const std::vector<Domain_edge_2> pieces = cut_edges(m_domain, b);
    const std::vector<Index> edge_of_piece = edges_of_pieces(b);
    std::vector<char> is_cut(pieces.size(), 0);
    for (std::size_t t = 0; t < mesh.inside.size(); ++t)
      for (int i = 0; i < 3; ++i) {
        const Index piece = mesh.inside[t] ? mesh.edges[t][i] : no_index;
        if (piece == no_index)
          continue;
        const Index u = pieces[piece].source, v = pieces[piece].target, apex = mesh.tr.vertices[t][i];
        const Point middle = CGAL::midpoint(b.point(u), b.point(v));
        if (relative_distance(b, u, v) <= longest_gap)
          continue;
        const double d = m_sizing(middle), cleared = cleared_radius * d;
        if (!is_cut[piece]) {
          is_cut[piece] = 1;
          const Index e = edge_of_piece[piece];
          const double s = 0.5 * (position(b, e, u) + position(b, e, v));
          change.inserted.add(m_domain.point_on_edge(e, s), d, Bubbles_2::EDGE, e, s);
        }
        if (b.is_in_face(apex) &&
            CGAL::squared_distance(b.point(apex), middle) < cleared * cleared)
          change.is_deleted[apex] = 1;
      }
  }

  /// the domain's edge of each piece, in the order of `cut_edges()`
  std::vector<Index> edges_of_pieces(const Bubbles_2& b) const
  {
    const std::vector<std::vector<Index>> on_edge = bubbles_on_edges(m_domain, b);
    std::vector<Index> result;
    for (std::size_t e = 0; e < on_edge.size(); ++e)
      result.insert(result.end(), on_edge[e].size() + 1, static_cast<Index>(e));
    return result;
  }

  double position(const Bubbles_2& b, Index e, Index i) const
  {
    return b.is_on_edge(i) ? b.s[i] : b.place[i] == m_domain.edges()[e].source ? 0. : 1.;
  }

  static double relative_distance(const Bubbles_2& b, Index i, Index j)
  {
    return 2 * std::hypot(b.x[i] - b.x[j], b.y[i] - b.y[j]) / (b.d[i] + b.d[j]);
  }

  const Domain_2& m_domain;
  const Sizing& m_sizing;
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DELAUNAY_POPULATION_H
