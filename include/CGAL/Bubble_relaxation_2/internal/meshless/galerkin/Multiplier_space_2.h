// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_GALERKIN_MULTIPLIER_SPACE_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_GALERKIN_MULTIPLIER_SPACE_2_H

#include <CGAL/Bubble_relaxation_2/internal/meshless/galerkin/Integration_domain_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// Functions for Lagrange's multipliers on the boundary: hats, linear between points that lie evenly on the
/// pieces between corners, in units of the size of the nodes. A piece as long as s sizes has at most 2 s / 3 of
/// them: with as many as there are nodes on the boundary the equations are singular or nearly so. Multipliers are
/// normal derivatives, which jump at corners.
class Multiplier_space_2
{
public:
  struct Hat
  {
    std::size_t index;
    double value;
  };

  /// \param is_included per edge of the boundary
  /// \param lengths of the edges in units of the size of the nodes
  Multiplier_space_2(const std::vector<Boundary_edge_2>& boundary, const std::vector<char>& is_included,
                     const std::vector<double>& lengths)
    : m_boundary(boundary), m_lengths(lengths), m_places(boundary.size())
  {
    link(is_included);
    std::vector<char> is_done(boundary.size(), 0);
    for (const bool only_starts : {true, false}) // what is left then are loops without corners
      for (std::size_t e = 0; e < boundary.size(); ++e)
        if (is_included[e] && !is_done[e] && !(only_starts && m_previous[e] != none && !is_corner(e)))
          add_path(path_from(e, is_done));
  }

  std::size_t size() const { return m_size; }

  /// the functions that are not zero at the place `s` in [0, 1] on an edge; two, perhaps the same
  std::array<Hat, 2> hats(std::size_t edge, double s) const
  {
    const Place& p = m_places[edge];
    if (p.intervals == 0)
      return {Hat{p.first, 1.}, Hat{p.first, 0.}};
    const double at = (p.begin + s * p.length) * static_cast<double>(p.intervals);
    const std::size_t left = (std::min)(static_cast<std::size_t>((std::max)(at, 0.)), p.intervals - 1);
    const double right_value = at - static_cast<double>(left);
    const std::size_t right = p.is_loop ? (left + 1) % p.intervals : left + 1;
    return {Hat{p.first + left, 1 - right_value}, Hat{p.first + right, right_value}};
  }

private:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  static constexpr double share_of_nodes = 2. / 3;

  /// an edge in its piece, which has the length 1
  struct Place
  {
    double begin = 0, length = 0;
    std::size_t first = 0, intervals = 0; // of the piece
    bool is_loop = false;
  };

  struct Path
  {
    std::vector<std::size_t> edges;
    bool is_loop;
  };

  /// finds for each edge the one that it continues, unless more than two meet there
  void link(const std::vector<char>& is_included)
  {
    Index most = no_index;
    for (const Boundary_edge_2& e : m_boundary)
      most = (std::max)(most, (std::max)(e.source, e.target));
    std::vector<std::size_t> ending(static_cast<std::size_t>(most + 1), none), number(ending.size(), 0);
    for (std::size_t e = 0; e < m_boundary.size(); ++e) {
      ++number[m_boundary[e].source];
      ++number[m_boundary[e].target];
      if (is_included[e])
        ending[m_boundary[e].target] = e;
    }
    m_previous.assign(m_boundary.size(), none);
    m_next.assign(m_boundary.size(), none);
    for (std::size_t e = 0; e < m_boundary.size(); ++e) {
      const Index v = m_boundary[e].source;
      if (!is_included[e] || number[v] != 2 || ending[v] == none)
        continue;
      m_previous[e] = ending[v];
      m_next[ending[v]] = e;
    }
  }

  /// whether the boundary turns by more than 30 degrees where an edge begins
  bool is_corner(std::size_t e) const
  {
    const Direction n = m_boundary[e].outer_normal(), before = m_boundary[m_previous[e]].outer_normal();
    return n.x * before.x + n.y * before.y < 0.866;
  }

  Path path_from(std::size_t first, std::vector<char>& is_done) const
  {
    Path path{{}, false};
    std::size_t e = first;
    for (; e != none && !is_done[e]; e = m_next[e]) {
      is_done[e] = 1;
      path.edges.push_back(e);
    }
    path.is_loop = e == first && !is_corner(first);
    return path;
  }

  /// cuts a path at its corners, if what lies between them is long enough for a function
  void add_path(const Path& path)
  {
    std::vector<std::vector<std::size_t>> pieces(1);
    double length = 0;
    for (std::size_t e : path.edges) {
      if (!pieces.back().empty() && is_corner(e) && share_of_nodes * length >= 1) {
        pieces.emplace_back();
        length = 0;
      }
      pieces.back().push_back(e);
      length += m_lengths[e];
    }
    if (pieces.size() > 1 && share_of_nodes * length < 1) {
      std::vector<std::size_t> last = pieces.back();
      pieces.pop_back();
      pieces.back().insert(pieces.back().end(), last.begin(), last.end());
    }
    for (const std::vector<std::size_t>& piece : pieces)
      add_piece(piece, path.is_loop);
  }

  void add_piece(const std::vector<std::size_t>& edges, bool is_loop)
  {
    double length = 0;
    for (std::size_t e : edges)
      length += m_lengths[e];
    const double most = (std::max)(1., std::floor(share_of_nodes * length));
    const std::size_t number = static_cast<std::size_t>(most);
    double begin = 0;
    for (std::size_t e : edges) {
      m_places[e] = Place{begin / length, m_lengths[e] / length, m_size, is_loop ? number : number - 1, is_loop};
      begin += m_lengths[e];
    }
    m_size += number;
  }

  const std::vector<Boundary_edge_2>& m_boundary;
  std::vector<double> m_lengths;
  std::vector<Place> m_places;
  std::vector<std::size_t> m_previous, m_next; // of each edge
  std::size_t m_size = 0;
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_GALERKIN_MULTIPLIER_SPACE_2_H
