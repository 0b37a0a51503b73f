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
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

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
  friend class Mls_approximation_2;
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
    if (!fit(p, number_of_derivatives, query, result))
      throw error(p, sufficient_enlargement(p, 1, query, result), 1);
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

  /// Evaluates at many points, in blocks that several threads may compute.
  /// \throws Deficient_support_error_2 about the first point that has no value
  Mls_values_2 evaluate(const std::vector<Point>& points, const std::vector<double>& coefficients,
                        int number_of_derivatives, const Threads& threads) const
  {
    check_number_of_derivatives(number_of_derivatives);
    check_number_of_coefficients(coefficients.size());
    for (const Point& p : points)
      check_point(p.x(), p.y());
    Mls_values_2 result;
    result.values.resize(points.size());
    for (auto* array : {&result.dx, &result.dy})
      array->resize(number_of_derivatives > 0 ? points.size() : 0);
    for (auto* array : {&result.dxx, &result.dxy, &result.dyy})
      array->resize(number_of_derivatives > 1 ? points.size() : 0);
    std::vector<Block> blocks((points.size() + block_size - 1) / block_size);
    const auto evaluate_one = [&](std::size_t b) {
      blocks[b] = evaluate_block(points, b, coefficients, number_of_derivatives, result);
    };
    parallel_for(threads, blocks.size(), evaluate_one, 1);
    std::size_t number_of_deficient = 0, first_deficient = points.size();
    for (const Block& b : blocks) {
      result.number_of_enlarged_supports += b.number_of_enlarged;
      result.largest_enlargement = (std::max)(result.largest_enlargement, b.largest_enlargement);
      number_of_deficient += b.number_of_deficient;
      first_deficient = (std::min)(first_deficient, b.first_deficient);
    }
    if (number_of_deficient > 0)
      throw error(points[first_deficient], sufficient_enlargement(points, threads), number_of_deficient);
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
    std::size_t first_deficient = static_cast<std::size_t>(-1);
  };

  /// returns whether there are shape functions at `p`, after all that may be done for it, and sets them if so
  bool fit(const Point& p, int number_of_derivatives, Influence_query_2& query, Mls_shapes_2& shapes) const
  {
    if (!suffices(p, number_of_derivatives, 1, query, shapes) &&
        m_options.deficient_support != Deficient_support::PSEUDO_INVERSE &&
        !(m_options.deficient_support == Deficient_support::ENLARGE &&
          enlarge(p, number_of_derivatives, query, shapes)))
      return false;
    shapes.m_fit.write(number_of_derivatives, shapes);
    return true;
  }

  /// returns whether the nodes at `p` do, with supports that are so much larger
  bool suffices(const Point& p, int number_of_derivatives, double enlargement, Influence_query_2& query,
                Mls_shapes_2& shapes) const
  {
    shapes.enlargement = enlargement;
    query(p.x(), p.y(), enlargement, shapes.nodes);
    shapes.m_fit.gather(*m_search, p, shapes.nodes, enlargement);
    const bool result = shapes.m_fit.solve(m_options, number_of_derivatives);
    shapes.condition_number = shapes.m_fit.condition_number();
    return result;
  }

  /// Enlarges the supports until the nodes suffice. Once they have all nodes, twice as far from their rims than
  /// when they had just got them, there is nothing to gain: weights hardly differ, and only lengths in units
  /// of the radii go on to shrink. From 1e15 radii away nodes cannot be told from each other.
  bool enlarge(const Point& p, int number_of_derivatives, Influence_query_2& query, Mls_shapes_2& shapes) const
  {
    int steps_with_all_nodes = 0;
    while (steps_with_all_nodes < 8 && shapes.enlargement < 1e15) {
      if (suffices(p, number_of_derivatives, 1.1 * shapes.enlargement, query, shapes))
        return true;
      if (shapes.nodes.size() == m_search->size())
        ++steps_with_all_nodes;
    }
    return false;
  }

  /// what supports times `enlargement` have to be multiplied by further, 1.1 again and again, until the nodes at
  /// `p` suffice; 0 if that does not help
  double sufficient_enlargement(const Point& p, double enlargement, Influence_query_2& query,
                                Mls_shapes_2& shapes) const
  {
    return suffices(p, 0, enlargement, query, shapes) || enlarge(p, 0, query, shapes) ? shapes.enlargement : 0;
  }

  /// The least power of 1.1 found that does at all points; 0 if there is none. Larger radii may also spoil the
  /// fit at a point, where two or three nodes get close in units of them before others are met: so all points are
  /// looked at again after each enlargement, until nothing changes.
  double sufficient_enlargement(const std::vector<Point>& points, const Threads& threads) const
  {
    std::vector<double> largest((points.size() + block_size - 1) / block_size);
    for (double enlargement = 1;;) {
      const auto find_largest = [&](std::size_t b) {
        Influence_query_2 q = query();
        Mls_shapes_2 shapes;
        largest[b] = enlargement;
        for (std::size_t i = b * block_size; i < end_of_block(points, b) && largest[b] > 0; ++i) {
          const double e = sufficient_enlargement(points[i], enlargement, q, shapes);
          largest[b] = e > 0 ? (std::max)(largest[b], e) : 0;
        }
      };
      parallel_for(threads, largest.size(), find_largest, 1);
      if (std::find(largest.begin(), largest.end(), 0.) != largest.end())
        return 0;
      const double next = *std::max_element(largest.begin(), largest.end());
      if (!(next > enlargement))
        return enlargement;
      enlargement = next;
    }
  }

  /// that the nodes do not suffice at `p`, the first of so many points, for all of which `enlargement` would do
  Deficient_support_error_2 error(const Point& p, double enlargement, std::size_t number_of_points) const
  {
    Influence_query_2 q = query();
    Mls_shapes_2 shapes;
    suffices(p, 0, 1, q, shapes);
    return Deficient_support_error_2(p.x(), p.y(), shapes.nodes.size(), shapes.condition_number,
                                     m_options.maximum_condition_number, enlargement, number_of_points);
  }

  static std::size_t end_of_block(const std::vector<Point>& points, std::size_t b)
  {
    return (std::min)(points.size(), (b + 1) * block_size);
  }

  Block evaluate_block(const std::vector<Point>& points, std::size_t b, const std::vector<double>& coefficients,
                       int number_of_derivatives, Mls_values_2& result) const
  {
    constexpr std::vector<double> Mls_values_2::*out[] = {&Mls_values_2::values, &Mls_values_2::dx,
      &Mls_values_2::dy, &Mls_values_2::dxx, &Mls_values_2::dxy, &Mls_values_2::dyy};
    constexpr std::vector<double> Mls_shapes_2::*in[] = {&Mls_shapes_2::values, &Mls_shapes_2::dx,
      &Mls_shapes_2::dy, &Mls_shapes_2::dxx, &Mls_shapes_2::dxy, &Mls_shapes_2::dyy};
    Block block;
    Influence_query_2 q = query();
    Mls_shapes_2 shapes;
    for (std::size_t i = b * block_size; i < end_of_block(points, b); ++i) {
      if (!fit(points[i], number_of_derivatives, q, shapes)) {
        block.first_deficient = (std::min)(block.first_deficient, i);
        ++block.number_of_deficient;
        continue;
      }
      block.number_of_enlarged += shapes.enlargement > 1;
      block.largest_enlargement = (std::max)(block.largest_enlargement, shapes.enlargement);
      for (std::size_t k = 0; k < 6; ++k)
        if (!(result.*out[k]).empty())
          (result.*out[k])[i] = sum_of_shapes(shapes.nodes, shapes.*in[k], coefficients);
    }
    return block;
  }

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

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_MLS_MLS_EVALUATION_2_H
