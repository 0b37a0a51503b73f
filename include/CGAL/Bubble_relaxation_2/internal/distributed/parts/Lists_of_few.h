// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_PARTS_LISTS_OF_FEW_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_PARTS_LISTS_OF_FEW_H

#include <CGAL/Bubble_relaxation_2/internal/core/vocabulary.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// A list for each of many bubbles, most of which are empty: what others have to do with the few at the border of a
/// rank's part. An empty list takes no more than an index.
template <class T>
class Lists_of_few
{
public:
  using List = boost::container::small_vector<T, 2>;

  explicit Lists_of_few(std::size_t n = 0) : m_place(n, no_index) {}

  /// makes room for `n` more bubbles
  void make_room_for(std::size_t n) { internal::make_room_for(n, m_place); }

  /// There are `n` bubbles, of which those that come new have empty lists. \pre they are not fewer than before
  void resize(std::size_t n) { m_place.resize(n, no_index); }

  /// no bubbles
  void clear()
  {
    m_place.clear();
    m_lists.clear();
  }

  bool is_empty(Index i) const { return m_place[i] == no_index; }

  /// good until the next `add()`
  const List& operator[](Index i) const { return is_empty(i) ? m_none : m_lists[m_place[i]]; }

  bool has(Index i, const T& value) const
  {
    const List& list = (*this)[i];
    return std::find(list.begin(), list.end(), value) != list.end();
  }

  void add(Index i, const T& value)
  {
    if (is_empty(i)) {
      m_place[i] = static_cast<Index>(m_lists.size());
      m_lists.emplace_back();
    }
    m_lists[m_place[i]].push_back(value);
  }

  /// unless it is there; returns whether it was added
  bool add_once(Index i, const T& value)
  {
    if (has(i, value))
      return false;
    add(i, value);
    return true;
  }

private:
  std::vector<Index> m_place; // of each bubble's list
  std::vector<List> m_lists;  // that are not empty
  List m_none;
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_PARTS_LISTS_OF_FEW_H
