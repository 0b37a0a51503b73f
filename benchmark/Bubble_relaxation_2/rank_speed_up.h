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

#include <CGAL/Distributed/npbs_relax.h>
#include <CGAL/Distributed/triangulate.h>
#include <CGAL/Point_set_3.h>

#include <iomanip>
#include <iostream>
#include <string>

/// How much faster all ranks are than `CGAL::npbs_relax()`, which is run by one while the others sleep. The runs take
/// turns, so that a slow while of the machine meets all, and the fastest of each counts, since other processes can
/// only slow them down. Prints a row for each program.
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
    std::cout << "the fastest of " << m_number_of_runs << " runs in turn, on " << m_number_of_ranks
              << " ranks; seconds; the mesh by triangulate() comes on top\n"
              << std::fixed << std::left << std::setw(8) << "domain" << std::right << std::setw(9) << "vertices" << "  "
              << std::left << std::setw(18) << "program" << std::right << std::setw(9) << "seconds" << std::setw(9)
              << "speed-up" << std::setw(9) << "mesh" << std::setw(10) << "with it" << std::setw(9) << "mean q"
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
    Run sequential, all, papers;
    for (int i = 0; i < m_number_of_runs; ++i) {
      keep_faster(run_alone(domain, np), sequential, i);
      keep_faster(run_by_all(domain, np), all, i);
      if (m_interval > 0)
        keep_faster(run_by_all(domain, np.exchange_interval(m_interval)), papers, i);
    }
    bool is_equal = true;
    if (m_rank == 0) {
      is_equal = is_same(sequential.report, all.report);
      print(domain, "npbs_relax", sequential, sequential);
      print(domain, std::to_string(m_number_of_ranks) + " ranks", all, sequential);
      if (m_interval > 0)
        print(domain, "the paper's, s=" + std::to_string(m_interval), papers, sequential);
      if (!is_equal)
        std::cout << "DIFFERENT from one rank" << std::endl;
    }
    return is_equal;
  }

private:
  using Report = CGAL::Bubble_relaxation_report_2<double>;

  struct Run
  {
    double seconds = 0, mesh_seconds = 0; ///< of the slowest rank
    Report report;
  };

  static void keep_faster(Run run, Run& fastest, int number)
  {
    if (number == 0 || run.seconds < fastest.seconds)
      fastest = std::move(run);
  }

  template <class NamedParameters>
  static Run run_alone(const paper::Domain& domain, const NamedParameters& np)
  {
    Run run;
    on_first_rank([&] {
      paper::CDT cdt = paper::triangulate(domain);
      const double start = MPI_Wtime();
      run.report = CGAL::npbs_relax(cdt, np);
      run.seconds = MPI_Wtime() - start;
    });
    MPI_Bcast(&run.seconds, 1, MPI_DOUBLE, 0, MPI_COMM_WORLD);
    return run;
  }

  template <class NamedParameters>
  static Run run_by_all(const paper::Domain& domain, const NamedParameters& np)
  {
    const paper::CDT cdt = paper::triangulate(domain);
    CGAL::Point_set_3<paper::Point, paper::K::Vector_2> points;
    Run run;
    run.seconds = slowest([&] { run.report = CGAL::Distributed::npbs_relax(points, cdt, MPI_COMM_WORLD, np).report; });
    run.mesh_seconds = slowest([&] { CGAL::Distributed::triangulate(points, cdt, MPI_COMM_WORLD, np); });
    return run;
  }

  template <class Work>
  static double slowest(const Work& work)
  {
    MPI_Barrier(MPI_COMM_WORLD);
    const double start = MPI_Wtime();
    work();
    double seconds = MPI_Wtime() - start;
    MPI_Allreduce(MPI_IN_PLACE, &seconds, 1, MPI_DOUBLE, MPI_MAX, MPI_COMM_WORLD);
    return seconds;
  }

  static bool is_same(const Report& a, const Report& b)
  {
    return a.number_of_vertices == b.number_of_vertices && a.number_of_moves == b.number_of_moves &&
           a.quality.mean_quality() == b.quality.mean_quality() && a.quality.worst_x() == b.quality.worst_x();
  }

  static void print(const paper::Domain& domain, const std::string& program, const Run& run, const Run& sequential)
  {
    const double with_mesh = run.seconds + run.mesh_seconds;
    std::cout << std::left << std::setw(8) << domain.name << std::right << std::setw(9) << run.report.number_of_vertices
              << "  " << std::left << std::setw(18) << program << std::right << std::setprecision(4) << std::setw(9)
              << run.seconds << std::setprecision(2) << std::setw(9) << sequential.seconds / run.seconds
              << std::setprecision(4) << std::setw(9) << run.mesh_seconds << std::setprecision(2) << std::setw(10)
              << sequential.seconds / with_mesh << std::setprecision(4) << std::setw(9)
              << run.report.quality.mean_quality() << std::setprecision(3) << std::setw(8)
              << run.report.quality.minimum_quality() << std::setw(7) << run.report.number_of_steps
              << std::setprecision(4);
    const auto& s = run.report.seconds;
    for (double phase :
         {s.reading, s.placement, s.renewal, s.motion, s.population, s.treatment, s.writing, s.evaluation})
      std::cout << std::setw(11) << phase;
    std::cout << std::setprecision(2) << std::setw(6) << load_average() << std::endl;
  }

  int m_number_of_runs, m_interval, m_rank = 0, m_number_of_ranks = 1;
};

#endif // BUBBLE_RELAXATION_2_BENCHMARK_RANK_SPEED_UP_H
