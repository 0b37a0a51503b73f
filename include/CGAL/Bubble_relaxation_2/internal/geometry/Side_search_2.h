// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_GEOMETRY_SIDE_SEARCH_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_GEOMETRY_SIDE_SEARCH_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/vocabulary.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Box_tree_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/linear_values.h>

#include <CGAL/Bbox_2.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// A point that is so far away that squares would be none is drawn nearer, in its direction from the origin: as seen
/// from there all coordinates of points are 0.
inline Point within_reach(const Point& q)
{
  constexpr double reach = 1e120;
  const double largest = (std::max)(std::abs(q.x()), std::abs(q.y()));
  return largest > reach ? Point(q.x() / largest * reach, q.y() / largest * reach) : q;
}

/// Sides of triangles with values at their ends, to find the nearest one to a point: in a tree, or, if they are those
/// of a convex polygon, by halving its parts that turn by a right angle at most. From afar the boxes of all sides of a
/// slanted wall seem to be near.
class Side_search_2
{
public:
  /// counterclockwise as seen from the triangle
  using Side = std::pair<Valued_corner_2, Valued_corner_2>;

  explicit Side_search_2(std::vector<Side> sides)
    : m_sides(std::move(sides)), m_ring(convex_ring(m_sides)), m_parts(parts()), m_tree(boxes())
  {}

  /// the side that has the nearest point to `q`
  /// \pre there are sides; `q` is `within_reach()`, and not inside if they are those of a convex polygon
  Index nearest(const Point& q) const
  {
    Candidates candidates(*this, q);
    if (m_ring.empty())
      m_tree.for_each_nearer(q, candidates.bound, [&](Index i) { return candidates.add(i); });
    for (std::size_t k = 0; k + 1 < m_parts.size(); ++k)
      candidates.add(nearest_of_part(m_parts[k], m_parts[k + 1], q));
    return candidates.best();
  }

  /// the nearest point to `q` of a side, and the value there
  Point point_on(Index side, const Point& q) const
  {
    const auto& [a, b] = ends(side);
    const double s = Nearest_on_side_2(a, b, q).share;
    return Point(a.x() + s * (b.x() - a.x()), a.y() + s * (b.y() - a.y()));
  }

  double value_on(Index side, const Point& q) const
  {
    return value_on_side(m_sides[side].first, m_sides[side].second, q);
  }

  /// the value in the nearest point of all
  double value(const Point& q) const { return value_on(nearest(q), q); }

private:
  /// in the order that counts for bits
  std::pair<const Point&, const Point&> ends(Index side) const
  {
    const auto& [a, b] = m_sides[side];
    if (a.rank < b.rank)
      return {a.point, b.point};
    return {b.point, a.point};
  }

  bool is_beyond(Index side, const Point& q) const
  {
    return CGAL::orientation(m_sides[side].first.point, m_sides[side].second.point, q) == RIGHT_TURN;
  }

  struct Candidate
  {
    Index side;
    double squared_distance;
    bool is_foot; // of a perpendicular from outside
    Point end;    // the nearest one
    double value;
  };

  class Candidates
  {
  public:
    double bound = std::numeric_limits<double>::infinity(); ///< the squared distance that still counts

    Candidates(const Side_search_2& search, const Point& q) : m_search(search), m_q(q) {}

    double add(Index i)
    {
      const auto& [a, b] = m_search.ends(i);
      const Nearest_on_side_2 n(a, b, m_q);
      if (n.squared_distance > bound)
        return bound;
      if (with_roundings(n.squared_distance) < m_least)
        m_all.clear();
      m_least = (std::min)(m_least, n.squared_distance);
      m_all.push_back({i, n.squared_distance, n.is_foot && m_search.is_beyond(i, m_q), n.share < 0.5 ? a : b,
                       m_search.value_on(i, m_q)});
      return bound = (std::min)(bound, with_roundings(n.squared_distance));
    }

    Index best() const
    {
      const Candidate* best = nullptr;
      for (const Candidate& c : m_all)
        if (c.squared_distance <= bound && (best == nullptr || is_better(c, *best)))
          best = &c;
      return best->side;
    }

  private:
    static double with_roundings(double squared_distance)
    {
      return squared_distance * (1 + 16 * std::numeric_limits<double>::epsilon());
    }

    /// Seen from afar many sides are equally near, up to roundings. Then that counts which the perpendicular from the
    /// point meets, else the one with the nearest end, which is found exactly. What is still the same has the smaller
    /// value, so that it does not matter how the sides are ordered.
    bool is_better(const Candidate& a, const Candidate& b) const
    {
      if (a.is_foot != b.is_foot)
        return a.is_foot;
      const Comparison_result nearer = a.is_foot ? EQUAL : CGAL::compare_distance_to_point(m_q, a.end, b.end);
      return nearer == EQUAL ? std::tie(a.value, a.side) < std::tie(b.value, b.side) : nearer == SMALLER;
    }

    const Side_search_2& m_search;
    Point m_q;
    double m_least = std::numeric_limits<double>::infinity(); // squared distance
    boost::container::small_vector<Candidate, 8> m_all;
  };

  /// The sides one after the other if they are those of a convex polygon, else nothing.
  static std::vector<Index> convex_ring(const std::vector<Side>& sides)
  {
    std::vector<Index> sorted = indices_below(sides.size()), ring;
    const auto begins_before = [&](Index i, Index rank) { return sides[i].first.rank < rank; };
    std::sort(sorted.begin(), sorted.end(),
              [&](Index i, Index j) { return begins_before(i, sides[j].first.rank); });
    for (Index i = 0; ring.size() < sides.size();) {
      ring.push_back(i);
      const Side& side = sides[i];
      const auto next = std::lower_bound(sorted.begin(), sorted.end(), side.second.rank, begins_before);
      if (next == sorted.end() || side.first.point == side.second.point ||
          sides[*next].first.rank != side.second.rank ||
          CGAL::orientation(side.first.point, side.second.point, sides[*next].second.point) == RIGHT_TURN)
        return {};
      i = *next;
      if ((i == 0) != (ring.size() == sides.size()))
        return {}; // there are several rings
    }
    return ring;
  }

  /// Where parts of the ring begin, each of which has directions in one quadrant, and the end. A ring that goes around
  /// more than once is given up.
  std::vector<std::size_t> parts()
  {
    constexpr std::size_t most = 5; // the first and the last may be of one quadrant
    const auto quadrant = [this](std::size_t k) {
      const auto d = m_sides[m_ring[k]].second.point - m_sides[m_ring[k]].first.point;
      return d.x() > 0 && d.y() >= 0 ? 0 : d.x() <= 0 && d.y() > 0 ? 1 : d.x() < 0 ? 2 : 3;
    };
    std::vector<std::size_t> result;
    for (std::size_t k = 0; k < m_ring.size(); ++k)
      if (k == 0 || quadrant(k) != quadrant(k - 1))
        result.push_back(k);
    if (result.size() > most)
      m_ring.clear();
    if (m_ring.empty())
      return {};
    result.push_back(m_ring.size());
    return result;
  }

  /// the first side of a part beyond whose second end the point is not, or the last one
  Index nearest_of_part(std::size_t first, std::size_t last, const Point& q) const
  {
    while (last - first > 1) {
      const std::size_t before = first + (last - first) / 2 - 1;
      const Side& side = m_sides[m_ring[before]];
      if (Nearest_on_side_2(side.first.point, side.second.point, q).share < 1)
        last = before + 1;
      else
        first = before + 1;
    }
    return m_ring[first];
  }

  /// of the sides, if a tree is needed
  std::vector<Bbox_2> boxes() const
  {
    std::vector<Bbox_2> result;
    if (m_ring.empty())
      for (const Side& s : m_sides)
        result.push_back(s.first.point.bbox() + s.second.point.bbox());
    return result;
  }

  std::vector<Side> m_sides;
  std::vector<Index> m_ring;
  std::vector<std::size_t> m_parts;
  Box_tree_2 m_tree;
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_GEOMETRY_SIDE_SEARCH_2_H
