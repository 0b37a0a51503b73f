// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef BUBBLE_RELAXATION_2_TEST_ROUGH_OUTLINES_H
#define BUBBLE_RELAXATION_2_TEST_ROUGH_OUTLINES_H

#include "domains.h"
#include "validation.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <random>
#include <vector>

/// Outlines that are known in more detail than meshes shall have.
namespace rough_outlines {

using domains::Outline;
using domains::square;

/// a ring with noise of all wave lengths
inline Outline coast(double x, double y, double radius, int n, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> phase(0, 6.283185307179586);
  std::vector<double> r(n, radius);
  for (int wave = 2; wave < n / 3; wave *= 2) {
    const double shift = phase(random);
    for (int i = 0; i < n; ++i)
      r[i] += 0.25 * radius / wave * std::sin(wave * 6.283185307179586 * i / n + shift);
  }
  std::uniform_real_distribution<double> jitter(-0.3, 0.3);
  Outline o;
  for (int i = 0; i < n; ++i) {
    const double t = 6.283185307179586 * (i + jitter(random)) / n, l = r[i] * (1 + 0.02 * jitter(random));
    o.push_back({x + l * std::cos(t), y + l * std::sin(t)});
  }
  return o;
}

/// a sea with islands of different sizes
inline std::vector<Outline> archipelago(unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> radius(0.02, 0.4);
  std::vector<Outline> outlines{square(-5, -5, 10)};
  for (int i = -2; i <= 2; ++i)
    for (int j = -2; j <= 2; ++j)
      outlines.push_back(
        coast(1.7 * i, 1.7 * j, radius(random), 40 + 10 * (i + 2), seed + static_cast<unsigned>(10 * i + j + 100)));
  outlines.push_back(coast(0, 0, 0.01, 12, seed + 7)); // a pond on the island in the middle, or beside it
  return outlines;
}

/// the vertices at which more than two boundary edges meet
template <class Cdt>
std::size_t number_of_pinches(const Cdt& cdt)
{
  std::map<validation::Xy, int> degree;
  std::size_t n = 0;
  for (const validation::Segment& s : validation::snapshot(cdt).constraints)
    for (const validation::Xy& p : {s.first, s.second})
      n += ++degree[p] == 3;
  return n;
}

/// of all gaps that a report tells of
template <class Report>
double filled_area(const Report& report)
{
  return std::accumulate(report.filled_gaps.begin(), report.filled_gaps.end(), 0.,
                         [](double sum, const auto& gap) { return sum + gap.area; });
}

/// from a place of a report to another one, the smaller first
template <class Place>
validation::Segment segment(const Place& p, const Place& q)
{
  return {{(std::min)(p, q)[0], (std::min)(p, q)[1]}, {(std::max)(p, q)[0], (std::max)(p, q)[1]}};
}

/// the segments of a constraint, sorted
template <class Ctp>
std::vector<validation::Segment> segments_of(const Ctp& cdt, typename Ctp::Constraint_id id)
{
  std::vector<validation::Segment> result;
  auto v = cdt.vertices_in_constraint_begin(id);
  for (auto u = v++; v != cdt.vertices_in_constraint_end(id); u = v++)
    result.push_back(std::minmax(validation::xy(*u), validation::xy(*v)));
  std::sort(result.begin(), result.end());
  return result;
}

} // namespace rough_outlines

#endif // BUBBLE_RELAXATION_2_TEST_ROUGH_OUTLINES_H
