// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// The domain: which faces belong to it, chains and corners, walks.

#include "domains.h"
#include "expect_throw.h"
#include "random_seeds.h"
#include "validation.h"

#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_marks_2.h>
#include <CGAL/Bubble_relaxation_2/internal/reading/read_input.h>
#include <CGAL/Bubble_relaxation_2/internal/sizes/Outline_sizes_2.h>

namespace test_domain {

using namespace CGAL::Bubble_relaxation_2::internal;
using domains::CDT;

namespace P = CGAL::Bubble_relaxation_parameters;

template <class Parameters>
double marked_area(const CDT& cdt, const Parameters& parameters)
{
  const Domain_marks_2<CDT> is_inside(cdt, parameters);
  double sum = 0;
  std::size_t faces = 0;
  for (CDT::Face_handle f : cdt.finite_face_handles())
    if (is_inside(f)) {
      sum += cdt.triangle(f).area();
      ++faces;
    }
  EXPECT_EQ(faces, is_inside.number_of_faces());
  for (CDT::Face_handle f : cdt.all_face_handles())
    if (cdt.is_infinite(f)) {
      EXPECT_FALSE(is_inside(f));
    }
  return sum;
}

/// what is read of a triangulation, whatever d
struct Reading
{
  explicit Reading(const CDT& cdt) : input(cdt, P::sizing_function(1.).limit_by_outline(false), std::make_shared<Progress>())
  {}

  const Input_2<CDT> input;
  const Domain_2& domain = input.problem().domain;
  const Given_mesh_2& given = input.problem().given;
};

std::unique_ptr<Reading> read(const CDT& cdt) { return std::make_unique<Reading>(cdt); }

CDT nested()
{
  return domains::make({domains::square(0, 0, 6), domains::square(1, 1, 4), domains::square(2, 2, 2)});
}

TEST(Domain_marks, nesting)
{
  EXPECT_DOUBLE_EQ(marked_area(nested(), CGAL::parameters::default_values()), 36 - 16 + 4);
}

TEST(Domain_marks, nesting_over_the_hull)
{
  CDT cdt = nested();
  cdt.insert(domains::Point(20, 3)); // the hull is no constraint
  EXPECT_DOUBLE_EQ(marked_area(cdt, CGAL::parameters::default_values()), 36 - 16 + 4);
}

TEST(Domain_marks, seeds_of_holes)
{
  const std::vector<domains::Point> seeds{{3, 3}, {100, 100}};
  EXPECT_DOUBLE_EQ(marked_area(nested(), P::seeds(seeds)), 36 - 4);
  const std::vector<domains::Point> none;
  EXPECT_DOUBLE_EQ(marked_area(nested(), P::seeds(none)), 36);
}

TEST(Domain_marks, seeds_in_the_domain)
{
  const std::vector<domains::Point> seeds{{1.5, 1.5}, {3, 3}};
  EXPECT_DOUBLE_EQ(marked_area(nested(), P::seeds(seeds).seeds_are_in_domain(true)), 16);
}

TEST(Domain_marks, a_seed_on_a_constraint_does_not_tell_its_side)
{
  using domains::Point;
  for (const Point& p : {Point(1, 1), Point(3, 1), Point(0, 0), Point(0, 3)})
    for (bool is_in_domain : {false, true}) {
      const std::vector<domains::Point> seeds{p};
      expect_invalid([&] { marked_area(nested(), P::seeds(seeds).seeds_are_in_domain(is_in_domain)); },
                     {"parameter seeds", "lies on a constraint"});
    }
  // both sides of a constraint that separates nothing are the same region
  CDT cdt = nested();
  domains::insert(cdt, {{0.25, 0.25}, {0.5, 0.5}}, false);
  for (const domains::Point& p : {domains::Point(0.25, 0.25), domains::Point(0.5, 0.5)}) {
    const std::vector<domains::Point> seeds{p};
    EXPECT_DOUBLE_EQ(marked_area(cdt, P::seeds(seeds).seeds_are_in_domain(true)), 20);
  }
}

TEST(Domain_marks, existing_marks)
{
  CDT cdt = nested();
  const Domain_marks_2<CDT> inner(
    cdt, P::seeds(std::vector<domains::Point>{{3, 3}}).seeds_are_in_domain(true));
  for (CDT::Face_handle f : cdt.finite_face_handles())
    f->set_in_domain(inner(f));
  EXPECT_DOUBLE_EQ(marked_area(cdt, CGAL::parameters::default_values()), 4);
}

TEST(Domain_reading, vertices_on_straight_edges_are_no_corners)
{
  CDT cdt = domains::make({{{0, 0}, {0.1, 0.03}, {0.7, 0.21}, {1, 0.3}, {0, 1}}});
  const auto reading = read(cdt);
  EXPECT_EQ(reading->domain.corners().size(), 3u);
  ASSERT_EQ(reading->domain.edges().size(), 3u);
  std::size_t splits = 0;
  for (const std::vector<Point>& on_edge : reading->given.on_edge)
    splits += on_edge.size();
  EXPECT_EQ(splits, 2u);
}

TEST(Domain_reading, a_fine_circle_keeps_its_corners)
{
  for (double shift : {0., 1e7}) {
    CDT cdt = domains::make({domains::polygon(shift, -shift, 1, 2000)});
    const auto reading = read(cdt);
    EXPECT_EQ(reading->domain.corners().size(), 2000u);
  }
}

/// where coordinates are so large that each vertex of an arc lies between its neighbours up to roundings: bends are found
/// in a time that is nearly linear, else this takes half a minute
TEST(Domain_reading, a_finely_sampled_arc_keeps_its_bends)
{
  const double x = 500000, y = 5.4e6, radius = 50, step = 0.001;
  const int n = 40000;
  domains::Outline arc{{x, y + radius}};
  for (int i = 0; i <= n; ++i)
    arc.push_back({x + radius * std::sin(i * step / radius), y + radius * (1 - std::cos(i * step / radius))});
  CDT cdt = domains::make({arc});
  const auto reading = read(cdt);
  const std::size_t corners = reading->domain.corners().size();
  EXPECT_GT(corners, 100u);
  EXPECT_LT(corners, 30000u); // many are mere splits
  for (std::size_t e = 0; e < corners; ++e)
    if (const double length = reading->domain.length(static_cast<Index>(e)); length < 0.9 * radius) {
      const double sagitta = length * length / (8 * radius);
      EXPECT_LT(sagitta, 10 * y * std::numeric_limits<double>::epsilon());
    }
}

TEST(Domain_reading, a_crossing_of_constraints_is_a_corner)
{
  CDT cdt = domains::make({domains::square(0, 0, 1)});
  domains::insert(cdt, {{0, 0.5}, {1, 0.5}}, false);
  const auto reading = read(cdt);
  EXPECT_EQ(reading->domain.corners().size(), 6u);
  EXPECT_EQ(reading->domain.edges().size(), 7u);
}

TEST(Domain_reading, a_sliver_with_straight_sides_keeps_all_its_edges)
{
  // the hole's corner in the middle is off the opposite edge by one rounding: it looks like a split of a
  // second edge with the same two ends
  const double above = std::nextafter(1., 2.);
  CDT cdt = domains::make({domains::square(0, 0, 4), {{1, 1}, {3, 1}, {2, above}}});
  ASSERT_EQ(cdt.number_of_vertices(), 7u);
  const auto reading = read(cdt);
  EXPECT_EQ(reading->domain.corners().size(), 7u);
  ASSERT_EQ(reading->domain.edges().size(), 7u);
  std::set<std::pair<Index, Index>> ends;
  for (const Domain_edge_2& e : reading->domain.edges())
    ends.insert(std::minmax(e.source, e.target));
  EXPECT_EQ(ends.size(), 7u);
  const auto is_inside = [&](double x, double y) {
    return reading->domain.is_inside(reading->domain.locate(Point(x, y), 0));
  };
  EXPECT_TRUE(is_inside(2, 1.5));
  EXPECT_TRUE(is_inside(2, 0.5));
}

TEST(Domain_marking, an_edge_may_be_given_once_only)
{
  const std::vector<Point> points{Point(0, 0), Point(1, 0), Point(0, 1)};
  Marked_triangulation_2 result;
  const std::vector<Domain_edge_2> once{{0, 1, true, false}, {1, 2, true, false}, {2, 0, true, false}};
  EXPECT_EQ(mark_triangulation(points, once, result), Marking_error::NONE);
  for (const Domain_edge_2& second : {Domain_edge_2{0, 1, false, true}, Domain_edge_2{1, 0, true, false}}) {
    std::vector<Domain_edge_2> twice = once;
    twice.push_back(second);
    EXPECT_EQ(mark_triangulation(points, twice, result), Marking_error::EDGE_TWICE);
  }
}

TEST(Domain_reading, free_vertices)
{
  CDT cdt = domains::make({domains::square(0, 0, 1), domains::square(0.2, 0.2, 0.3)});
  cdt.insert(domains::Point(0.7, 0.7)); // in the domain
  cdt.insert(domains::Point(0.3, 0.3)); // in the hole
  cdt.insert(domains::Point(2, 3));     // outside
  EXPECT_EQ(read(cdt)->given.free.size(), 1u);
}

TEST(Walk, stops_at_edges_of_the_domain_exactly_when_it_must)
{
  // compare with the exact intersection of the segment with all edges
  CDT cdt = domains::make(domains::random_star(random_seeds::seed()));
  const auto reading = read(cdt);
  const Domain_2& domain = reading->domain;
  std::mt19937 random(random_seeds::seed());
  std::uniform_real_distribution<double> uniform(-1., 1.);
  std::size_t blocked = 0, free = 0;
  while (blocked + free < 5000) {
    const Point p(uniform(random), uniform(random)), q(uniform(random), uniform(random));
    const Index t = domain.locate(p, 0);
    if (t == no_index || !domain.is_inside(t))
      continue;
    bool crosses = false;
    for (std::size_t e = 0; e < domain.edges().size(); ++e)
      crosses = crosses || CGAL::do_intersect(Kernel::Segment_2(p, q),
                                              Kernel::Segment_2(domain.source(e), domain.target(e)));
    const Walk_end end = domain.walk(t, p, q);
    ASSERT_EQ(end.is_blocked(), crosses) << p << " to " << q;
    if (crosses) {
      const Index e = domain.edge(end.triangle, end.edge);
      ASSERT_NE(e, no_index);
      ASSERT_TRUE(CGAL::do_intersect(Kernel::Segment_2(p, q),
                                     Kernel::Segment_2(domain.source(e), domain.target(e))));
      ++blocked;
    } else {
      ASSERT_EQ(end.triangle, domain.locate(q, 0));
      ++free;
    }
  }
  EXPECT_GT(blocked, 100u);
  EXPECT_GT(free, 100u);
}

TEST(Walk, locates_every_point_from_every_triangle)
{
  CDT cdt = domains::make(domains::random_star(random_seeds::seed()));
  const auto reading = read(cdt);
  const auto& tr = reading->domain.triangulation();
  std::mt19937 random(random_seeds::seed());
  std::uniform_real_distribution<double> uniform(-1.1, 1.1);
  std::size_t inside = 0, outside = 0;
  for (int k = 0; k < 500; ++k) {
    const Point q(uniform(random), uniform(random));
    Index expected = no_index;
    for (std::size_t t = 0; t < tr.number_of_triangles(); ++t)
      if (!tr.is_beyond(static_cast<Index>(t), 0, q) && !tr.is_beyond(static_cast<Index>(t), 1, q) &&
          !tr.is_beyond(static_cast<Index>(t), 2, q))
        expected = static_cast<Index>(t);
    ++(expected == no_index ? outside : inside);
    for (std::size_t t = 0; t < tr.number_of_triangles(); ++t)
      ASSERT_EQ(reading->domain.locate(q, static_cast<Index>(t)), expected) << q << " from " << t;
  }
  EXPECT_GT(inside, 100u);
  EXPECT_GT(outside, 10u);
}

TEST(Walk, locates_points_and_knows_the_outside)
{
  CDT cdt = domains::make({domains::square(0, 0, 1), domains::square(0.25, 0.25, 0.5)});
  const auto reading = read(cdt);
  const auto is_inside = [&](double x, double y) {
    const Index t = reading->domain.locate(Point(x, y), 0);
    return t != no_index && reading->domain.is_inside(t);
  };
  EXPECT_TRUE(is_inside(0.1, 0.1));
  EXPECT_TRUE(is_inside(0.9, 0.5));
  EXPECT_FALSE(is_inside(0.5, 0.5));
  EXPECT_FALSE(is_inside(1.1, 0.5));
}

TEST(Expected_number, is_the_integral_of_the_density)
{
  CDT cdt = domains::make({domains::square(-1, -1, 2), domains::polygon(0, 0, 0.5, 400)});
  const auto reading = read(cdt);
  const Sizes_2 uniform([](double, double) { return 0.01; });
  const double area = 4 - 3.14159265 * 0.25;
  EXPECT_NEAR(Expected_number_of_bubbles(reading->domain, uniform, 1e9)
                .integral_over_faces(),
              2 / std::sqrt(3.) * area / 1e-4, 10);
  // d = r/80 on a ring of radii 0.5 and 1 and the corners outside: by brute force
  const Sizes_2 graded([](double x, double y) { return std::hypot(x, y) / 80; });
  double sum = 0;
  const int n = 2000;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const Point p(-1 + 2 * (i + 0.5) / n, -1 + 2 * (j + 0.5) / n);
      if (std::hypot(p.x(), p.y()) > 0.5)
        sum += 2 / std::sqrt(3.) / (graded(p) * graded(p)) * 4 / n / n;
    }
  EXPECT_NEAR(Expected_number_of_bubbles(reading->domain, graded, 1e9)
                .integral_over_faces(), sum, 0.01 * sum);
}

TEST(Expected_number, is_that_of_the_hexagonal_packing)
{
  CDT cdt = domains::make({domains::square(0, 0, 1)});
  domains::insert(cdt, {{0.2, 0.2}, {0.8, 0.3}}, false);
  const auto reading = read(cdt);
  const Sizes_2 uniform([](double, double) { return 0.01; });
  // corners and ends, edges, and the area less half a cell for the outline's and one for the line's bubbles
  const double line = std::hypot(0.6, 0.1) * 100 - 1;
  EXPECT_NEAR(Expected_number_of_bubbles(reading->domain, uniform, 1e9)(),
              6 + 4 * 99 + line + 2 / std::sqrt(3.) * 1e4 - 0.5 * 4 * 99 - line, 1e-6);
}

TEST(Expected_number, of_needles_takes_few_calls_of_the_size)
{
  for (double width : {1e-9, 1e-12, 1e-15}) { // of about the smallest size, and far below
    SCOPED_TRACE(width);
    CDT cdt = domains::make({{{0, 0}, {1, 0}, {1, width}}});
    const auto reading = read(cdt);
    std::size_t calls = 0;
    const Sizes_2 graded([&calls](double x, double) {
      ++calls;
      return 1e-9 + 0.2 * std::abs(x - 0.4);
    });
    Expected_number_of_bubbles(reading->domain, graded, 1e9)();
    EXPECT_LT(calls, 10000u);
  }
  // nor does one whose edges alone ask for too many: they are counted first
  CDT cdt = domains::make({{{0, 0}, {1, 0}, {1, 1e-5}}});
  const auto reading = read(cdt);
  std::size_t calls = 0;
  const Sizes_2 rough([&calls](double x, double) {
    ++calls;
    return 1e-4 * (1.5 + std::sin(1e6 * x));
  });
  EXPECT_GT(Expected_number_of_bubbles(reading->domain, rough, 1000)(), 1000);
  EXPECT_LT(calls, 10000u);
}

TEST(Expected_number, of_an_edge_is_the_integral_of_the_inverse_size)
{
  CDT cdt = domains::make({{{0, 0}, {1, 0}, {0, 1}}});
  const auto reading = read(cdt);
  const Sizes_2 graded([](double x, double) { return 0.001 + 0.1 * x; });
  Expected_number_of_bubbles expected(reading->domain, graded, 1e9);
  for (std::size_t e = 0; e < 3; ++e) {
    const double dx = std::abs(reading->domain.source(e).x() - reading->domain.target(e).x());
    const double length = reading->domain.length(e);
    const double exact = dx == 0 ? length / 0.001 : 10 * length * std::log(101.);
    EXPECT_NEAR(expected.integral_over_edge(e), exact, 0.02 * exact);
  }
}

} // namespace test_domain
