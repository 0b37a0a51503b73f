// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef BUBBLE_RELAXATION_2_BENCHMARK_COMPARISON_H
#define BUBBLE_RELAXATION_2_BENCHMARK_COMPARISON_H

#include "meshing.h"

#include <CGAL/Mesh_quality_2.h>

#include <cmath>
#include <cstddef>
#include <iomanip>
#include <ostream>
#include <string>
#include <vector>

/// One mesher on one domain, as all are measured.
struct Comparison_row
{
  std::string mesher, domain;
  std::size_t target, vertices;
  double microseconds, floors; ///< CPU time: per vertex, and over that of the bare triangulation
  double mean_q, min_q, angle, irregular, length, deviation;
};

/// Judges a mesh by the bare triangulation of its vertices and constraints, whoever made it.
inline Comparison_row compare(const std::string& mesher, const paper::Domain& domain, std::size_t target,
                              const Measured_meshing& meshing, std::ostream& remarks)
{
  const auto q = CGAL::mesh_quality_2(meshing.bare, CGAL::parameters::sizing_function(domain.d));
  if (q.number_of_triangles() != meshing.triangles)
    remarks << mesher << ": the Delaunay triangulation of its vertices has " << q.number_of_triangles()
            << " triangles in the domain, its own mesh " << meshing.triangles << '\n';
  const double n = double(meshing.mesh.points.size());
  return {mesher, domain.name, target, meshing.mesh.points.size(), 1e6 * meshing.seconds / n,
          meshing.seconds / meshing.floor, q.mean_quality(), q.minimum_quality(), q.minimum_angle(),
          q.irregular_share(), q.mean_length_ratio(), q.length_ratio_deviation()};
}

inline void print_columns(std::ostream& out, const std::string& first)
{
  out << std::setw(20) << std::left << first << std::right << std::setw(9) << "vertices" << std::setw(11)
      << "us/vertex" << std::setw(9) << "floors" << std::setw(9) << "mean q" << std::setw(8) << "min q"
      << std::setw(8) << "angle" << std::setw(8) << "irreg." << std::setw(8) << "L/d" << std::setw(8)
      << "dev." << '\n';
}

inline void print_row(std::ostream& out, const std::string& first, const Comparison_row& r)
{
  out << std::fixed << std::setw(20) << std::left << first << std::right << std::setw(9) << r.vertices
      << std::setprecision(1) << std::setw(11) << r.microseconds << std::setw(9) << r.floors
      << std::setprecision(4) << std::setw(9) << r.mean_q << std::setprecision(3) << std::setw(8) << r.min_q
      << std::setprecision(1) << std::setw(8) << r.angle << std::setw(7) << 100 * r.irregular << '%'
      << std::setprecision(3) << std::setw(8) << r.length << std::setw(8) << r.deviation << std::endl;
}

/// A mesher over all domains: the means, and what is farthest from its ideal.
inline void print_summary(std::ostream& out, const std::vector<Comparison_row>& rows,
                          const std::vector<std::string>& meshers)
{
  const auto line = [&](const std::string& mesher, bool is_worst) {
    Comparison_row sum{mesher, "", 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
    std::size_t n = 0;
    const auto add = [&](double& total, double value, double ideal) {
      if (!is_worst)
        total += value;
      else if (n == 1 || std::abs(value - ideal) > std::abs(total - ideal))
        total = value;
    };
    for (const Comparison_row& r : rows) {
      if (r.mesher != mesher)
        continue;
      ++n;
      sum.vertices += r.vertices;
      add(sum.microseconds, r.microseconds, 0);
      add(sum.floors, r.floors, 0);
      add(sum.mean_q, r.mean_q, 1);
      add(sum.min_q, r.min_q, 1);
      add(sum.angle, r.angle, 60);
      add(sum.irregular, r.irregular, 0);
      add(sum.length, r.length, 1);
      add(sum.deviation, r.deviation, 0);
    }
    if (n == 0)
      return;
    sum.vertices /= n;
    if (!is_worst)
      for (double* value : {&sum.microseconds, &sum.floors, &sum.mean_q, &sum.min_q, &sum.angle,
                            &sum.irregular, &sum.length, &sum.deviation})
        *value /= double(n);
    print_row(out, mesher, sum);
  };
  for (bool is_worst : {false, true}) {
    out << '\n';
    print_columns(out, is_worst ? "worst of the domains" : "mean of the domains");
    for (const std::string& mesher : meshers)
      line(mesher, is_worst);
  }
}

inline void write_json(std::ostream& out, const std::vector<Comparison_row>& rows)
{
  out << "[\n" << std::setprecision(6);
  for (const Comparison_row& r : rows)
    out << "  {\"mesher\": \"" << r.mesher << "\", \"domain\": \"" << r.domain << "\", \"target\": " << r.target
        << ", \"vertices\": " << r.vertices << ", \"microseconds_per_vertex\": " << r.microseconds
        << ", \"floors\": " << r.floors << ", \"mean_q\": " << r.mean_q << ", \"min_q\": " << r.min_q
        << ", \"smallest_angle\": " << r.angle << ", \"irregular_share\": " << r.irregular
        << ", \"mean_length_ratio\": " << r.length << ", \"length_ratio_deviation\": " << r.deviation << '}'
        << (&r == &rows.back() ? "\n" : ",\n");
  out << "]\n";
}

#endif // BUBBLE_RELAXATION_2_BENCHMARK_COMPARISON_H
