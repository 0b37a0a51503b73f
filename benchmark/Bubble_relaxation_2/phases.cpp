// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// The cost of each phase in nanoseconds a node, on a graded and a uniform domain with about 1e3, 1e4 and 1e5 of
// them: the phases of whole relaxations as the report has them, and by themselves the neighbour sets, the
// forces, the statistics and, to compare with, the bare triangulation. With the options of Google Benchmark:
//
//   phases
//   phases --benchmark_filter='graded/10000(/|$)'

#include "bare_triangulation.h"

#include <CGAL/Bubble_relaxation_2/internal/geometry/Neighbor_sets_2.h>
#include <CGAL/Bubble_relaxation_2/internal/simulation/integrators.h>
#include <CGAL/npbs_place_nodes.h>
#include <CGAL/npbs_relax.h>

#include <benchmark/benchmark.h>

#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace {

using Phases = CGAL::Bubble_relaxation_seconds;
using Report = CGAL::Bubble_relaxation_report_2<double>;
using CGAL::Bubble_relaxation_2::internal::Bubbles_2;
using CGAL::Bubble_relaxation_2::internal::Neighbor_sets_2;
using State = benchmark::State;

constexpr int number_of_runs = 3;

/// one of the two domains, with the expected number of nodes
struct Case
{
  bool is_graded;
  long nodes;

  paper::Domain domain() const
  {
    const double f = 0.63 * std::sqrt(1000. / double(nodes));
    return is_graded ? paper::square_with_hole(f) : paper::non_convex(1.7 * f);
  }
  bool operator<(const Case& c) const
  {
    return std::make_pair(is_graded, nodes) < std::make_pair(c.is_graded, c.nodes);
  }
};

/// What `make()` returns for a case, made when it is asked for first, and kept. `make` has a type of its own for
/// each use, so that each has its own results.
template <class Make>
auto& kept(const Case& c, const Make& make)
{
  static std::map<Case, decltype(make())> results;
  auto found = results.find(c);
  if (found == results.end())
    found = results.emplace(c, make()).first;
  return found->second;
}

const std::vector<Report>& relaxations(const Case& c)
{
  return kept(c, [&c] {
    const paper::Domain domain = c.domain();
    std::vector<Report> reports;
    for (int i = 0; i < number_of_runs; ++i) {
      paper::CDT cdt = paper::triangulate(domain);
      reports.push_back(CGAL::npbs_relax(cdt, CGAL::parameters::sizing_function(domain.d)));
    }
    return reports;
  });
}

/// the mesh that comes out
const paper::CDT& relaxed_mesh(const Case& c)
{
  return kept(c, [&c] {
    const paper::Domain domain = c.domain();
    paper::CDT cdt = paper::triangulate(domain);
    CGAL::npbs_relax(cdt, CGAL::parameters::sizing_function(domain.d));
    return cdt;
  });
}

/// the bubbles that come out, in the library's own order
const Bubbles_2& relaxed_bubbles(const Case& c)
{
  return kept(c, [&c] {
    const paper::Domain domain = c.domain();
    const auto nodes =
      CGAL::npbs_place_nodes(paper::triangulate(domain), CGAL::parameters::sizing_function(domain.d));
    Bubbles_2 bubbles;
    for (std::size_t i = 0; i < nodes.size(); ++i)
      bubbles.add(nodes.points[i], nodes.sizes[i], Bubbles_2::FACE, 0);
    return bubbles;
  });
}

void count_nodes(State& state, double nodes)
{
  using benchmark::Counter;
  // the inverse of a rate that is summed over the iterations: time a node
  state.counters["s/node"] =
    Counter(nodes * double(state.iterations()), Counter::kIsRate | Counter::kInvert);
  state.counters["nodes"] = nodes;
}

/// a phase of whole relaxations: the seconds are those of the report
void phase(State& state, const Case& c, double Phases::*seconds)
{
  std::size_t run = 0;
  for (auto _ : state)
    state.SetIterationTime(relaxations(c)[run++].seconds.*seconds);
  const Report& report = relaxations(c)[0];
  count_nodes(state, double(report.number_of_vertices));
  if (seconds == &Phases::motion) // bubbles that sleep take no part in a step
    state.counters["s/move"] = benchmark::Counter(double(report.number_of_moves) * double(state.iterations()),
                                                  benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void build_neighbor_sets(State& state, const Case& c)
{
  const Bubbles_2& bubbles = relaxed_bubbles(c);
  Neighbor_sets_2 sets(1.7);
  for (auto _ : state) {
    sets.build(bubbles);
    benchmark::DoNotOptimize(sets.begin(0));
  }
  count_nodes(state, double(bubbles.size()));
}

void sum_forces(State& state, const Case& c)
{
  using namespace CGAL::Bubble_relaxation_2::internal;
  const Bubbles_2& b = relaxed_bubbles(c);
  Neighbor_sets_2 sets(1.7);
  sets.build(b);
  for (auto _ : state)
    for (std::size_t i = 0; i < b.size(); ++i) {
      Force sum = resultant_force(Bubble_force_2(), sets, b.x.data(), b.y.data(), b.d.data(), i);
      benchmark::DoNotOptimize(sum);
    }
  count_nodes(state, double(b.size()));
}

void evaluate(State& state, const Case& c)
{
  const paper::CDT& cdt = relaxed_mesh(c);
  const paper::Domain domain = c.domain();
  for (auto _ : state)
    benchmark::DoNotOptimize(
      CGAL::mesh_quality_2(cdt, CGAL::parameters::sizing_function(domain.d)).mean_quality());
  count_nodes(state, double(cdt.number_of_vertices()));
}

void triangulate_barely(State& state, const Case& c)
{
  const Vertices_and_constraints mesh = vertices_and_constraints(relaxed_mesh(c));
  for (auto _ : state) {
    paper::CDT cdt;
    state.SetIterationTime(triangulate_bare(mesh, cdt));
  }
  count_nodes(state, double(mesh.points.size()));
}

void register_benchmarks(const Case& c)
{
  const std::string name = std::string(c.is_graded ? "graded/" : "uniform/") + std::to_string(c.nodes);
  const auto add = [&name](const std::string& what, auto function) {
    return benchmark::RegisterBenchmark((what + "/" + name).c_str(), function)->Unit(benchmark::kMillisecond);
  };
  const std::pair<const char*, double Phases::*> phases[] = {
    {"reading", &Phases::reading},       {"placement", &Phases::placement}, {"renewal", &Phases::renewal},
    {"motion", &Phases::motion},         {"population", &Phases::population},
    {"treatment", &Phases::treatment},   {"evaluation", &Phases::evaluation}, {"writing", &Phases::writing}};
  for (const auto& p : phases)
    add(std::string("relaxation/") + p.first, [c, seconds = p.second](State& s) { phase(s, c, seconds); })
      ->UseManualTime()
      ->Iterations(number_of_runs);
  add("alone/neighbour_sets", [c](State& s) { build_neighbor_sets(s, c); });
  add("alone/forces", [c](State& s) { sum_forces(s, c); });
  add("alone/mesh_quality_2", [c](State& s) { evaluate(s, c); });
  add("alone/bare_triangulation", [c](State& s) { triangulate_barely(s, c); })->UseManualTime();
}

} // namespace

int main(int argc, char** argv)
{
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv))
    return 1;
  for (bool is_graded : {true, false})
    for (long nodes : {1000, 10000, 100000})
      register_benchmarks(Case{is_graded, nodes});
  benchmark::RunSpecifiedBenchmarks();
}
