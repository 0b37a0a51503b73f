// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// Threads do not change a bit.

#include "../../../demo/Bubble_relaxation_2/paper_domains.h"
#include "random_seeds.h"
#include "validation.h"

#include <CGAL/Bubble_relaxation_2/internal/fields/Interpolated_field_2.h>
#include <CGAL/npbs_adapt.h>
#include <CGAL/npbs_place_nodes.h>
#include <CGAL/npbs_relax.h>

#include <array>
#include <random>
#include <utility>
#include <vector>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

TEST(Size_of_the_mesh, on_an_edge_does_not_depend_on_what_was_asked_before)
{
  // random points on both sides of x = 0.3, edges between them on x = 0.3
  std::mt19937 random(random_seeds::seed());
  std::uniform_real_distribution<double> uniform(0., 1.);
  paper::CDT cdt;
  const std::vector<paper::Point> outline{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  cdt.insert_constraint(outline.begin(), outline.end(), true);
  cdt.insert_constraint(paper::Point(0.3, 0.01), paper::Point(0.3, 0.99));
  for (int k = 0; k < 300; ++k)
    cdt.insert(paper::Point(uniform(random), uniform(random)));
  using namespace CGAL::Bubble_relaxation_2::internal;
  const Domain_marks_2<paper::CDT> marks(cdt, CGAL::parameters::default_values());
  const auto field = mean_edge_length_field(marks, 0.5);
  for (int k = 0; k < 1000; ++k) {
    const double y = 0.01 + 0.98 * uniform(random);
    field(0.29, y); // leaves the search on the left
    const double from_left = field(0.3, y);
    field(0.31, y);
    EXPECT_EQ(from_left, field(0.3, y)) << y;
  }
  for (auto v : cdt.finite_vertex_handles()) {
    field(0.01, 0.5);
    const double x = v->point().x(), y = v->point().y(), from_left = field(x, y);
    field(0.99, 0.5);
    EXPECT_EQ(from_left, field(x, y));
  }
}

#ifdef CGAL_LINKED_WITH_TBB

TEST(Concurrency, parts_have_the_same_bits_for_any_number_of_threads)
{
  const paper::Domain domain = paper::square_with_hole(0.3);
  const auto adapted = [&domain](auto tag) {
    paper::CDT cdt = paper::triangulate(domain);
    CGAL::npbs_relax(cdt, CGAL::parameters::sizing_function(domain.d));
    const auto finer = [&domain](const paper::Point& p) { return (p.x() > 0.3 ? 0.5 : 1.) * domain.d(p); };
    CGAL::npbs_adapt(cdt, CGAL::parameters::sizing_function(finer).concurrency_tag(tag));
    return validation::triangles(cdt);
  };
  const auto sequential = adapted(CGAL::Sequential_tag());
  ASSERT_GT(sequential.size(), 3000u);
  for (std::size_t threads : {1u, 2u, 3u}) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    EXPECT_TRUE(adapted(CGAL::Parallel_tag()) == sequential);
  }
}

TEST(Concurrency, same_bits_for_any_number_of_threads)
{
  for (const paper::Domain& domain : {paper::square_with_hole(0.3), paper::graded_circle(0.5)}) {
    const paper::CDT cdt = paper::triangulate(domain);
    for (auto integrator :
         {CGAL::Bubble_integrator::SEMI_IMPLICIT_EULER, CGAL::Bubble_integrator::RUNGE_KUTTA_4}) {
      const auto np =
        CGAL::parameters::integrator(integrator).sizing_function(domain.d).number_of_rounds(3);
      const auto sequential =
        CGAL::npbs_place_nodes(cdt, np.concurrency_tag(CGAL::Sequential_tag()));
      ASSERT_GT(sequential.size(), 3000u);
      for (int threads : {1, 2, 3, 8}) {
        tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
        const auto parallel = CGAL::npbs_place_nodes(cdt, np.concurrency_tag(CGAL::Parallel_tag()));
        EXPECT_TRUE(parallel.points == sequential.points) << threads;
        EXPECT_TRUE(parallel.sizes == sequential.sizes) << threads;
      }
    }
  }
}

/// more bubbles than what is done at once anywhere; and all of `npbs_relax()`
TEST(Concurrency, same_bits_of_large_meshes)
{
  const paper::Domain domain = paper::graded_circle(0.16);
  const auto mesh = [&domain](auto tag) {
    paper::CDT cdt = paper::triangulate(domain);
    const auto report = CGAL::npbs_relax(
      cdt, CGAL::parameters::sizing_function(domain.d).number_of_rounds(4).concurrency_tag(tag));
    std::vector<std::array<paper::Point, 3>> triangles;
    for (auto f : cdt.finite_face_handles())
      triangles.push_back({f->vertex(0)->point(), f->vertex(1)->point(), f->vertex(2)->point()});
    std::vector<double> figures{
      report.quality.mean_quality(),      report.quality.minimum_quality(), report.quality.minimum_angle(),
      report.quality.mean_length_ratio(), report.quality.length_ratio_deviation(),
      report.quality.irregular_share(),   report.largest_size_gradient,     report.steepest_x,
      report.steepest_y};
    return std::make_pair(triangles, figures);
  };
  const auto sequential = mesh(CGAL::Sequential_tag());
  ASSERT_GT(sequential.first.size(), 80000u);
  for (int threads : {2, 3}) {
    tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    const auto parallel = mesh(CGAL::Parallel_tag());
    EXPECT_TRUE(parallel.first == sequential.first) << threads;
    EXPECT_EQ(parallel.second, sequential.second) << threads;
  }
}

TEST(Concurrency, same_bits_with_the_size_of_the_mesh)
{
  // bubbles slide exactly on inner edges of the mesh that gives the size: which triangle is found beside
  // such an edge depends on what was asked before, and by which thread
  paper::CDT cdt = paper::triangulate(paper::square_with_hole(0.5));
  for (double c : {0.07, 0.13, 0.29}) {
    cdt.insert_constraint(paper::Point(c - 0.9, 0.05), paper::Point(c - 0.9, 0.9));
    cdt.insert_constraint(paper::Point(0.05, c - 0.95), paper::Point(0.9, c - 0.95));
  }
  CGAL::npbs_relax(cdt, CGAL::parameters::sizing_function(
                          [](const paper::Point& p) { return 0.02 + 0.03 * std::abs(p.x() * p.y()); }));
  const auto np = CGAL::parameters::number_of_rounds(4);
  const auto sequential = CGAL::npbs_place_nodes(cdt, np.concurrency_tag(CGAL::Sequential_tag()));
  ASSERT_GT(sequential.size(), 1000u);
  EXPECT_TRUE(CGAL::npbs_place_nodes(cdt, np).points == sequential.points) << "the first call left a trace";
  for (int threads : {1, 2, 3, 8}) {
    tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    const auto parallel = CGAL::npbs_place_nodes(cdt, np.concurrency_tag(CGAL::Parallel_tag()));
    EXPECT_TRUE(parallel.points == sequential.points) << threads;
    EXPECT_TRUE(parallel.sizes == sequential.sizes) << threads;
  }
}

TEST(Concurrency, exceptions_of_the_sizing_function_pass_through)
{
  const paper::CDT cdt = paper::triangulate(paper::l_shape(1));
  std::atomic<int> left(2000);
  const auto d = [&left](const paper::Point&) {
    if (--left == 0)
      throw std::runtime_error("enough");
    return 0.05;
  };
  EXPECT_THROW(CGAL::npbs_place_nodes(cdt, CGAL::parameters::sizing_function(std::cref(d))
                                             .concurrency_tag(CGAL::Parallel_tag())),
               std::runtime_error);
}

#else

TEST(Concurrency, needs_tbb)
{
  GTEST_SKIP() << "built without TBB";
}

#endif
