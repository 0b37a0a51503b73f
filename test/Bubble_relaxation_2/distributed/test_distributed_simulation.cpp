// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// what ranks place and simulate together is what one places and simulates

#include "bubbles.h"
#include "equal_bubbles.h"

#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/gather_records.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/simulation/simulate_distributed.h>

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>

namespace {

using namespace bubbles;
using Report = CGAL::Bubble_relaxation_report_2<double>;

struct Ranks
{
  Communicator comm{MPI_COMM_WORLD};
  Agreement agreement{comm};
  Sparse_exchange exchange{comm};
};

/// what comes of a domain on one rank, and on all
struct Result
{
  Bubbles_2 whole;
  Placed_part_2 part;
  Report of_whole, of_part;
};

/// `size`: d; `np`: all else. The sizes of the outline count as well, as they do by default.
template <class Size, class NamedParameters>
Result simulate(Ranks& ranks, const paper::Domain& domain, const Size& size, const NamedParameters& parameters)
{
  const auto np = parameters.sizing_function(size);
  const Case c = read(domain);
  const Domain_marks_2<paper::CDT> marks(c.cdt, np);
  const Relaxation_options options = read_options(np);
  Result result{{}, {{}, Hilbert_partition_2(hilbert_curve(c.domain()), {})}, {}, {}};
  with_limited_sizing_field(c.cdt, np, marks, *c.reading, options, [&](const auto& sizing, const auto&) {
    Progress first(options.callback, options.number_of_rounds), second(options.callback, options.number_of_rounds);
    result.whole = simulate_bubbles<CGAL::Sequential_tag>(c.cdt, *c.reading, sizing, options, first, result.of_whole);
    result.part = simulate_distributed(ranks.comm, ranks.exchange, ranks.agreement, c.cdt, *c.reading, sizing,
                                       options, second, result.of_part);
  });
  return result;
}

void expect_parts_make_the_whole(Ranks& ranks, const Result& result)
{
  const Numbered_bubbles_2& part = result.part.bubbles;
  for (std::size_t i = 0; i < part.size(); ++i) {
    const std::size_t number = static_cast<std::size_t>(part.numbers[i]);
    ASSERT_LT(number, result.whole.size());
    EXPECT_TRUE(i == 0 || part.numbers[i] > part.numbers[i - 1]);
    EXPECT_EQ(result.part.partition.owner(part.bubbles.x[i], part.bubbles.y[i]), ranks.comm.rank());
    expect_equal(record(part.bubbles, i, 0), record(result.whole, number, 0));
    if (testing::Test::HasFailure())
      return; // one is enough
  }
  EXPECT_EQ(ranks.comm.sum(static_cast<std::int64_t>(part.size())), static_cast<std::int64_t>(result.whole.size()));
  EXPECT_EQ(result.of_part.number_of_steps, result.of_whole.number_of_steps);
  EXPECT_EQ(result.of_part.number_of_rounds, result.of_whole.number_of_rounds);
  EXPECT_EQ(result.of_part.stop_reason, result.of_whole.stop_reason);
  EXPECT_EQ(result.of_part.number_of_initial_bubbles, result.of_whole.number_of_initial_bubbles);
}

/// so that there are enough bubbles to grow in parts
paper::Domain domain(int k) { return paper::all_domains(k == 5 ? 0.6 : 0.5)[k]; }

class Paper_domain : public testing::TestWithParam<int>
{};

TEST_P(Paper_domain, is_filled_as_by_one_rank)
{
  Ranks ranks;
  const paper::Domain d = domain(GetParam());
  SCOPED_TRACE(d.name);
  const Result result = simulate(ranks, d, d.d, CGAL::parameters::mass(1.));
  EXPECT_GT(result.whole.size(), 1600u);
  EXPECT_GT(result.of_whole.number_of_rounds, 1u);
  expect_parts_make_the_whole(ranks, result);
}

INSTANTIATE_TEST_SUITE_P(Some, Paper_domain, testing::Values(1, 3, 4, 7));

TEST(Distributed_simulation, d_may_jump)
{
  Ranks ranks;
  const paper::Domain d = domain(5);
  const auto jump = [&d](const Point& p) { return d.d(p) * (std::sin(7 * p.x() + 3 * p.y()) > 0.3 ? 3. : 1.); };
  expect_parts_make_the_whole(ranks, simulate(ranks, d, jump, CGAL::parameters::mass(1.)));
}

TEST(Distributed_simulation, few_bubbles)
{
  Ranks ranks;
  const paper::Domain d = paper::all_domains(6)[0];
  const Result result = simulate(ranks, d, d.d, CGAL::parameters::mass(1.));
  EXPECT_LT(result.whole.size(), 200u);
  expect_parts_make_the_whole(ranks, result);
}

/// on all ranks only
template <class NamedParameters>
Report simulate_together(Ranks& ranks, const paper::Domain& domain, const NamedParameters& np)
{
  const Case c = read(domain);
  const Relaxation_options options = read_options(np);
  const Domain_marks_2<paper::CDT> marks(c.cdt, np);
  Report report;
  with_limited_sizing_field(c.cdt, np, marks, *c.reading, options, [&](const auto& sizing, const auto&) {
    Progress progress(options.callback, options.number_of_rounds);
    simulate_distributed(ranks.comm, ranks.exchange, ranks.agreement, c.cdt, *c.reading, sizing, options, progress,
                         report);
  });
  return report;
}

TEST(Distributed_simulation, stops_together)
{
  Ranks ranks;
  const paper::Domain d = domain(1);
  const bool is_last = ranks.comm.rank() == ranks.comm.size() - 1;
  int calls = 0;
  const auto callback = [&calls, is_last](double) { return !is_last || ++calls < 20; };
  const Report report = simulate_together(ranks, d, CGAL::parameters::sizing_function(d.d).callback(callback));
  EXPECT_EQ(report.stop_reason, CGAL::Bubble_stop_reason::STOPPED_BY_CALLBACK);
  EXPECT_EQ(report.number_of_steps, 19u);
}

TEST(Distributed_simulation, what_d_throws_on_one_rank_is_thrown_on_all)
{
  Ranks ranks;
  const paper::Domain d = domain(1);
  const bool is_last = ranks.comm.rank() == ranks.comm.size() - 1;
  // while bubbles are put on the outline, while they fill the faces, and while they move
  for (const int last : {3, 4000, 9000}) {
    int calls = 0;
    bool is_simulating = false;
    const auto size = [&](const Point& p) {
      if (is_last && is_simulating && ++calls > last)
        throw std::domain_error("no d after so many calls");
      return d.d(p);
    };
    const Case c = read(d);
    const auto np = CGAL::parameters::sizing_function(size);
    const Relaxation_options options = read_options(np);
    const Domain_marks_2<paper::CDT> marks(c.cdt, np);
    Report report;
    with_limited_sizing_field(c.cdt, np, marks, *c.reading, options, [&](const auto& sizing, const auto&) {
      Progress progress(options.callback, options.number_of_rounds);
      is_simulating = true;
      try {
        simulate_distributed(ranks.comm, ranks.exchange, ranks.agreement, c.cdt, *c.reading, sizing, options,
                             progress, report);
        ADD_FAILURE() << "nothing was thrown";
      } catch (const std::domain_error& e) {
        EXPECT_EQ(std::string(e.what()), "no d after so many calls");
      }
      is_simulating = false;
    });
  }
}

} // namespace
