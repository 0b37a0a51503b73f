// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_ADAPTATION_MISFIT_SEARCH_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_ADAPTATION_MISFIT_SEARCH_2_H

#include <CGAL/Bubble_relaxation_2/internal/adaptation/Part_growth_2.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Progress.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Sizes_2.h>
#include <CGAL/Bubble_relaxation_2/internal/core/reproducible_math.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Bubble_buckets_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/flatten_triangulation.h>

#include <CGAL/Bubble_relaxation_report_2.h>
#include <CGAL/number_type_config.h>
#include <CGAL/radius_ratio_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// When a face does not fit.
struct Misfit_criteria
{
  double longest_edge = 1.5, shortest_edge = 0.6; ///< means of the edges of a face, over the size there
  double misfit_angle = 20;                       ///< degrees
  double misfit_quality = 0;                      ///< the radius ratio q
  std::size_t number_of_rings = 4;
};

/// Finds the faces of a mesh that do not fit sizes. In a good mesh the mean length of a face's edges differs from the
/// size by up to a third here and there, so only larger misfits tell that sizes have changed. But then all counts
/// that hangs together with them and is off by the cube root of their factor, so that nothing is left over where
/// changes fade out.
template <class Cdt, class Is_inside>
class Misfit_search_2
{
public:
  using Face_handle = typename Cdt::Face_handle;
  using Vertex_handle = typename Cdt::Vertex_handle;

  /// `sizes`: what a mesh follows of those that are `wanted`; `forced`: places, with the sizes that are wanted there,
  /// whose triangles are what the outline forces them to be
  Misfit_search_2(const Cdt& cdt, const Is_inside& is_in_domain, const Sizes_2& sizes, const Sizes_2& wanted,
                  const Misfit_criteria& criteria, const Bubble_buckets_2& forced)
    : m_cdt(cdt), m_is_in_domain(is_in_domain), m_sizes(sizes), m_wanted(wanted), m_criteria(criteria),
      m_forced(forced), m_smallest_sine(sine_of(criteria.misfit_angle * CGAL_PI / 180)), m_part(cdt, is_in_domain, {}),
      m_star_numbers(sizeof(typename Cdt::Vertex))
  {}

  /// Looks for misfits among these faces, and beside those that it finds.
  template <class Face_range>
  std::vector<Face_handle> operator()(const Face_range& faces)
  {
    std::size_t number = 0;
    for (Face_handle f : faces) {
      tick(number++);
      if (m_is_in_domain(f) && is_misfit(f) && !is_forced(f))
        m_part.add(f);
    }
    for (std::size_t k = 0; k < m_part.faces().size(); ++k) {
      tick(k);
      for (int i = 0; i < 3; ++i) {
        const Face_handle n = m_part.faces()[k]->neighbor(i);
        if (is_other(n) && is_slight_misfit(n))
          m_part.add(n);
      }
    }
    m_part.add_rings(m_criteria.number_of_rings);
    return m_part.faces();
  }

private:
  /// whether it is a face of the domain that was not found yet
  bool is_other(Face_handle f) const
  {
    return !m_part.contains(f) && !m_cdt.is_infinite(f) && m_is_in_domain(f);
  }

  /// A sharp corner makes edges short and angles small, never edges long.
  bool is_forced(Face_handle f) const
  {
    constexpr double reach = 0.5; // of circles, in sizes, with what is refined around them
    const std::array<Point, 3> corners = corners_of(f).points;
    const double least = measure(f).length / m_criteria.longest_edge;
    return std::any_of(corners.begin(), corners.end(), [&](const Point& p) {
      return !m_forced.for_each_large(p.x(), p.y(), least, reach, [](const auto&, double) { return false; });
    });
  }

  /// The corners of a face, counterclockwise from the least on: nothing may depend on how faces number them.
  struct Corners
  {
    std::array<Point, 3> points;
    int first; ///< its number in the face
  };

  static Corners corners_of(Face_handle f)
  {
    Corners c{corners_in_double<Cdt>(f), 0};
    const auto least = std::min_element(c.points.begin(), c.points.end());
    c.first = static_cast<int>(least - c.points.begin());
    std::rotate(c.points.begin(), least, c.points.end());
    return c;
  }

  bool is_misfit(Face_handle f)
  {
    // Beside a constraint one row of triangles may be too coarse, and two too fine; and where sizes grow away from a
    // fine outline rows end.
    constexpr double narrow = 0.84;
    const auto is_misfit_by = [&](double shortest) {
      return is_misfit(f, m_criteria.misfit_quality, m_smallest_sine, m_criteria.longest_edge, shortest);
    };
    return is_misfit_by(m_criteria.shortest_edge) &&
           (!(is_at_constraint(f) || is_limited(f)) || is_misfit_by(narrow * m_criteria.shortest_edge));
  }

  bool is_slight_misfit(Face_handle f)
  {
    return is_misfit(f, 0, 0, cube_root_of(m_criteria.longest_edge), cube_root_of(m_criteria.shortest_edge));
  }

  /// Whether q is less than this, an angle is less than that of this sine, or edges are longer or shorter than so many
  /// times the size, and it is not a jump of the sizes that makes it so.
  bool is_misfit(Face_handle f, double smallest_q, double smallest_sine, double longest, double shortest)
  {
    const Measures m = measure(f);
    const double size = m_sizes(m.center);
    if (m.length <= longest * size && m.length >= shortest * size && m.sine >= smallest_sine && m.q >= smallest_q)
      return false;
    const Size_range range = sizes_around(f, m.center, size);
    return m.length > longest * range.largest || m.length < shortest * range.smallest ||
           m.sine < smallest_sine * range.flattening() || m.q < smallest_q * range.flattening();
  }

  bool is_at_constraint(Face_handle f) const
  {
    return m_cdt.are_there_incident_constraints(f->vertex(0)) || m_cdt.are_there_incident_constraints(f->vertex(1)) ||
           m_cdt.are_there_incident_constraints(f->vertex(2));
  }

  /// whether the outline asks for smaller triangles than the user
  bool is_limited(Face_handle f) const
  {
    constexpr double much = 0.9;
    const Point center = measure(f).center;
    return m_sizes(center) < much * m_wanted(center);
  }

  struct Measures
  {
    Point center;    ///< the centroid
    double length;   ///< the mean of the edges
    double sine = 1; ///< of the smallest angle that is not between two constraints
    double q = 1;    ///< if no angle is
  };

  struct Size_range
  {
    double smallest, largest;

    /// The smallest angle of two large bubbles and a small one that touch each other: its sine over that of 60 degrees.
    double flattening() const
    {
      const double s = smallest / largest; // sides are 2, 1 + s and 1 + s, and the cosine is 1 / (1 + s)
      return std::sqrt(s * (2 + s)) / (1 + s) / std::sqrt(0.75);
    }
  };

  /// The size in the middle of a face. No mesh follows sizes that are too steep: where they are, all is meant that is
  /// wanted at the corners and beside them, since more cannot be told of what triangles should be like.
  Size_range sizes_around(Face_handle f, const Point& center, double size)
  {
    Size_range range{size, size};
    bool is_steep = false;
    for (int i = 0; i < 3; ++i) {
      const Star& s = star(f->vertex(i));
      range.smallest = (std::min)(range.smallest, s.range.smallest);
      range.largest = (std::max)(range.largest, s.range.largest);
      is_steep = is_steep || s.is_steep || is_too_steep(size, center, s.size, point_of(f->vertex(i)));
    }
    return is_steep ? range : Size_range{size, size};
  }

  /// The sizes at a vertex and at its neighbours. Misfits lie side by side and share them, and it may take long to ask
  /// for.
  struct Star
  {
    double size;
    bool is_known = false, is_steep = false;
    Size_range range{};
  };

  static bool is_too_steep(double at_p, const Point& p, double at_q, const Point& q)
  {
    constexpr double too_steep = Bubble_relaxation_report_2<double>::steep_size_gradient;
    const double difference = at_p - at_q;
    return difference * difference > too_steep * too_steep * CGAL::squared_distance(p, q);
  }

  static Point point_of(Vertex_handle v) { return point_in_double<Cdt>(v->point()); }

  Index star_number(Vertex_handle v)
  {
    const Index known = m_star_numbers(&*v);
    if (known != no_index)
      return known;
    m_star_numbers.add(&*v);
    m_stars.push_back(Star{m_sizes(point_of(v))});
    return static_cast<Index>(m_stars.size()) - 1;
  }

  const Star& star(Vertex_handle v)
  {
    const std::size_t number = static_cast<std::size_t>(star_number(v));
    if (m_stars[number].is_known)
      return m_stars[number];
    Star s = m_stars[number]; // others may be added
    s.is_known = true;
    s.range = Size_range{s.size, s.size};
    const Point p = point_of(v);
    auto f = m_cdt.incident_faces(v), first = f;
    do {
      if (m_cdt.is_infinite(f) || !m_is_in_domain(f)) // sizes may be known in the domain only
        continue;
      const int i = f->index(v);
      for (const Vertex_handle& w : {f->vertex(ccw(i)), f->vertex(cw(i))}) {
        const double at_w = m_stars[static_cast<std::size_t>(star_number(w))].size;
        s.range.smallest = (std::min)(s.range.smallest, at_w);
        s.range.largest = (std::max)(s.range.largest, at_w);
        s.is_steep = s.is_steep || is_too_steep(s.size, p, at_w, point_of(w));
      }
    } while (++f != first);
    return m_stars[number] = s;
  }

  Measures measure(Face_handle f) const
  {
    const auto [p, first_corner] = corners_of(f);
    std::array<double, 3> length; // of the sides opposite to the corners
    for (int i = 0; i < 3; ++i)
      length[i] = std::sqrt(CGAL::squared_distance(p[ccw(i)], p[cw(i)]));
    const double twice_area = std::abs((p[1].x() - p[0].x()) * (p[2].y() - p[0].y()) -
                                       (p[2].x() - p[0].x()) * (p[1].y() - p[0].y()));
    Measures result{CGAL::centroid(p[0], p[1], p[2]), (length[0] + length[1] + length[2]) / 3};
    bool is_forced = false;
    for (int i = 0; i < 3; ++i)
      if (f->is_constrained((first_corner + i + 1) % 3) && f->is_constrained((first_corner + i + 2) % 3))
        is_forced = true;
      else if (length[i] <= length[ccw(i)] || length[i] <= length[cw(i)]) // else it may be obtuse
        result.sine = (std::min)(result.sine, twice_area / (length[ccw(i)] * length[cw(i)]));
    if (!is_forced && m_criteria.misfit_quality > 0)
      result.q = CGAL::radius_ratio_2(p[0], p[1], p[2]);
    return result;
  }

  const Cdt& m_cdt;
  const Is_inside& m_is_in_domain;
  const Sizes_2 &m_sizes, &m_wanted;
  Misfit_criteria m_criteria;
  const Bubble_buckets_2& m_forced;
  double m_smallest_sine;
  Part_growth_2<Cdt, Is_inside> m_part; // what was found
  Address_numbers m_star_numbers; // of vertices beside misfits
  std::vector<Star> m_stars;
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_ADAPTATION_MISFIT_SEARCH_2_H
