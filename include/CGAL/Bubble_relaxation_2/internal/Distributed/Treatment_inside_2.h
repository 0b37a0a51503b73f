// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_TREATMENT_INSIDE_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_TREATMENT_INSIDE_2_H

#include <CGAL/Bubble_relaxation_2/internal/Distributed/Communicator.h>
#include <CGAL/Bubble_relaxation_2/internal/Distributed/Distributed_mesh_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Distributed/forget_doubtful.h>
#include <CGAL/Bubble_relaxation_2/internal/Treatment_alone.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// A rank that treats the defects of its own part of the mesh as if it were alone, see `Treatment_alone`. So it may as
/// long as all triangles that change are between its own bubbles: then no other rank has one of them, and the mesh of
/// all ranks stays Delaunay everywhere. If one is not, it has come too near to others.
class Treatment_inside_2 : public Treatment_alone
{
public:
  Treatment_inside_2(const Communicator& comm, const Distributed_mesh_2& mesh)
    : m_comm(comm), m_mesh(mesh), m_is_beside_others(mesh.known.size(), 0)
  {
    for (Index t : triangles_beside_others(mesh.known.bubbles, mesh.triangulation))
      for (Index v : mesh.triangulation.tr.vertices[t])
        m_is_beside_others[v] = 1;
  }

  bool goes_on(bool here) const { return here && !m_is_too_near; }

  /// Collective. Whether any rank came too near to others: then what was done is worth nothing.
  bool has_failed() const { return m_comm.any(m_is_too_near); }

  void share_moves(const Marked_triangulation_2&, const Bubbles_2&, const std::vector<Index>& moved,
                   const Treatment_log_2&)
  {
    m_is_too_near = m_is_too_near ||
                    std::any_of(moved.begin(), moved.end(), [this](Index v) { return m_is_beside_others[v] != 0; });
  }

  void restore_border(Editable_triangulation_2& mesh, const Marked_triangulation_2& marked)
  {
    const std::vector<Index> flipped = mesh.take_flipped();
    for (Index t : flipped)
      for (Index v : marked.tr.vertices[t])
        m_is_too_near = m_is_too_near || m_mesh.known.bubbles.is_foreign[v];
    m_changed.insert(m_changed.end(), flipped.begin(), flipped.end());
  }

  /// all that were flipped
  const std::vector<Index>& changed_triangles() const { return m_changed; }

private:
  const Communicator& m_comm;
  const Distributed_mesh_2& m_mesh;
  std::vector<char> m_is_beside_others; // bubbles
  std::vector<Index> m_changed;
  bool m_is_too_near = false;
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_TREATMENT_INSIDE_2_H
