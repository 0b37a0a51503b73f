// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_PLACEMENT_BUBBLES_ON_CURVE_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_PLACEMENT_BUBBLES_ON_CURVE_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/Bubbles_2.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Communicator.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/sparse_exchange.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/parts/Hilbert_partition_2.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/parts/bubble_records.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_2.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// The order of a rank's bubbles along the curve. Bubbles stay where they are in memory until the end: what is sorted
/// are their keys.
class Bubbles_on_curve_2
{
public:
  Bubbles_on_curve_2(const Hilbert_curve_2& curve, Bubbles_2& bubbles) : m_curve(curve), m_bubbles(bubbles)
  {
    m_places.reserve(bubbles.size());
  }

  void add(Index i) { m_places.push_back(Place{m_curve.key(m_bubbles.x[i], m_bubbles.y[i]), i}); }

  void sort() { sort_from(0); }

  /// Collective. Cuts the curve so that all ranks own equally many bubbles. \pre they are sorted
  Hilbert_partition_2 even_partition(const Communicator& comm) const
  {
    return internal::even_partition(comm, m_curve, m_places);
  }

  /// Collective. Those that other ranks own go there, and others' come here. \pre they are sorted
  void bring_home(const Hilbert_partition_2& partition, Sparse_exchange& exchange, int rank)
  {
    std::vector<Place> home;
    Messages<Bubble_record_2> out;
    partition.for_each_owner(m_places.begin(), m_places.end(), [&](int owner, auto first, auto last) {
      if (owner == rank)
        home.assign(first, last);
      else
        std::transform(first, last, std::back_inserter(out[owner]), [this](const Place& p) {
          return record(m_bubbles, static_cast<std::size_t>(p.index), 0);
        });
    });
    m_places.swap(home);
    const std::size_t own = m_places.size();
    for (const auto& message : exchange(out))
      for (const Bubble_record_2& r : message.second) {
        internal::add(m_bubbles, r);
        add(static_cast<Index>(m_bubbles.size() - 1));
      }
    sort_from(own);
  }

  /// Of bubbles in one place the one of the lowest dimension stays. \pre they are sorted
  void forget_coincident()
  {
    m_places.erase(std::unique(m_places.begin(), m_places.end(),
                               [this](const Place& p, const Place& q) {
                                 return p.key == q.key && m_bubbles.x[p.index] == m_bubbles.x[q.index] &&
                                        m_bubbles.y[p.index] == m_bubbles.y[q.index];
                               }),
                   m_places.end());
  }

  /// Keeps these bubbles in this order and forgets the others, once; makes room for those of other ranks that will be
  /// added.
  void select()
  {
    std::vector<Index> order;
    order.reserve(m_places.size());
    for (const Place& p : m_places)
      order.push_back(p.index);
    m_bubbles.select(order);
  }

private:
  struct Place
  {
    Hilbert_curve_2::Key key;
    Index index;
  };

  /// \pre those before `first` are sorted
  void sort_from(std::size_t first)
  {
    merge_tail(m_places, first, [this](const Place& p, const Place& q) {
      return p.key != q.key ? p.key < q.key : values(p) < values(q);
    });
  }

  std::tuple<double, double, int, Index> values(const Place& p) const
  {
    const Index i = p.index;
    return std::make_tuple(m_bubbles.x[i], m_bubbles.y[i], int(m_bubbles.dimension[i]), i);
  }

  const Hilbert_curve_2 m_curve;
  Bubbles_2& m_bubbles;
  std::vector<Place> m_places;
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_PLACEMENT_BUBBLES_ON_CURVE_2_H
