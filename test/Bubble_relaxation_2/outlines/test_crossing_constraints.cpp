// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// Constraints that cross: what each of CGAL's intersection tags makes of them, and of that npbs_relax.

#include "domains.h"
#include "expect_throw.h"
#include "validation.h"

#include <CGAL/Constrained_triangulation_plus_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/npbs_relax.h>
#include <CGAL/simplify_outline_2.h>

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

namespace test_crossing_constraints {

using domains::Cdt_of;
using Inexact = domains::K;
using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
using Default = domains::CDT;
using None = Cdt_of<Inexact, CGAL::No_constraint_intersection_tag>;

/// in a square two inner constraints that cross, beside a hole, so that there is more than the domain
template <class CDT>
CDT crossing()
{
  CDT cdt = domains::make<CDT>({domains::square(0, 0, 1), domains::square(0.7, 0.7, 0.2)});
  domains::insert(cdt, {{0.1, 0.2}, {0.9, 0.6}}, false);
  domains::insert(cdt, {{0.2, 0.9}, {0.6, 0.1}}, false);
  return cdt;
}

template <class CDT>
class Crossing : public testing::Test
{};

using Crossable = testing::Types<
  Cdt_of<Inexact, CGAL::Exact_predicates_tag>,
  CGAL::Constrained_triangulation_plus_2<Cdt_of<Inexact, CGAL::Exact_predicates_tag>>,
  CGAL::Constrained_triangulation_plus_2<Cdt_of<Exact, CGAL::Exact_intersections_tag>>>;

TYPED_TEST_SUITE(Crossing, Crossable);

TYPED_TEST(Crossing, becomes_a_corner)
{
  auto cdt = crossing<TypeParam>();
  const validation::Snapshot before = validation::snapshot(cdt);
  EXPECT_EQ(cdt.number_of_vertices(), 13u);
  const auto report = CGAL::npbs_relax(cdt, CGAL::parameters::sizing_function(0.1));
  validation::expect_valid_mesh(cdt);
  validation::expect_constraints_kept(before, validation::snapshot(cdt));
  EXPECT_GT(report.quality.minimum_quality(), 0.8);
}

TYPED_TEST(Crossing, what_is_in_two_outlines_is_a_hole)
{
  auto cdt = domains::make<TypeParam>({domains::square(0, 0, 1), domains::square(0.5, 0.5, 1)});
  CGAL::npbs_relax(cdt, CGAL::parameters::sizing_function(0.1));
  double area = 0;
  for (auto f : cdt.finite_face_handles())
    if (f->is_in_domain())
      area += CGAL::to_double(cdt.triangle(f).area());
  EXPECT_NEAR(area, 1.5, 1e-12);
}

TEST(Crossing_of_exact, ends_in_one_place_when_rounded)
{
  using CDT = Cdt_of<Exact, CGAL::Exact_intersections_tag>;
  // two ends that only exact numbers can tell from each other
  CDT cdt = domains::make<CDT>({domains::square(0, 0, 1)});
  const Exact::FT little = Exact::FT(1) / (Exact::FT(1e20) * 3);
  cdt.insert_constraint(CDT::Point(0.5, 1 - little), CDT::Point(0.25, 0.5));
  cdt.insert_constraint(CDT::Point(0.5, 1 - 2 * little), CDT::Point(0.75, 0.5));
  const validation::Snapshot before = validation::snapshot(cdt);
  EXPECT_THROW(CGAL::npbs_relax(cdt, CGAL::parameters::sizing_function(0.1)), std::invalid_argument);
  EXPECT_TRUE(validation::snapshot(cdt) == before);
}

TEST(Crossing_of_default, is_refused_by_insertion)
{
  Default cdt = domains::make({domains::square(0, 0, 1)});
  domains::insert(cdt, {{0.125, 0.25}, {0.875, 0.625}}, false);
  EXPECT_THROW(domains::insert(cdt, {{0.2, 0.9}, {0.6, 0.1}}, false), Default::Intersection_of_constraints_exception);
  // they may meet in vertices, and lie on each other
  domains::insert(cdt, {{0.5, 0.4375}, {0.5, 0}}, false);
  domains::insert(cdt, {{0.125, 0.25}, {0.5, 0.4375}}, false);
  CGAL::npbs_relax(cdt, CGAL::parameters::sizing_function(0.1));
  validation::expect_valid_mesh(cdt);
}

TEST(Crossing_of_none, constraints_are_split_by_bubbles)
{
  // CGAL takes a vertex on a constraint for a crossing, but a bubble is none
  None cdt = domains::make<None>({domains::square(0, 0, 1), {{0.4, 0.4}, {0.7, 0.43}, {0.5, 0.65}}});
  cdt.insert(None::Point(0.52, 0.48)); // in the hole: the mesh is not all that there is, so it is written by insertion
  const validation::Snapshot before = validation::snapshot(cdt);
  const auto report = CGAL::npbs_relax(cdt, 0.1);
  EXPECT_TRUE(report.converged);
  validation::expect_constraints_kept(before, validation::snapshot(cdt));
  EXPECT_TRUE(cdt.is_valid());
}

TEST(Crossing_that_is_rounded, may_leave_edges_of_no_constraint)
{
  using Plus = CGAL::Constrained_triangulation_plus_2<Cdt_of<Inexact, CGAL::Exact_predicates_tag>>;
  // the place where the last side crosses the top of the square is rounded onto it
  const domains::Outline outline{{0, 0}, {1.7e-16, 7.6e-14}, {1, 0}, {1, 1}, {0, 1},
                                 {4.9691305262083531e-16, 0.99999999999999589},
                                 {1.4821969375237396e-323, 0.99999999999999978},
                                 {4.0666390579824734e-12, 1.0000000003243423}};
  Plus cdt = domains::make<Plus>({outline});
  ASSERT_TRUE(cdt.is_valid());
  const validation::Snapshot before = validation::snapshot(cdt);
  const auto expect_refusal = [&](const auto& call) {
    expect_invalid(call, {"the edge from", ", 1) is constrained", "belongs to no constraint"});
  };
  expect_refusal([&] { CGAL::npbs_relax(cdt, 0.1); });
  expect_refusal([&] { CGAL::simplify_outline_2(cdt, 0.1); });
  EXPECT_TRUE(validation::snapshot(cdt) == before);
}

} // namespace test_crossing_constraints
