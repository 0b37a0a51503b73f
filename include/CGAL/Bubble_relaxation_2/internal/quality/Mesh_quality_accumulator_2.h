// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_QUALITY_MESH_QUALITY_ACCUMULATOR_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_QUALITY_MESH_QUALITY_ACCUMULATOR_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/Progress.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Team.h>
#include <CGAL/Bubble_relaxation_2/internal/core/find_sorted.h>
#include <CGAL/Bubble_relaxation_2/internal/core/reproducible_math.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Flat_triangulation_2.h>

#include <CGAL/Kernel/global_functions_2.h>
#include <CGAL/number_utils.h>
#include <CGAL/radius_ratio_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// the number type of statistics: the kernel's, or `double` if that is exact and would only be slow
template <class Kernel>
struct Quality_number
{
  using type = std::conditional_t<std::is_floating_point<typename Kernel::FT>::value,
                                  typename Kernel::FT, double>;
};

constexpr std::size_t number_of_quality_bars = 20;
constexpr std::array<int, 7> quality_percents{1, 5, 10, 25, 50, 75, 90};

/// the values behind `Mesh_quality_2`
struct Mesh_statistics_2
{
  static constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

  std::size_t vertices = 0, triangles = 0, interior = 0, irregular = 0, obtuse = 0;
  double minimum_quality = undefined, mean_quality = undefined;
  double worst_x = undefined, worst_y = undefined;
  double minimum_angle = undefined, maximum_angle = undefined;
  double shortest_edge = undefined, longest_edge = undefined;
  std::array<double, quality_percents.size()> quality_percentiles{};
  std::array<std::size_t, number_of_quality_bars> histogram{};
  bool has_lengths = false;
  double mean_length = undefined, deviation = undefined;
  double length_percentile_1 = undefined, length_percentile_99 = undefined;

  void take_lengths(const Mesh_statistics_2& from)
  {
    has_lengths = from.has_lengths;
    mean_length = from.mean_length;
    deviation = from.deviation;
    length_percentile_1 = from.length_percentile_1;
    length_percentile_99 = from.length_percentile_99;
  }
};

/// Collects triangles, vertices and edges one by one. The statistics do not depend on their order, to the
/// last bit.
class Mesh_quality_accumulator_2
{
public:
  template <class Point_2>
  void add_triangle(const Point_2& p, const Point_2& q, const Point_2& r)
  {
    // a vertex to begin with that only the points decide: what rounds depends on it
    if (CGAL::lexicographically_xy_smaller(q, p) && CGAL::lexicographically_xy_smaller(q, r))
      add_triangle_in_order(q, r, p);
    else if (CGAL::lexicographically_xy_smaller(r, p))
      add_triangle_in_order(r, p, q);
    else
      add_triangle_in_order(p, q, r);
  }

  void add_vertex(bool is_interior, std::size_t degree)
  {
    ++m.vertices;
    m.interior += is_interior;
    m.irregular += is_interior && degree != 6;
  }

  /// `ratio`: the length of an edge over the wanted length
  void add_length(double ratio) { m_lengths.push_back(ratio); }

  /// makes room for all that others have
  void make_room_for(const std::vector<Mesh_quality_accumulator_2>& others)
  {
    std::size_t qualities = m_qualities.size(), lengths = m_lengths.size();
    for (const Mesh_quality_accumulator_2& other : others) {
      qualities += other.m_qualities.size();
      lengths += other.m_lengths.size();
    }
    m_qualities.reserve(qualities);
    m_lengths.reserve(lengths);
  }

  /// adds all that another one has
  void add(const Mesh_quality_accumulator_2& other)
  {
    if (!other.m_qualities.empty() &&
        (m_qualities.empty() || other.m.minimum_quality <= m.minimum_quality))
      add_worst(other.m.minimum_quality, other.m.worst_x, other.m.worst_y);
    m.vertices += other.m.vertices;
    m.interior += other.m.interior;
    m.irregular += other.m.irregular;
    m.obtuse += other.m.obtuse;
    if (!other.m_qualities.empty()) {
      if (may_be_smallest(other.m_largest_cotangent))
        add_smallest(other.m_largest_cotangent, other.m.minimum_angle);
      if (may_be_largest(other.m_smallest_cotangent))
        add_largest(other.m_smallest_cotangent, other.m.maximum_angle);
      add_edge(other.m.shortest_edge);
      add_edge(other.m.longest_edge);
    }
    m_qualities.insert(m_qualities.end(), other.m_qualities.begin(), other.m_qualities.end());
    m_lengths.insert(m_lengths.end(), other.m_lengths.begin(), other.m_lengths.end());
  }

  /// of what all of a team have; to be called once
  Mesh_statistics_2 statistics(const Team& all = Team())
  {
    std::array<std::size_t, 6> counts{m.vertices,  m.interior, m.irregular, m_qualities.size(), m_lengths.size(),
                                      m.obtuse};
    all.add_up(counts.data(), counts.size());
    m.vertices = counts[0];
    m.interior = counts[1];
    m.irregular = counts[2];
    m.triangles = counts[3];
    m.obtuse = counts[5];
    if (m.triangles > 0) {
      finish_extremes(all);
      finish_qualities(all);
    }
    m.has_lengths = counts[4] > 0;
    if (m.has_lengths)
      finish_lengths(counts[4], all);
    return m;
  }

private:
  template <class Point_2>
  void add_triangle_in_order(const Point_2& p, const Point_2& q, const Point_2& r)
  {
    const double quality = radius_ratio(p, q, r);
    if (m_qualities.empty() || quality <= m.minimum_quality)
      add_worst(quality, CGAL::to_double(p.x() + q.x() + r.x()) / 3,
                CGAL::to_double(p.y() + q.y() + r.y()) / 3);
    m_qualities.push_back(quality);
    add_angle(p, q, r);
    add_angle(q, r, p);
    add_angle(r, p, q);
  }

  void add_worst(double quality, double x, double y)
  {
    const bool is_equal = !m_qualities.empty() && quality == m.minimum_quality;
    if (is_equal && std::make_pair(m.worst_x, m.worst_y) <= std::make_pair(x, y))
      return;
    m.minimum_quality = quality;
    m.worst_x = x;
    m.worst_y = y;
  }

  template <class Point_2>
  void add_angle(const Point_2& p, const Point_2& q, const Point_2& r)
  {
    constexpr double degrees = 57.29577951308232;
    const double ux = CGAL::to_double(q.x() - p.x()), uy = CGAL::to_double(q.y() - p.y());
    const double vx = CGAL::to_double(r.x() - p.x()), vy = CGAL::to_double(r.y() - p.y());
    const double scale = (std::max)(std::abs(ux) + std::abs(uy), std::abs(vx) + std::abs(vy));
    const double x = ux / scale, y = uy / scale;
    const double cross = std::abs(x * (vy / scale) - y * (vx / scale));
    const double dot = x * (vx / scale) + y * (vy / scale);
    m.obtuse += is_obtuse(dot, cross);
    add_edge(scale > 0 ? scale * std::sqrt(x * x + y * y) : 0);
    // the cotangent falls as the angle grows, and costs less
    const bool is_angle = scale > 0 && (cross > 0 || dot != 0);
    const double cotangent = is_angle ? dot / cross : std::numeric_limits<double>::infinity();
    if (may_be_smallest(cotangent))
      add_smallest(cotangent, is_angle ? degrees * angle_of(dot, cross) : 0.);
    if (may_be_largest(cotangent))
      add_largest(cotangent, is_angle ? degrees * angle_of(dot, cross) : 0.);
  }

  void add_edge(double length)
  {
    if (!(length >= m.shortest_edge))
      m.shortest_edge = length;
    if (!(length <= m.longest_edge))
      m.longest_edge = length;
  }

  bool may_be_smallest(double cotangent) const { return !(cotangent < m_largest_cotangent); }
  bool may_be_largest(double cotangent) const { return !(cotangent > m_smallest_cotangent); }

  /// of angles with the same cotangent the smallest, whichever comes first
  void add_smallest(double cotangent, double angle)
  {
    m.minimum_angle = cotangent == m_largest_cotangent ? (std::min)(angle, m.minimum_angle) : angle;
    m_largest_cotangent = cotangent;
  }

  void add_largest(double cotangent, double angle)
  {
    m.maximum_angle = cotangent == m_smallest_cotangent ? (std::max)(angle, m.maximum_angle) : angle;
    m_smallest_cotangent = cotangent;
  }

  /// where there is no triangle all extremes are at infinity
  void finish_extremes(const Team& all)
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const bool is_empty = m_qualities.empty();
    const auto smallest_if = [&](bool is_one, double value) { return all.smallest(is_one ? value : infinity); };

    const double quality = smallest_if(!is_empty, m.minimum_quality);
    bool is_worst = !is_empty && !(m.minimum_quality > quality);
    const double x = smallest_if(is_worst, m.worst_x);
    is_worst = is_worst && !(m.worst_x > x);
    m.worst_y = smallest_if(is_worst, m.worst_y);
    m.worst_x = x;
    m.minimum_quality = quality;

    const double largest = all.largest(is_empty ? -infinity : m_largest_cotangent);
    m.minimum_angle = smallest_if(!is_empty && m_largest_cotangent == largest, m.minimum_angle);
    const double smallest = smallest_if(!is_empty, m_smallest_cotangent);
    const bool is_widest = !is_empty && m_smallest_cotangent == smallest;
    m.maximum_angle = all.largest(is_widest ? m.maximum_angle : -infinity);
    m.shortest_edge = smallest_if(!is_empty, m.shortest_edge);
    m.longest_edge = all.largest(is_empty ? -infinity : m.longest_edge);
  }

  void finish_qualities(const Team& all)
  {
    for (double q : m_qualities) {
      const double bar = q * double(number_of_quality_bars);
      ++m.histogram[(std::min)(static_cast<std::size_t>(bar), number_of_quality_bars - 1)];
    }
    all.add_up(m.histogram.data(), m.histogram.size());
    m.mean_quality = sum_in_any_order(m_qualities, [](double q) { return q; }, all) / double(m.triangles);
    m.quality_percentiles = percentiles(m_qualities, m.triangles, quality_percents, all);
  }

  /// `lengths`: how many there are
  void finish_lengths(std::size_t lengths, const Team& all)
  {
    const double n = double(lengths);
    m.mean_length = sum_in_any_order(m_lengths, [](double l) { return l; }, all) / n;
    const auto square = [this](double l) { return (l - m.mean_length) * (l - m.mean_length); };
    m.deviation = std::sqrt(sum_in_any_order(m_lengths, square, all) / n);
    const auto ends = percentiles(m_lengths, lengths, std::array<int, 2>{1, 99}, all);
    m.length_percentile_1 = ends[0];
    m.length_percentile_99 = ends[1];
  }

  /// the smallest of the values that at least each of `percents` of all values do not exceed
  template <std::size_t n>
  static std::array<double, n> percentiles(std::vector<double>& values, std::size_t number,
                                           const std::array<int, n>& percents, const Team& all)
  {
    std::vector<std::size_t> positions;
    for (int percent : percents) {
      const std::size_t rank = (number * static_cast<std::size_t>(percent) + 99) / 100;
      positions.push_back((std::max)(rank, std::size_t(1)) - 1);
    }
    const std::vector<double> sorted = sorted_at(positions, values, all);
    std::array<double, n> result{};
    std::copy(sorted.begin(), sorted.end(), result.begin());
    return result;
  }

  /// The sum of `term(v)` over the values of all of a team, the same to the last bit in whatever order they come: of
  /// terms as multiples of a unit, summed as integers. The unit is so small that the mean is off by less than
  /// n / 2^60 times the largest term. \pre no term is negative or not a number
  template <class Term>
  static double sum_in_any_order(const std::vector<double>& values, const Term& term, const Team& all)
  {
    double largest = 0;
    for (double v : values)
      largest = (std::max)(largest, term(v));
    largest = all.largest(largest);
    if (largest == 0 || !std::isfinite(largest))
      return largest;
    std::size_t n = values.size();
    all.add_up(&n, 1);
    const int digits = 60 - std::ilogb(static_cast<double>(n)) - std::ilogb(largest);
    // in two parts, since the largest terms may be the smallest numbers
    const double scale = std::ldexp(1., digits / 2), rest = std::ldexp(1., digits - digits / 2);
    std::uint64_t sum = 0; // stays below 2^62
    for (double v : values)
      sum += static_cast<std::uint64_t>(static_cast<std::int64_t>(term(v) * scale * rest));
    all.add_up(sum);
    return std::ldexp(static_cast<double>(sum), -digits);
  }

  Mesh_statistics_2 m;
  // of all angles; not numbers before the first
  double m_largest_cotangent = std::numeric_limits<double>::quiet_NaN();
  double m_smallest_cotangent = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> m_qualities, m_lengths;
};

/// Adds vertices of a domain.
/// \param is_constrained `is_constrained(t, i)`: whether the side `i` of the triangle is
/// \param is_counted of a vertex whether it is to be added
template <class Is_constrained, class Is_counted>
void add_vertices(const Triangles_2& tr, std::size_t number_of_vertices, const Is_constrained& is_constrained,
                  const Is_counted& is_counted, Mesh_quality_accumulator_2& accumulator)
{
  std::vector<char> is_in_domain(number_of_vertices, 0), is_interior(number_of_vertices, 1);
  std::vector<std::size_t> degrees(number_of_vertices, 0);
  for (std::size_t t = 0; t < tr.number_of_triangles(); ++t) {
    tick(t);
    const std::array<Index, 3>& v = tr.vertices[t];
    for (int i = 0; i < 3; ++i) {
      ++degrees[v[i]];
      if (tr.inside[t])
        is_in_domain[v[i]] = 1;
      if (is_constrained(static_cast<Index>(t), i)) // all ways out of the domain lead across constraints
        is_interior[v[ccw(i)]] = is_interior[v[cw(i)]] = 0;
    }
  }
  for (std::size_t v = 0; v < number_of_vertices; ++v)
    if (is_in_domain[v] && is_counted(v))
      accumulator.add_vertex(is_interior[v] != 0, degrees[v]);
}

/// Adds the length of an edge over d in the midpoint. It begins at the end that comes first: what rounds must not
/// depend on the triangle from which the edge is seen.
template <class Sizing>
void add_length(const Point& p, const Point& q, const Sizing& sizing, Mesh_quality_accumulator_2& accumulator)
{
  const bool is_reversed = CGAL::lexicographically_xy_smaller(q, p);
  const Point &a = is_reversed ? q : p, &b = is_reversed ? p : q;
  const double dx = b.x() - a.x(), dy = b.y() - a.y();
  accumulator.add_length(std::sqrt(dx * dx + dy * dy) / sizing(a.x() + dx / 2, a.y() + dy / 2));
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_QUALITY_MESH_QUALITY_ACCUMULATOR_2_H
