// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// the paper's protocol: on one rank it changes nothing, on several it loses no bubble and little quality

#include "bubbles.h"

#include <CGAL/Bubble_relaxation_2/internal/distributed/mesh/distributed_triangulate.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/quality/evaluate_distributed.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/simulation/simulate_distributed.h>

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

namespace {

using namespace bubbles;
using Report = CGAL::Bubble_relaxation_report_2<double>;
namespace P = CGAL::parameters;

struct Ranks
{
  Communicator comm{MPI_COMM_WORLD};
  Agreement agreement{comm};
  Sparse_exchange exchange{comm};
};

struct Result
{
  Placed_part_2 part;
  Report report;
  Traffic_2 traffic;
  double mean_quality; // of the mesh of all ranks
};

template <class NamedParameters>
Result simulate(Ranks& ranks, const paper::Domain& domain, const NamedParameters& parameters)
{
  const auto np = parameters.sizing_function(domain.d);
  const Case c = read(domain);
  const Domain_marks_2<paper::CDT> marks(c.cdt, np);
  const Relaxation_options options = read_options(np);
  Result result{{{}, Hilbert_partition_2(hilbert_curve(c.domain()), {})}, {}, {}, 0};
  with_limited_sizing_field(c.cdt, np, marks, *c.reading, options, [&](const auto& sizing, const auto&) {
    Progress progress(options.callback, options.number_of_rounds);
    result.part = simulate_distributed(ranks.comm, ranks.exchange, ranks.agreement, c.cdt, *c.reading, sizing,
                                       options, progress, result.report, {}, &result.traffic);
  });
  const Distributed_mesh_2 mesh = distributed_triangulate(c.domain(), result.part.bubbles, result.part.partition,
                                                          ranks.comm, ranks.agreement, ranks.exchange);
  result.mean_quality = distributed_quality(mesh, static_cast<const Sizing_field_ref_2*>(nullptr), ranks.comm,
                                            ranks.agreement).mean_quality();
  return result;
}

std::int64_t count(const Ranks& ranks, const Result& result)
{
  return ranks.comm.sum(static_cast<std::int64_t>(result.part.bubbles.size()));
}

void expect_equal(const Result& a, const Result& b)
{
  ASSERT_EQ(a.part.bubbles.size(), b.part.bubbles.size());
  const auto of = [](const Result& r, std::size_t i) {
    return record(r.part.bubbles.bubbles, i, r.part.bubbles.numbers[i]);
  };
  for (std::size_t i = 0; i < a.part.bubbles.size(); ++i) {
    const Bubble_record_2 r = of(a, i), s = of(b, i);
    ASSERT_EQ(r.x, s.x);
    ASSERT_EQ(r.y, s.y);
    ASSERT_EQ(r.vx, s.vx);
    ASSERT_EQ(r.vy, s.vy);
    ASSERT_EQ(r.d, s.d);
    ASSERT_EQ(r.number, s.number);
  }
  EXPECT_EQ(a.report.number_of_rounds, b.report.number_of_rounds);
  EXPECT_EQ(a.report.number_of_steps, b.report.number_of_steps);
  EXPECT_EQ(a.report.number_of_moves, b.report.number_of_moves);
  EXPECT_EQ(a.report.number_of_renewals, b.report.number_of_renewals);
  EXPECT_EQ(a.report.stop_reason, b.report.stop_reason);
}

TEST(Exchange_interval, changes_nothing_on_one_rank_and_little_on_several)
{
  Ranks ranks;
  if (ranks.comm.size() > 4)
    GTEST_SKIP() << "takes long with more ranks than cores";
  const paper::Domain d = paper::all_domains(1.5)[3];
  const auto np = P::number_of_rounds(5);
  const Result exact = simulate(ranks, d, np.exchange_interval(0));
  EXPECT_EQ(exact.traffic.waits, 0);
  EXPECT_EQ(exact.report.stop_reason, simulate(ranks, d, np).report.stop_reason);
  EXPECT_GT(exact.mean_quality, 0.95);
  for (const int steps : {1, 10}) {
    SCOPED_TRACE(steps);
    const Result result = simulate(ranks, d, np.exchange_interval(steps));
    EXPECT_NEAR(result.mean_quality, exact.mean_quality, 0.005);
    EXPECT_EQ(result.traffic.steps, static_cast<std::int64_t>(result.report.number_of_steps));
    if (ranks.comm.size() == 1) {
      expect_equal(result, exact);
      EXPECT_EQ(result.traffic.messages, 0);
    } else
      EXPECT_GT(ranks.comm.sum(result.traffic.messages), 0);
  }
}

TEST(Exchange_interval, of_the_paper)
{
  Ranks ranks;
  if (ranks.comm.size() > 4)
    GTEST_SKIP() << "takes long with more ranks than cores";
  const paper::Domain d = paper::all_domains(1.5)[3];
  const auto np = CGAL::npbs_paper_parameters().number_of_rounds(2).number_of_iterations(60);
  const Result exact = simulate(ranks, d, np), result = simulate(ranks, d, np.exchange_interval(25));
  EXPECT_NEAR(result.mean_quality, exact.mean_quality, 0.005);
  if (ranks.comm.size() == 1)
    expect_equal(result, exact);
}

TEST(Exchange_interval, conserves_bubbles)
{
  Ranks ranks;
  const paper::Domain d = paper::all_domains(1.5)[4];
  // many steps between exchanges, and bubbles that rush: some have to wait
  const auto np =
    P::population_control(CGAL::Bubble_population::NONE).number_of_rounds(2).number_of_iterations(20).damping(0.1);
  const Result exact = simulate(ranks, d, np), result = simulate(ranks, d, np.exchange_interval(7));
  const std::int64_t n = count(ranks, result);
  EXPECT_EQ(n, count(ranks, exact));
  EXPECT_EQ(n, static_cast<std::int64_t>(result.report.number_of_initial_bubbles));
  std::int64_t sum = 0;
  for (std::int64_t number : result.part.bubbles.numbers)
    sum += number;
  EXPECT_EQ(ranks.comm.sum(sum), n * (n - 1) / 2);
  EXPECT_EQ(ranks.comm.sum(result.traffic.waits) > 0, ranks.comm.size() > 1);
}

TEST(Exchange_interval, says_less_the_longer_it_is)
{
  Ranks ranks;
  const paper::Domain d = paper::all_domains(1)[8]; // the ring, where d varies most
  const auto np = P::number_of_rounds(1).number_of_iterations(8).displacement_tolerance(0).population_control(
    CGAL::Bubble_population::NONE);
  const Result exact = simulate(ranks, d, np), often = simulate(ranks, d, np.exchange_interval(2)),
               rarely = simulate(ranks, d, np.exchange_interval(8));
  const auto all = [&ranks](std::int64_t n) { return ranks.comm.sum(n); };
  if (ranks.comm.size() == 1) {
    EXPECT_EQ(exact.traffic.ghosts + often.traffic.ghosts + often.traffic.neighbors + often.traffic.bytes, 0);
    return;
  }
  EXPECT_EQ(exact.traffic.steps, 8);
  EXPECT_GE(exact.traffic.neighbors, 8);
  EXPECT_GT(all(exact.traffic.messages), all(often.traffic.messages));
  EXPECT_GT(all(often.traffic.messages), all(rarely.traffic.messages));
  EXPECT_GT(all(often.traffic.bytes), all(rarely.traffic.bytes));
  EXPECT_GT(all(rarely.traffic.ghosts), 0);
}

} // namespace
