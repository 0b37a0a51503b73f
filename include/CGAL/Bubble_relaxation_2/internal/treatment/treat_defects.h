// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_TREATMENT_TREAT_DEFECTS_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_TREATMENT_TREAT_DEFECTS_H

#include <CGAL/Bubble_relaxation_2/internal/core/Bubbles_2.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Progress.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Team.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_2.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Problem_2.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/outline.h>
#include <CGAL/Bubble_relaxation_2/internal/placement/place_bubbles.h>
#include <CGAL/Bubble_relaxation_2/internal/treatment/Angle_refinement_2.h>
#include <CGAL/Bubble_relaxation_2/internal/treatment/Defect_surgery_2.h>
#include <CGAL/Bubble_relaxation_2/internal/treatment/Smoothing_sweeps_2.h>
#include <CGAL/Bubble_relaxation_2/internal/treatment/insert_points.h>
#include <CGAL/Bubble_relaxation_2/internal/treatment/rebuild_outside.h>

#include <CGAL/Bubble_relaxation_report_2.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// What the treatment of defects did to a mesh: vertices that were moved, inserted and deleted.
struct Treatment_counts
{
  std::size_t treated = 0, inserted = 0, deleted = 0;

  Treatment_counts& operator+=(const Treatment_counts& c)
  {
    treated += c.treated;
    inserted += c.inserted;
    deleted += c.deleted;
    return *this;
  }

  void add_to(Report& report) const
  {
    report.number_of_treated_vertices += treated;
    report.number_of_insertions += inserted;
    report.number_of_deletions += deleted;
  }
};

/// Triangles with less than the first are operated on at first, and so on. A triangle with more than the last is acute:
/// 2 (sqrt 2 - 1) is the q of the right-angled triangle with two equal sides.
inline constexpr double bad_qualities[] = {0.9, 0.88, 0.86, 0.84, 0.83, 0.83, 0.83};

/// What these leave undone, surgery changes anyhow, or the sweeps after it do.
inline constexpr Sweeps sweeps_before_surgery{2, usual_sweeps.treated_quality};

/// Where sizes follow the outline they change so fast that forces do not make the best of most triangles.
inline Sweeps sweeps_after_surgery(const Problem_2& problem)
{
  constexpr double treated_at_outline = 0.98;
  return Sweeps{usual_sweeps.most, problem.follows_outline() ? treated_at_outline : usual_sweeps.treated_quality};
}

/// How far the treatment of a mesh has come.
struct Treatment_state
{
  double smallest; ///< q, which does not get smaller
  std::int64_t first_number; ///< of the vertices whose triangles are treated
  Outline_care& care;
  Treatment_counts counts{};
};

/// Moves vertices for the quality of their triangles.
inline void smooth_defects(const Domain_2& domain, const Threads& threads, Bubble_mesh_2& mesh, const Sweeps& sweeps,
                           Treatment_state& state)
{
  Team alone;
  Smoothing_sweeps_2 treat(domain, mesh, alone, threads);
  const std::vector<Index> moved = treat(sweeps, state.first_number);
  const double smallest_now = smallest_quality(mesh);
  const bool moves_outline = std::any_of(moved.begin(), moved.end(),
                                         [&mesh](Index v) { return mesh.bubbles.is_on_edge(v); });
  // the moves made none worse, but flips can
  if (smallest_now < state.smallest || !state.care.allows(moves_outline, [&] { return rebuild_outside(domain, mesh); })) {
    treat.undo();
    return;
  }
  state.smallest = smallest_now;
  state.counts.treated += moved.size();
}

/// Inserts and removes single bubbles where moving is not enough.
inline void operate_on_defects(const Domain_2& domain, Bubble_mesh_2& mesh, Treatment_state& state)
{
  if (state.smallest >= bad_qualities[0])
    return;
  label_edges(mesh.triangles);
  Bubbles_2 before = mesh.bubbles;
  Defect_surgery_2 surgery(domain, mesh, state.smallest, state.first_number);
  for (double bad_quality : bad_qualities)
    if (is_stop_wanted() || !surgery(bad_quality))
      break;
  if (surgery.number_of_insertions + surgery.number_of_deletions == 0)
    return;
  const double smallest_now = smallest_quality(mesh);
  // rounding can make a mess of a change; then what was there is good
  if (smallest_now < state.smallest ||
      !state.care.allows(surgery.has_changed_outline, [&] { return rebuild_outside(domain, mesh); })) {
    mesh.bubbles = std::move(before);
    triangulate(domain, mesh);
    return;
  }
  state.counts += Treatment_counts{0, surgery.number_of_insertions, surgery.number_of_deletions};
  state.smallest = smallest_now;
  state.first_number = surgery.first_number;
}

/// Whether a triangle is more than twice as large as an equilateral one with d as side, or less than half as large.
template <class Mesh>
bool is_misfit(const Mesh& mesh, Index t)
{
  constexpr double most = 2;
  const auto& v = mesh.triangles.vertices[t];
  const Bubbles_2& b = mesh.bubbles;
  const double d = (b.d[v[0]] + b.d[v[1]] + b.d[v[2]]) / 3, wanted = area_of_unit_triangle * d * d;
  const double area = CGAL::area(b.point(v[0]), b.point(v[1]), b.point(v[2]));
  return area > most * wanted || wanted > most * area;
}

/// How many triangles of a mesh do not fit d, of how many. Areas would be sums whose bits depend on the order.
struct Misfit_counts
{
  std::int64_t misfits = 0, all = 0;

  /// whether it is a larger share
  bool is_worse_than(const Misfit_counts& other) const { return misfits * other.all > other.misfits * all; }
};

/// \param counts of each triangle whether it counts
template <class Mesh>
Misfit_counts count_misfits(const Mesh& mesh, const std::vector<char>& counts)
{
  Misfit_counts result;
  for (Index t : marked(counts)) {
    ++result.all;
    result.misfits += is_misfit(mesh, t);
  }
  return result;
}

/// What the treatment of a mesh is made of, where one rank has all of it. `Distributed_treatment_2` is the same by several;
/// `treat()` puts the parts together for both.
class Whole_treatment_2
{
public:
  using Mesh = Bubble_mesh_2;
  using Piece = Bubble_mesh_2; ///< of it, in which a rank works

  explicit Whole_treatment_2(const Problem_2& problem) : m_problem(problem), m_threads(problem.options.threads) {}

  const Problem_2& problem() const { return m_problem; }

  static Piece piece_of(Mesh&& mesh) { return std::move(mesh); }
  static Mesh mesh_of(Piece&& piece) { return std::move(piece); }

  double smallest_quality(const Mesh& mesh) const { return internal::smallest_quality(mesh); }

  /// as `triangulate_own()` makes a mesh of them
  Bubbles_2 own_bubbles(const Mesh& mesh) const { return mesh.bubbles; }

  Mesh triangulate_own(Bubbles_2&& bubbles) const
  {
    Mesh mesh{std::move(bubbles), {}};
    triangulate(m_problem.domain, mesh);
    return mesh;
  }

  void smooth(Piece& mesh, const Sweeps& sweeps, Treatment_state& state) const
  {
    smooth_defects(m_problem.domain, m_threads, mesh, sweeps, state);
  }

  void operate(Piece& mesh, Treatment_state& state) const
  {
    operate_on_defects(m_problem.domain, mesh, state);
  }

  /// whether the outline of a mesh, which was changed, does not cross itself
  bool closes_outline(Piece& mesh) const { return rebuild_outside(m_problem.domain, mesh); }

  /// makes the mesh of the given bubbles; returns with what it is treated
  Whole_treatment_2 triangulate_given(Mesh& given) const
  {
    given.bubbles = given_bubbles(m_problem);
    triangulate(m_problem.domain, given);
    return *this;
  }

  Misfit_counts count_misfits(const Mesh& mesh) const { return internal::count_misfits(mesh, mesh.triangles.inside); }

  bool is_stop_wanted() const { return internal::is_stop_wanted(); }

  /// \name Refinement
  /// @{
  std::size_t number_of_bubbles(const Mesh& mesh) const { return mesh.bubbles.size(); }
  bool is_to_be_refined(const Mesh& mesh) const { return !to_be_refined(mesh).empty(); }
  Mesh triangulated_anew(const Mesh& mesh) const { return mesh; }

  std::vector<Steiner_point_2> wanted_points(const Mesh& mesh) const
  {
    return internal::wanted_points(m_problem, mesh, positions_on_edges(mesh.bubbles), to_be_refined(mesh));
  }

  /// returns whether that can be done; if not, the mesh is not to be used any more
  bool insert(const std::vector<Steiner_point_2>& points, Outline_care& care, Mesh& mesh) const
  {
    const bool splits_outline =
      std::any_of(points.begin(), points.end(), [](const Steiner_point_2& p) { return p.is_on_edge(); });
    return insert_points(m_problem.domain, m_problem.sizes, points, mesh) &&
           care.allows(splits_outline, [&] { return closes_outline(mesh); });
  }

  double smallest_free_sine(const Mesh& mesh) const { return internal::smallest_free_sine(mesh, mesh.triangles.inside); }
  static constexpr void prepare_to_treat_again(Mesh&) {}

  std::pair<std::int64_t, double> left_to_refine(const Mesh& mesh) const
  {
    return internal::left_to_refine(m_problem, mesh, mesh.triangles.inside);
  }
  /// @}

private:
  std::vector<Index> to_be_refined(const Mesh& mesh) const
  {
    return triangles_to_refine(m_problem, mesh, mesh.triangles.inside);
  }

  const Problem_2& m_problem;
  const Threads& m_threads;
};

/// Treats the last defects of a mesh, or those of triangles with a vertex from `first` on, see `number_of()`: where such a
/// vertex is deleted, only in its patch. The smallest q never gets smaller. Sizes of bubbles that move are not renewed.
template <class Treatment>
Treatment_counts treat_defects(const Treatment& treatment, typename Treatment::Mesh& mesh, Outline_care& care,
                               std::int64_t first = 0)
{
  const double smallest = treatment.smallest_quality(mesh);
  const Sweeps last_sweeps = sweeps_after_surgery(treatment.problem());
  if (smallest >= last_sweeps.treated_quality)
    return {};
  Treatment_state state{smallest, first, care};
  typename Treatment::Piece piece = treatment.piece_of(std::move(mesh));
  treatment.smooth(piece, sweeps_before_surgery, state);
  if (treatment.problem().options.population != Bubble_population::NONE)
    treatment.operate(piece, state);
  treatment.smooth(piece, last_sweeps, state);
  mesh = treatment.mesh_of(std::move(piece));
  return state.counts;
}

/// All bubbles were given by the user: then the mesh that they made is the result if its smallest q is larger, treated
/// too, unless it fits d worse, if only in one place, and the number of bubbles was free.
template <class Treatment>
void keep_the_better(const Treatment& treatment, typename Treatment::Mesh& mesh, Outline_care& care,
                     Treatment_counts& counts)
{
  typename Treatment::Mesh given;
  const auto treatment_of_given = treatment.triangulate_given(given);
  if (treatment.smallest_quality(given) <= treatment.smallest_quality(mesh) ||
      (treatment.problem().options.population != Bubble_population::NONE &&
       treatment.count_misfits(given).is_worse_than(treatment.count_misfits(mesh))))
    return;
  check_before_leaving(treatment, mesh, care);
  care.has_changed_outline = false;
  counts = treat_defects(treatment_of_given, given, care);
  mesh = std::move(given);
}

/// Refines, and treats what has come of it: new vertices stand where angles ask for them, not where they fit in best.
template <class Treatment>
void refine_and_treat(const Treatment& treatment, typename Treatment::Mesh& mesh, Outline_care& care,
                      Treatment_counts& counts)
{
  const std::size_t inserted = refine_small_angles(treatment, mesh, care);
  if (inserted == 0)
    return;
  counts.inserted += inserted;
  const std::int64_t first_new = static_cast<std::int64_t>(treatment.number_of_bubbles(mesh) - inserted); // the last ones
  const auto left_before = treatment.left_to_refine(mesh);
  Bubbles_2 before = treatment.own_bubbles(mesh);
  Outline_care care_again{care.is_careful};
  treatment.prepare_to_treat_again(mesh);
  const Treatment_counts more = treat_defects(treatment, mesh, care_again, first_new);
  if (left_before < treatment.left_to_refine(mesh)) {
    check_before_leaving(treatment, mesh, care_again);
    mesh = treatment.triangulate_own(std::move(before));
    return;
  }
  care.add(care_again);
  counts += more;
}

/// Treats and refines a mesh, and once more, carefully, if its outline crosses itself then.
template <class Treatment>
Treatment_counts treat_and_refine(const Treatment& treatment, typename Treatment::Mesh& mesh)
{
  const Relaxation_options& options = treatment.problem().options;
  Bubbles_2 simulated = treatment.own_bubbles(mesh);
  for (bool is_careful = false;; is_careful = true) {
    Outline_care care{is_careful};
    try {
      Treatment_counts counts = treat_defects(treatment, mesh, care);
      if (keeps_given_bubbles(options))
        keep_the_better(treatment, mesh, care, counts);
      if (options.population != Bubble_population::NONE)
        refine_and_treat(treatment, mesh, care, counts);
      if (!care.has_changed_outline || treatment.closes_outline(mesh))
        return counts;
    } catch (const Edges_too_near&) { // ranks triangulate, and find that on the way
      if (is_careful)
        throw;
    }
    mesh = treatment.triangulate_own(Bubbles_2(simulated));
  }
}

/// whether there is a result of a simulation to be treated
inline bool is_treatment_due(const Relaxation_options& options, const Report& report)
{
  return options.defect_treatment && report.number_of_steps != 0 &&
         report.stop_reason != Bubble_stop_reason::STOPPED_BY_CALLBACK;
}

/// What is done to the triangulation of the simulated bubbles before it is written.
template <class Treatment>
void treat(const Treatment& treatment, typename Treatment::Mesh& mesh, Report& report)
{
  if (is_treatment_due(treatment.problem().options, report))
    treat_and_refine(treatment, mesh).add_to(report);
  if (treatment.is_stop_wanted()) // what was left of it was not done
    tell_that_it_was_stopped(report);
}

/// The triangulation of the simulated bubbles, treated.
inline Bubble_mesh_2 triangulate_and_treat(const Problem_2& problem, Bubbles_2 bubbles, Report& report)
{
  const Phase_timer timer(report.seconds.treatment);
  problem.options.progress->start_phase(Bubble_phase::TREATMENT);
  Bubble_mesh_2 mesh{std::move(bubbles), {}};
  triangulate(problem.domain, mesh);
  treat(Whole_treatment_2(problem), mesh, report);
  return mesh;
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_TREATMENT_TREAT_DEFECTS_H
