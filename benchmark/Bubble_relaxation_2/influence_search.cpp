// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// What it takes to find the nodes in whose influence domain a point lies: this package's two ways, CGAL's Kd_tree with
// Fuzzy_sphere and its Point_set_2, and nanoflann. Nodes are placed by npbs_place_nodes(), uniform and graded;
// points come in space order, four a node, as quadrature points do. For each method a row with the milliseconds to
// build, the nanoseconds a query, both over those of the default, and the same for building and all queries.
// All have to find the same nodes. If sizes vary each node has a radius of its own. The other libraries search a disc
// around the point then, so wide that it has all of these nodes, as the known gradation allows, and drop the rest.
//
//   influence_search              10 000 nodes
//   influence_search 1e4 1e6      these numbers of nodes

#include "../../examples/Bubble_relaxation_2/paper_domains.h"

#include <CGAL/Fuzzy_sphere.h>
#include <CGAL/Influence_domain_2.h>
#include <CGAL/Kd_tree.h>
#include <CGAL/Point_set_2.h>
#include <CGAL/Search_traits_2.h>
#include <CGAL/Search_traits_adapter.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/npbs_place_nodes.h>
#include <CGAL/property_map.h>

#ifdef BUBBLE_RELAXATION_2_WITH_NANOFLANN
#include <nanoflann.hpp>
#endif

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <ctime>
#include <iomanip>
#include <iostream>
#include <iterator>
#include <limits>
#include <memory>
#include <numeric>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace {

using paper::CDT;
using paper::K;
using paper::Point;
using Nodes = CGAL::Node_set_2<Point>;
using Influence = CGAL::Influence_domain_2<K>;
using Found = std::vector<std::int32_t>;

constexpr std::size_t queries_a_node = 4, most_queries = 400000, queries_in_a_row = 4000;
constexpr int repetitions = 3;
constexpr double gradation = 0.1;

/// of this thread: others take turns on the machine
double cpu_seconds()
{
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

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
  std::vector<Place> places;

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

struct Measurement
{
  std::string name;
  double building = std::numeric_limits<double>::infinity(), querying = building; ///< seconds
  std::size_t number = 0, sum = 0;                                                ///< of the nodes found
};

template <class Search>
void measure(const Task& task, Measurement& m)
{
  const double start = cpu_seconds();
  const auto search = std::make_unique<Search>(task);
  const double built = cpu_seconds();
  Found found;
  m.number = m.sum = 0;
  for (const Place& place : task.places) {
    found.clear();
    (*search)(place, found);
    m.number += found.size();
    m.sum = std::accumulate(found.begin(), found.end(), m.sum);
  }
  m.building = (std::min)(m.building, built - start);
  m.querying = (std::min)(m.querying, cpu_seconds() - built);
}

/// returns whether all methods agree
bool measure_all(const Task& task)
{
  std::vector<Measurement> all{{"default"}, {"expansion"}, {"CGAL Kd_tree, Fuzzy_sphere"}, {"CGAL Point_set_2"}};
#ifdef BUBBLE_RELAXATION_2_WITH_NANOFLANN
  all.push_back({"nanoflann"});
#endif
  for (int k = 0; k < repetitions; ++k) { // in turn, so that what else the machine does meets all
    measure<Default_search>(task, all[0]);
    measure<Expansion_search>(task, all[1]);
    measure<Kd_tree_search>(task, all[2]);
    measure<Point_set_search>(task, all[3]);
#ifdef BUBBLE_RELAXATION_2_WITH_NANOFLANN
    measure<Nanoflann_search>(task, all[4]);
#endif
  }
  // building and the queries of all nodes
  const double queries = static_cast<double>(task.places.size());
  const auto total = [&](const Measurement& m) {
    return m.building + m.querying / queries * static_cast<double>(queries_a_node * task.nodes.size());
  };
  bool is_equal = true;
  for (const Measurement& m : all) {
    std::cout << "  " << std::left << std::setw(28) << m.name << std::right << std::fixed << std::setprecision(1)
              << std::setw(10) << 1e3 * m.building << std::setw(10) << 1e9 * m.querying / queries
              << std::setprecision(2) << std::setw(10) << m.querying / all[0].querying << std::setw(10)
              << total(m) / total(all[0]) << '\n';
    is_equal = is_equal && m.number == all[0].number && m.sum == all[0].sum;
  }
  std::cout << "  " << std::setprecision(1) << static_cast<double>(all[0].number) / queries << " nodes a query, "
            << (is_equal ? "the same for all" : "NOT THE SAME FOR ALL") << '\n' << std::endl;
  return is_equal;
}

/// uniform, or along a circle down to sizes that are far smaller than elsewhere
Nodes place(double n, bool is_uniform)
{
  CDT cdt;
  const paper::Outline square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  cdt.insert_constraint(square.begin(), square.end(), true);
  const double least = is_uniform ? std::sqrt(1.1547 / n) : 4 * paper::pi * 0.3 * 1.1547 / (gradation * n);
  const auto d = [=](const Point& p) {
    return is_uniform ? least : least + gradation * std::abs(paper::distance(p, 0.5, 0.5) - 0.3);
  };
  return CGAL::npbs_place_nodes(
    cdt, CGAL::parameters::sizing_function(d).number_of_rounds(2).defect_treatment(false));
}

Nodes shuffled(const Nodes& nodes)
{
  std::vector<std::int32_t> order(nodes.size()), rank(nodes.size());
  std::iota(order.begin(), order.end(), 0);
  std::shuffle(order.begin(), order.end(), std::mt19937(1));
  for (std::size_t k = 0; k < order.size(); ++k)
    rank[static_cast<std::size_t>(order[k])] = static_cast<std::int32_t>(k);
  Nodes result;
  result.neighbor_offsets.push_back(0);
  for (std::int32_t k : order) {
    const auto i = static_cast<std::size_t>(k);
    result.points.push_back(nodes.points[i]);
    result.sizes.push_back(nodes.sizes[i]);
    for (std::size_t l = nodes.neighbor_offsets[i]; l < nodes.neighbor_offsets[i + 1]; ++l)
      result.neighbors.push_back(rank[static_cast<std::size_t>(nodes.neighbors[l])]);
    result.neighbor_offsets.push_back(result.neighbors.size());
  }
  return result;
}

/// four around each of the nodes, whose order follows a curve; of many nodes, stretches of it
std::vector<Place> places(const Nodes& sorted, double factor, bool is_uniform)
{
  const std::size_t all = queries_a_node * sorted.size(), n = (std::min)(all, most_queries),
                    skipped = queries_in_a_row * ((all - n) / n);
  std::vector<Place> result;
  for (std::size_t k = 0; k < all; ++k) {
    if (k > 0 && k % queries_in_a_row == 0)
      k += skipped;
    if (k >= all)
      break;
    const std::size_t i = k / queries_a_node;
    const double d = sorted.sizes[i], offset = 0.25 * d;
    const Point p(sorted.points[i].x() + (k & 1 ? offset : -offset), sorted.points[i].y() + (k & 2 ? offset : -offset));
    // a node at a distance s has a size of at most d(p) + gradation s, and d(p) is at most d + gradation |p - x_i|
    const double largest = is_uniform ? d : d * (1 + gradation * 0.36);
    result.push_back(Place{p, 1.000001 * factor * largest / (is_uniform ? 1 : 1 - gradation * factor)});
  }
  return result;
}

bool measure(double n, bool is_uniform)
{
  const Nodes sorted = place(n, is_uniform);
  const auto sizes = std::minmax_element(sorted.sizes.begin(), sorted.sizes.end());
  bool is_equal = true;
  for (bool is_sorted : {true, false}) {
    Task task{is_sorted ? sorted : shuffled(sorted), {}, is_uniform, {}};
    for (double factor : {1.65, 2.5}) {
      task.places = places(sorted, factor, is_uniform);
      task.radii.clear();
      for (double d : task.nodes.sizes)
        task.radii.push_back(factor * d);
      std::cout << sorted.size() << " nodes, " << (is_uniform ? "uniform" : "graded") << std::setprecision(3)
                << std::defaultfloat << " (largest d over smallest " << *sizes.second / *sizes.first << "), "
                << (is_sorted ? "in space order" : "shuffled") << ", radius " << factor << " d\n"
                << "                                build ms  ns/query  /default with building\n";
      is_equal = measure_all(task) && is_equal;
    }
  }
  return is_equal;
}

} // namespace

int main(int argc, char** argv)
{
  std::vector<double> numbers{1e4};
  if (argc > 1)
    numbers.clear();
  for (int k = 1; k < argc; ++k)
    numbers.push_back(std::atof(argv[k]));
  bool is_equal = true;
  for (double n : numbers)
    for (bool is_uniform : {true, false})
      is_equal = measure(n, is_uniform) && is_equal;
  return is_equal ? EXIT_SUCCESS : EXIT_FAILURE;
}
