// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_PHASE_TIMER_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_PHASE_TIMER_H

#include <CGAL/Real_timer.h>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

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

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_PHASE_TIMER_H
