// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_REGION_SIZING_FIELD_2_H
#define CGAL_REGION_SIZING_FIELD_2_H

#include <CGAL/license/Bubble_relaxation_2.h>

#include <CGAL/Bubble_relaxation_2/internal/core/disable_warnings.h>

#include <CGAL/Bubble_relaxation_2/internal/core/Plane_2.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_marks_2.h>
#include <CGAL/Bubble_relaxation_2/internal/fields/Region_search_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/flatten_triangulation.h>
#include <CGAL/Bubble_relaxation_parameters.h>

#include <CGAL/number_utils.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgBubbleRelaxation2Sizing

Sizes by region: what a function of the region's tag, and of the place if it likes, asks for in the region in which the
place lies.

On constraints between regions, up to the rounding of points on them, it is the smallest of what their regions ask for.
There the size jumps; `Gradation_limited_sizing_field_2` makes a field of this one that does not, which makes better
triangles:

\code
Region_sizing_field_2<CDT> d(cdt, regions, [](int region) { return region == 7 ? 0.01 : 0.1; });
Gradation_limited_sizing_field_2<CDT> graded(cdt, 0.2, Bubble_relaxation_parameters::sizing_function(d));
npbs_relax(cdt, Bubble_relaxation_parameters::sizing_function(graded).face_region_map(regions));
\endcode

Beyond the domain it is the size of the region that is next to the place in the triangulation. What belongs to no
region, since the map has another value there, has sizes by that value.

The triangulation is copied and may be changed or go away: `npbs_relax()` may be called on the very triangulation that
the field was made of. Copies of the field share what they hold; a query takes well under a microsecond and what the
function takes, and its bits depend neither on other queries nor on threads.

\cgalModels{BubbleSizingField_2}

\tparam CDT_ a `Constrained_Delaunay_triangulation_2` or a `Constrained_triangulation_plus_2` of one

\sa `npbs_relax()`
\sa `Gradation_limited_sizing_field_2`
*/
template <class CDT_>
class Region_sizing_field_2
{
  using Search = Bubble_relaxation_2::internal::Region_search_2;

public:
  using CDT = CDT_;
  using FT = double; ///< the number type of sizes
  /// the point type: of a terrain, that of its plane
  using Point_2 = Bubble_relaxation_2::internal::Place_2<CDT>;

  /*!
  reads the regions.

  \tparam FaceRegionMap a model of `ReadablePropertyMap` with `CDT::Face_handle` as key and a value that can be
  copied and compared by `==`
  \tparam SizeOfRegion a function object, called as a constant with a region, or with a region and a `Point_2`, that
  returns a number; by several threads at once with `Parallel_tag`. It is copied

  \param cdt the domain, as for `npbs_relax()`
  \param regions the regions of the domain's faces
  \param size the wanted length of edges in a region
  \param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `seeds` and `seeds_are_in_domain` as
  for `npbs_relax()`

  \throws std::invalid_argument as `npbs_relax()` if there is no domain
  */
  template <class FaceRegionMap, class SizeOfRegion, class NamedParameters = parameters::Default_named_parameters>
  Region_sizing_field_2(const CDT& cdt, const FaceRegionMap& regions, const SizeOfRegion& size,
                        const NamedParameters& np = parameters::default_values())
  {
    using namespace Bubble_relaxation_2::internal;
    using Region = typename boost::property_traits<FaceRegionMap>::value_type;
    const Domain_marks_2<CDT> marks(cdt, np);
    Sorted_triangulation_2 sorted(marks); // so that it does not matter how the domain came about
    std::vector<Region> known; // mostly few
    std::vector<Index> of_triangle(sorted.tr.number_of_triangles(), no_index);
    std::size_t last = 0; // neighbours often have the same
    for (std::size_t t = 0; t < of_triangle.size(); ++t) {
      if (!sorted.tr.inside[t])
        continue;
      const Region region = get(regions, Handles<CDT>::face(marks.faces.addresses()[sorted.triangles[t]]));
      if (last >= known.size() || !(known[last] == region))
        last = static_cast<std::size_t>(std::find(known.begin(), known.end(), region) - known.begin());
      if (last == known.size())
        known.push_back(region);
      of_triangle[t] = static_cast<Index>(last);
    }
    m_search = std::make_shared<const Search>(std::move(sorted.tr), std::move(of_triangle));
    m_size = [known = std::move(known), size](std::size_t region, const Point_2& p) {
      return size_of<Region>(size, known[region], p);
    };
  }

  /// returns the size at `p`, NaN if a coordinate is not finite.
  FT operator()(const Point_2& p) const
  {
    const double x = CGAL::to_double(p.x()), y = CGAL::to_double(p.y());
    if (!std::isfinite(x) || !std::isfinite(y))
      return std::numeric_limits<double>::quiet_NaN();
    double least = std::numeric_limits<double>::infinity();
    m_search->for_each_region({x, y}, [&](std::size_t region) {
      const double d = m_size(region, p);
      if (d < least || d != d) // what is not a number is told by who asks
        least = d;
    });
    return least;
  }

private:
  template <class Region, class SizeOfRegion>
  static double size_of(const SizeOfRegion& size, const Region& region, [[maybe_unused]] const Point_2& p)
  {
    constexpr bool of_region = std::is_invocable<const SizeOfRegion&, const Region&>::value,
                   of_place = std::is_invocable<const SizeOfRegion&, const Region&, const Point_2&>::value;
    static_assert(of_region || of_place, "the sizes of a Region_sizing_field_2 must be callable, as a constant, with a "
                                         "region, or with a region and a point");
    if constexpr (of_place)
      return CGAL::to_double(size(region, p));
    else if constexpr (of_region)
      return CGAL::to_double(size(region));
    else
      return 0;
  }

  std::shared_ptr<const Search> m_search;
  std::function<double(std::size_t, const Point_2&)> m_size;
};

} // namespace CGAL

#include <CGAL/Bubble_relaxation_2/internal/core/enable_warnings.h>

#endif // CGAL_REGION_SIZING_FIELD_2_H
