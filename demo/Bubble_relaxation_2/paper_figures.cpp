// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// Reproduces Figures 3, 5 to 13, 16 and 19 to 21 of the paper.
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
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>
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

/// the name of a figure's picture
std::string file_name(int figure, const std::string& kind)
{
  std::ostringstream name;
  name << "figure_" << std::setw(2) << std::setfill('0') << figure << '_' << kind;
  return name.str();
}

/// Figures 3 and 5: the initial bubbles of example 1, and the same after one round without population
/// control
template <class Parameters>
void show_example_1(const std::string& kind, const std::string& round, const Parameters& parameters)
{
  const paper::Domain domain = paper::square_with_hole(1);
  paper::CDT initial = paper::triangulate(domain);
  show(file_name(3, kind), "Fig. 3: initial bubbles", initial, domain.d, parameters.number_of_rounds(0));
  paper::CDT simulated = paper::triangulate(domain);
  show(file_name(5, kind), "Fig. 5: " + round, simulated, domain.d, parameters.number_of_rounds(1));
}

/// a figure of section 2.1.5
template <class Parameters>
void show_domain(const paper::Domain& domain, const std::string& kind, const Parameters& parameters)
{
  paper::CDT cdt = paper::triangulate(domain);
  show(file_name(domain.figure, kind), "Fig. " + std::to_string(domain.figure) + ": " + domain.name, cdt,
       domain.d, parameters);
}

/// Figures 19 to 21: the mesh of example 1, and `refining` it by another d
template <class Parameters, class Refining>
void show_refinement(const std::string& kind, const Parameters& parameters, const Refining& refining)
{
  const paper::Domain domain = paper::square_with_hole(1);
  paper::CDT cdt = paper::triangulate(domain);
  show(file_name(19, kind), "Fig. 19: mesh of example 1", cdt, domain.d, parameters);
  show(file_name(21, kind), "Fig. 20, 21: refined, eq. 12", cdt, paper::refined_size(1), refining);
}

void show_figures_of_paper(const std::set<int>& figures)
{
  std::cout << "with the paper's parameters and numbers of steps\n";
  print_header();
  const auto parameters = P::npbs_paper_parameters();
  if (figures.count(3) > 0)
    show_example_1("paper", "750 steps", parameters.number_of_iterations(750));
  for (const paper::Domain& d : paper::all_domains(1))
    if (figures.count(d.figure) > 0)
      show_domain(d, "paper",
                  parameters.number_of_iterations(d.iterations).number_of_rounds(d.rounds));
  const auto four_rounds = parameters.number_of_rounds(4);
  if (figures.count(19) > 0)
    show_refinement("paper", four_rounds,
                    four_rounds.initial_placement(CGAL::Bubble_placement::KEEP));
}

void show_figures_with_defaults(const std::set<int>& figures)
{
  std::cout << "\nwith the defaults\n";
  print_header();
  const auto defaults = P::force_coefficient(1.);
  if (figures.count(3) > 0)
    show_example_1("default", "one round", defaults);
  for (const paper::Domain& d : paper::all_domains(1))
    if (figures.count(d.figure) > 0)
      show_domain(d, "default", defaults);
  if (figures.count(19) > 0)
    show_refinement("default", defaults, defaults);
}

/// what is shown together goes by the number of its first figure
const std::map<int, int> figure_groups{{3, 3},   {5, 3},   {6, 6},   {7, 7},   {8, 8},   {9, 9},  {10, 10},
                                       {11, 11}, {12, 12}, {13, 13}, {16, 16}, {19, 19}, {20, 19}, {21, 19}};

/// \throws std::invalid_argument with one line for the user
std::set<int> read_figures(const std::string& list)
{
  std::set<int> figures;
  std::istringstream in(list);
  for (std::string text; std::getline(in, text, ',');) {
    int figure = 0;
    std::istringstream number(text);
    if (!(number >> figure) || !number.eof() || figure_groups.count(figure) == 0)
      throw std::invalid_argument("there is no figure '" + text + "', only 3, 5 to 13, 16 and 19 to 21");
    figures.insert(figure_groups.at(figure));
  }
  if (figures.empty())
    throw std::invalid_argument("--figures needs numbers, such as 6,12");
  return figures;
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
try {
  std::set<int> figures;
  for (const auto& group : figure_groups)
    figures.insert(group.second);
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument == "--sizes") {
      show_size(1000);
      show_size(10000);
      return 0;
    }
    if (argument != "--figures" || i + 1 == argc)
      throw std::invalid_argument("usage: paper_figures [--figures 6,12] [--sizes]");
    figures = read_figures(argv[++i]);
  }
  show_figures_of_paper(figures);
  show_figures_with_defaults(figures);
} catch (const std::exception& e) {
  std::cerr << "paper_figures: " << e.what() << '\n';
  return 1;
}
