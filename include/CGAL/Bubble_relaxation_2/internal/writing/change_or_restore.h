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
#include <CGAL/Bubble_relaxation_2/internal/writing/Content_backup_2.h>

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
  /// \param visit_domain `visit_domain(saved)` calls `saved.save()` with the tags of the domain. Maps that forget what
  /// goes, as they will all handles if the copy is needed, are asked for all others, too
  template <class Visit_domain>
  Saved_tags_2(const NamedParameters& np, const Cdt& cdt, const Cdt& copy,
               [[maybe_unused]] const Visit_domain& visit_domain)
    : m_maps(np), m_vertex_numbers(sizeof(typename Cdt::Vertex)), m_face_numbers(sizeof(typename Cdt::Face))
  {
    if constexpr (Maps::has_markers)
      number(cdt.finite_vertex_handles(), copy.finite_vertex_handles(), m_vertex_numbers, m_vertices);
    if constexpr (Maps::has_regions)
      number(cdt.finite_face_handles(), copy.finite_face_handles(), m_face_numbers, m_faces);
    if constexpr ((Maps::has_markers && !Maps::markers_forget) || (Maps::has_regions && !Maps::regions_forget))
      visit_domain(*this);
    if constexpr (!Maps::markers_forget && !Maps::regions_forget)
      return;
    std::size_t n = 0;
    for (Face_handle f : cdt.finite_face_handles()) {
      tick(n++);
      if constexpr (Maps::regions_forget)
        save(f, get(m_maps.regions(), f));
      if constexpr (Maps::markers_forget)
        for (int i = 0; i < 3; ++i)
          if (f->is_constrained(i)) // from both sides, which does no harm
            save(key(f, i), get(m_maps.markers(), key(f, i)));
    }
  }

  void save(const Edge_key& edge, const Marker& marker)
  {
    m_markers.emplace_back(CGAL::make_sorted_pair(copy_of(edge.first), copy_of(edge.second)), marker);
  }

  void save(Face_handle f, const Region& region)
  {
    m_regions.emplace_back(m_faces[m_face_numbers(&*f)], region);
  }

  /// when the copy has become the triangulation, and `changed` is about to go
  void put_back([[maybe_unused]] Cdt& changed) const
  {
    if constexpr (Maps::markers_forget || Maps::regions_forget)
      for (auto f = changed.tds().faces().begin(); f != changed.tds().faces().end(); ++f) {
        if constexpr (Maps::regions_forget)
          forget(m_maps.regions(), Face_handle(f));
        if constexpr (Maps::markers_forget)
          for (int i = 0; i < 3; ++i)
            forget(m_maps.markers(), key(f, i));
      }
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
    for (Handle h : originals) {
      tick(numbers.addresses().size());
      numbers.add(&*h);
    }
    for (Handle h : copies) {
      tick(result.size());
      result.push_back(h);
    }
  }

  static Edge_key key(Face_handle f, int i)
  {
    return CGAL::make_sorted_pair(f->vertex(Cdt::ccw(i)), f->vertex(Cdt::cw(i)));
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
/// \param visit_tags `visit_tags(saved)` calls `saved.save()` with those of the domain
template <class Cdt, class NamedParameters, class Visit_tags, class Change>
void change_or_restore(Cdt& cdt, const NamedParameters& np, const Visit_tags& visit_tags, const Change& change)
{
  Content_backup_2<Cdt> backup(cdt);
  const Saved_tags_2<Cdt, NamedParameters> tags(np, cdt, backup.copy(), visit_tags);
  try {
    change();
  } catch (...) {
    backup.restore();
    try {
      tags.put_back(backup.copy());
    } catch (...) { // the map refuses, and what failed first is what matters
    }
    throw;
  }
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_WRITING_CHANGE_OR_RESTORE_H
