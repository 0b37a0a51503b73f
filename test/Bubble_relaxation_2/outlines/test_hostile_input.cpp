// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// Domains that break meshers, one a file of data/, named by what is wrong with them: each is meshed or refused.
//
// The files are WKT: polygons are outlines, line strings are other constraints, and points are pinned vertices. Lines
// that begin with # are ours:
//   # size: 0.1                           d, instead of the default
//   # maximum: 20000                      the most bubbles there may be
//   # refused: length_error | a word      what is thrown, and what its message names
//   # fails: again | why                  a check that is known to fail, and is left out

#include "domains.h"
#include "expect_throw.h"
#include "validation.h"

#include <CGAL/IO/WKT.h>
#include <CGAL/Polygon_with_holes_2.h>
#include <CGAL/npbs_relax.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace test_hostile_input {

namespace P = CGAL::parameters;
using domains::Point;
using CDT = domains::Cdt_of<domains::K, CGAL::Exact_predicates_tag>; // some files have lines that cross
using validation::Snapshot;

std::vector<std::string> names()
{
  std::vector<std::string> result;
  for (const auto& entry : std::filesystem::directory_iterator(BUBBLE_RELAXATION_2_TEST_DATA))
    result.push_back(entry.path().stem().string());
  std::sort(result.begin(), result.end());
  return result;
}

std::string trimmed(const std::string& s)
{
  const auto first = s.find_first_not_of(' ');
  return first == std::string::npos ? "" : s.substr(first, s.find_last_not_of(' ') + 1 - first);
}

struct Hostile_file
{
  std::vector<std::vector<Point>> outlines, lines;
  std::vector<Point> pins;
  std::optional<double> size;
  std::size_t maximum = 100000; // of bubbles
  std::vector<std::string> refusal;         // the exception, and the words of its message
  std::map<std::string, std::string> fails; // what is known to fail, and why

  explicit Hostile_file(const std::string& name)
  {
    std::ifstream file(BUBBLE_RELAXATION_2_TEST_DATA "/" + name + ".wkt");
    std::stringstream wkt;
    for (std::string line; std::getline(file, line);)
      if (line[0] == '#')
        read_comment(line);
      else
        wkt << line << '\n';
    std::vector<CGAL::Polygon_with_holes_2<domains::K>> polygons;
    CGAL::IO::read_WKT(wkt, pins, lines, polygons);
    for (const auto& polygon : polygons) {
      outlines.emplace_back(polygon.outer_boundary().begin(), polygon.outer_boundary().end());
      for (const auto& hole : polygon.holes())
        outlines.emplace_back(hole.begin(), hole.end());
    }
  }

private:
  void read_comment(const std::string& line)
  {
    const auto colon = line.find(':');
    const std::string key = line.substr(0, colon);
    std::vector<std::string> values;
    std::istringstream rest(colon == std::string::npos ? "" : line.substr(colon + 1));
    for (std::string value; std::getline(rest, value, '|');)
      values.push_back(trimmed(value));
    if (key == "# size")
      size = std::stod(values.at(0));
    else if (key == "# maximum")
      maximum = std::stoul(values.at(0));
    else if (key == "# refused")
      refusal = values;
    else if (key == "# fails")
      fails[values.at(0)] = values.at(1);
  }
};

/// how many triangles of the domain have an angle smaller than so many degrees, at any scale
std::size_t number_of_small_angles(const CDT& cdt, double degrees)
{
  std::size_t result = 0;
  for (CDT::Face_handle f : cdt.finite_face_handles()) {
    double smallest = 180;
    for (int i = 0; i < 3; ++i) {
      const Point &o = f->vertex(i)->point(), &p = f->vertex(cdt.ccw(i))->point(), &q = f->vertex(cdt.cw(i))->point();
      const double at_p = std::atan2(p.y() - o.y(), p.x() - o.x()), at_q = std::atan2(q.y() - o.y(), q.x() - o.x());
      smallest = (std::min)(smallest, std::abs(std::remainder(at_q - at_p, 2 * CGAL_PI)) * (180 / CGAL_PI));
    }
    result += f->is_in_domain() && smallest < degrees;
  }
  return result;
}

/// the triangulation of a file, with its pins
struct Input
{
  CDT cdt;
  std::set<CDT::Vertex_handle> pins;
  std::set<validation::Xy> fixed, beside; // what stays where it is, and what is not in the domain
  Snapshot snapshot;
  double area = 0, length = 0; // of the domain, and of all constraints

  explicit Input(const Hostile_file& file, double scale = 1)
  {
    const auto scaled = [scale](const Point& p) { return Point(scale * p.x(), scale * p.y()); };
    for (const auto* polylines : {&file.outlines, &file.lines})
      for (const std::vector<Point>& line : *polylines) {
        std::vector<Point> points;
        for (const Point& p : line)
          points.push_back(scaled(p));
        cdt.insert_constraint(points.begin(), points.end(), polylines == &file.outlines);
      }
    for (const Point& p : file.pins)
      pins.insert(cdt.insert(scaled(p)));
    snapshot = validation::snapshot(cdt);
    for (const validation::Segment& s : snapshot.constraints)
      length += validation::length(s);
    fixed = validation::fixed_vertices(cdt, pins);
    explore();
  }

  Input(const Input&) = delete; // handles would not go with it

private:
  /// by nesting: how many constraints are at least between a face and what is infinite
  void explore()
  {
    if (cdt.dimension() < 2)
      return;
    std::set<CDT::Face_handle> seen;
    std::set<CDT::Vertex_handle> in_domain;
    std::vector<CDT::Face_handle> level{cdt.infinite_face()};
    for (bool is_inside = false; !level.empty(); is_inside = !is_inside) {
      std::vector<CDT::Face_handle> next;
      while (!level.empty()) {
        const CDT::Face_handle f = level.back();
        level.pop_back();
        if (!seen.insert(f).second)
          continue;
        if (is_inside)
          area += CGAL::to_double(cdt.triangle(f).area());
        for (int i = 0; i < 3; ++i) {
          if (is_inside)
            in_domain.insert(f->vertex(i));
          (f->is_constrained(i) ? next : level).push_back(f->neighbor(i));
        }
      }
      for (CDT::Face_handle f : next)
        if (seen.count(f) == 0)
          level.push_back(f);
    }
    for (CDT::Vertex_handle v : cdt.finite_vertex_handles())
      if (in_domain.count(v) == 0)
        beside.insert(validation::xy(v));
  }
};

class Hostile_input : public testing::TestWithParam<std::string>
{
protected:
  /// whether a check is not known to fail
  bool is_expected(const std::string& check) const
  {
    const auto known = file.fails.find(check);
    if (known == file.fails.end())
      return true;
    std::cout << "known to fail: " << check << ": " << known->second << '\n';
    return false;
  }

  template <class Parameters>
  auto relax(Input& in, const Parameters& parameters, double scale = 1) const
  {
    const auto np = parameters.vertex_is_constrained_map(CGAL::make_boolean_property_map(in.pins))
                      .maximum_number_of_bubbles(file.maximum);
    return file.size ? CGAL::npbs_relax(in.cdt, np.sizing_function(scale * *file.size)) : CGAL::npbs_relax(in.cdt, np);
  }

  template <class Report>
  void expect_good(const Input& in, const Report& report, std::size_t evaluations_per_step,
                   const std::string& run) const
  {
    SCOPED_TRACE(run);
    const Snapshot after = validation::snapshot(in.cdt);
    if (is_expected("valid"))
      validation::expect_valid_mesh(in.cdt, in.beside);
    if (is_expected("kept")) {
      validation::expect_vertices_kept(in.fixed, after);
      validation::expect_vertices_kept(in.beside, after);
    }
    if (is_expected("constraints"))
      validation::expect_constraints_kept(in.snapshot, after);
    double largest = 0;
    for (const validation::Xy& p : in.snapshot.vertices)
      largest = (std::max)({largest, std::abs(p.first), std::abs(p.second)});
    // each bubble on an edge may lie beside it by a rounding
    EXPECT_NEAR(validation::domain_area(in.cdt), in.area, 1e-12 * in.area + 1e-14 * largest * in.length);
    for (CDT::Vertex_handle v : in.pins)
      EXPECT_EQ(in.snapshot.vertices.count(validation::xy(v)), 1u) << "a pin";
    if (is_expected("report"))
      validation::expect_report_adds_up(in.cdt, report, evaluations_per_step);
  }

  template <class Exception>
  void expect_refused() const
  {
    Input in(file);
    const validation::Content<CDT> before(in.cdt);
    expect_throw<Exception>([&] { relax(in, P::mass(1.)); }, {file.refusal.begin() + 1, file.refusal.end()});
    EXPECT_TRUE(validation::Content<CDT>(in.cdt) == before);
  }

  const Hostile_file file{GetParam()};
};

TEST_P(Hostile_input, is_meshed_or_refused)
{
  if (!file.refusal.empty()) {
    file.refusal[0] == "length_error"    ? expect_refused<std::length_error>()
    : file.refusal[0] == "runtime_error" ? expect_refused<std::runtime_error>()
                                         : expect_refused<std::invalid_argument>();
    return;
  }
  Input in(file);
  const auto report = relax(in, P::mass(1.));
  expect_good(in, report, 1, "with the defaults");
  if (is_expected("angles")) { // the default of minimum_angle, and what rounds
    const std::size_t number = report.number_of_forced_triangles + report.number_of_small_angles;
    EXPECT_GE(number, number_of_small_angles(in.cdt, 30 - 1e-6));
    EXPECT_LE(number, number_of_small_angles(in.cdt, 30 + 1e-6));
  }
  const std::vector<validation::Triangle> triangles = validation::triangles(in.cdt);
  if (is_expected("again"))
    expect_good(in, relax(in, P::mass(1.)), 1, "with the defaults, again");

  Input other(file);
  relax(other, P::mass(1.));
  EXPECT_TRUE(validation::triangles(other.cdt) == triangles) << "other bits in another run";

  if (is_expected("scaled"))
    for (int exponent : {-30, 20}) {
      const double scale = std::ldexp(1., exponent);
      Input scaled(file, scale);
      relax(scaled, P::mass(1.), scale);
      std::vector<validation::Triangle> expected = triangles;
      for (validation::Triangle& t : expected)
        for (validation::Xy& p : t)
          p = {scale * p.first, scale * p.second};
      EXPECT_TRUE(validation::triangles(scaled.cdt) == expected) << "other bits at the scale 2^" << exponent;
    }

  if (is_expected("paper")) {
    Input as_in_paper(file);
    const auto paper = CGAL::npbs_paper_parameters().number_of_rounds(2).number_of_iterations(40);
    expect_good(as_in_paper, relax(as_in_paper, paper), 4, "with the paper's parameters");
    expect_good(as_in_paper, relax(as_in_paper, paper), 4, "with the paper's parameters, again");
  }
}

// The bubbles on an edge put a vertex into the domain that was outside by a rounding.
TEST(Hostile_numbers, statistics_have_a_vertex_that_was_outside_by_a_rounding)
{
  CDT cdt;
  const std::vector<Point> outline{{608592.16051918664, 608592.16051918664},
                                   {608591.40123183478, 608593.35361713602},
                                   {608591.18432653591, 608592.37742448528},
                                   {608591.18432653579, 608592.37742448528}};
  cdt.insert_constraint(outline.begin(), outline.end(), true);
  cdt.insert(Point(608591.28091707535, 608593.11318885023));
  const auto report = CGAL::npbs_relax(cdt, P::sizing_function(1.).number_of_rounds(0));
  validation::expect_report_adds_up(cdt, report);
  EXPECT_TRUE(report.quality.has_length_ratios());
}

// So far from the origin x has steps of 2e-6, and y none to speak of: where d is smaller than those, no bubble has room.
TEST(Hostile_numbers, rhombic_placement_ends_where_d_is_less_than_the_rounding_of_x)
{
  const double far_away = 1e10, steps = 1.9073486328125e-6;
  CDT cdt;
  const std::vector<Point> outline{{far_away, 0}, {far_away + 1, 0}, {far_away + 1, 1}, {far_away, 1}};
  cdt.insert_constraint(outline.begin(), outline.end(), true);
  std::size_t calls = 0;
  const auto d = [&](const Point& p) {
    if (++calls > 1000000)
      throw std::runtime_error("too many calls");
    return 0.2 * std::hypot(p.x() - far_away - 262144 * steps, p.y() - 0.4) + 1e-11;
  };
  const auto np = P::sizing_function(d).initial_placement(CGAL::Bubble_placement::RHOMBIC).number_of_rounds(0);
  EXPECT_NO_THROW(CGAL::npbs_relax(cdt, np.defect_treatment(false).maximum_number_of_bubbles(100000)));
}

INSTANTIATE_TEST_SUITE_P(Data, Hostile_input, testing::ValuesIn(names()),
                         [](const auto& file) {
                           std::string name = file.param; // of which only letters, digits and _ may be in a test's
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

} // namespace test_hostile_input
