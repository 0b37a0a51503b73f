// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_PARTS_BUBBLE_RECORDS_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_PARTS_BUBBLE_RECORDS_H

#include <CGAL/Bubble_relaxation_2/internal/core/Bubbles_2.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Progress.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Communicator.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Messages.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// a bubble on its way from one rank to another
struct Bubble_record_2
{
  double x, y, d, vx, vy, s;
  std::int64_t id;
  Index host, pin;
  std::int32_t dimension;
  std::int32_t owner = -1; ///< where somebody asks for it
};

/// One by one all bubbles are put on their way, and taken off it by `add()`: both tick.
inline Bubble_record_2 record(const Bubbles_2& b, std::size_t i, std::int64_t id)
{
  tick(i);
  return Bubble_record_2{b.x[i], b.y[i], b.d[i], b.vx[i], b.vy[i], b.s[i], id, b.host[i], b.pin[i], b.dimension[i]};
}

/// the same of one that has an identity
inline Bubble_record_2 record(const Bubbles_2& b, std::size_t i) { return record(b, i, b.id[i]); }

inline std::vector<Bubble_record_2> records_of(const Bubbles_2& b)
{
  std::vector<Bubble_record_2> records;
  records.reserve(b.size());
  for (std::size_t i = 0; i < b.size(); ++i)
    records.push_back(record(b, i));
  return records;
}

/// adds a bubble to some without identities
inline void add(Bubbles_2& bubbles, const Bubble_record_2& r)
{
  tick(bubbles.size());
  bubbles.add(Point(r.x, r.y), r.d, static_cast<Bubbles_2::Dimension>(r.dimension), r.host, r.s, r.pin);
  bubbles.vx.back() = r.vx;
  bubbles.vy.back() = r.vy;
}

/// adds a bubble to some that are all of this rank
inline void add_own(Bubbles_2& bubbles, const Bubble_record_2& r)
{
  add(bubbles, r);
  bubbles.id.push_back(r.id);
}

/// adds a bubble to some with owners
inline void add(Bubbles_2& bubbles, const Bubble_record_2& r, int owner)
{
  add_own(bubbles, r);
  bubbles.owner.push_back(owner);
}

/// bubbles of one rank, among which those of others will come
inline Bubbles_2 with_owner(const Bubbles_2& own, int rank)
{
  Bubbles_2 result;
  result.make_room_for(own.size() + own.size() / 8);
  result = own;
  result.owner.reserve(own.size() + own.size() / 8);
  result.owner.assign(own.size(), rank);
  result.rank = rank;
  return result;
}

/// those of its bubbles that a rank owns and that are left, in the same order, without owners
inline Bubbles_2 own_bubbles(Bubbles_2 bubbles)
{
  bubbles.select(indices_where(bubbles.size(), [&](Index i) { return bubbles.is_ours(i) && !bubbles.is_gone(i); }));
  bubbles.owner.clear();
  return bubbles;
}

/// all that a simulation knows of a bubble, on its way from one rank to another
struct Bubble_state_2
{
  Bubble_record_2 bubble;
  Bubble_memory_2 memory;
};

/// Collective. The corners of all ranks and their pinned bubbles, and, if asked for, all on edges, with their owners.
inline std::vector<Bubble_record_2> gather_outline(const Communicator& comm, const Bubbles_2& bubbles, bool with_edges)
{
  std::vector<Bubble_record_2> own;
  for (std::size_t i = 0; i < bubbles.size(); ++i)
    if (bubbles.is_ours(i) && (bubbles.is_corner(i) || (with_edges && bubbles.is_on_edge(i)))) {
      own.push_back(record(bubbles, i));
      own.back().owner = comm.rank();
    }
  return gather_records(comm, own);
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_PARTS_BUBBLE_RECORDS_H
