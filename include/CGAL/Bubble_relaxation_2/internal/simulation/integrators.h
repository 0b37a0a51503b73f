// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_SIMULATION_INTEGRATORS_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_SIMULATION_INTEGRATORS_H

#include <CGAL/Bubble_relaxation_2/internal/core/Bubbles_2.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Progress.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Relaxation_options.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Team.h>
#include <CGAL/Bubble_relaxation_2/internal/core/parallel_for.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Neighbor_sets_2.h>
#include <CGAL/Bubble_relaxation_2/internal/simulation/Boundary_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// The interbubble force, eq. 2 of the paper: repulsion for w < 1, attraction for 1 < w < 1.5, nothing
/// beyond, where w is the distance over the wanted distance.
struct Bubble_force_2
{
  static constexpr double cut_off = 1.5;

  double coefficient = 1; ///< k0

  double operator()(double w) const
  {
    return w <= cut_off ? coefficient * (w * w * (1.25 * w - 2.375) + 1.125) : 0.;
  }
};

/// The resultant force on bubble `i` at the positions `x`, `y`: the sum over its neighbour set in the
/// order of indices. Each bubble gathers its own sum, so that threads and ranks do not change a bit.
inline Force resultant_force(const Bubble_force_2& force, const Neighbor_sets_2& neighbors,
                             const double* x, const double* y, const double* d, std::size_t i)
{
  Force sum{0, 0};
  for (const Index *j = neighbors.begin(i), *end = neighbors.end(i); j != end; ++j) {
    const double dx = x[i] - x[*j], dy = y[i] - y[*j];
    const double wanted = 0.5 * (d[i] + d[*j]);
    const double squared = dx * dx + dy * dy;
    const double reach = Bubble_force_2::cut_off * wanted;
    if (squared > reach * reach)
      continue;
    const double distance = std::sqrt(squared);
    if (distance > 0) {
      const double scale = force(distance / wanted) / distance;
      sum.x += scale * dx;
      sum.y += scale * dy;
    } else { // two bubbles in one place part along the x axis, by their order
      sum.x += (neighbors.is_before(static_cast<Index>(i), *j) ? -1 : 1) * force(0);
    }
  }
  return sum;
}

/// What an integrator wants the active bubbles to do in one step, by their position among them.
struct Displacements
{
  std::vector<double> x, y;

  void start_step(std::size_t n)
  {
    resize_in_turn(x, n);
    resize_in_turn(y, n);
  }
};

/// How the equation of motion (eq. 3) is integrated over a step.
class Integrator
{
public:
  virtual ~Integrator() = default;

  virtual unsigned evaluations_per_step() const = 0;

  /// whether bubbles sleep while they and their neighbours move less than the tolerance
  virtual bool lets_bubbles_sleep() const = 0;

  /// changes the time step, which is that of the options at first
  virtual void set_time_step(double h) = 0;

  /// finds velocities after a step, and displacements in it
  virtual void operator()(Bubbles_2& b, const std::vector<Index>& active, const Neighbor_sets_2& neighbors,
                          const Boundary_2& boundary, Displacements& displacements, Team& team) = 0;
};

/// One step of eq. 3 in units of the local size, which makes it scale-free:
///   v <- (1 - h c/m) v + h k0/m F,   x <- x + h d v.
class Semi_implicit_euler : public Integrator
{
public:
  unsigned evaluations_per_step() const override { return 1; }
  bool lets_bubbles_sleep() const override { return true; }

  explicit Semi_implicit_euler(const Relaxation_options& o)
    : m_threads(o.threads), m_force{o.force_coefficient}, m_mass(o.mass), m_damping(o.damping)
  {
    set_time_step(o.time_step);
  }

  void set_time_step(double h) override
  {
    m_step = h;
    m_keep = (std::max)(0., 1 - h * m_damping / m_mass);
    m_push = h / m_mass;
  }

  void operator()(Bubbles_2& b, const std::vector<Index>& active, const Neighbor_sets_2& neighbors,
                  const Boundary_2& boundary, Displacements& displacements, Team&) override
  {
    displacements.start_step(active.size());
    parallel_for(m_threads, active.size(), [&](std::size_t k) {
      const Index i = active[k];
      Force f = resultant_force(m_force, neighbors, b.x.data(), b.y.data(), b.d.data(), i);
      f = boundary.project(b, i, f);
      b.vx[i] = m_keep * b.vx[i] + m_push * f.x;
      b.vy[i] = m_keep * b.vy[i] + m_push * f.y;
      displacements.x[k] = m_step * b.d[i] * b.vx[i];
      displacements.y[k] = m_step * b.d[i] * b.vy[i];
    });
  }

private:
  const Threads m_threads;
  Bubble_force_2 m_force;
  const double m_mass, m_damping;
  double m_step, m_keep, m_push;
};

/// One step of eq. 3 by the classical Runge-Kutta method, in length units as in the paper. Sizes stay
/// as they are during the step.
class Runge_kutta_4 : public Integrator
{
public:
  unsigned evaluations_per_step() const override { return 4; }
  bool lets_bubbles_sleep() const override { return false; }

  explicit Runge_kutta_4(const Relaxation_options& o)
    : m_threads(o.threads), m_force{o.force_coefficient}, m_step(o.time_step), m_mass(o.mass), m_damping(o.damping)
  {}

  void set_time_step(double h) override { m_step = h; }

  /// Other ranks are told where the bubbles are at the next stage. That depends on velocities only, so the forces of
  /// this stage are found meanwhile; then places of others are put in.
  void operator()(Bubbles_2& b, const std::vector<Index>& active, const Neighbor_sets_2& neighbors,
                  const Boundary_2& boundary, Displacements& displacements, Team& team) override
  {
    const std::size_t n = active.size();
    displacements.start_step(n);
    std::fill(displacements.x.begin(), displacements.x.end(), 0.);
    std::fill(displacements.y.begin(), displacements.y.end(), 0.);
    assign_in_turn(m_sum_vx, n, 0.);
    assign_in_turn(m_sum_vy, n, 0.);
    for (std::vector<double>* x : {&m_x, &m_next_x})
      copy_in_turn(b.x, *x, b.size());
    for (std::vector<double>* y : {&m_y, &m_next_y})
      copy_in_turn(b.y, *y, b.size());
    resize_in_turn(m_vx, n);
    resize_in_turn(m_vy, n);
    for (std::size_t k = 0; k < n; ++k) {
      tick(k);
      m_vx[k] = b.vx[active[k]];
      m_vy[k] = b.vy[active[k]];
    }
    for (const Stage& stage : {Stage{1. / 6, 0.5}, Stage{1. / 3, 0.5}, Stage{1. / 3, 1.},
                               Stage{1. / 6, 0.}}) {
      const bool is_last = stage.ahead == 0;
      if (!is_last) {
        find_next_places(stage, b, active);
        team.send_positions(m_next_x, m_next_y);
      }
      advance(stage, b, active, neighbors, boundary, displacements);
      if (!is_last) {
        team.receive_positions(m_next_x, m_next_y);
        m_x.swap(m_next_x);
        m_y.swap(m_next_y);
      }
    }
    for (std::size_t k = 0; k < n; ++k) {
      tick(k);
      b.vx[active[k]] += m_sum_vx[k];
      b.vy[active[k]] += m_sum_vy[k];
    }
  }

private:
  /// its slopes count with `weight`; the next stage starts `ahead` steps from the start
  struct Stage { double weight, ahead; };

  void find_next_places(const Stage& stage, const Bubbles_2& b, const std::vector<Index>& active)
  {
    const double ahead = stage.ahead * m_step;
    parallel_for(m_threads, active.size(), [&](std::size_t k) {
      const Index i = active[k];
      m_next_x[i] = b.x[i] + ahead * m_vx[k];
      m_next_y[i] = b.y[i] + ahead * m_vy[k];
    });
  }

  void advance(const Stage& stage, const Bubbles_2& b, const std::vector<Index>& active,
               const Neighbor_sets_2& neighbors, const Boundary_2& boundary,
               Displacements& displacements)
  {
    const double sum = stage.weight * m_step, ahead = stage.ahead * m_step;
    parallel_for(m_threads, active.size(), [&](std::size_t k) {
      const Index i = active[k];
      Force f = resultant_force(m_force, neighbors, m_x.data(), m_y.data(), b.d.data(), i);
      f = boundary.project(b, i, f);
      const double ax = (f.x - m_damping * m_vx[k]) / m_mass;
      const double ay = (f.y - m_damping * m_vy[k]) / m_mass;
      displacements.x[k] += sum * m_vx[k];
      displacements.y[k] += sum * m_vy[k];
      m_sum_vx[k] += sum * ax;
      m_sum_vy[k] += sum * ay;
      m_vx[k] = b.vx[i] + ahead * ax;
      m_vy[k] = b.vy[i] + ahead * ay;
    });
  }

  const Threads m_threads;
  Bubble_force_2 m_force;
  double m_step, m_mass, m_damping;
  std::vector<double> m_x, m_y, m_next_x, m_next_y;   // of all bubbles
  std::vector<double> m_vx, m_vy, m_sum_vx, m_sum_vy; // of the active ones
};

inline std::unique_ptr<Integrator> make_integrator(const Relaxation_options& options)
{
  if (options.integrator == Bubble_integrator::RUNGE_KUTTA_4)
    return std::make_unique<Runge_kutta_4>(options);
  return std::make_unique<Semi_implicit_euler>(options);
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_SIMULATION_INTEGRATORS_H
