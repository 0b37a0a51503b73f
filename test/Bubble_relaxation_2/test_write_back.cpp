// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// What stays of a triangulation when it is relaxed, refined and coarsened: vertices, what they carry,
// handles, constraints and their identifiers; with several kernels, faces and triangulations.

#include "domains.h"
#include "validation.h"

#include <CGAL/Constrained_triangulation_plus_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/npbs_relax.h>

#include <map>
#include <string>

using domains::K;
using domains::Outline;

namespace {

using Info_vb = CGAL::Triangulation_vertex_base_with_info_2<std::string, K>;
using Info_cdt = CGAL::Constrained_Delaunay_triangulation_2<
  K, CGAL::Triangulation_data_structure_2<Info_vb, CGAL::Delaunay_mesh_face_base_2<K>>>;
using Plus = CGAL::Constrained_triangulation_plus_2<domains::CDT>;
using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
using Exact_cdt = CGAL::Constrained_Delaunay_triangulation_2<
  Exact, CGAL::Triangulation_data_structure_2<CGAL::Triangulation_vertex_base_2<Exact>,
                                              CGAL::Delaunay_mesh_face_base_2<Exact>>>;

const Outline slanted{{0, 0.1}, {0.97, 0}, {1.1, 0.9}, {0.1, 1.03}};
const Outline hole{{0.4, 0.4}, {0.7, 0.43}, {0.5, 0.65}};

auto size(double d) { return CGAL::parameters::sizing_function(d); }

template <class CDT>
struct Map_of_pins
{
  using key_type = typename CDT::Vertex_handle;
  using value_type = bool;
  using reference = bool;
  using category = boost::readable_property_map_tag;

  const std::set<key_type>* pins;

  friend bool get(const Map_of_pins& map, key_type v) { return map.pins->count(v) > 0; }
};

template <class CDT>
class Write_back : public testing::Test
{};

using Triangulations = testing::Types<domains::CDT, Info_cdt, Plus, Exact_cdt>;

} // namespace

TYPED_TEST_SUITE(Write_back, Triangulations);

TYPED_TEST(Write_back, refines_and_coarsens)
{
  TypeParam cdt = domains::make<TypeParam>({slanted, hole});
  const validation::Snapshot before = validation::snapshot(cdt);
  const double area = domains::area(slanted) - domains::area(hole);
  std::size_t last = 0;
  for (double d : {0.1, 0.05, 0.2, 0.03}) {
    SCOPED_TRACE(d);
    const auto report = CGAL::npbs_relax(cdt, size(d));
    const validation::Snapshot after = validation::snapshot(cdt);
    validation::expect_valid_mesh(cdt);
    validation::expect_vertices_kept(before.vertices, after);
    validation::expect_constraints_kept(before, after);
    EXPECT_NEAR(validation::domain_area(cdt), area, 1e-12);
    // at 0.2 the hole's edges are hardly longer than a bubble
    EXPECT_GT(report.quality.mean_quality(), d == 0.2 ? 0.9 : 0.95);
    EXPECT_NEAR(report.quality.mean_length_ratio(), 1, 0.1);
    // along the edges, too: the longest edge of the domain has about its length over d parts
    std::size_t on_boundary = 0;
    for (const auto& s : after.constraints)
      on_boundary += validation::length(s) < 1.8 * d;
    EXPECT_EQ(on_boundary, after.constraints.size());
    EXPECT_NEAR(double(after.constraints.size()), 4.68 / d, 0.25 * 4.68 / d + 4);
    EXPECT_NE(report.number_of_vertices, last);
    last = report.number_of_vertices;
  }
}

TYPED_TEST(Write_back, handles_of_corners_stay_valid)
{
  TypeParam cdt = domains::make<TypeParam>({slanted, hole});
  std::map<typename TypeParam::Vertex_handle, validation::Xy> corners;
  for (auto v : cdt.finite_vertex_handles())
    corners[v] = validation::xy(v);
  for (double d : {0.1, 0.05, 0.15}) {
    CGAL::npbs_relax(cdt, size(d));
    std::size_t found = 0;
    for (auto v : cdt.finite_vertex_handles())
      if (corners.count(v) > 0) {
        EXPECT_EQ(corners[v], validation::xy(v));
        ++found;
      }
    EXPECT_EQ(found, corners.size());
  }
}

TYPED_TEST(Write_back, inner_constraints_and_pinned_vertices_are_kept)
{
  using Point = typename TypeParam::Point;
  TypeParam cdt = domains::make<TypeParam>({domains::square(0, 0, 1)});
  domains::insert(cdt, {{0.2, 0.2}, {0.8, 0.3}}, false);  // inside, free ends
  domains::insert(cdt, {{0.5, 1}, {0.55, 0.6}}, false);   // dangling from the boundary
  domains::insert(cdt, {{0, 0.5}, {0.3, 0.45}, {0.25, 0.8}, {0, 0.8}}, false); // cuts a region off
  std::set<typename TypeParam::Vertex_handle> pins;
  pins.insert(cdt.insert(Point(0.7, 0.7)));
  pins.insert(cdt.insert(Point(0.71, 0.12)));
  pins.insert(cdt.insert(Point(0.35, 0))); // splits an edge of the square, and stays
  const Map_of_pins<TypeParam> map{&pins};
  const validation::Snapshot before = validation::snapshot(cdt);
  for (double d : {0.08, 0.05, 0.12}) {
    const auto report = CGAL::npbs_relax(cdt, size(d).vertex_is_constrained_map(map));
    const validation::Snapshot after = validation::snapshot(cdt);
    validation::expect_valid_mesh(cdt);
    validation::expect_vertices_kept(before.vertices, after);
    validation::expect_constraints_kept(before, after);
    EXPECT_NEAR(validation::domain_area(cdt), 1, 1e-9);
    EXPECT_GT(report.quality.mean_quality(), 0.9);
  }
}

TYPED_TEST(Write_back, unpinned_split_vertices_may_go)
{
  using Point = typename TypeParam::Point;
  TypeParam cdt = domains::make<TypeParam>({domains::square(0, 0, 1)});
  cdt.insert(Point(0.37, 0));
  CGAL::npbs_relax(cdt, size(0.25));
  const validation::Snapshot after = validation::snapshot(cdt);
  EXPECT_EQ(after.vertices.count({0.37, 0}), 0u);
  validation::expect_valid_mesh(cdt);
}

TYPED_TEST(Write_back, a_hole_with_vertices_is_left_alone)
{
  using Point = typename TypeParam::Point;
  TypeParam cdt = domains::make<TypeParam>({domains::square(0, 0, 1), domains::square(0.3, 0.3, 0.4)});
  cdt.insert(Point(0.5, 0.5));
  cdt.insert(Point(0.41, 0.52));
  domains::insert(cdt, {{0.45, 0.4}, {0.6, 0.6}}, false);
  cdt.insert(Point(2, 2)); // outside
  const std::vector<Point> seeds{Point(0.31, 0.31)};
  const validation::Snapshot before = validation::snapshot(cdt);
  CGAL::npbs_relax(cdt, CGAL::Bubble_relaxation_parameters::sizing_function(0.07).seeds(seeds));
  const validation::Snapshot after = validation::snapshot(cdt);
  validation::expect_valid_mesh(cdt, before.vertices);
  validation::expect_vertices_kept(before.vertices, after);
  validation::expect_constraints_kept(before, after);
  EXPECT_NEAR(validation::domain_area(cdt), 0.84, 1e-9);
}

TEST(Write_back_info, vertices_keep_what_they_carry)
{
  Info_cdt cdt = domains::make<Info_cdt>({slanted, hole});
  std::map<validation::Xy, std::string> info;
  for (auto v : cdt.finite_vertex_handles()) {
    v->info() = "vertex at " + std::to_string(v->point().x());
    info[validation::xy(v)] = v->info();
  }
  CGAL::npbs_relax(cdt, size(0.1));
  CGAL::npbs_relax(cdt, size(0.06));
  std::size_t found = 0;
  for (auto v : cdt.finite_vertex_handles())
    if (info.count(validation::xy(v)) > 0) {
      EXPECT_EQ(v->info(), info[validation::xy(v)]);
      ++found;
    } else {
      EXPECT_EQ(v->info(), "");
    }
  EXPECT_EQ(found, info.size());
}

TEST(Write_back_plus, constraints_keep_their_identifiers)
{
  Plus cdt;
  std::vector<domains::Point> line{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}};
  const auto outline = cdt.insert_constraint(line.begin(), line.end());
  std::vector<domains::Point> inner{{0.2, 0.3}, {0.5, 0.35}, {0.8, 0.7}};
  const auto inside = cdt.insert_constraint(inner.begin(), inner.end());
  for (double d : {0.1, 0.04, 0.2}) {
    CGAL::npbs_relax(cdt, size(d));
    validation::expect_valid_mesh(cdt);
    EXPECT_EQ(cdt.number_of_constraints(), 2u);
    for (const auto& c : {std::make_pair(outline, line), std::make_pair(inside, inner)}) {
      double length = 0, expected = 0;
      std::size_t kept = 0;
      auto v = cdt.vertices_in_constraint_begin(c.first), end = cdt.vertices_in_constraint_end(c.first);
      for (auto last = v; v != end; last = v, ++v) {
        length += std::sqrt(CGAL::squared_distance((*last)->point(), (*v)->point()));
        kept += std::count(c.second.begin(), c.second.end(), (*v)->point()) > 0;
        if (last != v) {
          EXPECT_TRUE(cdt.is_subconstraint(*last, *v));
        }
      }
      for (std::size_t k = 1; k < c.second.size(); ++k)
        expected += std::sqrt(CGAL::squared_distance(c.second[k - 1], c.second[k]));
      EXPECT_NEAR(length, expected, 1e-12);
      EXPECT_EQ(kept, c.second.size());
    }
  }
}

TEST(Write_back_exact, bubbles_lie_exactly_on_their_edges)
{
  Exact_cdt cdt = domains::make<Exact_cdt>({slanted});
  std::vector<Exact::Segment_2> edges;
  for (const auto& e : cdt.finite_edges())
    if (cdt.is_constrained(e))
      edges.push_back(cdt.segment(e));
  CGAL::npbs_relax(cdt, size(0.1));
  for (const auto& e : cdt.finite_edges())
    if (cdt.is_constrained(e)) {
      const auto s = cdt.segment(e);
      EXPECT_TRUE(std::any_of(edges.begin(), edges.end(), [&](const Exact::Segment_2& t) {
        return t.has_on(s.source()) && t.has_on(s.target());
      }));
    }
}

TEST(Write_back_plain, faces_need_no_mark)
{
  CGAL::Constrained_Delaunay_triangulation_2<K> cdt;
  domains::insert(cdt, slanted);
  domains::insert(cdt, hole);
  const auto report = CGAL::npbs_relax(cdt, size(0.05));
  EXPECT_TRUE(cdt.is_valid());
  EXPECT_GT(report.quality.mean_quality(), 0.97);
}

TEST(Write_back_default_size, an_existing_mesh_keeps_its_size)
{
  domains::CDT cdt = domains::make({domains::square(0, 0, 1)});
  const auto first = CGAL::npbs_relax(cdt, size(0.07));
  const auto second = CGAL::npbs_relax(cdt);
  EXPECT_NEAR(double(second.number_of_vertices), double(first.number_of_vertices),
              0.1 * double(first.number_of_vertices));
  EXPECT_GT(second.quality.mean_quality(), 0.97);
}

TEST(Write_back_keep, the_population_stays_if_it_shall)
{
  domains::CDT cdt = domains::make({domains::square(0, 0, 1)});
  CGAL::npbs_relax(cdt, size(0.1));
  const std::size_t n = cdt.number_of_vertices();
  const auto report = CGAL::npbs_relax(
    cdt, size(0.1).initial_placement(CGAL::Bubble_placement::KEEP)
           .population_control(CGAL::Bubble_population::NONE));
  EXPECT_EQ(cdt.number_of_vertices(), n);
  EXPECT_EQ(report.number_of_initial_bubbles, n);
}
