// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_CORE_PROGRESS_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_CORE_PROGRESS_H

#include <CGAL/Real_timer.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <utility>

namespace CGAL::Bubble_relaxation_2::internal {

/// Adds the time of its life to a phase of the report.
class Phase_timer
{
public:
  explicit Phase_timer(double& seconds) : m_seconds(seconds) { m_timer.start(); }
  ~Phase_timer() { stop(); }
  Phase_timer(const Phase_timer&) = delete;
  Phase_timer& operator=(const Phase_timer&) = delete;

  /// ends the phase before its scope ends
  void stop()
  {
    if (m_timer.is_running()) {
      m_timer.stop();
      m_seconds += m_timer.time();
    }
  }

private:
  double& m_seconds;
  Real_timer m_timer;
};

/// Passes progress in [0, 1], never falling, to the user's callback and remembers when it says stop.
class Progress
{
public:
  Progress(std::function<bool(double)> callback, std::size_t number_of_rounds)
    : m_callback(std::move(callback)), m_number_of_rounds((std::max)(number_of_rounds, std::size_t(1)))
  {}

  void start_round(std::size_t round) { m_round = round; }

  /// returns false if the user wants to stop
  bool report_step(std::size_t step, std::size_t number_of_steps)
  {
    // the bubbles' simulation is all but the last hundredth, which is left to the triangulation
    const double rounds = static_cast<double>(m_round) +
                          static_cast<double>(step) / static_cast<double>(number_of_steps);
    return report(0.99 * rounds / static_cast<double>(m_number_of_rounds));
  }

  bool report(double fraction)
  {
    m_fraction = (std::max)(m_fraction, (std::min)(fraction, 1.));
    if (m_callback && !m_is_cancelled && !m_callback(m_fraction))
      m_is_cancelled = true;
    return !m_is_cancelled;
  }

private:
  std::function<bool(double)> m_callback;
  std::size_t m_number_of_rounds;
  std::size_t m_round = 0;
  double m_fraction = 0;
  bool m_is_cancelled = false;
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_CORE_PROGRESS_H
