// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// The mesh of a domain in arrays has all that files keep of it, and says what does not belong together.

#include "bays.h"
#include "expect_throw.h"
#include "file_readers.h"

#include <CGAL/Bubble_relaxation_2/IO/MSH.h>
#include <CGAL/Mesh_arrays_2.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <map>
#include <string>
#include <vector>

namespace test_mesh_arrays {

using bays::Bay;
using bays::bay;
using CGAL::Mesh_arrays_2;
using file_readers::Mesh;
using file_readers::written;
using Cdt = domains::CDT;

namespace P = CGAL::parameters;

TEST(Mesh_arrays, have_what_the_domain_has)
{
  const Mesh_arrays_2 mesh = bay().mesh();
  std::map<int, double> length;
  for (std::size_t k = 0; k < mesh.edges.size(); ++k)
    length[mesh.edge_markers[k]] +=
      std::sqrt(CGAL::squared_distance(mesh.points[mesh.edges[k][0]], mesh.points[mesh.edges[k][1]]));
  EXPECT_EQ(length.size(), 5u);
  EXPECT_NEAR(length[5], 1000 / 3., 1e-6);
  EXPECT_NEAR(length[2], 5000 / 3., 1e-6);
  EXPECT_NEAR(length[4], 1000 / 3., 1e-6);
  EXPECT_NEAR(length[0], 800 / 3., 1e-6);
  std::map<double, double> area;
  for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
    const auto& t = mesh.triangles[k];
    area[mesh.regions[k]] += CGAL::area(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]);
  }
  EXPECT_NEAR(area[20], 1e6 / 9 * 0.96, 1e-4);
  EXPECT_EQ(area.size(), 2u);
  ASSERT_EQ(mesh.holes.size(), 2u);
  for (const auto& hole : mesh.holes)
    EXPECT_FALSE(bay().cdt.locate(hole)->is_in_domain());
  const auto boundary = mesh.boundary_edges();
  EXPECT_EQ(mesh.edges.size() - boundary.size(),
            static_cast<std::size_t>(std::count(mesh.edge_markers.begin(), mesh.edge_markers.end(), 4)));
  for (const auto& e : boundary) // as they are: with the domain on the left
    EXPECT_EQ(std::count(mesh.edges.begin(), mesh.edges.end(), e), 1);
}

TEST(Mesh_arrays, tell_which_vertices_their_points_are)
{
  std::vector<Cdt::Vertex_handle> vertices;
  const Mesh_arrays_2 mesh(bay().cdt, P::output_iterator(std::back_inserter(vertices)));
  ASSERT_EQ(vertices.size(), mesh.points.size());
  for (std::size_t k = 0; k < vertices.size(); ++k)
    EXPECT_EQ(vertices[k]->point(), mesh.points[k]);
}

// without markers the boundary has 1, as Triangle has it; with markers nothing is added to what the user says
TEST(Mesh_arrays, mark_the_boundary_where_there_are_no_markers)
{
  const Mesh_arrays_2 mesh = bay().cdt;
  for (std::size_t k = 0; k < mesh.edges.size(); ++k) {
    const auto turned = Mesh_arrays_2::Edge{mesh.edges[k][1], mesh.edges[k][0]};
    const auto boundary = mesh.boundary_edges();
    const bool is_boundary = std::count(boundary.begin(), boundary.end(), mesh.edges[k]) +
                               std::count(boundary.begin(), boundary.end(), turned) > 0;
    EXPECT_EQ(mesh.edge_markers[k], is_boundary);
  }
  EXPECT_TRUE(mesh.regions.empty());
  EXPECT_EQ(*std::max_element(mesh.vertex_markers.begin(), mesh.vertex_markers.end()), 1);
  EXPECT_EQ(*std::min_element(mesh.vertex_markers.begin(), mesh.vertex_markers.end()), 0);
}

// what lies between a domain and other constraints around it is outside of what is written, and no hole
TEST(Mesh_arrays, have_a_point_in_each_hole_and_none_outside)
{
  Cdt cdt = domains::make({domains::square(0, 0, 4), domains::square(1, 1, 2), domains::square(1.5, 1.5, 1),
                           domains::square(1.7, 1.7, 0.3)});
  const std::vector<domains::Point> between{{1.2, 1.2}};
  const Mesh_arrays_2 mesh(cdt, P::seeds(between).seeds_are_in_domain(true));
  EXPECT_EQ(mesh.edges.size(), 8u);
  ASSERT_EQ(mesh.holes.size(), 1u); // that in it is not written
  EXPECT_TRUE(1.5 < mesh.holes[0].x() && mesh.holes[0].x() < 2.5 && 1.5 < mesh.holes[0].y() && mesh.holes[0].y() < 2.5);
}

TEST(Mesh_arrays, number_names)
{
  const Bay<std::string, std::string> named("sea", "coast", "island", "", "sand", "rock");
  const Mesh_arrays_2 mesh = named.mesh();
  const std::map<int, std::string> markers{{1, "coast"}, {2, "island"}, {3, "sea"}};
  EXPECT_EQ(mesh.marker_names, markers);
  const std::map<double, std::string> regions{{1, "rock"}, {2, "sand"}};
  EXPECT_EQ(mesh.region_names, regions);
  const Mesh read = file_readers::Msh4_reader(written([&](std::ostream& out) { CGAL::IO::write_MSH(out, mesh); })).mesh;
  EXPECT_EQ(read.names.at({1, 3}), "sea");
  EXPECT_EQ(read.names.at({2, 1}), "rock");
}

TEST(Mesh_arrays, refuse_markers_that_are_no_integers)
{
  const Bay<double> bay(5, 2.5, 3, 4, 10, 20);
  expect_invalid([&] { bay.mesh(); }, {"edge_marker_map", "2.5"});
}

// as an int they would be others, such as 1
TEST(Mesh_arrays, refuse_markers_that_are_too_large)
{
  const Bay<std::int64_t> bay(5, 2, std::int64_t(4294967297), 4, 10, 20);
  expect_invalid([&] { bay.mesh(); }, {"edge_marker_map", "4294967297"});
}

/// two triangles, filled by hand
Mesh_arrays_2 square()
{
  Mesh_arrays_2 mesh;
  mesh.points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  mesh.edges = {{0, 1}, {1, 2}, {3, 2}, {3, 0}, {0, 2}};
  return mesh;
}

TEST(Mesh_arrays, that_are_filled_by_hand_need_no_markers_to_be_marked)
{
  Mesh_arrays_2 mesh = square();
  mesh.mark_boundary();
  EXPECT_EQ(mesh.edge_markers, (std::vector<int>{1, 1, 1, 1, 0}));
  EXPECT_EQ(mesh.vertex_markers, std::vector<int>(4, 1));
  EXPECT_NO_THROW(mesh.check());
  mesh = square();
  mesh.edges.push_back({2, 1});
  expect_invalid([&] { mesh.mark_boundary(); }, {"the edge of the points 1 and 2 comes twice"});
  mesh = square();
  mesh.edges.push_back({1, 1});
  expect_invalid([&] { mesh.mark_boundary(); }, {"one of edges has the point 1 twice"});
  mesh = square();
  mesh.triangles.push_back({3, 0, 3});
  expect_invalid([&] { mesh.mark_boundary(); }, {"one of triangles has the point 3 twice"});
  mesh = square();
  mesh.edges.push_back({0, 4});
  expect_invalid([&] { mesh.mark_boundary(); }, {"edges name the point 4 of 4"});
}

TEST(Mesh_arrays, refuse_elevations_and_holes_that_are_not_finite)
{
  Mesh_arrays_2 mesh = square();
  mesh.mark_boundary();
  mesh.elevations = {0, 1, std::numeric_limits<double>::infinity(), 2};
  expect_invalid([&] { mesh.check(); }, {"elevation inf must be finite"});
  mesh.elevations.clear();
  mesh.holes = {{0.5, std::numeric_limits<double>::quiet_NaN()}};
  expect_invalid([&] { mesh.check(); }, {"(0.5, nan) must be finite"});
}

} // namespace test_mesh_arrays
