// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_CORE_BUBBLES_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_CORE_BUBBLES_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/vocabulary.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// The bubbles as a structure of arrays. A bubble's index is its identity: neighbours are summed in
/// the order of indices, and indices follow space.
struct Bubbles_2
{
  enum Dimension : unsigned char { CORNER = 0, EDGE = 1, FACE = 2, GONE = 3 };

  std::vector<double> x, y;   ///< centre
  std::vector<double> d;      ///< wanted distance to neighbours at the centre
  std::vector<double> vx, vy; ///< velocity: in units of `d` a unit of time, or of length (Runge-Kutta)
  std::vector<unsigned char> dimension;
  /// what the bubble belongs to: the corner, the edge, or the domain's triangle that contains it;
  /// `no_index` for a pinned vertex off the domain's edges
  std::vector<Index> place;
  std::vector<double> s;      ///< position on its edge in (0,1); edge bubbles only
  std::vector<Index> tag;     ///< index of the user's pinned vertex; `no_index` for all others

  /// \name Part of All
  /// What a rank holds of bubbles that are distributed over several; empty where all are here.
  /// @{
  std::vector<std::int64_t> number; ///< its index among all
  std::vector<char> is_foreign;     ///< whether another rank owns it
  /// @}

  /// whether bubble `i` comes before bubble `j` among all
  bool is_before(std::size_t i, std::size_t j) const { return number.empty() ? i < j : number[i] < number[j]; }

  /// whether this rank says what becomes of a bubble
  bool is_ours(std::size_t i) const { return is_foreign.empty() || !is_foreign[i]; }

  std::size_t size() const { return x.size(); }
  Point point(std::size_t i) const { return Point(x[i], y[i]); }
  bool is_corner(std::size_t i) const { return dimension[i] == CORNER; }
  bool is_on_edge(std::size_t i) const { return dimension[i] == EDGE; }
  bool is_in_face(std::size_t i) const { return dimension[i] == FACE; }
  bool is_gone(std::size_t i) const { return dimension[i] == GONE; }
  bool can_move(std::size_t i) const { return is_on_edge(i) || is_in_face(i); }

  /// What counts as rest, as a share of the tolerance: bubbles on edges have few neighbours to push them,
  /// and two rows that face each other part slowly.
  double share_of_tolerance(std::size_t i) const { return is_on_edge(i) ? 0.05 : 1.; }

  /// makes room for `n` more
  void make_room_for(std::size_t n)
  {
    for (std::vector<double>* a : {&x, &y, &d, &vx, &vy, &s})
      internal::make_room_for(n, *a);
    internal::make_room_for(n, dimension);
    internal::make_room_for(n, place);
    internal::make_room_for(n, tag);
  }

  void add(const Point& p, double size, Dimension dim, Index at, double on_edge = 0,
           Index pinned = no_index)
  {
    x.push_back(p.x());
    y.push_back(p.y());
    d.push_back(size);
    vx.push_back(0);
    vy.push_back(0);
    dimension.push_back(dim);
    place.push_back(at);
    s.push_back(on_edge);
    tag.push_back(pinned);
  }

  /// deletes a bubble; the others keep their indices until `forget_gone()`
  void remove(std::size_t i) { dimension[i] = GONE; }

  /// those that are not deleted
  std::vector<Index> left() const
  {
    std::vector<Index> result;
    result.reserve(size());
    for (std::size_t i = 0; i < size(); ++i)
      if (!is_gone(i))
        result.push_back(static_cast<Index>(i));
    return result;
  }

  /// of each bubble the index that it has after `forget_gone()`, `no_index` for those that are deleted
  std::vector<Index> indices_left() const
  {
    std::vector<Index> result(size(), no_index);
    Index next = 0;
    for (Index i : left())
      result[i] = next++;
    return result;
  }

  void forget_gone()
  {
    const std::vector<Index> those = left();
    if (those.size() < size())
      select(those);
  }

  /// Keeps the bubbles `order[0], order[1], …` in this order and forgets the others. Where they go elsewhere in memory,
  /// there is room for some more afterwards.
  void select(const std::vector<Index>& order)
  {
    const bool in_place = is_in_place(order);
    for (std::vector<double>* a : {&x, &y, &d, &vx, &vy, &s})
      select(*a, order, in_place);
    select(dimension, order, in_place);
    select(place, order, in_place);
    select(tag, order, in_place);
    if (!number.empty())
      select(number, order, in_place);
    if (!is_foreign.empty())
      select(is_foreign, order, in_place);
  }

  /// all are here now
  void forget_parts()
  {
    number.clear();
    is_foreign.clear();
  }

  /// the same, of what is known of bubbles beside this
  template <class T>
  static void select(std::vector<T>& array, const std::vector<Index>& order)
  {
    select(array, order, is_in_place(order));
  }

  void stop(std::size_t i) { vx[i] = vy[i] = 0; }

private:
  /// whether none gets a later place: then one after the other can go where it belongs
  static bool is_in_place(const std::vector<Index>& order)
  {
    for (std::size_t k = 0; k < order.size(); ++k)
      if (static_cast<std::size_t>(order[k]) < k)
        return false;
    return true;
  }

  template <class T>
  static void select(std::vector<T>& array, const std::vector<Index>& order, bool in_place)
  {
    if (in_place) {
      for (std::size_t k = 0; k < order.size(); ++k)
        array[k] = array[order[k]];
      array.resize(order.size());
      return;
    }
    std::vector<T> selected;
    selected.reserve(order.size() + order.size() / 8);
    for (Index i : order)
      selected.push_back(array[i]);
    array.swap(selected);
  }
};

/// Bubbles that a population control wants to delete and to insert.
struct Population_change
{
  std::vector<Index> deleted;
  Bubbles_2 inserted;

  bool is_empty() const { return deleted.empty() && inserted.size() == 0; }
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_CORE_BUBBLES_2_H
