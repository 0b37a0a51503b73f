// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_SEARCH_DISC_LISTS_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_SEARCH_DISC_LISTS_2_H

#include <CGAL/Bubble_relaxation_2/internal/meshless/search/Influence_disc_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// Square cells, each with the list of all discs that meet it, in ascending order: a point is in no other disc
/// than those of its cell's list. Cells are about as wide as a radius, however radii vary: those of a regular grid
/// are cut into four as long as most of their discs are small for them. So a query finds one cell and goes
/// through one list, of which about half are found, and which does not have to be sorted.
///
/// Cells at the rim of the grid go on to infinity, so that each point has one.
class Disc_lists_2
{
public:
  explicit Disc_lists_2(const std::vector<Influence_disc_2>& discs);

  /// calls `visit(i)` for each disc that may contain a point, in ascending order
  template <class Visitor>
  void for_each_candidate(double x, double y, Visitor visit) const
  {
    if (m_cells.empty())
      return;
    const Cell& cell = m_cells[cell_of(x, y)];
    const std::int32_t* i = m_lists.data() + cell.first;
    for (const std::int32_t* last = i + cell.size; i != last; ++i)
      visit(*i);
  }

  /// the discs that contain a point, shrunk by a factor of at most 1, in ascending order
  void find(const std::vector<Influence_disc_2>& discs, double x, double y, double factor,
            std::vector<std::int32_t>& result) const
  {
    result.clear();
    if (m_cells.empty())
      return;
    const Cell& cell = m_cells[cell_of(x, y)];
    result.resize(cell.size);
    const std::int32_t* list = m_lists.data() + cell.first;
    std::int32_t* found = result.data();
    std::size_t n = 0;
    for (std::size_t k = 0, size = cell.size; k < size; ++k) {
      const std::int32_t i = list[k];
      found[n] = i;
      n += discs[static_cast<std::size_t>(i)].contains(x, y, factor); // no branch: it would be hard to foretell
    }
    result.resize(n);
  }

  std::size_t number_of_cells() const { return m_cells.size(); }
  std::size_t number_of_entries() const { return m_lists.size(); } ///< of all lists

private:
  struct Cell
  {
    std::size_t first = 0;      ///< of its list
    std::uint32_t size = 0;     ///< of its list
    std::uint32_t children = 0; ///< the first of its four quarters; 0: none
  };

  class Builder;

  static std::size_t index_at(double offset, std::size_t n)
  {
    return !(offset > 0) ? 0 : offset < static_cast<double>(n) ? static_cast<std::size_t>(offset) : n - 1;
  }

  std::size_t column(double x) const { return index_at((x - m_x0) * m_inverse, m_columns); }
  std::size_t row(double y) const { return index_at((y - m_y0) * m_inverse, m_rows); }

  std::size_t cell_of(double x, double y) const
  {
    const std::size_t i = column(x), j = row(y);
    std::size_t cell = j * m_columns + i;
    if (m_cells[cell].children == 0)
      return cell;
    double half = 0.5 * m_side;
    double xm = m_x0 + m_side * static_cast<double>(i) + half, ym = m_y0 + m_side * static_cast<double>(j) + half;
    do {
      const bool right = x >= xm, up = y >= ym;
      cell = m_cells[cell].children + (right ? 1 : 0) + (up ? 2 : 0);
      half *= 0.5;
      xm += right ? half : -half;
      ym += up ? half : -half;
    } while (m_cells[cell].children != 0);
    return cell;
  }

  double m_x0 = 0, m_y0 = 0, m_side = 1, m_inverse = 1;
  std::size_t m_columns = 0, m_rows = 0;
  std::vector<Cell> m_cells; // those of the grid row by row, then quarters
  std::vector<std::int32_t> m_lists;
};

class Disc_lists_2::Builder
{
public:
  Builder(const std::vector<Influence_disc_2>& discs, Disc_lists_2& lists)
    : m_discs(discs), m_extent(discs), m_rounding(m_extent.rounding()), m(lists)
  {}

  void build()
  {
    choose_side();
    list_in_grid();
    // all of one size, and cells of theirs: none is to be cut
    if (m_extent.smallest >= small * m.m_side)
      return;
    std::vector<std::int32_t> grid_lists;
    grid_lists.swap(m.m_lists);
    m.m_lists.reserve(grid_lists.size());
    for (std::size_t cell = 0, n = m.m_cells.size(); cell < n; ++cell) {
      const auto first = grid_lists.begin() + static_cast<std::ptrdiff_t>(m.m_cells[cell].first);
      m_stack.assign(first, first + m.m_cells[cell].size);
      const double x = m.m_x0 + m.m_side * static_cast<double>(cell % m.m_columns),
                   y = m.m_y0 + m.m_side * static_cast<double>(cell / m.m_columns);
      cut(cell, 0, m_stack.size(), Square{x, y, m.m_side}, 0);
    }
  }

private:
  // The best of those tried: the cells of lists with 1 million nodes and radii of 1.65 and 2.5 d, uniform and
  // graded, are between 0.75 and 1.5 radii wide. Smaller ones have shorter lists, which take longer to make.
  static constexpr double small = 0.75;                 ///< radius over side, of discs that a cell is cut for
  static constexpr std::size_t short_list = 8;          ///< is not cut
  static constexpr double entries_a_disc = 16;          ///< of the grid, at most
  static constexpr std::size_t discs_in_band = 16384; ///< about
  static constexpr int most_cuts = 40;                  ///< of a cell of the grid: radii may differ by 10^12
  static constexpr double slack = 1 + 1e-6;

  struct Square
  {
    double x, y, side;
  };

  /// The smallest grid that has no more cells than there are discs, and no more entries than some times as many.
  /// Discs that are wider than the grid have an entry in each of its cells: the estimate is too high then.
  void choose_side()
  {
    double sum = 0, squares = 0;
    for (const Influence_disc_2& d : m_discs) {
      sum += d.radius / m_extent.largest;
      squares += d.radius / m_extent.largest * (d.radius / m_extent.largest);
    }
    const double n = static_cast<double>(m_discs.size()), w = m_extent.xmax - m_extent.xmin,
                 h = m_extent.ymax - m_extent.ymin;
    double side = (std::max)(small * m_extent.smallest, m_rounding);
    const auto is_too_small = [&] {
      const double cells = (w / side + 1) * (h / side + 1), scale = m_extent.largest / side;
      return cells > n || (cells > 1 && n + 4 * scale * sum + 3.15 * scale * scale * squares > entries_a_disc * n);
    };
    while (is_too_small())
      side *= 2;
    m.m_side = side;
    m.m_inverse = 1 / side;
    m.m_x0 = m_extent.xmin;
    m.m_y0 = m_extent.ymin;
    m.m_columns = static_cast<std::size_t>(w / side) + 1;
    m.m_rows = static_cast<std::size_t>(h / side) + 1;
  }

  /// somewhat more than the radius, so that no rounding loses a disc
  double reach(const Influence_disc_2& d) const { return slack * d.radius + m_rounding; }

  /// calls `f(row, first column, last column)` for each row of the grid that a disc meets
  template <class Function>
  void for_each_run(const Influence_disc_2& d, const Function& f) const
  {
    const double r = reach(d);
    const std::size_t bottom = m.row(d.y - r), top = m.row(d.y + r);
    for (std::size_t j = bottom; j <= top; ++j) {
      const double low = m.m_y0 + m.m_side * static_cast<double>(j);
      // the first row and the last go on to infinity
      const double dy = (std::max)((std::max)(j > 0 ? low - d.y : 0, j + 1 < m.m_rows ? d.y - low - m.m_side : 0), 0.);
      const double half = std::sqrt((std::max)(r * r - dy * dy, 0.)) + m_rounding;
      f(j, m.column(d.x - half), m.column(d.x + half));
    }
  }

  /// cells first to last of one row of the grid, which a disc meets
  struct Run
  {
    std::uint32_t first, last;
    std::int32_t disc;
  };

  /// In bands of rows, whose lists fit into a cache: discs may come in any order in space, but lists take them in
  /// that of their numbers.
  void list_in_grid()
  {
    const std::size_t rows_in_band =
      (std::max)(m.m_rows * (std::min)(discs_in_band, m_discs.size()) / m_discs.size(), std::size_t(1));
    std::vector<std::vector<Run>> bands((m.m_rows - 1) / rows_in_band + 1);
    std::size_t entries = 0;
    for (std::size_t i = 0; i < m_discs.size(); ++i)
      for_each_run(m_discs[i], [&](std::size_t row, std::size_t first, std::size_t last) {
        bands[row / rows_in_band].push_back(Run{static_cast<std::uint32_t>(row * m.m_columns + first),
                                                static_cast<std::uint32_t>(row * m.m_columns + last),
                                                static_cast<std::int32_t>(i)});
        entries += last - first + 1;
      });
    m.m_lists.reserve(entries);
    m.m_cells.resize(m.m_columns * m.m_rows);
    for (std::size_t k = 0; k < bands.size(); ++k) {
      const std::size_t first = k * rows_in_band * m.m_columns;
      list_in_band(bands[k], first, (std::min)(first + rows_in_band * m.m_columns, m.m_cells.size()));
      std::vector<Run>().swap(bands[k]);
    }
  }

  void list_in_band(const std::vector<Run>& runs, std::size_t first_cell, std::size_t end_of_cells)
  {
    for (const Run& run : runs)
      for (std::size_t cell = run.first; cell <= run.last; ++cell)
        ++m.m_cells[cell].size;
    std::size_t entries = m.m_lists.size();
    for (std::size_t k = first_cell; k < end_of_cells; ++k) {
      m.m_cells[k].first = entries;
      entries += m.m_cells[k].size;
      m.m_cells[k].size = 0;
    }
    m.m_lists.resize(entries);
    for (const Run& run : runs)
      for (std::size_t cell = run.first; cell <= run.last; ++cell) {
        Cell& c = m.m_cells[cell];
        m.m_lists[c.first + c.size++] = run.disc;
      }
  }

  /// enters the list that lies in the stack from `first` on, or cuts the cell and enters those of its quarters
  void cut(std::size_t cell, std::size_t first, std::size_t size, const Square& square, int number_of_cuts)
  {
    if (!is_worth_cutting(first, size, square.side, number_of_cuts)) {
      m.m_cells[cell].first = m.m_lists.size();
      m.m_cells[cell].size = static_cast<std::uint32_t>(size);
      const auto begin = m_stack.begin() + static_cast<std::ptrdiff_t>(first);
      m.m_lists.insert(m.m_lists.end(), begin, begin + static_cast<std::ptrdiff_t>(size));
      return;
    }
    const std::size_t children = m.m_cells.size(), top = first + size;
    m.m_cells.resize(children + 4);
    m.m_cells[cell].children = static_cast<std::uint32_t>(children);
    const std::array<std::size_t, 4> sizes = distribute(first, size, square);
    const double half = 0.5 * square.side;
    for (std::size_t k = 4; k-- > 0;) { // from the top of the stack
      cut(children + k, top + k * size, sizes[k],
          Square{square.x + (k & 1 ? half : 0), square.y + (k & 2 ? half : 0), half}, number_of_cuts + 1);
    }
    m_stack.resize(top);
  }

  bool is_worth_cutting(std::size_t first, std::size_t size, double side, int number_of_cuts) const
  {
    if (size <= short_list || number_of_cuts == most_cuts)
      return false;
    std::size_t number_of_small = 0;
    for (std::size_t k = first; k < first + size; ++k)
      number_of_small += disc(k).radius < small * side;
    return 2 * number_of_small > size;
  }

  const Influence_disc_2& disc(std::size_t k) const { return m_discs[static_cast<std::size_t>(m_stack[k])]; }

  /// Puts the discs of a cell into the lists of its quarters, which lie one after the other above it in the stack,
  /// each with room for all. Whether a disc meets a quarter is asked as if that had no outer sides, which the cells
  /// at the rim do not have: it meets the cell anyway.
  std::array<std::size_t, 4> distribute(std::size_t first, std::size_t size, const Square& square)
  {
    const double xm = square.x + 0.5 * square.side, ym = square.y + 0.5 * square.side;
    const std::size_t top = first + size;
    m_stack.resize(top + 4 * size);
    std::array<std::size_t, 4> sizes{0, 0, 0, 0};
    for (std::size_t k = first; k < top; ++k) {
      const Influence_disc_2& d = disc(k);
      const double r = reach(d), squared = r * r;
      const double left = (std::max)(d.x - xm, 0.), right = (std::max)(xm - d.x, 0.),
                   down = (std::max)(d.y - ym, 0.), up = (std::max)(ym - d.y, 0.);
      const std::array<double, 4> distances{left * left + down * down, right * right + down * down,
                                            left * left + up * up, right * right + up * up};
      for (std::size_t q = 0; q < 4; ++q) {
        m_stack[top + q * size + sizes[q]] = m_stack[k];
        sizes[q] += distances[q] < squared;
      }
    }
    return sizes;
  }

  const std::vector<Influence_disc_2>& m_discs;
  const Influence_extent_2 m_extent;
  const double m_rounding;
  Disc_lists_2& m;
  std::vector<std::int32_t> m_stack;
};

inline Disc_lists_2::Disc_lists_2(const std::vector<Influence_disc_2>& discs)
{
  if (!discs.empty())
    Builder(discs, *this).build();
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_SEARCH_DISC_LISTS_2_H
