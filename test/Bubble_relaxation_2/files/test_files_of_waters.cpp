// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// Files for models of oceans and rivers, whose boundaries are lists of nodes: each edge of the boundary is in one of
// them, in the right order.

#include "bays.h"
#include "domains.h"
#include "expect_throw.h"
#include "file_readers.h"

#include <CGAL/Bubble_relaxation_2/IO/2DM.h>
#include <CGAL/Bubble_relaxation_2/IO/ADCIRC.h>
#include <CGAL/npbs_relax.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace test_files_of_waters {

using CGAL::Mesh_arrays_2;
using file_readers::Words;
using file_readers::written;
using Edge = Mesh_arrays_2::Edge;
using Nodes = std::vector<std::size_t>;

/// A rectangle with two islands and a pier inside: 1 to the left, 5 to the right, 2 below, 3 above; islands have 6 and
/// 7, half of the second one 1, and the pier 9.
Mesh_arrays_2 sea()
{
  domains::CDT cdt = domains::make({{{0, 0}, {2, 0}, {2, 1}, {0, 1}},
                                    domains::square(0.3, 0.3, 0.3),
                                    domains::square(1.3, 0.3, 0.3)});
  domains::insert(cdt, {{0.9, 0.2}, {1.1, 0.8}}, false);
  CGAL::npbs_relax(cdt, 0.11);
  Mesh_arrays_2 mesh = cdt;
  for (std::size_t k = 0; k < mesh.edges.size(); ++k) {
    const auto p = CGAL::midpoint(mesh.points[mesh.edges[k][0]], mesh.points[mesh.edges[k][1]]);
    mesh.edge_markers[k] = p.x() == 0   ? 1
                           : p.x() == 2 ? 5
                           : p.y() == 0 ? 2
                           : p.y() == 1 ? 3
                           : p.x() < 0.7 ? 6
                           : p.x() < 1.2 ? 9
                           : p.x() < 1.31 ? 1
                                          : 7;
  }
  for (const auto& p : mesh.points)
    mesh.vertex_data["depth"].push_back(10 + p.x() / 3);
  return mesh;
}

struct Boundary
{
  std::string flags;
  Nodes nodes;
};

struct Ocean
{
  std::vector<Boundary> open, land;
};

/// numbers of the boundaries' nodes from 0
Ocean read_ocean(const Mesh_arrays_2& mesh, const std::string& text)
{
  Words words(text);
  words.expect("mesh");
  EXPECT_EQ(words.count(), mesh.triangles.size());
  EXPECT_EQ(words.count(), mesh.points.size());
  for (std::size_t k = 0; k < mesh.points.size(); ++k) {
    EXPECT_EQ(words.count(), k + 1);
    EXPECT_EQ(words.number(), mesh.points[k].x());
    EXPECT_EQ(words.number(), mesh.points[k].y());
    EXPECT_EQ(words.number(), mesh.vertex_data.at("depth")[k]);
  }
  for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
    EXPECT_EQ(words.count(), k + 1);
    words.expect("3");
    for (const std::size_t v : mesh.triangles[k])
      EXPECT_EQ(words.count(), v + 1);
  }
  Ocean ocean;
  for (auto* boundaries : {&ocean.open, &ocean.land}) {
    boundaries->resize(words.count());
    words.rest_of_line();
    const std::size_t total = words.count();
    words.rest_of_line();
    std::size_t sum = 0;
    for (Boundary& b : *boundaries) {
      b.nodes.resize(words.count());
      b.flags = words.next<std::string>();
      words.rest_of_line();
      for (std::size_t& v : b.nodes)
        v = words.count() - 1;
      sum += b.nodes.size();
    }
    EXPECT_EQ(sum, total);
  }
  EXPECT_TRUE(words.is_at_end());
  return ocean;
}

Ocean ocean_of(const Mesh_arrays_2& mesh, const std::set<int>& open, int land_type = 0)
{
  return read_ocean(mesh, written([&](std::ostream& out) { CGAL::IO::write_ADCIRC(out, mesh, open, land_type); }));
}

std::vector<Edge> edges_of(const Nodes& nodes, bool is_closed)
{
  std::vector<Edge> edges;
  for (std::size_t k = 1; k < nodes.size(); ++k)
    edges.push_back({nodes[k - 1], nodes[k]});
  if (is_closed)
    edges.push_back({nodes.back(), nodes.front()});
  return edges;
}

/// that each edge of the boundary is in one list, seen with the domain on the left
void expect_all_boundary(const Mesh_arrays_2& mesh, const Ocean& ocean, const std::set<std::string>& closed)
{
  std::vector<Edge> edges, expected = mesh.boundary_edges();
  for (const auto* boundaries : {&ocean.open, &ocean.land})
    for (const Boundary& b : *boundaries)
      for (const Edge& e : edges_of(b.nodes, boundaries == &ocean.land && closed.count(b.flags) > 0))
        edges.push_back(e);
  std::sort(edges.begin(), edges.end());
  std::sort(expected.begin(), expected.end());
  EXPECT_EQ(edges, expected);
}

double length(const Mesh_arrays_2& mesh, const std::vector<Edge>& edges)
{
  double sum = 0;
  for (const Edge& e : edges)
    sum += std::sqrt(CGAL::squared_distance(mesh.points[e[0]], mesh.points[e[1]]));
  return sum;
}

TEST(Files_of_waters, adcirc_with_one_open_boundary)
{
  const Mesh_arrays_2 mesh = sea();
  const Ocean ocean = ocean_of(mesh, {5});
  expect_all_boundary(mesh, ocean, {"1"});
  ASSERT_EQ(ocean.open.size(), 1u);
  const Nodes& open = ocean.open[0].nodes;
  EXPECT_EQ(mesh.points[open.front()], domains::Point(2, 0)); // counterclockwise
  EXPECT_EQ(mesh.points[open.back()], domains::Point(2, 1));
  ASSERT_EQ(ocean.land.size(), 3u);
  EXPECT_EQ(ocean.land[0].flags, "0");
  EXPECT_EQ(ocean.land[0].nodes.front(), open.back()); // they share their ends
  EXPECT_EQ(ocean.land[0].nodes.back(), open.front());
  EXPECT_NEAR(length(mesh, edges_of(ocean.land[0].nodes, false)), 5, 1e-12);
  for (std::size_t k : {1, 2}) {
    EXPECT_EQ(ocean.land[k].flags, "1");
    EXPECT_NE(ocean.land[k].nodes.front(), ocean.land[k].nodes.back());
    EXPECT_NEAR(length(mesh, edges_of(ocean.land[k].nodes, true)), 1.2, 1e-12);
  }
}

// the marker 1 is on both, and one island has an open side
TEST(Files_of_waters, adcirc_with_several_open_boundaries)
{
  const Mesh_arrays_2 mesh = sea();
  const Ocean ocean = ocean_of(mesh, {1, 5}, 20);
  expect_all_boundary(mesh, ocean, {"21"});
  EXPECT_EQ(ocean.open.size(), 3u);
  std::vector<std::string> flags;
  for (const Boundary& b : ocean.land)
    flags.push_back(b.flags);
  EXPECT_EQ(flags, (std::vector<std::string>{"20", "20", "20", "21"}));
}

TEST(Files_of_waters, adcirc_knows_all_open_markers)
{
  expect_invalid([] { ocean_of(sea(), {5, 42}); }, {"open_markers", "no edge of the boundary has the marker 42"});
}

TEST(Files_of_waters, a_file_stays_if_what_is_to_be_written_is_refused)
{
  const bays::Folder folder;
  const std::string name = folder / "fort.14";
  CGAL::IO::write_ADCIRC(name, sea(), {5});
  const auto size = std::filesystem::file_size(name);
  expect_invalid([&] { CGAL::IO::write_ADCIRC(name, sea(), {42}); }, {"open_markers"});
  expect_invalid([&] { CGAL::IO::write_ADCIRC(name, sea(), {5}, 7); }, {"land_type"});
  EXPECT_EQ(std::filesystem::file_size(name), size);
}

TEST(Files_of_waters, adcirc_needs_the_boundary_and_the_domain_on_its_left)
{
  const auto expect_refused = [](const Mesh_arrays_2& mesh, const std::string& words) {
    expect_invalid([&] { written([&](std::ostream& out) { CGAL::IO::write_ADCIRC(out, mesh); }); }, {words});
  };
  Mesh_arrays_2 mesh = sea();
  mesh.edges.clear();
  mesh.edge_markers.clear();
  expect_refused(mesh, "which one triangle has, is not among the edges");
  mesh = sea();
  std::swap(mesh.triangles[5][0], mesh.triangles[5][1]);
  expect_refused(mesh, "is clockwise");
}

TEST(Files_of_waters, adcirc_of_a_lake)
{
  const Mesh_arrays_2 mesh = sea();
  const Ocean ocean = ocean_of(mesh, {});
  EXPECT_TRUE(ocean.open.empty());
  ASSERT_EQ(ocean.land.size(), 3u);
  EXPECT_EQ(ocean.land[0].flags, "0");
  EXPECT_EQ(ocean.land[0].nodes.front(), ocean.land[0].nodes.back());
  expect_all_boundary(mesh, ocean, {"1"});
}

// all around open: the first node is not told twice
TEST(Files_of_waters, adcirc_of_an_island_in_the_ocean)
{
  const Mesh_arrays_2 mesh = sea();
  const Ocean ocean = ocean_of(mesh, {1, 2, 3, 5, 6, 7});
  EXPECT_EQ(ocean.open.size(), 3u);
  EXPECT_TRUE(ocean.land.empty());
  for (const Boundary& b : ocean.open)
    EXPECT_EQ(std::set<std::size_t>(b.nodes.begin(), b.nodes.end()).size(), b.nodes.size());
}

TEST(Files_of_waters, two_dm)
{
  Mesh_arrays_2 mesh = sea();
  for (const auto& t : mesh.triangles)
    mesh.regions.push_back(mesh.points[t[0]].x() < 1 ? 3 : 4);
  Words words(written([&](std::ostream& out) { CGAL::IO::write_2DM(out, mesh); }));
  for (const char* word : {"MESH2D", "NUM_MATERIALS_PER_ELEM", "1"})
    words.expect(word);
  for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
    words.expect("E3T");
    EXPECT_EQ(words.count(), k + 1);
    for (const std::size_t v : mesh.triangles[k])
      EXPECT_EQ(words.count(), v + 1);
    EXPECT_EQ(words.number(), mesh.regions[k]);
  }
  for (std::size_t k = 0; k < mesh.points.size(); ++k) {
    words.expect("ND");
    EXPECT_EQ(words.count(), k + 1);
    EXPECT_EQ(words.number(), mesh.points[k].x());
    EXPECT_EQ(words.number(), mesh.points[k].y());
    EXPECT_EQ(words.number(), -mesh.vertex_data["depth"][k]);
  }
  std::map<int, std::set<Edge>> found, expected;
  std::map<int, int> number_of_strings;
  Nodes nodes;
  while (!words.is_at_end()) {
    words.expect("NS");
    for (std::size_t in_line = 0; in_line < 10; ++in_line) {
      const long v = words.next<long>();
      nodes.push_back(static_cast<std::size_t>(std::labs(v)) - 1);
      if (v > 0)
        continue;
      const int marker = words.next<int>();
      for (const Edge& e : edges_of(nodes, false))
        EXPECT_TRUE(found[marker].insert({(std::min)(e[0], e[1]), (std::max)(e[0], e[1])}).second);
      ++number_of_strings[marker];
      nodes.clear();
      break;
    }
  }
  for (std::size_t k = 0; k < mesh.edges.size(); ++k)
    expected[mesh.edge_markers[k]].insert({(std::min)(mesh.edges[k][0], mesh.edges[k][1]),
                                           (std::max)(mesh.edges[k][0], mesh.edges[k][1])});
  EXPECT_EQ(found, expected);
  EXPECT_EQ(number_of_strings, (std::map<int, int>{{1, 2}, {2, 1}, {3, 1}, {5, 1}, {6, 1}, {7, 1}, {9, 1}}));
}

// an outline that touches itself: nothing is lost, though models of oceans will not take it
TEST(Files_of_waters, adcirc_of_an_island_at_the_coast)
{
  const domains::CDT cdt = domains::mesh({domains::square(0, 0, 1), {{0, 0.5}, {0.3, 0.3}, {0.3, 0.7}}}, 0.1);
  Mesh_arrays_2 mesh = cdt;
  mesh.vertex_data["depth"].assign(mesh.points.size(), 1);
  const Ocean ocean = ocean_of(mesh, {});
  expect_all_boundary(mesh, ocean, {"1"});
  EXPECT_EQ(ocean.land.size(), 2u);
}

} // namespace test_files_of_waters
