// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// Parts of the treatment of defects that cannot be seen from outside: that it can be undone, and the energy it
// descends.

#include "distributed/bubbles.h"
#include "random_seeds.h"

#include <CGAL/Bubble_relaxation_2/internal/treatment/treat_defects.h>

#include <gtest/gtest.h>

namespace test_treatment_parts {

namespace internal = CGAL::Bubble_relaxation_2::internal;
using internal::Index;

void expect_equal(const internal::Marked_triangles_2& a, const internal::Marked_triangles_2& b)
{
  EXPECT_EQ(a.vertices, b.vertices);
  EXPECT_EQ(a.neighbors, b.neighbors);
  EXPECT_EQ(a.edges, b.edges);
  EXPECT_EQ(a.inside, b.inside);
}

TEST(Defects, treatment_can_be_undone)
{
  const bubbles::Case c = bubbles::random(paper::square_with_hole(1), 600, 0);
  internal::Bubble_mesh_2 mesh = bubbles::mesh_of(c);
  const internal::Bubbles_2& b = mesh.bubbles;
  const internal::Marked_triangles_2 before = mesh.triangles;
  internal::Team alone;
  internal::Smoothing_sweeps_2 treat(c.domain(), mesh, alone);
  EXPECT_GT(treat().size(), 100u);
  EXPECT_NE(b.x, c.bubbles.x);
  EXPECT_NE(b.s, c.bubbles.s);
  EXPECT_NE(b.host, c.bubbles.host);
  EXPECT_NE(mesh.triangles.vertices, before.vertices);
  EXPECT_NE(mesh.triangles.edges, before.edges);
  treat.undo();
  EXPECT_EQ(b.x, c.bubbles.x);
  EXPECT_EQ(b.y, c.bubbles.y);
  EXPECT_EQ(b.s, c.bubbles.s);
  EXPECT_EQ(b.host, c.bubbles.host);
  expect_equal(mesh.triangles, before);
}

TEST(Defects, triangles_that_were_cut_off_can_be_put_back)
{
  const bubbles::Case c = bubbles::random(paper::square_with_hole(1), 100, 0);
  internal::Bubble_mesh_2 mesh = bubbles::mesh_of(c);
  const internal::Marked_triangles_2 before = mesh.triangles;
  internal::Undo_log_2 log;
  internal::Editable_triangulation_2 editable(mesh, &log);
  for (std::size_t t = 0; t < mesh.triangles.inside.size(); t += 3)
    if (mesh.triangles.inside[t])
      editable.cut_off(static_cast<Index>(t));
  EXPECT_NE(mesh.triangles.neighbors, before.neighbors);
  EXPECT_NE(mesh.triangles.inside, before.inside);
  log.undo(mesh);
  expect_equal(mesh.triangles, before);
}

TEST(Defects, a_triangle_outside_that_is_turned_over_may_have_a_neighbor_twice)
{
  using internal::no_index;
  internal::Bubble_mesh_2 mesh;
  for (const internal::Point& p : {internal::Point(0.9, 0), internal::Point(1, 0.001), internal::Point(1, 2),
                                   internal::Point(1.1, 0)})
    mesh.bubbles.add(p, 1, internal::Bubbles_2::CORNER, static_cast<Index>(mesh.bubbles.size()));
  internal::Marked_triangles_2& m = mesh.triangles;
  m.vertices = {{0, 1, 2}, {3, 2, 1}, {0, 3, 1}}; // two inside, one below them outside
  m.neighbors = {{1, no_index, 2}, {0, 2, no_index}, {1, 0, no_index}};
  m.edges = {{no_index, 0, 1}, {no_index, 2, 3}, {2, 1, no_index}};
  m.inside = {1, 1, 0};
  internal::Editable_triangulation_2 editable(mesh);
  mesh.bubbles.y[1] = -0.01; // the lower vertex leaves the outline, so that the edge to it is flipped
  EXPECT_EQ(editable.restore_delaunay({1}), 1u);
  EXPECT_EQ(editable.star(1).size(), 2u);
  mesh.bubbles.y[1] = 0.001;
  EXPECT_EQ(editable.restore_delaunay({0, 3}), 1u);
  for (Index t = 0; t < 3; ++t)
    for (int i = 0; i < 3; ++i) {
      const Index n = m.neighbors[t][i];
      if (n == no_index)
        continue;
      for (Index v : {m.vertices[t][internal::ccw(i)], m.vertices[t][internal::cw(i)]})
        EXPECT_EQ(std::count(m.vertices[n].begin(), m.vertices[n].end(), v), 1) << t << ' ' << i;
    }
}

TEST(Defects, star_gradient_is_that_of_the_energy)
{
  internal::Star_quality_2 star(internal::Point(10, 20), 0.5);
  const std::vector<internal::Point> ring{{10.5, 20.1}, {10.2, 20.5}, {9.7, 20.3},
                                          {9.5, 19.9},  {9.9, 19.6},  {10.4, 19.5}};
  for (std::size_t i = 0; i < ring.size(); ++i)
    star.add(ring[i], ring[(i + 1) % ring.size()]);
  using Vector = internal::Star_quality_2::Vector;
  constexpr double h = 1e-5;
  for (const Vector& at : {Vector{0, 0}, Vector{0.1, -0.2}}) {
    const Vector g = star.gradient(at);
    EXPECT_NEAR(g.x, (star({at.x + h, at.y}).energy - star({at.x - h, at.y}).energy) / (2 * h),
                1e-6 * std::abs(g.x));
    EXPECT_NEAR(g.y, (star({at.x, at.y + h}).energy - star({at.x, at.y - h}).energy) / (2 * h),
                1e-6 * std::abs(g.y));
  }
  EXPECT_LT(star({2, 0}).smallest, 0);
  EXPECT_EQ(star({2, 0}).energy, std::numeric_limits<double>::infinity());
}

} // namespace test_treatment_parts
