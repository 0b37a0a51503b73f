// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_BUBBLE_BUCKETS_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_BUBBLE_BUCKETS_2_H

#include <CGAL/Bubble_relaxation_2/internal/Flat_triangulation_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// The buckets of Fig. 4 of the paper for bubbles of any mixture of sizes: square cells in levels, the
/// side doubling from level to level. A bubble lies in the level whose side just exceeds its reach, so
/// cells hold few bubbles however graded the sizes are. Cells nest, and a cell knows whether anything
/// smaller lies in it, so a query goes down only where there is something. Stored in a hash table.
class Bubble_buckets_2
{
public:
  /// `reach`: bubbles i and j are near when their distance is less than `reach * (d_i + d_j) / 2`;
  /// `unit`: any typical size; `x0`, `y0`: any point near the bubbles
  Bubble_buckets_2(double reach, double unit, double x0, double y0, std::size_t expected)
    : m_reach(reach), m_unit(unit), m_x0(x0), m_y0(y0)
  {
    std::size_t capacity = 1024;
    while (capacity < 3 * expected)
      capacity *= 2;
    m_slots.assign(capacity, Slot());
    m_bubbles.reserve(expected);
  }

  std::size_t size() const { return m_bubbles.size(); }

  void insert(Index id, double x, double y, double d)
  {
    const int level = level_of(x, y, d);
    if (m_bubbles.empty())
      m_highest = level;
    m_bubbles.push_back(Entry{x, y, d, id, no_index});
    add_to_cell(cell_at(level, x, y), static_cast<Index>(m_bubbles.size()) - 1);
  }

  Point point(std::size_t k) const { return Point(m_bubbles[k].x, m_bubbles[k].y); }

  /// moves the bubble that was the `k`-th to be inserted
  void move(std::size_t k, double x, double y, double d)
  {
    Entry& e = m_bubbles[k];
    const Cell from = cell_at(level_of(e.x, e.y, e.d), e.x, e.y);
    const Cell to = cell_at(level_of(x, y, d), x, y);
    e.x = x;
    e.y = y;
    e.d = d;
    if (from == to)
      return;
    take_from_cell(from, static_cast<Index>(k));
    add_to_cell(to, static_cast<Index>(k));
  }

  /// takes out the bubble that was the `k`-th to be inserted; it still counts in `size()`
  void erase(std::size_t k)
  {
    Entry& e = m_bubbles[k];
    take_from_cell(cell_at(level_of(e.x, e.y, e.d), e.x, e.y), static_cast<Index>(k));
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
    if (m_bubbles.empty())
      return true;
    const int own = level_of(x, y, d);
    if (own > m_highest && is_wider_than_all(d))
      return visit_all(x, y, d, near, visit);
    // up: cells of the own level and above that the reach can touch; at most 3 x 3 a level
    for (int level = m_highest; level > own; --level)
      if (!visit_level(level, x, y, d, near, false, visit))
        return false;
    return visit_level((std::min)(own, m_highest), x, y, d, near, true, visit);
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
  struct Cell
  {
    std::int64_t ix, iy;
    int level;

    bool operator==(const Cell& c) const { return ix == c.ix && iy == c.iy && level == c.level; }
  };

  struct Slot
  {
    Cell cell = {0, 0, 0};
    Index first = no_index;       // of the linked list of its bubbles
    bool used = false;
    bool has_descendants = false; // whether smaller cells inside hold bubbles
  };

  // covers the rounding of cell coordinates, so that no bubble in reach is missed
  static constexpr double slack = 1 + 1e-6;

  double bound(int level) const { return m_unit * power_of_two(level); } // largest d in the level
  double side(int level) const { return m_reach * bound(level); }

  /// the lowest level whose bound is at least d, but not so low that coordinates of cells overflow
  int level_of(double x, double y, double d) const
  {
    constexpr int bits = 48;
    const int level = exponent_above(d / m_unit);
    const double far = (std::max)(std::abs(x - m_x0), std::abs(y - m_y0));
    return far > 0 ? (std::max)(level, exponent_above(far / (m_reach * m_unit)) - bits) : level;
  }

  static double power_of_two(int exponent)
  {
    if (exponent < -1022 || exponent > 1023)
      return std::ldexp(1., exponent);
    const std::uint64_t bits = static_cast<std::uint64_t>(exponent + 1023) << 52;
    double power;
    std::memcpy(&power, &bits, sizeof power);
    return power;
  }

  // the least e with value <= 2^e
  static int exponent_above(double value)
  {
    int exponent;
    const double mantissa = std::frexp(value, &exponent);
    return mantissa == 0.5 ? exponent - 1 : exponent;
  }

  Cell cell_at(int level, double x, double y) const
  {
    const double inverse = 1 / side(level);
    return Cell{static_cast<std::int64_t>(std::floor((x - m_x0) * inverse)),
                static_cast<std::int64_t>(std::floor((y - m_y0) * inverse)), level};
  }

  static Cell parent(const Cell& c) { return Cell{c.ix >> 1, c.iy >> 1, c.level + 1}; }

  // Blocks of 8 x 8 cells of a level are hashed and lie together in memory, and so do the cells that
  // bubbles with neighbouring numbers look at.
  std::size_t slot_of(const Cell& c) const
  {
    std::uint64_t h = static_cast<std::uint64_t>(c.ix >> 3) * 0x9E3779B97F4A7C15u;
    h ^= static_cast<std::uint64_t>(c.iy >> 3) * 0xC2B2AE3D27D4EB4Fu + (h >> 29);
    h ^= static_cast<std::uint64_t>(c.level) * 0x165667B19E3779F9u;
    h ^= h >> 32;
    h *= 0xD6E8FEB86659FD93u;
    h ^= h >> 32;
    const std::size_t within = static_cast<std::size_t>((c.ix & 7) | ((c.iy & 7) << 3));
    std::size_t k = (h * 64 + within) & (m_slots.size() - 1);
    for (int attempt = 0; m_slots[k].used && !(m_slots[k].cell == c); ++attempt)
      k = (k + (attempt < 8 ? 64 : 1)) & (m_slots.size() - 1);
    return k;
  }

  const Slot* find(const Cell& c) const
  {
    const Slot& s = m_slots[slot_of(c)];
    return s.used ? &s : nullptr;
  }

  Slot& find_or_add(const Cell& c)
  {
    std::size_t k = slot_of(c);
    if (!m_slots[k].used) {
      if (2 * (m_used + 1) > m_slots.size()) {
        grow();
        k = slot_of(c);
      }
      m_slots[k].used = true;
      m_slots[k].cell = c;
      ++m_used;
    }
    return m_slots[k];
  }

  void take_from_cell(const Cell& cell, Index k)
  {
    Index* link = &m_slots[slot_of(cell)].first;
    while (*link != k)
      link = &m_bubbles[*link].next;
    *link = m_bubbles[k].next;
  }

  void add_to_cell(const Cell& cell, Index k)
  {
    Slot& slot = find_or_add(cell);
    m_bubbles[k].next = slot.first;
    slot.first = k;
    if (cell.level > m_highest)
      raise_top(cell.level);
    mark_ancestors(cell);
  }

  void grow()
  {
    std::vector<Slot> old(2 * m_slots.size());
    old.swap(m_slots);
    for (const Slot& s : old)
      if (s.used)
        m_slots[slot_of(s.cell)] = s;
  }

  void mark_ancestors(Cell cell)
  {
    while (cell.level < m_highest) {
      cell = parent(cell);
      Slot& slot = find_or_add(cell);
      if (slot.has_descendants)
        return;
      slot.has_descendants = true;
    }
  }

  // a larger bubble than all before: all cells below need ancestors up to its level
  void raise_top(int level)
  {
    std::vector<Cell> tops;
    for (const Slot& s : m_slots)
      if (s.used && s.cell.level == m_highest)
        tops.push_back(s.cell);
    m_highest = level;
    for (const Cell& c : tops)
      mark_ancestors(c);
  }

  /// whether one that is larger than all inserted would look into more cells than there are bubbles
  bool is_wider_than_all(double d) const
  {
    const double cells = d / bound(m_highest) + 3;
    return cells * cells > static_cast<double>(m_bubbles.size());
  }

  template <class Visitor>
  bool visit_all(double x, double y, double d, double near, Visitor& visit) const
  {
    for (const Entry& e : m_bubbles)
      if (e.id != no_index && !visit_if_near(e, x, y, d, near, visit))
        return false;
    return true;
  }

  template <class Visitor>
  bool visit_if_near(const Entry& e, double x, double y, double d, double near, Visitor& visit) const
  {
    const double dx = e.x - x, dy = e.y - y, reach = 0.5 * near * (d + e.d);
    const double squared = dx * dx + dy * dy;
    return !(squared < reach * reach) || visit(e, squared);
  }

  template <class Visitor>
  bool visit_level(int level, double x, double y, double d, double near, bool descend,
                   Visitor& visit) const
  {
    const double r = slack * 0.5 * near * (d + bound(level));
    const Cell low = cell_at(level, x - r, y - r), high = cell_at(level, x + r, y + r);
    for (std::int64_t iy = low.iy; iy <= high.iy; ++iy)
      for (std::int64_t ix = low.ix; ix <= high.ix; ++ix)
        if (!visit_cell(Cell{ix, iy, level}, x, y, d, near, descend, visit))
          return false;
    return true;
  }

  template <class Visitor>
  bool visit_cell(const Cell& cell, double x, double y, double d, double near, bool descend,
                  Visitor& visit) const
  {
    const Slot* slot = find(cell);
    if (slot == nullptr)
      return true;
    for (Index k = slot->first; k != no_index; k = m_bubbles[k].next)
      if (!visit_if_near(m_bubbles[k], x, y, d, near, visit))
        return false;
    if (!descend || !slot->has_descendants)
      return true;
    const double r = slack * 0.5 * near * (d + bound(cell.level - 1)), c = side(cell.level - 1);
    for (int k = 0; k < 4; ++k) {
      const Cell child{2 * cell.ix + (k & 1), 2 * cell.iy + (k >> 1), cell.level - 1};
      const double left = m_x0 + c * child.ix, bottom = m_y0 + c * child.iy;
      if (x + r < left || x - r > left + c || y + r < bottom || y - r > bottom + c)
        continue;
      if (!visit_cell(child, x, y, d, near, true, visit))
        return false;
    }
    return true;
  }

  double m_reach, m_unit, m_x0, m_y0;
  std::vector<Slot> m_slots;
  std::vector<Entry> m_bubbles;
  std::size_t m_used = 0;
  int m_highest = 0;
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_BUBBLE_BUCKETS_2_H
