// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_SEARCH_INFLUENCE_SEARCH_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_SEARCH_INFLUENCE_SEARCH_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/in_words.h>
#include <CGAL/Bubble_relaxation_2/internal/meshless/search/Disc_lists_2.h>
#include <CGAL/Bubble_relaxation_2/internal/meshless/search/Influence_disc_2.h>
#include <CGAL/Bubble_relaxation_2/internal/meshless/search/Neighbor_expansion_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// \throws std::invalid_argument if a coordinate of a point that is asked for is not finite
inline void check_point(double x, double y)
{
  if (!std::isfinite(x) || !std::isfinite(y))
    throw std::invalid_argument("Bubble_relaxation_2: parameter p = " + in_words(x, y) + " must be finite");
}

/// \throws std::invalid_argument unless `parameter` tells for each of `n` nodes a positive number, such as its `what`
inline void check_numbers(const std::string& parameter, const std::string& what, const std::vector<double>& numbers,
                          std::size_t n)
{
  const std::string start = "Bubble_relaxation_2: parameter " + parameter;
  if (numbers.size() != n)
    throw std::invalid_argument(start + " has " + std::to_string(numbers.size()) + " numbers for " +
                                std::to_string(n) + " nodes");
  for (std::size_t i = 0; i < n; ++i)
    if (!(numbers[i] > 0) || !std::isfinite(numbers[i]))
      throw std::invalid_argument(start + ": the " + what + " " + in_words(numbers[i]) + " of node " +
                                  std::to_string(i) + " must be positive and finite");
}

/// All ways to search influence domains. Coordinates are multiplied with a power of two, so that those of tiny or
/// huge domains have squares; this rounds nothing.
class Influence_search_2
{
public:
  /// what a thread keeps from query to query
  struct State
  {
    Neighbor_expansion_2::State expansion;
    std::size_t number_of_fallbacks = 0;
  };

  /// \throws std::invalid_argument, std::length_error if the discs cannot be searched
  explicit Influence_search_2(std::vector<Influence_disc_2> discs)
    : m_scale((check(discs), scale_of(discs))), m_unit(1 / m_scale),
      m_discs(scaled(std::move(discs), m_scale)), m_lists(m_discs)
  {}

  // the parts point to the discs
  Influence_search_2(const Influence_search_2&) = delete;
  Influence_search_2& operator=(const Influence_search_2&) = delete;

  void use_neighbors(std::vector<std::size_t> offsets, std::vector<std::int32_t> neighbors)
  {
    m_expansion =
      std::make_unique<Neighbor_expansion_2>(m_discs, buckets(), std::move(offsets), std::move(neighbors));
  }

  std::size_t size() const { return m_discs.size(); }

  /// As it was given: powers of two change no digit, unless a number is 10^300 times less than the largest, which
  /// no search can tell from zero.
  Influence_disc_2 disc(std::size_t i) const
  {
    const Influence_disc_2& d = m_discs[i];
    return Influence_disc_2{m_unit * d.x, m_unit * d.y, m_unit * d.radius};
  }

  bool is_expansion_complete() const { return m_expansion && m_expansion->number_of_obstructed_nodes() == 0; }

  /// finds the discs that contain a point, in ascending order
  void find(double x, double y, double factor, State& state, std::vector<std::int32_t>& result) const
  {
    x *= m_scale;
    y *= m_scale;
    if (m_expansion) {
      if (m_expansion->search(x, y, factor, state.expansion, result))
        return;
      ++state.number_of_fallbacks;
    }
    find_scaled(x, y, factor, result);
  }

  /// the same without a query before or after it: what an expansion needs takes longer to make
  void find_once(double x, double y, double factor, std::vector<std::int32_t>& result) const
  {
    find_scaled(x * m_scale, y * m_scale, factor, result);
  }

  std::int32_t nearest(double x, double y) const
  {
    x *= m_scale;
    y *= m_scale;
    double squared = std::numeric_limits<double>::infinity();
    m_lists.for_each_candidate(x, y, [&](std::int32_t i) {
      squared = (std::min)(squared, m_discs[static_cast<std::size_t>(i)].squared_distance(x, y));
    });
    return buckets().nearest(x, y, std::isfinite(squared) ? std::sqrt(squared) : 0);
  }

private:
  void find_scaled(double x, double y, double factor, std::vector<std::int32_t>& result) const
  {
    if (factor <= 1) {
      m_lists.find(m_discs, x, y, factor, result);
      return;
    }
    result.clear();
    buckets().for_each(x, y, factor, [&result](std::int32_t i) { result.push_back(i); });
    std::sort(result.begin(), result.end());
  }

  static void check(const std::vector<Influence_disc_2>& discs)
  {
    if (discs.size() > static_cast<std::size_t>((std::numeric_limits<Index>::max)()))
      throw std::length_error("Bubble_relaxation_2: " + std::to_string(discs.size()) +
                              " nodes are more than their indices can number");
    for (std::size_t i = 0; i < discs.size(); ++i)
      if (!std::isfinite(discs[i].x) || !std::isfinite(discs[i].y))
        throw std::invalid_argument("Bubble_relaxation_2: parameter points: node " + std::to_string(i) + " at " +
                                    in_words(discs[i].x, discs[i].y) + " must be finite");
    check_extent(discs);
  }

  /// In `double` places are not told apart, and squares have no value, where some discs are far too large for others
  /// or too far away from them.
  static void check_extent(const std::vector<Influence_disc_2>& discs)
  {
    constexpr double most_radii = 1e15, largest = 1e153;
    std::vector<double> radii;
    std::size_t farthest = 0;
    double extent = 0;
    for (std::size_t i = 0; i < discs.size(); ++i) {
      const double dx = std::abs(discs[i].x - discs[0].x), dy = std::abs(discs[i].y - discs[0].y);
      const double reach = (std::max)(dx, dy) + discs[i].radius;
      farthest = reach > extent ? i : farthest;
      extent = (std::max)(extent, reach);
      radii.push_back(discs[i].radius);
    }
    const auto middle = radii.begin() + static_cast<std::ptrdiff_t>(radii.size() / 2);
    std::nth_element(radii.begin(), middle, radii.end());
    if (!radii.empty() && !(extent <= most_radii * *middle && extent <= largest))
      throw std::invalid_argument("Bubble_relaxation_2: the influence domain of node " + std::to_string(farthest) +
                                  " at " + in_words(discs[farthest].x, discs[farthest].y) + ", of radius " +
                                  in_words(discs[farthest].radius) + ", reaches " + in_words(extent) +
                                  " from the first node, which must be at most 1e15 times the median radius, " +
                                  in_words(*middle) + ", and at most 1e153");
  }

  static double scale_of(const std::vector<Influence_disc_2>& discs)
  {
    double largest = 0;
    for (const Influence_disc_2& d : discs)
      largest = (std::max)({largest, std::abs(d.x), std::abs(d.y), d.radius});
    int exponent = 0;
    std::frexp(largest, &exponent);
    return std::ldexp(1., -(std::max)((std::min)(exponent, 1000), -1000));
  }

  static std::vector<Influence_disc_2> scaled(std::vector<Influence_disc_2> discs, double scale)
  {
    for (Influence_disc_2& d : discs)
      d = Influence_disc_2{scale * d.x, scale * d.y, scale * d.radius};
    return discs;
  }

  /// many never need them
  const Node_buckets_2& buckets() const
  {
    std::call_once(m_once, [this] { m_buckets = std::make_unique<Node_buckets_2>(m_discs); });
    return *m_buckets;
  }

  const double m_scale;
  const double m_unit; // one of the scaled length
  const std::vector<Influence_disc_2> m_discs;
  const Disc_lists_2 m_lists;
  std::unique_ptr<const Neighbor_expansion_2> m_expansion;
  mutable std::once_flag m_once;
  mutable std::unique_ptr<const Node_buckets_2> m_buckets;
};

/// Queries by one thread. It keeps what it searches.
class Influence_query_2
{
public:
  explicit Influence_query_2(std::shared_ptr<const Influence_search_2> search) : m_search(std::move(search)) {}

  void operator()(double x, double y, double factor, std::vector<std::int32_t>& result)
  {
    m_search->find(x, y, factor, m_state, result);
  }

  std::size_t number_of_fallbacks() const { return m_state.number_of_fallbacks; }

private:
  std::shared_ptr<const Influence_search_2> m_search;
  Influence_search_2::State m_state;
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_SEARCH_INFLUENCE_SEARCH_2_H
