// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_WRITING_WRITE_NEIGHBORS_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_WRITING_WRITE_NEIGHBORS_H

#include <CGAL/Bubble_relaxation_2/internal/core/Bubbles_2.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Communicator.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Messages.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/parts/Hilbert_partition_2.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/parts/bubble_records.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Bubble_buckets_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Neighbor_search_2.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <set>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// The bubbles of a rank, in the order of their numbers, and after them those of other ranks that are neighbours of
/// one of them, and perhaps some more.
struct Bubbles_with_ghosts_2
{
  Bubbles_2 known;
  std::size_t number_of_own = 0;
  double radius = 0; ///< of the sets
  std::unique_ptr<Bubble_buckets_2> buckets; ///< with all of them, if there are any
};

/// Finds the bubbles of other ranks that are neighbours of those of this one: nearer than `radius` times the mean of
/// both sizes, so nearer than that times the larger one.
///
/// Each bubble is sent to the ranks whose pieces of the plane a disc with that radius around it meets, so the rank in
/// whose piece the smaller one of two neighbours lies knows both, and tells the owner of each of the other. It need
/// own none of them: a bubble may have moved out of the piece of its owner.
class Neighbors_of_ranks_2
{
public:
  Neighbors_of_ranks_2(const Bubbles_2& own, const Hilbert_partition_2& partition, double radius, Communicator& comm)
    : m_partition(partition), m_comm(comm),
      m_result{with_owner(own, comm.rank()), own.size(), radius, nullptr}, m_known(m_result.known)
  {}

  Neighbors_of_ranks_2(const Neighbors_of_ranks_2&) = delete;
  Neighbors_of_ranks_2& operator=(const Neighbors_of_ranks_2&) = delete;

  /// Collective.
  Bubbles_with_ghosts_2 operator()()
  {
    insert_in_buckets(0);
    Messages<Bubble_record_2> out;
    tell_of_own(out);
    learn(deliver(m_comm, out));
    out.clear();
    tell_of_pairs(out);
    learn(deliver(m_comm, out));
    return std::move(m_result);
  }

private:
  void tell_of_own(Messages<Bubble_record_2>& out)
  {
    constexpr double slack = 1 + 1e-9; // coordinates are rounded to cells of the curve
    const Bubbles_2& b = m_known;
    Clearance_2 clearance(m_partition, m_comm.rank());
    for (std::size_t i = 0; i < m_result.number_of_own; ++i)
      for (int rank : clearance.others_in_disc(b.x[i], b.y[i], slack * m_result.radius * b.d[i]))
        tell(static_cast<Index>(i), rank, out);
  }

  void tell_of_pairs(Messages<Bubble_record_2>& out)
  {
    const Bubbles_2& b = m_known;
    for (std::size_t k = m_result.number_of_own; k < b.size(); ++k) {
      const Index i = static_cast<Index>(k);
      m_result.buckets->for_each_near(b.x[k], b.y[k], b.d[k], [&](Index j, double, double) {
        tell(i, m_known.owner[j], out);
        tell(j, m_known.owner[i], out);
        return true;
      });
    }
  }

  /// once; neither ourselves, nor the owner of a bubble need be told
  void tell(Index i, int rank, Messages<Bubble_record_2>& out)
  {
    if (rank == m_comm.rank() || rank == m_known.owner[i] || !m_told.insert({i, rank}).second)
      return;
    out[rank].push_back(record(m_known, static_cast<std::size_t>(i)));
    out[rank].back().owner = m_known.owner[i];
  }

  void learn(const Messages<Bubble_record_2>& in)
  {
    const std::size_t first = m_known.size();
    for (const auto& message : in)
      for (const Bubble_record_2& r : message.second)
        if (m_learnt.insert(r.id).second)
          add(m_known, r, r.owner);
    insert_in_buckets(first);
  }

  /// all from `first` on
  void insert_in_buckets(std::size_t first)
  {
    const Bubbles_2& b = m_known;
    if (!m_result.buckets && b.size() != 0)
      m_result.buckets = std::make_unique<Bubble_buckets_2>(m_result.radius, b.d[0], b.x[0], b.y[0], b.size());
    for (std::size_t i = first; i < b.size(); ++i)
      m_result.buckets->insert(static_cast<Index>(i), b.x[i], b.y[i], b.d[i]);
  }

  const Hilbert_partition_2& m_partition;
  Communicator& m_comm;
  Bubbles_with_ghosts_2 m_result;
  Bubbles_2& m_known; // of the result
  std::set<std::pair<Index, int>> m_told; // of which bubble which rank
  std::unordered_set<std::int64_t> m_learnt;
};

/// Collective. The bubbles of this rank, and all bubbles of others that are neighbours of one of them.
/// \pre the numbers of `own` ascend
inline Bubbles_with_ghosts_2 with_neighbors(const Bubbles_2& own, const Hilbert_partition_2& partition,
                                           double radius, Communicator& comm)
{
  return Neighbors_of_ranks_2(own, partition, radius, comm)();
}

/// Writes what a rank has to know of the neighbours that others own, in the order of their numbers.
template <class Relaxation>
void write_ghosts(const Bubbles_2& b, const std::vector<char>& is_ghost, Relaxation& relaxation)
{
  std::vector<std::pair<std::int64_t, std::size_t>> ghosts;
  for (std::size_t i = 0; i < b.size(); ++i)
    if (is_ghost[i])
      ghosts.emplace_back(b.id[i], i);
  std::sort(ghosts.begin(), ghosts.end());
  for (const auto& ghost : ghosts) {
    const std::size_t i = ghost.second;
    relaxation.ghost_ids.push_back(b.id[i]);
    relaxation.ghost_points.push_back(typename Relaxation::Point_2(b.x[i], b.y[i]));
    relaxation.ghost_sizes.push_back(b.d[i]);
    relaxation.ghost_owners.push_back(b.owner[i]);
  }
}

/// Writes the neighbour sets of the bubbles of a rank into a `Relaxation_2`, and what it has to know of neighbours
/// that others own.
template <class Relaxation>
void write_neighbors(const Bubbles_with_ghosts_2& bubbles, Relaxation& relaxation)
{
  constexpr std::size_t block_size = Neighbor_search_2::block_size, usual_number = 7;
  const Bubbles_2& known = bubbles.known;
  const std::size_t n = bubbles.number_of_own;
  const auto is_gone = [](std::size_t) { return false; };
  const auto is_before = [&known](Index i, Index j) { return known.id[i] < known.id[j]; };
  relaxation.neighbor_radius = bubbles.radius;
  relaxation.neighbors.reserve(usual_number * n);
  relaxation.neighbor_offsets.reserve(n + 1);
  relaxation.neighbor_offsets.push_back(0);
  if (n == 0)
    return;
  std::vector<char> is_neighbor(known.size(), 0);
  const Neighbor_search_2 find(*bubbles.buckets, known.x, known.y, known.d, bubbles.radius);
  Neighbor_block block;
  for (std::size_t first = 0; first < n; first += block_size) {
    find(first, (std::min)(first + block_size, n), is_gone, is_before, block);
    for (Index j : block.found) {
      relaxation.neighbors.push_back(known.id[j]);
      is_neighbor[j] = 1;
    }
    for (std::size_t size : block.sizes)
      relaxation.neighbor_offsets.push_back(relaxation.neighbor_offsets.back() + size);
  }
  std::fill_n(is_neighbor.begin(), n, char(0)); // of others only
  write_ghosts(known, is_neighbor, relaxation);
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_WRITING_WRITE_NEIGHBORS_H
