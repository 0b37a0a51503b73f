// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_VALUES_OF_ALL_RANKS_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_VALUES_OF_ALL_RANKS_H

#include <CGAL/Bubble_relaxation_2/internal/Distributed/Communicator.h>
#include <CGAL/Bubble_relaxation_2/internal/order_independent.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// What the values of all ranks are like, for statistics that are the same as if one rank had them all. All
/// members are collective. See `All_values_here`.
class Values_of_all_ranks
{
public:
  explicit Values_of_all_ranks(const Communicator& comm) : m_comm(comm) {}

  double smallest(double value) const { return m_comm.smallest(value); }
  double largest(double value) const { return m_comm.largest(value); }

  template <std::size_t n>
  std::array<std::size_t, n> sums(const std::array<std::size_t, n>& counts) const
  {
    std::array<std::uint64_t, n> result;
    std::copy(counts.begin(), counts.end(), result.begin());
    add_up(result.data(), n);
    std::array<std::size_t, n> sums;
    std::copy(result.begin(), result.end(), sums.begin());
    return sums;
  }

  /// Finds them byte after byte: how many values that begin as far as is known go on with which byte tells the
  /// next one. No rank gets values of others, nor all positions a walk over all values.
  template <std::size_t n>
  std::array<double, n> sorted_at(const std::vector<double>& values,
                                  const std::array<std::size_t, n>& positions) const
  {
    std::vector<std::uint64_t> candidates(values.size());
    std::transform(values.begin(), values.end(), candidates.begin(), bits);
    std::array<std::uint64_t, n> found{}, rest;
    std::copy(positions.begin(), positions.end(), rest.begin());
    for (int shift = 56; shift >= 0; shift -= 8) {
      const std::vector<std::uint64_t> known = distinct(found);
      std::vector<std::uint64_t> counts(known.size() * 256, 0);
      const auto leave = [&](std::uint64_t candidate) { return !count(candidate, shift, known, counts); };
      candidates.erase(std::remove_if(candidates.begin(), candidates.end(), leave), candidates.end());
      add_up(counts.data(), counts.size());
      for (std::size_t k = 0; k < n; ++k) {
        const auto place = std::lower_bound(known.begin(), known.end(), found[k]) - known.begin();
        add_byte(&counts[static_cast<std::size_t>(place) * 256], found[k], rest[k]);
      }
    }
    std::array<double, n> result;
    std::transform(found.begin(), found.end(), result.begin(), number);
    return result;
  }

private:
  void add_up(std::uint64_t* counts, std::size_t n) const
  {
    check_mpi(MPI_Allreduce(MPI_IN_PLACE, counts, static_cast<int>(n), MPI_UINT64_T, MPI_SUM, m_comm.handle()));
  }

  /// of numbers that are not negative; they have the order of their bits
  static std::uint64_t bits(double value)
  {
    value += 0.; // there is a negative zero
    std::uint64_t result;
    std::memcpy(&result, &value, sizeof(result));
    return result;
  }

  static double number(std::uint64_t bits)
  {
    double result;
    std::memcpy(&result, &bits, sizeof(result));
    return result;
  }

  /// what is known of the values at several positions, sorted: at first there is little that differs
  template <std::size_t n>
  static std::vector<std::uint64_t> distinct(const std::array<std::uint64_t, n>& found)
  {
    std::vector<std::uint64_t> result(found.begin(), found.end());
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

  /// counts the next byte of a candidate that begins as one of those that are known; whether it does
  static bool count(std::uint64_t candidate, int shift, const std::vector<std::uint64_t>& known,
                    std::vector<std::uint64_t>& counts)
  {
    const std::uint64_t first_bytes = shift == 56 ? 0 : candidate >> (shift + 8);
    for (std::size_t k = 0; k < known.size(); ++k)
      if (known[k] == first_bytes) {
        ++counts[k * 256 + (candidate >> shift & 255)];
        return true;
      }
    return false;
  }

  static void add_byte(const std::uint64_t* counts, std::uint64_t& found, std::uint64_t& rest)
  {
    std::uint64_t byte = 0;
    for (; byte < 255 && rest >= counts[byte]; ++byte)
      rest -= counts[byte];
    found = found << 8 | byte;
  }

  const Communicator& m_comm;
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_VALUES_OF_ALL_RANKS_H
