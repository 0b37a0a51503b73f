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

#include "files/domain_file.h"
#include "files/file_names.h"
#include "files/mesh_file.h"
#include "files/simplify_domain.h"
#include "mesh_warnings.h"
#include "size_formula.h"
#include "svg_picture.h"

#include <CGAL/Gradation_limited_sizing_field_2.h>
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
#include <utility>
#include <vector>
#include <unistd.h>

namespace po = boost::program_options;

volatile std::sig_atomic_t is_interrupted = 0;

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
  namespace defaults = CGAL::Bubble_relaxation_2::internal;
  po::options_description options("npbs_mesh INPUT [options]   meshes a domain by bubble simulation");
  options.add_options()
    ("help,h", "shows this")
    ("version", "shows the version")
    ("input", po::value<std::string>(), "the domain: .poly (Triangle), .wkt, or a mesh to relax: .ele "
                                        "with its .node; - is standard input")
    ("format,f", po::value<std::string>()->default_value(""), "poly or wkt, whatever the ending")
    ("size,s", po::value<std::string>(), "wanted length of edges, a formula in x, y and region, the attribute of a "
                                         "region of the domain; default: that of the domain's own edges")
    ("gradation,g", po::value<double>(), "the most that the length may change per unit of length, such as 0.2; "
                                         "default: as --size asks")
    ("size-growth", po::value<double>()->default_value(defaults::default_size_growth, "0.2"),
     "by how much the length grows per unit of length away from where the domain is finer than it")
    ("minimum-angle", po::value<double>()->default_value(defaults::default_minimum_angle),
     "smaller angles are refined, in degrees, but for those between two segments; 0: never")
    ("tolerance", po::value<double>(), "replace the outline by one with pieces as long as --size, within this share of "
                                       "it, such as 0.1")
    ("min-island", po::value<double>()->default_value(0), "with --tolerance: drop islands with a smaller area")
    ("min-gap", po::value<double>()->default_value(0), "with --tolerance: fill where the domain is narrower")
    ("simplification-report", po::value<std::string>(), "with --tolerance: a text file with the places of what was "
                                                        "dropped and filled")
    ("output,o", po::value<std::string>(), "the mesh: .vtu (ParaView), .msh (Gmsh), or .node or .ele "
                                           "(Triangle; both, and .poly)")
    ("picture,p", po::value<std::string>(), "a picture of the mesh and its quality, .svg")
    ("paper", "the parameters of the paper instead of the defaults")
    ("rounds", po::value<int>()->default_value(defaults::default_number_of_rounds),
     "rounds of simulation at most; with --paper 6")
    ("iterations", po::value<int>()->default_value(defaults::default_number_of_iterations),
     "steps in a round at most; with --paper 250")
    ("max-bubbles", po::value<long>()->default_value(20000000), "refuse sizes that ask for more vertices")
    ("threads", po::value<int>()->default_value(1), "threads at most, 0 for all; the mesh is the same")
    ("quiet,q", "no progress and no statistics");
  return options;
}

void print_version()
{
  std::cout << "npbs_mesh " << NPBS_MESH_VERSION << ", CGAL " << CGAL_VERSION_STR << ", muParser "
            << mu::Parser().GetVersion(mu::pviBRIEF)
#ifdef CGAL_LINKED_WITH_TBB
            << ", TBB"
#endif
            << '\n';
}

po::variables_map read_arguments(int argc, char** argv)
{
  const po::options_description options = all_options();
  po::positional_options_description positional;
  positional.add("input", 1);
  po::variables_map arguments;
  po::store(po::command_line_parser(argc, argv).options(options).positional(positional).run(), arguments);
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
  if (arguments.count("quiet") > 0 && arguments.count("output") + arguments.count("picture") == 0)
    throw std::runtime_error("--quiet without --output or --picture leaves nothing to show");
  return arguments;
}

/// \throws std::runtime_error if the input is among the files of the output
void check_that_input_stays(const std::string& input, const std::string& output)
{
  std::error_code ignored;
  for (const std::string& file : mesh_files(output))
    if (std::filesystem::equivalent(input, file, ignored))
      throw std::runtime_error(file + ": is the input; give --output another name");
}

/// what would be found out only when the mesh is there
void check_arguments(const po::variables_map& arguments)
{
  if (arguments.count("output") > 0) {
    const std::string output = arguments["output"].as<std::string>();
    check_extension(output, mesh_endings());
    check_that_input_stays(arguments["input"].as<std::string>(), output);
    for (const std::string& file : mesh_files(output))
      check_writable(file);
  }
  if (arguments.count("picture") > 0) {
    check_extension(arguments["picture"].as<std::string>(), {".svg"});
    check_writable(arguments["picture"].as<std::string>());
  }
  if (arguments.count("simplification-report") > 0) {
    const std::string report = arguments["simplification-report"].as<std::string>();
    std::error_code ignored;
    if (std::filesystem::equivalent(arguments["input"].as<std::string>(), report, ignored))
      throw std::runtime_error(report + ": is the input; give --simplification-report another name");
    check_writable(report);
  }
  if (arguments.count("gradation") > 0 && !(arguments["gradation"].as<double>() > 0))
    throw std::runtime_error("--gradation must be positive");
  if (arguments.count("tolerance") > 0 && arguments.count("size") == 0)
    throw std::runtime_error("--tolerance needs --size");
  if (arguments.count("tolerance") == 0 && !(arguments["min-island"].defaulted() && arguments["min-gap"].defaulted()))
    throw std::runtime_error("--min-island and --min-gap need --tolerance");
  if (arguments.count("tolerance") == 0 && arguments.count("simplification-report") > 0)
    throw std::runtime_error("--simplification-report needs --tolerance");
  if (arguments["threads"].as<int>() < 0)
    throw std::runtime_error("--threads must not be negative");
#ifndef CGAL_LINKED_WITH_TBB
  if (arguments["threads"].as<int>() != 1)
    throw std::runtime_error("--threads: this npbs_mesh was built without TBB");
#endif
}

/// what the user asks for, else what `parameters` hold, else the default that --help shows
template <class Parameters, class Tag>
int count(const po::variable_value& argument, const Parameters& parameters, Tag tag)
{
  using namespace CGAL::parameters;
  if (!argument.defaulted())
    return argument.as<int>();
  return static_cast<int>(choose_parameter(get_parameter(parameters, tag), argument.as<int>()));
}

using Size = std::function<double(const Point&)>;

/// calls npbs_relax with what the arguments say, on top of `parameters`
template <class Parameters>
Report relax(Domain& domain, const Region_map& regions, const po::variables_map& arguments, const Size& size,
             const Parameters& parameters)
{
  namespace np = CGAL::internal_np;
  using Pinned = CGAL::Boolean_property_map<const std::set<CDT::Vertex_handle>>;
  Progress_bar bar(arguments.count("quiet") == 0);
  const auto all =
    parameters.number_of_rounds(count(arguments["rounds"], parameters, np::number_of_rounds))
      .number_of_iterations(count(arguments["iterations"], parameters, np::number_of_iterations))
      .maximum_number_of_bubbles(arguments["max-bubbles"].as<long>())
      .size_growth(arguments["size-growth"].as<double>())
      .minimum_angle(arguments["minimum-angle"].as<double>())
      .vertex_is_constrained_map(Pinned(domain.pinned))
      .edge_marker_map(Segment_marker_map{&domain})
      .face_region_map(regions)
      .concurrency_tag(CGAL::Parallel_if_available_tag())
      .callback([&bar](double fraction) {
        bar.show(fraction);
        return is_interrupted == 0; // Ctrl-C stops the simulation and keeps its mesh
      });
  return size ? CGAL::npbs_relax(domain.cdt, all.sizing_function(size))
              : CGAL::npbs_relax(domain.cdt, all);
}

/// what npbs_relax says, in the words of the command line
std::string in_words_of_options(std::string text)
{
  const std::pair<std::string, std::string> words[] = {
    {"Bubble_relaxation_2: ", ""},
    {"maximum_number_of_bubbles", "--max-bubbles"},
    {"gradation", "--gradation"},
    {"size_growth", "--size-growth"},
    {"minimum_angle", "--minimum-angle"},
    {"relative_outline_tolerance", "--tolerance"},
    {"minimum_island_area", "--min-island"},
    {"minimum_gap", "--min-gap"},
    {"number_of_rounds", "--rounds"},
    {"number_of_iterations", "--iterations"},
    {"parameter --", "--"},
    {"the sizing function", "--size"}};
  for (const auto& word : words) {
    const std::size_t found = text.find(word.first);
    if (found != std::string::npos)
      text.replace(found, word.first.size(), word.second);
  }
  return text;
}

/// the input as messages call it
std::string input_name(const po::variables_map& arguments)
{
  const std::string input = arguments["input"].as<std::string>();
  return input == "-" ? "standard input" : input;
}

/// The size, limited as --gradation asks.
/// \throws std::runtime_error with the name of the input
Size limited_size(Domain& domain, const po::variables_map& arguments, const Size& size)
try {
  using Limited = CGAL::Gradation_limited_sizing_field_2<CDT>;
  using Pinned = CGAL::Boolean_property_map<const std::set<CDT::Vertex_handle>>;
  if (arguments.count("gradation") == 0)
    return size;
  const double g = arguments["gradation"].as<double>();
  if (!size)
    return Limited(domain.cdt, g, CGAL::Bubble_relaxation_parameters::vertex_is_constrained_map(Pinned(domain.pinned))
                                    .edge_marker_map(Segment_marker_map{&domain}));
  return Limited(domain.cdt, g, CGAL::Bubble_relaxation_parameters::sizing_function(size));
} catch (const std::exception& e) {
  throw std::runtime_error(input_name(arguments) + ": " + in_words_of_options(e.what()));
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

/// The sizes that --size asks for, nothing without it.
/// \throws std::runtime_error with the name of the input
Size wanted_size(const Domain& domain, const po::variables_map& arguments, const std::optional<Size_formula>& formula)
try {
  return formula ? size_in_domain(*formula, domain) : Size();
} catch (const std::exception& e) {
  throw std::runtime_error(input_name(arguments) + ": " + in_words_of_options(e.what()));
}

/// Replaces the outline if --tolerance asks for it, and tells what it was replaced by.
/// \throws std::runtime_error with the name of the input
void simplify(Domain& domain, const po::variables_map& arguments, const std::optional<Size_formula>& formula)
try {
  if (arguments.count("tolerance") == 0)
    return;
  const Size size = wanted_size(domain, arguments, formula);
  const auto report = simplify_domain(domain, CGAL::Bubble_relaxation_parameters::sizing_function(size)
                                                .relative_outline_tolerance(arguments["tolerance"].as<double>())
                                                .minimum_island_area(arguments["min-island"].as<double>())
                                                .minimum_gap(arguments["min-gap"].as<double>()));
  if (arguments.count("quiet") == 0)
    std::cout << "outline\n" << report;
  if (arguments.count("simplification-report") > 0)
    write_simplification(arguments["simplification-report"].as<std::string>(), report);
} catch (const std::exception& e) {
  throw std::runtime_error(input_name(arguments) + ": " + in_words_of_options(e.what()));
}

void write_files(const Domain& domain, const Region_map& regions, const Report& report,
                 const po::variables_map& arguments, const Size& size)
{
  if (arguments.count("output") > 0)
    write_mesh_file(arguments["output"].as<std::string>(), make_mesh_arrays(domain, regions, size));
  if (arguments.count("picture") > 0) {
    Svg_picture picture;
    picture.add_mesh(domain.cdt, "mesh, coloured by q");
    picture.add_histogram(report.quality, "q = 2 r_in / r_out");
    picture.write(arguments["picture"].as<std::string>());
  }
}

/// `warn(text)` is called for all that should not be in a mesh.
template <class Warn>
void warn_of_mesh(const Domain& domain, const Report& report, const po::variables_map& arguments, const Size& size,
                  const Warn& warn)
{
  if (report.steep_share > 0)
    warn(steep_message(report));
  const std::vector<Point> ends = loose_ends(domain.cdt);
  if (!ends.empty())
    warn(loose_ends_message(ends));
  const bool is_refined = arguments.count("paper") == 0 && report.number_of_steps > 0 &&
                          report.stop_reason != CGAL::Bubble_stop_reason::STOPPED_BY_CALLBACK;
  if (is_refined && report.number_of_small_angles > 0)
    warn(small_angles_message(report, arguments["minimum-angle"].as<double>()));
  const Bad_triangle worst(domain);
  if (worst.is_bad())
    warn(worst.message(size));
}

int main(int argc, char** argv)
try {
  const po::variables_map arguments = read_arguments(argc, argv);
  check_arguments(arguments);
  std::optional<Size_formula> formula;
  if (arguments.count("size") > 0)
    formula.emplace(arguments["size"].as<std::string>());
  Domain domain =
    read_domain_file(arguments["input"].as<std::string>(), arguments["format"].as<std::string>());
  const auto warn = [&](const std::string& text) {
    std::cerr << "npbs_mesh: warning: " << input_name(arguments) << ": " << text << '\n';
  };
  for (const std::string& warning : domain.warnings)
    warn(warning);
  simplify(domain, arguments, formula);
  const Region_map regions = region_attributes(domain);
  std::signal(SIGINT, [](int) { is_interrupted = 1; });
  const Size size = limited_size(domain, arguments, wanted_size(domain, arguments, formula));
  const Report report = mesh(domain, regions, arguments, size);
  if (report.number_of_vertices == 0)
    throw std::runtime_error("interrupted before there were bubbles, nothing is written");

  if (arguments.count("quiet") == 0)
    print_statistics(report);
  if (report.stop_reason == CGAL::Bubble_stop_reason::STOPPED_BY_CALLBACK)
    std::cerr << "npbs_mesh: interrupted, the mesh is as the bubbles were\n";
  if (arguments.count("quiet") == 0 && arguments.count("size") > 0 && is_forced_by_outline(report))
    std::cerr << "npbs_mesh: hint: " << input_name(arguments) << ": "
              << forced_by_outline_message(report, arguments.count("tolerance") > 0) << '\n';
  warn_of_mesh(domain, report, arguments, size, warn);
  write_files(domain, regions, report, arguments, size);
} catch (const std::exception& e) {
  std::cerr << "npbs_mesh: " << e.what() << '\n';
  return 1;
}
