// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_GEOMETRY_CELL_BLOCKS_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_GEOMETRY_CELL_BLOCKS_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/vocabulary.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// The index of the lowest bit that is set. \pre one is
inline int lowest_bit(std::uint64_t bits)
{
#ifdef __GNUC__
  return __builtin_ctzll(bits);
#else
  int k = 0;
  for (int half = 32; half > 0; half /= 2)
    if (((bits >> k) << (64 - half)) == 0)
      k += half;
  return k;
#endif
}

/// 2 to the power of `exponent`. By bits, like the next: calls of the library show in the time of a search.
inline double power_of_two(int exponent)
{
  if (exponent < -1022 || exponent > 1023)
    return std::ldexp(1., exponent);
  const std::uint64_t bits = static_cast<std::uint64_t>(exponent + 1023) << 52;
  double power;
  std::memcpy(&power, &bits, sizeof power);
  return power;
}

/// the least e with `value` <= 2^e \pre `value` is positive
inline int exponent_above(double value)
{
  std::uint64_t bits;
  std::memcpy(&bits, &value, sizeof bits);
  const int biased = static_cast<int>(bits >> 52);
  if (biased > 0 && biased < 0x7FF)
    return biased - 1023 + ((bits << 12) != 0);
  int exponent;
  const double mantissa = std::frexp(value, &exponent);
  return mantissa == 0.5 ? exponent - 1 : exponent;
}

/// Square cells in levels, the side doubling from level to level, in blocks of 8 x 8, with a bit for each cell that
/// holds something and for each that has smaller ones inside, so that a query finds the cells that it must look into
/// with a few operations on whole blocks. A block points to the four of the next lower level inside it; only those of
/// the highest level are hashed.
class Cell_blocks_2
{
public:
  struct Cell
  {
    std::int64_t ix, iy;
    int level;

    bool operator==(const Cell& c) const { return ix == c.ix && iy == c.iy && level == c.level; }
  };

  /// 8 x 8 cells of a level. Whoever puts something into a cell, or takes it out, sets its bit of `occupied`, and
  /// `first`.
  struct Block
  {
    std::uint64_t occupied = 0;    ///< a bit for each cell: whether it holds anything
    std::uint64_t descendants = 0; ///< whether smaller cells inside do
    double largest = 0;            ///< nothing in it, or in smaller cells inside, is larger
    double inverse;                ///< of the side of its cells
    std::int64_t ix, iy;           ///< of its first cell, divided by 8
    std::array<Index, 4> children{no_index, no_index, no_index, no_index};
    std::array<Index, 64> first;   ///< what the cells hold; read for occupied cells only
  };

  /// `side`: of the cells of level 0; `x0`, `y0`: any point near all cells
  Cell_blocks_2(double side, double x0, double y0) : m_side(side), m_inverse(1 / side), m_x0(x0), m_y0(y0)
  {
    m_table.assign(64, no_index);
  }

  /// the cell of a level at (x, y), or of a higher one if coordinates of cells would overflow
  Cell cell_at(int level, double x, double y) const
  {
    constexpr int bits = 48;
    const double far = (std::max)(std::abs(x - m_x0), std::abs(y - m_y0));
    if (far > 0)
      level = (std::max)(level, exponent_above(far / m_side) - bits);
    const double inverse = inverse_side(level);
    return Cell{index_at(x - m_x0, inverse), index_at(y - m_y0, inverse), level};
  }

  static int bit_of(const Cell& c) { return static_cast<int>((c.ix & 7) | ((c.iy & 7) << 3)); }

  const Block& operator[](Index block) const { return m_blocks[block]; }

  /// nothing is larger
  double largest() const { return m_largest; }

  /// of the side of the cells of the highest level
  double least_inverse() const { return inverse_side(m_highest); }

  /// The block of a cell in which something of size `d` lies or will lie. It is made if it is not there; and those
  /// around it know of it then.
  Block& block_for(const Cell& cell, double d)
  {
    if (m_roots.empty())
      m_highest = cell.level;
    while (cell.level > m_highest)
      raise_top();
    m_largest = (std::max)(m_largest, d);
    Block& b = find_or_add_block(cell, [d](Block& around, int bit) {
      around.descendants |= std::uint64_t(1) << bit;
      around.largest = (std::max)(around.largest, d);
    });
    b.largest = (std::max)(b.largest, d);
    return b;
  }

  /// The block of a cell. \pre it was made
  Block& block_of(const Cell& cell)
  {
    return find_or_add_block(cell, [](Block&, int) {});
  }

  /// calls `visit(block)` for all blocks of the highest level that are nearer to (x, y) than `distance` in x and y,
  /// until it returns false; returns whether it never did
  template <class Visit>
  bool for_each_root(double x, double y, double distance, const Visit& visit) const
  {
    const double inverse = least_inverse();
    const auto block_at = [&](double dx, double dy) {
      return block_index(Cell{index_at(x + dx - m_x0, inverse), index_at(y + dy - m_y0, inverse), 0});
    };
    const Cell low = block_at(-distance, -distance), high = block_at(distance, distance);
    for (std::int64_t iy = low.iy; iy <= high.iy; ++iy)
      for (std::int64_t ix = low.ix; ix <= high.ix; ++ix) {
        const Index root = m_table[slot_of(ix, iy)];
        if (root != no_index && !visit(root))
          return false;
      }
    return true;
  }

  /// the bits of the cells of a block that are nearer to (x, y) than `distance` in x and y
  std::uint64_t cells_near(const Block& b, double x, double y, double distance) const
  {
    return bits_between(x - distance - m_x0, x + distance - m_x0, b.inverse, b.ix, 1) &
           bits_between(y - distance - m_y0, y + distance - m_y0, b.inverse, b.iy, 8);
  }

private:
  double inverse_side(int level) const { return m_inverse * power_of_two(-level); }

  static std::int64_t index_at(double offset, double inverse)
  {
    const double v = offset * inverse;
    const std::int64_t i = static_cast<std::int64_t>(v);
    return i - (static_cast<double>(i) > v);
  }

  static Cell block_index(const Cell& c) { return Cell{c.ix >> 3, c.iy >> 3, c.level}; }

  // of a block of the highest level
  std::size_t slot_of(std::int64_t ix, std::int64_t iy) const
  {
    const std::uint64_t hash = hash_of_two(static_cast<std::uint64_t>(ix), static_cast<std::uint64_t>(iy));
    std::size_t k = static_cast<std::size_t>(hash) & (m_table.size() - 1);
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
  Block& find_or_add_block(const Cell& cell, const Mark& mark)
  {
    const auto above = [&cell](int k) { // sizes may differ by more than 2^64
      return Cell{cell.ix >> (std::min)(k, 63), cell.iy >> (std::min)(k, 63), cell.level + k};
    };
    Index b = find_or_add_root(block_index(above(m_highest - cell.level)));
    for (int k = m_highest - cell.level; k > 0; --k) {
      mark(m_blocks[b], bit_of(above(k)));
      const Cell block = block_index(above(k - 1));
      const std::size_t quarter = static_cast<std::size_t>((block.ix & 1) | ((block.iy & 1) << 1));
      if (m_blocks[b].children[quarter] == no_index) {
        const Index child = add_block(block);
        m_blocks[b].children[quarter] = child;
      }
      b = m_blocks[b].children[quarter];
    }
    return m_blocks[b];
  }

  // something larger than all before: the blocks of the highest level get parents
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

  double m_side, m_inverse, m_x0, m_y0;
  std::vector<Block> m_blocks;
  std::vector<Index> m_roots; // the blocks of the highest level
  std::vector<Index> m_table; // the same, hashed
  double m_largest = 0;
  int m_highest = 0;
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_GEOMETRY_CELL_BLOCKS_2_H
