// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef BUBBLE_RELAXATION_2_TEST_SAME_BITS_OUTLINES_H
#define BUBBLE_RELAXATION_2_TEST_SAME_BITS_OUTLINES_H

#include "../../../demo/Bubble_relaxation_2/paper_domains.h"

#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

/// Domains that have the same bits on every machine: of + - * / and square roots, and of random numbers of an engine
/// that the standard defines, without its distributions.
namespace same_bits {

using paper::CDT;
using paper::Outline;
using paper::Point;
using paper::triangulate;
using Size = paper::Sizing;

inline double distance(const Point& p, double x, double y)
{
  return std::sqrt((p.x() - x) * (p.x() - x) + (p.y() - y) * (p.y() - y));
}

/// around the origin; `n` is 4 times a power of 2: of the corners of a square, halved between neighbours
inline Outline circle(double radius, std::size_t n)
{
  Outline o{{radius, 0}, {0, radius}, {-radius, 0}, {0, -radius}};
  while (o.size() < n) {
    Outline finer;
    for (std::size_t k = 0; k < o.size(); ++k) {
      const Point &p = o[k], &q = o[(k + 1) % o.size()];
      const double x = p.x() + q.x(), y = p.y() + q.y(), scale = radius / std::sqrt(x * x + y * y);
      finer.push_back(p);
      finer.push_back(Point(scale * x, scale * y));
    }
    o = finer;
  }
  return o;
}

inline std::vector<Outline> square_with_hole(std::size_t n)
{
  return {{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}, circle(0.5, n)};
}

inline Outline l_shape() { return {{0, 0}, {0.4, 0}, {0.4, 0.6}, {1, 0.6}, {1, 1}, {0, 1}}; }

/// the paper's, with seven fingers
inline Outline comb() { return paper::comb(1).outlines[0]; }

/// a ring that is rough at all scales
inline Outline shore(const Point& center, double radius, std::size_t n, std::mt19937& random)
{
  const Outline round = circle(1, n);
  std::vector<double> r(n, 0);
  for (std::size_t step = n / 4; step > 0; step /= 2) // each value from its neighbours at twice the distance
    for (std::size_t k = 0; k < n; k += step) {
      const double noise = static_cast<double>(random()) / 4294967296. - 0.5;
      if (k % (2 * step) != 0)
        r[k] = 0.5 * (r[k - step] + r[(k + step) % n]);
      r[k] += 1.5 * noise * static_cast<double>(step) / static_cast<double>(n);
    }
  Outline o;
  for (std::size_t k = 0; k < n; ++k) {
    const double l = radius * (1 + r[k]);
    o.push_back(Point(center.x() + l * round[k].x(), center.y() + l * round[k].y()));
  }
  return o;
}

/// a lake with islands; one is a needle, and so is the bay between two others, which touch each other
inline std::vector<Outline> lake()
{
  std::mt19937 random(11);
  return {shore(Point(0, 0), 1, 256, random),
          shore(Point(0.1, -0.5), 0.15, 64, random),
          shore(Point(-0.5, 0.05), 0.2, 64, random),
          shore(Point(0.15, 0.5), 0.03, 16, random),
          {{-0.35, -0.55}, {-0.2, -0.32}, {-0.33, -0.545}},
          {{0.4, 0.4}, {0.6, 0.41}, {0.5, 0.5}},
          {{0.4, 0.4}, {0.5, 0.3}, {0.6, 0.39}}};
}

} // namespace same_bits

#endif // BUBBLE_RELAXATION_2_TEST_SAME_BITS_OUTLINES_H
