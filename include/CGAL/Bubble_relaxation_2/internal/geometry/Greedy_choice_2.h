// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_GEOMETRY_GREEDY_CHOICE_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_GEOMETRY_GREEDY_CHOICE_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/parallel_for.h>
#include <CGAL/Bubble_relaxation_2/internal/core/sort_indices.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Bubble_buckets_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Flat_triangulation_2.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// a place for a bubble, of which the one with the least rank is the best
struct Greedy_candidate_2
{
  double rank, x, y, d;

  bool operator<(const Greedy_candidate_2& c) const { return std::tie(rank, x, y) < std::tie(c.rank, c.x, c.y); }
};

/// Chooses from candidates the best first, as long as they do not come too near to a better one that was chosen.
/// Who stands in whose way is found once, so that the choice can be made again when some of it is made elsewhere.
class Greedy_choice_2
{
public:
  /// starts anew. Two candidates nearer than `reach` times their mean size stand in each other's way; those for
  /// which `is_possible(candidate)` does not hold are not chosen. `origin`: any point near them.
  template <class Is_possible>
  void assign(const std::vector<Greedy_candidate_2>& candidates, double reach, double unit, const Point& origin,
              const Threads& threads, const Is_possible& is_possible)
  {
    const std::size_t n = candidates.size();
    m_order.resize(n);
    for (std::size_t k = 0; k < n; ++k)
      m_order[k] = static_cast<Index>(k);
    sort_indices(m_order, [&candidates](Index a, Index b) { return candidates[a] < candidates[b]; });
    m_is_possible.resize(n);
    m_is_chosen.assign(n, 0);
    m_rivals.resize((std::max)(m_rivals.size(), n));
    parallel_for(
      threads, n, [&](std::size_t k) { m_is_possible[k] = is_possible(static_cast<Index>(k)); }, grain);
    find_rivals(candidates, reach, unit, origin, threads);
  }

  /// decides on those for which `is_ours(candidate)` holds; what is decided of others stays
  template <class Is_ours>
  void decide(const Is_ours& is_ours)
  {
    for (Index c : m_order)
      if (is_ours(c))
        m_is_chosen[c] = m_is_possible[c] && std::none_of(m_rivals[c].begin(), m_rivals[c].end(), [this](Index r) {
          return m_is_chosen[r] != 0;
        });
  }

  void decide()
  {
    decide([](Index) { return true; });
  }

  bool is_chosen(std::size_t candidate) const { return m_is_chosen[candidate] != 0; }
  void set_chosen(std::size_t candidate, bool value) { m_is_chosen[candidate] = value; }

  /// calls `visit(candidate)` for all chosen, the best first
  template <class Visitor>
  void for_each_chosen(const Visitor& visit) const
  {
    for (Index c : m_order)
      if (m_is_chosen[c])
        visit(c);
  }

private:
  using Rivals = boost::container::small_vector<Index, 6>;

  static constexpr std::size_t grain = 64;

  /// of each candidate the better ones that stand in its way
  void find_rivals(const std::vector<Greedy_candidate_2>& candidates, double reach, double unit, const Point& origin,
                   const Threads& threads)
  {
    Bubble_buckets_2 near(reach, unit, origin.x(), origin.y(), candidates.size());
    for (std::size_t k = 0; k < candidates.size(); ++k)
      if (m_is_possible[k])
        near.insert(static_cast<Index>(k), candidates[k].x, candidates[k].y, candidates[k].d);
    parallel_for(
      threads, candidates.size(),
      [&](std::size_t k) {
        m_rivals[k].clear();
        const Greedy_candidate_2& c = candidates[k];
        if (m_is_possible[k])
          near.for_each_near(c.x, c.y, c.d, [&](Index r, double, double) {
            if (candidates[r] < c)
              m_rivals[k].push_back(r);
            return true;
          });
      },
      grain);
  }

  std::vector<Index> m_order; // the best first
  std::vector<char> m_is_possible, m_is_chosen;
  std::vector<Rivals> m_rivals;
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_GEOMETRY_GREEDY_CHOICE_2_H
