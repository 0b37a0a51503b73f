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

#include "files/domain_file.h"
#include "files/file_names.h"
#include "mpi_session.h"
#include "size_formula.h"

#include <CGAL/Distributed/npbs_mesh.h>
#include <CGAL/Point_set_3.h>

#include <boost/program_options.hpp>

#include <functional>
#include <iostream>
#include <memory>
#include <set>
#include <stdexcept>
#include <string>

namespace po = boost::program_options;

struct Arguments
{
  std::string input, size, output;
  bool is_help = false;
};

po::options_description all_options()
{
  po::options_description options("distributed_mesh INPUT [options]   meshes a domain by several ranks");
  options.add_options()
    ("help,h", "shows this")
    ("input", po::value<std::string>(), "the domain: .poly (Triangle), .wkt, or a mesh to relax: .ele with its .node")
    ("size,s", po::value<std::string>(), "wanted length of edges, a formula in x and y; default: that of the "
                                         "domain's own edges")
    ("output,o", po::value<std::string>(), "the mesh, .pvtu (ParaView), with a .vtu of each rank beside it");
  return options;
}

Arguments read_arguments(int argc, char** argv)
{
  po::positional_options_description positional;
  positional.add("input", 1);
  po::variables_map map;
  po::store(po::command_line_parser(argc, argv).options(all_options()).positional(positional).run(), map);
  const auto text = [&map](const char* name) {
    return map.count(name) > 0 ? map[name].as<std::string>() : std::string();
  };
  const Arguments arguments{text("input"), text("size"), text("output"), map.count("help") > 0};
  if (!arguments.is_help && arguments.input.empty())
    throw std::runtime_error("no input file; see distributed_mesh --help");
  if (arguments.input == "-")
    throw std::runtime_error("standard input goes to one rank only; give a file");
  if (!arguments.output.empty())
    check_extension(arguments.output, {".pvtu"});
  return arguments;
}

/// makes the mesh and writes it
template <class NamedParameters>
void mesh(const Mpi_session& session, const Domain& domain, const std::string& output, const NamedParameters& np)
{
  CGAL::Point_set_3<Point, Kernel::Vector_2> points; // those of this rank
  const auto result = CGAL::Distributed::npbs_mesh(points, domain.cdt, MPI_COMM_WORLD, np);
  if (session.is_first())
    std::cout << result.report;
  if (output.empty())
    return;
  result.mesh.write_pvtu(output);
  if (session.is_first())
    std::cout << output << " of " << session.number_of_ranks() << " ranks" << std::endl;
}

int run(const Mpi_session& session, int argc, char** argv)
{
  Arguments arguments;
  std::unique_ptr<Domain> domain; // whose vertices are pinned by their handles, so it stays where it is
  std::function<double(const Point&)> size;
  session.all_or_none([&] { // a file may be missing where one rank runs
    arguments = read_arguments(argc, argv);
    if (!arguments.size.empty())
      size = Size_formula(arguments.size);
    if (session.is_first() && !arguments.output.empty())
      check_writable(arguments.output); // before the work is done, not after it
    if (!arguments.is_help)
      domain.reset(new Domain(read_domain_file(arguments.input, "")));
  });
  if (arguments.is_help) {
    if (session.is_first())
      std::cout << all_options();
    return 0;
  }
  if (session.is_first())
    for (const std::string& warning : domain->warnings)
      std::cerr << "distributed_mesh: warning: " << arguments.input << ": " << warning << '\n';

  using Pinned = CGAL::Boolean_property_map<const std::set<CDT::Vertex_handle>>;
  const auto np = CGAL::Bubble_relaxation_parameters::vertex_is_constrained_map(Pinned(domain->pinned));
  if (size)
    mesh(session, *domain, arguments.output, np.sizing_function(size));
  else
    mesh(session, *domain, arguments.output, np);
  return 0;
}

int main(int argc, char** argv)
{
  return run_with_mpi(argc, argv, "distributed_mesh",
                      [&](const Mpi_session& session) { return run(session, argc, argv); });
}
