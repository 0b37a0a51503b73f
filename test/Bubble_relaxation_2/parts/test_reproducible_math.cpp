// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// The package's own mathematical functions: how near they are to those of the library in long double, and that they
// have the same bits everywhere.

#include <CGAL/Bubble_relaxation_2/internal/core/reproducible_math.h>
#include <CGAL/Bubble_relaxation_2/internal/core/vocabulary.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <random>

namespace test_reproducible_math {

using namespace CGAL::Bubble_relaxation_2::internal;

constexpr double pi = 2 * half_pi, infinity = std::numeric_limits<double>::infinity();
constexpr int n = 200000; // random arguments

/// Random numbers that are the same everywhere: the distributions of the library are not.
class Random
{
public:
  double between(double a, double b) { return a + (b - a) * std::ldexp(static_cast<double>(m_engine() >> 11), -53); }

  /// of all magnitudes
  double of_magnitude(int smallest, int largest)
  {
    const int exponent = smallest + static_cast<int>(m_engine() % static_cast<std::uint64_t>(largest - smallest + 1));
    return std::ldexp(between(1, 2), exponent);
  }

private:
  std::mt19937_64 m_engine{1};
};

/// how far a value is from the right one, in units of the last digit of a number of this magnitude
double ulps(double value, long double right, double magnitude)
{
  const double unit = std::nextafter(magnitude, infinity) - magnitude;
  return static_cast<double>(std::abs(static_cast<long double>(value) - right)) / unit;
}

double ulps(double value, long double right) { return ulps(value, right, std::abs(static_cast<double>(right))); }

/// the largest error over random arguments; 0 where the library knows no more digits than `double` has
template <class Error>
double largest_error(const Error& error)
{
  if (std::numeric_limits<long double>::digits < 64)
    return 0;
  Random random;
  double largest = 0;
  for (int i = 0; i < n; ++i)
    largest = (std::max)(largest, error(random));
  return largest;
}

template <class Value>
std::uint64_t hash(const Value& value)
{
  Random random;
  std::uint64_t result = 0;
  for (int i = 0; i < n; ++i) {
    const double x = value(random);
    std::uint64_t bits;
    std::memcpy(&bits, &x, sizeof bits);
    result = hash_of_two(result, bits);
  }
  return result;
}

TEST(Reproducible_math, products_are_rounded_before_they_are_added)
{
  volatile double a = 1 + std::ldexp(1, -30), one = 1; // a^2 = 1 + 2^-29 + 2^-60
  const double square = a * a;
  EXPECT_EQ(square - one, std::ldexp(1, -29));
  const double x = a, y = one;
  EXPECT_EQ(x * x - y, std::ldexp(1, -29)) << "operations are fused: compile with -ffp-contract=off";
}

TEST(Reproducible_math, is_near_to_the_library)
{
  EXPECT_LE(largest_error([](Random& random) {
    const double x = random.of_magnitude(-290, 290), y = x * random.between(-2, 2);
    return ulps(length_of(x, y), std::hypot(static_cast<long double>(x), static_cast<long double>(y)));
  }), 1.2);
  EXPECT_LE(largest_error([](Random& random) {
    const double a = random.between(-pi / 4, pi / 4);
    return ulps(sine_of(a), std::sin(static_cast<long double>(a)));
  }), 1.);
  EXPECT_LE(largest_error([](Random& random) {
    const double a = random.between(-pi / 4, pi / 4);
    return ulps(cosine_of(a), std::cos(static_cast<long double>(a)));
  }), 1.2);
  EXPECT_LE(largest_error([](Random& random) {
    const double a = random.between(-1000, 1000);
    return (std::max)(ulps(sine_of(a), std::sin(static_cast<long double>(a)), 0.5),
                      ulps(cosine_of(a), std::cos(static_cast<long double>(a)), 0.5));
  }), 1.5);
  EXPECT_LE(largest_error([](Random& random) {
    const double x = random.between(-1, 1), y = random.between(-1, 1);
    return ulps(angle_of(x, y), std::atan2(static_cast<long double>(y), static_cast<long double>(x)));
  }), 2.);
  EXPECT_LE(largest_error([](Random& random) {
    const double x = random.of_magnitude(-300, 300);
    return ulps(logarithm_of(x), std::log(static_cast<long double>(x)));
  }), 1.7);
  EXPECT_LE(largest_error([](Random& random) {
    const double x = random.between(0.5, 2);
    return ulps(logarithm_of(x), std::log(static_cast<long double>(x)));
  }), 2.);
  EXPECT_LE(largest_error([](Random& random) {
    const double x = random.of_magnitude(-300, 300);
    return ulps(cube_root_of(x), std::cbrt(static_cast<long double>(x)));
  }), 1.);
}

TEST(Reproducible_math, special_values)
{
  EXPECT_EQ(length_of(3, 4), 5);
  EXPECT_EQ(length_of(-3e-90, 0), 3e-90);
  EXPECT_EQ(sine_of(0), 0);
  EXPECT_EQ(sine_of(pi / 2), 1);
  EXPECT_EQ(sine_of(-pi / 2), -1);
  EXPECT_EQ(cosine_of(0), 1);
  EXPECT_EQ(cosine_of(pi), -1);
  EXPECT_EQ(cosine_of(3 * pi), -1);
  EXPECT_NEAR(sine_of(pi), 1.2246467991473532e-16, 1e-26); // of pi rounded
  EXPECT_NEAR(sine_of(pi / 6), 0.5, 1e-16);
  EXPECT_EQ(angle_of(0, 0), 0);
  EXPECT_EQ(angle_of(1, 0), 0);
  EXPECT_EQ(angle_of(0, 1), pi / 2);
  EXPECT_EQ(angle_of(0, -1e-300), -pi / 2);
  EXPECT_EQ(angle_of(-1e180, 0.), pi);
  EXPECT_EQ(angle_of(-1, -0.), -pi);
  EXPECT_EQ(angle_of(1, 1), pi / 4);
  EXPECT_EQ(angle_of(-1, 1), 3 * (pi / 4));
  EXPECT_EQ(angle_of(1, 1e-20), 1e-20);
  EXPECT_EQ(logarithm_of(0), -infinity);
  EXPECT_EQ(logarithm_of(1), 0);
  EXPECT_EQ(logarithm_of(2), 0.69314718055994531);
  EXPECT_EQ(logarithm_of(std::numeric_limits<double>::denorm_min()), -744.44007192138122);
  EXPECT_EQ(cube_root_of(0), 0);
  EXPECT_EQ(cube_root_of(27), 3);
  EXPECT_EQ(cube_root_of(0.125), 0.5);
  EXPECT_EQ(cube_root_of(1e300), 1e100);
}

TEST(Reproducible_math, values_have_these_bits)
{
  EXPECT_EQ(length_of(0.1, 0.7), 0x1.6a09e667f3bccp-1);
  EXPECT_EQ(sine_of(0.1), 0x1.98eaecb8bcb2cp-4);
  EXPECT_EQ(sine_of(2.5), 0x1.326af0dcfcabp-1);
  EXPECT_EQ(sine_of(-4), 0x1.837b9dddc1eaep-1);
  EXPECT_EQ(cosine_of(0.1), 0x1.fd712f9a817cp-1);
  EXPECT_EQ(cosine_of(2.5), -0x1.9a2f7ef858b7dp-1);
  EXPECT_EQ(cosine_of(-100), 0x1.b981dbf665fep-1);
  EXPECT_EQ(angle_of(0.3, 0.1), 0x1.4978fa3269ee1p-2);
  EXPECT_EQ(angle_of(0.1, 0.3), 0x1.3fc176b7a856p+0);
  EXPECT_EQ(angle_of(-0.7, -0.5), -0x1.42bb5f776eb8p+1);
  EXPECT_EQ(logarithm_of(0.9), -0x1.af8e8210a415cp-4);
  EXPECT_EQ(logarithm_of(10), 0x1.26bb1bbb55516p+1);
  EXPECT_EQ(logarithm_of(1e-90), -0x1.9e771eff6ffa6p+7);
  EXPECT_EQ(cube_root_of(1.5), 0x1.250bfe1b082f5p+0);
  EXPECT_EQ(cube_root_of(1e-90), 0x1.4484bfeebc29fp-100);
}

TEST(Reproducible_math, random_values_have_these_bits)
{
  EXPECT_EQ(hash([](Random& r) {
    const double x = r.between(-1, 1);
    return length_of(x, r.between(-1, 1));
  }), 0xd8f2f69633ae312bu);
  EXPECT_EQ(hash([](Random& r) { return sine_of(r.between(-10, 10)); }), 0x6aecd084c399e253u);
  EXPECT_EQ(hash([](Random& r) { return cosine_of(r.between(-10, 10)); }), 0x6fbe9ca23a322654u);
  EXPECT_EQ(hash([](Random& r) {
    const double x = r.between(-1, 1);
    return angle_of(x, r.between(-1, 1));
  }), 0x4efece3d60fef9d9u);
  EXPECT_EQ(hash([](Random& r) { return logarithm_of(r.of_magnitude(-300, 300)); }), 0x9fe935566c8f1575u);
  EXPECT_EQ(hash([](Random& r) { return cube_root_of(r.of_magnitude(-300, 300)); }), 0x2f2103afcdf0fce0u);
}

} // namespace test_reproducible_math
