// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef BUBBLE_RELAXATION_2_TEST_SAME_BITS_MESHES_H
#define BUBBLE_RELAXATION_2_TEST_SAME_BITS_MESHES_H

#include "outlines.h"

#include <CGAL/Gradation_limited_sizing_field_2.h>
#include <CGAL/Interpolated_sizing_field_2.h>
#include <CGAL/npbs_adapt.h>
#include <CGAL/npbs_relax.h>
#include <CGAL/property_map.h>
#include <CGAL/simplify_outline_2.h>
#include <CGAL/transfer_2.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

/// Meshes of all kinds, one of each stage and rule, and a hash of what each came out as. Domains and sizes are made
/// without the mathematical functions of a library: they are the same on every machine.
namespace same_bits {

using Vertex_handle = CDT::Vertex_handle;
using Report = CGAL::Bubble_relaxation_report_2<double>;
using Values = std::map<Vertex_handle, double>;
namespace P = CGAL::Bubble_relaxation_parameters;

/// a hash of numbers, in their order
class Hash
{
public:
  void add(std::uint64_t n)
  {
    m_value = (m_value ^ n) * 0x9E3779B97F4A7C15u;
    m_value ^= m_value >> 29;
  }

  void add(double x)
  {
    std::uint64_t bits;
    std::memcpy(&bits, &x, sizeof bits);
    add(bits);
  }

  void add(const Point& p)
  {
    add(p.x());
    add(p.y());
  }

  std::uint64_t value() const { return m_value; }

private:
  std::uint64_t m_value = 0;
};

/// vertices, and triangles of the domain, in an order that does not depend on how they are stored
inline void add_mesh(Hash& hash, const CDT& cdt)
{
  std::vector<Point> points;
  for (const Vertex_handle v : cdt.finite_vertex_handles())
    points.push_back(v->point());
  std::sort(points.begin(), points.end());
  std::vector<std::array<Point, 3>> triangles;
  for (const auto f : cdt.finite_face_handles())
    if (f->is_in_domain()) {
      triangles.push_back({f->vertex(0)->point(), f->vertex(1)->point(), f->vertex(2)->point()});
      std::sort(triangles.back().begin(), triangles.back().end());
    }
  std::sort(triangles.begin(), triangles.end());
  for (const Point& p : points)
    hash.add(p);
  for (const auto& t : triangles)
    for (const Point& p : t)
      hash.add(p);
}

inline void add_report(Hash& hash, const Report& report)
{
  const auto& q = report.quality;
  for (std::size_t n : {report.number_of_vertices, report.number_of_triangles, report.number_of_wanted_vertices,
                        report.number_of_steps, report.number_of_moves, report.number_of_insertions,
                        report.number_of_deletions, report.number_of_small_angles, q.number_of_obtuse_triangles()})
    hash.add(static_cast<std::uint64_t>(n));
  for (double x : {q.minimum_quality(), q.mean_quality(), q.worst_x(), q.worst_y(), q.minimum_angle(),
                   q.maximum_angle(), q.mean_length_ratio(), q.length_ratio_deviation(), q.quality_percentile(10),
                   report.largest_size_gradient})
    hash.add(x);
}

template <class NamedParameters>
void mesh(Hash& hash, CDT& cdt, const NamedParameters& np)
{
  const Report report = CGAL::npbs_relax(cdt, np);
  add_mesh(hash, cdt);
  add_report(hash, report);
}

inline void mesh(Hash& hash, CDT& cdt, const Size& size) { mesh(hash, cdt, P::sizing_function(size)); }

inline void mesh_domain(Hash& hash, const std::vector<Outline>& outlines, const Size& size)
{
  CDT cdt = triangulate(outlines);
  mesh(hash, cdt, size);
}

/// the integrator, the placement and the control of the population that are not the default
inline void mesh_as_in_paper(Hash& hash)
{
  CDT cdt = triangulate(square_with_hole(16));
  mesh(hash, cdt,
       P::npbs_paper_parameters().sizing_function(Size([](const Point& p) { return distance(p, 0, 0) / 8; })));
}

/// at the sizes of the outline, then refined from what is there
inline void refine(Hash& hash)
{
  CDT cdt = triangulate({l_shape(), {{0.1, 0.7}, {0.2, 0.72}, {0.15, 0.8}}});
  mesh(hash, cdt, P::number_of_rounds(10));
  mesh(hash, cdt, Size([](const Point& p) { return 0.02 + 0.1 * distance(p, 0.4, 0.6); }));
  mesh(hash, cdt,
       P::sizing_function(Size([](const Point& p) { return 0.018 + 0.1 * distance(p, 0.4, 0.6); }))
         .initial_placement(CGAL::Bubble_placement::KEEP));
}

/// with islands, needles, an inner constraint, and pins
inline void mesh_lake(Hash& hash, double minimum_angle, double size_growth)
{
  CDT cdt = triangulate(lake());
  const std::vector<Point> pier{{-0.2, -0.1}, {0.3, 0.05}, {0.31, 0.25}};
  cdt.insert_constraint(pier.begin(), pier.end(), false);
  std::set<Vertex_handle> pins;
  for (const Point& p : {Point(0.55, 0.1), Point(0.56, 0.1), Point(-0.4, 0.5)})
    pins.insert(cdt.insert(p));
  mesh(hash, cdt,
       P::sizing_function(Size([](const Point& p) { return 0.04 + 0.1 * distance(p, 0.2, 0.1); }))
         .minimum_angle(minimum_angle)
         .size_growth(size_growth)
         .vertex_is_constrained_map(CGAL::Boolean_property_map<std::set<Vertex_handle>>(pins)));
}

inline void simplify(Hash& hash)
{
  constexpr double d = 0.12;
  CDT cdt = triangulate(lake());
  const auto report =
    CGAL::simplify_outline_2(cdt, P::sizing_function(d).minimum_island_area(d * d / 2).minimum_gap(d));
  hash.add(report.hausdorff_distance);
  hash.add(report.forced_vertices);
  mesh(hash, cdt, Size([](const Point&) { return d; }));
}

/// a fine place that goes on
inline void adapt(Hash& hash)
{
  CDT cdt = triangulate(square_with_hole(16));
  const auto size_near = [](double x) {
    return Size([x](const Point& p) { return 0.03 + 0.15 * distance(p, x, 0.6); });
  };
  mesh(hash, cdt, size_near(-0.5));
  for (double x : {-0.4, -0.3}) {
    const Report report = CGAL::npbs_adapt(cdt, P::sizing_function(size_near(x)));
    add_mesh(hash, cdt);
    add_report(hash, report);
  }
}

/// sizes at the vertices of a mesh, as from indicators of errors, and fields with limited growth
inline void mesh_with_fields(Hash& hash)
{
  CDT coarse = triangulate(square_with_hole(16));
  mesh(hash, coarse, Size([](const Point&) { return 0.2; }));
  Values sizes;
  for (const Vertex_handle v : coarse.finite_vertex_handles())
    sizes[v] = 0.02 + 0.3 * std::abs(v->point().x() * v->point().y());
  const CGAL::Interpolated_sizing_field_2<CDT> field(coarse, boost::make_assoc_property_map(sizes), 0.25);
  mesh_domain(hash, square_with_hole(16), field);
  const CDT domain = triangulate({l_shape()});
  const CGAL::Gradation_limited_sizing_field_2<CDT> limited(
    domain, 0.2, P::sizing_function(Size([](const Point& p) { return p.x() < 0.2 ? 0.03 : 0.2; })));
  mesh_domain(hash, {l_shape()}, limited);
}

/// values at vertices, carried over to another mesh
inline void transfer(Hash& hash)
{
  CDT source = triangulate(square_with_hole(16)), target = source;
  mesh(hash, source, Size([](const Point&) { return 0.15; }));
  mesh(hash, target, Size([](const Point&) { return 0.11; }));
  Values values;
  for (const Vertex_handle v : source.finite_vertex_handles())
    values[v] = distance(v->point(), 0.6, 0.5) < 0.4 ? 1 : 0;
  for (const auto method : {CGAL::Vertex_transfer::PROJECTION, CGAL::Vertex_transfer::MONOTONE_PROJECTION}) {
    Values carried;
    const auto report = CGAL::transfer_vertex_values_2(source, boost::make_assoc_property_map(values), target,
                                                       boost::make_assoc_property_map(carried),
                                                       P::transfer_method(method));
    hash.add(report.target_integral);
    std::map<Point, double> by_place;
    for (const auto& v : carried)
      by_place[v.first->point()] = v.second;
    for (const auto& v : by_place)
      hash.add(v.second);
  }
}

struct Case
{
  std::string name;
  std::uint64_t hash; ///< what it is to be
  std::function<void(Hash&)> make;

  std::uint64_t operator()() const
  {
    Hash h;
    make(h);
    return h.value();
  }
};

inline std::vector<Case> cases()
{
  const auto at = [](double least, double growth, double x, double y, double largest) {
    return Size([=](const Point& p) { return (std::min)(least + growth * distance(p, x, y), largest); });
  };
  const auto domain = [](const std::vector<Outline>& outlines, const Size& size) {
    return [=](Hash& hash) { mesh_domain(hash, outlines, size); };
  };
  return {
    {"square with hole", 0x8805af328f82a333, domain(square_with_hole(32), at(0, 0.1, 0, 0, 1))},
    {"graded circle", 0xa454acb9a7ec6374, domain({circle(0.6, 64)}, [](const Point& p) {
       return 0.06 * std::abs(distance(p, 0, 0) - 0.3) / 0.3 + 0.02;
     })},
    {"L", 0x2319931a6b413c72, domain({l_shape()}, at(0.01, 0.16, 0.4, 0.6, 0.08))},
    {"comb", 0x5710be32f664e27f, domain({comb()}, [](const Point& p) {
       return p.x() > 0.7 ? 0.015 : (std::min)((0.7 - p.x()) / 5 + 0.015, 0.05);
     })},
    {"ring", 0xed6f9d30e0f47afb, domain({circle(1, 64), circle(1. / 64, 64)}, at(0, 1. / 8, 0, 0, 1))},
    {"paper's parameters", 0x74c19c8719ff02f3, mesh_as_in_paper},
    {"needle", 0x4cc4012ac0a02fe4, domain({{{0, 0}, {2, 0.1}, {1.2, 0.3}, {2, 0.6}}}, at(0.04, 0, 0, 0, 1))},
    {"refined", 0x1f85e6669561973b, refine},
    {"lake", 0x9d89f39381cf7fd7, [](Hash& hash) { mesh_lake(hash, 20, 0.2); }},
    {"lake with steep sizes", 0x9db861e3b93a5a02, [](Hash& hash) { mesh_lake(hash, 33, 1); }},
    {"simplified lake", 0xfb2d7d5098e72239, simplify},
    {"adapted", 0x1050bef5eda1d13d, adapt},
    {"fields", 0xe3e9f80ea4967035, mesh_with_fields},
    {"transfer", 0x90caa4f65ad4e12d, transfer},
  };
}

} // namespace same_bits

#endif // BUBBLE_RELAXATION_2_TEST_SAME_BITS_MESHES_H
