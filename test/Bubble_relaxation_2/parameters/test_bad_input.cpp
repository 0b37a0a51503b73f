// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// Bad input throws an exception that names the parameter and its value, and nothing is lost.

#include "domains.h"
#include "expect_throw.h"
#include "validation.h"

#include <CGAL/npbs_place_nodes.h>
#include <CGAL/npbs_relax.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <locale>

namespace test_bad_input {

using domains::CDT;
using domains::Point;

namespace P = CGAL::parameters;

const double not_a_number = std::numeric_limits<double>::quiet_NaN();
const double infinity = std::numeric_limits<double>::infinity();

/// expects an exception whose message contains all of `words`, and the triangulation as it was, with
/// the very same vertices
template <class Exception, class Parameters>
void expect_throw(CDT& cdt, const Parameters& parameters, const std::vector<std::string>& words)
{
  const validation::Snapshot before = validation::snapshot(cdt);
  std::vector<CDT::Vertex_handle> handles;
  for (auto v : cdt.finite_vertex_handles())
    handles.push_back(v);
  ::expect_throw<Exception>([&] { CGAL::npbs_relax(cdt, parameters); }, words);
  EXPECT_TRUE(validation::snapshot(cdt) == before);
  for (CDT::Vertex_handle v : cdt.finite_vertex_handles())
    EXPECT_EQ(std::count(handles.begin(), handles.end(), v), 1);
  EXPECT_TRUE(cdt.is_valid());
}

CDT square() { return domains::make({domains::square(0, 0, 1)}); }

/// the same mesh with other parameters, to the last bit; returns the report
template <class Parameters, class Others>
auto expect_same_mesh(const Parameters& parameters, const Others& others)
{
  CDT cdt = square(), other = square();
  const auto report = CGAL::npbs_relax(cdt, parameters);
  CGAL::npbs_relax(other, others);
  validation::expect_valid_mesh(cdt);
  validation::expect_report_adds_up(cdt, report);
  EXPECT_NEAR(validation::domain_area(cdt), 1, 1e-12);
  EXPECT_GT(report.quality.minimum_quality(), 0.5);
  EXPECT_TRUE(validation::triangles(cdt) == validation::triangles(other));
  return report;
}

/// the least maximum_number_of_bubbles that is not refused
std::size_t least_maximum(double d)
{
  std::size_t refused = 0, taken = 100000;
  while (taken - refused > 1) {
    const std::size_t middle = (refused + taken) / 2;
    try {
      CGAL::npbs_place_nodes(square(), P::sizing_function(d).number_of_rounds(0).maximum_number_of_bubbles(middle));
      taken = middle;
    } catch (const std::length_error&) {
      refused = middle;
    }
  }
  return taken;
}

struct My_error : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

TEST(Bad_size, not_positive_and_finite)
{
  for (double bad : {0., -1., not_a_number, infinity, -infinity}) {
    CDT cdt = square();
    expect_throw<std::invalid_argument>(cdt, P::sizing_function(bad), {"sizing_function"});
    expect_throw<std::invalid_argument>(
      cdt, P::sizing_function([bad](const Point& p) { return p.x() > 0.9 && p.y() > 0.9 ? bad : 0.1; }),
      {"sizing_function", "d("});
  }
}

TEST(Bad_size, beyond_the_bounds_of_magnitude)
{
  for (double bad : {1e-91, 1e91, 1e300}) {
    CDT cdt = square();
    expect_throw<std::invalid_argument>(cdt, P::sizing_function(bad),
                                        {"sizing_function", "d(", "at least 1e-90 and at most 1e+90"});
  }
}

TEST(Bad_size, the_message_names_the_place_and_the_value)
{
  CDT cdt = square();
  // bad in one corner only, so that the order in which places are asked for does not count
  expect_throw<std::invalid_argument>(
    cdt, P::sizing_function([](const Point& p) { return p.x() == 1 && p.y() == 1 ? -3.25 : 0.1; }),
    {"-3.25", "d(1, 1)"});
}

TEST(Bad_size, throws_at_any_call)
{
  // count the calls of a whole run, then throw at some of them: the first, some between, the last
  std::size_t calls = 0;
  const auto counting = [&](const Point&) {
    ++calls;
    return 0.1;
  };
  CDT counted = square();
  CGAL::npbs_relax(counted, P::sizing_function(std::cref(counting)));
  ASSERT_GT(calls, 100u);
  for (std::size_t at : {std::size_t(1), calls / 7, calls / 3, calls / 2, calls - calls / 4, calls}) {
    SCOPED_TRACE(at);
    std::size_t left = at;
    CDT cdt = square();
    expect_throw<My_error>(cdt, P::sizing_function([&left](const Point&) {
                             if (--left == 0)
                               throw My_error("enough");
                             return 0.1;
                           }), {"enough"});
  }
}

struct Thousands_separator : std::numpunct<char>
{
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

TEST(Bad_size, too_many_bubbles)
{
  CDT cdt = square();
  expect_throw<std::length_error>(cdt, P::sizing_function(0.01).maximum_number_of_bubbles(5000),
                                  {"maximum_number_of_bubbles", "5000"});
  const std::locale before = std::locale::global(std::locale(std::locale::classic(), new Thousands_separator));
  expect_throw<std::length_error>(cdt, P::sizing_function(0.01).maximum_number_of_bubbles(5000),
                                  {"maximum_number_of_bubbles = 5000: "});
  std::locale::global(before);
  expect_throw<std::length_error>(cdt, P::sizing_function(1e-12), {"maximum_number_of_bubbles"});
  expect_throw<std::length_error>(
    cdt, P::sizing_function([](const Point& p) { return 1e-7 + 1e-6 * std::abs(p.x()); }),
    {"maximum_number_of_bubbles"});
  expect_same_mesh(P::sizing_function(0.05).maximum_number_of_bubbles(1000), P::sizing_function(0.05));
  // the expected number itself is enough, and one less is too few
  const std::size_t least = least_maximum(0.05);
  expect_same_mesh(P::sizing_function(0.05).maximum_number_of_bubbles(least), P::sizing_function(0.05));
  expect_throw<std::length_error>(cdt, P::sizing_function(0.05).maximum_number_of_bubbles(least - 1),
                                  {"maximum_number_of_bubbles", std::to_string(least - 1)});
  EXPECT_NEAR(double(least), 511, 30) << "it is about the number of vertices that the mesh has";
}

TEST(Bad_size, too_small_where_coordinates_are_coarse)
{
  // a few roundings wide: parts of it that are counted get no shorter than one
  CDT cdt = domains::make({domains::square(1024, 1024, 8 * 0x1p-42)});
  expect_throw<std::length_error>(cdt, P::sizing_function(1e-18), {"maximum_number_of_bubbles", "at least"});
}

TEST(Bad_size, too_many_bubbles_on_edges)
{
  // the area would hold 46 bubbles
  CDT cdt = domains::make({{{0, 0}, {1, 0}, {1, 0.001}, {0, 0.001}}});
  expect_throw<std::length_error>(cdt, P::sizing_function(0.005).maximum_number_of_bubbles(390),
                                  {"maximum_number_of_bubbles", "390"});
  // it is narrower than d
  expect_throw<std::length_error>(cdt, P::sizing_function(0.005).maximum_number_of_bubbles(410),
                                  {"maximum_number_of_bubbles", "410", "at least", "limit_by_outline"});
  const auto report = CGAL::npbs_relax(
    cdt, P::sizing_function(0.005).maximum_number_of_bubbles(410).limit_by_outline(false));
  EXPECT_NEAR(double(report.number_of_initial_bubbles), 402, 8);
  // soon refused, however fine it is on the edges alone
  CDT needle = domains::make({{{0, 0}, {1, 0}, {1, 1e-14}, {0, 1e-14}}});
  expect_throw<std::length_error>(needle, P::sizing_function(1e-10), {"maximum_number_of_bubbles"});
}

TEST(Bad_parameter, out_of_range)
{
  CDT cdt = square();
  const auto size = P::sizing_function(0.1);
  for (double bad : {0., -0.5, not_a_number, infinity}) {
    expect_throw<std::invalid_argument>(cdt, size.time_step(bad), {"time_step"});
    expect_throw<std::invalid_argument>(cdt, size.mass(bad), {"mass"});
    expect_throw<std::invalid_argument>(cdt, size.force_coefficient(bad), {"force_coefficient"});
    expect_throw<std::invalid_argument>(cdt, size.neighbor_radius(bad), {"neighbor_radius"});
    expect_throw<std::invalid_argument>(cdt, size.size_growth(bad), {"size_growth"});
  }
  for (double bad : {-0.5, not_a_number, infinity}) {
    expect_throw<std::invalid_argument>(cdt, size.damping(bad), {"damping"});
    expect_throw<std::invalid_argument>(cdt, size.displacement_tolerance(bad),
                                        {"displacement_tolerance"});
    expect_throw<std::invalid_argument>(cdt, size.minimum_angle(bad), {"minimum_angle"});
  }
  for (double bad : {9e-13, 1.1e12}) {
    expect_throw<std::invalid_argument>(cdt, size.time_step(bad), {"time_step", "at least 1e-12 and at most 1e+12"});
    expect_throw<std::invalid_argument>(cdt, size.mass(bad), {"mass", "at least 1e-12 and at most 1e+12"});
    expect_throw<std::invalid_argument>(cdt, size.damping(bad), {"damping", "at least 1e-12 and at most 1e+12"});
    expect_throw<std::invalid_argument>(cdt, size.force_coefficient(bad),
                                        {"force_coefficient", "at least 1e-12 and at most 1e+12"});
  }
  expect_throw<std::invalid_argument>(cdt, size.time_step(-0.125), {"time_step", "-0.125"});
  expect_throw<std::invalid_argument>(cdt, size.neighbor_radius(1.5), {"neighbor_radius", "1.5"});
  expect_throw<std::invalid_argument>(cdt, size.neighbor_radius(101.), {"neighbor_radius", "at most 100"});
  expect_throw<std::invalid_argument>(cdt, size.size_growth(1.125), {"size_growth", "1.125", "at most 1"});
  expect_throw<std::invalid_argument>(cdt, size.minimum_angle(33.5), {"minimum_angle", "33.5", "0 to 33 degrees"});
  expect_throw<std::invalid_argument>(cdt, size.number_of_iterations(-1), {"number_of_iterations", "-1"});
  expect_throw<std::invalid_argument>(cdt, size.number_of_rounds(-2), {"number_of_rounds", "-2"});
  expect_throw<std::invalid_argument>(cdt, size.renewal_interval(-3), {"renewal_interval", "-3"});
  expect_throw<std::invalid_argument>(cdt, size.maximum_number_of_bubbles(0),
                                      {"maximum_number_of_bubbles", "0"});
}

TEST(Bad_parameter, what_bounds_allow_is_taken)
{
  const auto size = P::sizing_function(0.1);
  expect_same_mesh(size.size_growth(1), size.size_growth(1.)); // other types of the same numbers
  expect_same_mesh(size.minimum_angle(33), size.minimum_angle(33.));
  expect_same_mesh(size.minimum_angle(0), size.minimum_angle(0.));
  for (double value : {1e-12, 1e12})
    EXPECT_NO_THROW(CGAL::npbs_place_nodes(square(), size.force_coefficient(value).mass(value).damping(value)
                                                       .time_step(value).number_of_rounds(1)));
  EXPECT_NO_THROW(CGAL::npbs_place_nodes(square(), size.damping(0.).number_of_rounds(1)));
  EXPECT_NO_THROW(CGAL::npbs_place_nodes( // in units of the user's
    square(), size.integrator(CGAL::Bubble_integrator::RUNGE_KUTTA_4).mass(1e-13).number_of_rounds(1)));
}

TEST(Bad_parameter, counts_are_integers)
{
  CDT cdt = square();
  const auto size = P::sizing_function(0.1);
  for (double bad : {2.5, -1., not_a_number, infinity, -infinity, 1e30}) {
    expect_throw<std::invalid_argument>(cdt, size.number_of_rounds(bad), {"number_of_rounds"});
    expect_throw<std::invalid_argument>(cdt, size.number_of_iterations(bad), {"number_of_iterations"});
    expect_throw<std::invalid_argument>(cdt, size.renewal_interval(bad), {"renewal_interval"});
    expect_throw<std::invalid_argument>(cdt, size.maximum_number_of_bubbles(bad),
                                        {"maximum_number_of_bubbles"});
  }
  expect_throw<std::invalid_argument>(cdt, size.number_of_rounds(2.5f), {"number_of_rounds", "2.5", "integer"});
  // other types of the same numbers, which are followed
  const auto report = expect_same_mesh(size.number_of_rounds(2.).number_of_iterations(3.f),
                                       size.number_of_rounds(2).number_of_iterations(3));
  EXPECT_EQ(report.number_of_rounds, 2u);
  EXPECT_EQ(report.number_of_steps, 6u);
}

TEST(Bad_parameter, more_bubbles_than_there_are_indices)
{
  CDT cdt = square();
  const auto size = P::sizing_function(0.1);
  expect_same_mesh(size.maximum_number_of_bubbles(2147483647), size);
  expect_throw<std::invalid_argument>(cdt, size.maximum_number_of_bubbles(2147483648u),
                                      {"maximum_number_of_bubbles", "2147483648", "2147483647"});
  expect_throw<std::invalid_argument>(cdt, size.maximum_number_of_bubbles(std::size_t(-1)),
                                      {"maximum_number_of_bubbles", "18446744073709551615"});
}

TEST(Bad_parameter, wild_but_valid_values_give_a_valid_mesh)
{
  const auto size = P::sizing_function(0.1).number_of_rounds(2);
  const auto run = [](const auto& parameters, std::size_t evaluations_per_step = 1) {
    CDT cdt = square();
    const validation::Snapshot before = validation::snapshot(cdt);
    const auto report = CGAL::npbs_relax(cdt, parameters);
    validation::expect_mesh_of(before, cdt);
    validation::expect_report_adds_up(cdt, report, evaluations_per_step);
    EXPECT_NEAR(validation::domain_area(cdt), 1, 1e-12);
    EXPECT_NEAR(double(report.number_of_vertices), 142, 25);
  };
  run(size.time_step(1e6));
  run(size.force_coefficient(1e12));
  run(size.mass(1e-12));
  run(size.damping(1e9));
  run(size.integrator(CGAL::Bubble_integrator::RUNGE_KUTTA_4).time_step(1e3), 4);
  run(size.integrator(CGAL::Bubble_integrator::RUNGE_KUTTA_4).time_step(1e3).force_coefficient(1e200), 4);
  run(size.number_of_iterations(0));
  run(size.displacement_tolerance(1e9));
  run(size.neighbor_radius(20.));
}

TEST(Bad_domain, empty)
{
  CDT cdt;
  expect_throw<std::invalid_argument>(cdt, P::sizing_function(0.1), {"dimension"});
  cdt.insert(Point(0, 0));
  expect_throw<std::invalid_argument>(cdt, P::sizing_function(0.1), {"dimension"});
  cdt.insert_constraint(Point(0, 0), Point(1, 1));
  expect_throw<std::invalid_argument>(cdt, P::sizing_function(0.1), {"dimension"});
}

TEST(Bad_domain, no_closed_region)
{
  CDT cdt;
  domains::insert(cdt, {{0, 0}, {1, 0}, {1, 1}, {0, 1}}, false);
  expect_throw<std::invalid_argument>(cdt, P::sizing_function(0.1), {"no face"});
  CDT points;
  for (int i = 0; i < 10; ++i)
    points.insert(Point(i, i * i));
  expect_throw<std::invalid_argument>(points, P::sizing_function(0.1), {"no face"});
}

TEST(Bad_domain, everything_is_a_hole)
{
  CDT cdt = square();
  const std::vector<Point> seeds{Point(0.5, 0.5)};
  expect_throw<std::invalid_argument>(
    cdt, CGAL::Bubble_relaxation_parameters::seeds(seeds).sizing_function(0.1), {"no face", "holes"});
}

TEST(Bad_domain, unbounded)
{
  CDT cdt = square();
  const std::vector<Point> seeds{Point(5, 5)};
  expect_throw<std::invalid_argument>(cdt,
                                      CGAL::Bubble_relaxation_parameters::seeds(seeds)
                                        .seeds_are_in_domain(true)
                                        .sizing_function(0.1),
                                      {"seeds", "(5, 5)"});
}

TEST(Bad_domain, a_boundary_that_is_no_constraint)
{
  CDT cdt = square();
  (*cdt.finite_faces_begin()).set_in_domain(true);
  expect_throw<std::invalid_argument>(cdt, P::sizing_function(0.1), {"must be constrained"});
}

TEST(Bad_domain, seed_that_is_no_point)
{
  CDT cdt = square();
  const std::vector<Point> seeds{Point(not_a_number, 0)};
  expect_throw<std::invalid_argument>(
    cdt, CGAL::Bubble_relaxation_parameters::seeds(seeds).sizing_function(0.1), {"seeds", "nan"});
}

TEST(Bad_domain, seed_beyond_the_bound_of_coordinates)
{
  CDT cdt = square();
  const std::vector<Point> seeds{Point(0, -1e91)};
  expect_throw<std::invalid_argument>(
    cdt, CGAL::Bubble_relaxation_parameters::seeds(seeds).sizing_function(0.1),
    {"seeds", "(0, -1e+91)", "at most 1e+90"});
}

TEST(Bad_input, place_nodes_checks_as_well)
{
  const CDT cdt = square();
  ::expect_throw<std::invalid_argument>([&] { CGAL::npbs_place_nodes(cdt, P::sizing_function(-1.)); },
                                        {"sizing_function", "-1"});
  ::expect_throw<std::invalid_argument>(
    [&] { CGAL::npbs_place_nodes(cdt, P::sizing_function(0.1).time_step(not_a_number)); }, {"time_step", "nan"});
  ::expect_throw<std::invalid_argument>([] { CGAL::npbs_place_nodes(CDT(), P::sizing_function(0.1)); },
                                        {"dimension"});
}

TEST(Callback, stops_at_any_call)
{
  std::size_t calls = 0;
  double last = 0;
  CDT counted = square();
  CGAL::npbs_relax(counted, P::sizing_function(0.1).callback([&](double fraction) {
    ++calls;
    EXPECT_GE(fraction, last);
    EXPECT_LE(fraction, 1);
    last = fraction;
    return true;
  }));
  EXPECT_EQ(last, 1);
  ASSERT_GT(calls, 10u);
  for (std::size_t at : {calls / 4, calls / 2}) { // of the simulation
    SCOPED_TRACE(at);
    std::size_t left = at;
    CDT cdt = square();
    const auto report = CGAL::npbs_relax(
      cdt, P::sizing_function(0.1).callback([&left](double) { return --left > 0; }));
    EXPECT_EQ(left, 0u) << "called again after it said stop";
    EXPECT_EQ(report.stop_reason, CGAL::Bubble_stop_reason::STOPPED_BY_CALLBACK);
    EXPECT_FALSE(report.converged);
    EXPECT_LT(report.number_of_steps, at);
    validation::expect_valid_mesh(cdt);
    EXPECT_GT(cdt.number_of_vertices(), 80u);
    EXPECT_NEAR(validation::domain_area(cdt), 1, 1e-9);
  }
}

TEST(Callback, may_throw)
{
  CDT cdt = square();
  int left = 20;
  expect_throw<My_error>(cdt, P::sizing_function(0.1).callback([&left](double) {
                           return --left > 0 ? true : throw My_error("stop");
                         }), {"stop"});
}

TEST(Callback, may_throw_at_the_last_call)
{
  CDT cdt = square();
  const validation::Snapshot before = validation::snapshot(cdt);
  const auto callback = [](double fraction) { return fraction < 1 ? true : throw My_error("at the end"); };
  EXPECT_THROW(CGAL::npbs_relax(cdt, P::sizing_function(0.1).callback(callback)), My_error);
  EXPECT_TRUE(validation::snapshot(cdt) == before); // with other vertices, since all was written
  EXPECT_TRUE(cdt.is_valid());
}

TEST(Bad_constraints, corners_beside_an_edge_by_a_rounding_are_named)
{
  int number_of_refusals = 0;
  for (int k = 0; k < 50; ++k) { // a plate, turned, and an inclusion with two corners on one of its sides
    const double angle = 0.01 + 0.007 * k, c = std::cos(angle), s = std::sin(angle);
    const auto turned = [&](const Point& p) { return Point(c * p.x() - s * p.y(), s * p.x() + c * p.y()); };
    const Point corners[] = {turned({1, 0}), turned({1.8, 0})};
    CDT cdt;
    const std::vector<Point> plate{turned({0, 0}), turned({4, 0}), turned({4, 2}), turned({0, 2})},
      inclusion{corners[0], corners[1], turned({2.1, 0.5}), turned({1.3, 0.5})};
    try {
      cdt.insert_constraint(plate.begin(), plate.end(), true);
      cdt.insert_constraint(inclusion.begin(), inclusion.end(), true);
    } catch (const CDT::Intersection_of_constraints_exception&) { // they lie on the other side
      continue;
    }
    const std::vector<Point> hole{turned({50, 50})};
    try {
      CGAL::npbs_relax(cdt, CGAL::Bubble_relaxation_parameters::sizing_function(0.1).seeds(hole));
    } catch (const std::runtime_error& e) {
      ++number_of_refusals;
      double x = 0, y = 0;
      const std::string text = e.what();
      ASSERT_EQ(std::sscanf(text.substr(text.find("the vertex (") + 12).c_str(), "%lf, %lf", &x, &y), 2) << text;
      EXPECT_LT((std::min)(CGAL::squared_distance(Point(x, y), corners[0]), CGAL::squared_distance(Point(x, y), corners[1])),
                1e-8) << text;
    }
  }
  EXPECT_GT(number_of_refusals, 0);
}

} // namespace test_bad_input
