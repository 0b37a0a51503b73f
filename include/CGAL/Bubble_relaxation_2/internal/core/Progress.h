// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_CORE_PROGRESS_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_CORE_PROGRESS_H

#include <CGAL/Bubble_relaxation_enums.h>
#include <CGAL/Real_timer.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {

template <class FT_>
struct Bubble_relaxation_report_2;

namespace Bubble_relaxation_2::internal {

struct Bubbles_2;

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

/// is thrown where the user's callback wants all to stop, and caught at the door
struct Stopped_by_callback {};

template <class Report>
void tell_that_it_was_stopped(Report& report)
{
  report.stop_reason = Bubble_stop_reason::STOPPED_BY_CALLBACK;
  report.converged = false;
}

/// Does what a callback may stop. Then there is no mesh, and what the report may tell of one is taken back.
template <class Report, class Work>
void do_unless_stopped(Report& report, const Work& work)
{
  try {
    work();
  } catch (const Stopped_by_callback&) {
    tell_that_it_was_stopped(report);
    report.number_of_vertices = report.number_of_triangles = 0;
    report.number_of_forced_triangles = report.number_of_small_angles = 0;
    report.largest_size_gradient = report.steep_share = 0;
    report.quality = {};
    report.forced_places = {};
  }
}

/// A visitor of the user's, without its type.
class Observer
{
public:
  virtual ~Observer() = default;
  virtual void phase_begins(Bubble_phase) = 0;
  virtual void step_ends(const Bubbles_2&) = 0;
  virtual void round_ends(const Bubble_relaxation_report_2<double>&) = 0;
};

/// Passes progress in [0, 1], never falling, to the user's callback, and stops all when it says so.
class Progress
{
public:
  explicit Progress(std::function<bool(double)> callback = nullptr, std::unique_ptr<Observer> observer = nullptr)
    : m_callback(std::move(callback)), m_observer(std::move(observer)), m_start(Clock::now()), m_last(m_start)
  {}

  /// whether there is a callback
  bool is_heard() const { return static_cast<bool>(m_callback); }

  /// to tell a visitor of steps and rounds
  Observer* observer() const { return m_observer.get(); }

  void start_phase(Bubble_phase phase)
  {
    // shares of the time of all, by the benchmark progress: writing takes less where triangles are written as they are
    constexpr double begins[] = {0, 0.01, 0.29, 0.6, 0.9, 0.95, 1};
    m_begin = begins[static_cast<int>(phase)];
    m_end = begins[static_cast<int>(phase) + 1];
    m_start_of_phase = Clock::now();
    m_is_measured = false;
    if (m_observer)
      m_observer->phase_begins(phase);
    report(m_begin);
  }

  /// `share` of the phase is done
  /// \returns false if the user wants to stop
  bool report_share(double share)
  {
    m_is_measured = true;
    return report(m_begin + share * (m_end - m_begin));
  }

  bool report(double fraction)
  {
    m_fraction = (std::max)(m_fraction, (std::min)(fraction, 1.));
    if (m_callback && !m_is_stopped) {
      m_last = Clock::now();
      m_is_calling = true;
      m_is_stopped = !m_callback(m_fraction);
      m_is_calling = false;
      if (m_is_stopped && m_throws)
        throw Stopped_by_callback();
    }
    return !m_is_stopped;
  }

  /// Time has gone by: calls the callback if it was not called in the last fortieth of a second: what does not tick may
  /// take three times as long.
  void tick()
  {
    if (is_due())
      report(m_is_measured ? m_fraction : m_begin + expected_share() * (m_end - m_begin));
  }

  /// the same where it is known which share of the phase is done; what ticks in between tells this share
  void tick_share(double share)
  {
    m_is_measured = true;
    m_fraction = (std::max)(m_fraction, m_begin + share * (m_end - m_begin));
    tick();
  }

  /// Tells that all is done, and nothing after that: what users do then may tick as well.
  void finish()
  {
    report(1);
    m_is_over = true;
  }

  bool is_stopped() const { return m_is_stopped; }

  /// From here on a stop is not thrown, but remembered for those who ask.
  void remember_stop() { m_throws = false; }

private:
  using Clock = std::chrono::steady_clock;
  using Seconds = std::chrono::duration<double>;

  bool is_due() const
  {
    return m_callback && !m_is_calling && !m_is_stopped && !m_is_over &&
           Clock::now() - m_last >= std::chrono::milliseconds(25);
  }

  /// How much of the phase is over if it goes on at the pace so far; from the half on less and less, since it may take
  /// longer.
  double expected_share() const
  {
    constexpr double first_guess = 10, enough_to_know = 0.2; // seconds that all takes; the share that tells more
    const Clock::time_point now = Clock::now();
    const double of_all =
      m_begin > enough_to_know ? Seconds(m_start_of_phase - m_start).count() / m_begin : first_guess;
    const double share = Seconds(now - m_start_of_phase).count() / (of_all * (m_end - m_begin));
    return share <= 0.5 ? share : 1 - 1 / (4 * share);
  }

  std::function<bool(double)> m_callback;
  std::unique_ptr<Observer> m_observer;
  Clock::time_point m_start, m_last, m_start_of_phase;
  double m_begin = 0, m_end = 0, m_fraction = 0;
  bool m_is_measured = false, m_is_stopped = false, m_is_over = false, m_throws = true;
  bool m_is_calling = false; // loops of what the callback calls tell nobody
};

/// whom the loops of this thread tell that they go on; other threads that help it tell nobody
inline thread_local Progress* progress_of_thread = nullptr;

/// Makes loops of this thread tell somebody, for as long as it lives.
class Progress_scope
{
public:
  explicit Progress_scope(Progress& progress) : m_before(std::exchange(progress_of_thread, &progress)) {}
  ~Progress_scope() { progress_of_thread = m_before; }
  Progress_scope(const Progress_scope&) = delete;
  Progress_scope& operator=(const Progress_scope&) = delete;

private:
  Progress* m_before; // what calls the package within a callback has one of its own
};

/// A loop goes on: to be called at least every few milliseconds of it.
inline void tick()
{
  if (progress_of_thread != nullptr)
    progress_of_thread->tick();
}

/// the same for the i-th turn of a loop whose turns take microseconds
inline void tick(std::size_t i)
{
  if (i % 256 == 0)
    tick();
}

/// the same where `done` of the turns of a phase, `all` in number, are done
inline void tick(std::size_t done, std::size_t all)
{
  if (done % 256 == 0 && progress_of_thread != nullptr)
    progress_of_thread->tick_share(static_cast<double>(done) / static_cast<double>(all));
}

/// how many elements of an array are made or copied at once, before it ticks: with millions the memory alone, where it
/// is touched for the first time, takes tenths of a second
constexpr std::size_t elements_at_once = 1 << 16;

/// the same as `array.resize(n, value)`, with no more memory than that needs
template <class T>
void resize_in_turn(std::vector<T>& array, std::size_t n, const T& value = T())
{
  array.reserve(n);
  do {
    array.resize((std::min)(n, array.size() + elements_at_once), value);
    tick();
  } while (array.size() < n);
}

/// the same as `array.assign(n, value)`
template <class T>
void assign_in_turn(std::vector<T>& array, std::size_t n, const T& value)
{
  array.clear();
  resize_in_turn(array, n, value);
}

/// adds a copy of all elements of an array to another one, in which there is room for them
template <class T>
void append_in_turn(const std::vector<T>& from, std::vector<T>& to)
{
  for (std::size_t first = 0; first < from.size(); first += elements_at_once) {
    const std::size_t last = (std::min)(first + elements_at_once, from.size());
    to.insert(to.end(), from.begin() + static_cast<std::ptrdiff_t>(first),
              from.begin() + static_cast<std::ptrdiff_t>(last));
    tick();
  }
}

/// makes an array a copy of another one, with room for `n` elements
template <class T>
void copy_in_turn(const std::vector<T>& from, std::vector<T>& to, std::size_t n)
{
  to.clear();
  to.reserve(n);
  append_in_turn(from, to);
}

/// whether the user wants all to stop, so that what need not be done may be left
inline bool is_stop_wanted() { return progress_of_thread != nullptr && progress_of_thread->is_stopped(); }

} // namespace Bubble_relaxation_2::internal
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_CORE_PROGRESS_H
