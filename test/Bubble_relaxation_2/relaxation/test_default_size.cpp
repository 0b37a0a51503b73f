// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// Without a sizing function an outline that has no mesh yet is meshed as its constraints are long and its
// regions are wide.

#include "domains.h"
#include "random_seeds.h"
#include "relax_and_validate.h"
#include "validation.h"

#include <CGAL/Bubble_relaxation_2/internal/sizes/Outline_sizes_2.h>
#include <CGAL/npbs_relax.h>

namespace test_default_size {

using CGAL::Bubble_relaxation_2::internal::Outline_field_2;
using CGAL::Bubble_relaxation_2::internal::Size_source_2;
using domains::Outline;

const Outline l_shape{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};

/// the area that is given lies within the outlines
auto relax(domains::CDT& cdt, double area)
{
  const auto report = relax_and_validate(cdt, CGAL::parameters::default_values());
  validation::expect_report_adds_up(cdt, report);
  EXPECT_NEAR(validation::domain_area(cdt), area, 1e-12);
  return report;
}

auto relax(const std::vector<Outline>& outlines, double area)
{
  domains::CDT cdt = domains::make(outlines);
  return relax(cdt, area);
}

/// the lengths of the edges of the mesh that have an end within `reach` of a point
std::vector<double> lengths_around(const domains::CDT& cdt, const domains::Point& p, double reach)
{
  std::vector<double> result;
  for (const auto& e : cdt.finite_edges()) {
    const auto s = cdt.segment(e);
    if ((e.first->is_in_domain() || e.first->neighbor(e.second)->is_in_domain()) &&
        (std::min)(CGAL::squared_distance(p, s.source()), CGAL::squared_distance(p, s.target())) <= reach * reach)
      result.push_back(std::sqrt(s.squared_length()));
  }
  std::sort(result.begin(), result.end());
  return result;
}

using Sources = std::vector<Size_source_2>;

constexpr double growth = 0.2;

/// sources in the square from (-1, -1) to (1, 1), with sizes up to `largest`
Sources random_sources(std::mt19937& random, int number, double largest)
{
  std::uniform_real_distribution<double> coordinate(-1, 1), size(0, largest);
  Sources result;
  for (int i = 0; i < number; ++i) {
    const double x = coordinate(random), y = coordinate(random);
    result.push_back({{x, y}, size(random)});
  }
  return result;
}

/// the same places seen in two fields, which were made of the same sources
void expect_least_over_all(const Outline_field_2& field, const Outline_field_2& same, const Sources& sources,
                           std::mt19937& random)
{
  std::uniform_real_distribution<double> coordinate(-1, 1);
  int exact = 0;
  for (int i = 0; i < 1000; ++i) {
    const domains::Point p(coordinate(random), coordinate(random));
    double least = 1e300;
    for (const Size_source_2& s : sources)
      least = (std::min)(least, s.d + growth * std::sqrt(CGAL::squared_distance(p, s.point)));
    EXPECT_NEAR(field(p), least, 0.01 * least);
    exact += field(p) <= least * (1 + 1e-14);
    EXPECT_EQ(field(p), same(p));
  }
  EXPECT_GE(exact, 950); // elsewhere many sources ask for almost the same
}

const CGAL::Bbox_2 box(-1, -1, 1, 1);

TEST(Outline_field, is_the_least_over_all_sources)
{
  std::mt19937 random(random_seeds::seed());
  Sources sources = random_sources(random, 1000, 0.02);
  const Outline_field_2 field(sources, box, growth);
  std::shuffle(sources.begin(), sources.end(), random);
  expect_least_over_all(field, Outline_field_2(sources, box, growth), sources, random);
}

TEST(Outline_field, takes_sources_one_after_the_other)
{
  std::mt19937 random(random_seeds::seed());
  Sources sources = random_sources(random, 10, 0.1);
  Outline_field_2 field(sources, box, growth), same(sources, box, growth);
  for (int number : {1, 100, 1000}) {
    Sources more = random_sources(random, number, 0.05);
    sources.insert(sources.end(), more.begin(), more.end());
    field.add(more);
    std::shuffle(more.begin(), more.end(), random);
    same.add(more);
    expect_least_over_all(field, same, sources, random);
  }
}

TEST(Outline_field, is_the_least_far_from_clusters)
{
  std::mt19937 random(random_seeds::seed());
  std::normal_distribution<double> off(0, 0.02);
  Sources sources;
  for (const domains::Point& center : {domains::Point(-0.9, -0.9), domains::Point(0.9, 0.2)})
    for (int i = 0; i < 300; ++i) {
      const double x = off(random), y = off(random);
      sources.push_back({{center.x() + x, center.y() + y}, 0.001});
      if (i % 10 == 0) // several in one place
        sources.push_back({sources.back().point, i % 20 == 0 ? 0.001 : 0.0005});
    }
  const Outline_field_2 field(sources, box, growth);
  std::shuffle(sources.begin(), sources.end(), random);
  expect_least_over_all(field, Outline_field_2(sources, box, growth), sources, random);
}

TEST(Outline_field, is_the_same_with_sources_that_are_nowhere_the_least)
{
  std::mt19937 random(random_seeds::seed());
  Sources sources = random_sources(random, 1000, 0.02), more;
  const Outline_field_2 before(sources, box, growth);
  for (const Size_source_2& s : sources)
    more.push_back({s.point, s.d + 0.01});
  Outline_field_2 field = before;
  field.add(more);
  expect_least_over_all(field, before, sources, random);
}

TEST(Outline_field, asks_few_sources_on_the_axis_of_a_circle)
{
  std::vector<Size_source_2> sources;
  for (const auto& p : domains::polygon(0, 0, 1, 100000))
    sources.push_back({{p.first, p.second}, 6.28e-5});
  const Outline_field_2 field(sources, CGAL::Bbox_2(-1, -1, 1, 1), 0.2);
  for (int i = 0; i < 1000000; ++i) // takes minutes if a query looks at all sources
    EXPECT_NEAR(field(1e-9 * i, 0), 0.2 + 6.28e-5, 0.02);
}

TEST(Default_size, of_an_l_with_a_finely_divided_hole)
{
  const Outline hole = domains::polygon(0.5, 0.5, 0.25, 60);
  const auto report = relax({l_shape, hole}, 3 - domains::area(hole));
  EXPECT_GE(report.quality.mean_quality(), 0.975);
  EXPECT_GE(report.quality.minimum_quality(), 0.865);
  EXPECT_NEAR(report.quality.mean_length_ratio(), 0.996, 0.005);
}

TEST(Default_size, of_a_channel)
{
  const auto report = relax({domains::square(0, 0, 1), domains::square(0.1, 0.1, 0.8)}, 0.36);
  EXPECT_GE(report.quality.mean_quality(), 0.969);
  EXPECT_GE(report.quality.minimum_quality(), 0.82); // right and isosceles, in corners
}

TEST(Default_size, of_a_long_rectangle)
{
  const auto report = relax({{{0, 0}, {10, 0}, {10, 0.1}, {0, 0.1}}}, 1);
  EXPECT_GE(report.quality.mean_quality(), 0.966);
  EXPECT_GE(report.quality.minimum_quality(), 0.82);
  EXPECT_NEAR(double(report.number_of_vertices), 170, 4); // one row, lower by a tenth than it should be
}

TEST(Default_size, of_almost_coincident_vertices)
{
  // 1e-13 above the corner there is a bend, else the vertex would only split an edge
  const auto report = relax({{{0, 0}, {1, 0}, {1 + 1e-13, 1e-13}, {1, 1}, {0, 1}}}, 1);
  EXPECT_GE(report.quality.mean_quality(), 0.98);
  EXPECT_LE(report.number_of_vertices, 2000u);
}

TEST(Default_size, of_a_slit)
{
  // between a hole and the outline there is a gap of 1e-9, too narrow for triangles: its sides count as touching
  const double gap = 1e-9;
  domains::CDT cdt = domains::make({domains::square(0, 0, 1), {{0.2, gap}, {0.8, gap}, {0.8, 0.5}}});
  const auto report = relax(cdt, 1 - 0.5 * 0.6 * (0.5 - gap));
  EXPECT_NEAR(double(report.number_of_vertices), 259, 4);
  EXPECT_NEAR(double(report.number_of_triangles), 339, 8);
  EXPECT_GT(report.number_of_small_angles, 0u); // needles across the gap
  EXPECT_LE(report.small_y, gap);
  EXPECT_GE(report.small_x, 0.);
  EXPECT_LE(report.small_x, 1.);
  std::size_t in_gap = 0, others = 0;
  double sum = 0, least = 1;
  for (auto f : cdt.finite_face_handles()) {
    if (!f->is_in_domain())
      continue;
    const auto t = cdt.triangle(f);
    const bool is_in_gap = t[0].y() <= gap && t[1].y() <= gap && t[2].y() <= gap;
    const double q = CGAL::radius_ratio_2(t[0], t[1], t[2]);
    is_in_gap ? ++in_gap : ++others;
    if (!is_in_gap) {
      sum += q;
      least = (std::min)(least, q);
    }
  }
  EXPECT_GT(in_gap, 0u);
  EXPECT_GE(sum / double(others), 0.961);
  EXPECT_GE(least, 0.815);
  EXPECT_NEAR(lengths_around(cdt, domains::Point(0.5, 0), 0.1).back(), 0.0202, 0.002);
  EXPECT_NEAR(lengths_around(cdt, domains::Point(0, 1), 0.1).back(), 0.2304, 0.005);
}

TEST(Default_size, of_random_stars)
{
  std::mt19937 random(random_seeds::seed());
  for (int i = 0; i < 10; ++i) {
    const std::vector<Outline> star = domains::random_star(random());
    const auto report = relax(star, domains::area(star[0]) - domains::area(star[1]));
    // of 200 stars the least are 0.9186 and 0.801
    EXPECT_GE(report.quality.mean_quality(), 0.915);
    EXPECT_GE(report.quality.minimum_quality(), 0.78);
  }
}

} // namespace test_default_size
