// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// Parts of the treatment of defects that cannot be seen from outside: that it can be undone, the energy it descends, and
// that vertices inserted one by one make the triangulation of all.

#include "distributed/bubbles.h"
#include "random_seeds.h"

#include <CGAL/Bubble_relaxation_2/internal/treatment/treat_defects.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <stdexcept>
#include <vector>

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

/// two triangles inside, and one below them outside, which has been turned over: its vertex between them has moved down,
/// the edge from there has been flipped, and now it has one of them twice as its neighbour
internal::Bubble_mesh_2 turned_over()
{
  using internal::no_index;
  internal::Bubble_mesh_2 mesh;
  for (const internal::Point& p : {internal::Point(0.9, 0), internal::Point(1, 0.001), internal::Point(1, 2),
                                   internal::Point(1.1, 0)})
    mesh.bubbles.add(p, 1, internal::Bubbles_2::CORNER, static_cast<Index>(mesh.bubbles.size()));
  internal::Marked_triangles_2& m = mesh.triangles;
  m.vertices = {{0, 1, 2}, {3, 2, 1}, {0, 3, 1}};
  m.neighbors = {{1, no_index, 2}, {0, 2, no_index}, {1, 0, no_index}};
  m.edges = {{no_index, 0, 1}, {no_index, 2, 3}, {2, 1, no_index}};
  m.inside = {1, 1, 0};
  internal::Editable_triangulation_2 editable(mesh);
  mesh.bubbles.y[1] = -0.01;
  editable.restore_delaunay({1});
  EXPECT_EQ(editable.take_flipped().size(), 2u); // the triangles of one edge
  EXPECT_EQ(editable.star(1).size(), 2u);
  return mesh;
}

/// whether neighbours have the side between them
void expect_linked(const internal::Marked_triangles_2& m)
{
  for (std::size_t t = 0; t < m.number_of_triangles(); ++t)
    for (int i = 0; i < 3; ++i) {
      const Index n = m.neighbors[t][i];
      if (n == internal::no_index)
        continue;
      for (Index v : {m.vertices[t][internal::ccw(i)], m.vertices[t][internal::cw(i)]})
        EXPECT_EQ(std::count(m.vertices[n].begin(), m.vertices[n].end(), v), 1) << t << ' ' << i;
    }
}

TEST(Defects, a_triangle_outside_that_is_turned_over_may_have_a_neighbor_twice)
{
  internal::Bubble_mesh_2 mesh = turned_over();
  expect_linked(mesh.triangles);
  internal::Editable_triangulation_2 editable(mesh);
  mesh.bubbles.y[1] = 0.001;
  editable.restore_delaunay({0, 3});
  EXPECT_EQ(editable.take_flipped().size(), 2u);
  expect_linked(mesh.triangles);
}

TEST(Defects, the_neighbor_of_a_triangle_twice_may_be_replaced)
{
  using internal::no_index;
  internal::Bubble_mesh_2 mesh = turned_over();
  mesh.bubbles.add(internal::Point(1, -0.005), 1, internal::Bubbles_2::FACE, 0);
  const Index t = mesh.triangles.neighbors[2][0];
  ASSERT_EQ(mesh.triangles.neighbors[2][1], t);
  internal::Mesh_stitching_2 stitching(mesh);
  stitching.replace({t}, {{{0, 1, 4}, {no_index, no_index, 1}},
                          {{1, 3, 4}, {no_index, no_index, 2}},
                          {{3, 0, 4}, {no_index, no_index, no_index}}});
  EXPECT_NE(mesh.triangles.neighbors[2][0], mesh.triangles.neighbors[2][1]);
  expect_linked(mesh.triangles);
}

TEST(Defects, the_side_of_a_triangle_that_is_a_neighbor_twice_may_be_split)
{
  for (int side : {0, 1}) {
    internal::Bubble_mesh_2 mesh = turned_over();
    const internal::Marked_triangles_2& m = mesh.triangles;
    const Index t = m.neighbors[2][side];
    const int i = m.index_of_side(t, m.vertices[2][internal::ccw(side)], m.vertices[2][internal::cw(side)]);
    mesh.bubbles.add(CGAL::midpoint(mesh.point(t, internal::ccw(i)), mesh.point(t, internal::cw(i))), 1,
                     internal::Bubbles_2::EDGE, m.edges[t][i], 0.5);
    internal::Editable_triangulation_2(mesh).insert_on_side(4, t, i);
    EXPECT_EQ(m.neighbors[2][side], internal::no_index);
    EXPECT_NE(m.neighbors[2][1 - side], internal::no_index);
    expect_linked(m);
  }
}

/// what a triangle is, wherever it begins: its vertices, the smallest first, and the label and the vertex beyond of each side
using Described_triangle = std::array<Index, 9>;

std::vector<Described_triangle> triangles_of_domain(const internal::Bubble_mesh_2& mesh)
{
  const internal::Marked_triangles_2& m = mesh.triangles;
  std::vector<Described_triangle> result;
  for (std::size_t t = 0; t < m.inside.size(); ++t) {
    if (!m.inside[t])
      continue;
    const std::array<int, 3> corners = internal::corners_in_order(m, static_cast<Index>(t));
    Described_triangle d;
    for (std::size_t k = 0; k < 3; ++k) {
      const int i = corners[k];
      const Index n = m.neighbors[t][i];
      d[k] = m.vertices[t][i];
      d[3 + k] = m.edges[t][i];
      d[6 + k] = n == internal::no_index || !m.inside[n]
                   ? internal::no_index
                   : m.vertices[n][m.index_of_neighbor(n, static_cast<Index>(t))];
    }
    result.push_back(d);
  }
  std::sort(result.begin(), result.end());
  return result;
}

/// In each seventh triangle its centroid, and the middle of a side of each eighth, unless another one of its triangles or of
/// those at its vertices has one.
std::vector<internal::Steiner_point_2> points_to_insert(const bubbles::Case& c, const internal::Bubble_mesh_2& mesh)
{
  const internal::Marked_triangles_2& m = mesh.triangles;
  const internal::Bubbles_2& b = mesh.bubbles;
  std::vector<char> is_taken(b.size(), 0);
  std::vector<internal::Steiner_point_2> result;
  for (std::size_t k = 0; k < m.inside.size(); ++k) {
    const Index t = static_cast<Index>(k);
    const auto& v = m.vertices[k];
    if (!m.inside[k] || (k % 7 != 0 && k % 8 != 0) || is_taken[v[0]] || is_taken[v[1]] || is_taken[v[2]])
      continue;
    const int i = static_cast<int>(k % 3), after = internal::ccw(i), before = internal::cw(i);
    const internal::Point middle = CGAL::midpoint(mesh.point(t, after), mesh.point(t, before)),
                          centroid = CGAL::centroid(mesh.point(t, 0), mesh.point(t, 1), mesh.point(t, 2));
    Index hint = 0;
    internal::Steiner_point_2 p{0, centroid.x(), centroid.y(), 0, 0, c.domain().host_of(centroid, hint),
                                internal::Bubbles_2::FACE, t};
    if (k % 7 != 0 && m.edges[k][i] == internal::no_index) {
      p.x = middle.x();
      p.y = middle.y();
      p.host = c.domain().host_of(middle, hint);
    } else if (k % 7 != 0) {
      p.host = internal::edge_of_piece(c.domain(), b, v[after], v[before]);
      p.s = 0.5 * (internal::position_on(c.domain(), b, p.host, v[after]) +
                   internal::position_on(c.domain(), b, p.host, v[before]));
      p.x = c.domain().point_on_edge(p.host, p.s).x();
      p.y = c.domain().point_on_edge(p.host, p.s).y();
      p.dimension = internal::Bubbles_2::EDGE;
    }
    for (Index w : v)
      is_taken[w] = 1;
    result.push_back(p);
  }
  return result;
}

/// inserts them into the mesh of a case, and returns how many of them are on edges
std::size_t expect_the_triangulation_of_all(const bubbles::Case& c)
{
  internal::Bubble_mesh_2 mesh = bubbles::mesh_of(c);
  const std::vector<internal::Steiner_point_2> points = points_to_insert(c, mesh);
  EXPECT_GT(points.size(), c.bubbles.size() / 20);
  EXPECT_TRUE(internal::insert_points(c.domain(), c.input->problem().sizes, points, mesh));
  EXPECT_TRUE(internal::rebuild_outside(c.domain(), mesh));
  EXPECT_EQ(mesh.bubbles.size(), c.bubbles.size() + points.size());
  internal::Bubble_mesh_2 anew{mesh.bubbles, {}};
  internal::triangulate(c.domain(), anew);
  internal::label_edges(anew.triangles);
  EXPECT_EQ(triangles_of_domain(mesh), triangles_of_domain(anew));
  EXPECT_EQ(mesh.triangles.inside.size(), anew.triangles.inside.size());
  return static_cast<std::size_t>(std::count_if(points.begin(), points.end(), [](const internal::Steiner_point_2& p) {
    return p.dimension == internal::Bubbles_2::EDGE;
  }));
}

TEST(Defects, inserted_vertices_make_the_triangulation_of_all)
{
  for (unsigned seed = 0; seed < 5; ++seed) {
    SCOPED_TRACE(seed);
    EXPECT_GT(expect_the_triangulation_of_all(bubbles::random(paper::square_with_hole(1), 600, seed)), 0u);
  }
  expect_the_triangulation_of_all(bubbles::lattice(20)); // on sides, on circles of other vertices, on inner edges
}

TEST(Defects, no_vertex_is_inserted_where_one_is)
{
  const bubbles::Case c = bubbles::lattice(8);
  const internal::Bubble_mesh_2 mesh = bubbles::mesh_of(c);
  const auto begin = mesh.triangles.inside.begin();
  const Index t = static_cast<Index>(std::find(begin, mesh.triangles.inside.end(), 1) - begin);
  for (const internal::Point& p : {mesh.point(t, 0), internal::Point(-1, 4)}) {
    internal::Bubble_mesh_2 copy = mesh;
    EXPECT_FALSE(internal::insert_points(c.domain(), c.input->problem().sizes,
                                         {{0, p.x(), p.y(), 0, 0, 0, internal::Bubbles_2::FACE, t}}, copy));
  }
}

TEST(Defects, no_vertex_is_inserted_that_would_crowd_an_edge)
{
  const bubbles::Case c = bubbles::random(paper::square_with_hole(1), 100, 0);
  const internal::Bubble_mesh_2 mesh = bubbles::mesh_of(c);
  const internal::Marked_triangles_2& m = mesh.triangles;
  const internal::Bubbles_2& b = mesh.bubbles;
  std::size_t number = 0;
  for (std::size_t k = 0; k < m.inside.size(); ++k)
    for (int i = 0; i < 3; ++i) {
      const Index u = m.vertices[k][internal::ccw(i)], v = m.vertices[k][internal::cw(i)];
      if (!m.inside[k] || m.edges[k][i] == internal::no_index || !b.is_on_edge(u) || !b.is_on_edge(v))
        continue;
      for (double share : {0.5, 1e-6}) {
        const double s = b.s[u] + share * (b.s[v] - b.s[u]);
        const internal::Point p = c.domain().point_on_edge(b.host[u], s);
        internal::Bubble_mesh_2 copy = mesh;
        EXPECT_EQ(internal::insert_points(c.domain(), c.input->problem().sizes,
                                          {{0, p.x(), p.y(), s, 0, b.host[u], internal::Bubbles_2::EDGE,
                                            static_cast<Index>(k)}}, copy),
                  share == 0.5);
      }
      ++number;
    }
  EXPECT_GT(number, 4u);
}

/// The unit square and the bubbles on its corners.
struct Square
{
  internal::Domain_2 domain;
  internal::Bubble_mesh_2 mesh;

  Square()
  {
    const std::vector<internal::Point> corners{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    std::vector<internal::Domain_edge_2> edges;
    for (Index i = 0; i < 4; ++i) {
      edges.push_back({i, (i + 1) % 4, true, false});
      mesh.bubbles.add(corners[i], 1, internal::Bubbles_2::CORNER, i);
    }
    EXPECT_EQ(domain.build(corners, edges), internal::Marking_error::NONE);
  }
};

/// Where bubbles of an edge are so near to each other that they are beside it by more than their distance, triangles stay
/// as they should be when one passes another: also one that must stay, which looks like a corner in a patch.
TEST(Defects, no_bubble_slides_past_another_one_of_its_edge)
{
  using internal::Bubbles_2;
  for (const auto dimension : {Bubbles_2::EDGE, Bubbles_2::CORNER}) {
    Square square;
    Bubbles_2& b = square.mesh.bubbles;
    b.add({0.4, 0}, 1, Bubbles_2::EDGE, 0, 0.4); // would best be at 0.48
    b.add({0.5, -0.3}, 1, Bubbles_2::EDGE, 0, 0.45);
    const Index sliding = 4, other = 5;
    internal::triangulate(square.domain, square.mesh);
    b.dimension[other] = dimension;
    internal::Editable_triangulation_2 mesh(square.mesh);
    const internal::Vertex_smoothing_2 move(square.domain, 1);
    EXPECT_TRUE(move(mesh, b, sliding));
    for (int k = 0; k < 10; ++k)
      move(mesh, b, sliding);
    EXPECT_GT(b.s[sliding], 0.4);
    EXPECT_LT(b.s[sliding], b.s[other]);
  }
}

/// A piece of the outline ends at a bubble that is too far inside, and leaves another one outside.
TEST(Defects, a_bubble_that_a_bent_edge_leaves_outside_stays_a_vertex)
{
  using internal::Bubbles_2;
  Square square;
  const internal::Domain_2& domain = square.domain;
  internal::Bubble_mesh_2& mesh = square.mesh;
  mesh.bubbles.add({0.5, 1e-3}, 1, Bubbles_2::EDGE, 0, 0.5);
  mesh.bubbles.add({0.5, 5e-4}, 1, Bubbles_2::FACE, 0);
  mesh.bubbles.add({0.5, 0.5}, 1, Bubbles_2::FACE, 0);
  internal::triangulate(domain, mesh);
  EXPECT_TRUE(internal::rebuild_outside(domain, mesh));
  const std::vector<char> inside{1, 1, 1, 1, 1, 0, 1}, outside{1, 1, 0, 0, 1, 1, 0};
  EXPECT_EQ(internal::vertices_of_triangles(mesh.triangles, true, mesh.bubbles.size()), inside);
  EXPECT_EQ(internal::vertices_of_triangles(mesh.triangles, false, mesh.bubbles.size()), outside);

  mesh.bubbles.y[4] = 0; // it would have to come into the domain
  const internal::Marked_triangles_2 before = mesh.triangles;
  EXPECT_FALSE(internal::rebuild_outside(domain, mesh));
  expect_equal(mesh.triangles, before);
}

/// says at the end that the outline crosses itself
struct Treatment_found_broken : internal::Whole_treatment_2
{
  using Whole_treatment_2::Whole_treatment_2;
  bool closes_outline(Mesh&) const { return ++number_of_looks, false; }
  mutable int number_of_looks = 0;
};

/// one that finds that on the way
struct Treatment_that_throws : internal::Whole_treatment_2
{
  using Whole_treatment_2::Whole_treatment_2;
  void operate(Mesh& mesh, internal::Treatment_state& state) const
  {
    if (!state.care.is_careful)
      throw internal::Edges_too_near(problem().domain);
    Whole_treatment_2::operate(mesh, state);
  }
};

void expect_equal(const internal::Bubble_mesh_2& a, const internal::Bubble_mesh_2& b)
{
  EXPECT_EQ(a.bubbles.x, b.bubbles.x);
  EXPECT_EQ(a.bubbles.y, b.bubbles.y);
  EXPECT_EQ(a.bubbles.s, b.bubbles.s);
  EXPECT_EQ(triangles_of_domain(a), triangles_of_domain(b));
  EXPECT_EQ(a.triangles.inside.size(), b.triangles.inside.size());
}

void expect_equal(const internal::Treatment_counts& a, const internal::Treatment_counts& b)
{
  EXPECT_EQ(a.treated, b.treated);
  EXPECT_EQ(a.inserted, b.inserted);
  EXPECT_EQ(a.deleted, b.deleted);
}

TEST(Defects, all_is_done_carefully_once_more_when_the_outline_is_found_broken)
{
  for (unsigned seed = 0; seed < 3; ++seed) {
    SCOPED_TRACE(seed);
    const bubbles::Case c = bubbles::random(paper::square_with_hole(1), 600, seed);
    const internal::Problem_2 problem = c.input->problem();
    internal::Bubble_mesh_2 expected = bubbles::mesh_of(c), mesh = expected, other = expected;
    const Treatment_found_broken treatment(problem);
    const auto counts = treat_and_refine(internal::Whole_treatment_2(problem), expected);
    EXPECT_GT(counts.treated, 100u);
    EXPECT_GT(counts.inserted, 10u);
    expect_equal(treat_and_refine(treatment, mesh), counts);
    EXPECT_EQ(treatment.number_of_looks, 1);
    expect_equal(mesh, expected);
    expect_equal(treat_and_refine(Treatment_that_throws(problem), other), counts);
    expect_equal(other, expected);
  }
}

/// refines a mesh of which only the number of vertices is known, up to 13, one by one
struct Counting_treatment
{
  using Mesh = std::size_t;

  const internal::Problem_2& problem() const { throw std::logic_error("only a broken outline asks for it"); }
  bool is_to_be_refined(Mesh) const { return true; }
  bool is_stop_wanted() const { return false; }
  Mesh triangulated_anew(Mesh mesh) const { return mesh; }
  std::size_t number_of_bubbles(Mesh mesh) const { return mesh; }
  double smallest_free_sine(Mesh) const { return 0.5; }
  bool closes_outline(Mesh mesh) const { return mesh < 12; }

  std::vector<internal::Steiner_point_2> wanted_points(Mesh mesh) const
  {
    return std::vector<internal::Steiner_point_2>(mesh < 13 ? 1 : 0);
  }

  /// carefully, from the 12th vertex on the outline is seen to cross itself
  bool insert(const std::vector<internal::Steiner_point_2>& points, internal::Outline_care& care, Mesh& mesh) const
  {
    mesh += points.size();
    return care.allows(true, [&mesh] { return mesh < 12; });
  }
};

TEST(Defects, refinement_ends_before_it_breaks_the_outline)
{
  for (bool is_careful : {false, true}) {
    std::size_t mesh = 10;
    internal::Outline_care care{is_careful};
    EXPECT_EQ(internal::refine_small_angles(Counting_treatment(), mesh, care), is_careful ? 1u : 3u);
    EXPECT_EQ(mesh, is_careful ? 11u : 13u);
    EXPECT_EQ(care.has_changed_outline, !is_careful); // to be looked at
  }
}

/// a mesh of one triangle, which begins with any of its corners
internal::Bubble_mesh_2 triangle(double length, std::array<internal::Point, 3> corners, int first = 0)
{
  internal::Bubble_mesh_2 mesh;
  for (const internal::Point& p : corners)
    mesh.bubbles.add(internal::Point(length * p.x(), length * p.y()), length, internal::Bubbles_2::CORNER, internal::no_index);
  mesh.triangles.vertices.push_back({first, internal::ccw(first), internal::cw(first)});
  mesh.triangles.inside.push_back(1);
  return mesh;
}

// also of needles with all orientations
TEST(Defects, bounds_of_qualities_are_none_too_large)
{
  std::mt19937 engine(random_seeds::seed());
  std::uniform_real_distribution<double> coordinate(-1, 2), exponent(-90, 88);
  for (int k = 0; k < 3000; ++k) {
    std::array<internal::Point, 3> corners;
    for (internal::Point& p : corners)
      p = internal::Point(coordinate(engine), coordinate(engine));
    if (k % 2 == 0) { // nearly on a line
      const double along = coordinate(engine), beside = std::pow(10, exponent(engine) / 5);
      corners[2] = corners[0] + along * (corners[1] - corners[0]) +
                   (std::min)(beside, 1.) * (corners[1] - corners[0]).perpendicular(CGAL::LEFT_TURN);
    }
    const internal::Bubble_mesh_2 mesh = triangle(std::pow(10, exponent(engine)), corners, k % 3);
    const double q = internal::quality(mesh, 0);
    EXPECT_FALSE(internal::has_surely_more(mesh, 0, q));
    for (double least : {0.5 * q, q, std::nextafter(q, 2.), 0.83, 0.95})
      EXPECT_EQ(internal::has_quality(mesh, 0, least), q >= least) << least;
    const double sine = std::abs(internal::Smallest_angle_2(mesh, 0).sine);
    EXPECT_LE(q, internal::quality_of_isosceles(std::asin((std::min)(sine, 1.)) / 2) + 1e-12);
  }
}

TEST(Defects, bounds_of_qualities_tell_most)
{
  std::mt19937 engine(random_seeds::seed());
  std::uniform_real_distribution<double> shift(-0.1, 0.1);
  for (int k = 0; k < 100; ++k) {
    const internal::Point tip(0.5 + shift(engine), 0.866 + shift(engine));
    EXPECT_TRUE(internal::has_surely_more(triangle(1, {internal::Point(0, 0), internal::Point(1, 0), tip}), 0, 0.9));
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
  EXPECT_EQ(star({0, 0}).smallest_worth, star({0, 0}).smallest); // none is obtuse
  EXPECT_EQ(star({2, 0}).energy, std::numeric_limits<double>::infinity());
}

TEST(Defects, the_last_sweeps_take_in_more_where_the_outline_asks_for_many_bubbles)
{
  const bubbles::Case c = bubbles::random(paper::square_with_hole(1), 100, 0);
  const internal::Relaxation_options options;
  internal::Sizes_2 any_size([](double, double) { return 1.; });
  internal::Problem_2 problem{c.domain(), c.given(), options, any_size, any_size};
  problem.wanted.expected_number = 100;
  for (double number : {100., 125.}) {
    problem.sizes.expected_number = number;
    EXPECT_FALSE(problem.follows_outline());
    EXPECT_EQ(internal::sweeps_after_surgery(problem).treated_quality, 0.95);
  }
  problem.sizes.expected_number = 126;
  EXPECT_TRUE(problem.follows_outline());
  EXPECT_EQ(internal::sweeps_after_surgery(problem).treated_quality, 0.98);
}

TEST(Defects, an_obtuse_triangle_is_worth_less_but_no_q_falls_for_that)
{
  using Star = internal::Star_quality_2;
  for (double x : {-0.5, 0.3, 0.5, 0.7, 1.5}) {
    Star star(internal::Point(0, 0), 1);
    star.add(internal::Point(0, 0), internal::Point(1, 0));
    const Star::Value v = star({x, 0.4}); // a right angle would be at a height of at least sqrt(x (1 - x))
    EXPECT_EQ(v.smallest_worth, 0.95 * v.smallest) << x;
    const Star::Value right = star({0, 1});
    EXPECT_EQ(right.smallest_worth, right.smallest);
  }
  const Star::Value now{0.5, 0.475, 10};
  EXPECT_TRUE((Star::Value{0.5, 0.5, 9}.is_better_than(now)));
  EXPECT_FALSE((Star::Value{0.48, 0.48, 9}.is_better_than(now)));
  EXPECT_FALSE((Star::Value{0.51, 0.474, 9}.is_better_than(now)));
  EXPECT_FALSE((Star::Value{0.5, 0.475, 10}.is_better_than(now)));
}

} // namespace test_treatment_parts
