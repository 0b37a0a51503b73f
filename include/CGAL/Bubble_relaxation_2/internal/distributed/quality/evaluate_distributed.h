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
#include <iterator>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// What the values of all ranks are like, for statistics that are the same as if one rank had them all. All
/// members are collective. See `Team`.
class Values_of_all_ranks : public Team
{
public:
  explicit Values_of_all_ranks(Communicator& comm) : m_comm(comm) {}

  bool is_alone() const override { return false; }
  double smallest(double value) const override { return m_comm.smallest(value); }
  double largest(double value) const override { return m_comm.largest(value); }

  void add_up(std::size_t* counts, std::size_t n) const override
  {
    std::vector<std::uint64_t> sums(counts, counts + n);
    check_mpi(
      MPI_Allreduce(MPI_IN_PLACE, sums.data(), static_cast<int>(n), MPI_UINT64_T, MPI_SUM, m_comm.handle()));
    std::copy(sums.begin(), sums.end(), counts);
  }

  /// Finds them byte after byte: how many values that begin as far as is known go on with which byte tells the
  /// next one. No rank gets values of others, nor all positions a walk over all values.
  std::vector<double> sorted_at(std::vector<double>& values, const std::vector<std::size_t>& positions) const override
  {
    const std::size_t n = positions.size();
    std::vector<std::uint64_t> candidates(values.size());
    std::transform(values.begin(), values.end(), candidates.begin(), bits);
    std::vector<std::uint64_t> found(n, 0), rest(positions.begin(), positions.end());
    for (int shift = 56; shift >= 0; shift -= 8) {
      const std::vector<std::uint64_t> known = distinct(found);
      std::vector<std::size_t> counts(known.size() * 256, 0);
      const auto leave = [&](std::uint64_t candidate) { return !count(candidate, shift, known, counts); };
      candidates.erase(std::remove_if(candidates.begin(), candidates.end(), leave), candidates.end());
      add_up(counts.data(), counts.size());
      for (std::size_t k = 0; k < n; ++k) {
        const auto place = std::lower_bound(known.begin(), known.end(), found[k]) - known.begin();
        add_byte(&counts[static_cast<std::size_t>(place) * 256], found[k], rest[k]);
      }
    }
    std::vector<double> result;
    std::transform(found.begin(), found.end(), std::back_inserter(result), number);
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

  /// what is known of the values at several positions, sorted: at first there is little that differs
  static std::vector<std::uint64_t> distinct(std::vector<std::uint64_t> result)
  {
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

  /// counts the next byte of a candidate that begins as one of those that are known; whether it does
  static bool count(std::uint64_t candidate, int shift, const std::vector<std::uint64_t>& known,
                    std::vector<std::size_t>& counts)
  {
    const std::uint64_t first_bytes = shift == 56 ? 0 : candidate >> (shift + 8);
    for (std::size_t k = 0; k < known.size(); ++k)
      if (known[k] == first_bytes) {
        ++counts[k * 256 + (candidate >> shift & 255)];
        return true;
      }
    return false;
  }

  static void add_byte(const std::size_t* counts, std::uint64_t& found, std::uint64_t& rest)
  {
    std::uint64_t byte = 0;
    for (; byte < 255 && rest >= counts[byte]; ++byte)
      rest -= counts[byte];
    found = found << 8 | byte;
  }

  Communicator& m_comm;
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
inline void evaluate_distributed(const Distributed_mesh_2& mesh, const Sizes_2& sizing, Communicator& comm,
                                 Report& report)
{
  const Phase_timer timer(report.seconds.evaluation);
  report.quality = distributed_quality(mesh, &sizing, comm);
  report.number_of_vertices = report.quality.number_of_vertices();
  report.number_of_triangles = report.quality.number_of_triangles();
  Size_gradient_2 gradient(Report::steep_size_gradient);
  comm.agree_after([&] { gradient = size_gradient(mesh, sizing, Threads()); });
  gradient.tell(report, Values_of_all_ranks(comm));
}

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_QUALITY_EVALUATE_DISTRIBUTED_H
