// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// Constraints that stay as they are: no vertex comes on them, none of theirs moves or goes, handles and markers stay, and
// triangles beside them are as good as their lengths let them be.

#include "domains.h"
#include "validation.h"

#include <CGAL/Constrained_triangulation_plus_2.h>
#include <CGAL/Constraint_marker_map_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Mesh_quality_2.h>
#include <CGAL/npbs_adapt.h>
#include <CGAL/npbs_place_nodes.h>
#include <CGAL/npbs_relax.h>
#include <CGAL/property_map.h>
#include <CGAL/utility.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace test_protect_constraints {

namespace np = CGAL::parameters;
using domains::CDT;
using domains::Outline;
using domains::Point;

template <class Cdt>
using Ends = std::pair<typename Cdt::Vertex_handle, typename Cdt::Vertex_handle>;

template <class Cdt>
Ends<Cdt> ends(const Cdt& cdt, const typename Cdt::Edge& e)
{
  return CGAL::make_sorted_pair(e.first->vertex(cdt.ccw(e.second)), e.first->vertex(cdt.cw(e.second)));
}

template <class Cdt>
std::set<Ends<Cdt>> constraints(const Cdt& cdt)
{
  std::set<Ends<Cdt>> result;
  for (const auto& e : cdt.finite_edges())
    if (cdt.is_constrained(e))
      result.insert(ends(cdt, e));
  return result;
}

/// the constraints whose ends both lie above a height
template <class Cdt>
std::set<Ends<Cdt>> constraints_above(const Cdt& cdt, double y)
{
  std::set<Ends<Cdt>> result;
  for (const Ends<Cdt>& e : constraints(cdt))
    if (CGAL::to_double(e.first->point().y()) > y && CGAL::to_double(e.second->point().y()) > y)
      result.insert(e);
  return result;
}

/// all are still constraints, between the same vertices
template <class Cdt>
void expect_kept(const std::set<Ends<Cdt>>& kept, const Cdt& cdt)
{
  const auto after = constraints(cdt);
  EXPECT_TRUE(std::includes(after.begin(), after.end(), kept.begin(), kept.end()));
}

/// a ring of regular polygons
Outline outer(int n) { return domains::polygon(0, 0, 1, n); }
Outline inner(int n) { return domains::polygon(0.05, 0, 0.4, n, 0.1); }

template <class Cdt>
double minimum_angle(const Cdt& cdt)
{
  return CGAL::mesh_quality_2(cdt).minimum_angle();
}

TEST(Protect_constraints, all_stay_with_their_vertices)
{
  CDT cdt = domains::make({outer(60), inner(24)});
  const auto before = constraints(cdt);
  const validation::Snapshot snapshot = validation::snapshot(cdt);
  const auto report = CGAL::npbs_relax(cdt, np::sizing_function(0.1).protect_constraints(true));
  EXPECT_EQ(constraints(cdt), before); // handles, too
  validation::expect_mesh_of(snapshot, cdt);
  EXPECT_TRUE(report.converged);
  EXPECT_GT(cdt.number_of_vertices(), 350u);
  EXPECT_GT(minimum_angle(cdt), 38);
  EXPECT_GT(report.quality.mean_quality(), 0.975);
}

TEST(Protect_constraints, false_and_a_map_of_none_change_nothing)
{
  CDT without = domains::make({domains::slanted, domains::hole}), is_false(without), none(without);
  CGAL::npbs_relax(without, 0.05);
  CGAL::npbs_relax(is_false, np::protect_constraints(false).sizing_function(0.05));
  std::set<Ends<CDT>> empty;
  CGAL::npbs_relax(none, np::sizing_function(0.05).protect_constraints(CGAL::Boolean_property_map<decltype(empty)>(empty)));
  EXPECT_TRUE(validation::snapshot(is_false) == validation::snapshot(without));
  EXPECT_TRUE(validation::snapshot(none) == validation::snapshot(without));
}

TEST(Protect_constraints, those_of_a_map_stay_and_others_are_split)
{
  CDT cdt = domains::make({outer(60), inner(24)});
  std::set<Ends<CDT>> kept = constraints_above(cdt, 0);
  const std::size_t all = constraints(cdt).size();
  ASSERT_GT(kept.size(), 30u);
  const validation::Snapshot before = validation::snapshot(cdt);
  CGAL::npbs_relax(cdt, np::sizing_function(0.04).protect_constraints(CGAL::make_boolean_property_map(kept)));
  validation::expect_mesh_of(before, cdt);
  const std::size_t after = constraints(cdt).size();
  EXPECT_GT(after - kept.size(), 2 * (all - kept.size()));
  EXPECT_GT(minimum_angle(cdt), 33);
}

TEST(Protect_constraints, vertices_that_only_split_a_line_stay)
{
  CDT cdt = domains::make({{{0, 0}, {0.13, 0}, {0.2, 0}, {0.37, 0}, {0.5, 0}, {0.61, 0}, {0.8, 0}, {1, 0},
                            {1, 0.5}, {1, 1}, {0.5, 1}, {0, 1}, {0, 0.5}}});
  const auto before = constraints(cdt);
  CDT free(cdt);
  CGAL::npbs_relax(free, 0.1);
  EXPECT_EQ(validation::snapshot(free).vertices.count({0.13, 0.}), 0u); // without the parameter it goes
  CGAL::npbs_relax(cdt, np::sizing_function(0.1).protect_constraints(true));
  EXPECT_EQ(constraints(cdt), before);
  validation::expect_valid_mesh(cdt);
}

/// bubbles of the wanted size beside far longer constraints would make fans of needles
TEST(Protect_constraints, sizes_are_larger_beside_long_ones)
{
  for (double d : {0.2, 0.05, 0.02}) {
    CDT cdt = domains::make({outer(20)});
    CGAL::npbs_relax(cdt, np::sizing_function(d).protect_constraints(true));
    EXPECT_GT(minimum_angle(cdt), 34) << d;
    CDT::Face_handle in_center = cdt.locate(Point(0.01, 0.02));
    for (int i = 0; i < 3; ++i) // and go back to what is wanted
      EXPECT_LT(std::sqrt(cdt.segment(in_center, i).squared_length()), d < 0.1 ? 2 * d : 0.3) << d;
  }
}

/// a long side between short ones: without larger sizes along it bubbles came to lie on it
TEST(Protect_constraints, no_vertex_comes_near_a_long_one_between_short_ones)
{
  for (int n : {10, 30, 50, 60}) {
    Outline square{{0, 0}, {1, 0}};
    for (int i = 1; i <= n; ++i)
      square.push_back({1, double(i) / n});
    for (int i = 1; i <= n; ++i)
      square.push_back({1 - double(i) / n, 1});
    for (int i = 1; i < n; ++i)
      square.push_back({0, 1 - double(i) / n});
    CDT cdt = domains::make({square});
    const auto before = constraints(cdt);
    CGAL::npbs_relax(cdt, np::sizing_function(1. / n).protect_constraints(true));
    EXPECT_EQ(constraints(cdt), before);
    EXPECT_GT(minimum_angle(cdt), 6) << n;
    for (CDT::Vertex_handle v : cdt.finite_vertex_handles())
      if (!cdt.are_there_incident_constraints(v))
        EXPECT_GT(v->point().y(), 1. / n) << n;
    EXPECT_EQ(CGAL::npbs_misfit_faces(cdt, np::sizing_function(1. / n).protect_constraints(true)).size(), 0u) << n;
  }
}

/// the same where the outline beside it, which may be split, asks for small sizes
TEST(Protect_constraints, the_outline_does_not_ask_for_needles_on_a_long_one)
{
  for (int n : {30, 100}) {
    Outline half{{-1, 0}};
    for (int i = 0; i < n; ++i)
      half.push_back({std::cos(3.14159265358979 * i / n), std::sin(3.14159265358979 * i / n)});
    CDT cdt = domains::make({half});
    std::set<Ends<CDT>> diameter;
    for (const Ends<CDT>& e : constraints(cdt))
      if (e.first->point().y() == 0 && e.second->point().y() == 0)
        diameter.insert(e);
    ASSERT_EQ(diameter.size(), 1u);
    CGAL::npbs_relax(cdt, np::sizing_function(0.1).protect_constraints(CGAL::make_boolean_property_map(diameter)));
    expect_kept<CDT>(diameter, cdt);
    EXPECT_GT(minimum_angle(cdt), n == 30 ? 12 : 8) << n;
  }
}

TEST(Protect_constraints, inner_ones_and_free_ends_stay)
{
  CDT cdt = domains::square_with_inner_constraints<CDT>();
  std::set<Ends<CDT>> kept;
  for (const Ends<CDT>& e : constraints(cdt))
    if (e.first->point().x() > 0.1 && e.second->point().x() > 0.1 && e.first->point().y() < 0.9 &&
        e.second->point().y() < 0.9 && (e.first->point().x() < 0.9 || e.second->point().x() < 0.9))
      kept.insert(e);
  ASSERT_EQ(kept.size(), 2u); // the free one, and one of the three that cut a region off
  const validation::Snapshot before = validation::snapshot(cdt);
  CGAL::npbs_relax(cdt, np::sizing_function(0.05).protect_constraints(CGAL::make_boolean_property_map(kept)));
  validation::expect_mesh_of(before, cdt);
  expect_kept<CDT>(kept, cdt);
}

template <class Cdt>
class Protect_constraints_of : public testing::Test {};

using Kinds = testing::Types<
  domains::Cdt_of<CGAL::Exact_predicates_exact_constructions_kernel, CGAL::Exact_intersections_tag>,
  CGAL::Constrained_triangulation_plus_2<domains::Cdt_of<domains::K, CGAL::Exact_predicates_tag>>>;
TYPED_TEST_SUITE(Protect_constraints_of, Kinds);

TYPED_TEST(Protect_constraints_of, other_triangulations_stay)
{
  TypeParam cdt = domains::make<TypeParam>({outer(40), inner(16)});
  std::set<Ends<TypeParam>> kept = constraints_above(cdt, 0);
  for (double d : {0.1, 0.06}) { // with a mesh there already, too
    CGAL::npbs_relax(cdt, np::sizing_function(d).protect_constraints(CGAL::make_boolean_property_map(kept)));
    validation::expect_valid_mesh(cdt);
    expect_kept<TypeParam>(kept, cdt);
    EXPECT_GT(constraints(cdt).size(), 60u) << d;
  }
}

TEST(Protect_constraints, markers_stay)
{
  CDT cdt = domains::make({outer(30), inner(12)});
  CGAL::Constraint_marker_map_2<CDT> markers;
  for (const Ends<CDT>& e : constraints(cdt))
    put(markers, e, e.first->point().y() > 0 && e.second->point().y() > 0 ? 1 : 2);
  std::set<Ends<CDT>> kept = constraints_above(cdt, 0);
  const auto parameters = np::edge_marker_map(markers).protect_constraints(CGAL::make_boolean_property_map(kept));
  CGAL::npbs_relax(cdt, parameters.sizing_function(0.05));
  const auto expect_markers = [&] {
    expect_kept<CDT>(kept, cdt);
    for (const Ends<CDT>& e : constraints(cdt))
      EXPECT_EQ(get(markers, e), kept.count(e) == 1 ? 1 : 2);
  };
  expect_markers();
  CGAL::npbs_adapt(cdt, parameters.sizing_function([](const Point& p) { return 0.03 + 0.1 * std::hypot(p.x() - 0.7, p.y()); }));
  expect_markers();
}

TEST(Protect_constraints, a_local_change_keeps_them_and_settles)
{
  CDT cdt = domains::make({outer(80), inner(30)});
  domains::insert(cdt, {{-0.8, 0.1}, {-0.7, 0.13}, {-0.62, 0.1}, {-0.5, 0.1}}, false);
  const auto before = constraints(cdt);
  const auto parameters = np::protect_constraints(true);
  CGAL::npbs_relax(cdt, parameters.sizing_function(0.08));
  for (double x : {0.7, 0., -0.7}) {
    const auto d = [x](const Point& p) {
      return (std::min)(0.08, 0.02 + 0.2 * std::hypot(p.x() - x, p.y() - 0.7 + std::abs(x)));
    };
    CGAL::npbs_adapt(cdt, parameters.sizing_function(d));
    EXPECT_EQ(constraints(cdt), before) << x;
    validation::expect_valid_mesh(cdt);
    EXPECT_GT(minimum_angle(cdt), 26) << x;
    CGAL::npbs_adapt(cdt, parameters.sizing_function(d));
    EXPECT_EQ(CGAL::npbs_misfit_faces(cdt, parameters.sizing_function(d)).size(), 0u) << x;
  }
}

TEST(Protect_constraints, neither_order_nor_scale_counts)
{
  std::mt19937 random(7);
  for (unsigned seed = 1; seed <= 6; ++seed) {
    const std::vector<Outline> star = domains::random_star(seed);
    CDT one = domains::make(star), other = domains::make(domains::scaled(domains::shuffled(star, random), 1024));
    const auto mesh = [](CDT& cdt, double scale) {
      std::set<Ends<CDT>> kept = constraints_above(cdt, -0.2 * scale);
      CGAL::npbs_relax(cdt, np::sizing_function(0.06 * scale).protect_constraints(CGAL::make_boolean_property_map(kept)));
      expect_kept<CDT>(kept, cdt);
      validation::expect_valid_mesh(cdt);
    };
    mesh(one, 1);
    mesh(other, 1024);
    std::set<validation::Xy> scaled;
    for (const auto& [x, y] : validation::snapshot(one).vertices)
      scaled.insert({1024 * x, 1024 * y});
    EXPECT_EQ(validation::snapshot(other).vertices, scaled) << seed;
  }
}

/// opposite sides with the same vertices: what a solver with periodic boundary conditions needs
TEST(Protect_constraints, cells_can_be_periodic)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> jump(0.04, 0.065);
  std::vector<double> cuts;
  for (double s = jump(random); s < 0.97; s += jump(random))
    cuts.push_back(s);
  Outline cell{{0, 0}};
  for (double s : cuts)
    cell.push_back({s, 0});
  cell.push_back({1, 0});
  for (double s : cuts)
    cell.push_back({1, s});
  cell.push_back({1, 1});
  for (auto s = cuts.rbegin(); s != cuts.rend(); ++s)
    cell.push_back({*s, 1});
  cell.push_back({0, 1});
  for (auto s = cuts.rbegin(); s != cuts.rend(); ++s)
    cell.push_back({0, *s});
  CDT cdt = domains::make({cell, domains::polygon(0.5, 0.5, 0.2, 9)});
  std::set<Ends<CDT>> sides;
  for (const Ends<CDT>& e : constraints(cdt))
    if (std::hypot(e.first->point().x() - 0.5, e.first->point().y() - 0.5) > 0.3)
      sides.insert(e);
  CGAL::npbs_relax(cdt, np::sizing_function(0.05).protect_constraints(CGAL::make_boolean_property_map(sides)));
  const std::set<validation::Xy> vertices = validation::snapshot(cdt).vertices;
  std::size_t on_left = 0;
  for (const auto& [x, y] : vertices) {
    if (x == 0) {
      ++on_left;
      EXPECT_EQ(vertices.count({1., y}), 1u);
    }
    if (y == 0)
      EXPECT_EQ(vertices.count({x, 1.}), 1u);
  }
  EXPECT_EQ(on_left, cuts.size() + 2);
  EXPECT_GT(minimum_angle(cdt), 30);
}

TEST(Protect_constraints, nodes_come_on_none)
{
  const CDT cdt = domains::make({outer(20)});
  const auto nodes = CGAL::npbs_place_nodes(cdt, np::sizing_function(0.25).protect_constraints(true)).points;
  std::size_t on_circle = 0;
  for (const Point& p : nodes)
    on_circle += std::hypot(p.x(), p.y()) > 0.98;
  EXPECT_EQ(on_circle, 20u);
  EXPECT_GT(nodes.size(), 40u);
}

} // namespace test_protect_constraints
