// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef BUBBLE_RELAXATION_2_DEMO_LOOSE_ENDS_H
#define BUBBLE_RELAXATION_2_DEMO_LOOSE_ENDS_H

#include "bad_triangles.h"
#include "files/domain.h"

#include <algorithm>
#include <string>
#include <vector>

/// Ends of segments where no other segment begins, outside of the mesh. Inside they are cracks; outside, the
/// outline that they belong to was perhaps meant to be closed, and bounds nothing as it is.
inline std::vector<Point> loose_ends(const CDT& meshed)
{
  std::vector<Point> ends;
  for (CDT::Vertex_handle v : meshed.finite_vertex_handles()) {
    int segments = 0;
    bool is_in_domain = false;
    CDT::Face_circulator f = meshed.incident_faces(v), begin = f;
    do {
      segments += f->is_constrained(CDT::ccw(f->index(v))); // each edge from one of its sides
      is_in_domain = is_in_domain || f->is_in_domain();
    } while (++f != begin);
    if (segments == 1 && !is_in_domain)
      ends.push_back(v->point());
  }
  std::sort(ends.begin(), ends.end());
  return ends;
}

/// what to say about them
inline std::string loose_ends_message(const std::vector<Point>& ends)
{
  return std::to_string(ends.size()) + (ends.size() == 1 ? " segment ends" : " segments end") +
         " loosely outside of the mesh, such as at " + in_words(ends.front()) + ": is an outline not closed?";
}

#endif // BUBBLE_RELAXATION_2_DEMO_LOOSE_ENDS_H
