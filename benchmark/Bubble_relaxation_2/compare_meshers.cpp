// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// This package, CGAL's 2D Meshes and Gmsh on the same domains with the same sizing function d, judged by the
// same evaluator: quality of the mesh over CPU time, per vertex and in floors (see bare_triangulation.h), all
// in one thread and measured in this run. Putting a domain into a mesher's own form is not timed, nor is reading
// its mesh. CGAL's d is scaled so that it makes as many vertices as npbs_relax; Gmsh gets d as it is. Lloyd's
// optimisation makes all its iterations, without freezing vertices: that is slower and better.
//
//   compare_meshers [OPTION ...] [VERTICES ...]     about so many vertices (default 10000)
//     --json FILE     all rows
//     --svg FILE      quality over cost, of the last number of vertices
//     --lloyd N       Lloyd's optimisation up to N vertices (default 12000): its cost grows faster than they do
//     --skip-lloyd    none of it

#include "benchmark_domains.h"
#include "cgal_meshers.h"
#include "comparison.h"
#include "quality_chart.h"
#ifdef BUBBLE_RELAXATION_2_WITH_GMSH
#include "gmsh_mesher.h"
#endif

#include "../../demo/Bubble_relaxation_2/files/file_names.h"

#include <cstdlib>
#include <exception>
#include <iomanip>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

struct Options
{
  std::vector<double> targets;
  std::string json, svg;
  double lloyd_limit = 12000;
};

Options read_options(int argc, char** argv)
{
  Options options;
  const auto value = [&](int& i) {
    if (i + 1 == argc)
      throw std::invalid_argument(std::string(argv[i]) + " needs a value");
    return std::string(argv[++i]);
  };
  for (int i = 1; i < argc; ++i) {
    const std::string a = argv[i];
    if (a == "--json")
      check_writable(options.json = value(i));
    else if (a == "--svg")
      check_writable(options.svg = value(i));
    else if (a == "--lloyd")
      options.lloyd_limit = std::atof(value(i).c_str());
    else if (a == "--skip-lloyd")
      options.lloyd_limit = 0;
    else if (std::atof(a.c_str()) >= 100)
      options.targets.push_back(std::atof(a.c_str()));
    else
      throw std::invalid_argument(a + " is no number of vertices of at least 100, nor a known option");
  }
  if (options.targets.empty())
    options.targets.push_back(1e4);
  return options;
}

class Comparison
{
public:
  explicit Comparison(double lloyd_limit) : m_lloyd_limit(lloyd_limit) {}

  const std::vector<std::string>& meshers() const { return m_meshers; }

  /// the rows of one domain, which are printed as they come
  std::vector<Comparison_row> operator()(const Domain_maker& make, double target) const
  {
    const paper::Domain domain = domain_with_vertices(make, target);
    std::vector<Comparison_row> rows;
    std::ostringstream remarks;
    const auto add = [&](std::size_t mesher, const Measured_meshing& meshing) {
      rows.push_back(compare(m_meshers[mesher], domain, std::size_t(target), meshing, remarks));
      print_row(std::cout, m_meshers[mesher], rows.back());
    };
    std::cout << '\n';
    print_columns(std::cout, domain.name);
    add(0, measure([&] { return mesh_with_bubbles(domain); }));
    const Cgal_mesher cgal(domain, rows[0].vertices);
    add(1, measure([&] { return cgal.refine_and_optimize(0); }));
    if (target <= m_lloyd_limit) {
      add(2, measure([&] { return cgal.refine_and_optimize(10); }));
      add(3, measure([&] { return cgal.refine_and_optimize(100); }));
    }
#ifdef BUBBLE_RELAXATION_2_WITH_GMSH
    add(4, measure([&] { return m_gmsh(domain, 0); }));
    add(5, measure([&] { return m_gmsh(domain, 20); }));
#endif
    std::cout << "CGAL's d is scaled by " << std::setprecision(3) << cgal.scale() << '\n' << remarks.str();
    return rows;
  }

private:
  double m_lloyd_limit;
  std::vector<std::string> m_meshers{"npbs_relax", "CGAL refine", "refine + Lloyd 10", "refine + Lloyd 100",
                                     "Gmsh Frontal", "Gmsh + Relocate2D"};
#ifdef BUBBLE_RELAXATION_2_WITH_GMSH
  Gmsh_mesher m_gmsh;
#endif
};

} // namespace

int main(int argc, char** argv)
try {
  const Options options = read_options(argc, argv);
  const Comparison comparison(options.lloyd_limit);
  std::cout << "CGAL " << CGAL_VERSION_STR << ", ";
#ifdef BUBBLE_RELAXATION_2_WITH_GMSH
  std::cout << "Gmsh " << Gmsh_mesher::version() << '\n';
#else
  std::cout << "no Gmsh: it was not found when this program was configured\n";
#endif
  std::vector<Comparison_row> all, rows;
  for (double target : options.targets) {
    rows.clear();
    for (const Domain_maker& make : compared_domains())
      for (const Comparison_row& r : comparison(make, target))
        rows.push_back(r);
    print_summary(std::cout, rows, comparison.meshers());
    all.insert(all.end(), rows.begin(), rows.end());
  }
  if (!options.json.empty())
    write_file(options.json, [&](std::ostream& out) { write_json(out, all); });
  if (!options.svg.empty())
    write_file(options.svg, [&](std::ostream& out) {
      Quality_chart(rows, comparison.meshers())
        .write(out, "Quality over cost, about " + std::to_string(rows.back().target) + " vertices, 8 domains");
    });
} catch (const std::exception& e) {
  std::cerr << "compare_meshers: " << e.what() << '\n';
  return 1;
} catch (const std::string& message) { // that is how Gmsh says it
  std::cerr << "compare_meshers: Gmsh: " << message << '\n';
  return 1;
}
