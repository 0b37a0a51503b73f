// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// Reproduces Figures 3, 5 to 13 and 19 to 21 of the paper.
//
//   paper_figures                 all figures: pictures, and a table with a row a figure, first with the
//                                 paper's parameters and numbers of steps, then with the defaults
//   paper_figures --figures 6,12  some of them
//   paper_figures --sizes         the defaults at about 1000 and 10 000 vertices on every domain

#include "paper_domains.h"
#include "svg_picture.h"

#include <CGAL/npbs_relax.h>

#include <cmath>
#include <iomanip>
#include <iostream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace P = CGAL::parameters;
using Report = CGAL::Bubble_relaxation_report_2<double>;

void print_header()
{
  std::cout << std::left << std::setw(34) << "figure" << std::right << std::setw(8) << "N"
            << std::setw(7) << "steps" << std::setw(8) << "mean q" << std::setw(7) << "min q"
            << std::setw(7) << "angle" << std::setw(8) << "irreg." << std::setw(7) << "L/d"
            << std::setw(7) << "dev." << '\n';
}

void print_row(const std::string& name, const Report& r)
{
  const auto& q = r.quality;
  std::cout << std::fixed << std::left << std::setw(34) << name << std::right << std::setw(8)
            << r.number_of_vertices << std::setw(7) << r.number_of_steps << std::setprecision(4)
            << std::setw(8) << q.mean_quality() << std::setprecision(3) << std::setw(7)
            << q.minimum_quality() << std::setprecision(1) << std::setw(7) << q.minimum_angle()
            << std::setw(7) << 100 * q.irregular_share() << '%' << std::setprecision(3)
            << std::setw(7) << q.mean_length_ratio() << std::setw(7) << q.length_ratio_deviation()
            << '\n';
}

/// meshes a domain, writes its pictures, prints its row
template <class Parameters>
Report show(const std::string& file, const std::string& name, paper::CDT& cdt, const paper::Sizing& d,
            const Parameters& parameters)
{
  const Report report = CGAL::npbs_relax(cdt, parameters.sizing_function(d));
  Svg_picture picture;
  picture.add_nodes(cdt, name + ": nodes");
  picture.add_mesh(cdt, "mesh");
  picture.add_histogram(report.quality, "q = 2 r_in / r_out");
  picture.write(file + ".svg");
  print_row(name, report);
  return report;
}

/// Figures 3 and 5: the initial bubbles of example 1, and the same after 750 steps, one round
void show_example_1()
{
  const paper::Domain domain = paper::square_with_hole(1);
  paper::CDT initial = paper::triangulate(domain);
  show("figure_03_paper", "Fig. 3: initial bubbles", initial, domain.d,
       P::npbs_paper_parameters().number_of_rounds(0));
  paper::CDT simulated = paper::triangulate(domain);
  show("figure_05_paper", "Fig. 5: 750 steps", simulated, domain.d,
       P::npbs_paper_parameters().number_of_rounds(1).number_of_iterations(750));
}

/// Figures 19 to 21: the mesh of example 1, refined by another d
template <class Parameters>
void show_refinement(const std::string& kind, const Parameters& parameters)
{
  const paper::Domain domain = paper::square_with_hole(1);
  paper::CDT cdt = paper::triangulate(domain);
  show("figure_19_" + kind, "Fig. 19: mesh of example 1", cdt, domain.d, parameters);
  show("figure_21_" + kind, "Fig. 20, 21: refined, eq. 12", cdt, paper::refined_size(1),
       parameters.initial_placement(CGAL::Bubble_placement::KEEP));
}

void show_figures(const std::set<int>& figures)
{
  const auto wanted = [&](int figure) { return figures.empty() || figures.count(figure) > 0; };
  std::cout << "with the paper's parameters and numbers of steps\n";
  print_header();
  if (wanted(3) || wanted(5))
    show_example_1();
  for (const paper::Domain& d : paper::all_domains(1)) {
    if (!wanted(d.figure))
      continue;
    paper::CDT cdt = paper::triangulate(d);
    std::ostringstream file;
    file << "figure_" << std::setw(2) << std::setfill('0') << d.figure << "_paper";
    show(file.str(), "Fig. " + std::to_string(d.figure) + ": " + d.name, cdt, d.d,
         P::npbs_paper_parameters().number_of_iterations(d.iterations).number_of_rounds(d.rounds));
  }
  if (wanted(19))
    show_refinement("paper", P::npbs_paper_parameters().number_of_rounds(4));

  std::cout << "\nwith the defaults\n";
  print_header();
  for (const paper::Domain& d : paper::all_domains(1)) {
    if (!wanted(d.figure))
      continue;
    paper::CDT cdt = paper::triangulate(d);
    std::ostringstream file;
    file << "figure_" << std::setw(2) << std::setfill('0') << d.figure << "_default";
    show(file.str(), "Fig. " + std::to_string(d.figure) + ": " + d.name, cdt, d.d,
         P::force_coefficient(1.));
  }
  if (wanted(19)) {
    const paper::Domain domain = paper::square_with_hole(1);
    paper::CDT cdt = paper::triangulate(domain);
    show("figure_19_default", "Fig. 19: mesh of example 1", cdt, domain.d, P::force_coefficient(1.));
    show("figure_21_default", "Fig. 20, 21: refined, eq. 12", cdt, paper::refined_size(1),
         P::force_coefficient(1.));
  }
}

/// the defaults at about `n` vertices: d is scaled by what comes out at first
void show_size(std::size_t n)
{
  std::cout << "\ndefaults, about " << n << " vertices\n";
  print_header();
  for (std::size_t k = 0; k < paper::all_domains(1).size(); ++k) {
    double f = 1;
    Report report;
    for (int attempt = 0; attempt < 3; ++attempt) {
      const paper::Domain domain = paper::all_domains(f)[k];
      paper::CDT cdt = paper::triangulate(domain);
      report = CGAL::npbs_relax(cdt, P::sizing_function(domain.d));
      const double ratio = double(report.number_of_vertices) / double(n);
      if (std::abs(ratio - 1) < 0.05)
        break;
      f *= std::sqrt(ratio);
    }
    const paper::Domain domain = paper::all_domains(f)[k];
    print_row("Fig. " + std::to_string(domain.figure) + ": " + domain.name, report);
  }
}

int main(int argc, char** argv)
{
  std::set<int> figures;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument == "--sizes") {
      show_size(1000);
      show_size(10000);
      return 0;
    }
    if (argument != "--figures" || i + 1 == argc) {
      std::cerr << "usage: paper_figures [--figures 6,12] [--sizes]\n";
      return 1;
    }
    std::istringstream list(argv[++i]);
    for (std::string number; std::getline(list, number, ',');)
      figures.insert(std::stoi(number));
  }
  show_figures(figures);
}
