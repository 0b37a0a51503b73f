// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// needs: muParser, Boost.Program_options
//
// A mesher for the command line:
//   npbs_mesh lake.poly --size "0.02+0.1*sqrt(x^2+y^2)" --output lake.vtu --picture lake.svg

#include "bad_triangle.h"
#include "files/file_names.h"
#include "files/mesh_file.h"
#include "files/mesh_of_domain.h"
#include "files/simplify_domain.h"
#include "files/statistics_file.h"
#include "input_options.h"
#include "mesh_options.h"
#include "mesh_warnings.h"
#include "output_options.h"
#include "svg_picture.h"
#include "warnings.h"

#include <CGAL/npbs_relax.h>

#include <boost/program_options.hpp>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <csignal>
#include <functional>
#include <iostream>
#include <optional>
#include <sstream>
#include <vector>
#include <unistd.h>

volatile std::sig_atomic_t interruption = 0; // the signal that came

int interrupted_exit() { return 128 + interruption; } // as shells have it

/// Ctrl-C, and what a time limit sends, stop the simulation and keep its mesh.
void be_interrupted_by_signals()
{
  for (const int number : {SIGINT, SIGTERM})
    std::signal(number, [](int came) { interruption = came; });
}

/// A bar on a terminal, nothing elsewhere. Its line ends with its life, however far it is: what is printed
/// next, an error too, starts on a line of its own.
class Progress_bar
{
public:
  explicit Progress_bar(bool is_shown) : m_is_shown(is_shown && isatty(STDERR_FILENO)) {}
  ~Progress_bar()
  {
    if (m_percent >= 0)
      std::cerr << std::endl;
  }
  Progress_bar(const Progress_bar&) = delete;
  Progress_bar& operator=(const Progress_bar&) = delete;

  void show(double fraction)
  {
    const int percent = static_cast<int>(100 * fraction), done = static_cast<int>(40 * fraction);
    if (!m_is_shown || percent == m_percent)
      return;
    m_percent = percent;
    std::cerr << "\r[" << std::string(done, '#') << std::string(40 - done, ' ') << "] " << percent
              << " %" << std::flush;
  }

private:
  bool m_is_shown;
  int m_percent = -1; // what the bar shows, -1 before it is drawn
};

po::options_description all_options()
{
  po::options_description options("npbs_mesh INPUT [options]   meshes a domain by bubble simulation");
  options.add_options()
    ("help,h", "shows this")
    ("version", "shows the version")
    ("format,f", po::value<std::string>()->default_value(""),
     "of the input: poly or wkt, whatever the ending, needed for standard input, -; or map, for what else GDAL reads")
    ("output,o", po::value<std::string>(), "the mesh: .vtu (ParaView), .msh (Gmsh 4.1), .msh2 (2.2), .2dm (SMS), .14, "
                                           ".grd or .gr3 (ADCIRC, SCHISM), or .node, .ele or .edge (Triangle; these, "
                                           "and .poly)")
    ("picture,p", po::value<std::string>(), "a picture of the mesh and its quality, .svg")
    ("threads", po::value<int>()->default_value(1), "threads at most, 0 for all; the mesh is the same");
  return options.add(input_options()).add(output_options()).add(mesh_options());
}

void print_version()
{
  std::cout << "npbs_mesh " << NPBS_MESH_VERSION << ", CGAL " << CGAL_VERSION_STR << ", muParser "
            << mu::Parser().GetVersion(mu::pviBRIEF)
#ifdef CGAL_LINKED_WITH_TBB
            << ", TBB"
#endif
#ifdef BUBBLE_RELAXATION_2_WITH_GDAL
            << ", GDAL " << GDAL_RELEASE_NAME
#endif
            << '\n';
}

po::variables_map read_arguments(int argc, char** argv)
{
  const po::options_description options = all_options();
  const po::variables_map arguments = parse_arguments(argc, argv, options);
  if (arguments.count("help") > 0) {
    std::cout << options;
    std::exit(0);
  }
  if (arguments.count("version") > 0) {
    print_version();
    std::exit(0);
  }
  if (arguments.count("input") == 0)
    throw std::runtime_error("no input file; see npbs_mesh --help");
  if (arguments.count("quiet") > 0 &&
      arguments.count("output") + arguments.count("picture") + arguments.count("statistics") == 0)
    throw std::runtime_error("--quiet without --output, --picture or --statistics leaves nothing to show");
  return arguments;
}

/// what would be found out only when the mesh is there
void check_arguments(const po::variables_map& arguments)
{
  const std::string input = arguments["input"].as<std::string>();
  if (arguments.count("output") > 0) {
    const std::string output = arguments["output"].as<std::string>();
    check_extension(output, mesh_endings());
    for (const std::string& file : mesh_files(output))
      check_output(input, file, "--output");
  }
  if (arguments.count("picture") > 0) {
    check_extension(arguments["picture"].as<std::string>(), {".svg"});
    check_writable(arguments["picture"].as<std::string>());
  }
  if (arguments.count("simplification-report") > 0)
    check_output(input, arguments["simplification-report"].as<std::string>(), "--simplification-report");
  check_statistics(arguments);
  check_mesh_options(arguments);
  if (arguments["threads"].as<int>() < 0)
    throw std::runtime_error("--threads must not be negative");
#ifndef CGAL_LINKED_WITH_TBB
  if (arguments["threads"].as<int>() != 1)
    throw std::runtime_error("--threads: this npbs_mesh was built without TBB");
#endif
}

/// calls npbs_relax with what the arguments say, on top of `parameters`
template <class Parameters>
Report relax(Domain& domain, const Region_map& regions, const po::variables_map& arguments, const Size& size,
             const Parameters& parameters)
{
  Progress_bar bar(arguments.count("quiet") == 0);
  const auto all =
    mesh_parameters(domain, regions, arguments, parameters)
      .concurrency_tag(CGAL::Parallel_if_available_tag())
      .callback([&bar](double fraction) {
        bar.show(fraction);
        return interruption == 0;
      });
  return size ? CGAL::npbs_relax(domain.cdt, all.sizing_function(size))
              : CGAL::npbs_relax(domain.cdt, all);
}

/// \throws std::runtime_error with the name of the input
Report mesh(Domain& domain, const Region_map& regions, const po::variables_map& arguments, const Size& size)
try {
#ifdef CGAL_LINKED_WITH_TBB
  const int threads = arguments["threads"].as<int>();
  const tbb::global_control limit(
    tbb::global_control::max_allowed_parallelism,
    threads > 0 ? threads
                : tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
#endif
  return arguments.count("paper") > 0
           ? relax(domain, regions, arguments, size, CGAL::npbs_paper_parameters())
           : relax(domain, regions, arguments, size, CGAL::parameters::force_coefficient(1.));
} catch (const std::exception& e) {
  throw std::runtime_error(input_name(arguments) + ": " + in_words_of_options(e.what()));
}

void write_files(Domain& domain, const Region_map& regions, const Report& report, const po::variables_map& arguments,
                 const Size& size, const Output_tags& tags)
try {
  if (arguments.count("output") > 0) {
    CGAL::Mesh_arrays_2 mesh = mesh_of(domain, regions);
    tags.add_to(mesh);
    if (size)
      for (const Point& p : mesh.points)
        mesh.vertex_data["d"].push_back(size(p));
    tags.project(mesh);
    write_mesh_file(arguments["output"].as<std::string>(), mesh, tags.open());
  }
  if (arguments.count("picture") > 0) {
    Svg_picture picture;
    picture.add_mesh(domain.cdt, "mesh, coloured by q");
    picture.add_histogram(report.quality, "q = 2 r_in / r_out");
    picture.write(arguments["picture"].as<std::string>());
  }
} catch (const std::exception& e) {
  throw std::runtime_error(in_words_of_options(e.what()));
}

/// tells all that should not be in a mesh
void warn_of_mesh(const Domain& domain, const Report& report, const po::variables_map& arguments, const Size& size,
                  Warnings& warn)
{
  warn_of_report(report, arguments, warn);
  warn_of_what_is_outside(domain.cdt, warn);
  if (arguments.count("output") > 0 && is_of_adcirc(arguments["output"].as<std::string>())) {
    const std::vector<Point> touching = touching_places(domain.cdt);
    if (!touching.empty())
      warn(touching_message(touching));
  }
  const Bad_triangle worst(domain, Protected_segments(domain, arguments["protect"].as<std::string>()));
  if (worst.is_bad())
    warn(worst.message(size));
}

int main(int argc, char** argv)
try {
  const po::variables_map arguments = read_arguments(argc, argv);
  check_arguments(arguments);
  std::optional<Size_formula> formula = size_formula(arguments);
  Output_tags tags(arguments);
  Domain domain = read_domain(arguments, arguments["format"].as<std::string>());
  Warnings warn("npbs_mesh", arguments);
  warn.tell_of(domain);
  tags.check(domain);
  const Rasters rasters = read_rasters(arguments, domain);
  tags.set_rasters(rasters);
  if (formula)
    formula->set_rasters(rasters);
  prepare(domain, arguments, formula, tags);
  warn.tell_of(domain);
  const Region_map regions = region_attributes(domain);
  be_interrupted_by_signals();
  const Size size = limited_size(domain, arguments, wanted_size(domain, arguments, formula),
                                 [](double) { return interruption == 0; });
  const Report report = mesh(domain, regions, arguments, size);
  if (report.number_of_vertices == 0) {
    std::cerr << "npbs_mesh: interrupted before there were bubbles, nothing is written\n";
    return interrupted_exit();
  }
  if (arguments.count("quiet") == 0)
    print_statistics(report);
  const bool is_stopped = report.stop_reason == CGAL::Bubble_stop_reason::STOPPED_BY_CALLBACK;
  if (is_stopped)
    std::cerr << "npbs_mesh: interrupted, the mesh is as the bubbles were\n";
  hint_at_outline("npbs_mesh", arguments, report);
  warn_of_mesh(domain, report, arguments, size, warn);
  write_files(domain, regions, report, arguments, size, tags);
  const int exit_code = is_stopped ? interrupted_exit() : 0;
  if (arguments.count("statistics") > 0)
    write_statistics(arguments["statistics"].as<std::string>(), report, warn.all(), exit_code);
  return exit_code;
} catch (const std::exception& e) {
  std::cerr << "npbs_mesh: " << e.what() << '\n';
  return 1;
}
