// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_PARTS_DISTRIBUTE_BUBBLES_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_PARTS_DISTRIBUTE_BUBBLES_H

#include <CGAL/Bubble_relaxation_2/internal/core/in_words.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Communicator.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Messages.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/parts/Hilbert_partition_2.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/parts/bubble_records.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <string>
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
Records_at_home<Keyed_record> send_home(Communicator& comm, const Hilbert_partition_2& partition,
                                        const std::vector<Place_on_curve<Keyed_record>>& sorted)
{
  using Place = Place_on_curve<Keyed_record>;
  Records_at_home<Keyed_record> home;
  Messages<Keyed_record> out;
  partition.for_each_owner(sorted.begin(), sorted.end(), [&](int owner, auto first, auto last) {
    if (owner == comm.rank())
      home.places.assign(first, last);
    else
      std::transform(first, last, std::back_inserter(out[owner]), [](const Place& p) { return *p.record; });
  });
  home.others = deliver(comm, out);
  const std::size_t own = home.places.size();
  for (const auto& message : home.others)
    for (const Keyed_record& r : message.second)
      home.places.push_back({r.key, &r});
  merge_tail(home.places, own);
  return home;
}

/// brings each bubble to the rank that owns its place, in the order of their numbers
inline Bubbles_2 send_home(Communicator& comm, const Hilbert_partition_2& partition, Bubbles_2 bubbles)
{
  const Bubbles_2& b = bubbles;
  std::vector<Index> home;
  home.reserve(b.size());
  Messages<Bubble_record_2> out;
  Clearance_2 clearance(partition, comm.rank());
  for (std::size_t i = 0; i < b.size(); ++i) {
    const int owner = clearance(b.x[i], b.y[i], b.d[i]) > 0 ? comm.rank() : partition.owner(b.x[i], b.y[i]);
    if (owner == comm.rank())
      home.push_back(static_cast<Index>(i));
    else
      out[owner].push_back(record(b, i));
  }
  if (home.size() < b.size())
    bubbles.select(home);
  for (const auto& message : deliver(comm, out))
    for (const Bubble_record_2& r : message.second)
      add_own(bubbles, r);
  bubbles.sort_by_id();
  return bubbles;
}

/// Numbers bubbles along the curve, the first of all ranks by 0.
/// \pre the records of each rank are sorted, and come before those of the next
inline Bubbles_2 number_along_curve(Communicator& comm, const std::vector<Keyed_record_2>& records)
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

/// Brings points from whatever ranks to those that own their places, as many to each, and numbers them. All
/// members are collective.
class Point_distribution_2
{
public:
  Point_distribution_2(const Domain_2& domain, Communicator& comm)
    : m_domain(domain), m_comm(comm),
      m_partition(hilbert_curve(domain), {})
  {}

  /// where they are afterwards
  const Hilbert_partition_2& partition() const { return m_partition; }

  /// Corners of the domain that are missing are added. Points are numbered along the curve unless they have
  /// numbers; sizes that are not numbers become distances to points nearby.
  /// \throws std::invalid_argument on all ranks if two points have the same place or the same number, or if
  /// only some ranks' points have numbers
  Bubbles_2 operator()(const Bubbles_2& points, bool has_numbers)
  {
    const bool are_numbered = check_numbers(points, has_numbers);
    std::vector<Keyed_record_2> records;
    m_comm.agree_after([&] { records = keyed(points); });
    add_missing_corners(records, are_numbered);
    const auto places = places_on_curve(records);
    m_partition = even_partition(m_comm, m_partition.curve(), places);
    records = send_home(m_comm, m_partition, places).records();
    m_comm.agree_after([&] {
      check_places(records);
      estimate_sizes(records);
    });
    if (!are_numbered)
      return number_along_curve(m_comm, records);
    Bubbles_2 result;
    m_comm.agree_after([&] { result = in_order_of_numbers(records); });
    return result;
  }

private:
  bool check_numbers(const Bubbles_2& points, bool has_numbers)
  {
    const bool any_has = m_comm.any(points.size() > 0 && has_numbers);
    if (!any_has)
      return false;
    m_comm.agree_after([&] {
      if (points.size() > 0 && !has_numbers)
        throw std::invalid_argument("Bubble_relaxation_2: points of some ranks have the property global_id, "
                                    "points of others have not");
    });
    Messages<std::int64_t> out;
    m_comm.agree_after([&] {
      for (std::int64_t number : points.id)
        out[static_cast<int>(number % m_comm.size())].push_back(number);
    });
    const Messages<std::int64_t> in = deliver(m_comm, out);
    m_comm.agree_after([&] {
      std::vector<std::int64_t> numbers;
      for (const auto& message : in)
        numbers.insert(numbers.end(), message.second.begin(), message.second.end());
      std::sort(numbers.begin(), numbers.end());
      const auto twice = std::adjacent_find(numbers.begin(), numbers.end());
      if (twice != numbers.end())
        throw std::invalid_argument("Bubble_relaxation_2: two points have the global_id " +
                                    std::to_string(*twice));
    });
    return true;
  }

  Keyed_record_2 keyed(const Bubble_record_2& r) const
  {
    return Keyed_record_2{m_partition.curve().key(r.x, r.y), r};
  }

  std::vector<Keyed_record_2> keyed(const Bubbles_2& points) const
  {
    std::vector<Keyed_record_2> records;
    records.reserve(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
      records.push_back(keyed(record(points, i)));
    return records;
  }

  /// the first rank does, with numbers after all others
  void add_missing_corners(std::vector<Keyed_record_2>& records, bool are_numbered)
  {
    std::vector<std::int32_t> is_there(m_domain.corners().size(), 0);
    std::int64_t last = -1;
    for (const Keyed_record_2& r : records) {
      if (r.bubble.dimension == Bubbles_2::CORNER && r.bubble.host != no_index)
        is_there[r.bubble.host] = 1;
      last = (std::max)(last, r.bubble.id);
    }
    m_comm.reduce_each(is_there, MPI_MAX);
    last = m_comm.largest(last);
    m_comm.agree_after([&] {
      const auto missing = std::count(is_there.begin(), is_there.end(), 0);
      if (are_numbered && last > (std::numeric_limits<std::int64_t>::max)() - missing)
        throw std::length_error("Bubble_relaxation_2: after the largest global_id there is no room for those of "
                                "corners of the domain that are not among the points");
      for (std::size_t c = 0; c < is_there.size() && m_comm.rank() == 0; ++c)
        if (!is_there[c])
          records.push_back(corner(static_cast<Index>(c), ++last));
    });
  }

  Keyed_record_2 corner(Index c, std::int64_t number) const
  {
    Bubble_record_2 r{};
    r.x = m_domain.corners()[c].x();
    r.y = m_domain.corners()[c].y();
    r.d = std::numeric_limits<double>::quiet_NaN();
    r.id = number;
    r.host = c;
    r.pin = no_index;
    r.dimension = Bubbles_2::CORNER;
    return keyed(r);
  }

  /// points in one place have one key, so they are on one rank
  static void check_places(const std::vector<Keyed_record_2>& sorted)
  {
    for (std::size_t k = 1; k < sorted.size(); ++k) {
      const Bubble_record_2 &r = sorted[k - 1].bubble, &s = sorted[k].bubble;
      if (r.x == s.x && r.y == s.y)
        throw std::invalid_argument("Bubble_relaxation_2: two points have the coordinates " + in_words(r.x, r.y));
    }
  }

  /// the distance to the nearer one of the points before and after it on the curve
  void estimate_sizes(std::vector<Keyed_record_2>& sorted) const
  {
    for (std::size_t k = 0; k < sorted.size(); ++k) {
      Bubble_record_2& r = sorted[k].bubble;
      if (!std::isnan(r.d))
        continue;
      r.d = m_partition.curve().side();
      for (std::size_t n : {k - 1, k + 1}) // what is before the first is not there either
        if (n < sorted.size())
          r.d = (std::min)(r.d, std::hypot(sorted[n].bubble.x - r.x, sorted[n].bubble.y - r.y));
    }
  }

  static Bubbles_2 in_order_of_numbers(std::vector<Keyed_record_2>& records)
  {
    std::sort(records.begin(), records.end(), [](const Keyed_record_2& r, const Keyed_record_2& s) {
      return r.bubble.id < s.bubble.id;
    });
    Bubbles_2 result;
    result.make_room_for(records.size());
    for (const Keyed_record_2& r : records)
      add_own(result, r.bubble);
    return result;
  }

  const Domain_2& m_domain;
  Communicator& m_comm;
  Hilbert_partition_2 m_partition;
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_PARTS_DISTRIBUTE_BUBBLES_H
