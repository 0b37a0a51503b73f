// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// An adaptive loop that pays for what it changes: Laplace's equation on the L-shape, as in adaptive_poisson, but in
// each cycle the mesh is made anew only where the error asks for smaller triangles, and the solver starts from the
// solution before. At the end all meshes together are compared with the last one, made at once with the same d.
//
//   adaptive_cycles [--nodes N]

#include "adaptive_cycles.h"
#include "paper_domains.h"

#include <cstdlib>
#include <exception>
#include <iomanip>
#include <iostream>
#include <stdexcept>
#include <string>

namespace {

Cycle_options read_arguments(int argc, char** argv)
{
  Cycle_options result;
  char* end = nullptr;
  if (argc == 3 && std::string(argv[1]) == "--nodes")
    result.nodes = std::strtod(argv[2], &end);
  if (argc != 1 && (end == nullptr || end == argv[2] || *end != '\0' || !(result.nodes > 0) || result.nodes > 1e7))
    throw std::invalid_argument("usage: adaptive_cycles [--nodes N], N positive, 1e7 at most");
  return result;
}

constexpr const char* head =
  "                            seconds                             solver's                            smallest\n"
  "   cycle  vertices      new  meshing carrying   sizing  solving   steps   error H1   estimate   error L2       q\n";

void print(const std::string& name, const Adaptive_cycle& c)
{
  std::cout << std::setw(8) << name << std::setw(10) << c.vertices << std::setw(9) << c.new_vertices << std::fixed
            << std::setprecision(3);
  for (double seconds : {c.meshing, c.carrying, c.sizing, c.solving})
    std::cout << std::setw(9) << seconds;
  std::cout << std::setw(8) << c.iterations << std::scientific << std::setprecision(2);
  for (double error : {c.error.h1, c.estimate, c.error.l2})
    std::cout << std::setw(11) << error;
  std::cout << std::fixed << std::setprecision(3) << std::setw(8) << c.minimum_quality << std::endl;
}

} // namespace

int main(int argc, char** argv)
try {
  Adaptive_cycles<paper::CDT> loop(read_arguments(argc, argv));
  std::cout << head;
  int number = 0;
  const auto cycles = loop([&](const Adaptive_cycle& c) { print(std::to_string(++number), c); });
  const Adaptive_cycle once = loop.at_once();
  print("at once", once);

  double meshing = 0, carrying = 0, sizing = 0;
  std::size_t vertices = 0;
  for (const Adaptive_cycle& c : cycles) {
    meshing += c.meshing;
    carrying += c.carrying;
    sizing += c.sizing;
    vertices += c.new_vertices;
  }
  const Adaptive_cycle& last = cycles.back();
  std::cout << std::setprecision(2) << "all meshes over the last one at once: time " << meshing / once.meshing
            << ", with values carried over " << (meshing + carrying) / once.meshing << ", and with the choice of d "
            << (meshing + carrying + sizing) / once.meshing << "; new vertices "
            << double(vertices) / double(once.vertices)
            << "\nthe last mesh over the one at once: error H1 " << last.error.h1 / once.error.h1 << ", error L2 "
            << last.error.l2 / once.error.l2 << '\n';
} catch (const std::exception& e) {
  std::cerr << "adaptive_cycles: " << e.what() << '\n';
  return EXIT_FAILURE;
}
