// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_SIMULATION_POPULATION_TEAM_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_SIMULATION_POPULATION_TEAM_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/Bubbles_2.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Team.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Communicator.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Messages.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/parts/Hilbert_partition_2.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/parts/Part_team_2.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/parts/bubble_records.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/simulation/Halo_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Neighbor_sets_2.h>
#include <CGAL/Bubble_relaxation_2/internal/population/Local_triangulation_2.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <unordered_map>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// where a bubble is that asks for others around it, by its reference, and as how large
struct Wide_hole_side_2
{
  double x, y, d;
};

/// Those of our bubbles among `touched` that lie beside wide holes, by the other ranks that may own bubbles across: those
/// are farther away than others ever look.
inline Messages<Wide_hole_side_2> wide_hole_sides(const Bubbles_2& bubbles, const Neighbor_sets_2& neighbors,
                                                  const std::vector<Index>& touched, const Halo_2& halo,
                                                  const Hilbert_partition_2& partition, int our_rank)
{
  using Triangulation = Local_triangulation_2;
  constexpr double largest_ratio = 4;
  Messages<Wide_hole_side_2> asked;
  for (Index i : touched) {
    // one that is asked for, and not known anyway, is not much larger; it may have left the part of its owner
    const double size = neighbors.reference_d(i);
    const double most = (0.5 * neighbors.radius() * (Triangulation::far + largest_ratio) +
                         largest_ratio * Halo_2::away_from_part) * size;
    if (!bubbles.is_ours(i) || bubbles.is_gone(i) || halo.is_ours_within(bubbles, i, most) ||
        !Triangulation::is_beside_wide_hole(bubbles, neighbors, i))
      continue;
    const Wide_hole_side_2 side{neighbors.reference_x(i), neighbors.reference_y(i), Triangulation::far * size};
    for (int rank : partition.owners_in_disc(side.x, side.y, most))
      if (rank != our_rank)
        asked[rank].push_back(side);
  }
  return asked;
}

/// The ranks that control the population together: each deletes its own bubbles and inserts in its own part.
class Population_team_2 : public Part_team_2
{
public:
  using Triangle = std::array<Index, 3>;

  Population_team_2(Communicator& comm, const Halo_2& halo) : Part_team_2(comm), m_halo(halo) {}

  /// `number`: of all bubbles that ever were
  void start(const Hilbert_partition_2& partition, std::int64_t number)
  {
    m_partition = &partition;
    m_next_number = number;
  }

  std::int64_t next_number() const { return m_next_number; }

  /// `touched`, as far as it is known of others' bubbles as well
  std::vector<Index> share_touched(const Bubbles_2& b, std::vector<Index> touched) override
  {
    std::vector<char> is_touched(b.size(), 0);
    for (Index i : touched)
      is_touched[i] = b.is_ours(i);
    share(is_touched);
    std::vector<Index> result;
    for (std::size_t i = 0; i < b.size(); ++i)
      if (is_touched[i])
        result.push_back(static_cast<Index>(i));
    return result;
  }

  void share_triangles(const Bubbles_2& b, std::vector<Triangle>& triangles) override
  {
    using Numbers = std::array<std::int64_t, 3>;
    Messages<Numbers> out;
    for (const Triangle& t : triangles) {
      const Numbers numbers{b.id[t[0]], b.id[t[1]], b.id[t[2]]};
      const std::array<int, 3> owners{m_halo.owner(t[0]), m_halo.owner(t[1]), m_halo.owner(t[2])};
      for (int k = 0; k < 3; ++k) // each once
        if (owners[k] != m_comm.rank() && std::find(owners.begin(), owners.begin() + k, owners[k]) == owners.begin() + k)
          out[owners[k]].push_back(numbers);
    }
    const std::unordered_map<std::int64_t, Index> indices = m_halo.indices_at_border(b);
    const auto index = [&indices](std::int64_t number) {
      const auto found = indices.find(number);
      return found == indices.end() ? no_index : found->second;
    };
    for (const auto& message : deliver(m_comm, out))
      for (const Numbers& n : message.second)
        triangles.push_back(Triangle{index(n[0]), index(n[1]), index(n[2])});
  }

  void share(std::vector<char>& values) override { m_halo.lists().share(m_comm, values); }
  void share(std::vector<double>& values) override { m_halo.lists().share(m_comm, values); }

  /// \pre they are sorted along the curve
  void number(Bubbles_2& inserted) override
  {
    const std::int64_t n = static_cast<std::int64_t>(inserted.size());
    std::int64_t number = m_next_number + m_comm.sum_before(n);
    m_next_number += m_comm.sum(n);
    for (std::size_t k = 0; k < inserted.size(); ++k)
      inserted.id.push_back(number++);
  }

private:
  const Halo_2& m_halo;
  std::int64_t m_next_number = 0;
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_SIMULATION_POPULATION_TEAM_2_H
