// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_IO_MSH_H
#define CGAL_BUBBLE_RELAXATION_2_IO_MSH_H

#include <CGAL/license/Bubble_relaxation_2.h>

#include <CGAL/Bubble_relaxation_2/internal/core/disable_warnings.h>

#include <CGAL/Bubble_relaxation_2/internal/files/Tag_groups.h>
#include <CGAL/Bubble_relaxation_2/internal/files/write_file.h>
#include <CGAL/Mesh_arrays_2.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2::internal {

/// Writes the formats of Gmsh. Edges of one marker are one curve, triangles of one region one surface: elementary
/// entities, each in the physical group of its tag.
class Msh_writer
{
public:
  Msh_writer(std::ostream& out, const Mesh_arrays_2& mesh)
    : m_out(out), m_mesh(mesh), m_curves(mesh.edge_markers, mesh.marker_names),
      m_surfaces(mesh.regions.empty() ? std::vector<double>{1} : mesh.regions, mesh.region_names)
  {}

  void write_4_1()
  {
    m_out << "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n";
    write_names();
    find_entities();
    write_entities();
    write_nodes();
    write_elements();
    write_data();
  }

  void write_2_2()
  {
    m_out << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";
    write_names();
    m_out << "$Nodes\n" << m_mesh.points.size() << '\n';
    for (std::size_t k = 0; k < m_mesh.points.size(); ++k) {
      m_out << k + 1 << ' ';
      write_point(k);
    }
    m_out << "$EndNodes\n$Elements\n" << m_mesh.edges.size() + m_mesh.triangles.size() << '\n';
    std::size_t number = 0;
    const auto write = [&](int type, const auto& cells, const auto& group_of) {
      for (std::size_t k = 0; k < cells.size(); ++k) {
        const Tag_groups::Group& group = group_of(k);
        m_out << ++number << ' ' << type << " 2 " << group.number << ' ' << group.place + 1;
        write_nodes_of(cells[k]);
      }
    };
    write(1, m_mesh.edges, [this](std::size_t k) -> const Tag_groups::Group& { return curve(k); });
    write(2, m_mesh.triangles, [this](std::size_t k) -> const Tag_groups::Group& { return surface(k); });
    m_out << "$EndElements\n";
    write_data();
  }

private:
  /// a curve or a surface
  struct Entity
  {
    int dimension;
    Tag_groups::Group group;
    std::vector<std::size_t> cells; ///< edges or triangles
    std::vector<std::size_t> nodes; ///< that belong to no entity before it; the last one has those of no cell as well
    std::array<double, 6> box;      ///< the least coordinates, then the greatest
  };

  const Tag_groups::Group& curve(std::size_t edge) const { return m_curves(m_mesh.edge_markers[edge]); }

  const Tag_groups::Group& surface(std::size_t triangle) const
  {
    return m_surfaces(m_mesh.regions.empty() ? 1 : m_mesh.regions[triangle]);
  }

  double elevation(std::size_t v) const { return m_mesh.elevations.empty() ? 0 : m_mesh.elevations[v]; }

  void find_entities()
  {
    std::vector<char> is_taken(m_mesh.points.size(), 0);
    const auto add = [&](int dimension, const Tag_groups& groups, const auto& cells, const auto& group_of) {
      const std::size_t first = m_entities.size();
      for (const auto& g : groups.all())
        m_entities.push_back({dimension, g.second, {}, {}, {}});
      for (std::size_t k = 0; k < cells.size(); ++k) {
        Entity& e = m_entities[first + group_of(k).place];
        for (const std::size_t v : cells[k]) {
          widen(e.box, v, e.cells.empty() && v == cells[k][0]);
          if (!is_taken[v])
            e.nodes.push_back(v);
          is_taken[v] = 1;
        }
        e.cells.push_back(k);
      }
    };
    add(1, m_curves, m_mesh.edges, [this](std::size_t k) { return curve(k); });
    add(2, m_surfaces, m_mesh.triangles, [this](std::size_t k) { return surface(k); });
    Entity& last = m_entities.back(); // there is a surface at least
    for (std::size_t v = 0; v < is_taken.size(); ++v)
      if (!is_taken[v]) { // a point of no edge or triangle
        widen(last.box, v, last.cells.empty() && last.nodes.empty());
        last.nodes.push_back(v);
      }
  }

  void widen(std::array<double, 6>& box, std::size_t v, bool is_first) const
  {
    const std::array<double, 3> p{m_mesh.points[v].x(), m_mesh.points[v].y(), elevation(v)};
    for (std::size_t c = 0; c < 3; ++c) {
      box[c] = is_first ? p[c] : (std::min)(box[c], p[c]);
      box[c + 3] = is_first ? p[c] : (std::max)(box[c + 3], p[c]);
    }
  }

  void write_names()
  {
    std::size_t number = 0;
    std::string lines;
    for (int dimension : {1, 2})
      for (const auto& g : (dimension == 1 ? m_curves : m_surfaces).all())
        if (!g.second.name.empty()) {
          ++number;
          lines += std::to_string(dimension) + " " + std::to_string(g.second.number) + " " + in_quotes(g.second.name) +
                   "\n";
        }
    if (number > 0)
      m_out << "$PhysicalNames\n" << number << '\n' << lines << "$EndPhysicalNames\n";
  }

  void write_entities()
  {
    m_out << "$Entities\n0 " << m_curves.all().size() << ' ' << m_surfaces.all().size() << " 0\n";
    for (const Entity& e : m_entities) {
      m_out << e.group.place + 1;
      for (const double c : e.box)
        m_out << ' ' << c;
      m_out << " 1 " << e.group.number << " 0\n"; // nothing is told of its boundary
    }
    m_out << "$EndEntities\n";
  }

  void write_nodes()
  {
    const std::size_t n = m_mesh.points.size();
    write_head("$Nodes", n, [](const Entity& e) { return e.nodes.size(); });
    for (const Entity& e : m_entities) {
      if (e.nodes.empty())
        continue;
      m_out << e.dimension << ' ' << e.group.place + 1 << " 0 " << e.nodes.size() << '\n';
      for (const std::size_t v : e.nodes)
        m_out << v + 1 << '\n';
      for (const std::size_t v : e.nodes)
        write_point(v);
    }
    m_out << "$EndNodes\n";
  }

  void write_elements()
  {
    const std::size_t n = m_mesh.edges.size() + m_mesh.triangles.size();
    write_head("$Elements", n, [](const Entity& e) { return e.cells.size(); });
    std::size_t number = 0;
    for (const Entity& e : m_entities) {
      if (e.cells.empty())
        continue;
      m_out << e.dimension << ' ' << e.group.place + 1 << ' ' << e.dimension << ' ' << e.cells.size() << '\n';
      for (const std::size_t k : e.cells) { // lines are of type 1, triangles of type 2
        m_out << ++number;
        e.dimension == 1 ? write_nodes_of(m_mesh.edges[k]) : write_nodes_of(m_mesh.triangles[k]);
      }
    }
    m_out << "$EndElements\n";
  }

  /// the number of blocks that are not empty, and the range of numbers
  template <class Size>
  void write_head(const char* section, std::size_t n, const Size& size)
  {
    const auto blocks =
      std::count_if(m_entities.begin(), m_entities.end(), [&](const Entity& e) { return size(e) > 0; });
    m_out << section << '\n' << blocks << ' ' << n << ' ' << (n > 0 ? 1 : 0) << ' ' << n << '\n';
  }

  void write_data()
  {
    for (const auto& data : m_mesh.vertex_data) {
      m_out << "$NodeData\n1\n" << in_quotes(data.first) << "\n1\n0\n3\n0\n1\n" << data.second.size() << '\n';
      for (std::size_t k = 0; k < data.second.size(); ++k)
        m_out << k + 1 << ' ' << data.second[k] << '\n';
      m_out << "$EndNodeData\n";
    }
  }

  void write_point(std::size_t v)
  {
    m_out << m_mesh.points[v].x() << ' ' << m_mesh.points[v].y() << ' ' << elevation(v) << '\n';
  }

  template <class Cell>
  void write_nodes_of(const Cell& cell)
  {
    for (const std::size_t v : cell)
      m_out << ' ' << v + 1;
    m_out << '\n';
  }

  /// Gmsh knows no way to write quotes and ends of lines in names, and reads no longer ones.
  static std::string in_quotes(std::string name)
  {
    std::replace(name.begin(), name.end(), '"', '\'');
    std::replace(name.begin(), name.end(), '\n', ' ');
    return '"' + name.substr(0, 127) + '"';
  }

  std::ostream& m_out;
  const Mesh_arrays_2& m_mesh;
  Tag_groups m_curves, m_surfaces;
  std::vector<Entity> m_entities;
};

} // namespace Bubble_relaxation_2::internal

namespace IO {

/*!
\ingroup PkgBubbleRelaxation2Files

writes a mesh as an `.msh` file of Gmsh, ASCII, version 4.1: the edges on constraints as lines and the triangles, of
which those with one tag are one elementary entity.

The physical group of a line is its marker, that of a triangle its region, and 1 if there are no regions. Tags that are
no positive integers, 0 too, get the next free numbers, and their values as names. `marker_names` and `region_names` are
the names of physical groups, in which `"` becomes `'`; `vertex_data` becomes `$NodeData`.

\returns whether it was written

\throws std::invalid_argument as `Mesh_arrays_2::check()` does
*/
inline bool write_MSH(std::ostream& out, const Mesh_arrays_2& mesh)
{
  mesh.check();
  const Bubble_relaxation_2::internal::Plain_numbers plain(out);
  Bubble_relaxation_2::internal::Msh_writer(out, mesh).write_4_1();
  return static_cast<bool>(out);
}

/*!
\ingroup PkgBubbleRelaxation2Files

writes a mesh to the file `name`.

\throws std::runtime_error with the name and the reason if it cannot be written; then it is not there
*/
inline void write_MSH(const std::string& name, const Mesh_arrays_2& mesh)
{
  mesh.check();
  Bubble_relaxation_2::internal::write_file(name, [&mesh](std::ostream& out) { write_MSH(out, mesh); });
}

/*!
\ingroup PkgBubbleRelaxation2Files

writes a mesh as `write_MSH()` does, in version 2.2 of the format, for programs that do not read 4.1.

\returns whether it was written

\throws std::invalid_argument as `Mesh_arrays_2::check()` does
*/
inline bool write_MSH2(std::ostream& out, const Mesh_arrays_2& mesh)
{
  mesh.check();
  const Bubble_relaxation_2::internal::Plain_numbers plain(out);
  Bubble_relaxation_2::internal::Msh_writer(out, mesh).write_2_2();
  return static_cast<bool>(out);
}

/*!
\ingroup PkgBubbleRelaxation2Files

writes a mesh to the file `name`.

\throws std::runtime_error with the name and the reason if it cannot be written; then it is not there
*/
inline void write_MSH2(const std::string& name, const Mesh_arrays_2& mesh)
{
  mesh.check();
  Bubble_relaxation_2::internal::write_file(name, [&mesh](std::ostream& out) { write_MSH2(out, mesh); });
}

} // namespace IO
} // namespace CGAL

#include <CGAL/Bubble_relaxation_2/internal/core/enable_warnings.h>

#endif // CGAL_BUBBLE_RELAXATION_2_IO_MSH_H
