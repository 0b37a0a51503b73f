// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_CORNERS_CUT_DOMAIN_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_CORNERS_CUT_DOMAIN_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/Bubbles_2.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Sizes_2.h>
#include <CGAL/Bubble_relaxation_2/internal/core/reproducible_math.h>
#include <CGAL/Bubble_relaxation_2/internal/corners/Sharp_corner_2.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_2.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Problem_2.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/outline.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/place_on_edges.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/remove_coincident.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Marked_triangulation_2.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// A domain without the circles around its sharp corners. What is cut off counts as outside until there are nodes for
/// all else; their triangulation in the whole domain has the triangles of circles and corners that it is to have.
class Cut_domain_2
{
public:
  /// `sharp`: corners with circles
  Cut_domain_2(const Domain_2& whole, const std::vector<Sharp_corner_2>& sharp)
    : m_whole(whole), m_points(whole.corners()), m_nodes_on_arms(whole.edges().size(), {no_index, no_index})
  {
    for (const Sharp_corner_2& c : sharp)
      cut_arms(c);
    for (std::size_t e = 0; e < whole.edges().size(); ++e)
      add_pieces(static_cast<Index>(e));
    for (const Sharp_corner_2& c : sharp)
      for (const Sharp_corner_2::Sector& s : c.sectors())
        add_arc(c, s);
    m_is_cut = m_domain.build(std::move(m_points), std::move(m_edges)) == Marking_error::NONE;
  }

  /// Whether circles do not meet what is near by a rounding: else the domain is not to be used.
  bool is_cut() const { return m_is_cut; }

  /// whether points of the whole domain are in this one: those a rounding away from an edge may be beyond a piece of it
  bool contains(const std::vector<Point>& points) const
  {
    Index hint = 0;
    return std::all_of(points.begin(), points.end(),
                       [&](const Point& p) { return m_domain.locate_inside(p, hint) != no_index; });
  }

  const Domain_2& domain() const { return m_domain; }

  /// What is left of very sharp corners: chords in front of which the domain hardly gets wider. Beside a sharper corner
  /// there are several, which are short anyhow.
  const std::vector<Kernel::Segment_2>& narrow_chords() const { return m_narrow_chords; }

  const Domain_2& whole() const { return m_whole; }

  /// makes vertices that were on edges of the whole domain those on edges of this one
  void cut(Given_mesh_2& given) const
  {
    std::vector<std::vector<Point>> on_edge(m_domain.edges().size());
    for (std::size_t k = 0; k < m_pieces.size(); ++k)
      if (m_domain.edges()[k].takes_bubbles())
        for (const Point& p : given.on_edge[m_pieces[k].edge]) {
          const double s = position_on_edge(m_whole, m_pieces[k].edge, p);
          if (s > m_pieces[k].begin && s < m_pieces[k].end)
            on_edge[k].push_back(p);
        }
    given.on_edge = std::move(on_edge);
  }

  /// Makes a mesh of this domain one of the whole.
  void join(Bubble_mesh_2& mesh) const
  {
    join(mesh.bubbles);
    remove_coincident(m_whole, mesh.bubbles);
    triangulate(m_whole, mesh);
  }

  /// The hosts of bubbles in faces, which are triangles of a domain, are not to be used any more.
  void join(Bubbles_2& b) const
  {
    for (std::size_t i = 0; i < b.size(); ++i)
      if (b.is_on_edge(i)) {
        const Piece& piece = m_pieces[b.host[i]];
        b.host[i] = piece.edge;
        b.s[i] = piece.begin + b.s[i] * (piece.end - piece.begin);
      } else if (b.is_corner(i) && b.host[i] >= static_cast<Index>(m_whole.corners().size())) {
        const Node& on_circle = node(b.host[i]);
        b.dimension[i] = on_circle.edge == no_index ? Bubbles_2::FACE : Bubbles_2::EDGE;
        b.s[i] = on_circle.s;
        b.host[i] = on_circle.edge == no_index ? 0 : on_circle.edge;
      }
  }

private:
  /// a part of an edge of the whole domain, which has none where circles are
  struct Piece { Index edge; double begin, end; };

  /// a corner that is one in the cut domain only
  struct Node
  {
    Index edge; ///< on which it lies, if any
    double s;
  };

  Index add_node(const Node& node, const Point& p)
  {
    m_nodes.push_back(node);
    m_points.push_back(p);
    return static_cast<Index>(m_points.size() - 1);
  }

  void add_piece(const Domain_edge_2& edge, const Piece& piece)
  {
    m_edges.push_back(edge);
    m_pieces.push_back(piece);
  }

  void cut_arms(const Sharp_corner_2& c)
  {
    for (const Sharp_corner_2::Arm& a : c.arms()) {
      const double share = c.radius / m_whole.length(a.edge), s = a.is_source ? share : 1 - share;
      node_on_arm(a) = add_node(Node{a.edge, s}, m_whole.point_on_edge(a.edge, s));
    }
  }

  Index& node_on_arm(const Sharp_corner_2::Arm& a) { return m_nodes_on_arms[a.edge][a.is_source ? 0 : 1]; }

  void add_pieces(Index e)
  {
    Domain_edge_2 edge = m_whole.edges()[e];
    double begin = 0, end = 1;
    const auto [first, last] = m_nodes_on_arms[e];
    if (first != no_index) {
      begin = node(first).s;
      add_piece(Domain_edge_2{edge.source, first, false, false, Edge_kind::RIM}, Piece{e, 0, begin});
      edge.source = first;
    }
    if (last != no_index) {
      end = node(last).s;
      add_piece(Domain_edge_2{last, edge.target, false, false, Edge_kind::RIM}, Piece{e, end, 1});
      edge.target = last;
    }
    add_piece(edge, Piece{e, begin, end});
  }

  void add_arc(const Sharp_corner_2& c, const Sharp_corner_2::Sector& sector)
  {
    constexpr double narrow = 0.42; // radians, 24 degrees
    const Sharp_corner_2::Arm& arm = c.arms()[sector.first];
    const Point& o = m_whole.corners()[c.corner];
    const double start = angle_of(arm.to_other_end.x(), arm.to_other_end.y());
    Index last = node_on_arm(arm);
    const auto add_chord = [&](Index next) { // counterclockwise, so the corner is on its left
      add_piece(Domain_edge_2{last, next, false, true, Edge_kind::RIM}, Piece{no_index, 0, 0});
      last = next;
    };
    const std::vector<double> angles = c.nodes(sector);
    for (double angle : angles)
      add_chord(add_node(Node{no_index, 0}, Point(o.x() + c.radius * cosine_of(start + angle),
                                                  o.y() + c.radius * sine_of(start + angle))));
    add_chord(node_on_arm(c.arms()[sector.second]));
    if (angles.empty() && sector.angle < narrow)
      m_narrow_chords.emplace_back(m_points[node_on_arm(arm)], m_points[last]);
  }

  /// what a corner of this domain is that is none of the whole one
  const Node& node(Index corner) const { return m_nodes[static_cast<std::size_t>(corner) - m_whole.corners().size()]; }

  const Domain_2& m_whole;
  Domain_2 m_domain;
  std::vector<Kernel::Segment_2> m_narrow_chords;
  bool m_is_cut = false;
  std::vector<Point> m_points;        // until the domain is built
  std::vector<Domain_edge_2> m_edges; // the same
  std::vector<Piece> m_pieces;        // of each edge
  std::vector<Node> m_nodes;          // of corners beyond those of the whole domain
  std::vector<std::array<Index, 2>> m_nodes_on_arms; // of each edge of the whole domain, at its source and target
};

/// A domain without the circles around its sharp corners. Where one of them meets what is near by a rounding, or comes
/// between a pinned vertex and the edge that it lies beside by a rounding, that corner gets none: halves are tried, and
/// halves of those that cannot be cut off, so few bad ones among many cost few tries; where there are more than some
/// dozens, others may get none either. Null if no circle is left.
/// `sizes`: how large circles may be; `growth`: by which they grow; `pinned`: vertices that have to stay in the domain
inline std::shared_ptr<const Cut_domain_2> cut_corners(const Domain_2& whole, const Sizes_2& sizes, double growth,
                                                       const std::vector<Point>& pinned)
{
  constexpr int most_tries = 400; // each takes as long as reading the domain
  std::vector<Sharp_corner_2> sharp = sharp_corners(whole, growth), good;
  find_circles(whole, sizes, sharp);
  std::shared_ptr<const Cut_domain_2> result;
  std::vector<std::array<std::size_t, 2>> parts; // of the sharp corners, that may be good
  if (!sharp.empty())
    parts.push_back({0, sharp.size()});
  for (int tries = 0; !parts.empty() && tries < most_tries; ++tries) {
    const auto [first, last] = parts.back();
    parts.pop_back();
    std::vector<Sharp_corner_2> more = good;
    for (std::size_t k = first; k < last; ++k)
      more.push_back(sharp[k]);
    auto cut = std::make_shared<const Cut_domain_2>(whole, more);
    if (cut->is_cut() && cut->contains(pinned)) {
      result = std::move(cut);
      good = std::move(more);
    } else if (last - first > 1) {
      const std::size_t middle = first + (last - first) / 2;
      parts.push_back({middle, last});
      parts.push_back({first, middle});
    }
  }
  return result;
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_CORNERS_CUT_DOMAIN_2_H
