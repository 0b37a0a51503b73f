// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef BUBBLE_RELAXATION_2_TEST_ADAPTATION_CHECKS_H
#define BUBBLE_RELAXATION_2_TEST_ADAPTATION_CHECKS_H

#include "domains.h"
#include "validation.h"

#include <CGAL/Bubble_relaxation_parameters.h>
#include <CGAL/Constrained_triangulation_plus_2.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <set>
#include <type_traits>
#include <utility>
#include <vector>

/// Which parts of a mesh are meshed anew, and that nothing else changes.
namespace adaptation {

/// With polylines of constraints, which may cross. Each kind of triangulation takes the compiler ten seconds or more, so
/// that tests share this one.
using Plus = CGAL::Constrained_triangulation_plus_2<domains::Cdt_of<domains::K, CGAL::Exact_predicates_tag>>;

template <class D>
auto size(const D& d)
{
  return CGAL::parameters::sizing_function(d);
}

/// the faces of the domain whose centroids are within a distance of a place
template <class CDT>
std::vector<typename CDT::Face_handle> faces_near(const CDT& cdt, double x, double y, double radius)
{
  std::vector<typename CDT::Face_handle> result;
  for (typename CDT::Face_handle f : cdt.finite_face_handles()) {
    double cx = 0, cy = 0;
    for (int i = 0; i < 3; ++i) {
      cx += validation::xy(f->vertex(i)).first / 3;
      cy += validation::xy(f->vertex(i)).second / 3;
    }
    if (f->is_in_domain() && std::hypot(cx - x, cy - y) < radius)
      result.push_back(f);
  }
  return result;
}

template <class Base, class = void>
struct Has_info : std::false_type {};

template <class Base>
struct Has_info<Base, std::void_t<decltype(std::declval<Base&>().info())>> : std::true_type {};

/// All that has to be the same after a part of a triangulation was meshed anew: faces of the domain that do not
/// belong to the part, and vertices that are not inside of it, or on one of its constraints at the border of the
/// domain.
template <class CDT>
class Outside
{
  using Vertex_handle = typename CDT::Vertex_handle;
  using Face_handle = typename CDT::Face_handle;

public:
  /// \param cdt gets infos if its vertices and faces may have any
  Outside(CDT& cdt, const std::vector<Face_handle>& part) : m_part(part.begin(), part.end())
  {
    set_info(cdt);
    for (Face_handle f : cdt.finite_face_handles())
      if (f->is_in_domain() && m_part.count(f) == 0)
        m_faces[f] = Face_content();
    for (auto& [f, c] : m_faces) {
      c = content(f);
      for (int i = 0; i < 3; ++i)
        m_vertices[f->vertex(i)] = content(f->vertex(i));
    }
    for (Vertex_handle v : cdt.finite_vertex_handles()) {
      auto f = cdt.incident_faces(v), first = f;
      bool is_outside = true;
      do
        is_outside = is_outside && m_part.count(f) == 0;
      while (++f != first);
      if (is_outside)
        m_vertices[v] = content(v);
    }
  }

  void expect_untouched(const CDT& cdt) const
  {
    std::set<Face_handle> faces;
    std::set<Vertex_handle> vertices;
    for (Face_handle f : cdt.finite_face_handles())
      faces.insert(f);
    for (Vertex_handle v : cdt.finite_vertex_handles())
      vertices.insert(v);
    for (const auto& [f, before] : m_faces) {
      ASSERT_EQ(faces.count(f), 1u);
      EXPECT_TRUE(content(f) == before);
    }
    for (const auto& [v, before] : m_vertices) {
      ASSERT_EQ(vertices.count(v), 1u);
      EXPECT_TRUE(content(v) == before);
    }
  }

  std::size_t number_of_faces() const { return m_faces.size(); }

private:
  struct Face_content
  {
    std::array<Vertex_handle, 3> vertices;
    std::array<Face_handle, 3> neighbors; // none where the part begins, or the domain ends
    std::array<bool, 3> is_constrained;
    bool is_in_domain = true;
    int info = 0;

    bool operator==(const Face_content& c) const
    {
      return vertices == c.vertices && neighbors == c.neighbors && is_constrained == c.is_constrained &&
             is_in_domain == c.is_in_domain && info == c.info;
    }
  };

  using Vertex_content = std::pair<typename CDT::Point, int>;

  template <class Handle>
  static int info(Handle h)
  {
    if constexpr (Has_info<std::decay_t<decltype(*h)>>::value)
      return h->info();
    else
      return 0;
  }

  static void set_info(CDT& cdt)
  {
    int number = 1;
    if constexpr (Has_info<typename CDT::Vertex>::value)
      for (Vertex_handle v : cdt.finite_vertex_handles())
        v->info() = number++;
    if constexpr (Has_info<typename CDT::Face>::value)
      for (Face_handle f : cdt.finite_face_handles())
        f->info() = number++;
  }

  Face_content content(Face_handle f) const
  {
    Face_content c{{}, {}, {}, f->is_in_domain(), info(f)};
    for (int i = 0; i < 3; ++i) {
      const Face_handle n = f->neighbor(i);
      c.vertices[i] = f->vertex(i);
      c.is_constrained[i] = f->is_constrained(i);
      if (m_faces.count(n) > 0) // else it may be another one later
        c.neighbors[i] = n;
      EXPECT_TRUE(n->has_neighbor(f));
    }
    return c;
  }

  static Vertex_content content(Vertex_handle v) { return {v->point(), info(v)}; }

  std::set<Face_handle> m_part;
  std::map<Face_handle, Face_content> m_faces;
  std::map<Vertex_handle, Vertex_content> m_vertices;
};

} // namespace adaptation

#endif // BUBBLE_RELAXATION_2_TEST_ADAPTATION_CHECKS_H
