// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_ADAPTATION_RIM_SIZES_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_ADAPTATION_RIM_SIZES_H

#include <CGAL/Bubble_relaxation_2/internal/core/Sizes_2.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_2.h>
#include <CGAL/Bubble_relaxation_2/internal/sizes/Outline_sizes_2.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// The length of the shorter edge of the rim at each corner of a part, where that is far more than sizes ask for.
inline std::vector<Size_source_2> coarse_rim(const Domain_2& part, const Sizes_2& wanted)
{
  constexpr double tolerated = 1.25; // a vertex is kept if the mesh around it is as coarse as that
  constexpr double none = std::numeric_limits<double>::infinity();
  std::vector<double> length(part.corners().size(), none);
  for (std::size_t e = 0; e < part.edges().size(); ++e)
    if (!part.edges()[e].takes_bubbles)
      for (Index end : {part.edges()[e].source, part.edges()[e].target})
        length[end] = (std::min)(length[end], part.length(static_cast<Index>(e)));
  std::vector<Size_source_2> result;
  for (std::size_t c = 0; c < length.size(); ++c)
    if (length[c] < none && length[c] > tolerated * wanted(part.corners()[c]))
      result.push_back(Size_source_2{part.corners()[c], length[c]});
  return result;
}

/// The wanted sizes, and larger ones beside edges of the rim that are far longer: from there they shrink by no more
/// than `growth` per unit of length, else triangles at the rim would be needles.
inline Sizes_2 no_finer_than_rim(const Domain_2& part, const Sizes_2& wanted, double growth)
{
  std::vector<Size_source_2> sources = coarse_rim(part, wanted);
  if (sources.empty())
    return wanted;
  double longest = 0;
  for (const Size_source_2& s : sources)
    longest = (std::max)(longest, s.d);
  for (Size_source_2& s : sources) // the largest of d_s - g |x - s| is less than the longest by the least of these
    s.d = longest - s.d;
  Outline_field_2 less(sources, part.bbox(), growth);
  return larger_of(wanted, Sizes_2([less = std::move(less), longest](double x, double y) {
                     return longest - less(x, y);
                   }));
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_ADAPTATION_RIM_SIZES_H
