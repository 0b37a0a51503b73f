// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_OUTLINE_SIMPLIFICATION_FILL_GAPS_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_OUTLINE_SIMPLIFICATION_FILL_GAPS_H

#include <CGAL/Bubble_relaxation_2/internal/core/in_words.h>
#include <CGAL/Bubble_relaxation_2/internal/core/reproducible_math.h>
#include <CGAL/Bubble_relaxation_2/internal/outline_simplification/Outline_triangulation_2.h>
#include <CGAL/Bubble_relaxation_2/internal/outline_simplification/Simplified_outline_2.h>
#include <CGAL/Bubble_relaxation_2/internal/outline_simplification/cut_segments.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// The rule `minimum_gap`: takes out of the domain what no disc of that diameter within it reaches: channels and the
/// room between islands. These are triangles between segments, densely cut where others are near, whose circumscribed
/// circles are smaller, as in an alpha shape. Open corners are no gaps, nor is what is wider than deep. What is beside
/// a vertex that stays, or beside a constraint with the domain on both sides, is left alone.
class Gap_rule_2
{
  static constexpr double cut = 0.25;          // segments are cut in parts of this many widths
  static constexpr double most_parts = 1e7;    // a triangulation of some gigabytes
  static constexpr double shallow = 0.03;      // what is no deeper, over the least width, is no gap
  static constexpr double open_depth = 0.52;   // over the width of the mouth: an angle of about 88 degrees
  static constexpr double open_mouth = 0.7;    // over the least width
  static constexpr double least_basin = 3.14;  // over the square of the width: a disc of twice the width

public:
  /// \throws std::length_error if the width is so small that there would be far more parts than can be wanted
  Gap_rule_2(const Outline_2& outline, double width)
    : m_outline(cut_where_narrow(outline, width)), m_triangulation(m_outline, width),
      m_is_within(m_outline.points.size(), 1), m_next(m_outline.points.size()), m_width(width)
  {
    for (const Outline_segment_2& s : m_outline.segments) {
      if (!is_inner(s))
        m_is_within[s.source] = m_is_within[s.target] = 0;
      m_next[s.source].push_back(s.target);
      m_next[s.target].push_back(s.source);
    }
  }

  Outline_2 operator()(Outline_simplification_report_2& report)
  {
    fill_narrow();
    do
      fill_basins();
    while (fill_pinches());
    tell(report);
    return with_joined_parts(m_triangulation.new_outline());
  }

private:
  using Region = std::vector<Index>;
  using Vertices = boost::container::small_vector<Index, 2>;

  /// What is beyond the mouth of a gap is seen as it is: so twice the width counts as near.
  static Outline_2 cut_where_narrow(const Outline_2& outline, double width)
  {
    const auto near = stretches_near_others(outline, 2 * width, cut * width);
    double n = 0;
    for (const auto& stretches : near)
      for (const Stretch& s : stretches)
        n += std::ceil((s.second - s.first) / (cut * width));
    if (!(n < most_parts))
      throw std::length_error("Bubble_relaxation_2: parameter minimum_gap = " + in_words(width) +
                              " cuts the outline into about " + in_words(n) + " parts");
    return with_cut_segments(outline, [&](std::size_t e) {
      std::vector<Point> cuts;
      const Point &a = outline.points[outline.segments[e].source], &b = outline.points[outline.segments[e].target];
      const double length = distance(a, b), n_parts = std::ceil(length / (cut * width)), part = length / n_parts;
      for (const Stretch& s : near[e])
        for (double i = (std::max)(1., std::ceil(s.first / part)); i < n_parts && i * part <= s.second; ++i)
          cuts.emplace_back(a.x() + i / n_parts * (b.x() - a.x()), a.y() + i / n_parts * (b.y() - a.y()));
      return cuts;
    });
  }

  const Flat_triangulation_2& tr() const { return m_triangulation.tr(); }

  static bool is_inner(const Outline_segment_2& s) { return s.inside_left && s.inside_right; }

  /// whether a triangle is beside a pin or a constraint within the domain: it does not tell how wide the domain is
  bool is_beside_inner(Index t) const
  {
    for (int i = 0; i < 3; ++i) {
      const Index e = m_triangulation.segment(t, i);
      if (m_is_within[tr().vertices[t][i]] || (e != no_index && is_inner(m_outline.segments[e])))
        return true;
    }
    return false;
  }

  bool is_left_alone(Index t) const
  {
    const auto& v = tr().vertices[t];
    return is_beside_inner(t) || m_outline.is_fixed[v[0]] || m_outline.is_fixed[v[1]] || m_outline.is_fixed[v[2]];
  }

  bool is_left_alone(const Region& region) const
  {
    return std::any_of(region.begin(), region.end(), [this](Index t) { return is_left_alone(t); });
  }

  void fill(const Region& region)
  {
    for (Index t : region)
      m_triangulation.set_inside(t, false);
  }

  void fill_narrow()
  {
    std::vector<char> is_narrow(m_triangulation.size(), 0);
    for (std::size_t t = 0; t < is_narrow.size(); ++t)
      is_narrow[t] = m_triangulation.is_inside(static_cast<Index>(t)) && is_narrow_triangle(static_cast<Index>(t));
    for (const Region& region : m_triangulation.regions([&](Index t) { return is_narrow[t] != 0; }))
      if (!is_open(region, is_narrow))
        for (Index t : region)
          if (!is_left_alone(t))
            fill({t});
  }

  bool is_narrow_triangle(Index t) const
  {
    if (is_beside_inner(t))
      return false;
    double squares[3];
    for (int i = 0; i < 3; ++i)
      squares[i] = CGAL::squared_distance(tr().point(t, ccw(i)), tr().point(t, cw(i)));
    const double twice = 2 * m_triangulation.area(t);
    for (int i = 0; i < 3; ++i) // a vertex very near to a part of a segment
      if (m_triangulation.segment(t, i) != no_index && 2 * squares[i] > squares[0] + squares[1] + squares[2] &&
          twice * twice < m_width * m_width * squares[i])
        return true;
    return squares[0] * squares[1] * squares[2] < m_width * m_width * twice * twice; // diameter < width
  }

  /// Whether a region is only what is left in an open corner: one mouth, wider than deep. Neither is it a gap if it
  /// leads to nothing but a pin or a constraint within the domain, without which it might not be narrow.
  bool is_open(const Region& region, const std::vector<char>& is_narrow) const
  {
    std::vector<std::pair<Index, Index>> mouths; // their ends
    bool leads_on = false;
    for (Index t : region)
      for (int i = 0; i < 3; ++i) {
        const Index n = m_triangulation.neighbor(t, i);
        if (m_triangulation.segment(t, i) != no_index || !m_triangulation.is_inside(n) || is_narrow[n])
          continue;
        mouths.emplace_back(tr().vertices[t][ccw(i)], tr().vertices[t][cw(i)]);
        leads_on |= !is_beside_inner(n);
      }
    if (!leads_on || mouths.size() != 1)
      return !mouths.empty() && !leads_on;
    const auto [a, b] = mouths[0];
    const Point &p = m_outline.points[a], &q = m_outline.points[b];
    const double width = distance(p, q);
    double depth = 0;
    Point deepest = p;
    for (Index t : region)
      for (int i = 0; i < 3; ++i)
        if (const double d = distance_to_segment(tr().point(t, i), p, q); d > depth) {
          depth = d;
          deepest = tr().point(t, i);
        }
    return depth < shallow * m_width ||
           (depth < open_depth * width &&
            (width > open_mouth * m_width || (goes_straight_on(deepest, a) && goes_straight_on(deepest, b))));
  }

  /// whether a wall from a corner to the end of a mouth goes on behind it: the mouth is where the wall happens to be
  /// cut
  bool goes_straight_on(const Point& corner, Index end) const
  {
    const double rounding = 1e-6 * m_width;
    return std::any_of(m_next[end].begin(), m_next[end].end(), [&](Index next) {
      return distance_to_segment(m_outline.points[end], corner, m_outline.points[next]) < rounding;
    });
  }

  /// fills what was cut off and has no more room than for few triangles
  void fill_basins()
  {
    for (const Region& region : m_triangulation.regions([this](Index t) { return m_triangulation.is_inside(t); }))
      if (m_triangulation.area(region) < least_basin * m_width * m_width && touches_filled(region) &&
          !is_left_alone(region))
        fill(region);
  }

  bool touches_filled(const Region& region) const
  {
    for (Index t : region)
      for (Index n : tr().neighbors[t])
        if (m_triangulation.was_inside(n) && !m_triangulation.is_inside(n))
          return true;
    return false;
  }

  /// Fills triangles at vertices where the domain meets itself, all but those of the widest part there, or of the
  /// parts that are left alone; returns whether there are some.
  bool fill_pinches()
  {
    std::map<Index, std::vector<Index>> around; // triangles of the domain at vertices with more than two boundary sides
    std::vector<int> sides(m_outline.points.size(), 0);
    for_each_boundary_side([&](Index t, int i) {
      ++sides[tr().vertices[t][ccw(i)]];
      ++sides[tr().vertices[t][cw(i)]];
    });
    for (std::size_t k = 0; k < m_triangulation.size(); ++k)
      if (m_triangulation.is_inside(static_cast<Index>(k)))
        for (Index v : tr().vertices[k])
          if (sides[v] > 2 && !m_outline.is_fixed[v])
            around[v].push_back(static_cast<Index>(k));
    bool are_filled = false;
    for (const auto& pinch : around)
      are_filled |= keep_widest(pinch.first, pinch.second);
    return are_filled;
  }

  template <class Visitor>
  void for_each_boundary_side(const Visitor& visit) const
  {
    for (std::size_t k = 0; k < m_triangulation.size(); ++k)
      for (int i = 0; i < 3; ++i)
        if (m_triangulation.is_inside(static_cast<Index>(k)) && !m_triangulation.is_inside(tr().neighbors[k][i]))
          visit(static_cast<Index>(k), i);
  }

  double angle_at(Index t, Index v) const
  {
    const int i = tr().index_of_vertex(t, v);
    const Point &p = tr().point(t, i), &a = tr().point(t, ccw(i)), &b = tr().point(t, cw(i));
    return angle_of((a.x() - p.x()) * (b.x() - p.x()) + (a.y() - p.y()) * (b.y() - p.y()),
                    2 * m_triangulation.area(t));
  }

  /// the triangles of the domain around a vertex, in sets that hang together
  std::vector<Region> fans_of(const std::vector<Index>& triangles) const
  {
    std::vector<Region> fans;
    std::vector<char> is_done(triangles.size(), 0);
    for (std::size_t k = 0; k < triangles.size(); ++k) {
      if (is_done[k] || !m_triangulation.is_inside(triangles[k]))
        continue;
      Region fan{triangles[k]};
      is_done[k] = 1;
      for (std::size_t j = 0; j < fan.size(); ++j)
        for (std::size_t l = 0; l < triangles.size(); ++l)
          if (!is_done[l] && m_triangulation.is_inside(triangles[l]) && are_neighbors(fan[j], triangles[l])) {
            is_done[l] = 1;
            fan.push_back(triangles[l]);
          }
      fans.push_back(std::move(fan));
    }
    return fans;
  }

  /// returns whether something was filled
  bool keep_widest(Index v, const std::vector<Index>& triangles)
  {
    const std::vector<Region> fans = fans_of(triangles);
    if (fans.size() < 2)
      return false; // what was filled at another vertex was enough
    std::vector<char> is_kept;
    for (const Region& fan : fans)
      is_kept.push_back(is_left_alone(fan));
    if (std::count(is_kept.begin(), is_kept.end(), 1) == 0) {
      double widest = -1;
      std::size_t kept = 0;
      for (std::size_t f = 0; f < fans.size(); ++f) {
        double angle = 0;
        for (Index t : fans[f])
          angle += angle_at(t, v);
        if (angle > widest) {
          widest = angle;
          kept = f;
        }
      }
      is_kept[kept] = 1;
    }
    for (std::size_t f = 0; f < fans.size(); ++f)
      if (!is_kept[f])
        fill(fans[f]);
    return std::count(is_kept.begin(), is_kept.end(), 0) > 0;
  }

  bool are_neighbors(Index s, Index t) const
  {
    const auto& n = tr().neighbors[s];
    return std::find(n.begin(), n.end(), t) != n.end();
  }

  void tell(Outline_simplification_report_2& report) const
  {
    const auto is_filled = [this](Index t) { return m_triangulation.was_inside(t) && !m_triangulation.is_inside(t); };
    for (const Region& region : m_triangulation.regions(is_filled)) {
      double longest = -1;
      Point place(0, 0);
      for (Index t : region)
        for (int i = 0; i < 3; ++i) {
          const Point &a = tr().point(t, ccw(i)), &b = tr().point(t, cw(i));
          const Point middle((a.x() + b.x()) / 2, (a.y() + b.y()) / 2);
          const double l = CGAL::squared_distance(a, b);
          if (l > longest || (l == longest && middle < place)) {
            longest = l;
            place = middle;
          }
        }
      report.filled_gaps.push_back({{place.x(), place.y()}, m_triangulation.area(region)});
    }
    std::sort(report.filled_gaps.begin(), report.filled_gaps.end(),
              [](const auto& a, const auto& b) { return a.place < b.place; });
  }

  Outline_2 m_outline;
  Outline_triangulation_2 m_triangulation;
  std::vector<char> m_is_within; // of each vertex whether it is not on the boundary
  std::vector<Vertices> m_next;  // to each vertex, over segments
  double m_width;
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_OUTLINE_SIMPLIFICATION_FILL_GAPS_H
