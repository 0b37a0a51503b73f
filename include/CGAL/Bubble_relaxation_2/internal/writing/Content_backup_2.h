// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_WRITING_CONTENT_BACKUP_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_WRITING_CONTENT_BACKUP_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/Progress.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/flatten_triangulation.h>
#include <CGAL/Bubble_relaxation_2/internal/reading/read_input.h>
#include <CGAL/Bubble_relaxation_2/internal/writing/forget_levels.h>

#include <CGAL/Unique_hash_map.h>

#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// Whether constraints know the hierarchy that they belong to (CGAL 6.1).
template <class Constraint_id, class = void>
struct Knows_its_hierarchy : std::false_type {};

template <class Constraint_id>
struct Knows_its_hierarchy<
  Constraint_id,
  std::void_t<decltype(std::declval<Constraint_id>().vl_with_info_pointer()->hierarchy_ptr)>>
  : std::true_type
{};

/// Which vertices of a polyline were given by the user is not copied by CGAL 5.5.
template <class Cdt>
void copy_input_flags(const Cdt& cdt, Cdt& copy)
{
  using Vertex_handle = typename Cdt::Vertex_handle;
  Unique_hash_map<Vertex_handle, Vertex_handle> copied;
  auto w = copy.finite_vertices_begin();
  for (Vertex_handle v : cdt.finite_vertex_handles())
    copied[v] = w++; // a copy has the same order
  for (auto c = cdt.constraints_begin(); c != cdt.constraints_end(); ++c) {
    // the set of constraints has another order in the copy, but the lists of contexts of a piece have the same
    auto from = cdt.vertices_in_constraint_begin(*c), next = from;
    const Vertex_handle first = *next, second = *++next;
    auto in_copy = copy.contexts_begin(copied[first], copied[second]);
    for (auto context = cdt.contexts_begin(first, second); !((*context).id() == *c); ++context)
      ++in_copy;
    for (auto to = copy.vertices_in_constraint_begin((*in_copy).id()); from != cdt.vertices_in_constraint_end(*c);
         ++from, ++to)
      to.input() = from.input();
  }
}

/// Copies a triangulation as `copy_triangulation()` does, but ticks meanwhile: with millions of vertices that takes a
/// second. \pre it has dimension 2, and each vertex a face
template <class Cdt>
void copy_in_turn(Cdt& from, Cdt& to)
{
  Address_numbers vertex_numbers(sizeof(typename Cdt::Vertex)), face_numbers(sizeof(typename Cdt::Face));
  std::vector<typename Cdt::Vertex_handle> vertices;
  std::vector<typename Cdt::Face_handle> faces;
  to.tds().clear();
  to.tds().set_dimension(2);
  for (auto& v : from.tds().vertices()) {
    tick(vertices.size());
    vertex_numbers.add(&v);
    vertices.push_back(to.tds().create_vertex(v));
  }
  for (auto& f : from.tds().faces()) {
    tick(faces.size());
    face_numbers.add(&f);
    faces.push_back(to.tds().create_face(f));
  }
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    tick(k);
    vertices[k]->set_face(faces[face_numbers(&*vertices[k]->face())]);
  }
  for (std::size_t k = 0; k < faces.size(); ++k) {
    tick(k);
    for (int i = 0; i < 3; ++i) {
      faces[k]->set_vertex(i, vertices[vertex_numbers(&*faces[k]->vertex(i))]);
      faces[k]->set_neighbor(i, faces[face_numbers(&*faces[k]->neighbor(i))]);
    }
  }
  to.set_infinite_vertex(vertices[vertex_numbers(&*from.infinite_vertex())]);
}

/// A copy of a triangulation, to give it its content back. Handles and identifiers of constraints do not outlive that.
template <class Cdt>
class Content_backup_2
{
public:
  explicit Content_backup_2(Cdt& cdt) : m_cdt(cdt), m_copy(cdt.geom_traits())
  {
    // swap() takes along what orders the map of the constraints' pieces, and that refers to a
    // triangulation: it must be the one that lives on
    if constexpr (Has_constraint_hierarchy<Cdt>::value) {
      m_copy.hierarchy_ref() = std::decay_t<decltype(m_copy.hierarchy_ref())>(&cdt);
      m_copy.copy_triangulation(cdt);
      copy_input_flags(cdt, m_copy);
    } else if constexpr (Has_levels<Cdt>::value)
      m_copy.copy_triangulation(cdt);
    else
      copy_in_turn(cdt, m_copy);
  }

  Content_backup_2(const Content_backup_2&) = delete;
  Content_backup_2& operator=(const Content_backup_2&) = delete;

  /// what the triangulation had, and after `restore()` what it has had since
  Cdt& copy() { return m_copy; }

  void restore()
  {
    m_cdt.swap(m_copy);
    if constexpr (Has_constraint_hierarchy<Cdt>::value)
      if constexpr (Knows_its_hierarchy<typename Cdt::Constraint_id>::value)
        for (auto c = m_cdt.constraints_begin(); c != m_cdt.constraints_end(); ++c)
          (*c).vl_with_info_pointer()->hierarchy_ptr = &m_cdt.hierarchy_ref();
  }

private:
  Cdt& m_cdt;
  Cdt m_copy;
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_WRITING_CONTENT_BACKUP_2_H
