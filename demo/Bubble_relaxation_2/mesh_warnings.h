// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef BUBBLE_RELAXATION_2_DEMO_MESH_WARNINGS_H
#define BUBBLE_RELAXATION_2_DEMO_MESH_WARNINGS_H

#include "files/domain.h"

#include <CGAL/radius_ratio_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <sstream>
#include <string>
#include <vector>

// What npbs_mesh warns of when it has made a mesh.

inline double distance(const Point& p, const Point& q) { return std::hypot(q.x() - p.x(), q.y() - p.y()); }

/// the angle at `p` of a triangle, in degrees
inline double angle(const Point& q, const Point& p, const Point& r)
{
  const double x = q.x() - p.x(), y = q.y() - p.y(), u = r.x() - p.x(), v = r.y() - p.y();
  return std::abs(std::atan2(x * v - y * u, x * u + y * v)) * 180 / CGAL_PI;
}

/// coordinates with as many digits as it takes to find the place on a map of the world in millimetres
inline std::string in_words(const Point& p)
{
  std::ostringstream text;
  text.precision(11);
  text << '(' << p.x() << ", " << p.y() << ')';
  return text.str();
}

/// The triangle with the smallest angle of a mesh, and why it may be there.
class Bad_triangle
{
public:
  explicit Bad_triangle(const Domain& domain) : m_domain(domain)
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

  /// whether elements like this are known to spoil computations
  bool is_bad() const { return m_angle < 20 || m_smallest_quality < 0.3; }

  /// \param size d, or nothing
  std::string message(const std::function<double(const Point&)>& size) const
  {
    const Point center = CGAL::centroid(m_domain.cdt.triangle(m_face));
    std::ostringstream text;
    text.precision(4);
    text << "the triangle at " << in_words(center) << " has an angle of " << m_angle
         << " degrees, q = " << quality(m_face) << ": " << cause();
    if (size)
      text << "; d is " << size(center) << " there";
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

  std::string cause() const
  {
    std::ostringstream text;
    text.precision(4);
    if (m_face->is_constrained(CDT::ccw(m_corner)) && m_face->is_constrained(CDT::cw(m_corner)))
      return "two segments of the domain meet there in this angle";
    int shortest = -1; // the shortest edge between two vertices that cannot move, by the corner opposite
    for (int i = 0; i < 3; ++i)
      if (stays(m_face->vertex(CDT::ccw(i))) && stays(m_face->vertex(CDT::cw(i))) &&
          (shortest < 0 || length(i) < length(shortest)))
        shortest = i;
    if (shortest < 0)
      return "parts of the domain come nearer to each other than d, or d changes much from one triangle to "
             "the next";
    if (m_face->is_constrained(shortest))
      text << "a segment of the domain there is only " << length(shortest) << " long";
    else
      text << "two points there, corners or pinned ones, are only " << length(shortest) << " apart";
    return text.str();
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
  CDT::Face_handle m_face;
  int m_corner = 0;
  double m_angle = 180, m_smallest_quality = 1;
};

/// Ends of segments where no other segment begins, outside of the mesh. Inside they are cracks; outside, the
/// outline that they belong to was perhaps meant to be closed, and bounds nothing as it is.
inline std::vector<Point> loose_ends(const CDT& meshed)
{
  std::vector<Point> ends;
  for (CDT::Vertex_handle v : meshed.finite_vertex_handles()) {
    int segments = 0;
    bool is_in_domain = false;
    CDT::Face_circulator f = meshed.incident_faces(v), begin = f;
    do {
      segments += f->is_constrained(CDT::ccw(f->index(v))); // each edge from one of its sides
      is_in_domain = is_in_domain || f->is_in_domain();
    } while (++f != begin);
    if (segments == 1 && !is_in_domain)
      ends.push_back(v->point());
  }
  std::sort(ends.begin(), ends.end());
  return ends;
}

/// what to say about them
inline std::string loose_ends_message(const std::vector<Point>& ends)
{
  return std::to_string(ends.size()) + (ends.size() == 1 ? " segment ends" : " segments end") +
         " loosely outside of the mesh, such as at " + in_words(ends.front()) + ": is an outline not closed?";
}

#endif // BUBBLE_RELAXATION_2_DEMO_MESH_WARNINGS_H
