// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// The same d for CGAL's Delaunay refinement, and its mesh as input of the relaxation.

#include "../../../demo/Bubble_relaxation_2/paper_domains.h"
#include "rough_outlines.h"
#include "validation.h"

#include <CGAL/Bubble_mesh_criteria_2.h>
#include <CGAL/Delaunay_mesh_size_criteria_2.h>
#include <CGAL/Delaunay_mesher_2.h>
#include <CGAL/npbs_relax.h>

namespace test_mesh_criteria {

using paper::CDT;
using Criteria = CGAL::Bubble_mesh_criteria_2<CDT, paper::Sizing>;

CDT refined(const paper::Domain& domain)
{
  CDT cdt = paper::triangulate(domain);
  CGAL::Delaunay_mesher_2<CDT, Criteria> mesher(cdt, Criteria(domain.d));
  mesher.refine_mesh();
  return cdt;
}

TEST(Mesh_criteria, refinement_follows_the_size)
{
  for (const paper::Domain& domain :
       {paper::non_convex(1), paper::graded_square(1), paper::graded_circle(0.7), paper::l_shape(0.5)}) {
    SCOPED_TRACE(domain.name);
    const CDT cdt = refined(domain);
    const auto q = CGAL::mesh_quality_2(cdt, CGAL::parameters::sizing_function(domain.d));
    EXPECT_NEAR(q.mean_length_ratio(), 1, 0.025);
    EXPECT_GT(q.minimum_angle(), 24.5);
    for (CDT::Face_handle f : cdt.finite_face_handles()) {
      if (!f->is_in_domain())
        continue;
      const paper::Point c =
        CGAL::centroid(f->vertex(0)->point(), f->vertex(1)->point(), f->vertex(2)->point());
      for (int i = 0; i < 3; ++i)
        EXPECT_LE(std::sqrt(cdt.segment(f, i).squared_length()),
                  Criteria::size_factor * domain.d(c) * (1 + 1e-12));
    }
  }
}

TEST(Mesh_criteria, function_interface)
{
  const paper::Domain domain = paper::l_shape(1);
  CDT cdt = paper::triangulate(domain);
  const auto criteria = CGAL::make_bubble_mesh_criteria_2(cdt, [](const paper::Point&) { return 0.1; });
#if CGAL_VERSION_NR >= 1050600000
  CGAL::refine_Delaunay_mesh_2(cdt, CGAL::parameters::criteria(criteria));
#else
  CGAL::refine_Delaunay_mesh_2(cdt, criteria);
#endif
  EXPECT_NEAR(double(cdt.number_of_vertices()), 94, 3);
}

TEST(Mesh_criteria, of_a_lambda_can_be_set_anew)
{
  const paper::Domain domain = paper::l_shape(1);
  CDT cdt = paper::triangulate(domain);
  double d = 0.2;
  const auto sizing = [&d](const paper::Point&) { return d; };
  auto criteria = CGAL::make_bubble_mesh_criteria_2(cdt, sizing);
  CGAL::Delaunay_mesher_2<CDT, decltype(criteria)> mesher(cdt, criteria);
  mesher.refine_mesh();
  const std::size_t n = cdt.number_of_vertices();
  d = 0.1;
  mesher.set_criteria(CGAL::make_bubble_mesh_criteria_2(cdt, sizing));
  mesher.refine_mesh();
  EXPECT_GT(cdt.number_of_vertices(), 2 * n);
  criteria = CGAL::make_bubble_mesh_criteria_2(cdt, sizing, 0.1);
}

TEST(Mesh_criteria, a_bad_size_is_refused)
{
  const paper::Domain domain = paper::l_shape(1);
  CDT cdt = paper::triangulate(domain);
  CGAL::Delaunay_mesher_2<CDT, Criteria> mesher(cdt, Criteria([](const paper::Point&) { return -1.; }));
  EXPECT_THROW(mesher.refine_mesh(), std::invalid_argument);
}

TEST(Mesh_criteria, relaxation_improves_the_mesh_and_keeps_its_size)
{
  for (const paper::Domain& domain : {paper::non_convex(1), paper::graded_square(0.7), paper::l_shape(0.5)}) {
    SCOPED_TRACE(domain.name);
    CDT cdt = refined(domain);
    const validation::Snapshot outline = validation::snapshot(paper::triangulate(domain));
    const auto before = CGAL::mesh_quality_2(cdt, CGAL::parameters::sizing_function(domain.d));
    const auto report = CGAL::npbs_relax(cdt, CGAL::parameters::sizing_function(domain.d));
    validation::expect_mesh_of(outline, cdt);
    EXPECT_GT(report.quality.mean_quality(), before.mean_quality() + 0.04);
    // the meshes of CGAL's refinement differ between its versions
    EXPECT_GE(report.quality.mean_quality(), 0.983);
    EXPECT_GE(report.quality.minimum_quality(), 0.82);
    EXPECT_GT(report.quality.minimum_quality(), before.minimum_quality());
    EXPECT_NEAR(report.quality.mean_length_ratio(), 0.985, 0.014);
  }
}

TEST(Mesh_criteria, refined_mesh_can_be_made_finer_and_coarser)
{
  const paper::Domain domain = paper::l_shape(0.7);
  CDT cdt = refined(domain);
  const std::size_t n = cdt.number_of_vertices();
  const auto finer = CGAL::npbs_relax(
    cdt, CGAL::parameters::sizing_function([&](const paper::Point& p) { return domain.d(p) / 2; }));
  EXPECT_NEAR(double(finer.number_of_vertices), 3.69 * double(n), 0.05 * double(n));
  EXPECT_GE(finer.quality.mean_quality(), 0.9915);
  EXPECT_GE(finer.quality.minimum_quality(), 0.8);
  const auto coarser = CGAL::npbs_relax(
    cdt, CGAL::parameters::sizing_function([&](const paper::Point& p) { return domain.d(p) * 2; }));
  EXPECT_NEAR(double(coarser.number_of_vertices), 0.27 * double(n), 0.01 * double(n));
  EXPECT_GE(coarser.quality.mean_quality(), 0.971);
  EXPECT_GE(coarser.quality.minimum_quality(), 0.8);
  validation::expect_valid_mesh(cdt);
}

/// Sizes of a mesh that is refined from short pieces of a coast to large triangles double from edge to edge, and no packing
/// follows that.
TEST(Mesh_criteria, coast_is_relaxed_without_a_size)
{
  for (unsigned seed : {1u, 2u, 3u}) {
    SCOPED_TRACE(seed);
    CDT cdt;
    for (const domains::Outline& outline : rough_outlines::archipelago(seed))
      domains::insert(cdt, outline);
    CGAL::Delaunay_mesher_2<CDT, CGAL::Delaunay_mesh_size_criteria_2<CDT>> mesher(cdt, {0.125, 1});
    mesher.refine_mesh();
    const auto before = CGAL::mesh_quality_2(cdt);
    const auto report = CGAL::npbs_relax(cdt);
    EXPECT_TRUE(report.converged);
    EXPECT_LT(double(report.number_of_moves), 45 * double(report.number_of_vertices));
    EXPECT_GT(report.quality.mean_quality(), before.mean_quality() + 0.12);
    EXPECT_GT(report.quality.minimum_angle(), before.minimum_angle() + 4);
    EXPECT_LT(report.number_of_small_angles, 60u);
    EXPECT_LT(double(report.number_of_vertices), 1.6 * double(before.number_of_vertices()));
  }
}

} // namespace test_mesh_criteria
