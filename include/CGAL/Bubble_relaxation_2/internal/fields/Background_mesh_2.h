// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_FIELDS_BACKGROUND_MESH_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_FIELDS_BACKGROUND_MESH_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/Progress.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Sizes_2.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_2.h>
#include <CGAL/Bubble_relaxation_2/internal/fields/Gradient_limiter_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Hilbert_curve_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <set>
#include <tuple>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// A triangulation of a domain that is refined until sizes whose growth is limited are nearly linear in its
/// triangles. In each turn all edges are cut for which this does not hold, and the triangulation is made
/// anew: constrained Delaunay, so that its triangles stay as round as the domain allows.
class Background_mesh_2
{
public:
  /// \param points places inside the domain that become vertices, besides its corners
  Background_mesh_2(const Domain_2& domain, const std::vector<Point>& points, const Sizes_2& sizing, double g,
                    std::size_t maximum_number_of_vertices)
    : m_sizing(sizing), m_g(g), m_maximum(maximum_number_of_vertices),
      m_extent((std::max)(domain.bbox().x_span(), domain.bbox().y_span())),
      m_points(domain.corners()), m_pieces(domain.edges()), m_curve(domain.bbox(), false),
      m_sizes(domain.corners().size())
  {
    m_points.insert(m_points.end(), points.begin(), points.end());
  }

  /// Makes the mesh. False if there is not enough room among the vertices or the numbers, or if the callback said so:
  /// then it is the last one whose sizes are known.
  /// \param progress remembers a stop
  bool build(Progress& progress)
  {
    double done = 0;
    // vertices inside may lie on each other, or on the outline, by a rounding; then corners are tried, which do not
    for (bool is_made = triangulate() || triangulate(); is_made; is_made = triangulate()) {
      ask_for_given_sizes();
      const std::vector<double> last = std::exchange(m_sizes, m_given);
      Gradient_limiter_2(m_mesh, m_g).spread(m_sizes);
      if (progress.is_stopped())
        return false;
      find_news(last);
      std::vector<Cut> cuts = find_cuts();
      const std::size_t room = m_maximum > m_points.size() ? m_maximum - m_points.size() : 0;
      done = (std::max)(done, double(m_points.size()) / double(m_points.size() + cuts.size()));
      const bool goes_on = progress.report(done);
      if (cuts.empty() || room == 0 || !goes_on)
        return cuts.empty() && goes_on;
      if (cuts.size() > room)
        cuts.resize(room); // the worst ones come first
      make(cuts);
    }
    return false;
  }

  Marked_triangulation_2& mesh() { return m_mesh; }

  /// at the vertices, limited as far as `Gradient_limiter_2::spread()` does
  std::vector<double>& sizes() { return m_sizes; }

private:
  /// How far the linear interpolation may be from the limited size, relative to it; the longest edges inside
  /// and on constraints, relative to the extent of the domain; the length of edges, relative to the size, that
  /// are fine enough, and that where d or the field is too steep; the gradients, relative to the limit, of
  /// triangles that are too coarse and of the sides of dips; and how much longer another side of a triangle is
  /// that is cut first.
  static constexpr double tolerance = 0.05, longest = 1. / 32, longest_on_constraints = 1. / 128,
                          shortest = 1, shortest_where_steep = 0.25, steepest = 1.1, steep_in_dips = 2,
                          much_longer = 1.3;

  /// A point that is to be inserted, on a piece of a constraint or inside.
  struct Cut
  {
    double error;
    Point point;
    Index piece;

    bool operator<(const Cut& c) const
    {
      return std::make_tuple(-error, point, piece) < std::make_tuple(-c.error, c.point, c.piece);
    }
  };

  bool triangulate()
  {
    Marked_triangulation_2 mesh;
    const bool is_made = mark_triangulation(m_points, m_pieces, mesh) == Marking_error::NONE;
    if (!is_made || (is_stop_wanted() && m_mesh.number_of_triangles() > 0)) {
      m_points.resize(m_sizes.size()); // the last cuts are too fine for the numbers, or come too late
      return false;
    }
    m_mesh = std::move(mesh);
    return true;
  }

  /// d at the vertices, not limited
  void ask_for_given_sizes()
  {
    m_given.resize(m_points.size(), 0);
    for (std::size_t t = 0; t < m_mesh.number_of_triangles(); ++t) {
      tick(t);
      for (Index v : m_mesh.vertices[t])
        if (m_mesh.inside[t] && m_given[v] == 0)
          m_given[v] = size(m_points[v]);
    }
  }

  /// An edge or a triangle that was fine is so as long as its vertices, and those of the triangles beside it, have the
  /// sizes that they had: where there are new triangles, there are new vertices.
  void find_news(const std::vector<double>& last)
  {
    m_has_news.resize(m_points.size(), 1);
    for (std::size_t v = 0; v < last.size(); ++v)
      m_has_news[v] |= m_sizes[v] != last[v];
  }

  bool has_news(Index t) const
  {
    const auto& v = m_mesh.vertices[t];
    return m_has_news[v[0]] || m_has_news[v[1]] || m_has_news[v[2]];
  }

  /// d, which is asked once in each place
  double size(const Point& p)
  {
    const auto found = m_known.find(p);
    if (found != m_known.end())
      return found->second;
    const double size = m_known[p] = m_sizing(p);
    tick(); // it may be slow
    return size;
  }

  std::vector<Cut> find_cuts()
  {
    std::vector<Cut> cuts;
    const Gradient_limiter_2 limiter(m_mesh, m_g);
    m_is_doubtful.assign(m_points.size(), 0);
    for_each_edge(m_mesh, 0, m_mesh.number_of_triangles(), [&](Index t, int i) {
      const Index n = m_mesh.neighbors[t][i];
      if (has_news(t) || (n != no_index && m_mesh.inside[n] && has_news(n)))
        add_edge(t, i, edge_error(t, i), cuts);
    });
    for (std::size_t k = 0; k < m_mesh.number_of_triangles(); ++k) {
      tick(k);
      if (m_mesh.inside[k] && has_news(static_cast<Index>(k)))
        add_triangle(static_cast<Index>(k), limiter.gradient(static_cast<Index>(k), m_sizes), cuts);
    }
    m_has_news = m_is_doubtful;
    std::sort(cuts.begin(), cuts.end());
    std::set<Point> seen;
    cuts.erase(std::remove_if(cuts.begin(), cuts.end(),
                              [&](const Cut& c) {
                                tick(seen.size());
                                return !seen.insert(c.point).second;
                              }),
               cuts.end());
    return cuts;
  }

  double length(Index t, int i) const
  {
    return std::sqrt(CGAL::squared_distance(m_mesh.point(t, ccw(i)), m_mesh.point(t, cw(i))));
  }

  double value(Index t, int i) const { return m_sizes[m_mesh.vertices[t][i]]; }

  /// how far the middle of a side is from linear, relative to the tolerance; infinite for a side that is too
  /// long to know anything
  double edge_error(Index t, int i)
  {
    const double l = length(t, i), a = value(t, ccw(i)), b = value(t, cw(i));
    const bool is_constrained = m_mesh.edges[t][i] != no_index;
    if (l > m_extent * (is_constrained ? longest_on_constraints : longest))
      return std::numeric_limits<double>::infinity();
    if (l > shortest_where_steep * (std::min)(a, b) && leads_into_dip(t, i, l))
      return 1 / tolerance;
    if (l <= shortest * (std::min)(a, b))
      return 0;
    const Point m = CGAL::midpoint(m_mesh.point(t, ccw(i)), m_mesh.point(t, cw(i)));
    double limited = (std::min)(size(m), limit_across(t, i, m));
    const Index n = m_mesh.neighbors[t][i];
    if (n != no_index && m_mesh.inside[n])
      limited = (std::min)(limited, limit_across(n, m_mesh.index_of_neighbor(n, t), m));
    return std::abs(limited / (a + (b - a) / 2) - 1) / tolerance;
  }

  /// Whether the end of a side where d is smaller is the source of its own size although d is steep there: a
  /// narrow dip, whose bottom may lie somewhere beside.
  bool leads_into_dip(Index t, int i, double l) const
  {
    Index low = m_mesh.vertices[t][ccw(i)], high = m_mesh.vertices[t][cw(i)];
    if (m_given[high] < m_given[low])
      std::swap(low, high);
    return m_sizes[low] == m_given[low] && m_given[high] - m_given[low] > steep_in_dips * m_g * l;
  }

  /// what fronts from the other two sides of a triangle bring to a point of the side `i`
  double limit_across(Index t, int i, const Point& m) const
  {
    const Point& p = m_mesh.point(t, i);
    return (std::min)(
      front_from_segment(p, value(t, i), m_mesh.point(t, ccw(i)), value(t, ccw(i)), m, m_g),
      front_from_segment(p, value(t, i), m_mesh.point(t, cw(i)), value(t, cw(i)), m, m_g));
  }

  /// Cuts a side, or instead the much longer one that the triangles beside it lead to: else a triangle with a
  /// long side that nobody asks to cut becomes flatter and flatter.
  void add_edge(Index t, int i, double error, std::vector<Cut>& cuts)
  {
    if (!(error > 1))
      return;
    look_again_at(t);
    for (double l = length(t, i), last = 0; l > last;) {
      last = l;
      l *= much_longer;
      const Index n = m_mesh.neighbors[t][i];
      for (Index beside : {t, n})
        for (int j = 0; j < 3 && beside != no_index && m_mesh.inside[beside]; ++j)
          if (length(beside, j) > l) {
            l = length(beside, j);
            t = beside;
            i = j;
          }
      if (l == last * much_longer)
        break;
    }
    cuts.push_back(Cut{error, CGAL::midpoint(m_mesh.point(t, ccw(i)), m_mesh.point(t, cw(i))),
                       m_mesh.edges[t][i]});
  }

  /// what is cut need not be what is too coarse
  void look_again_at(Index t)
  {
    for (Index v : m_mesh.vertices[t])
      m_is_doubtful[v] = 1;
  }

  /// A triangle is cut where d is smaller in its middle than its corners tell, and its longest side where it
  /// is too flat for the gradient.
  void add_triangle(Index t, double gradient, std::vector<Cut>& cuts)
  {
    const double least = (std::min)({value(t, 0), value(t, 1), value(t, 2)});
    const double l[3] = {length(t, 0), length(t, 1), length(t, 2)};
    const int i = static_cast<int>(std::max_element(l, l + 3) - l);
    if (gradient > steepest * m_g && l[i] > shortest_where_steep * least)
      add_edge(t, i, 1 + gradient / m_g, cuts);
    if (l[i] <= shortest * least)
      return;
    const Point c = CGAL::centroid(m_mesh.point(t, 0), m_mesh.point(t, 1), m_mesh.point(t, 2));
    const double error = (1 - size(c) / ((value(t, 0) + value(t, 1) + value(t, 2)) / 3)) / tolerance;
    if (error > 1) {
      look_again_at(t);
      cuts.push_back(Cut{error, c, no_index});
    }
  }

  /// in the order of a curve: triangulation is fast if points are near to those before them
  void make(const std::vector<Cut>& cuts)
  {
    std::vector<Point> points;
    for (const Cut& c : cuts)
      points.push_back(c.point);
    for (Index k : hilbert_order(m_curve, points)) {
      const Cut& c = cuts[static_cast<std::size_t>(k)];
      const Index v = static_cast<Index>(m_points.size());
      m_points.push_back(c.point);
      if (c.piece == no_index)
        continue;
      Domain_edge_2 rest = m_pieces[c.piece];
      m_pieces[c.piece].target = v;
      rest.source = v;
      m_pieces.push_back(rest);
    }
  }

  struct Hash
  {
    std::size_t operator()(const Point& p) const { return static_cast<std::size_t>(hash_of_place(p.x(), p.y())); }
  };

  const Sizes_2& m_sizing;
  double m_g;
  std::size_t m_maximum;
  double m_extent;
  std::vector<Point> m_points;
  std::vector<Domain_edge_2> m_pieces; // of constraints, between points
  Hilbert_curve_2 m_curve;
  Marked_triangulation_2 m_mesh;
  std::vector<double> m_given, m_sizes; // d at points, and limited: at first of corners
  std::vector<char> m_has_news, m_is_doubtful; // points that are new or have another size, or of what is too coarse
  std::unordered_map<Point, double, Hash> m_known;
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_FIELDS_BACKGROUND_MESH_2_H
