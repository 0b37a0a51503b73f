// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_PARTS_PART_TEAM_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_PARTS_PART_TEAM_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/Progress.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Team.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Communicator.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Messages.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/parts/Hilbert_partition_2.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/parts/distribute_bubbles.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Bubble_buckets_2.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// Collective. How far from the part of its owner a bubble is at most, on any rank, or a bit more.
inline double farthest_stray(const Communicator& comm, const Hilbert_partition_2& partition, const Bubbles_2& own)
{
  double farthest = 0;
  for (std::size_t i = 0; i < own.size(); ++i) {
    tick(i);
    if (partition.owner(own.x[i], own.y[i]) == comm.rank())
      continue;
    double radius = 0.1 * own.d[i];
    for (bool is_near = false; !is_near; radius *= 2)
      is_near = is_among(partition.owners_in_disc(own.x[i], own.y[i], radius), comm.rank());
    farthest = (std::max)(farthest, radius); // twice that of the disc, beside which the part may be
  }
  return comm.largest(farthest);
}

/// Collective. Adds to the records of this rank such of others, so that two which are nearer to each other than `reach`
/// times the size of the larger one are known to the owners of both: each goes to the ranks `others(record, radius)` of
/// which something lies within that of it, and who gets to know a larger one tells its owner of smaller ones around it.
/// Returns who has what.
template <class Record, class Others>
Shared_lists share_around(Communicator& comm, double reach, std::vector<Record>& records, const Others& others)
{
  const std::size_t own = records.size();
  Shared_lists lists;
  std::unordered_map<Index, Hilbert_partition_2::Ranks> told;
  Messages<Record> out;
  const auto tell = [&](Index k, int rank) {
    if (rank == comm.rank() || !add_once(told[k], rank))
      return;
    lists.sent[rank].push_back(k);
    out[rank].push_back(records[k]);
  };
  const auto exchange = [&] {
    deliver(comm, out, [&](int rank, const Record& record) {
      lists.received[rank].push_back(static_cast<Index>(records.size()));
      records.push_back(record);
    });
    out.clear();
  };
  for (std::size_t k = 0; k < own; ++k) {
    tick(k);
    for (int rank : others(records[k], reach * records[k].d))
      tell(static_cast<Index>(k), rank);
  }
  exchange();
  double largest = 0;
  for (std::size_t l = own; l < records.size(); ++l)
    largest = (std::max)(largest, records[l].d);
  if (own != 0 && largest > 0) {
    Bubble_buckets_2 ours(2 * reach, records[0].d, records[0].x, records[0].y, 0);
    for (std::size_t k = 0; k < own; ++k)
      if (records[k].d < largest) // others were told where they are not smaller
        ours.insert(static_cast<Index>(k), records[k].x, records[k].y, records[k].d);
    for (const auto& list : lists.received)
      for (Index l : list.second)
        ours.for_each_within(records[l].x, records[l].y, reach * records[l].d, [&](const auto& e, double) {
          tell(e.id, list.first);
          return true;
        });
  }
  exchange();
  return lists;
}

/// Collective. The same of records that may lie up to `stray` beside the part of their owner.
template <class Record>
Shared_lists share_around(Communicator& comm, const Hilbert_partition_2& partition, double reach, double stray,
                          std::vector<Record>& records)
{
  constexpr double slack = 1 + 1e-9; // coordinates are rounded to cells of the curve
  Clearance_2 clearance(partition, comm.rank());
  return share_around(comm, reach, records, [&](const Record& r, double radius) {
    return clearance.others_in_disc(r.x, r.y, slack * radius + stray);
  });
}

/// What ranks know together at any stage. All members are collective. Statistics are those of one rank with all values.
class Team_of_ranks : public Team
{
public:
  explicit Team_of_ranks(Communicator& comm) : m_comm(comm) {}

  bool is_alone() const override { return false; }
  bool any(bool here) const override { return m_comm.any(here); }
  void agree_after(const std::function<void()>& f) override { m_comm.agree_after(f); }
  double smallest(double value) const override { return m_comm.smallest(value); }
  double largest(double value) const override { return m_comm.largest(value); }
  std::size_t number_before(std::size_t n) const override { return std::size_t(m_comm.sum_before(std::int64_t(n))); }
  void add_up(std::size_t* counts, std::size_t n) const override { m_comm.add_up(counts, n); }
  void add_up(std::uint64_t& sum) const override { sum = m_comm.sum(sum); }

protected:
  Communicator& m_comm;
};

/// Ranks of which each works on its own part of the plane, and which choose together among places for new bubbles.
class Part_team_2 : public Team_of_ranks
{
public:
  explicit Part_team_2(Communicator& comm) : Team_of_ranks(comm) {}

  bool owns_place(const Point& p) const override { return m_partition->owner(p.x(), p.y()) == m_comm.rank(); }

  Share_of_disc share_of(const Point& p, double radius) const override
  {
    const Hilbert_partition_2::Ranks owners = m_partition->owners_in_disc(p.x(), p.y(), radius);
    if (!is_among(owners, m_comm.rank()))
      return Share_of_disc::NONE;
    return owners.size() == 1 ? Share_of_disc::ALL : Share_of_disc::SOME;
  }

  std::size_t share_holes(std::vector<Hole_2>& holes, double reach) override
  {
    holes = send_home(m_comm, *m_partition, std::move(holes));
    const std::size_t number_of_ours = holes.size();
    m_candidates = share_around(m_comm, *m_partition, reach, 0, holes);
    return number_of_ours;
  }

  void share_choice(std::vector<char>& states) override { share_values(m_comm, m_candidates, states); }

protected:
  const Hilbert_partition_2* m_partition = nullptr; ///< who owns what, when it is known
  Shared_lists m_candidates;                        ///< among which is chosen
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_PARTS_PART_TEAM_2_H
