// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// q = 2 r_in / r_out and the statistics of meshes.

#include "domains.h"
#include "random_seeds.h"
#include "validation.h"

#include <CGAL/Bubble_relaxation_2/internal/core/find_sorted.h>
#include <CGAL/Bubble_relaxation_report_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Mesh_quality_2.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <sstream>
#include <type_traits>

namespace test_mesh_quality {

using domains::CDT;
using domains::Point;

TEST(Radius_ratio, known_triangles)
{
  EXPECT_NEAR(CGAL::radius_ratio_2(Point(0, 0), Point(1, 0), Point(0.5, std::sqrt(0.75))), 1, 1e-15);
  // right and isosceles: r_in = (2 - sqrt 2)/2, r_out = sqrt 2 / 2
  EXPECT_NEAR(CGAL::radius_ratio_2(Point(0, 0), Point(1, 0), Point(0, 1)), 2 * (std::sqrt(2.) - 1), 1e-15);
  // sides 3, 4, 5: r_in = 1, r_out = 2.5
  EXPECT_NEAR(CGAL::radius_ratio_2(Point(0, 0), Point(3, 0), Point(3, 4)), 0.8, 1e-15);
  EXPECT_EQ(CGAL::radius_ratio_2(Point(0, 0), Point(1, 1), Point(3, 3)), 0);
  EXPECT_EQ(CGAL::radius_ratio_2(Point(2, 1), Point(2, 1), Point(2, 1)), 0);
  EXPECT_EQ(CGAL::radius_ratio_2(Point(2, 1), Point(2, 1), Point(3, 1)), 0);
}

TEST(Radius_ratio, equals_equation_11_in_long_double)
{
  std::mt19937 random(random_seeds::seed());
  std::uniform_real_distribution<double> uniform(-1., 1.);
  for (int k = 0; k < 10000; ++k) {
    const Point p(uniform(random), uniform(random)), q(uniform(random), uniform(random)),
      r(uniform(random), uniform(random));
    const auto length = [](const Point& s, const Point& t) {
      const long double x = (long double)(t.x()) - s.x(), y = (long double)(t.y()) - s.y();
      return std::sqrt(x * x + y * y);
    };
    const long double a = length(q, r), b = length(r, p), c = length(p, q);
    const long double expected = (b + c - a) * (c + a - b) * (a + b - c) / (a * b * c);
    EXPECT_NEAR(CGAL::radius_ratio_2(p, q, r), double(expected), 1e-13);
  }
}

TEST(Radius_ratio, flat_triangles_have_correct_digits)
{
  for (double h : {1e-3, 1e-6, 1e-9, 1e-12, 1e-100}) {
    // base 1, height h over the middle: q = 8 h^2 up to terms of h^4
    const double q = CGAL::radius_ratio_2(Point(0, 0), Point(1, 0), Point(0.5, h));
    EXPECT_NEAR(q / (8 * h * h), 1, 1e-5);
  }
}

TEST(Radius_ratio, does_not_depend_on_scale_orientation_or_order)
{
  const double p[3][2] = {{0.1, 0.2}, {1.3, 0.4}, {0.6, 1.1}};
  const auto at = [&](int i, double s) { return Point(s * p[i][0], s * p[i][1]); };
  const double q = CGAL::radius_ratio_2(at(0, 1), at(1, 1), at(2, 1));
  for (double s : {std::ldexp(1., -1000), std::ldexp(1., -40), std::ldexp(1., 40), std::ldexp(1., 1000)})
    EXPECT_EQ(CGAL::radius_ratio_2(at(0, s), at(1, s), at(2, s)), q);
  EXPECT_NEAR(CGAL::radius_ratio_2(at(0, 1), at(2, 1), at(1, 1)), q, 1e-15);
  EXPECT_NEAR(CGAL::radius_ratio_2(at(1, 1), at(2, 1), at(0, 1)), q, 1e-15);
  using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
  const Exact::FT exact =
    CGAL::radius_ratio_2(Exact::Point_2(0, 0), Exact::Point_2(3, 0), Exact::Point_2(3, 4));
  EXPECT_NEAR(CGAL::to_double(exact), 0.8, 1e-15);
}

TEST(Radius_ratio, is_of_the_number_type_of_the_kernel)
{
  using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
  using Float = CGAL::Simple_cartesian<float>;
  const auto returned = [](const auto& p) { return CGAL::radius_ratio_2(p, p, p); };
  EXPECT_TRUE((std::is_same<decltype(returned(Point())), double>::value));
  EXPECT_TRUE((std::is_same<decltype(returned(Float::Point_2())), float>::value));
  EXPECT_TRUE((std::is_same<decltype(returned(Exact::Point_2())), Exact::FT>::value));
}

TEST(Mesh_quality, refuses_bad_sizes)
{
  const CDT cdt = domains::make({domains::square(0, 0, 1)});
  for (double bad : {0., -1., std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_THROW(CGAL::mesh_quality_2(cdt, CGAL::parameters::sizing_function(bad)), std::invalid_argument);
    try {
      CGAL::mesh_quality_2(cdt, CGAL::parameters::sizing_function([bad](const Point&) { return bad; }));
      ADD_FAILURE() << "no exception";
    } catch (const std::invalid_argument& e) {
      EXPECT_NE(std::string(e.what()).find("sizing_function: d("), std::string::npos) << e.what();
      EXPECT_EQ(std::string(e.what()).find("npbs_relax"), std::string::npos) << e.what();
    }
  }
}

TEST(Mesh_quality, the_size_may_be_any_number_of_the_kernel)
{
  using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
  using Exact_cdt = CGAL::Constrained_Delaunay_triangulation_2<Exact>;
  const auto cdt = domains::make<Exact_cdt>({domains::square(0, 0, 1)});
  const Exact::FT d = Exact::FT(1) / 2;
  EXPECT_EQ(CGAL::mesh_quality_2(cdt, CGAL::parameters::sizing_function(d)).length_ratio_percentile(1), 2);
  EXPECT_EQ(CGAL::mesh_quality_2(cdt, CGAL::parameters::sizing_function(1)).length_ratio_percentile(1), 1);
}

TEST(Mesh_quality, of_a_hexagonal_patch)
{
  CDT cdt;
  std::vector<Point> ring;
  for (int i = 0; i < 6; ++i)
    ring.push_back(Point(std::cos(i * 1.0471975511965976), std::sin(i * 1.0471975511965976)));
  cdt.insert_constraint(ring.begin(), ring.end(), true);
  cdt.insert(Point(0, 0));
  const auto q = CGAL::mesh_quality_2(cdt, CGAL::parameters::sizing_function(0.5));
  EXPECT_EQ(q.number_of_triangles(), 6u);
  EXPECT_EQ(q.number_of_vertices(), 7u);
  EXPECT_NEAR(q.minimum_quality(), 1, 1e-14);
  EXPECT_NEAR(q.mean_quality(), 1, 1e-14);
  EXPECT_NEAR(q.minimum_angle(), 60, 1e-10);
  EXPECT_NEAR(q.maximum_angle(), 60, 1e-10);
  EXPECT_EQ(q.number_of_interior_vertices(), 1u);
  EXPECT_EQ(q.irregular_share(), 0);
  EXPECT_EQ(q.histogram().back(), 6u);
  EXPECT_NEAR(q.shortest_edge(), 1, 1e-14);
  EXPECT_NEAR(q.longest_edge(), 1, 1e-14);
  ASSERT_TRUE(q.has_length_ratios());
  EXPECT_NEAR(q.mean_length_ratio(), 2, 1e-14);
  EXPECT_NEAR(q.length_ratio_deviation(), 0, 1e-14);
  EXPECT_NEAR(q.length_ratio_percentile(1), 2, 1e-14);
}

TEST(Mesh_quality, of_two_triangles_with_a_hole_beside)
{
  CDT cdt = domains::make({domains::square(0, 0, 1)});
  const auto q = CGAL::mesh_quality_2(cdt);
  EXPECT_EQ(q.number_of_triangles(), 2u);
  EXPECT_EQ(q.number_of_interior_vertices(), 0u);
  EXPECT_EQ(q.irregular_share(), 0);
  EXPECT_FALSE(q.has_length_ratios());
  EXPECT_TRUE(std::isnan(q.mean_length_ratio()));
  EXPECT_EQ(q.shortest_edge(), 1);
  EXPECT_NEAR(q.longest_edge(), std::sqrt(2.), 1e-15);
  EXPECT_NEAR(q.minimum_angle(), 45, 1e-12);
  EXPECT_NEAR(q.maximum_angle(), 90, 1e-12);
  EXPECT_NEAR(q.mean_quality(), 2 * (std::sqrt(2.) - 1), 1e-14);
}

TEST(Mesh_quality, agrees_with_brute_force_on_a_random_mesh)
{
  CDT cdt = domains::make({domains::square(0, 0, 1), domains::square(0.4, 0.4, 0.2)});
  std::mt19937 random(random_seeds::seed());
  std::uniform_real_distribution<double> uniform(0.001, 0.999);
  for (int k = 0; k < 500; ++k)
    cdt.insert(Point(uniform(random), uniform(random)));
  const auto q = CGAL::mesh_quality_2(cdt);
  std::vector<double> qualities;
  double angle = 180, largest = 0, shortest = 2, longest = 0;
  for (CDT::Face_handle f : cdt.finite_face_handles()) {
    const Point c = CGAL::centroid(f->vertex(0)->point(), f->vertex(1)->point(), f->vertex(2)->point());
    if (c.x() > 0.4 && c.x() < 0.6 && c.y() > 0.4 && c.y() < 0.6)
      continue;
    qualities.push_back(
      CGAL::radius_ratio_2(f->vertex(0)->point(), f->vertex(1)->point(), f->vertex(2)->point()));
    for (int i = 0; i < 3; ++i) {
      const auto u = f->vertex((i + 1) % 3)->point() - f->vertex(i)->point();
      const auto v = f->vertex((i + 2) % 3)->point() - f->vertex(i)->point();
      const double a =
        std::acos(u * v / std::sqrt(u.squared_length() * v.squared_length())) * 57.29577951308232;
      shortest = (std::min)(shortest, std::sqrt(u.squared_length()));
      longest = (std::max)(longest, std::sqrt(u.squared_length()));
      angle = (std::min)(angle, a);
      largest = (std::max)(largest, a);
    }
  }
  std::sort(qualities.begin(), qualities.end());
  ASSERT_EQ(q.number_of_triangles(), qualities.size());
  const double rounding = 1e-12; // the triangles' vertices are taken in another order here
  EXPECT_NEAR(q.minimum_quality(), qualities.front(), rounding);
  EXPECT_NEAR(q.minimum_angle(), angle, 1e-6);
  EXPECT_NEAR(q.maximum_angle(), largest, 1e-6);
  EXPECT_NEAR(q.shortest_edge(), shortest, rounding);
  EXPECT_NEAR(q.longest_edge(), longest, rounding);
  std::size_t sum = 0;
  for (std::size_t n : q.histogram())
    sum += n;
  EXPECT_EQ(sum, qualities.size());
  for (int percent : {1, 5, 10, 25, 50, 75, 90}) {
    const double value = q.quality_percentile(percent) + rounding;
    const double share = double(std::upper_bound(qualities.begin(), qualities.end(), value) -
                                qualities.begin()) / double(qualities.size());
    EXPECT_GE(share, percent / 100.);
    EXPECT_LT(share, percent / 100. + 2. / double(qualities.size()));
  }
  EXPECT_THROW(q.quality_percentile(33), std::invalid_argument);
  EXPECT_THROW(q.length_ratio_percentile(2), std::invalid_argument);
}

TEST(Order_independent, sums_are_equal_to_the_last_bit_in_any_order)
{
  // of so many lengths the mean has the bits of the sum, while it is no smaller than the smallest number
  constexpr int n = 1024;
  constexpr double smallest = std::numeric_limits<double>::denorm_min();
  const auto mean = [](const std::vector<double>& lengths) {
    CGAL::Bubble_relaxation_2::internal::Mesh_quality_accumulator_2 accumulator;
    for (double length : lengths)
      accumulator.add_length(length);
    return accumulator.statistics().mean_length;
  };
  std::mt19937 random(random_seeds::seed());
  for (double scale : {1., 1e-300, 1e300, n * smallest}) {
    std::vector<double> values;
    long double exact = 0;
    for (int i = 0; i < n; ++i) {
      const double number = double(random() % 1000);
      values.push_back(scale == n * smallest ? scale * number : scale * std::exp(-1e-2 * i) * number / 1000);
      exact += values.back();
    }
    const double sum = n * mean(values);
    EXPECT_NEAR(sum / exact, 1, 1e-12);
    for (int k = 0; k < 5; ++k) {
      std::shuffle(values.begin(), values.end(), random);
      EXPECT_EQ(n * mean(values), sum);
    }
  }
  EXPECT_TRUE(std::isnan(mean({}))); // there is none
  EXPECT_EQ(mean({0., 0.}), 0.);
  EXPECT_EQ(mean({3.}), 3.);
  EXPECT_EQ(mean({1., INFINITY}), INFINITY);
  EXPECT_EQ(mean(std::vector<double>(n, smallest)), smallest);
}

TEST(Order_independent, positions_are_sorted)
{
  using CGAL::Bubble_relaxation_2::internal::sorted_at;
  std::mt19937 random(random_seeds::seed());
  for (std::size_t n : {1, 2, 3, 10, 1000}) {
    std::vector<double> values;
    std::vector<std::size_t> positions;
    for (std::size_t i = 0; i < n; ++i) {
      values.push_back(double(random() % 100) - 50); // many are equal
      if (random() % 3 == 0)
        positions.push_back(i);
    }
    std::vector<double> sorted = values;
    std::sort(sorted.begin(), sorted.end());
    const std::vector<double> found = sorted_at(positions, values, CGAL::Bubble_relaxation_2::internal::Team());
    for (std::size_t k = 0; k < positions.size(); ++k)
      EXPECT_EQ(found[k], sorted[positions[k]]);
  }
}

TEST(Mesh_quality, counts_irregular_vertices)
{
  CDT cdt = domains::make({domains::square(0, 0, 1)});
  cdt.insert(Point(0.5, 0.5)); // degree 4
  const auto q = CGAL::mesh_quality_2(cdt);
  EXPECT_EQ(q.number_of_interior_vertices(), 1u);
  EXPECT_EQ(q.irregular_share(), 1);
}

TEST(Mesh_quality, prints_all_figures)
{
  CDT cdt = domains::make({domains::square(0, 0, 1)});
  cdt.insert(Point(0.5, 0.4));
  std::ostringstream out;
  out.precision(3);
  out << CGAL::mesh_quality_2(cdt, CGAL::parameters::sizing_function(0.7)) << 0.123456;
  for (const char* word : {"vertices", "triangles", "radius ratio", "angle", "degree", "edge: shortest, longest",
                           "length over d", "histogram", "#", "0.123"})
    EXPECT_NE(out.str().find(word), std::string::npos) << word;
  EXPECT_EQ(out.str().find("0.1235"), std::string::npos) << "the format of the stream was changed";
}

TEST(Mesh_quality, prints_no_more_empty_rows_than_it_must)
{
  // q = 0.08 and 0.98
  CDT cdt = domains::make({{{0, 0}, {1, 0}, {0.5, 0.1}}, {{2, 0}, {3, 0}, {2.5, 0.8}}});
  std::ostringstream out;
  out << CGAL::mesh_quality_2(cdt);
  const std::string text = out.str(), bar = " " + std::string(40, '#') + "\n";
  EXPECT_EQ(text.substr(text.find("  histogram")), "  histogram of the radius ratio\n"
                                                   "  0.05 - 0.10          1" + bar +
                                                   "  0.10 - 0.95          0\n"
                                                   "  0.95 - 1.00          1" + bar);
}

TEST(Report, prints_what_was_done)
{
  CGAL::Bubble_relaxation_report_2<double> report;
  report.number_of_initial_bubbles = 12;
  report.stop_reason = CGAL::Bubble_stop_reason::STOPPED_BY_CALLBACK;
  report.seconds.population = 0.25;
  std::ostringstream text;
  text << report;
  EXPECT_NE(text.str().find("12 bubbles placed"), std::string::npos) << text.str();
  EXPECT_NE(text.str().find("stopped by the callback"), std::string::npos) << text.str();
  EXPECT_NE(text.str().find("population 0.25"), std::string::npos) << text.str();
  EXPECT_EQ(text.str().find("radius ratio"), std::string::npos) << "there is no mesh";
}

TEST(Mesh_quality, of_an_exact_kernel_is_in_double)
{
  using Exact_cdt = CGAL::Constrained_Delaunay_triangulation_2<CGAL::Exact_predicates_exact_constructions_kernel>;
  const auto cdt = domains::make<Exact_cdt>({domains::square(0, 0, 1)});
  const CGAL::Mesh_quality_2<double> q = CGAL::mesh_quality_2(cdt);
  EXPECT_NEAR(q.minimum_quality(), 2 * (std::sqrt(2.) - 1), 1e-14);
}

TEST(Mesh_quality, in_another_number_type)
{
  CDT cdt = domains::make({domains::square(0, 0, 1)});
  cdt.insert(Point(0.5, 0.4));
  const auto q = CGAL::mesh_quality_2(cdt);
  const CGAL::Mesh_quality_2<float> single(q);
  EXPECT_EQ(single.mean_quality(), static_cast<float>(q.mean_quality()));
  EXPECT_EQ(single.worst_y(), static_cast<float>(q.worst_y()));
  EXPECT_EQ(single.number_of_triangles(), q.number_of_triangles());
  EXPECT_EQ(single.histogram(), q.histogram());
}

} // namespace test_mesh_quality
