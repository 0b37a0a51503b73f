// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// the paper's protocol: on one rank it changes nothing, on several it loses no bubble and little quality

#include "bubbles.h"
#include "relaxed_points.h"
#include "same_exception.h"

#include <CGAL/Bubble_relaxation_2/internal/distributed/simulation/simulate_distributed.h>
#include <CGAL/Distributed/npbs_relax.h>

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

namespace test_distributed_exchange_interval {

using relaxed_points::All_parts;
using relaxed_points::Part;
namespace P = CGAL::parameters;

/// what all ranks relax together, and what they were told
struct Result
{
  All_parts all;
  CGAL::Bubble_relaxation_report_2<double> report;
};

template <class NamedParameters>
Result relax(const paper::Domain& domain, const NamedParameters& parameters)
{
  Part part;
  part.relaxation = CGAL::Distributed::npbs_relax(part.points, paper::triangulate(domain), MPI_COMM_WORLD,
                                                  parameters.sizing_function(domain.d));
  return Result{gather(part), part.relaxation.report};
}

/// to the last bit
void expect_equal(const Result& a, const Result& b)
{
  ASSERT_EQ(a.all.nodes.size(), b.all.nodes.size());
  for (std::size_t i = 0; i < a.all.nodes.size(); ++i) {
    ASSERT_EQ(a.all.nodes[i].place, b.all.nodes[i].place);
    ASSERT_EQ(a.all.nodes[i].size, b.all.nodes[i].size);
    ASSERT_EQ(a.all.nodes[i].id, b.all.nodes[i].id);
    ASSERT_EQ(a.all.nodes[i].dimension, b.all.nodes[i].dimension);
  }
  EXPECT_EQ(a.all.neighbors, b.all.neighbors);
  EXPECT_EQ(a.report.number_of_rounds, b.report.number_of_rounds);
  EXPECT_EQ(a.report.number_of_steps, b.report.number_of_steps);
  EXPECT_EQ(a.report.number_of_moves, b.report.number_of_moves);
  EXPECT_EQ(a.report.number_of_renewals, b.report.number_of_renewals);
  EXPECT_EQ(a.report.stop_reason, b.report.stop_reason);
  EXPECT_EQ(a.report.quality.mean_quality(), b.report.quality.mean_quality());
}

/// of as many nodes, about: in other places if there are several ranks, and as good
void expect_alike(const Result& result, const Result& exact)
{
  if (distributed::size() == 1) {
    expect_equal(result, exact);
    return;
  }
  EXPECT_NEAR(double(result.all.nodes.size()), double(exact.all.nodes.size()), 0.02 * double(exact.all.nodes.size()));
  EXPECT_NEAR(result.report.quality.mean_quality(), exact.report.quality.mean_quality(), 0.003);
  const auto places = [](const Result& r) {
    std::vector<relaxed_points::Coordinates> p;
    for (const auto& node : r.all.nodes)
      p.push_back(node.place);
    return p;
  };
  EXPECT_NE(places(result), places(exact)) << "the interval was not heeded";
}

TEST(Exchange_interval, changes_nothing_on_one_rank_and_little_on_several)
{
  const paper::Domain d = paper::all_domains(1.5)[3];
  const auto np = P::number_of_rounds(5).defect_treatment(false);
  const Result exact = relax(d, np.exchange_interval(0));
  expect_equal(exact, relax(d, np)); // the default
  EXPECT_GE(exact.report.quality.mean_quality(), 0.97);
  for (const int steps : {1, 10}) {
    SCOPED_TRACE(steps);
    expect_alike(relax(d, np.exchange_interval(steps)), exact);
  }
}

TEST(Exchange_interval, of_the_paper)
{
  const paper::Domain d = paper::all_domains(1.5)[3];
  const auto np = CGAL::npbs_paper_parameters().number_of_rounds(2).number_of_iterations(60);
  expect_alike(relax(d, np.exchange_interval(25)), relax(d, np));
}

TEST(Exchange_interval, conserves_bubbles)
{
  const paper::Domain d = paper::all_domains(1.5)[4];
  // many steps between exchanges, and bubbles that rush: some have to wait
  const auto np = P::population_control(CGAL::Bubble_population::NONE).number_of_rounds(2).number_of_iterations(20)
                    .damping(0.1).defect_treatment(false);
  const Result exact = relax(d, np), result = relax(d, np.exchange_interval(7));
  EXPECT_EQ(result.all.nodes.size(), exact.all.nodes.size());
  EXPECT_EQ(result.all.nodes.size(), result.report.number_of_initial_bubbles);
  for (std::size_t i = 0; i < result.all.nodes.size(); ++i)
    EXPECT_EQ(result.all.nodes[i].id, static_cast<std::int64_t>(i)); // each once
}

// What is below cannot be seen from outside: how much is said.

using namespace bubbles;

template <class NamedParameters>
Traffic_2 traffic(Communicator& ranks, const paper::Domain& domain, const NamedParameters& parameters)
{
  const auto np = parameters.sizing_function(domain.d);
  Case c{paper::triangulate(domain), nullptr, {}};
  c.read(np);
  const Problem_2 problem = c.input->problem();
  Report report;
  Traffic_2 result;
  simulate_distributed(ranks, problem, report, {}, &result);
  EXPECT_EQ(result.steps, static_cast<std::int64_t>(report.number_of_steps));
  return result;
}

TEST(Exchange_interval, lets_bubbles_wait)
{
  Communicator ranks{MPI_COMM_WORLD};
  const auto np = P::population_control(CGAL::Bubble_population::NONE).number_of_rounds(2).number_of_iterations(20)
                    .damping(0.1);
  const paper::Domain d = paper::all_domains(1.5)[4];
  EXPECT_EQ(ranks.sum(traffic(ranks, d, np).waits), 0);
  EXPECT_EQ(ranks.sum(traffic(ranks, d, np.exchange_interval(7)).waits) > 0, ranks.size() > 1);
}

TEST(Exchange_interval, says_less_the_longer_it_is)
{
  Communicator ranks{MPI_COMM_WORLD};
  const paper::Domain d = paper::all_domains(1)[8]; // the ring, where d varies most
  const auto np = P::number_of_rounds(1).number_of_iterations(8).displacement_tolerance(0).population_control(
    CGAL::Bubble_population::NONE);
  const Traffic_2 exact = traffic(ranks, d, np), often = traffic(ranks, d, np.exchange_interval(2)),
                  rarely = traffic(ranks, d, np.exchange_interval(8));
  const auto all = [&ranks](std::int64_t n) { return ranks.sum(n); };
  if (ranks.size() == 1) {
    EXPECT_EQ(exact.ghosts + often.ghosts + often.neighbors + often.bytes, 0);
    return;
  }
  EXPECT_EQ(exact.steps, 8);
  EXPECT_GE(exact.neighbors, 8);
  EXPECT_GT(all(exact.messages), all(often.messages));
  EXPECT_GT(all(often.messages), all(rarely.messages));
  EXPECT_GT(all(often.bytes), all(rarely.bytes));
  EXPECT_GT(all(rarely.ghosts), 0);
}

} // namespace test_distributed_exchange_interval
