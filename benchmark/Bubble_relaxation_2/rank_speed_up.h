// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef BUBBLE_RELAXATION_2_BENCHMARK_RANK_SPEED_UP_H
#define BUBBLE_RELAXATION_2_BENCHMARK_RANK_SPEED_UP_H

#include "ranks.h"

#include <CGAL/Distributed/npbs_mesh.h>
#include <CGAL/Distributed/npbs_relax.h>
#include <CGAL/Point_set_3.h>
#include <CGAL/npbs_place_nodes.h>

#include <algorithm>
#include <cstddef>
#include <iomanip>
#include <iostream>
#include <string>
#include <vector>

/// How much faster all ranks are than the programs without ranks, each of which is run by one while the others sleep:
/// `npbs_relax()` makes a mesh, as `Distributed::npbs_mesh()` does; `npbs_place_nodes()` makes nodes with neighbour
/// sets, as `Distributed::npbs_relax()` does. No speed-up can be more than that of programs without ranks that run at
/// once, one by each rank. The runs take turns, so that a slow while of the machine meets all, and the median of each
/// counts. Prints a row for each program.
class Rank_speed_up
{
public:
  /// `interval`: steps between exchanges with the paper's protocol; 0: it is not run
  Rank_speed_up(int number_of_runs, int interval) : m_number_of_runs(number_of_runs), m_interval(interval)
  {
    MPI_Comm_rank(MPI_COMM_WORLD, &m_rank);
    MPI_Comm_size(MPI_COMM_WORLD, &m_number_of_ranks);
  }

  void print_header() const
  {
    if (m_rank != 0)
      return;
    std::cout << "medians of " << m_number_of_runs << " runs in turn, on " << m_number_of_ranks
              << " ranks; seconds; speed-up over npbs_relax() without ranks, and over the program without ranks that "
                 "makes the same\n"
              << std::fixed << std::left << std::setw(20) << "domain" << std::right << std::setw(9) << "vertices" << "  "
              << std::left << std::setw(21) << "program" << std::setw(7) << "makes" << std::right << std::setw(9)
              << "seconds" << std::setw(9) << "speed-up" << std::setw(6) << "same" << std::setw(9) << "mean q"
              << std::setw(8) << "min q" << std::setw(7) << "steps";
    for (const char* phase :
         {"reading", "placement", "renewal", "motion", "population", "treatment", "writing", "evaluation"})
      std::cout << std::setw(11) << phase;
    std::cout << std::setw(7) << "load\n";
  }

  /// \returns whether the ranks make what one makes
  template <class NamedParameters>
  bool operator()(const paper::Domain& domain, const NamedParameters& parameters) const
  {
    const auto np = parameters.sizing_function(domain.d);
    std::vector<Run> meshes, meshes_at_once, nodes_made, meshes_of_all, nodes_made_by_all, papers;
    for (int i = 0; i < m_number_of_runs; ++i) {
      meshes.push_back(mesh_alone(domain, np));
      meshes_of_all.push_back(mesh_by_all(domain, np));
      meshes_at_once.push_back(mesh_by_each(domain, np));
      nodes_made.push_back(nodes_alone(domain, np));
      nodes_made_by_all.push_back(nodes_by_all(domain, np));
      if (m_interval > 0)
        papers.push_back(nodes_by_all(domain, np.exchange_interval(m_interval)));
    }
    if (m_rank != 0)
      return true;
    const Run mesh = median(meshes), nodes = median(nodes_made), mesh_of_all = median(meshes_of_all),
              nodes_of_all = median(nodes_made_by_all);
    const std::string ranks = std::to_string(m_number_of_ranks) + " ranks: ";
    print(domain, "npbs_relax", "mesh", mesh, mesh.seconds, mesh.seconds);
    const double all_seconds = m_number_of_ranks * mesh.seconds; // of what is made at once
    print(domain, std::to_string(m_number_of_ranks) + " at once", "meshes", median(meshes_at_once), all_seconds,
          all_seconds);
    print(domain, ranks + "npbs_mesh", "mesh", mesh_of_all, mesh.seconds, mesh.seconds);
    print(domain, "npbs_place_nodes", "nodes", nodes, mesh.seconds, nodes.seconds);
    print(domain, ranks + "npbs_relax", "nodes", nodes_of_all, mesh.seconds, nodes.seconds);
    if (m_interval > 0)
      print(domain, "the paper's, s=" + std::to_string(m_interval), "nodes", median(papers), mesh.seconds,
            nodes.seconds);
    const bool is_equal = is_same(mesh.report, mesh_of_all.report) && is_same(mesh.report, nodes_of_all.report);
    if (!is_equal)
      std::cout << "DIFFERENT from one rank" << std::endl;
    return is_equal;
  }

private:
  using Points = CGAL::Point_set_3<paper::Point, paper::K::Vector_2>;
  using Report = CGAL::Bubble_relaxation_report_2<double>;

  struct Run
  {
    double seconds = 0; ///< of the slowest rank
    Report report;
  };

  /// \pre there is one
  static Run median(std::vector<Run> runs)
  {
    const auto middle = runs.begin() + static_cast<std::ptrdiff_t>(runs.size() / 2);
    const auto is_faster = [](const Run& a, const Run& b) { return a.seconds < b.seconds; };
    std::nth_element(runs.begin(), middle, runs.end(), is_faster);
    return *middle;
  }

  template <class NamedParameters>
  static Run mesh_alone(const paper::Domain& domain, const NamedParameters& np)
  {
    return alone(domain, [&np](paper::CDT& cdt) { return CGAL::npbs_relax(cdt, np); });
  }

  template <class NamedParameters>
  static Run mesh_by_each(const paper::Domain& domain, const NamedParameters& np)
  {
    paper::CDT own = paper::triangulate(domain);
    return by_all(domain, [&own, &np](Points&, const paper::CDT&) { return CGAL::npbs_relax(own, np); });
  }

  template <class NamedParameters>
  static Run nodes_alone(const paper::Domain& domain, const NamedParameters& np)
  {
    return alone(domain, [&np](const paper::CDT& cdt) { return CGAL::npbs_place_nodes(cdt, np).report; });
  }

  template <class NamedParameters>
  static Run mesh_by_all(const paper::Domain& domain, const NamedParameters& np)
  {
    return by_all(domain, [&np](Points& points, const paper::CDT& cdt) {
      return CGAL::Distributed::npbs_mesh(points, cdt, MPI_COMM_WORLD, np).report;
    });
  }

  template <class NamedParameters>
  static Run nodes_by_all(const paper::Domain& domain, const NamedParameters& np)
  {
    return by_all(domain, [&np](Points& points, const paper::CDT& cdt) {
      return CGAL::Distributed::npbs_relax(points, cdt, MPI_COMM_WORLD, np).report;
    });
  }

  /// `make(cdt)` returns a report, on the first rank
  template <class Make>
  static Run alone(const paper::Domain& domain, const Make& make)
  {
    Run run;
    on_first_rank([&] {
      paper::CDT cdt = paper::triangulate(domain);
      run.seconds = seconds_of([&] { run.report = make(cdt); });
    });
    return run;
  }

  /// `make(points, cdt)` returns a report, on all ranks
  template <class Make>
  static Run by_all(const paper::Domain& domain, const Make& make)
  {
    const paper::CDT cdt = paper::triangulate(domain);
    Points points;
    Run run;
    MPI_Barrier(MPI_COMM_WORLD);
    run.seconds = seconds_of([&] { run.report = make(points, cdt); });
    MPI_Allreduce(MPI_IN_PLACE, &run.seconds, 1, MPI_DOUBLE, MPI_MAX, MPI_COMM_WORLD);
    return run;
  }

  template <class Work>
  static double seconds_of(const Work& work)
  {
    const double start = MPI_Wtime();
    work();
    return MPI_Wtime() - start;
  }

  static bool is_same(const Report& a, const Report& b)
  {
    return a.number_of_vertices == b.number_of_vertices && a.number_of_moves == b.number_of_moves &&
           a.quality.mean_quality() == b.quality.mean_quality() && a.quality.worst_x() == b.quality.worst_x();
  }

  /// `mesh_seconds`, `same_seconds`: of the programs without ranks, of which the second one makes the same
  static void print(const paper::Domain& domain, const std::string& program, const char* makes, const Run& run,
                    double mesh_seconds, double same_seconds)
  {
    std::cout << std::left << std::setw(20) << domain.name << std::right << std::setw(9) << run.report.number_of_vertices
              << "  " << std::left << std::setw(21) << program << std::setw(7) << makes << std::right
              << std::setprecision(4) << std::setw(9) << run.seconds << std::setprecision(2) << std::setw(9)
              << mesh_seconds / run.seconds << std::setw(6) << same_seconds / run.seconds;
    print_report(run.report);
    std::cout << std::setprecision(2) << std::setw(6) << load_average() << std::endl;
  }

  static void print_report(const Report& report)
  {
    if (report.number_of_triangles > 0)
      std::cout << std::setprecision(4) << std::setw(9) << report.quality.mean_quality() << std::setprecision(3)
                << std::setw(8) << report.quality.minimum_quality();
    else // nodes have no mesh
      std::cout << std::setw(9) << "-" << std::setw(8) << "-";
    std::cout << std::setw(7) << report.number_of_steps << std::setprecision(4);
    const auto& s = report.seconds;
    for (double phase :
         {s.reading, s.placement, s.renewal, s.motion, s.population, s.treatment, s.writing, s.evaluation})
      std::cout << std::setw(11) << phase;
  }

  int m_number_of_runs, m_interval, m_rank = 0, m_number_of_ranks = 1;
};

#endif // BUBBLE_RELAXATION_2_BENCHMARK_RANK_SPEED_UP_H
