// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// A hot body crosses a channel, turning, in 100 steps. Its constraints are taken out of the mesh and put in at the next
// place, npbs_adapt() makes the mesh anew where triangles do not fit then, and a step of the equation of heat starts
// from the temperatures that vertices keep or get from the old faces. All meshes become one animated picture.
//
//   moving_body [--steps N]

#include "carried_values.h"
#include "linear_finite_elements.h"
#include "mesh_animation.h"
#include "moving_hole.h"
#include "paper_domains.h"
#include "svg_picture.h"

#include <CGAL/Mesh_quality_2.h>
#include <CGAL/npbs_adapt.h>
#include <CGAL/npbs_relax.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <functional>
#include <iomanip>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <string>

namespace {

using paper::CDT;
using paper::Outline;
using paper::Point;

const Outline channel{{0, 0}, {4, 0}, {4, 1}, {0, 1}};

/// An ellipse at a place of its way, which it covers in a unit of time.
struct Body
{
  static constexpr double a = 0.12, b = 0.07, piece = 0.025;

  explicit Body(double time)
    : x(0.35 + 3.3 * time), y(0.5 + 0.2 * std::sin(2 * paper::pi * time)), cosine(std::cos(6 * time)),
      sine(std::sin(6 * time))
  {}

  Outline outline() const
  {
    constexpr int n = 24;
    Outline result;
    for (int i = 0; i < n; ++i) {
      const double u = a * std::cos(2 * paper::pi * i / n), v = b * std::sin(2 * paper::pi * i / n);
      result.push_back(Point(x + u * cosine - v * sine, y + u * sine + v * cosine));
    }
    return result;
  }

  /// about the distance, less where it is far
  double distance(const Point& p) const
  {
    const double dx = p.x() - x, dy = p.y() - y;
    return b * (std::hypot((dx * cosine + dy * sine) / a, (dy * cosine - dx * sine) / b) - 1);
  }

  /// d around it
  double size(const Point& p) const { return (std::min)(0.04, piece + 0.2 * (std::max)(0., distance(p))); }

  double x, y, cosine, sine;
};

/// A step of time of the equation of heat, u' = k div grad u: -div grad u + u / (k dt) = before / (k dt). The body has
/// the temperature 1, the walls have 0.
struct Heat_problem
{
  static constexpr double conductivity = 0.01;

  std::function<double(const Point&)> source, dirichlet;

  explicit Heat_problem(const Body& body)
    : dirichlet([&body](const Point& p) { return body.distance(p) < 0.5 * Body::piece ? 1. : 0.; })
  {}
};

struct Step
{
  std::size_t vertices = 0, new_vertices = 0;
  double minimum_quality = 1, seconds = 0, seconds_at_once = 0;
  Eigen::Index iterations = 0;
};

double seconds() { return double(std::clock()) / CLOCKS_PER_SEC; }

template <class Sizes>
double seconds_at_once(const Body& body, const Sizes& d)
{
  CDT cdt = paper::triangulate({channel, body.outline()});
  const double start = seconds();
  CGAL::npbs_relax(cdt, CGAL::parameters::sizing_function(d));
  return seconds() - start;
}

/// The mesh, the temperatures at its vertices, and where the body is.
class Moving_body
{
public:
  explicit Moving_body(int steps)
    : m_steps(steps), m_body(0), m_cdt(paper::triangulate({channel, m_body.outline()}))
  {
    CGAL::npbs_relax(m_cdt, CGAL::parameters::sizing_function(sizes()));
    set_temperatures([this](const Point& p) { return Heat_problem(m_body).dirichlet(p); });
  }

  Step move_to(int step)
  {
    constexpr double room = 0.8;     // of the pieces of the outline: what is nearer would be in the way
    constexpr double quality = 0.85; // what is worse is made anew
    Step result;
    const double start = seconds();
    m_body = Body(double(step) / m_steps);
    Moving_hole<CDT>& hole = m_hole ? *m_hole : m_hole.emplace(m_cdt, Body(0).outline());
    hole.on_removal = [this](CDT::Vertex_handle v) { m_carried.values.erase(v); };
    hole.move(m_body.outline(), room * Body::piece);
    for (CDT::Vertex_handle v : hole.vertices())
      m_carried.values[v] = 1;
    m_carried.number_of_new_vertices = 0;
    m_carried.seconds = 0;
    CGAL::npbs_adapt(m_cdt, CGAL::parameters::sizing_function(sizes()).misfit_quality(quality).visitor(
                              std::ref(m_carried)));
    result.seconds = seconds() - start - m_carried.seconds;
    result.seconds_at_once = seconds_at_once(m_body, sizes());
    result.new_vertices = m_carried.number_of_new_vertices;
    result.minimum_quality = CGAL::mesh_quality_2(m_cdt).minimum_quality();
    result.vertices = m_cdt.number_of_vertices();
    result.iterations = conduct();
    return result;
  }

  template <class Look>
  void look(const Look& look) const
  {
    const Triangle_arrays<CDT> mesh(m_cdt);
    look(m_cdt, mesh, m_carried.in_order(mesh), m_body.outline());
  }

private:
  /// refers to where the body is
  std::function<double(const Point&)> sizes() const
  {
    return [this](const Point& p) { return m_body.size(p); };
  }

  template <class Temperature>
  void set_temperatures(const Temperature& u)
  {
    for (CDT::Vertex_handle v : m_cdt.finite_vertex_handles())
      m_carried.values[v] = u(v->point());
  }

  Eigen::Index conduct()
  {
    constexpr double tolerance = 1e-10;
    const Triangle_arrays<CDT> mesh(m_cdt);
    const Eigen::VectorXd before = m_carried.in_order(mesh);
    Linear_element_system<CDT> system(mesh, Heat_problem(m_body));
    system.add_mass(m_steps / Heat_problem::conductivity, before);
    Eigen::Index iterations = 0;
    m_carried.set(mesh, system.solve(before, tolerance, iterations));
    return iterations;
  }

  int m_steps;
  Body m_body;
  CDT m_cdt;
  Carried_values<CDT> m_carried{m_cdt};
  std::optional<Moving_hole<CDT>> m_hole;
};

int read_arguments(int argc, char** argv)
{
  int steps = 100;
  if (argc == 3 && std::string(argv[1]) == "--steps")
    steps = std::atoi(argv[2]);
  if ((argc != 1 && argc != 3) || steps < 1 || steps > 10000 || (argc == 3 && std::string(argv[1]) != "--steps"))
    throw std::invalid_argument("usage: moving_body [--steps N], N from 1 to 10000");
  return steps;
}

/// some steps side by side, with triangles in the colour of their q
void add_panel(Svg_picture& picture, const CDT& cdt, int step)
{
  const double x = Body(step / 100.).x;
  picture.add_part_of_mesh(cdt, CGAL::Bbox_2(x - 0.5, 0, x + 0.5, 1), "step " + std::to_string(step));
}

} // namespace

int main(int argc, char** argv)
try {
  const int steps = read_arguments(argc, argv);
  Moving_body body(steps);
  Mesh_animation animation(CGAL::Bbox_2(0, 0, 4, 1));
  Svg_picture picture;
  const auto draw = [&](int step) {
    body.look([&](const CDT& cdt, const auto& mesh, const Eigen::VectorXd& values, const Outline& outline) {
      animation.add(mesh, values, outline);
      if (step * 4 % steps == 0 && 0 < step && step < steps)
        add_panel(picture, cdt, step * 100 / steps);
    });
  };
  draw(0);
  Step all, least;
  double share = 0;
  std::cout << " step  vertices     new  smallest q  milliseconds  at once  solver's steps\n" << std::fixed;
  for (int step = 1; step <= steps; ++step) {
    const Step s = body.move_to(step);
    draw(step);
    std::cout << std::setw(5) << step << std::setw(10) << s.vertices << std::setw(8) << s.new_vertices
              << std::setprecision(3) << std::setw(12) << s.minimum_quality << std::setprecision(1) << std::setw(14)
              << 1e3 * s.seconds << std::setw(9) << 1e3 * s.seconds_at_once << std::setw(16) << s.iterations << '\n';
    least.minimum_quality = (std::min)(least.minimum_quality, s.minimum_quality);
    all.seconds += s.seconds;
    all.seconds_at_once += s.seconds_at_once;
    share += double(s.new_vertices) / double(s.vertices) / steps;
  }
  animation.write("moving_body.svg", 12);
  picture.write("moving_body_steps.svg");
  std::cout << std::setprecision(3) << "smallest q of all meshes " << least.minimum_quality << ", new vertices "
            << 100 * share << " % a step, time " << all.seconds / all.seconds_at_once << " of that for all anew\n";
} catch (const std::exception& e) {
  std::cerr << "moving_body: " << e.what() << '\n';
  return EXIT_FAILURE;
}
