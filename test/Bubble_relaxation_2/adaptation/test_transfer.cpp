// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// Values at vertices and of faces that are carried over from one mesh to another.

#include "domains.h"
#include "expect_throw.h"
#include "random_seeds.h"

#include <CGAL/npbs_relax.h>
#include <CGAL/transfer_2.h>

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <random>
#include <set>
#include <sstream>
#include <utility>
#include <vector>

namespace test_transfer {

namespace P = CGAL::parameters;
using CGAL::Face_transfer;
using CGAL::Vertex_transfer;
using domains::CDT;
using domains::K;
using domains::mesh;
using domains::Point;
using Delaunay = CGAL::Delaunay_triangulation_2<K>;

const std::vector<Vertex_transfer> projections{Vertex_transfer::PROJECTION, Vertex_transfer::MONOTONE_PROJECTION};
const std::vector<Vertex_transfer> vertex_methods{Vertex_transfer::INTERPOLATION, Vertex_transfer::PROJECTION,
                                                  Vertex_transfer::MONOTONE_PROJECTION};
const std::vector<Face_transfer> face_methods{Face_transfer::MEAN, Face_transfer::RECONSTRUCTION,
                                              Face_transfer::MONOTONE_RECONSTRUCTION};

template <class Handle>
using Values = std::map<Handle, double>;
template <class T>
using Vertex_values = Values<typename T::Vertex_handle>;
template <class T>
using Face_values = Values<typename T::Face_handle>;

template <class T, class Function>
Vertex_values<T> at_vertices(const T& t, const Function& f)
{
  Vertex_values<T> values;
  for (auto v : t.finite_vertex_handles())
    values[v] = f(v->point());
  return values;
}

/// the mean of a function over a triangle, exact for quadratic ones
template <class Function>
double mean(const K::Triangle_2& t, const Function& f)
{
  return (f(CGAL::midpoint(t[0], t[1])) + f(CGAL::midpoint(t[1], t[2])) + f(CGAL::midpoint(t[2], t[0]))) / 3;
}

template <class T, class Function>
Face_values<T> in_faces(const T& t, const Function& f)
{
  Face_values<T> values;
  for (auto face : t.finite_face_handles())
    values[face] = mean(t.triangle(face), f);
  return values;
}

template <class S, class T, class Parameters>
CGAL::Transfer_report_2 transfer(const S& s, const Vertex_values<S>& values, const T& t, Vertex_values<T>& result,
                                 const Parameters& np)
{
  return CGAL::transfer_vertex_values_2(s, boost::make_assoc_property_map(values), t,
                                        boost::make_assoc_property_map(result), np);
}

template <class S, class T, class Parameters>
CGAL::Transfer_report_2 transfer(const S& s, const Face_values<S>& values, const T& t, Face_values<T>& result,
                                 const Parameters& np)
{
  return CGAL::transfer_face_values_2(s, boost::make_assoc_property_map(values), t,
                                      boost::make_assoc_property_map(result), np);
}

template <class T>
void expect_values(const Vertex_values<T>& values, const Vertex_values<T>& expected, double tolerance)
{
  ASSERT_EQ(values.size(), expected.size());
  for (const auto& v : values)
    ASSERT_NEAR(v.second, expected.at(v.first), tolerance) << v.first->point();
}

template <class Handle>
bool is_less(const std::pair<const Handle, double>& a, const std::pair<const Handle, double>& b)
{
  return a.second < b.second;
}

template <class Handle>
double least(const Values<Handle>& values)
{
  return std::min_element(values.begin(), values.end(), is_less<Handle>)->second;
}

template <class Handle>
double largest(const Values<Handle>& values)
{
  return std::max_element(values.begin(), values.end(), is_less<Handle>)->second;
}

template <class Source, class Target>
void expect_no_new_extremes(const Values<Source>& source, const Values<Target>& target)
{
  EXPECT_GE(least(target), least(source));
  EXPECT_LE(largest(target), largest(source));
}

/// the values by the points, or centroids, that they belong to
template <class T>
std::map<Point, double> by_place(const T&, const Vertex_values<T>& values)
{
  std::map<Point, double> result;
  for (const auto& v : values)
    result[v.first->point()] = v.second;
  return result;
}

template <class T>
std::map<Point, double> by_place(const T& t, const Face_values<T>& values)
{
  std::map<Point, double> result;
  for (const auto& f : values)
    result[CGAL::centroid(t.triangle(f.first))] = f.second;
  return result;
}

/// of a face, in an order that does not depend on it
template <class Face_handle>
std::vector<Point> sorted_corners(Face_handle f)
{
  std::vector<Point> c{f->vertex(0)->point(), f->vertex(1)->point(), f->vertex(2)->point()};
  std::sort(c.begin(), c.end());
  return c;
}

template <class T>
Vertex_values<T> random_at_vertices(const T& t)
{
  std::mt19937 random(random_seeds::seed());
  std::uniform_real_distribution<double> uniform(-1, 3);
  return at_vertices(t, [&](const Point&) { return uniform(random); });
}

template <class T>
Face_values<T> random_in_faces(const T& t)
{
  std::mt19937 random(random_seeds::seed());
  std::uniform_real_distribution<double> uniform(-1, 3);
  Face_values<T> values;
  for (auto f : t.finite_face_handles())
    values[f] = uniform(random);
  return values;
}

double wave(const Point& p) { return std::sin(3 * p.x() + 1) * std::cos(2 * p.y() - 0.3); }

double linear(const Point& p) { return 2 - 3 * p.x() + 0.5 * p.y(); }

const std::vector<domains::Outline> star = domains::random_star(3);

/// the difference from a function in the mean square
double error_at_vertices(const CDT& cdt, const Vertex_values<CDT>& values)
{
  double sum = 0;
  for (auto f : cdt.finite_face_handles())
    if (f->is_in_domain())
      for (int i = 0; i < 3; ++i) {
        const auto a = f->vertex(i), b = f->vertex(cdt.ccw(i));
        const double e = (values.at(a) + values.at(b)) / 2 - wave(CGAL::midpoint(a->point(), b->point()));
        sum += cdt.triangle(f).area() / 3 * e * e;
      }
  return std::sqrt(sum);
}

/// the difference from the means of a function, in the mean square
double error_in_faces(const CDT& cdt, const Face_values<CDT>& values)
{
  double sum = 0;
  for (const auto& v : values) {
    const double e = v.second - mean(cdt.triangle(v.first), wave);
    sum += cdt.triangle(v.first).area() * e * e;
  }
  return std::sqrt(sum);
}

TEST(Transfer, linear_fields_are_exact)
{
  const CDT s = mesh(star, 0.08), t = mesh(star, 0.05);
  for (Vertex_transfer method : vertex_methods) {
    Vertex_values<CDT> values;
    transfer(s, at_vertices(s, linear), t, values, P::transfer_method(method));
    expect_values<CDT>(values, at_vertices(t, linear), 3e-14);
  }
  Face_values<CDT> values;
  transfer(s, in_faces(s, linear), t, values, P::transfer_method(Face_transfer::RECONSTRUCTION));
  for (const auto& v : values)
    EXPECT_NEAR(v.second, mean(t.triangle(v.first), linear), 1e-13);
}

TEST(Transfer, constants_are_exact_to_the_last_bit)
{
  const CDT s = mesh(star, 0.08), t = mesh(star, 0.05);
  const auto constant = [](const Point&) { return 0.1; };
  for (Vertex_transfer method : vertex_methods) {
    Vertex_values<CDT> values;
    transfer(s, at_vertices(s, constant), t, values, P::transfer_method(method));
    EXPECT_NEAR(least(values), 0.1, 1e-16);
    EXPECT_NEAR(largest(values), 0.1, 1e-16);
  }
  for (Face_transfer method : face_methods) {
    Face_values<CDT> in_s, values;
    for (auto f : s.finite_face_handles())
      in_s[f] = 0.1;
    transfer(s, in_s, t, values, P::transfer_method(method));
    EXPECT_EQ(least(values), 0.1);
    EXPECT_EQ(largest(values), 0.1);
  }
}

TEST(Transfer, the_integral_is_kept)
{
  const CDT s = mesh(star, 0.08), t = mesh(star, 0.05);
  const auto expect_kept = [](const CGAL::Transfer_report_2& r) {
    EXPECT_NEAR(r.target_integral, r.source_integral, 1e-13 * std::abs(r.source_integral));
    EXPECT_NEAR(r.overlap_integral, r.source_integral, 1e-13 * std::abs(r.source_integral));
    EXPECT_NEAR(r.overlap_area, r.source_area, 1e-13 * r.source_area);
    EXPECT_LE(r.uncovered_area, 1e-13 * r.source_area);
  };
  Vertex_values<CDT> at_t;
  Face_values<CDT> in_t;
  for (Vertex_transfer method : projections)
    expect_kept(transfer(s, random_at_vertices(s), t, at_t, P::transfer_method(method)));
  for (Face_transfer method : face_methods)
    expect_kept(transfer(s, random_in_faces(s), t, in_t, P::transfer_method(method)));
}

TEST(Transfer, errors_are_of_second_order)
{
  std::map<int, std::vector<double>> errors;
  for (double d : {0.08, 0.04, 0.02}) {
    const CDT s = mesh({domains::square(0, 0, 1)}, d), t = mesh({domains::square(0, 0, 1)}, 0.83 * d);
    int k = 0;
    for (Vertex_transfer method : vertex_methods) {
      Vertex_values<CDT> values;
      transfer(s, at_vertices(s, wave), t, values, P::transfer_method(method));
      errors[k++].push_back(error_at_vertices(t, values));
    }
    for (Face_transfer method : face_methods) {
      Face_values<CDT> values;
      transfer(s, in_faces(s, wave), t, values, P::transfer_method(method));
      errors[k++].push_back(error_in_faces(t, values));
    }
  }
  // bounds cut slopes in the triangles along the boundary: an error of first order on a share d of the area
  const std::vector<double> least_order{1.95, 1.95, 1.95, 0.9, 1.95, 1.5},
    largest_error{3.1e-4, 1.9e-4, 1.9e-4, 2.9e-3, 3.6e-5, 1.4e-4};
  for (int k = 0; k < 6; ++k) {
    EXPECT_GT(std::log2(errors[k][1] / errors[k][2]), least_order[k]) << k;
    EXPECT_LT(errors[k][2], largest_error[k]) << k;
  }
}

/// A mesh of a disc whose outline is a regular polygon, and the same turned about its centre by an angle of the
/// polygon, so that both cover the same, up to roundings. Values go round with the turned mesh and back to the other
/// one.
struct Turning_disc
{
  static constexpr int sides = 100;

  Turning_disc() : mesh(domains::mesh({domains::polygon(0, 0, 1, sides)}, 2 * CGAL_PI / sides)), turned(mesh)
  {
    std::map<Point, CDT::Vertex_handle> vertex_at;
    std::map<Point, CDT::Face_handle> face_at;
    for (auto v : mesh.finite_vertex_handles())
      vertex_at[v->point()] = v;
    for (auto f : mesh.finite_face_handles())
      face_at[CGAL::centroid(mesh.triangle(f))] = f;
    for (auto f : turned.finite_face_handles())
      face_before[f] = face_at.at(CGAL::centroid(turned.triangle(f)));
    const double angle = 2 * 3.14159265358979323846 / sides, c = std::cos(angle), s = std::sin(angle);
    for (auto v : turned.finite_vertex_handles()) {
      const Point p = v->point();
      vertex_before[v] = vertex_at.at(p);
      v->set_point(Point(c * p.x() - s * p.y(), s * p.x() + c * p.y()));
    }
  }

  template <class Handle, class Before, class Method>
  CGAL::Transfer_report_2 turn(Values<Handle>& values, const Before& before, Method method) const
  {
    Values<Handle> carried;
    for (const auto& b : before)
      carried[b.first] = values.at(b.second);
    return transfer(turned, carried, mesh, values, P::transfer_method(method));
  }

  CDT mesh, turned;
  std::map<CDT::Vertex_handle, CDT::Vertex_handle> vertex_before;
  std::map<CDT::Face_handle, CDT::Face_handle> face_before;
};

/// a disc with a slot (Zalesak, 1979)
double slotted_disc(const Point& p)
{
  return std::hypot(p.x(), p.y() - 0.45) < 0.4 && !(std::abs(p.x()) < 0.08 && p.y() < 0.6) ? 1 : 0;
}

/// how much of a field is elsewhere after a full turn
template <class Handle>
double moved_share(const Values<Handle>& before, const Values<Handle>& after)
{
  double moved = 0, all = 0;
  for (const auto& v : before) {
    moved += std::abs(after.at(v.first) - v.second);
    all += v.second;
  }
  return moved / all;
}

struct Turn_result
{
  double drift, least, largest, moved;
};

/// whether a transfer intersects triangles, and so knows what is covered
bool intersects(Vertex_transfer method) { return method != Vertex_transfer::INTERPOLATION; }
bool intersects(Face_transfer) { return true; }

/// turns a slotted disc round by 100 transfers
template <class Handle, class Before, class Method>
Turn_result full_turn(const Turning_disc& disc, const Values<Handle>& before, const Before& handle_before,
                      Method method)
{
  Values<Handle> values = before;
  double first = 0, last = 0;
  for (int k = 0; k < Turning_disc::sides; ++k) {
    const CGAL::Transfer_report_2 report = disc.turn(values, handle_before, method);
    if (k == 0)
      first = report.source_integral;
    last = report.target_integral;
    if (intersects(method)) {
      EXPECT_LE(report.uncovered_area, 1e-13 * report.target_area);
    }
  }
  return {std::abs(last / first - 1), least(values), largest(values), moved_share(before, values)};
}

TEST(Transfer, a_slotted_disc_goes_round)
{
  const Turning_disc disc;
  const auto turn = [&](Vertex_transfer method) {
    return full_turn(disc, at_vertices(disc.mesh, slotted_disc), disc.vertex_before, method);
  };
  EXPECT_GT(turn(Vertex_transfer::INTERPOLATION).drift, 0.01); // what the others are for
  Turn_result r = turn(Vertex_transfer::PROJECTION);
  EXPECT_LT(r.drift, 2e-15);
  EXPECT_LT(r.moved, 0.40);
  r = turn(Vertex_transfer::MONOTONE_PROJECTION);
  EXPECT_LT(r.drift, 2e-15);
  EXPECT_GE(r.least, 0);
  EXPECT_LE(r.largest, 1);
  EXPECT_GT(r.largest, 0.99);
  EXPECT_LT(r.moved, 0.37);
}

TEST(Transfer, a_slotted_disc_of_faces_goes_round)
{
  const Turning_disc disc;
  const auto turn = [&](Face_transfer method) {
    return full_turn(disc, in_faces(disc.mesh, slotted_disc), disc.face_before, method);
  };
  const Turn_result blurred = turn(Face_transfer::MEAN);
  EXPECT_LT(blurred.drift, 2e-15);
  Turn_result r = turn(Face_transfer::RECONSTRUCTION);
  EXPECT_LT(r.drift, 2e-15);
  EXPECT_LT(r.moved, 0.43);
  r = turn(Face_transfer::MONOTONE_RECONSTRUCTION);
  EXPECT_LT(r.drift, 2e-15);
  EXPECT_GE(r.least, 0);
  EXPECT_LE(r.largest, 1);
  EXPECT_GT(r.largest, 0.98);
  EXPECT_LT(r.moved, 0.41);
  EXPECT_LT(r.moved, 0.5 * blurred.moved);
}

TEST(Transfer, no_new_extremes)
{
  const CDT s = mesh(star, 0.08), t = mesh(star, 0.05);
  for (const auto& way : {std::make_pair(&s, &t), std::make_pair(&t, &s)}) {
    const Vertex_values<CDT> at_source = random_at_vertices(*way.first);
    const Face_values<CDT> in_source = random_in_faces(*way.first);
    for (Vertex_transfer method : {Vertex_transfer::INTERPOLATION, Vertex_transfer::MONOTONE_PROJECTION}) {
      Vertex_values<CDT> values;
      transfer(*way.first, at_source, *way.second, values, P::transfer_method(method));
      expect_no_new_extremes(at_source, values);
    }
    for (Face_transfer method : {Face_transfer::MEAN, Face_transfer::MONOTONE_RECONSTRUCTION}) {
      Face_values<CDT> values;
      transfer(*way.first, in_source, *way.second, values, P::transfer_method(method));
      expect_no_new_extremes(in_source, values);
    }
  }
}

TEST(Transfer, what_does_not_change_keeps_its_bits)
{
  const CDT s = mesh(star, 0.08), t = s;
  const Vertex_values<CDT> at_s = random_at_vertices(s);
  const std::map<Point, double> expected = by_place(s, at_s);
  for (Vertex_transfer method : {Vertex_transfer::INTERPOLATION, Vertex_transfer::PROJECTION}) {
    Vertex_values<CDT> values;
    transfer(s, at_s, t, values, P::transfer_method(method));
    for (const auto& v : values)
      EXPECT_NEAR(v.second, expected.at(v.first->point()), method == Vertex_transfer::PROJECTION ? 2e-15 : 0);
  }
  const Face_values<CDT> in_s = random_in_faces(s);
  const std::map<Point, double> value_at = by_place(s, in_s);
  for (Face_transfer method : face_methods) {
    Face_values<CDT> values;
    transfer(s, in_s, t, values, P::transfer_method(method));
    for (const auto& f : values)
      EXPECT_NEAR(f.second, value_at.at(CGAL::centroid(t.triangle(f.first))), 2e-15);
  }
}

// beside values that are very much larger as well
TEST(Transfer, interpolation_keeps_the_bits_of_small_values)
{
  const CDT s = mesh(star, 0.1), t = s;
  Vertex_values<CDT> at_s = at_vertices(s, [](const Point& p) { return 1e-20 * wave(p); }), values;
  at_s.begin()->second = 1e300;
  transfer(s, at_s, t, values, P::transfer_method(Vertex_transfer::INTERPOLATION));
  EXPECT_TRUE(by_place(t, values) == by_place(s, at_s));
}

// each triangle looking at all around each of its corners would take many minutes
TEST(Transfer, slopes_around_a_vertex_of_high_degree)
{
  namespace internal = CGAL::Bubble_relaxation_2::internal;
  for (const int n : {300, 200000}) {
    internal::Face_set_2 fan;
    fan.points.emplace_back(0, 0);
    for (int k = 0; k <= n; ++k)
      fan.points.emplace_back(std::cos(1.5 * k / n), std::sin(1.5 * k / n));
    std::vector<double> values;
    for (int k = 1; k <= n; ++k) {
      fan.triangles.push_back({0, k, k + 1});
      values.push_back(linear(CGAL::centroid(fan.points[0], fan.points[k], fan.points[k + 1])));
    }
    const internal::Triangles_around_2 around(fan.triangles, fan.points.size(), [](std::size_t) { return true; });
    const std::vector<internal::Offset_2> slopes = internal::face_slopes(fan, around, values);
    for (int k = 0; k < n; k += n / 100) // roundings count as much as the triangles are slim
      EXPECT_NEAR(slopes[k].x, linear(fan.points[k + 1]) - linear(fan.points[0]), n > 1000 ? 1e-2 : 1e-8);
    const std::vector<internal::Bounds> bounds = internal::bounds_around(fan, around, values);
    EXPECT_EQ(bounds[n / 2].least, *std::min_element(values.begin(), values.end()));
    EXPECT_EQ(bounds[n / 2].largest, *std::max_element(values.begin(), values.end()));
  }
}

std::vector<Point> random_points(std::size_t n, unsigned k)
{
  std::mt19937 random(random_seeds::seed(k));
  std::uniform_real_distribution<double> uniform(0, 1);
  std::vector<Point> points{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  while (points.size() < n)
    points.emplace_back(uniform(random), uniform(random));
  return points;
}

template <class Function>
std::vector<Point> mapped(std::vector<Point> points, const Function& f)
{
  std::transform(points.begin(), points.end(), points.begin(), f);
  return points;
}

TEST(Transfer, has_the_same_bits_in_any_order)
{
  std::vector<Point> p = random_points(300, 0), q = random_points(400, 1);
  const Delaunay s(p.begin(), p.end()), t(q.begin(), q.end());
  Delaunay other_s, other_t; // no sorting in space before insertion
  for (auto k = p.rbegin(); k != p.rend(); ++k)
    other_s.insert(*k);
  for (auto k = q.rbegin(); k != q.rend(); ++k)
    other_t.insert(*k);
  const auto rough = [](const Point& x) { return std::sin(40 * x.x()) * std::cos(30 * x.y()) + 0.1; };
  for (Vertex_transfer method : vertex_methods) {
    Vertex_values<Delaunay> a, b;
    transfer(s, at_vertices(s, rough), t, a, P::transfer_method(method));
    transfer(other_s, at_vertices(other_s, rough), other_t, b, P::transfer_method(method));
    EXPECT_TRUE(by_place(t, a) == by_place(other_t, b));
  }
  for (Face_transfer method : face_methods) {
    const auto by_area = [](const Delaunay& d) { // of the corners in an order that is the same for all
      Face_values<Delaunay> values;
      for (auto f : d.finite_face_handles()) {
        const std::vector<Point> c = sorted_corners(f);
        values[f] = c.front().y() + c.back().y();
      }
      return values;
    };
    const auto by_corners = [](const Delaunay& d, const Face_values<Delaunay>& values) {
      std::map<std::vector<Point>, double> result;
      for (const auto& f : values)
        result[sorted_corners(f.first)] = f.second;
      EXPECT_EQ(result.size(), d.number_of_faces());
      return result;
    };
    Face_values<Delaunay> a, b;
    transfer(s, by_area(s), t, a, P::transfer_method(method));
    transfer(other_s, by_area(other_s), other_t, b, P::transfer_method(method));
    EXPECT_TRUE(by_corners(t, a) == by_corners(other_t, b));
  }
}

TEST(Transfer, does_not_depend_on_units)
{
  const std::vector<Point> p = random_points(300, 0), q = random_points(400, 1);
  const auto values_in = [&](double length, double value) {
    const auto scale = [&](const Point& x) { return Point(length * x.x(), length * x.y()); };
    const std::vector<Point> p_scaled = mapped(p, scale), q_scaled = mapped(q, scale);
    const Delaunay s(p_scaled.begin(), p_scaled.end()), t(q_scaled.begin(), q_scaled.end());
    std::vector<double> all;
    for (Vertex_transfer method : vertex_methods) {
      Vertex_values<Delaunay> values;
      transfer(s, at_vertices(s, [&](const Point& x) { return value * wave(Point(x.x() / length, x.y() / length)); }),
               t, values, P::transfer_method(method));
      for (const auto& v : by_place(t, values))
        all.push_back(v.second / value);
    }
    return all;
  };
  const std::vector<double> expected = values_in(1, 1);
  for (double length : {std::ldexp(1., 200), std::ldexp(1., -200)})
    for (double value : {std::ldexp(1., 900), std::ldexp(1., -900)})
      EXPECT_TRUE(values_in(length, value) == expected) << length << ' ' << value;
}

TEST(Transfer, far_from_the_origin_and_in_needles)
{
  const auto far = [](const Point& x) { return Point(1e6 + x.x(), -3e6 + x.y()); };
  const auto flat = [](const Point& x) { return Point(x.x(), 1e-6 * x.y()); };
  const auto slanted = [](const Point& x) { return Point(x.x() + x.y(), x.x() + (1 + 1e-9) * x.y()); };
  const auto hostile = [](const Point& x) { // layers, within each points on a line up to roundings
    const double y = std::round(30 * x.y()) / 30;
    return Point(x.x(), 0.1 * x.x() + y);
  };
  for (const std::function<Point(const Point&)>& f :
       std::vector<std::function<Point(const Point&)>>{far, flat, slanted, hostile}) {
    const std::vector<Point> p = mapped(random_points(1000, 0), f), q = mapped(random_points(1500, 1), f);
    const Delaunay s(p.begin(), p.end()), t(q.begin(), q.end());
    Vertex_values<Delaunay> at_t;
    Face_values<Delaunay> in_t;
    for (Vertex_transfer method : projections) {
      const auto r = transfer(s, random_at_vertices(s), t, at_t, P::transfer_method(method));
      EXPECT_NEAR(r.target_integral, r.source_integral, 1e-13 * std::abs(r.source_integral)) << p[4];
      EXPECT_LE(r.uncovered_area, 1e-12 * r.target_area) << p[4];
    }
    for (Face_transfer method : face_methods) {
      const auto r = transfer(s, random_in_faces(s), t, in_t, P::transfer_method(method));
      EXPECT_NEAR(r.target_integral, r.source_integral, 1e-13 * std::abs(r.source_integral)) << p[4];
    }
  }
}

TEST(Transfer, what_is_not_covered_goes_on_with_the_nearest_value)
{
  const CDT s = mesh({domains::square(0, 0, 1)}, 0.1), t = mesh({domains::square(0, 0, 1.5)}, 0.1);
  const auto x = [](const Point& p) { return 1 + p.x(); };
  const auto nearest = [](const Point& p) { return 1 + (std::min)(1., p.x()); };
  Vertex_values<CDT> values;
  auto r = transfer(s, at_vertices(s, x), t, values, P::transfer_method(Vertex_transfer::INTERPOLATION));
  expect_values<CDT>(values, at_vertices(t, nearest), 1e-14);
  EXPECT_NEAR(r.source_area, 1, 1e-14);
  EXPECT_NEAR(r.target_area, 2.25, 1e-14);
  EXPECT_NEAR(r.source_integral, 1.5, 1e-14);
  EXPECT_NEAR(r.target_integral, 1.5 * (1.5 + 0.5 * 2), 0.02);
  for (double unknown : {r.overlap_area, r.uncovered_area, r.overlap_integral}) // nothing is intersected
    EXPECT_TRUE(std::isnan(unknown));
  EXPECT_EQ(r.number_of_pairs, 0u);
  std::ostringstream text;
  text << r;
  EXPECT_EQ(text.str().find("nan"), std::string::npos) << text.str();
  r = transfer(s, at_vertices(s, x), t, values, P::default_values());
  EXPECT_NEAR(r.overlap_area, 1, 1e-14);
  EXPECT_NEAR(r.uncovered_area, 1.25, 1e-14);
  EXPECT_NEAR(r.source_integral, 1.5, 1e-14);
  EXPECT_NEAR(r.overlap_integral, 1.5, 1e-14);
  EXPECT_NEAR(r.target_integral, 1.5 * (1.5 + 0.5 * 2), 0.02); // the kink at x = 1 lies inside of triangles
  for (const auto& v : values)
    EXPECT_NEAR(v.second, nearest(v.first->point()), 0.03) << v.first->point();

  Face_values<CDT> in_t;
  r = transfer(s, in_faces(s, x), t, in_t, P::default_values());
  EXPECT_NEAR(r.overlap_integral, 1.5, 1e-14);
  EXPECT_LE(largest(in_t), 2);
  for (const auto& f : in_t)
    EXPECT_NEAR(f.second, nearest(CGAL::centroid(t.triangle(f.first))), 0.07);

  // and back: what the target does not cover is left out
  const Face_values<CDT> in_t_before = in_faces(t, x);
  Face_values<CDT> in_s;
  r = transfer(t, in_t_before, s, in_s, P::default_values());
  EXPECT_NEAR(r.source_integral, 1.75 * 2.25, 1e-13);
  EXPECT_NEAR(r.target_integral, r.overlap_integral, 1e-13);
  EXPECT_NEAR(r.uncovered_area, 0, 1e-14);
  EXPECT_NEAR(r.target_integral, 1.5, 0.02);
}

TEST(Transfer, keeps_the_whole_integral_on_demand)
{
  // a hole as two polygons: triangles of the finer one reach into the coarser one, which reaches beyond it elsewhere
  const CDT s = mesh({domains::square(-1, -1, 2), domains::polygon(0, 0, 0.5, 20)}, 0.15),
            t = mesh({domains::square(-1, -1, 2), domains::polygon(0, 0, 0.5, 31)}, 0.1);
  Vertex_values<CDT> values;
  const Vertex_values<CDT> at_s = at_vertices(s, wave);
  for (Vertex_transfer method : projections) {
    auto r = transfer(s, at_s, t, values, P::transfer_method(method));
    EXPECT_GT(std::abs(r.target_integral - r.source_integral), 1e-4);
    EXPECT_LT(std::abs(r.target_integral - r.source_integral), r.uncovered_area + r.source_area - r.overlap_area);
    r = transfer(s, at_s, t, values, P::transfer_method(method).keep_integral(true));
    EXPECT_NEAR(r.target_integral, r.source_integral, 1e-14 * r.source_area);
  }
  expect_no_new_extremes(at_s, values);
  Face_values<CDT> in_t;
  const Face_values<CDT> in_s = in_faces(s, wave);
  for (Face_transfer method : face_methods) {
    const auto r = transfer(s, in_s, t, in_t, P::transfer_method(method).keep_integral(true));
    EXPECT_NEAR(r.target_integral, r.source_integral, 1e-14 * r.source_area);
  }
  expect_no_new_extremes(in_s, in_t);
}

TEST(Transfer, marks_and_maps_tell_what_takes_part)
{
  const CDT s = mesh({domains::square(0, 0, 1), domains::square(0.3, 0.3, 0.4)}, 0.1); // with a hole
  const CDT t = mesh({domains::square(0, 0, 1), domains::square(0.3, 0.3, 0.4)}, 0.08);
  Face_values<CDT> values;
  const Face_values<CDT> in_s = in_faces(s, linear);
  auto r = transfer(s, in_s, t, values, P::default_values());
  EXPECT_NEAR(r.source_area, 1 - 0.16, 1e-14);
  EXPECT_NEAR(r.overlap_area, 1 - 0.16, 1e-14);

  std::map<CDT::Face_handle, bool> is_left;
  std::vector<CDT::Face_handle> all;
  for (auto f : s.finite_face_handles()) {
    is_left[f] = CGAL::centroid(s.triangle(f)).x() < 0.5;
    all.insert(all.end(), 2, f); // what comes twice counts once
  }
  r = transfer(s, in_s, t, values, P::source_in_domain_map(boost::make_assoc_property_map(is_left)));
  EXPECT_NEAR(r.source_area, 0.5, 0.05);
  EXPECT_NEAR(r.target_area, 1 - 0.16, 1e-14);
  r = transfer(s, in_s, t, values, P::source_faces(all));
  EXPECT_NEAR(r.source_area, 1, 1e-14);
}

TEST(Transfer, a_part_keeps_its_rim_and_its_integral)
{
  const CDT s = mesh({domains::square(0, 0, 1)}, 0.05);
  CDT t = s;
  t.insert(Point(0.51, 0.47)); // what a remesher of parts would do with more vertices
  t.insert(Point(0.53, 0.52));
  std::map<std::vector<Point>, CDT::Face_handle> kept;
  for (auto f : t.finite_face_handles())
    kept[sorted_corners(f)] = f;
  std::vector<CDT::Face_handle> removed, added;
  for (auto f : s.finite_face_handles())
    if (kept.erase(sorted_corners(f)) == 0)
      removed.push_back(f);
  for (const auto& k : kept)
    added.push_back(k.second);
  std::set<CDT::Vertex_handle> rim;
  const Vertex_values<CDT> at_s = random_at_vertices(s);
  const std::map<Point, double> before = by_place(s, at_s);
  for (CDT::Face_handle f : added)
    for (int i = 0; i < 3; ++i)
      if (before.count(f->vertex(i)->point()) > 0)
        rim.insert(f->vertex(i));
  ASSERT_GT(removed.size(), 3u);
  ASSERT_GT(rim.size(), 4u);
  for (Vertex_transfer method : projections) {
    Vertex_values<CDT> values;
    const auto r = transfer(s, at_s, t, values, P::source_faces(removed).target_faces(added).transfer_method(method)
                                                  .vertex_is_constrained_map(CGAL::make_boolean_property_map(rim)));
    EXPECT_EQ(values.size(), rim.size() + 2);
    for (CDT::Vertex_handle v : rim)
      EXPECT_EQ(values[v], before.at(v->point()));
    EXPECT_NEAR(r.overlap_area, r.source_area, 1e-13 * r.source_area);
    if (method == Vertex_transfer::PROJECTION) { // two vertices within bounds may not make up what the rest lost
      EXPECT_NEAR(r.target_integral, r.source_integral, 1e-14 * r.source_area);
    }
  }
}

TEST(Transfer, any_triangulations)
{
  using Exact = CGAL::Delaunay_triangulation_2<CGAL::Exact_predicates_exact_constructions_kernel>;
  const std::vector<Point> p = random_points(200, 0);
  Exact s;
  for (const Point& x : p)
    s.insert(Exact::Point(x.x(), x.y()));
  const CDT t = mesh({domains::square(0, 0, 1)}, 0.1);
  Vertex_values<Exact> at_s;
  for (auto v : s.finite_vertex_handles())
    at_s[v] = linear(Point(CGAL::to_double(v->point().x()), CGAL::to_double(v->point().y())));
  Vertex_values<CDT> values;
  for (Vertex_transfer method : vertex_methods) {
    CGAL::transfer_vertex_values_2(s, boost::make_assoc_property_map(at_s), t, boost::make_assoc_property_map(values),
                                   P::transfer_method(method));
    expect_values<CDT>(values, at_vertices(t, linear), 1e-13);
  }
}

TEST(Transfer, refuses_bad_input)
{
  const CDT s = mesh({domains::square(0, 0, 1)}, 0.2);
  CDT line;
  line.insert(Point(0, 0));
  line.insert(Point(1, 0));
  Vertex_values<CDT> at_s = at_vertices(s, linear), result;
  Face_values<CDT> in_s = in_faces(s, linear), in_result;
  const std::vector<CDT::Face_handle> none, infinite{s.infinite_face()}, empty{CDT::Face_handle()};
  expect_invalid([&] { transfer(line, {}, s, result, P::default_values()); }, {"source", "dimension 1"});
  expect_invalid([&] { transfer(s, at_s, line, result, P::default_values()); }, {"target", "dimension 1"});
  expect_invalid([&] { transfer(s, at_s, s, result, P::source_faces(none)); }, {"source", "no face"});
  expect_invalid([&] { transfer(s, in_s, s, in_result, P::target_faces(infinite)); }, {"target", "infinite face"});
  expect_invalid([&] { transfer(s, in_s, s, in_result, P::target_faces(empty)); }, {"target", "empty handle"});
  for (double bad : {std::nan(""), double(INFINITY)}) {
    for (auto& v : at_s)
      if (v.first->point() == Point(1, 0))
        v.second = bad;
    expect_invalid([&] { transfer(s, at_s, s, result, P::default_values()); }, {"source_values", "(1, 0)", "finite"});
    in_s.begin()->second = bad;
    expect_invalid([&] { transfer(s, in_s, s, in_result, P::default_values()); }, {"source_values", "finite"});
  }
  EXPECT_TRUE(result.empty());
  EXPECT_TRUE(in_result.empty());
}

} // namespace test_transfer
