// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// Neighbour sets: equal to brute force for any mixture of sizes, and no interacting pair is ever missed.

#include "domains.h"
#include "random_seeds.h"
#include "validation.h"

#include <CGAL/Bubble_relaxation_2/internal/geometry/Hilbert_curve_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Neighbor_sets_2.h>
#include <CGAL/Bubble_relaxation_2/internal/population/adjust_population.h>
#include <CGAL/npbs_place_nodes.h>

#include <functional>
#include <set>

namespace test_neighbor_sets {

using namespace CGAL::Bubble_relaxation_2::internal;

using Size = std::function<double(double, double)>;

/// bubbles at random in the unit square, all free
Bubbles_2 random_bubbles(std::size_t n, unsigned seed, const Size& size)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(0., 1.);
  Bubbles_2 b;
  for (std::size_t i = 0; i < n; ++i) {
    const double x = uniform(random), y = uniform(random);
    b.add(Point(x, y), size(x, y), Bubbles_2::FACE, 0);
  }
  return b;
}

void sort_along_curve(Bubbles_2& b)
{
  std::vector<Point> points;
  for (std::size_t i = 0; i < b.size(); ++i)
    points.push_back(b.point(i));
  b.select(hilbert_order(Hilbert_curve_2(CGAL::Bbox_2(0, 0, 1, 1)), points));
}

std::vector<Index> brute_force(const Bubbles_2& b, std::size_t i, double radius)
{
  std::vector<Index> result;
  for (std::size_t j = 0; j < b.size(); ++j)
    if (j != i && !b.is_gone(i) && !b.is_gone(j) &&
        std::hypot(b.x[i] - b.x[j], b.y[i] - b.y[j]) < 0.5 * radius * (b.d[i] + b.d[j]))
      result.push_back(static_cast<Index>(j));
  return result;
}

void expect_equal_to_brute_force(const Bubbles_2& b, const Neighbor_sets_2& sets)
{
  for (std::size_t i = 0; i < b.size(); ++i)
    ASSERT_EQ(std::vector<Index>(sets.begin(i), sets.end(i)), brute_force(b, i, sets.radius())) << i;
}

const std::vector<std::pair<const char*, Size>> sizes{
  {"uniform", [](double, double) { return 0.04; }},
  {"graded", [](double x, double y) { return 0.001 + 0.1 * std::hypot(x, y); }},
  {"jumps", [](double x, double) { return x < 0.5 ? 0.003 : 0.09; }},
  {"noise", [](double x, double y) { return 0.002 + 0.08 * std::abs(std::sin(1e4 * x + 3e3 * y)); }},
  {"spot", [](double x, double y) { return std::hypot(x - 0.3, y - 0.7) < 0.05 ? 1e-6 : 0.07; }}};

/// Sets without a skin find what is there now, and what was added: all within a radius, and all large ones.
TEST(Neighbor_sets, find_all_that_is_near_now)
{
  for (const auto& size : sizes) {
    Bubbles_2 b = random_bubbles(500, 4, size.second);
    Neighbor_sets_2 sets(Neighbor_sets_2::without_skin);
    sets.build(b);
    const Bubbles_2 more = random_bubbles(100, 5, size.second);
    for (std::size_t i = 0; i < more.size(); ++i) {
      b.add(more.point(i), more.d[i], Bubbles_2::FACE, 0);
      sets.add(b, static_cast<Index>(b.size()) - 1);
    }
    for (std::size_t i = 0; i < b.size(); i += 7)
      for (double near : {1.5, 6.1}) {
        std::set<Index> within, large;
        sets.find_within(b.x[i], b.y[i], b.d[i], near, [&](Index j) { within.insert(j); });
        sets.find_large(b.x[i], b.y[i], b.d[i], near, [&](Index j) { large.insert(j); });
        for (std::size_t k = 0; k < b.size(); ++k) {
          const double distance = std::hypot(b.x[i] - b.x[k], b.y[i] - b.y[k]);
          const Index j = static_cast<Index>(k);
          EXPECT_TRUE(distance > near * b.d[i] || within.count(j)) << size.first << ' ' << i << ' ' << j;
          EXPECT_TRUE(b.d[k] < b.d[i] || distance > near * b.d[k] || large.count(j)) << size.first << ' ' << i << ' ' << j;
        }
      }
  }
}

TEST(Neighbor_sets, equal_to_brute_force)
{
  for (const auto& size : sizes)
    for (double radius : {1.6, 1.7, 3.})
      for (bool is_sorted : {false, true}) { // those that follow each other lie together, or not
        SCOPED_TRACE(size.first);
        Bubbles_2 b = random_bubbles(800, random_seeds::seed(), size.second);
        if (is_sorted)
          sort_along_curve(b);
        Neighbor_sets_2 sets(radius);
        sets.build(b);
        expect_equal_to_brute_force(b, sets);
      }
}

TEST(Neighbor_sets, rounding_does_not_hide_a_neighbor_from_a_group)
{
  Bubbles_2 b;
  for (int i = 0; i < 8; ++i)
    b.add(Point(i - 9, 0), 1, Bubbles_2::FACE, 0);
  b.add(Point(-std::ldexp(1., -52), 0), 1, Bubbles_2::FACE, 0); // a little nearer than 2 to the last one
  Neighbor_sets_2 sets(2.);
  sets.build(b);
  expect_equal_to_brute_force(b, sets);
  EXPECT_EQ(sets.end(8) - sets.begin(8), 1);
}

TEST(Neighbor_sets, of_groups_with_gaps)
{
  Bubbles_2 b = random_bubbles(800, random_seeds::seed(), sizes[1].second);
  sort_along_curve(b);
  for (std::size_t i = 0; i < b.size(); ++i)
    if (i % 3 == 0 || (i > 200 && i < 240))
      b.remove(i);
  Neighbor_sets_2 sets(2.);
  sets.build(b);
  expect_equal_to_brute_force(b, sets);
}

/// Each of the small ones has all of the large ones for neighbours, and each of these has all of the small ones, which
/// takes many minutes if they are looked at from each small one.
TEST(Local_triangulation, of_small_bubbles_among_large_ones)
{
  constexpr int side = 400;
  constexpr double small = 1e-3;
  Bubbles_2 b;
  std::vector<Index> all;
  for (int i = 0; i < side * side; ++i) // a lattice with gaps, in which circles are wide
    if (i % 3 == 0)
      b.add(Point(small * (i % side + 0.5 * (i / side % 2)), 0.87 * small * (i / side)), small, Bubbles_2::FACE, 0);
  for (int i = 0; i < 20; ++i)
    b.add(Point(0.2 + 0.01 * i, -0.1 - 0.001 * i * i), 1, Bubbles_2::FACE, 0);
  for (std::size_t i = 0; i < b.size(); ++i)
    all.push_back(static_cast<Index>(i));
  Neighbor_sets_2 sets(1.7);
  sets.build(b);
  const Local_triangulation_2 mesh(b, sets, all, Threads());
  // Euler's formula, with three vertices or more on the convex hull
  EXPECT_LE(mesh.triangles().size(), 2 * b.size() - 5);
  EXPECT_GT(mesh.triangles().size(), 2 * b.size() - 2 * side);
}

TEST(Neighbor_sets, adversarial_sets)
{
  Bubbles_2 same_place, line, lattice;
  for (int i = 0; i < 40; ++i) {
    same_place.add(Point(0.5, 0.5), 0.1, Bubbles_2::FACE, 0);
    line.add(Point(1e8 + i, -1e8), i % 3 == 0 ? 5. : 0.5, Bubbles_2::FACE, 0);
    for (int j = 0; j < 40; ++j) // exactly on the corners of cells
      lattice.add(Point(i * 0.17, j * 0.17), 0.1, Bubbles_2::FACE, 0);
  }
  for (const Bubbles_2* b : {&same_place, &line, &lattice}) {
    Neighbor_sets_2 sets(1.7);
    sets.build(*b);
    expect_equal_to_brute_force(*b, sets);
  }
  Neighbor_sets_2 empty(1.7);
  empty.build(Bubbles_2());
  EXPECT_EQ(empty.number_of_bubbles(), 0u);
}

TEST(Neighbor_sets, renewal_from_neighbors_finds_them_in_a_packing)
{
  Bubbles_2 b;
  for (int i = 0; i < 20; ++i)
    for (int j = 0; j < 20; ++j)
      b.add(Point(i + 0.5 * j, 0.8660254 * j), 1, Bubbles_2::FACE, 0);
  Neighbor_sets_2 sets(1.7);
  sets.build(b);
  std::mt19937 random(random_seeds::seed());
  std::uniform_real_distribution<double> jitter(-0.1, 0.1);
  for (std::size_t i = 0; i < b.size(); ++i) {
    b.x[i] += jitter(random);
    b.y[i] += jitter(random);
  }
  sets.renew_from_neighbors(b);
  expect_equal_to_brute_force(b, sets);
}

TEST(Neighbor_sets, skin_covers_every_interacting_pair)
{
  // as long as no bubble has used up its skin, no pair nearer than 1.5 is missing: move and resize
  // bubbles at random up to that limit
  std::mt19937 random(random_seeds::seed());
  std::uniform_real_distribution<double> uniform(-1., 1.);
  for (const auto& size : sizes) {
    SCOPED_TRACE(size.first);
    Bubbles_2 b = random_bubbles(600, random(), size.second);
    Neighbor_sets_2 sets(1.7);
    sets.build(b);
    std::size_t moved = 0;
    for (int attempt = 0; attempt < 30; ++attempt)
      for (std::size_t i = 0; i < b.size(); ++i) {
        const double x = b.x[i], y = b.y[i], d = b.d[i];
        b.x[i] += 0.08 * d * uniform(random);
        b.y[i] += 0.08 * d * uniform(random);
        b.d[i] *= 1 + 0.1 * uniform(random);
        if (sets.is_outrun_by(b, i)) {
          b.x[i] = x;
          b.y[i] = y;
          b.d[i] = d;
        } else {
          ++moved;
        }
      }
    EXPECT_GT(moved, b.size());
    for (std::size_t i = 0; i < b.size(); ++i)
      for (Index j : brute_force(b, i, 1.5))
        ASSERT_TRUE(std::binary_search(sets.begin(i), sets.end(i), j)) << i << ' ' << j;
  }
}

Domain_2 unit_square()
{
  Domain_2 square;
  EXPECT_EQ(square.build({Point(0, 0), Point(1, 0), Point(1, 1), Point(0, 1)},
                         {{0, 1, true, false}, {1, 2, true, false}, {2, 3, true, false},
                          {3, 0, true, false}}),
            Marking_error::NONE);
  return square;
}

/// deletes every tenth bubble and inserts as many at random
Population_change random_change(const Domain_2& domain, const Bubbles_2& b, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(0.05, 0.95);
  Population_change change;
  for (std::size_t i = 0; i < b.size(); i += 10)
    if (!b.is_gone(i)) {
      change.deleted.push_back(static_cast<Index>(i));
      const Point p(uniform(random), uniform(random));
      change.inserted.add(p, b.d[i], Bubbles_2::FACE, domain.locate(p, 0));
    }
  return change;
}

TEST(Neighbor_sets, follow_deletions_and_additions)
{
  const Domain_2 domain = unit_square();
  for (const auto& size : sizes) {
    SCOPED_TRACE(size.first);
    Bubbles_2 b = random_bubbles(300, random_seeds::seed(), size.second);
    Neighbor_sets_2 sets(1.7);
    sets.build(b);
    for (unsigned k = 0; k < 3; ++k) {
      const Population_change change = random_change(domain, b, random_seeds::seed(k));
      for (Index i : change.deleted) {
        sets.remove(i);
        b.remove(i);
      }
      for (std::size_t i = 0; i < change.inserted.size(); ++i) {
        b.add(change.inserted.point(i), change.inserted.d[i], Bubbles_2::FACE, 0);
        sets.add(b, static_cast<Index>(b.size()) - 1);
      }
      expect_equal_to_brute_force(b, sets);
    }
  }
}

/// Bubbles farther than 1.5 do not interact, so that larger neighbour sets change no bit, unless a pair was missing in
/// the smaller ones. (Who sleeps does depend on the sets, so nobody does here.)
TEST(Neighbor_sets, simulation_misses_no_interacting_pair)
{
  std::mt19937 random(random_seeds::seed());
  std::uniform_real_distribution<double> uniform(0.01, 0.99);
  domains::CDT cdt = domains::make({domains::square(0, 0, 1)});
  for (int i = 0; i < 120; ++i) // a start that moves a lot
    cdt.insert(domains::Point(uniform(random), uniform(random)));
  const auto size = [](const domains::Point& p) { return 0.02 + 0.15 * std::hypot(p.x() - 0.5, p.y() - 0.5); };
  for (auto population : {CGAL::Bubble_population::NONE, CGAL::Bubble_population::OVERLAP_RATIO})
    for (auto integrator : {CGAL::Bubble_integrator::SEMI_IMPLICIT_EULER, CGAL::Bubble_integrator::RUNGE_KUTTA_4}) {
      const auto np = CGAL::parameters::initial_placement(CGAL::Bubble_placement::KEEP).population_control(population)
                        .integrator(integrator).displacement_tolerance(0).number_of_rounds(3).number_of_iterations(100)
                        .defect_treatment(false).sizing_function(size);
      // within a step of Runge-Kutta bubbles go farther than a thin skin: 1.6 would miss a pair there
      const bool has_stages = integrator == CGAL::Bubble_integrator::RUNGE_KUTTA_4;
      const auto few = CGAL::npbs_place_nodes(cdt, np.neighbor_radius(has_stages ? 1.65 : 1.6));
      const auto some = CGAL::npbs_place_nodes(cdt, np.neighbor_radius(1.7));
      const auto all = CGAL::npbs_place_nodes(cdt, np.neighbor_radius(100.));
      EXPECT_TRUE(few.points == all.points);
      EXPECT_TRUE(some.points == all.points);
      EXPECT_GT(few.report.number_of_renewals, 10u);
      EXPECT_GT(few.report.number_of_renewals, all.report.number_of_renewals);
      EXPECT_EQ(few.report.number_of_steps, 300u);
    }
}

} // namespace test_neighbor_sets
