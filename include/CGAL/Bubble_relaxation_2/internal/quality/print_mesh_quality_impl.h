// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_QUALITY_PRINT_MESH_QUALITY_IMPL_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_QUALITY_PRINT_MESH_QUALITY_IMPL_H

#include <CGAL/Mesh_quality_2.h>

#include <algorithm>
#include <cstddef>
#include <iomanip>
#include <ostream>
#include <sstream>
#include <string>

namespace CGAL::Bubble_relaxation_2::internal {

inline void print_table(std::ostream& out, const Mesh_quality_2<double>& q)
{
  const auto row = [&](const char* name) -> std::ostream& {
    return out << "  " << std::left << std::setw(36) << name << std::right;
  };
  out << std::fixed;
  row("vertices") << q.number_of_vertices() << '\n';
  row("triangles") << q.number_of_triangles() << '\n';
  out << std::setprecision(4);
  row("radius ratio: mean, smallest") << q.mean_quality() << "  " << q.minimum_quality() << '\n';
  row("  1 %, 10 %, median") << q.quality_percentile(1) << "  " << q.quality_percentile(10) << "  "
                             << q.quality_percentile(50) << '\n';
  out << std::setprecision(2);
  row("angle: smallest, largest") << q.minimum_angle() << "  " << q.maximum_angle() << '\n';
  row("obtuse triangles") << q.number_of_obtuse_triangles() << '\n';
  row("interior vertices, not of degree 6") << q.number_of_interior_vertices() << "  "
                                            << 100 * q.irregular_share() << " %\n";
  out.unsetf(std::ios::floatfield); // lengths have any magnitude
  row("edge: shortest, longest") << std::setprecision(6) << q.shortest_edge() << "  " << q.longest_edge() << '\n';
  out << std::fixed;
  if (!q.has_length_ratios())
    return;
  out << std::setprecision(4);
  row("length over d: mean, deviation") << q.mean_length_ratio() << "  "
                                        << q.length_ratio_deviation() << '\n';
  row("  1 %, 99 %") << q.length_ratio_percentile(1) << "  " << q.length_ratio_percentile(99) << '\n';
}

/// one line a bar, from the first that is not empty; one line for empty ones that follow each other
inline void print_histogram(std::ostream& out, const Mesh_quality_2<double>& q)
{
  constexpr std::size_t width = 40;
  const auto& bars = q.histogram();
  const std::size_t highest = *std::max_element(bars.begin(), bars.end());
  const auto is_empty = [](std::size_t bar) { return bar == 0; };
  const auto position = [&bars](auto bar) { return double(bar - bars.begin()) / double(bars.size()); };
  out << std::setprecision(2) << "  histogram of the radius ratio\n";
  for (auto bar = std::find_if_not(bars.begin(), bars.end(), is_empty); bar != bars.end();) {
    const auto next = is_empty(*bar) ? std::find_if_not(bar, bars.end(), is_empty) : bar + 1;
    out << "  " << position(bar) << " - " << position(next) << ' ' << std::setw(10) << *bar;
    if (!is_empty(*bar)) // a bar that holds anything shows
      out << ' ' << std::string((std::max)(std::size_t(1), *bar * width / highest), '#');
    out << '\n';
    bar = next;
  }
}

CGAL_BUBBLE_RELAXATION_2_INLINE
void print_mesh_quality(std::ostream& out, const Mesh_quality_2<double>& quality)
{
  std::ostringstream text; // the user's stream keeps its format
  text.imbue(out.getloc());
  print_table(text, quality);
  if (quality.number_of_triangles() > 0)
    print_histogram(text, quality);
  out << text.str();
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_QUALITY_PRINT_MESH_QUALITY_IMPL_H
