// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_ADAPTATION_REMESH_PART_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_ADAPTATION_REMESH_PART_H

#include <CGAL/Bubble_relaxation_2/internal/adaptation/Part_growth_2.h>
#include <CGAL/Bubble_relaxation_2/internal/adaptation/Part_reading_2.h>
#include <CGAL/Bubble_relaxation_2/internal/adaptation/Part_write_2.h>
#include <CGAL/Bubble_relaxation_2/internal/adaptation/rim_sizes.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Progress.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_2.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_marks_2.h>
#include <CGAL/Bubble_relaxation_2/internal/engine/engine.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Marked_triangulation_2.h>
#include <CGAL/Bubble_relaxation_2/internal/reading/read_input.h>

#include <CGAL/radius_ratio_2.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// Edges of constraints at the border of the domain that stay as they are, like those of the rim: it turned out that
/// what is beyond them is too flat to be changed.
template <class Cdt>
class Kept_edges_2
{
  using Vertex_handle = typename Cdt::Vertex_handle;

public:
  void add(const std::vector<Vertex_handle>& path)
  {
    for (std::size_t k = 1; k < path.size(); ++k)
      m_ends.insert(ends(path[k - 1], path[k]));
  }

  bool is_empty() const { return m_ends.empty(); }

  bool contains(typename Cdt::Face_handle f, int i) const
  {
    return m_ends.count(ends(f->vertex(Cdt::ccw(i)), f->vertex(Cdt::cw(i)))) != 0;
  }

private:
  static std::pair<const void*, const void*> ends(Vertex_handle u, Vertex_handle v)
  {
    return std::minmax<const void*>(&*u, &*v);
  }

  std::set<std::pair<const void*, const void*>> m_ends;
};

/// What is to be done with a part of a triangulation. It refers to the user's vertices and parameters.
template <class Cdt>
class Part_input_2
{
public:
  using Part = std::vector<typename Cdt::Face_handle>;

  /// `sizes`: those that are wanted; by default those of the mesh
  template <class Is_inside, class NamedParameters>
  Part_input_2(const Cdt& cdt, const Part& part, const Kept_edges_2<Cdt>& kept, const Is_inside& is_in_domain,
               const NamedParameters& np, const Relaxation_options& options, const std::optional<Sizes_2>& sizes)
    : Part_input_2(cdt, copy_of(cdt, part, kept, is_in_domain), is_in_domain, np, options, sizes)
  {}

  const Part_reading_2<Cdt>& reading() const { return m_reading; }

  Problem_2 problem() const
  {
    return Problem_2{m_limits.cut ? *m_limits.domain : m_reading.domain, m_reading.given, m_options, m_wanted,
                     m_limits.sizes, m_limits.cut.get(), &m_reading.domain};
  }

private:
  template <class Is_inside, class NamedParameters>
  Part_input_2(const Cdt& cdt, const Marked_copy_2& copy, const Is_inside& is_in_domain, const NamedParameters& np,
               const Relaxation_options& o, const std::optional<Sizes_2>& sizes)
    : m_options(o), m_reading(cdt, copy, np),
      m_wanted(sizes ? sizes_from_rim(cdt, is_in_domain, *sizes) : sizes_of_mesh(copy)),
      m_limits(limit_by_outline(m_reading.domain, m_reading.given, m_wanted, o, o.limit_by_outline && sizes))
  {
    if (!m_options.placement_is_given) // then what fits of a mesh is kept
      m_reading.look_around(copy);
  }

  /// the part in arrays; its rim, behind which the domain goes on, stays as it is
  template <class Is_inside>
  static Marked_copy_2 copy_of(const Cdt& cdt, const Part& part, const Kept_edges_2<Cdt>& kept,
                               const Is_inside& is_in_domain)
  {
    Marked_copy_2 result(cdt, part, [&](typename Cdt::Face_handle f, int i) {
      return is_in_domain(f->neighbor(i)) || kept.contains(f, i);
    });
    result.check_domain();
    return result;
  }

  template <class Is_inside>
  Sizes_2 sizes_from_rim(const Cdt& cdt, const Is_inside& is_in_domain, const Sizes_2& sizes)
  {
    m_reading.given.silent_corners = rim_at_jumps(cdt, is_in_domain, m_reading, sizes);
    return no_finer_than_edges(m_reading.domain, m_reading.given, sizes, m_options.size_growth);
  }

  Relaxation_options m_options;
  Part_reading_2<Cdt> m_reading;
  Sizes_2 m_wanted;
  Limits_of_outline_2 m_limits;
};

/// what is known of a mesh before it is written
template <class Cdt>
struct Write_plan
{
  using Path = std::vector<typename Cdt::Vertex_handle>;

  Path removed_vertices;
  bool needs_no_flips = false;    ///< whether the triangles become faces as they are
  std::vector<Path> kept_borders; ///< if there are some, the mesh cannot be written: they have to stay
};

/// Nodes that cannot be written have to go, until those can be that are left.
template <class Cdt>
Write_plan<Cdt> make_writable(Cdt& cdt, const std::vector<typename Cdt::Face_handle>& part,
                              const Part_input_2<Cdt>& input, Bubble_mesh_2& mesh, Report& report)
{
  const Elevations<Cdt> none;
  std::set<std::size_t> borders;
  for (;;) {
    std::vector<Index> those;
    {
      Part_write_2<Cdt> attempt(cdt, part, input.reading(), mesh, none);
      const auto found = attempt.find_unwritable(borders);
      borders.insert(found.borders.begin(), found.borders.end());
      if (found.is_none()) {
        Write_plan<Cdt> plan{attempt.removed_vertices(), attempt.needs_no_flips(), {}};
        for (std::size_t chain : borders)
          plan.kept_borders.push_back(attempt.old_path(chain));
        return plan;
      }
      those = found.bubbles;
    }
    if (!those.empty())
      make_mesh_without(those, input.problem(), mesh, report);
  }
}

/// Puts the mesh of a part into the triangulation, and tells the visitor. The callback is called while the new faces
/// are made, of which nothing is left if it stops that or throws; it is told that all is done just before they are
/// put in. Returns borders that have to stay: if there are any, nothing was done.
template <class Cdt, class NamedParameters, class Visitor>
std::vector<typename Write_plan<Cdt>::Path>
write_part(Cdt& cdt, const NamedParameters& np, const std::vector<typename Cdt::Face_handle>& part,
           const Part_input_2<Cdt>& input, Bubble_mesh_2 mesh, const Elevation_function<Cdt>& elevation,
           Visitor& visitor, Report& report)
{
  const Phase_timer timer(report.seconds.writing);
  Progress& progress = *input.problem().options.progress;
  progress.start_phase(Bubble_phase::WRITING);
  const Write_plan<Cdt> plan = make_writable(cdt, part, input, mesh, report);
  if (!plan.kept_borders.empty())
    return plan.kept_borders;
  const Elevations<Cdt> elevations = find_elevations(cdt, input.reading(), mesh.bubbles, elevation);
  const Tags_2<Cdt, NamedParameters> tags(np, cdt, input.reading());
  visitor.before_change(part, plan.removed_vertices);
  Part_write_2<Cdt> write(cdt, part, input.reading(), mesh, elevations);
  write.build(plan.needs_no_flips);
  const std::vector<typename Cdt::Vertex_handle> new_vertices = write.new_vertices();
  const std::vector<typename Cdt::Face_handle> new_faces = write.new_faces();
  progress.finish();
  write.exchange();
  visitor.while_both_exist(part, plan.removed_vertices, new_faces, new_vertices);
  tags.forget_part(input.reading(), part);
  write.finish();
  write.write_tags(tags);
  visitor.after_change(new_faces, new_vertices);
  return {};
}

/// The corners of a part on its rim that have a bad triangle: the treatment could not make it better, since they stay.
inline std::vector<Index> rim_defects(const Domain_2& part, const Bubble_mesh_2& mesh)
{
  constexpr double bad = 0.92; // few are worse in a mesh that is made at once
  std::vector<char> is_on_rim(part.corners().size(), 0), is_defect(is_on_rim);
  for (const Domain_edge_2& e : part.edges())
    if (e.kind == Edge_kind::RIM)
      is_on_rim[e.source] = is_on_rim[e.target] = 1;
  const Bubbles_2& b = mesh.bubbles;
  for (std::size_t t = 0; t < mesh.triangles.number_of_triangles(); ++t) {
    tick(t);
    const Index f = static_cast<Index>(t);
    if (!mesh.triangles.inside[t] ||
        !(CGAL::radius_ratio_2(mesh.point(f, 0), mesh.point(f, 1), mesh.point(f, 2)) < bad))
      continue;
    for (Index v : mesh.triangles.vertices[t])
      if (b.is_corner(v) && b.host[v] != no_index && is_on_rim[b.host[v]])
        is_defect[b.host[v]] = 1;
  }
  return marked(is_defect);
}

/// What is to be done with a part of a triangulation, and how.
template <class Cdt, class Is_inside, class NamedParameters>
struct Part_task_2
{
  using Part = std::vector<typename Cdt::Face_handle>;

  Cdt& cdt;
  const Is_inside& is_in_domain;
  const NamedParameters& np;
  const Relaxation_options& options;
  const std::optional<Sizes_2>& sizes;
  const Elevation_function<Cdt>& elevation;

  /// Meshes a part anew.
  template <class Visitor>
  void remesh(const Part& part, Visitor& visitor, Report& report) const
  {
    remesh(part, 0, visitor, report);
  }

  /// The same. Where bad triangles are left at the rim, the part grows, and all is done once more.
  template <class Visitor>
  void adapt(Part part, Visitor& visitor, Report& report) const
  {
    remesh(std::move(part), 3, visitor, report);
  }

private:
  /// `most_growths`: how often the part may grow. All is done once more, too, with borders that have to stay.
  template <class Visitor>
  void remesh(Part part, int most_growths, Visitor& visitor, Report& report) const
  {
    Kept_edges_2<Cdt> kept;
    for (int growths = 0;;) {
      const Part_input_2<Cdt> input = read(part, kept, report);
      const auto seconds = report.seconds;
      report = Report();
      report.seconds = seconds;
      Bubble_mesh_2 mesh = make_mesh(input.problem(), report);
      if (growths < most_growths && kept.is_empty() && is_treated(report)) {
        Part larger = grown(part, input.reading(), mesh);
        if (larger.size() != part.size()) {
          part.swap(larger);
          ++growths;
          continue;
        }
      }
      const auto borders = write_part(cdt, np, part, input, std::move(mesh), elevation, visitor, report);
      if (borders.empty())
        return;
      for (const auto& path : borders)
        kept.add(path);
    }
  }

  Part_input_2<Cdt> read(const Part& part, const Kept_edges_2<Cdt>& kept, Report& report) const
  {
    const Phase_timer timer(report.seconds.reading);
    return Part_input_2<Cdt>(cdt, part, kept, is_in_domain, np, options, sizes);
  }

  bool is_treated(const Report& report) const
  {
    return options.defect_treatment && report.stop_reason != Bubble_stop_reason::STOPPED_BY_CALLBACK;
  }

  /// the part with more around its bad triangles
  Part grown(const Part& part, const Part_reading_2<Cdt>& reading, const Bubble_mesh_2& mesh) const
  {
    Part_growth_2<Cdt, Is_inside> growth(cdt, is_in_domain, part);
    for (Index corner : rim_defects(reading.domain, mesh)) {
      Part_growth_2<Cdt, Is_inside> around(cdt, is_in_domain, {});
      around.add_star(reading.vertex(reading.graph->corners()[corner]));
      around.add_rings(2);
      for (auto f : around.faces())
        growth.add(f);
    }
    return growth.faces();
  }
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_ADAPTATION_REMESH_PART_H
