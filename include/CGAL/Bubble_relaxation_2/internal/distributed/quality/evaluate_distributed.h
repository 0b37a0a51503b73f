// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_QUALITY_EVALUATE_DISTRIBUTED_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_QUALITY_EVALUATE_DISTRIBUTED_H

#include <CGAL/Bubble_relaxation_2/internal/core/Progress.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Sizes_2.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Team.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mesh/Distributed_mesh_2.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Communicator.h>
#include <CGAL/Bubble_relaxation_2/internal/quality/evaluate.h>

#include <CGAL/Mesh_quality_2.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// What the values of all ranks are like, for statistics that are the same as if one rank had them all. All
/// members are collective. See `Team`.
class Values_of_all_ranks : public Team
{
public:
  explicit Values_of_all_ranks(const Communicator& comm) : m_comm(comm) {}

  bool is_alone() const override { return false; }
  double smallest(double value) const override { return m_comm.smallest(value); }
  double largest(double value) const override { return m_comm.largest(value); }

  void add_up(std::size_t* counts, std::size_t n) const override
  {
    std::vector<std::uint64_t> sums(counts, counts + n);
    m_comm.reduce_each(sums, MPI_SUM);
    std::copy(sums.begin(), sums.end(), counts);
  }

  std::vector<double> sorted_at(std::vector<double>& values, const std::vector<std::size_t>& positions) const override
  {
    std::sort(values.begin(), values.end());
    std::vector<double> result;
    for (std::uint64_t found :
         find_sorted(m_comm, values, bits, std::vector<std::int64_t>(positions.begin(), positions.end())))
      result.push_back(number(found));
    return result;
  }

private:
  /// of numbers that are not negative; they have the order of their bits
  static std::uint64_t bits(double value)
  {
    value += 0.; // there is a negative zero
    std::uint64_t result;
    std::memcpy(&result, &value, sizeof(result));
    return result;
  }

  static double number(std::uint64_t bits)
  {
    double result;
    std::memcpy(&result, &bits, sizeof(result));
    return result;
  }

  const Communicator& m_comm;
};

/// Collective. The statistics of the mesh of all ranks, on all ranks the same as one rank alone would find them,
/// to the last bit. `sizing`: a pointer to the sizing field, or null if there are to be no lengths. What it
/// throws on one rank all throw.
inline Mesh_quality_2<double> distributed_quality(const Distributed_mesh_2& mesh, const Sizes_2* sizing,
                                                  Communicator& comm)
{
  Mesh_quality_accumulator_2 accumulator;
  comm.agree_after([&] {
    const std::size_t n = mesh.triangles.number_of_triangles();
    add_triangles(mesh, 0, n, accumulator);
    add_vertices(mesh, accumulator);
    if (sizing != nullptr)
      add_lengths(mesh, 0, n, *sizing, accumulator);
  });
  return Mesh_quality_2<double>(accumulator.statistics(Values_of_all_ranks(comm)));
}

/// Collective. Puts the statistics of the mesh of all ranks into the report, as `evaluate()` does of that of one.
/// What d throws on one rank all throw.
inline void evaluate_distributed(const Distributed_mesh_2& mesh, const Problem_2& problem, Communicator& comm,
                                 Report& report)
{
  const Phase_timer timer(report.seconds.evaluation);
  tell_wanted_number(problem, report);
  report.quality = distributed_quality(mesh, &problem.sizes, comm);
  report.number_of_vertices = report.quality.number_of_vertices();
  report.number_of_triangles = report.quality.number_of_triangles();
  Size_gradient_2 gradient(Report::steep_size_gradient);
  std::optional<Small_angles_2> small;
  comm.agree_after([&] {
    gradient = size_gradient(mesh, problem.wanted, Threads());
    small.emplace(problem.whole_domain(), problem.options.minimum_angle);
    small->add(mesh);
  });
  gradient.tell(report, Values_of_all_ranks(comm));
  small->tell(report, Values_of_all_ranks(comm));
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_QUALITY_EVALUATE_DISTRIBUTED_H
