// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_INPUT_READ_SAME_DOMAIN_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_INPUT_READ_SAME_DOMAIN_H

#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Agreement.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Communicator.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_2.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_marks_2.h>
#include <CGAL/Bubble_relaxation_2/internal/reading/read_domain.h>
#include <CGAL/Bubble_relaxation_2/internal/sizes/read_sizes.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// the hash FNV-1a of numbers, byte by byte
class Hash_of_numbers
{
public:
  template <class T>
  void add(T number)
  {
    unsigned char bytes[sizeof(T)];
    std::memcpy(bytes, &number, sizeof(T));
    for (unsigned char byte : bytes)
      m_hash = (m_hash ^ byte) * 1099511628211u;
  }

  std::uint64_t value() const { return m_hash; }

private:
  std::uint64_t m_hash = 14695981039346656037u;
};

inline std::uint64_t hash_of(const Domain_2& domain)
{
  Hash_of_numbers hash;
  for (const Point& p : domain.corners()) {
    hash.add(p.x());
    hash.add(p.y());
  }
  for (const Domain_edge_2& e : domain.edges()) {
    hash.add(e.source);
    hash.add(e.target);
    hash.add(e.inside_left);
    hash.add(e.inside_right);
  }
  return hash.value();
}

/// Collective. \throws std::invalid_argument on all ranks if not all have the same hash of something
inline void check_same(const Communicator& comm, std::uint64_t hash, const std::string& what)
{
  if (comm.smallest(hash) == comm.largest(hash))
    return;
  comm.all_throw();
  throw std::invalid_argument("Bubble_relaxation_2: " + what + " is not the same on all ranks");
}

inline void check_same_domain(const Communicator& comm, const Domain_2& domain)
{
  check_same(comm, hash_of(domain), "the domain");
}

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

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_INPUT_READ_SAME_DOMAIN_H
