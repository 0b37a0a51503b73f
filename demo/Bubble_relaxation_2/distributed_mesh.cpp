// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// needs: muParser, Boost.Program_options
//
// Meshes a domain from a file by several ranks, each of which writes its part:
//   mpirun -n 4 distributed_mesh lake.poly --size "0.02+0.1*sqrt(x^2+y^2)" --output lake.pvtu
// or the first one the whole, in the formats of npbs_mesh, if that has room there.

#include "files/file_names.h"
#include "files/mesh_file.h"
#include "files/statistics_file.h"
#include "gathered_mesh.h"
#include "input_options.h"
#include "mesh_options.h"
#include "mesh_warnings.h"
#include "mpi_session.h"
#include "output_options.h"
#include "warnings.h"

#include <CGAL/Distributed/npbs_mesh.h>
#include <CGAL/Point_set_3.h>
#include <CGAL/npbs_relax.h>

#include <boost/program_options.hpp>

#include <iostream>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

po::options_description all_options()
{
  po::options_description options("distributed_mesh INPUT [options]   meshes a domain by several ranks");
  options.add_options()
    ("help,h", "shows this")
    ("output,o", po::value<std::string>(), "the mesh: .pvtu (ParaView), with a .vtu of each rank beside it; or, "
                                           "gathered by the first rank, what npbs_mesh writes");
  return options.add(input_options()).add(output_options()).add(mesh_options());
}

bool is_in_parts(const std::string& output) { return extension(output) == ".pvtu"; }

/// the files that the first rank writes
std::vector<std::string> files_of_first(const std::string& output)
{
  return is_in_parts(output) ? std::vector<std::string>{output} : mesh_files(output);
}

po::variables_map read_arguments(const Mpi_session& session, int argc, char** argv)
{
  const po::variables_map arguments = parse_arguments(argc, argv, all_options());
  if (arguments.count("help") > 0)
    return arguments;
  if (arguments.count("input") == 0)
    throw std::runtime_error("no input file; see distributed_mesh --help");
  if (arguments["input"].as<std::string>() == "-")
    throw std::runtime_error("standard input goes to one rank only; give a file");
  check_mesh_options(arguments);
  if (session.is_first()) // before the work is done, not after it
    check_statistics(arguments);
  if (arguments.count("output") > 0) {
    const std::string output = arguments["output"].as<std::string>();
    std::vector<std::string> endings = mesh_endings();
    endings.insert(endings.begin(), ".pvtu");
    check_extension(output, endings);
    if (session.is_first())
      for (const std::string& file : files_of_first(output))
        check_output(arguments["input"].as<std::string>(), file, "--output");
  }
  return arguments;
}

/// writes the mesh, of which each rank has a part
template <class Mesh>
void write(const Mpi_session& session, const Domain& domain, const po::variables_map& arguments,
           const Output_tags& tags, const Mesh& part)
{
  const std::string output = arguments["output"].as<std::string>();
  if (is_in_parts(output)) {
    part.write_pvtu(output);
  } else {
    const Gathered_mesh whole(session, part);
    session.all_or_none([&] {
      if (!session.is_first())
        return;
      CGAL::Mesh_arrays_2 arrays = whole.arrays(domain, arguments.count("size") > 0);
      tags.add_to(arrays);
      tags.project(arrays);
      write_mesh_file(output, arrays, tags.open());
    });
  }
  if (session.is_first() && arguments.count("quiet") == 0)
    std::cout << output << " of " << session.number_of_ranks() << " ranks" << std::endl;
}

/// makes the mesh, and writes it; `warn` is used by the first rank
template <class NamedParameters>
void mesh(const Mpi_session& session, const Domain& domain, const po::variables_map& arguments, const Output_tags& tags,
          Warnings& warn, const NamedParameters& np)
{
  CGAL::Point_set_3<Point, Kernel::Vector_2> points; // those of this rank
  const auto result = CGAL::Distributed::npbs_mesh(points, domain.cdt, MPI_COMM_WORLD, np);
  if (session.is_first()) {
    if (arguments.count("quiet") == 0)
      print_statistics(result.report);
    hint_at_outline("distributed_mesh", arguments, result.report);
    warn_of_report(result.report, arguments, warn);
    warn_of_worst_triangle(result.report, warn);
  }
  if (arguments.count("output") > 0)
    write(session, domain, arguments, tags, result.mesh);
  session.all_or_none([&] {
    if (session.is_first() && arguments.count("statistics") > 0)
      write_statistics(arguments["statistics"].as<std::string>(), result.report, warn.all(), 0);
  });
}

int run(const Mpi_session& session, int argc, char** argv)
{
  po::variables_map arguments;
  std::unique_ptr<Domain> domain; // whose vertices are pinned by their handles, so it stays where it is
  std::optional<Output_tags> tags;
  Region_map regions;
  Size size;
  session.all_or_none([&] { // a file may be missing where one rank runs
    arguments = read_arguments(session, argc, argv);
    if (arguments.count("help") > 0)
      return;
    std::optional<Size_formula> formula = size_formula(arguments);
    tags.emplace(arguments);
    domain.reset(new Domain(read_domain(arguments, "")));
    tags->check(*domain);
    const Rasters rasters = read_rasters(arguments, *domain);
    tags->set_rasters(rasters);
    if (formula)
      formula->set_rasters(rasters);
    prepare(*domain, arguments, formula, *tags, session.is_first());
    regions = region_attributes(*domain);
    size = limited_size(*domain, arguments, wanted_size(*domain, arguments, formula));
    if (session.is_first()) // the mesh does not know what lies outside of it
      warn_of_what_is_outside(domain->cdt, [&](const std::string& text) { domain->warnings.push_back(text); });
  });
  if (arguments.count("help") > 0) {
    if (session.is_first())
      std::cout << all_options();
    return 0;
  }
  Warnings warn("distributed_mesh", arguments);
  if (session.is_first())
    warn.tell_of(*domain);

  const auto mesh_with = [&](const auto& parameters) {
    const auto np = mesh_parameters(*domain, regions, arguments, parameters);
    size ? mesh(session, *domain, arguments, *tags, warn, np.sizing_function(size))
         : mesh(session, *domain, arguments, *tags, warn, np);
  };
  try {
    arguments.count("paper") > 0 ? mesh_with(CGAL::npbs_paper_parameters())
                                 : mesh_with(CGAL::parameters::force_coefficient(1.));
  } catch (const std::exception& e) { // on all ranks
    throw std::runtime_error(in_words_of_options(e.what()));
  }
  return 0;
}

int main(int argc, char** argv)
{
  return run_with_mpi(argc, argv, "distributed_mesh",
                      [&](const Mpi_session& session) { return run(session, argc, argv); });
}
