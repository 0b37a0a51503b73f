// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_IO_ADCIRC_H
#define CGAL_BUBBLE_RELAXATION_2_IO_ADCIRC_H

#include <CGAL/license/Bubble_relaxation_2.h>

#include <CGAL/Bubble_relaxation_2/internal/core/disable_warnings.h>

#include <CGAL/Bubble_relaxation_2/internal/files/Edge_chains_2.h>
#include <CGAL/Bubble_relaxation_2/internal/files/depth.h>
#include <CGAL/Bubble_relaxation_2/internal/files/write_file.h>
#include <CGAL/Mesh_arrays_2.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <ostream>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2::internal {

/// The boundary of a mesh as models of oceans see it: nodes of its parts, in each of which the domain is on the left.
struct Coastal_boundary_2
{
  struct Land
  {
    std::vector<std::size_t> nodes; ///< of an island each once; of a closed mainland the first one again at the end
    bool is_island;
  };

  std::vector<std::vector<std::size_t>> open;
  std::vector<Land> land; ///< islands last
  int land_type;          ///< of the mainland

  /// \throws std::invalid_argument as `IO::write_ADCIRC()`
  Coastal_boundary_2(const Mesh_arrays_2& mesh, const std::set<int>& open_markers, int type) : land_type(type)
  {
    mesh.check();
    if (land_type != 0 && land_type != 10 && land_type != 20)
      throw std::invalid_argument("Bubble_relaxation_2: land_type = " + std::to_string(land_type) +
                                  " must be 0, 10 or 20");
    std::map<Mesh_arrays_2::Edge, int> markers;
    for (std::size_t k = 0; k < mesh.edges.size(); ++k)
      markers[mesh.edges[k]] = mesh.edge_markers[k];
    check_triangles(mesh, markers);
    std::set<int> missing = open_markers;
    std::vector<Mesh_arrays_2::Edge> open_edges, land_edges;
    for (const auto& e : mesh.boundary_edges()) {
      const auto found = markers.find(e);
      const int marker = found != markers.end() ? found->second : markers.at({e[1], e[0]});
      (open_markers.count(marker) > 0 ? open_edges : land_edges).push_back(e);
      missing.erase(marker);
    }
    if (!missing.empty())
      throw std::invalid_argument("Bubble_relaxation_2: open_markers: no edge of the boundary has the marker " +
                                  std::to_string(*missing.begin()));
    for (auto chain : Edge_chains_2(open_edges).take_chains()) {
      if (chain.front() == chain.back())
        chain.pop_back();
      open.push_back(chain);
    }
    for (const auto& chain : Edge_chains_2(land_edges).take_chains()) {
      land.push_back({chain, chain.front() == chain.back() && is_clockwise(mesh, chain)});
      if (land.back().is_island)
        land.back().nodes.pop_back();
    }
    std::stable_partition(land.begin(), land.end(), [](const Land& l) { return !l.is_island; });
  }

private:
  /// whether the boundary can be told from the edges, with the domain on its left
  static void check_triangles(const Mesh_arrays_2& mesh, const std::map<Mesh_arrays_2::Edge, int>& edges)
  {
    std::vector<Mesh_arrays_2::Edge> sides;
    for (const auto& t : mesh.triangles) {
      const auto &p = mesh.points[t[0]], &q = mesh.points[t[1]], &r = mesh.points[t[2]];
      if (CGAL::orientation(p, q, r) == RIGHT_TURN)
        throw std::invalid_argument("Bubble_relaxation_2: mesh arrays: the triangle at " + in_words(p.x(), p.y()) +
                                    " is clockwise");
      for (std::size_t i = 0; i < 3; ++i)
        sides.push_back({t[i], t[(i + 1) % 3]});
    }
    std::sort(sides.begin(), sides.end());
    for (const auto& side : sides) {
      const Mesh_arrays_2::Edge turned{side[1], side[0]};
      if (!std::binary_search(sides.begin(), sides.end(), turned) && edges.count(side) == 0 && edges.count(turned) == 0)
        throw std::invalid_argument("Bubble_relaxation_2: mesh arrays: the side of the points " +
                                    std::to_string(side[0]) + " and " + std::to_string(side[1]) +
                                    ", which one triangle has, is not among the edges");
    }
  }

  static bool is_clockwise(const Mesh_arrays_2& mesh, const std::vector<std::size_t>& closed)
  {
    double area = 0; // twice that, from the first point, so that no digits are lost where coordinates are large
    for (std::size_t k = 1; k < closed.size(); ++k)
      area += CGAL::determinant(mesh.points[closed[k - 1]] - mesh.points[closed[0]],
                                mesh.points[closed[k]] - mesh.points[closed[0]]);
    return area < 0;
  }
};

inline bool write_fort_14(std::ostream& out, const Mesh_arrays_2& mesh, const Coastal_boundary_2& boundary)
{
  const Plain_numbers plain(out);
  const std::vector<double> depth = depths(mesh);
  out << "mesh\n" << mesh.triangles.size() << ' ' << mesh.points.size() << '\n';
  for (std::size_t k = 0; k < mesh.points.size(); ++k)
    out << k + 1 << ' ' << mesh.points[k].x() << ' ' << mesh.points[k].y() << ' ' << depth[k] << '\n';
  for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
    const auto& t = mesh.triangles[k];
    out << k + 1 << " 3 " << t[0] + 1 << ' ' << t[1] + 1 << ' ' << t[2] + 1 << '\n';
  }
  const auto write_nodes = [&out](const std::vector<std::size_t>& nodes) {
    for (const std::size_t v : nodes)
      out << v + 1 << '\n';
  };
  std::size_t open_nodes = 0, land_nodes = 0, number = 0;
  for (const auto& nodes : boundary.open)
    open_nodes += nodes.size();
  for (const auto& land : boundary.land)
    land_nodes += land.nodes.size();
  out << boundary.open.size() << " = Number of open boundaries\n"
      << open_nodes << " = Total number of open boundary nodes\n";
  for (const auto& nodes : boundary.open) {
    out << nodes.size() << " 0 = Number of nodes for open boundary " << ++number << '\n';
    write_nodes(nodes);
  }
  number = 0;
  out << boundary.land.size() << " = Number of land boundaries\n"
      << land_nodes << " = Total number of land boundary nodes\n";
  for (const auto& land : boundary.land) {
    out << land.nodes.size() << ' ' << boundary.land_type + land.is_island
        << " = Number of nodes for land boundary " << ++number << '\n';
    write_nodes(land.nodes);
  }
  return static_cast<bool>(out);
}

} // namespace Bubble_relaxation_2::internal

namespace IO {

/*!
\ingroup PkgBubbleRelaxation2Files

writes a mesh as a `fort.14` (`.14`, `.grd`) file of ADCIRC, which is also an `hgrid.gr3` file of SCHISM: nodes with
depths, triangles, open boundaries, and land boundaries, islands last.

All boundaries have the domain on their left: around it counterclockwise, around islands clockwise. A boundary that ends
where another kind begins shares the node there. Closed ones do not have their first node again at the end, but for a
mainland without an opening. Edges of a hole are an island if none of them is open, and land otherwise.

The depth of a node is the vertex data `depth`, or else minus its elevation, or else 0. Other data, regions and names
are not kept; of markers only what is open.

\param out takes the file
\param mesh a mesh, or a triangulation
\param open_markers the markers of open boundaries; all others are land
\param land_type of the mainland: 0, 10 or 20, as ADCIRC has them; islands have one more, which is 1, 11 or 21. SCHISM
wants 0

\returns whether it was written

\throws std::invalid_argument if `land_type` is none of these, if no edge of the boundary has one of `open_markers`, if
a triangle is clockwise, if a side that one triangle has is not among the edges, or as `Mesh_arrays_2::check()` does
*/
inline bool write_ADCIRC(std::ostream& out, const Mesh_arrays_2& mesh, const std::set<int>& open_markers = {},
                         int land_type = 0)
{
  using namespace Bubble_relaxation_2::internal;
  return write_fort_14(out, mesh, Coastal_boundary_2(mesh, open_markers, land_type));
}

/*!
\ingroup PkgBubbleRelaxation2Files

writes a mesh to the file `name`.

\throws std::invalid_argument as above, before the file is touched
\throws std::runtime_error with the name and the reason if it cannot be written; then it is not there
*/
inline void write_ADCIRC(const std::string& name, const Mesh_arrays_2& mesh, const std::set<int>& open_markers = {},
                         int land_type = 0)
{
  using namespace Bubble_relaxation_2::internal;
  const Coastal_boundary_2 boundary(mesh, open_markers, land_type);
  write_file(name, [&](std::ostream& out) { write_fort_14(out, mesh, boundary); });
}

} // namespace IO
} // namespace CGAL

#include <CGAL/Bubble_relaxation_2/internal/core/enable_warnings.h>

#endif // CGAL_BUBBLE_RELAXATION_2_IO_ADCIRC_H
