// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_PARTS_PART_TEAM_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_PARTS_PART_TEAM_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/Team.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Communicator.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Messages.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/parts/Hilbert_partition_2.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/parts/Lists_of_few.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Bubble_buckets_2.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// Ranks of which each works on its own part of the plane, and which choose together among places for new bubbles.
class Part_team_2 : public Team
{
public:
  Part_team_2(Communicator& comm, const Hilbert_partition_2& partition) : Part_team_2(comm, &partition) {}

  bool is_alone() const override { return false; }
  bool any(bool here) const override { return m_comm.any(here); }
  bool owns_place(const Point& p) const override { return m_partition->owner(p.x(), p.y()) == m_comm.rank(); }

  Share_of_disc share_of(const Point& p, double radius) const override
  {
    const Hilbert_partition_2::Ranks owners = m_partition->owners_in_disc(p.x(), p.y(), radius);
    if (std::find(owners.begin(), owners.end(), m_comm.rank()) == owners.end())
      return Share_of_disc::NONE;
    return owners.size() == 1 ? Share_of_disc::ALL : Share_of_disc::SOME;
  }

  std::size_t share_holes(std::vector<Hole_2>& holes, double reach) override
  {
    Messages<Hole_2> out;
    for (const Hole_2& h : holes)
      out[m_partition->owner(h.x, h.y)].push_back(h);
    holes.clear();
    for (const auto& message : deliver(m_comm, out))
      holes.insert(holes.end(), message.second.begin(), message.second.end());
    const std::size_t number_of_ours = holes.size();
    m_holes = {};
    Lists_of_few<int> told(number_of_ours);
    out.clear();
    for (std::size_t k = 0; k < number_of_ours; ++k)
      for (int rank : m_partition->owners_in_disc(holes[k].x, holes[k].y, reach * holes[k].d))
        tell(holes, static_cast<Index>(k), rank, told, out);
    m_holes.deliver_to(holes, out, m_comm);
    out.clear();
    tell_of_smaller(holes, number_of_ours, reach, told, out);
    m_holes.deliver_to(holes, out, m_comm);
    return number_of_ours;
  }

  void share_choice(std::vector<char>& states) override { m_holes.share(m_comm, states); }

protected:
  /// `partition`: `nullptr` until it is known, before anything is asked
  Part_team_2(Communicator& comm, const Hilbert_partition_2* partition) : m_comm(comm), m_partition(partition) {}

  Communicator& m_comm;
  const Hilbert_partition_2* m_partition; ///< who owns what

private:
  /// who was told of a larger one tells of smaller ones near it
  void tell_of_smaller(const std::vector<Hole_2>& holes, std::size_t number_of_ours, double reach,
                       Lists_of_few<int>& told, Messages<Hole_2>& out)
  {
    if (number_of_ours == 0 || holes.size() == number_of_ours)
      return;
    Bubble_buckets_2 ours(2 * reach, holes[0].d, holes[0].x, holes[0].y, number_of_ours);
    for (std::size_t k = 0; k < number_of_ours; ++k)
      ours.insert(static_cast<Index>(k), holes[k].x, holes[k].y, holes[k].d);
    for (const auto& list : m_holes.received)
      for (Index l : list.second) {
        const double far = reach * holes[l].d;
        ours.for_each_near(holes[l].x, holes[l].y, holes[l].d, [&](Index k, double squared, double) {
          if (squared < far * far)
            tell(holes, k, list.first, told, out);
          return true;
        });
      }
  }

  void tell(const std::vector<Hole_2>& holes, Index k, int rank, Lists_of_few<int>& told, Messages<Hole_2>& out)
  {
    if (rank != m_comm.rank() && told.add_once(k, rank))
      m_holes.send(rank, holes, static_cast<std::size_t>(k), out);
  }

  Shared_lists m_holes;
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_PARTS_PART_TEAM_2_H
