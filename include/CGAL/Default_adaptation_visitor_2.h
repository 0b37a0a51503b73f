// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_DEFAULT_ADAPTATION_VISITOR_2_H
#define CGAL_DEFAULT_ADAPTATION_VISITOR_2_H

#include <CGAL/license/Bubble_relaxation_2.h>

#include <CGAL/Bubble_relaxation_2/internal/core/disable_warnings.h>

#include <vector>

namespace CGAL {

/*!
\ingroup PkgBubbleRelaxation2Ref

\brief is told what `npbs_remesh_faces()` and `npbs_adapt()` change, and does nothing. Visitors are derived from it, and
have what they need of its functions.

\cgalModels{BubbleAdaptationVisitor_2}

\tparam CDT the triangulation
*/
template <class CDT>
struct Default_adaptation_visitor_2
{
  /// vertices
  using Vertices = std::vector<typename CDT::Vertex_handle>;

  /// faces
  using Faces = std::vector<typename CDT::Face_handle>;

  /// nothing has been changed yet
  void before_change(const Faces& /* old_faces */, const Vertices& /* removed_vertices */) {}

  /// old and new faces exist, the triangulation consists of the new ones
  void while_both_exist(const Faces& /* old_faces */, const Vertices& /* removed_vertices */,
                        const Faces& /* new_faces */, const Vertices& /* new_vertices */)
  {}

  /// all is done
  void after_change(const Faces& /* new_faces */, const Vertices& /* new_vertices */) {}
};

} // namespace CGAL

#include <CGAL/Bubble_relaxation_2/internal/core/enable_warnings.h>

#endif // CGAL_DEFAULT_ADAPTATION_VISITOR_2_H
