// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// Geometry that breaks meshers: touching, thin, tiny, huge and far away.

#include "domains.h"
#include "expect_throw.h"
#include "random_seeds.h"
#include "relax_and_validate.h"
#include "validation.h"

#include <CGAL/npbs_place_nodes.h>
#include <CGAL/npbs_relax.h>

namespace test_degenerate_input {

using domains::CDT;
using domains::Outline;

auto size(double d) { return CGAL::parameters::sizing_function(d); }

TEST(Degenerate_input, hole_touches_the_boundary_in_a_vertex)
{
  CDT cdt = domains::make({domains::square(0, 0, 1), {{0, 0}, {0.6, 0.3}, {0.3, 0.6}}});
  const auto report = relax_and_validate(cdt, size(0.05));
  EXPECT_NEAR(validation::domain_area(cdt), 1 - 0.135, 1e-12);
  EXPECT_GE(report.quality.mean_quality(), 0.985);
  EXPECT_GE(report.quality.minimum_quality(), 0.7); // in the corner of 37 degrees
}

TEST(Degenerate_input, two_components_joined_in_a_point)
{
  CDT cdt = domains::make({domains::square(0, 0, 1), domains::square(1, 1, 1)});
  const auto report = relax_and_validate(cdt, size(0.1));
  EXPECT_NEAR(validation::domain_area(cdt), 2, 1e-12);
  EXPECT_GE(report.quality.mean_quality(), 0.983);
  EXPECT_GE(report.quality.minimum_quality(), 0.915);
}

TEST(Degenerate_input, two_separate_components)
{
  CDT cdt = domains::make({domains::square(0, 0, 1), domains::square(3, 1, 1)});
  const auto report = relax_and_validate(cdt, size(0.1));
  EXPECT_NEAR(validation::domain_area(cdt), 2, 1e-12);
  EXPECT_GE(report.quality.mean_quality(), 0.983);
  EXPECT_GE(report.quality.minimum_quality(), 0.915);
}

TEST(Degenerate_input, corner_of_one_degree)
{
  CDT cdt = domains::make({{{0, 0}, {1, 0}, {1, std::tan(3.14159265358979 / 180)}}});
  relax_and_validate(cdt, size(0.02));
  EXPECT_NEAR(validation::domain_area(cdt), 0.5 * std::tan(3.14159265358979 / 180), 1e-15);
}

TEST(Degenerate_input, slit_thinner_than_a_bubble)
{
  CDT cdt = domains::make({domains::square(0, 0, 1), {{0.2, 0.5}, {0.8, 0.5}, {0.8, 0.501}, {0.2, 0.501}}});
  relax_and_validate(cdt, size(0.05));
  EXPECT_NEAR(validation::domain_area(cdt), 1 - 0.0006, 1e-12);
}

TEST(Degenerate_input, hole_as_thin_as_a_rounding)
{
  CDT cdt = domains::make({domains::square(0, 0, 4), {{1, 1}, {3, 1}, {2, std::nextafter(1., 2.)}}});
  const std::set<validation::Xy> corners = validation::snapshot(cdt).vertices;
  for (double d : {5., 2.5}) {
    CGAL::npbs_relax(cdt, size(d));
    validation::expect_valid_mesh(cdt);
    const validation::Snapshot after = validation::snapshot(cdt);
    validation::expect_vertices_kept(corners, after);
    double around_hole = 0, around_square = 0; // the sides of the hole cannot be told by their place
    for (const validation::Segment& s : after.constraints)
      (std::abs(s.first.second - 1) < 1e-9 && std::abs(s.second.second - 1) < 1e-9
         ? around_hole : around_square) += validation::length(s);
    EXPECT_NEAR(around_hole, 4, 1e-12);
    EXPECT_NEAR(around_square, 16, 1e-12);
    EXPECT_NEAR(validation::domain_area(cdt), 16, 1e-12);
    EXPECT_TRUE(std::any_of(cdt.finite_faces_begin(), cdt.finite_faces_end(),
                            [](const auto& f) { return !f.is_in_domain(); }));
  }
}

TEST(Degenerate_input, sides_that_would_cross_when_bubbles_split_them_are_refused)
{
  CDT cdt = domains::make({domains::square(0, 0, 4), {{1, 1}, {3, 1}, {2, std::nextafter(1., 2.)}}});
  const validation::Snapshot before = validation::snapshot(cdt);
  expect_throw<std::runtime_error>([&] { CGAL::npbs_relax(cdt, size(0.4)); }, {"nearer"});
  const validation::Snapshot after = validation::snapshot(cdt);
  EXPECT_EQ(after.vertices, before.vertices);
  EXPECT_EQ(after.constraints, before.constraints);
}

TEST(Degenerate_input, channel_thinner_than_a_bubble)
{
  CDT cdt = domains::make({{{0, 0}, {1, 0}, {1, 0.49}, {2, 0.49}, {2, 0}, {3, 0}, {3, 1}, {2, 1},
                            {2, 0.51}, {1, 0.51}, {1, 1}, {0, 1}}});
  relax_and_validate(cdt, size(0.08));
  EXPECT_NEAR(validation::domain_area(cdt), 2.02, 1e-12);
}

TEST(Degenerate_input, nearly_coincident_vertices)
{
  CDT cdt = domains::make({{{0, 0}, {1, 0}, {1, 0.5}, {1 + 1e-12, 0.5 + 1e-12}, {1, 1}, {0, 1}}});
  relax_and_validate(cdt, size(0.1));
}

TEST(Degenerate_input, small_bend_is_kept)
{
  CDT cdt = domains::make({{{0, 0}, {1, 0}, {1 + 1e-9, 0.5}, {1, 1}, {0, 1}}});
  relax_and_validate(cdt, size(0.1));
}

TEST(Degenerate_input, bend_of_one_rounding_is_straight)
{
  CDT cdt = domains::make({{{0, 0}, {1, 0}, {std::nextafter(1., 2.), 0.5}, {1, 1}, {0, 1}}});
  CGAL::npbs_relax(cdt, size(0.13));
  validation::expect_valid_mesh(cdt);
  EXPECT_NEAR(validation::domain_area(cdt), 1, 1e-12);
}

TEST(Degenerate_input, many_vertices_on_a_short_edge)
{
  Outline o{{0, 0}, {1, 0}};
  for (int i = 0; i <= 200; ++i) // a circular bump of radius 0.001 on the right side
    o.push_back({1 + 0.001 * std::sin(i * 3.14159265358979 / 200),
                 0.5 - 0.001 * std::cos(i * 3.14159265358979 / 200)});
  o.push_back({1, 1});
  o.push_back({0, 1});
  CDT cdt = domains::make({o});
  relax_and_validate(cdt, size(0.1));
}

TEST(Degenerate_input, domain_smaller_than_a_bubble)
{
  CDT cdt = domains::make({domains::square(0, 0, 1)});
  const auto report = relax_and_validate(cdt, size(10.));
  EXPECT_EQ(report.number_of_vertices, 4u);
  EXPECT_EQ(report.number_of_triangles, 2u);
}

TEST(Degenerate_input, single_triangle)
{
  CDT cdt = domains::make({{{0, 0}, {1, 0}, {0.5, 0.8}}});
  const auto report = relax_and_validate(cdt, size(1.));
  EXPECT_EQ(report.number_of_vertices, 3u);
}

TEST(Degenerate_input, size_that_falls_below_all_roundings)
{
  for (double x : {0., 1.}) { // the fine place is an end of edges, at zero and at a number with roundings
    CDT cdt = domains::make({domains::square(0, 0, 1)});
    const auto d = [x](const domains::Point& p) {
      return 0.2 * std::hypot(p.x() - x, p.y() - x) + 1e-40;
    };
    const auto report = relax_and_validate(
      cdt, CGAL::parameters::sizing_function(d).number_of_rounds(1).number_of_iterations(5));
    EXPECT_NEAR(double(report.number_of_vertices), x == 0 ? 4259 : 1723, 50);
  }
}

// by the thousands the bubbles would push all others, in each step
TEST(Degenerate_input, given_mesh_far_finer_than_the_size)
{
  const CDT mesh = domains::mesh({domains::square(0, 0, 1)}, 0.02);
  const std::size_t number = mesh.number_of_vertices();
  for (auto population : {CGAL::Bubble_population::OVERLAP_RATIO, CGAL::Bubble_population::DELAUNAY}) {
    const auto keep = [&](double d) {
      CDT cdt = mesh;
      const auto report =
        CGAL::npbs_relax(cdt, size(d).initial_placement(CGAL::Bubble_placement::KEEP).population_control(population)
                                .number_of_rounds(2).number_of_iterations(5));
      validation::expect_valid_mesh(cdt);
      return report.number_of_initial_bubbles;
    };
    EXPECT_EQ(keep(0.02), number);
    for (double d : {0.04, 0.08, 0.5}) { // about as many as a packing has
      const double wanted = 1.155 / (d * d) + 2 / d + 1;
      EXPECT_GT(double(keep(d)), 0.9 * wanted);
      EXPECT_LT(double(keep(d)), 1.25 * wanted + 1);
    }
  }
}

// none of them may go: then the bubbles are smaller than d
TEST(Degenerate_input, given_mesh_far_finer_than_the_size_that_keeps_all)
{
  CDT cdt = domains::make({domains::square(0, 0, 1)});
  const auto d = [](double factor) {
    return CGAL::parameters::sizing_function([factor](const domains::Point& p) { return factor * (0.015 + 0.03 * p.x()); });
  };
  CGAL::npbs_relax(cdt, d(1));
  const auto keep = d(50).initial_placement(CGAL::Bubble_placement::KEEP)
                      .population_control(CGAL::Bubble_population::NONE);
  const std::size_t number = cdt.number_of_vertices();
  const auto nodes = CGAL::npbs_place_nodes(cdt, keep);
  EXPECT_LT(nodes.neighbors.size(), 20 * number);
  const auto report = CGAL::npbs_relax(cdt, keep);
  validation::expect_valid_mesh(cdt);
  EXPECT_GT(report.number_of_wanted_vertices, number / 2);
  EXPECT_NEAR(double(report.number_of_vertices), double(number), 40); // on the outline there are fewer
  EXPECT_GE(report.quality.mean_quality(), 0.98);
}

class Scaled_and_shifted : public testing::TestWithParam<std::pair<double, double>>
{};

TEST_P(Scaled_and_shifted, slanted_domain)
{
  const double scale = GetParam().first, shift = GetParam().second;
  Outline outer = domains::slanted, hole = domains::hole;
  for (Outline* o : {&outer, &hole})
    for (auto& p : *o)
      p = {scale * p.first + shift, scale * p.second - shift};
  CDT cdt = domains::make({outer, hole});
  const auto report = relax_and_validate(cdt, size(0.05 * scale));
  EXPECT_GE(report.quality.mean_quality(), 0.987);
  EXPECT_GE(report.quality.minimum_quality(), 0.82);
  EXPECT_EQ(report.quality.number_of_vertices(), report.number_of_vertices);
}

INSTANTIATE_TEST_SUITE_P(Coordinates, Scaled_and_shifted,
                         testing::Values(std::pair<double, double>(1, 0),
                                         std::pair<double, double>(1e-9, 0),
                                         std::pair<double, double>(1e9, 0),
                                         std::pair<double, double>(1, 1e8),
                                         std::pair<double, double>(1e-80, 0),
                                         std::pair<double, double>(1e80, 0)));

TEST(Degenerate_input, random_stars)
{
  for (unsigned k = 0; k < 20; ++k) {
    const unsigned seed = random_seeds::seed(k);
    SCOPED_TRACE(seed);
    CDT cdt = domains::make(domains::random_star(seed));
    const auto report = relax_and_validate(cdt, size(0.07));
    const std::vector<Outline> star = domains::random_star(seed);
    EXPECT_NEAR(validation::domain_area(cdt), domains::area(star[0]) - domains::area(star[1]), 1e-12);
    // of 400 stars the least are 0.98596 and 0.817
    EXPECT_GE(report.quality.mean_quality(), 0.985);
    EXPECT_GE(report.quality.minimum_quality(), 0.8);
  }
}

} // namespace test_degenerate_input
