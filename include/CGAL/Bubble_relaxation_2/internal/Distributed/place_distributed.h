// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_PLACE_DISTRIBUTED_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_PLACE_DISTRIBUTED_H

#include <CGAL/Bubble_relaxation_2/internal/Distributed/Agreement.h>
#include <CGAL/Bubble_relaxation_2/internal/Distributed/Growth_team_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Distributed/distribute_bubbles.h>
#include <CGAL/Bubble_relaxation_2/internal/place_bubbles.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// bubbles of one rank, and who owns what
struct Placed_part_2
{
  Numbered_bubbles_2 bubbles;
  Hilbert_partition_2 partition;
};

/// The initial bubbles, each on the rank that owns its place. All ranks put bubbles on the outline, which all of
/// them have; the faces are filled by all together.
template <class Cdt, class Sizing>
Placed_part_2 place_distributed(const Communicator& comm, Sparse_exchange& exchange, Agreement& agreement,
                                const Cdt& cdt, const Domain_reading_2<Cdt>& reading, const Sizing& sizing,
                                const Relaxation_options& options)
{
  const Domain_2& domain = reading.domain;
  const Hilbert_curve_2 curve(domain.bbox());
  Growth_team_2 team(comm, exchange, agreement);
  Bubbles_2 bubbles = place_on_all<Sequential_tag>(cdt, reading, sizing, options, team);
  agreement.reach();
  remove_crowded_on_edges(domain, bubbles);
  std::vector<Keyed_record_2> records;
  for (std::size_t i = 0; i < bubbles.size(); ++i) {
    const bool is_ours = team.is_divided() ? team.owns(static_cast<Index>(i)) : comm.rank() == 0;
    if (!bubbles.is_gone(i) && is_ours)
      records.push_back(Keyed_record_2{curve.key(bubbles.x[i], bubbles.y[i]), record(bubbles, i, 0)});
  }
  const Hilbert_partition_2 partition = even_partition(comm, curve, records);
  records = bring_home(partition, exchange, comm.rank(), records);
  forget_coincident(records);
  return Placed_part_2{number_along_curve(comm, records), partition};
}

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_PLACE_DISTRIBUTED_H
