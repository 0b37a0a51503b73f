// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef BUBBLE_RELAXATION_2_BENCHMARK_INFLUENCE_SEARCHES_H
#define BUBBLE_RELAXATION_2_BENCHMARK_INFLUENCE_SEARCHES_H

#include "../../demo/Bubble_relaxation_2/paper_domains.h"

#include <CGAL/Bbox_2.h>
#include <CGAL/Fuzzy_sphere.h>
#include <CGAL/Influence_domain_2.h>
#include <CGAL/Kd_tree.h>
#include <CGAL/Point_set_2.h>
#include <CGAL/Search_traits_2.h>
#include <CGAL/Search_traits_adapter.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/node_set_2.h>
#include <CGAL/property_map.h>

#ifdef BUBBLE_RELAXATION_2_WITH_NANOFLANN
#include <nanoflann.hpp>
#endif

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <memory>
#include <numeric>
#include <utility>
#include <vector>

/// The ways to find the nodes in whose influence domain a point lies that influence_search compares.
namespace influence_searches {

using paper::K;
using paper::Point;
using Nodes = CGAL::Node_set_2<Point>;
using Influence = CGAL::Influence_domain_2<K>;
using Found = std::vector<std::int32_t>;

struct Place
{
  Point p;
  double reach; ///< no node is found that is farther away
};

struct Task
{
  Nodes nodes;
  std::vector<double> radii;
  bool is_uniform;
  std::vector<Place> places;     ///< of the queries
  std::vector<Place> few_places; ///< of those of a method that would take too long

  bool has(std::int32_t i, const Point& p) const
  {
    const Point& q = nodes.points[static_cast<std::size_t>(i)];
    const double dx = q.x() - p.x(), dy = q.y() - p.y(), r = radii[static_cast<std::size_t>(i)];
    return dx * dx + dy * dy < r * r;
  }
};

// each method is built from a task and finds the nodes of a place

struct Default_search
{
  Influence influence;
  Influence::Query query;

  explicit Default_search(const Task& t) : influence(make(t, CGAL::Influence_search::BUCKETS)), query(influence) {}

  static Influence make(const Task& t, CGAL::Influence_search search)
  {
    const auto np = CGAL::parameters::influence_search(search);
    return t.is_uniform ? Influence(t.nodes, t.radii[0], np) : Influence(t.nodes, t.radii, np);
  }

  void operator()(const Place& place, Found& found) { query(place.p, 1, found); }
};

struct Expansion_search : Default_search
{
  explicit Expansion_search(const Task& t) : Default_search(t)
  {
    influence = make(t, CGAL::Influence_search::EXPANSION);
    query = Influence::Query(influence);
  }
};

/// A plain grid as it is usually written: square cells as wide as the largest radius, each node in one of them. A query
/// goes through nine cells, which are three stretches of an array that a counting sort has made.
struct Grid_search
{
  struct Entry
  {
    double x, y, squared_radius;
    std::int32_t node;
  };

  double x0, y0, side;
  std::size_t columns, rows;
  std::vector<std::size_t> begins; ///< of each cell, row by row, and the end
  std::vector<Entry> entries;

  explicit Grid_search(const Task& t)
  {
    CGAL::Bbox_2 box;
    for (const Point& p : t.nodes.points)
      box += p.bbox();
    side = *std::max_element(t.radii.begin(), t.radii.end());
    // a ring of empty cells, so that all cells with nodes have eight around them
    x0 = box.xmin() - side;
    y0 = box.ymin() - side;
    columns = static_cast<std::size_t>((box.xmax() - x0) / side) + 2;
    rows = static_cast<std::size_t>((box.ymax() - y0) / side) + 2;
    begins.assign(columns * rows + 1, 0);
    for (const Point& p : t.nodes.points)
      ++begins[cell(p) + 1];
    std::partial_sum(begins.begin(), begins.end(), begins.begin());
    std::vector<std::size_t> ends(begins.begin(), begins.end() - 1);
    entries.resize(t.nodes.size());
    for (std::size_t i = 0; i < t.nodes.size(); ++i) {
      const Point& p = t.nodes.points[i];
      entries[ends[cell(p)]++] = Entry{p.x(), p.y(), t.radii[i] * t.radii[i], static_cast<std::int32_t>(i)};
    }
  }

  std::size_t column(double x) const { return static_cast<std::size_t>((x - x0) / side); }
  std::size_t row(double y) const { return static_cast<std::size_t>((y - y0) / side); }
  std::size_t cell(const Point& p) const { return row(p.y()) * columns + column(p.x()); }

  void operator()(const Place& place, Found& found)
  {
    const double x = place.p.x(), y = place.p.y();
    if (!(x >= x0 && y >= y0))
      return;
    const std::size_t i = column(x), j = row(y);
    if (i >= columns || j >= rows)
      return;
    const std::size_t left = i > 0 ? i - 1 : 0, right = (std::min)(i + 1, columns - 1);
    for (std::size_t k = j > 0 ? j - 1 : 0; k <= (std::min)(j + 1, rows - 1); ++k)
      for (std::size_t e = begins[k * columns + left]; e < begins[k * columns + right + 1]; ++e) {
        const double dx = entries[e].x - x, dy = entries[e].y - y;
        if (dx * dx + dy * dy < entries[e].squared_radius)
          found.push_back(entries[e].node);
      }
  }
};

struct Kd_tree_search
{
  using Numbered = std::pair<Point, std::int32_t>;
  using Traits = CGAL::Search_traits_adapter<Numbered, CGAL::First_of_pair_property_map<Numbered>,
                                             CGAL::Search_traits_2<K>>;

  const Task& task;
  std::unique_ptr<CGAL::Kd_tree<Traits>> tree;
  std::vector<Numbered> near;

  explicit Kd_tree_search(const Task& t) : task(t)
  {
    std::vector<Numbered> points;
    for (std::size_t i = 0; i < t.nodes.size(); ++i)
      points.emplace_back(t.nodes.points[i], static_cast<std::int32_t>(i));
    tree = std::make_unique<CGAL::Kd_tree<Traits>>(points.begin(), points.end());
    tree->build();
  }

  void operator()(const Place& place, Found& found)
  {
    near.clear();
    tree->search(std::back_inserter(near), CGAL::Fuzzy_sphere<Traits>(place.p, place.reach));
    for (const Numbered& n : near)
      if (task.has(n.second, place.p))
        found.push_back(n.second);
  }
};

struct Point_set_search
{
  using Vertex_base = CGAL::Triangulation_vertex_base_with_info_2<std::int32_t, K>;
  using Point_set = CGAL::Point_set_2<K, CGAL::Triangulation_data_structure_2<Vertex_base>>;

  const Task& task;
  Point_set points;
  std::vector<Point_set::Vertex_handle> near;

  explicit Point_set_search(const Task& t) : task(t)
  {
    std::vector<std::pair<Point, std::int32_t>> numbered;
    for (std::size_t i = 0; i < t.nodes.size(); ++i)
      numbered.emplace_back(t.nodes.points[i], static_cast<std::int32_t>(i));
    static_cast<Point_set::Base&>(points).insert(numbered.begin(), numbered.end());
  }

  void operator()(const Place& place, Found& found)
  {
    near.clear();
    points.range_search(K::Circle_2(place.p, place.reach * place.reach), std::back_inserter(near));
    for (const auto v : near)
      if (task.has(v->info(), place.p))
        found.push_back(v->info());
  }
};

#ifdef BUBBLE_RELAXATION_2_WITH_NANOFLANN
struct Nanoflann_search
{
#if NANOFLANN_VERSION < 0x150
  using Near = std::pair<std::int32_t, double>;
  using Parameters = nanoflann::SearchParams;
#else
  using Near = nanoflann::ResultItem<std::int32_t, double>;
  using Parameters = nanoflann::SearchParameters;
#endif
  struct Cloud
  {
    const std::vector<Point>& points;

    std::size_t kdtree_get_point_count() const { return points.size(); }
    double kdtree_get_pt(std::size_t i, std::size_t k) const { return k == 0 ? points[i].x() : points[i].y(); }
    template <class Box>
    bool kdtree_get_bbox(Box&) const { return false; }
  };
  using Tree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Cloud>, Cloud, 2, std::int32_t>;

  const Task& task;
  Cloud cloud;
  Tree tree;
  std::vector<Near> near;

  explicit Nanoflann_search(const Task& t) : task(t), cloud{t.nodes.points}, tree(2, cloud) { tree.buildIndex(); }

  void operator()(const Place& place, Found& found)
  {
    const double center[2] = {place.p.x(), place.p.y()};
    Parameters parameters;
    parameters.sorted = false;
    near.clear();
    tree.radiusSearch(center, place.reach * place.reach, near, parameters);
    for (const Near& n : near)
      if (task.has(n.first, place.p))
        found.push_back(n.first);
  }
};
#endif

} // namespace influence_searches

#endif // BUBBLE_RELAXATION_2_BENCHMARK_INFLUENCE_SEARCHES_H
