// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// Which names can start a chain of parameters, and that all names can follow: by the lists of CGAL and of the package, so
// that the compiler asks for each name of this version of CGAL. A chain goes on with any name if each link of it is of the
// package's class, and if that has all names.

#include <CGAL/Bubble_relaxation_parameters.h>

#include <gtest/gtest.h>

#include <functional>
#include <type_traits>
#include <utility>
#include <vector>

namespace P = CGAL::parameters;
namespace B = CGAL::Bubble_relaxation_parameters;

namespace {

struct Ours
{
  template <class T, class Tag, class Base>
  static std::true_type test(const CGAL::Bubble_relaxation_named_parameters<T, Tag, Base>&);
  static std::false_type test(...);
};

/// whether a chain can go on with all names
template <class Pack>
constexpr bool goes_on = decltype(Ours::test(std::declval<Pack>()))::value;

struct Yes
{
  bool operator()(double) const { return true; }
};

[[maybe_unused]] int any = 1; // some of CGAL's setters refer to what they are given

} // namespace

// of all kinds of CGAL's names
#define CGAL_add_named_parameter_with_compatibility(X, Y, Z) CGAL_add_named_parameter(X, Y, Z)
#define CGAL_add_extra_named_parameter_with_compatibility(X, Y, Z) CGAL_add_named_parameter(X, Y, Z)
#define CGAL_add_named_parameter_with_compatibility_cref_only(X, Y, Z) CGAL_add_named_parameter(X, Y, Z)
#define CGAL_add_named_parameter_with_compatibility_ref_only(X, Y, Z) CGAL_add_named_parameter(X, Y, Z)

TEST(Named_parameters_chains, every_name_follows_one_of_ours)
{
  using Pack = decltype(P::damping(1.));
  static_assert(goes_on<Pack>);
#define CGAL_add_named_parameter(X, Y, Z) static_assert(goes_on<decltype(std::declval<Pack>().Z(any))>);
#include <CGAL/Bubble_relaxation_2/internal/core/parameters_interface.h>
#include <CGAL/STL_Extension/internal/parameters_interface.h>
#undef CGAL_add_named_parameter
}

TEST(Named_parameters_chains, every_name_of_ours_starts_from_both_namespaces)
{
#define CGAL_add_named_parameter(X, Y, Z) static_assert(goes_on<decltype(P::Z(any))> && goes_on<decltype(B::Z(any))>);
#include <CGAL/Bubble_relaxation_2/internal/core/parameters_interface.h>
#undef CGAL_add_named_parameter
}

TEST(Named_parameters_chains, every_name_of_cgal_starts_from_our_namespace)
{
#define CGAL_add_named_parameter(X, Y, Z) static_assert(goes_on<decltype(B::Z(any))>);
#include <CGAL/STL_Extension/internal/parameters_interface.h>
#undef CGAL_add_named_parameter
}

// names of CGAL that functions of the package read, and are functions in CGAL, with all that an argument can be
#define EXPECT_TO_START(Z)                                                                                             \
  {                                                                                                                    \
    static_assert(goes_on<decltype(P::Z(1))> && goes_on<decltype(P::Z(0.5))> && goes_on<decltype(P::Z(Yes()))>);       \
    static_assert(goes_on<decltype(P::Z(any))> && goes_on<decltype(P::Z(yes))> && goes_on<decltype(P::Z(vector))>);    \
    static_assert(goes_on<decltype(P::Z(std::ref(yes)))> && goes_on<decltype(P::Z(std::cref(yes)))>);                  \
    static_assert(goes_on<decltype(P::Z(std::as_const(any)))> && goes_on<decltype(P::Z(number))>);                     \
    static_assert(goes_on<decltype(P::Z(count))> && goes_on<decltype(P::Z(function))>);                                \
    static_assert(goes_on<decltype(P::Z(std::as_const(vector)))>);                                                     \
    static_assert(!has_concepts || goes_on<decltype(P::Z(std::as_const(yes)))>);                                       \
  }

TEST(Named_parameters_chains, names_that_we_share_with_cgal_start)
{
#if defined(__cpp_concepts) && __cpp_concepts >= 201907L
  constexpr bool has_concepts = true;
#else
  constexpr bool has_concepts = false; // constants of other classes start a chain of CGAL's then
#endif
  Yes yes;
  std::vector<int> vector;
  const double number = 0.5;
  const std::size_t count = 3;
  const std::function<bool(double)> function = yes;
  EXPECT_TO_START(callback)
  EXPECT_TO_START(neighbor_radius)
  EXPECT_TO_START(number_of_iterations)
  EXPECT_TO_START(vertex_is_constrained_map)
  EXPECT_TO_START(visitor)
  EXPECT_TO_START(sizing_function)
  EXPECT_TO_START(concurrency_tag)
  static_cast<void>(yes);
  static_cast<void>(number);
  static_cast<void>(count);
}

TEST(Named_parameters_chains, what_follows_does_not_lose_what_was_first)
{
  namespace N = CGAL::internal_np;
  const auto f = [](double progress) { return progress < 0.5; };
  const int n = 30;
  const auto np = P::number_of_iterations(n).mass(2.).callback(f).time_step(0.1);
  EXPECT_EQ(P::get_parameter(np, N::number_of_iterations), 30);
  EXPECT_EQ(P::get_parameter(np, N::mass), 2);
  EXPECT_EQ(P::get_parameter(np, N::time_step), 0.1);
  EXPECT_TRUE(P::get_parameter(np, N::callback)(0.4));
  EXPECT_FALSE(P::get_parameter(np, N::callback)(0.6));
}

// seeds are objects in CGAL 6: in a chain of CGAL's they go with names of CGAL
TEST(Named_parameters_chains, seeds)
{
  namespace N = CGAL::internal_np;
  const std::vector<int> seeds{1, 2};
  const auto cgals = P::seeds(seeds).number_of_iterations(3).seeds_are_in_domain(true);
  EXPECT_EQ(P::get_parameter(cgals, N::seeds).size(), 2u);
  EXPECT_TRUE(P::get_parameter(cgals, N::seeds_are_in_domain));
  EXPECT_EQ(P::get_parameter(B::seeds(seeds).mass(2.), N::seeds).size(), 2u);
  EXPECT_EQ(P::get_parameter(P::number_of_iterations(3).seeds(seeds).mass(2.), N::seeds).size(), 2u);
}
