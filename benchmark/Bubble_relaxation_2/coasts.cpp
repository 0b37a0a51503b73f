// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// Real outlines: shores from GSHHG, meshed with the same wanted length everywhere by this package, by CGAL's Delaunay
// refinement and by Gmsh, one after the other in processes of their own. This package meshes the outline as it is, one
// within a tenth of the length, and one without islands under half of its square and narrows under the length:
//
//   coasts FOLDER [--size 3] [--limit 60] [--svg coast.svg] [NAME ...]
//
// FOLDER has coasts.txt, which tells where they are, and the shores as GMT writes them, NAME_RESOLUTION.txt; a name
// without resolution stands for all there are. The size is in kilometres; who takes longer than the limit, in seconds,
// is stopped.

#include "cgal_meshers.h"
#include "coast.h"
#include "in_child_process.h"
#include "outline_judgement.h"
#include "simplified_coast.h"
#ifdef BUBBLE_RELAXATION_2_WITH_GMSH
#include "gmsh_mesher.h"
#endif

#include "../../demo/Bubble_relaxation_2/files/file_names.h"
#include "../../examples/Bubble_relaxation_2/svg_picture.h"

#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <functional>
#include <iomanip>
#include <iostream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

struct Options
{
  std::string folder, svg;
  double size = 3;
  unsigned limit = 60;
  std::vector<std::string> names;
};

Options read_options(int argc, char** argv)
{
  Options options;
  for (int i = 1; i < argc; ++i) {
    const std::string a = argv[i];
    const auto value = [&] {
      if (i + 1 == argc)
        throw std::invalid_argument(a + " needs a value");
      return std::string(argv[++i]);
    };
    if (a == "--size")
      options.size = std::atof(value().c_str());
    else if (a == "--limit")
      options.limit = static_cast<unsigned>(std::atoi(value().c_str()));
    else if (a == "--svg")
      check_writable(options.svg = value());
    else if (options.folder.empty())
      options.folder = a;
    else
      options.names.push_back(a);
  }
  if (options.folder.empty() || !(options.size > 0) || options.limit == 0)
    throw std::invalid_argument("coasts FOLDER [--size KILOMETRES] [--limit SECONDS] [--svg FILE] [NAME ...]");
  return options;
}

/// what a process gives back
struct Row
{
  std::size_t vertices = 0;
  double seconds = 0, seconds_before = 0, moves = 0; ///< seconds_before: of all, those that the outline took
  bool has_moves = false, is_converged = false;
  Outline_judgement judgement;
};

/// \param outline that was meshed
Row row(const paper::CDT& outline, const Meshing& meshing)
{
  Row result;
  paper::CDT bare;
  triangulate_bare(meshing.mesh, bare);
  result.vertices = meshing.mesh.points.size();
  result.seconds = meshing.seconds;
  result.judgement = judge(bare, sharp_corners(outline));
  return result;
}

/// \param simplify changes the outline before it is meshed; the time for that counts
/// \param growth of sizes away from short parts of the outline
template <class Simplify>
Row relaxed(const paper::Domain& coast, const Simplify& simplify, double growth = 0.2)
{
  Meshing meshing;
  paper::CDT cdt = paper::triangulate(coast);
  double start = cpu_seconds();
  simplify(cdt);
  const double seconds_before = cpu_seconds() - start;
  const paper::CDT outline = cdt;
  start = cpu_seconds();
  const auto report = CGAL::npbs_relax(cdt, CGAL::parameters::sizing_function(coast.d).size_growth(growth));
  meshing.seconds = seconds_before + cpu_seconds() - start;
  meshing.mesh = vertices_and_constraints(cdt);
  Row result = row(outline, meshing);
  result.seconds_before = seconds_before;
  result.has_moves = true;
  result.moves = double(report.number_of_moves) / double(report.number_of_vertices);
  result.is_converged = report.converged;
  return result;
}

void print_columns(const std::string& coast)
{
  std::cout << std::setw(16) << std::left << coast << std::right << std::setw(9) << "vertices" << std::setw(11)
            << "us/vertex" << std::setw(9) << "outline" << std::setw(8) << "mean q" << std::setw(8) << "free q"
            << std::setw(12) << "free angle" << std::setw(6) << "<26" << std::setw(9) << "obtuse" << std::setw(8) << "moves" << '\n';
}

void print(const std::string& mesher, const Row& r)
{
  const Outline_judgement& j = r.judgement;
  std::cout << std::fixed << std::setw(16) << std::left << mesher << std::right << std::setw(9) << r.vertices
            << std::setprecision(1) << std::setw(11) << 1e6 * r.seconds / double(r.vertices) << std::setprecision(0)
            << std::setw(8) << 100 * r.seconds_before / r.seconds << '%' << std::setprecision(4)
            << std::setw(8) << j.mean_q << std::setprecision(3) << std::setw(8) << j.free_q << std::setprecision(1)
            << std::setw(12) << j.free_angle << std::setw(6) << j.under_26 << std::setprecision(2) << std::setw(8)
            << 100 * double(j.obtuse) / double(j.triangles) << '%';
  if (r.has_moves)
    std::cout << std::setprecision(1) << std::setw(8) << r.moves << (r.is_converged ? "" : "  not converged");
  std::cout << std::endl;
}

class Comparison
{
public:
  explicit Comparison(unsigned limit) : m_limit(limit) {}

  void operator()(const paper::Domain& coast) const
  {
    std::size_t corners = 0;
    for (const paper::Outline& o : coast.outlines)
      corners += o.size();
    std::cout << '\n' << coast.name << ": " << corners << " corners, " << coast.outlines.size() - 1 << " islands\n";
    const paper::CDT outline = paper::triangulate(coast);
    print_columns("");
    run("npbs_relax", [&] { return relaxed(coast, [](paper::CDT&) {}); });
    for (const auto& [name, growth] : {std::pair("  growth 0.35", 0.35), {"  growth 0.6", 0.6}, {"  growth 1", 1.}})
      run(name, [&, growth = growth] { return relaxed(coast, [](paper::CDT&) {}, growth); });
    run("  tolerance", [&] { return relaxed(coast, [&](paper::CDT& cdt) { simplify(coast, cdt); }); });
    run("  and rules", [&] { return relaxed(coast, [&](paper::CDT& cdt) { simplify_by_rules(coast, cdt); }); });
    run("CGAL refine", [&] { return row(outline, Cgal_mesher(coast).refine_and_optimize(0)); });
#ifdef BUBBLE_RELAXATION_2_WITH_GMSH
    run("Gmsh Frontal", [&] { return row(outline, Gmsh_mesher()(coast, 0)); });
#endif
  }

private:
  void run(const std::string& mesher, const std::function<Row()>& make) const
  {
    try {
      print(mesher, in_child_process<Row>([&] {
              alarm(m_limit); // ends the process
              return make();
            }));
    } catch (const std::runtime_error&) {
      std::cout << std::setw(16) << std::left << mesher << std::right << "  no mesh in " << m_limit << " s" << std::endl;
    }
  }

  unsigned m_limit;
};

/// a coast as it is, and within a tolerance and by the rules
void draw(const std::string& file_name, const paper::Domain& coast)
{
  paper::CDT cdt = paper::triangulate(coast), simplified = cdt;
  simplify_by_rules(coast, simplified);
  Svg_picture picture;
  for (paper::CDT* mesh : {&cdt, &simplified}) {
    CGAL::npbs_relax(*mesh, CGAL::parameters::sizing_function(coast.d));
    picture.add_mesh(*mesh, mesh == &cdt ? "the outline as it is" : "within d/10, without small islands and narrows");
  }
  picture.write(file_name);
}

} // namespace

int main(int argc, char** argv)
try {
  const Options options = read_options(argc, argv);
  const Comparison compare(options.limit);
  const std::vector<paper::Domain> coasts = read_coasts(options.folder, options.size, options.names);
  for (const paper::Domain& coast : coasts)
    compare(coast);
  if (!options.svg.empty())
    draw(options.svg, coasts.front());
} catch (const std::exception& e) {
  std::cerr << "coasts: " << e.what() << '\n';
  return 1;
}
