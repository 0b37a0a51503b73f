// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// The part of a mesh that sizes ask for, and that meshes do not get worse by many changes.

#include "adaptation_checks.h"
#include "domains.h"
#include "expect_throw.h"
#include "validation.h"

#include <CGAL/Mesh_quality_2.h>
#include <CGAL/npbs_adapt.h>
#include <CGAL/npbs_relax.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <random>
#include <set>
#include <vector>

namespace test_misfits {

using adaptation::faces_near;
using adaptation::size;
using domains::CDT;
using domains::hole;
using domains::Outline;
using domains::Point;
using domains::slanted;
using validation::Content;
using Faces = std::vector<CDT::Face_handle>;

/// a size that is small in some places
struct Places
{
  double d = 0.02;
  std::vector<std::array<double, 3>> smaller; // x, y, factor

  double operator()(const Point& p) const
  {
    double result = d;
    for (const auto& [x, y, factor] : smaller)
      result = (std::min)(result, factor * d + 0.2 * std::hypot(p.x() - x, p.y() - y));
    return result;
  }
};

template <class D>
CGAL::Mesh_quality_2<double> quality(const CDT& cdt, const D& d)
{
  return CGAL::mesh_quality_2(cdt, size(d));
}

template <class D>
CDT at_once(const D& d)
{
  return domains::mesh({slanted, hole}, d);
}

TEST(Misfits, are_none_where_sizes_did_not_change)
{
  const auto wave = [](const Point& p) { return 0.03 * (1 + 0.5 * std::sin(9 * p.x()) * std::sin(7 * p.y())); };
  const auto ramp = [](const Point& p) { return 0.01 + 0.005 * p.x(); };
  const auto expect_none = [](const auto& d) {
    CDT cdt = at_once(d);
    const Content<CDT> before(cdt);
    EXPECT_TRUE(CGAL::npbs_misfit_faces(cdt, size(d)).empty());
    double last = 0;
    const auto report = CGAL::npbs_adapt(cdt, size(d).callback([&last](double progress) {
      last = progress;
      return true;
    }));
    EXPECT_EQ(last, 1);
    EXPECT_EQ(report.number_of_triangles, 0u);
    EXPECT_TRUE(report.converged);
    EXPECT_TRUE(Content<CDT>(cdt) == before);
  };
  expect_none(wave);
  expect_none(ramp);
  expect_none(0.02);
  expect_none(0.11); // more than the hole's edges allow
}

/// fine outlines and sharp corners ask for small triangles, which are no misfits
TEST(Misfits, outlines_are_known)
{
  const Outline fine = domains::polygon(0, 0, 1, 150), sharp{{0, 0}, {1, 0}, {1, 0.1}}, far{{3, 0}, {4, 0}, {4, 0.2}};
  for (const std::vector<Outline>& outlines : {std::vector<Outline>{fine}, {sharp}, {sharp, far}}) {
    const CDT cdt = domains::mesh(outlines, 0.1);
    EXPECT_TRUE(CGAL::npbs_misfit_faces(cdt, size(0.1)).empty());
    EXPECT_FALSE(CGAL::npbs_misfit_faces(cdt, size(0.1).limit_by_outline(false)).empty());
    EXPECT_FALSE(CGAL::npbs_misfit_faces(cdt, size(0.02)).empty());
  }
}

/// nor are those that sizes grow through from there, as beside rounded corners
TEST(Misfits, are_none_beside_rounded_corners)
{
  for (int n : {60, 120, 300}) { // pieces of each corner
    domains::Outline plate;
    for (int k = 0; k < 4; ++k)
      for (int i = 0; i <= n; ++i) {
        const double angle = CGAL_PI / 2 * (k + double(i) / n);
        plate.push_back({(k == 0 || k == 3 ? 9 : 1) + std::cos(angle), (k < 2 ? 9 : 1) + std::sin(angle)});
      }
    const auto d = [](const Point& p) { return 0.2 + 0.02 * p.x(); };
    const CDT cdt = domains::mesh({plate}, d);
    EXPECT_TRUE(CGAL::npbs_misfit_faces(cdt, size(d)).empty()) << n;
  }
}

/// but they do not ask for large ones
TEST(Misfits, are_large_faces_at_sharp_corners)
{
  CDT cdt = domains::make({Outline{{0, 0}, {1, 0}, {1, 0.8}}});
  for (CDT::Face_handle f : cdt.finite_face_handles())
    f->set_in_domain(true);
  EXPECT_EQ(CGAL::npbs_misfit_faces(cdt, size(0.1)).size(), 1u);
  EXPECT_GT(CGAL::npbs_adapt(cdt, size(0.1)).number_of_triangles, 50u);
  validation::expect_valid_mesh(cdt);
  EXPECT_TRUE(CGAL::npbs_misfit_faces(cdt, size(0.1)).empty());
}

/// and what is meshed anew around them is no finer than if all was made at once
TEST(Misfits, are_none_at_sharp_corners_of_adapted_meshes)
{
  for (double height : {0.7, 0.8, 0.97})
    for (double d : {0.025, 0.1}) {
      SCOPED_TRACE(testing::Message() << height << ' ' << d);
      const Outline outline{{0, 0}, {1, 0}, {1, height}};
      CDT cdt = domains::mesh({outline}, 0.05);
      const CDT once = domains::mesh({outline}, d);
      EXPECT_GT(CGAL::npbs_adapt(cdt, size(d)).number_of_triangles, 0u);
      EXPECT_TRUE(CGAL::npbs_misfit_faces(cdt, size(d)).empty());
      EXPECT_NEAR(double(cdt.number_of_vertices()) / double(once.number_of_vertices()), 1, 0.1);
    }
}

/// Rows of triangles come in whole numbers: between the edges of a wedge they cannot have all sizes.
TEST(Misfits, are_none_between_edges_that_meet)
{
  for (double degrees : {9., 12., 48.})
    for (int k = 0; k < 10; ++k) {
      SCOPED_TRACE(testing::Message() << degrees << " degrees, " << k);
      CDT cdt = domains::make({domains::square(0, 0, 1)});
      const Point corner(0.5 + 0.003 * k, 0.5 + 0.001 * k);
      const double length = degrees < 45 ? 0.2 : 0.08;
      for (double turn : {0., degrees * 3.14159265358979 / 180})
        cdt.insert_constraint(corner, Point(corner.x() + length * std::cos(0.3 + 0.1 * k + turn),
                                            corner.y() + length * std::sin(0.3 + 0.1 * k + turn)));
      CGAL::npbs_relax(cdt, size(0.05));
      EXPECT_TRUE(CGAL::npbs_misfit_faces(cdt, size(0.05)).empty());
    }
}

/// No mesh follows a jump, so what a relaxation makes of it fits: it is not meshed again and again, but when it moves.
TEST(Misfits, are_none_where_sizes_jump)
{
  for (double factor : {1.5, 2., 3.})
    for (bool is_disc : {true, false}) {
      SCOPED_TRACE(testing::Message() << "a jump by " << factor << (is_disc ? " around a disc" : " across a line"));
      double reach = 0.25;
      const auto d = [&](const Point& p) {
        const double x = p.x() - 0.45, y = p.y() - 0.5;
        return (is_disc ? std::hypot(x, y) : x + 0.3 * y + 0.2) < reach ? 0.06 / factor : 0.06;
      };
      CDT cdt = domains::mesh({domains::square(0, 0, 1)}, std::cref(d));
      EXPECT_TRUE(CGAL::npbs_misfit_faces(cdt, size(std::cref(d))).empty());
      std::size_t changed = 0, again = 0;
      for (int move = 0; move < 4; ++move) {
        reach += 0.04;
        changed += CGAL::npbs_adapt(cdt, size(std::cref(d))).number_of_triangles > 0;
        const Content<CDT> before(cdt);
        again += CGAL::npbs_adapt(cdt, size(std::cref(d))).number_of_triangles > 0;
        EXPECT_EQ(Content<CDT>(cdt) == before, again == 0);
      }
      EXPECT_GE(changed, factor < 2 ? 1u : 2u);
      EXPECT_EQ(again, 0u);
      const auto now = quality(cdt, std::cref(d)),
                 once = quality(domains::mesh({domains::square(0, 0, 1)}, std::cref(d)), std::cref(d));
      // at most .064 is measured
      EXPECT_NEAR(double(now.number_of_vertices()) / double(once.number_of_vertices()), 1, 0.08);
      EXPECT_GE(now.minimum_quality(), 0.8);
    }
}

TEST(Misfits, are_where_sizes_changed)
{
  const CDT cdt = at_once(0.02);
  Places d;
  d.smaller.push_back({0.2, 0.3, 0.3});
  std::size_t last = 0;
  for (int rings : {0, 1, 4}) {
    const auto found = CGAL::npbs_misfit_faces(cdt, size(d).number_of_rings(rings));
    EXPECT_GT(found.size(), last);
    last = found.size();
    for (CDT::Face_handle f : found) {
      const Point& p = f->vertex(0)->point();
      EXPECT_LT(std::hypot(p.x() - 0.2, p.y() - 0.3), 0.07 + 0.03 * (rings + 1));
    }
  }
  EXPECT_LT(last, 500u);
}

/// A caller who knows where sizes have changed need not have all of the mesh searched: they are asked for there only.
TEST(Misfits, are_looked_for_where_the_caller_says)
{
  Places d;
  std::size_t calls = 0;
  const auto counted = [&](const Point& p) {
    ++calls;
    return d(p);
  };
  const auto np = size(std::cref(counted));
  CDT cdt = at_once(d);
  d.smaller = {{0.2, 0.3, 0.3}, {0.85, 0.75, 0.3}};
  EXPECT_TRUE(CGAL::npbs_misfit_faces(cdt, np.faces_to_check(Faces())).empty());
  EXPECT_EQ(calls, 0u);
  const Faces everywhere = CGAL::npbs_misfit_faces(cdt, np);
  const std::size_t calls_of_all = calls;
  Faces near = faces_near(cdt, 0.2, 0.3, 0.015);
  near.insert(near.end(), near.begin(), near.begin() + 3);
  calls = 0;
  const Faces found = CGAL::npbs_misfit_faces(cdt, np.faces_to_check(near));
  EXPECT_LT(3 * calls, calls_of_all);
  Faces expected;
  std::copy_if(everywhere.begin(), everywhere.end(), std::back_inserter(expected),
               [](CDT::Face_handle f) { return f->vertex(0)->point().x() < 0.5; });
  EXPECT_LT(expected.size(), everywhere.size());
  EXPECT_GT(found.size(), near.size());
  EXPECT_EQ(std::set<CDT::Face_handle>(found.begin(), found.end()),
            std::set<CDT::Face_handle>(expected.begin(), expected.end()));

  const Content<CDT> before(cdt);
  EXPECT_EQ(CGAL::npbs_adapt(cdt, np.faces_to_check(Faces())).number_of_triangles, 0u);
  EXPECT_EQ(CGAL::npbs_adapt(cdt, np.faces_to_check(faces_near(cdt, 0.5, 0.15, 0.05))).number_of_triangles, 0u);
  EXPECT_TRUE(Content<CDT>(cdt) == before);
  CGAL::npbs_adapt(cdt, np.faces_to_check(near));
  validation::expect_valid_mesh(cdt);
  const Faces left = CGAL::npbs_misfit_faces(cdt, np);
  EXPECT_FALSE(left.empty());
  for (CDT::Face_handle f : left)
    EXPECT_GT(f->vertex(0)->point().x(), 0.5);
}

/// For users whose d is slow: no bubbles are counted before there is a part.
TEST(Misfits, are_looked_for_with_few_calls_of_the_size)
{
  std::size_t calls = 0;
  const auto counted = [&](const Point& p) {
    ++calls;
    return 0.01 + 0.005 * p.x();
  };
  CDT cdt = domains::mesh({domains::square(0, 0, 1)}, std::cref(counted));
  const Faces near = faces_near(cdt, 0.2, 0.5, 0.1);
  EXPECT_GT(near.size(), 200u);
  calls = 0;
  EXPECT_TRUE(CGAL::npbs_misfit_faces(cdt, size(std::cref(counted)).faces_to_check(near)).empty());
  EXPECT_LT(calls, 4 * near.size());
  calls = 0;
  EXPECT_TRUE(CGAL::npbs_misfit_faces(cdt, size(std::cref(counted))).empty());
  EXPECT_LT(calls, 4 * cdt.number_of_faces());
}

/// No sizes are divided for a mesh that is kept, as long as only misfits are looked for.
TEST(Misfits, of_a_mesh_that_would_be_kept_are_the_same)
{
  const CDT cdt = domains::mesh({domains::square(0, 0, 1)}, 0.05);
  for (double d : {0.05, 0.2}) {
    const auto np = size(d);
    const auto found = CGAL::npbs_misfit_faces(cdt, np);
    EXPECT_EQ(found.empty(), d == 0.05);
    EXPECT_EQ(CGAL::npbs_misfit_faces(cdt, np.initial_placement(CGAL::Bubble_placement::KEEP)
                                             .population_control(CGAL::Bubble_population::NONE)).size(), found.size());
  }
}

/// Then the outline is read near these faces only, whatever there is farther away, and asks for the same sizes.
TEST(Misfits, outlines_are_read_near_the_faces_to_check)
{
  std::vector<Outline> outlines{Outline{{0, 0}, {12, 0}, {14, 0.9}, {12, 12}, {0, 12}}}; // a sharp corner, too
  for (int i = 0; i < 10; ++i)
    for (int j = 1; j < 11; ++j)
      outlines.push_back(domains::polygon(i + 1., j + 0.5, 0.25, 8 + i + j));
  CDT cdt = domains::mesh(outlines, 0.2);
  std::set<CDT::Vertex_handle> pinned;
  std::mt19937 random(1);
  for (CDT::Vertex_handle v : cdt.finite_vertex_handles())
    if (random() % 8 == 0)
      pinned.insert(v);
  for (int k = 0; k < 20; ++k) {
    const double x = 0.5 + static_cast<double>(random() % 120) / 10, y = static_cast<double>(random() % 120) / 10;
    SCOPED_TRACE(testing::Message() << x << ' ' << y);
    double reach = 1e9;
    const auto near = [&](const Point& p) {
      const double distance = std::hypot(p.x() - x, p.y() - y);
      if (distance > reach)
        throw std::runtime_error("asked far away");
      return (std::min)(0.2, 0.1 + 0.1 * distance);
    };
    const auto np = size(std::cref(near)).vertex_is_constrained_map(CGAL::make_boolean_property_map(pinned));
    const Faces faces = faces_near(cdt, x, y, 0.9), by_whole_outline = CGAL::npbs_misfit_faces(cdt, np);
    reach = 6.5;
    const Faces found = CGAL::npbs_misfit_faces(cdt, np.faces_to_check(faces));
    EXPECT_TRUE(std::set<CDT::Face_handle>(found.begin(), found.end()) ==
                std::set<CDT::Face_handle>(by_whole_outline.begin(), by_whole_outline.end()));
    EXPECT_TRUE(
      CGAL::npbs_misfit_faces(cdt, size(0.2).vertex_is_constrained_map(CGAL::make_boolean_property_map(pinned)).faces_to_check(faces)).empty());
  }
}

/// A part may grow far beyond them; then all of the outline counts.
TEST(Misfits, grow_far_beyond_the_faces_to_check)
{
  const std::vector<Outline> outlines{domains::square(0, 0, 6), domains::polygon(4.5, 4.5, 0.5, 40)};
  const CDT cdt = domains::mesh(outlines, 0.2);
  const Faces all = CGAL::npbs_misfit_faces(cdt, size(0.1)),
              found = CGAL::npbs_misfit_faces(cdt, size(0.1).faces_to_check(faces_near(cdt, 1, 1, 0.2)));
  EXPECT_EQ(std::set<CDT::Face_handle>(found.begin(), found.end()), std::set<CDT::Face_handle>(all.begin(), all.end()));
}

TEST(Misfits, bad_faces_to_check_are_told)
{
  CDT cdt = at_once(0.05);
  const CDT other = at_once(0.05);
  const Content<CDT> before(cdt);
  const auto check = [&](const CDT::Face_handle f) {
    return [&cdt, f] { CGAL::npbs_adapt(cdt, size(0.02).faces_to_check(Faces{f})); };
  };
  expect_invalid(check(CDT::Face_handle()), {"faces_to_check", "empty handle"});
  expect_invalid(check(cdt.infinite_face()), {"faces_to_check", "infinite"});
  expect_invalid(check(cdt.locate(Point(0.52, 0.5))), {"faces_to_check", "not marked"});
  expect_invalid(check(faces_near(other, 0.5, 0.2, 0.2)[0]), {"faces_to_check", "none of this triangulation"});
  EXPECT_TRUE(Content<CDT>(cdt) == before);

  using Bare = CGAL::Constrained_Delaunay_triangulation_2<domains::K>; // no marks
  const Bare bare = domains::mesh<Bare>({slanted, hole}, 0.05);
  const std::vector<Bare::Face_handle> inside{bare.locate(Point(0.2, 0.2))}, outside{bare.locate(Point(0.52, 0.5))};
  EXPECT_FALSE(CGAL::npbs_misfit_faces(bare, size(0.02).faces_to_check(inside)).empty());
  expect_invalid([&] { CGAL::npbs_misfit_faces(bare, size(0.02).faces_to_check(outside)); },
                 {"faces_to_check", "not in the domain"});
}

TEST(Misfits, small_angles_count)
{
  CDT cdt = at_once(0.05);
  CDT::Vertex_handle v = cdt.locate(Point(0.2, 0.3))->vertex(0);
  const Point p = v->point();
  cdt.insert(Point(p.x() + 0.002, p.y()))->face();
  for (CDT::Face_handle f : cdt.finite_face_handles())
    if (!f->is_in_domain() && std::hypot(f->vertex(0)->point().x() - p.x(), f->vertex(0)->point().y() - p.y()) < 0.15)
      f->set_in_domain(true);
  const auto loose = size(0.05).shortest_edge(0.01).longest_edge(9.);
  EXPECT_TRUE(CGAL::npbs_misfit_faces(cdt, loose.misfit_angle(0.)).empty());
  EXPECT_FALSE(CGAL::npbs_misfit_faces(cdt, loose.misfit_angle(0.).misfit_quality(0.5)).empty());
  EXPECT_FALSE(CGAL::npbs_misfit_faces(cdt, loose).empty());
  CGAL::npbs_adapt(cdt, loose);
  EXPECT_TRUE(CGAL::npbs_misfit_faces(cdt, loose).empty());
  EXPECT_GE(quality(cdt, 0.05).minimum_quality(), 0.85);
}

/// as good as if the mesh was made at once
TEST(Adapt_quality, of_places_that_are_refined_and_given_back)
{
  Places d;
  CDT cdt = at_once(d);
  const auto expect_good = [&](const auto& report) {
    const auto once = quality(at_once(d), d), now = quality(cdt, d);
    validation::expect_valid_mesh(cdt);
    EXPECT_GE(report.quality.mean_quality(), 0.985);
    EXPECT_NEAR(report.quality.mean_length_ratio(), 1, 0.021);
    EXPECT_GE(now.minimum_quality(), once.minimum_quality() - 0.001);
    EXPECT_NEAR(now.mean_quality(), once.mean_quality(), 0.001);
    EXPECT_NEAR(double(now.number_of_vertices()) / double(once.number_of_vertices()), 1, 0.012);
  };
  const std::size_t before = cdt.number_of_vertices();
  for (const auto& [x, y] : {std::make_pair(0.2, 0.3), std::make_pair(0.5, 0.05), std::make_pair(1.1, 0.9)}) {
    d.smaller.push_back({x, y, 0.25});
    expect_good(CGAL::npbs_adapt(cdt, size(d)));
    EXPECT_GT(cdt.number_of_vertices(), before + 10);
    d.smaller.clear();
    expect_good(CGAL::npbs_adapt(cdt, size(d)));
    EXPECT_LE(cdt.number_of_vertices(), before + 5);
  }
}

/// the points of all rims that there were
struct Rims : CGAL::Default_adaptation_visitor_2<CDT>
{
  std::set<Point> points;

  void after_change(const Faces& faces, const Vertices&)
  {
    const std::set<CDT::Face_handle> inside(faces.begin(), faces.end());
    for (CDT::Face_handle f : faces)
      for (int i = 0; i < 3; ++i)
        if (f->neighbor(i)->is_in_domain() && inside.count(f->neighbor(i)) == 0)
          points.insert(f->vertex(CDT::ccw(i))->point());
  }
};

/// by how much the mean of q is less in triangles at former rims than elsewhere
double seam(const CDT& cdt, const std::set<Point>& rims)
{
  double sums[] = {0, 0}, numbers[] = {0, 0};
  for (CDT::Face_handle f : cdt.finite_face_handles()) {
    if (!f->is_in_domain())
      continue;
    const int is_at_rim = rims.count(f->vertex(0)->point()) + rims.count(f->vertex(1)->point()) +
                            rims.count(f->vertex(2)->point()) > 0;
    sums[is_at_rim] += CGAL::radius_ratio_2(f->vertex(0)->point(), f->vertex(1)->point(), f->vertex(2)->point());
    numbers[is_at_rim] += 1;
  }
  EXPECT_GT(numbers[1], 500);
  return sums[0] / numbers[0] - sums[1] / numbers[1];
}

/// The vertices of former rims are like others: where parts are meshed again and again no seam is left. Means of three
/// meshes, since the smallest q of one is a matter of luck, at once or not.
TEST(Adapt_quality, does_not_drift)
{
  double mean_quality = 0, mean_length = 0, smallest = 0, difference = 0; // at once, less what it is after changes
  constexpr int number_of_meshes = 3;
  for (int mesh = 1; mesh <= number_of_meshes; ++mesh) {
    std::mt19937 random(static_cast<unsigned>(mesh));
    const auto uniform = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(random); };
    Places d;
    CDT cdt = at_once(d);
    Rims rims;
    for (int k = 0; k < 60; ++k) {
      if (d.smaller.size() == 5)
        d.smaller.erase(d.smaller.begin());
      const double x = uniform(0, 1.1), y = uniform(0, 1);
      d.smaller.push_back({x, y, uniform(0.2, 0.6)});
      CGAL::npbs_adapt(cdt, size(d).visitor(std::ref(rims)));
    }
    validation::expect_valid_mesh(cdt);
    const auto after = quality(cdt, d), once = quality(at_once(d), d);
    mean_quality += (once.mean_quality() - after.mean_quality()) / number_of_meshes;
    mean_length += (once.mean_length_ratio() - after.mean_length_ratio()) / number_of_meshes;
    smallest += (once.minimum_quality() - after.minimum_quality()) / number_of_meshes;
    difference += seam(cdt, rims.points) / number_of_meshes;
    EXPECT_GE(after.minimum_quality(), 0.88);
  }
  // measured: .0011, .0087, .0042, -.0032
  EXPECT_LE(mean_quality, 0.002);
  EXPECT_NEAR(mean_length, 0, 0.01);
  EXPECT_LE(smallest, 0.008);
  EXPECT_LE(difference, 0.);
}

} // namespace test_misfits
