// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_TREATMENT_ANGLE_REFINEMENT_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_TREATMENT_ANGLE_REFINEMENT_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/Bubbles_2.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Progress.h>
#include <CGAL/Bubble_relaxation_2/internal/core/reproducible_math.h>
#include <CGAL/Bubble_relaxation_2/internal/core/vocabulary.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_2.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Problem_2.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/outline.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Bubble_buckets_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Marked_triangulation_2.h>
#include <CGAL/Bubble_relaxation_2/internal/sizes/Outline_sizes_2.h>
#include <CGAL/Bubble_relaxation_2/internal/treatment/rebuild_outside.h>

#include <CGAL/Kernel/global_functions_2.h>
#include <CGAL/Mesh_quality_2.h>
#include <CGAL/number_type_config.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// A vertex that a triangle with a small angle asks for: its circumcentre, or the middle of a piece of the outline that it
/// is too near to.
struct Steiner_point_2
{
  double sine; ///< of the angle: the smallest comes first
  double x, y, s, radius;
  Index host;
  Bubbles_2::Dimension dimension;
  Index triangle; ///< that asks for it, on its rank

  bool is_on_edge() const { return dimension == Bubbles_2::EDGE; }

  bool operator<(const Steiner_point_2& p) const
  {
    return std::tie(sine, x, y, radius, host) < std::tie(p.sine, p.x, p.y, p.radius, p.host);
  }
};

/// the sine of the smallest angle of a triangle, or 1 if two edges of the domain make it
inline double smallest_free_sine(const Bubble_mesh_2& mesh, Index t)
{
  const Smallest_angle_2 smallest(mesh, t);
  const auto& edges = mesh.triangles.edges[t];
  return edges[ccw(smallest.vertex)] == no_index || edges[cw(smallest.vertex)] == no_index ? smallest.sine : 1.;
}

/// the smallest of those triangles that belong to the domain, or to a rank
inline double smallest_free_sine(const Bubble_mesh_2& mesh, const std::vector<char>& is_counted)
{
  double smallest = 1;
  for (std::size_t t = 0; t < is_counted.size(); ++t)
    if (is_counted[t])
      smallest = (std::min)(smallest, smallest_free_sine(mesh, static_cast<Index>(t)));
  return smallest;
}

/// where a bubble is on an edge of the domain
struct Position_on_edge
{
  double s;
  Index edge;
};

/// those of the bubbles that are ours
inline std::vector<Position_on_edge> positions_on_edges(const Bubbles_2& b)
{
  std::vector<Position_on_edge> result;
  for (std::size_t i = 0; i < b.size(); ++i)
    if (b.is_on_edge(i) && b.is_ours(i))
      result.push_back(Position_on_edge{b.s[i], b.host[i]});
  return result;
}

/// Finds what Ruppert's algorithm inserts (A Delaunay refinement algorithm for quality 2-dimensional mesh generation, J.
/// Algorithms 18, 1995) where simulation and surgery have left a triangle with a small angle. Up to 20.7 degrees it ends
/// by proof if the edges of the domain meet in 60 degrees or more, and in practice mostly up to more than 30. Chords of
/// circles around sharp corners cannot be split: what asks for that gets nothing.
class Angle_refinement_2
{
public:
  /// `positions`: of the bubbles of all ranks
  Angle_refinement_2(const Problem_2& problem, const Bubble_mesh_2& mesh,
                     const std::vector<Position_on_edge>& positions)
    : m_domain(problem.domain), m_sizes(problem.sizes), m_mesh(mesh), m_on_edge(m_domain.edges().size()),
      m_pieces(1, extent(m_domain), m_domain.bbox().xmin(), m_domain.bbox().ymin(),
               positions.size() + m_domain.edges().size())
  {
    for (const Position_on_edge& p : positions)
      m_on_edge[p.edge].push_back(p.s);
    for (std::size_t e = 0; e < m_on_edge.size(); ++e) {
      tick(e);
      std::sort(m_on_edge[e].begin(), m_on_edge[e].end());
      add_pieces(static_cast<Index>(e));
    }
  }

  /// What triangle `t` asks for, if it can be had and is not far nearer to others than the size there.
  std::optional<Steiner_point_2> operator()(Index t)
  {
    constexpr double least_radius = 0.001;
    const std::optional<Steiner_point_2> point = is_in_crack(t) ? std::nullopt : find(t);
    return point && point->radius > least_radius * m_sizes(point->x, point->y) ? point : std::nullopt;
  }

  /// of those that are nearer to each other than the radius of one of them the first
  static std::vector<Steiner_point_2> independent(std::vector<Steiner_point_2> points)
  {
    std::sort(points.begin(), points.end());
    std::vector<Steiner_point_2> result;
    for (const Steiner_point_2& p : points)
      if (std::none_of(result.begin(), result.end(), [&p](const Steiner_point_2& q) {
            return length_of(p.x - q.x, p.y - q.y) < (std::max)(p.radius, q.radius);
          }))
        result.push_back(p);
    return result;
  }

private:
  /// whether a triangle is so flat that the sides around it count as touching, for which no size is small enough
  bool is_in_crack(Index t) const
  {
    const Point p = m_mesh.point(t, 0), q = m_mesh.point(t, 1), r = m_mesh.point(t, 2);
    const double longest = std::sqrt((std::max)(
      {CGAL::squared_distance(p, q), CGAL::squared_distance(q, r), CGAL::squared_distance(r, p)}));
    const Point middle = CGAL::centroid(p, q, r);
    return 2 * std::abs(CGAL::area(p, q, r)) <= Outline_sizes_2::narrowest * m_sizes(middle.x(), middle.y()) * longest;
  }

  std::optional<Steiner_point_2> find(Index t)
  {
    const auto [i, j, k] = corners_in_order(m_mesh.triangles, t);
    const Point p = m_mesh.point(t, i), q = m_mesh.point(t, j), r = m_mesh.point(t, k);
    if (is_flat(p, q, r))
      return std::nullopt;
    const Point center = CGAL::circumcenter(p, q, r), centroid = CGAL::centroid(p, q, r);
    const Index start = m_domain.host_of(centroid, m_hint);
    if (start == no_index)
      return std::nullopt;
    const Walk_end end = m_domain.walk(start, centroid, center);
    Steiner_point_2 result{Smallest_angle_2(m_mesh, t).sine, center.x(), center.y(), 0,
                           std::sqrt(CGAL::squared_distance(center, p)), end.triangle, Bubbles_2::FACE, t};
    if (end.is_blocked())
      return split(m_domain.edge(end.triangle, end.edge), crossing(end, centroid, center), result);
    for (Index e : edges_near(center))
      if (const std::optional<double> s = encroached(e, end.triangle, center))
        return split(e, *s, result);
    return result;
  }

  /// Whether three points are on a line up to some roundings of their coordinates: their circumcentre would be anywhere, and
  /// a pinned vertex so near to an edge might come to lie on its other side.
  static bool is_flat(const Point& p, const Point& q, const Point& r)
  {
    constexpr double rounding = 8 * std::numeric_limits<double>::epsilon();
    const Kernel::Vector_2 u = q - p, v = r - p;
    const double largest = (std::max)(std::abs(p.x()), std::abs(p.y())),
                 length = std::abs(u.x()) + std::abs(u.y()) + std::abs(v.x()) + std::abs(v.y());
    return std::abs(u.x() * v.y() - u.y() * v.x()) <= rounding * largest * length;
  }

  /// where on an edge of the domain a walk ended
  double crossing(const Walk_end& end, const Point& from, const Point& to) const
  {
    const Index e = m_domain.edge(end.triangle, end.edge);
    const Kernel::Vector_2 u = m_domain.target(e) - m_domain.source(e), v = to - from, w = from - m_domain.source(e);
    const double s = (w.x() * v.y() - w.y() * v.x()) / (u.x() * v.y() - u.y() * v.x());
    return (std::max)(0., (std::min)(1., s));
  }

  /// the ends of the piece of an edge that a position is in
  std::array<double, 2> piece(Index e, double s) const
  {
    const std::vector<double>& on_edge = m_on_edge[e];
    const auto next = std::upper_bound(on_edge.begin(), on_edge.end(), s);
    return {next == on_edge.begin() ? 0 : *(next - 1), next == on_edge.end() ? 1 : *next};
  }

  void add_pieces(Index e)
  {
    const auto add = [&](double from, double to) {
      const Point middle = m_domain.point_on_edge(e, 0.5 * (from + to));
      if (from < to)
        m_pieces.insert(e, middle.x(), middle.y(), (to - from) * m_domain.length(e));
    };
    double last = 0;
    for (double s : m_on_edge[e])
      add(std::exchange(last, s), s);
    add(last, 1);
  }

  /// those with pieces whose diametral circles may contain a point, in order
  std::vector<Index> edges_near(const Point& p) const
  {
    constexpr double radius = 0.5 * (1 + 1e-6); // with roundings
    std::vector<Index> result;
    m_pieces.for_each_large(p.x(), p.y(), 0, radius, [&result](const Bubble_buckets_2::Entry& piece, double) {
      result.push_back(piece.id);
      return true;
    });
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

  /// a position in a piece of an edge whose diametral circle contains a point that sees it
  std::optional<double> encroached(Index e, Index triangle, const Point& p) const
  {
    const Point &a = m_domain.source(e), &b = m_domain.target(e);
    if (CGAL::angle(a, p, b) != OBTUSE)
      return std::nullopt; // then no piece of it is
    const Kernel::Vector_2 u = b - a;
    const std::array<double, 2> ends = piece(e, ((p - a) * u) / (u * u));
    const double middle = 0.5 * (ends[0] + ends[1]);
    const Point m = m_domain.point_on_edge(e, middle);
    if (CGAL::angle(m_domain.point_on_edge(e, ends[0]), p, m_domain.point_on_edge(e, ends[1])) != OBTUSE)
      return std::nullopt;
    const Walk_end end = m_domain.walk(triangle, p, m);
    return !end.is_blocked() || m_domain.edge(end.triangle, end.edge) == e ? std::optional<double>(middle) : std::nullopt;
  }

  /// the middle of a piece of an edge instead
  std::optional<Steiner_point_2> split(Index e, double s, Steiner_point_2 result) const
  {
    if (!m_domain.edges()[e].takes_bubbles())
      return std::nullopt;
    const std::array<double, 2> ends = piece(e, s);
    result.s = 0.5 * (ends[0] + ends[1]);
    const Point p = m_domain.point_on_edge(e, result.s);
    result.x = p.x();
    result.y = p.y();
    result.radius = 0.5 * (ends[1] - ends[0]) * m_domain.length(e);
    result.host = e;
    result.dimension = Bubbles_2::EDGE;
    return result;
  }

  const Domain_2& m_domain;
  const Sizes_2& m_sizes;
  const Bubble_mesh_2& m_mesh;
  std::vector<std::vector<double>> m_on_edge; // positions, in order
  Bubble_buckets_2 m_pieces;                  // of edges between these, with their lengths as sizes
  Index m_hint = 0;
};

/// triangles with less are refined, if any are
inline constexpr double least_refined_quality = 0.55;

/// Whether a triangle has a smaller angle than it needs, or two hardly larger ones, so that it is blunt.
inline bool is_to_be_refined(const Bubble_mesh_2& mesh, Index t, double sine)
{
  constexpr double sine_beyond = 0.545; // with a larger angle no q is less
  const double smallest = smallest_free_sine(mesh, t);
  return smallest < sine || (sine > 0 && smallest < sine_beyond &&
                             radius_ratio_2(mesh.point(t, 0), mesh.point(t, 1), mesh.point(t, 2)) < least_refined_quality);
}

/// Those triangles that are to be refined and belong to the domain, or to a rank.
inline std::vector<Index> triangles_to_refine(const Problem_2& problem, const Bubble_mesh_2& mesh,
                                              const std::vector<char>& is_counted)
{
  std::vector<Index> result;
  const double angle = problem.options.minimum_angle * CGAL_PI / 180, sine = sine_of(angle);
  const double enough = (std::max)(least_refined_quality, quality_of_isosceles(angle / 2));
  for (std::size_t k = 0; k < is_counted.size(); ++k) {
    tick(k);
    const Index t = static_cast<Index>(k);
    if (is_counted[k] && !has_surely_more(mesh, t, enough) && is_to_be_refined(mesh, t, sine))
      result.push_back(t);
  }
  return result;
}

/// How many triangles of a mesh are to be refined, and how far their smallest sine is from 1: the less the better.
inline std::pair<std::int64_t, double> left_to_refine(const Problem_2& problem, const Bubble_mesh_2& mesh,
                                                      const std::vector<char>& is_counted)
{
  std::pair<std::int64_t, double> result{0, 0};
  for (Index t : triangles_to_refine(problem, mesh, is_counted))
    result = {result.first + 1, (std::max)(result.second, 1 - smallest_free_sine(mesh, t))};
  return result;
}

/// What these triangles ask for. `positions`: of the bubbles of all ranks
inline std::vector<Steiner_point_2> wanted_points(const Problem_2& problem, const Bubble_mesh_2& mesh,
                                                  const std::vector<Position_on_edge>& positions,
                                                  const std::vector<Index>& triangles)
{
  std::vector<Steiner_point_2> result;
  Angle_refinement_2 refine(problem, mesh, positions);
  for (Index t : triangles) {
    tick();
    if (const auto point = refine(t))
      result.push_back(*point);
  }
  return result;
}

/// Whether refinement that has taken, and asks for, so many vertices will hardly come to an end.
inline bool is_endless(std::size_t number_of_new_vertices, std::size_t number_of_vertices)
{
  return number_of_new_vertices > 100 + number_of_vertices / 50;
}

/// Inserts vertices into a mesh until no angle is smaller than `minimum_angle` that need not be so, or they cannot be
/// told from others; returns how many, none if that is endless.
template <class Treatment>
std::size_t insert_for_small_angles(const Treatment& treatment, const typename Treatment::Mesh& mesh, Outline_care& care,
                                    typename Treatment::Mesh& refined)
{
  const std::size_t number_of_vertices = treatment.number_of_bubbles(mesh);
  std::vector<std::vector<Steiner_point_2>> rounds;
  refined = treatment.triangulated_anew(mesh);
  for (std::size_t result = 0;;) {
    std::vector<Steiner_point_2> points = treatment.wanted_points(refined);
    if (is_endless(result + points.size(), number_of_vertices))
      return 0;
    points = Angle_refinement_2::independent(std::move(points));
    if (points.empty() || treatment.is_stop_wanted())
      return result;
    if (!treatment.insert(points, care, refined)) { // without the last ones then
      refined = treatment.triangulated_anew(mesh);
      for (const std::vector<Steiner_point_2>& round : rounds)
        treatment.insert(round, care, refined);
      return result;
    }
    result += points.size();
    rounds.push_back(std::move(points));
  }
}

/// The same, unless it makes angles in a crack smaller. `treatment`: by one rank or all
/// \throws Edges_too_near if the outline crosses itself then, unless that is left to those who have `care`
template <class Treatment>
std::size_t refine_small_angles(const Treatment& treatment, typename Treatment::Mesh& mesh, Outline_care& care)
{
  if (!treatment.is_to_be_refined(mesh))
    return 0;
  typename Treatment::Mesh refined;
  Outline_care care_of_refined{care.is_careful};
  const std::size_t result = insert_for_small_angles(treatment, mesh, care_of_refined, refined);
  if (result == 0 || treatment.smallest_free_sine(refined) < treatment.smallest_free_sine(mesh)) {
    check_before_leaving(treatment, refined, care_of_refined);
    return 0;
  }
  care.add(care_of_refined);
  mesh = std::move(refined);
  return result;
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_TREATMENT_ANGLE_REFINEMENT_2_H
