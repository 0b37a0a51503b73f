// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// Random domains of the kinds that break meshers, each by its seed, with random sizes and parameters: each is meshed or
// refused, as the reference tells. One minute of them; BUBBLE_RELAXATION_2_FUZZ_SECONDS gives them more, and
// BUBBLE_RELAXATION_2_SEED other ones. What fails once becomes a file of data/.

#include "domains.h"
#include "random_seeds.h"
#include "validation.h"

#include <CGAL/npbs_adapt.h>
#include <CGAL/npbs_relax.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <iostream>
#include <limits>
#include <optional>
#include <random>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace test_fuzz {

namespace P = CGAL::parameters;
using domains::K;
using domains::Outline;
using domains::Point;
using CDT = domains::Cdt_of<K, CGAL::Exact_predicates_tag>;

/// a domain with pins and what it is meshed with
class Random_case
{
public:
  explicit Random_case(unsigned seed) : m_random(seed)
  {
    switch (m_random() % 5) {
    case 0: add_star(0, 0, 1); break;
    case 1: add_strip(); break;
    case 2: add_comb(); break;
    case 3: add_doubled_square(); break;
    default: add_crossing_lines();
    }
    if (happens(0.4))
      add_star(between(-0.2, 0.6), between(-0.2, 0.6), power_of_ten(-8, -1)); // a hole, or what sticks out
    if (happens(0.3))
      add_pins();
    if (happens(0.2))
      turn_and_move();
    if (happens(0.6))
      size = power_of_ten(-1.3, 0.3);
    limits = happens(0.7);
    treats = happens(0.8);
    keeps = happens(0.2);
    rounds = m_random() % 12;
    if (happens(0.3))
      growth = between(0.05, 1);
    if (happens(0.3))
      angle = between(0, 33);
  }

  std::vector<Outline> outlines, lines;
  std::vector<Point> pins;
  std::optional<double> size;
  bool limits, treats, keeps;
  int rounds;
  double growth = 0.2, angle = 30;

private:
  double between(double a, double b) { return std::uniform_real_distribution<double>(a, b)(m_random); }
  double power_of_ten(double a, double b) { return std::pow(10., between(a, b)); }
  bool happens(double probability) { return between(0, 1) < probability; }

  /// radii of all magnitudes
  void add_star(double x, double y, double radius)
  {
    const int n = 3 + static_cast<int>(m_random() % 30);
    const double least = happens(0.3) ? -3 : -0.5;
    Outline star;
    for (int k = 0; k < n; ++k) {
      const double r = radius * power_of_ten(least, 0), t = 2 * 3.14159265358979 * (k + between(-0.4, 0.4)) / n;
      star.push_back({x + r * std::cos(t), y + r * std::sin(t)});
    }
    outlines.push_back(star);
  }

  /// a strip of any width, or a needle
  void add_strip()
  {
    const double width = power_of_ten(-12, 0);
    outlines.push_back(happens(0.5) ? Outline{{0, 0}, {1, 0}, {1, width}, {0, width}}
                                    : Outline{{0, 0}, {1, 0}, {between(0, 1), width}});
  }

  /// teeth with slits between them
  void add_comb()
  {
    const int teeth = 1 + static_cast<int>(m_random() % 6);
    const double slit = power_of_ten(-10, -1.5), root = power_of_ten(-6, -0.5);
    Outline comb{{0, 0}, {1, 0}};
    for (int k = teeth; k > 0; --k) {
      comb.push_back({(k - slit) / teeth, 1});
      comb.push_back({(k - 1 + slit) / teeth, 1});
      if (k > 1) {
        comb.push_back({(k - 1 + slit) / teeth, root});
        comb.push_back({(k - 1 - slit) / teeth, root});
      }
    }
    outlines.push_back(comb);
  }

  /// corners of which some are there twice, some roundings apart
  void add_doubled_square()
  {
    Outline square;
    for (const auto& p : domains::square(0.25, 0.25, 1)) {
      square.push_back(p);
      if (happens(0.6))
        square.push_back({near(p.first), near(p.second)});
    }
    outlines.push_back(square);
  }

  double near(double x)
  {
    if (happens(0.3))
      return x + power_of_ten(-15, -8);
    for (unsigned k = m_random() % 4; k > 0; --k)
      x = std::nextafter(x, 10);
    return x;
  }

  /// what CGAL makes of lines that cross
  void add_crossing_lines()
  {
    outlines.push_back(domains::square(0, 0, 1));
    for (unsigned k = 1 + m_random() % 12; k > 0; --k)
      lines.push_back({{between(-0.1, 1.1), between(-0.1, 1.1)}, {between(-0.1, 1.1), between(-0.1, 1.1)}});
  }

  /// anywhere, or beside an edge
  void add_pins()
  {
    for (unsigned k = 1 + m_random() % 4; k > 0; --k) {
      const auto &p = outlines[0][0], &q = outlines[0][1];
      const double s = between(0, 1);
      pins.push_back(happens(0.5) ? Point(between(-0.1, 1.1), between(-0.1, 1.1))
                                  : Point(p.first + s * (q.first - p.first), p.second + s * (q.second - p.second)));
    }
  }

  void turn_and_move()
  {
    const double t = between(0, 6), far = happens(0.5) ? power_of_ten(0, 9) : 0, scale = power_of_ten(-20, 20);
    const auto moved = [&](double x, double y) {
      return std::make_pair(scale * (far + std::cos(t) * x - std::sin(t) * y),
                            scale * (std::sin(t) * x + std::cos(t) * y));
    };
    for (auto* polylines : {&outlines, &lines})
      for (Outline& line : *polylines)
        for (auto& p : line)
          p = moved(p.first, p.second);
    for (Point& p : pins) {
      const auto q = moved(p.x(), p.y());
      p = Point(q.first, q.second);
    }
    if (size)
      *size *= scale;
  }

  std::mt19937 m_random;
};

struct Input
{
  CDT cdt;
  std::set<CDT::Vertex_handle> pins;

  explicit Input(const Random_case& c)
  {
    for (const Outline& o : c.outlines)
      domains::insert(cdt, o);
    for (const Outline& o : c.lines)
      domains::insert(cdt, o, false);
    for (const Point& p : c.pins)
      pins.insert(cdt.insert(p));
  }

  Input(const Input&) = delete; // handles would not go with it
};

class Fuzz : public testing::Test
{
protected:
  static auto relax(const Random_case& c, Input& in)
  {
    const auto np = P::limit_by_outline(c.limits)
                      .defect_treatment(c.treats)
                      .number_of_rounds(c.rounds)
                      .size_growth(c.growth)
                      .minimum_angle(c.angle)
                      .maximum_number_of_bubbles(3000)
                      .vertex_is_constrained_map(CGAL::make_boolean_property_map(in.pins));
    if (c.keeps && c.size)
      return CGAL::npbs_relax(in.cdt, np.sizing_function(*c.size).initial_placement(CGAL::Bubble_placement::KEEP));
    return c.size ? CGAL::npbs_relax(in.cdt, np.sizing_function(*c.size)) : CGAL::npbs_relax(in.cdt, np);
  }

  static double largest_coordinate(const validation::Snapshot& s)
  {
    double largest = 0;
    for (const validation::Xy& p : s.vertices)
      largest = (std::max)({largest, std::abs(p.first), std::abs(p.second)});
    return largest;
  }

  static double length(const validation::Snapshot& s)
  {
    double sum = 0;
    for (const validation::Segment& c : s.constraints)
      sum += validation::length(c);
    return sum;
  }

  /// not the qualities: where the mesh is written by insertion, a vertex may be moved by a rounding, and flat triangles
  /// change
  template <class Report>
  static void expect_numbers_add_up(const CDT& cdt, const Report& report)
  {
    std::set<CDT::Vertex_handle> vertices;
    std::size_t number_of_triangles = 0;
    for (CDT::Face_handle f : cdt.finite_face_handles())
      if (f->is_in_domain()) {
        ++number_of_triangles;
        for (int i = 0; i < 3; ++i)
          vertices.insert(f->vertex(i));
      }
    EXPECT_EQ(report.number_of_vertices, vertices.size());
    EXPECT_EQ(report.number_of_triangles, number_of_triangles);
  }

  static void expect_same_domain(const CDT& cdt, const validation::Snapshot& before,
                                 const std::set<validation::Xy>& fixed)
  {
    EXPECT_TRUE(cdt.is_valid());
    const validation::Snapshot after = validation::snapshot(cdt);
    validation::expect_vertices_kept(fixed, after);
    // pieces shorter than a rounding of long ones cannot be told apart, but all together are as long as before
    const double largest = largest_coordinate(before);
    const double pieces = double(before.constraints.size() + after.constraints.size());
    EXPECT_NEAR(length(after), length(before), 1e-9 * length(before) + 1e-14 * largest * pieces);
  }

  /// nothing of CGAL's own: it tells nobody what to do about it
  static void expect_own_words(const std::exception& e)
  {
    EXPECT_EQ(std::string(e.what()).rfind("Bubble_relaxation_2: ", 0), 0u) << e.what();
    EXPECT_EQ(std::string(e.what()).find("please report"), std::string::npos) << e.what();
  }

  /// The mesh gets finer around one of its vertices, and coarser again, or both are refused.
  static void adapt(Input& in, double longest, const validation::Snapshot& before,
                    const std::set<validation::Xy>& fixed)
  {
    const Point centre = in.cdt.finite_vertices_begin()->point();
    for (double least : {0.2, 2.}) {
      const auto d = [&](const Point& p) {
        return least * longest + 0.3 * std::sqrt(CGAL::squared_distance(p, centre));
      };
      const validation::Content<CDT> content(in.cdt);
      try {
        CGAL::npbs_adapt(in.cdt, P::sizing_function(d).maximum_number_of_bubbles(3000).vertex_is_constrained_map(
                                   CGAL::make_boolean_property_map(in.pins)));
        expect_same_domain(in.cdt, before, fixed);
      } catch (const std::exception& e) {
        expect_own_words(e);
        EXPECT_TRUE(validation::Content<CDT>(in.cdt) == content) << "changed by " << e.what();
      }
    }
  }

  void try_case(unsigned seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Random_case c(seed);
    Input in(c);
    if (!in.cdt.is_valid())
      return; // what CGAL makes of crossings a rounding apart may not be
    const validation::Snapshot before = validation::snapshot(in.cdt);
    const std::set<validation::Xy> fixed = validation::fixed_vertices(in.cdt, in.pins);
    ++m_number_of_cases;
    try {
      const std::clock_t start = std::clock();
      const auto report = relax(c, in);
      const double seconds = double(std::clock() - start) / CLOCKS_PER_SEC;
      EXPECT_LT(seconds, (std::max)(20., 4e-4 * double(report.number_of_vertices)));
      expect_same_domain(in.cdt, before, fixed);
      expect_numbers_add_up(in.cdt, report);
      Input other(c);
      relax(c, other);
      EXPECT_TRUE(validation::triangles(other.cdt) == validation::triangles(in.cdt)) << "other bits in another run";
      adapt(in, report.quality.longest_edge(), before, fixed);
    } catch (const std::exception& e) {
      expect_own_words(e);
      EXPECT_TRUE(validation::snapshot(in.cdt) == before) << "changed by " << e.what();
      ++m_number_of_refusals;
    }
  }

  std::size_t m_number_of_cases = 0, m_number_of_refusals = 0;
};

TEST_F(Fuzz, all_are_meshed_or_refused)
{
  const char* given = std::getenv("BUBBLE_RELAXATION_2_FUZZ_SECONDS");
  const double seconds = given != nullptr ? std::atof(given) : 60;
  const auto start = std::chrono::steady_clock::now();
  // seeds of one run are far from those of the next
  const auto passed = [start] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  for (unsigned seed = 100000 * random_seeds::seed(); passed() < seconds && !HasFailure(); ++seed)
    try_case(seed);
  EXPECT_GT(m_number_of_cases, 0u);
  // too many for the maximum, mostly
  EXPECT_LT(double(m_number_of_refusals), 0.4 * double(m_number_of_cases) + 5);
  std::cout << m_number_of_cases << " cases, of which " << m_number_of_refusals << " were refused\n";
}

} // namespace test_fuzz
