// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef BUBBLE_RELAXATION_2_DEMO_SIMPLIFY_DOMAIN_H
#define BUBBLE_RELAXATION_2_DEMO_SIMPLIFY_DOMAIN_H

#include "domain.h"
#include "file_names.h"

#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_marks_2.h>
#include <CGAL/Unique_hash_map.h>
#include <CGAL/property_map.h>
#include <CGAL/simplify_outline_2.h>

#include <algorithm>
#include <cstddef>
#include <ostream>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

/// the square of the least height of a triangle
inline double squared_height(const CDT& cdt, CDT::Face_handle f)
{
  const Kernel::Triangle_2 t = cdt.triangle(f);
  double longest = 0;
  for (int i = 0; i < 3; ++i)
    longest = (std::max)(longest, CGAL::squared_distance(t[i], t[i + 1]));
  return 4 * t.area() * t.area() / longest;
}

/// Moves the points that tell regions to where regions are wide: near a segment that is replaced they would come to lie
/// on the other side.
inline void move_regions_inwards(Domain& domain)
{
  constexpr std::size_t none = 0;
  CGAL::Unique_hash_map<CDT::Face_handle, std::size_t> number(none); // of what a face is in, from one
  std::vector<Point> middles;
  for (Region& region : domain.regions) {
    const CDT::Face_handle f = domain.cdt.locate(region.point);
    if (number[f] == none) {
      middles.push_back(region.point);
      double widest = 0;
      flood(f, [&](CDT::Face_handle g) {
        if (std::exchange(number[g], middles.size()) != none)
          return false;
        const double width = domain.cdt.is_infinite(g) ? 0 : squared_height(domain.cdt, g);
        if (width > widest) {
          widest = width;
          middles.back() = CGAL::centroid(domain.cdt.triangle(g));
        }
        return true;
      });
    }
    region.point = middles[number[f] - 1];
  }
}

/// Replaces the outline by one within a tolerance; its segments have the markers of those that they stand for.
/// \param parameters sizes, tolerance and rules
template <class Parameters>
CGAL::Outline_simplification_report_2 simplify_domain(Domain& domain, const Parameters& parameters)
{
  using Pinned = CGAL::Boolean_property_map<const std::set<CDT::Vertex_handle>>;
  move_regions_inwards(domain);
  return CGAL::simplify_outline_2(
    domain.cdt,
    parameters.vertex_is_constrained_map(Pinned(domain.pinned)).edge_marker_map(Segment_marker_map{&domain}));
}

/// A part of a domain that no side of a triangle joins to another.
struct Connected_part
{
  double area;
  CDT::Face_handle face; ///< of it

  Point place() const ///< in it
  {
    return CGAL::centroid(face->vertex(0)->point(), face->vertex(1)->point(), face->vertex(2)->point());
  }
};

/// across sides with domain on both
inline bool goes_on(CDT::Face_handle f, int i) { return f->neighbor(i)->is_in_domain(); }

/// the parts, the largest first
inline std::vector<Connected_part> connected_parts(const CDT& cdt)
{
  std::vector<Connected_part> parts;
  CGAL::Unique_hash_map<CDT::Face_handle, bool> is_known(false);
  for (CDT::Face_handle first : cdt.finite_face_handles()) {
    if (!first->is_in_domain() || is_known[first])
      continue;
    parts.push_back(Connected_part{0, first});
    flood(first, goes_on, [&](CDT::Face_handle f) {
      if (std::exchange(is_known[f], true))
        return false;
      parts.back().area += cdt.triangle(f).area();
      return true;
    });
  }
  std::sort(parts.begin(), parts.end(), [](const Connected_part& p, const Connected_part& q) {
    return p.area != q.area ? p.area > q.area : p.place() < q.place();
  });
  return parts;
}

/// what to say if a domain whose narrows were filled has several parts
inline std::string parts_message(const std::vector<Connected_part>& parts)
{
  std::ostringstream text;
  text << "with narrows filled the domain has " << parts.size() << " parts that are not connected;";
  constexpr std::size_t most_places = 4;
  for (std::size_t k = 1; k < parts.size() && k < most_places; ++k)
    text << (k > 1 ? "," : "") << " one with the area " << parts[k].area << " is at " << to_string(parts[k].place());
  if (parts.size() > most_places)
    text << ", " << parts.size() - most_places << " are smaller";
  text << "; --largest-part leaves them out";
  return text.str();
}

/// Takes all but the largest part out of a domain. \throws std::invalid_argument if there is no domain
inline void keep_largest_part(Domain& domain)
{
  const auto faces = domain.cdt.finite_face_handles();
  if (std::none_of(faces.begin(), faces.end(), [](CDT::Face_handle f) { return f->is_in_domain(); })) {
    using Marks = CGAL::Bubble_relaxation_2::internal::Domain_marks_2<CDT>;
    const Marks is_in_domain(domain.cdt, CGAL::parameters::default_values()); // by nesting
    for (CDT::Face_handle f : faces)
      f->set_in_domain(is_in_domain(f));
  }
  const std::vector<Connected_part> parts = connected_parts(domain.cdt);
  if (parts.size() < 2)
    return;
  double left_out = 0;
  for (std::size_t k = 1; k < parts.size(); ++k) {
    left_out += parts[k].area;
    flood(parts[k].face, goes_on, [](CDT::Face_handle f) {
      const bool is_new = f->is_in_domain();
      f->set_in_domain(false);
      return is_new;
    });
  }
  std::ostringstream text;
  text << "--largest-part: of " << parts.size() << " parts that with the area " << parts[0].area << ", at "
       << to_string(parts[0].place()) << ", is meshed; the others have " << left_out;
  domain.warnings.push_back(text.str());
}

/// Writes where the rules took islands and narrows away: a line each, with its area.
/// \throws std::runtime_error with the name and the system's reason
inline void write_simplification(const std::string& name, const CGAL::Outline_simplification_report_2& report)
{
  write_file(name, [&report](std::ostream& out) {
    out.precision(17);
    out << "# what x y area\n";
    for (const auto& island : report.dropped_islands)
      out << "island " << island.place[0] << ' ' << island.place[1] << ' ' << island.area << '\n';
    for (const auto& gap : report.filled_gaps)
      out << "gap " << gap.place[0] << ' ' << gap.place[1] << ' ' << gap.area << '\n';
  });
}

#endif // BUBBLE_RELAXATION_2_DEMO_SIMPLIFY_DOMAIN_H
