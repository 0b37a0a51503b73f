// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// The force of eq. 2, the integrators of eq. 3, and the boundary.

#include "random_seeds.h"
#include "validation.h"

#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_2.h>
#include <CGAL/Bubble_relaxation_2/internal/simulation/integrators.h>

using namespace CGAL::Bubble_relaxation_2::internal;

namespace {

Domain_2 unit_square()
{
  Domain_2 domain;
  EXPECT_EQ(domain.build({Point(0, 0), Point(1, 0), Point(1, 1), Point(0, 1)},
                         {{0, 1, true, false}, {1, 2, true, false}, {2, 3, true, false},
                          {3, 0, true, false}}),
            Marking_error::NONE);
  return domain;
}

/// two bubbles in the middle of the square, at `distance`
Bubbles_2 pair_at(const Domain_2& domain, double distance, double d)
{
  Bubbles_2 b;
  for (double x : {0.5 - 0.5 * distance, 0.5 + 0.5 * distance}) {
    const Point p(x, 0.41);
    b.add(p, d, Bubbles_2::FACE, domain.locate(p, 0));
  }
  return b;
}

} // namespace

TEST(Bubble_force, has_the_values_of_equation_2)
{
  const Bubble_force_2 force{1};
  EXPECT_DOUBLE_EQ(force(0), 1.125);
  EXPECT_NEAR(force(1), 0, 1e-15);
  EXPECT_NEAR(force(1.5), 0, 1e-15);
  EXPECT_EQ(force(1.5000001), 0);
  EXPECT_EQ(force(7), 0);
  EXPECT_DOUBLE_EQ(force(0.5), 1.25 * 0.125 - 2.375 * 0.25 + 1.125);
  for (double w = 0.01; w < 1; w += 0.01)
    EXPECT_GT(force(w), 0) << w;
  for (double w = 1.01; w < 1.5; w += 0.01)
    EXPECT_LT(force(w), 0) << w;
  EXPECT_NEAR((force(1 + 1e-6) - force(1 - 1e-6)) / 2e-6, -1, 1e-6); // the stiffness of a packing
  EXPECT_DOUBLE_EQ((Bubble_force_2{3}(0.5)), 3 * force(0.5));
}

TEST(Resultant_force, is_opposite_for_a_pair_and_zero_in_a_lattice)
{
  Bubbles_2 b;
  for (int i = 0; i < 7; ++i)
    for (int j = 0; j < 7; ++j)
      b.add(Point(0.1 * (i + 0.5 * j), 0.1 * 0.86602540378443865 * j), 0.1, Bubbles_2::FACE, 0);
  Neighbor_sets_2 sets(1.7);
  sets.build(b);
  const Force f = resultant_force(Bubble_force_2{1}, sets, b.x.data(), b.y.data(), b.d.data(), 24);
  EXPECT_NEAR(f.x, 0, 1e-14);
  EXPECT_NEAR(f.y, 0, 1e-14);

  Bubbles_2 pair;
  pair.add(Point(0, 0), 1, Bubbles_2::FACE, 0);
  pair.add(Point(0.3, 0.4), 0.5, Bubbles_2::FACE, 0);
  sets.build(pair);
  const Force f0 = resultant_force(Bubble_force_2{2}, sets, pair.x.data(), pair.y.data(), pair.d.data(), 0);
  const Force f1 = resultant_force(Bubble_force_2{2}, sets, pair.x.data(), pair.y.data(), pair.d.data(), 1);
  EXPECT_EQ(f0.x, -f1.x);
  EXPECT_EQ(f0.y, -f1.y);
  EXPECT_NEAR(std::hypot(f0.x, f0.y), Bubble_force_2{2}(0.5 / 0.75), 1e-14);
  EXPECT_LT(f0.x, 0);
}

TEST(Resultant_force, parts_bubbles_in_one_place)
{
  Bubbles_2 b;
  b.add(Point(0.2, 0.2), 1, Bubbles_2::FACE, 0);
  b.add(Point(0.2, 0.2), 1, Bubbles_2::FACE, 0);
  Neighbor_sets_2 sets(1.7);
  sets.build(b);
  const Force f0 = resultant_force(Bubble_force_2{1}, sets, b.x.data(), b.y.data(), b.d.data(), 0);
  const Force f1 = resultant_force(Bubble_force_2{1}, sets, b.x.data(), b.y.data(), b.d.data(), 1);
  EXPECT_EQ(f0.x, -1.125);
  EXPECT_EQ(f1.x, 1.125);
}

TEST(Runge_kutta, is_of_fourth_order)
{
  // two bubbles swing about their wanted distance; halving the step divides the error by 16
  const Domain_2 domain = unit_square();
  const Boundary_2 boundary(domain);
  const auto distance_after = [&](double dt, int steps) {
    Relaxation_options o;
    o.time_step = dt;
    o.mass = 1;
    o.damping = 0.5;
    Bubbles_2 b = pair_at(domain, 0.27, 0.3);
    Neighbor_sets_2 sets(1.7);
    sets.build(b);
    Runge_kutta_4<CGAL::Sequential_tag> rk(o);
    Displacements displacements;
    for (int k = 0; k < steps; ++k) {
      rk(b, {0, 1}, sets, boundary, displacements);
      for (std::size_t i = 0; i < b.size(); ++i)
        boundary.move(b, i, displacements.x[i], displacements.y[i]);
    }
    return b.x[1] - b.x[0];
  };
  const double exact = distance_after(0.4 / 512, 512);
  double error = std::abs(distance_after(0.1, 4) - exact);
  for (int steps : {8, 16}) {
    const double smaller = std::abs(distance_after(0.4 / steps, steps) - exact);
    EXPECT_GT(error / smaller, 13);
    EXPECT_LT(error / smaller, 20);
    error = smaller;
  }
}

TEST(Semi_implicit_euler, goes_by_its_formula_in_units_of_d)
{
  const Domain_2 domain = unit_square();
  const Boundary_2 boundary(domain);
  Relaxation_options o;
  o.damping = 0.3;
  o.time_step = 0.5;
  const double d = 0.1, w = 0.9;
  Bubbles_2 b = pair_at(domain, w * d, d);
  Neighbor_sets_2 sets(1.7);
  sets.build(b);
  b.vx[1] = 0.2;
  Displacements displacements;
  Semi_implicit_euler<CGAL::Sequential_tag>{o}(b, {0, 1}, sets, boundary, displacements);
  const double v = (1 - 0.5 * 0.3) * 0.2 + 0.5 * Bubble_force_2{1}(w);
  EXPECT_NEAR(b.vx[1], v, 1e-12);
  EXPECT_NEAR(displacements.x[1], 0.5 * d * v, 1e-13);
}

TEST(Integrators, both_bring_a_pair_to_its_wanted_distance)
{
  const Domain_2 domain = unit_square();
  const Boundary_2 boundary(domain);
  const auto settle = [&](auto integrator, int steps) {
    Bubbles_2 b = pair_at(domain, 0.08, 0.1);
    Neighbor_sets_2 sets(1.7);
    sets.build(b);
    Displacements displacements;
    for (int k = 0; k < steps; ++k) {
      integrator(b, {0, 1}, sets, boundary, displacements);
      for (std::size_t i = 0; i < b.size(); ++i)
        boundary.move(b, i, displacements.x[i], displacements.y[i]);
    }
    return b.x[1] - b.x[0];
  };
  Relaxation_options exact, paper;
  paper.time_step = 0.02;
  paper.damping = 3.8429;
  EXPECT_NEAR(settle(Semi_implicit_euler<CGAL::Sequential_tag>(exact), 300), 0.1, 1e-9);
  EXPECT_NEAR(settle(Runge_kutta_4<CGAL::Sequential_tag>(paper), 2000), 0.1, 1e-4);
}

TEST(Boundary, corners_do_not_move)
{
  const Domain_2 domain = unit_square();
  Bubbles_2 b;
  b.add(Point(0, 0), 0.1, Bubbles_2::CORNER, 0);
  Boundary_2(domain).move(b, 0, 0.02, 0.03);
  EXPECT_EQ(b.x[0], 0);
  EXPECT_EQ(b.y[0], 0);
}

TEST(Boundary, edge_bubbles_slide_and_do_not_pass_the_ends)
{
  const Domain_2 domain = unit_square();
  const Boundary_2 boundary(domain);
  Bubbles_2 b;
  b.add(domain.point_on_edge(1, 0.5), 0.1, Bubbles_2::EDGE, 1, 0.5); // the right side
  boundary.move(b, 0, 0.02, 0.01);
  EXPECT_EQ(b.x[0], 1);
  EXPECT_NEAR(b.y[0], 0.51, 1e-15);
  for (int k = 0; k < 100; ++k)
    boundary.move(b, 0, 0, 0.03);
  EXPECT_EQ(b.x[0], 1);
  EXPECT_LE(b.y[0], 1 - 0.049);
  EXPECT_GE(b.y[0], 0.9);
  for (int k = 0; k < 100; ++k)
    boundary.move(b, 0, 0, -0.03);
  EXPECT_GE(b.y[0], 0.049);
}

TEST(Boundary, face_bubbles_that_leave_are_put_back_at_a_distance)
{
  const Domain_2 domain = unit_square();
  const Boundary_2 boundary(domain);
  Bubbles_2 b;
  const Point start(0.5, 0.02);
  b.add(start, 0.1, Bubbles_2::FACE, domain.locate(start, 0));
  b.vy[0] = -1;
  EXPECT_TRUE(boundary.move(b, 0, 0.005, -0.025));
  EXPECT_NEAR(b.x[0], 0.505, 1e-12);
  EXPECT_NEAR(b.y[0], Boundary_2::return_distance * 0.1, 1e-12);
  EXPECT_EQ(b.vy[0], 0);
  EXPECT_TRUE(domain.is_inside(b.place[0]));
  EXPECT_FALSE(boundary.move(b, 0, 0.01, 0.01));
}

TEST(Boundary, no_bubble_ever_leaves)
{
  const Domain_2 domain = unit_square();
  const Boundary_2 boundary(domain);
  std::mt19937 random(random_seeds::seed());
  std::uniform_real_distribution<double> step(-0.5, 0.5);
  Bubbles_2 b;
  for (int i = 0; i < 50; ++i) {
    const Point p(0.1 + 0.016 * i, 0.5);
    b.add(p, 0.3, Bubbles_2::FACE, domain.locate(p, 0));
  }
  for (int k = 0; k < 200; ++k)
    for (std::size_t i = 0; i < b.size(); ++i) {
      boundary.move(b, i, step(random), step(random));
      ASSERT_GT(b.x[i], 0);
      ASSERT_LT(b.x[i], 1);
      ASSERT_GT(b.y[i], 0);
      ASSERT_LT(b.y[i], 1);
      ASSERT_TRUE(domain.is_inside(b.place[i]));
    }
}
