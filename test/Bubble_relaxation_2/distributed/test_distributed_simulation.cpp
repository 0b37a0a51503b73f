// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// what ranks place and simulate together is what one places and simulates, before any treatment of defects

#include "relaxed_points.h"
#include "same_exception.h"

#include <CGAL/npbs_place_nodes.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>

namespace test_distributed_simulation {

using namespace relaxed_points;
using distributed::last_rank;
using distributed::rank;
namespace P = CGAL::parameters;
using Nodes = CGAL::Node_set_2<Point>;

/// `size`: d. The sizes of the outline count as well, as they do by default.
template <class Size>
Nodes expect_same_as_one_rank(const paper::Domain& domain, const Size& size)
{
  const auto np = P::defect_treatment(false).sizing_function(size);
  const paper::CDT cdt = paper::triangulate(domain);
  Part part;
  part.relaxation = CGAL::Distributed::npbs_relax(part.points, cdt, MPI_COMM_WORLD, np);
  const All_parts all = gather(part);
  const Nodes whole = CGAL::npbs_place_nodes(cdt, np);
  EXPECT_EQ(all.nodes.size(), whole.size());
  for (std::size_t n = 0; n < (std::min)(whole.size(), all.nodes.size()) && !testing::Test::HasFailure(); ++n) {
    const Node& node = all.nodes[n];
    EXPECT_EQ(node.id, static_cast<std::int64_t>(n));
    EXPECT_EQ(Point(node.place[0], node.place[1]), whole.points[n]);
    EXPECT_EQ(node.size, whole.sizes[n]);
    EXPECT_EQ(node.dimension, int(whole.dimensions[n]));
  }
  const auto &report = part.relaxation.report, &expected = whole.report;
  EXPECT_EQ(report.number_of_initial_bubbles, expected.number_of_initial_bubbles);
  EXPECT_EQ(report.number_of_rounds, expected.number_of_rounds);
  EXPECT_EQ(report.number_of_steps, expected.number_of_steps);
  EXPECT_EQ(report.number_of_moves, expected.number_of_moves);
  EXPECT_EQ(report.number_of_insertions, expected.number_of_insertions);
  EXPECT_EQ(report.number_of_deletions, expected.number_of_deletions);
  EXPECT_EQ(report.number_of_returns, expected.number_of_returns);
  EXPECT_EQ(report.stop_reason, expected.stop_reason);
  EXPECT_EQ(report.number_of_treated_vertices, 0u);
  return whole;
}

/// so that there are enough bubbles to grow in parts
paper::Domain domain(int k) { return paper::all_domains(k == 5 ? 0.6 : 0.5)[k]; }

class Paper_domain : public testing::TestWithParam<int>
{};

TEST_P(Paper_domain, is_filled_as_by_one_rank)
{
  const paper::Domain d = domain(GetParam());
  SCOPED_TRACE(d.name);
  const Nodes whole = expect_same_as_one_rank(d, d.d);
  EXPECT_GT(whole.size(), 1600u);
  EXPECT_GT(whole.report.number_of_rounds, 1u);
}

INSTANTIATE_TEST_SUITE_P(Some, Paper_domain, testing::Values(1, 3, 4, 7));

TEST(Distributed_simulation, d_may_jump)
{
  const paper::Domain d = domain(5);
  expect_same_as_one_rank(
    d, [&d](const Point& p) { return d.d(p) * (std::sin(7 * p.x() + 3 * p.y()) > 0.3 ? 3. : 1.); });
}

TEST(Distributed_simulation, few_bubbles)
{
  const paper::Domain d = paper::all_domains(6)[0];
  EXPECT_LT(expect_same_as_one_rank(d, d.d).size(), 200u);
}

TEST(Distributed_simulation, stops_together)
{
  const paper::Domain d = domain(1);
  const auto run = [&d](Points& points, const std::function<bool(double)>& callback) {
    return CGAL::Distributed::npbs_relax(points, paper::triangulate(d), MPI_COMM_WORLD,
                                         P::sizing_function(d.d).callback(callback)).report;
  };
  Points points, all;
  const auto stopped = run(points, [](double share) { return rank() != last_rank() || share < 0.3; }); // bubbles move
  const auto whole = run(all, [](double) { return true; });
  EXPECT_EQ(stopped.stop_reason, CGAL::Bubble_stop_reason::STOPPED_BY_CALLBACK);
  EXPECT_GT(stopped.number_of_steps, 0u);
  EXPECT_LT(stopped.number_of_steps, whole.number_of_steps);
  EXPECT_EQ(points.size(), 0u);
}

TEST(Distributed_simulation, what_d_throws_on_one_rank_is_thrown_on_all)
{
  const paper::Domain d = domain(1);
  // while bubbles are put on the outline, while they fill the faces, and while they move
  for (const int last : {3, 4000, 9000}) {
    int calls = 0;
    const auto size = [&](const Point& p) {
      if (rank() == last_rank() && ++calls > last)
        throw std::domain_error("no d after so many calls");
      return d.d(p);
    };
    Points points;
    distributed::expect_same_exception<std::domain_error>("no d after so many calls", [&] {
      CGAL::Distributed::npbs_relax(points, paper::triangulate(d), MPI_COMM_WORLD, P::sizing_function(size));
    });
    EXPECT_EQ(points.size(), 0u);
  }
}

} // namespace test_distributed_simulation
