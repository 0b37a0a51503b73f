// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// statistics of all ranks are those that one rank would find, to the last bit

#include "../random_seeds.h"
#include "../validation.h"
#include "bubbles.h"
#include "union_of_ranks.h"

#include <CGAL/Bubble_relaxation_2/internal/core/find_sorted.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/parts/Part_team_2.h>
#include <CGAL/Bubble_relaxation_2/internal/quality/evaluate.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

namespace test_distributed_quality {

using namespace bubbles;
using Quality = CGAL::Mesh_quality_2<double>;

struct Ranks
{
  Communicator comm{MPI_COMM_WORLD};

  Quality quality(const Case& c, const Sizes_2* sizes, bool with_gaps)
  {
    std::vector<std::int64_t> numbers(c.bubbles.size());
    std::iota(numbers.begin(), numbers.end(), 0);
    const Hilbert_partition_2 partition =
      distributed::partition(c.domain().bbox(), c.bubbles, comm.size(), with_gaps);
    const Distributed_mesh_2 mesh = distributed_triangulate(
      c.domain(), distributed::own_part(c.bubbles, numbers, partition, comm.rank()), partition, comm);
    Team_of_ranks team(comm);
    return quality_of(mesh, sizes, Threads(), team);
  }
};

void expect_quality_of_one_rank(const Case& c, const paper::Sizing& d)
{
  const Sizes_2 field = sizes_of(d);
  Report report;
  const Relaxation_options options;
  evaluate(mesh_of(c), Problem_2{c.domain(), c.given(), options, field, field}, report);
  Ranks ranks;
  for (bool with_gaps : {false, true})
    EXPECT_EQ(validation::all_numbers(ranks.quality(c, &field, with_gaps)), validation::all_numbers(report.quality));
}

TEST(Distributed_quality, of_relaxed_bubbles)
{
  for (const paper::Domain& domain : paper::all_domains(1)) {
    SCOPED_TRACE(domain.name);
    expect_quality_of_one_rank(relaxed(domain), domain.d);
  }
}

TEST(Distributed_quality, of_random_points)
{
  for (unsigned seed = 1; seed <= 4; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const paper::Domain domain = paper::trunk(1);
    expect_quality_of_one_rank(random(domain, 700, seed), domain.d);
  }
}

TEST(Distributed_quality, of_equal_triangles)
{
  expect_quality_of_one_rank(lattice(16), [](const Point& p) { return 1 + p.x() / 7; });
}

TEST(Distributed_quality, of_a_mesh_with_fewer_triangles_than_ranks)
{
  Case c = read(paper::graded_square(1));
  add_outline(c, 0, 1);
  expect_quality_of_one_rank(c, [](const Point&) { return 1; });
}

TEST(Distributed_quality, without_lengths)
{
  Ranks ranks;
  const Case c = random(paper::trunk(1), 100, 1);
  const Quality quality = ranks.quality(c, nullptr, false);
  EXPECT_FALSE(quality.has_length_ratios());
  EXPECT_EQ(quality.number_of_vertices(), c.bubbles.size());
}

TEST(Distributed_quality, a_sizing_function_that_throws_on_one_rank)
{
  const Case c = random(paper::trunk(1), 400, 1);
  Ranks ranks;
  const int last = ranks.comm.size() - 1;
  const Sizes_2 field([&](double, double) -> double {
    if (ranks.comm.rank() == last)
      throw std::domain_error("no size here");
    return 1;
  });
  try {
    ranks.quality(c, &field, false);
    ADD_FAILURE() << "nothing was thrown";
  } catch (const std::domain_error& e) {
    EXPECT_STREQ(e.what(), "no size here");
  }
}

TEST(Team_of_ranks, sorted_positions_are_those_of_all_values)
{
  Communicator comm(MPI_COMM_WORLD);
  const Team_of_ranks all(comm);
  std::mt19937 engine(random_seeds::seed(7));
  std::vector<double> values{0., -0., std::numeric_limits<double>::denorm_min(),
                             std::numeric_limits<double>::infinity(), (std::numeric_limits<double>::max)(),
                             1., 1., 1.};
  std::uniform_real_distribution<double> exponent(-300, 300);
  for (int i = 0; i < 500; ++i)
    values.push_back(std::pow(10, exponent(engine)));
  std::vector<double> own;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (static_cast<int>(i * i % 11) % comm.size() == comm.rank())
      own.push_back(values[i]);
  std::sort(values.begin(), values.end());
  const std::vector<std::size_t> positions{0, 1, 2, 2, 250, 506, 507};
  const auto found = sorted_at(positions, own, all);
  for (std::size_t k = 0; k < positions.size(); ++k)
    EXPECT_EQ(found[k], values[positions[k]]) << positions[k];
}

} // namespace test_distributed_quality
