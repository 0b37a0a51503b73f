// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_PARTS_DISTRIBUTE_BUBBLES_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_PARTS_DISTRIBUTE_BUBBLES_H

#include <CGAL/Bubble_relaxation_2/internal/core/Bubbles_2.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Progress.h>
#include <CGAL/Bubble_relaxation_2/internal/core/in_words.h>
#include <CGAL/Bubble_relaxation_2/internal/core/parallel_for.h>
#include <CGAL/Bubble_relaxation_2/internal/core/reproducible_math.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Communicator.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Messages.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/parts/Hilbert_partition_2.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/parts/bubble_records.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_2.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/remove_coincident.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>
#include <tuple>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// bubbles of one rank, and who owns what
struct Placed_part_2
{
  Bubbles_2 bubbles;
  Hilbert_partition_2 partition;
};

/// brings each of some records with places and sizes to the rank that owns its place
template <class Record>
std::vector<Record> send_home(Communicator& comm, const Hilbert_partition_2& partition, std::vector<Record> records)
{
  Messages<Record> out;
  Clearance_2 clearance(partition, comm.rank());
  std::size_t home = 0; // so many of the first ones are; there is no memory for all once more
  for (std::size_t k = 0; k < records.size(); ++k) {
    tick(k);
    const Record r = records[k];
    const int owner = clearance(r.x, r.y, r.d) > 0 ? comm.rank() : partition.owner(r.x, r.y);
    if (owner == comm.rank())
      records[home++] = r;
    else
      out[owner].push_back(r);
  }
  records.resize(home);
  deliver(comm, out, [&](int, const Record& r) { records.push_back(r); });
  return records;
}

/// brings each bubble to the rank that owns its place, in the order of their numbers \pre they are without owners
inline Bubbles_2 send_home(Communicator& comm, const Hilbert_partition_2& partition, const Bubbles_2& bubbles)
{
  Bubbles_2 home;
  home.make_room_for(bubbles.size() + bubbles.size() / 8);
  for (const Bubble_record_2& r : send_home(comm, partition, records_of(bubbles)))
    add_own(home, r);
  home.sort_by_id();
  return home;
}

/// the keys and indices of bubbles along a curve
inline std::vector<std::pair<Hilbert_curve_2::Key, Index>> places_on(const Hilbert_curve_2& curve,
                                                                     const std::vector<Bubble_record_2>& bubbles)
{
  std::vector<std::pair<Hilbert_curve_2::Key, Index>> places;
  places.reserve(bubbles.size());
  for (std::size_t i = 0; i < bubbles.size(); ++i) {
    tick(i);
    places.emplace_back(curve.key(bubbles[i].x, bubbles[i].y), static_cast<Index>(i));
  }
  parallel_sort(Threads(), places, [&bubbles](const auto& p, const auto& q) {
    const Bubble_record_2 &b = bubbles[p.second], &c = bubbles[q.second];
    return std::tie(p.first, b.x, b.y, b.dimension, p.second) < std::tie(q.first, c.x, c.y, c.dimension, q.second);
  });
  return places;
}

/// Collective. Cuts the curve so that all ranks own equally many bubbles, which are on any ranks, and brings each to
/// its owner, along the curve.
inline Placed_part_2 send_home_evenly(Communicator& comm, const Hilbert_curve_2& curve,
                                      const std::vector<Bubble_record_2>& bubbles)
{
  const auto places = places_on(curve, bubbles);
  Placed_part_2 result{{}, even_partition(comm, curve, places, [](const auto& p) { return p.first; },
                                          [](std::int64_t number) { return number; })};
  std::vector<Bubble_record_2> home;
  home.reserve(bubbles.size() + bubbles.size() / 8);
  Messages<Bubble_record_2> out;
  for (const auto& p : places) {
    tick(home.size());
    const int owner = result.partition.owner(p.first);
    (owner == comm.rank() ? home : out[owner]).push_back(bubbles[p.second]);
  }
  deliver(comm, out, [&](int, const Bubble_record_2& r) { home.push_back(r); });
  result.bubbles.make_room_for(home.size() + home.size() / 8); // with those of other ranks that will be added
  for (const auto& p : places_on(curve, home))
    add_own(result.bubbles, home[p.second]);
  return result;
}

/// Collective. Numbers bubbles from 0 on, as they come: those of each rank before those of the next.
inline void number_along_curve(Communicator& comm, Bubbles_2& bubbles)
{
  bubbles.id.resize(bubbles.size());
  std::iota(bubbles.id.begin(), bubbles.id.end(), comm.sum_before(static_cast<std::int64_t>(bubbles.size())));
}

/// Brings points from whatever ranks to those that own their places, as many to each, and numbers them. All
/// members are collective.
class Point_distribution_2
{
public:
  Point_distribution_2(const Domain_2& domain, Communicator& comm)
    : m_domain(domain), m_comm(comm), m_partition(hilbert_curve(domain), {})
  {}

  /// where they are afterwards
  const Hilbert_partition_2& partition() const { return m_partition; }

  /// Corners of the domain that are missing are added. Points are numbered along the curve unless they have
  /// numbers; sizes that are not numbers become distances to points nearby.
  /// \throws std::invalid_argument on all ranks if two points have the same place or the same number, or if
  /// only some ranks' points have numbers
  Bubbles_2 operator()(Bubbles_2 points, bool has_numbers)
  {
    const bool are_numbered = check_numbers(points, has_numbers);
    add_missing_corners(points, are_numbered);
    Placed_part_2 part = send_home_evenly(m_comm, m_partition.curve(), records_of(points));
    points = std::move(part.bubbles);
    m_partition = part.partition;
    m_comm.agree_after([&] {
      check_places(points);
      estimate_sizes(points);
    });
    if (are_numbered)
      points.sort_by_id();
    else
      number_along_curve(m_comm, points);
    return points;
  }

private:
  bool check_numbers(const Bubbles_2& points, bool has_numbers)
  {
    if (!m_comm.any(points.size() > 0 && has_numbers))
      return false;
    if (m_comm.any(points.size() > 0 && !has_numbers))
      m_comm.throw_on_all(std::invalid_argument(
        "Bubble_relaxation_2: points of some ranks have the property global_id, points of others have not"));
    Messages<std::int64_t> out;
    for (std::int64_t number : points.id)
      out[static_cast<int>(number % m_comm.size())].push_back(number);
    std::vector<std::int64_t> numbers;
    deliver(m_comm, out, [&](int, std::int64_t number) { numbers.push_back(number); });
    std::sort(numbers.begin(), numbers.end());
    m_comm.agree_after([&] {
      const auto twice = std::adjacent_find(numbers.begin(), numbers.end());
      if (twice != numbers.end())
        throw std::invalid_argument("Bubble_relaxation_2: two points have the global_id " + std::to_string(*twice));
    });
    return true;
  }

  /// the first rank does, with numbers after all others
  void add_missing_corners(Bubbles_2& points, bool are_numbered)
  {
    std::vector<std::int32_t> is_there(m_domain.corners().size(), 0);
    std::int64_t last = -1;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (points.is_corner(i) && points.host[i] != no_index)
        is_there[points.host[i]] = 1;
      last = (std::max)(last, points.id[i]);
    }
    m_comm.reduce_each(is_there, MPI_MAX);
    last = m_comm.largest(last);
    m_comm.agree_after([&] {
      const auto missing = std::count(is_there.begin(), is_there.end(), 0);
      if (are_numbered && last > (std::numeric_limits<std::int64_t>::max)() - missing)
        throw std::length_error("Bubble_relaxation_2: after the largest global_id there is no room for those of "
                                "corners of the domain that are not among the points");
      for (std::size_t c = 0; c < is_there.size() && m_comm.rank() == 0; ++c)
        if (!is_there[c]) {
          points.add(m_domain.corners()[c], std::numeric_limits<double>::quiet_NaN(), Bubbles_2::CORNER,
                     static_cast<Index>(c));
          points.id.push_back(++last);
        }
    });
  }

  /// points in one place have one key, so they are on one rank
  static void check_places(const Bubbles_2& sorted)
  {
    for (std::size_t i = 1; i < sorted.size(); ++i)
      if (sorted.point(i - 1) == sorted.point(i))
        throw std::invalid_argument("Bubble_relaxation_2: two points have the coordinates " +
                                    in_words(sorted.x[i], sorted.y[i]));
  }

  /// the distance to the nearer one of the points before and after it on the curve
  void estimate_sizes(Bubbles_2& sorted) const
  {
    for (std::size_t i = 0; i < sorted.size(); ++i) {
      if (!std::isnan(sorted.d[i]))
        continue;
      sorted.d[i] = m_partition.curve().side();
      for (std::size_t n : {i - 1, i + 1}) // what is before the first is not there either
        if (n < sorted.size())
          sorted.d[i] = (std::min)(sorted.d[i], length_of(sorted.x[n] - sorted.x[i], sorted.y[n] - sorted.y[i]));
    }
  }

  const Domain_2& m_domain;
  Communicator& m_comm;
  Hilbert_partition_2 m_partition;
};

/// Collective. Replaces distinct numbers below `end`, of which each rank has some, by 0, 1, … in their order. Each rank
/// counts those of an interval of numbers, which are mostly its own. \pre they ascend
inline void compact_numbers(Communicator& comm, std::int64_t end, std::vector<std::int64_t>& numbers)
{
  if (comm.sum(static_cast<std::int64_t>(numbers.size())) == end)
    return; // none is missing
  Messages<std::int64_t> out;
  for (std::int64_t number : numbers)
    out[static_cast<int>(number * comm.size() / end)].push_back(number);
  Messages<std::int64_t> in = deliver(comm, out);
  std::vector<std::int64_t> counted;
  for (const auto& message : in)
    counted.insert(counted.end(), message.second.begin(), message.second.end());
  std::sort(counted.begin(), counted.end());
  const std::int64_t before = comm.sum_before(static_cast<std::int64_t>(counted.size()));
  for (auto& message : in)
    for (std::int64_t& number : message.second)
      number = before + (std::lower_bound(counted.begin(), counted.end(), number) - counted.begin());
  auto next = numbers.begin();
  deliver(comm, in, [&](int, std::int64_t number) { *next++ = number; }); // from lower ranks come lower numbers
}

/// Collective. Removes bubbles of ours that would confuse the triangulation, as `remove_confusing_on_edges()` does of
/// all: each rank finds those on some of the edges.
inline void remove_confusing_of_ours(Communicator& comm, const Domain_2& domain, Bubbles_2& b)
{
  Messages<Bubble_record_2> out;
  for (std::size_t i = 0; i < b.size(); ++i)
    if (b.is_ours(i) && b.is_on_edge(i))
      out[static_cast<int>(b.host[i]) % comm.size()].push_back(record(b, i));
  Bubbles_2 some;
  for (const Bubble_record_2& r : gather_outline(comm, b, false))
    add_own(some, r);
  deliver(comm, out, [&](int, const Bubble_record_2& r) { add_own(some, r); });
  some.sort_by_id();
  remove_confusing_on_edges(domain, some);
  std::vector<std::int64_t> gone; // few
  for (std::size_t k = 0; k < some.size(); ++k)
    if (some.is_gone(k))
      gone.push_back(some.id[k]);
  gone = gather_records(comm, gone);
  const std::unordered_set<std::int64_t> all_gone(gone.begin(), gone.end());
  for (std::size_t i = 0; i < b.size(); ++i)
    if (b.is_on_edge(i) && all_gone.count(b.id[i]) != 0)
      b.remove(i);
}

/// Collective. The bubbles that are left, with numbers below `end`, each on the rank of its place and numbered anew.
inline Bubbles_2 bring_home_and_number(Communicator& comm, const Hilbert_partition_2& partition, std::int64_t end,
                                       Bubbles_2 bubbles)
{
  Bubbles_2 home = send_home(comm, partition, own_bubbles(std::move(bubbles)));
  remove_those_in_one_place(home);
  home.forget_gone();
  compact_numbers(comm, end, home.id);
  return home;
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_PARTS_DISTRIBUTE_BUBBLES_H
