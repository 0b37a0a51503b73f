// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_IO_TRIANGLE_H
#define CGAL_BUBBLE_RELAXATION_2_IO_TRIANGLE_H

#include <CGAL/license/Bubble_relaxation_2.h>

#include <CGAL/Bubble_relaxation_2/internal/core/disable_warnings.h>

#include <CGAL/Bubble_relaxation_2/internal/files/write_file.h>
#include <CGAL/Mesh_arrays_2.h>

#include <CGAL/centroid.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <filesystem>
#include <map>
#include <ostream>
#include <set>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2::internal {

inline Mesh_arrays_2::Point_2 centroid_of(const Mesh_arrays_2& mesh, std::size_t triangle)
{
  const auto& t = mesh.triangles[triangle];
  return CGAL::centroid(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]);
}

/// the largest triangle of each part of a mesh that edges bound
inline std::vector<std::size_t> largest_triangles_between_edges(const Mesh_arrays_2& mesh)
{
  using Edge = Mesh_arrays_2::Edge;
  std::vector<std::pair<Edge, std::size_t>> sides;
  for (std::size_t k = 0; k < mesh.triangles.size(); ++k)
    for (std::size_t i = 0; i < 3; ++i)
      sides.emplace_back(sorted_edge(mesh.triangles[k][i], mesh.triangles[k][(i + 1) % 3]), k);
  std::sort(sides.begin(), sides.end());
  std::set<Edge> edges;
  for (const Edge& e : mesh.edges)
    edges.insert(sorted_edge(e[0], e[1]));
  boost::disjoint_sets_with_storage<> parts(mesh.triangles.size());
  for (std::size_t k = 1; k < sides.size(); ++k)
    if (sides[k].first == sides[k - 1].first && edges.count(sides[k].first) == 0)
      parts.union_set(sides[k].second, sides[k - 1].second);
  std::map<std::size_t, std::size_t> largest; // by the representative of the part
  const auto area = [&mesh](std::size_t k) {
    const auto& t = mesh.triangles[k];
    return CGAL::area(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]);
  };
  for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
    const auto found = largest.emplace(parts.find_set(k), k).first;
    if (area(k) > area(found->second))
      found->second = k;
  }
  std::vector<std::size_t> result;
  for (const auto& part : largest)
    result.push_back(part.second);
  std::sort(result.begin(), result.end());
  return result;
}

} // namespace Bubble_relaxation_2::internal

namespace IO {

/*!
\ingroup PkgBubbleRelaxation2Files

writes the points of a mesh as a `.node` file of Triangle, with their markers. All of Triangle's files are numbered from
1.

\returns whether it was written

\throws std::invalid_argument as `Mesh_arrays_2::check()` does
*/
inline bool write_triangle_node(std::ostream& out, const Mesh_arrays_2& mesh)
{
  mesh.check();
  const Bubble_relaxation_2::internal::Plain_numbers plain(out);
  out << mesh.points.size() << " 2 0 1\n";
  for (std::size_t k = 0; k < mesh.points.size(); ++k)
    out << k + 1 << ' ' << mesh.points[k].x() << ' ' << mesh.points[k].y() << ' ' << mesh.vertex_markers[k] << '\n';
  return static_cast<bool>(out);
}

/*!
\ingroup PkgBubbleRelaxation2Files

writes the triangles of a mesh as an `.ele` file of Triangle, with their regions as attributes if there are any.

\returns whether it was written

\throws std::invalid_argument as `Mesh_arrays_2::check()` does
*/
inline bool write_triangle_ele(std::ostream& out, const Mesh_arrays_2& mesh)
{
  mesh.check();
  const Bubble_relaxation_2::internal::Plain_numbers plain(out);
  out << mesh.triangles.size() << " 3 " << (mesh.regions.empty() ? 0 : 1) << '\n';
  for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
    const auto& t = mesh.triangles[k];
    out << k + 1 << ' ' << t[0] + 1 << ' ' << t[1] + 1 << ' ' << t[2] + 1;
    if (!mesh.regions.empty())
      out << ' ' << mesh.regions[k];
    out << '\n';
  }
  return static_cast<bool>(out);
}

/*!
\ingroup PkgBubbleRelaxation2Files

writes the edges on constraints of a mesh, with their markers, its holes, and its regions, if there are any, as a
`.poly` file of Triangle. Its points are those of the `.node` file beside it. A region is what lies within edges: if its
triangles have different ones, that of the largest triangle counts.

\returns whether it was written

\throws std::invalid_argument as `Mesh_arrays_2::check()` does
*/
inline bool write_triangle_poly(std::ostream& out, const Mesh_arrays_2& mesh)
{
  mesh.check();
  const Bubble_relaxation_2::internal::Plain_numbers plain(out);
  out << "0 2 0 1\n" << mesh.edges.size() << " 1\n";
  for (std::size_t k = 0; k < mesh.edges.size(); ++k)
    out << k + 1 << ' ' << mesh.edges[k][0] + 1 << ' ' << mesh.edges[k][1] + 1 << ' ' << mesh.edge_markers[k] << '\n';
  out << mesh.holes.size() << '\n';
  for (std::size_t k = 0; k < mesh.holes.size(); ++k)
    out << k + 1 << ' ' << mesh.holes[k].x() << ' ' << mesh.holes[k].y() << '\n';
  if (mesh.regions.empty())
    return static_cast<bool>(out);
  const std::vector<std::size_t> largest = Bubble_relaxation_2::internal::largest_triangles_between_edges(mesh);
  out << largest.size() << '\n';
  for (std::size_t k = 0; k < largest.size(); ++k) {
    const auto p = Bubble_relaxation_2::internal::centroid_of(mesh, largest[k]);
    out << k + 1 << ' ' << p.x() << ' ' << p.y() << ' ' << mesh.regions[largest[k]] << " -1\n"; // -1: no largest area
  }
  return static_cast<bool>(out);
}

/*!
\ingroup PkgBubbleRelaxation2Files

writes all edges of a mesh as an `.edge` file of Triangle, with their markers, 0 for those on no constraint.

\returns whether it was written

\throws std::invalid_argument as `Mesh_arrays_2::check()` does
*/
inline bool write_triangle_edge(std::ostream& out, const Mesh_arrays_2& mesh)
{
  mesh.check();
  const Bubble_relaxation_2::internal::Plain_numbers plain(out);
  using Bubble_relaxation_2::internal::sorted_edge;
  std::map<Mesh_arrays_2::Edge, int> markers;
  for (std::size_t k = 0; k < mesh.edges.size(); ++k)
    markers[sorted_edge(mesh.edges[k][0], mesh.edges[k][1])] = mesh.edge_markers[k];
  std::vector<Mesh_arrays_2::Edge> edges;
  for (const auto& t : mesh.triangles)
    for (std::size_t i = 0; i < 3; ++i)
      edges.push_back(sorted_edge(t[i], t[(i + 1) % 3]));
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  out << edges.size() << " 1\n";
  for (std::size_t k = 0; k < edges.size(); ++k) {
    const auto found = markers.find(edges[k]);
    out << k + 1 << ' ' << edges[k][0] + 1 << ' ' << edges[k][1] + 1 << ' '
        << (found == markers.end() ? 0 : found->second) << '\n';
  }
  return static_cast<bool>(out);
}

/*!
\ingroup PkgBubbleRelaxation2Files

returns the names of the files that `write_triangle_files()` writes: `name` with the endings `.node`, `.ele` and
`.poly`, and `.edge` if `name` has that. If `name` has one of these endings it is left out before; another one stays, as
in `box.1`, which is how Triangle numbers meshes.
*/
inline std::vector<std::string> triangle_files(const std::string& name)
{
  std::filesystem::path path(name);
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const bool is_known = ending == ".node" || ending == ".ele" || ending == ".poly" || ending == ".edge";
  const std::string stem = is_known ? path.replace_extension().string() : name;
  std::vector<std::string> files{stem + ".node", stem + ".ele", stem + ".poly"};
  if (ending == ".edge")
    files.push_back(stem + ".edge");
  return files;
}

/*!
\ingroup PkgBubbleRelaxation2Files

writes a mesh for Triangle and its users: the files that `triangle_files()` tells, with markers, attributes of regions,
and a point in each hole. Names, elevations and data of vertices are not kept.

\throws std::runtime_error with the name of a file and the reason if it cannot be written; then there is none of them
*/
inline void write_triangle_files(const std::string& name, const Mesh_arrays_2& mesh)
{
  mesh.check();
  const std::vector<std::string> files = triangle_files(name);
  bool (*const writers[])(std::ostream&, const Mesh_arrays_2&) = {write_triangle_node, write_triangle_ele,
                                                                  write_triangle_poly, write_triangle_edge};
  std::size_t k = 0;
  try {
    for (; k < files.size(); ++k)
      Bubble_relaxation_2::internal::write_file(files[k], [&](std::ostream& out) { writers[k](out, mesh); });
  } catch (...) {
    std::error_code ignored;
    while (k-- > 0)
      std::filesystem::remove(files[k], ignored);
    throw;
  }
}

} // namespace IO
} // namespace CGAL

#include <CGAL/Bubble_relaxation_2/internal/core/enable_warnings.h>

#endif // CGAL_BUBBLE_RELAXATION_2_IO_TRIANGLE_H
