// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_TREATMENT_GREEDY_COLORING_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_TREATMENT_GREEDY_COLORING_2_H

#include <CGAL/Bubble_relaxation_2/internal/geometry/Editable_triangulation_2.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// Colours candidates among the vertices so that no two neighbours have the same: each gets the first colour
/// that none of its neighbours with a smaller index has.
class Greedy_coloring_2
{
public:
  /// of vertices that are no candidates, and of those whose neighbours have all colours
  static constexpr unsigned char none = 255;

  explicit Greedy_coloring_2(std::size_t number_of_vertices) : m_color(number_of_vertices, none) {}

  unsigned char operator[](Index v) const { return m_color[v]; }
  void set(Index v, unsigned char color) { m_color[v] = color; }

  /// `candidates` ascend
  void color(const Editable_triangulation_2& mesh, const std::vector<Index>& candidates)
  {
    for (Index v : candidates)
      color(mesh, v);
  }

  /// returns whether the colour of a candidate is another now
  bool color(const Editable_triangulation_2& mesh, Index v)
  {
    const unsigned char old = m_color[v];
    m_color[v] = first_color_left(mesh, v);
    return m_color[v] != old;
  }

  void forget(const std::vector<Index>& candidates)
  {
    for (Index v : candidates)
      m_color[v] = none;
  }

  /// the candidates of each colour
  std::vector<std::vector<Index>> sets(const std::vector<Index>& candidates) const
  {
    std::vector<std::vector<Index>> result;
    for (Index v : candidates) {
      if (m_color[v] == none)
        continue;
      if (m_color[v] >= result.size())
        result.resize(m_color[v] + std::size_t(1));
      result[m_color[v]].push_back(v);
    }
    return result;
  }

private:
  static constexpr unsigned char most = 63; // vertices with more neighbours than this are not coloured

  unsigned char first_color_left(const Editable_triangulation_2& mesh, Index v) const
  {
    std::uint64_t taken = 0;
    for (const Corner_2& c : mesh.star(v))
      for (Index w : mesh.vertices(c.triangle))
        if (w < v && m_color[w] != none && mesh.is_inside(c.triangle))
          taken |= std::uint64_t(1) << m_color[w];
    unsigned char color = 0;
    while (color < most && (taken >> color & 1) != 0)
      ++color;
    return color < most ? color : none;
  }

  std::vector<unsigned char> m_color;
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_TREATMENT_GREEDY_COLORING_2_H
