// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef BUBBLE_RELAXATION_2_TEST_VALIDATION_H
#define BUBBLE_RELAXATION_2_TEST_VALIDATION_H

#include <CGAL/Bubble_relaxation_enums.h>
#include <CGAL/Mesh_quality_2.h>
#include <CGAL/radius_ratio_2.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

/// Oracles: is the result valid, does it contain what it must, is nothing where it must not be.
namespace validation {

using Xy = std::pair<double, double>;
using Segment = std::pair<Xy, Xy>;

/// a lazy number that nobody has evaluated rounds otherwise
template <class Number>
auto rounded(const Number& x, int) -> decltype(x.exact(), 0.)
{
  return CGAL::to_double(x.exact());
}

template <class Number>
double rounded(const Number& x, long)
{
  return CGAL::to_double(x);
}

template <class Vertex_handle>
Xy xy(Vertex_handle v)
{
  return {rounded(v->point().x(), 0), rounded(v->point().y(), 0)};
}

/// the corners and constraints of a triangulation, to compare with later
struct Snapshot
{
  std::set<Xy> vertices;
  std::vector<Segment> constraints;
};

template <class CDT>
Snapshot snapshot(const CDT& cdt)
{
  Snapshot s;
  for (auto v : cdt.finite_vertex_handles())
    s.vertices.insert(xy(v));
  for (const auto& e : cdt.finite_edges())
    if (cdt.is_constrained(e))
      s.constraints.push_back({(std::min)(xy(e.first->vertex(cdt.ccw(e.second))),
                                          xy(e.first->vertex(cdt.cw(e.second)))),
                               (std::max)(xy(e.first->vertex(cdt.ccw(e.second))),
                                          xy(e.first->vertex(cdt.cw(e.second))))});
  std::sort(s.constraints.begin(), s.constraints.end());
  return s;
}

inline bool operator==(const Snapshot& a, const Snapshot& b)
{
  return a.vertices == b.vertices && a.constraints == b.constraints;
}

inline double length(const Segment& s)
{
  return std::hypot(s.second.first - s.first.first, s.second.second - s.first.second);
}

/// distance of a point from a segment's line, and whether it lies beside the segment
inline double off(const Segment& s, const Xy& p)
{
  const double dx = s.second.first - s.first.first, dy = s.second.second - s.first.second;
  return std::abs(dx * (p.second - s.first.second) - dy * (p.first - s.first.first)) / length(s);
}

inline double along(const Segment& s, const Xy& p)
{
  const double dx = s.second.first - s.first.first, dy = s.second.second - s.first.second;
  return (dx * (p.first - s.first.first) + dy * (p.second - s.first.second)) / length(s);
}

/// every constraint of `before` is a union of constraints of `after`, up to rounding
inline void expect_constraints_kept(const Snapshot& before, const Snapshot& after)
{
  double largest = 0;
  for (const Xy& p : before.vertices)
    largest = (std::max)({largest, std::abs(p.first), std::abs(p.second)});
  const double rounding = 32 * std::numeric_limits<double>::epsilon() * largest;
  for (const Segment& s : before.constraints) {
    double covered = 0;
    for (const Segment& t : after.constraints) {
      // vertices that only split constraints may be others, so either may be the longer one
      const bool s_is_longer = length(s) >= length(t);
      const Segment &line = s_is_longer ? s : t, &piece = s_is_longer ? t : s;
      if (off(line, piece.first) <= rounding && off(line, piece.second) <= rounding) {
        const auto ends = std::minmax({along(line, piece.first), along(line, piece.second)});
        covered += (std::max)(0., (std::min)(ends.second, length(line)) - (std::max)(ends.first, 0.));
      }
    }
    EXPECT_NEAR(covered, length(s), 1e-9 * length(s) + 64 * rounding)
      << "constraint from (" << s.first.first << ", " << s.first.second << ") to ("
      << s.second.first << ", " << s.second.second << ")";
  }
}

inline void expect_vertices_kept(const std::set<Xy>& vertices, const Snapshot& after)
{
  for (const Xy& p : vertices)
    EXPECT_EQ(after.vertices.count(p), 1u) << "vertex (" << p.first << ", " << p.second << ")";
}

/// The vertices that no relaxation may move: ends and bends of constraints, and those that the user pinned. A bend is
/// more than what the rounding of its vertices makes.
template <class CDT>
std::set<Xy> fixed_vertices(const CDT& cdt, const std::set<typename CDT::Vertex_handle>& pins)
{
  double largest = 0;
  for (auto v : cdt.finite_vertex_handles())
    largest = (std::max)({largest, std::abs(xy(v).first), std::abs(xy(v).second)});
  std::set<Xy> result;
  for (typename CDT::Vertex_handle v : cdt.finite_vertex_handles()) {
    std::vector<Xy> ends;
    if (cdt.are_there_incident_constraints(v)) {
      auto e = cdt.incident_edges(v), start = e;
      do {
        const auto a = e->first->vertex(cdt.ccw(e->second)), b = e->first->vertex(cdt.cw(e->second));
        if (cdt.is_constrained(*e))
          ends.push_back(xy(a == v ? b : a));
      } while (++e != start);
    }
    const double rounding = 64 * std::numeric_limits<double>::epsilon() * largest;
    const bool is_straight = ends.size() == 2 && off({ends[0], ends[1]}, xy(v)) <= rounding &&
                             along({ends[0], xy(v)}, ends[1]) >= length({ends[0], xy(v)});
    if (pins.count(v) > 0 || (!ends.empty() && !is_straight))
      result.insert(xy(v));
  }
  return result;
}

/// the triangles of the domain, by their corners
using Triangle = std::array<Xy, 3>;

template <class CDT>
std::vector<Triangle> triangles(const CDT& cdt)
{
  std::vector<Triangle> result;
  for (auto f : cdt.finite_face_handles())
    if (f->is_in_domain()) {
      result.push_back({xy(f->vertex(0)), xy(f->vertex(1)), xy(f->vertex(2))});
      std::sort(result.back().begin(), result.back().end());
    }
  std::sort(result.begin(), result.end());
  return result;
}

/// every face and vertex of a triangulation with all that it knows, by handles
template <class Cdt>
struct Content
{
  struct Face
  {
    std::vector<typename Cdt::Vertex_handle> vertices;
    std::vector<typename Cdt::Face_handle> neighbors;
    std::vector<bool> flags;

    bool operator==(const Face& f) const
    {
      return vertices == f.vertices && neighbors == f.neighbors && flags == f.flags;
    }
  };

  std::map<typename Cdt::Face_handle, Face> faces;
  std::map<typename Cdt::Vertex_handle, typename Cdt::Point> vertices;
  std::map<typename Cdt::Vertex_handle, typename Cdt::Face_handle> faces_of_vertices;
  std::size_t number_of_vertices, number_of_faces;

  explicit Content(const Cdt& cdt)
    : number_of_vertices(cdt.number_of_vertices()), number_of_faces(cdt.number_of_faces())
  {
    for (auto f : cdt.all_face_handles()) {
      Face& c = faces[f];
      for (int i = 0; i < 3; ++i) {
        c.vertices.push_back(f->vertex(i));
        c.neighbors.push_back(f->neighbor(i));
        c.flags.push_back(f->is_constrained(i));
      }
      c.flags.push_back(f->is_in_domain());
    }
    for (auto v : cdt.finite_vertex_handles()) {
      vertices[v] = v->point();
      faces_of_vertices[v] = v->face();
    }
  }

  bool operator==(const Content& c) const
  {
    return faces == c.faces && vertices == c.vertices && faces_of_vertices == c.faces_of_vertices &&
           number_of_vertices == c.number_of_vertices && number_of_faces == c.number_of_faces;
  }
};

/// the area of the faces that are in the domain
template <class CDT>
double domain_area(const CDT& cdt)
{
  double sum = 0;
  for (auto f : cdt.finite_face_handles())
    if (f->is_in_domain()) {
      const Xy p = xy(f->vertex(0)), q = xy(f->vertex(1)), r = xy(f->vertex(2));
      sum += 0.5 * ((q.first - p.first) * (r.second - p.second) -
                    (q.second - p.second) * (r.first - p.first));
    }
  return sum;
}

/// valid, Delaunay, bounded by constraints; and every vertex that is no end of a constraint lies in the
/// domain, but for those that were outside of it before: pass these as `outside`
template <class CDT>
void expect_valid_mesh(const CDT& cdt, const std::set<Xy>& outside = {})
{
  EXPECT_TRUE(cdt.is_valid());
  std::set<typename CDT::Vertex_handle> in_domain;
  for (auto f : cdt.all_face_handles()) {
    if (cdt.is_infinite(f)) {
      EXPECT_FALSE(f->is_in_domain());
      continue;
    }
    for (int i = 0; i < 3; ++i) {
      if (!f->is_constrained(i)) {
        EXPECT_EQ(f->is_in_domain(), f->neighbor(i)->is_in_domain());
      }
      if (f->is_in_domain())
        in_domain.insert(f->vertex(i));
    }
  }
  for (auto v : cdt.finite_vertex_handles())
    if (!cdt.are_there_incident_constraints(v) && outside.count(xy(v)) == 0) {
      EXPECT_EQ(in_domain.count(v), 1u) << "vertex (" << xy(v).first << ", " << xy(v).second << ")";
    }
}

/// a valid mesh that has all vertices and constraints which there were before
template <class CDT>
void expect_mesh_of(const Snapshot& before, const CDT& cdt, const std::set<Xy>& outside = {})
{
  const Snapshot after = snapshot(cdt);
  expect_valid_mesh(cdt, outside);
  expect_vertices_kept(before.vertices, after);
  expect_constraints_kept(before, after);
}

/// No vertex of the domain is nearer to another than `least` times the mean of d at both, but two of
/// `fixed`, whose distance is the user's. Only edges are looked at: in a Delaunay triangulation each
/// vertex is joined to its nearest one.
template <class CDT, class Sizing>
void expect_no_vertices_nearer(const CDT& cdt, const Sizing& d, double least,
                               const std::set<Xy>& fixed)
{
  for (const auto& e : cdt.finite_edges()) {
    const auto u = e.first->vertex(cdt.ccw(e.second)), v = e.first->vertex(cdt.cw(e.second));
    if (!e.first->is_in_domain() && !e.first->neighbor(e.second)->is_in_domain())
      continue;
    if (fixed.count(xy(u)) > 0 && fixed.count(xy(v)) > 0)
      continue;
    EXPECT_GE(length({xy(u), xy(v)}), 0.5 * least * (d(u->point()) + d(v->point())))
      << "from (" << xy(u).first << ", " << xy(u).second << ") to (" << xy(v).first << ", "
      << xy(v).second << ")";
  }
}

/// The report tells of the mesh that is there, counted anew, and its numbers go together.
template <class CDT, class Report>
void expect_report_adds_up(const CDT& cdt, const Report& report, std::size_t evaluations_per_step = 1)
{
  std::set<typename CDT::Vertex_handle> vertices, on_border;
  std::size_t number_of_triangles = 0;
  double sum = 0, least = 1;
  for (auto f : cdt.finite_face_handles())
    if (f->is_in_domain()) {
      ++number_of_triangles;
      const double q =
        CGAL::to_double(CGAL::radius_ratio_2(f->vertex(0)->point(), f->vertex(1)->point(), f->vertex(2)->point()));
      sum += q;
      least = (std::min)(least, q);
      for (int i = 0; i < 3; ++i) {
        vertices.insert(f->vertex(i));
        if (f->is_constrained(i)) {
          on_border.insert(f->vertex(cdt.ccw(i)));
          on_border.insert(f->vertex(cdt.cw(i)));
        }
      }
    }
  const auto& q = report.quality;
  EXPECT_EQ(report.number_of_vertices, vertices.size());
  EXPECT_EQ(report.number_of_triangles, number_of_triangles);
  EXPECT_EQ(q.number_of_vertices(), vertices.size());
  EXPECT_EQ(q.number_of_triangles(), number_of_triangles);
  EXPECT_LE(q.number_of_interior_vertices(), vertices.size() - on_border.size());
  EXPECT_NEAR(q.mean_quality(), sum / double(number_of_triangles), 1e-9);
  EXPECT_NEAR(q.minimum_quality(), least, 1e-9);
  std::size_t bars = 0;
  for (std::size_t bar : q.histogram())
    bars += bar;
  EXPECT_EQ(bars, number_of_triangles);
  // those in one place with another are removed, and not counted
  EXPECT_LE(report.number_of_vertices + report.number_of_deletions,
            report.number_of_initial_bubbles + report.number_of_insertions);
  EXPECT_EQ(report.number_of_force_evaluations, evaluations_per_step * report.number_of_steps);
  EXPECT_LE(report.number_of_moves,
            report.number_of_steps * (report.number_of_initial_bubbles + report.number_of_insertions));
  EXPECT_LE(report.number_of_returns, report.number_of_moves);
  EXPECT_EQ(report.number_of_renewals > 0, report.number_of_rounds > 0);
  EXPECT_EQ(report.converged, report.stop_reason == CGAL::Bubble_stop_reason::CONVERGED);
}

/// all that is told of the quality of a mesh, to compare
template <class FT>
std::vector<double> all_numbers(const CGAL::Mesh_quality_2<FT>& q)
{
  std::vector<double> numbers{double(q.number_of_vertices()), double(q.number_of_triangles()),
                              q.minimum_quality(), q.mean_quality(), q.worst_x(), q.worst_y(),
                              q.minimum_angle(), q.maximum_angle(), q.shortest_edge(), q.longest_edge(),
                              double(q.number_of_interior_vertices()), q.irregular_share(),
                              q.mean_length_ratio(), q.length_ratio_deviation(),
                              q.length_ratio_percentile(1), q.length_ratio_percentile(99)};
  for (int percent : {1, 5, 10, 25, 50, 75, 90})
    numbers.push_back(q.quality_percentile(percent));
  for (std::size_t bar : q.histogram())
    numbers.push_back(double(bar));
  return numbers;
}

} // namespace validation

#endif // BUBBLE_RELAXATION_2_TEST_VALIDATION_H
