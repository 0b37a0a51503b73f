// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// What a callback is told, and how soon it is obeyed, in each phase of a relaxation: the phase's share of the time, the
// calls, the longest time without one, the told progress over the share of time that has gone, where it is farthest from
// 1 after the first tenth of all, and the time from a stop, half way through the phase, to the return: with
// `restore_when_stopped`, and without, where the bubbles are still triangulated and written. Domains are a square,
// eq. 4, a lake with islands, the square in a `Constrained_triangulation_plus_2`, which is written by insertion, and
// the square from a mesh with a quarter of the vertices. Seconds are CPU time, which other processes do not change.
//
//   progress FILE [1e6 ...]
//
// FILE is lake.poly; numbers are those of vertices.

#include "../../demo/Bubble_relaxation_2/files/triangle_file.h"
#include "bare_triangulation.h"
#include "benchmark_domains.h"

#include <CGAL/Constrained_triangulation_plus_2.h>
#include <CGAL/Default_relaxation_visitor_2.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <functional>
#include <iomanip>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using CGAL::Bubble_phase;
namespace P = CGAL::parameters;

constexpr int number_of_phases = 6;
constexpr const char* names[number_of_phases] = {"reading",   "placement",  "simulation",
                                                 "treatment", "evaluation", "writing"};

struct Call
{
  double seconds, told;
};

/// sees a relaxation: when phases begin, and each call
struct Watch : CGAL::Default_relaxation_visitor_2
{
  double start = cpu_seconds();
  std::vector<double> begins; // of the phases, then the end
  std::vector<Call> calls[number_of_phases];

  double now() const { return cpu_seconds() - start; }
  void phase_begins(Bubble_phase) { begins.push_back(now()); }

  /// a call of the callback
  Call hear(double told)
  {
    calls[begins.size() - 1].push_back({now(), told});
    return calls[begins.size() - 1].back();
  }
};

template <class Cdt>
Watch watch(Cdt cdt, const paper::Sizing& d, std::size_t& vertices)
{
  Watch w;
  const auto callback = [&w](double told) {
    w.hear(told);
    return true;
  };
  vertices = CGAL::npbs_relax(cdt, P::sizing_function(d).callback(callback).visitor(std::ref(w))).number_of_vertices;
  w.begins.push_back(w.now());
  return w;
}

/// Stops half way between the first and the last call that a phase had.
/// \returns the time from there to the return
template <class Cdt>
double stop_in(int phase, const Watch& before, bool restores, Cdt cdt, const paper::Sizing& d)
{
  const double half = (before.calls[phase].back().seconds - before.calls[phase].front().seconds) / 2;
  Watch w;
  double stopped = 0;
  const auto callback = [&](double told) {
    const Call call = w.hear(told);
    const int now = static_cast<int>(w.begins.size()) - 1;
    if (now < phase || (now == phase && call.seconds - w.begins[phase] < half))
      return true;
    stopped = stopped > 0 ? stopped : call.seconds;
    return false;
  };
  CGAL::npbs_relax(cdt, P::sizing_function(d).callback(callback).visitor(std::ref(w)).restore_when_stopped(restores));
  return w.now() - stopped;
}

double longest_gap(const Watch& w, int phase)
{
  double last = w.begins[phase], gap = 0;
  for (const Call& c : w.calls[phase]) {
    gap = (std::max)(gap, c.seconds - last);
    last = c.seconds;
  }
  return (std::max)(gap, w.begins[phase + 1] - last);
}

/// told progress over the share of time, where it is farthest from 1 on a logarithmic scale
double worst_ratio(const Watch& w, int phase)
{
  constexpr double first_tenth = 0.1;
  double worst = 1;
  for (const Call& c : w.calls[phase]) {
    const double share = c.seconds / w.begins.back();
    const double ratio = c.told / share;
    if (share > first_tenth && (std::max)(ratio, 1 / ratio) > (std::max)(worst, 1 / worst))
      worst = ratio;
  }
  return worst;
}

template <class Cdt>
void measure(const std::string& name, const Cdt& cdt, const paper::Sizing& d)
{
  std::size_t vertices = 0;
  const Watch w = watch(cdt, d, vertices);
  std::cout << name << ", " << vertices << " vertices, " << std::setprecision(2) << w.begins.back() << " s\n";
  for (int phase = 0; phase < number_of_phases; ++phase) {
    std::cout << "  " << std::left << std::setw(12) << names[phase] << std::right << std::setw(6)
              << (w.begins[phase + 1] - w.begins[phase]) / w.begins.back() << std::setw(7) << w.calls[phase].size()
              << std::setprecision(3) << std::setw(8) << longest_gap(w, phase) << std::setprecision(2) << std::setw(8)
              << worst_ratio(w, phase) << std::setprecision(3);
    for (bool restores : {true, false})
      std::cout << std::setw(10) << stop_in(phase, w, restores, cdt, d);
    std::cout << std::setprecision(2) << std::endl;
  }
}

CDT read_lake(const std::string& file)
{
  std::ifstream in(file);
  if (!in)
    throw std::runtime_error(file + ": cannot be opened");
  return read_poly(in, file).cdt;
}

double area(const CDT& cdt)
{
  double sum = 0;
  for (CDT::Face_handle f : cdt.finite_face_handles())
    sum += f->is_in_domain() ? cdt.triangle(f).area() : 0;
  return sum;
}

/// with which an area has `n` vertices
paper::Sizing uniform(double area, double n)
{
  const double d = std::sqrt(2 * area / (std::sqrt(3.) * n));
  return [d](const paper::Point&) { return d; };
}

void measure_domains(const CDT& lake, double n)
{
  const std::vector<paper::Outline> unit_square = square(1).outlines;
  measure("square", paper::triangulate(unit_square), uniform(1, n));
  const paper::Domain graded = domain_with_vertices(paper::graded_circle, n);
  measure("eq. 4", paper::triangulate(graded), graded.d);
  measure("lake", lake, uniform(area(lake), n));
  using Plus = CGAL::Constrained_triangulation_plus_2<paper::CDT>;
  measure("square, inserted", paper::triangulate<Plus>(unit_square), uniform(1, n));
  paper::CDT mesh = paper::triangulate(unit_square);
  CGAL::npbs_relax(mesh, P::sizing_function(uniform(1, n / 4)));
  measure("square, from a mesh", mesh, uniform(1, n));
}

} // namespace

int main(int argc, char** argv)
try {
  if (argc < 2)
    throw std::invalid_argument("progress FILE [NUMBER ...]");
  const CDT lake = read_lake(argv[1]);
  std::cout << std::fixed << "  phase        share  calls     gap   ratio   stopped  with a mesh\n";
  if (argc == 2)
    measure_domains(lake, 1e6);
  for (int i = 2; i < argc; ++i)
    measure_domains(lake, std::atof(argv[i]));
} catch (const std::exception& e) {
  std::cerr << "progress: " << e.what() << '\n';
  return 1;
}
