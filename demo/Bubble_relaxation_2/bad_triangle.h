// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef BUBBLE_RELAXATION_2_DEMO_BAD_TRIANGLE_H
#define BUBBLE_RELAXATION_2_DEMO_BAD_TRIANGLE_H

#include "files/domain.h"
#include "mesh_options.h"
#include "mesh_warnings.h"

#include <CGAL/radius_ratio_2.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

inline double distance(const Point& p, const Point& q) { return std::hypot(q.x() - p.x(), q.y() - p.y()); }

/// the angle at `p` of a triangle, in degrees
inline double angle(const Point& q, const Point& p, const Point& r)
{
  const double x = q.x() - p.x(), y = q.y() - p.y(), u = r.x() - p.x(), v = r.y() - p.y();
  return std::abs(std::atan2(x * v - y * u, x * u + y * v)) * 180 / CGAL_PI;
}

/// The triangle with the smallest angle of a mesh, and why it may be there.
class Bad_triangle
{
public:
  /// \param protected_segments those of the domain that got no new vertices
  Bad_triangle(const Domain& domain, const Protected_segments& protected_segments)
    : m_domain(domain), m_protected(protected_segments)
  {
    for (CDT::Face_handle f : domain.cdt.finite_face_handles()) {
      if (!f->is_in_domain())
        continue;
      m_smallest_quality = (std::min)(m_smallest_quality, quality(f));
      for (int i = 0; i < 3; ++i)
        if (angle_at(f, i) < m_angle) {
          m_angle = angle_at(f, i);
          m_face = f;
          m_corner = i;
        }
    }
  }

  bool is_bad() const { return ::is_bad(m_angle, m_smallest_quality); }

  /// \param size d, or nothing
  std::string message(const std::function<double(const Point&)>& size) const
  {
    const Point place = is_corner() ? m_face->vertex(m_corner)->point() : CGAL::centroid(m_domain.cdt.triangle(m_face));
    std::ostringstream text;
    text.precision(4);
    text << (is_corner() ? "the triangle in the corner " : "the triangle at ") << in_words(place) << " has an angle of "
         << m_angle << " degrees, q = " << quality(m_face) << ": ";
    if (!size) {
      text << cause(std::numeric_limits<double>::infinity());
    } else {
      const double d = size(place);
      text << cause(d) << "; d is " << d << " there";
    }
    return text.str();
  }

private:
  static double quality(CDT::Face_handle f)
  {
    return CGAL::radius_ratio_2(f->vertex(0)->point(), f->vertex(1)->point(), f->vertex(2)->point());
  }

  static double angle_at(CDT::Face_handle f, int i)
  {
    return angle(f->vertex(CDT::ccw(i))->point(), f->vertex(i)->point(), f->vertex(CDT::cw(i))->point());
  }

  /// whether the angle is between two segments
  bool is_corner() const
  {
    return m_face->is_constrained(CDT::ccw(m_corner)) && m_face->is_constrained(CDT::cw(m_corner));
  }

  /// \param d the size there, infinite if nobody has asked for one
  std::string cause(double d) const
  {
    std::ostringstream text;
    text.precision(4);
    if (is_corner())
      return "two segments of the domain meet there in this angle";
    const int too_long = edge_that_is_too_long(d), shortest = shortest_that_stays();
    if (too_long >= 0)
      text << "a segment that --protect keeps is " << length(too_long) << " long there, longer than d";
    else if (shortest < 0 || length(shortest) > d)
      text << "parts of the domain come nearer to each other than d, "
           << (m_protected.has_any() ? "a segment near it that --protect keeps is far longer than d, " : "")
           << "or d changes much from one triangle to the next";
    else if (m_face->is_constrained(shortest))
      text << "a segment of the domain there is only " << length(shortest) << " long";
    else
      text << "two points there, corners or pinned ones, are only " << length(shortest) << " apart";
    return text.str();
  }

  /// the shortest edge between two vertices that cannot move, by the corner opposite, -1 if there is none
  int shortest_that_stays() const
  {
    int shortest = -1;
    for (int i = 0; i < 3; ++i)
      if (stays(m_face->vertex(CDT::ccw(i))) && stays(m_face->vertex(CDT::cw(i))) &&
          (shortest < 0 || length(i) < length(shortest)))
        shortest = i;
    return shortest;
  }

  /// a protected segment on which vertices are missed, by the corner opposite, -1 if there is none
  int edge_that_is_too_long(double d) const
  {
    constexpr double too_long = 1.5; // shorter ones are about one edge of the mesh
    for (int i = 0; i < 3; ++i) {
      const double usual = (std::min)(d, (std::max)(length(CDT::ccw(i)), length(CDT::cw(i))));
      if (m_face->is_constrained(i) && length(i) > too_long * usual &&
          get(m_protected, {m_face->vertex(CDT::ccw(i)), m_face->vertex(CDT::cw(i))}))
        return i;
    }
    return -1;
  }

  double length(int i) const
  {
    return distance(m_face->vertex(CDT::ccw(i))->point(), m_face->vertex(CDT::cw(i))->point());
  }

  /// whether a vertex is pinned, or a corner: not the middle of one straight line
  bool stays(CDT::Vertex_handle v) const
  {
    if (m_domain.pinned.count(v) > 0)
      return true;
    std::vector<Point> neighbors;
    CDT::Edge_circulator e = m_domain.cdt.incident_edges(v), start = e;
    do {
      if (m_domain.cdt.is_constrained(*e))
        neighbors.push_back(other_end(*e, v)->point());
    } while (++e != start);
    return !neighbors.empty() &&
           (neighbors.size() != 2 || angle(neighbors[0], v->point(), neighbors[1]) < 180 - 1e-6);
  }

  const Domain& m_domain;
  const Protected_segments m_protected;
  CDT::Face_handle m_face;
  int m_corner = 0;
  double m_angle = 180, m_smallest_quality = 1;
};

#endif // BUBBLE_RELAXATION_2_DEMO_BAD_TRIANGLE_H
