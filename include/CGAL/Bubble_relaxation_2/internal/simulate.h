// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_SIMULATE_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_SIMULATE_H

#include <CGAL/Bubble_relaxation_2/internal/Boundary_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Neighbor_sets_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Phase_timer.h>
#include <CGAL/Bubble_relaxation_2/internal/Progress.h>
#include <CGAL/Bubble_relaxation_2/internal/Relaxation_options.h>
#include <CGAL/Bubble_relaxation_2/internal/integrators.h>
#include <CGAL/Bubble_relaxation_2/internal/parallel_for.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// What one round of simulation did.
struct Round_result
{
  std::size_t steps = 0;
  std::size_t renewals = 0;
  std::size_t returns = 0;   ///< bubbles put back into the domain
  bool is_at_rest = false;   ///< no bubble moved more than the tolerance in the last step
  bool is_cancelled = false;
};

/// Keeps the sizes of the bubbles up to date. d is asked again only where a bubble has moved more than
/// `tolerance` times its size since it was asked last: most bubbles soon hardly move.
template <class Sizing>
class Size_update
{
public:
  static constexpr double tolerance = 0.01;

  Size_update(const Bubbles_2& b, const Sizing& sizing) : m_sizing(sizing), m_x(b.x), m_y(b.y) {}

  void operator()(Bubbles_2& b, std::size_t i)
  {
    const double dx = b.x[i] - m_x[i], dy = b.y[i] - m_y[i], far = tolerance * b.d[i];
    if (dx * dx + dy * dy <= far * far)
      return;
    b.d[i] = m_sizing(b.x[i], b.y[i]);
    m_x[i] = b.x[i];
    m_y[i] = b.y[i];
  }

private:
  const Sizing& m_sizing;
  std::vector<double> m_x, m_y; // where d was asked
};

/// Makes or renews the neighbour sets when it is time: in the paper every `renewal_interval` steps from
/// neighbours of neighbours; by default for the bubbles that have used up their skin, with buckets.
class Renewal
{
public:
  Renewal(Neighbor_sets_2& neighbors, const Relaxation_options& options)
    : m_neighbors(neighbors), m_interval(options.renewal_interval)
  {}

  /// `is_outrun`: whether each bubble has used up its skin; returns whether anything was renewed
  bool operator()(const Bubbles_2& bubbles, std::size_t step, const std::vector<char>& is_outrun)
  {
    if (step == 0)
      m_neighbors.build(bubbles);
    else if (m_interval == 0 && std::find(is_outrun.begin(), is_outrun.end(), 1) != is_outrun.end())
      m_neighbors.renew(bubbles, is_outrun);
    else if (m_interval != 0 && step % m_interval == 0)
      m_neighbors.renew_from_neighbors(bubbles);
    else
      return false;
    return true;
  }

private:
  Neighbor_sets_2& m_neighbors;
  std::size_t m_interval;
};

/// What a step did to each bubble.
struct Step_flags
{
  explicit Step_flags(std::size_t n) : rests(n, 0), returned(n, 0), is_outrun(n, 0) {}

  std::vector<char> rests;     ///< moved less than the tolerance
  std::vector<char> returned;  ///< left its face and was put back
  std::vector<char> is_outrun; ///< has used up its skin
};

/// One round of Fig. 2 of the paper: steps until the bubbles rest, `number_of_iterations` at most.
template <class Concurrency_tag, class Integrator, class Sizing, class Seconds>
Round_result simulate_round(Bubbles_2& bubbles, Neighbor_sets_2& neighbors, Integrator integrator,
                            const Boundary_2& boundary, const Sizing& sizing,
                            const Relaxation_options& options, Progress& progress, Seconds& seconds)
{
  Round_result result;
  Renewal renew(neighbors, options);
  Size_update<Sizing> update_size(bubbles, sizing);
  Displacements displacements;
  Step_flags flags(bubbles.size());

  while (result.steps < options.number_of_iterations && !result.is_at_rest) {
    if (!progress.report_step(result.steps, options.number_of_iterations)) {
      result.is_cancelled = true;
      break;
    }
    {
      const Phase_timer timer(seconds.renewal);
      result.renewals += renew(bubbles, result.steps, flags.is_outrun);
    }
    const Phase_timer timer(seconds.motion);
    integrator(bubbles, neighbors, boundary, displacements);
    parallel_for<Concurrency_tag>(bubbles.size(), [&](std::size_t i) {
      const double x = bubbles.x[i], y = bubbles.y[i];
      flags.returned[i] = boundary.move(bubbles, i, displacements.x[i], displacements.y[i]);
      update_size(bubbles, i);
      const double dx = bubbles.x[i] - x, dy = bubbles.y[i] - y;
      const double little = options.displacement_tolerance * bubbles.d[i];
      flags.rests[i] = dx * dx + dy * dy <= little * little;
      flags.is_outrun[i] = neighbors.is_outrun_by(bubbles, i);
    });
    ++result.steps;
    result.returns += std::count(flags.returned.begin(), flags.returned.end(), 1);
    result.is_at_rest = std::find(flags.rests.begin(), flags.rests.end(), 0) == flags.rests.end();
  }
  return result;
}

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_SIMULATE_H
