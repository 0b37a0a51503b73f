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
#include <CGAL/Bubble_relaxation_2/internal/bits.h>
#include <CGAL/Bubble_relaxation_2/internal/make_room_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// The buckets of Fig. 4 of the paper for bubbles of any mixture of sizes: square cells in levels, the
/// side doubling from level to level. A bubble lies in the level whose side just exceeds its reach, so
/// cells hold few bubbles however graded the sizes are.
///
/// Cells are stored in blocks of 8 x 8, with a bit for each cell that holds bubbles and for each that has
/// smaller ones inside, so that a query finds the cells that it must look into with a few operations on
/// whole blocks. A block points to the four of the next lower level inside it; only those of the highest
/// level are hashed.
class Bubble_buckets_2
{
public:
  /// `reach`: bubbles i and j are near when their distance is less than `reach * (d_i + d_j) / 2`;
  /// `unit`: any typical size; `x0`, `y0`: any point near the bubbles
  Bubble_buckets_2(double reach, double unit, double x0, double y0, std::size_t expected)
    : m_reach(reach), m_unit(unit), m_side(sides_of_reach * reach * unit),
      m_inverse(1 / m_side), m_x0(x0), m_y0(y0)
  {
    m_table.assign(64, no_index);
    m_bubbles.reserve(expected);
  }

  std::size_t size() const { return m_bubbles.size(); }

  /// makes room for `n` more bubbles
  void make_room_for(std::size_t n) { internal::make_room_for(n, m_bubbles); }

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
    const bool grows = d > e.d, stays = from == to;
    if (!stays)
      take_from_cell(from, static_cast<Index>(k));
    e.x = x;
    e.y = y;
    e.d = d;
    if (!stays)
      add_to_cell(to, static_cast<Index>(k));
    else if (grows)
      block_for(to, d);
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
    return for_each_in(Query<Mean_radius>{x, y, Mean_radius{near, d}}, d, visit);
  }

  /// calls `visit(entry)` for each bubble that may be near to one of size `d`, or of less, which lies within a
  /// distance from (x, y)
  template <class Visitor>
  void for_each_near_some(double x, double y, double distance, double d, Visitor visit) const
  {
    const auto visit_entry = [&visit](const Entry& e, double) {
      visit(e);
      return true;
    };
    for_each_in(Query<Wider_radius>{x, y, Wider_radius{distance, m_reach, d}}, d + 2 * distance / m_reach, visit_entry);
  }

  /// calls `visit(entry, squared distance)` for all within a distance from (x, y)
  template <class Visitor>
  bool for_each_within(double x, double y, double distance, Visitor visit) const
  {
    return for_each_in(Query<Distance>{x, y, Distance{distance}}, 2 * distance / m_reach, visit);
  }

  /// the same for those of size `least` or more whose distance from (x, y) is less than `near` times their size
  template <class Visitor>
  bool for_each_large(double x, double y, double least, double near, Visitor visit) const
  {
    return for_each_in(Query<Large_radius>{x, y, Large_radius{near, least}}, 0, visit);
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
  /// within which distance bubbles of a size count
  struct Mean_radius
  {
    double near, d;
    double operator()(double size) const { return 0.5 * near * (d + size); }
  };

  struct Wider_radius
  {
    double more, near, d;
    double operator()(double size) const { return slack * (more + 0.5 * near * (d + size)); }
  };

  struct Distance
  {
    double distance;
    double operator()(double) const { return distance; }
  };

  struct Large_radius
  {
    double near, least;
    double operator()(double size) const { return size < least ? 0 : near * size; }
  };

  template <class Radius>
  struct Query
  {
    double x, y;
    Radius radius;
  };

  /// `d`: about the size of a bubble that sees so far
  template <class Radius, class Visitor>
  bool for_each_in(const Query<Radius>& q, double d, Visitor& visit) const
  {
    if (m_bubbles.empty())
      return true;
    if (q.radius(m_largest) == 0)
      return true;
    if (d > 4 * m_largest && is_wider_than_all(d))
      return visit_all(q, visit);
    const double x = q.x, y = q.y, r = slack * q.radius(m_largest), inverse = inverse_side(m_highest);
    const Cell low = block_of(Cell{index_at(x - r - m_x0, inverse), index_at(y - r - m_y0, inverse), 0}),
               high = block_of(Cell{index_at(x + r - m_x0, inverse), index_at(y + r - m_y0, inverse), 0});
    for (std::int64_t iy = low.iy; iy <= high.iy; ++iy)
      for (std::int64_t ix = low.ix; ix <= high.ix; ++ix) {
        const Index root = m_table[slot_of(ix, iy)];
        if (root != no_index && !visit_block(root, q, visit))
          return false;
      }
    return true;
  }

  struct Cell
  {
    std::int64_t ix, iy;
    int level;

    bool operator==(const Cell& c) const { return ix == c.ix && iy == c.iy && level == c.level; }
  };

  /// 8 x 8 cells of a level
  struct Block
  {
    std::uint64_t occupied = 0;   ///< a bit for each cell: whether it holds bubbles
    std::uint64_t descendants = 0; ///< whether smaller cells inside do
    double largest = 0;           ///< no bubble in it, or in smaller cells inside, is larger
    double inverse;               ///< of the side of its cells
    std::int64_t ix, iy;          ///< of its first cell, divided by 8
    std::array<Index, 4> children{no_index, no_index, no_index, no_index};
    std::array<Index, 64> first;  ///< of the linked lists of the bubbles; read for occupied cells only
  };

  // covers the rounding of cell coordinates, so that no bubble in reach is missed
  static constexpr double slack = 1 + 1e-6;
  static constexpr double sides_of_reach = 0.5;

  double inverse_side(int level) const { return m_inverse * power_of_two(-level); }

  /// the lowest level whose bound is at least d, but not so low that coordinates of cells overflow
  int level_of(double x, double y, double d) const
  {
    constexpr int bits = 48;
    const int level = exponent_above(d / m_unit);
    const double far = (std::max)(std::abs(x - m_x0), std::abs(y - m_y0));
    return far > 0 ? (std::max)(level, exponent_above(far / m_side) - bits) : level;
  }

  static std::int64_t index_at(double offset, double inverse)
  {
    const double v = offset * inverse;
    const std::int64_t i = static_cast<std::int64_t>(v);
    return i - (static_cast<double>(i) > v);
  }

  Cell cell_at(int level, double x, double y) const
  {
    const double inverse = inverse_side(level);
    return Cell{index_at(x - m_x0, inverse), index_at(y - m_y0, inverse), level};
  }

  static Cell block_of(const Cell& c) { return Cell{c.ix >> 3, c.iy >> 3, c.level}; }

  static int bit_of(const Cell& c) { return static_cast<int>((c.ix & 7) | ((c.iy & 7) << 3)); }

  // of a block of the highest level
  std::size_t slot_of(std::int64_t ix, std::int64_t iy) const
  {
    std::uint64_t h = static_cast<std::uint64_t>(ix) * 0x9E3779B97F4A7C15u;
    h = (h ^ (h >> 32) ^ static_cast<std::uint64_t>(iy)) * 0xD6E8FEB86659FD93u;
    std::size_t k = (h ^ (h >> 32)) & (m_table.size() - 1);
    while (m_table[k] != no_index &&
           !(m_blocks[m_table[k]].ix == ix && m_blocks[m_table[k]].iy == iy))
      k = (k + 1) & (m_table.size() - 1);
    return k;
  }

  Index add_block(const Cell& block)
  {
    m_blocks.emplace_back();
    Block& b = m_blocks.back();
    b.inverse = inverse_side(block.level);
    b.ix = block.ix;
    b.iy = block.iy;
    return static_cast<Index>(m_blocks.size()) - 1;
  }

  Index find_or_add_root(const Cell& block)
  {
    const std::size_t k = slot_of(block.ix, block.iy);
    return m_table[k] != no_index ? m_table[k] : enter_root(add_block(block));
  }

  Index enter_root(Index block)
  {
    m_roots.push_back(block);
    if (4 * m_roots.size() > m_table.size()) {
      m_table.assign(4 * m_table.size(), no_index);
      for (Index root : m_roots)
        m_table[slot_of(m_blocks[root].ix, m_blocks[root].iy)] = root;
    } else
      m_table[slot_of(m_blocks[block].ix, m_blocks[block].iy)] = block;
    return block;
  }

  /// The block of a cell. On the way down blocks that are not there are made, and `mark(block, bit)` is
  /// called for all cells around the given one.
  template <class Mark>
  Index find_or_add_block(const Cell& cell, const Mark& mark)
  {
    const auto above = [&cell](int k) { return Cell{cell.ix >> k, cell.iy >> k, cell.level + k}; };
    Index b = find_or_add_root(block_of(above(m_highest - cell.level)));
    for (int k = m_highest - cell.level; k > 0; --k) {
      mark(m_blocks[b], bit_of(above(k)));
      const Cell block = block_of(above(k - 1));
      const std::size_t quarter = static_cast<std::size_t>((block.ix & 1) | ((block.iy & 1) << 1));
      if (m_blocks[b].children[quarter] == no_index) {
        const Index child = add_block(block);
        m_blocks[b].children[quarter] = child;
      }
      b = m_blocks[b].children[quarter];
    }
    return b;
  }

  void take_from_cell(const Cell& cell, Index k)
  {
    Block& b = m_blocks[find_or_add_block(cell, [](Block&, int) {})];
    const int bit = bit_of(cell);
    Index* link = &b.first[static_cast<std::size_t>(bit)];
    while (*link != k)
      link = &m_bubbles[*link].next;
    *link = m_bubbles[k].next;
    if (b.first[static_cast<std::size_t>(bit)] == no_index)
      b.occupied &= ~(std::uint64_t(1) << bit);
  }

  void add_to_cell(const Cell& cell, Index k)
  {
    while (cell.level > m_highest)
      raise_top();
    Block& b = block_for(cell, m_bubbles[k].d);
    const int bit = bit_of(cell);
    Index& first = b.first[static_cast<std::size_t>(bit)];
    m_bubbles[k].next = (b.occupied >> bit & 1) != 0 ? first : no_index;
    first = k;
    b.occupied |= std::uint64_t(1) << bit;
  }

  /// the block of a cell in which a bubble of size `d` lies or will lie; those around it know of it then
  Block& block_for(const Cell& cell, double d)
  {
    m_largest = (std::max)(m_largest, d);
    Block& b = m_blocks[find_or_add_block(cell, [d](Block& around, int bit) {
      around.descendants |= std::uint64_t(1) << bit;
      around.largest = (std::max)(around.largest, d);
    })];
    b.largest = (std::max)(b.largest, d);
    return b;
  }

  // a larger bubble than all before: the blocks of the highest level get parents
  void raise_top()
  {
    std::vector<Index> below;
    below.swap(m_roots);
    m_table.assign(m_table.size(), no_index);
    ++m_highest;
    for (Index child : below) {
      const std::int64_t ix = m_blocks[child].ix, iy = m_blocks[child].iy;
      const std::size_t quarter = static_cast<std::size_t>((ix & 1) | ((iy & 1) << 1));
      const Index parent = find_or_add_root(Cell{ix >> 1, iy >> 1, m_highest});
      Block &p = m_blocks[parent], &c = m_blocks[child];
      p.children[quarter] = child;
      p.largest = (std::max)(p.largest, c.largest);
      for (std::uint64_t bits = c.occupied | c.descendants; bits != 0; bits &= bits - 1) {
        const int bit = lowest_bit(bits);
        const Cell cell{8 * ix + (bit & 7), 8 * iy + (bit >> 3), 0};
        p.descendants |= std::uint64_t(1) << bit_of(Cell{cell.ix >> 1, cell.iy >> 1, 1});
      }
    }
  }

  /// whether one that is larger than all inserted would look into more blocks than there are bubbles
  bool is_wider_than_all(double d) const
  {
    const double blocks = d * inverse_side(m_highest) + 3;
    return blocks * blocks > static_cast<double>(m_bubbles.size());
  }

  template <class Radius, class Visitor>
  bool visit_all(const Query<Radius>& q, Visitor& visit) const
  {
    for (const Entry& e : m_bubbles)
      if (e.id != no_index && !visit_if_near(e, q, visit))
        return false;
    return true;
  }

  template <class Radius, class Visitor>
  bool visit_if_near(const Entry& e, const Query<Radius>& q, Visitor& visit) const
  {
    const double dx = e.x - q.x, dy = e.y - q.y, reach = q.radius(e.d);
    const double squared = dx * dx + dy * dy;
    return !(squared < reach * reach) || visit(e, squared);
  }

  /// the cells of a block that bubbles near `q` can be in, or can be in smaller cells inside
  template <class Radius>
  std::uint64_t cells_near(const Block& b, const Query<Radius>& q) const
  {
    const double r = slack * q.radius(b.largest);
    return bits_between(q.x - r - m_x0, q.x + r - m_x0, b.inverse, b.ix, 1) &
           bits_between(q.y - r - m_y0, q.y + r - m_y0, b.inverse, b.iy, 8);
  }

  /// The bits of the columns of a block that lie between two coordinates, or of the rows: `step` is from
  /// one bit to the next. Rounded as in `cell_at()`.
  static std::uint64_t bits_between(double low, double high, double inverse, std::int64_t block,
                                    int step)
  {
    const double start = 8 * static_cast<double>(block);
    const double from = low * inverse - start, to = high * inverse - start;
    if (!(from < 8 && to >= 0))
      return 0;
    const int first = from > 0 ? static_cast<int>(from) : 0, last = to < 8 ? static_cast<int>(to) : 7;
    constexpr std::uint64_t all = ~std::uint64_t(0), first_column = 0x0101010101010101u;
    return step == 8 ? all >> 8 * (7 - last) & all << 8 * first
                     : (0xFFu >> (7 - last) & 0xFFu << first) * first_column;
  }

  template <class Radius, class Visitor>
  bool visit_block(Index block, const Query<Radius>& q, Visitor& visit) const
  {
    const Block& b = m_blocks[block];
    if (q.radius(b.largest) == 0) // all are too small
      return true;
    const std::uint64_t near = cells_near(b, q);
    for (std::uint64_t bits = b.occupied & near; bits != 0; bits &= bits - 1)
      for (Index k = b.first[static_cast<std::size_t>(lowest_bit(bits))]; k != no_index; k = m_bubbles[k].next)
        if (!visit_if_near(m_bubbles[k], q, visit))
          return false;
    const std::uint64_t below = b.descendants & near;
    if (below == 0)
      return true;
    constexpr std::uint64_t quarter = 0x0F0F0F0Fu;
    for (int k = 0; k < 4; ++k)
      if ((below & (quarter << ((k & 1) * 4 + (k >> 1) * 32))) != 0 &&
          !visit_block(b.children[static_cast<std::size_t>(k)], q, visit))
        return false;
    return true;
  }

  double m_reach, m_unit, m_side, m_inverse, m_x0, m_y0;
  std::vector<Entry> m_bubbles;
  std::vector<Block> m_blocks;
  std::vector<Index> m_roots; // the blocks of the highest level
  std::vector<Index> m_table; // the same, hashed
  double m_largest = 0;       // no bubble is larger
  int m_highest = 0;
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_BUBBLE_BUCKETS_2_H
