// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// Markers of constraints and regions of faces go through meshing: exactly, for several triangulations, and however
// often.

#include "domains.h"
#include "expect_throw.h"
#include "random_seeds.h"
#include "rough_outlines.h"
#include "validation.h"

#include <CGAL/Constrained_triangulation_plus_2.h>
#include <CGAL/Constraint_marker_map_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Face_region_map_2.h>
#include <CGAL/Region_sizing_field_2.h>
#include <CGAL/npbs_adapt.h>
#include <CGAL/npbs_place_nodes.h>
#include <CGAL/npbs_relax.h>
#include <CGAL/simplify_outline_2.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace test_tags {

using domains::K;
using domains::Outline;

namespace P = CGAL::parameters;

using Plus = CGAL::Constrained_triangulation_plus_2<domains::CDT>;
using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
using Exact_cdt = domains::Cdt_of<Exact>;
using Unmarked_cdt = CGAL::Constrained_Delaunay_triangulation_2<K>; // its faces cannot be marked

template <class Cdt>
double x_of(typename Cdt::Vertex_handle v)
{
  return CGAL::to_double(v->point().x());
}

template <class Cdt>
double y_of(typename Cdt::Vertex_handle v)
{
  return CGAL::to_double(v->point().y());
}

/// A rectangle of two squares, side by side: an inner wall between them, a marker that changes in the middle of
/// the straight bottom, and a vertex there that only splits the top.
template <class Cdt>
struct Channel
{
  using Vertex = typename Cdt::Vertex_handle;

  Cdt cdt;
  CGAL::Constraint_marker_map_2<Cdt, std::string> markers{"none"};
  CGAL::Face_region_map_2<Cdt, double> regions;

  explicit Channel(bool has_more = false)
  {
    const auto add = [&](double x, double y) { return cdt.insert(typename Cdt::Point(x, y)); };
    const Vertex a = add(0, 0), change = add(0.7, 0), b = add(1, 0), c = add(2, 0), d = add(2, 1), e = add(1, 1),
                 split = add(0.375, 1), f = add(0, 1);
    insert(a, change, "sand");
    insert(change, b, "rock");
    insert(b, c, "rock");
    insert(c, d, "outflow");
    insert(d, e, "wall");
    insert(e, split, "wall");
    insert(split, f, "wall");
    insert(f, a, "inflow");
    insert(b, e, "sieve");
    if (has_more) // then the mesh is inserted, not written as it is
      insert(add(5, 5), add(6, 5), "quay");
    for (auto face : cdt.finite_face_handles())
      regions.set(face, is_left(face) ? 10 : 20);
  }

  void insert(Vertex u, Vertex v, const char* marker)
  {
    cdt.insert_constraint(u, v);
    markers.set(u, v, marker);
  }

  static bool is_left(typename Cdt::Face_handle f)
  {
    return x_of<Cdt>(f->vertex(0)) + x_of<Cdt>(f->vertex(1)) + x_of<Cdt>(f->vertex(2)) < 3;
  }

  static bool is_outside(typename Cdt::Face_handle f)
  {
    return y_of<Cdt>(f->vertex(0)) + y_of<Cdt>(f->vertex(1)) + y_of<Cdt>(f->vertex(2)) > 3;
  }

  auto maps() const { return P::edge_marker_map(markers).face_region_map(regions); }

  std::string expected(Vertex u, Vertex v) const
  {
    const double x = (x_of<Cdt>(u) + x_of<Cdt>(v)) / 2, y = (y_of<Cdt>(u) + y_of<Cdt>(v)) / 2;
    if (y > 1)
      return "quay";
    return y == 0 ? (x < 0.7 ? "sand" : "rock") : y == 1 ? "wall" : x == 0 ? "inflow" : x == 2 ? "outflow" : "sieve";
  }

  std::set<validation::Xy> vertices() const
  {
    std::set<validation::Xy> result;
    for (auto v : cdt.finite_vertex_handles())
      result.insert(validation::xy(v));
    return result;
  }

  bool has_vertex(double x, double y) const { return vertices().count({x, y}) > 0; }

  /// of the faces that are not of the domain, in order
  std::vector<double> regions_outside() const
  {
    std::vector<double> result;
    for (auto f : cdt.finite_face_handles())
      if (is_outside(f))
        result.push_back(regions(f));
    return result;
  }

  void expect_tags_of_mesh() const
  {
    std::map<std::string, double> lengths;
    std::map<double, double> areas;
    for (auto e = cdt.finite_edges_begin(); e != cdt.finite_edges_end(); ++e) {
      if (!cdt.is_constrained(*e))
        continue;
      const Vertex u = e->first->vertex(Cdt::ccw(e->second)), v = e->first->vertex(Cdt::cw(e->second));
      const std::string marker = markers(v, u);
      EXPECT_EQ(marker, expected(u, v));
      lengths[marker] += std::hypot(x_of<Cdt>(u) - x_of<Cdt>(v), y_of<Cdt>(u) - y_of<Cdt>(v));
    }
    for (auto f : cdt.finite_face_handles())
      if (!is_outside(f)) {
        EXPECT_EQ(regions(f), is_left(f) ? 10 : 20);
        areas[regions(f)] += CGAL::to_double(cdt.triangle(f).area());
      }
    EXPECT_EQ(lengths.size(), 6u + lengths.count("quay"));
    EXPECT_NEAR(lengths["sand"], 0.7, 1e-12);
    EXPECT_NEAR(lengths["rock"], 1.3, 1e-12);
    EXPECT_NEAR(lengths["wall"], 2, 1e-12);
    for (const char* one : {"inflow", "outflow", "sieve"})
      EXPECT_NEAR(lengths[one], 1, 1e-12);
    EXPECT_NEAR(areas[10], 1, 1e-12);
    EXPECT_NEAR(areas[20], 1, 1e-12);
  }
};

template <class Cdt>
class Tags : public testing::Test
{};

using Triangulations = testing::Types<domains::CDT, Plus, Exact_cdt, Unmarked_cdt>;

TYPED_TEST_SUITE(Tags, Triangulations);

TYPED_TEST(Tags, go_through_refining_and_coarsening)
{
  for (bool has_more : {false, true}) {
    Channel<TypeParam> channel(has_more);
    for (double d : {0.1, 0.04, 0.3, 0.07}) {
      SCOPED_TRACE(d);
      const auto report = CGAL::npbs_relax(channel.cdt, channel.maps().sizing_function(d));
      EXPECT_TRUE(channel.has_vertex(0.7, 0));
      // a hierarchy knows that the user gave it as an end
      EXPECT_EQ(channel.has_vertex(0.375, 1), (std::is_same<TypeParam, Plus>::value));
      EXPECT_GE(report.quality.minimum_quality(), 0.6);
      channel.expect_tags_of_mesh();
    }
  }
}

TYPED_TEST(Tags, change_nothing_of_a_mesh_but_where_they_change)
{
  Channel<TypeParam> with, without;
  std::set<typename TypeParam::Vertex_handle> pins;
  for (auto v : without.cdt.finite_vertex_handles())
    if (x_of<TypeParam>(v) == 0.7)
      pins.insert(v);
  const auto pinned = CGAL::make_boolean_property_map(pins);
  CGAL::npbs_relax(with.cdt, with.maps().sizing_function(0.1));
  CGAL::npbs_relax(without.cdt, P::vertex_is_constrained_map(pinned).sizing_function(0.1));
  EXPECT_GT(with.vertices().size(), 200u);
  EXPECT_TRUE(with.vertices() == without.vertices());
}

// markers go through circles around sharp corners, and refinement for small angles
TEST(Tags_of_outlines, with_sharp_corners_and_narrows)
{
  using Cdt = domains::CDT;
  Cdt cdt;
  const Outline outline{{0, 0}, {3, 0.1}, {1, 0.5}, {3, 0.6}, {0.9, 0.97}, {1, 1}, {0, 1.1}};
  std::vector<Cdt::Vertex_handle> corners;
  for (const domains::Point& p : domains::points_of(outline))
    corners.push_back(cdt.insert(p));
  std::map<std::pair<Cdt::Vertex_handle, Cdt::Vertex_handle>, int> markers;
  std::vector<double> expected, found(outline.size(), 0);
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const auto u = corners[k], v = corners[(k + 1) % corners.size()];
    cdt.insert_constraint(u, v);
    markers[CGAL::make_sorted_pair(u, v)] = static_cast<int>(k);
    expected.push_back(std::sqrt(CGAL::squared_distance(u->point(), v->point())));
  }
  CGAL::npbs_relax(cdt, P::sizing_function(0.2).edge_marker_map(boost::make_assoc_property_map(markers)));
  EXPECT_GT(cdt.number_of_vertices(), 100u);
  for (const auto& e : cdt.constrained_edges()) {
    const auto u = e.first->vertex(Cdt::ccw(e.second)), v = e.first->vertex(Cdt::cw(e.second));
    found[static_cast<std::size_t>(markers.at(CGAL::make_sorted_pair(u, v)))] +=
      std::sqrt(CGAL::squared_distance(u->point(), v->point()));
  }
  for (std::size_t k = 0; k < expected.size(); ++k)
    EXPECT_NEAR(found[k], expected[k], 1e-12) << k;
}

/// inserts a ring whose segment k gets `marker(k)`; returns its vertices
template <class Marker_of>
std::vector<domains::CDT::Vertex_handle> insert(domains::CDT& cdt, CGAL::Constraint_marker_map_2<domains::CDT>& markers,
                                                const Outline& ring, const Marker_of& marker)
{
  std::vector<domains::CDT::Vertex_handle> v;
  for (const domains::Point& p : domains::points_of(ring))
    v.push_back(cdt.insert(p));
  for (std::size_t k = 0; k < v.size(); ++k) {
    cdt.insert_constraint(v[k], v[(k + 1) % v.size()]);
    markers.set(cdt, v[k], v[(k + 1) % v.size()], marker(k));
  }
  return v;
}

// pieces have the markers of what they stand for, and a vertex stays where these change
TEST(Tags_of_outlines, go_to_simplified_ones)
{
  domains::CDT cdt;
  CGAL::Constraint_marker_map_2<domains::CDT> markers;
  const auto shore =
    insert(cdt, markers, rough_outlines::coast(0, 0, 1, 300, 1), [](std::size_t k) { return k < 100 ? 1 : 2; });
  insert(cdt, markers, rough_outlines::coast(0.4, 0.1, 0.2, 90, 2), [](std::size_t) { return 3; });
  insert(cdt, markers, rough_outlines::coast(-0.3, 0.1, 0.02, 30, 3), [](std::size_t) { return 4; });
  const domains::Point first = shore[0]->point(), second = shore[100]->point();
  const auto report = CGAL::simplify_outline_2(
    cdt, P::sizing_function(0.1).minimum_island_area(0.01).edge_marker_map(markers));
  EXPECT_EQ(report.dropped_islands.size(), 1u);
  EXPECT_LT(report.number_of_segments, 150u);
  std::map<int, std::map<domains::Point, int>> pieces; // at each vertex, of each marker
  for (const auto& e : cdt.constrained_edges()) {
    const auto u = e.first->vertex(cdt.ccw(e.second)), v = e.first->vertex(cdt.cw(e.second));
    ++pieces[markers(u, v)][u->point()];
    ++pieces[markers(u, v)][v->point()];
  }
  ASSERT_EQ(pieces.size(), 3u); // nobody has the marker of the island that is gone, or none
  for (int marker : {1, 2})
    for (const auto& [point, number] : pieces.at(marker))
      EXPECT_EQ(number, point == first || point == second ? 1 : 2) << marker << " at " << point;
  EXPECT_EQ(pieces[1].count(first) + pieces[1].count(second), 2u);
  for (const auto& [point, number] : pieces.at(3))
    EXPECT_LT(std::hypot(point.x() - 0.4, point.y() - 0.1), 0.3) << number;
}

TEST(Tags_of_outlines, where_a_gap_is_filled_are_those_beside_it)
{
  domains::CDT cdt;
  CGAL::Constraint_marker_map_2<domains::CDT> markers;
  const Outline bay{{0, 0}, {10, 0}, {10, 5}, {13, 5}, {13, 5.5}, {10, 5.5}, {10, 10}, {0, 10}}; // open to the west
  insert(cdt, markers, bay, [](std::size_t k) { return k == 7 ? 1 : 2; });
  for (double x : {2., 4.3}) // islands with a narrow between them
    insert(cdt, markers, domains::square(x, 4, 2), [](std::size_t) { return 3; });
  const auto report = CGAL::simplify_outline_2(cdt, P::sizing_function(1.).minimum_gap(0.8).edge_marker_map(markers));
  EXPECT_EQ(report.filled_gaps.size(), 2u);
  EXPECT_TRUE(std::any_of(report.pieces.begin(), report.pieces.end(), [](const auto& p) { return p.is_new; }));
  for (const auto& e : cdt.constrained_edges()) {
    const auto u = e.first->vertex(cdt.ccw(e.second)), v = e.first->vertex(cdt.cw(e.second));
    const domains::Point p = CGAL::midpoint(u->point(), v->point());
    const bool is_of_islands = p.x() > 1 && p.x() < 9 && p.y() > 1 && p.y() < 9;
    EXPECT_EQ(markers(u, v), is_of_islands ? 3 : p.x() < 0.1 ? 1 : 2) << p;
  }
}

TEST(Tags_of_nodes, a_node_stays_where_the_marker_changes)
{
  Channel<domains::CDT> channel;
  const auto is_there = [](const auto& nodes) {
    return std::count(nodes.points.begin(), nodes.points.end(), domains::Point(0.7, 0));
  };
  EXPECT_EQ(is_there(CGAL::npbs_place_nodes(channel.cdt, channel.maps().sizing_function(0.15))), 1);
  EXPECT_EQ(is_there(CGAL::npbs_place_nodes(channel.cdt, 0.15)), 0);
}

TEST(Tags_in_vain, regions_that_no_constraint_parts)
{
  Channel<domains::CDT> channel;
  channel.regions.set(channel.cdt.locate(domains::Point(0.5, 0.01)), 30);
  const validation::Snapshot before = validation::snapshot(channel.cdt);
  expect_invalid([&] { CGAL::npbs_relax(channel.cdt, channel.maps().sizing_function(0.1)); },
                 {"parameter face_region_map: the edge from (", "between two regions and must be constrained"});
  EXPECT_TRUE(validation::snapshot(channel.cdt) == before);
}

struct Failing_map
{
  using key_type = domains::CDT::Face_handle;
  using value_type = int;
  using reference = int;
  using category = boost::read_write_property_map_tag;

  bool fails_in_get;

  friend int get(const Failing_map& map, key_type)
  {
    if (map.fails_in_get)
      throw std::domain_error("get");
    return 1;
  }

  friend void put(const Failing_map&, key_type, int) { throw std::domain_error("put"); }
};

TEST(Tags_in_vain, exceptions_of_maps_leave_the_triangulation)
{
  Channel<domains::CDT> channel;
  const validation::Snapshot before = validation::snapshot(channel.cdt);
  for (bool fails_in_get : {true, false}) {
    EXPECT_THROW(
      CGAL::npbs_relax(channel.cdt, P::face_region_map(Failing_map{fails_in_get}).sizing_function(0.1)),
      std::domain_error);
    EXPECT_TRUE(validation::snapshot(channel.cdt) == before);
  }
}

/// A map that fails after so many calls of `get()` or of `put()`; never where that is null.
template <class Map>
struct Failing_later
{
  using key_type = typename Map::key_type;
  using value_type = typename Map::value_type;
  using reference = value_type;
  using category = boost::read_write_property_map_tag;

  const Map* map;
  int *gets_left, *puts_left;

  static void count(int* left)
  {
    if (left != nullptr && (*left)-- == 0)
      throw std::domain_error("too many calls");
  }

  friend value_type get(const Failing_later& m, const key_type& key)
  {
    count(m.gets_left);
    return get(*m.map, key);
  }
  friend void forget(const Failing_later& m, const key_type& key) { forget(*m.map, key); }
  friend void put(const Failing_later& m, const key_type& key, const value_type& value)
  {
    count(m.puts_left);
    put(*m.map, key, value);
  }
};

TYPED_TEST(Tags, come_back_when_a_change_fails)
{
  for (bool has_more : {false, true})
    for (int puts : {0, 40}) {
      Channel<TypeParam> channel(has_more);
      CGAL::npbs_relax(channel.cdt, channel.maps().sizing_function(0.2));
      for (auto f : channel.cdt.finite_face_handles())
        if (channel.is_outside(f))
          channel.regions.set(f, 30);
      const std::vector<double> outside = channel.regions_outside();
      EXPECT_EQ(outside.empty(), !has_more);
      int left = puts;
      using Regions = decltype(channel.regions);
      const Failing_later<Regions> failing{&channel.regions, nullptr, &left};
      const auto np = P::edge_marker_map(channel.markers).face_region_map(failing).sizing_function(0.1);
      EXPECT_THROW(CGAL::npbs_relax(channel.cdt, np), std::domain_error);
      channel.expect_tags_of_mesh();
      EXPECT_EQ(channel.regions_outside(), outside);
    }
}

TYPED_TEST(Tags, exceptions_before_a_change_change_nothing)
{
  Channel<TypeParam> channel(true);
  const auto handles = [&channel] {
    std::vector<typename TypeParam::Vertex_handle> result;
    for (auto v : channel.cdt.finite_vertex_handles())
      result.push_back(v);
    return result;
  };
  const auto before = handles();
  bool is_done = false;
  for (int gets = 0; !is_done; ++gets) {
    int left = gets;
    using Markers = decltype(channel.markers);
    try {
      CGAL::npbs_relax(channel.cdt, P::edge_marker_map(Failing_later<Markers>{&channel.markers, &left, nullptr})
                                      .face_region_map(channel.regions)
                                      .sizing_function(0.5));
      is_done = true;
      EXPECT_GT(gets, 20); // when it is read, and before it is written
    } catch (const std::domain_error&) {
      ASSERT_TRUE(handles() == before);
    }
    channel.expect_tags_of_mesh();
  }
}

TYPED_TEST(Tags, come_back_after_a_stop)
{
  Channel<TypeParam> channel;
  CGAL::npbs_relax(channel.cdt, channel.maps().sizing_function(0.2));
  const validation::Snapshot before = validation::snapshot(channel.cdt);
  double most = 0;
  for (double stop : {0.9, 0.97, 1.}) {
    const auto to_be_stopped = channel.maps().sizing_function(0.05).restore_when_stopped(true);
    CGAL::npbs_relax(channel.cdt, to_be_stopped.callback([&](double x) {
      most = (std::max)(most, x);
      return x < stop;
    }));
    EXPECT_TRUE(validation::snapshot(channel.cdt) == before);
    channel.expect_tags_of_mesh();
  }
  EXPECT_EQ(most, 1);
}

TYPED_TEST(Tags, go_through_local_changes)
{
  Channel<TypeParam> channel;
  CGAL::npbs_relax(channel.cdt, channel.maps().sizing_function(0.1));
  std::set<validation::Xy> old = channel.vertices();
  for (const double x : {0.7, 1., 0., 1.9}) { // where the marker changes, beside the wall, at both ends
    SCOPED_TRACE(x);
    const auto d = [x](const auto& p) {
      return std::min(0.1, 0.02 + 0.2 * std::hypot(CGAL::to_double(p.x()) - x, CGAL::to_double(p.y())));
    };
    const auto report = CGAL::npbs_adapt(channel.cdt, channel.maps().sizing_function(d));
    EXPECT_GT(report.number_of_vertices, 0u);
    EXPECT_TRUE(channel.has_vertex(0.7, 0));
    channel.expect_tags_of_mesh();
    EXPECT_NE(channel.vertices().size(), old.size());
    old = channel.vertices();
  }
}

TEST(Tag_maps, tell_edges_on_a_line_and_faces_of_a_region)
{
  Channel<domains::CDT> channel;
  domains::CDT& cdt = channel.cdt;
  CGAL::Constraint_marker_map_2<domains::CDT> markers(-1);
  const auto at = [&](double x, double y) { return cdt.insert(domains::Point(x, y)); };
  markers.set(cdt, at(2, 1), at(0, 1), 5);
  EXPECT_EQ(markers(at(1, 1), at(2, 1)), 5);
  EXPECT_EQ(markers(at(1, 1), at(0.375, 1)), 5);
  EXPECT_EQ(markers(at(0, 1), at(0.375, 1)), 5);
  EXPECT_EQ(markers(at(0, 1), at(0, 0)), -1);
  for (const auto& line : {std::pair(at(1, 0), at(2, 1)), std::pair(at(2, 0), at(1, 1))}) // one is an edge
    expect_invalid([&] { markers.set(cdt, line.first, line.second, 6); }, {"no constraint leads straight on"});
  CGAL::Face_region_map_2<domains::CDT> regions;
  regions.set_all_around(cdt.locate(domains::Point(0.5, 0.5)), 7);
  for (auto f : cdt.finite_face_handles())
    EXPECT_EQ(regions(f), channel.is_left(f) ? 7 : 0);
  markers.clear();
  EXPECT_EQ(markers(at(1, 1), at(2, 1)), -1);
  const CGAL::Face_region_map_2<domains::CDT> copy = regions; // they share what they hold
  regions.clear();
  for (auto f : cdt.finite_face_handles())
    EXPECT_EQ(copy(f), 0);
}

/// mean lengths of edges whose middle lies left and right of `x`, but for those near to it
template <class Cdt>
std::pair<double, double> mean_lengths(const Cdt& cdt, double x, double near)
{
  double sum[2] = {0, 0}, count[2] = {0, 0};
  for (auto e = cdt.finite_edges_begin(); e != cdt.finite_edges_end(); ++e) {
    const auto s = cdt.segment(*e);
    const double middle = (CGAL::to_double(s.source().x()) + CGAL::to_double(s.target().x())) / 2;
    if (std::abs(middle - x) < near)
      continue;
    sum[middle > x] += std::sqrt(CGAL::to_double(s.squared_length()));
    ++count[middle > x];
  }
  return {sum[0] / count[0], sum[1] / count[1]};
}

/// The crossing of two constraints is rounded, so it lies on neither line.
TEST(Tag_maps, lines_that_a_rounding_has_bent)
{
  using Crossing = CGAL::Constrained_triangulation_plus_2<domains::Cdt_of<K, CGAL::Exact_predicates_tag>>;
  Crossing cdt;
  const auto a = cdt.insert(domains::Point(0, 0)), b = cdt.insert(domains::Point(10, 0.1)),
             c = cdt.insert(domains::Point(3, -5)), d = cdt.insert(domains::Point(7.7, 2.3));
  cdt.insert_constraint(a, b);
  const Crossing::Constraint_id second = cdt.insert_constraint(c, d);
  const CGAL::Constraint_marker_map_2<Crossing> markers(0);
  expect_invalid([&] { markers.set(cdt, c, d, 5); }, {"straight on from", "(7.7, 2.3)", "rounded"});
  EXPECT_EQ(cdt.number_of_vertices(), 5u);
  const auto marked = [&] {
    double length = 0;
    for (const Crossing::Edge& e : cdt.constrained_edges())
      if (markers(e.first->vertex(Crossing::ccw(e.second)), e.first->vertex(Crossing::cw(e.second))) == 5)
        length += std::sqrt(cdt.segment(e).squared_length());
    return length;
  };
  EXPECT_EQ(marked(), 0);
  markers.set(cdt, second, 5);
  EXPECT_NEAR(marked(), std::hypot(4.7, 7.3), 1e-12);
}

TYPED_TEST(Tags, sizes_of_regions)
{
  Channel<TypeParam> channel;
  using Field = CGAL::Region_sizing_field_2<TypeParam>;
  using Place = typename TypeParam::Point;
  const Field field(channel.cdt, channel.regions, [](double region) { return region == 10 ? 0.04 : 0.12; });
  EXPECT_EQ(field(Place(0.5, 0.5)), 0.04);
  EXPECT_EQ(field(Place(1.5, 0.01)), 0.12);
  for (double x : {1., std::nextafter(1, 0), std::nextafter(1, 2)}) // on both, up to rounding
    for (double y : {0., 0.3, 1.})
      EXPECT_EQ(field(Place(x, y)), 0.04);
  EXPECT_EQ(field(Place(-3, 0.5)), 0.04);
  EXPECT_EQ(field(Place(7, 0.5)), 0.12);
  for (int time = 0; time < 2; ++time) { // from the outline, and from the mesh
    const auto report = CGAL::npbs_relax(channel.cdt, channel.maps().sizing_function(field));
    channel.expect_tags_of_mesh();
    const auto [left, right] = mean_lengths(channel.cdt, 1, 0.2);
    EXPECT_NEAR(left, 0.04, 0.002);
    EXPECT_NEAR(right, 0.12, 0.02);
    EXPECT_GE(report.quality.minimum_quality(), 0.5);
  }
}

TEST(Region_sizing_field, is_the_same_in_any_order_of_insertion)
{
  // a bay between two regions: places in it are as near to one as to the other
  const std::vector<domains::Point> outline{{0, 0}, {2, 0}, {4, 0}, {4, 3}, {3, 3}, {2, 1}, {1, 3}, {0, 3}};
  std::set<std::vector<double>> results;
  std::mt19937 random(random_seeds::seed());
  std::vector<std::size_t> order{0, 1, 2, 3, 4, 5, 6, 7};
  for (int k = 0; k < 20; ++k) {
    std::shuffle(order.begin(), order.end(), random);
    domains::CDT cdt;
    for (std::size_t v : order)
      cdt.insert(outline[v]);
    cdt.insert_constraint(outline.begin(), outline.end(), true);
    cdt.insert_constraint(outline[1], outline[5]);
    CGAL::Face_region_map_2<domains::CDT> regions(0);
    for (const auto f : cdt.finite_face_handles())
      regions.set(f, CGAL::centroid(cdt.triangle(f)).x() < 2 ? 1 : 2);
    const CGAL::Region_sizing_field_2<domains::CDT> field(cdt, regions, [](int region) { return double(region); });
    std::vector<double> sizes;
    for (double y : {1.5, 2.5, 3.5, 10.})
      sizes.push_back(field(domains::Point(2, y)));
    results.insert(sizes);
    EXPECT_TRUE(std::isnan(field(domains::Point(std::nan(""), 0))));
  }
  EXPECT_EQ(results.size(), 1u);
}

TEST(Region_sizing_field, is_of_the_region_and_the_place)
{
  Channel<domains::CDT> channel;
  const CGAL::Region_sizing_field_2<domains::CDT> field(
    channel.cdt, channel.regions, [](double region, const domains::Point& p) { return region + p.y(); });
  EXPECT_EQ(field(domains::Point(0.5, 0.5)), 10.5);
  EXPECT_EQ(field(domains::Point(1.5, 0.25)), 20.25);
  EXPECT_EQ(field(domains::Point(1, 0.25)), 10.25);
  expect_invalid(
    [&] {
      CGAL::npbs_relax(channel.cdt, CGAL::Region_sizing_field_2<domains::CDT>(channel.cdt, channel.regions,
                                                                              [](double) { return std::nan(""); }));
    },
    {"d(", "nan"});
}

} // namespace test_tags
