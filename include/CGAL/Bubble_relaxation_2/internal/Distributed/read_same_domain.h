// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_READ_SAME_DOMAIN_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_READ_SAME_DOMAIN_H

#include <CGAL/Bubble_relaxation_2/internal/Distributed/Agreement.h>
#include <CGAL/Bubble_relaxation_2/internal/Distributed/Communicator.h>
#include <CGAL/Bubble_relaxation_2/internal/Distributed/check_same_domain.h>
#include <CGAL/Bubble_relaxation_2/internal/Domain_marks_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Domain_reading_2.h>
#include <CGAL/Bubble_relaxation_2/internal/with_sizing_field.h>

#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// what all ranks have read from the same domain
template <class Cdt>
struct Same_domain_2
{
  std::unique_ptr<Domain_marks_2<Cdt>> is_inside;
  std::unique_ptr<Domain_reading_2<Cdt>> reading;
};

/// Collective. Reads the domain with what the user pinned.
/// \throws std::invalid_argument on all ranks if one has no domain, telling which, or if they are not the same
template <class Cdt, class NamedParameters>
Same_domain_2<Cdt> read_same_domain(const Cdt& cdt, const NamedParameters& np, const Communicator& comm,
                                    Agreement& agreement)
{
  Same_domain_2<Cdt> result;
  agreement.reach_after([&] {
    try {
      result.is_inside = std::make_unique<Domain_marks_2<Cdt>>(cdt, np);
      result.reading = read_domain(cdt, np, *result.is_inside);
    } catch (const std::invalid_argument& e) {
      throw std::invalid_argument(std::string(e.what()) + " (on rank " + std::to_string(comm.rank()) + ")");
    }
  });
  check_same_domain(comm, result.reading->domain);
  return result;
}

/// Collective. \throws std::invalid_argument on all ranks if vertices in the domain, or on its edges, are not the
/// same on all
template <class Cdt>
void check_same_vertices(const Communicator& comm, const Domain_reading_2<Cdt>& reading)
{
  Hash_of_numbers hash;
  const auto add = [&hash](const std::vector<typename Cdt::Vertex_handle>& vertices) {
    hash.add(vertices.size());
    for (const auto v : vertices) {
      const Point p = Constraint_graph_2<Cdt>::to_point(v);
      hash.add(p.x());
      hash.add(p.y());
    }
  };
  add(reading.pinned);
  add(reading.free);
  for (const auto& chain : reading.graph->chains())
    add(chain.splits);
  if (comm.smallest(hash.value()) == comm.largest(hash.value()))
    return;
  comm.all_throw();
  throw std::invalid_argument("Bubble_relaxation_2: the domain has not the same vertices on all ranks, or not the "
                              "same are pinned");
}

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_READ_SAME_DOMAIN_H
