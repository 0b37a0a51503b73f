// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// What several ranks gain, what they hold and send, and what a model makes of that.
//
//   mpirun -n 2 --bind-to core distributed speed [--runs 7] [--interval 10] [--paper] [1192 1e5 1e6]
//                                               [--coasts FOLDER [NAME ...]]
//       seconds of CGAL::Distributed::npbs_mesh() and npbs_relax() on all ranks, and with the paper's protocol and so
//       many steps between exchanges (0: without), against those of CGAL::npbs_relax() and npbs_place_nodes() on one,
//       with so many vertices; whether the meshes are the same. With the defaults, or all with the paper's parameters,
//       as in its example of a ring:
//       distributed speed --paper --interval 50 1192
//   mpirun -n 64 distributed counts [--interval 10] [1e5 6.4e5] [--coasts FOLDER [NAME ...]]
//       bubbles, ghosts, neighbours, messages and bytes of a rank, and the most memory that it takes, on 2, 4, 8, 16, 64
//       of the ranks, whose number may be larger than that of cores, and of more bubbles on all of them; and from
//       these a model of the efficiency on up to 1e5 ranks
//
// FOLDER and names of coasts are as for the benchmark coasts.

#include "../../demo/Bubble_relaxation_2/mpi_session.h"
#include "coast.h"
#include "rank_counts.h"
#include "rank_speed_up.h"
#include "scaling_model.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

namespace P = CGAL::parameters;

struct Arguments
{
  std::string command;
  int runs = 7, interval = 10; // a round has 30 steps at most
  bool is_paper = false;
  std::vector<double> sizes;
  std::string folder; ///< of coasts; empty: none
  std::vector<std::string> names;
};

/// the paper's ring, eq. 4, a uniform square, and coasts
std::vector<Domain_maker> domains_of(const Arguments& arguments)
{
  std::vector<Domain_maker> result{paper::ring, paper::graded_circle, square};
  if (!arguments.folder.empty())
    for (const paper::Domain& coast : read_coasts(arguments.folder, 1, arguments.names))
      result.push_back([coast](double kilometres) {
        paper::Domain scaled = coast;
        scaled.d = [kilometres](const paper::Point&) { return kilometres; };
        return scaled;
      });
  return result;
}

int compare_speed(const Arguments& arguments)
{
  const Rank_speed_up compare(arguments.runs, arguments.interval);
  compare.print_header();
  bool is_equal = true;
  for (double n : arguments.sizes)
    for (const Domain_maker& make : domains_of(arguments)) {
      const paper::Domain d = domain_of_all(make, n);
      const auto papers = CGAL::npbs_paper_parameters().number_of_iterations(d.iterations).number_of_rounds(d.rounds);
      const bool is_same = arguments.is_paper ? compare(d, papers) : compare(d, P::force_coefficient(1.));
      is_equal = is_equal && is_same;
    }
  return is_equal ? 0 : 1;
}

/// the counts of the first `ranks` ranks, on these, while the others sleep
template <class NamedParameters>
Rank_counts count(const Mpi_session& session, int ranks, const paper::Domain& domain, const std::string& exchange,
                  const NamedParameters& np)
{
  Rank_counts counts{};
  MPI_Comm comm;
  MPI_Comm_split(MPI_COMM_WORLD, session.rank() < ranks ? 0 : MPI_UNDEFINED, session.rank(), &comm);
  if (comm != MPI_COMM_NULL) {
    counts = count_of_ranks(comm, domain, np);
    MPI_Comm_free(&comm);
    if (session.is_first())
      print(domain.name, exchange, counts);
  }
  wait_asleep(MPI_COMM_WORLD);
  return counts;
}

/// what one rank needs for a bubble in a step, in the fastest of some runs
double seconds_of_move(const paper::Domain& domain)
{
  double seconds = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 5; ++i) {
    paper::CDT cdt = paper::triangulate(domain);
    const auto report = CGAL::npbs_relax(cdt, P::sizing_function(domain.d));
    seconds = (std::min)(seconds, (report.seconds.renewal + report.seconds.motion) / double(report.number_of_moves));
  }
  return seconds;
}

void count_and_model(const Mpi_session& session, const Arguments& arguments)
{
  const int interval = arguments.interval;
  const std::vector<Domain_maker> domains = domains_of(arguments);
  if (session.is_first()) {
    std::cout << "per rank, and per step of the simulation; control of the population and reductions do not count\n";
    print_header_of_counts();
  }
  std::vector<Scaling_model> models;
  for (const Domain_maker& make : domains) {
    const paper::Domain domain = domain_of_all(make, arguments.sizes[0]);
    std::vector<Rank_counts> of_all;
    for (int ranks : {2, 4, 8, 16, 64})
      if (ranks <= session.number_of_ranks()) {
        of_all = {count(session, ranks, domain, "each step", P::force_coefficient(1.))};
        if (interval > 0)
          count(session, ranks, domain, "the paper's, s=" + std::to_string(interval), P::exchange_interval(interval));
      }
    for (std::size_t k = 1; k < arguments.sizes.size(); ++k)
      of_all.push_back(count(session, of_all[0].number_of_ranks, domain_of_all(make, arguments.sizes[k]), "each step",
                             P::force_coefficient(1.)));
    double seconds = 0;
    on_first_rank([&] { seconds = seconds_of_move(domain); });
    models.emplace_back(of_all, seconds);
  }
  if (!session.is_first())
    return;
  Scaling_model::print_assumptions();
  for (std::size_t k = 0; k < domains.size(); ++k)
    for (double all : {1e8, 1e9, 1e10})
      for (double ranks : {1e3, 1e4, 1e5})
        models[k].print(domains[k](1).name, all, ranks);
}

/// \throws std::invalid_argument with one line for the user
Arguments read_arguments(int argc, char** argv)
{
  Arguments arguments;
  arguments.command = argc > 1 ? argv[1] : "";
  const bool is_speed = arguments.command == "speed";
  bool is_understood = is_speed || arguments.command == "counts";
  for (int i = 2; i < argc; ++i) {
    const std::string option = argv[i];
    if (is_speed && option == "--paper") {
      arguments.is_paper = true;
      continue;
    }
    if (option == "--coasts" && i + 1 < argc) {
      arguments.folder = argv[++i];
      continue;
    }
    if (std::isalpha(static_cast<unsigned char>(option[0]))) {
      arguments.names.push_back(option);
      continue;
    }
    const bool is_option = option == "--runs" || option == "--interval";
    const double value = std::atof(is_option ? argv[i + 1 < argc ? ++i : i] : argv[i]);
    is_understood = is_understood && value >= (option == "--runs" ? 1 : is_option ? 0 : 100);
    if (option == "--runs")
      arguments.runs = static_cast<int>(value);
    else if (option == "--interval")
      arguments.interval = static_cast<int>(value);
    else
      arguments.sizes.push_back(value);
  }
  is_understood = is_understood && (arguments.names.empty() || !arguments.folder.empty());
  if (!is_understood)
    throw std::invalid_argument("usage: distributed speed [--runs N] [--interval S] [--paper] [VERTICES ...], or "
                                "distributed counts [--interval S] [VERTICES ...], both with [--coasts FOLDER [NAME ...]]");
  if (arguments.sizes.empty())
    arguments.sizes = is_speed ? std::vector<double>{1192, 1e5, 1e6} : std::vector<double>{1e5, 6.4e5};
  return arguments;
}

int run(const Mpi_session& session, int argc, char** argv)
{
  const Arguments arguments = read_arguments(argc, argv);
  if (arguments.command == "counts" && session.number_of_ranks() < 2)
    throw std::invalid_argument("counts needs at least two ranks");
  if (session.is_first())
    std::cout << "load " << load_average() << '\n';
  if (arguments.command == "speed")
    return compare_speed(arguments);
  count_and_model(session, arguments);
  return 0;
}

} // namespace

int main(int argc, char** argv)
{
  return run_with_mpi(argc, argv, "distributed",
                      [&](const Mpi_session& session) { return run(session, argc, argv); });
}
