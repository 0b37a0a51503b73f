// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// CGAL::Distributed::npbs_relax() with bad input, or when something fails on one rank: all ranks throw the same, or
// stop together, and have the points that they had

#include "relaxed_points.h"
#include "same_exception.h"

#include <CGAL/Distributed/triangulate.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

namespace test_distributed_faults {

using namespace relaxed_points;
using CGAL::Bubble_relaxation_2::internal::Communicator;
using distributed::expect_same_exception;
using distributed::last_rank;
using distributed::rank;
using distributed::size;
namespace parameters = CGAL::Bubble_relaxation_parameters;

bool is_last() { return rank() == last_rank(); }

std::string on_rank(int r) { return " on rank " + std::to_string(r); }

/// Points of a user, with a property, and with one that was removed.
Points users_points()
{
  Points points;
  points.add_property_map<int>("color", 7);
  points.remove(points.insert(Point(1, 2)));
  return points;
}

std::set<std::string> properties(const Points& points)
{
  const auto names = points.properties();
  return std::set<std::string>(names.begin(), names.end());
}

/// all ranks throw the same, and no rank's points change
template <class E, class NamedParameters>
void expect_failure(const std::string& part, const paper::CDT& domain, const NamedParameters& np)
{
  Points points = users_points();
  const std::set<std::string> before = properties(points);
  expect_same_exception<E>(part, [&] { CGAL::Distributed::npbs_relax(points, domain, MPI_COMM_WORLD, np); });
  EXPECT_EQ(points.number_of_points(), 0u);
  EXPECT_EQ(points.number_of_removed_points(), 1u);
  EXPECT_EQ(properties(points), before);
}

struct Case
{
  paper::Domain domain = paper::square_with_hole(1.5);
  paper::CDT cdt = paper::triangulate(domain);
};

auto few_steps() { return parameters::number_of_rounds(2).number_of_iterations(8); }

TEST(Distributed_faults, parameters_that_are_not_the_same)
{
  if (size() == 1)
    return;
  const Case c;
  const auto np = few_steps().sizing_function(c.domain.d);
  const std::string last = on_rank(last_rank());
  const auto expect = [&](const std::string& text, const auto& different) {
    expect_failure<std::invalid_argument>("parameter " + text + last, c.cdt, different);
  };
  const bool l = is_last();
  expect("damping = 0.7 on rank 0, but 0.5", np.damping(l ? 0.5 : 0.7));
  expect("mass = 1 on rank 0, but 2", np.mass(l ? 2. : 1.));
  expect("force_coefficient = 1 on rank 0, but 1.25", np.force_coefficient(l ? 1.25 : 1.));
  expect("time_step = 0.6 on rank 0, but 0.5", np.time_step(l ? 0.5 : 0.6));
  expect("displacement_tolerance = 0.007 on rank 0, but 0.008", np.displacement_tolerance(l ? 0.008 : 0.007));
  expect("neighbor_radius = 1.7 on rank 0, but 1.7000000000000002",
         np.neighbor_radius(l ? 1.7000000000000002 : 1.7));
  expect("number_of_rounds = 2 on rank 0, but 3", np.number_of_rounds(l ? 3 : 2));
  expect("number_of_iterations = 8 on rank 0, but 9", np.number_of_iterations(l ? 9 : 8));
  expect("maximum_number_of_bubbles = 90000 on rank 0, but 90001",
         np.maximum_number_of_bubbles(l ? 90001 : 90000));
  expect("renewal_interval = 0 on rank 0, but 10", np.renewal_interval(l ? 10 : 0));
  expect("exchange_interval = 0 on rank 0, but 10", np.exchange_interval(l ? 10 : 0));
  expect("defect_treatment = true on rank 0, but false", np.defect_treatment(!l));
  expect("limit_by_outline = false on rank 0, but true", np.limit_by_outline(l));
  expect("population_control = DELAUNAY on rank 0, but NONE",
         np.population_control(l ? CGAL::Bubble_population::NONE : CGAL::Bubble_population::DELAUNAY));
  expect("initial_placement = FRONTAL on rank 0, but RHOMBIC",
         np.initial_placement(l ? CGAL::Bubble_placement::RHOMBIC : CGAL::Bubble_placement::FRONTAL));
  expect("integrator = SEMI_IMPLICIT_EULER on rank 0, but RUNGE_KUTTA_4",
         np.integrator(l ? CGAL::Bubble_integrator::RUNGE_KUTTA_4 : CGAL::Bubble_integrator::SEMI_IMPLICIT_EULER));
}

TEST(Distributed_faults, sizing_functions_that_are_not_the_same)
{
  if (size() == 1)
    return;
  const Case c;
  expect_failure<std::invalid_argument>("parameter sizing_function = one that asks for", c.cdt,
                                        parameters::sizing_function(is_last() ? 0.2 : 0.21));
  // both are limited by the outline everywhere, to the same sizes
  std::vector<Point> hexagon;
  for (int k = 0; k < 6; ++k)
    hexagon.push_back(Point(1.22 * std::cos(k * CGAL_PI / 3), std::sin(k * CGAL_PI / 3)));
  paper::CDT cdt;
  cdt.insert_constraint(hexagon.begin(), hexagon.end(), true);
  expect_failure<std::invalid_argument>("parameter sizing_function = one that asks for", cdt,
                                        parameters::sizing_function(is_last() ? 1.6 : 100.).size_growth(0.01));
}

TEST(Distributed_faults, parameters_out_of_range_on_one_rank)
{
  const Case c;
  const auto np = parameters::sizing_function(c.domain.d);
  expect_failure<std::invalid_argument>("parameter mass = -1", c.cdt, np.mass(is_last() ? -1. : 1.));
  expect_failure<std::length_error>("maximum_number_of_bubbles", c.cdt, np.maximum_number_of_bubbles(20));
  const auto negative = [](const Point& p) { return is_last() && p.x() > 0.9 ? -1. : 0.2; };
  expect_failure<std::invalid_argument>("must be positive and finite", c.cdt, parameters::sizing_function(negative));
}

TEST(Distributed_faults, domains)
{
  const Case c;
  const auto np = few_steps().sizing_function(0.2);
  expect_failure<std::invalid_argument>("so it bounds no domain (on rank " + std::to_string(last_rank()) + ")",
                                        is_last() ? paper::CDT() : c.cdt, np);
  if (size() == 1)
    return;
  expect_failure<std::invalid_argument>("the domain is not the same on all ranks",
                                        is_last() ? paper::triangulate(paper::square_with_hole(2)) : c.cdt, np);
  paper::CDT with_vertex = c.cdt;
  with_vertex.insert(Point(0.75, 0.75));
  expect_failure<std::invalid_argument>("not the same vertices on all ranks", is_last() ? with_vertex : c.cdt, np);
}

/// `p` is given on the last rank only
template <class NamedParameters>
void expect_point_is_refused(const std::string& message, const Point& p, const NamedParameters& np)
{
  const Case c;
  Points points;
  if (is_last())
    points.insert(p);
  expect_same_exception<std::invalid_argument>(
    message, [&] { CGAL::Distributed::npbs_relax(points, c.cdt, MPI_COMM_WORLD, np); });
  EXPECT_EQ(points.size(), is_last() ? 1u : 0u);
  EXPECT_FALSE(points.has_property_map<double>("size"));
}

TEST(Distributed_faults, points_on_one_rank)
{
  const auto np = parameters::sizing_function(0.2);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  expect_point_is_refused("1 points on all ranks together, but there is no sizing_function", Point(0.75, 0.75),
                          parameters::mass(1.));
  expect_point_is_refused("(100, 0.75) is not in the domain", Point(100, 0.75), np);
  expect_point_is_refused("must be finite", Point(nan, 0.75), np);
}

/// A point with dimension 0 on the last rank: in a face it is pinned, and on an edge it would move in silence.
TEST(Distributed_faults, a_point_that_is_pinned_to_an_edge_on_one_rank)
{
  const Case c;
  const auto with_dimension_0 = [](const Point& p) {
    Points points;
    const auto dimension = points.add_property_map<int>("dimension", 2).first;
    if (is_last())
      dimension[*points.insert(p)] = 0;
    return points;
  };
  const Point on_edge(0.25, -1), in_face(0.75, 0.8125);
  const auto np = few_steps().sizing_function(c.domain.d);
  Points points = with_dimension_0(on_edge);
  expect_same_exception<std::invalid_argument>(
    "property dimension = 0 of the point (0.25, -1) pins it, but it lies on an edge",
    [&] { CGAL::Distributed::npbs_relax(points, c.cdt, MPI_COMM_WORLD, np); });
  EXPECT_EQ(points.size(), is_last() ? 1u : 0u);
  EXPECT_FALSE(points.has_property_map<double>("size"));
  EXPECT_NO_THROW(CGAL::Distributed::triangulate(points, c.cdt, MPI_COMM_WORLD)); // where nothing moves
  points = with_dimension_0(in_face);
  CGAL::Distributed::npbs_relax(points, c.cdt, MPI_COMM_WORLD, np);
  const Communicator comm(MPI_COMM_WORLD);
  EXPECT_TRUE(comm.any(std::any_of(points.begin(), points.end(), [&](const auto& i) {
    return points.point(i) == in_face;
  })));
}

/// a property of the points of the last rank has the wrong type: all ranks throw, and it stays
template <class T>
void expect_property_is_refused(const std::string& name, const std::string& type)
{
  const Case c;
  Points points;
  if (is_last()) {
    points.insert(Point(0.75, 0.75));
    points.add_property_map<T>(name, T(7));
  }
  const std::set<std::string> before = properties(points);
  const std::string message = "property " + name + " of the points must have values of the type " + type;
  expect_same_exception<std::invalid_argument>(message, [&] {
    CGAL::Distributed::npbs_relax(points, c.cdt, MPI_COMM_WORLD, few_steps().sizing_function(0.2));
  });
  expect_same_exception<std::invalid_argument>(message, [&] {
    CGAL::Distributed::triangulate(points, c.cdt, MPI_COMM_WORLD);
  });
  EXPECT_EQ(points.size(), is_last() ? 1u : 0u);
  EXPECT_EQ(properties(points), before);
}

TEST(Distributed_faults, properties_of_another_type_on_one_rank)
{
  expect_property_is_refused<int>("global_id", "std::int64_t");
  expect_property_is_refused<float>("size", "double");
  expect_property_is_refused<unsigned char>("dimension", "int");
  expect_property_is_refused<std::int64_t>("edge", "int");
  expect_property_is_refused<float>("position", "double");
}

/// d of the domain, which counts how often it is called on the last rank, and fails there once it has been called
/// as often as `last`
struct Failing_size
{
  const paper::Sizing& d;
  std::size_t last;
  std::size_t* calls;

  double operator()(const Point& p) const
  {
    if (is_last() && ++*calls == last)
      throw std::domain_error("no d at call " + std::to_string(last));
    return d(p);
  }
};

TEST(Distributed_faults, d_that_throws_on_one_rank)
{
  const Case c;
  std::size_t calls = 0;
  const auto np = [&](std::size_t last) {
    return few_steps().sizing_function(Failing_size{c.domain.d, last, &calls});
  };
  Points points;
  CGAL::Distributed::npbs_relax(points, c.cdt, MPI_COMM_WORLD, np(0));
  EXPECT_GT(points.size(), 0u);
  // while the domain is read, bubbles are placed and moved, the mesh is evaluated, and the points are written
  std::int64_t all = static_cast<std::int64_t>(calls);
  MPI_Bcast(&all, 1, MPI_INT64_T, last_rank(), MPI_COMM_WORLD);
  for (int part = 0; part <= 12; ++part) {
    const std::size_t last = static_cast<std::size_t>(1 + (all - 1) * part / 12);
    SCOPED_TRACE(last);
    calls = 0;
    expect_failure<std::domain_error>("no d at call " + std::to_string(last), c.cdt, np(last));
  }
}

/// the report of ranks that all stop since the last one's callback wants to, with their points as they were
template <class NamedParameters>
auto expect_stopped(const Case& c, const NamedParameters& np)
{
  Points points = users_points();
  const std::set<std::string> before = properties(points);
  const auto relaxation = CGAL::Distributed::npbs_relax(points, c.cdt, MPI_COMM_WORLD, np);
  EXPECT_EQ(relaxation.report.stop_reason, CGAL::Bubble_stop_reason::STOPPED_BY_CALLBACK);
  EXPECT_FALSE(relaxation.report.converged);
  EXPECT_EQ(relaxation.report.number_of_vertices, 0u);
  EXPECT_TRUE(relaxation.neighbors.empty());
  EXPECT_EQ(points.number_of_points(), 0u);
  EXPECT_EQ(points.number_of_removed_points(), 1u);
  EXPECT_EQ(properties(points), before);
  return relaxation.report;
}

TEST(Distributed_faults, one_rank_stops_all)
{
  const Case c;
  int calls = 0;
  const auto callback = [&calls](double) { return !is_last() || ++calls < 20; };
  const auto report = expect_stopped(c, parameters::sizing_function(c.domain.d).callback(callback));
  EXPECT_GT(report.number_of_steps, 0u);
  EXPECT_LT(report.number_of_steps, 20u); // phases and long loops call it too
}

TEST(Distributed_faults, one_rank_stops_all_in_the_treatment)
{
  const Case c;
  const auto callback = [](double progress) { return !is_last() || progress < 0.58; }; // where the treatment begins
  const auto report = expect_stopped(c, few_steps().sizing_function(c.domain.d).callback(callback));
  EXPECT_EQ(report.number_of_rounds, 2u);
}

TEST(Distributed_faults, a_callback_on_one_rank_only)
{
  const Case c;
  std::vector<double> progress;
  const auto callback = [&progress](double fraction) {
    progress.push_back(fraction);
    return true;
  };
  Points points;
  CGAL::Distributed::npbs_relax(
    points, c.cdt, MPI_COMM_WORLD,
    few_steps().sizing_function(c.domain.d)
      .callback(is_last() ? std::function<bool(double)>(callback) : std::function<bool(double)>()));
  EXPECT_GT(points.size(), 0u);
  if (!is_last())
    return;
  EXPECT_TRUE(std::is_sorted(progress.begin(), progress.end()));
  EXPECT_EQ(progress.back(), 1);
}

TEST(Distributed_faults, callbacks_that_throw_on_one_rank)
{
  const Case c;
  for (double when : {0., 0.3, 0.6, 0.9, 1.}) { // in all phases
    SCOPED_TRACE(when);
    const auto callback = [when](double progress) -> bool {
      if (is_last() && progress >= when)
        throw std::domain_error("no more");
      return true;
    };
    expect_failure<std::domain_error>("no more", c.cdt,
                                      few_steps().sizing_function(c.domain.d).callback(callback));
  }
}

TEST(Distributed_faults, communicators)
{
  const Case c;
  Points points;
  EXPECT_THROW(CGAL::Distributed::npbs_relax(points, c.cdt, MPI_COMM_NULL), std::invalid_argument);
}

} // namespace test_distributed_faults
