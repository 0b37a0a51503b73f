// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_QUALITY_EVALUATE_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_QUALITY_EVALUATE_H

#include <CGAL/Bubble_relaxation_2/internal/core/Progress.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Sizes_2.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Team.h>
#include <CGAL/Bubble_relaxation_2/internal/core/parallel_for.h>
#include <CGAL/Bubble_relaxation_2/internal/core/reproducible_math.h>
#include <CGAL/Bubble_relaxation_2/internal/corners/Cut_domain_2.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_2.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Problem_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Marked_triangulation_2.h>
#include <CGAL/Bubble_relaxation_2/internal/quality/Mesh_quality_accumulator_2.h>

#include <CGAL/Bubble_relaxation_report_2.h>
#include <CGAL/number_type_config.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// d at the vertices of the triangles of the domain around bubbles of this rank; others are not the business of d
inline std::vector<double> sizes_at_vertices(const Bubble_mesh_2& mesh, const Sizes_2& sizing,
                                             const Threads& threads)
{
  const Bubbles_2& b = mesh.bubbles;
  std::vector<char> is_needed(b.size(), 0);
  for (std::size_t t = 0; t < mesh.triangles.number_of_triangles(); ++t) {
    tick(t);
    const std::array<Index, 3>& v = mesh.triangles.vertices[t];
    if (mesh.triangles.inside[t] && (b.is_ours(v[0]) || b.is_ours(v[1]) || b.is_ours(v[2])))
      is_needed[v[0]] = is_needed[v[1]] = is_needed[v[2]] = 1;
  }
  std::vector<double> sizes(b.size(), 0);
  parallel_for(threads, sizes.size(), [&](std::size_t v) {
    if (is_needed[v])
      sizes[v] = sizing(b.x[v], b.y[v]);
  });
  return sizes;
}

/// Calls `visit(a, b)` for the ends of the edges of this rank, whose ends with the smaller indices are ours, that have
/// their first triangle in a range.
template <class Visitor>
void for_each_own_edge(const Bubble_mesh_2& mesh, std::size_t first, std::size_t last, const Visitor& visit)
{
  const Marked_triangles_2& tr = mesh.triangles;
  for_each_edge(tr, first, last, [&](Index t, int i) {
    const Index a = tr.vertices[t][ccw(i)], b = tr.vertices[t][cw(i)];
    if (mesh.bubbles.is_ours((std::min)(a, b)))
      visit(a, b);
  });
}

/// Puts into the report how many vertices d alone asks for, and which pins are of no use.
inline void tell_of_input(const Problem_2& problem, Report& report)
{
  report.number_of_wanted_vertices = static_cast<std::size_t>(std::llround(problem.wanted.number_without_corners));
  report.number_of_pins_outside = problem.given.number_of_pins_outside;
  report.pin_outside_x = problem.given.pin_outside.x();
  report.pin_outside_y = problem.given.pin_outside.y();
}

/// How much d changes from one vertex of a mesh to the next, which is what the mesh can see of its gradient, kinks and
/// jumps included.
class Size_gradient_2
{
public:
  /// adds the edges of this rank; `sizes`: d at the vertices
  void add(const Bubble_mesh_2& mesh, const std::vector<double>& sizes)
  {
    for_each_own_edge(mesh, 0, mesh.triangles.number_of_triangles(), [&](Index a, Index b) {
      add_edge(mesh.bubbles.point(a), sizes[a], mesh.bubbles.point(b), sizes[b]);
    });
  }

  /// Puts it into the report. Of edges with the same gradient it tells that with the lexicographically smallest
  /// midpoint.
  void tell(Report& report, const Team& all) const
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const double largest = all.largest(m_largest);
    const bool is_here = m_largest == largest;
    const double x = all.smallest(is_here ? m_steepest.x() : infinity);
    const double y = all.smallest(is_here && m_steepest.x() == x ? m_steepest.y() : infinity);
    std::array<std::size_t, 2> counts{m_number_of_steep, m_number};
    all.add_up(counts.data(), counts.size());
    report.largest_size_gradient = largest;
    report.steepest_x = x;
    report.steepest_y = y;
    report.steep_share = counts[1] == 0 ? 0. : static_cast<double>(counts[0]) / static_cast<double>(counts[1]);
  }

private:
  /// an edge with d at its ends, in whatever order they come
  void add_edge(const Point& p, double d_p, const Point& q, double d_q)
  {
    constexpr double rounding = 8 * std::numeric_limits<double>::epsilon(); // of the user's formula
    const double dx = q.x() - p.x(), dy = q.y() - p.y();
    const double change = std::abs(d_q - d_p), length = std::sqrt(dx * dx + dy * dy), gradient = change / length;
    ++m_number;
    if (change > Report::steep_size_gradient * length + rounding * (d_p + d_q))
      ++m_number_of_steep;
    if (!(gradient > 0) || gradient < m_largest)
      return;
    // from the end that comes first: what rounds must not depend on the triangle from which the edge is seen
    const Point& first = CGAL::lexicographically_xy_smaller(q, p) ? q : p;
    const double sign = &first == &q ? -1 : 1;
    const Point middle(first.x() + sign * dx / 2, first.y() + sign * dy / 2);
    if (gradient > m_largest || CGAL::lexicographically_xy_smaller(middle, m_steepest))
      m_steepest = middle;
    m_largest = gradient;
  }

  double m_largest = 0;
  Point m_steepest = Point(0, 0);
  std::size_t m_number_of_steep = 0, m_number = 0;
};

/// How many of something there are, and where the least of them is, in whatever order they come.
struct Counted_places_2
{
  std::size_t number = 0;
  double least = std::numeric_limits<double>::infinity();
  Point where = Point(0, 0);

  void add(double value, const Point& p)
  {
    ++number;
    if (std::make_pair(value, p) < std::make_pair(least, where)) {
      least = value;
      where = p;
    }
  }

  /// of all ranks
  void tell(std::size_t& number_of_all, double& x, double& y, const Team& all) const
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    number_of_all = number;
    all.add_up(&number_of_all, 1);
    if (number_of_all == 0)
      return;
    const bool is_here = least == all.smallest(least);
    x = all.smallest(is_here ? where.x() : infinity);
    y = all.smallest(is_here && where.x() == x ? where.y() : infinity);
  }
};

/// Where the outline forces most vertices: those with much less than the wanted size, counted in squares.
class Forced_places_2
{
public:
  explicit Forced_places_2(const Domain_2& domain)
    : m_x(domain.bbox().xmin()), m_y(domain.bbox().ymin()),
      m_side((std::max)(domain.bbox().x_span(), domain.bbox().y_span()) / side), m_squares(side * side)
  {}

  /// adds the vertices of this rank; `wanted`: their sizes, 0 outside of the domain
  void add(const Bubbles_2& b, const std::vector<double>& wanted)
  {
    constexpr double much = 0.7; // one alone would have the area of two
    for (std::size_t v = 0; v < b.size(); ++v) {
      tick(v);
      if (b.is_ours(v) && b.d[v] < much * wanted[v])
        m_squares[square(b.x[v] - m_x) + side * square(b.y[v] - m_y)].add(b.d[v] / wanted[v], b.point(v));
    }
  }

  /// those with most of them, none beside another one that is told
  void tell(Report& report, const Team& all) const
  {
    std::vector<std::size_t> numbers;
    for (const Counted_places_2& s : m_squares)
      numbers.push_back(s.number);
    all.add_up(numbers.data(), numbers.size());
    for (auto& place : report.forced_places) {
      const auto most = std::max_element(numbers.begin(), numbers.end());
      const std::size_t told = static_cast<std::size_t>(most - numbers.begin());
      m_squares[told].tell(place.number_of_vertices, place.x, place.y, all);
      for (std::size_t k = 0; k < numbers.size(); ++k)
        if (are_near(k % side, told % side) && are_near(k / side, told / side))
          numbers[k] = 0;
    }
  }

private:
  static constexpr std::size_t side = 16;

  static bool are_near(std::size_t i, std::size_t j) { return i <= j + 1 && j <= i + 1; }

  std::size_t square(double from_begin) const
  {
    return (std::min)(static_cast<std::size_t>((std::max)(from_begin / m_side, 0.)), side - 1);
  }

  double m_x, m_y, m_side;
  std::vector<Counted_places_2> m_squares;
};

/// The triangles whose smallest angle is smaller than one that is asked for: those at corners of the domain that are sharper
/// have to be so, between the edges, or beside them, where angles grow from there.
class Small_angles_2
{
public:
  Small_angles_2(const Domain_2& domain, double minimum_angle)
    : m_sine(sine_of(minimum_angle * CGAL_PI / 180)),
      m_largest_quality(quality_of_isosceles(minimum_angle * CGAL_PI / 360)), m_is_sharp(domain.corners().size(), 0)
  {
    for (const Sharp_corner_2& c : sharp_corners(domain, default_size_growth))
      m_is_sharp[c.corner] = c.sharpest_angle() < minimum_angle * CGAL_PI / 180;
  }

  /// adds the triangles of this rank
  void add(const Bubble_mesh_2& mesh)
  {
    const Bubbles_2& b = mesh.bubbles;
    for (std::size_t k = 0; k < mesh.triangles.number_of_triangles(); ++k) {
      tick(k);
      const Index t = static_cast<Index>(k);
      const std::array<Index, 3>& v = mesh.triangles.vertices[k];
      if (!mesh.triangles.inside[k] || has_surely_more(mesh, t, m_largest_quality) ||
          !b.is_ours(*std::min_element(v.begin(), v.end())))
        continue;
      const Smallest_angle_2 smallest(mesh, t);
      if (!(smallest.sine < m_sine))
        continue;
      const bool is_forced = std::any_of(v.begin(), v.end(), [&](Index i) {
        return b.is_corner(i) && b.host[i] != no_index && m_is_sharp[b.host[i]];
      });
      (is_forced ? m_forced : m_others).add(smallest.sine, mesh.point(t, smallest.vertex));
    }
  }

  void tell(Report& report, const Team& all) const
  {
    m_forced.tell(report.number_of_forced_triangles, report.forced_x, report.forced_y, all);
    m_others.tell(report.number_of_small_angles, report.small_x, report.small_y, all);
  }

private:
  double m_sine, m_largest_quality; // of a triangle with that angle
  std::vector<char> m_is_sharp;
  Counted_places_2 m_forced, m_others;
};

/// adds the triangles of the domain in a range whose vertices with the smallest indices are of this rank
inline void add_triangles(const Bubble_mesh_2& mesh, std::size_t first, std::size_t last,
                          Mesh_quality_accumulator_2& accumulator)
{
  for (std::size_t t = first; t < last; ++t) {
    const Index f = static_cast<Index>(t);
    const std::array<Index, 3>& v = mesh.triangles.vertices[t];
    if (mesh.triangles.inside[t] && mesh.bubbles.is_ours(*std::min_element(v.begin(), v.end())))
      accumulator.add_triangle(mesh.point(f, 0), mesh.point(f, 1), mesh.point(f, 2));
  }
}

/// The statistics of a mesh, of all ranks. `sizing`: over d in their midpoints lengths of edges are told; null if there
/// are to be none
inline Mesh_quality_2<double> quality_of(const Bubble_mesh_2& mesh, const Sizes_2* sizing, const Threads& threads,
                                         Team& team)
{
  constexpr std::size_t block_size = 4096;
  Mesh_quality_accumulator_2 all;
  team.agree_after([&] {
    const Marked_triangles_2& tr = mesh.triangles;
    const std::size_t n = tr.number_of_triangles();
    std::vector<Mesh_quality_accumulator_2> blocks((n + block_size - 1) / block_size);
    parallel_for(
      threads, blocks.size(),
      [&](std::size_t k) {
        const std::size_t first = k * block_size, last = (std::min)(first + block_size, n);
        add_triangles(mesh, first, last, blocks[k]);
        if (sizing != nullptr)
          for_each_own_edge(mesh, first, last, [&](Index a, Index b) {
            add_length(mesh.bubbles.point(a), mesh.bubbles.point(b), *sizing, blocks[k]);
          });
      },
      1);
    add_vertices(
      tr, mesh.bubbles.size(), [&](Index t, int i) { return tr.edges[t][i] != no_index; },
      [&](std::size_t v) { return mesh.bubbles.is_ours(v); }, all);
    all.make_room_for(blocks);
    for (const Mesh_quality_accumulator_2& block : blocks) {
      tick();
      all.add(block);
    }
  });
  return Mesh_quality_2<double>(all.statistics(team));
}

/// Puts the statistics of a mesh, of all ranks, into the report. It is the mesh in arrays: the user's d may throw, and
/// then the user's triangulation must not have been changed yet.
inline void evaluate(const Bubble_mesh_2& mesh, const Problem_2& problem, Team& team, Report& report)
{
  const Threads& threads = problem.options.threads;
  const Phase_timer timer(report.seconds.evaluation);
  tell_of_input(problem, report);
  report.quality = quality_of(mesh, &problem.sizes, threads, team);
  report.number_of_vertices = report.quality.number_of_vertices();
  report.number_of_triangles = report.quality.number_of_triangles();
  Size_gradient_2 gradient;
  Small_angles_2 small(problem.whole_domain(), problem.options.minimum_angle);
  Forced_places_2 forced(problem.whole_domain());
  team.agree_after([&] {
    const std::vector<double> wanted = sizes_at_vertices(mesh, problem.wanted, threads);
    gradient.add(mesh, wanted);
    forced.add(mesh.bubbles, wanted);
    small.add(mesh);
  });
  gradient.tell(report, team);
  forced.tell(report, team);
  small.tell(report, team);
}

inline void evaluate(const Bubble_mesh_2& mesh, const Problem_2& problem, Report& report)
{
  Team alone;
  evaluate(mesh, problem, alone, report);
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_QUALITY_EVALUATE_H
