// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_MLS_MLS_EVALUATION_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_MLS_MLS_EVALUATION_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/parallel_for.h>
#include <CGAL/Bubble_relaxation_2/internal/meshless/mls/Local_fit_2.h>
#include <CGAL/Bubble_relaxation_2/internal/meshless/mls/Mls_fitting_2.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// the sum of the nodes' shape functions times their coefficients
template <class Coefficients>
double sum_of_shapes(const std::vector<std::int32_t>& nodes, const std::vector<double>& shapes,
                     const Coefficients& coefficients)
{
  double result = 0;
  for (std::size_t i = 0; i < nodes.size(); ++i)
    result += shapes[i] * coefficients[static_cast<std::size_t>(nodes[i])];
  return result;
}

/// Moving least squares at many points, in blocks that several threads may compute.
template <class Mls, class Concurrency_tag>
class Mls_evaluation_2
{
public:
  using Influence = typename Mls::Influence;
  using Point_2 = typename Mls::Point_2;
  using Values = typename Mls::Values;

  Mls_evaluation_2(const Influence& influence, const Mls_options& options, const std::vector<Point_2>& points)
    : m_influence(influence), m_options(options), m_points(points),
      m_number_of_blocks((points.size() + block_size - 1) / block_size)
  {}

  /// \throws Deficient_support_error_2 about the first point that has no value
  template <class Coefficients>
  Values operator()(const Coefficients& coefficients, int number_of_derivatives) const
  {
    const std::size_t n = m_points.size();
    Values result;
    result.values.resize(n);
    for (auto* array : {&result.dx, &result.dy})
      array->resize(number_of_derivatives > 0 ? n : 0);
    for (auto* array : {&result.dxx, &result.dxy, &result.dyy})
      array->resize(number_of_derivatives > 1 ? n : 0);
    std::vector<Block> blocks(m_number_of_blocks);
    parallel_for<Concurrency_tag>(m_number_of_blocks, [&](std::size_t b) {
      blocks[b] = evaluate_block(b, coefficients, number_of_derivatives, result);
    }, 1);
    add_up(blocks, result);
    return result;
  }

private:
  using Shapes = typename Mls::Shape_functions;
  using Fitting = Mls_fitting_2<Influence, Shapes>;

  static constexpr std::size_t block_size = 512; // points that one thread evaluates in a row

  /// what was found at the points of a block
  struct Block
  {
    std::size_t number_of_enlarged = 0;
    double largest_enlargement = 1;
    std::size_t number_of_deficient = 0;
    std::size_t first_deficient = 0;
  };

  /// what a thread needs
  struct Worker
  {
    typename Mls::Query query;
    Local_fit_2 fit;
    Shapes shapes;
    Fitting fitting;

    explicit Worker(const Mls_evaluation_2& e)
      : query(e.m_influence), fitting(e.m_influence, e.m_options, query, fit, shapes)
    {}
    Worker(const Worker&) = delete;
    Worker& operator=(const Worker&) = delete;
  };

  std::size_t end_of_block(std::size_t b) const { return (std::min)(m_points.size(), (b + 1) * block_size); }

  template <class Coefficients>
  Block evaluate_block(std::size_t b, const Coefficients& coefficients, int number_of_derivatives,
                       Values& result) const
  {
    Block block;
    Worker w(*this);
    for (std::size_t i = b * block_size; i < end_of_block(b); ++i) {
      if (!w.fitting.fit(m_points[i], number_of_derivatives)) {
        if (block.number_of_deficient++ == 0)
          block.first_deficient = i;
        continue;
      }
      w.fit.write(number_of_derivatives, w.shapes);
      block.number_of_enlarged += w.shapes.enlargement > 1;
      block.largest_enlargement = (std::max)(block.largest_enlargement, w.shapes.enlargement);
      for_each_array(result, w.shapes, [&](std::vector<double>& out, const std::vector<double>& shapes) {
        if (!out.empty())
          out[i] = sum_of_shapes(w.shapes.nodes, shapes, coefficients);
      });
    }
    return block;
  }

  void add_up(const std::vector<Block>& blocks, Values& result) const
  {
    std::size_t number_of_deficient = 0;
    for (const Block& b : blocks) {
      result.number_of_enlarged_supports += b.number_of_enlarged;
      result.largest_enlargement = (std::max)(result.largest_enlargement, b.largest_enlargement);
      number_of_deficient += b.number_of_deficient;
    }
    if (number_of_deficient == 0)
      return;
    const auto first = std::find_if(blocks.begin(), blocks.end(),
                                    [](const Block& b) { return b.number_of_deficient > 0; });
    throw Worker(*this).fitting.error(m_points[first->first_deficient], sufficient_enlargement(),
                                      number_of_deficient);
  }

  /// The least power of 1.1 found that does at all points; 0 if there is none. Larger radii may also spoil the
  /// fit at a point, where two or three nodes get close in units of them before others are met: so all points are
  /// looked at again after each enlargement, until nothing changes.
  double sufficient_enlargement() const
  {
    for (double enlargement = 1;;) {
      std::vector<double> largest(m_number_of_blocks);
      parallel_for<Concurrency_tag>(m_number_of_blocks, [&](std::size_t b) {
        largest[b] = sufficient_enlargement(b, enlargement);
      }, 1);
      if (std::find(largest.begin(), largest.end(), 0.) != largest.end())
        return 0;
      const double next = *std::max_element(largest.begin(), largest.end());
      if (!(next > enlargement))
        return enlargement;
      enlargement = next;
    }
  }

  /// of the points of a block, which have been enlarged already
  double sufficient_enlargement(std::size_t b, double enlargement) const
  {
    Worker w(*this);
    double largest = enlargement;
    for (std::size_t i = b * block_size; i < end_of_block(b) && largest > 0; ++i) {
      const double e = w.fitting.sufficient_enlargement(m_points[i], enlargement);
      largest = e > 0 ? (std::max)(largest, e) : 0;
    }
    return largest;
  }

  template <class Function>
  static void for_each_array(Values& v, const Shapes& r, const Function& f)
  {
    f(v.values, r.values);
    f(v.dx, r.dx);
    f(v.dy, r.dy);
    f(v.dxx, r.dxx);
    f(v.dxy, r.dxy);
    f(v.dyy, r.dyy);
  }

  const Influence& m_influence;
  const Mls_options& m_options;
  const std::vector<Point_2>& m_points;
  const std::size_t m_number_of_blocks;
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_MLS_MLS_EVALUATION_2_H
