// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_CORE_BUBBLES_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_CORE_BUBBLES_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/Progress.h>
#include <CGAL/Bubble_relaxation_2/internal/core/vocabulary.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// Sorts a sequence whose first elements are sorted: mostly few came after these.
template <class T, class Is_before>
void merge_tail(std::vector<T>& sequence, const Is_before& is_before)
{
  const auto middle = std::is_sorted_until(sequence.begin(), sequence.end(), is_before);
  std::sort(middle, sequence.end(), is_before);
  std::inplace_merge(sequence.begin(), middle, sequence.end(), is_before);
}

/// The bubbles as a structure of arrays: all that is known of a bubble is kept here, once. Where all bubbles are here a
/// bubble's index is its identity: neighbours are summed in the order of indices, and indices follow space. On one of
/// several ranks it has its index among all, and an owner.
struct Bubbles_2
{
  enum Dimension : unsigned char { CORNER = 0, EDGE = 1, FACE = 2, GONE = 3 };

  std::vector<double> x, y;   ///< centre
  std::vector<double> d;      ///< wanted distance to neighbours at the centre
  std::vector<double> vx, vy; ///< velocity: in units of `d` a unit of time, or of length (Runge-Kutta)
  std::vector<unsigned char> dimension;
  /// what the bubble belongs to: the corner, the edge, or the domain's triangle that contains it;
  /// `no_index` for a pinned vertex off the domain's edges
  std::vector<Index> host;
  std::vector<double> s;      ///< position on its edge in (0,1); 0 of others
  std::vector<Index> pin;     ///< index of the user's pinned vertex; `no_index` for all others

  /// \name Part of All
  /// What a rank holds of bubbles that are distributed over several; empty where all are here.
  /// @{
  std::vector<std::int64_t> id;     ///< its index among all
  std::vector<std::int32_t> owner;  ///< the rank that says what becomes of it; empty as well if all are ours
  std::int32_t rank = 0;            ///< this one
  /// @}

  /// whether bubble `i` comes before bubble `j` among all
  bool is_before(std::size_t i, std::size_t j) const { return id.empty() ? i < j : id[i] < id[j]; }

  /// whether this rank says what becomes of a bubble
  bool is_ours(std::size_t i) const { return owner.empty() || owner[i] == rank; }

  /// on other ranks others of them count
  std::size_t count_ours(const std::vector<Index>& those) const
  {
    return static_cast<std::size_t>(std::count_if(those.begin(), those.end(), [this](Index i) { return is_ours(i); }));
  }

  std::size_t size() const { return x.size(); }
  Point point(std::size_t i) const { return Point(x[i], y[i]); }
  bool is_corner(std::size_t i) const { return dimension[i] == CORNER; }
  bool is_on_edge(std::size_t i) const { return dimension[i] == EDGE; }
  bool is_in_face(std::size_t i) const { return dimension[i] == FACE; }
  bool is_gone(std::size_t i) const { return dimension[i] == GONE; }
  bool can_move(std::size_t i) const { return is_on_edge(i) || is_in_face(i); }

  /// makes room for `n` more
  void make_room_for(std::size_t n)
  {
    for_each_array([n](auto& array) { internal::make_room_for(n, array); });
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
    host.push_back(at);
    s.push_back(on_edge);
    pin.push_back(pinned);
  }

  /// adds a copy of another one, at rest and without its id and owner
  void add(const Bubbles_2& from, std::size_t i)
  {
    add(from.point(i), from.d[i], static_cast<Dimension>(from.dimension[i]), from.host[i], from.s[i], from.pin[i]);
  }

  /// deletes a bubble; the others keep their indices until `forget_gone()`
  void remove(std::size_t i) { dimension[i] = GONE; }

  /// those that are not deleted
  std::vector<Index> left() const
  {
    std::vector<Index> result;
    result.reserve(size());
    for (std::size_t i = 0; i < size(); ++i) {
      tick(i);
      if (!is_gone(i))
        result.push_back(static_cast<Index>(i));
    }
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
    for_each_array([&](auto& array) { select(array, order, in_place); });
  }

  /// Orders them by their identities. Mostly few were added to those that ascend.
  void sort_by_id()
  {
    if (std::is_sorted(id.begin(), id.end()))
      return;
    std::vector<Index> order = indices_below(size());
    merge_tail(order, [this](Index i, Index j) { return id[i] < id[j]; });
    select(order);
  }

  /// of a bubble with an identity, `no_index` if there is none \pre they are sorted by it
  Index index_of(std::int64_t identity) const { return index_among(id, identity); }

  void stop(std::size_t i) { vx[i] = vy[i] = 0; }

private:
  /// calls `f` for all that have an element a bubble
  template <class Function>
  void for_each_array(const Function& f)
  {
    for (std::vector<double>* a : {&x, &y, &d, &vx, &vy, &s})
      f(*a);
    f(dimension);
    f(host);
    f(pin);
    if (!id.empty())
      f(id);
    if (!owner.empty())
      f(owner);
  }

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
      for (std::size_t k = 0; k < order.size(); ++k) {
        tick(k);
        array[k] = array[order[k]];
      }
      array.resize(order.size());
      return;
    }
    std::vector<T> selected;
    selected.reserve(order.size() + order.size() / 8);
    for (Index i : order) {
      tick(selected.size());
      selected.push_back(array[i]);
    }
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

/// What a simulation remembers of a bubble, beside the bubble itself.
struct Bubble_memory_2
{
  double reference_x, reference_y, reference_d; ///< where its neighbours were last looked for
  double asked_x, asked_y;                      ///< where d was last asked
  char is_active, is_touched;
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_CORE_BUBBLES_2_H
