// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_INPUT_HASH_OF_DOMAIN_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_INPUT_HASH_OF_DOMAIN_H

#include <CGAL/Bubble_relaxation_2/internal/core/vocabulary.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Communicator.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_2.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Problem_2.h>

#include <cstdint>
#include <cstring>
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

  void add(const Point& p)
  {
    add(p.x());
    add(p.y());
  }

  std::uint64_t value() const { return m_hash; }

private:
  std::uint64_t m_hash = 14695981039346656037u;
};

inline std::uint64_t hash_of(const Domain_2& domain)
{
  Hash_of_numbers hash;
  for (const Point& p : domain.corners())
    hash.add(p);
  for (const Domain_edge_2& e : domain.edges()) {
    hash.add(e.source);
    hash.add(e.target);
    hash.add(e.inside_left);
    hash.add(e.inside_right);
  }
  return hash.value();
}

/// Collective. \throws std::invalid_argument on all ranks, with the words `what`, if not all have the same hash
inline void check_same(const Communicator& comm, std::uint64_t hash, const std::string& what)
{
  if (comm.smallest(hash) == comm.largest(hash))
    return;
  comm.throw_on_all(std::invalid_argument("Bubble_relaxation_2: " + what));
}

inline void check_same_domain(const Communicator& comm, const Domain_2& domain)
{
  check_same(comm, hash_of(domain), "the domain is not the same on all ranks");
}

/// Collective. \throws std::invalid_argument on all ranks if vertices in the domain, or on its edges, are not the
/// same on all
inline void check_same_vertices(const Communicator& comm, const Given_mesh_2& given)
{
  Hash_of_numbers hash;
  const auto add = [&hash](const std::vector<Point>& points) {
    hash.add(points.size());
    for (const Point& p : points)
      hash.add(p);
  };
  add(given.pinned);
  add(given.free);
  for (const std::vector<Point>& points : given.on_edge)
    add(points);
  check_same(comm, hash.value(), "the domain has not the same vertices on all ranks, or not the same are pinned");
}

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_INPUT_HASH_OF_DOMAIN_H
