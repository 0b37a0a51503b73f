// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_GEOMETRY_BUBBLE_BUCKETS_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_GEOMETRY_BUBBLE_BUCKETS_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/vocabulary.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Cell_blocks_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Flat_triangulation_2.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// The buckets of Fig. 4 of the paper for bubbles of any mixture of sizes: square cells in levels, the
/// side doubling from level to level. A bubble lies in the level whose side just exceeds its reach, so
/// cells hold few bubbles however graded the sizes are.
class Bubble_buckets_2
{
public:
  /// `reach`: bubbles i and j are near when their distance is less than `reach * (d_i + d_j) / 2`;
  /// `unit`: any typical size; `x0`, `y0`: any point near the bubbles
  Bubble_buckets_2(double reach, double unit, double x0, double y0, std::size_t expected)
    : m_reach(reach), m_unit(unit), m_cells(sides_of_reach * reach * unit, x0, y0)
  {
    m_bubbles.reserve(expected);
  }

  /// makes room for `n` more bubbles
  void make_room_for(std::size_t n) { internal::make_room_for(n, m_bubbles); }

  void insert(Index id, double x, double y, double d)
  {
    m_bubbles.push_back(Entry{x, y, d, id, no_index});
    add_to_cell(cell_of(x, y, d), static_cast<Index>(m_bubbles.size()) - 1);
  }

  Point point(std::size_t k) const { return Point(m_bubbles[k].x, m_bubbles[k].y); }

  /// moves the bubble that was the `k`-th to be inserted
  void move(std::size_t k, double x, double y, double d)
  {
    Entry& e = m_bubbles[k];
    const Cell from = cell_of(e.x, e.y, e.d), to = cell_of(x, y, d);
    const bool grows = d > e.d, stays = from == to;
    if (!stays)
      take_from_cell(from, static_cast<Index>(k));
    e.x = x;
    e.y = y;
    e.d = d;
    if (!stays)
      add_to_cell(to, static_cast<Index>(k));
    else if (grows)
      m_cells.block_for(to, d);
  }

  /// takes out the bubble that was the `k`-th to be inserted; it still counts in `size()`
  void erase(std::size_t k)
  {
    Entry& e = m_bubbles[k];
    take_from_cell(cell_of(e.x, e.y, e.d), static_cast<Index>(k));
    e.id = no_index;
  }

  struct Entry
  {
    double x, y, d;
    Index id;
    Index next; ///< in its cell
  };

  /// calls `visit(id, squared distance, d_j)` for each bubble j near to one of size `d` at (x, y),
  /// until `visit` returns false; returns whether all were visited
  template <class Visitor>
  bool for_each_near(double x, double y, double d, Visitor visit) const
  {
    return for_each_near(x, y, d, m_reach, [&visit](const Entry& e, double squared) {
      return visit(e.id, squared, e.d);
    });
  }

  /// the same with any reach for this query, and calls `visit(entry, squared distance)`
  template <class Visitor>
  bool for_each_near(double x, double y, double d, double near, Visitor visit) const
  {
    return for_each_in(x, y, [=](double size) { return 0.5 * near * (d + size); }, d, visit);
  }

  /// calls `visit(entry)` for each bubble that may be near to one of size `d`, or of less, which lies within a
  /// distance from (x, y)
  template <class Visitor>
  void for_each_near_some(double x, double y, double distance, double d, Visitor visit) const
  {
    const auto radius = [this, distance, d](double size) { return slack * (distance + 0.5 * m_reach * (d + size)); };
    const auto visit_entry = [&visit](const Entry& e, double) {
      visit(e);
      return true;
    };
    for_each_in(x, y, radius, d + 2 * distance / m_reach, visit_entry);
  }

  /// calls `visit(entry, squared distance)` for all within a distance from (x, y)
  template <class Visitor>
  bool for_each_within(double x, double y, double distance, Visitor visit) const
  {
    return for_each_in(x, y, [=](double) { return distance; }, 2 * distance / m_reach, visit);
  }

  /// the same for those of size `least` or more whose distance from (x, y) is less than `near` times their size
  template <class Visitor>
  bool for_each_large(double x, double y, double least, double near, Visitor visit) const
  {
    return for_each_in(x, y, [=](double size) { return size < least ? 0 : near * size; }, 0, visit);
  }

  /// whether no bubble is near to one of size `d` at (x, y)
  bool is_free(double x, double y, double d) const
  {
    return is_free(x, y, d, m_reach);
  }

  bool is_free(double x, double y, double d, double reach) const
  {
    return for_each_near(x, y, d, reach, [](const Entry&, double) { return false; });
  }

private:
  using Cell = Cell_blocks_2::Cell;
  using Block = Cell_blocks_2::Block;

  /// `radius(size)`: within which distance bubbles of a size count; `d`: about the size of a bubble that sees so far
  template <class Radius, class Visitor>
  bool for_each_in(double x, double y, const Radius& radius, double d, const Visitor& visit) const
  {
    if (m_bubbles.empty())
      return true;
    const double largest = m_cells.largest();
    if (radius(largest) == 0)
      return true;
    if (d > 4 * largest && is_wider_than_all(d))
      return visit_all(x, y, radius, visit);
    return m_cells.for_each_root(x, y, slack * radius(largest),
                                 [&](Index root) { return visit_block(root, x, y, radius, visit); });
  }

  // covers the rounding of cell coordinates, so that no bubble in reach is missed
  static constexpr double slack = 1 + 1e-6;
  static constexpr double sides_of_reach = 0.5;

  /// of the lowest level whose bound is at least d
  Cell cell_of(double x, double y, double d) const { return m_cells.cell_at(exponent_above(d / m_unit), x, y); }

  void take_from_cell(const Cell& cell, Index k)
  {
    Block& b = m_cells.block_of(cell);
    const int bit = Cell_blocks_2::bit_of(cell);
    Index* link = &b.first[static_cast<std::size_t>(bit)];
    while (*link != k)
      link = &m_bubbles[*link].next;
    *link = m_bubbles[k].next;
    if (b.first[static_cast<std::size_t>(bit)] == no_index)
      b.occupied &= ~(std::uint64_t(1) << bit);
  }

  void add_to_cell(const Cell& cell, Index k)
  {
    Block& b = m_cells.block_for(cell, m_bubbles[k].d);
    const int bit = Cell_blocks_2::bit_of(cell);
    Index& first = b.first[static_cast<std::size_t>(bit)];
    m_bubbles[k].next = (b.occupied >> bit & 1) != 0 ? first : no_index;
    first = k;
    b.occupied |= std::uint64_t(1) << bit;
  }

  /// whether one that is larger than all inserted would look into more blocks than there are bubbles
  bool is_wider_than_all(double d) const
  {
    const double blocks = d * m_cells.least_inverse() + 3;
    return blocks * blocks > static_cast<double>(m_bubbles.size());
  }

  template <class Radius, class Visitor>
  bool visit_all(double x, double y, const Radius& radius, const Visitor& visit) const
  {
    for (const Entry& e : m_bubbles)
      if (e.id != no_index && !visit_if_near(e, x, y, radius, visit))
        return false;
    return true;
  }

  template <class Radius, class Visitor>
  bool visit_if_near(const Entry& e, double x, double y, const Radius& radius, const Visitor& visit) const
  {
    const double dx = e.x - x, dy = e.y - y, reach = radius(e.d);
    const double squared = dx * dx + dy * dy;
    return !(squared < reach * reach) || visit(e, squared);
  }

  template <class Radius, class Visitor>
  bool visit_block(Index block, double x, double y, const Radius& radius, const Visitor& visit) const
  {
    const Block& b = m_cells[block];
    if (radius(b.largest) == 0) // all are too small
      return true;
    const std::uint64_t near = m_cells.cells_near(b, x, y, slack * radius(b.largest));
    for (std::uint64_t bits = b.occupied & near; bits != 0; bits &= bits - 1)
      for (Index k = b.first[static_cast<std::size_t>(lowest_bit(bits))]; k != no_index; k = m_bubbles[k].next)
        if (!visit_if_near(m_bubbles[k], x, y, radius, visit))
          return false;
    const std::uint64_t below = b.descendants & near;
    if (below == 0)
      return true;
    constexpr std::uint64_t quarter = 0x0F0F0F0Fu;
    for (int k = 0; k < 4; ++k)
      if ((below & (quarter << ((k & 1) * 4 + (k >> 1) * 32))) != 0 &&
          !visit_block(b.children[static_cast<std::size_t>(k)], x, y, radius, visit))
        return false;
    return true;
  }

  double m_reach, m_unit;
  std::vector<Entry> m_bubbles;
  Cell_blocks_2 m_cells; // with the first bubbles of linked lists
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_GEOMETRY_BUBBLE_BUCKETS_2_H
