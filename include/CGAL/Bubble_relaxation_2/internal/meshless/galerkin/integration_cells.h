// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_GALERKIN_INTEGRATION_CELLS_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_GALERKIN_INTEGRATION_CELLS_H

#include <CGAL/Bubble_relaxation_2/internal/meshless/galerkin/Integration_domain_2.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// Points and weights on [0, 1].
struct Gauss_rule
{
  std::vector<double> points, weights;

  std::size_t size() const { return points.size(); }
};

/// Gauss's rule of `n` points for the weight function (1 - t)^exponent on [0, 1]: exact for polynomials up to
/// degree 2 n - 1. `exponent` is 0 (Legendre) or 1, which is what collapses a square to a triangle.
/// The points are the eigenvalues of the tridiagonal matrix of the three-term recurrence of the orthogonal
/// (Jacobi) polynomials (Golub and Welsch, Math. Comp. 23, 1969).
inline Gauss_rule gauss_rule(std::size_t n, int exponent = 0)
{
  const auto size = static_cast<Eigen::Index>(n);
  Eigen::VectorXd diagonal = Eigen::VectorXd::Zero(size), beside(size > 1 ? size - 1 : 0);
  for (Eigen::Index k = 0; k < size; ++k) {
    const double i = static_cast<double>(k), j = i + 1;
    if (exponent == 1)
      diagonal[k] = -1 / ((2 * i + 1) * (2 * i + 3));
    if (j < static_cast<double>(n))
      beside[k] = exponent == 1 ? std::sqrt(j * (j + 1)) / (2 * j + 1) : j / std::sqrt(4 * j * j - 1);
  }
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver;
  solver.computeFromTridiagonal(diagonal, beside);
  Gauss_rule rule;
  for (Eigen::Index k = 0; k < size; ++k) {
    const double first = solver.eigenvectors()(0, k);
    rule.points.push_back((1 + solver.eigenvalues()[k]) / 2);
    rule.weights.push_back(first * first / (exponent + 1));
  }
  return rule;
}

/// A cell of integration: the triangle or the parallelogram that two vectors span from a corner.
struct Background_cell_2
{
  double x, y;   ///< the corner
  double ux, uy; ///< the vectors
  double vx, vy;
  bool is_triangle;

  double area() const { return std::abs(ux * vy - uy * vx) * (is_triangle ? 0.5 : 1.); }
};

/// Gauss's rules for cells, with `n` points in each direction: exact for polynomials of degree 2 n - 1, on
/// parallelograms in each direction. The rule for triangles is the one for the square with a side collapsed.
class Cell_quadrature_2
{
public:
  explicit Cell_quadrature_2(std::size_t n) : m_along(gauss_rule(n)), m_collapsed(gauss_rule(n, 1)) {}

  std::size_t points_per_cell() const { return m_along.size() * m_along.size(); }

  /// calls `visit(x, y, weight)` for all points of the cell
  template <class Visitor>
  void for_each_point(const Background_cell_2& cell, const Visitor& visit) const
  {
    const double jacobian = std::abs(cell.ux * cell.vy - cell.uy * cell.vx);
    const Gauss_rule& across = cell.is_triangle ? m_collapsed : m_along;
    for (std::size_t i = 0; i < across.size(); ++i)
      for (std::size_t j = 0; j < m_along.size(); ++j) {
        const double s = across.points[i];
        const double t = m_along.points[j] * (cell.is_triangle ? 1 - s : 1.);
        visit(cell.x + s * cell.ux + t * cell.vx, cell.y + s * cell.uy + t * cell.vy,
              jacobian * across.weights[i] * m_along.weights[j]);
      }
  }

private:
  Gauss_rule m_along, m_collapsed;
};

/// the size of the nodes around a place
using Size_at = std::function<double(const Point&)>;

/// The longest side that a cell may have, in units of the size of the nodes around. The triangles of a mesh of
/// the nodes have shorter ones.
constexpr double largest_cell_side = 1.75;

/// a point in the middle that does not depend on the order of both
inline Point middle(const Point& a, const Point& b) { return Point((a.x() + b.x()) / 2, (a.y() + b.y()) / 2); }

/// The most cells that a number of nodes may have, besides given triangles, a thousand for each and a million more:
/// so many are no mesh, but sizes in other units than the coordinates.
inline std::size_t most_cells(std::size_t number_of_nodes) { return 1000 * (number_of_nodes + 1000); }

[[noreturn]] inline void throw_too_many_cells(std::size_t most)
{
  throw std::length_error("Bubble_relaxation_2: parameter nodes: their sizes ask for more than " +
                          std::to_string(most) + " cells of integration: some are too small for the domain, or in "
                          "another unit");
}

/// Cuts a triangle in two at the middle of its longest side, and the parts again, until they are small against
/// the sizes of the nodes, `size_at(point)`. Longest sides keep the angles of the parts bounded; that the parts
/// do not fit together at their sides does not matter to integrals.
inline void add_triangle_cells(std::array<Point, 3> t, const Size_at& size_at, std::size_t most,
                               std::vector<Background_cell_2>& cells)
{
  std::vector<std::array<Point, 3>> stack(1, t);
  while (!stack.empty()) {
    if (cells.size() >= most)
      throw_too_many_cells(most);
    t = stack.back();
    stack.pop_back();
    int longest = 0; // opposite to this vertex
    double square[3];
    for (int i = 0; i < 3; ++i) {
      square[i] = CGAL::squared_distance(t[ccw(i)], t[cw(i)]);
      longest = square[i] > square[longest] ? i : longest;
    }
    const Point m = middle(t[ccw(longest)], t[cw(longest)]);
    if (std::sqrt(square[longest]) > largest_cell_side * size_at(m)) {
      stack.push_back({t[longest], m, t[cw(longest)]});
      stack.push_back({t[longest], t[ccw(longest)], m});
    } else {
      cells.push_back(Background_cell_2{t[0].x(), t[0].y(), t[1].x() - t[0].x(), t[1].y() - t[0].y(),
                                        t[2].x() - t[0].x(), t[2].y() - t[0].y(), true});
    }
  }
}

/// The triangles of the domain as cells: those of a mesh as they are, larger ones in parts.
/// \throws std::length_error if there are more than `most` of them and the triangles
inline std::vector<Background_cell_2> triangle_cells(const Integration_domain_2& domain, const Size_at& size_at,
                                                     std::size_t most)
{
  std::vector<Background_cell_2> cells;
  for (const auto& t : domain.triangles)
    add_triangle_cells(t, size_at, most + domain.triangles.size(), cells);
  return cells;
}

/// The rectangles of a regular grid over the bounding box of a domain, as far as they lie in it: those inside as
/// they are, the others as the triangles of their parts inside. So the cells fill the domain, up to rounding.
class Grid_cells_2
{
public:
  Grid_cells_2(const Integration_domain_2& domain, std::size_t nx, std::size_t ny)
    : m_bbox(domain.bbox), m_nx(nx), m_ny(ny), m_parts(nx * ny)
  {
    for (const auto& t : domain.triangles)
      clip(t);
  }

  std::vector<Background_cell_2> cells() const
  {
    std::vector<Background_cell_2> result;
    for (std::size_t j = 0; j < m_ny; ++j)
      for (std::size_t i = 0; i < m_nx; ++i) {
        const Background_cell_2 whole{x(i), y(j), x(i + 1) - x(i), 0, 0, y(j + 1) - y(j), false};
        const std::vector<Background_cell_2>& parts = m_parts[j * m_nx + i];
        double area = 0;
        for (const Background_cell_2& part : parts)
          area += part.area();
        if (area > (1 - 1e-10) * whole.area()) // the sum of what rounded cuts leave of a whole rectangle
          result.push_back(whole);
        else
          result.insert(result.end(), parts.begin(), parts.end());
      }
    return result;
  }

  /// appends the places in (0, 1) where the segment from `a` to `b` crosses lines of the grid, sorted
  void crossings(const Point& a, const Point& b, std::vector<double>& places) const
  {
    for (std::size_t i = 1; i < m_nx; ++i)
      add_crossing(a.x(), b.x(), x(i), places);
    for (std::size_t j = 1; j < m_ny; ++j)
      add_crossing(a.y(), b.y(), y(j), places);
    std::sort(places.begin(), places.end());
  }

private:
  using Polygon = std::vector<Point>;

  static double line(double min, double max, std::size_t i, std::size_t n)
  {
    return i == n ? max : min + (max - min) * (static_cast<double>(i) / static_cast<double>(n));
  }

  double x(std::size_t i) const { return line(m_bbox.xmin(), m_bbox.xmax(), i, m_nx); }
  double y(std::size_t j) const { return line(m_bbox.ymin(), m_bbox.ymax(), j, m_ny); }

  static void add_crossing(double from, double to, double line, std::vector<double>& places)
  {
    if ((from < line && line < to) || (to < line && line < from))
      places.push_back((line - from) / (to - from));
  }

  /// the first line of the grid below a coordinate, or at it
  static std::size_t cell(double min, double max, double value, std::size_t n)
  {
    const double place = std::floor((value - min) / (max - min) * static_cast<double>(n));
    return static_cast<std::size_t>((std::min)((std::max)(place, 0.), static_cast<double>(n - 1)));
  }

  /// adds a triangle's parts to all rectangles that its bounding box meets
  void clip(const std::array<Point, 3>& t)
  {
    const Bbox_2 box = t[0].bbox() + t[1].bbox() + t[2].bbox();
    const std::size_t right = cell(m_bbox.xmin(), m_bbox.xmax(), box.xmax(), m_nx);
    const std::size_t top = cell(m_bbox.ymin(), m_bbox.ymax(), box.ymax(), m_ny);
    for (std::size_t j = cell(m_bbox.ymin(), m_bbox.ymax(), box.ymin(), m_ny); j <= top; ++j) {
      const Polygon row = below(above({t.begin(), t.end()}, y(j), true), y(j + 1), true);
      for (std::size_t i = cell(m_bbox.xmin(), m_bbox.xmax(), box.xmin(), m_nx); i <= right; ++i)
        add(below(above(row, x(i), false), x(i + 1), false), m_parts[j * m_nx + i]);
    }
  }

  /// a convex polygon as triangles
  static void add(const Polygon& p, std::vector<Background_cell_2>& parts)
  {
    for (std::size_t k = 2; k < p.size(); ++k) {
      const Background_cell_2 part{p[0].x(), p[0].y(), p[k - 1].x() - p[0].x(), p[k - 1].y() - p[0].y(),
                                   p[k].x() - p[0].x(), p[k].y() - p[0].y(), true};
      if (part.area() > 0)
        parts.push_back(part);
    }
  }

  static Polygon above(const Polygon& p, double line, bool is_y) { return cut(p, line, is_y, 1); }
  static Polygon below(const Polygon& p, double line, bool is_y) { return cut(p, line, is_y, -1); }

  /// the part of a convex polygon on one side of a line (Sutherland and Hodgman)
  static Polygon cut(const Polygon& polygon, double line, bool is_y, double sign)
  {
    const auto height = [&](const Point& p) { return sign * ((is_y ? p.y() : p.x()) - line); };
    Polygon result;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      const Point &p = polygon[k], &q = polygon[(k + 1) % polygon.size()];
      const double hp = height(p), hq = height(q);
      if (hp >= 0)
        result.push_back(p);
      if ((hp > 0 && hq < 0) || (hp < 0 && hq > 0)) {
        const double s = hp / (hp - hq);
        result.push_back(is_y ? Point(p.x() + s * (q.x() - p.x()), line)
                              : Point(line, p.y() + s * (q.y() - p.y())));
      }
    }
    return result;
  }

  Bbox_2 m_bbox;
  std::size_t m_nx, m_ny;
  std::vector<std::vector<Background_cell_2>> m_parts; // of each rectangle, row after row
};

/// A cell of integration on the boundary: the part from `begin` to `end`, in [0, 1], of an edge.
struct Boundary_segment_2
{
  std::size_t edge;
  double begin, end;
};

/// the point that divides an edge at `s` in [0, 1]
inline Point point_on(const Boundary_edge_2& e, double s)
{
  return Point(e.a.x() + s * (e.b.x() - e.a.x()), e.a.y() + s * (e.b.y() - e.a.y()));
}

/// The edges of the boundary, halved until the parts are small against the sizes of the nodes.
/// \throws std::length_error if there are more than `most` of them and the edges
inline std::vector<Boundary_segment_2> halved_boundary(const Integration_domain_2& domain, const Size_at& size_at,
                                                       std::size_t most)
{
  std::vector<Boundary_segment_2> segments, stack;
  for (std::size_t e = 0; e < domain.boundary.size(); ++e) {
    const Boundary_edge_2& edge = domain.boundary[e];
    stack.push_back(Boundary_segment_2{e, 0, 1});
    while (!stack.empty()) {
      if (segments.size() >= most + domain.boundary.size())
        throw_too_many_cells(most);
      const Boundary_segment_2 s = stack.back();
      stack.pop_back();
      const double m = (s.begin + s.end) / 2;
      if ((s.end - s.begin) * edge.length() > largest_cell_side * size_at(point_on(edge, m))) {
        stack.push_back(Boundary_segment_2{e, m, s.end});
        stack.push_back(Boundary_segment_2{e, s.begin, m});
      } else {
        segments.push_back(s);
      }
    }
  }
  return segments;
}

/// The edges of the boundary, cut where lines of the grid cross them.
inline std::vector<Boundary_segment_2> cut_boundary(const Integration_domain_2& domain, const Grid_cells_2& grid)
{
  constexpr double shortest = 1e-10; // of an edge: below are roundings of one crossing
  std::vector<Boundary_segment_2> segments;
  std::vector<double> places;
  for (std::size_t e = 0; e < domain.boundary.size(); ++e) {
    places.clear();
    grid.crossings(domain.boundary[e].a, domain.boundary[e].b, places);
    double last = 0;
    for (double s : places)
      if (s - last > shortest && 1 - s > shortest) {
        segments.push_back(Boundary_segment_2{e, last, s});
        last = s;
      }
    segments.push_back(Boundary_segment_2{e, last, 1});
  }
  return segments;
}

/// calls `visit(s, x, y, weight)` for the points of Gauss's rule on a segment, where s in [0, 1] is the place on
/// the edge
template <class Visitor>
void for_each_point(const Boundary_edge_2& edge, const Boundary_segment_2& segment, const Gauss_rule& rule,
                    const Visitor& visit)
{
  const double part = segment.end - segment.begin, length = part * edge.length();
  for (std::size_t k = 0; k < rule.size(); ++k) {
    const double s = segment.begin + part * rule.points[k];
    const Point p = point_on(edge, s);
    visit(s, p.x(), p.y(), length * rule.weights[k]);
  }
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_GALERKIN_INTEGRATION_CELLS_H
