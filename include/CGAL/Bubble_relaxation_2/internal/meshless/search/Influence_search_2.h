// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_SEARCH_INFLUENCE_SEARCH_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_SEARCH_INFLUENCE_SEARCH_2_H

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
#include <utility>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

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

  explicit Influence_search_2(std::vector<Influence_disc_2> discs)
    : m_scale(scale_of(discs)), m_unit(1 / m_scale), m_discs(scaled(std::move(discs), m_scale)), m_lists(m_discs)
  {}

  // the parts point to the discs
  Influence_search_2(const Influence_search_2&) = delete;
  Influence_search_2& operator=(const Influence_search_2&) = delete;

  void use_neighbors(std::vector<std::size_t> offsets, std::vector<std::int32_t> neighbors)
  {
    m_expansion =
      std::make_unique<Neighbor_expansion_2>(m_discs, buckets(), std::move(offsets), std::move(neighbors));
  }

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
    if (factor <= 1)
      m_lists.find(m_discs, x, y, factor, result);
    else
      find_in_enlarged(x, y, factor, result);
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
  void find_in_enlarged(double x, double y, double factor, std::vector<std::int32_t>& result) const
  {
    result.clear();
    buckets().for_each(x, y, factor, [&result](std::int32_t i) { result.push_back(i); });
    std::sort(result.begin(), result.end());
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

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_SEARCH_INFLUENCE_SEARCH_2_H
