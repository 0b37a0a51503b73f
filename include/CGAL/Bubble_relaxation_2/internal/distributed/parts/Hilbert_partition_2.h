// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_PARTS_HILBERT_PARTITION_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_PARTS_HILBERT_PARTITION_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/find_sorted.h>
#include <CGAL/Bubble_relaxation_2/internal/core/vocabulary.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Communicator.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Hilbert_curve_2.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// Which rank owns which part of the plane: consecutive pieces of a Hilbert curve. One key for each rank but
/// the first says all, to all ranks.
class Hilbert_partition_2
{
public:
  using Key = Hilbert_curve_2::Key;
  using Ranks = boost::container::small_vector<int, 4>;

  /// `first_keys`: where the pieces of ranks 1, 2, … begin, in this order
  Hilbert_partition_2(const Hilbert_curve_2& curve, std::vector<Key> first_keys)
    : m_curve(curve), m_first_keys(std::move(first_keys))
  {}

  const Hilbert_curve_2& curve() const { return m_curve; }
  int number_of_ranks() const { return static_cast<int>(m_first_keys.size()) + 1; }

  int owner(Key key) const
  {
    return static_cast<int>(std::upper_bound(m_first_keys.begin(), m_first_keys.end(), key) - m_first_keys.begin());
  }

  int owner(double x, double y) const { return owner(m_curve.key(x, y)); }

  /// All ranks that own a part of the disc, and perhaps some that own something beside it; sorted.
  Ranks owners_in_disc(double x, double y, double radius) const
  {
    Ranks result;
    visit_disc(x, y, radius, [&result](int first, int last) {
      for (int rank = first; rank <= last; ++rank)
        if (result.empty() || result.back() != rank)
          result.push_back(rank);
      return true;
    });
    sort_each_once(result);
    return result;
  }

  /// Whether a rank owns the whole disc, or a little more even.
  bool owns_disc(int rank, double x, double y, double radius) const
  {
    return visit_disc(x, y, radius, [rank](int first, int last) { return first == rank && last == rank; });
  }

private:
  /// so many times a square about as wide as the disc is quartered: it need not be exact what is beside the disc
  static constexpr int finest = 3;

  /// cells around a disc
  struct Box
  {
    std::uint32_t first_column, last_column, first_row, last_row;
  };

  static std::uint32_t at(std::uint32_t cell, int level) { return level < Hilbert_curve_2::levels ? cell >> level : 0; }

  /// Calls `visit(first, last)` for intervals of ranks, all of which own something in the disc or beside it, until it
  /// returns false; then this does so too.
  template <class Visit>
  bool visit_disc(double x, double y, double radius, const Visit& visit) const
  {
    if (m_first_keys.empty())
      return visit(0, 0);
    const Box disc{m_curve.column(x - radius), m_curve.column(x + radius), m_curve.row(y - radius),
                   m_curve.row(y + radius)};
    // at most four cells of this level cover the disc
    const std::uint32_t widest = (std::max)(disc.last_column - disc.first_column, disc.last_row - disc.first_row);
    int level = 1; // of the last cell of level 0 there is no next
    while (level < Hilbert_curve_2::levels && (widest >> level) > 0)
      ++level;
    for (std::uint32_t row = at(disc.first_row, level); row <= at(disc.last_row, level); ++row)
      for (std::uint32_t column = at(disc.first_column, level); column <= at(disc.last_column, level); ++column)
        if (!visit_square(disc, column, row, level, (std::max)(0, level - finest), visit))
          return false;
    return true;
  }

  /// the same for what lies in a square of 2^level cells in a row, as far as it is in the box
  template <class Visit>
  bool visit_square(const Box& box, std::uint32_t column, std::uint32_t row, int level, int last_level,
                    const Visit& visit) const
  {
    if (column > at(box.last_column, level) || column < at(box.first_column, level) ||
        row > at(box.last_row, level) || row < at(box.first_row, level))
      return true;
    const bool is_all = level == Hilbert_curve_2::levels;
    const Key cells = is_all ? ~Key(0) : (Key(1) << 2 * level) - 1;
    const Key first = is_all ? 0 : m_curve.key_of_cell(column, row, Hilbert_curve_2::levels - level) << 2 * level;
    const int low = owner(first), high = owner(first | cells);
    if (low == high || level == last_level)
      return visit(low, high);
    for (int quarter = 0; quarter < 4; ++quarter)
      if (!visit_square(box, 2 * column + static_cast<std::uint32_t>(quarter & 1),
                        2 * row + static_cast<std::uint32_t>(quarter >> 1), level - 1, last_level, visit))
        return false;
    return true;
  }

  Hilbert_curve_2 m_curve;
  std::vector<Key> m_first_keys;
};

inline bool is_among(const Hilbert_partition_2::Ranks& ranks, int rank)
{
  return std::find(ranks.begin(), ranks.end(), rank) != ranks.end();
}

/// adds a rank unless it is there; returns whether it was added
inline bool add_once(Hilbert_partition_2::Ranks& ranks, int rank)
{
  if (is_among(ranks, rank))
    return false;
  ranks.push_back(rank);
  return true;
}

/// Collective. Cuts the curve so that all ranks own equally many of some elements, which are on any ranks.
/// \param sorted this rank's
/// \param key where on the curve an element is
/// \param count for how many so many of the first elements of `sorted` count
template <class T, class Key_of, class Count>
Hilbert_partition_2 even_partition(const Communicator& comm, const Hilbert_curve_2& curve, const std::vector<T>& sorted,
                                   const Key_of& key, const Count& count)
{
  const auto count_before = [&](Hilbert_curve_2::Key end) {
    const auto first = std::lower_bound(sorted.begin(), sorted.end(), end,
                                        [&key](const T& t, Hilbert_curve_2::Key k) { return key(t) < k; });
    return static_cast<std::size_t>(count(first - sorted.begin()));
  };
  const std::int64_t all = comm.sum(count(static_cast<std::int64_t>(sorted.size())));
  std::vector<std::size_t> cuts;
  for (int rank = 1; rank < comm.size(); ++rank)
    cuts.push_back(static_cast<std::size_t>(all * rank / comm.size()));
  return Hilbert_partition_2(curve, find_sorted(cuts, count_before, comm));
}

/// The length of a vector or up to 9 % more, without a square root and for coordinates of any order.
inline double length_at_most(double x, double y)
{
  x = std::abs(x);
  y = std::abs(y);
  return (std::max)(x, y) + 0.4143 * (std::min)(x, y); // an octagon in the unit circle: sqrt(2) - 1, rounded up
}

/// How far places are from other ranks' parts of the plane. It is asked of one place after the other, each near the
/// last one: what was found there answers most questions.
class Clearance_2
{
public:
  Clearance_2(const Hilbert_partition_2& partition, int rank) : m_partition(&partition), m_rank(rank)
  {
    if (partition.number_of_ranks() == 1)
      m_clearance = std::numeric_limits<double>::infinity();
  }

  /// The radius of a disc around a place that lies in our part, at least as large as `radius`. 0 if it is not known
  /// that there is such a disc: then there is none that is much larger.
  double operator()(double x, double y, double radius)
  {
    const double left = (1 - 1e-9) * m_clearance - length_at_most(x - m_x, y - m_y);
    if (left >= radius)
      return left;
    double found = 0;
    for (double factor : look_ahead) {
      if (!m_partition->owns_disc(m_rank, x, y, factor * radius))
        break;
      found = factor * radius;
    }
    if (found > 0) {
      m_x = x;
      m_y = y;
      m_clearance = found;
    }
    return found;
  }

  /// The other ranks with a part of the disc, and perhaps some with a part of what is beside it.
  Hilbert_partition_2::Ranks others_in_disc(double x, double y, double radius)
  {
    Hilbert_partition_2::Ranks result;
    if ((*this)(x, y, radius) == 0)
      result = m_partition->owners_in_disc(x, y, radius);
    result.erase(std::remove(result.begin(), result.end(), m_rank), result.end());
    return result;
  }

private:
  /// so many times the radius are tried, for those that come after
  static constexpr std::array<double, 4> look_ahead = {1.2, 3, 8, 24};

  const Hilbert_partition_2* m_partition;
  int m_rank;
  double m_x = 0, m_y = 0, m_clearance = 0; // the last one that was found
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_PARTS_HILBERT_PARTITION_2_H
