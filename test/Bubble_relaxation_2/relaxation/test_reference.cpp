// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// The reference of npbs_relax() tells the defaults that hold.

#include <CGAL/Bubble_relaxation_2/internal/core/in_words.h>
#include <CGAL/Bubble_relaxation_2/internal/core/read_options.h>
#include <CGAL/Bubble_relaxation_parameters.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>

namespace test_reference {

using CGAL::Bubble_relaxation_2::internal::in_words;
using CGAL::Bubble_relaxation_2::internal::read_options;
using CGAL::Bubble_relaxation_2::internal::Relaxation_options;

/// what the reference says of a parameter's default, without spaces
std::string told_default(const std::string& name)
{
  std::ifstream file(BUBBLE_RELAXATION_2_INCLUDE_DIR "/CGAL/npbs_relax.h");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  std::smatch found;
  const std::regex pattern("cgalParamNBegin\\{" + name + "\\}[^]*?cgalParamDefault\\{([^}]*)\\}");
  EXPECT_TRUE(std::regex_search(text, found, pattern)) << name;
  std::string told = found[1];
  told.erase(std::remove(told.begin(), told.end(), ' '), told.end());
  return told;
}

std::string with_runge_kutta(double value) { return in_words(value) + "with`RUNGE_KUTTA_4`"; }

TEST(Reference, tells_numbers_as_they_are)
{
  const Relaxation_options o;
  const auto begins = [](const std::string& name, const auto& value) {
    const std::string told = told_default(name), number = in_words(static_cast<double>(value));
    EXPECT_EQ(told.substr(0, number.size()), number) << name;
    const char next = told.size() > number.size() ? told[number.size()] : ';';
    EXPECT_TRUE(next == ';' || next == ':' || next == ',') << name << ": " << told;
  };
  begins("number_of_rounds", o.number_of_rounds);
  begins("number_of_iterations", o.number_of_iterations);
  begins("displacement_tolerance", o.displacement_tolerance);
  begins("force_coefficient", o.force_coefficient);
  begins("mass", o.mass);
  begins("damping", o.damping);
  begins("time_step", o.time_step);
  begins("neighbor_radius", o.neighbor_radius);
  begins("renewal_interval", o.renewal_interval);
  EXPECT_EQ(told_default("maximum_number_of_bubbles"), "100000000");
  EXPECT_EQ(o.maximum_number_of_bubbles, 100000000u);
}

// the page of named parameters has a row for each of them
TEST(Reference, lists_all_names)
{
  const auto text_of = [](const char* path) {
    std::ifstream file(std::string(BUBBLE_RELAXATION_2_INCLUDE_DIR) + path);
    return std::string{std::istreambuf_iterator<char>(file), {}};
  };
  const std::string list = text_of("/CGAL/Bubble_relaxation_2/internal/core/parameters_interface.h"),
                    page = text_of("/../doc/Bubble_relaxation_2/standalone/named_parameters.txt");
  const std::regex name("CGAL_add_named_parameter\\([a-z_]+, [a-z_]+, ([a-z_]+)\\)");
  std::size_t n = 0;
  for (auto found = std::sregex_iterator(list.begin(), list.end(), name); found != std::sregex_iterator(); ++found, ++n)
    EXPECT_NE(page.find("`" + (*found)[1].str() + "`"), std::string::npos) << (*found)[1];
  EXPECT_GE(n, 50u);
}

TEST(Reference, tells_numbers_of_the_papers_integrator)
{
  const Relaxation_options o =
    read_options(CGAL::parameters::integrator(CGAL::Bubble_integrator::RUNGE_KUTTA_4));
  EXPECT_NE(told_default("displacement_tolerance").find(with_runge_kutta(o.displacement_tolerance)), std::string::npos);
  EXPECT_NE(told_default("time_step").find(with_runge_kutta(o.time_step)), std::string::npos);
  EXPECT_NE(told_default("damping").find(with_runge_kutta(o.damping)), std::string::npos);
}

TEST(Reference, tells_choices_as_they_are)
{
  const Relaxation_options o;
  EXPECT_EQ(o.integrator, CGAL::Bubble_integrator::SEMI_IMPLICIT_EULER);
  EXPECT_EQ(told_default("integrator").find("`SEMI_IMPLICIT_EULER`"), 0u);
  EXPECT_EQ(o.placement, CGAL::Bubble_placement::FRONTAL);
  EXPECT_EQ(told_default("initial_placement").find("`FRONTAL`"), 0u);
  EXPECT_EQ(o.population, CGAL::Bubble_population::DELAUNAY);
  EXPECT_EQ(told_default("population_control").find("`DELAUNAY`"), 0u);
  EXPECT_TRUE(o.defect_treatment);
  EXPECT_EQ(told_default("defect_treatment").find("`true`"), 0u);
  EXPECT_TRUE(o.limit_by_outline);
  EXPECT_EQ(told_default("limit_by_outline").find("`true`"), 0u);
}

} // namespace test_reference
