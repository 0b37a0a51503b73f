// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_CORNERS_SHARP_CORNER_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_CORNERS_SHARP_CORNER_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/Progress.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Sizes_2.h>
#include <CGAL/Bubble_relaxation_2/internal/core/reproducible_math.h>
#include <CGAL/Bubble_relaxation_2/internal/core/vocabulary.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_2.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/place_on_edges.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// A corner in which two edges of the domain meet in less than 45 degrees, surrounded by a circle. No mesh has better
/// triangles there than the angle allows, but all others can be good, if the circle is part of the mesh: its nodes,
/// which include one on each edge at the corner, make isosceles triangles with the corner, and the angles beyond the
/// nodes on the edges are larger than 90 degrees.
class Sharp_corner_2
{
public:
  /// an edge at the corner
  struct Arm
  {
    Index edge;
    bool is_source;             ///< whether the corner is the source of the edge
    Kernel::Vector_2 to_other_end;
    double spacing = widest;    ///< of the nodes on the circle around the arm, in radii
  };

  /// what lies between an arm and the next, counterclockwise
  struct Sector
  {
    std::size_t first, second;  ///< arms
    double angle;
  };

  Index corner;
  double radius = 0;

  /// `growth`: of the spacing of nodes, by radian
  Sharp_corner_2(Index c, std::vector<Arm> arms_at_corner, const Domain_2& domain, double growth)
    : corner(c), m_arms(std::move(arms_at_corner)), m_growth(growth)
  {
    std::stable_sort(m_arms.begin(), m_arms.end(), [](const Arm& a, const Arm& b) {
      return Kernel::Direction_2(a.to_other_end) < Kernel::Direction_2(b.to_other_end);
    });
    for (std::size_t k = 0; k < m_arms.size(); ++k)
      add_sector(domain, k, (k + 1) % m_arms.size());
    if (is_sharp())
      find_spacings();
  }

  /// Whether it is one indeed. Edges that can hardly be told apart by their coordinates make none.
  bool is_sharp() const { return m_sharpest < sharp && m_sharpest > needle; }

  const std::vector<Arm>& arms() const { return m_arms; }

  /// between two edges that face each other in the domain
  double sharpest_angle() const { return m_sharpest; }

  /// those that belong to the domain
  const std::vector<Sector>& sectors() const { return m_sectors; }

  /// Nodes on the circle in a sector: their angles from its first arm. Spacings grow away from the arms. They make no angle
  /// under 30 degrees if no sector has one.
  std::vector<double> nodes(const Sector& s) const
  {
    const double first = m_arms[s.first].spacing, second = m_arms[s.second].spacing;
    const auto spacing = [&](double a) {
      return (std::min)({widest, first + m_growth * a, second + m_growth * (s.angle - a)});
    };
    Edge_integral integral{{0}, {0}}; // over angles
    for (double a = 0; a < s.angle;) {
      const double next = (std::min)(s.angle, a + 0.25 * spacing(a));
      integral.s.push_back(next);
      integral.sum.push_back(integral.sum.back() + integrate_piece(next - a, spacing(a), spacing(next)));
      a = next;
    }
    std::vector<double> result;
    const bool is_good = m_sharpest >= good_angle;
    const double most = is_good ? std::floor(s.angle / good_angle) : integral.total(),
                 parts = (std::max)(std::ceil(s.angle / widest_angle), std::round((std::min)(integral.total(), most)));
    for (double k = 1; k < parts; ++k)
      result.push_back(is_good ? k / parts * s.angle : integral.invert(k / parts * integral.total()));
    return result;
  }

private:
  static constexpr double pi = CGAL_PI;
  static constexpr double sharp = pi / 4, needle = 1e-6; // angles
  static constexpr double widest = 0.9;                  // spacing, in radii
  static constexpr double good_angle = pi / 6, widest_angle = 1.4; // between two nodes

  void add_sector(const Domain_2& domain, std::size_t k, std::size_t next)
  {
    const Domain_edge_2& e = domain.edges()[m_arms[k].edge];
    if (!(m_arms[k].is_source ? e.inside_left : e.inside_right))
      return;
    const Kernel::Vector_2 &u = m_arms[k].to_other_end, &v = m_arms[next].to_other_end;
    double angle = angle_of(u * v, u.x() * v.y() - u.y() * v.x());
    if (!(angle > 0))
      angle += 2 * pi; // of the only edge in its corner with itself
    m_sectors.push_back(Sector{k, next, angle});
    m_sharpest = (std::min)(m_sharpest, angle);
  }

  /// in a sharp sector as wide as the chord between its arms; all around they grow no faster than elsewhere
  void find_spacings()
  {
    for (const Sector& s : m_sectors)
      if (s.angle < sharp)
        for (std::size_t k : {s.first, s.second})
          m_arms[k].spacing = (std::min)(m_arms[k].spacing, 2 * sine_of(0.5 * s.angle));
    const std::size_t n = m_arms.size();
    for (std::size_t turn = 0; turn < 2 * n; ++turn) {
      grow(turn % n, (turn + 1) % n);
      grow((2 * n - turn) % n, (2 * n - turn - 1) % n);
    }
  }

  void grow(std::size_t from, std::size_t to)
  {
    const Kernel::Vector_2 &u = m_arms[from].to_other_end, &v = m_arms[to].to_other_end;
    const double angle = std::abs(angle_of(u * v, u.x() * v.y() - u.y() * v.x()));
    m_arms[to].spacing = (std::min)(m_arms[to].spacing, m_arms[from].spacing + m_growth * angle);
  }

  std::vector<Arm> m_arms;       // counterclockwise
  std::vector<Sector> m_sectors; // counterclockwise
  double m_growth;
  double m_sharpest = 2 * pi;
};

/// all corners of a domain that are sharp; they have no circles yet
inline std::vector<Sharp_corner_2> sharp_corners(const Domain_2& domain, double growth)
{
  std::vector<std::vector<Sharp_corner_2::Arm>> arms(domain.corners().size());
  for (std::size_t k = 0; k < domain.edges().size(); ++k) {
    tick(k);
    const Index e = static_cast<Index>(k);
    const Domain_edge_2& edge = domain.edges()[k];
    const Kernel::Vector_2 u = domain.target(e) - domain.source(e);
    arms[edge.source].push_back({e, true, u});
    arms[edge.target].push_back({e, false, -u});
  }
  std::vector<Sharp_corner_2> result;
  for (std::size_t c = 0; c < arms.size(); ++c) {
    tick(c);
    Sharp_corner_2 corner(static_cast<Index>(c), std::move(arms[c]), domain, growth);
    if (corner.is_sharp())
      result.push_back(std::move(corner));
  }
  return result;
}

/// Gives sharp corners their circles, and forgets those where roundings of coordinates would show in them, or where an
/// arm takes no nodes. `sizes`: a
/// bit more than a third of them is the largest radius, since circles around corners that face each other must not meet
inline void find_circles(const Domain_2& domain, const Sizes_2& sizes, std::vector<Sharp_corner_2>& corners)
{
  const auto takes_no_nodes = [&](const Sharp_corner_2& c) {
    return std::any_of(c.arms().begin(), c.arms().end(),
                       [&](const Sharp_corner_2::Arm& a) { return !domain.edges()[a.edge].takes_bubbles(); });
  };
  corners.erase(std::remove_if(corners.begin(), corners.end(), takes_no_nodes), corners.end());
  std::vector<int> number_at(domain.edges().size(), 0); // of the ends of each edge
  for (const Sharp_corner_2& corner : corners)
    for (const Sharp_corner_2::Arm& a : corner.arms())
      ++number_at[a.edge];
  for (Sharp_corner_2& corner : corners) {
    corner.radius = 0.36 * sizes(domain.corners()[corner.corner]);
    for (const Sharp_corner_2::Arm& a : corner.arms()) // something is left between two circles
      corner.radius = (std::min)(corner.radius, domain.length(a.edge) / (1 + number_at[a.edge]));
  }
  constexpr double many_roundings = 1e4 * std::numeric_limits<double>::epsilon();
  const auto is_rounded = [&](const Sharp_corner_2& c) {
    const Point& p = domain.corners()[c.corner];
    return c.radius * c.sharpest_angle() < many_roundings * (std::max)(std::abs(p.x()), std::abs(p.y()));
  };
  corners.erase(std::remove_if(corners.begin(), corners.end(), is_rounded), corners.end());
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_CORNERS_SHARP_CORNER_2_H
