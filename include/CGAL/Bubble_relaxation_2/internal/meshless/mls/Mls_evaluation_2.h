// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_MLS_MLS_EVALUATION_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_MLS_MLS_EVALUATION_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/Relaxation_options.h>
#include <CGAL/Bubble_relaxation_2/internal/core/parallel_for.h>
#include <CGAL/Bubble_relaxation_2/internal/core/vocabulary.h>
#include <CGAL/Bubble_relaxation_2/internal/meshless/mls/Local_fit_2.h>
#include <CGAL/Bubble_relaxation_2/internal/meshless/search/Influence_search_2.h>

#include <CGAL/Deficient_support_error_2.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// calls `f(i)` for all i in [0, n), perhaps by several threads
using Parallel_loop = std::function<void(std::size_t n, const std::function<void(std::size_t)>& f)>;

template <class Concurrency_tag>
Parallel_loop make_parallel_loop()
{
  return [](std::size_t n, const std::function<void(std::size_t)>& f) {
    parallel_for(threads_of<Concurrency_tag>(), n, f, 1);
  };
}

template <class Point_2>
Point rounded(const Point_2& p)
{
  return Point(CGAL::to_double(p.x()), CGAL::to_double(p.y()));
}

template <class Point_2>
std::vector<Point> rounded(const std::vector<Point_2>& points)
{
  std::vector<Point> result;
  result.reserve(points.size());
  for (const Point_2& p : points)
    result.push_back(rounded(p));
  return result;
}

/// `Moving_least_squares_2::Shape_functions`
struct Mls_shapes_2
{
  std::vector<std::int32_t> nodes;
  std::vector<double> values, dx, dy, dxx, dxy, dyy;
  double enlargement = 1;
  double condition_number = 0;

private:
  friend class Mls_fitting_2;
  Local_fit_2 m_fit;
};

/// `Moving_least_squares_2::Values`
struct Mls_values_2
{
  std::vector<double> values, dx, dy, dxx, dxy, dyy;
  std::size_t number_of_enlarged_supports = 0;
  double largest_enlargement = 1;
};

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

/// Fits at one point after the other, for one thread: searches nodes, and does what is to be done where they do not
/// suffice.
class Mls_fitting_2
{
public:
  Mls_fitting_2(const Influence_search_2& search, const Mls_options& options, Influence_query_2& query,
                Mls_shapes_2& shapes)
    : m_search(search), m_options(options), m_query(query), m_shapes(shapes)
  {}

  /// returns whether there are shape functions at `p`, after all that may be done for it, and sets them if so
  bool fit(const Point& p, int number_of_derivatives)
  {
    if (!suffices(p, number_of_derivatives, 1) && !does_nevertheless(p, number_of_derivatives))
      return false;
    m_shapes.m_fit.write(number_of_derivatives, m_shapes);
    return true;
  }

  /// what supports times `enlargement` have to be multiplied by further, 1.1 again and again, until the nodes at
  /// `p` suffice; 0 if that does not help
  double sufficient_enlargement(const Point& p, double enlargement)
  {
    return suffices(p, 0, enlargement) || enlarge(p, 0) ? m_shapes.enlargement : 0;
  }

  /// that the nodes do not suffice at `p`, the first of so many points, for all of which `enlargement` would do
  Deficient_support_error_2 error(const Point& p, double enlargement, std::size_t number_of_points)
  {
    suffices(p, 0, 1);
    return Deficient_support_error_2(p.x(), p.y(), m_shapes.nodes.size(),
                                     m_shapes.condition_number, m_options.maximum_condition_number, enlargement,
                                     number_of_points);
  }

private:
  bool does_nevertheless(const Point& p, int number_of_derivatives)
  {
    switch (m_options.deficient_support) {
    case Deficient_support::ENLARGE:
      return enlarge(p, number_of_derivatives);
    case Deficient_support::PSEUDO_INVERSE:
      return true;
    default:
      return false;
    }
  }

  /// returns whether the nodes at `p` do, with supports that are so much larger
  bool suffices(const Point& p, int number_of_derivatives, double enlargement)
  {
    m_shapes.enlargement = enlargement;
    m_query(p.x(), p.y(), enlargement, m_shapes.nodes);
    m_shapes.m_fit.gather(m_search, p, m_shapes.nodes, enlargement);
    const bool result = m_shapes.m_fit.solve(m_options, number_of_derivatives);
    m_shapes.condition_number = m_shapes.m_fit.condition_number();
    return result;
  }

  /// Enlarges the supports until the nodes suffice. Once they have all nodes, twice as far from their rims than
  /// when they had just got them, there is nothing to gain: weights hardly differ, and only lengths in units
  /// of the radii go on to shrink. From 1e15 radii away nodes cannot be told from each other.
  bool enlarge(const Point& p, int number_of_derivatives)
  {
    int steps_with_all_nodes = 0;
    while (steps_with_all_nodes < 8 && m_shapes.enlargement < 1e15) {
      if (suffices(p, number_of_derivatives, 1.1 * m_shapes.enlargement))
        return true;
      if (m_shapes.nodes.size() == m_search.size())
        ++steps_with_all_nodes;
    }
    return false;
  }

  const Influence_search_2& m_search;
  const Mls_options& m_options;
  Influence_query_2& m_query;
  Mls_shapes_2& m_shapes;
};

/// Moving least squares at many points, in blocks that several threads may compute.
class Mls_evaluation_2
{
public:
  Mls_evaluation_2(std::shared_ptr<const Influence_search_2> search, const Mls_options& options,
                   const std::vector<Point>& points, const Parallel_loop& parallel)
    : m_search(std::move(search)), m_options(options), m_points(points), m_parallel(parallel),
      m_number_of_blocks((points.size() + block_size - 1) / block_size)
  {}

  /// \throws Deficient_support_error_2 about the first point that has no value
  Mls_values_2 operator()(const std::vector<double>& coefficients, int number_of_derivatives) const
  {
    const std::size_t n = m_points.size();
    Mls_values_2 result;
    result.values.resize(n);
    for (auto* array : {&result.dx, &result.dy})
      array->resize(number_of_derivatives > 0 ? n : 0);
    for (auto* array : {&result.dxx, &result.dxy, &result.dyy})
      array->resize(number_of_derivatives > 1 ? n : 0);
    std::vector<Block> blocks(m_number_of_blocks);
    m_parallel(m_number_of_blocks, [&](std::size_t b) {
      blocks[b] = evaluate_block(b, coefficients, number_of_derivatives, result);
    });
    add_up(blocks, result);
    return result;
  }

private:
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
    Influence_query_2 query;
    Mls_shapes_2 shapes;
    Mls_fitting_2 fitting;

    explicit Worker(const Mls_evaluation_2& e)
      : query(e.m_search), fitting(*e.m_search, e.m_options, query, shapes)
    {}
    Worker(const Worker&) = delete;
    Worker& operator=(const Worker&) = delete;
  };

  std::size_t end_of_block(std::size_t b) const { return (std::min)(m_points.size(), (b + 1) * block_size); }

  Block evaluate_block(std::size_t b, const std::vector<double>& coefficients, int number_of_derivatives,
                       Mls_values_2& result) const
  {
    Block block;
    Worker w(*this);
    for (std::size_t i = b * block_size; i < end_of_block(b); ++i) {
      if (!w.fitting.fit(m_points[i], number_of_derivatives)) {
        if (block.number_of_deficient++ == 0)
          block.first_deficient = i;
        continue;
      }
      block.number_of_enlarged += w.shapes.enlargement > 1;
      block.largest_enlargement = (std::max)(block.largest_enlargement, w.shapes.enlargement);
      constexpr std::vector<double> Mls_values_2::*out[] = {&Mls_values_2::values, &Mls_values_2::dx,
        &Mls_values_2::dy, &Mls_values_2::dxx, &Mls_values_2::dxy, &Mls_values_2::dyy};
      constexpr std::vector<double> Mls_shapes_2::*in[] = {&Mls_shapes_2::values, &Mls_shapes_2::dx,
        &Mls_shapes_2::dy, &Mls_shapes_2::dxx, &Mls_shapes_2::dxy, &Mls_shapes_2::dyy};
      for (std::size_t k = 0; k < 6; ++k)
        if (!(result.*out[k]).empty())
          (result.*out[k])[i] = sum_of_shapes(w.shapes.nodes, w.shapes.*in[k], coefficients);
    }
    return block;
  }

  void add_up(const std::vector<Block>& blocks, Mls_values_2& result) const
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
      m_parallel(m_number_of_blocks, [&](std::size_t b) {
        largest[b] = sufficient_enlargement(b, enlargement);
      });
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

  const std::shared_ptr<const Influence_search_2> m_search;
  const Mls_options& m_options;
  const std::vector<Point>& m_points;
  const Parallel_loop& m_parallel;
  const std::size_t m_number_of_blocks;
};

/// What `Moving_least_squares_2` does, whatever the kernel.
class Mls_approximation_2
{
public:
  Mls_approximation_2(std::shared_ptr<const Influence_search_2> search, const Mls_options& options)
    : m_search(std::move(search)), m_options(options)
  {
    if (m_search->size() == 0)
      throw std::invalid_argument("Bubble_relaxation_2: parameter influence has no nodes");
  }

  Influence_query_2 query() const { return Influence_query_2(m_search); }

  /// \throws Deficient_support_error_2
  void find_shapes(const Point& p, int number_of_derivatives, Influence_query_2& query, Mls_shapes_2& result) const
  {
    check_point(p.x(), p.y());
    check_number_of_derivatives(number_of_derivatives);
    Mls_fitting_2 fitting(*m_search, m_options, query, result);
    if (!fitting.fit(p, number_of_derivatives))
      throw fitting.error(p, fitting.sufficient_enlargement(p, 1), 1);
  }

  template <class Coefficients>
  double value(const Point& p, const Coefficients& coefficients) const
  {
    const Mls_shapes_2 shapes = shapes_for(p, 0, coefficients.size());
    return sum_of_shapes(shapes.nodes, shapes.values, coefficients);
  }

  template <class Vector_2, class Coefficients>
  Vector_2 gradient(const Point& p, const Coefficients& coefficients) const
  {
    const Mls_shapes_2 shapes = shapes_for(p, 1, coefficients.size());
    return Vector_2(sum_of_shapes(shapes.nodes, shapes.dx, coefficients),
                    sum_of_shapes(shapes.nodes, shapes.dy, coefficients));
  }

  Mls_values_2 evaluate(const std::vector<Point>& points, const std::vector<double>& coefficients,
                        int number_of_derivatives, const Parallel_loop& parallel) const
  {
    check_number_of_derivatives(number_of_derivatives);
    check_number_of_coefficients(coefficients.size());
    for (const Point& p : points)
      check_point(p.x(), p.y());
    return Mls_evaluation_2(m_search, m_options, points, parallel)(coefficients, number_of_derivatives);
  }

private:
  Mls_shapes_2 shapes_for(const Point& p, int number_of_derivatives, std::size_t number_of_coefficients) const
  {
    check_number_of_coefficients(number_of_coefficients);
    Influence_query_2 q = query();
    Mls_shapes_2 shapes;
    find_shapes(p, number_of_derivatives, q, shapes);
    return shapes;
  }

  static void check_number_of_derivatives(int n)
  {
    if (n < 0 || n > 2)
      throw_invalid_parameter("number_of_derivatives", n, "0, 1 or 2");
  }

  void check_number_of_coefficients(std::size_t n) const
  {
    if (n != m_search->size())
      throw std::invalid_argument("Bubble_relaxation_2: parameter coefficients has " + std::to_string(n) +
                                  " numbers for " + std::to_string(m_search->size()) + " nodes");
  }

  std::shared_ptr<const Influence_search_2> m_search;
  Mls_options m_options;
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_MLS_MLS_EVALUATION_2_H
