// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// The paper's domains, meshed with the defaults and with the paper's parameters: invariants, and bounds
// of quality with a margin to what paper_figures prints.

#include "../../demo/Bubble_relaxation_2/paper_domains.h"
#include "validation.h"

#include <CGAL/npbs_relax.h>

namespace {

using paper::CDT;
using paper::Domain;

std::vector<double> coordinates(const CDT& cdt)
{
  std::vector<double> result;
  for (auto v : cdt.finite_vertex_handles()) {
    result.push_back(v->point().x());
    result.push_back(v->point().y());
  }
  return result;
}

template <class Parameters>
auto relax_and_validate(const Domain& domain, CDT& cdt, const Parameters& parameters)
{
  cdt = paper::triangulate(domain);
  const validation::Snapshot before = validation::snapshot(cdt);
  const auto report = CGAL::npbs_relax(cdt, parameters.sizing_function(domain.d));
  const validation::Snapshot after = validation::snapshot(cdt);
  validation::expect_valid_mesh(cdt);
  validation::expect_vertices_kept(before.vertices, after);
  validation::expect_constraints_kept(before, after);
  EXPECT_EQ(report.number_of_vertices, cdt.number_of_vertices());
  return report;
}

/// numbers of vertices for which the quality is promised, and the scales of d that give them about
constexpr double sizes[] = {1000, 10000};
constexpr double size_factors[][2] = {{0.627, 0.191}, {1.046, 0.33},  {1.065, 0.33},  {0.673, 0.207},
                                      {1.028, 0.324}, {0.783, 0.242}, {0.563, 0.17}, {1.239, 0.374},
                                      {1.095, 0.3415}};

class Paper_domain : public testing::TestWithParam<int>
{
protected:
  Domain domain(double f) const { return paper::all_domains(f)[GetParam()]; }
};

} // namespace

TEST_P(Paper_domain, defaults)
{
  for (int size : {0, 1}) {
    CDT cdt;
    const Domain d = domain(size_factors[GetParam()][size]);
    SCOPED_TRACE(d.name);
    const validation::Snapshot before = validation::snapshot(paper::triangulate(d));
    const auto report = relax_and_validate(d, cdt, CGAL::parameters::mass(1.));
    const auto& q = report.quality;
    EXPECT_NEAR(double(report.number_of_vertices), sizes[size], 0.1 * sizes[size]);
    EXPECT_GE(q.mean_quality(), size == 0 ? 0.983 : 0.991);
    EXPECT_GE(q.minimum_quality(), 0.80);
    EXPECT_GE(q.minimum_angle(), 38);
    EXPECT_LE(q.irregular_share(), size == 0 ? 0.135 : 0.065);
    EXPECT_NEAR(q.mean_length_ratio(), 1, size == 0 ? 0.025 : 0.015);
    EXPECT_LE(q.length_ratio_deviation(), size == 0 ? 0.07 : 0.052);
    // the population control leaves no pair nearer than 0.62, and later steps move bubbles apart
    validation::expect_no_vertices_nearer(cdt, d.d, 0.6, before.vertices);
  }
}

TEST_P(Paper_domain, paper_parameters)
{
  CDT cdt;
  const Domain d = domain(1);
  SCOPED_TRACE(d.name);
  const auto report = relax_and_validate(
    d, cdt,
    CGAL::npbs_paper_parameters().number_of_iterations(d.iterations).number_of_rounds(d.rounds));
  const std::set<int> best{6, 7, 12, 13};
  EXPECT_GE(report.quality.mean_quality(), best.count(d.figure) > 0 ? 0.95 : 0.90);
  EXPECT_GE(report.quality.minimum_quality(), 0.2);
  EXPECT_EQ(report.number_of_force_evaluations, 4 * report.number_of_steps);
}

TEST_P(Paper_domain, same_bits_in_every_run)
{
  CDT first, second;
  relax_and_validate(domain(1), first, CGAL::parameters::mass(1.));
  relax_and_validate(domain(1), second, CGAL::parameters::mass(1.));
  EXPECT_EQ(coordinates(first), coordinates(second));
}

TEST_P(Paper_domain, same_bits_at_another_scale)
{
  const Domain d = domain(1);
  const double scale = std::ldexp(1., -30);
  Domain small = d;
  for (paper::Outline& o : small.outlines)
    for (paper::Point& p : o)
      p = paper::Point(scale * p.x(), scale * p.y());
  small.d = [&](const paper::Point& p) {
    return scale * d.d(paper::Point(p.x() / scale, p.y() / scale));
  };
  CDT first, second;
  relax_and_validate(d, first, CGAL::parameters::mass(1.));
  relax_and_validate(small, second, CGAL::parameters::mass(1.));
  std::vector<double> scaled = coordinates(first);
  for (double& x : scaled)
    x *= scale;
  EXPECT_EQ(scaled, coordinates(second));
}

INSTANTIATE_TEST_SUITE_P(All, Paper_domain, testing::Range(0, 9));

TEST(Relax, order_of_insertion_hardly_matters)
{
  Domain d = paper::l_shape(1);
  CDT first, second;
  const auto report = relax_and_validate(d, first, CGAL::parameters::mass(1.));
  std::rotate(d.outlines[0].begin(), d.outlines[0].begin() + 2, d.outlines[0].end());
  std::reverse(d.outlines[0].begin(), d.outlines[0].end());
  const auto again = relax_and_validate(d, second, CGAL::parameters::mass(1.));
  // only the vertices' own order in the triangulation is another
  EXPECT_EQ(validation::snapshot(first).vertices, validation::snapshot(second).vertices);
  EXPECT_EQ(validation::snapshot(first).constraints, validation::snapshot(second).constraints);
  EXPECT_EQ(report.quality.mean_quality(), again.quality.mean_quality());
  EXPECT_EQ(report.quality.mean_length_ratio(), again.quality.mean_length_ratio());
}

TEST(Relax, number_of_vertices_follows_the_size)
{
  for (double d : {0.2, 0.1, 0.05}) {
    CDT cdt;
    Domain square{0, "square", {{{0, 0}, {1, 0}, {1, 1}, {0, 1}}},
                  [d](const paper::Point&) { return d; }, 0, 0};
    const auto report = relax_and_validate(square, cdt, CGAL::parameters::mass(1.));
    // the hexagonal lattice, and half a row at the boundary
    const double expected = 2 / std::sqrt(3.) / (d * d) + 0.5 * 4 / d + 1;
    EXPECT_NEAR(double(report.number_of_vertices), expected, 0.1 * expected);
  }
}

TEST(Relax, no_rounds_give_the_initial_placement)
{
  for (auto placement : {CGAL::Bubble_placement::RHOMBIC, CGAL::Bubble_placement::FRONTAL}) {
    CDT cdt;
    const auto report =
      relax_and_validate(paper::non_convex(1), cdt,
                         CGAL::parameters::number_of_rounds(0).initial_placement(placement));
    EXPECT_EQ(report.number_of_steps, 0u);
    EXPECT_EQ(report.number_of_vertices, report.number_of_initial_bubbles);
    EXPECT_GT(report.quality.mean_quality(), 0.9);
  }
}

TEST(Relax, report_adds_up)
{
  CDT cdt;
  const auto report = relax_and_validate(paper::graded_circle(1), cdt, CGAL::parameters::mass(1.));
  EXPECT_EQ(report.number_of_vertices,
            report.number_of_initial_bubbles + report.number_of_insertions -
              report.number_of_deletions);
  EXPECT_EQ(report.number_of_force_evaluations, report.number_of_steps);
  EXPECT_EQ(report.number_of_triangles, report.quality.number_of_triangles());
  EXPECT_GE(report.number_of_renewals, report.number_of_rounds);
  EXPECT_EQ(report.converged, report.stop_reason == CGAL::Bubble_stop_reason::CONVERGED);
  EXPECT_GT(report.seconds.motion, 0);
  EXPECT_GT(report.seconds.total(), report.seconds.motion);
}
