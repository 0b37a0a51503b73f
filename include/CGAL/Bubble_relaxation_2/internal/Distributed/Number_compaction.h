// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_NUMBER_COMPACTION_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_NUMBER_COMPACTION_H

#include <CGAL/Bubble_relaxation_2/internal/Distributed/Communicator.h>
#include <CGAL/Bubble_relaxation_2/internal/Distributed/exchange_known.h>
#include <CGAL/Bubble_relaxation_2/internal/Distributed/sparse_exchange.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// Replaces distinct numbers below `end`, of which each rank has some, by 0, 1, … in their order. Each rank counts
/// those of an interval of numbers, which are mostly its own. \pre they ascend
class Number_compaction
{
public:
  Number_compaction(const Communicator& comm, Sparse_exchange& exchange, std::int64_t end)
    : m_comm(comm), m_exchange(exchange), m_end(end)
  {}

  /// Collective. To be called once.
  void operator()(std::vector<std::int64_t>& numbers)
  {
    find_own(numbers);
    const Messages<std::int64_t> in = m_exchange(those_of_others(numbers));
    for (const auto& message : in)
      m_received.insert(m_received.end(), message.second.begin(), message.second.end());
    std::sort(m_received.begin(), m_received.end());
    m_before = m_comm.sum_before((m_last - m_first) + static_cast<std::int64_t>(m_received.size()));
    Messages<std::int64_t> replies, answers;
    for (const auto& message : in)
      for (std::int64_t number : message.second)
        replies[message.first].push_back(m_before + count_below(numbers, number));
    for (const auto& interval : m_intervals)
      answers[interval.first].resize(static_cast<std::size_t>(interval.second.second - interval.second.first));
    exchange_known(m_comm, replies, answers);
    compact_own(numbers);
    for (const auto& answer : answers)
      std::copy(answer.second.begin(), answer.second.end(), numbers.begin() + m_intervals[answer.first].first);
  }

private:
  using Position = std::ptrdiff_t; ///< among the numbers of this rank

  /// the first number that a rank counts
  std::int64_t first_of(int rank) const { return (rank * m_end + m_comm.size() - 1) / m_comm.size(); }

  static Position position(const std::vector<std::int64_t>& numbers, std::int64_t number)
  {
    return std::lower_bound(numbers.begin(), numbers.end(), number) - numbers.begin();
  }

  void find_own(const std::vector<std::int64_t>& numbers)
  {
    m_first = position(numbers, first_of(m_comm.rank()));
    m_last = position(numbers, first_of(m_comm.rank() + 1));
  }

  Messages<std::int64_t> those_of_others(const std::vector<std::int64_t>& numbers)
  {
    Messages<std::int64_t> out;
    const Position end = static_cast<Position>(numbers.size());
    for (Position first = 0; first < end;) {
      const int rank = static_cast<int>(numbers[first] * m_comm.size() / m_end);
      const Position last = position(numbers, first_of(rank + 1));
      if (rank != m_comm.rank()) {
        out[rank].assign(numbers.begin() + first, numbers.begin() + last);
        m_intervals[rank] = {first, last};
      }
      first = last;
    }
    return out;
  }

  /// of the numbers that this rank counts
  std::int64_t count_below(const std::vector<std::int64_t>& numbers, std::int64_t number) const
  {
    return (position(numbers, number) - m_first) + position(m_received, number);
  }

  void compact_own(std::vector<std::int64_t>& numbers) const
  {
    auto received = m_received.begin();
    for (Position k = m_first; k < m_last; ++k) {
      while (received != m_received.end() && *received < numbers[k])
        ++received;
      numbers[k] = m_before + (k - m_first) + (received - m_received.begin());
    }
  }

  const Communicator& m_comm;
  Sparse_exchange& m_exchange;
  const std::int64_t m_end;
  Position m_first = 0, m_last = 0; // between these are the numbers that this rank has and counts
  std::map<int, std::pair<Position, Position>> m_intervals; // of those that others count
  std::vector<std::int64_t> m_received;                     // others', which this rank counts
  std::int64_t m_before = 0;                                // which lower ranks count
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_NUMBER_COMPACTION_H
