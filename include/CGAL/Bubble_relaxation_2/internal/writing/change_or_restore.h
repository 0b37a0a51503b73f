// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_WRITING_CHANGE_OR_RESTORE_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_WRITING_CHANGE_OR_RESTORE_H

#include <CGAL/Bubble_relaxation_2/internal/geometry/flatten_triangulation.h>
#include <CGAL/Bubble_relaxation_2/internal/reading/read_input.h>
#include <CGAL/Bubble_relaxation_2/internal/writing/Restore_on_throw.h>

#include <CGAL/utility.h>

#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// The tags of a triangulation for a copy of it, whose vertices and faces have other handles.
template <class Cdt, class NamedParameters>
class Saved_tags_2
{
  using Maps = Tag_maps<NamedParameters>;
  using Vertex_handle = typename Cdt::Vertex_handle;
  using Face_handle = typename Cdt::Face_handle;
  using Edge_key = std::pair<Vertex_handle, Vertex_handle>;
  using Marker = Tag_type<NamedParameters, internal_np::edge_marker_t>;
  using Region = Tag_type<NamedParameters, internal_np::face_region_t>;

public:
  /// \pre the copy has the order of the triangulation
  Saved_tags_2(const NamedParameters& np, const Cdt& cdt, const Cdt& copy)
    : m_maps(np), m_vertex_numbers(sizeof(typename Cdt::Vertex)), m_face_numbers(sizeof(typename Cdt::Face))
  {
    if constexpr (Maps::has_markers)
      number(cdt.finite_vertex_handles(), copy.finite_vertex_handles(), m_vertex_numbers, m_vertices);
    if constexpr (Maps::has_regions)
      number(cdt.finite_face_handles(), copy.finite_face_handles(), m_face_numbers, m_faces);
  }

  void save(const Edge_key& edge, const Marker& marker)
  {
    m_markers.emplace_back(CGAL::make_sorted_pair(copy_of(edge.first), copy_of(edge.second)), marker);
  }

  void save(Face_handle f, const Region& region)
  {
    m_regions.emplace_back(m_faces[m_face_numbers(&*f)], region);
  }

  /// takes all edges and faces of a triangulation out of the maps
  void forget([[maybe_unused]] Cdt& cdt) const
  {
    if constexpr (Maps::has_markers || Maps::has_regions)
      for (auto f = cdt.tds().faces().begin(); f != cdt.tds().faces().end(); ++f) {
        if constexpr (Maps::has_regions)
          forget_if_possible(m_maps.regions(), Face_handle(f));
        if constexpr (Maps::has_markers)
          for (int i = 0; i < 3; ++i)
            forget_if_possible(m_maps.markers(),
                               CGAL::make_sorted_pair(f->vertex(Cdt::ccw(i)), f->vertex(Cdt::cw(i))));
      }
  }

  /// when the copy has become the triangulation
  void put_back() const
  {
    if constexpr (Maps::has_markers)
      for (const auto& [edge, marker] : m_markers)
        put(m_maps.markers(), edge, marker);
    if constexpr (Maps::has_regions)
      for (const auto& [f, region] : m_regions)
        put(m_maps.regions(), f, region);
  }

private:
  template <class Range, class Handle>
  static void number(const Range& originals, const Range& copies, Address_numbers& numbers, std::vector<Handle>& result)
  {
    for (Handle h : originals)
      numbers.add(&*h);
    for (Handle h : copies)
      result.push_back(h);
  }

  Vertex_handle copy_of(Vertex_handle v) const { return m_vertices[m_vertex_numbers(&*v)]; }

  Maps m_maps;
  Address_numbers m_vertex_numbers, m_face_numbers;
  std::vector<Vertex_handle> m_vertices; // of the copy
  std::vector<Face_handle> m_faces;
  std::vector<std::pair<Edge_key, Marker>> m_markers;
  std::vector<std::pair<Face_handle, Region>> m_regions;
};

/// Calls `change()`. If that throws, the triangulation gets back what it had, and the user's maps their tags of it.
/// \param visit_tags `visit_tags(saved)` calls `saved.save()` with all of them
template <class Cdt, class NamedParameters, class Visit_tags, class Change>
void change_or_restore(Cdt& cdt, const NamedParameters& np, const Visit_tags& visit_tags, const Change& change)
{
  Restore_on_throw<Cdt> guard(cdt);
  Saved_tags_2<Cdt, NamedParameters> tags(np, cdt, guard.backup());
  visit_tags(tags);
  try {
    change();
  } catch (...) {
    tags.forget(cdt);
    guard.restore();
    tags.put_back();
    throw;
  }
  guard.all_went_well();
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_WRITING_CHANGE_OR_RESTORE_H
