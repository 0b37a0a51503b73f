// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// all ways to start, and all ways to go on, by ranks are those of one rank: from points that are given on any rank,
// from the vertices of the domain's triangulation, and as in the paper

#include "../random_seeds.h"
#include "bubbles.h"
#include "equal_bubbles.h"

#include <CGAL/Bubble_relaxation_2/internal/distributed/simulation/simulate_distributed.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <random>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

namespace test_distributed_placement {

using namespace bubbles;
using CGAL::Bubble_placement;
using CDT = paper::CDT;
using Size = std::function<double(const Point&)>;

/// the triangulation of the domain of `c` with all its bubbles inserted
CDT with_bubbles(const Case& c)
{
  const Bubbles_2& b = c.bubbles;
  CDT cdt;
  for (const Domain_edge_2& piece : cut_edges(c.domain(), b))
    cdt.insert_constraint(b.point(piece.source), b.point(piece.target));
  for (std::size_t i = 0; i < b.size(); ++i)
    cdt.insert(b.point(i));
  return cdt;
}

/// some of the bubbles, at random; the last rank has most, and the first has none of those in faces
Bubbles_2 scattered(Communicator& ranks, const Bubbles_2& b)
{
  Bubbles_2 result;
  std::mt19937 engine(random_seeds::seed(7));
  for (std::size_t i = 0; i < b.size(); ++i) {
    const int rank = (std::min)(static_cast<int>(engine() % 16), ranks.size() - 1);
    const bool is_for_last = rank == 0 && b.is_in_face(i);
    if ((is_for_last ? ranks.size() - 1 : rank) == ranks.rank())
      add_own(result, record(b, i, no_index));
  }
  return result;
}

Relaxation_options options_with(bool is_given, Bubble_placement placement)
{
  Relaxation_options options = read_options(CGAL::parameters::number_of_rounds(3).number_of_iterations(12));
  options.placement_is_given = is_given;
  options.placement = placement;
  return options;
}

void expect_parts_make_the_whole(Communicator& ranks, const Placed_part_2& placed, const Bubbles_2& whole)
{
  const Bubbles_2& part = placed.bubbles;
  EXPECT_EQ(ranks.sum(static_cast<std::int64_t>(part.size())), static_cast<std::int64_t>(whole.size()));
  for (std::size_t i = 0; i < part.size(); ++i) {
    const std::size_t number = static_cast<std::size_t>(part.id[i]);
    ASSERT_LT(number, whole.size());
    EXPECT_EQ(placed.partition.owner(part.x[i], part.y[i]), ranks.rank());
    expect_equal(record(part, i), record(whole, number, 0));
    if (testing::Test::HasFailure())
      return; // one is enough
  }
}

/// simulates the same problem on one rank and on all, as far as these read another triangulation or `points`
void expect_same(Communicator& ranks, const Problem_2& of_one, const Problem_2& of_all, const Bubbles_2& points = {})
{
  Report first, second;
  const Bubbles_2 all = relax_bubbles(of_one, first);
  const Placed_part_2 part = simulate_distributed(ranks, of_all, second, points);
  EXPECT_EQ(second.number_of_initial_bubbles, first.number_of_initial_bubbles);
  EXPECT_EQ(second.number_of_steps, first.number_of_steps);
  EXPECT_GT(all.size(), 500u);
  expect_parts_make_the_whole(ranks, part, all);
}

/// Simulates on one rank what is read in `whole`, and on all ranks what is read in `bare` and `points`; both by d.
void expect_same(Communicator& ranks, const Case& whole, const Case& bare, const Bubbles_2& points, const Size& d,
                 const Relaxation_options& options)
{
  const Sizes_2 sizes = sizes_in(bare, d);
  const Problem_2 of_one{whole.domain(), whole.given(), options, sizes, sizes},
    of_all{bare.domain(), bare.given(), options, sizes, sizes};
  expect_same(ranks, of_one, of_all, points);
  expect_parts_make_the_whole(
    ranks, place_by_all(ranks, of_all, points, given_bubbles),
    given_bubbles(of_one));
}

/// from the domain alone
void expect_same(Communicator& ranks, const paper::Domain& domain, const Relaxation_options& options)
{
  Case bare{paper::triangulate(domain), nullptr, {}};
  const auto np = CGAL::parameters::sizing_function(domain.d).limit_by_outline(options.limit_by_outline);
  bare.read(np);
  const Input& input = *bare.input;
  const Problem_2 read = input.problem(),
                  problem{read.domain, read.given, options, read.wanted, read.sizes, read.cut, read.whole};
  expect_same(ranks, problem, problem);
}

/// a mesh to start from: a domain with bubbles, and its triangulation with them
struct Given
{
  explicit Given(int k, double coarseness = 0.8)
    : domain(paper::all_domains(coarseness)[k]), bare(relaxed(domain))
  {
    read_mesh();
  }

  /// reads the mesh again, where the points `pinned` are pinned
  void read_mesh(const std::vector<Point>& pinned = {})
  {
    mesh.cdt = with_bubbles(bare);
    std::set<CDT::Vertex_handle> pins;
    for (const Point& p : pinned)
      pins.insert(mesh.cdt.insert(p)); // where it is already
    mesh.read(CGAL::parameters::sizing_function(domain.d).limit_by_outline(false).vertex_is_constrained_map(
      CGAL::make_boolean_property_map(pins)));
  }

  const paper::Domain domain;
  Case bare, mesh;
};

class Ways_to_start : public testing::TestWithParam<std::pair<bool, Bubble_placement>>
{};

TEST_P(Ways_to_start, from_points_on_any_rank)
{
  Communicator ranks{MPI_COMM_WORLD};
  for (int k : {0, 4}) {
    SCOPED_TRACE(k);
    Given given(k);
    // as fine as the mesh in a part of the domain, finer, and coarser
    const Size& d = given.domain.d;
    const CGAL::Bbox_2& box = given.bare.domain().bbox();
    const double third = (box.xmax() - box.xmin()) / 3, x0 = box.xmin();
    const Size other = [&](const Point& p) {
      return d(p) * (p.x() < x0 + third ? 0.7 : p.x() < x0 + 2 * third ? 1. : 1.5);
    };
    const auto options = options_with(GetParam().first, GetParam().second);
    expect_same(ranks, given.mesh, given.bare, scattered(ranks, given.bare.bubbles), other, options);
    expect_same(ranks, given.mesh, given.mesh, {}, other, options); // of the domain
  }
}

INSTANTIATE_TEST_SUITE_P(All, Ways_to_start,
                         testing::Values(std::make_pair(true, Bubble_placement::KEEP),
                                         std::make_pair(false, Bubble_placement::FRONTAL),
                                         std::make_pair(true, Bubble_placement::FRONTAL)));

TEST(Ways_to_go_on, as_in_the_paper)
{
  Communicator ranks{MPI_COMM_WORLD};
  for (int k : {1, 5}) {
    SCOPED_TRACE(k);
    Relaxation_options options = read_options(CGAL::npbs_paper_parameters());
    options.number_of_rounds = 3;
    options.number_of_iterations = 35;
    expect_same(ranks, paper::all_domains(k == 5 ? 0.9 : 0.7)[k], options);
  }
}

TEST(Ways_to_go_on, each_for_itself)
{
  Communicator ranks{MPI_COMM_WORLD};
  const paper::Domain domain = paper::all_domains(0.8)[3];
  {
    SCOPED_TRACE("Runge-Kutta, and all else as by default");
    Relaxation_options options = read_options(CGAL::parameters::integrator(CGAL::Bubble_integrator::RUNGE_KUTTA_4));
    options.number_of_rounds = 2;
    expect_same(ranks, domain, options);
  }
  {
    SCOPED_TRACE("cells, the overlapping ratio, and all else as by default");
    Relaxation_options options = options_with(true, Bubble_placement::RHOMBIC);
    options.population = CGAL::Bubble_population::OVERLAP_RATIO;
    expect_same(ranks, domain, options);
  }
  {
    SCOPED_TRACE("renewal at intervals, and all else as by default");
    Relaxation_options options = options_with(true, Bubble_placement::RHOMBIC);
    options.renewal_interval = 4;
    expect_same(ranks, domain, options);
    options.neighbor_radius = 3.5; // not by neighbours of neighbours
    expect_same(ranks, domain, options);
  }
}

TEST(Ways_to_go_on, bubbles_that_go_far_take_their_neighbours_along)
{
  Communicator ranks{MPI_COMM_WORLD};
  Given given(0);
  const CGAL::Bbox_2& box = given.bare.domain().bbox();
  const double middle = (box.xmin() + box.xmax()) / 2;
  const Size crowded_on_one_side = [&](const Point& p) { return given.domain.d(p) * (p.x() < middle ? 1.8 : 0.6); };
  Relaxation_options options = options_with(true, Bubble_placement::KEEP);
  options.population = CGAL::Bubble_population::NONE;
  options.number_of_iterations = 60;
  options.renewal_interval = 4;
  expect_same(ranks, given.mesh, given.bare, scattered(ranks, given.bare.bubbles), crowded_on_one_side, options);
}

/// At a junction on a straight constraint the same place is proposed by both of its pieces.
TEST(Ways_to_go_on, from_junctions_on_straight_constraints)
{
  Communicator ranks{MPI_COMM_WORLD};
  Case comb{CDT(), nullptr, {}};
  const std::vector<Point> square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  comb.cdt.insert_constraint(square.begin(), square.end(), true);
  for (int k = 1; k < 31; ++k) {
    const Point junction(k / 32., 0.25 + k / 64.), next((k + 1) / 32., 0.25 + (k + 1) / 64.);
    comb.cdt.insert_constraint(junction, next);
    comb.cdt.insert_constraint(junction, Point(junction.x(), junction.y() + 0.0125));
  }
  comb.read(CGAL::parameters::sizing_function(0.02));
  const Problem_2 problem = comb.input->problem();
  Team alone;
  Bubbles_2 placed = place_bubbles(problem, alone);
  remove_those_in_one_place(placed);
  EXPECT_EQ(placed.left().size(), placed.size());
  expect_same(ranks, problem, problem);
}

TEST_P(Ways_to_start, with_pinned_points)
{
  Communicator ranks{MPI_COMM_WORLD};
  Given given(0);
  Bubbles_2& b = given.bare.bubbles;
  std::vector<Point> pinned;
  for (std::size_t i = 0; i < b.size(); i += 40)
    if (b.is_in_face(i)) {
      pinned.push_back(b.point(i));
      b.dimension[i] = Bubbles_2::CORNER;
      b.host[i] = no_index;
    }
  ASSERT_GT(pinned.size(), 5u);
  given.read_mesh(pinned);
  const Size finer = [&](const Point& p) { return given.domain.d(p) * (p.x() < p.y() ? 0.7 : 1.); };
  const auto options = options_with(GetParam().first, GetParam().second);
  expect_same(ranks, given.mesh, given.bare, scattered(ranks, b), finer, options);
  expect_same(ranks, given.mesh, given.mesh, {}, finer, options);
}

TEST(Given_points, in_one_place_are_refused_on_all_ranks)
{
  Communicator ranks{MPI_COMM_WORLD};
  Given given(0);
  Bubbles_2 points = scattered(ranks, given.bare.bubbles);
  Sizes_2 sizes([](double, double) { return 0.05; }); // the same everywhere
  sizes.expected_number = 1000;
  const Relaxation_options options;
  const Problem_2 problem{given.bare.domain(), given.bare.given(), options, sizes, sizes};
  const auto place = [&] {
    place_by_all(ranks, problem, points, given_bubbles);
  };
  EXPECT_NO_THROW(place());
  if (ranks.rank() == ranks.size() - 1)
    add_own(points, record(points, points.size() - 1));
  EXPECT_THROW(place(), std::invalid_argument);
}

/// removes the bubbles in discs beside the lines through the middle of the box, where borders of ranks are about
void make_holes(Given& given, double radius)
{
  Bubbles_2& b = given.bare.bubbles;
  const CGAL::Bbox_2& box = given.bare.domain().bbox();
  const double d = given.domain.d(Point(box.xmin(), box.ymin())), x = (box.xmin() + box.xmax()) / 2,
               y = (box.ymin() + box.ymax()) / 2;
  double side = 1, gap = 0;
  for (double along = -40; along < 40; along += 2 * radius + 4, side = -side, gap += 0.3) {
    const double off = side * (radius + gap);
    for (const Point& center : {Point(x + off * d, y + along * d), Point(x + along * d, y + off * d)})
      for (std::size_t i = 0; i < b.size(); ++i)
        if (b.is_in_face(i) && std::hypot(b.x[i] - center.x(), b.y[i] - center.y()) < radius * d)
          b.remove(i);
  }
  b.forget_gone();
  given.read_mesh();
}

/// Beside a wide hole bubbles are neighbours that are farther from each other than others ever look.
TEST(Wide_holes, are_filled_as_by_one_rank)
{
  Communicator ranks{MPI_COMM_WORLD};
  Relaxation_options options = options_with(true, Bubble_placement::KEEP);
  options.neighbor_radius = 2.9; // beside holes they look three times as far, and this matters to 7 ranks
  for (const double radius : {2.5, 4.}) {
    SCOPED_TRACE(radius);
    Given given(0, 0.5);
    make_holes(given, radius);
    expect_same(ranks, given.mesh, given.bare, scattered(ranks, given.bare.bubbles), given.domain.d, options);
  }
}

} // namespace test_distributed_placement
