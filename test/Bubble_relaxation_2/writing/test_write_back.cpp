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

#include <CGAL/Cartesian.h>
#include <CGAL/Constrained_triangulation_plus_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/npbs_relax.h>

#include <cmath>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace test_write_back {

using domains::hole;
using domains::K;
using domains::Outline;
using domains::slanted;

using Info_vb = CGAL::Triangulation_vertex_base_with_info_2<std::string, K>;
using Info_cdt = CGAL::Constrained_Delaunay_triangulation_2<
  K, CGAL::Triangulation_data_structure_2<Info_vb, CGAL::Delaunay_mesh_face_base_2<K>>>;
using Plus = CGAL::Constrained_triangulation_plus_2<domains::CDT>;
using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
using Exact_cdt = domains::Cdt_of<Exact>;

auto size(double d) { return CGAL::parameters::sizing_function(d); }

template <class CDT>
class Write_back : public testing::Test
{};

using Triangulations = testing::Types<domains::CDT, Info_cdt, Plus, Exact_cdt>;

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
    validation::expect_mesh_of(before, cdt);
    EXPECT_NEAR(validation::domain_area(cdt), area, 1e-12);
    // at 0.2 the hole's edges are hardly longer than a bubble
    EXPECT_GE(report.quality.mean_quality(), d == 0.2 ? 0.951 : d == 0.1 ? 0.975 : 0.98);
    EXPECT_NEAR(report.quality.mean_length_ratio(), 1, d >= 0.1 ? 0.05 : 0.031);
    // along the edges, too: the longest edge of the domain has about its length over d parts
    const std::vector<validation::Segment> pieces = validation::snapshot(cdt).constraints;
    for (const validation::Segment& s : pieces)
      EXPECT_LT(validation::length(s), 1.8 * d);
    EXPECT_NEAR(double(pieces.size()), 4.68 / d, 0.25 * 4.68 / d + 4);
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
  TypeParam cdt = domains::square_with_inner_constraints<TypeParam>();
  std::set<typename TypeParam::Vertex_handle> pins;
  pins.insert(cdt.insert(Point(0.7, 0.7)));
  pins.insert(cdt.insert(Point(0.71, 0.12)));
  pins.insert(cdt.insert(Point(0.35, 0))); // splits an edge of the square, and stays
  const auto map = CGAL::make_boolean_property_map(pins);
  const validation::Snapshot before = validation::snapshot(cdt);
  for (double d : {0.08, 0.05, 0.12}) {
    const auto report = CGAL::npbs_relax(cdt, size(d).vertex_is_constrained_map(map));
    validation::expect_mesh_of(before, cdt);
    EXPECT_NEAR(validation::domain_area(cdt), 1, 1e-9);
    EXPECT_GE(report.quality.mean_quality(), 0.96);
  }
}

TYPED_TEST(Write_back, pins_outside_are_counted)
{
  using Point = typename TypeParam::Point;
  TypeParam cdt = domains::make<TypeParam>({slanted, hole});
  std::set<typename TypeParam::Vertex_handle> pins;
  for (const Point& p : {Point(0.2, 0.2), Point(3, -1), Point(0.53, 0.5), Point(0.1, 1.03)}) // the last is a corner
    pins.insert(cdt.insert(p));
  const auto report = CGAL::npbs_relax(cdt, size(0.1).vertex_is_constrained_map(CGAL::make_boolean_property_map(pins)));
  EXPECT_EQ(report.number_of_pins_outside, 2u);
  EXPECT_EQ(report.pin_outside_x, 0.53);
  EXPECT_EQ(report.pin_outside_y, 0.5);
  std::ostringstream text;
  text << report;
  EXPECT_NE(text.str().find("outside of the domain: 2, the first at (0.53, 0.5)"), std::string::npos) << text.str();
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

// CGAL splits no constraint then, not even at a point on it
template <class Kernel>
void relax_without_intersections()
{
  using Strict_cdt = domains::Cdt_of<Kernel, CGAL::No_constraint_intersection_tag>;
  using Point = typename Strict_cdt::Point;
  using FT = typename Kernel::FT;
  constexpr double rounding = std::is_same<FT, float>::value ? 1e-5 : 1e-6;
  Strict_cdt cdt;
  const Point inner[]{Point(0.25, 0.25), Point(0.75, 0.625)};
  for (const Outline& o : {Outline{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, Outline{{2, 0}, {3, 0}, {3, 1}}})
    for (std::size_t k = 0; k < o.size(); ++k) {
      const auto &p = o[k], &q = o[(k + 1) % o.size()];
      cdt.insert_constraint(Point(FT(p.first), FT(p.second)), Point(FT(q.first), FT(q.second)));
    }
  cdt.insert_constraint(inner[0], inner[1]);
  cdt.insert(Point(1.5, 3)); // outside
  std::size_t last = 0;
  for (double d : {0.1, 0.04, 0.15}) {
    const auto report = CGAL::npbs_relax(cdt, size(d));
    EXPECT_TRUE(report.converged);
    EXPECT_GE(report.quality.minimum_quality(), 0.6);
    EXPECT_TRUE(cdt.is_valid());
    EXPECT_NE(report.number_of_vertices, last);
    last = report.number_of_vertices;
    double length = 0; // of all constraints
    for (auto e = cdt.finite_edges_begin(); e != cdt.finite_edges_end(); ++e)
      if (cdt.is_constrained(*e)) {
        const double of_piece = std::sqrt(CGAL::to_double(cdt.segment(*e).squared_length()));
        EXPECT_LT(of_piece, 1.8 * d);
        length += of_piece;
      }
    EXPECT_NEAR(length, 4 + 2 + std::sqrt(2.) + 0.625, rounding);
  }
}

TEST(Write_back_without_intersections, epick) { relax_without_intersections<K>(); }

TEST(Write_back_without_intersections, plain_coordinates) { relax_without_intersections<CGAL::Cartesian<double>>(); }

TEST(Write_back_without_intersections, single_precision)
{
  relax_without_intersections<CGAL::Simple_cartesian<float>>();
}

TEST(Write_back_without_intersections, exact_coordinates) { relax_without_intersections<Exact>(); }

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
  validation::expect_mesh_of(before, cdt, before.vertices);
  EXPECT_NEAR(validation::domain_area(cdt), 0.84, 1e-9);
}

/// a constraint between two corners of the domain that lies outside of it, and one that only begins at a corner
TYPED_TEST(Write_back, constraints_beside_the_domain_are_left_alone)
{
  using Point = typename TypeParam::Point;
  const Outline l_shape{{0, 0}, {1, 0}, {1, 0.5}, {0.5, 0.5}, {0.5, 1}, {0, 1}};
  for (const Outline& beside : {Outline{{1, 0.5}, {0.5, 1}}, Outline{{0.5, 0.5}, {0.7, 0.8}}}) {
    TypeParam cdt = domains::make<TypeParam>({l_shape});
    domains::insert(cdt, beside, false);
    const std::vector<Point> seeds{Point(0.2, 0.3)};
    const validation::Snapshot before = validation::snapshot(cdt);
    CGAL::npbs_relax(
      cdt,
      CGAL::Bubble_relaxation_parameters::sizing_function(0.07).seeds(seeds).seeds_are_in_domain(true));
    validation::expect_mesh_of(before, cdt);
    EXPECT_NEAR(validation::domain_area(cdt), 0.75, 1e-9);
  }
}

/// A plain triangulation takes the triangles as they are, others get them by insertion.
TEST(Write_back_plus, the_mesh_is_the_same_with_and_without_a_hierarchy)
{
  const auto triangles = [](auto cdt, double d) {
    CGAL::npbs_relax(cdt, size(0.1));
    CGAL::npbs_relax(cdt, size(d));
    std::set<std::set<validation::Xy>> result;
    for (auto f : cdt.finite_face_handles())
      result.insert({validation::xy(f->vertex(0)), validation::xy(f->vertex(1)), validation::xy(f->vertex(2))});
    EXPECT_EQ(result.size(), cdt.number_of_faces());
    return result;
  };
  for (double d : {0.2, 0.05})
    EXPECT_TRUE(triangles(domains::make<domains::CDT>({slanted, hole}), d) ==
                triangles(domains::make<Plus>({slanted, hole}), d));
}

/// counts how often a triangulation asks whether a point lies in a circle
struct Counting_kernel : K
{
  static inline std::size_t count = 0;

  struct Side_of_oriented_circle_2 : K::Side_of_oriented_circle_2
  {
    CGAL::Oriented_side operator()(const K::Point_2& p, const K::Point_2& q, const K::Point_2& r, const K::Point_2& s) const
    {
      ++count;
      return K::Side_of_oriented_circle_2::operator()(p, q, r, s);
    }
  };

  Side_of_oriented_circle_2 side_of_oriented_circle_2_object() const { return {}; }
};

TEST(Write_back_plus, vertices_of_needles_go_and_come_without_the_square_of_their_number)
{
  using Counting = CGAL::Constrained_triangulation_plus_2<domains::Cdt_of<Counting_kernel>>;
  std::vector<K::Point_2> star;
  for (int i = 0; i < 20; ++i) {
    const double angle = CGAL_PI / 10 * i, r = i % 2 == 1 ? 0.003 * (1 + i % 5) : 1 - 0.05 * (i % 7);
    star.emplace_back(r * std::cos(angle), r * std::sin(angle));
  }
  Counting cdt;
  cdt.insert_constraint(star.begin(), star.end(), true);
  CGAL::npbs_relax(cdt, size(0.13));
  Counting_kernel::count = 0;
  const auto report = CGAL::npbs_relax(cdt, size(0.13));
  EXPECT_GT(report.number_of_vertices, 5000u);
  EXPECT_LT(Counting_kernel::count, 300 * report.number_of_vertices);
  EXPECT_TRUE(cdt.is_valid());
}

/// The mesh alone is written as it is, and all else, outside or in holes, makes that it is inserted: the triangles of
/// the domain are those that a hierarchy gets, which is never written directly.
TEST(Direct_write, gives_the_triangles_that_insertion_gives)
{
  const Outline notched{{0, 0}, {1, 0}, {1, 1}, {0.5, 0.5}, {0, 1}};
  struct Beside
  {
    std::vector<Outline> outlines;
    Outline vertices, line;
  };
  for (const Beside& b : {Beside{{slanted, hole}, {}, {}}, Beside{{slanted}, {}, {}},
                          Beside{{slanted, hole}, {{0.52, 0.5}}, {}},
                          Beside{{slanted}, {{3, 3}}, {}}, Beside{{notched}, {{0.5, 0.9}, {3, 2}}, {}},
                          Beside{{notched}, {}, {{0.5, 0.5}, {0.5, 0.8}}}}) {
    const auto relaxed = [&b](auto cdt) {
      for (const auto& p : b.vertices)
        cdt.insert(domains::Point(p.first, p.second));
      if (!b.line.empty())
        domains::insert(cdt, b.line, false);
      std::vector<std::vector<validation::Triangle>> result;
      for (double d : {0.1, 0.06, 0.15}) { // the second time there is a mesh
        CGAL::npbs_relax(cdt, size(d));
        validation::expect_valid_mesh(cdt, {b.vertices.begin(), b.vertices.end()});
        result.push_back(validation::triangles(cdt));
      }
      return result;
    };
    EXPECT_TRUE(relaxed(domains::make(b.outlines)) == relaxed(domains::make<Plus>(b.outlines)));
  }
}

TEST(Direct_write, of_single_triangles)
{
  for (double turn : {0., 0.1, 2.}) {
    Outline triangle;
    for (int k = 0; k < 3; ++k)
      triangle.emplace_back(std::cos(turn + 2.1 * k), std::sin(turn + 2.1 * k));
    for (double d : {10., 0.5}) {
      const domains::CDT cdt = domains::mesh({triangle}, d);
      validation::expect_valid_mesh(cdt);
      EXPECT_NEAR(validation::domain_area(cdt), domains::area(triangle), 1e-14);
    }
  }
}

TEST(Direct_write, content_comes_back_after_an_error)
{
  domains::CDT cdt = domains::mesh({slanted, hole}, 0.1);
  const validation::Snapshot before = validation::snapshot(cdt);
  CGAL::Bubble_relaxation_2::internal::Content_backup_2<domains::CDT> backup(cdt);
  cdt.tds().faces().clear();
  cdt.tds().create_vertex();
  backup.restore();
  EXPECT_TRUE(validation::snapshot(cdt) == before);
  validation::expect_valid_mesh(cdt);
}

/// Vertices on slanted edges lie beside them by a rounding, which changes when the treatment slides them: what is
/// beyond the edge, slivers or the hull, must stay valid.
TEST(Direct_write, of_treated_vertices_on_slanted_edges)
{
  std::size_t treated = 0;
  for (int k = 0; k < 40; ++k) {
    const double turn = 0.1 + 0.157 * k, d = 0.07 + 0.003 * k;
    Outline outline;
    for (int i = 0; i < 3 + k % 3; ++i) {
      const double angle = turn + 6.283185307179586 * i / (3 + k % 3);
      outline.emplace_back(std::cos(angle), std::sin(angle));
    }
    domains::CDT cdt = domains::make({outline});
    const auto report = CGAL::npbs_relax(cdt, size(d));
    treated += report.number_of_treated_vertices;
    validation::expect_valid_mesh(cdt);
    EXPECT_NEAR(validation::domain_area(cdt), domains::area(outline), 1e-12);
  }
  EXPECT_GT(treated, 100u);
}

/// a wall opposite to a tip of the domain, with a gap between them that is not in the domain
TEST(Direct_write, beside_narrow_gaps_outside_of_the_domain)
{
  for (double gap : {0.02, 0.005, 0.001})
    for (double d : {0.05, 0.083, 0.11}) {
      const Outline clamp{{0, 0}, {1, 0}, {1, 0.5}, {0.2, 0.5}, {0.2, 0.8}, {0.4, 0.8}, {0.6, 0.5 + gap},
                          {0.8, 0.8}, {1, 0.8}, {1, 1}, {0, 1}};
      const domains::CDT cdt = domains::mesh({clamp}, d);
      validation::expect_valid_mesh(cdt);
      EXPECT_NEAR(validation::domain_area(cdt), domains::area(clamp), 1e-12);
    }
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

struct Enough : std::runtime_error
{
  Enough() : std::runtime_error("enough") {}
};

/// a polyline of a hierarchy, with what can be seen of it
struct Polyline
{
  Plus::Constraint_id id;
  std::vector<std::pair<Plus::Vertex_handle, bool>> vertices; // with the input flags
  std::vector<domains::Point> points;

  bool operator==(const Polyline& p) const { return id == p.id && vertices == p.vertices && points == p.points; }
};

std::vector<Polyline> polylines(const Plus& cdt)
{
  std::vector<Polyline> result;
  for (auto c = cdt.constraints_begin(); c != cdt.constraints_end(); ++c) {
    result.push_back({*c, {}, {cdt.points_in_constraint_begin(*c), cdt.points_in_constraint_end(*c)}});
    for (auto v = cdt.vertices_in_constraint_begin(*c); v != cdt.vertices_in_constraint_end(*c); ++v)
      result.back().vertices.push_back({*v, v.input()});
  }
  return result;
}

/// all that can be seen of a triangulation with its polylines, handles and identifiers included
auto everything(const Plus& cdt) { return std::pair(validation::Content<Plus>(cdt), polylines(cdt)); }

/// a mesh with polylines: one closed with a point given on a straight side, one open, one apart
Plus mesh_with_polylines()
{
  Plus cdt;
  domains::insert(cdt, {{0, 0}, {0.4, 0}, {1, 0}, {1, 1}, {0, 1}});
  domains::insert(cdt, {{0.2, 0.3}, {0.5, 0.35}, {0.8, 0.7}}, false);
  cdt.insert_constraint(domains::Point(0.3, 0.1), domains::Point(0.35, 0.25));
  CGAL::npbs_relax(cdt, size(0.15));
  return cdt;
}

/// without handles: the polylines as places with their input flags, and all else that has a place
auto everything_by_places(const Plus& cdt)
{
  std::multiset<std::vector<std::pair<validation::Xy, bool>>> lines;
  for (const Polyline& p : polylines(cdt)) {
    std::vector<std::pair<validation::Xy, bool>> line;
    for (const auto& [v, is_input] : p.vertices)
      line.push_back({validation::xy(v), is_input});
    lines.insert(line);
  }
  return std::pair(validation::snapshot(cdt), lines);
}

/// later relaxations do what they do in a triangulation in which nothing was ever thrown
void expect_same_later(Plus& cdt)
{
  Plus other = mesh_with_polylines();
  for (double d : {0.07, 0.2}) {
    CGAL::npbs_relax(cdt, size(d));
    CGAL::npbs_relax(other, size(d));
    EXPECT_TRUE(everything_by_places(cdt) == everything_by_places(other));
  }
}

TEST(Write_back_plus, exceptions_of_the_size_leave_everything_as_it_was)
{
  std::size_t calls = 0;
  const auto counting = [&](const domains::Point&) {
    ++calls;
    return 0.1;
  };
  Plus counted = mesh_with_polylines();
  CGAL::npbs_relax(counted, CGAL::parameters::sizing_function(std::cref(counting)));
  Plus cdt = mesh_with_polylines();
  const auto before = everything(cdt);
  for (std::size_t at : {std::size_t(1), calls / 2, calls - 200, calls - 1, calls}) {
    SCOPED_TRACE(at);
    std::size_t left = at;
    const auto throwing = [&left](const domains::Point&) { return --left == 0 ? throw Enough() : 0.1; };
    EXPECT_THROW(CGAL::npbs_relax(cdt, CGAL::parameters::sizing_function(throwing)), Enough);
    EXPECT_TRUE(everything(cdt) == before);
  }
  expect_same_later(cdt);
}

TEST(Write_back_plus, an_exception_of_the_callback_before_the_writing_leaves_everything_as_it_was)
{
  Plus cdt = mesh_with_polylines();
  const auto before = everything(cdt);
  const auto throwing = [](double fraction) { return fraction < 0.95 ? true : throw Enough(); }; // where writing begins
  EXPECT_THROW(CGAL::npbs_relax(cdt, size(0.1).callback(throwing)), Enough);
  EXPECT_TRUE(everything(cdt) == before);
  expect_same_later(cdt);
}

TEST(Write_back_plus, an_exception_of_the_last_callback_gives_the_content_back)
{
  Plus cdt = mesh_with_polylines();
  const auto before = everything_by_places(cdt);
  const auto throwing = [](double fraction) { return fraction < 1 ? true : throw Enough(); };
  EXPECT_THROW(CGAL::npbs_relax(cdt, size(0.1).callback(throwing)), Enough);
  EXPECT_TRUE(everything_by_places(cdt) == before);
  expect_same_later(cdt);
}

TEST(Write_back_plus, content_comes_back_after_an_error_of_the_writing)
{
  Plus cdt = mesh_with_polylines();
  const auto before = everything_by_places(cdt);
  {
    CGAL::Bubble_relaxation_2::internal::Content_backup_2<Plus> backup(cdt);
    cdt.insert(domains::Point(0.7, 0.2));
    cdt.insert_constraint(domains::Point(0.6, 0.1), domains::Point(0.6, 0.4));
    EXPECT_FALSE(everything_by_places(cdt) == before);
    backup.restore();
  }
  EXPECT_TRUE(everything_by_places(cdt) == before);
  EXPECT_TRUE(cdt.is_valid());
  cdt.insert_constraint(domains::Point(0.6, 0.1), domains::Point(0.6, 0.4));
  for (auto f : cdt.all_face_handles()) // the new line's faces have no marks
    f->set_in_domain(false);
  CGAL::npbs_relax(cdt, size(0.1));
  validation::expect_valid_mesh(cdt);
  EXPECT_EQ(cdt.number_of_constraints(), 4u);
  EXPECT_GT(cdt.number_of_vertices(), 90u);
}

TEST(Write_back_plus, points_of_polylines_are_those_of_their_vertices)
{
  Plus cdt = mesh_with_polylines();
  for (int k = 0; k < 3; ++k)
    for (double d : {0.1, 0.05}) {
      CGAL::npbs_relax(cdt, size(d));
      for (const Polyline& p : polylines(cdt)) {
        std::vector<domains::Point> of_vertices;
        for (const auto& [v, is_input] : p.vertices)
          of_vertices.push_back(v->point());
        EXPECT_EQ(p.points, of_vertices);
      }
    }
}

TEST(Write_back_plus, points_that_the_user_kept_stay)
{
  // as after a simplification of polylines that keeps the points
  Plus cdt;
  const auto id = domains::insert(cdt, {{0, 0}, {0.5, 0.1}, {1, 0}, {1, 1}, {0, 1}});
  cdt.simplify(std::next(cdt.vertices_in_constraint_begin(id)));
  for (double d : {0.1, 0.2}) {
    CGAL::npbs_relax(cdt, size(d));
    EXPECT_EQ(std::count(cdt.points_in_constraint_begin(id), cdt.points_in_constraint_end(id),
                         domains::Point(0.5, 0.1)), 1);
    EXPECT_EQ(std::distance(cdt.points_in_constraint_begin(id), cdt.points_in_constraint_end(id)),
              1 + std::distance(cdt.vertices_in_constraint_begin(id), cdt.vertices_in_constraint_end(id)));
  }
}

TEST(Write_back_report, describes_the_mesh_that_is_written)
{
  domains::CDT cdt = domains::make({slanted, hole});
  domains::insert(cdt, {{0.2, 0.2}, {0.8, 0.3}}, false);
  cdt.insert(domains::Point(2, 2)); // outside
  const auto d = [](const domains::Point& p) { return 0.03 + 0.05 * p.x(); };
  const auto report = CGAL::npbs_relax(cdt, CGAL::parameters::sizing_function(d));
  const auto quality = CGAL::mesh_quality_2(cdt, CGAL::parameters::sizing_function(d));
  EXPECT_EQ(report.number_of_vertices, quality.number_of_vertices());
  EXPECT_EQ(report.number_of_triangles, quality.number_of_triangles());
  EXPECT_EQ(report.quality.number_of_interior_vertices(), quality.number_of_interior_vertices());
  EXPECT_EQ(report.quality.irregular_share(), quality.irregular_share());
  EXPECT_NEAR(report.quality.minimum_quality(), quality.minimum_quality(), 1e-12);
  EXPECT_NEAR(report.quality.mean_quality(), quality.mean_quality(), 1e-12);
  EXPECT_NEAR(report.quality.minimum_angle(), quality.minimum_angle(), 1e-9);
  EXPECT_NEAR(report.quality.mean_length_ratio(), quality.mean_length_ratio(), 1e-12);
  EXPECT_NEAR(report.quality.length_ratio_deviation(), quality.length_ratio_deviation(), 1e-12);
  EXPECT_NEAR(report.quality.length_ratio_percentile(99), quality.length_ratio_percentile(99), 1e-12);
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

TEST(Write_back_exact, the_size_may_be_a_number_of_the_kernel)
{
  Exact_cdt cdt = domains::make<Exact_cdt>({slanted}), other = cdt;
  CGAL::npbs_relax(cdt, CGAL::parameters::sizing_function(Exact::FT(0.1)));
  CGAL::npbs_relax(other, size(0.1));
  EXPECT_TRUE(validation::snapshot(cdt) == validation::snapshot(other));
  EXPECT_THROW(CGAL::npbs_relax(cdt, CGAL::parameters::sizing_function(Exact::FT(-1))),
               std::invalid_argument);
}

TEST(Write_back_plain, faces_need_no_mark)
{
  CGAL::Constrained_Delaunay_triangulation_2<K> cdt;
  domains::insert(cdt, slanted);
  domains::insert(cdt, hole);
  const auto report = CGAL::npbs_relax(cdt, size(0.05));
  EXPECT_TRUE(cdt.is_valid());
  EXPECT_GE(report.quality.mean_quality(), 0.988);
}

template <class Face_base>
CGAL::Bubble_relaxation_report_2<double> relax_beside_a_crossing_that_is_rounded()
{
  using Cdt = CGAL::Constrained_Delaunay_triangulation_2<
    K, CGAL::Triangulation_data_structure_2<CGAL::Triangulation_vertex_base_2<K>, Face_base>, CGAL::Exact_predicates_tag>;
  Cdt cdt = domains::make<Cdt>({{{0, 0},
                                 {1, 0},
                                 {0.99999999999999978, 5.5924611234959882e-10},
                                 {1.0000000000000007, 9.8813129168249309e-324},
                                 {0.99999999999999989, -4.9406564584124654e-324},
                                 {1, 1},
                                 {0.99999999999925171, 0.99999999999996236},
                                 {0, 1},
                                 {9.8813129168249309e-324, 0.99999999999999989}}});
  for (const K::Point_2& p : {K::Point_2(0.02, 0.17), K::Point_2(0, 0.1)})
    cdt.insert(p);
  return CGAL::npbs_relax(cdt);
}

TEST(Write_back_plain, the_report_counts_what_is_written_without_marks_too)
{
  const auto marked = relax_beside_a_crossing_that_is_rounded<CGAL::Delaunay_mesh_face_base_2<K>>();
  const auto plain = relax_beside_a_crossing_that_is_rounded<CGAL::Constrained_triangulation_face_base_2<K>>();
  EXPECT_EQ(plain.number_of_vertices, marked.number_of_vertices);
  EXPECT_EQ(plain.number_of_triangles, marked.number_of_triangles);
  EXPECT_EQ(plain.quality.number_of_triangles(), plain.number_of_triangles);
}

TEST(Write_back_default_size, an_existing_mesh_keeps_its_size)
{
  domains::CDT cdt = domains::make({domains::square(0, 0, 1)});
  const auto first = CGAL::npbs_relax(cdt, size(0.07));
  const auto second = CGAL::npbs_relax(cdt);
  EXPECT_NEAR(double(second.number_of_vertices), double(first.number_of_vertices),
              0.01 * double(first.number_of_vertices));
  EXPECT_GE(second.quality.mean_quality(), 0.991);
}

TEST(Write_back_keep, the_population_stays_if_it_shall)
{
  domains::CDT cdt = domains::mesh({domains::square(0, 0, 1)}, 0.1);
  const std::size_t n = cdt.number_of_vertices();
  const auto report = CGAL::npbs_relax(
    cdt, size(0.1).initial_placement(CGAL::Bubble_placement::KEEP)
           .population_control(CGAL::Bubble_population::NONE));
  EXPECT_EQ(cdt.number_of_vertices(), n);
  EXPECT_EQ(report.number_of_initial_bubbles, n);
}

} // namespace test_write_back
