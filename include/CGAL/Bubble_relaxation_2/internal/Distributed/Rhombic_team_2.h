// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors
#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_RHOMBIC_TEAM_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_RHOMBIC_TEAM_2_H

#include <CGAL/Bubble_relaxation_2/internal/Distributed/Hilbert_partition_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Distributed/Hole_exchange_2.h>
#include <CGAL/Bubble_relaxation_2/internal/place_rhombic.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// The ranks that place bubbles in cells together, each those whose centres are in its part.
class Rhombic_team_2
{
public:
  Rhombic_team_2(const Communicator& comm, Sparse_exchange& exchange, const Hilbert_partition_2& partition)
    : m_rank(comm.rank()), m_partition(partition), m_holes(comm, exchange)
  {}

  Share_of_disc share_of(const Point& p, double radius) const
  {
    const Hilbert_partition_2::Ranks owners = m_partition.owners_in_disc(p.x(), p.y(), radius);
    if (std::find(owners.begin(), owners.end(), m_rank) == owners.end())
      return Share_of_disc::NONE;
    return owners.size() == 1 ? Share_of_disc::ALL : Share_of_disc::SOME;
  }

  bool owns_place(const Point& p) const { return m_partition.owner(p.x(), p.y()) == m_rank; }

  std::size_t share_holes(std::vector<Hole_2>& holes, double reach)
  {
    return m_holes.share(m_partition, holes, reach);
  }

  template <class Choice>
  void decide(Choice& choice) const
  {
    m_holes.decide(choice);
  }

private:
  const int m_rank;
  const Hilbert_partition_2& m_partition;
  Hole_exchange_2 m_holes;
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_RHOMBIC_TEAM_2_H
