// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_FILES_EDGE_CHAINS_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_FILES_EDGE_CHAINS_2_H

#include <array>
#include <cstddef>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// The nodes of each chain of the edges of a part of an outline, the first one again at the end of one that is closed.
/// Chains end where not just two edges meet, and go in the direction of their first edge.
class Edge_chains_2
{
public:
  using Edge = std::array<std::size_t, 2>;
  using Chain = std::vector<std::size_t>;

  explicit Edge_chains_2(const std::vector<Edge>& edges) : m_edges(edges), m_is_used(edges.size(), 0)
  {
    for (std::size_t e = 0; e < edges.size(); ++e)
      for (const std::size_t v : edges[e])
        m_edges_of[v].push_back(e);
    start([this](const Edge& e) { return is_end(e[0]) ? 0 : -1; });
    start([this](const Edge& e) { return is_end(e[1]) ? 1 : -1; });
    start([](const Edge&) { return 0; }); // the others are closed
  }

  std::vector<Chain> take_chains() { return std::move(m_chains); }

private:
  bool is_end(std::size_t v) const { return m_edges_of.at(v).size() != 2; }

  /// `first(edge)`: which of its ends a chain starts from, -1 if none does
  template <class First>
  void start(const First& first)
  {
    for (std::size_t e = 0; e < m_edges.size(); ++e)
      if (!m_is_used[e] && first(m_edges[e]) >= 0)
        m_chains.push_back(chain_from(m_edges[e][static_cast<std::size_t>(first(m_edges[e]))], e));
  }

  Chain chain_from(std::size_t v, std::size_t e)
  {
    Chain chain{v};
    for (;;) {
      m_is_used[e] = 1;
      v = m_edges[e][m_edges[e][0] == v ? 1 : 0];
      chain.push_back(v);
      const std::vector<std::size_t>& next = m_edges_of.at(v);
      if (is_end(v) || (m_is_used[next[0]] && m_is_used[next[1]]))
        return chain;
      e = m_is_used[next[0]] ? next[1] : next[0];
    }
  }

  const std::vector<Edge>& m_edges;
  std::vector<char> m_is_used;
  std::unordered_map<std::size_t, std::vector<std::size_t>> m_edges_of; // of each node
  std::vector<Chain> m_chains;
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_FILES_EDGE_CHAINS_2_H
