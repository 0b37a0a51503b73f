// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_REPORT_2_H
#define CGAL_BUBBLE_RELAXATION_REPORT_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/disable_warnings.h>

#include <CGAL/Bubble_relaxation_2/internal/core/in_words.h>
#include <CGAL/Bubble_relaxation_enums.h>
#include <CGAL/Mesh_quality_2.h>
#include <CGAL/number_utils.h>

#include <array>
#include <cstddef>
#include <ostream>

namespace CGAL {

/*!
\ingroup PkgBubbleRelaxation2Ref

Seconds of wall-clock time that a relaxation spent in each of its phases. What lies between them is in none:
the removal of bubbles in one place, and the copy of the triangulation that is kept until all went well.
*/
struct Bubble_relaxation_seconds
{
  double reading = 0;    ///< from the triangulation to the domain and the sizes, and their expected number
  double placement = 0;  ///< the initial bubbles
  double renewal = 0;    ///< neighbour sets
  double motion = 0;     ///< forces, steps and the boundary
  double population = 0; ///< insertion and deletion of bubbles between rounds, and whether any is needed
  double treatment = 0;  ///< the triangulation of the bubbles in arrays, and the treatment of its last defects
  double writing = 0;    ///< from the bubbles to the triangulation
  double evaluation = 0; ///< the triangles within the circles around sharp corners, and statistics of the mesh

  /// the sum of all phases, less than the whole time
  double total() const
  {
    return reading + placement + renewal + motion + population + treatment + writing + evaluation;
  }
};

/*!
\ingroup PkgBubbleRelaxation2Ref

What a call of `npbs_relax()` did, and the mesh that came out.

\tparam FT_ number type of the quality measures
*/
template <class FT_>
struct Bubble_relaxation_report_2
{
  using FT = FT_;

  Bubble_relaxation_report_2() = default;

  /// the same in another number type
  template <class Other_FT>
  explicit Bubble_relaxation_report_2(const Bubble_relaxation_report_2<Other_FT>& other)
    : number_of_vertices(other.number_of_vertices), number_of_triangles(other.number_of_triangles),
      number_of_wanted_vertices(other.number_of_wanted_vertices),
      number_of_pins_outside(other.number_of_pins_outside), pin_outside_x(FT(other.pin_outside_x)),
      pin_outside_y(FT(other.pin_outside_y)),
      number_of_initial_bubbles(other.number_of_initial_bubbles), number_of_rounds(other.number_of_rounds),
      number_of_steps(other.number_of_steps), number_of_force_evaluations(other.number_of_force_evaluations),
      number_of_moves(other.number_of_moves), number_of_renewals(other.number_of_renewals),
      number_of_insertions(other.number_of_insertions), number_of_deletions(other.number_of_deletions),
      number_of_treated_vertices(other.number_of_treated_vertices), number_of_returns(other.number_of_returns),
      converged(other.converged), stop_reason(other.stop_reason), seconds(other.seconds), quality(other.quality),
      number_of_forced_triangles(other.number_of_forced_triangles), forced_x(FT(other.forced_x)),
      forced_y(FT(other.forced_y)), number_of_small_angles(other.number_of_small_angles), small_x(FT(other.small_x)),
      small_y(FT(other.small_y)), largest_size_gradient(FT(other.largest_size_gradient)),
      steepest_x(FT(other.steepest_x)), steepest_y(FT(other.steepest_y)), steep_share(FT(other.steep_share))
  {
    for (std::size_t k = 0; k < forced_places.size(); ++k)
      forced_places[k] = {other.forced_places[k].number_of_vertices, FT(other.forced_places[k].x),
                          FT(other.forced_places[k].y)};
  }

  std::size_t number_of_vertices = 0;          ///< vertices of the mesh of the domain; 0 if no mesh was made
  std::size_t number_of_triangles = 0;         ///< triangles of the mesh of the domain
  /// About as many vertices as d alone asks for: the integral of 2 / (sqrt(3) d<sup>2</sup>) over the domain, half of
  /// that of 1/d along its boundary, and one. Corners nearer to each other than d, narrows and the growth of sizes from
  /// there (`limit_by_outline`) force all others. Of a part that is meshed anew d is what its rim leaves of it, see
  /// `npbs_remesh_faces()`.
  std::size_t number_of_wanted_vertices = 0;

  /// A part of the domain in which the outline forces vertices.
  struct Forced_place
  {
    std::size_t number_of_vertices = 0; ///< those with less than 0.7 of the size that d asks for; 0: there is no such part
    FT x = FT(0);                       ///< the x coordinate of the one with the smallest share of it
    FT y = FT(0);                       ///< the y coordinate of that vertex
  };
  /// Where most of the vertices are that the outline forces: squares with a sixteenth of the extent of the domain, those
  /// with most of them first, and none beside another one.
  std::array<Forced_place, 5> forced_places{};

  /// Whether there are more than twice as many vertices as d alone asks for, and a hundred more, so that most of them
  /// are there for the outline. Then `operator<<` tells where, and what can be done.
  bool is_forced_by_outline() const
  {
    constexpr std::size_t few = 100; // that corners take are not worth a word
    return number_of_wanted_vertices > 0 && number_of_vertices > 2 * number_of_wanted_vertices &&
           number_of_vertices > number_of_wanted_vertices + few;
  }

  /// pinned vertices outside of the domain, which are not of the mesh; zero for parts that are meshed anew
  std::size_t number_of_pins_outside = 0;
  FT pin_outside_x = FT(0); ///< the x coordinate of the first of them, in lexicographic order
  FT pin_outside_y = FT(0); ///< the y coordinate of that vertex

  std::size_t number_of_initial_bubbles = 0;   ///< bubbles after the initial placement
  std::size_t number_of_rounds = 0;            ///< rounds of simulation, with one that was stopped
  std::size_t number_of_steps = 0;             ///< time steps, all rounds together
  std::size_t number_of_force_evaluations = 0; ///< evaluations of all forces: one a step, four with Runge-Kutta
  std::size_t number_of_moves = 0;             ///< bubbles that did not sleep in a step, summed over the steps
  std::size_t number_of_renewals = 0;          ///< how often neighbour sets were made or renewed
  std::size_t number_of_insertions = 0;        ///< bubbles inserted by population control and treatment
  /// bubbles deleted by them; not those removed because they were in one place with another
  std::size_t number_of_deletions = 0;
  std::size_t number_of_treated_vertices = 0; ///< vertices moved by the treatment of the last defects
  /// how often a face bubble was stopped at an edge: put back, or left where it was if there was no room
  std::size_t number_of_returns = 0;
  bool converged = false;                      ///< whether `stop_reason` is `CONVERGED`
  Bubble_stop_reason stop_reason = Bubble_stop_reason::ITERATION_LIMIT; ///< why it ended
  Bubble_relaxation_seconds seconds;           ///< time spent in each phase
  Mesh_quality_2<FT> quality;                  ///< statistics of the mesh, q = 2 r_in / r_out (eq. 11)

  /// \name Small Angles
  /// Triangles with an angle of less than `minimum_angle`. At a corner in which two edges of the domain meet in less than
  /// that they are forced: between the edges no mesh has others, and beside them angles grow from there. Zero in the
  /// report of `npbs_place_nodes()`.
  /// @{
  std::size_t number_of_forced_triangles = 0; ///< those with a vertex in such a corner
  FT forced_x = FT(0);                        ///< the x coordinate of the vertex with the smallest of their angles
  FT forced_y = FT(0);                        ///< the y coordinate of that vertex
  std::size_t number_of_small_angles = 0;     ///< all others; \ref BR2_outlines tells what leaves them
  FT small_x = FT(0);                         ///< the x coordinate of the vertex with the smallest of their angles
  FT small_y = FT(0);                         ///< the y coordinate of that vertex
  /// @}

  /// \name Gradient of the Sizes
  /// How much d changes along the edges of the mesh: |d<sub>i</sub> - d<sub>j</sub>| over the length of the
  /// edge. Zero in the report of `npbs_place_nodes()`, which makes no mesh.
  /// @{
  static constexpr double steep_size_gradient = 0.5; ///< triangles get bad where d is steeper than this
  FT largest_size_gradient = FT(0); ///< the largest of all edges
  FT steepest_x = FT(0);            ///< the x coordinate of the midpoint of that edge
  FT steepest_y = FT(0);            ///< the y coordinate of the midpoint of that edge
  FT steep_share = FT(0);           ///< the share of the edges with more than `steep_size_gradient`
  /// @}
};

namespace Bubble_relaxation_2::internal {

template <class FT>
void print_what_is_forced(std::ostream& out, const Bubble_relaxation_report_2<FT>& report)
{
  out << "  d alone asks for about " << report.number_of_wanted_vertices << " of " << report.number_of_vertices
      << " vertices, the outline forces " << report.number_of_vertices - report.number_of_wanted_vertices
      << " more, where it is finer or narrower";
  constexpr std::size_t most_places = 3;
  for (std::size_t k = 0; k < most_places && report.forced_places[k].number_of_vertices > 0; ++k)
    out << (k == 0 ? ", most near " : ", ")
        << about_in_words(CGAL::to_double(report.forced_places[k].x), CGAL::to_double(report.forced_places[k].y));
  out << ":\n  simplify_outline_2() replaces it, but for pinned vertices, by one with longer pieces; a larger size_growth"
         " makes fewer triangles, and worse ones\n";
}

} // namespace Bubble_relaxation_2::internal

/*!
\ingroup PkgBubbleRelaxation2Functions

\brief prints what was done, where the time went, and the statistics of the mesh if there is one; and if most vertices
are there for the outline, how many, near which places, and what makes them fewer.
*/
template <class FT>
std::ostream& operator<<(std::ostream& out, const Bubble_relaxation_report_2<FT>& report)
{
  const char* const reasons[] = {"converged", "iteration limit", "stopped by the callback"};
  const Bubble_relaxation_seconds& s = report.seconds;
  out << "  " << report.number_of_initial_bubbles << " bubbles placed, " << report.number_of_insertions
      << " inserted, " << report.number_of_deletions << " deleted, " << report.number_of_treated_vertices
      << " treated\n  " << report.number_of_rounds << " rounds, " << report.number_of_steps << " steps, "
      << report.number_of_renewals << " renewals: " << reasons[static_cast<int>(report.stop_reason)]
      << "\n  seconds: reading " << s.reading << ", placement " << s.placement << ", renewal " << s.renewal
      << ", motion " << s.motion << ", population " << s.population << ", treatment " << s.treatment
      << ", writing " << s.writing << ", evaluation " << s.evaluation << '\n';
  if (report.number_of_pins_outside > 0)
    out << "  pinned vertices outside of the domain: " << report.number_of_pins_outside << ", the first at "
        << Bubble_relaxation_2::internal::about_in_words(CGAL::to_double(report.pin_outside_x),
                                                         CGAL::to_double(report.pin_outside_y))
        << '\n';
  if (report.number_of_forced_triangles + report.number_of_small_angles > 0) {
    out << "  small angles: " << report.number_of_forced_triangles << " triangles at sharp corners of the domain, "
        << report.number_of_small_angles << " others";
    if (report.number_of_small_angles > 0)
      out << ", the smallest at "
          << Bubble_relaxation_2::internal::about_in_words(CGAL::to_double(report.small_x),
                                                           CGAL::to_double(report.small_y));
    out << '\n';
  }
  if (constexpr double many = 0.01; report.steep_share > many)
    out << "  d changes by up to " << report.largest_size_gradient
        << " per unit of length: above 0.5 no mesh follows it, and where it is small in small places they may be missed;\n"
           "  Gradation_limited_sizing_field_2 limits it\n";
  if (report.is_forced_by_outline())
    Bubble_relaxation_2::internal::print_what_is_forced(out, report);
  if (report.quality.number_of_triangles() > 0)
    out << report.quality;
  return out;
}

} // namespace CGAL

#include <CGAL/Bubble_relaxation_2/internal/core/enable_warnings.h>

#endif // CGAL_BUBBLE_RELAXATION_REPORT_2_H
