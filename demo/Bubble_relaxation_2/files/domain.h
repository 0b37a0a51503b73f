// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef BUBBLE_RELAXATION_2_DEMO_DOMAIN_H
#define BUBBLE_RELAXATION_2_DEMO_DOMAIN_H

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Face_region_map_2.h>
#include <CGAL/Unique_hash_map.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_2;
using CDT = CGAL::Constrained_Delaunay_triangulation_2<
  Kernel,
  CGAL::Triangulation_data_structure_2<CGAL::Triangulation_vertex_base_2<Kernel>,
                                       CGAL::Delaunay_mesh_face_base_2<Kernel>>,
  CGAL::No_constraint_intersection_requiring_constructions_tag>;

/// A point in a region that segments bound, the number that its triangles get, and the area that they may have.
struct Region
{
  Point point;
  double attribute;
  double area = 0; ///< positive if there is one
};

/// A domain as files give it.
struct Domain
{
  CDT cdt; ///< its faces are marked, unless the domain is told by nesting
  std::set<CDT::Vertex_handle> pinned;
  std::map<Point, int> point_markers;                      ///< those that are not 0
  std::map<std::pair<Point, Point>, int> segment_markers; ///< of edges of `cdt`, those that are not 0
  std::vector<Region> regions;
  std::string crs, crs_of_file; ///< the reference systems of coordinates here and in the file, empty if not known
  std::vector<std::string> warnings; ///< what the user should know, without the name of the file
};

inline std::string to_string(const Point& p)
{
  std::ostringstream text;
  text << '(' << p.x() << ", " << p.y() << ')';
  return text.str();
}

inline std::pair<Point, Point> sorted(const Point& p, const Point& q)
{
  return p < q ? std::make_pair(p, q) : std::make_pair(q, p);
}

/// the end of an edge that is not `v`
inline CDT::Vertex_handle other_end(const CDT::Edge& e, CDT::Vertex_handle v)
{
  const CDT::Vertex_handle a = e.first->vertex(CDT::cw(e.second));
  return a == v ? e.first->vertex(CDT::ccw(e.second)) : a;
}

/// A segment crosses another one.
struct Crossing_segments : std::runtime_error
{
  using Ends = std::pair<Point, Point>;

  Ends piece; ///< of the other one, between vertices on it

  Crossing_segments(const Ends& segment, const Ends& other)
    : std::runtime_error("the segment " + text(segment) + " crosses that " + text(other)), piece(other)
  {}

  static std::string text(const Ends& s) { return "from " + to_string(s.first) + " to " + to_string(s.second); }
};

/// The constraint that a segment crosses between its ends; pieces of constraints have no vertices there, so a crossing
/// in a vertex, which is none, is not taken for one.
inline std::pair<Point, Point> crossed_constraint(const CDT& cdt, const Point& p, const Point& q)
{
  for (const CDT::Edge& e : cdt.constrained_edges()) {
    const Point &a = e.first->vertex(CDT::ccw(e.second))->point(), &b = e.first->vertex(CDT::cw(e.second))->point();
    if (CGAL::orientation(p, q, a) * CGAL::orientation(p, q, b) < 0 &&
        CGAL::orientation(a, b, p) * CGAL::orientation(a, b, q) < 0)
      return sorted(a, b);
  }
  throw std::runtime_error("the segment " + Crossing_segments::text({p, q}) + " crosses another");
}

/// Inserts a segment with its marker.
/// \throws Crossing_segments if it crosses another one
inline void insert_segment(Domain& domain, CDT::Vertex_handle u, CDT::Vertex_handle v, int marker = 0)
{
  if (u == v)
    return;
  try {
    domain.cdt.insert_constraint(u, v);
  } catch (const CDT::Intersection_of_constraints_exception&) {
    throw Crossing_segments({u->point(), v->point()}, crossed_constraint(domain.cdt, u->point(), v->point()));
  }
  while (marker != 0 && u != v) { // vertices on the segment cut it
    CDT::Vertex_handle w;
    CDT::Face_handle f;
    int i = 0;
    domain.cdt.includes_edge(u, v, w, f, i);
    domain.segment_markers[sorted(u->point(), w->point())] = marker;
    u = w;
  }
}

/// Calls `visit(f)` for the faces from `f` on, across sides that are open, `is_open(f, i)`, as long as it returns that `f`
/// is new.
template <class Is_open, class Visit>
void flood(CDT::Face_handle f, const Is_open& is_open, const Visit& visit)
{
  std::vector<CDT::Face_handle> stack;
  if (visit(f))
    stack.push_back(f);
  while (!stack.empty()) {
    const CDT::Face_handle g = stack.back();
    stack.pop_back();
    for (int i = 0; i < 3; ++i)
      if (is_open(g, i) && visit(g->neighbor(i)))
        stack.push_back(g->neighbor(i));
  }
}

/// the same across sides that are not constrained
template <class Visit>
void flood(CDT::Face_handle f, const Visit& visit)
{
  flood(f, [](CDT::Face_handle g, int i) { return !g->is_constrained(i); }, visit);
}

/// a place where an outline may have been meant to go on; empty if there is none
inline std::string open_end_in_words(const CDT& cdt)
{
  for (CDT::Vertex_handle v : cdt.finite_vertex_handles()) {
    std::vector<CDT::Edge> constraints;
    cdt.incident_constraints(v, std::back_inserter(constraints));
    if (constraints.size() == 1)
      return "; only one segment ends at " + to_string(v->point());
  }
  return "";
}

/// the face that a point of a hole or a region lies in
/// \throws std::runtime_error if it lies on a segment
inline CDT::Face_handle face_around(const CDT& cdt, const std::string& what, const Point& p)
{
  CDT::Locate_type place;
  int side = 0;
  const CDT::Face_handle f = cdt.locate(p, place, side);
  if ((place == CDT::VERTEX && cdt.are_there_incident_constraints(f->vertex(side))) ||
      (place == CDT::EDGE && f->is_constrained(side)))
    throw std::runtime_error("the " + what + " " + to_string(p) +
                             " lies on a segment and does not tell which side is meant");
  return f;
}

/// warns of points of holes or regions that are none, since they lie outside
inline void warn_of_points_outside(Domain& domain, const std::string& what, const std::string& of_what,
                                   const std::vector<Point>& points)
{
  if (points.size() == 1)
    domain.warnings.push_back("the " + what + " " + to_string(points[0]) + " lies outside of " + of_what +
                              " and is none");
  else if (!points.empty())
    domain.warnings.push_back(std::to_string(points.size()) + " " + what + "s lie outside of " + of_what +
                              " and are none, such as " + to_string(points[0]));
}

/// Marks the faces that are reached neither from outside nor from holes.
inline void mark_all_but_holes(Domain& domain, const std::vector<Point>& holes)
{
  if (domain.cdt.dimension() < 2)
    return;
  CGAL::Unique_hash_map<CDT::Face_handle, bool> is_outside(false), is_hole(false);
  const auto mark_in = [](auto& map) {
    return [&map](CDT::Face_handle f) { return !std::exchange(map[f], true); };
  };
  flood(domain.cdt.infinite_face(), mark_in(is_outside));
  std::vector<Point> useless;
  for (const Point& hole : holes) {
    const CDT::Face_handle f = face_around(domain.cdt, "hole", hole);
    if (is_outside[f])
      useless.push_back(hole);
    flood(f, mark_in(is_hole));
  }
  warn_of_points_outside(domain, "hole", "all outlines", useless);
  bool is_empty = true;
  for (CDT::Face_handle f : domain.cdt.finite_face_handles()) {
    f->set_in_domain(!is_outside[f] && !is_hole[f]);
    is_empty = is_empty && !f->is_in_domain();
  }
  if (is_empty)
    throw std::runtime_error(
      "no face lies in the domain: the segments close no region, or all regions are holes" +
      open_end_in_words(domain.cdt));
}

/// warns of the points of regions that no segment parts from a later one
inline void warn_of_regions_in_one(Domain& domain, const std::vector<std::pair<Point, Point>>& same)
{
  if (!same.empty())
    domain.warnings.push_back(std::to_string(same.size()) +
                              (same.size() == 1 ? " region is none: no segment parts it from a later one"
                                                : " regions are none: no segments part them from later ones") +
                              "; the last counts, such as " + to_string(same[0].second) + " after " +
                              to_string(same[0].first));
}

/// Keeps the regions that have faces of the domain, the last one where no segment parts several, and warns of others.
/// \throws std::runtime_error if the point of one lies on a segment
inline void keep_regions_with_faces(Domain& domain)
{
  if (domain.cdt.dimension() < 2)
    return;
  std::vector<Region> regions;
  std::vector<Point> outside;
  std::vector<std::pair<Point, Point>> same; // one that does not count, and that which does
  constexpr std::size_t none = 0;
  CGAL::Unique_hash_map<CDT::Face_handle, std::size_t> number(none); // of a face's region, from one
  for (auto region = domain.regions.rbegin(); region != domain.regions.rend(); ++region) {
    const CDT::Face_handle f = face_around(domain.cdt, "region", region->point);
    if (!f->is_in_domain()) {
      outside.push_back(region->point);
    } else if (number[f] == none) {
      regions.push_back(*region);
      flood(f, [&](CDT::Face_handle g) { return std::exchange(number[g], regions.size()) == none; });
    } else {
      const Region& other = regions[number[f] - 1];
      if (region->attribute != other.attribute || region->area != other.area)
        same.emplace_back(region->point, other.point);
    }
  }
  domain.regions = std::move(regions);
  warn_of_points_outside(domain, "region", "the domain", outside);
  warn_of_regions_in_one(domain, same);
}

/// the marker of a constrained edge of `domain.cdt`
inline int segment_marker(const Domain& domain, const Point& p, const Point& q)
{
  const auto found = domain.segment_markers.find(sorted(p, q));
  return found == domain.segment_markers.end() ? 0 : found->second;
}

inline int point_marker(const Domain& domain, const Point& p)
{
  const auto found = domain.point_markers.find(p);
  return found == domain.point_markers.end() ? 0 : found->second;
}

/// \throws std::runtime_error if no segment of a domain has one of the markers that an option names
inline void check_markers(const Domain& domain, const std::string& option, std::set<int> markers)
{
  for (const auto& e : domain.cdt.constrained_edges())
    markers.erase(segment_marker(domain, e.first->vertex(CDT::ccw(e.second))->point(),
                                 e.first->vertex(CDT::cw(e.second))->point()));
  if (!markers.empty())
    throw std::runtime_error(option + ": no segment has the marker " + std::to_string(*markers.begin()));
}

/// The markers of a domain's segments as `npbs_relax()` takes them.
struct Segment_marker_map
{
  using key_type = std::pair<CDT::Vertex_handle, CDT::Vertex_handle>;
  using value_type = int;
  using reference = int;
  using category = boost::read_write_property_map_tag;

  Domain* domain;

  static std::pair<Point, Point> ends(const key_type& edge)
  {
    return sorted(edge.first->point(), edge.second->point());
  }

  friend int get(const Segment_marker_map& map, const key_type& edge)
  {
    return segment_marker(*map.domain, edge.first->point(), edge.second->point());
  }

  friend void put(const Segment_marker_map& map, const key_type& edge, int marker)
  {
    if (marker != 0)
      map.domain->segment_markers[ends(edge)] = marker;
  }

  friend void forget(const Segment_marker_map& map, const key_type& edge)
  {
    map.domain->segment_markers.erase(ends(edge));
  }
};

using Region_map = CGAL::Face_region_map_2<CDT, double>;

/// what is given for regions, of their faces, in the domain or not; 0 where nothing is given
inline Region_map region_values(const Domain& domain, double Region::*value)
{
  Region_map values;
  if (domain.cdt.dimension() < 2)
    return values;
  for (const Region& region : domain.regions)
    values.set_all_around(domain.cdt.locate(region.point), region.*value);
  return values;
}

inline Region_map region_attributes(const Domain& domain) { return region_values(domain, &Region::attribute); }

inline bool has_areas(const Domain& domain)
{
  return std::any_of(domain.regions.begin(), domain.regions.end(), [](const Region& r) { return r.area > 0; });
}

/// whether a vertex that only splits a straight line means something: it has a marker that neither its segments nor
/// its neighbours have
inline bool is_meant(const Domain& domain, CDT::Vertex_handle v)
{
  const int marker = point_marker(domain, v->point());
  if (marker == 0)
    return false;
  bool is_known = false;
  CDT::Edge_circulator e = domain.cdt.incident_edges(v), start = e;
  do {
    if (!domain.cdt.is_constrained(*e))
      continue;
    const Point& other = other_end(*e, v)->point();
    is_known = is_known || segment_marker(domain, v->point(), other) == marker || point_marker(domain, other) == marker;
  } while (++e != start);
  return !is_known;
}

/// Pins what the relaxation would take away although it carries a marker of its own.
inline void pin_points_with_markers(Domain& domain)
{
  if (domain.cdt.dimension() < 2 || domain.point_markers.empty())
    return;
  for (CDT::Vertex_handle v : domain.cdt.finite_vertex_handles())
    if (domain.cdt.are_there_incident_constraints(v) && is_meant(domain, v))
      domain.pinned.insert(v);
}

/// Pins points that are no ends of segments.
inline void pin_lonely_points(Domain& domain)
{
  for (CDT::Vertex_handle v : domain.cdt.finite_vertex_handles())
    if (domain.cdt.dimension() < 1 || !domain.cdt.are_there_incident_constraints(v))
      domain.pinned.insert(v);
}

#endif // BUBBLE_RELAXATION_2_DEMO_DOMAIN_H
