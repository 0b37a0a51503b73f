// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_TREATMENT_PIECE_STITCHING_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_TREATMENT_PIECE_STITCHING_2_H

#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Communicator.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Messages.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/parts/bubble_records.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/treatment/Mesh_piece_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Mesh_stitching_2.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

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

/// What operations make of their patches, in the words of all ranks.
struct Patch_change_2
{
  std::vector<Changed_bubble_2> bubbles; ///< all of the patches; what is inserted comes in the order of its numbers
  std::vector<Changed_triangle_2> triangles;
};

/// changes by the places of single operations
using Patch_changes_2 = std::map<std::int32_t, Patch_change_2>;

/// Collective. The changes of all ranks of which this one knows some bubble. All get all: operations are few.
inline Patch_changes_2 changes_known_here(const Communicator& comm, const Bubbles_2& known, const Patch_change_2& own)
{
  Patch_changes_2 result;
  const auto all_bubbles = gather_records(comm, own.bubbles);
  for (const Changed_bubble_2& b : all_bubbles)
    if (known.index_of(b.bubble.id) != no_index)
      result[b.operation];
  const auto sort_in = [&result](const auto& all, auto part) {
    for (const auto& t : all) {
      const auto found = result.find(t.operation);
      if (found != result.end())
        (found->second.*part).push_back(t);
    }
  };
  sort_in(all_bubbles, &Patch_change_2::bubbles);
  sort_in(gather_records(comm, own.triangles), &Patch_change_2::triangles);
  return result;
}

/// Puts what operations made of patches in their place in the pieces of all ranks, as far as each piece reaches. Bubbles
/// are numbered without gaps then, as on one rank.
class Piece_stitching_2
{
public:
  Piece_stitching_2(Mesh_piece_2& piece, Communicator& comm)
    : m_piece(piece), m_known(piece.mesh.bubbles), m_triangles(piece.mesh.triangles), m_comm(comm)
  {}

  bool has_changed_outline = false; ///< of the whole domain

  /// Collective. `end`: the first number of an inserted bubble. Returns whether all pieces are still wide enough.
  bool operator()(const Patch_changes_2& changes, std::int64_t end)
  {
    m_end = end;
    Mesh_stitching_2 stitching(m_piece.mesh);
    replace(changes, stitching);
    const std::vector<std::int64_t> gone = gone_of_ours();
    Editable_triangulation_2 mesh = stitching.finish();
    Border_certificate_2 certificate(m_piece.mesh);
    const bool is_wide_enough = forget_doubtful(triangles_beside_others(m_piece.mesh), certificate, mesh);
    close_gaps(gone);
    link_with_others(m_comm, m_piece);
    m_piece.mesh.mark_triangles(m_comm.rank());
    has_changed_outline = m_comm.any(has_changed_outline);
    return !m_comm.any(!is_wide_enough);
  }

private:
  using Triangles = std::map<std::array<Index, 3>, Index>; // by their vertices, in order

  void replace(const Patch_changes_2& changes, Mesh_stitching_2& stitching)
  {
    const Triangles before = triangles_between(changes);
    for (const auto& change : changes) {
      std::vector<Index> taken_away;
      std::vector<New_triangle_2> made;
      for (const Changed_bubble_2& b : change.second.bubbles)
        replace(b);
      for (const Changed_triangle_2& t : change.second.triangles) {
        const std::array<Index, 3> v = indices(t);
        const auto known_before = before.find(sorted(v));
        if (!t.is_new && known_before != before.end())
          taken_away.push_back(known_before->second);
        if (t.is_new && sorted(v).front() != no_index)
          made.push_back(New_triangle_2{v, t.edges});
      }
      stitching.replace(taken_away, made);
    }
  }

  /// the triangles of the piece between bubbles of the changes
  Triangles triangles_between(const Patch_changes_2& changes) const
  {
    std::vector<char> is_changed(m_known.size(), 0);
    for (const auto& change : changes)
      for (const Changed_bubble_2& b : change.second.bubbles) {
        const Index i = m_known.index_of(b.bubble.id);
        if (i != no_index)
          is_changed[i] = 1;
      }
    Triangles result;
    for (std::size_t t = 0; t < m_triangles.inside.size(); ++t) {
      const std::array<Index, 3>& v = m_triangles.vertices[t];
      if (m_triangles.inside[t] && is_changed[v[0]] && is_changed[v[1]] && is_changed[v[2]])
        result[sorted(v)] = static_cast<Index>(t);
    }
    return result;
  }

  static std::array<Index, 3> sorted(std::array<Index, 3> v)
  {
    std::sort(v.begin(), v.end());
    return v;
  }

  std::array<Index, 3> indices(const Changed_triangle_2& t) const
  {
    return {m_known.index_of(t.vertices[0]), m_known.index_of(t.vertices[1]), m_known.index_of(t.vertices[2])};
  }

  void replace(const Changed_bubble_2& changed)
  {
    const Bubble_record_2& r = changed.bubble;
    Bubbles_2& b = m_known;
    const Index i = m_known.index_of(r.id);
    if (i == no_index) {
      if (r.id >= m_end) { // else it is not known here
        add(b, r, changed.owner);
        has_changed_outline = has_changed_outline || r.dimension == Bubbles_2::EDGE;
      }
      return;
    }
    const bool is_gone = r.dimension == Bubbles_2::GONE;
    has_changed_outline = has_changed_outline || (b.is_on_edge(i) && (is_gone || Point(r.x, r.y) != b.point(i)));
    if (is_gone) {
      b.remove(i);
      return;
    }
    b.x[i] = r.x;
    b.y[i] = r.y;
    b.s[i] = r.s;
    b.host[i] = r.host;
  }

  /// the identities of bubbles of this rank that are gone
  std::vector<std::int64_t> gone_of_ours() const
  {
    std::vector<std::int64_t> gone;
    for (std::size_t i = 0; i < m_known.size(); ++i)
      if (m_known.is_gone(i) && m_known.owner[i] == m_comm.rank())
        gone.push_back(m_known.id[i]);
    return gone;
  }

  void close_gaps(const std::vector<std::int64_t>& gone_here)
  {
    std::vector<std::int64_t> gone = gather_records(m_comm, gone_here);
    std::sort(gone.begin(), gone.end());
    std::size_t before = 0;
    for (std::int64_t& number : m_known.id) {
      while (before < gone.size() && gone[before] < number)
        ++before;
      number -= static_cast<std::int64_t>(before);
    }
  }

  Mesh_piece_2& m_piece;
  Bubbles_2& m_known;
  const Marked_triangles_2& m_triangles;
  Communicator& m_comm;
  std::int64_t m_end = 0;
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_TREATMENT_PIECE_STITCHING_2_H
