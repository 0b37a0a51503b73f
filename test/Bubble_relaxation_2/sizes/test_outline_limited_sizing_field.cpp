// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// The sizes that npbs_relax() follows, told before there is a mesh.

#include "domains.h"
#include "expect_throw.h"
#include "rough_outlines.h"
#include "validation.h"

#include <CGAL/Outline_limited_sizing_field_2.h>
#include <CGAL/npbs_relax.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <functional>
#include <memory>
#include <stdexcept>

namespace test_outline_limited_sizing_field {

namespace P = CGAL::parameters;
using domains::CDT;
using domains::Point;
using Field = CGAL::Outline_limited_sizing_field_2<CDT>;

/// a square with a square hole that leaves a narrow of .02 on the left
CDT with_a_narrow() { return domains::make({domains::square(0, 0, 1), domains::square(0.02, 0.4, 0.2)}); }

/// the mean of edge length over size in the middle, in the domain, as the report has it
template <class Size>
double mean_length_ratio(const CDT& cdt, const Size& size)
{
  double sum = 0;
  int number = 0;
  for (const CDT::Edge& e : cdt.finite_edges())
    if (e.first->is_in_domain() || e.first->neighbor(e.second)->is_in_domain()) {
      const CDT::Segment s = cdt.segment(e);
      sum += std::sqrt(s.squared_length()) / size(CGAL::midpoint(s.source(), s.target()));
      ++number;
    }
  return sum / number;
}

TEST(Outline_limited_sizing_field, is_d_where_there_is_room_and_smaller_where_there_is_none)
{
  const Field h(with_a_narrow(), 0.1);
  EXPECT_EQ(h(Point(0.8, 0.1)), 0.1);
  EXPECT_LT(h(Point(0.01, 0.5)), 0.03);
  EXPECT_GT(h(Point(0.01, 0.5)), 0.01);
  EXPECT_LT(h(Point(0.01, 0.35)), h(Point(0.01, 0.2))); // it grows away from there
  for (double x = 0.01; x < 1; x += 0.03)
    EXPECT_LE(h(Point(x, 0.9)), 0.1);
}

TEST(Outline_limited_sizing_field, is_what_the_mesh_follows)
{
  for (CDT cdt : {with_a_narrow(), domains::make(rough_outlines::archipelago(3))}) {
    const double d = cdt.number_of_vertices() < 20 ? 0.1 : 0.5;
    const Field h(cdt, P::sizing_function(d).size_growth(0.3));
    const auto report = CGAL::npbs_relax(cdt, P::sizing_function(d).size_growth(0.3));
    const auto vertices = static_cast<double>(report.number_of_vertices);
    EXPECT_NEAR(mean_length_ratio(cdt, h), report.quality.mean_length_ratio(), 1e-12);
    EXPECT_GT(vertices, 1.2 * static_cast<double>(report.number_of_wanted_vertices));
    EXPECT_NEAR(h.number_of_vertices() / vertices, 1, 0.1);
  }
}

TEST(Outline_limited_sizing_field, counts_the_corners_of_a_fine_outline)
{
  domains::Outline round;
  for (int k = 0; k < 400; ++k)
    round.emplace_back(std::cos(k * 3.14159265358979 / 200), std::sin(k * 3.14159265358979 / 200));
  CDT cdt = domains::make({round});
  const auto np = P::sizing_function(0.1).limit_by_outline(false);
  const double expected = Field(cdt, np).number_of_vertices();
  EXPECT_NEAR(expected / static_cast<double>(CGAL::npbs_relax(cdt, np).number_of_vertices), 1, 0.1);
}

TEST(Outline_limited_sizing_field, is_of_the_mesh_or_the_outline_without_a_size)
{
  const CDT cdt = with_a_narrow();
  EXPECT_LT(Field(cdt)(Point(0.01, 0.5)), 0.03);
  CDT mesh = domains::make({domains::square(0, 0, 1)});
  CGAL::npbs_relax(mesh, 0.1);
  EXPECT_NEAR(Field(mesh)(Point(0.5, 0.5)), 0.1, 0.02);
}

TEST(Outline_limited_sizing_field, keeps_what_it_needs)
{
  std::unique_ptr<Field> h;
  {
    CDT cdt = with_a_narrow();
    const auto big = std::make_shared<double>(0.1);
    h = std::make_unique<Field>(cdt, P::sizing_function([big](const Point& p) { return *big + 0.01 * p.x(); }));
  } // triangulation, parameters and function are gone
  const Field copy = *h;
  h.reset();
  EXPECT_DOUBLE_EQ(copy(Point(1, 0.1)), 0.11);
}

TEST(Outline_limited_sizing_field, gives_the_bits_of_the_other_order)
{
  const std::vector<domains::Outline> outlines = rough_outlines::archipelago(5);
  const Field h(domains::make(outlines), 0.4), other(domains::make({outlines.rbegin(), outlines.rend()}), 0.4);
  for (double x = -4.9; x < 5; x += 0.37)
    for (double y = -4.9; y < 5; y += 0.41)
      EXPECT_EQ(h(Point(x, y)), other(Point(x, y)));
}

TEST(Outline_limited_sizing_field, takes_exact_numbers)
{
  using Exact = domains::Cdt_of<CGAL::Exact_predicates_exact_constructions_kernel>;
  const Exact cdt = domains::make<Exact>({domains::square(0, 0, 1)});
  const CGAL::Outline_limited_sizing_field_2 h(cdt, P::sizing_function(0.1));
  EXPECT_EQ(h(Exact::Point(0.5, 0.5)), 0.1);
}

TEST(Outline_limited_sizing_field, refuses_bad_input)
{
  const auto make = [](const auto& np) { return [=] { Field(with_a_narrow(), np); }; };
  expect_invalid(make(P::sizing_function(0.)), {"sizing_function", "= 0"});
  expect_invalid(make(P::sizing_function(0.1).size_growth(-1)), {"size_growth", "-1"});
  expect_invalid([] { Field(CDT(), 0.2); }, {"bounds no domain"});
  EXPECT_THROW(make(P::sizing_function(1e-4).maximum_number_of_bubbles(1000))(), std::length_error);
}

} // namespace test_outline_limited_sizing_field
