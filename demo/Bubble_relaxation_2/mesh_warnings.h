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
#include "mesh_options.h"

#include <CGAL/Bubble_relaxation_report_2.h>
#include <CGAL/radius_ratio_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

// What npbs_mesh and distributed_mesh tell and warn of when they have made a mesh.

using Report = CGAL::Bubble_relaxation_report_2<double>;

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

inline void print_statistics(const Report& report)
{
  const auto row = [](const std::string& name) -> std::ostream& {
    return std::cout << "  " << name << std::string(36 - name.size(), ' ');
  };
  const auto print_small_angles = [&row](const std::string& where, std::size_t number, double x, double y) {
    row("small angles " + where) << number;
    if (number > 0)
      std::cout << ", the smallest at " << in_words(Point(x, y));
    std::cout << '\n';
  };
  std::cout << report.quality;
  row("worst triangle, at") << ' ' << in_words(Point(report.quality.worst_x(), report.quality.worst_y())) << '\n';
  row("vertices that d alone asks for") << report.number_of_wanted_vertices << '\n';
  row("largest change of d per length") << report.largest_size_gradient << '\n';
  print_small_angles("at sharp corners", report.number_of_forced_triangles, report.forced_x, report.forced_y);
  print_small_angles("elsewhere", report.number_of_small_angles, report.small_x, report.small_y);
  row("steps") << report.number_of_steps << '\n';
  row("converged") << (report.converged ? "yes" : "no") << '\n';
  row("seconds") << report.seconds.total() << '\n';
}

/// what makes an outline force fewer vertices
inline std::string advice_on_outline(const po::variables_map& arguments)
{
  constexpr double usual = 0.1; // leaves pieces about as long as d; a smaller one needs short pieces where it bends
  if (!is_simplified(arguments))
    return "--tolerance 0.1 replaces it, but for pins, by one with longer pieces";
  const std::string longer = "a larger tolerance, such as a tenth of --size, makes pieces longer where it bends, ";
  const bool is_small = arguments.count("absolute-tolerance") > 0 || arguments["tolerance"].as<double>() < usual;
  return (is_small ? longer : "") +
         "larger --min-island and --min-gap take islands and narrows away, if there are any";
}

/// what to say if most of the vertices are there for the outline, and what can be done
inline std::string forced_by_outline_message(const Report& report, const po::variables_map& arguments)
{
  std::ostringstream text;
  text << "--size alone asks for about " << report.number_of_wanted_vertices << " vertices, the outline forces "
       << report.number_of_vertices - report.number_of_wanted_vertices
       << " more, where it is finer or narrower, most near";
  constexpr std::size_t most_places = 3;
  for (std::size_t k = 0; k < most_places && report.forced_places[k].number_of_vertices > 0; ++k)
    text << (k > 0 ? "," : "") << ' ' << in_words(Point(report.forced_places[k].x, report.forced_places[k].y));
  text << "; " << advice_on_outline(arguments);
  if (arguments["size-growth"].as<double>() < 1)
    text << ", a larger --size-growth makes fewer triangles, and worse ones";
  return text.str();
}

/// says so, if the user has asked for a size and wants to hear of it
inline void hint_at_outline(const std::string& program, const po::variables_map& arguments, const Report& report)
{
  if (arguments.count("quiet") == 0 && arguments.count("size") > 0 && report.is_forced_by_outline())
    std::cerr << program << ": hint: " << input_name(arguments) << ": " << forced_by_outline_message(report, arguments)
              << '\n';
}

/// what to say if --minimum-angle was not kept
inline std::string small_angles_message(const Report& report, double minimum_angle)
{
  std::ostringstream text;
  text << report.number_of_small_angles << (report.number_of_small_angles == 1 ? " triangle has" : " triangles have")
       << " an angle under --minimum-angle " << minimum_angle << " that no sharp corner forces, the smallest at "
       << in_words(Point(report.small_x, report.small_y))
       << ": to refine them would take too many vertices, make a smaller angle, or there is no room; a smaller "
          "--minimum-angle or --size-growth may be kept";
  return text.str();
}

/// what to say about sizes that change faster than a mesh can follow
inline std::string steep_message(const Report& report)
{
  std::ostringstream text;
  text.precision(3);
  text << "d changes by " << report.largest_size_gradient << " per unit of length at "
       << in_words(Point(report.steepest_x, report.steepest_y)) << ", and along " << 100 * report.steep_share
       << " % of all edges by more than " << Report::steep_size_gradient
       << ", which makes bad triangles; --gradation 0.2 limits it";
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
    const Point place = is_corner() ? m_face->vertex(m_corner)->point() : CGAL::centroid(m_domain.cdt.triangle(m_face));
    std::ostringstream text;
    text.precision(4);
    text << (is_corner() ? "the triangle in the corner " : "the triangle at ") << in_words(place) << " has an angle of "
         << m_angle << " degrees, q = " << quality(m_face) << ": " << cause();
    if (size)
      text << "; d is " << size(place) << " there";
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

  std::string cause() const
  {
    std::ostringstream text;
    text.precision(4);
    if (is_corner())
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

/// The points outside of the mesh in which so many segments end. If it is one, inside this is a crack; outside, the
/// outline that it belongs to was perhaps meant to be closed, and bounds nothing as it is. If none does, somebody wanted
/// a node there.
inline std::vector<Point> points_outside(const CDT& meshed, int wanted_segments)
{
  std::vector<Point> points;
  for (CDT::Vertex_handle v : meshed.finite_vertex_handles()) {
    int segments = 0;
    bool is_in_domain = false;
    CDT::Face_circulator f = meshed.incident_faces(v), begin = f;
    do {
      segments += f->is_constrained(CDT::ccw(f->index(v))); // each edge from one of its sides
      is_in_domain = is_in_domain || f->is_in_domain();
    } while (++f != begin);
    if (segments == wanted_segments && !is_in_domain)
      points.push_back(v->point());
  }
  std::sort(points.begin(), points.end());
  return points;
}

/// what to say about points that are no nodes
inline std::string points_outside_message(const std::vector<Point>& points)
{
  return std::to_string(points.size()) + (points.size() == 1 ? " point lies" : " points lie") +
         " outside of the mesh, such as " + in_words(points.front());
}

/// what to say about ends of segments
inline std::string loose_ends_message(const std::vector<Point>& ends)
{
  return std::to_string(ends.size()) + (ends.size() == 1 ? " segment ends" : " segments end") +
         " loosely outside of the mesh, such as at " + in_words(ends.front()) + ": is an outline not closed?";
}

/// the vertices with more than two edges of the boundary, where parts of the domain only touch
inline std::vector<Point> touching_places(const CDT& meshed)
{
  std::vector<Point> points;
  for (CDT::Vertex_handle v : meshed.finite_vertex_handles()) {
    int edges = 0;
    CDT::Face_circulator f = meshed.incident_faces(v), begin = f;
    do
      edges += f->is_in_domain() != f->neighbor(CDT::ccw(f->index(v)))->is_in_domain(); // each from one of its sides
    while (++f != begin);
    if (edges > 2)
      points.push_back(v->point());
  }
  std::sort(points.begin(), points.end());
  return points;
}

/// what to say about those to somebody who writes a file for a model of oceans
inline std::string touching_message(const std::vector<Point>& places)
{
  return std::to_string(places.size()) + (places.size() == 1 ? " node has" : " nodes have") +
         " more than two edges of the boundary, such as that at " + in_words(places.front()) +
         ": models of oceans do not take them; --min-gap fills narrows";
}

#endif // BUBBLE_RELAXATION_2_DEMO_MESH_WARNINGS_H
