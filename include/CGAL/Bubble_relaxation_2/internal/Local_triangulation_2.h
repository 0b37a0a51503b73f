// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_LOCAL_TRIANGULATION_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_LOCAL_TRIANGULATION_2_H

#include <CGAL/Bubble_relaxation_2/internal/Bubbles_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Neighbor_sets_2.h>

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Triangulation_face_base_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <array>
#include <utility>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// The Delaunay triangulation near some of the bubbles: of them, their neighbours, and the neighbours of
/// these. A triangle with one of the bubbles themselves is one of the triangulation of all, unless its
/// circle is so large that there is a hole anyway.
class Local_triangulation_2
{
public:
  using Triangle = std::array<Index, 3>; ///< local numbers, counterclockwise

  Local_triangulation_2(const Bubbles_2& bubbles, const Neighbor_sets_2& neighbors,
                        const std::vector<Index>& touched)
    : m_bubbles(touched), m_number_of_touched(touched.size())
  {
    std::vector<char> is_taken(bubbles.size(), 0);
    for (Index i : m_bubbles)
      is_taken[i] = 1;
    std::size_t first = 0;
    for (int ring = 0; ring < 2; ++ring) {
      const std::size_t last = m_bubbles.size();
      for (; first < last; ++first) {
        const Index i = m_bubbles[first];
        for (const Index *j = neighbors.begin(i), *end = neighbors.end(i); j != end; ++j)
          if (!is_taken[*j]) {
            is_taken[*j] = 1;
            m_bubbles.push_back(*j);
          }
      }
    }
    triangulate(bubbles);
  }

  std::size_t number_of_bubbles() const { return m_bubbles.size(); }
  /// the first local numbers
  std::size_t number_of_touched() const { return m_number_of_touched; }
  Index bubble(Index local) const { return m_bubbles[local]; }

  /// those with a touched bubble
  const std::vector<Triangle>& triangles() const { return m_triangles; }

  Triangle bubbles(const Triangle& t) const
  {
    return {m_bubbles[t[0]], m_bubbles[t[1]], m_bubbles[t[2]]};
  }

  /// the local numbers of the neighbours of some touched bubbles, some twice
  std::vector<std::vector<Index>> neighbors_of(const std::vector<Index>& some) const
  {
    std::vector<Index> position(m_number_of_touched, no_index);
    for (std::size_t c = 0; c < some.size(); ++c)
      position[some[c]] = static_cast<Index>(c);
    std::vector<std::vector<Index>> result(some.size());
    for (const Triangle& t : m_triangles)
      for (int i = 0; i < 3; ++i)
        if (is_touched(t[i]) && position[t[i]] != no_index) {
          result[position[t[i]]].push_back(t[ccw(i)]);
          result[position[t[i]]].push_back(t[cw(i)]);
        }
    return result;
  }

private:
  bool is_touched(Index local) const
  {
    return static_cast<std::size_t>(local) < m_number_of_touched;
  }

  void triangulate(const Bubbles_2& bubbles)
  {
    using Vb = Triangulation_vertex_base_with_info_2<Index, Kernel>;
    using Tds = Triangulation_data_structure_2<Vb, Triangulation_face_base_2<Kernel>>;
    std::vector<std::pair<Point, Index>> points;
    points.reserve(m_bubbles.size());
    for (std::size_t k = 0; k < m_bubbles.size(); ++k)
      points.emplace_back(bubbles.point(m_bubbles[k]), static_cast<Index>(k));
    const Delaunay_triangulation_2<Kernel, Tds> dt(points.begin(), points.end());
    for (const auto f : dt.finite_face_handles()) {
      const Triangle t{f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()};
      if (is_touched(t[0]) || is_touched(t[1]) || is_touched(t[2]))
        m_triangles.push_back(t);
    }
  }

  std::vector<Index> m_bubbles; // by local number, the touched first
  std::size_t m_number_of_touched;
  std::vector<Triangle> m_triangles;
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_LOCAL_TRIANGULATION_2_H
