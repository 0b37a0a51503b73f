// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_SIMULATION_SIMULATION_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_SIMULATION_SIMULATION_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/Bubbles_2.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Progress.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Sizes_2.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Team.h>
#include <CGAL/Bubble_relaxation_2/internal/core/parallel_for.h>
#include <CGAL/Bubble_relaxation_2/internal/core/vocabulary.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Problem_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Neighbor_sets_2.h>
#include <CGAL/Bubble_relaxation_2/internal/simulation/Active_bubbles_2.h>
#include <CGAL/Bubble_relaxation_2/internal/simulation/Boundary_2.h>
#include <CGAL/Bubble_relaxation_2/internal/simulation/integrators.h>
#include <CGAL/Bubble_relaxation_report_2.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// Keeps the sizes of the bubbles up to date. d is asked again only where a bubble has moved more than
/// `tolerance` times its size since it was asked last: most bubbles soon hardly move.
class Size_update
{
public:
  Size_update(const Bubbles_2& b, const Sizes_2& sizing, double tolerance)
    : m_sizing(sizing), m_tolerance(tolerance)
  {
    const std::size_t n = b.size() + b.size() / 8; // with those that will be added
    copy_in_turn(b.x, m_x, n);
    copy_in_turn(b.y, m_y, n);
  }

  void operator()(Bubbles_2& b, std::size_t i)
  {
    const double dx = b.x[i] - m_x[i], dy = b.y[i] - m_y[i], far = m_tolerance * b.d[i];
    if (dx * dx + dy * dy <= far * far)
      return;
    b.d[i] = m_sizing(b.x[i], b.y[i]);
    m_x[i] = b.x[i];
    m_y[i] = b.y[i];
  }

  void make_room_for(std::size_t n)
  {
    internal::make_room_for(n, m_x);
    internal::make_room_for(n, m_y);
  }

  /// the same, of which it is known where d was asked
  void add(double x, double y)
  {
    m_x.push_back(x);
    m_y.push_back(y);
  }

  double x(std::size_t i) const { return m_x[i]; }
  double y(std::size_t i) const { return m_y[i]; }

  void clear()
  {
    m_x.clear();
    m_y.clear();
  }

private:
  const Sizes_2& m_sizing;
  const double m_tolerance;
  std::vector<double> m_x, m_y; // where d was asked
};

/// What one round of simulation did.
struct Round_result
{
  std::size_t steps = 0;
  std::size_t moves = 0;     ///< bubbles that took part, summed over the steps
  std::size_t renewals = 0;
  std::size_t returns = 0;   ///< bubbles put back into the domain
  bool is_at_rest = false;   ///< no bubble moved more than the tolerance in the last step
  bool is_cancelled = false;
};

/// What a step did to each active bubble, by its position among them.
struct Step_flags
{
  std::vector<char> rests;     ///< moved less than the tolerance
  std::vector<char> is_moving; ///< wanted to move more than it could sleep through
  std::vector<char> returned;  ///< left its face and was put back
  std::vector<char> goes_far;  ///< wanted to move more than a tenth of its size
  std::vector<char> is_outrun; ///< has used up its skin

  void start_step(std::size_t n)
  {
    for (std::vector<char>* flags : {&rests, &is_moving, &returned, &goes_far, &is_outrun})
      resize_in_turn(*flags, n);
  }
};

/// The bubbles in motion, with all that outlasts a round: neighbour sets, sizes, and who sleeps.
class Simulation_2
{
public:
  Simulation_2(const Problem_2& problem, Bubbles_2& bubbles, Team& team)
    : m_options(problem.options), m_time_step(m_options.time_step),
      m_boundary(problem.domain), m_integrator(make_integrator(m_options)),
      m_fine_tolerance(m_options.displacement_tolerance * (is_soon_at_rest(problem) ? 2 : 1)),
      m_tolerance(m_fine_tolerance), m_bubbles(bubbles), m_team(team),
      m_neighbors(m_options.neighbor_radius),
      m_update_size(bubbles, problem.sizes, m_integrator->lets_bubbles_sleep() ? 0.03 : 0.01) // the paper's: 0.01
  {
    m_active.wake_all(bubbles);
  }

  /// While bubbles are still inserted and deleted, rest need not be what it shall be in the end.
  void rest_coarsely()
  {
    if (m_options.population != Bubble_population::DELAUNAY &&
        !(m_integrator->lets_bubbles_sleep() && m_options.population == Bubble_population::OVERLAP_RATIO))
      return;
    m_rests_coarsely = true;
    m_tolerance = coarse_tolerance * m_options.displacement_tolerance;
  }

  bool rests_coarsely() const { return m_rests_coarsely; }

  /// Wakes all bubbles for the rest that is asked for; returns false if it was that already.
  bool rest_finely()
  {
    if (!m_rests_coarsely)
      return false;
    m_rests_coarsely = false;
    m_tolerance = m_fine_tolerance;
    m_active.rouse_all(m_bubbles);
    return true;
  }

  void halve_steps()
  {
    constexpr double least = 1e-6; // of those that the options ask for
    if (m_time_step > least * m_options.time_step)
      m_time_step /= 2;
    m_integrator->set_time_step(m_time_step);
  }

  const Neighbor_sets_2& neighbors() const { return m_neighbors; }
  Neighbor_sets_2& neighbors() { return m_neighbors; }

  unsigned evaluations_per_step() const { return m_integrator->evaluations_per_step(); }

  /// whether bubbles are renewed before they go far from where their neighbours were last looked for
  bool keeps_references() const { return m_options.renewal_interval == 0; }

  /// whether all are awake only to look whether they rest
  bool is_roused() const { return m_active.is_roused(); }

  Bubble_memory_2 memory(Index i) const
  {
    return Bubble_memory_2{m_neighbors.reference_x(i), m_neighbors.reference_y(i), m_neighbors.reference_d(i),
                           m_update_size.x(i),         m_update_size.y(i),         m_active.is_active(i),
                           m_active.is_touched(i)};
  }

  /// adds a bubble that is not new, but was not known here; it is in `bubbles` already
  void add_known(const Bubble_memory_2& m)
  {
    const Index i = static_cast<Index>(m_bubbles.size()) - 1;
    m_neighbors.add(i, m.reference_x, m.reference_y, m.reference_d);
    m_update_size.add(m.asked_x, m.asked_y);
    m_active.make_room(m_bubbles);
    if (m_bubbles.can_move(i) && m_neighbors.is_outrun_by(m_bubbles, i))
      m_outrun.push_back(i);
  }

  /// goes on with other bubbles, of each of which a simulation remembers something
  void restart(const std::vector<Bubble_memory_2>& memories, bool is_roused)
  {
    m_has_begun = true;
    std::vector<double> x, y, d;
    std::vector<char> is_active, is_touched;
    m_update_size.clear();
    for (std::size_t i = 0; i < memories.size(); ++i) {
      const Bubble_memory_2& m = memories[i];
      x.push_back(m.reference_x);
      y.push_back(m.reference_y);
      d.push_back(m.reference_d);
      m_update_size.add(m.asked_x, m.asked_y);
      is_active.push_back(m_bubbles.is_ours(i) ? m.is_active : char(0));
      is_touched.push_back(m.is_touched);
    }
    m_neighbors.build(m_bubbles, Bubble_references_2{x, y, d}, m_options.threads);
    m_active.restart(is_active, is_touched, is_roused);
    m_outrun = indices_where(memories.size(), [this](Index i) {
      return m_bubbles.can_move(i) && m_neighbors.is_outrun_by(m_bubbles, i);
    });
  }

  /// the bubbles that may have moved in the last round
  std::vector<Index> touched() const { return m_active.touched(); }

  /// One round of Fig. 2 of the paper: steps until the bubbles rest, `number_of_iterations` at most.
  Round_result run_round(Bubble_relaxation_seconds& seconds)
  {
    Round_result result;
    m_active.forget_touched();
    {
      const Phase_timer timer(seconds.renewal);
      result.renewals += build_neighbors_if_first();
    }
    m_sums = m_team.sum(Step_sums{0, 0, m_bubbles.count_ours(m_outrun)});
    while (result.steps < m_options.number_of_iterations && !result.is_at_rest) {
      if (!m_team.goes_on(report_progress())) {
        result.is_cancelled = true;
        break;
      }
      {
        const Phase_timer timer(seconds.renewal);
        if (m_team.is_outgrown())
          m_team.look_for_ghosts_anew(*this, m_bubbles);
        result.renewals += renew_neighbors(result.steps);
      }
      {
        const Phase_timer timer(seconds.motion);
        step(result);
        if (result.steps >= least_steps_of_wild && result.steps % steps_to_calm == 0 && is_wild())
          calm_down();
      }
      if (Observer* observer = m_options.progress->observer())
        observer->step_ends(m_bubbles);
    }
    m_team.end_steps(*this, m_bubbles);
    if (!keeps_references()) { // as in the paper before each round, and for the control of the population
      const Phase_timer timer(seconds.renewal);
      build_neighbors();
      ++result.renewals;
    }
    if (m_options.population == Bubble_population::DELAUNAY)
      m_team.look_across_holes(*this, m_bubbles);
    return result;
  }

  /// Carries out a change of the population. Indices stay: new bubbles come after the last.
  void apply(const Population_change& change)
  {
    for (Index i : change.deleted) {
      const std::vector<Index> bereft(m_neighbors.begin(i), m_neighbors.end(i));
      m_neighbors.remove(i);
      m_bubbles.remove(i);
      for (Index j : bereft)
        m_active.wake(m_bubbles, j);
    }
    m_active.forget_gone(m_bubbles);
    m_outrun.erase(std::remove_if(m_outrun.begin(), m_outrun.end(),
                                  [this](Index i) { return m_bubbles.is_gone(i); }),
                   m_outrun.end());
    const Bubbles_2& in = change.inserted;
    m_bubbles.make_room_for(in.size());
    m_neighbors.make_room_for(in.size());
    m_update_size.make_room_for(in.size());
    const Index first = static_cast<Index>(m_bubbles.size());
    for (std::size_t k = 0; k < in.size(); ++k) {
      tick(k);
      const Index i = static_cast<Index>(m_bubbles.size());
      m_bubbles.add(in, k);
      if (!in.id.empty()) {
        m_bubbles.id.push_back(in.id[k]);
        m_bubbles.owner.push_back(m_bubbles.rank);
      }
      m_neighbors.add(m_bubbles, i);
      m_update_size.add(in.x[k], in.y[k]);
      wake_around(i);
    }
    m_team.share_new(*this, m_bubbles, first);
  }

  /// a bubble is new, and takes part in the next step with its neighbours
  void wake_around(Index i)
  {
    m_active.wake(m_bubbles, i);
    for (const Index *j = m_neighbors.begin(i), *end = m_neighbors.end(i); j != end; ++j)
      m_active.wake(m_bubbles, *j);
  }

private:
  static constexpr double coarse_tolerance = 3.3; // times that of the end
  static constexpr std::size_t least_steps_of_wild = 10; // before, bubbles may still be on their way
  static constexpr std::size_t steps_to_calm = 5;        // from standstill, if steps are short enough

  /// Tells which share of the simulation is over. Bubbles that may sleep need 3 to 30 moves, as the sizes have it: each
  /// counts less than the one before.
  bool report_progress() const
  {
    constexpr double half_way = 4;
    const double moves = static_cast<double>(m_number_of_moves) / static_cast<double>(m_bubbles.size() + 1);
    const double most = static_cast<double>(m_options.number_of_rounds * m_options.number_of_iterations);
    return m_options.progress->report_share(m_integrator->lets_bubbles_sleep() ? moves / (moves + half_way)
                                                                               : moves / (most + 1));
  }

  /// whether the treatment makes more of triangles in less time than the last moves would
  bool is_soon_at_rest(const Problem_2& problem) const
  {
    return problem.follows_outline() && m_options.defect_treatment && m_integrator->lets_bubbles_sleep();
  }

  /// makes the neighbour sets before the first round
  bool build_neighbors_if_first()
  {
    if (m_has_begun)
      return false;
    m_has_begun = true;
    build_neighbors();
    m_team.look_for_ghosts(*this, m_bubbles);
    return true;
  }

  void build_neighbors()
  {
    m_neighbors.build(m_bubbles, m_options.threads);
    m_outrun.clear();
  }

  /// Renews the neighbour sets when it is time: in the paper every `renewal_interval` steps from
  /// neighbours of neighbours, unless sets are large; by default for the bubbles that have used up their skin, with buckets.
  bool renew_neighbors(std::size_t step)
  {
    const std::size_t interval = m_options.renewal_interval;
    if (interval == 0 && m_sums.outrun != 0) {
      if (3 * m_sums.outrun > m_team.number_of_all(m_bubbles))
        m_neighbors.build(m_bubbles, m_options.threads);
      else
        m_neighbors.renew(m_bubbles, m_outrun, m_options.threads);
    } else if (interval != 0 && step != 0 && step % interval == 0) {
      if (have_large_sets())
        m_neighbors.build(m_bubbles, m_options.threads);
      else {
        m_team.share_sets(m_bubbles, m_neighbors);
        m_neighbors.renew_from_neighbors(m_bubbles);
      }
    } else
      return false;
    m_outrun.clear();
    return true;
  }

  /// Whether there are too many neighbours of neighbours to look at all: the radius is large, or bubbles are crowded.
  bool have_large_sets() const
  {
    constexpr std::size_t usual = 36; // within three times the distance of neighbours
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < m_bubbles.size(); ++i) {
      const Index k = static_cast<Index>(i);
      const std::size_t size = static_cast<std::size_t>(m_neighbors.end(k) - m_neighbors.begin(k));
      sum += m_bubbles.is_ours(i) ? size * size : 0;
    }
    m_team.add_up(sum);
    return sum > usual * usual * m_team.number_of_all(m_bubbles);
  }

  void step(Round_result& result)
  {
    const std::vector<Index>& active = m_active.indices();
    (*m_integrator)(m_bubbles, active, m_neighbors, m_boundary, m_displacements, m_team);
    m_flags.start_step(active.size());
    move_all_of(active, true);
    m_team.send_moves(m_bubbles, active, m_flags.is_moving);
    move_all_of(active, false);
    ++result.steps;
    result.moves += active.size();
    m_number_of_moves += active.size();
    Step_sums sums;
    for (std::size_t k = 0; k < active.size(); ++k) {
      result.returns += m_flags.returned[k] != 0;
      sums.restless += m_flags.rests[k] == 0;
      sums.far += m_flags.goes_far[k] != 0;
      if (m_flags.is_outrun[k])
        m_outrun.push_back(active[k]);
    }
    sums.outrun = m_outrun.size();
    const std::vector<Index>& others = m_team.receive_moves(m_bubbles, active, m_flags.is_moving);
    for (Index i : others)
      if (m_neighbors.is_outrun_by(m_bubbles, i))
        m_outrun.push_back(i);
    if (m_integrator->lets_bubbles_sleep()) {
      m_active.add_others(others);
      m_active.advance(m_bubbles, m_neighbors, m_flags.is_moving, m_options.threads);
    } else if (!m_team.is_alone())
      m_active.forget_others(m_bubbles); // those that wait in others' parts
    m_sums = m_team.sum(sums);
    result.is_at_rest = m_sums.restless == 0;
  }

  /// moves the active bubbles at the border to other ranks, or all others
  void move_all_of(const std::vector<Index>& active, bool is_at_border)
  {
    const bool is_alone = m_team.is_alone();
    if (is_alone && is_at_border)
      return;
    parallel_for(m_options.threads, active.size(), [&](std::size_t k) {
      if (is_alone || m_team.is_at_border(active[k]) == is_at_border)
        move(k, active[k]);
    });
  }

  /// whether steps are too long for forces and mass: a third of the bubbles went far in the last one
  bool is_wild() const
  {
    return m_integrator->lets_bubbles_sleep() && 3 * m_sums.far > m_team.number_of_all(m_bubbles);
  }

  /// lets all bubbles start again, from standstill, with shorter steps
  void calm_down()
  {
    halve_steps();
    for (std::vector<double>* v : {&m_bubbles.vx, &m_bubbles.vy})
      std::fill(v->begin(), v->end(), 0.);
  }

  void move(std::size_t k, Index i)
  {
    Bubbles_2& b = m_bubbles;
    const double x = b.x[i], y = b.y[i];
    m_flags.returned[k] = m_boundary.move(b, i, m_displacements.x[k], m_displacements.y[k]);
    m_update_size(b, i);
    const double dx = b.x[i] - x, dy = b.y[i] - y;
    const double little = m_tolerance * b.d[i], far = 0.1 * b.d[i];
    const double squared = m_displacements.x[k] * m_displacements.x[k] + m_displacements.y[k] * m_displacements.y[k];
    m_flags.is_moving[k] = squared > little * little;
    m_flags.rests[k] = dx * dx + dy * dy <= little * little;
    m_flags.goes_far[k] = squared > far * far;
    m_flags.is_outrun[k] = m_neighbors.is_outrun_by(b, i);
  }

  const Relaxation_options& m_options;
  bool m_has_begun = false; // neighbours were looked for, if only of other ranks' bubbles
  bool m_rests_coarsely = false;
  std::size_t m_number_of_moves = 0;
  double m_time_step;
  const Boundary_2 m_boundary;
  std::unique_ptr<Integrator> m_integrator;
  const double m_fine_tolerance; // a displacement of less, in units of the size, is rest, in the end
  double m_tolerance;            // the same now
  Bubbles_2& m_bubbles;
  Team& m_team;
  Neighbor_sets_2 m_neighbors;
  Active_bubbles_2 m_active;
  Size_update m_update_size;
  Displacements m_displacements;
  Step_flags m_flags;
  std::vector<Index> m_outrun; // waiting for their renewal
  Step_sums m_sums; // of the last step
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_SIMULATION_SIMULATION_2_H
