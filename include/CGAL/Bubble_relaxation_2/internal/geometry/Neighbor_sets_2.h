// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_GEOMETRY_NEIGHBOR_SETS_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_GEOMETRY_NEIGHBOR_SETS_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/Bubbles_2.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Progress.h>
#include <CGAL/Bubble_relaxation_2/internal/core/parallel_for.h>
#include <CGAL/Bubble_relaxation_2/internal/core/vocabulary.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Bubble_buckets_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Index_sets.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Neighbor_search_2.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// where bubbles were, and how large, when their neighbours were last looked for
struct Bubble_references_2
{
  const std::vector<double>&x, &y, &d;
};

/// The neighbour sets of section 2.1.3 of the paper (Verlet lists): for each bubble all others nearer
/// than `radius` times the mean of the two sizes, sorted by index.
///
/// Distances and sizes are those of the references: each bubble has one, what it was at its last
/// renewal. With a force that ends at 1.5 d, a set of radius r misses no interacting pair while each
/// bubble i keeps  moved_i + 0.75 (d_i - d_i at its reference) <= (r - 1.5) / 2 * d_i at its reference:
/// the references of a pair outside the sets are at least r (d_i + d_j) / 2 apart, and the sum of both
/// inequalities leaves 1.5 times the mean of the present sizes. So a bubble that has used up its skin
/// can be renewed alone.
class Neighbor_sets_2
{
  /// `is_before()` as a function object
  auto order() const { return [this](Index i, Index j) { return is_before(i, j); }; }

public:
  /// the radius of sets that miss nothing as long as nothing moves: where the force ends
  static constexpr double without_skin = 1.5;

  explicit Neighbor_sets_2(double radius) : m_radius(radius) {}

  double radius() const { return m_radius; }
  std::size_t number_of_bubbles() const { return m_sets.size(); }

  const Index* begin(std::size_t i) const { return m_sets.begin(i); }
  const Index* end(std::size_t i) const { return m_sets.end(i); }

  /// the order of sets: that of all bubbles, of which these may be a part
  bool is_before(Index i, Index j) const
  {
    return m_numbers->empty() ? i < j : (*m_numbers)[i] < (*m_numbers)[j];
  }

  /// finds all neighbours anew with buckets
  void build(const Bubbles_2& bubbles, const Threads& threads = Threads())
  {
    build(bubbles, Bubble_references_2{bubbles.x, bubbles.y, bubbles.d}, threads);
  }

  /// the same, by references that the bubbles have already
  void build(const Bubbles_2& bubbles, const Bubble_references_2& references, const Threads& threads)
  {
    start(bubbles, references);
    const std::size_t n = bubbles.size();
    m_buckets.reset(); // what is in them may be gone
    if (n == 0)
      return;
    m_buckets = std::make_unique<Bubble_buckets_2>(m_radius, m_d[0], m_x[0], m_y[0], n + n / 8);
    for (std::size_t i = 0; i < n; ++i) {
      tick(i);
      m_buckets->insert(static_cast<Index>(i), m_x[i], m_y[i], m_d[i]);
    }
    for (std::size_t i = 0; i < n; ++i)
      if (bubbles.is_gone(i))
        m_buckets->erase(i);
    // not all at once: that would take as much memory as the sets
    std::vector<Neighbor_block> blocks((std::max)(least_blocks_at_once, n / block_size / 32));
    const Neighbor_search_2 find(*m_buckets, m_x, m_y, m_d, m_radius);
    for (std::size_t first = 0; first < n; first += blocks.size() * block_size) {
      parallel_for(
        threads, blocks.size(),
        [&](std::size_t k) {
          const std::size_t start = (std::min)(first + k * block_size, n), end = (std::min)(start + block_size, n);
          find_block(bubbles, find, start, end, blocks[k]);
        },
        1);
      for (const Neighbor_block& block : blocks)
        append(block);
    }
  }

  /// makes room for `n` more bubbles
  void make_room_for(std::size_t n)
  {
    for (std::vector<double>* a : {&m_x, &m_y, &m_d})
      internal::make_room_for(n, *a);
    m_sets.make_room_for(n);
  }

  /// takes bubble `i` out of all sets
  void remove(Index i)
  {
    for (const Index *j = begin(i), *last = end(i); j != last; ++j)
      m_sets.erase(*j, i, order());
    m_sets.clear(i);
    if (m_buckets)
      m_buckets->erase(i);
  }

  /// makes the set of a bubble that was added to `bubbles` after the last, and puts it into those of its
  /// neighbours; after `renew_from_neighbors()` it stays empty until the next `build()`
  void add(const Bubbles_2& bubbles, Index i) { add(i, bubbles.x[i], bubbles.y[i], bubbles.d[i]); }

  /// the same, by its reference
  void add(Index i, double x, double y, double d)
  {
    m_x.push_back(x);
    m_y.push_back(y);
    m_d.push_back(d);
    m_sets.append(nullptr, 0);
    if (m_sets.size() == 1) // a rank may begin with none
      m_buckets = std::make_unique<Bubble_buckets_2>(m_radius, d, x, y, 1);
    if (!m_buckets)
      return;
    m_buckets->insert(i, x, y, d);
    find_neighbors(i, m_found);
    replace(i, m_found);
  }

  double reference_x(std::size_t i) const { return m_x[i]; }
  double reference_y(std::size_t i) const { return m_y[i]; }
  double reference_d(std::size_t i) const { return m_d[i]; }

  /// renews the bubbles that have used up their skin, in the sets of their neighbours too
  /// \pre the sets were made by `build()` from as many bubbles
  void renew(const Bubbles_2& bubbles, const std::vector<Index>& outrun, const Threads& threads = Threads())
  {
    for (Index i : outrun) {
      m_x[i] = bubbles.x[i];
      m_y[i] = bubbles.y[i];
      m_d[i] = bubbles.d[i];
      m_buckets->move(i, m_x[i], m_y[i], m_d[i]);
    }
    m_new_sets.resize((std::min)(outrun.size(), renewed_at_once));
    for (std::size_t first = 0; first < outrun.size(); first += renewed_at_once) {
      const std::size_t n = (std::min)(outrun.size() - first, renewed_at_once);
      parallel_for(threads, n, [&](std::size_t k) { find_neighbors(outrun[first + k], m_new_sets[k]); }, 64);
      for (std::size_t k = 0; k < n; ++k)
        replace(outrun[first + k], m_new_sets[k]);
    }
  }

  /// The paper's renewal of all sets: neighbours and their neighbours, as far as they are within the radius now.
  /// Those that have gone farther apart than three sizes do not tell of their neighbours. Of several ranks each
  /// renews the sets of its own bubbles, and puts these into the sets of others'.
  /// \pre sets of others' bubbles near ours have those of their neighbours that are near ours too
  void renew_from_neighbors(const Bubbles_2& bubbles)
  {
    const Index_sets old_sets = std::exchange(m_sets, Index_sets());
    start(bubbles, Bubble_references_2{bubbles.x, bubbles.y, bubbles.d});
    const std::size_t n = bubbles.size();
    const double farthest = (std::max)(m_radius, 3.);
    const auto is_near = [&bubbles](Index i, Index j, double times) {
      const double reach = 0.5 * times * (bubbles.d[i] + bubbles.d[j]);
      const double dx = bubbles.x[j] - bubbles.x[i], dy = bubbles.y[j] - bubbles.y[i];
      return dx * dx + dy * dy < reach * reach;
    };
    std::vector<std::size_t> seen_by(n, n);
    for (std::size_t k = 0; k < n; ++k) {
      const Index i = static_cast<Index>(k);
      seen_by[k] = k;
      m_found.clear();
      const auto consider = [&](Index j) {
        seen_by[j] = k;
        if (is_near(i, j, m_radius))
          m_found.push_back(j);
      };
      for (const Index *j = old_sets.begin(k), *end = old_sets.end(k); bubbles.is_ours(k) && j != end; ++j) {
        if (seen_by[*j] != k)
          consider(*j);
        if (is_near(i, *j, farthest))
          for (const Index *l = old_sets.begin(*j), *last = old_sets.end(*j); l != last; ++l)
            if (seen_by[*l] != k && is_near(*j, *l, farthest)) // most have been seen
              consider(*l);
      }
      std::sort(m_found.begin(), m_found.end(), order());
      m_sets.append(m_found.data(), m_found.size());
    }
    m_buckets.reset(); // their bubbles are not where they were
    tell_others(bubbles);
  }

  /// replaces the set of a bubble of another rank by what that rank tells of it
  void assign(Index i, const std::vector<Index>& set) { m_sets.assign(i, set); }

  /// Replaces all sets: those of the bubbles of this rank are as `set_of(i)` tells, and those of others' have them.
  template <class Set_of>
  void assign_all(const Bubbles_2& bubbles, const Set_of& set_of)
  {
    for (std::size_t i = 0; i < bubbles.size(); ++i)
      assign(static_cast<Index>(i), bubbles.is_ours(i) ? set_of(static_cast<Index>(i)) : std::vector<Index>());
    m_buckets.reset();
    tell_others(bubbles);
  }

  /// calls `visit(j)` for all bubbles j whose distance from bubble `i` is less than the radius times the mean of
  /// `times` its size and that of j, by references
  template <class Visitor>
  void find_around(Index i, double times, const Visitor& visit) const
  {
    find_around(m_x[i], m_y[i], times * m_d[i], [&](Index j) {
      if (j != i)
        visit(j);
    });
  }

  /// the same around any place, for a size `d`
  template <class Visitor>
  void find_around(double x, double y, double d, const Visitor& visit) const
  {
    m_buckets->for_each_near(x, y, d, [&](Index j, double, double) {
      visit(j);
      return true;
    });
  }

  /// calls `visit(j)` for all bubbles j within `near` times `d` of (x, y), and perhaps for some beyond
  template <class Visitor>
  void find_within(double x, double y, double d, double near, const Visitor& visit) const
  {
    if (m_sets.size() == 0)
      return;
    m_buckets->for_each_within(x, y, (near + m_radius - without_skin) * d, visitor(visit));
  }

  /// the same for those whose distance from (x, y) is less than `near` times their size, if that is `least` or more
  template <class Visitor>
  void find_large(double x, double y, double least, double near, const Visitor& visit) const
  {
    if (m_sets.size() == 0)
      return;
    const double most_grown = m_radius / without_skin; // from the reference, until the skin is used up
    m_buckets->for_each_large(x, y, least / most_grown, near * most_grown, visitor(visit));
  }

  /// whether bubble `i` has used up its share of the skin, see above
  bool is_outrun_by(const Bubbles_2& bubbles, std::size_t i) const
  {
    const double dx = bubbles.x[i] - m_x[i], dy = bubbles.y[i] - m_y[i];
    const double left = 0.5 * (m_radius - without_skin) * m_d[i] - 0.75 * (bubbles.d[i] - m_d[i]);
    return left < 0 || dx * dx + dy * dy > left * left;
  }

private:
  template <class Visitor>
  static auto visitor(const Visitor& visit)
  {
    return [&visit](const Bubble_buckets_2::Entry& e, double) {
      visit(e.id);
      return true;
    };
  }

  /// puts the bubbles of this rank into the sets of their neighbours that others own, which are empty
  void tell_others(const Bubbles_2& bubbles)
  {
    if (bubbles.owner.empty())
      return;
    for (std::size_t i = 0; i < bubbles.size(); ++i)
      for (std::size_t k = 0; bubbles.is_ours(i) && k < m_sets.size_of(i); ++k) {
        const Index j = begin(i)[k];
        if (!bubbles.is_ours(j))
          m_sets.insert(j, static_cast<Index>(i), order());
      }
  }

  void start(const Bubbles_2& bubbles, const Bubble_references_2& references)
  {
    const std::size_t n = bubbles.size() + bubbles.size() / 8; // with those that will be added
    m_sets.start(n);
    m_numbers = &bubbles.id;
    copy_in_turn(references.x, m_x, n);
    copy_in_turn(references.y, m_y, n);
    copy_in_turn(references.d, m_d, n);
  }

  static constexpr std::size_t block_size = Neighbor_search_2::block_size, least_blocks_at_once = 32,
                               renewed_at_once = 8192;

  void find_block(const Bubbles_2& bubbles, const Neighbor_search_2& find, std::size_t first, std::size_t last,
                  Neighbor_block& block) const
  {
    const auto is_gone = [&bubbles](std::size_t i) { return bubbles.is_gone(i); };
    if (m_numbers->empty())
      find(first, last, is_gone, std::less<Index>(), block);
    else
      find(first, last, is_gone, order(), block);
  }

  /// the neighbours of bubble `i` by references, sorted
  void find_neighbors(std::size_t i, std::vector<Index>& found) const
  {
    found.clear();
    Neighbor_search_2(*m_buckets, m_x, m_y, m_d, m_radius).find_neighbors(i, found);
    if (m_numbers->empty())
      std::sort(found.begin(), found.end());
    else
      std::sort(found.begin(), found.end(), order());
  }

  void append(const Neighbor_block& block)
  {
    const Index* first = block.found.data();
    for (std::size_t size : block.sizes) {
      m_sets.append(first, size);
      first += size;
    }
  }

  /// makes `found` the set of bubble `i`, and tells the bubbles that are neighbours no more, or newly
  void replace(Index i, const std::vector<Index>& found)
  {
    m_left.clear();
    m_joined.clear();
    if (std::equal(begin(i), end(i), found.begin(), found.end()))
      return;
    std::set_difference(begin(i), end(i), found.begin(), found.end(), std::back_inserter(m_left), order());
    std::set_difference(found.begin(), found.end(), begin(i), end(i), std::back_inserter(m_joined), order());
    for (Index j : m_left)
      m_sets.erase(j, i, order());
    for (Index j : m_joined)
      m_sets.insert(j, i, order());
    m_sets.assign(i, found);
  }

  double m_radius;
  const std::vector<std::int64_t>* m_numbers = nullptr; // of the bubbles
  Index_sets m_sets;
  std::vector<double> m_x, m_y, m_d; // the references
  std::unique_ptr<Bubble_buckets_2> m_buckets;
  std::vector<std::vector<Index>> m_new_sets; // of those that are renewed at once
  std::vector<Index> m_found, m_left, m_joined;
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_GEOMETRY_NEIGHBOR_SETS_2_H
