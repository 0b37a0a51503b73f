// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_PLACEMENT_GROWTH_HOLDERS_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_PLACEMENT_GROWTH_HOLDERS_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/vocabulary.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/parts/Hilbert_partition_2.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/parts/Lists_of_few.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// Which ranks have which bubble of a crystal that grows: the one in whose part it came in owns it, and those
/// whose parts are near have it too.
class Growth_holders_2
{
public:
  /// `rank`: this one
  Growth_holders_2(const Hilbert_partition_2& partition, int rank) : m_partition(partition), m_rank(rank) {}

  /// makes room for `n` more bubbles
  void make_room_for(std::size_t n)
  {
    internal::make_room_for(n, m_places);
    internal::make_room_for(n, m_owner);
    m_others.make_room_for(n);
  }

  int owner(std::size_t i) const { return m_owner[i]; }
  bool is_ours(std::size_t i) const { return m_owner[i] == m_rank; }

  /// A bubble came in at (x, y): it is known within `radius`. `parent`: one nearby that came before, or none.
  void add(double x, double y, double radius, Index parent)
  {
    const Index i = static_cast<Index>(m_owner.size());
    double clearance = clearance_at(x, y, parent);
    if (clearance < radius)
      clearance = find_clearance(x, y, radius);
    m_places.push_back(Place{x, y, clearance});
    m_others.resize(m_places.size());
    m_owner.push_back(clearance > 0 ? m_rank : m_partition.owner(x, y));
    if (clearance == 0 && is_ours(static_cast<std::size_t>(i)))
      for (int r : m_partition.owners_in_disc(x, y, radius))
        add_holder(i, r);
  }

  /// whether only this rank has, or will have, a bubble that comes in at (x, y) and is known within `radius`
  bool is_ours_alone(double x, double y, double radius, Index parent) const
  {
    return clearance_at(x, y, parent) >= radius;
  }

  /// how far from where a bubble came in all is of this rank, as far as that is known
  double clearance(Index i) const { return m_places[i].clearance; }

  /// whether all ranks within `radius` of (x, y) have a bubble of ours
  bool is_known_within(Index i, double x, double y, double radius) const
  {
    if (clearance_at(x, y, i) >= radius)
      return true;
    for (int r : m_partition.owners_in_disc(x, y, radius))
      if (!has(i, r))
        return false;
    return true;
  }

  /// the other ranks that have a bubble of ours
  const Lists_of_few<int>::List& others(Index i) const { return m_others[i]; }

  bool has(Index i, int rank) const { return rank == m_rank || m_others.has(i, rank); }

  void add_holder(Index i, int rank)
  {
    if (rank != m_rank)
      m_others.add_once(i, rank);
  }

private:
  /// where a bubble came in, and how far from there nothing belongs to other ranks; 0 if that is not known
  struct Place
  {
    double x, y, clearance;
  };

  /// looks ahead, for all that come after it
  double find_clearance(double x, double y, double radius) const
  {
    for (double factor : {4., 1.2})
      if (m_partition.owns_disc(m_rank, x, y, factor * radius))
        return factor * radius;
    return 0;
  }

  double clearance_at(double x, double y, Index parent) const
  {
    if (parent == no_index || m_places[parent].clearance == 0)
      return 0;
    const Place& p = m_places[parent];
    constexpr double rounding = 1e-9;
    return (std::max)(0., (1 - rounding) * p.clearance - length_at_most(x - p.x, y - p.y));
  }

  const Hilbert_partition_2& m_partition;
  const int m_rank;
  std::vector<int> m_owner;
  std::vector<Place> m_places;
  Lists_of_few<int> m_others; // that have a bubble of ours
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_PLACEMENT_GROWTH_HOLDERS_2_H
