// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// the callback is called while bubbles go from rank to rank and while they are written, and may stop or throw there

#include "relaxed_points.h"
#include "same_exception.h"

#include <CGAL/Bubble_relaxation_2/internal/distributed/engine/distributed_engine.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/parts/distribute_bubbles.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/writing/relax_by_all.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <ctime>
#include <functional>
#include <stdexcept>
#include <utility>
#include <vector>

namespace test_distributed_progress {

using namespace CGAL::Bubble_relaxation_2::internal;
using distributed::expect_same_exception;
using distributed::last_rank;
using distributed::rank;
using distributed::size;
using relaxed_points::Points;
namespace parameters = CGAL::Bubble_relaxation_parameters;

bool is_last() { return rank() == last_rank(); }

/// What a callback may do while ranks work together, and when it was called: in the processor's time, since other
/// processes are in the way.
class Heard
{
public:
  explicit Heard(Communicator& comm, std::function<bool()> answer = [] { return true; })
    : m_progress(agreed_callback(
        [this, answer](double) {
          note();
          ++m_calls;
          return answer();
        },
        comm))
  {
    m_progress.remember_stop();
  }

  /// \returns the longest time without a call, as a share of the time of all
  template <class Work>
  double longest_rest(const Work& work)
  {
    const Progress_scope scope(m_progress);
    m_longest = 0;
    const double start = m_last = now();
    work();
    note();
    return m_longest / (m_last - start);
  }

  int calls() const { return m_calls; }

private:
  static double now() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

  void note()
  {
    const double time = now();
    m_longest = (std::max)(m_longest, time - m_last);
    m_last = time;
  }

  Progress m_progress;
  int m_calls = 0;
  double m_last = 0, m_longest = 0;
};

constexpr int side = 700;

CGAL::Bbox_2 box() { return CGAL::Bbox_2(0, 0, side, side); }

/// bubbles of each rank in a square, row by row, which are all over the parts of others; with numbers or without
Bubbles_2 rows(bool with_numbers)
{
  Bubbles_2 result;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const std::int64_t number = (std::int64_t(y) * side + x) * size() + rank();
      result.add(Point(x + (0.5 + rank()) / size(), y + 0.5), 1. / size(), Bubbles_2::FACE, 0);
      result.id.push_back(with_numbers ? number : no_index);
    }
  return result;
}

std::int64_t number_of_all() { return std::int64_t(side) * side * size(); }

/// each of the stages that are only there on ranks
template <class Use>
void for_each_stage(Communicator& comm, const Use& use)
{
  const Hilbert_curve_2 curve(box());
  const std::vector<Bubble_record_2> records = [] {
    std::vector<Bubble_record_2> result;
    const Bubbles_2 bubbles = rows(false);
    for (std::size_t i = 0; i < bubbles.size(); ++i)
      result.push_back(record(bubbles, i));
    return result;
  }();
  Placed_part_2 part{{}, Hilbert_partition_2(curve, {})};
  use("send_home_evenly", [&] { part = send_home_evenly(comm, curve, records); });
  EXPECT_EQ(comm.sum(std::int64_t(part.bubbles.size())), number_of_all());
  const Bubbles_2 numbered = rows(true);
  use("send_home", [&] { part.bubbles = send_home(comm, part.partition, numbered); });
  EXPECT_EQ(comm.sum(std::int64_t(part.bubbles.size())), number_of_all());
  constexpr double radius = 2.2;
  Bubbles_2 known;
  use("with_neighbors", [&] { known = with_neighbors(part.bubbles, part.partition, radius, comm); });
  CGAL::Distributed::Relaxation_2<paper::K> relaxation;
  use("write_neighbors", [&] { write_neighbors(known, radius, relaxation); });
  EXPECT_EQ(relaxation.neighbor_offsets.size(), part.bubbles.size() + 1);
}

TEST(Distributed_progress, is_told_by_all_stages)
{
  Communicator comm(MPI_COMM_WORLD);
  for_each_stage(comm, [&](const char* name, const auto& stage) {
    SCOPED_TRACE(name);
    Heard heard(comm);
    const double rest = heard.longest_rest(stage);
    EXPECT_GT(heard.calls(), 0);
    if (size() == 1) { // others are waited for
      EXPECT_LT(rest, 0.4);
    }
  });
}

TEST(Distributed_progress, all_ranks_throw_what_a_callback_throws_in_between)
{
  Communicator comm(MPI_COMM_WORLD);
  for_each_stage(comm, [&](const char* name, const auto& stage) {
    SCOPED_TRACE(name);
    Heard heard(comm, []() -> bool {
      if (is_last())
        throw std::domain_error("no more");
      return true;
    });
    heard.longest_rest(stage);
    expect_same_exception<std::domain_error>("no more", [&] { comm.agree(); });
  });
}

// loops of some thousand bubbles call it now and then, so that it stops here and there
TEST(Distributed_progress, a_callback_of_one_rank_stops_all_wherever_it_is_called)
{
  const paper::CDT cdt = paper::triangulate(paper::square_with_hole(1));
  const auto np = parameters::sizing_function(0.01).number_of_rounds(1).number_of_iterations(2);
  int calls = 0, last = 0;
  const auto callback = [&](double) { return ++calls != last || !is_last(); };
  const auto run = [&] {
    Points points;
    calls = 0;
    const auto relaxation = CGAL::Distributed::npbs_relax(points, cdt, MPI_COMM_WORLD, np.callback(callback));
    const bool is_stopped = relaxation.report.stop_reason == CGAL::Bubble_stop_reason::STOPPED_BY_CALLBACK;
    const Communicator comm(MPI_COMM_WORLD);
    EXPECT_EQ(comm.any(is_stopped), is_stopped);
    EXPECT_EQ(points.is_empty(), is_stopped);
    return is_stopped;
  };
  EXPECT_FALSE(run());
  int all = calls; // of the last rank
  MPI_Bcast(&all, 1, MPI_INT, last_rank(), MPI_COMM_WORLD);
  for (int part = 0; part < 6; ++part) {
    last = 1 + all * part / 8;
    SCOPED_TRACE(last);
    const bool is_stopped = run();
    EXPECT_TRUE(is_stopped || part > 3); // the last part of all is written anyhow
  }
}

} // namespace test_distributed_progress
