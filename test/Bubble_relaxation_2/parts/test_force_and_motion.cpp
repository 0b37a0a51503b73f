// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// The force of eq. 2, the integrators of eq. 3, and the boundary, as they are seen in where nodes go step by step.

#include "domains.h"
#include "random_seeds.h"
#include "validation.h"

#include <CGAL/npbs_place_nodes.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace test_force_and_motion {

namespace P = CGAL::parameters;
using domains::CDT;
using domains::Outline;
using domains::Point;
using Size = std::function<double(const Point&)>;
using Nodes = CGAL::Node_set_2<Point>;

Size uniform(double d)
{
  return [d](const Point&) { return d; };
}

/// the bubbles that are given, after some steps; no other ones come, and none go
template <class Parameters>
Nodes after_steps(const CDT& cdt, const Size& size, int steps, const Parameters& np)
{
  return CGAL::npbs_place_nodes(cdt, np.sizing_function(size)
                                       .initial_placement(CGAL::Bubble_placement::KEEP)
                                       .population_control(CGAL::Bubble_population::NONE)
                                       .defect_treatment(false).limit_by_outline(false)
                                       .displacement_tolerance(0).number_of_rounds(1).number_of_iterations(steps));
}

/// the nodes in faces, which are as many as the free vertices and in the order of x
std::vector<Point> free_nodes(const Nodes& nodes)
{
  std::vector<Point> result;
  for (std::size_t i = 0; i < nodes.size(); ++i)
    if (nodes.dimensions[i] == 2)
      result.push_back(nodes.points[i]);
  std::sort(result.begin(), result.end());
  return result;
}

/// free vertices in the middle of a square from -1 to 1: its outline is far away from them
CDT bubbles_at(const std::vector<Point>& points)
{
  CDT cdt = domains::make({domains::square(-1, -1, 2)});
  cdt.insert(points.begin(), points.end());
  return cdt;
}

CDT pair_at(double distance) { return bubbles_at({Point(-0.5 * distance, 0.03), Point(0.5 * distance, 0.03)}); }

/// how far apart two bubbles are after some steps
template <class Parameters>
double distance_after(const CDT& cdt, double d, int steps, const Parameters& np)
{
  const std::vector<Point> p = free_nodes(after_steps(cdt, uniform(d), steps, np));
  EXPECT_EQ(p.size(), 2u);
  return p[1].x() - p[0].x();
}

/// eq. 2
double force(double w) { return w <= 1.5 ? 1.25 * w * w * w - 2.375 * w * w + 1.125 : 0; }

TEST(Bubble_force, has_the_values_of_equation_2)
{
  const double d = 0.1, h = 1e-3;
  for (double k0 : {1., 3.})
    for (double w = 0.02; w < 1.7; w += 0.02) {
      const std::vector<Point> p =
        free_nodes(after_steps(pair_at(w * d), uniform(d), 1, P::time_step(h).force_coefficient(k0)));
      ASSERT_EQ(p.size(), 2u);
      // one step from rest goes as far as h^2 d F
      const double expected = h * h * d * k0 * force(w);
      EXPECT_NEAR(p[1].x() - 0.5 * w * d, expected, 1e-16) << w;
      EXPECT_NEAR(p[0].x() + 0.5 * w * d, -expected, 1e-16) << w;
      EXPECT_EQ(p[0].y(), 0.03);
      EXPECT_EQ(p[1].y(), 0.03);
    }
  EXPECT_GT(force(0.99), 0);
  EXPECT_LT(force(1.01), 0);
  EXPECT_NEAR((force(1 + 1e-6) - force(1 - 1e-6)) / 2e-6, -1, 1e-6); // the stiffness of a packing
}

TEST(Bubble_force, is_opposite_for_bubbles_of_different_sizes)
{
  const Size size = [](const Point& p) { return p.x() < 0 ? 0.1 : 0.05; };
  const double h = 1e-2, w = 0.04 / 0.075; // the wanted distance is the mean of both
  const std::vector<Point> p = free_nodes(after_steps(pair_at(0.04), size, 1, P::time_step(h)));
  ASSERT_EQ(p.size(), 2u);
  EXPECT_NEAR(p[0].x() + 0.02, -h * h * 0.1 * force(w), 1e-16);
  EXPECT_NEAR(p[1].x() - 0.02, h * h * 0.05 * force(w), 1e-16);
}

TEST(Bubble_force, is_zero_in_a_lattice)
{
  std::vector<Point> lattice;
  for (int i = -4; i <= 4; ++i)
    for (int j = -4; j <= 4; ++j)
      lattice.push_back(Point(0.1 * (i + 0.5 * j), 0.1 * std::sqrt(0.75) * j));
  const Nodes nodes = after_steps(bubbles_at(lattice), uniform(0.1), 1, P::time_step(0.6));
  std::size_t at_rest = 0, moved = 0;
  for (const Point& p : lattice) {
    double least = 1;
    for (const Point& q : nodes.points)
      least = (std::min)(least, std::sqrt(CGAL::squared_distance(p, q)));
    least < 1e-15 ? ++at_rest : ++moved;
  }
  // the next neighbours have the wanted distance, and those after them are farther than 1.5 times that: only in the
  // last digits is there a force
  EXPECT_EQ(at_rest, lattice.size()) << moved;
}

TEST(Bubble_force, parts_bubbles_as_near_as_may_be)
{
  // the smallest distance that input may have
  const double d = 0.1, h = 0.01;
  const std::vector<Point> p =
    free_nodes(after_steps(bubbles_at({Point(0, 0), Point(1e-90, 0)}), uniform(d), 1, P::time_step(h)));
  ASSERT_EQ(p.size(), 2u);
  EXPECT_NEAR(p[0].x(), -1.125 * h * h * d, 1e-18);
  EXPECT_NEAR(p[1].x(), 1.125 * h * h * d, 1e-18);
  EXPECT_EQ(p[0].y(), 0);
}

TEST(Semi_implicit_euler, goes_by_its_formula_in_units_of_d)
{
  const double d = 0.1, h = 0.5, c = 0.3, m = 2, k0 = 1.5;
  double x = 0.9 * d, v = 0; // the distance, and how fast each goes, in units of d
  for (int steps = 1; steps <= 12; ++steps) {
    v = (1 - h * c / m) * v + h * k0 / m * force(x / d);
    x += 2 * h * d * v;
    EXPECT_NEAR(distance_after(pair_at(0.9 * d), d, steps, P::time_step(h).damping(c).mass(m).force_coefficient(k0)), x,
                1e-14)
      << steps;
  }
}

TEST(Runge_kutta, is_of_fourth_order)
{
  // two bubbles swing about their wanted distance; halving the step divides the error by 16
  const auto after = [](int steps) {
    return distance_after(pair_at(0.27), 0.3, steps,
                          P::integrator(CGAL::Bubble_integrator::RUNGE_KUTTA_4).time_step(0.4 / steps).damping(0.5));
  };
  const double exact = after(512);
  double error = std::abs(after(4) - exact);
  for (int steps : {8, 16}) {
    const double smaller = std::abs(after(steps) - exact);
    EXPECT_GT(error / smaller, 13);
    EXPECT_LT(error / smaller, 20);
    error = smaller;
  }
}

TEST(Runge_kutta, solves_the_equation_of_motion)
{
  // in units of length, with small steps of another method
  const double d = 0.3, c = 0.7, m = 1.3, k0 = 0.8, end = 0.4;
  double x = 0.24, v = 0;
  const int steps = 200000;
  for (int k = 0; k < steps; ++k) {
    v += end / steps * (k0 * force(x / d) - c * v) / m;
    x += 2 * end / steps * v;
  }
  EXPECT_NEAR(distance_after(pair_at(0.24), d, 20,
                             P::integrator(CGAL::Bubble_integrator::RUNGE_KUTTA_4).time_step(end / 20).damping(c)
                               .mass(m).force_coefficient(k0)),
              x, 1e-6);
}

TEST(Integrators, both_bring_a_pair_to_its_wanted_distance)
{
  EXPECT_NEAR(distance_after(pair_at(0.08), 0.1, 300, P::mass(1.)), 0.1, 1e-9);
  EXPECT_NEAR(distance_after(pair_at(0.08), 0.1, 2000, P::integrator(CGAL::Bubble_integrator::RUNGE_KUTTA_4)), 0.1,
              1e-4);
}

TEST(Boundary, face_bubbles_that_leave_are_put_back_at_a_distance)
{
  // two of them, one below the other; the lower one is pushed out of the square, and put back half a bubble from it
  CDT cdt = domains::make({domains::square(-1, 0, 2)});
  cdt.insert(Point(0.1, 0.02)); // between two bubbles of the edge
  cdt.insert(Point(0.1, 0.07));
  const Nodes nodes = after_steps(cdt, uniform(0.2), 1, P::time_step(100.));
  EXPECT_EQ(nodes.report.number_of_returns, 1u);
  const std::vector<Point> p = free_nodes(nodes);
  ASSERT_EQ(p.size(), 2u);
  EXPECT_NEAR((std::min)(p[0].y(), p[1].y()), 0.5 * 0.2, 1e-15);
}

TEST(Boundary, no_step_is_longer_than_0_3_d)
{
  std::mt19937 random(random_seeds::seed());
  std::uniform_real_distribution<double> uniform_in(-0.9, 0.9);
  std::vector<Point> points;
  for (int i = 0; i < 300; ++i)
    points.push_back(Point(uniform_in(random), uniform_in(random)));
  const CDT cdt = bubbles_at(points);
  const double d = 0.15;
  for (double h : {0.6, 10., 1e8}) {
    const Nodes before = after_steps(cdt, uniform(d), 0, P::time_step(h));
    const Nodes after = after_steps(cdt, uniform(d), 1, P::time_step(h));
    ASSERT_EQ(after.size(), before.size());
    ASSERT_EQ(after.dimensions, before.dimensions);
    std::size_t longest = 0;
    for (std::size_t i = 0; i < after.size(); ++i) {
      const double step = std::sqrt(CGAL::squared_distance(before.points[i], after.points[i]));
      if (before.dimensions[i] == 0) {
        EXPECT_EQ(step, 0);
      } else if (1 - std::abs(before.points[i].x()) > 0.9 * d && 1 - std::abs(before.points[i].y()) > 0.9 * d) {
        EXPECT_LE(step, 0.3 * d * (1 + 1e-14)); // no bubble near an edge, which is put back
      }
      longest += step > 0.3 * d * (1 - 1e-14);
    }
    EXPECT_GT(longest, 100u); // of 300
  }
}

/// a domain, constraints in it, and how fine
struct Trap
{
  std::string name;
  std::vector<Outline> outlines, inner;
  double d;
};

std::vector<Trap> traps()
{
  const double pi = 3.14159265358979;
  Outline star, spiral;
  for (int i = 0; i < 16; ++i) {
    const double r = i % 2 == 0 ? 1 : 0.3;
    star.push_back({r * std::cos(pi * i / 8), r * std::sin(pi * i / 8)});
  }
  for (int i = 0; i <= 20; ++i)
    spiral.push_back({(0.4 + 0.03 * i) * std::cos(0.4 * i), (0.4 + 0.03 * i) * std::sin(0.4 * i)});
  for (int i = 20; i >= 0; --i)
    spiral.push_back({(0.25 + 0.03 * i) * std::cos(0.4 * i), (0.25 + 0.03 * i) * std::sin(0.4 * i)});
  const Outline box = domains::square(-1, -1, 2);
  return {{"convex", {box}, {}, 0.15},
          {"reflex corners", {star}, {}, 0.12},
          {"reflex corner in a room",
           {{{-1, -1}, {1, -1}, {1, 1}, {0.01, 1}, {0, -0.9}, {-0.01, 1}, {-1, 1}}}, {}, 0.15},
          {"slits", {box, {{-0.8, 0}, {0.8, 1e-9}, {0.8, 0}}, {{0, 0.1}, {1e-9, 0.9}, {0, 0.9}}}, {}, 0.15},
          {"band", {spiral}, {}, 0.1},
          {"needle", {{{-1, 0}, {1, 0}, {1, 0.2}}}, {}, 0.2},
          {"inner constraints", {box},
           {{{-1, 0.1}, {1, -0.2}}, {{-0.3, 1}, {-0.3, 0.3}}, {{0.5, -1}, {0.4, -0.3}}}, 0.15},
          {"chambers", {box}, {{{-1, -1}, {0, 0}, {1, 1}}, {{1, -1}, {0, 0}, {-1, 1}}}, 0.15}};
}

/// the component of the domain that a point is in, by any face of it; faces are joined where no constraint is between
class Chambers
{
public:
  explicit Chambers(const CDT& cdt) : m_cdt(cdt)
  {
    int next = 0;
    for (CDT::Face_handle start : cdt.all_face_handles()) {
      if (m_of_face.count(start) > 0)
        continue;
      std::vector<CDT::Face_handle> front{start};
      bool is_outer = false;
      while (!front.empty()) {
        const CDT::Face_handle f = front.back();
        front.pop_back();
        if (!m_of_face.emplace(f, next).second)
          continue;
        is_outer = is_outer || cdt.is_infinite(f);
        for (int i = 0; i < 3; ++i)
          if (!f->is_constrained(i))
            front.push_back(f->neighbor(i));
      }
      if (is_outer)
        m_outer = next;
      ++next;
    }
  }

  /// no chamber, if it is outside or on a constraint
  int operator()(const Point& p) const
  {
    CDT::Locate_type type;
    int i;
    const CDT::Face_handle f = m_cdt.locate(p, type, i);
    if (type == CDT::VERTEX || (type == CDT::EDGE && f->is_constrained(i)) || m_of_face.at(f) == m_outer)
      return -1;
    return m_of_face.at(f);
  }

private:
  const CDT& m_cdt;
  std::map<CDT::Face_handle, int> m_of_face;
  int m_outer = -1;
};

class In_a_trap : public testing::TestWithParam<std::size_t>
{};

/// However wildly bubbles are thrown about: those of faces stay in their chamber, which constraints bound, and not on
/// these; those of edges stay on their edges and do not come near its ends; and those of vertices stay.
TEST_P(In_a_trap, no_bubble_ever_leaves)
{
  const Trap trap = traps()[GetParam()];
  SCOPED_TRACE(trap.name);
  CDT bare = domains::make(trap.outlines);
  for (const Outline& o : trap.inner)
    domains::insert(bare, o, false);
  const validation::Snapshot outline = validation::snapshot(bare);
  const Chambers chambers(bare);
  std::mt19937 random(random_seeds::seed());
  std::uniform_real_distribution<double> uniform_in(-1, 1);
  CDT cdt = bare;
  std::map<int, std::size_t> expected;
  while (cdt.number_of_vertices() < bare.number_of_vertices() + 300) {
    const Point p(uniform_in(random), uniform_in(random));
    const int chamber = chambers(p);
    if (chamber < 0)
      continue;
    cdt.insert(p);
    ++expected[chamber];
  }
  std::size_t returns = 0;
  for (double h : {0.6, 5., 1e6})
    for (auto integrator : {CGAL::Bubble_integrator::SEMI_IMPLICIT_EULER, CGAL::Bubble_integrator::RUNGE_KUTTA_4})
      for (int steps : {1, 2, 5, 20, 60}) {
        SCOPED_TRACE(testing::Message() << "time step " << h << ", " << steps << " steps");
        const Nodes nodes =
          after_steps(cdt, uniform(trap.d), steps, P::integrator(integrator).time_step(h).damping(0.05));
        returns += nodes.report.number_of_returns;
        std::map<int, std::size_t> found;
        std::set<validation::Xy> corners;
        for (std::size_t i = 0; i < nodes.size(); ++i) {
          const validation::Xy p{nodes.points[i].x(), nodes.points[i].y()};
          if (nodes.dimensions[i] == 2)
            ++found[chambers(nodes.points[i])];
          else if (nodes.dimensions[i] == 0)
            corners.insert(p);
          else {
            const auto edge = std::find_if(
              outline.constraints.begin(), outline.constraints.end(), [&](const validation::Segment& s) {
                const double length = validation::length(s), margin = (std::min)(0.499 * nodes.sizes[i], 0.333 * length);
                return validation::off(s, p) < 1e-15 && validation::along(s, p) >= margin &&
                       validation::along(s, p) <= length - margin;
              });
            EXPECT_TRUE(edge != outline.constraints.end()) << nodes.points[i];
          }
        }
        EXPECT_EQ(found, expected);
        EXPECT_EQ(corners, outline.vertices);
      }
  EXPECT_GT(returns, 500u) << "the boundary was not tried";
}

INSTANTIATE_TEST_SUITE_P(All, In_a_trap, testing::Range(std::size_t(0), traps().size()));

} // namespace test_force_and_motion
