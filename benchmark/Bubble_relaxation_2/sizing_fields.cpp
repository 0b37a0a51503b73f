// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// What sizing fields on triangulations cost: seconds to make one, and nanoseconds for a query, in random order
// and along rows, by one thread and by several at once (then each query's time is that of one thread; with as
// many cores it should stay the same).
//
//   sizing_fields [threads]

#include "../../demo/Bubble_relaxation_2/paper_domains.h"

#include <CGAL/Gradation_limited_sizing_field_2.h>
#include <CGAL/Interpolated_sizing_field_2.h>
#include <CGAL/Real_timer.h>
#include <CGAL/npbs_relax.h>

#include <cstdlib>
#include <iomanip>
#include <iostream>
#include <map>
#include <random>
#include <string>
#include <thread>
#include <vector>

namespace {

using paper::CDT;
using paper::Point;

constexpr int queries = 1000000;

std::vector<Point> random_places()
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::vector<Point> points;
  for (int k = 0; k < queries; ++k)
    points.emplace_back(uniform(random), uniform(random));
  return points;
}

std::vector<Point> rows()
{
  std::vector<Point> points;
  for (int k = 0; k < queries; ++k)
    points.emplace_back((k % 1000 + 0.37) / 1000, (k / 1000 + 0.43) / 1000);
  return points;
}

template <class Field>
double nanoseconds(const Field& d, const std::vector<Point>& points, int number_of_threads)
{
  std::vector<double> sums(number_of_threads, 0);
  std::vector<std::thread> threads;
  CGAL::Real_timer timer;
  timer.start();
  for (double& sum : sums)
    threads.emplace_back([&] {
      double all = 0;
      for (const Point& p : points)
        all += d(p);
      sum = all;
    });
  for (std::thread& t : threads)
    t.join();
  if (sums.front() != sums.back())
    std::cerr << "sizing_fields: threads differ\n";
  return 1e9 * timer.time() / queries;
}

template <class Field>
void print_row(const std::string& name, std::size_t vertices, double seconds, const Field& d, int threads)
{
  std::cout << std::left << std::setw(34) << name << std::right << std::setw(9) << vertices << std::fixed
            << std::setprecision(2) << std::setw(9) << seconds << std::setprecision(0);
  for (int n : {1, threads})
    std::cout << std::setw(9) << nanoseconds(d, random_places(), n) << std::setw(9) << nanoseconds(d, rows(), n);
  std::cout << std::endl;
}

void measure_limited(double least, int threads)
{
  CDT cdt;
  const paper::Outline square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  cdt.insert_constraint(square.begin(), square.end(), true);
  const auto d = [=](const Point& p) { return paper::distance(p, 0.4, 0.55) < 0.25 ? least : 1.; };
  CGAL::Real_timer timer;
  timer.start();
  const CGAL::Gradation_limited_sizing_field_2 h(cdt, 0.2, CGAL::parameters::sizing_function(d));
  print_row("limited, jump from " + std::to_string(least).substr(0, 6), h.number_of_vertices(), timer.time(), h,
            threads);
}

void measure_interpolated(double size, int threads)
{
  CDT cdt;
  const paper::Outline square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  cdt.insert_constraint(square.begin(), square.end(), true);
  const auto graded = [=](const Point& p) { return size * (0.2 + paper::distance(p, 0.4, 0.55)); };
  CGAL::npbs_relax(cdt, CGAL::parameters::sizing_function(graded).number_of_rounds(1));
  std::map<CDT::Vertex_handle, double> sizes;
  for (auto v : cdt.finite_vertex_handles())
    sizes[v] = graded(v->point());
  CGAL::Real_timer timer;
  timer.start();
  const CGAL::Interpolated_sizing_field_2<CDT> d(cdt, boost::make_assoc_property_map(sizes), 0.2);
  print_row("interpolated", cdt.number_of_vertices(), timer.time(), d, threads);
}

} // namespace

int main(int argc, char** argv)
{
  const int threads = argc > 1 ? std::atoi(argv[1]) : 2;
  std::cout << "field                              vertices  seconds   random     rows   random     rows   (1 and "
            << threads << " threads)\n";
  for (double least : {0.02, 0.005, 0.001})
    measure_limited(least, threads);
  for (double size : {0.1, 0.03, 0.01})
    measure_interpolated(size, threads);
}
