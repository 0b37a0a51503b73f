// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// Nodes and their neighbour sets, and threads.

#include "../../../demo/Bubble_relaxation_2/paper_domains.h"
#include "validation.h"

#include <CGAL/npbs_place_nodes.h>
#include <CGAL/npbs_relax.h>

namespace test_place_nodes {

TEST(Place_nodes, neighbor_sets_equal_brute_force)
{
  const paper::Domain domain = paper::graded_circle(1);
  const paper::CDT cdt = paper::triangulate(domain);
  const auto nodes = CGAL::npbs_place_nodes(
    cdt, CGAL::parameters::sizing_function(domain.d).neighbor_radius(2.2));
  ASSERT_GT(nodes.size(), 900u);
  ASSERT_EQ(nodes.neighbor_offsets.size(), nodes.size() + 1);
  ASSERT_EQ(nodes.sizes.size(), nodes.size());
  ASSERT_EQ(nodes.dimensions.size(), nodes.size());
  EXPECT_EQ(nodes.neighbor_radius, 2.2);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    ASSERT_EQ(nodes.sizes[i], domain.d(nodes.points[i]));
    std::vector<std::int32_t> expected;
    for (std::size_t j = 0; j < nodes.size(); ++j)
      if (j != i && paper::distance(nodes.points[i], nodes.points[j].x(), nodes.points[j].y()) <
                      1.1 * (nodes.sizes[i] + nodes.sizes[j]))
        expected.push_back(static_cast<std::int32_t>(j));
    ASSERT_EQ(std::vector<std::int32_t>(nodes.neighbors.begin() + nodes.neighbor_offsets[i],
                                        nodes.neighbors.begin() + nodes.neighbor_offsets[i + 1]),
              expected);
  }
}

TEST(Place_nodes, are_the_vertices_that_npbs_relax_makes)
{
  const paper::Domain domain = paper::l_shape(1);
  paper::CDT cdt = paper::triangulate(domain);
  const auto nodes = CGAL::npbs_place_nodes(cdt, CGAL::parameters::sizing_function(domain.d));
  EXPECT_EQ(cdt.number_of_vertices(), 6u);
  CGAL::npbs_relax(cdt, CGAL::parameters::sizing_function(domain.d));
  std::set<validation::Xy> expected = validation::snapshot(cdt).vertices, found;
  for (const paper::Point& p : nodes.points)
    found.insert({p.x(), p.y()});
  EXPECT_EQ(found, expected);
}

double falling_size(const paper::Point& p) { return 0.2 - 0.1 * p.x(); }

TEST(Place_nodes, the_size_may_be_a_plain_function)
{
  paper::CDT cdt;
  const std::vector<paper::Point> square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  cdt.insert_constraint(square.begin(), square.end(), true);
  const auto expected = CGAL::npbs_place_nodes(
    cdt, CGAL::parameters::sizing_function([](const paper::Point& p) { return falling_size(p); }));
  ASSERT_GT(expected.size(), 40u);
  EXPECT_EQ(CGAL::npbs_place_nodes(cdt, CGAL::parameters::sizing_function(falling_size)).points, expected.points);
  EXPECT_EQ(CGAL::npbs_place_nodes(cdt, CGAL::parameters::sizing_function(&falling_size)).points, expected.points);
  CGAL::npbs_relax(cdt, CGAL::parameters::number_of_rounds(5).sizing_function(falling_size));
  EXPECT_EQ(CGAL::mesh_quality_2(cdt, CGAL::parameters::sizing_function(falling_size)).number_of_vertices(),
            expected.size());
}

TEST(Place_nodes, dimensions)
{
  const paper::Domain domain = paper::non_convex(1);
  const paper::CDT cdt = paper::triangulate(domain);
  const auto nodes = CGAL::npbs_place_nodes(cdt, CGAL::parameters::sizing_function(domain.d));
  EXPECT_EQ(std::count(nodes.dimensions.begin(), nodes.dimensions.end(), 0), 11);
  // the outline is 7.83 long, d = 0.05; no interior node is nearer to another than half of d
  EXPECT_NEAR(double(std::count(nodes.dimensions.begin(), nodes.dimensions.end(), 1)), 7.83 / 0.05, 20);
  for (std::size_t i = 0; i < nodes.size(); ++i)
    for (std::size_t k = nodes.neighbor_offsets[i]; k < nodes.neighbor_offsets[i + 1]; ++k)
      EXPECT_GT(paper::distance(nodes.points[i], nodes.points[nodes.neighbors[k]].x(),
                                nodes.points[nodes.neighbors[k]].y()), 0.6 * 0.05);
}

} // namespace test_place_nodes
