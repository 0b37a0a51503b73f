// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_GEOMETRY_BOX_TREE_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_GEOMETRY_BOX_TREE_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/vocabulary.h>

#include <CGAL/Bbox_2.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// A binary tree of boxes around things, such as triangles or their sides, halved by the longer side of the box. A
/// march over neighbours (Farrell and Maddison, CMAME 200 (2011)) would need no tree, but it stops at holes and at the
/// rim of a part, and misses what lies behind; the tree finds all things whatever the domains are, of any grading.
class Box_tree_2
{
public:
  /// \param boxes of the things, which are known by their numbers
  explicit Box_tree_2(const std::vector<Bbox_2>& boxes) : m_things(indices_below(boxes.size()))
  {
    if (!m_things.empty())
      build(0, m_things.size(), boxes);
  }

  /// calls `visit(i)` for things, among them all whose box meets `box`
  template <class Visitor>
  void for_each_near(const Bbox_2& box, const Visitor& visit, std::size_t node = 0) const
  {
    if (m_nodes.empty() || !do_overlap(m_nodes[node].box, box))
      return;
    if (m_nodes[node].right == 0) {
      for (std::size_t k = m_nodes[node].first; k < m_nodes[node].last; ++k)
        visit(m_things[k]);
      return;
    }
    for_each_near(box, visit, node + 1);
    for_each_near(box, visit, m_nodes[node].right);
  }

  /// calls `visit(i)`, which returns the squared distance that still counts, for things, among them the nearest ones
  template <class Visitor>
  void for_each_nearer(const Point& q, double& squared_bound, const Visitor& visit, std::size_t node = 0) const
  {
    if (m_nodes.empty() || squared_distance(m_nodes[node].box, q) > squared_bound)
      return;
    const Node& n = m_nodes[node];
    if (n.right == 0) {
      for (std::size_t k = n.first; k < n.last; ++k)
        squared_bound = visit(m_things[k]);
      return;
    }
    const bool is_right_nearer =
      squared_distance(m_nodes[n.right].box, q) < squared_distance(m_nodes[node + 1].box, q);
    for_each_nearer(q, squared_bound, visit, is_right_nearer ? n.right : node + 1);
    for_each_nearer(q, squared_bound, visit, is_right_nearer ? node + 1 : n.right);
  }

private:
  static constexpr std::size_t most_in_leaf = 4;

  struct Node
  {
    Bbox_2 box;
    std::size_t first, last;
    std::size_t right = 0; // the left child follows; 0 in a leaf
  };

  static double squared_distance(const Bbox_2& b, const Point& q)
  {
    const double x = (std::max)({b.xmin() - q.x(), q.x() - b.xmax(), 0.});
    const double y = (std::max)({b.ymin() - q.y(), q.y() - b.ymax(), 0.});
    return x * x + y * y;
  }

  void build(std::size_t first, std::size_t last, const std::vector<Bbox_2>& boxes)
  {
    const std::size_t node = m_nodes.size();
    Bbox_2 box;
    for (std::size_t k = first; k < last; ++k)
      box += boxes[m_things[k]];
    m_nodes.push_back(Node{box, first, last});
    if (last - first <= most_in_leaf)
      return;
    const bool is_wide = box.x_span() > box.y_span();
    const auto middle = [&](Index i) {
      return is_wide ? boxes[i].xmin() + boxes[i].xmax() : boxes[i].ymin() + boxes[i].ymax();
    };
    const std::size_t half = first + (last - first) / 2;
    const auto begin = m_things.begin();
    std::nth_element(begin + static_cast<std::ptrdiff_t>(first), begin + static_cast<std::ptrdiff_t>(half),
                     begin + static_cast<std::ptrdiff_t>(last),
                     [&](Index a, Index b) { return middle(a) < middle(b); });
    build(first, half, boxes);
    m_nodes[node].right = m_nodes.size();
    build(half, last, boxes);
  }

  std::vector<Index> m_things;
  std::vector<Node> m_nodes;
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_GEOMETRY_BOX_TREE_2_H
