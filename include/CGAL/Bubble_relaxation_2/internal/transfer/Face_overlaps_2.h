// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_TRANSFER_FACE_OVERLAPS_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_TRANSFER_FACE_OVERLAPS_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/parallel_for.h>
#include <CGAL/Bubble_relaxation_2/internal/transfer/Source_search_2.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// What a triangle of the target has in common with one of the source.
struct Face_overlap_2
{
  Index source;
  double area;
  Offset_2 moment; ///< the integrals of the barycentric coordinates 1 and 2 of the source's triangle
};

/// All pairs of triangles that overlap, by the triangles of the target, and by those of the source for each.
class Face_overlaps_2
{
public:
  Face_overlaps_2(const Source_search_2& search, const Face_set_2& target, const Threads& threads)
    : m_blocks((target.number_of_triangles() + block_size - 1) / block_size)
  {
    parallel_for(threads, m_blocks.size(), [&](std::size_t b) { fill(search, target, b); }, 1);
  }

  /// the overlaps of a triangle of the target, as a range
  auto operator[](std::size_t t) const
  {
    const Block& block = m_blocks[t / block_size];
    const std::size_t k = t % block_size;
    return Range{block.overlaps.data() + block.ends[k], block.overlaps.data() + block.ends[k + 1]};
  }

  std::size_t size() const
  {
    std::size_t sum = 0;
    for (const Block& block : m_blocks)
      sum += block.overlaps.size();
    return sum;
  }

private:
  static constexpr std::size_t block_size = 1024;

  struct Range
  {
    const Face_overlap_2 *m_begin, *m_end;

    const Face_overlap_2* begin() const { return m_begin; }
    const Face_overlap_2* end() const { return m_end; }
  };

  /// threads write to blocks of their own
  struct Block
  {
    std::vector<Face_overlap_2> overlaps;
    std::vector<std::size_t> ends{0};
  };

  void fill(const Source_search_2& search, const Face_set_2& target, std::size_t b)
  {
    Block& block = m_blocks[b];
    const std::size_t last = (std::min)((b + 1) * block_size, target.number_of_triangles());
    Source_search_2::Triangles found;
    for (std::size_t k = b * block_size; k < last; ++k) {
      const Index t = static_cast<Index>(k);
      search.find_overlapping(target, t, found);
      for (Index s : found) {
        const Overlap_polygon_2 polygon(search.source(), s, target, t);
        if (polygon.area() > 0)
          block.overlaps.push_back(Face_overlap_2{s, polygon.area(), moment(polygon, target.area(t))});
      }
      block.ends.push_back(block.overlaps.size());
    }
  }

  static Offset_2 moment(const Overlap_polygon_2& polygon, double target_area)
  {
    std::array<Weights_3, Overlap_polygon_2::most> w;
    for (int k = 0; k < polygon.size(); ++k)
      w[k] = polygon.source_weights(k);
    Offset_2 sum{0, 0};
    polygon.for_each_triangle([&](int i, int j, int k, double share) {
      sum.x += share * target_area * (w[i][1] + w[j][1] + w[k][1]) / 3;
      sum.y += share * target_area * (w[i][2] + w[j][2] + w[k][2]) / 3;
    });
    return sum;
  }

  std::vector<Block> m_blocks;
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_TRANSFER_FACE_OVERLAPS_2_H
