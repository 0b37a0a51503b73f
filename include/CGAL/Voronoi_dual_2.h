// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_VORONOI_DUAL_2_H
#define CGAL_VORONOI_DUAL_2_H

#include <CGAL/license/Bubble_relaxation_2.h>

#include <CGAL/Bubble_relaxation_2/internal/core/disable_warnings.h>

#include <CGAL/Bubble_relaxation_2/internal/core/Plane_2.h>
#include <CGAL/Bubble_relaxation_2/internal/core/check_call.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_marks_2.h>
#include <CGAL/Bubble_relaxation_2/internal/dual/Cell_polygons_2.h>
#include <CGAL/Bubble_relaxation_2/internal/dual/dual_faces.h>
#include <CGAL/Bubble_relaxation_2/internal/dual/evaluate_dual.h>
#include <CGAL/Bubble_relaxation_parameters.h>
#include <CGAL/Voronoi_quality_2.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/property_map.h>
#include <CGAL/utility.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgBubbleRelaxation2FiniteVolumes

The dual of a mesh for finite volumes: a cell around each vertex of the domain, a face across each edge, and the parts
of the domain's boundary that belong to each cell.

The face across an edge lies on its perpendicular bisector, between the circumcentres of the triangles on both sides, or
from one to the midpoint of an edge of the boundary. So it crosses the line of the two vertices at a right angle, and
the difference of their values over their distance is the gradient across it. These are the Voronoi cells, clipped at
the constraints, unless an obtuse angle lies opposite to a constraint
(`Voronoi_quality_2::number_of_centers_beyond_constraints`). There the circumcentre lies beyond the constraint, and
lengths are measured with their signs: the face of that edge is negative at a boundary, and may be so within the domain.
The areas still sum up to that of the domain, and the faces of each cell still close it.

An edge within the domain that is a constraint has a face like others, since a vertex on it has a cell on both sides.
`Face::left_length` and `Face::right_length` are the parts of a face on both sides, for coefficients that jump there.

Cells are in the order in which the triangulation lists their vertices. All is computed in `double`, whatever the
kernel, and converted to its points and vectors. The dual of a terrain lies in the plane of the projection. It does not
follow when the triangulation changes: its handles are those of the triangulation that it was made of.

\tparam CDT_ a `Constrained_Delaunay_triangulation_2` or a `Constrained_triangulation_plus_2` of one
\tparam Marker_ what `edge_marker_map` has as values

\sa `IO::write_VTU_of_cells()`
*/
template <class CDT_, class Marker_ = int>
class Voronoi_dual_2
{
public:
  using CDT = CDT_;
  using Marker = Marker_;
  using Vertex_handle = typename CDT::Vertex_handle;
  using Edge = typename CDT::Edge;
  using Point_2 = Bubble_relaxation_2::internal::Place_2<CDT>;        ///< where points lie in the plane
  using Vector_2 = typename Kernel_traits<Point_2>::Kernel::Vector_2; ///< their differences

  static constexpr std::size_t no_cell = static_cast<std::size_t>(-1); ///< stands for none

  /// The cell of a vertex.
  struct Cell
  {
    Vertex_handle vertex;
    Point_2 center;      ///< the point of the vertex
    double area;         ///< negative only beside a negative face
    bool is_on_boundary; ///< whether it has boundary parts
  };

  /// What two cells have in common.
  struct Face
  {
    std::size_t first, second; ///< the numbers of the cells
    double length;             ///< negative as told above
    double left_length;        ///< from the midpoint of the edge to the circumcentre of `edge.first`
    double right_length;       ///< the rest, on the other side of the edge; 0 at the boundary
    double distance;           ///< of the centres of the cells
    Point_2 midpoint;          ///< of the face, which is not that of the edge
    Vector_2 normal;           ///< of length 1, from the first cell to the second one
    Edge edge;                 ///< the edge that it crosses, in the triangle, of the domain, on the left of `normal`
    bool is_on_boundary;       ///< whether `edge` has the domain on one side only
    bool is_constrained;       ///< whether `edge` is a constraint
    Marker marker;             ///< of `edge`, if it is a constraint
  };

  /// What a cell has in common with the domain's boundary: half of an edge.
  struct Boundary_part
  {
    std::size_t cell; ///< the number of the cell
    double length;    ///< positive
    Point_2 midpoint; ///< of this half
    Vector_2 normal;  ///< of length 1, out of the domain
    Edge edge;        ///< in a triangle of the domain
    Marker marker;    ///< of `edge`
  };

  /// Cells as polygons with common corners.
  struct Polygon_soup
  {
    std::vector<Point_2> points;                    ///< the corners
    std::vector<std::vector<std::size_t>> polygons; ///< the corners of each, counterclockwise
    /// the cell of each polygon, in ascending order. A cell has several where the domain touches itself in its vertex.
    std::vector<std::size_t> cells;
    std::vector<std::array<std::size_t, 2>> segments; ///< the ends of each boundary part
  };

  /*!
  makes the dual of a triangulation's domain.

  \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
  \param cdt the triangulation
  \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below

  \cgalNamedParamsBegin
    \cgalParamNBegin{edge_marker_map}
      \cgalParamDescription{the markers of constraints; asked for those of the domain}
      \cgalParamType{a model of `ReadablePropertyMap` with `std::pair<Vertex_handle, Vertex_handle>`, the ends of an
                     edge, as key, and values that convert to `Marker`, such as `Constraint_marker_map_2`}
      \cgalParamDefault{none: all markers are `Marker()`}
    \cgalParamNEnd
    \cgalParamNBegin{seeds}
      \cgalParamDescription{points in the holes of the domain, or in the domain}
      \cgalParamType{a range of points}
      \cgalParamDefault{none: the domain are the faces that are marked as such, or else the faces in an odd
                        number of outlines}
    \cgalParamNEnd
    \cgalParamNBegin{seeds_are_in_domain}
      \cgalParamDescription{whether the seeds lie in the domain}
      \cgalParamType{`bool`}
      \cgalParamDefault{`false`}
    \cgalParamNEnd
  \cgalNamedParamsEnd

  \throws std::invalid_argument if the triangulation has no domain, if an edge around the domain is not constrained, if
  a coordinate is not finite or beyond the magnitudes that the manual states, if a seed tells no region, or if a
  triangle has no area in `double`
  */
  template <class NamedParameters = parameters::Default_named_parameters>
  explicit Voronoi_dual_2(const CDT_& cdt, const NamedParameters& np = parameters::default_values())
    : Voronoi_dual_2(Domain_marks(checked(cdt, np), np), np)
  {}

  const std::vector<Cell>& cells() const { return m_cells; }                            ///< the cells
  const std::vector<Face>& faces() const { return m_faces; }                            ///< between cells
  const std::vector<Boundary_part>& boundary_parts() const { return m_boundary_parts; } ///< of cells

  /// returns the number of a vertex's cell, `no_cell` if no triangle of the domain has it.
  std::size_t cell_of(Vertex_handle v) const
  {
    const Index i = m_vertices(&*v);
    return i == no_index ? no_cell : m_cell_of[i];
  }

  /// returns the statistics.
  const Voronoi_quality_2& quality() const { return m_quality; }

  /// makes polygons of the cells. Beside negative faces they cross themselves, or the boundary.
  Polygon_soup polygon_soup() const
  {
    const Bubble_relaxation_2::internal::Cell_polygons_2 made(m_triangles);
    Polygon_soup soup;
    for (const auto& p : made.corners())
      soup.points.push_back(point(p.x(), p.y()));
    for (const auto& [vertex, polygon] : made.polygons()) {
      soup.polygons.push_back(polygon);
      soup.cells.push_back(m_cell_of[vertex]);
    }
    for (const Dual_face& f : m_boundary)
      for (const auto& segment : made.halves(f))
        soup.segments.push_back(segment);
    return soup;
  }

private:
  using FT = typename Kernel_traits<Point_2>::Kernel::FT;
  using Index = Bubble_relaxation_2::internal::Index;
  using Domain_marks = Bubble_relaxation_2::internal::Domain_marks_2<CDT>;
  using Dual_face = Bubble_relaxation_2::internal::Dual_face_2;
  static constexpr Index no_index = Bubble_relaxation_2::internal::no_index;

  template <class NamedParameters>
  static const CDT& checked(const CDT& cdt, const NamedParameters&)
  {
    using namespace Bubble_relaxation_2::internal;
    [[maybe_unused]] constexpr bool is_meant = check_triangulation<CDT>() && check_maps<CDT, NamedParameters>();
    return cdt;
  }

  template <class NamedParameters>
  Voronoi_dual_2(Domain_marks&& domain, const NamedParameters& np)
    : m_vertices(domain.vertices)
  {
    add_cells(domain);
    const std::vector<Dual_face> faces = Bubble_relaxation_2::internal::dual_faces(domain.tr);
    const auto marker = markers(domain, np);
    for (const Dual_face& f : faces)
      add_face(domain, f, marker(f));
    add_up_areas(faces);
    std::vector<double> areas;
    for (const Cell& c : m_cells)
      areas.push_back(c.area);
    m_quality = Bubble_relaxation_2::internal::evaluate_dual(domain, faces, areas);
    m_triangles = std::move(domain.tr);
  }

  void add_cells(const Domain_marks& domain)
  {
    using namespace Bubble_relaxation_2::internal;
    std::vector<char> is_in_domain(domain.tr.points.size(), 0);
    for (std::size_t t = 0; t < domain.tr.number_of_triangles(); ++t)
      for (int i = 0; i < 3 && domain.tr.inside[t]; ++i)
        is_in_domain[domain.tr.vertices[t][i]] = 1;
    m_cell_of.assign(is_in_domain.size(), no_cell);
    for (Index i : marked(is_in_domain)) {
      const Vertex_handle v = vertex(domain, i);
      m_cell_of[i] = m_cells.size();
      m_cells.push_back({v, Plane_2<CDT>::place(v->point()), 0, false});
    }
  }

  static Vertex_handle vertex(const Domain_marks& domain, Index i)
  {
    return Bubble_relaxation_2::internal::Handles<CDT>::vertex(domain.vertices.addresses()[i]);
  }

  /// what tells the markers of faces
  template <class NamedParameters>
  static auto markers([[maybe_unused]] const Domain_marks& domain, [[maybe_unused]] const NamedParameters& np)
  {
    using namespace Bubble_relaxation_2::internal;
    if constexpr (Is_given<NamedParameters, internal_np::edge_marker_t>::value) {
      const auto map = parameters::get_parameter(np, internal_np::edge_marker); // a copy, which may hold all markers
      using Value = typename boost::property_traits<std::decay_t<decltype(map)>>::value_type;
      static_assert(std::is_convertible<Value, Marker>::value,
                    "the second parameter of Voronoi_dual_2 must be the type of edge_marker_map's values");
      return [map, &domain](const Dual_face& f) {
        return domain.is_constrained(f.triangle, f.side)
                 ? Marker(get(map, CGAL::make_sorted_pair(vertex(domain, f.a), vertex(domain, f.b))))
                 : Marker();
      };
    } else {
      return [](const Dual_face&) { return Marker(); };
    }
  }

  /// Adds what faces give to the areas of cells, in an order that does not depend on where triangles lie in memory.
  void add_up_areas(const std::vector<Dual_face>& faces)
  {
    std::vector<std::pair<std::size_t, double>> shares;
    shares.reserve(2 * faces.size());
    for (const Dual_face& f : faces)
      for (Index v : {f.a, f.b})
        shares.emplace_back(m_cell_of[v], f.length * f.distance / 4);
    std::sort(shares.begin(), shares.end());
    for (const auto& [cell, share] : shares)
      m_cells[cell].area += share;
  }

  void add_face(const Domain_marks& domain, const Dual_face& f, const Marker& marker)
  {
    const std::size_t a = m_cell_of[f.a], b = m_cell_of[f.b];
    const Edge edge(Bubble_relaxation_2::internal::Handles<CDT>::face(domain.faces.addresses()[f.triangle]), f.side);
    m_faces.push_back({a, b, f.length, f.left, f.right, f.distance, beside(f, 0, (f.left - f.right) / 2),
                       vector(f.along.x, f.along.y), edge, !f.has_right,
                       domain.is_constrained(f.triangle, f.side), marker});
    if (f.has_right)
      return;
    m_boundary.push_back(f);
    for (std::size_t cell : {a, b}) {
      m_cells[cell].is_on_boundary = true;
      const Point_2 midpoint = beside(f, (cell == a ? -f.distance : f.distance) / 4, 0);
      m_boundary_parts.push_back({cell, f.distance / 2, midpoint, vector(f.along.y, -f.along.x), edge, marker});
    }
  }

  /// a point near the midpoint of an edge: farther along, and to the left
  static Point_2 beside(const Dual_face& f, double along, double left)
  {
    return point(f.middle.x() + along * f.along.x - left * f.along.y,
                 f.middle.y() + along * f.along.y + left * f.along.x);
  }

  static Point_2 point(double x, double y) { return Point_2(FT(x), FT(y)); }
  static Vector_2 vector(double x, double y) { return Vector_2(FT(x), FT(y)); }

  Bubble_relaxation_2::internal::Address_numbers m_vertices;
  Bubble_relaxation_2::internal::Flat_triangulation_2 m_triangles;
  std::vector<Dual_face> m_boundary;  // the faces of boundary edges
  std::vector<std::size_t> m_cell_of; // of each vertex of the triangulation
  std::vector<Cell> m_cells;
  std::vector<Face> m_faces;
  std::vector<Boundary_part> m_boundary_parts;
  Voronoi_quality_2 m_quality;
};

} // namespace CGAL

#include <CGAL/Bubble_relaxation_2/internal/core/enable_warnings.h>

#endif // CGAL_VORONOI_DUAL_2_H
