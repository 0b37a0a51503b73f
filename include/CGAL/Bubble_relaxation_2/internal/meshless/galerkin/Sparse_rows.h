// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_GALERKIN_SPARSE_ROWS_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_GALERKIN_SPARSE_ROWS_H

#include <CGAL/Bubble_relaxation_2/internal/core/vocabulary.h>
#include <CGAL/Bubble_relaxation_2/internal/meshless/mls/Mls_evaluation_2.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// What a cell adds to the equations: a dense matrix and a vector for a few unknowns.
struct Galerkin_part
{
  std::vector<Index> unknowns; ///< ascending
  Eigen::MatrixXd matrix;      ///< a row a test function
  Eigen::VectorXd load;
};

/// A sparse matrix while parts are added to it. Each entry is the sum of its parts in their order, whatever the
/// number of threads.
class Sparse_rows
{
public:
  explicit Sparse_rows(std::size_t n) : m_rows(n), m_load(Eigen::VectorXd::Zero(static_cast<Eigen::Index>(n))) {}

  /// adds the first `number` of parts, which have a `Galerkin_part` for a base
  template <class Part>
  void add(const Parallel_loop& parallel, const std::vector<Part>& parts, std::size_t number)
  {
    // the rows of all parts, sorted by row; a row is one thread's
    std::vector<Row_of_part> sorted;
    for (std::size_t k = 0; k < number; ++k)
      for (std::size_t r = 0; r < parts[k].unknowns.size(); ++r)
        sorted.push_back(Row_of_part{parts[k].unknowns[r], static_cast<Index>(k), static_cast<Index>(r)});
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const Row_of_part& a, const Row_of_part& b) { return a.row < b.row; });
    std::vector<std::size_t> first;
    for (std::size_t k = 0; k < sorted.size(); ++k)
      if (k == 0 || sorted[k].row != sorted[k - 1].row)
        first.push_back(k);
    first.push_back(sorted.size());
    parallel(first.size() - 1, [&](std::size_t i) {
      for (std::size_t k = first[i]; k < first[i + 1]; ++k)
        add_row(sorted[k].row, parts[sorted[k].part], sorted[k].row_of_part);
    });
  }

  const Eigen::VectorXd& load() const { return m_load; }

  /// the entry on the diagonal; 0 if there is none
  double diagonal(std::size_t i) const
  {
    for (const Entry& e : m_rows[i])
      if (static_cast<std::size_t>(e.column) == i)
        return e.value;
    return 0;
  }

  Eigen::SparseMatrix<double> matrix() const
  {
    const auto n = static_cast<Eigen::Index>(m_rows.size());
    Eigen::VectorXi sizes = Eigen::VectorXi::Zero(n); // of columns
    for (const std::vector<Entry>& row : m_rows)
      for (const Entry& e : row)
        ++sizes[e.column];
    Eigen::SparseMatrix<double> result(n, n);
    result.reserve(sizes);
    for (Eigen::Index i = 0; i < n; ++i)
      for (const Entry& e : m_rows[static_cast<std::size_t>(i)])
        result.insert(i, e.column) = e.value;
    result.makeCompressed();
    return result;
  }

private:
  struct Entry
  {
    Index column;
    double value;
  };

  struct Row_of_part
  {
    Index row, part, row_of_part;
  };

  void add_row(Index row, const Galerkin_part& part, Index row_of_part)
  {
    m_load[row] += part.load[row_of_part];
    std::vector<Entry>& entries = m_rows[static_cast<std::size_t>(row)];
    const std::size_t old_size = entries.size();
    std::size_t k = 0;
    for (std::size_t c = 0; c < part.unknowns.size(); ++c) {
      const Index column = part.unknowns[c];
      const double value = part.matrix(row_of_part, static_cast<Eigen::Index>(c));
      while (k < old_size && entries[k].column < column)
        ++k;
      if (k < old_size && entries[k].column == column)
        entries[k].value += value;
      else
        entries.push_back(Entry{column, value});
    }
    const auto middle = entries.begin() + static_cast<std::ptrdiff_t>(old_size);
    std::inplace_merge(entries.begin(), middle, entries.end(),
                       [](const Entry& a, const Entry& b) { return a.column < b.column; });
  }

  std::vector<std::vector<Entry>> m_rows; // sorted by columns
  Eigen::VectorXd m_load;
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_GALERKIN_SPARSE_ROWS_H
