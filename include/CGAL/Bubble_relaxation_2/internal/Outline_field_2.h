// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_OUTLINE_FIELD_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_OUTLINE_FIELD_2_H

#include <CGAL/Bubble_relaxation_2/internal/Bubble_mesh_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Domain_reading_2.h>
#include <CGAL/Bubble_relaxation_2/internal/place_on_edges.h>

#include <CGAL/Bbox_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// A place on the outline of a domain and the size that is wanted there.
struct Size_source_2
{
  Point point;
  double d;
};

/// The size d(x) = min over all sources s of d_s + g |x - s|, which grows by no more than g per unit.
///
/// A quadtree holds in each leaf the few sources that are the least somewhere in it, so a query does not
/// look at all of them; where there would be many, d may be a little too large. The result depends neither
/// on the order of the sources nor on former queries.
class Outline_field_2
{
public:
  static constexpr double gradation = 0.2;

  Outline_field_2(const std::vector<Size_source_2>& sources, const Bbox_2& box)
    : m_x(0.5 * (box.xmin() + box.xmax())), m_y(0.5 * (box.ymin() + box.ymax())),
      m_half_side(0.5 * (std::max)(box.xmax() - box.xmin(), box.ymax() - box.ymin()))
  {
    m_cells.emplace_back();
    build(0, m_x, m_y, m_half_side, sources, 0);
  }

  double operator()(double x, double y) const
  {
    std::size_t cell = 0;
    double cx = m_x, cy = m_y;
    for (double half = 0.5 * m_half_side; m_cells[cell].first_child != 0; half *= 0.5) {
      const bool is_right = x >= cx, is_upper = y >= cy;
      cell = m_cells[cell].first_child + is_right + 2 * is_upper;
      cx += is_right ? half : -half;
      cy += is_upper ? half : -half;
    }
    const std::vector<Size_source_2>& sources = m_cells[cell].sources;
    double least = size_from(sources.front(), x, y);
    for (const Size_source_2& s : sources)
      least = (std::min)(least, size_from(s, x, y));
    return least;
  }

  double operator()(const Point& p) const { return (*this)(p.x(), p.y()); }

private:
  static constexpr std::size_t most_sources = 8; // in a leaf
  static constexpr int deepest = 40;

  struct Cell
  {
    std::size_t first_child = 0; // the others follow; 0 in a leaf
    std::vector<Size_source_2> sources;
  };

  static double size_from(const Size_source_2& s, double x, double y)
  {
    const double dx = x - s.point.x(), dy = y - s.point.y();
    return s.d + gradation * std::sqrt(dx * dx + dy * dy);
  }

  static const Size_source_2& nearest(const std::vector<Size_source_2>& sources, double x, double y)
  {
    const Size_source_2* best = &sources.front();
    for (const Size_source_2& s : sources) {
      const double d = size_from(s, x, y), least = size_from(*best, x, y);
      if (d < least || (d == least && s.point < best->point))
        best = &s;
    }
    return *best;
  }

  void build(std::size_t cell, double x, double y, double half,
             const std::vector<Size_source_2>& sources, int depth)
  {
    // within the cell two sources cannot change their order if they differ by more than this
    const double slack = 2 * gradation * std::sqrt(2.) * half;
    const double least = size_from(nearest(sources, x, y), x, y);
    std::vector<Size_source_2> kept;
    std::copy_if(sources.begin(), sources.end(), std::back_inserter(kept),
                 [&](const Size_source_2& s) { return size_from(s, x, y) <= least + slack; });
    if (kept.size() <= most_sources) {
      m_cells[cell].sources = std::move(kept);
      return;
    }
    // far from a finely divided outline many sources stay, but d hardly changes within the cell
    if (slack <= 0.5 * least || depth == deepest) {
      for (int k = 0; k < 9; ++k)
        m_cells[cell].sources.push_back(
          nearest(kept, x + (k % 3 - 1) * half, y + (k / 3 - 1) * half));
      return;
    }
    const std::size_t first = m_cells.size();
    m_cells[cell].first_child = first;
    m_cells.resize(first + 4);
    for (int k = 0; k < 4; ++k)
      build(first + k, x + ((k & 1) != 0 ? 0.5 : -0.5) * half, y + ((k & 2) != 0 ? 0.5 : -0.5) * half,
            0.5 * half, kept, depth + 1);
  }

  double m_x, m_y, m_half_side; // of the root
  std::vector<Cell> m_cells;
};

/// Finds the sizes that the outline of a domain asks for: at each vertex of a constraint the length of the
/// shorter constraint beside it, and less where the domain is narrower than that.
template <class Cdt>
class Outline_sizes_2
{
  using Reading = Domain_reading_2<Cdt>;

public:
  explicit Outline_sizes_2(const Reading& reading)
    : m_reading(reading), m_domain(reading.domain),
      m_corner_sizes(m_domain.corners().size(), extent())
  {}

  std::vector<Size_source_2> operator()()
  {
    for (const auto& chain : m_reading.graph->chains())
      add_chain(chain);
    for (std::size_t c = 0; c < m_corner_sizes.size(); ++c)
      add(m_domain.corners()[c], m_corner_sizes[c]);
    // along a constraint that is long in comparison to the width of the domain each turn measures the
    // width in more places
    std::size_t last = 0;
    for (int turn = 0; turn < 4 && m_sources.size() > last; ++turn) {
      last = m_sources.size();
      add_widths();
    }
    return std::move(m_sources);
  }

private:
  /// Without these two limits a slit, or two vertices that almost coincide, would ask for bubbles without
  /// number: the least share of a constraint's length, and of the domain's extent.
  static constexpr double least_share = 0.125, least_size = 1e-6;

  double extent() const
  {
    const Bbox_2& box = m_domain.bbox();
    return (std::max)(box.xmax() - box.xmin(), box.ymax() - box.ymin());
  }

  void add(const Point& p, double d)
  {
    m_sources.push_back(Size_source_2{p, (std::max)(d, least_size * extent())});
  }

  /// the pieces of a constraint between its vertices
  template <class Chain>
  void add_chain(const Chain& chain)
  {
    std::vector<Point> path(1, m_domain.corners()[chain.source]);
    for (const auto v : chain.splits)
      path.push_back(Reading::Graph::to_point(v));
    path.push_back(m_domain.corners()[chain.target]);
    double last = extent();
    for (std::size_t k = 1; k < path.size(); ++k) {
      const double length = std::sqrt(CGAL::squared_distance(path[k - 1], path[k]));
      if (k > 1)
        add(path[k - 1], (std::min)(last, length));
      else
        limit(chain.source, length);
      last = length;
    }
    limit(chain.target, last);
  }

  void limit(Index corner, double d)
  {
    m_corner_sizes[corner] = (std::min)(m_corner_sizes[corner], d);
  }

  /// divides the constraints by the sizes found so far, and measures across the triangles between them
  void add_widths()
  {
    const Outline_field_2 field(m_sources, m_domain.bbox());
    const Bubbles_2 nodes = nodes_on_constraints(field);
    std::vector<Point> points;
    for (std::size_t i = 0; i < nodes.size(); ++i)
      points.push_back(nodes.point(i));
    Marked_triangulation_2 mesh;
    if (mark_triangulation(points, cut_edges(m_domain, nodes), mesh) != Marking_error::NONE)
      return; // rounded across each other: there is nothing to measure
    for (std::size_t t = 0; t < mesh.inside.size(); ++t)
      for (int i = 0; i < 3; ++i)
        if (mesh.inside[t] && mesh.edges[t][i] != no_index)
          add_width(mesh, static_cast<Index>(t), i, least_width(nodes, mesh.tr.vertices[t][i]), field);
  }

  Bubbles_2 nodes_on_constraints(const Outline_field_2& field) const
  {
    Bubbles_2 nodes;
    for (std::size_t c = 0; c < m_corner_sizes.size(); ++c)
      nodes.add(m_domain.corners()[c], m_corner_sizes[c], Bubbles_2::CORNER, static_cast<Index>(c));
    for (std::size_t e = 0; e < m_domain.edges().size(); ++e)
      place_on_edge(m_domain, static_cast<Index>(e), field, nodes);
    remove_coincident(m_domain, nodes);
    return nodes;
  }

  double least_width(const Bubbles_2& nodes, Index i) const
  {
    if (nodes.is_corner(i))
      return least_share * m_corner_sizes[nodes.place[i]];
    const Domain_edge_2& e = m_domain.edges()[nodes.place[i]];
    return least_share * (std::min)(m_corner_sizes[e.source], m_corner_sizes[e.target]);
  }

  /// the distance of the vertex `i` of a triangle from the constraint opposite to it
  void add_width(const Marked_triangulation_2& mesh, Index t, int i, double least,
                 const Outline_field_2& field)
  {
    const Point &p = mesh.tr.point(t, i), &a = mesh.tr.point(t, ccw(i)), &b = mesh.tr.point(t, cw(i));
    const Kernel::Vector_2 u = b - a;
    const double s = ((p - a) * u) / (u * u);
    // along a constraint there is no width
    if ((s <= 0 && mesh.edges[t][cw(i)] != no_index) || (s >= 1 && mesh.edges[t][ccw(i)] != no_index))
      return;
    const Point foot = a + (std::max)(0., (std::min)(1., s)) * u;
    const double width = (std::max)(std::sqrt(CGAL::squared_distance(p, foot)), least);
    for (const Point& end : {p, foot})
      if (width < field(end))
        add(end, width);
  }

  const Reading& m_reading;
  const Domain_2& m_domain;
  std::vector<double> m_corner_sizes; // the shortest constraint at each
  std::vector<Size_source_2> m_sources;
};

/// The size for a domain that has no mesh yet.
template <class Cdt>
Outline_field_2 outline_field(const Domain_reading_2<Cdt>& reading)
{
  return Outline_field_2(Outline_sizes_2<Cdt>(reading)(), reading.domain.bbox());
}

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_OUTLINE_FIELD_2_H
