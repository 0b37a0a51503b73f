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
#include <CGAL/Bubble_relaxation_2/internal/core/Progress.h>
#include <CGAL/Bubble_relaxation_2/internal/core/vocabulary.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_2.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/outline.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/place_on_edges.h>

#include <CGAL/Kernel/global_functions_2.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <tuple>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// Removes bubbles on edges whose order along them is lost in rounding, or would be: those too near to the last one that is
/// not, or to an end.
inline void remove_crowded_on_edges(const Domain_2& domain, Bubbles_2& b)
{
  constexpr double least_gap = 1e-3; // of the size; simulated bubbles are far above
  const std::vector<std::vector<Index>> on_edge = bubbles_on_edges(domain, b);
  for (std::size_t e = 0; e < on_edge.size(); ++e) {
    double last = 0;
    for (Index i : on_edge[e]) {
      const double gap = least_gap * b.d[i] / domain.length(static_cast<Index>(e));
      if (b.s[i] - last < gap || 1 - b.s[i] < gap)
        b.remove(i);
      else
        last = b.s[i];
    }
  }
}

/// Removes bubbles of an edge until a point beside it is on the same side of the piece between the two bubbles
/// next to it as of the whole edge.
inline void keep_side_of_edge(const Domain_2& domain, Index e, std::vector<Index>& on_edge, const Point& p,
                              Bubbles_2& b)
{
  const Orientation side = CGAL::orientation(domain.source(e), domain.target(e), p);
  const double s = position_on_edge(domain, e, p);
  while (side != COLLINEAR && !on_edge.empty()) {
    const auto after = std::find_if(on_edge.begin(), on_edge.end(), [&](Index i) { return b.s[i] > s; });
    const bool is_first = after == on_edge.begin(), is_last = after == on_edge.end();
    const Point source = is_first ? domain.source(e) : b.point(*std::prev(after)),
                target = is_last ? domain.target(e) : b.point(*after);
    if (CGAL::orientation(source, target, p) == side)
      return;
    const bool goes_before = is_last || (!is_first && s - b.s[*std::prev(after)] <= b.s[*after] - s);
    const auto nearer = goes_before ? std::prev(after) : after;
    b.remove(*nearer);
    on_edge.erase(nearer);
  }
}

/// Removes bubbles on edges that, by their own rounding, put a pinned vertex on the other side of its edge and so out
/// of the domain.
inline void remove_beside_pins(const Domain_2& domain, Bubbles_2& b)
{
  std::vector<std::vector<Index>> on_edge;
  Index hint = 0;
  for (std::size_t i = 0; i < b.size(); ++i) {
    if (!b.is_corner(i) || b.host[i] != no_index)
      continue;
    if (on_edge.empty())
      on_edge = bubbles_on_edges(domain, b);
    const Point p = b.point(i);
    const Index t = domain.locate_inside(p, hint);
    for (int k = 0; t != no_index && k < 3; ++k) {
      const Index e = domain.edge(t, k);
      if (e != no_index)
        keep_side_of_edge(domain, e, on_edge[static_cast<std::size_t>(e)], p, b);
    }
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
    tick(i);
    if (is_taken[hash(i)])
      is_taken_twice[hash(i)] = true;
    is_taken[hash(i)] = true;
  }
  return indices_where(b.size(), [&](std::size_t i) {
    tick(i);
    return is_taken_twice[hash(i)] && !b.is_gone(i);
  });
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

/// Removes bubbles on edges that would confuse the triangulation.
inline void remove_confusing_on_edges(const Domain_2& domain, Bubbles_2& b)
{
  remove_crowded_on_edges(domain, b);
  remove_beside_pins(domain, b);
}

/// Removes bubbles that cannot be told apart in the triangulation, or would confuse it.
inline void remove_coincident(const Domain_2& domain, Bubbles_2& b)
{
  remove_confusing_on_edges(domain, b);
  remove_those_in_one_place(b);
  b.forget_gone();
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DOMAIN_REMOVE_COINCIDENT_H
