// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef BUBBLE_RELAXATION_2_BENCHMARK_OUTLINE_JUDGEMENT_H
#define BUBBLE_RELAXATION_2_BENCHMARK_OUTLINE_JUDGEMENT_H

#include "../../demo/Bubble_relaxation_2/paper_domains.h"

#include <CGAL/radius_ratio_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <vector>

/// What a mesh of a rough outline is judged by. A triangle is free if it has no vertex at a corner of the outline of
/// less than 60 degrees: there the outline decides.
struct Outline_judgement
{
  std::size_t triangles = 0, obtuse = 0, under_26 = 0; ///< under_26: free ones with an angle below 26 degrees
  double mean_q = 0, free_q = 1, free_angle = 60;      ///< smallest q and angle of free triangles
};

/// the angle at `p` in degrees
inline double angle_at(const paper::Point& p, const paper::Point& q, const paper::Point& r)
{
  const paper::K::Vector_2 u = q - p, v = r - p;
  return std::atan2(std::abs(u.x() * v.y() - u.y() * v.x()), u * v) * 180 / paper::pi;
}

/// where two segments of an outline meet in less than 60 degrees
inline std::set<paper::Point> sharp_corners(const paper::CDT& outline)
{
  std::map<paper::Point, std::vector<paper::Point>> neighbors;
  for (const paper::CDT::Edge& e : outline.constrained_edges()) {
    const paper::Point &p = e.first->vertex(outline.cw(e.second))->point(),
                       &q = e.first->vertex(outline.ccw(e.second))->point();
    neighbors[p].push_back(q);
    neighbors[q].push_back(p);
  }
  std::set<paper::Point> result;
  for (const auto& v : neighbors)
    for (std::size_t i = 0; i < v.second.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (angle_at(v.first, v.second[i], v.second[j]) < 60)
          result.insert(v.first);
  return result;
}

/// \param sharp the sharp corners of the outline that was meshed
inline Outline_judgement judge(const paper::CDT& mesh, const std::set<paper::Point>& sharp)
{
  Outline_judgement result;
  for (paper::CDT::Face_handle f : mesh.finite_face_handles()) {
    if (!f->is_in_domain())
      continue;
    const paper::Point &p = f->vertex(0)->point(), &q = f->vertex(1)->point(), &r = f->vertex(2)->point();
    const auto angles = std::minmax({angle_at(p, q, r), angle_at(q, r, p), angle_at(r, p, q)});
    const double quality = CGAL::radius_ratio_2(p, q, r);
    ++result.triangles;
    result.mean_q += quality;
    result.obtuse += angles.second > 90;
    if (sharp.count(p) + sharp.count(q) + sharp.count(r) > 0)
      continue;
    result.under_26 += angles.first < 26;
    result.free_q = (std::min)(result.free_q, quality);
    result.free_angle = (std::min)(result.free_angle, angles.first);
  }
  result.mean_q /= double(result.triangles);
  return result;
}

#endif // BUBBLE_RELAXATION_2_BENCHMARK_OUTLINE_JUDGEMENT_H
