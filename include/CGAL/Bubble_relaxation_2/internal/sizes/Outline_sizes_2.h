// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_SIZES_OUTLINE_SIZES_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_SIZES_OUTLINE_SIZES_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/Progress.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Sizes_2.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_2.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Problem_2.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/outline.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/place_on_edges.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/remove_coincident.h>
#include <CGAL/Bubble_relaxation_2/internal/sizes/Outline_field_2.h>
#include <CGAL/Bubble_relaxation_2/internal/sizes/expected_number_of_bubbles.h>

#include <CGAL/Bbox_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

inline double extent(const Domain_2& domain)
{
  return (std::max)(domain.bbox().x_span(), domain.bbox().y_span());
}

/// Two vertices that almost coincide would ask for bubbles without number: no size is a smaller share of the extent,
/// nor less than about a step of coordinates, since bubbles that are smaller would round to one place by the thousands.
inline double smallest_size(const Domain_2& domain)
{
  constexpr double smallest_share = 1e-12;
  const Bbox_2& box = domain.bbox();
  const double farthest =
    (std::max)({std::abs(box.xmin()), std::abs(box.xmax()), std::abs(box.ymin()), std::abs(box.ymax())});
  const double least_step = 0.5 * std::numeric_limits<double>::epsilon() * farthest;
  return (std::max)(smallest_share * extent(domain), least_step);
}

/// At each vertex of a constraint the length of the shorter constraint beside it. `splits`: what counts as vertices of
/// edges between their ends, if anything
inline std::vector<Size_source_2> sizes_of_pieces(const Domain_2& domain,
                                                  const std::vector<std::vector<Point>>* splits = nullptr)
{
  const double smallest = smallest_size(domain);
  std::vector<Size_source_2> result;
  for (const Point& p : domain.corners())
    result.push_back(Size_source_2{p, extent(domain)});
  for (std::size_t e = 0; e < domain.edges().size(); ++e) {
    const Domain_edge_2& edge = domain.edges()[e];
    std::size_t last = static_cast<std::size_t>(edge.source);
    const auto add_piece_to = [&](std::size_t next) {
      const double length = std::sqrt(CGAL::squared_distance(result[last].point, result[next].point));
      for (std::size_t end : {last, next})
        result[end].d = (std::min)(result[end].d, (std::max)(length, smallest));
      last = next;
    };
    if (splits != nullptr)
      for (const Point& p : (*splits)[e]) {
        result.push_back(Size_source_2{p, extent(domain)});
        add_piece_to(result.size() - 1);
      }
    add_piece_to(static_cast<std::size_t>(edge.target));
  }
  return result;
}

/// at each corner the length of the shortest edge of a kind, infinite where there is none
inline std::vector<double> lengths_at_corners(const Domain_2& domain, Edge_kind kind)
{
  std::vector<double> length(domain.corners().size(), std::numeric_limits<double>::infinity());
  for (std::size_t e = 0; e < domain.edges().size(); ++e)
    if (const Domain_edge_2& edge = domain.edges()[e]; edge.kind == kind)
      for (Index end : {edge.source, edge.target})
        length[end] = (std::min)(length[end], domain.length(static_cast<Index>(e)));
  return length;
}

/// Sizes that are no less than at some places, of which there are some: from there they shrink by `growth` per unit of
/// length.
inline Sizes_2 raise_around(std::vector<Size_source_2> places, const Sizes_2& sizes, const Bbox_2& box, double growth)
{
  double largest = 0;
  for (const Size_source_2& s : places)
    largest = (std::max)(largest, s.d);
  for (Size_source_2& s : places) // the largest of d_s - g |x - s| is less than the largest of all by the least of these
    s.d = largest - s.d;
  Outline_field_2 less(places, box, growth);
  return Sizes_2([sizes, less = std::move(less), largest](double x, double y) {
    return (std::max)(sizes(x, y), largest - less(x, y));
  });
}

/// An edge that is longer than so many times the size makes needles.
constexpr double longest_without_needles = 1.25;

/// The wanted sizes, and larger ones beside edges of a kind that takes no bubbles and that are far longer: from there they
/// shrink by no more than `growth` per unit of length, else triangles at these edges would be needles. Silent corners
/// do not count.
inline Sizes_2 raise_beside_edges(const Domain_2& domain, const Given_mesh_2& given, const Sizes_2& wanted,
                                  Edge_kind kind, double growth)
{
  const std::vector<double> length = lengths_at_corners(domain, kind);
  std::vector<Size_source_2> places;
  for (std::size_t c = 0; c < length.size(); ++c) {
    const Point& p = domain.corners()[c];
    if (!std::isinf(length[c]) && length[c] > longest_without_needles * wanted(p) &&
        !std::binary_search(given.silent_corners.begin(), given.silent_corners.end(), p))
      places.push_back(Size_source_2{p, length[c]});
  }
  return places.empty() ? wanted : raise_around(std::move(places), wanted, domain.bbox(), growth);
}

/// The sizes, and larger ones along protected edges that are far longer than these in the middle, though at their ends
/// there is something short: bubbles would come to lie on an edge that has none to push them off.
inline Sizes_2 raise_along_protected(const Domain_2& domain, const Sizes_2& sizes, double growth)
{
  std::vector<Size_source_2> places;
  for (std::size_t k = 0; k < domain.edges().size(); ++k) {
    if (domain.edges()[k].kind != Edge_kind::PROTECTED)
      continue;
    const Index e = static_cast<Index>(k);
    const double length = domain.length(e),
                 at_ends = (std::min)(sizes(domain.source(e)), sizes(domain.target(e))),
                 size = (std::min)(length, at_ends + 0.5 * growth * length); // which raises none at the ends
    const Point middle = domain.point_on_edge(e, 0.5);
    if (size > longest_without_needles * sizes(middle))
      places.push_back(Size_source_2{middle, size});
  }
  return places.empty() ? sizes : raise_around(std::move(places), sizes, domain.bbox(), growth);
}

/// The wanted sizes, and smaller ones where the outline asks for it.
class Limited_sizes_2
{
public:
  /// `growth`: how fast sizes grow away from sources
  Limited_sizes_2(const Sizes_2& wanted, const Bbox_2& box, double growth)
    : m_wanted(wanted), m_box(box), m_growth(growth), m_sizes(wanted)
  {}

  const Sizes_2& sizes() const { return m_sizes; }
  const Sizes_2& wanted() const { return m_wanted; }
  bool is_limited() const { return m_field.has_value(); }

  void add(const std::vector<Size_source_2>& more)
  {
    if (more.empty())
      return;
    if (is_limited())
      m_field->add(more);
    else
      m_field.emplace(more, m_box, m_growth);
    m_sizes = smaller_of(m_wanted, Sizes_2(*m_field));
  }

private:
  const Sizes_2 m_wanted;
  const Bbox_2 m_box;
  const double m_growth;
  std::optional<Outline_field_2> m_field;
  Sizes_2 m_sizes;
};

/// Finds where the outline of a domain asks for smaller sizes than the user: in units of the size that is followed
/// there, no piece of it, no pinned vertex's distance from others and no width of the domain is to be less than .9. Only
/// in a corner between two edges there is no width: however sharp it is, smaller triangles are no better in it,
/// only beside the chord where it was cut off.
class Outline_sizes_2
{
public:
  /// A crack that is narrower than this share of what is wanted has no room for triangles: its sides count as touching.
  static constexpr double narrowest = 1e-6;

  /// `maximum`: of bubbles; `limited`: the sizes that are followed, which are made smaller
  Outline_sizes_2(const Domain_2& domain, const Given_mesh_2& given, std::size_t maximum, Limited_sizes_2& limited)
    : m_domain(domain), m_given(given), m_maximum(maximum), m_limited(limited)
  {}

  /// Asks for sizes that are smaller than chords where a sharp corner was cut off. A chord is not divided, and makes an
  /// obtuse angle with the edge at each end, which two triangles have to share: for that bubbles as large as the chord have
  /// no room.
  void add_chords(const std::vector<Kernel::Segment_2>& chords)
  {
    constexpr double share = 0.6;
    for (const Kernel::Segment_2& chord : chords)
      limit(CGAL::midpoint(chord), share * std::sqrt(chord.squared_length()));
  }

  /// `turns`: along a constraint that is long in comparison to the width of the domain each turn measures the width in
  /// more places
  /// \throws std::length_error if too many bubbles are asked for on edges alone
  void operator()(int turns)
  {
    for (const Size_source_2& s : sizes_of_pieces(m_domain))
      if (!is_silent(s.point))
        limit(s.point, s.d);
    bool is_found = true;
    for (int turn = 0; turn < turns && is_found; ++turn) {
      m_limited.add(m_found);
      m_found.clear();
      // along a crack each turn asks for ten times as many
      count_bubbles_on_edges(m_domain, m_maximum, m_limited.sizes());
      add_widths();
      is_found = !m_found.empty();
    }
    m_limited.add(m_found);
  }

private:
  /// One row of triangles in a channel is hardly worse when it is a little lower than it should be.
  static constexpr double tolerated = 1.1;

  /// Sizes that differ by less are left alone: else each turn would find many that are a little smaller.
  static constexpr double notable = 0.9;

  bool is_silent(const Point& p) const
  {
    return std::binary_search(m_given.silent_corners.begin(), m_given.silent_corners.end(), p);
  }

  void limit(const Point& p, double distance)
  {
    const double d = tolerated * distance;
    if (d < notable * m_limited.sizes()(p))
      m_found.push_back(Size_source_2{p, (std::max)(d, smallest_size(m_domain))});
  }

  /// divides the constraints by the sizes found so far, and measures across the triangles between them
  void add_widths()
  {
    const Bubbles_2 nodes = nodes_on_constraints();
    Marked_triangulation_2 mesh;
    if (mark_triangulation(points_of(nodes), cut_edges(m_domain, nodes), mesh) != Marking_error::NONE)
      return; // rounded across each other: there is nothing to measure
    for (std::size_t t = 0; t < mesh.inside.size(); ++t) {
      tick(t);
      for (int i = 0; i < 3 && mesh.inside[t]; ++i) {
        const auto& v = mesh.vertices[t];
        if (mesh.edges[t][i] == no_index)
          add_distance(nodes, v[ccw(i)], v[cw(i)]);
        else if (!is_in_corner(nodes, v[i], v[ccw(i)], v[cw(i)]))
          add_width(nodes, mesh, static_cast<Index>(t), i);
      }
    }
  }

  Bubbles_2 nodes_on_constraints() const
  {
    Bubbles_2 nodes;
    for (std::size_t c = 0; c < m_domain.corners().size(); ++c)
      nodes.add(m_domain.corners()[c], extent(m_domain), Bubbles_2::CORNER, static_cast<Index>(c));
    for (const Point& p : m_given.pinned)
      nodes.add(p, extent(m_domain), Bubbles_2::CORNER, no_index);
    for (std::size_t e = 0; e < m_domain.edges().size(); ++e) {
      tick(e);
      place_on_edge(m_domain, static_cast<Index>(e), m_limited.sizes(), nodes);
    }
    remove_coincident(m_domain, nodes);
    sort_in_space(m_domain, nodes); // else the triangulation takes the square of the nodes of a long edge
    return nodes;
  }

  static bool is_pin(const Bubbles_2& nodes, Index i) { return nodes.host[i] == no_index; }

  /// the distance of a pinned vertex from another one or from a corner
  void add_distance(const Bubbles_2& nodes, Index i, Index j)
  {
    if (!nodes.is_corner(i) || !nodes.is_corner(j) || !(is_pin(nodes, i) || is_pin(nodes, j)))
      return;
    const Point p = nodes.point(i), q = nodes.point(j);
    if (is_silent(p) || is_silent(q))
      return;
    for (const Point& end : {p, q})
      limit(end, std::sqrt(CGAL::squared_distance(p, q)));
  }

  /// whether a node and the side from `p` to `q` lie on two edges that meet in a corner
  bool is_in_corner(const Bubbles_2& nodes, Index node, Index p, Index q) const
  {
    const Domain_edge_2& side = m_domain.edges()[edge_of_piece(m_domain, nodes, p, q)];
    const std::array<Index, 2> corners = ends(nodes, node);
    return std::any_of(corners.begin(), corners.end(), [&side](Index c) { return c == side.source || c == side.target; });
  }

  /// whether a side is a constraint that stays and is so much longer than `width` that bubbles of that size would only
  /// make a fan of needles on it
  bool is_too_long(const Bubbles_2& nodes, Index p, Index q, double width) const
  {
    constexpr double far_longer = 1.5;
    const Index e = edge_of_piece(m_domain, nodes, p, q);
    return m_domain.edges()[e].kind == Edge_kind::PROTECTED && m_domain.length(e) > far_longer * width;
  }

  /// the corners at the ends of the edge that a node lies on; none of a pinned vertex
  std::array<Index, 2> ends(const Bubbles_2& nodes, Index i) const
  {
    if (nodes.is_corner(i))
      return {nodes.host[i], nodes.host[i]};
    const Domain_edge_2& e = m_domain.edges()[nodes.host[i]];
    return {e.source, e.target};
  }

  /// the distance of the vertex `i` of a triangle from the constraint opposite to it
  void add_width(const Bubbles_2& nodes, const Marked_triangulation_2& mesh, Index t, int i)
  {
    const Point &p = mesh.point(t, i), &a = mesh.point(t, ccw(i)), &b = mesh.point(t, cw(i));
    const Kernel::Vector_2 u = b - a;
    const double s = ((p - a) * u) / (u * u);
    // along a constraint there is no width
    if ((s <= 0 && mesh.edges[t][cw(i)] != no_index) || (s >= 1 && mesh.edges[t][ccw(i)] != no_index))
      return;
    if (is_silent(p) || is_silent(a) || is_silent(b))
      return;
    const Point foot = a + (std::max)(0., (std::min)(1., s)) * u;
    const double width = std::sqrt(CGAL::squared_distance(p, foot));
    if (is_too_long(nodes, mesh.vertices[t][ccw(i)], mesh.vertices[t][cw(i)], width))
      return;
    for (const Point& end : {p, foot})
      if (width > narrowest * m_limited.wanted()(end))
        limit(end, width);
  }

  const Domain_2& m_domain;
  const Given_mesh_2& m_given;
  const std::size_t m_maximum;
  Limited_sizes_2& m_limited;
  std::vector<Size_source_2> m_found; // in this turn
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_SIZES_OUTLINE_SIZES_2_H
