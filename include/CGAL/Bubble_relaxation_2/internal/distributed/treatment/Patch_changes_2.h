// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_TREATMENT_PATCH_CHANGES_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_TREATMENT_PATCH_CHANGES_2_H

#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Communicator.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Messages.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/parts/Lists_of_few.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/parts/bubble_records.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/treatment/Border_certificate_2.h>

#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// a bubble of a patch after an operation, `GONE` if it was deleted
struct Changed_bubble_2
{
  std::int32_t operation; ///< the place of the operation among all, the worst triangle's first
  std::int32_t owner;
  Bubble_record_2 bubble;
};

/// a triangle that an operation takes away or makes
struct Changed_triangle_2
{
  std::int32_t operation;
  std::int32_t is_new;
  std::array<std::int64_t, 3> vertices; ///< their numbers
  std::array<Index, 3> edges;           ///< labels
};

/// What an operation makes of a patch, in the words of all ranks.
struct Patch_change_2
{
  std::vector<Changed_bubble_2> bubbles; ///< all of the patch; what is inserted comes in the order of its numbers
  std::vector<Changed_triangle_2> triangles;
};

/// changes by the places of their operations
using Patch_changes_2 = std::map<std::int32_t, Patch_change_2>;

/// Tells all ranks that know bubbles of a patch what became of it: first the owners of its bubbles, who know which
/// other ranks know them.
class Patch_announcement_2
{
public:
  Patch_announcement_2(const Mesh_piece_2& piece, Communicator& comm)
    : m_known(piece.mesh.bubbles), m_comm(comm), m_takers(piece.mesh.bubbles.size())
  {
    for (const auto& list : piece.sent)
      for (Index i : list.second)
        m_takers.add(i, list.first);
  }

  /// Collective. Returns the changes of all ranks that are known here.
  Patch_changes_2 operator()(const Patch_changes_2& own)
  {
    const Patch_changes_2 at_owners = tell(own, [](const Patch_change_2& change) {
      std::set<int> ranks;
      for (const Changed_bubble_2& b : change.bubbles)
        ranks.insert(b.owner);
      return ranks;
    });
    return tell(at_owners, [this](const Patch_change_2& change) { return takers(change); });
  }

private:
  /// the ranks that know own bubbles, this one among them
  std::set<int> takers(const Patch_change_2& change) const
  {
    std::set<int> ranks{m_comm.rank()};
    for (const Changed_bubble_2& b : change.bubbles) {
      const Index i = b.owner == m_comm.rank() ? m_known.index_of(b.bubble.id) : no_index;
      if (i != no_index) // else it is of another rank, or inserted
        ranks.insert(m_takers[i].begin(), m_takers[i].end());
    }
    return ranks;
  }

  template <class Ranks_of>
  Patch_changes_2 tell(const Patch_changes_2& changes, const Ranks_of& ranks_of)
  {
    Messages<Changed_bubble_2> bubbles;
    Messages<Changed_triangle_2> triangles;
    for (const auto& change : changes)
      for (int rank : ranks_of(change.second)) {
        const Patch_change_2& c = change.second;
        bubbles[rank].insert(bubbles[rank].end(), c.bubbles.begin(), c.bubbles.end());
        triangles[rank].insert(triangles[rank].end(), c.triangles.begin(), c.triangles.end());
      }
    Patch_changes_2 result;
    collect(deliver(m_comm, bubbles), result, &Patch_change_2::bubbles);
    collect(deliver(m_comm, triangles), result, &Patch_change_2::triangles);
    return result;
  }

  /// several ranks may tell the same: the first counts
  template <class T>
  static void collect(const Messages<T>& in, Patch_changes_2& result, std::vector<T> Patch_change_2::*part)
  {
    std::map<std::int32_t, int> teller;
    for (const auto& message : in)
      for (const T& t : message.second)
        if (teller.emplace(t.operation, message.first).first->second == message.first)
          (result[t.operation].*part).push_back(t);
  }

  const Bubbles_2& m_known;
  Communicator& m_comm;
  Lists_of_few<int> m_takers; // the other ranks that know own bubbles
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_TREATMENT_PATCH_CHANGES_2_H
