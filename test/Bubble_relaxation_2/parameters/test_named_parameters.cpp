// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// Named parameters: values come back whatever the order, CGAL's functions take the packs.

#include <CGAL/Bubble_relaxation_2/internal/core/read_options.h>
#include <CGAL/Bubble_relaxation_parameters.h>

#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

namespace test_named_parameters {

namespace P = CGAL::parameters;
namespace B = CGAL::Bubble_relaxation_parameters;
using CGAL::Bubble_relaxation_2::internal::Is_given;
using CGAL::Bubble_relaxation_2::internal::read_callback;
using CGAL::Bubble_relaxation_2::internal::read_options;

// as CGAL's functions take them
template <typename CGAL_NP_TEMPLATE_PARAMETERS>
int number_of_iterations(const CGAL_NP_CLASS& np)
{
  return P::choose_parameter(P::get_parameter(np, CGAL::internal_np::number_of_iterations), -1);
}

TEST(Named_parameters, values_come_back_in_any_order)
{
  const auto expect = [](const auto& np) {
    const auto o = read_options(np);
    EXPECT_EQ(o.damping, 0.45);
    EXPECT_EQ(o.mass, 2.5);
    EXPECT_EQ(o.number_of_iterations, 17u);
    EXPECT_EQ(o.number_of_rounds, 3u);
    const auto callback = read_callback(np);
    ASSERT_TRUE(bool(callback));
    EXPECT_FALSE(callback(0.5));
  };
  const auto stop = [](double) { return false; };
  expect(P::damping(0.45).mass(2.5).number_of_iterations(17).number_of_rounds(3).callback(stop));
  expect(P::number_of_rounds(3).callback(std::function<bool(double)>(stop)).number_of_iterations(17)
           .mass(2.5).damping(0.45));
  expect(B::callback(stop).number_of_iterations(17).number_of_rounds(3u).damping(0.45).mass(2.5));
  expect(B::number_of_iterations(17).damping(0.45).mass(2.5).callback(stop).number_of_rounds(3));
}

TEST(Named_parameters, every_name_is_read)
{
  const auto o = read_options(
    B::integrator(CGAL::Bubble_integrator::RUNGE_KUTTA_4).force_coefficient(3).time_step(0.25)
      .neighbor_radius(2.).renewal_interval(7).displacement_tolerance(0.5f)
      .initial_placement(CGAL::Bubble_placement::RHOMBIC)
      .population_control(CGAL::Bubble_population::NONE).maximum_number_of_bubbles(99));
  EXPECT_EQ(o.integrator, CGAL::Bubble_integrator::RUNGE_KUTTA_4);
  EXPECT_EQ(o.force_coefficient, 3);
  EXPECT_EQ(o.time_step, 0.25);
  EXPECT_EQ(o.neighbor_radius, 2);
  EXPECT_EQ(o.renewal_interval, 7u);
  EXPECT_EQ(o.displacement_tolerance, 0.5);
  EXPECT_TRUE(o.placement_is_given);
  EXPECT_EQ(o.placement, CGAL::Bubble_placement::RHOMBIC);
  EXPECT_EQ(o.population, CGAL::Bubble_population::NONE);
  EXPECT_EQ(o.maximum_number_of_bubbles, 99u);
}

TEST(Named_parameters, defaults_depend_on_the_integrator)
{
  const auto euler = read_options(P::default_values());
  EXPECT_EQ(euler.integrator, CGAL::Bubble_integrator::SEMI_IMPLICIT_EULER);
  EXPECT_EQ(euler.time_step, 0.6);
  EXPECT_EQ(euler.damping, 0.6);
  EXPECT_EQ(euler.displacement_tolerance, 0.0085);
  EXPECT_FALSE(euler.placement_is_given);
  const auto rk = read_options(P::integrator(CGAL::Bubble_integrator::RUNGE_KUTTA_4));
  EXPECT_EQ(rk.time_step, 0.02);
  EXPECT_EQ(rk.damping, 3.8429);
}

TEST(Named_parameters, of_the_paper)
{
  const auto o = read_options(CGAL::npbs_paper_parameters());
  EXPECT_EQ(o.integrator, CGAL::Bubble_integrator::RUNGE_KUTTA_4);
  EXPECT_EQ(o.force_coefficient, 1);
  EXPECT_EQ(o.mass, 1);
  EXPECT_EQ(o.damping, 3.8429);
  EXPECT_EQ(o.time_step, 0.02);
  EXPECT_EQ(o.number_of_iterations, 250u);
  EXPECT_EQ(o.neighbor_radius, 1.7);
  EXPECT_EQ(o.renewal_interval, 10u);
  EXPECT_EQ(o.displacement_tolerance, 0);
  EXPECT_EQ(o.placement, CGAL::Bubble_placement::RHOMBIC);
  EXPECT_EQ(o.population, CGAL::Bubble_population::OVERLAP_RATIO);
}

TEST(Named_parameters, interval_of_exchanges)
{
  EXPECT_EQ(read_options(P::default_values()).exchange_interval, 0u);
  EXPECT_EQ(read_options(P::exchange_interval(50)).exchange_interval, 50u);
  EXPECT_THROW(read_options(P::exchange_interval(-1)), std::invalid_argument);
  EXPECT_THROW(read_options(P::exchange_interval(0.5)), std::invalid_argument);
}

TEST(Named_parameters, the_last_setter_wins)
{
  EXPECT_EQ(read_options(CGAL::npbs_paper_parameters().time_step(0.5)).time_step, 0.5);
  EXPECT_EQ(read_options(P::mass(1.).mass(2.).mass(3.)).mass, 3);
}

TEST(Named_parameters, packs_are_taken_by_functions_of_cgal)
{
  EXPECT_EQ(number_of_iterations(P::damping(1.).number_of_iterations(5)), 5);
  EXPECT_EQ(number_of_iterations(B::number_of_iterations(6).mass(1.)), 6);
  EXPECT_EQ(number_of_iterations(P::mass(1.)), -1);
}

TEST(Named_parameters, of_meshless_methods)
{
  namespace N = CGAL::internal_np;
  const auto expect = [](const auto& np) {
    EXPECT_EQ(P::get_parameter(np, N::influence_search), CGAL::Influence_search::EXPANSION);
    EXPECT_EQ(P::get_parameter(np, N::support_radius), 0.15);
    EXPECT_EQ(P::get_parameter(np, N::support_factor), 2.5);
    EXPECT_EQ(P::get_parameter(np, N::mls_basis), CGAL::Moving_least_squares_basis::QUADRATIC);
    EXPECT_EQ(P::get_parameter(np, N::mls_weight), CGAL::Moving_least_squares_weight::GAUSSIAN);
    EXPECT_EQ(P::get_parameter(np, N::deficient_support), CGAL::Deficient_support::REPORT);
    EXPECT_EQ(P::get_parameter(np, N::maximum_condition_number), 1e6);
    EXPECT_EQ(P::get_parameter(np, N::dirichlet_condition), CGAL::Dirichlet_condition::PENALTY);
    EXPECT_EQ(P::get_parameter(np, N::penalty_factor), 1e4);
    EXPECT_EQ(P::get_parameter(np, N::nitsche_factor), 10);
    EXPECT_EQ(P::get_parameter(np, N::integration_cells), CGAL::Integration_cells::GRID);
    EXPECT_EQ(P::get_parameter(np, N::grid_cells).nx, 12);
    EXPECT_EQ(P::get_parameter(np, N::grid_cells).ny, 10);
    EXPECT_EQ(P::get_parameter(np, N::number_of_gauss_points), 3);
    EXPECT_TRUE(P::get_parameter(np, N::consistent_integration));
    EXPECT_EQ(P::get_parameter(np, N::residual_tolerance), 1e-9);
  };
  using E = CGAL::Influence_search;
  expect(P::influence_search(E::EXPANSION).support_radius(0.15).support_factor(2.5)
           .mls_basis(CGAL::Moving_least_squares_basis::QUADRATIC)
           .mls_weight(CGAL::Moving_least_squares_weight::GAUSSIAN)
           .deficient_support(CGAL::Deficient_support::REPORT).maximum_condition_number(1e6)
           .dirichlet_condition(CGAL::Dirichlet_condition::PENALTY).penalty_factor(1e4).nitsche_factor(10)
           .integration_cells(CGAL::Integration_cells::GRID).grid_cells(12, 10).number_of_gauss_points(3)
           .consistent_integration(true).residual_tolerance(1e-9));
  expect(P::residual_tolerance(1e-9).grid_cells(12, 10).consistent_integration(true).number_of_gauss_points(3)
           .integration_cells(CGAL::Integration_cells::GRID).nitsche_factor(10).penalty_factor(1e4)
           .dirichlet_condition(CGAL::Dirichlet_condition::PENALTY).maximum_condition_number(1e6)
           .deficient_support(CGAL::Deficient_support::REPORT)
           .mls_weight(CGAL::Moving_least_squares_weight::GAUSSIAN)
           .mls_basis(CGAL::Moving_least_squares_basis::QUADRATIC).support_factor(2.5).support_radius(0.15)
           .influence_search(E::EXPANSION));
  EXPECT_EQ(P::get_parameter(P::mass(1.).grid_cells(7), N::grid_cells), 7);
  // they go with those of other functions, and these read what is theirs
  EXPECT_EQ(read_options(P::support_factor(2.).damping(0.45).mls_basis(1)).damping, 0.45);
}

TEST(Named_parameters, references_and_copies)
{
  int calls = 0;
  auto counting = [&calls](double) { return ++calls > 0; };
  read_callback(P::damping(1.).callback(std::ref(counting)))(0);
  EXPECT_EQ(calls, 1);
  const auto d = [](int) { return 0.5; };
  const auto np = P::sizing_function(d);
  EXPECT_TRUE((Is_given<std::decay_t<decltype(np)>, CGAL::internal_np::sizing_function_t>::value));
  EXPECT_FALSE((Is_given<std::decay_t<decltype(np)>, CGAL::internal_np::seeds_t>::value));
}

} // namespace test_named_parameters
