// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_TREATMENT_TREATMENT_INSIDE_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_TREATMENT_TREATMENT_INSIDE_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/Team.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mesh/Distributed_mesh_2.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Communicator.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/treatment/Border_certificate_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Editable_triangulation_2.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// Ranks that treat the defects of a mesh, each on its own or together.
class Treating_team : public Team
{
public:
  /// whether ranks speak to each other within the treatment
  virtual bool is_collective() const = 0;

  /// Collective. Whether what was done is worth nothing.
  virtual bool has_failed() const = 0;

  /// the triangles that may not be marked as what they are now
  virtual const std::vector<Index>& changed_triangles() const = 0;
};

/// A rank that treats the defects of its own part of the mesh as if it were alone, see `Team`. It may as long as
/// two things hold; else it has come too near to others.
///
/// No candidate has a neighbour of another rank: then candidates that are connected are all of one rank, their colours are
/// those that one rank alone would give them, and they are moved in the same order, among vertices that stay. And all
/// triangles that flips make are between its own bubbles: then no other rank has one of them, and every edge is locally
/// Delaunay again on the rank that changed something beside it, so the whole is Delaunay.
class Treatment_inside_2 : public Treating_team
{
public:
  Treatment_inside_2(const Communicator& comm, const Distributed_mesh_2& mesh)
    : m_comm(comm), m_mesh(mesh)
  {
    for (Index t : triangles_beside_others(mesh))
      for (Index v : mesh.triangles.vertices[t])
        m_beside_others.push_back(v);
  }

  bool is_collective() const override { return false; }

  bool goes_on_treating(bool here) override { return here && !m_is_too_near; }

  /// Collective. Whether any rank came too near to others: then what was done is worth nothing.
  bool has_failed() const override { return m_comm.any(m_is_too_near); }

  /// `values`: not 0 for candidates only
  void share(std::vector<char>& values) override
  {
    m_is_too_near = m_is_too_near || std::any_of(m_beside_others.begin(), m_beside_others.end(),
                                                 [&values](Index v) { return values[v] != 0; });
  }

  void restore_border(Editable_triangulation_2& mesh) override
  {
    const std::vector<Index> flipped = mesh.take_flipped();
    m_is_too_near = m_is_too_near || std::any_of(flipped.begin(), flipped.end(), [&](Index t) {
                      return is_beside_others(m_mesh.bubbles, mesh.vertices(t));
                    });
    m_changed.insert(m_changed.end(), flipped.begin(), flipped.end());
  }

  /// all that were flipped
  const std::vector<Index>& changed_triangles() const override { return m_changed; }

private:
  const Communicator& m_comm;
  const Distributed_mesh_2& m_mesh;
  std::vector<Index> m_beside_others; // bubbles with neighbours of other ranks, and these
  std::vector<Index> m_changed;
  bool m_is_too_near = false;
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_TREATMENT_TREATMENT_INSIDE_2_H
