// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_PLACEMENT_GROWTH_LIMITS_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_PLACEMENT_GROWTH_LIMITS_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/Bubbles_2.h>
#include <CGAL/Bubble_relaxation_2/internal/core/reproducible_math.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Flat_triangulation_2.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <unordered_set>

namespace CGAL::Bubble_relaxation_2::internal {

/// turned to the left by 60 degrees
inline Direction turned(const Direction& u)
{
  constexpr double cosine = 0.5, sine = 0.86602540378443864676;
  return {cosine * u.x - sine * u.y, sine * u.x + cosine * u.y};
}

/// Bubbles nearer than this, in units of their mean size, are neighbours.
constexpr double largest_distance_of_neighbors = 1.3;

/// Calls `visit(dx, dy, distance, wanted distance)` if bubbles at (x, y) and (x2, y2) are neighbours, with the way from
/// the second to the first.
template <class Visitor>
void visit_if_neighbors(double x, double y, double d, double x2, double y2, double d2, const Visitor& visit)
{
  const double dx = x - x2, dy = y - y2, squared = dx * dx + dy * dy;
  const double wanted = 0.5 * (d + d2), reach = largest_distance_of_neighbors * wanted;
  if (squared > 0 && squared <= reach * reach)
    visit(dx, dy, std::sqrt(squared), wanted);
}

/// Where a bubble of size `d` goes from `p` in a step of Newton's method for springs between it and its neighbours.
/// `for_each(add)`: calls `add(x, y, d)` for other bubbles, neighbours or not
template <class For_each>
Point settled(const Point& p, double d, const For_each& for_each)
{
  double sum_x = 0, sum_y = 0, number = 0;
  for_each([&](double x2, double y2, double d2) {
    visit_if_neighbors(p.x(), p.y(), d, x2, y2, d2, [&](double dx, double dy, double distance, double wanted) {
      const double stretch = wanted / distance - 1;
      number += 1;
      sum_x += stretch * dx;
      sum_y += stretch * dy;
    });
  });
  // springs in all directions are half as stiff as in one
  const double compliance = 1 / (std::max)(1., 0.5 * number);
  return Point(p.x() + compliance * sum_x, p.y() + compliance * sum_y);
}

/// The bubbles around a place where another may go, gathered once for all questions about it.
class Growth_limits_2
{
public:
  /// no bubble is set nearer to another than this, in units of their mean size
  static constexpr double least_distance = 0.8;

  std::size_t size() const { return m_bubbles.size(); }
  Index index(std::size_t k) const { return m_bubbles[k].id; }

  /// adds bubble `i` if it is nearer to one of size `d` at `p` than `reach` times the mean size, once
  void add_if_near(Index i, const Bubbles_2& b, const Point& p, double d, double reach)
  {
    const double dx = p.x() - b.x[i], dy = p.y() - b.y[i], distance = 0.5 * reach * (d + b.d[i]);
    if (dx * dx + dy * dy < distance * distance && is_new(i))
      m_bubbles.push_back(Bubble{b.x[i], b.y[i], b.d[i], i});
  }

  /// one that is not there yet
  void add(const Point& p, double d) { m_bubbles.push_back(Bubble{p.x(), p.y(), d, no_index}); }

  /// whether a bubble of size `d` has room at `p` beside those that were added after `first` others
  bool is_free(const Point& p, double d, std::size_t first = 0) const
  {
    return std::none_of(m_bubbles.begin() + static_cast<std::ptrdiff_t>(first), m_bubbles.end(), [&](const Bubble& b) {
      const double reach = 0.5 * least_distance * (d + b.d), dx = p.x() - b.x, dy = p.y() - b.y;
      return dx * dx + dy * dy < reach * reach;
    });
  }

  /// whether `predicate(index, x, y, d)` holds for one of them; the index of one not there yet is
  /// `no_index`
  template <class Predicate>
  bool any_of(const Predicate& predicate) const
  {
    return std::any_of(m_bubbles.begin(), m_bubbles.end(), [&](const Bubble& b) {
      return predicate(b.id, b.x, b.y, b.d);
    });
  }

  /// The place of a bubble among all its neighbours: a few steps of Newton's method for springs between
  /// them.
  Point settle(Point p, double d, int steps) const
  {
    const auto for_each = [this](const auto& add) {
      for (const Bubble& b : m_bubbles)
        add(b.x, b.y, b.d);
    };
    for (int k = 0; k < steps; ++k)
      p = settled(p, d, for_each);
    return p;
  }

  /// how badly a bubble fits: the energy of the springs to its neighbours
  double misfit(const Point& p, double d) const
  {
    double sum = 0;
    for_each_neighbor(p.x(), p.y(), d, [&](double, double, double distance, double wanted) {
      sum += (distance / wanted - 1) * (distance / wanted - 1);
    });
    return sum;
  }

  /// the direction of the lattice at `p`: that of its neighbours, the six-fold mean, next to `u`
  Direction direction(const Point& p, double d, const Direction& u) const
  {
    double sum_x = 0, sum_y = 0; // of the sixth powers, as complex numbers
    for_each_neighbor(p.x(), p.y(), d, [&](double dx, double dy, double distance, double) {
      const double x = (dx * u.x + dy * u.y) / distance, y = (dy * u.x - dx * u.y) / distance;
      const double cube_x = x * (x * x - 3 * y * y), cube_y = y * (3 * x * x - y * y);
      sum_x += cube_x * cube_x - cube_y * cube_y;
      sum_y += 2 * cube_x * cube_y;
    });
    const double angle = angle_of(sum_x, sum_y) / 6, c = cosine_of(angle), s = sine_of(angle);
    return {c * u.x - s * u.y, s * u.x + c * u.y};
  }

private:
  struct Bubble
  {
    double x, y, d;
    Index id;
  };

  /// Few are looked through faster; beside an outline that is far finer than d there are thousands.
  bool is_new(Index i)
  {
    constexpr std::size_t few = 64;
    if (m_bubbles.size() < few)
      return std::none_of(m_bubbles.begin(), m_bubbles.end(), [i](const Bubble& b) { return b.id == i; });
    if (m_indices.empty())
      for (const Bubble& b : m_bubbles)
        m_indices.insert(b.id);
    return m_indices.insert(i).second;
  }

  /// calls `visit(dx, dy, distance, wanted distance)` for the neighbours of a bubble at (x, y)
  template <class Visitor>
  void for_each_neighbor(double x, double y, double d, const Visitor& visit) const
  {
    for (const Bubble& b : m_bubbles)
      visit_if_neighbors(x, y, d, b.x, b.y, b.d, visit);
  }

  boost::container::small_vector<Bubble, 24> m_bubbles;
  std::unordered_set<Index> m_indices; // of those that are there, if they are many
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_PLACEMENT_GROWTH_LIMITS_2_H
