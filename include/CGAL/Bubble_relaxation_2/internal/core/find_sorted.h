// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_CORE_FIND_SORTED_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_CORE_FIND_SORTED_H

#include <CGAL/Bubble_relaxation_2/internal/core/Progress.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Team.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <limits>
#include <map>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// What sorting the numbers of all ranks would bring to some positions. All are searched at once by halving: 64 times
/// each rank counts its numbers before each. No rank gets numbers of others.
/// \param count_before how many of this rank's numbers are smaller than one
/// \param all adds up counts of all ranks: a `Team`, or what ranks talk by
/// \returns the largest number that there is for positions where there is none
template <class Count, class All>
std::vector<std::uint64_t> find_sorted(const std::vector<std::size_t>& positions, const Count& count_before,
                                       const All& all)
{
  std::vector<std::uint64_t> found(positions.size(), 0); // the largest that are known to be small enough
  std::vector<std::size_t> counts(positions.size());
  for (int bit = 63; bit >= 0 && !positions.empty(); --bit) {
    const std::uint64_t half = std::uint64_t(1) << bit;
    for (std::size_t k = 0; k < found.size(); ++k)
      counts[k] = count_before(found[k] | half);
    all.add_up(counts.data(), counts.size());
    for (std::size_t k = 0; k < found.size(); ++k)
      if (counts[k] <= positions[k])
        found[k] |= half;
  }
  return found;
}

/// Values that get sorted as far as it takes to find some of them. \pre all are numbers
class Partly_sorted_values
{
public:
  /// changes the order of `values`
  explicit Partly_sorted_values(std::vector<double>& values)
    : m_values(values), m_before{{0, 0}, {(std::numeric_limits<std::uint64_t>::max)(), values.size()}}
  {
    if (values.empty())
      return;
    tick();
    const auto extremes = std::minmax_element(values.begin(), values.end());
    m_before[key_of(*extremes.first)] = 0;
    m_before[key_of(*extremes.second) + 1] = values.size();
  }

  /// how many have smaller keys
  std::size_t number_before(std::uint64_t key)
  {
    const auto next = m_before.lower_bound(key);
    if (next->first == key)
      return next->second;
    tick();
    const auto at = [this](std::size_t i) { return m_values.begin() + static_cast<std::ptrdiff_t>(i); };
    const auto middle = std::partition(at(std::prev(next)->second), at(next->second),
                                       [key](double value) { return key_of(value) < key; });
    return m_before.emplace_hint(next, key, static_cast<std::size_t>(middle - m_values.begin()))->second;
  }

  /// the value with a key; keys have the order of the values
  static double value_of(std::uint64_t key) { return reinterpreted<double>((key & sign) != 0 ? key ^ sign : ~key); }

private:
  static constexpr std::uint64_t sign = std::uint64_t(1) << 63;

  static std::uint64_t key_of(double value)
  {
    const std::uint64_t bits = reinterpreted<std::uint64_t>(value + 0.); // there is a negative zero
    return (bits & sign) != 0 ? ~bits : bits | sign;
  }

  template <class To, class From>
  static To reinterpreted(From from)
  {
    To to;
    std::memcpy(&to, &from, sizeof(to));
    return to;
  }

  std::vector<double>& m_values;
  std::map<std::uint64_t, std::size_t> m_before; // of keys that were asked about: the values to the left are smaller
};

/// The values that sorting those of all of a team would bring to some positions; not a number where there is none. Changes
/// the order of `values`. \pre all are numbers
inline std::vector<double> sorted_at(const std::vector<std::size_t>& positions, std::vector<double>& values,
                                     const Team& all)
{
  Partly_sorted_values sorting(values);
  std::vector<double> result;
  for (std::uint64_t key : find_sorted(positions, [&](std::uint64_t k) { return sorting.number_before(k); }, all))
    result.push_back(Partly_sorted_values::value_of(key));
  return result;
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_CORE_FIND_SORTED_H
