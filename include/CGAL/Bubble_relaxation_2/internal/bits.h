// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_BITS_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_BITS_H

#include <cmath>
#include <cstdint>
#include <cstring>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// The index of the lowest bit that is set. \pre one is
inline int lowest_bit(std::uint64_t bits)
{
#ifdef __GNUC__
  return __builtin_ctzll(bits);
#else
  int k = 0;
  for (int half = 32; half > 0; half /= 2)
    if (((bits >> k) << (64 - half)) == 0)
      k += half;
  return k;
#endif
}

/// 2 to the power of `exponent`
inline double power_of_two(int exponent)
{
  if (exponent < -1022 || exponent > 1023)
    return std::ldexp(1., exponent);
  const std::uint64_t bits = static_cast<std::uint64_t>(exponent + 1023) << 52;
  double power;
  std::memcpy(&power, &bits, sizeof power);
  return power;
}

/// the least e with `value` <= 2^e \pre `value` is positive
inline int exponent_above(double value)
{
  std::uint64_t bits;
  std::memcpy(&bits, &value, sizeof bits);
  const int biased = static_cast<int>(bits >> 52);
  if (biased > 0 && biased < 0x7FF)
    return biased - 1023 + ((bits << 12) != 0);
  int exponent;
  const double mantissa = std::frexp(value, &exponent);
  return mantissa == 0.5 ? exponent - 1 : exponent;
}

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_BITS_H
