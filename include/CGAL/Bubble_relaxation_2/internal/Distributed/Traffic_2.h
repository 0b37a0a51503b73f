// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_TRAFFIC_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_TRAFFIC_2_H

#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// What one rank of a simulation holds of others and sends to them. The control of the population and reductions
/// do not count.
struct Traffic_2
{
  std::int64_t steps = 0;
  std::int64_t ghosts = 0;    ///< bubbles of others that it holds, summed over the steps
  std::int64_t neighbors = 0; ///< ranks that it has such bubbles of, summed over the steps
  std::int64_t waits = 0;     ///< bubbles that stopped in another's part until the next exchange (paper's protocol)
  std::int64_t messages = 0;  ///< that it has sent: moves, bubbles made known, and bubbles that go home
  std::int64_t bytes = 0;     ///< in these messages

  void add_message(std::size_t size)
  {
    ++messages;
    bytes += static_cast<std::int64_t>(size);
  }

  /// `Messages`: see `Sparse_exchange`
  template <class Messages>
  void add_messages(const Messages& out)
  {
    for (const auto& message : out)
      if (!message.second.empty())
        add_message(message.second.size() * sizeof(message.second[0]));
  }
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_TRAFFIC_2_H
