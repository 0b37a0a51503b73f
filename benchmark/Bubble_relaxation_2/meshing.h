// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef BUBBLE_RELAXATION_2_BENCHMARK_MESHING_H
#define BUBBLE_RELAXATION_2_BENCHMARK_MESHING_H

#include "bare_triangulation.h"

#include <algorithm>
#include <cstddef>
#include <utility>

/// What a mesher made of a domain.
struct Meshing
{
  Vertices_and_constraints mesh;
  std::size_t triangles = 0; ///< in the domain, as the mesher itself counts them
  double seconds = 0;        ///< CPU time, without that for putting the domain into the mesher's own form
};

/// A mesh with the bare triangulation of its vertices and constraints, and the times of both.
struct Measured_meshing : Meshing
{
  paper::CDT bare;   ///< with its domain marked
  double floor = 0;  ///< seconds
};

/// Calls a mesher several times, and makes the bare triangulation after each call, so that a slow while of the
/// machine meets both. The fastest of each counts, since other processes can only slow them down.
/// \param make_mesh returns a `Meshing`, the same each time
template <class MakeMesh>
Measured_meshing measure(const MakeMesh& make_mesh)
{
  constexpr int at_most = 8, floors_each = 4;
  constexpr double enough_seconds = 2;
  Measured_meshing result;
  double spent = 0;
  for (int i = 0; i < at_most && spent < enough_seconds; ++i) {
    Meshing meshing = make_mesh();
    spent += meshing.seconds;
    if (i > 0)
      meshing.seconds = (std::min)(meshing.seconds, result.seconds);
    static_cast<Meshing&>(result) = std::move(meshing);
    for (int k = 0; k < floors_each; ++k) {
      result.bare.clear();
      const double seconds = triangulate_bare(result.mesh, result.bare);
      result.floor = i == 0 && k == 0 ? seconds : (std::min)(result.floor, seconds);
      spent += seconds;
    }
  }
  return result;
}

#endif // BUBBLE_RELAXATION_2_BENCHMARK_MESHING_H
