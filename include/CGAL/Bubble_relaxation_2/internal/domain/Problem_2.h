// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DOMAIN_PROBLEM_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DOMAIN_PROBLEM_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/Relaxation_options.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Sizes_2.h>
#include <CGAL/Bubble_relaxation_2/internal/core/reproducible_math.h>
#include <CGAL/Bubble_relaxation_2/internal/core/vocabulary.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_2.h>

#include <cstddef>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// How an existing mesh looks around a vertex.
struct Mesh_star_2
{
  double spacing;   ///< mean length of the edges
  double direction; ///< angle of the shortest edge
};

/// `ring`: the neighbours of a vertex at `p`, counterclockwise from the lexicographically smallest one on
inline Mesh_star_2 mesh_star(const Point& p, const std::vector<Point>& ring)
{
  double sum = 0, shortest = 0, direction = 0;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const double dx = ring[k].x() - p.x(), dy = ring[k].y() - p.y(), length = length_of(dx, dy);
    sum += length;
    if (k == 0 || length < shortest) {
      shortest = length;
      direction = angle_of(dx, dy);
    }
  }
  return Mesh_star_2{sum / static_cast<double>(ring.size()), direction};
}

/// What a triangulation had inside of its domain before, as far as its vertices are no corners.
struct Given_mesh_2
{
  std::vector<Point> pinned;
  std::vector<std::vector<Point>> on_edge; ///< those that split an edge of the domain, from source to target
  std::vector<Point> free;                 ///< along the curve
  std::vector<Mesh_star_2> around; ///< of the free ones, if that was asked for
  /// Corners of a part's rim that ask for no sizes, sorted: the mesh beyond goes on there as it is.
  std::vector<Point> silent_corners;
  std::size_t number_of_pins_outside = 0; ///< of the domain
  Point pin_outside{0, 0};                ///< the first of them, in lexicographic order
};

class Cut_domain_2;

/// What is to be done, without the user's types. It refers to what was read.
struct Problem_2
{
  const Domain_2& domain;
  const Given_mesh_2& given;
  const Relaxation_options& options;
  Sizes_2 wanted; ///< by the user
  Sizes_2 sizes;  ///< that the simulation follows: smaller where the outline asks for it
  const Cut_domain_2* cut = nullptr; ///< if `domain` is the one of it, with which the result is to be joined
  const Domain_2* whole = nullptr;   ///< the domain before that

  /// whether sizes, smaller where the outline asks for it, ask for more than 1.25 times the bubbles of the wanted ones
  bool follows_outline() const
  {
    constexpr double many_more = 1.25;
    return sizes.expected_number > many_more * wanted.expected_number;
  }

  const Domain_2& whole_domain() const { return whole != nullptr ? *whole : domain; }
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DOMAIN_PROBLEM_2_H
