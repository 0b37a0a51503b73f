// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DOMAIN_REMOVE_COINCIDENT_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DOMAIN_REMOVE_COINCIDENT_H

#include <CGAL/Bubble_relaxation_2/internal/core/Bubbles_2.h>
#include <CGAL/Bubble_relaxation_2/internal/core/vocabulary.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_2.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/outline.h>

#include <cstddef>
#include <tuple>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// Finds bubbles on an edge whose order along it is lost in rounding, or would be: told of all from source to
/// target, one after the other.
class Crowd_on_edge
{
public:
  explicit Crowd_on_edge(double length) : m_length(length) {}

  /// whether the next bubble, of size `d` at `s`, is too near to the last that is not, or to an end
  bool has(double s, double d)
  {
    constexpr double least_gap = 1e-3; // of the size; simulated bubbles are far above
    const double gap = least_gap * d / m_length;
    if (s - m_last < gap || 1 - s < gap)
      return true;
    m_last = s;
    return false;
  }

private:
  double m_length, m_last = 0;
};

/// Removes bubbles on edges that are crowded.
inline void remove_crowded_on_edges(const Domain_2& domain, Bubbles_2& b)
{
  const std::vector<std::vector<Index>> on_edge = bubbles_on_edges(domain, b);
  for (std::size_t e = 0; e < on_edge.size(); ++e) {
    Crowd_on_edge crowd(domain.length(static_cast<Index>(e)));
    for (Index i : on_edge[e])
      if (crowd.has(b.s[i], b.d[i]))
        b.remove(i);
  }
}

/// The bubbles that may be in one place with another: few, if no two are.
inline std::vector<Index> perhaps_in_one_place(const Bubbles_2& b)
{
  int bits = 16; // of the hash
  while (bits < 40 && std::size_t(1) << bits < 16 * b.size())
    ++bits;
  std::vector<bool> is_taken(std::size_t(1) << bits), is_taken_twice(is_taken.size());
  const auto hash = [&](std::size_t i) { return hash_of_place(b.x[i], b.y[i]) >> (64 - bits); };
  for (std::size_t i = 0; i < b.size(); ++i) {
    if (is_taken[hash(i)])
      is_taken_twice[hash(i)] = true;
    is_taken[hash(i)] = true;
  }
  std::vector<Index> result;
  for (std::size_t i = 0; i < b.size(); ++i)
    if (is_taken_twice[hash(i)] && !b.is_gone(i))
      result.push_back(static_cast<Index>(i));
  return result;
}

/// Of bubbles in one place removes all but one of the lowest dimension.
inline void remove_those_in_one_place(Bubbles_2& b)
{
  std::vector<Index> those = perhaps_in_one_place(b);
  sort_indices(those, [&b](Index i, Index j) {
    return std::tie(b.x[i], b.y[i], b.dimension[i], i) < std::tie(b.x[j], b.y[j], b.dimension[j], j);
  });
  std::size_t last = 0;
  for (std::size_t k = 1; k < those.size(); ++k)
    if (b.x[those[k]] == b.x[those[last]] && b.y[those[k]] == b.y[those[last]])
      b.remove(those[k]);
    else
      last = k;
}

/// Removes bubbles that cannot be told apart in the triangulation: those above.
inline void remove_coincident(const Domain_2& domain, Bubbles_2& b)
{
  remove_crowded_on_edges(domain, b);
  remove_those_in_one_place(b);
  b.forget_gone();
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DOMAIN_REMOVE_COINCIDENT_H
