// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_STAGE_EXCHANGE_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_STAGE_EXCHANGE_2_H

#include <CGAL/Bubble_relaxation_2/internal/Distributed/Communicator.h>
#include <CGAL/Bubble_relaxation_2/internal/Distributed/Halo_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Distributed/exchange_known.h>
#include <CGAL/Bubble_relaxation_2/internal/Distributed/sparse_exchange.h>
#include <CGAL/Bubble_relaxation_2/internal/Neighbor_sets_2.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// Tells neighbouring ranks where bubbles are at the stages of a step: those that are neighbours of theirs, since
/// forces look at no others. The halo is wider.
class Stage_exchange_2
{
public:
  explicit Stage_exchange_2(const Communicator& comm) : m_exchange(comm) {}

  /// Collective. Begins to tell where our bubbles are. `receive()` has to follow.
  void send(const Halo_2& halo, const Neighbor_sets_2& sets, const std::vector<double>& x, const std::vector<double>& y)
  {
    if (m_halo_changes != halo.number_of_changes() || m_set_changes != sets.number_of_changes())
      find_neighbors_of_others(halo, sets);
    for (auto& message : m_out) {
      const std::vector<Index>& list = halo.sent().at(message.first);
      for (Place& p : message.second) {
        const Index i = list[static_cast<std::size_t>(p.position)];
        p.x = x[i];
        p.y = y[i];
      }
    }
    for (const auto& list : halo.received())
      m_in[list.first].resize(list.second.size());
    m_exchange.start(m_out, m_in);
  }

  /// Collective. Puts in where the bubbles of others are. \pre `send()` was called, and the halo has not changed
  void receive(const Halo_2& halo, std::vector<double>& x, std::vector<double>& y)
  {
    m_exchange.finish();
    for (const auto& list : halo.received())
      for (const Place& p : m_in[list.first]) {
        const Index i = list.second[static_cast<std::size_t>(p.position)];
        x[i] = p.x;
        y[i] = p.y;
      }
  }

private:
  struct Place
  {
    double x, y;
    std::int64_t position; ///< in the list of the halo
  };

  void find_neighbors_of_others(const Halo_2& halo, const Neighbor_sets_2& sets)
  {
    m_out.clear();
    m_in.clear();
    for (const auto& list : halo.sent()) {
      std::vector<Place>& message = m_out[list.first];
      for (std::size_t n = 0; n < list.second.size(); ++n) {
        const Index i = list.second[n];
        if (std::any_of(sets.begin(i), sets.end(i), [&](Index j) { return halo.owner(j) == list.first; }))
          message.push_back(Place{0, 0, static_cast<std::int64_t>(n)});
      }
    }
    m_halo_changes = halo.number_of_changes();
    m_set_changes = sets.number_of_changes();
  }

  Known_exchange<Place> m_exchange;
  Messages<Place> m_out, m_in;
  std::size_t m_halo_changes = 0, m_set_changes = 0; // when the neighbours were found
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_STAGE_EXCHANGE_2_H
