// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_MPI_TEAM_OF_RANKS_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_MPI_TEAM_OF_RANKS_H

#include <CGAL/Bubble_relaxation_2/internal/core/Team.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Communicator.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// What ranks know together at any stage. All members are collective. Statistics are the same as if one rank had all
/// values.
class Team_of_ranks : public Team
{
public:
  explicit Team_of_ranks(Communicator& comm) : m_comm(comm) {}

  bool is_alone() const override { return false; }
  bool any(bool here) const override { return m_comm.any(here); }
  void agree_after(const std::function<void()>& f) override { m_comm.agree_after(f); }
  double smallest(double value) const override { return m_comm.smallest(value); }
  double largest(double value) const override { return m_comm.largest(value); }

  void add_up(std::size_t* counts, std::size_t n) const override
  {
    std::vector<std::uint64_t> sums(counts, counts + n);
    m_comm.reduce_each(sums, MPI_SUM);
    std::copy(sums.begin(), sums.end(), counts);
  }

  void add_up(std::uint64_t& sum) const override { sum = m_comm.sum(sum); }

  std::vector<double> sorted_at(std::vector<double>& values, const std::vector<std::size_t>& positions) const override
  {
    std::sort(values.begin(), values.end());
    std::vector<double> result;
    for (std::uint64_t found :
         find_sorted(m_comm, values, bits, std::vector<std::int64_t>(positions.begin(), positions.end()),
                     [](std::int64_t count) { return count; }))
      result.push_back(number(found));
    return result;
  }

protected:
  Communicator& m_comm;

private:
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
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_MPI_TEAM_OF_RANKS_H
