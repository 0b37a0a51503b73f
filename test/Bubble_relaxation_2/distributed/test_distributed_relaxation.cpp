// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// CGAL::Distributed::npbs_relax(): all ranks together make the points, the neighbour sets and the report of one

#include "../random_seeds.h"
#include "../validation.h"
#include "relaxed_points.h"
#include "same_exception.h"
#include "union_of_ranks.h"

#include <CGAL/npbs_place_nodes.h>
#include <CGAL/npbs_relax.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <iterator>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace test_distributed_relaxation {

using namespace relaxed_points;
namespace parameters = CGAL::Bubble_relaxation_parameters;

/// `report`: of all ranks
template <class Report>
void expect_equal(const Report& report, const Report& expected)
{
  EXPECT_EQ(report.number_of_vertices, expected.number_of_vertices);
  EXPECT_EQ(report.number_of_triangles, expected.number_of_triangles);
  EXPECT_EQ(report.number_of_initial_bubbles, expected.number_of_initial_bubbles);
  EXPECT_EQ(report.number_of_rounds, expected.number_of_rounds);
  EXPECT_EQ(report.number_of_steps, expected.number_of_steps);
  EXPECT_EQ(report.number_of_force_evaluations, expected.number_of_force_evaluations);
  EXPECT_EQ(report.number_of_moves, expected.number_of_moves);
  EXPECT_EQ(report.number_of_renewals, expected.number_of_renewals);
  EXPECT_EQ(report.number_of_insertions, expected.number_of_insertions);
  EXPECT_EQ(report.number_of_deletions, expected.number_of_deletions);
  EXPECT_EQ(report.number_of_treated_vertices, expected.number_of_treated_vertices);
  EXPECT_EQ(report.number_of_returns, expected.number_of_returns);
  EXPECT_EQ(report.converged, expected.converged);
  EXPECT_EQ(report.stop_reason, expected.stop_reason);
  EXPECT_EQ(report.number_of_wanted_vertices, expected.number_of_wanted_vertices);
  EXPECT_EQ(report.number_of_pins_outside, expected.number_of_pins_outside);
  EXPECT_EQ(report.pin_outside_x, expected.pin_outside_x);
  EXPECT_EQ(report.pin_outside_y, expected.pin_outside_y);
  for (std::size_t k = 0; k < report.forced_places.size(); ++k) {
    EXPECT_EQ(report.forced_places[k].number_of_vertices, expected.forced_places[k].number_of_vertices);
    EXPECT_EQ(report.forced_places[k].x, expected.forced_places[k].x);
    EXPECT_EQ(report.forced_places[k].y, expected.forced_places[k].y);
  }
  EXPECT_EQ(report.number_of_forced_triangles, expected.number_of_forced_triangles);
  EXPECT_EQ(report.forced_x, expected.forced_x);
  EXPECT_EQ(report.forced_y, expected.forced_y);
  EXPECT_EQ(report.number_of_small_angles, expected.number_of_small_angles);
  EXPECT_EQ(report.small_x, expected.small_x);
  EXPECT_EQ(report.small_y, expected.small_y);
  EXPECT_EQ(report.largest_size_gradient, expected.largest_size_gradient);
  EXPECT_EQ(report.steepest_x, expected.steepest_x);
  EXPECT_EQ(report.steepest_y, expected.steepest_y);
  EXPECT_EQ(report.steep_share, expected.steep_share);
  EXPECT_EQ(validation::all_numbers(report.quality), validation::all_numbers(expected.quality));
}

/// the nodes of one rank have the ids of the points as indices
template <class Nodes>
void expect_equal(const All_parts& all, const Nodes& nodes)
{
  ASSERT_EQ(all.nodes.size(), nodes.size());
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    const Node& node = all.nodes[n];
    ASSERT_EQ(node.id, static_cast<std::int64_t>(n));
    ASSERT_EQ(Point(node.place[0], node.place[1]), nodes.points[n]);
    ASSERT_EQ(node.size, nodes.sizes[n]);
    ASSERT_EQ(node.dimension, int(nodes.dimensions[n]));
    const auto first = nodes.neighbors.begin();
    const std::vector<std::int64_t> expected(first + static_cast<std::ptrdiff_t>(nodes.neighbor_offsets[n]),
                                             first + static_cast<std::ptrdiff_t>(nodes.neighbor_offsets[n + 1]));
    ASSERT_EQ(all.neighbors[n], expected) << "of " << n;
  }
}

/// they are the points of all parts, in another order
void expect_vertices(const All_parts& all, const paper::CDT& mesh)
{
  std::vector<Coordinates> points, vertices;
  for (const Node& node : all.nodes)
    points.push_back(node.place);
  for (const auto v : mesh.finite_vertex_handles())
    vertices.push_back({v->point().x(), v->point().y()});
  std::sort(points.begin(), points.end());
  std::sort(vertices.begin(), vertices.end());
  EXPECT_TRUE(points == vertices);
}

/// points come in the order of their ids, and ghosts are the neighbours that others own, as these know them
void expect_consistent(const Part& part, const All_parts& all)
{
  const auto& r = part.relaxation;
  std::vector<std::int64_t> own, neighbors = r.neighbors, ghosts;
  for (const auto& i : part.points)
    own.push_back(part.global_id(i));
  EXPECT_TRUE(std::is_sorted(own.begin(), own.end()));
  std::sort(neighbors.begin(), neighbors.end());
  neighbors.erase(std::unique(neighbors.begin(), neighbors.end()), neighbors.end());
  std::set_difference(neighbors.begin(), neighbors.end(), own.begin(), own.end(), std::back_inserter(ghosts));
  ASSERT_EQ(r.ghost_ids, ghosts);
  ASSERT_EQ(r.ghost_points.size(), ghosts.size());
  ASSERT_EQ(r.ghost_sizes.size(), ghosts.size());
  ASSERT_EQ(r.ghost_owners.size(), ghosts.size());
  for (std::size_t k = 0; k < ghosts.size(); ++k) {
    const Node& node = all.nodes.at(static_cast<std::size_t>(ghosts[k]));
    EXPECT_EQ(r.ghost_points[k], Point(node.place[0], node.place[1]));
    EXPECT_EQ(r.ghost_sizes[k], node.size);
    EXPECT_EQ(r.ghost_owners[k], node.owner);
  }
}

/// One rank of all makes the whole as well. `points`: of the ranks, which that one has in its triangulation.
template <class NamedParameters>
Part expect_as_one_rank(paper::CDT domain, const NamedParameters& np, const std::vector<Point>& points = {})
{
  Part part;
  for (std::size_t k = 0; k < points.size(); ++k)
    if (7 * k % 10 % static_cast<std::size_t>(distributed::size()) == static_cast<std::size_t>(distributed::rank()))
      part.points.insert(points[k]);
  part.relaxation = CGAL::Distributed::npbs_relax(part.points, domain, MPI_COMM_WORLD, np);
  const All_parts all = gather(part);
  expect_consistent(part, all);
  if (distributed::rank() != 0)
    return part;
  domain.insert(points.begin(), points.end());
  paper::CDT mesh = domain;
  expect_equal(part.relaxation.report, CGAL::npbs_relax(mesh, np));
  expect_vertices(all, mesh);
  const auto nodes = CGAL::npbs_place_nodes(domain, np);
  EXPECT_EQ(part.relaxation.neighbor_radius, nodes.neighbor_radius);
  expect_equal(all, nodes);
  return part;
}

/// so that there are about a thousand points
paper::Domain domain(int k) { return paper::all_domains(0.7)[static_cast<std::size_t>(k)]; }

class Paper_domain : public testing::TestWithParam<int>
{};

TEST_P(Paper_domain, as_one_rank)
{
  const paper::Domain d = domain(GetParam());
  SCOPED_TRACE(d.name);
  const Part part = expect_as_one_rank(paper::triangulate(d), parameters::sizing_function(d.d).number_of_rounds(4));
  EXPECT_GT(part.relaxation.report.number_of_vertices, 800u);
}

INSTANTIATE_TEST_SUITE_P(Some, Paper_domain, testing::Values(3, 4, 7));

// what ranks place and simulate, of so many bubbles that they grow in parts
TEST(Distributed_relaxation, before_any_treatment)
{
  for (int k : {1, 3, 4, 7}) {
    const paper::Domain d = paper::all_domains(0.5)[static_cast<std::size_t>(k)];
    SCOPED_TRACE(d.name);
    const auto np = parameters::sizing_function(d.d).defect_treatment(false);
    const auto report = expect_as_one_rank(paper::triangulate(d), np).relaxation.report;
    EXPECT_GT(report.number_of_vertices, 1600u);
    EXPECT_GT(report.number_of_rounds, 1u);
    EXPECT_EQ(report.number_of_treated_vertices, 0u);
  }
}

TEST(Distributed_relaxation, d_may_jump)
{
  const paper::Domain d = paper::graded_square(1);
  const auto jump = [&d](const Point& p) { return d.d(p) * (std::sin(7 * p.x() + 3 * p.y()) > 0.3 ? 3. : 1.); };
  const Part part = expect_as_one_rank(paper::triangulate(d), parameters::sizing_function(jump));
  EXPECT_GT(part.relaxation.report.number_of_deletions, 0u);
  EXPECT_GT(part.relaxation.report.number_of_insertions, 0u);
}

TEST(Distributed_relaxation, neighbors_of_all_sizes)
{
  using namespace CGAL::Bubble_relaxation_2::internal;
  Communicator comm(MPI_COMM_WORLD);
  std::mt19937 engine(random_seeds::seed(1));
  std::uniform_real_distribution<double> uniform(0, 1);
  Bubbles_2 all;
  for (int i = 0; i < 400; ++i) {
    const double x = uniform(engine), y = uniform(engine);
    all.add(Point(x, y), std::pow(30, -uniform(engine)), Bubbles_2::FACE, 0); // a large one may see most others
  }
  const Hilbert_partition_2 partition = distributed::partition(CGAL::Bbox_2(0, 0, 1, 1), all, comm.size(), true);
  Bubbles_2 own;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const int home = partition.owner(all.x[i], all.y[i]);
    if ((i % 5 == 0 ? (home + 1) % comm.size() : home) == comm.rank()) // some have left home
      add_own(own, record(all, i, 3 * static_cast<std::int64_t>(i)));
  }
  CGAL::Distributed::Relaxation_2<paper::K> written;
  write_neighbors(with_neighbors(own, partition, 0.4, comm), 0.4, written);
  ASSERT_EQ(written.neighbor_offsets.size(), own.size() + 1);
  std::set<std::int64_t> ghosts;
  for (std::size_t k = 0; k < own.size(); ++k) {
    std::vector<std::int64_t> neighbors;
    const std::size_t i = static_cast<std::size_t>(own.id[k] / 3);
    for (std::size_t j = 0; j < all.size(); ++j) {
      const double distance = std::hypot(all.x[i] - all.x[j], all.y[i] - all.y[j]);
      if (j == i || !(distance < 0.2 * (all.d[i] + all.d[j])))
        continue;
      neighbors.push_back(3 * static_cast<std::int64_t>(j));
      if (!std::binary_search(own.id.begin(), own.id.end(), neighbors.back()))
        ghosts.insert(neighbors.back());
    }
    const auto first = written.neighbors.begin();
    EXPECT_EQ(neighbors, std::vector<std::int64_t>(first + std::ptrdiff_t(written.neighbor_offsets[k]),
                                                   first + std::ptrdiff_t(written.neighbor_offsets[k + 1])));
  }
  EXPECT_EQ(written.ghost_ids, std::vector<std::int64_t>(ghosts.begin(), ghosts.end()));
}

TEST(Distributed_relaxation, d_of_the_outline)
{
  expect_as_one_rank(paper::triangulate(domain(3)), CGAL::parameters::default_values());
}

TEST(Distributed_relaxation, ranks_may_have_nothing)
{
  paper::CDT cdt;
  const std::vector<Point> square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  cdt.insert_constraint(square.begin(), square.end(), true);
  for (double d : {2., 0.7, 0.4}) {
    SCOPED_TRACE(d);
    expect_as_one_rank(cdt, parameters::sizing_function(d));
  }
}

TEST(Distributed_relaxation, other_starts_and_ends)
{
  const paper::Domain d = paper::square_with_hole(1.5);
  const paper::CDT cdt = paper::triangulate(d);
  const auto np = parameters::sizing_function(d.d);
  expect_as_one_rank(cdt, np.initial_placement(CGAL::Bubble_placement::RHOMBIC));
  expect_as_one_rank(cdt, np.population_control(CGAL::Bubble_population::NONE));
  expect_as_one_rank(cdt, np.number_of_rounds(0));
  expect_as_one_rank(cdt, np.number_of_rounds(3).number_of_iterations(4).limit_by_outline(false));
  paper::CDT mesh = cdt; // whose free vertices are bubbles to begin with
  CGAL::npbs_relax(mesh, np.number_of_rounds(1));
  expect_as_one_rank(mesh, parameters::sizing_function(0.1));
}

/// the vertices of a mesh that are no corners of its domain
std::vector<Point> free_vertices(const paper::CDT& domain, const paper::CDT& mesh)
{
  std::vector<Point> result;
  for (const auto v : mesh.finite_vertex_handles()) {
    paper::CDT::Locate_type type;
    int i;
    domain.locate(v->point(), type, i);
    if (type != paper::CDT::VERTEX)
      result.push_back(v->point());
  }
  return result;
}

TEST(Distributed_relaxation, from_given_points)
{
  const paper::Domain d = paper::square_with_hole(1.5);
  const paper::CDT cdt = paper::triangulate(d);
  paper::CDT mesh = cdt;
  CGAL::npbs_relax(mesh, parameters::sizing_function(d.d));
  const std::vector<Point> good = free_vertices(cdt, mesh);
  for (const double factor : {1., 1.4, 6.}) {
    const auto np = parameters::sizing_function([&](const Point& p) { return factor * d.d(p); });
    SCOPED_TRACE(factor);
    // with 1, what is given is better than what comes of it; with the others few are taken
    expect_as_one_rank(cdt, np.initial_placement(CGAL::Bubble_placement::KEEP), good);
    if (factor > 2)
      continue;
    expect_as_one_rank(cdt, np, good);
    expect_as_one_rank(cdt, np.initial_placement(CGAL::Bubble_placement::FRONTAL), good);
  }
}

// rows that take over the distances of the outline leave room, and a single crystal grows instead
TEST(Distributed_relaxation, bubbles_grow_twice)
{
  const paper::Domain d = paper::ring(1);
  const paper::CDT cdt = paper::triangulate(d);
  const auto np = parameters::sizing_function([&d](const Point& p) { return 0.7 * d.d(p); });
  EXPECT_LT(expect_as_one_rank(cdt, np).relaxation.report.number_of_vertices, 2500u);
  paper::CDT mesh = cdt; // and where a mesh is given
  CGAL::npbs_relax(mesh, parameters::sizing_function(d.d));
  EXPECT_LT(expect_as_one_rank(cdt, np, free_vertices(cdt, mesh)).relaxation.report.number_of_vertices, 2500u);
}

TEST(Distributed_relaxation, ranks_stay_balanced)
{
  const paper::Domain d = paper::square_with_hole(2);
  const paper::CDT cdt = paper::triangulate(d);
  paper::CDT mesh = cdt;
  CGAL::npbs_relax(mesh, parameters::sizing_function(0.2));
  // bubbles are inserted on one side only
  const auto np = parameters::sizing_function([](const Point& p) { return p.x() < 0.3 ? 0.03 : 0.2; });
  const Part part = expect_as_one_rank(cdt, np.initial_placement(CGAL::Bubble_placement::KEEP),
                                        free_vertices(cdt, mesh));
  const double number = double(part.relaxation.report.number_of_vertices);
  EXPECT_GT(number, 300);
  EXPECT_LT(double(part.points.size()), 1.25 * number / distributed::size() + 16);
}

/// a star with needles
paper::CDT star(unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> exponent(-1.3, 0), shift(-0.4, 0.4);
  const int n = 24;
  std::vector<Point> points;
  for (int k = 0; k < n; ++k) {
    const double r = std::pow(10., exponent(random)), t = 2 * CGAL_PI * (k + shift(random)) / n;
    points.push_back(Point(r * std::cos(t), r * std::sin(t)));
  }
  paper::CDT cdt;
  cdt.insert_constraint(points.begin(), points.end(), true);
  return cdt;
}

TEST(Distributed_relaxation, sharp_corners_and_refinement)
{
  std::size_t number_of_forced = 0, number_of_refined = 0;
  for (unsigned seed = 1; seed <= 6; ++seed) {
    SCOPED_TRACE(seed);
    const paper::CDT cdt = star(seed);
    // after one round where sizes grow fast there is something left to refine, if no less than about what can be had is
    // asked for
    const auto np = parameters::sizing_function(0.05).number_of_rounds(1).size_growth(0.3);
    const std::size_t before = expect_as_one_rank(cdt, np.minimum_angle(0.)).relaxation.report.number_of_vertices;
    const auto report = expect_as_one_rank(cdt, np.minimum_angle(33.)).relaxation.report;
    number_of_forced += report.number_of_forced_triangles;
    number_of_refined += report.number_of_vertices > before;
  }
  EXPECT_GT(number_of_forced, 0u);
  EXPECT_GT(number_of_refined, 0u);
}

TEST(Distributed_relaxation, paper_parameters)
{
  const paper::Domain d = paper::square_with_hole(1.5);
  expect_as_one_rank(paper::triangulate(d),
                     CGAL::npbs_paper_parameters().sizing_function(d.d).number_of_rounds(3).number_of_iterations(40));
}

TEST(Distributed_relaxation, properties_of_users_stay)
{
  const paper::Domain d = paper::square_with_hole(1);
  Points points;
  auto color = points.add_property_map<int>("color", 7).first;
  auto id = points.add_property_map<std::int64_t>("global_id", 0).first;
  points.insert(Point(0, 0));
  points.remove(points.begin());
  CGAL::Distributed::npbs_relax(points, paper::triangulate(d), MPI_COMM_WORLD,
                                parameters::sizing_function(d.d).number_of_rounds(1));
  EXPECT_EQ(points.size() > 0, true);
  EXPECT_EQ(points.number_of_removed_points(), 0u);
  std::int64_t last = -1;
  for (const auto& i : points) {
    EXPECT_EQ(color[i], 7);
    EXPECT_GT(id[i], last);
    last = id[i];
  }
}

} // namespace test_distributed_relaxation
