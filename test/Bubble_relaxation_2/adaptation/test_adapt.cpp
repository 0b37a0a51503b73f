// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// Parts of a mesh that are meshed anew: what stays as it is, what becomes of constraints, pins and holes, with
// several kernels, faces and triangulations.

#include "adaptation_checks.h"
#include "domains.h"
#include "random_seeds.h"
#include "validation.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/npbs_adapt.h>
#include <CGAL/npbs_relax.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#include <vector>

namespace test_adapt {

using adaptation::faces_near;
using adaptation::Plus;
using adaptation::size;
using domains::Cdt_of;
using domains::hole;
using domains::K;
using domains::mesh;
using domains::Outline;
using domains::slanted;

using Info_vb = CGAL::Triangulation_vertex_base_with_info_2<int, K>;
using Info_fb = CGAL::Triangulation_face_base_with_info_2<int, K, CGAL::Delaunay_mesh_face_base_2<K>>;
using Info_cdt = CGAL::Constrained_Delaunay_triangulation_2<K, CGAL::Triangulation_data_structure_2<Info_vb, Info_fb>>;
using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
using Exact_cdt = Cdt_of<Exact>;
using Exact_plus = CGAL::Constrained_triangulation_plus_2<Exact_cdt>;

template <class CDT>
class Adapt : public testing::Test
{};

// Each takes the compiler ten seconds or more: one with what users may add, and one with the exact kernel and a hierarchy.
// A hierarchy of another kernel is below and in test_adapt_promises.cpp, the exact kernel alone in test_tags.cpp and
// test_terrain.cpp.
using Triangulations = testing::Types<Info_cdt, Exact_plus>;

/// of what is in a part: in the middle, at a side, in a corner, at the hole, of all
struct Disc
{
  double x, y, radius;
};

const Disc discs[] = {{0.25, 0.25, 0.15}, {0.5, 0, 0.2}, {1.1, 0.9, 0.25}, {0.5, 0.5, 0.2}, {0.5, 0.5, 9}};

TYPED_TEST_SUITE(Adapt, Triangulations);

TYPED_TEST(Adapt, leaves_all_outside_as_it_is)
{
  for (const Disc& disc : discs)
    for (double d : {0.05, 0.025, 0.09}) {
      SCOPED_TRACE(testing::Message() << "disc at " << disc.x << ", " << disc.y << ", d = " << d);
      TypeParam cdt = mesh<TypeParam>({slanted, hole}, 0.05);
      const auto part = faces_near(cdt, disc.x, disc.y, disc.radius);
      const adaptation::Outside<TypeParam> outside(cdt, part);
      const validation::Snapshot before = validation::snapshot(cdt);
      const auto report = CGAL::npbs_remesh_faces(cdt, part, size(d));
      outside.expect_untouched(cdt);
      validation::expect_valid_mesh(cdt);
      validation::expect_constraints_kept(before, validation::snapshot(cdt));
      EXPECT_NEAR(validation::domain_area(cdt), domains::area(slanted) - domains::area(hole), 1e-12);
      EXPECT_GE(report.quality.mean_quality(), 0.94);
      EXPECT_GE(report.quality.minimum_quality(), 0.6);
      if (disc.radius > 1) {
        EXPECT_EQ(report.number_of_vertices, cdt.number_of_vertices());
      }
    }
}

TYPED_TEST(Adapt, inner_constraints_and_pins_stay)
{
  using Point = typename TypeParam::Point;
  TypeParam cdt = domains::square_with_inner_constraints<TypeParam>();
  std::set<typename TypeParam::Vertex_handle> pins;
  for (const Point& p : {Point(0.7, 0.7), Point(0.71, 0.12), Point(0.35, 0)})
    pins.insert(cdt.insert(p));
  const auto map = CGAL::make_boolean_property_map(pins);
  const validation::Snapshot before = validation::snapshot(cdt);
  CGAL::npbs_relax(cdt, size(0.06).vertex_is_constrained_map(map));
  for (const Disc& disc : {Disc{0.5, 0.25, 0.2}, Disc{0.5, 0.8, 0.2}, Disc{0.2, 0.6, 0.3}, Disc{0.7, 0.7, 0.2},
                           Disc{0.35, 0, 0.15}, Disc{0.5, 0.5, 9}})
    for (double d : {0.03, 0.06}) {
      SCOPED_TRACE(testing::Message() << "disc at " << disc.x << ", " << disc.y << ", d = " << d);
      const auto part = faces_near(cdt, disc.x, disc.y, disc.radius);
      const adaptation::Outside<TypeParam> outside(cdt, part);
      CGAL::npbs_remesh_faces(cdt, part, size(d).vertex_is_constrained_map(map));
      outside.expect_untouched(cdt);
      validation::expect_mesh_of(before, cdt);
      EXPECT_NEAR(validation::domain_area(cdt), 1, 1e-12);
      std::size_t found = 0;
      for (auto v : cdt.finite_vertex_handles())
        found += pins.count(v);
      EXPECT_EQ(found, pins.size());
    }
}

TYPED_TEST(Adapt, single_faces_and_pinched_parts)
{
  TypeParam cdt = mesh<TypeParam>({slanted, hole}, 0.1);
  for (int k = 0; k < 20; ++k) {
    std::vector<typename TypeParam::Face_handle> all, part;
    for (auto f : cdt.finite_face_handles())
      if (f->is_in_domain())
        all.push_back(f);
    part.push_back(all[std::size_t(k) * all.size() / 20]);
    if (k % 2 == 1) // and one that it shares a vertex with only
      for (auto f : all)
        if (f->has_vertex(part[0]->vertex(0)) && !f->has_neighbor(part[0]) && f != part[0] && part.size() == 1)
          part.push_back(f);
    const adaptation::Outside<TypeParam> outside(cdt, part);
    CGAL::npbs_remesh_faces(cdt, part, size(k % 3 == 0 ? 0.03 : 0.1));
    outside.expect_untouched(cdt);
    validation::expect_valid_mesh(cdt);
  }
}

/// Discs of random domains with random sizes, one after the other, and some faces of discs only: no more can be told of
/// them than that they are valid.
TYPED_TEST(Adapt, random_parts_of_random_domains)
{
  std::mt19937 random(random_seeds::seed(11));
  const auto uniform = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(random); };
  for (unsigned k = 0; k < 6; ++k) {
    const std::vector<Outline> outlines = domains::random_star(random_seeds::seed(k));
    TypeParam cdt = domains::make<TypeParam>(outlines);
    const validation::Snapshot input = validation::snapshot(cdt);
    CGAL::npbs_relax(cdt, size(0.1));
    for (int change = 0; change < 12; ++change) {
      auto part = faces_near(cdt, uniform(-1, 1), uniform(-1, 1), uniform(0.05, 0.6));
      if (change % 2 == 1)
        part.erase(std::remove_if(part.begin(), part.end(), [&](auto) { return uniform(0, 1) < 0.5; }), part.end());
      if (part.empty())
        continue;
      const adaptation::Outside<TypeParam> outside(cdt, part);
      CGAL::npbs_remesh_faces(cdt, part, size(std::exp(uniform(std::log(0.03), std::log(0.3)))));
      outside.expect_untouched(cdt);
      validation::expect_mesh_of(input, cdt);
      ASSERT_FALSE(testing::Test::HasFailure()) << "domain " << k << ", change " << change;
    }
  }
}

/// a constraint with domain on both sides, of which only one is in the part, belongs to the rim
TYPED_TEST(Adapt, constraints_at_the_rim_are_not_split)
{
  TypeParam cdt = domains::make<TypeParam>({{{0, 0}, {0.48, 0}, {1, 0}, {1, 1}, {0.53, 1}, {0, 1}}});
  const validation::Segment wall{{0.48, 0}, {0.53, 1}};
  domains::insert(cdt, {wall.first, wall.second}, false);
  CGAL::npbs_relax(cdt, size(0.08));
  std::vector<typename TypeParam::Face_handle> part;
  for (auto f : faces_near(cdt, 0, 0.5, 9)) {
    bool is_left = true;
    for (int i = 0; i < 3; ++i) {
      const validation::Xy p = validation::xy(f->vertex(i));
      is_left = is_left && p.first - 0.48 - p.second * 0.05 < 1e-9;
    }
    if (is_left)
      part.push_back(f);
  }
  const adaptation::Outside<TypeParam> outside(cdt, part);
  ASSERT_GT(outside.number_of_faces(), 50u);
  ASSERT_GT(part.size(), 50u);
  const validation::Snapshot before = validation::snapshot(cdt);
  CGAL::npbs_remesh_faces(cdt, part, size(0.03));
  outside.expect_untouched(cdt);
  validation::expect_valid_mesh(cdt);
  const validation::Snapshot after = validation::snapshot(cdt);
  for (const validation::Segment& piece : before.constraints)
    if (validation::off(wall, piece.first) < 1e-12 && validation::off(wall, piece.second) < 1e-12) {
      EXPECT_TRUE(std::binary_search(after.constraints.begin(), after.constraints.end(), piece));
    }
  EXPECT_GT(after.constraints.size(), before.constraints.size()); // those of the outline are split
}

/// The circle of a flat triangle reaches far over its longest edge: nodes of the part must not come into it.
TYPED_TEST(Adapt, nodes_stay_out_of_the_circles_of_faces_outside)
{
  using Point = typename TypeParam::Point;
  TypeParam cdt = domains::make<TypeParam>({domains::square(0, 0, 10)});
  for (const Point& p : {Point(4, 5), Point(6, 5), Point(5, 5.25), Point(5, 0.8)})
    cdt.insert(p);
  for (auto f : cdt.finite_face_handles())
    f->set_in_domain(true);
  const auto flat = faces_near(cdt, 5, 5.08, 0.1);
  ASSERT_EQ(flat.size(), 1u);
  auto part = faces_near(cdt, 0, 0, 99);
  part.erase(std::find(part.begin(), part.end(), flat.front()));
  const adaptation::Outside<TypeParam> outside(cdt, part);
  ASSERT_EQ(outside.number_of_faces(), 1u);
  const auto report = CGAL::npbs_remesh_faces(cdt, part, size(0.5));
  outside.expect_untouched(cdt);
  validation::expect_valid_mesh(cdt);
  EXPECT_GT(report.number_of_vertices, 150u);
  EXPECT_NEAR(validation::domain_area(cdt), 100, 1e-9);
  for (auto v : cdt.finite_vertex_handles()) {
    const validation::Xy p = validation::xy(v);
    EXPECT_GE(std::hypot(p.first - 5, p.second - 3.125), 2.125 - 1e-9); // of the flat triangle
  }
}

/// what crosses in a hierarchy, and pieces of two constraints
TEST(Adapt_plus, overlapping_and_crossing_constraints)
{
  Plus cdt = domains::make<Plus>({domains::square(0, 0, 1)});
  domains::insert(cdt, {{0.1, 0.2}, {0.9, 0.8}}, false);
  domains::insert(cdt, {{0.2, 0.9}, {0.7, 0.1}}, false);
  domains::insert(cdt, {{0, 0}, {0.5, 0}}, false); // lies on the square
  const validation::Snapshot before = validation::snapshot(cdt);
  CGAL::npbs_relax(cdt, size(0.05));
  for (const Disc& disc : {Disc{0.45, 0.5, 0.2}, Disc{0.4, 0, 0.2}, Disc{0.5, 0.5, 9}})
    for (double d : {0.03, 0.07}) {
      const auto part = faces_near(cdt, disc.x, disc.y, disc.radius);
      const adaptation::Outside<Plus> outside(cdt, part);
      CGAL::npbs_remesh_faces(cdt, part, size(d));
      outside.expect_untouched(cdt);
      validation::expect_mesh_of(before, cdt);
      EXPECT_EQ(cdt.number_of_constraints(), 4u);
    }
}

TEST(Adapt_kernels, with_inexact_predicates)
{
  using Simple = Cdt_of<CGAL::Simple_cartesian<double>>;
  Simple cdt = mesh<Simple>({domains::square(0, 0, 1), domains::square(0.4, 0.4, 0.2)}, 0.05);
  for (double d : {0.03, 0.08}) {
    const auto part = faces_near(cdt, 0.5, 0.3, 0.3);
    const adaptation::Outside<Simple> outside(cdt, part);
    CGAL::npbs_remesh_faces(cdt, part, size(d));
    outside.expect_untouched(cdt);
    validation::expect_valid_mesh(cdt);
    EXPECT_NEAR(validation::domain_area(cdt), 0.96, 1e-12);
  }
}

/// Faces without marks cannot tell whether they are in the domain: the hole's constraints are those of a rim, except
/// for `npbs_adapt()`, which finds the domain as a relaxation does.
TEST(Adapt_marks, are_not_needed)
{
  using Bare = CGAL::Constrained_Delaunay_triangulation_2<K>;
  Bare cdt = mesh<Bare>({slanted, hole}, 0.05);
  const auto at_hole = [&cdt] {
    std::size_t sum = 0;
    for (const auto& e : cdt.finite_edges()) {
      const validation::Xy p = validation::xy(e.first->vertex(cdt.ccw(e.second)));
      sum += cdt.is_constrained(e) && std::hypot(p.first - 0.5, p.second - 0.5) < 0.25;
    }
    return sum;
  };
  const std::size_t before = at_hole();
  std::vector<Bare::Face_handle> part;
  for (Bare::Face_handle f : cdt.finite_face_handles()) {
    const auto c = CGAL::centroid(cdt.triangle(f));
    const bool is_in_hole = CGAL::orientation(K::Point_2(0.4, 0.4), K::Point_2(0.7, 0.43), c) == CGAL::LEFT_TURN &&
                            CGAL::orientation(K::Point_2(0.7, 0.43), K::Point_2(0.5, 0.65), c) == CGAL::LEFT_TURN &&
                            CGAL::orientation(K::Point_2(0.5, 0.65), K::Point_2(0.4, 0.4), c) == CGAL::LEFT_TURN;
    if (!is_in_hole && std::hypot(c.x() - 0.5, c.y() - 0.5) < 0.3)
      part.push_back(f);
  }
  const std::size_t number = cdt.number_of_vertices();
  CGAL::npbs_remesh_faces(cdt, part, size(0.025));
  EXPECT_TRUE(cdt.is_valid());
  EXPECT_GT(cdt.number_of_vertices(), number + 30);
  EXPECT_EQ(at_hole(), before);
  CGAL::npbs_adapt(cdt, size(0.02));
  EXPECT_TRUE(cdt.is_valid());
  EXPECT_GT(at_hole(), 2 * before);
  const std::size_t at_once = mesh<Bare>({slanted, hole}, 0.02).number_of_vertices();
  EXPECT_NEAR(double(cdt.number_of_vertices()), double(at_once), 0.02 * double(at_once));
}

} // namespace test_adapt
