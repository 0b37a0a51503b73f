// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_DEFAULT_RELAXATION_VISITOR_2_H
#define CGAL_DEFAULT_RELAXATION_VISITOR_2_H

#include <CGAL/license/Bubble_relaxation_2.h>

#include <CGAL/Bubble_relaxation_2/internal/core/disable_warnings.h>

#include <CGAL/Bubble_relaxation_2/internal/core/Bubbles_2.h>
#include <CGAL/Bubble_relaxation_enums.h>
#include <CGAL/Bubble_relaxation_report_2.h>

#include <cstddef>

namespace CGAL {

/*!
\ingroup PkgBubbleRelaxation2Ref

\brief The bubbles while they move, as a visitor sees them. It refers to what moves: what is wanted later is to be copied.

A bubble keeps its index from step to step. New ones come after the last; an index whose bubble was deleted stays unused.
*/
class Bubble_view_2
{
public:
  /// \cond SKIP_IN_MANUAL
  explicit Bubble_view_2(const Bubble_relaxation_2::internal::Bubbles_2& bubbles) : m_bubbles(&bubbles) {}
  /// \endcond

  /// the number of indices, those that are unused among them
  std::size_t size() const { return m_bubbles->size(); }

  /// whether the bubble was deleted: then nothing else is to be asked of it
  bool is_deleted(std::size_t i) const { return m_bubbles->is_gone(i); }

  double x(std::size_t i) const { return m_bubbles->x[i]; } ///< of the centre
  double y(std::size_t i) const { return m_bubbles->y[i]; } ///< of the centre

  /// the diameter, which is the wanted distance d at the centre, or, near narrow parts of the outline, what it allows
  double diameter(std::size_t i) const { return m_bubbles->d[i]; }

  /// whether it slides along a constraint
  bool is_on_constraint(std::size_t i) const { return m_bubbles->is_on_edge(i); }

  /// whether it stays where it is: on a corner of the outline or on a pinned vertex
  bool is_fixed(std::size_t i) const { return m_bubbles->is_corner(i); }

private:
  const Bubble_relaxation_2::internal::Bubbles_2* m_bubbles;
};

/*!
\ingroup PkgBubbleRelaxation2Ref

\brief sees `npbs_relax()` and `npbs_place_nodes()` at work, and does nothing. Visitors are derived from it, and have what
they need of its functions.

\cgalModels{BubbleRelaxationVisitor_2}
*/
struct Default_relaxation_visitor_2
{
  /// what was before is done
  void phase_begins(Bubble_phase) {}

  /// all bubbles have made their move
  void step_ends(const Bubble_view_2&) {}

  /// a round is over
  void round_ends(const Bubble_relaxation_report_2<double>&) {}
};

} // namespace CGAL

#include <CGAL/Bubble_relaxation_2/internal/core/enable_warnings.h>

#endif // CGAL_DEFAULT_RELAXATION_VISITOR_2_H
