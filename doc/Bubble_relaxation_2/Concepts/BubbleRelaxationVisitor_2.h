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

The concept `BubbleRelaxationVisitor_2` describes what sees a relaxation at work, for pictures that move, for logs and for
studies of the method. All functions are called by the thread that called the package. What they throw passes through, and
the triangulation is as it was.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Default_relaxation_visitor_2}
\cgalHasModelsEnd

\sa `CGAL::npbs_relax()`
\sa `CGAL::npbs_place_nodes()`
*/
class BubbleRelaxationVisitor_2
{
public:
  /// is called when a phase begins. Phases come in the order of `CGAL::Bubble_phase`, each once, if nothing stops them.
  void phase_begins(CGAL::Bubble_phase phase);

  /// is called after each step of the simulation.
  void step_ends(const CGAL::Bubble_view_2& bubbles);

  /// is called after each round, before bubbles are inserted and deleted. `so_far` counts rounds, steps, moves, and
  /// insertions and deletions; all else in it is not known yet.
  void round_ends(const CGAL::Bubble_relaxation_report_2<double>& so_far);
};
