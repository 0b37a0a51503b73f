// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// The dual of meshes of bubbles: what holds for each, and that they are good for finite volumes.

#include "domains.h"
#include "dual_checks.h"
#include "random_seeds.h"
#include "rough_outlines.h"
#include "terrains.h"
#include "validation.h"

#include "../../../demo/Bubble_relaxation_2/paper_domains.h"

#include <CGAL/Constrained_triangulation_plus_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Voronoi_dual_2.h>
#include <CGAL/npbs_relax.h>
#include <CGAL/simplify_outline_2.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace test_voronoi_dual_meshes {

using domains::CDT;
using domains::K;
using domains::Point;
using dual_checks::expect_valid;
using Dual = CGAL::Voronoi_dual_2<CDT>;
namespace P = CGAL::parameters;

/// no triangle is obtuse and no face negative
void expect_good(const CGAL::Voronoi_quality_2& q, const std::string& name)
{
  EXPECT_EQ(q.number_of_obtuse_triangles, 0u) << name;
  EXPECT_EQ(q.number_of_centers_beyond_constraints, 0u) << name;
  EXPECT_EQ(q.number_of_negative_faces, 0u) << name;
  EXPECT_GT(q.smallest_face_ratio, 0.) << name;
  EXPECT_GT(q.smallest_area, 0.) << name;
  EXPECT_LT(q.largest_orthogonality_error, 1e-13) << name;
}

/// Each of random points of the domain lies in the cell of the vertex that is nearest to it.
void expect_cells_of_nearest(const CDT& cdt, const Dual& dual)
{
  const auto soup = dual.polygon_soup();
  std::vector<CGAL::Polygon_2<K>> polygons(dual.cells().size());
  for (std::size_t k = 0; k < soup.cells.size(); ++k)
    for (std::size_t corner : soup.polygons[k])
      polygons[soup.cells[k]].push_back(soup.points[corner]);
  std::mt19937 random(random_seeds::seed());
  std::uniform_real_distribution<double> share(0.05, 1);
  for (auto f : cdt.finite_face_handles()) {
    if (!f->is_in_domain())
      continue;
    const double a = share(random), b = share(random), c = share(random);
    const Point p = CGAL::barycenter(f->vertex(0)->point(), a, f->vertex(1)->point(), b, f->vertex(2)->point(), c);
    std::size_t nearest = 0;
    for (std::size_t k = 1; k < dual.cells().size(); ++k)
      if (CGAL::has_smaller_distance_to_point(p, dual.cells()[k].center, dual.cells()[nearest].center))
        nearest = k;
    // roundings put a point on a face on either side of it, which hardly ever comes
    EXPECT_TRUE(polygons[nearest].is_simple());
    EXPECT_TRUE(polygons[nearest].has_on_bounded_side(p)) << p;
  }
}

TEST(Voronoi_dual_meshes, of_a_square_with_hole)
{
  const CDT cdt = domains::mesh({domains::square(0, 0, 1), domains::square(0.4, 0.4, 0.2)}, 0.07);
  const Dual dual(cdt);
  expect_valid(dual, 0.96);
  expect_good(dual.quality(), "square with hole");
  expect_cells_of_nearest(cdt, dual);
}

TEST(Voronoi_dual_meshes, of_a_ring)
{
  const domains::Outline outer = domains::polygon(0, 0, 1, 60), inner = domains::polygon(0, 0, 0.5, 30);
  const CDT cdt = domains::mesh({outer, inner}, 0.1);
  const Dual dual(cdt);
  expect_valid(dual, domains::area(outer) - domains::area(inner));
  expect_good(dual.quality(), "ring");
  expect_cells_of_nearest(cdt, dual);
}

TEST(Voronoi_dual_meshes, of_an_outline_that_is_not_convex)
{
  const domains::Outline bent{{0, 0}, {2, 0}, {2, 1}, {1.2, 1}, {1, 1.6}, {0.4, 1.6}, {0, 1}};
  const CDT cdt = domains::mesh({bent}, 0.1);
  const Dual dual(cdt);
  expect_valid(dual, domains::area(bent));
  expect_good(dual.quality(), "bent");
  expect_cells_of_nearest(cdt, dual);
}

TEST(Voronoi_dual_meshes, of_constraints_within_the_domain)
{
  CDT cdt = domains::square_with_inner_constraints<CDT>();
  CGAL::npbs_relax(cdt, P::sizing_function(0.05));
  const Dual dual(cdt);
  expect_valid(dual, 1);
  EXPECT_EQ(dual.quality().number_of_centers_beyond_constraints, 0u);
  expect_cells_of_nearest(cdt, dual);
  std::size_t inner = 0;
  for (const auto& f : dual.faces()) {
    EXPECT_EQ(f.is_constrained, cdt.is_constrained(f.edge));
    inner += f.is_constrained && !f.is_on_boundary;
    if (f.is_constrained && !f.is_on_boundary) { // it ends on either side of the constraint
      EXPECT_GT(f.left_length, 0.);
      EXPECT_GT(f.right_length, 0.);
    }
  }
  EXPECT_GT(inner, 20u);
}

TEST(Voronoi_dual_meshes, of_a_pinned_vertex)
{
  CDT cdt = domains::make({domains::square(0, 0, 1)});
  const std::set<CDT::Vertex_handle> pins{cdt.insert(Point(0.31, 0.47))};
  CGAL::npbs_relax(cdt, P::sizing_function(0.08).vertex_is_constrained_map(CGAL::make_boolean_property_map(pins)));
  const Dual dual(cdt);
  expect_valid(dual, 1);
  expect_good(dual.quality(), "pin");
  const auto& cell = dual.cells().at(dual.cell_of(*pins.begin()));
  EXPECT_EQ(cell.center, Point(0.31, 0.47));
  EXPECT_NEAR(cell.area, 0.08 * 0.08 * std::sqrt(0.75), 0.05 * 0.08 * 0.08);
}

TEST(Voronoi_dual_meshes, of_other_triangulations)
{
  using Plus = CGAL::Constrained_triangulation_plus_2<domains::Cdt_of<K, CGAL::Exact_predicates_tag>>;
  Plus plus = domains::make<Plus>({domains::square(0, 0, 1)});
  domains::insert(plus, {{0.2, 0.1}, {0.7, 0.9}}, false);
  domains::insert(plus, {{0.2, 0.8}, {0.9, 0.3}}, false); // they cross
  CGAL::npbs_relax(plus, P::sizing_function(0.1));
  expect_valid(CGAL::Voronoi_dual_2<Plus>(plus), 1);

  using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
  using Exact_cdt = CGAL::Constrained_Delaunay_triangulation_2<Exact>;
  const auto exact = domains::mesh<Exact_cdt>({domains::square(0, 0, 1)}, 0.2);
  const CGAL::Voronoi_dual_2 dual(exact); // the parameter is deduced
  expect_valid(dual, 1);

  using Single = CGAL::Constrained_Delaunay_triangulation_2<CGAL::Simple_cartesian<float>>;
  const Single single = domains::make<Single>({domains::square(0, 0, 1)});
  EXPECT_EQ(dual_checks::total_area(CGAL::Voronoi_dual_2<Single>(single)), 1); // points have single precision
}

TEST(Voronoi_dual_meshes, of_a_terrain_is_that_of_its_projection)
{
  terrains::Terrain terrain;
  using Point_3 = terrains::Terrain::Point;
  const std::vector<Point_3> corners{{0, 0, 1}, {1, 0, 5}, {1, 1, -3}, {0, 1, 2}};
  terrain.insert_constraint(corners.begin(), corners.end(), true);
  CGAL::npbs_relax(terrain, P::sizing_function(0.15));
  const CGAL::Voronoi_dual_2<terrains::Terrain> dual(terrain);
  expect_valid(dual, 1);
  const Dual flat(domains::mesh({domains::square(0, 0, 1)}, 0.15));
  EXPECT_EQ(dual.quality().smallest_face_ratio, flat.quality().smallest_face_ratio);
}

TEST(Voronoi_dual_meshes, domains_of_the_benchmark_have_no_obtuse_triangle_and_no_negative_face)
{
  std::vector<paper::Domain> all = paper::all_domains(1);
  for (const paper::Domain& finer : paper::all_domains(0.5))
    all.push_back(finer);
  for (const paper::Domain& domain : all) {
    paper::CDT cdt = paper::triangulate(domain);
    CGAL::npbs_relax(cdt, P::sizing_function(domain.d));
    const CGAL::Voronoi_dual_2<paper::CDT> dual(cdt);
    expect_good(dual.quality(), domain.name);
    expect_valid(dual, validation::domain_area(cdt));
  }
}

TEST(Voronoi_dual_meshes, a_simplified_coast_has_no_obtuse_triangle_and_no_negative_face)
{
  CDT cdt = domains::make(rough_outlines::archipelago(1));
  constexpr double d = 0.15;
  CGAL::simplify_outline_2(
    cdt, P::sizing_function(d).relative_outline_tolerance(0.1).minimum_island_area(d * d / 2).minimum_gap(d));
  CGAL::npbs_relax(cdt, P::sizing_function(d));
  const Dual dual(cdt);
  expect_good(dual.quality(), "archipelago");
  expect_valid(dual, validation::domain_area(cdt));
}

} // namespace test_voronoi_dual_meshes
