// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef BUBBLE_RELAXATION_2_DEMO_MESH_FILE_H
#define BUBBLE_RELAXATION_2_DEMO_MESH_FILE_H

#include "file_names.h"
#include "mesh_arrays.h"
#include "vtu_file.h"

#include <cmath>
#include <ostream>
#include <set>

inline const std::vector<std::string>& mesh_endings()
{
  static const std::vector<std::string> endings{".vtu", ".msh", ".node", ".ele"};
  return endings;
}

/// the files that a mesh is written to: Triangle's are three
inline std::vector<std::string> mesh_files(const std::string& name)
{
  if (extension(name) == ".vtu" || extension(name) == ".msh")
    return {name};
  const std::string base = without_extension(name);
  return {base + ".node", base + ".ele", base + ".poly"};
}

// Triangle's files, numbered from 1

inline void write_node(std::ostream& out, const Mesh_arrays& mesh)
{
  out.precision(17);
  out << mesh.points.size() << " 2 0 1\n";
  for (std::size_t k = 0; k < mesh.points.size(); ++k)
    out << k + 1 << ' ' << mesh.points[k].x() << ' ' << mesh.points[k].y() << ' ' << mesh.point_markers[k]
        << '\n';
}

inline void write_ele(std::ostream& out, const Mesh_arrays& mesh)
{
  out.precision(17);
  out << mesh.triangles.size() << " 3 " << (mesh.regions.empty() ? 0 : 1) << '\n';
  for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
    const auto& t = mesh.triangles[k];
    out << k + 1 << ' ' << t[0] + 1 << ' ' << t[1] + 1 << ' ' << t[2] + 1;
    if (!mesh.regions.empty())
      out << ' ' << mesh.regions[k];
    out << '\n';
  }
}

/// the segments with their markers, and the holes; the points are in the .node
inline void write_poly(std::ostream& out, const Mesh_arrays& mesh)
{
  out.precision(17);
  out << "0 2 0 1\n" << mesh.edges.size() << " 1\n";
  for (std::size_t k = 0; k < mesh.edges.size(); ++k)
    out << k + 1 << ' ' << mesh.edges[k][0] + 1 << ' ' << mesh.edges[k][1] + 1 << ' ' << mesh.edge_markers[k]
        << '\n';
  out << mesh.holes.size() << '\n';
  for (std::size_t k = 0; k < mesh.holes.size(); ++k)
    out << k + 1 << ' ' << mesh.holes[k].x() << ' ' << mesh.holes[k].y() << '\n';
}

/// Gmsh's format 2.2. The physical group of a line is its marker, that of a triangle its region's attribute,
/// as far as it is an integer, else 1. Elements of one group have one elementary entity.
inline void write_msh(std::ostream& out, const Mesh_arrays& mesh)
{
  out.precision(17);
  out << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n" << mesh.points.size() << '\n';
  for (std::size_t k = 0; k < mesh.points.size(); ++k)
    out << k + 1 << ' ' << mesh.points[k].x() << ' ' << mesh.points[k].y() << " 0\n";
  out << "$EndNodes\n$Elements\n" << mesh.edges.size() + mesh.triangles.size() << '\n';
  std::size_t number = 0;
  const auto write = [&](int type, const auto& elements, const auto& group_of) {
    std::set<int> groups;
    for (std::size_t k = 0; k < elements.size(); ++k)
      groups.insert(group_of(k));
    for (std::size_t k = 0; k < elements.size(); ++k) {
      const auto entity = 1 + std::distance(groups.begin(), groups.find(group_of(k)));
      out << ++number << ' ' << type << " 2 " << group_of(k) << ' ' << entity;
      for (const std::size_t i : elements[k])
        out << ' ' << i + 1;
      out << '\n';
    }
  };
  write(1, mesh.edges, [&](std::size_t k) { return mesh.edge_markers[k]; });
  write(2, mesh.triangles, [&](std::size_t k) {
    const double region = mesh.regions.empty() ? 1 : mesh.regions[k];
    return region == std::floor(region) && std::abs(region) < 2e9 ? static_cast<int>(region) : 1;
  });
  out << "$EndElements\n";
}

/// Writes .vtu, .msh, or .node, .ele and .poly, by the ending of the name.
/// \throws std::runtime_error with the name and the reason
inline void write_mesh_file(const std::string& name, const Mesh_arrays& mesh)
{
  for (const std::string& file : mesh_files(name))
    write_file(file, [&](std::ostream& out) {
      const std::string ending = extension(file);
      if (ending == ".vtu")
        Vtu_writer(out, mesh).write();
      else if (ending == ".msh")
        write_msh(out, mesh);
      else if (ending == ".node")
        write_node(out, mesh);
      else if (ending == ".ele")
        write_ele(out, mesh);
      else
        write_poly(out, mesh);
    });
}

#endif // BUBBLE_RELAXATION_2_DEMO_MESH_FILE_H
