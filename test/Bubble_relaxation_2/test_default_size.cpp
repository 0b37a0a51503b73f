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
#include "validation.h"

#include <CGAL/npbs_relax.h>

using CGAL::Bubble_relaxation_2::internal::Outline_field_2;
using CGAL::Bubble_relaxation_2::internal::Size_source_2;
using domains::Outline;

namespace {

const Outline l_shape{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};

auto relax(const std::vector<Outline>& outlines)
{
  domains::CDT cdt = domains::make(outlines);
  const auto report = CGAL::npbs_relax(cdt);
  validation::expect_valid_mesh(cdt);
  return report;
}

} // namespace

TEST(Outline_field, is_the_least_over_all_sources)
{
  std::mt19937 random(random_seeds::seed());
  std::uniform_real_distribution<double> coordinate(-1, 1);
  const CGAL::Bbox_2 box(-1, -1, 1, 1);
  std::vector<Size_source_2> sources;
  for (int i = 0; i < 1000; ++i)
    sources.push_back({{coordinate(random), coordinate(random)}, 0.01 + 0.01 * coordinate(random)});
  const Outline_field_2 field(sources, box);
  std::shuffle(sources.begin(), sources.end(), random);
  const Outline_field_2 shuffled(sources, box);
  for (int i = 0; i < 1000; ++i) {
    const domains::Point p(coordinate(random), coordinate(random));
    double least = 1e300;
    for (const Size_source_2& s : sources)
      least = (std::min)(least, s.d + Outline_field_2::gradation *
                                        std::sqrt(CGAL::squared_distance(p, s.point)));
    EXPECT_NEAR(field(p), least, 0.01 * least);
    EXPECT_EQ(field(p), shuffled(p));
  }
}

TEST(Outline_field, asks_few_sources_on_the_axis_of_a_circle)
{
  std::vector<Size_source_2> sources;
  for (const auto& p : domains::polygon(0, 0, 1, 100000))
    sources.push_back({{p.first, p.second}, 6.28e-5});
  const Outline_field_2 field(sources, CGAL::Bbox_2(-1, -1, 1, 1));
  for (int i = 0; i < 1000000; ++i) // takes minutes if a query looks at all sources
    EXPECT_NEAR(field(1e-9 * i, 0), 0.2 + 6.28e-5, 0.02);
}

TEST(Default_size, of_an_l_with_a_finely_divided_hole)
{
  const auto report = relax({l_shape, domains::polygon(0.5, 0.5, 0.25, 60)});
  EXPECT_GE(report.quality.mean_quality(), 0.9);
  EXPECT_GE(report.quality.minimum_quality(), 0.3);
  EXPECT_NEAR(report.quality.mean_length_ratio(), 1, 0.1);
}

TEST(Default_size, of_a_channel)
{
  const auto report = relax({domains::square(0, 0, 1), domains::square(0.1, 0.1, 0.8)});
  EXPECT_GE(report.quality.mean_quality(), 0.9);
  EXPECT_GE(report.quality.minimum_quality(), 0.3);
}

TEST(Default_size, of_a_long_rectangle)
{
  const auto report = relax({{{0, 0}, {10, 0}, {10, 0.1}, {0, 0.1}}});
  EXPECT_GE(report.quality.mean_quality(), 0.9);
  EXPECT_GE(report.quality.minimum_quality(), 0.3);
  EXPECT_LE(report.number_of_vertices, 500u);
}

TEST(Default_size, of_almost_coincident_vertices)
{
  const auto report = relax({{{0, 0}, {1, 0}, {1, 1e-13}, {1, 1}, {0, 1}}});
  EXPECT_GE(report.quality.mean_quality(), 0.9);
  EXPECT_LE(report.number_of_vertices, 10000u);
}

TEST(Default_size, of_a_slit)
{
  const auto report = relax({domains::square(0, 0, 1), {{0.2, 1e-9}, {0.8, 1e-9}, {0.8, 0.5}}});
  EXPECT_LE(report.number_of_vertices, 5000u);
}

TEST(Default_size, of_random_stars)
{
  std::mt19937 random(random_seeds::seed());
  for (int i = 0; i < 10; ++i)
    EXPECT_GE(relax(domains::random_star(random())).quality.mean_quality(), 0.85);
}
