// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// How the cost of npbs_relax grows with the number of vertices: CPU time per vertex, its ratio to the floor (see
// bare_triangulation.h) of the mesh that comes out, that ratio over the one at 1e4, and the peak memory per vertex
// beyond that of the triangulation itself. Every mesh is made in a process of its own, since the peak of a
// process never falls.
//
//   scaling                       1e3 to 1e6 vertices on two graded domains and a uniform one
//   scaling 1e7                   up to this number
//   scaling --threads 2 [1e6]     seconds of wall-clock time in each phase with Sequential_tag, and with
//                                 Parallel_tag and 1 to so many threads; whether the meshes have the same bits

#include "bare_triangulation.h"
#include "in_child_process.h"

#include <CGAL/npbs_relax.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <iomanip>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using CDT = paper::CDT;
using Phases = CGAL::Bubble_relaxation_seconds;

/// what a child process measures
struct Measurement
{
  double vertices, seconds, wall, floor, mean_q, min_q, steps;
  double peak_bytes, own_bytes; ///< by how much the call raised the peak; what the triangulation's arrays take
  Phases phases;
  std::uint64_t hash; ///< of the bits of all points, in the order of their coordinates
};

std::uint64_t hash_of(std::vector<paper::Point> points)
{
  std::sort(points.begin(), points.end());
  std::uint64_t hash = 14695981039346656037u; // FNV-1a
  for (const paper::Point& p : points)
    for (double coordinate : {p.x(), p.y()}) {
      unsigned char bytes[sizeof coordinate];
      std::memcpy(bytes, &coordinate, sizeof coordinate);
      for (unsigned char byte : bytes)
        hash = (hash ^ byte) * 1099511628211u;
    }
  return hash;
}

double bytes_of(const CDT& cdt)
{
  return double(cdt.tds().vertices().capacity()) * sizeof(CDT::Vertex) +
         double(cdt.tds().faces().capacity()) * sizeof(CDT::Face);
}

/// meshes a domain and, if asked to, makes the bare triangulation of the same vertices
template <class Concurrency_tag>
Measurement mesh(const paper::Domain& domain, bool has_floor)
{
  Measurement m{};
  Vertices_and_constraints output;
  {
    CDT cdt = paper::triangulate(domain);
    const double peak = peak_memory(), start = cpu_seconds();
    const auto wall = std::chrono::steady_clock::now();
    const auto report = CGAL::npbs_relax(
      cdt, CGAL::parameters::sizing_function(domain.d).concurrency_tag(Concurrency_tag()));
    m.seconds = cpu_seconds() - start;
    m.wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - wall).count();
    m.peak_bytes = peak_memory() - peak;
    m.own_bytes = bytes_of(cdt);
    m.vertices = double(report.number_of_vertices);
    m.mean_q = report.quality.mean_quality();
    m.min_q = report.quality.minimum_quality();
    m.steps = double(report.number_of_steps);
    m.phases = report.seconds;
    output = vertices_and_constraints(cdt);
  }
  m.hash = hash_of(output.points);
  const int repetitions = m.vertices < 3e5 ? 5 : 1;
  for (int i = 0; has_floor && i < repetitions; ++i) {
    CDT bare;
    const double seconds = triangulate_bare(output, bare);
    m.floor = i == 0 ? seconds : (std::min)(m.floor, seconds);
  }
  return m;
}

void print_name(const std::string& name) { std::cout << std::setw(21) << std::left << name << std::right; }

/// three domains from 1e3 vertices on: d of eq. 1, which crystals follow, a uniform one, and eq. 4, which no
/// crystal can follow
template <class Run>
void for_each_size(double largest, const Run& run)
{
  struct Start
  {
    paper::Domain (*make)(double);
    double f; // for about 1000 vertices
  };
  for (const Start& start :
       {Start{paper::square_with_hole, 0.63}, Start{paper::non_convex, 1.07}, Start{paper::graded_circle, 1.}}) {
    double f = start.f;
    for (double n = 1e3; n <= 1.01 * largest; n *= 10, f /= std::sqrt(10.))
      run(start.make(f), n);
  }
}

void show_growth(double largest)
{
  print_name("domain");
  std::cout << std::fixed << std::setw(10) << "vertices" << std::setw(11) << "us/vertex" << std::setw(9) << "floors"
            << std::setw(12) << "over 1e4's" << std::setw(12) << "MB at peak" << std::setw(14) << "bytes/vertex"
            << std::setw(9) << "mean q" << std::setw(8) << "min q" << std::setw(7) << "steps"
            << "   % of: reading, placement, renewal, motion, population, treatment, writing, evaluation\n";
  double at_ten_thousand = 0;
  for_each_size(largest, [&](const paper::Domain& domain, double n) {
    const auto m = in_child_process<Measurement>([&] { return mesh<CGAL::Sequential_tag>(domain, true); });
    const double floors = m.seconds / m.floor;
    if (n < 1.1e4)
      at_ten_thousand = n > 9e3 ? floors : 0;
    print_name(domain.name);
    std::cout << std::setprecision(0) << std::setw(10) << m.vertices << std::setprecision(2) << std::setw(11)
              << 1e6 * m.seconds / m.vertices << std::setprecision(1) << std::setw(9) << floors
              << std::setprecision(2) << std::setw(12);
    if (at_ten_thousand > 0)
      std::cout << floors / at_ten_thousand;
    else
      std::cout << "-";
    std::cout << std::setprecision(1) << std::setw(12) << m.peak_bytes / 1e6 << std::setprecision(0) << std::setw(14)
              << (m.peak_bytes - m.own_bytes) / m.vertices << std::setprecision(4) << std::setw(9) << m.mean_q
              << std::setprecision(3) << std::setw(8) << m.min_q << std::setprecision(0) << std::setw(7) << m.steps
              << "  ";
    const Phases& s = m.phases; // of wall-clock time: phases are not timed otherwise
    for (double phase :
         {s.reading, s.placement, s.renewal, s.motion, s.population, s.treatment, s.writing, s.evaluation})
      std::cout << ' ' << 100 * phase / s.total();
    std::cout << std::endl;
  });
}

/// prints a row of the table of threads; `first` is what the others are compared with
void print_threads(const paper::Domain& domain, const std::string& threads, const Measurement& m,
                   const Measurement& first)
{
  print_name(domain.name);
  std::cout << std::setprecision(0) << std::setw(10) << m.vertices << std::setw(12) << threads
            << std::setprecision(3) << std::setw(9) << m.wall << std::setprecision(2) << std::setw(9)
            << first.wall / m.wall << std::setprecision(3);
  const Phases& s = m.phases;
  for (double phase :
       {s.reading, s.placement, s.renewal, s.motion, s.population, s.treatment, s.writing, s.evaluation})
    std::cout << std::setw(11) << phase;
  std::cout << "  " << std::hex << std::setw(16) << std::setfill('0') << m.hash << std::dec << std::setfill(' ')
            << (m.hash == first.hash ? "" : "  DIFFERENT") << std::endl;
}

/// \returns whether all meshes of a domain have the same bits
bool show_threads([[maybe_unused]] int threads, double largest)
{
  print_name("domain");
  std::cout << std::fixed << std::setw(10) << "vertices" << std::setw(12) << "threads" << std::setw(9) << "seconds"
            << std::setw(9) << "speed-up";
  for (const char* phase :
       {"reading", "placement", "renewal", "motion", "population", "treatment", "writing", "evaluation"})
    std::cout << std::setw(11) << phase;
  std::cout << "  hash of the points\n";
  bool is_equal = true;
  for_each_size(largest, [&](const paper::Domain& domain, double) {
    const auto first = in_child_process<Measurement>([&] { return mesh<CGAL::Sequential_tag>(domain, false); });
    print_threads(domain, "sequential", first, first);
#ifdef CGAL_LINKED_WITH_TBB
    for (int t = 1; t <= threads; ++t) {
      const auto m = in_child_process<Measurement>([&] {
        const tbb::global_control control(tbb::global_control::max_allowed_parallelism, std::size_t(t));
        return mesh<CGAL::Parallel_tag>(domain, false);
      });
      print_threads(domain, std::to_string(t), m, first);
      is_equal = is_equal && m.hash == first.hash;
    }
#endif
  });
#ifdef CGAL_LINKED_WITH_TBB
  std::cout << (is_equal ? "all meshes of a domain have the same bits\n" : "the bits DIFFER\n");
#else
  std::cout << "no Parallel_tag: TBB was not found when this program was configured\n";
#endif
  return is_equal;
}

} // namespace

int main(int argc, char** argv)
try {
  double largest = 1e6;
  int threads = 0;
  for (int i = 1; i < argc; ++i) {
    const bool is_threads = std::string(argv[i]) == "--threads";
    const double value = std::atof(is_threads ? argv[i + 1 < argc ? ++i : i] : argv[i]);
    if (value < 1)
      throw std::invalid_argument("usage: scaling [--threads N] [VERTICES]");
    if (is_threads)
      threads = int(value);
    else
      largest = value;
  }
  if (threads > 0)
    return show_threads(threads, largest) ? 0 : 1;
  show_growth(largest);
} catch (const std::exception& e) {
  std::cerr << "scaling: " << e.what() << '\n';
  return 1;
}
