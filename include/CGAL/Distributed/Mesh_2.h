// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_DISTRIBUTED_MESH_2_H
#define CGAL_DISTRIBUTED_MESH_2_H

#include <CGAL/license/Bubble_relaxation_2.h>

#include <CGAL/Bubble_relaxation_2/internal/core/disable_warnings.h>

#include <CGAL/Bubble_relaxation_2/IO/VTU.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/input/read_same_input.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mesh/Distributed_mesh_2.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Communicator.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/writing/write_pvtu.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_regions_2.h>
#include <CGAL/Bubble_relaxation_2/internal/files/write_file.h>
#include <CGAL/Mesh_arrays_2.h>
#include <CGAL/Mesh_quality_2.h>

#include <mpi.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <ostream>
#include <string>
#include <vector>

namespace CGAL {

/// functions and classes for the ranks of an MPI communicator
namespace Distributed {

/*!
\ingroup PkgBubbleRelaxation2Ref

Data of points, or of triangles, of a mesh: a name, and a number for each by its local index.

\sa `Mesh_2::write_pvtu()`
*/
struct Mesh_data
{
  std::string name;
  std::function<double(std::size_t)> value;
};

/*!
\ingroup PkgBubbleRelaxation2Ref

What one rank has of a triangle mesh that is spread over the ranks of an MPI communicator. It is made by
`CGAL::Distributed::triangulate()` and `CGAL::Distributed::npbs_mesh()`.

A rank has its own points, all triangles around them, and the vertices of these triangles that other ranks
own, the ghosts. Each point and each triangle is owned by one rank: a triangle by the owner of that of its
vertices with the smallest global id. Points and triangles have local indices, the owned ones first, and points
have a global id, which is the same on all ranks.

Markers of constraints and regions of faces that were told by `edge_marker_map` and `face_region_map` are those of sides
and triangles here.

\tparam Kernel_ the kernel of the points
\tparam Marker_ the type of markers, the value type of `edge_marker_map`
\tparam Region_ the type of regions, the value type of `face_region_map`
*/
template <class Kernel_, class Marker_ = int, class Region_ = int>
class Mesh_2
{
  using Index = Bubble_relaxation_2::internal::Index;

public:
  using Kernel = Kernel_;
  using Marker = Marker_;
  using Region = Region_;
  using Point_2 = typename Kernel::Point_2;
  /// what names a point on all ranks
  using Global_id = std::int64_t;

#ifndef DOXYGEN_RUNNING
  /// without points
  explicit Mesh_2(MPI_Comm comm = MPI_COMM_NULL) : m_comm(comm)
  {
    if (comm == MPI_COMM_NULL) // no user gets this mesh: making it throws, or does not compile
      return;
    MPI_Comm_rank(comm, &m_rank);
    MPI_Comm_size(comm, &m_number_of_ranks);
  }

  /// `tags`: of the edges of the domain, which all ranks have
  template <class Tags>
  Mesh_2(const Bubble_relaxation_2::internal::Distributed_mesh_2& mesh,
         const Bubble_relaxation_2::internal::Domain_2& domain, const Tags& tags,
         const Mesh_quality_2<double>& quality, MPI_Comm comm)
    : Mesh_2(comm)
  {
    using namespace Bubble_relaxation_2::internal;
    m_quality = quality;
    const Domain_regions_2 regions(domain);
    take(tags, regions);
    Triangle_places_2 places(domain, regions, mesh);
    std::vector<Index> local(mesh.bubbles.size(), -1);
    add_points(mesh, local);
    const auto triangles = static_cast<std::size_t>(std::count(mesh.is_final.begin(), mesh.is_final.end(), 1));
    reserve_each(triangles, m_vertices, m_edges, m_parts);
    add_triangles(mesh, true, local, places);
    m_owned_triangles = m_vertices.size();
    add_triangles(mesh, false, local, places);
  }
#endif

  /// \name Ranks
  /// @{
  int rank() const { return m_rank; }                       ///< of this process
  int number_of_ranks() const { return m_number_of_ranks; } ///< that have a part of the mesh
  /// @}

  /// \name Points
  /// Local indices are less than `number_of_points()`. Owned points and ghosts are in the order of their ids.
  /// @{
  std::size_t number_of_points() const { return m_points.size(); }    ///< owned points and ghosts
  std::size_t number_of_owned_points() const { return m_owned_points; } ///< those with the first indices

  const Point_2& point(std::size_t i) const { return m_points[i]; }    ///< coordinates
  Global_id global_id(std::size_t i) const { return m_ids[i]; }        ///< the same on all ranks
  int owner(std::size_t i) const { return m_owners[i]; }               ///< the rank that owns the point
  bool is_ghost(std::size_t i) const { return i >= m_owned_points; }   ///< whether another rank owns it
  double size(std::size_t i) const { return m_sizes[i]; }              ///< the wanted distance to neighbours
  /// 0: a corner of the domain or a pinned point, 1: on an edge of the domain, 2: in a face
  int dimension(std::size_t i) const { return m_dimensions[i]; }
  /// @}

  /// \name Triangles
  /// All triangles of the domain with an owned vertex. Their vertices are in counterclockwise order.
  /// @{
  std::size_t number_of_triangles() const { return m_vertices.size(); }     ///< owned ones and others
  std::size_t number_of_owned_triangles() const { return m_owned_triangles; } ///< those with the first indices
  /// whether this rank owns the triangle, as exactly one does
  bool is_owned_triangle(std::size_t t) const { return t < m_owned_triangles; }

  /// local indices of the vertices
  const std::array<std::int32_t, 3>& vertices(std::size_t t) const { return m_vertices[t]; }

  /// global ids of the vertices
  std::array<Global_id, 3> triangle(std::size_t t) const
  {
    const std::array<std::int32_t, 3>& v = m_vertices[t];
    return {m_ids[v[0]], m_ids[v[1]], m_ids[v[2]]};
  }

  /// whether the side opposite to the vertex `i` of a triangle lies on an edge of the domain
  bool is_constrained(std::size_t t, int i) const { return m_edges[t][i] != -1; }

  /// The number of the edge of the domain on which the side opposite to the vertex `i` of a triangle lies, the same on
  /// all ranks, or -1. Edges of the domain are straight from corner to corner; the property `edge` of points has the same
  /// numbers.
  std::int32_t edge(std::size_t t, int i) const { return m_edges[t][i]; }

  /// the number of the part of the domain, as constraints part it, in which a triangle is, the same on all ranks
  std::int32_t part(std::size_t t) const { return m_parts[t]; }
  /// @}

  /// \name Tags
  /// @{
  bool has_markers() const { return !m_markers.empty(); } ///< whether `edge_marker_map` was given
  bool has_regions() const { return !m_regions.empty(); } ///< whether `face_region_map` was given

  /// the marker of the constraint on which the side opposite to the vertex `i` of a triangle lies
  /// \pre `has_markers()` and `is_constrained(t, i)`
  Marker marker(std::size_t t, int i) const { return m_markers[static_cast<std::size_t>(m_edges[t][i])]; }

  /// the region of a triangle \pre `has_regions()`
  Region region(std::size_t t) const { return m_regions[static_cast<std::size_t>(m_parts[t])]; }
  /// @}

  /// The statistics of the mesh of all ranks, the same on each, and for any number of ranks. There are lengths
  /// of edges if `triangulate()` was given a sizing function, or if `npbs_mesh()` made the mesh.
  const Mesh_quality_2<double>& quality() const { return m_quality; }

  /*!
  \brief writes the mesh for ParaView. All ranks must call it, with the same name.

  Each rank writes a file with its triangles, `name_0.vtu`, `name_1.vtu`, and so on, as `CGAL::IO::write_VTU()` does,
  and the first one `name.pvtu`, which refers to them. Points have also the data `global_id`, `size`, and `rank`, their
  owner; triangles `rank`. Sides on constraints are lines, each in one file. Markers and regions are there if the mesh
  has them and they are numbers. The last file that is written is `name.pvtu`: if one cannot be written none is left.

  \param path name of the file, which must end with `.pvtu`
  \param of_points more data of points, such as a solution: numbers by local indices, of owned points and of ghosts
  \param of_triangles more data of triangles, by local indices of owned ones
  \pre the communicator that the mesh was made with still exists

  \throws std::invalid_argument on all ranks, before anything is written, if the name does not end so; if data have not
  the same names on all, or such as the files have anyhow (`global_id`, `size`, `rank`, `region`, and `marker`, `q`,
  `dimension`, see `CGAL::IO::write_VTU()`); or if a marker is a number that is no `int`, or a region 2^53 or more
  \throws std::runtime_error on all ranks if one of the files cannot be written
  */
  void write_pvtu(const std::string& path, const std::vector<Mesh_data>& of_points = {},
                  const std::vector<Mesh_data>& of_triangles = {}) const
  {
    using namespace Bubble_relaxation_2::internal;
    Communicator ranks(m_comm);
    std::string stem;
    Mesh_arrays_2 part;
    ranks.agree_after([&] {
      stem = pvtu_stem(path);
      part = arrays_of_part(*this, of_points, of_triangles);
    });
    Hash_of_numbers names;
    for (const auto* data : {&part.vertex_data, &part.triangle_data})
      for (const auto& array : *data)
        names.add(array.first);
    check_same(ranks, names.value(), "the data of write_pvtu() have not the same names on all ranks");
    std::string piece; // when it is written
    try {
      ranks.agree_after([&] {
        IO::write_VTU(vtu_path(stem, m_rank), part);
        piece = vtu_path(stem, m_rank);
      });
      ranks.agree_after([&] {
        if (m_rank == 0)
          write_file(path, [&](std::ostream& out) { write_pvtu_header(out, part, stem, m_number_of_ranks); });
      });
    } catch (...) { // on all ranks
      if (!piece.empty()) {
        remove_file(piece);
        if (m_rank == 0)
          remove_file(path); // of old, which may have named it
      }
      throw;
    }
  }

private:
  using Part = Bubble_relaxation_2::internal::Distributed_mesh_2;

  /// `local`: of each point of the mesh, its index here
  void add_points(const Part& mesh, std::vector<Index>& local)
  {
    const auto& b = mesh.bubbles;
    std::vector<Index> those =
      Bubble_relaxation_2::internal::indices_where(b.size(), [&](Index i) { return b.owner[i] == m_rank; });
    m_owned_points = those.size();
    for (std::size_t t = 0; t < mesh.is_final.size(); ++t)
      if (mesh.is_final[t])
        for (Index v : mesh.triangles.vertices[t])
          if (b.owner[v] != m_rank && local[v] == -1) {
            those.push_back(v);
            local[v] = 0; // is set when all are known
          }
    std::sort(those.begin() + static_cast<std::ptrdiff_t>(m_owned_points), those.end()); // as their ids
    Bubble_relaxation_2::internal::reserve_each(those.size(), m_points, m_ids, m_owners, m_sizes, m_dimensions);
    for (Index i : those) {
      Bubble_relaxation_2::internal::tick(m_points.size());
      local[i] = static_cast<Index>(m_points.size());
      m_points.push_back(Point_2(b.x[i], b.y[i]));
      m_ids.push_back(b.id[i]);
      m_owners.push_back(b.owner[i]);
      m_sizes.push_back(b.d[i]);
      m_dimensions.push_back(static_cast<unsigned char>(b.dimension[i]));
    }
  }

  template <class Tags>
  void take(const Tags& tags, const Bubble_relaxation_2::internal::Domain_regions_2& regions)
  {
    for (const auto& marker : tags.markers())
      m_markers.push_back(*marker);
    std::vector<const Region*> values(static_cast<std::size_t>(regions.number_of_regions()), nullptr);
    const auto add = [&values](Index part, const auto& value) {
      if (value)
        values[static_cast<std::size_t>(part)] = &*value;
    };
    for (std::size_t e = 0; e < tags.left().size(); ++e) {
      add(regions.left(static_cast<Index>(e)), tags.left()[e]);
      add(regions.right(static_cast<Index>(e)), tags.right()[e]);
    }
    if (!tags.left().empty())
      for (const Region* value : values)
        m_regions.push_back(*value); // edges are all around each part
  }

  template <class Places>
  void add_triangles(const Part& mesh, bool are_owned, const std::vector<Index>& local, Places& places)
  {
    const auto& marked = mesh.triangles;
    for (std::size_t t = 0; t < mesh.is_final.size(); ++t) {
      Bubble_relaxation_2::internal::tick(t);
      if (!mesh.is_final[t] || (mesh.is_owned[t] != 0) != are_owned)
        continue;
      const auto& v = marked.vertices[t];
      m_vertices.push_back({local[v[0]], local[v[1]], local[v[2]]});
      m_edges.push_back(places.edges(t));
      m_parts.push_back(places.region(t, m_edges.back()));
    }
  }

  MPI_Comm m_comm;
  int m_rank = 0, m_number_of_ranks = 0;
  std::size_t m_owned_points = 0, m_owned_triangles = 0;
  std::vector<Point_2> m_points;
  std::vector<Global_id> m_ids;
  std::vector<int> m_owners;
  std::vector<double> m_sizes;
  std::vector<unsigned char> m_dimensions;
  std::vector<std::array<std::int32_t, 3>> m_vertices;
  std::vector<std::array<Index, 3>> m_edges; // of the domain, behind the sides of each triangle
  std::vector<Index> m_parts;                // of the domain, of each triangle
  std::vector<Marker> m_markers;             // of edges of the domain
  std::vector<Region> m_regions;             // of parts of the domain
  Mesh_quality_2<double> m_quality;
};

} // namespace Distributed
} // namespace CGAL

#include <CGAL/Bubble_relaxation_2/internal/core/enable_warnings.h>

#endif // CGAL_DISTRIBUTED_MESH_2_H
