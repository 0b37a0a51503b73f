// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_INTEGRATORS_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_INTEGRATORS_H

#include <CGAL/Bubble_relaxation_2/internal/Boundary_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Bubble_force_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Neighbor_sets_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Relaxation_options.h>
#include <CGAL/Bubble_relaxation_2/internal/parallel_for.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// The displacements that an integrator wants the bubbles to make in one step, and which bubbles were
/// moving in the step before.
struct Displacements
{
  std::vector<double> x, y;
  std::vector<char> was_moving, is_moving;

  void start_step(std::size_t n)
  {
    x.resize(n);
    y.resize(n);
    if (is_moving.size() != n)
      is_moving.assign(n, 1);
    was_moving.swap(is_moving);
    is_moving.resize(n);
  }
};

/// One step of eq. 3 in units of the local size, which makes it scale-free:
///   v <- (1 - h c/m) v + h k0/m F,   x <- x + h d v.
/// A bubble sleeps while it and its neighbours hardly move: after some dozen steps most do.
template <class Concurrency_tag>
class Semi_implicit_euler
{
public:
  static constexpr unsigned evaluations_per_step = 1;

  explicit Semi_implicit_euler(const Relaxation_options& o)
    : m_force{o.force_coefficient}, m_step(o.time_step),
      m_keep((std::max)(0., 1 - o.time_step * o.damping / o.mass)), m_push(o.time_step / o.mass),
      m_hardly(share_of_tolerance * o.displacement_tolerance)
  {}

  void operator()(Bubbles_2& b, const Neighbor_sets_2& neighbors, const Boundary_2& boundary,
                  Displacements& displacements) const
  {
    displacements.start_step(b.size());
    parallel_for<Concurrency_tag>(b.size(), [&](std::size_t i) {
      if (b.is_corner(i) || sleeps(i, neighbors, displacements.was_moving)) {
        displacements.x[i] = displacements.y[i] = b.vx[i] = b.vy[i] = 0;
        displacements.is_moving[i] = 0;
        return;
      }
      Force f = resultant_force(m_force, neighbors, b.x.data(), b.y.data(), b.d.data(), i);
      f = boundary.project(b, i, f);
      b.vx[i] = m_keep * b.vx[i] + m_push * f.x;
      b.vy[i] = m_keep * b.vy[i] + m_push * f.y;
      displacements.x[i] = m_step * b.d[i] * b.vx[i];
      displacements.y[i] = m_step * b.d[i] * b.vy[i];
      const double far = m_step * m_step * (b.vx[i] * b.vx[i] + b.vy[i] * b.vy[i]);
      displacements.is_moving[i] = far > m_hardly * m_hardly;
    });
  }

private:
  /// a bubble that moves less than this times the tolerance may fall asleep
  static constexpr double share_of_tolerance = 0.2;

  static bool sleeps(std::size_t i, const Neighbor_sets_2& neighbors,
                     const std::vector<char>& was_moving)
  {
    if (was_moving[i])
      return false;
    for (const Index *j = neighbors.begin(i), *end = neighbors.end(i); j != end; ++j)
      if (was_moving[*j])
        return false;
    return true;
  }

  Bubble_force_2 m_force;
  double m_step, m_keep, m_push;
  double m_hardly; // displacement over d
};

/// One step of eq. 3 by the classical Runge-Kutta method, in length units as in the paper. Sizes stay
/// as they are during the step.
template <class Concurrency_tag>
class Runge_kutta_4
{
public:
  static constexpr unsigned evaluations_per_step = 4;

  explicit Runge_kutta_4(const Relaxation_options& o)
    : m_force{o.force_coefficient}, m_step(o.time_step), m_mass(o.mass), m_damping(o.damping)
  {}

  void operator()(Bubbles_2& b, const Neighbor_sets_2& neighbors, const Boundary_2& boundary,
                  Displacements& displacements)
  {
    const std::size_t n = b.size();
    displacements.start_step(n);
    for (std::vector<double>* a : {&m_x, &m_y, &m_next_x, &m_next_y, &m_vx, &m_vy, &m_sum_vx,
                                   &m_sum_vy})
      a->assign(n, 0);
    displacements.x.assign(n, 0);
    displacements.y.assign(n, 0);
    m_x = b.x;
    m_y = b.y;
    m_vx = b.vx;
    m_vy = b.vy;
    stage(b, neighbors, boundary, displacements, 1. / 6, 0.5);
    stage(b, neighbors, boundary, displacements, 1. / 3, 0.5);
    stage(b, neighbors, boundary, displacements, 1. / 3, 1.);
    stage(b, neighbors, boundary, displacements, 1. / 6, 0.);
    for (std::size_t i = 0; i < n; ++i) {
      b.vx[i] += m_sum_vx[i];
      b.vy[i] += m_sum_vy[i];
    }
  }

private:
  /// adds the stage's slopes with `weight` and goes on to the next stage's state, `ahead` steps from
  /// the start
  void stage(const Bubbles_2& b, const Neighbor_sets_2& neighbors, const Boundary_2& boundary,
             Displacements& displacements, double weight, double ahead)
  {
    parallel_for<Concurrency_tag>(b.size(), [&](std::size_t i) {
      m_next_x[i] = b.x[i];
      m_next_y[i] = b.y[i];
      if (b.is_corner(i))
        return;
      Force f = resultant_force(m_force, neighbors, m_x.data(), m_y.data(), b.d.data(), i);
      f = boundary.project(b, i, f);
      const double ax = (f.x - m_damping * m_vx[i]) / m_mass;
      const double ay = (f.y - m_damping * m_vy[i]) / m_mass;
      displacements.x[i] += weight * m_step * m_vx[i];
      displacements.y[i] += weight * m_step * m_vy[i];
      m_sum_vx[i] += weight * m_step * ax;
      m_sum_vy[i] += weight * m_step * ay;
      m_next_x[i] = b.x[i] + ahead * m_step * m_vx[i];
      m_next_y[i] = b.y[i] + ahead * m_step * m_vy[i];
      m_vx[i] = b.vx[i] + ahead * m_step * ax;
      m_vy[i] = b.vy[i] + ahead * m_step * ay;
    });
    m_x.swap(m_next_x);
    m_y.swap(m_next_y);
  }

  Bubble_force_2 m_force;
  double m_step, m_mass, m_damping;
  std::vector<double> m_x, m_y, m_next_x, m_next_y, m_vx, m_vy, m_sum_vx, m_sum_vy;
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_INTEGRATORS_H
