// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

/*!
\ingroup PkgBubbleRelaxation2Concepts
\cgalConcept

The concept `BubbleAdaptationVisitor_2` describes what is told of a part of a mesh that is meshed anew, so that data at
vertices and faces can go along. Each function is called once, in this order, if anything changes at all. `CDT` is the
type of the triangulation. A visitor is copied, unless a `std::reference_wrapper` of it is given.

Faces are those of the domain; faces out of the domain that are replaced beside a constraint are not told. Removed
vertices were inside of the part, or on its constraints; all others of the old faces stay. New faces and vertices carry
what their bases are made with, and the mark of the domain.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Default_adaptation_visitor_2<CDT>}
\cgalHasModelsEnd

\sa `CGAL::npbs_remesh_faces()`
\sa `CGAL::npbs_adapt()`
\sa `CGAL::transfer_vertex_values_2()`
*/
class BubbleAdaptationVisitor_2
{
public:
  /// is called when the new mesh of the part is known and nothing has been changed. If it throws the triangulation
  /// stays as it is. So it does, and no other function is called, if the callback still throws after that, or stops
  /// all with `restore_when_stopped`.
  void before_change(const std::vector<CDT::Face_handle>& old_faces,
                     const std::vector<CDT::Vertex_handle>& removed_vertices);

  /// is called when the new faces are in the place of the old ones, which still exist: both have their vertices, so
  /// data can be transferred from one to the other. Walks and circulators see the new ones only; iterators over all
  /// faces or vertices, and their numbers, have old and new ones; constraints of a
  /// `Constrained_triangulation_plus_2` have their old vertices still. The triangulation must not be changed. If it
  /// throws, the new faces and vertices go, and all is as it was.
  void while_both_exist(const std::vector<CDT::Face_handle>& old_faces,
                        const std::vector<CDT::Vertex_handle>& removed_vertices,
                        const std::vector<CDT::Face_handle>& new_faces,
                        const std::vector<CDT::Vertex_handle>& new_vertices);

  /// is called when all is done. What it throws passes through, and the triangulation is the new one.
  void after_change(const std::vector<CDT::Face_handle>& new_faces,
                    const std::vector<CDT::Vertex_handle>& new_vertices);
};
