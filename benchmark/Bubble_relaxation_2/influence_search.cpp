// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// What it takes to find the nodes in whose influence domain a point lies: this package's two ways, a plain grid of
// cells as wide as the largest radius, CGAL's Kd_tree with Fuzzy_sphere and its Point_set_2, and nanoflann. Nodes are
// placed by npbs_place_nodes(), uniform and graded; points come in space order, four a node, as quadrature points do.
// For each method a row with the milliseconds to build, the nanoseconds a query, both over those of the default, the
// same for building and all queries, and how many queries were timed: a method that is slow gets fewer.
// All have to find the same nodes; only the package's ways give them in ascending order. If sizes vary each node has a
// radius of its own. The other libraries search a disc around the point then, so wide that it has all of these nodes,
// as the known gradation allows, and drop the rest.
//
//   influence_search              10 000 nodes
//   influence_search 1e4 1e6      these numbers of nodes

#include "influence_searches.h"

#include <CGAL/npbs_place_nodes.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <ctime>
#include <iomanip>
#include <iostream>
#include <limits>
#include <memory>
#include <numeric>
#include <random>
#include <string>
#include <vector>

namespace {

using namespace influence_searches;

constexpr std::size_t queries_a_node = 4, most_queries = 200000, queries_in_a_row = 4000;
constexpr std::size_t few_queries = 20000, few_in_a_row = 500; // of a slow method
constexpr double slow = 5e-6;                                  // seconds a query
constexpr int repetitions = 3;
constexpr double gradation = 0.1;

/// of this thread: others take turns on the machine
double cpu_seconds()
{
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

struct Measurement
{
  std::string name;
  double building = std::numeric_limits<double>::infinity(), querying = building; ///< seconds: in all, and a query
  bool is_slow = false;
  std::size_t queries = 0;         ///< that were timed
  std::size_t number = 0, sum = 0; ///< of the nodes found
};

/// returns the seconds a query, and adds up what is found
template <class Search>
double seconds_a_query(Search& search, const std::vector<Place>& places, Measurement& m)
{
  Found found;
  m.number = m.sum = 0;
  m.queries = places.size();
  const double start = cpu_seconds();
  for (const Place& place : places) {
    found.clear();
    search(place, found);
    m.number += found.size();
    m.sum = std::accumulate(found.begin(), found.end(), m.sum);
  }
  return (cpu_seconds() - start) / static_cast<double>(places.size());
}

template <class Search>
void measure(const Task& task, bool is_first, Measurement& m)
{
  const double start = cpu_seconds();
  const auto search = std::make_unique<Search>(task);
  m.building = (std::min)(m.building, cpu_seconds() - start);
  if (is_first)
    m.is_slow = seconds_a_query(*search, task.few_places, m) > slow;
  m.querying = (std::min)(m.querying, seconds_a_query(*search, m.is_slow ? task.few_places : task.places, m));
}

void print(const Measurement& m, const Measurement& reference, std::size_t number_of_nodes)
{
  // building and the queries of all nodes
  const auto total = [&](const Measurement& x) {
    return x.building + x.querying * static_cast<double>(queries_a_node * number_of_nodes);
  };
  std::cout << "  " << std::left << std::setw(28) << m.name << std::right << std::fixed << std::setprecision(1)
            << std::setw(10) << 1e3 * m.building << std::setw(11) << 1e9 * m.querying << std::setprecision(2)
            << std::setw(10) << m.querying / reference.querying << std::setw(10) << total(m) / total(reference)
            << std::setw(10) << m.queries << '\n';
}

/// returns whether all methods agree
bool measure_all(const Task& task)
{
  std::vector<Measurement> all{{"default"}, {"expansion"}, {"plain grid"}, {"CGAL Kd_tree, Fuzzy_sphere"},
                               {"CGAL Point_set_2"}};
#ifdef BUBBLE_RELAXATION_2_WITH_NANOFLANN
  all.push_back({"nanoflann"});
#endif
  for (int k = 0; k < repetitions; ++k) { // in turn, so that what else the machine does meets all
    measure<Default_search>(task, k == 0, all[0]);
    measure<Expansion_search>(task, k == 0, all[1]);
    measure<Grid_search>(task, k == 0, all[2]);
    measure<Kd_tree_search>(task, k == 0, all[3]);
    measure<Point_set_search>(task, k == 0, all[4]);
#ifdef BUBBLE_RELAXATION_2_WITH_NANOFLANN
    measure<Nanoflann_search>(task, k == 0, all[5]);
#endif
  }
  Default_search search(task);
  Measurement expected_of_all, expected_of_few;
  seconds_a_query(search, task.places, expected_of_all);
  seconds_a_query(search, task.few_places, expected_of_few);
  bool is_equal = true;
  for (const Measurement& m : all) {
    print(m, all[0], task.nodes.size());
    const Measurement& expected = m.is_slow ? expected_of_few : expected_of_all;
    is_equal = is_equal && m.number == expected.number && m.sum == expected.sum;
  }
  std::cout << "  " << std::setprecision(1)
            << static_cast<double>(expected_of_all.number) / static_cast<double>(expected_of_all.queries)
            << " nodes a query, " << (is_equal ? "the same for all" : "NOT THE SAME FOR ALL") << '\n' << std::endl;
  return is_equal;
}

/// uniform, or along a circle down to sizes that are far smaller than elsewhere
Nodes place(double n, bool is_uniform)
{
  const paper::Outline square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const double least = is_uniform ? std::sqrt(1.1547 / n) : 4 * paper::pi * 0.3 * 1.1547 / (gradation * n);
  const auto d = [=](const Point& p) {
    return is_uniform ? least : least + gradation * std::abs(paper::distance(p, 0.5, 0.5) - 0.3);
  };
  return CGAL::npbs_place_nodes(
    paper::triangulate({square}),
    CGAL::parameters::sizing_function(d).number_of_rounds(2).defect_treatment(false));
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

/// short stretches from all parts of the domain
std::vector<Place> few(const std::vector<Place>& all)
{
  const std::size_t step = (all.size() + few_queries - 1) / few_queries;
  std::vector<Place> result;
  for (std::size_t k = 0; k < all.size(); ++k)
    if (k / few_in_a_row % step == 0)
      result.push_back(all[k]);
  return result;
}

bool measure(double n, bool is_uniform)
{
  const Nodes sorted = place(n, is_uniform);
  const auto sizes = std::minmax_element(sorted.sizes.begin(), sorted.sizes.end());
  bool is_equal = true;
  for (bool is_sorted : {true, false}) {
    Task task{is_sorted ? sorted : shuffled(sorted), {}, is_uniform, {}, {}};
    for (double factor : {1.65, 2.5}) {
      task.places = places(sorted, factor, is_uniform);
      task.few_places = few(task.places);
      task.radii.clear();
      for (double d : task.nodes.sizes)
        task.radii.push_back(factor * d);
      std::cout << sorted.size() << " nodes, " << (is_uniform ? "uniform" : "graded") << std::setprecision(3)
                << std::defaultfloat << " (largest d over smallest " << *sizes.second / *sizes.first << "), "
                << (is_sorted ? "in space order" : "shuffled") << ", radius " << factor << " d\n"
                << "                                build ms   ns/query  /default with building  queries\n";
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
