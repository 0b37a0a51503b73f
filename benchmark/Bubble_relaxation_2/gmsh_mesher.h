// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef BUBBLE_RELAXATION_2_BENCHMARK_GMSH_MESHER_H
#define BUBBLE_RELAXATION_2_BENCHMARK_GMSH_MESHER_H

#include "meshing.h"

#include <gmsh.h>

#include <cstddef>
#include <string>
#include <unordered_map>
#include <vector>

/// Gmsh's Frontal-Delaunay algorithm for triangles, in one thread, with d as the only size. An object of this
/// class has Gmsh's library for itself.
class Gmsh_mesher
{
public:
  Gmsh_mesher()
  {
    gmsh::initialize();
    gmsh::option::setNumber("General.Terminal", 0);
    gmsh::option::setNumber("General.NumThreads", 1);
    gmsh::option::setNumber("Mesh.Algorithm", 6);
    // sizes at points, of curvature and from the boundary inwards would be mixed with d
    for (const char* source : {"FromPoints", "FromCurvature", "ExtendFromBoundary"})
      gmsh::option::setNumber(std::string("Mesh.MeshSize") + source, 0);
  }
  ~Gmsh_mesher() { gmsh::finalize(); }
  Gmsh_mesher(const Gmsh_mesher&) = delete;
  Gmsh_mesher& operator=(const Gmsh_mesher&) = delete;

  static std::string version()
  {
    std::string text;
    gmsh::option::getString("General.Version", text);
    return text;
  }

  /// \param relocations rounds of "Relocate2D" after meshing, which moves vertices to improve triangles
  Meshing operator()(const paper::Domain& domain, int relocations) const
  {
    gmsh::clear();
    gmsh::model::add(domain.name);
    add_outlines(domain);
    // newer versions also hand over the size that Gmsh has found so far
    gmsh::model::mesh::setSizeCallback([&domain](int, int, double x, double y, double, auto...) {
      return domain.d(paper::Point(x, y));
    });
    Meshing result;
    const double start = cpu_seconds();
    gmsh::model::mesh::generate(2);
    if (relocations > 0)
      gmsh::model::mesh::optimize("Relocate2D", true, relocations);
    result.seconds = cpu_seconds() - start;
    read_mesh(result);
    gmsh::model::mesh::removeSizeCallback();
    return result;
  }

private:
  /// the first outline is around the others, which are holes
  static void add_outlines(const paper::Domain& domain)
  {
    namespace geo = gmsh::model::geo;
    std::vector<int> loops;
    for (const paper::Outline& outline : domain.outlines) {
      std::vector<int> points, lines;
      for (const paper::Point& p : outline)
        points.push_back(geo::addPoint(p.x(), p.y(), 0));
      for (std::size_t i = 0; i < points.size(); ++i)
        lines.push_back(geo::addLine(points[i], points[(i + 1) % points.size()]));
      loops.push_back(geo::addCurveLoop(lines));
    }
    geo::addPlaneSurface(loops);
    geo::synchronize();
  }

  static void read_mesh(Meshing& result)
  {
    std::vector<std::size_t> tags, lines, ends, triangles, corners;
    std::vector<double> coordinates, parameters;
    gmsh::model::mesh::getNodes(tags, coordinates, parameters);
    std::unordered_map<std::size_t, std::size_t> index;
    for (std::size_t i = 0; i < tags.size(); ++i) {
      index[tags[i]] = i;
      result.mesh.points.emplace_back(coordinates[3 * i], coordinates[3 * i + 1]);
    }
    gmsh::model::mesh::getElementsByType(1, lines, ends);
    for (std::size_t i = 0; i < ends.size(); i += 2)
      result.mesh.constraints.emplace_back(index.at(ends[i]), index.at(ends[i + 1]));
    gmsh::model::mesh::getElementsByType(2, triangles, corners);
    result.triangles = triangles.size();
  }
};

#endif // BUBBLE_RELAXATION_2_BENCHMARK_GMSH_MESHER_H
