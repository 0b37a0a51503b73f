// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// What callbacks and visitors are told of a relaxation at work, and what becomes of the triangulation when they end it.

#include "domains.h"
#include "validation.h"

#include <CGAL/Constrained_triangulation_plus_2.h>
#include <CGAL/Default_relaxation_visitor_2.h>
#include <CGAL/npbs_adapt.h>
#include <CGAL/npbs_place_nodes.h>
#include <CGAL/npbs_relax.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <set>
#include <thread>
#include <utility>
#include <vector>

namespace test_progress {

namespace P = CGAL::parameters;
using CGAL::Bubble_phase;
using domains::CDT;
using domains::Point;

CDT ring_domain() { return domains::make({domains::polygon(0, 0, 1, 40), domains::polygon(0, 0, 0.4, 20)}); }

/// a domain, and a mesh that is to be refined
enum class Start { OUTLINE, MESH };

CDT start_from(Start start)
{
  CDT cdt = ring_domain();
  if (start == Start::MESH)
    CGAL::npbs_relax(cdt, 0.1);
  return cdt;
}

/// notes all that it is told
struct Log : CGAL::Default_relaxation_visitor_2
{
  std::vector<Bubble_phase> phases;
  std::size_t steps = 0, rounds = 0, moves = 0;
  std::function<void(Bubble_phase)> at_phase = [](Bubble_phase) {};
  std::function<void(const CGAL::Bubble_view_2&)> at_step = [](const CGAL::Bubble_view_2&) {};

  void phase_begins(Bubble_phase p)
  {
    phases.push_back(p);
    at_phase(p);
  }
  void step_ends(const CGAL::Bubble_view_2& b)
  {
    ++steps;
    at_step(b);
  }
  void round_ends(const CGAL::Bubble_relaxation_report_2<double>& r)
  {
    EXPECT_EQ(r.number_of_rounds, ++rounds);
    EXPECT_EQ(r.number_of_steps, steps);
    EXPECT_GE(r.number_of_moves, moves);
    moves = r.number_of_moves;
  }
};

const std::vector<Bubble_phase> all_phases{Bubble_phase::READING,   Bubble_phase::PLACEMENT,  Bubble_phase::SIMULATION,
                                           Bubble_phase::TREATMENT, Bubble_phase::EVALUATION, Bubble_phase::WRITING};

class Progress : public testing::TestWithParam<Start>
{};

INSTANTIATE_TEST_SUITE_P(From, Progress, testing::Values(Start::OUTLINE, Start::MESH));

TEST_P(Progress, goes_from_0_to_1_through_all_phases)
{
  CDT cdt = start_from(GetParam());
  Log log;
  std::map<int, int> calls; // by phase
  double last = -1;
  const auto callback = [&](double progress) {
    EXPECT_GE(progress, (std::max)(last, 0.));
    EXPECT_LE(progress, 1);
    last = progress;
    ++calls[static_cast<int>(log.phases.back())];
    return true;
  };
  const auto report = CGAL::npbs_relax(cdt, P::sizing_function(0.05).callback(callback).visitor(std::ref(log)));
  EXPECT_EQ(log.phases, all_phases);
  EXPECT_EQ(calls.size(), all_phases.size());
  EXPECT_EQ(last, 1);
  EXPECT_EQ(log.steps, report.number_of_steps);
  EXPECT_EQ(log.rounds, report.number_of_rounds);
  EXPECT_EQ(log.moves, report.number_of_moves);
  EXPECT_TRUE(report.converged);
}

TEST_P(Progress, looking_on_changes_nothing)
{
  CDT seen = start_from(GetParam()), unseen(seen);
  CGAL::npbs_relax(seen, P::sizing_function(0.05).callback([](double) { return true; }).visitor(Log()));
  CGAL::npbs_relax(unseen, P::sizing_function(0.05));
  EXPECT_EQ(validation::triangles(seen), validation::triangles(unseen));
}

/// stops a relaxation in a phase
CGAL::Bubble_relaxation_report_2<double> stop_in(Bubble_phase phase, bool restores, CDT& cdt)
{
  Log log;
  bool is_stopped = false;
  const auto callback = [&](double) {
    EXPECT_FALSE(is_stopped); // it is not called again
    is_stopped = log.phases.back() == phase;
    return !is_stopped;
  };
  return CGAL::npbs_relax(
    cdt, P::sizing_function(0.05).callback(callback).visitor(std::ref(log)).restore_when_stopped(restores));
}

TEST_P(Progress, may_be_stopped_in_every_phase_without_a_trace)
{
  const CDT start = start_from(GetParam());
  for (std::size_t k = 0; k + 1 < all_phases.size(); ++k) {
    SCOPED_TRACE(k);
    CDT cdt(start);
    const validation::Content<CDT> before(cdt);
    const auto report = stop_in(all_phases[k], true, cdt);
    EXPECT_EQ(report.stop_reason, CGAL::Bubble_stop_reason::STOPPED_BY_CALLBACK);
    EXPECT_FALSE(report.converged);
    EXPECT_EQ(report.number_of_vertices, 0u);
    EXPECT_TRUE(validation::Content<CDT>(cdt) == before);
  }
}

TEST_P(Progress, may_be_stopped_with_a_mesh_once_there_are_bubbles)
{
  const CDT start = start_from(GetParam());
  for (std::size_t k = 0; k + 1 < all_phases.size(); ++k) {
    SCOPED_TRACE(k);
    CDT cdt(start);
    const validation::Snapshot before = validation::snapshot(cdt);
    const auto report = stop_in(all_phases[k], false, cdt);
    EXPECT_EQ(report.converged, all_phases[k] == Bubble_phase::EVALUATION); // then nothing is left out
    EXPECT_EQ(report.stop_reason == CGAL::Bubble_stop_reason::STOPPED_BY_CALLBACK, !report.converged);
    if (all_phases[k] < Bubble_phase::SIMULATION) {
      EXPECT_EQ(validation::triangles(cdt), validation::triangles(start));
    } else {
      validation::expect_valid_mesh(cdt);
      validation::expect_constraints_kept(before, validation::snapshot(cdt));
      EXPECT_EQ(report.number_of_vertices, cdt.number_of_vertices());
      EXPECT_GT(report.number_of_vertices, 900u);
    }
  }
}

TEST_P(Progress, what_callbacks_and_visitors_throw_passes_and_leaves_no_trace)
{
  struct Thrown {};
  const CDT start = start_from(GetParam());
  for (Bubble_phase phase : all_phases) {
    CDT cdt(start);
    Log log;
    log.at_phase = [phase](Bubble_phase p) {
      if (p == phase)
        throw Thrown();
    };
    EXPECT_THROW(CGAL::npbs_relax(cdt, P::sizing_function(0.05).visitor(std::ref(log))), Thrown);
    EXPECT_EQ(validation::triangles(cdt), validation::triangles(start));
    Log quiet_log;
    const auto callback = [&](double) -> bool {
      if (quiet_log.phases.back() == phase)
        throw Thrown();
      return true;
    };
    EXPECT_THROW(CGAL::npbs_relax(cdt, P::sizing_function(0.05).callback(callback).visitor(std::ref(quiet_log))), Thrown);
    EXPECT_EQ(validation::triangles(cdt), validation::triangles(start));
  }
}

TEST_P(Progress, time_goes_by_in_loops_too)
{
  CDT cdt = start_from(GetParam());
  Log log;
  std::map<int, int> calls; // by phase
  const auto slow = [](const Point&) {
    std::this_thread::sleep_for(std::chrono::microseconds(150));
    return 0.07;
  };
  const auto callback = [&](double) {
    ++calls[static_cast<int>(log.phases.back())];
    return true;
  };
  const auto report = CGAL::npbs_relax(cdt, P::sizing_function(slow).callback(callback).visitor(std::ref(log)));
  for (const auto& [phase, seconds] : {std::pair{Bubble_phase::PLACEMENT, report.seconds.placement},
                                       std::pair{Bubble_phase::EVALUATION, report.seconds.evaluation}}) {
    EXPECT_GT(seconds, 0.1);
    EXPECT_GE(calls[static_cast<int>(phase)], static_cast<int>(seconds / 0.25)); // ten times a second, on a machine that does other things too
  }
}

/// in triangulations that get triangles, and those that get vertices
template <class Cdt>
struct Progress_of_writing : testing::Test
{
  using Calls = std::vector<double>;

  Cdt cdt = domain();
  Calls calls; // while it is written

  static Cdt domain() { return domains::make<Cdt>({domains::polygon(0, 0, 1, 40), domains::polygon(0, 0, 0.4, 20)}); }

  /// `obey(calls)`: what the callback returns while it is written. It is slow there, so that each turn of a loop calls it.
  template <class Obey>
  auto relax(const Obey& obey, bool restores)
  {
    calls.clear();
    Log log;
    const auto callback = [&](double progress) {
      if (log.phases.back() != Bubble_phase::WRITING)
        return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(30));
      calls.push_back(progress);
      return obey(calls);
    };
    return CGAL::npbs_relax(
      cdt, P::sizing_function(0.05).callback(callback).visitor(std::ref(log)).restore_when_stopped(restores));
  }
};

using Plus = CGAL::Constrained_triangulation_plus_2<CDT>;
using Written = testing::Types<CDT, Plus>;
TYPED_TEST_SUITE(Progress_of_writing, Written, );

TYPED_TEST(Progress_of_writing, rises_to_1)
{
  const auto report = this->relax([](const auto&) { return true; }, true);
  EXPECT_TRUE(report.converged);
  EXPECT_GE(this->calls.size(), 5u);
  EXPECT_TRUE(std::is_sorted(this->calls.begin(), this->calls.end()));
  EXPECT_GT(std::set<double>(this->calls.begin(), this->calls.end()).size(), 4u);
  EXPECT_EQ(this->calls.back(), 1);
  EXPECT_EQ(std::count(this->calls.begin(), this->calls.end(), 1.), 1);
}

TYPED_TEST(Progress_of_writing, a_stop_or_an_exception_gives_the_content_back)
{
  struct Thrown {};
  TypeParam other = this->domain();
  this->relax([](const auto&) { return true; }, true);
  const std::size_t all = this->calls.size(); // first a copy is made, then it is written
  this->cdt = this->domain();
  const validation::Snapshot before = validation::snapshot(this->cdt);
  for (std::size_t last : {std::size_t(1), std::size_t(4), all / 2, all - 2, all}) {
    SCOPED_TRACE(last);
    const auto report = this->relax([last](const auto& calls) { return calls.size() < last; }, true);
    EXPECT_EQ(report.stop_reason, CGAL::Bubble_stop_reason::STOPPED_BY_CALLBACK);
    EXPECT_EQ(report.number_of_vertices, 0u);
    EXPECT_EQ(this->calls.size(), last);
    EXPECT_TRUE(validation::snapshot(this->cdt) == before);
    EXPECT_TRUE(this->cdt.is_valid());
    const auto throwing = [last](const auto& calls) { return calls.size() < last ? true : throw Thrown(); };
    EXPECT_THROW(this->relax(throwing, false), Thrown);
    EXPECT_EQ(this->calls.size(), last);
    EXPECT_TRUE(validation::snapshot(this->cdt) == before);
  }
  CGAL::npbs_relax(this->cdt, 0.05);
  CGAL::npbs_relax(other, 0.05);
  EXPECT_EQ(validation::triangles(this->cdt), validation::triangles(other));
}

TYPED_TEST(Progress_of_writing, a_stop_without_restoring_leaves_the_whole_mesh)
{
  TypeParam other = this->domain();
  const auto report = this->relax([](const auto& calls) { return calls.size() < 3; }, false);
  EXPECT_TRUE(report.converged);
  EXPECT_EQ(report.stop_reason, CGAL::Bubble_stop_reason::CONVERGED);
  EXPECT_EQ(this->calls.size(), 3u); // it is not called again
  CGAL::npbs_relax(other, 0.05);
  EXPECT_EQ(validation::triangles(this->cdt), validation::triangles(other));
}

TEST(Progress_visitor, sees_all_bubbles_move)
{
  CDT cdt = ring_domain();
  const std::set<CDT::Vertex_handle> pins{cdt.insert(Point(0.7, 0.1))};
  Log log;
  std::vector<std::pair<double, double>> last;
  std::size_t number = 0, number_fixed = 0, number_moved = 0;
  log.at_step = [&](const CGAL::Bubble_view_2& b) {
    number = number_fixed = 0;
    ASSERT_GE(b.size(), last.size());
    for (std::size_t i = 0; i < b.size(); ++i) {
      if (b.is_deleted(i)) {
        if (i == last.size())
          last.push_back({0, 0});
        continue;
      }
      ++number;
      number_fixed += b.is_fixed(i);
      EXPECT_EQ(b.diameter(i), 0.06);
      EXPECT_LE(std::hypot(b.x(i), b.y(i)), 1 + 1e-12);
      const std::pair<double, double> p{b.x(i), b.y(i)};
      if (i == last.size())
        last.push_back(p);
      EXPECT_TRUE(p == last[i] || !b.is_fixed(i));
      number_moved += p != last[i];
      last[i] = p;
    }
  };
  const auto report = CGAL::npbs_relax(
    cdt, CGAL::Bubble_relaxation_parameters::sizing_function(0.06).limit_by_outline(false).defect_treatment(false)
           .vertex_is_constrained_map(CGAL::make_boolean_property_map(pins)).visitor(std::ref(log)));
  EXPECT_EQ(number_fixed, 61u); // 60 corners and a pin
  EXPECT_EQ(number, report.number_of_vertices);
  EXPECT_GT(number_moved, report.number_of_moves / 2);
}

TEST(Progress_visitor, may_be_in_another_relaxation)
{
  CDT outer = ring_domain(), alone = ring_domain();
  int number_of_inner = 0;
  const auto callback = [&number_of_inner](double) {
    if (number_of_inner < 3) {
      CDT inner = ring_domain();
      bool has_been_called = false;
      CGAL::npbs_relax(inner, P::sizing_function(0.2).callback([&](double) { return has_been_called = true; }));
      EXPECT_TRUE(has_been_called);
      ++number_of_inner;
    }
    return true;
  };
  CGAL::npbs_relax(outer, P::sizing_function(0.1).callback(callback));
  CGAL::npbs_relax(alone, 0.1);
  EXPECT_EQ(number_of_inner, 3);
  EXPECT_EQ(validation::triangles(outer), validation::triangles(alone));
}

TEST(Progress_of_nodes, phases_and_stops_are_the_same)
{
  const CDT cdt = ring_domain();
  Log log;
  const auto nodes = CGAL::npbs_place_nodes(cdt, P::sizing_function(0.1).visitor(std::ref(log)));
  EXPECT_EQ(log.phases, (std::vector<Bubble_phase>(all_phases.begin(), all_phases.begin() + 4)));
  const auto stopped = CGAL::npbs_place_nodes(cdt, P::sizing_function(0.1).callback([](double) { return false; }));
  EXPECT_EQ(stopped.report.stop_reason, CGAL::Bubble_stop_reason::STOPPED_BY_CALLBACK);
  EXPECT_EQ(stopped.size(), 0u);
  Log of_third;
  const auto untreated = CGAL::npbs_place_nodes(
    cdt, P::sizing_function(0.1).visitor(std::ref(of_third)).callback([&of_third](double) {
      return of_third.phases.back() != Bubble_phase::TREATMENT;
    }));
  EXPECT_EQ(untreated.report.stop_reason, CGAL::Bubble_stop_reason::STOPPED_BY_CALLBACK);
  EXPECT_GT(untreated.size(), 100u);
}

TEST(Progress_of_adaptation, may_be_stopped_without_a_trace)
{
  CDT cdt = start_from(Start::MESH);
  const CDT start(cdt);
  const auto d = [](const Point& p) { return p.x() > 0.5 ? 0.03 : 0.1; };
  for (double last : {0., 0.3, 0.8}) {
    const auto report = CGAL::npbs_adapt(
      cdt, P::sizing_function(d).callback([last](double p) { return p <= last; }).restore_when_stopped(true));
    EXPECT_EQ(report.stop_reason, CGAL::Bubble_stop_reason::STOPPED_BY_CALLBACK);
    EXPECT_EQ(report.number_of_vertices + report.number_of_triangles, 0u); // a mesh that is not there is not told of
    EXPECT_EQ(report.quality.number_of_triangles(), 0u);
    EXPECT_EQ(validation::triangles(cdt), validation::triangles(start));
  }
}

TEST(Progress_of_adaptation, a_search_for_misfits_may_be_stopped)
{
  const CDT cdt = start_from(Start::MESH);
  const auto slow = [](const Point& p) {
    std::this_thread::sleep_for(std::chrono::microseconds(150));
    return p.x() > 0.5 ? 0.03 : 0.1;
  };
  int calls = 0;
  const auto search = [&](int last) {
    calls = 0;
    return CGAL::npbs_misfit_faces(cdt, P::sizing_function(slow).callback([&calls, last](double progress) {
      EXPECT_LE(progress, 0.05);
      return ++calls != last;
    }));
  };
  EXPECT_FALSE(search(0).empty());
  EXPECT_GT(calls, 2); // also within the sweep over the faces
  for (int last : {1, 2}) {
    EXPECT_TRUE(search(last).empty());
    EXPECT_EQ(calls, last);
  }
}

/// counts how often d is asked for between two calls of the callback; it takes a millisecond each time
TEST(Progress_of_adaptation, callbacks_do_not_wait_for_many_slow_sizes)
{
  std::size_t asked = 0, most = 0;
  const auto callback = [&](double) {
    most = (std::max)(most, asked);
    asked = 0;
    return true;
  };
  const auto d = [&](const Point& p) {
    ++asked;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return p.x() < 0 ? 0.2 : 0.1;
  };
  CDT cdt = domains::mesh({domains::polygon(0, 0, 1, 20)}, 0.2);
  CGAL::npbs_misfit_faces(cdt, P::sizing_function(d).callback(callback));
  EXPECT_LT(most, 40u);
}

TEST(Progress_of_adaptation, may_be_stopped_while_a_domain_without_marks_is_found)
{
  using Plain = CGAL::Constrained_Delaunay_triangulation_2<domains::K>;
  Plain cdt = domains::make<Plain>({domains::square(0, 0, 1)});
  std::vector<Point> points;
  constexpr int side = 350; // so many that it takes more than a fortieth of a second
  for (int i = 1; i < side; ++i)
    for (int j = 1; j < side; ++j)
      points.push_back(Point((i + 0.3 * (j % 2)) / side, double(j) / side));
  cdt.insert(points.begin(), points.end());
  const std::size_t before = cdt.number_of_vertices();
  int calls = 0;
  const auto report =
    CGAL::npbs_adapt(cdt, P::sizing_function(0.1).callback([&calls](double) { return ++calls < 2; }));
  EXPECT_EQ(calls, 2);
  EXPECT_EQ(report.stop_reason, CGAL::Bubble_stop_reason::STOPPED_BY_CALLBACK);
  EXPECT_EQ(report.number_of_vertices, 0u);
  EXPECT_EQ(cdt.number_of_vertices(), before);
}

} // namespace test_progress
