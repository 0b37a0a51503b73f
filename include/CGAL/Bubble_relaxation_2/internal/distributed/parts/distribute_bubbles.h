// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_PARTS_DISTRIBUTE_BUBBLES_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_PARTS_DISTRIBUTE_BUBBLES_H

#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Communicator.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/sparse_exchange.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/parts/Clearance_2.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/parts/Hilbert_partition_2.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/parts/bubble_records.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// a bubble with its place on the curve
struct Keyed_record_2
{
  Hilbert_curve_2::Key key;
  Bubble_record_2 bubble;

  bool operator<(const Keyed_record_2& r) const
  {
    return std::tie(key, bubble.x, bubble.y, bubble.dimension, bubble.id) <
           std::tie(r.key, r.bubble.x, r.bubble.y, r.bubble.dimension, r.bubble.id);
  }
};

/// where on the curve a record is; to be sorted in place of it, since records are large
template <class Keyed_record>
struct Place_on_curve
{
  Hilbert_curve_2::Key key;
  const Keyed_record* record;

  bool operator<(const Place_on_curve& p) const { return key != p.key ? key < p.key : *record < *p.record; }
};

/// the places of records, in their order on the curve
template <class Keyed_record>
std::vector<Place_on_curve<Keyed_record>> places_on_curve(const std::vector<Keyed_record>& records)
{
  std::vector<Place_on_curve<Keyed_record>> places;
  places.reserve(records.size());
  for (const Keyed_record& r : records)
    places.push_back({r.key, &r});
  if (!std::is_sorted(places.begin(), places.end()))
    std::sort(places.begin(), places.end());
  return places;
}

/// The records that belong to a rank, in their order on the curve.
template <class Keyed_record>
struct Records_at_home
{
  std::vector<Place_on_curve<Keyed_record>> places;
  Messages<Keyed_record> others; ///< what came from other ranks; some of the places lead here

  std::vector<Keyed_record> records() const
  {
    std::vector<Keyed_record> result;
    result.reserve(places.size());
    for (const Place_on_curve<Keyed_record>& p : places)
      result.push_back(*p.record);
    return result;
  }
};

/// brings each bubble, with its key, to the rank that owns its place; those that are there already stay in memory
template <class Keyed_record>
Records_at_home<Keyed_record> bring_home(const Hilbert_partition_2& partition, Sparse_exchange& exchange, int rank,
                                         const std::vector<Place_on_curve<Keyed_record>>& sorted)
{
  using Place = Place_on_curve<Keyed_record>;
  Records_at_home<Keyed_record> home;
  Messages<Keyed_record> out;
  partition.for_each_owner(sorted.begin(), sorted.end(), [&](int owner, auto first, auto last) {
    if (owner == rank)
      home.places.assign(first, last);
    else
      std::transform(first, last, std::back_inserter(out[owner]), [](const Place& p) { return *p.record; });
  });
  home.others = exchange(out);
  const std::size_t own = home.places.size();
  for (const auto& message : home.others)
    for (const Keyed_record& r : message.second)
      home.places.push_back({r.key, &r});
  merge_tail(home.places, own);
  return home;
}

/// brings each bubble to the rank that owns its place, in the order of their numbers
inline Bubbles_2 bring_home(const Hilbert_partition_2& partition, Sparse_exchange& exchange, int rank,
                            Bubbles_2 bubbles)
{
  const Bubbles_2& b = bubbles;
  std::vector<Index> home;
  home.reserve(b.size());
  Messages<Bubble_record_2> out;
  Clearance_2 clearance(partition, rank);
  for (std::size_t i = 0; i < b.size(); ++i) {
    const int owner = clearance(b.x[i], b.y[i], b.d[i]) > 0 ? rank : partition.owner(b.x[i], b.y[i]);
    if (owner == rank)
      home.push_back(static_cast<Index>(i));
    else
      out[owner].push_back(record(b, i));
  }
  if (home.size() < b.size())
    bubbles.select(home);
  for (const auto& message : exchange(out))
    for (const Bubble_record_2& r : message.second)
      add_own(bubbles, r);
  bubbles.sort_by_id();
  return bubbles;
}

/// Numbers bubbles along the curve, the first of all ranks by 0.
/// \pre the records of each rank are sorted, and come before those of the next
inline Bubbles_2 number_along_curve(const Communicator& comm, const std::vector<Keyed_record_2>& records)
{
  std::int64_t number = comm.sum_before(static_cast<std::int64_t>(records.size()));
  Bubbles_2 result;
  result.make_room_for(records.size());
  for (Keyed_record_2 r : records) {
    r.bubble.id = number++;
    add_own(result, r.bubble);
  }
  return result;
}

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_PARTS_DISTRIBUTE_BUBBLES_H
