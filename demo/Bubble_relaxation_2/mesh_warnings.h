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

#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_marks_2.h>
#include <CGAL/Bubble_relaxation_report_2.h>

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
inline std::string small_angles_message(const Report& report, const po::variables_map& arguments)
{
  const double minimum_angle = arguments["minimum-angle"].as<double>();
  const bool has_protected = !arguments["protect"].as<std::string>().empty();
  std::ostringstream text;
  text << report.number_of_small_angles << (report.number_of_small_angles == 1 ? " triangle has" : " triangles have")
       << " an angle under --minimum-angle " << minimum_angle << " that no sharp corner forces, the smallest at "
       << in_words(Point(report.small_x, report.small_y))
       << ": to refine them would take too many vertices, make a smaller angle, or there is no room"
       << (has_protected ? ", as beside segments far longer than d that --protect keeps; protect fewer, or " : "; ")
       << "a smaller --minimum-angle or --size-growth may be kept";
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

/// `warn(text)` is called for what the report tells that should not be in a mesh.
template <class Warn>
void warn_of_report(const Report& report, const po::variables_map& arguments, Warn&& warn)
{
  if (report.steep_share > 0)
    warn(steep_message(report));
  const bool is_refined = arguments.count("paper") == 0 && report.number_of_steps > 0 &&
                          report.stop_reason != CGAL::Bubble_stop_reason::STOPPED_BY_CALLBACK;
  if (is_refined && report.number_of_small_angles > 0)
    warn(small_angles_message(report, arguments));
}

/// whether elements like this are known to spoil computations
inline bool is_bad(double smallest_angle, double smallest_quality)
{
  return smallest_angle < 20 || smallest_quality < 0.3;
}

/// the same of bad triangles, where nothing but the report is known of them
template <class Warn>
void warn_of_worst_triangle(const Report& report, Warn&& warn)
{
  const auto& quality = report.quality;
  if (quality.number_of_triangles() == 0 || !is_bad(quality.minimum_angle(), quality.minimum_quality()))
    return;
  std::ostringstream text;
  text.precision(4);
  text << "the triangle at " << in_words(Point(quality.worst_x(), quality.worst_y())) << " has q = "
       << quality.minimum_quality() << ", the smallest angle is " << quality.minimum_angle() << " degrees";
  warn(text.str());
}

/// The points outside of the domain in which so many segments end. If it is one, inside this is a crack; outside, the
/// outline that it belongs to was perhaps meant to be closed, and bounds nothing as it is. If none does, somebody
/// wanted a node there.
inline std::vector<Point> points_outside(const CDT& cdt, int wanted_segments)
{
  const CGAL::Bubble_relaxation_2::internal::Domain_marks_2<CDT> marks(cdt, CGAL::parameters::default_values());
  std::vector<Point> points;
  for (CDT::Vertex_handle v : cdt.finite_vertex_handles()) {
    int segments = 0;
    bool is_in_domain = false;
    CDT::Face_circulator f = cdt.incident_faces(v), begin = f;
    do {
      segments += f->is_constrained(CDT::ccw(f->index(v))); // each edge from one of its sides
      is_in_domain = is_in_domain || marks(f);
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

/// `warn(text)` is called for what lies outside of a domain, meshed or not, and was perhaps meant to be in it.
template <class Warn>
void warn_of_what_is_outside(const CDT& cdt, Warn&& warn)
{
  const std::vector<Point> ends = points_outside(cdt, 1), lonely = points_outside(cdt, 0);
  if (!ends.empty())
    warn(loose_ends_message(ends));
  if (!lonely.empty())
    warn(points_outside_message(lonely));
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
