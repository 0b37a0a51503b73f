// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DOMAIN_DOMAIN_MARKS_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DOMAIN_DOMAIN_MARKS_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/in_words.h>

#include <CGAL/Bubble_relaxation_parameters.h>
#include <CGAL/Unique_hash_map.h>
#include <CGAL/number_utils.h>

#include <cmath>
#include <cstddef>
#include <sstream>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

template <class Face, class = void>
struct Has_domain_mark : std::false_type {};

template <class Face>
struct Has_domain_mark<Face, std::void_t<decltype(std::declval<Face&>().set_in_domain(true)),
                                         decltype(std::declval<const Face&>().is_in_domain())>>
  : std::true_type
{};

/// Which faces of a triangulation form the domain: those that the seeds reach, as in Mesh_2; without
/// seeds those that are marked; if none is marked, those in an odd number of outlines.
template <class Cdt>
class Domain_marks_2
{
public:
  using Face_handle = typename Cdt::Face_handle;

  /// whether faces carry a mark, as models of `DelaunayMeshFaceBase_2` do
  static constexpr bool has_marks = Has_domain_mark<typename Cdt::Face>::value;

  /// \throws std::invalid_argument if there is no domain, or if a constraint is missing around it
  template <class NamedParameters>
  Domain_marks_2(const Cdt& cdt, const NamedParameters& np) : m_cdt(cdt), m_inside(false)
  {
    if (cdt.dimension() < 2) {
      std::ostringstream message;
      message << "Bubble_relaxation_2: the triangulation has " << cdt.number_of_vertices()
              << " vertices and the dimension " << cdt.dimension() << ", so it bounds no domain";
      throw std::invalid_argument(message.str());
    }
    if constexpr (Is_given<NamedParameters, internal_np::seeds_t>::value)
      mark_by_seeds(parameters::get_parameter(np, internal_np::seeds),
                    parameters::choose_parameter(
                      parameters::get_parameter(np, internal_np::seeds_are_in_domain), false));
    else if (!copy_marks())
      mark_by_nesting();
    if (m_number_of_faces == 0)
      throw std::invalid_argument("Bubble_relaxation_2: no face lies in the domain: the constraints close no "
                                  "region, or all regions are holes");
    check_boundary();
  }

  bool operator()(Face_handle f) const { return m_inside[f]; }

  std::size_t number_of_faces() const { return m_number_of_faces; }

private:
  void set_inside(Face_handle f)
  {
    m_inside[f] = true;
    ++m_number_of_faces;
  }

  template <class Range>
  void mark_by_seeds(const Range& seeds, bool seeds_are_in_domain)
  {
    std::vector<Face_handle> reached;
    Unique_hash_map<Face_handle, bool> is_reached(false);
    if (!seeds_are_in_domain)
      flood(m_cdt.infinite_face(), is_reached, reached);
    for (const auto& seed : seeds) {
      const double x = CGAL::to_double(seed.x()), y = CGAL::to_double(seed.y());
      if (!std::isfinite(x) || !std::isfinite(y))
        throw_seed(x, y, "must be finite");
      typename Cdt::Locate_type type;
      int index;
      const Face_handle f = m_cdt.locate(seed, type, index);
      const bool is_outside = type == Cdt::OUTSIDE_CONVEX_HULL || m_cdt.is_infinite(f);
      if (is_outside && seeds_are_in_domain)
        throw_seed(x, y, "lies outside of all outlines and cannot be in the domain");
      if (!is_outside)
        flood(f, is_reached, reached);
    }
    if (seeds_are_in_domain) {
      for (Face_handle f : reached)
        if (!m_cdt.is_infinite(f))
          set_inside(f);
    } else {
      for (Face_handle f : m_cdt.finite_face_handles())
        if (!is_reached[f])
          set_inside(f);
    }
  }

  /// reaches all faces from `f` that no constraint separates from it
  void flood(Face_handle f, Unique_hash_map<Face_handle, bool>& is_reached,
             std::vector<Face_handle>& reached) const
  {
    if (is_reached[f])
      return;
    is_reached[f] = true;
    std::size_t next = reached.size();
    reached.push_back(f);
    for (; next < reached.size(); ++next) {
      const Face_handle g = reached[next];
      for (int i = 0; i < 3; ++i) {
        const Face_handle n = g->neighbor(i);
        if (g->is_constrained(i) || is_reached[n])
          continue;
        is_reached[n] = true;
        reached.push_back(n);
      }
    }
  }

  bool copy_marks()
  {
    if constexpr (has_marks)
      for (Face_handle f : m_cdt.finite_face_handles())
        if (f->is_in_domain())
          set_inside(f);
    return m_number_of_faces > 0;
  }

  void mark_by_nesting()
  {
    Unique_hash_map<Face_handle, bool> is_reached(false);
    std::vector<Face_handle> level, next_level(1, m_cdt.infinite_face());
    for (bool is_odd = false; !next_level.empty(); is_odd = !is_odd) {
      level.clear();
      for (Face_handle f : next_level)
        flood(f, is_reached, level);
      next_level.clear();
      for (Face_handle f : level) {
        if (is_odd)
          set_inside(f);
        for (int i = 0; i < 3; ++i)
          if (!is_reached[f->neighbor(i)])
            next_level.push_back(f->neighbor(i));
      }
    }
  }

  /// the domain must end at constraints, or bubbles could leave it
  void check_boundary() const
  {
    for (Face_handle f : m_cdt.finite_face_handles()) {
      if (!m_inside[f])
        continue;
      for (int i = 0; i < 3; ++i) {
        if (f->is_constrained(i) || m_inside[f->neighbor(i)])
          continue;
        const auto &p = f->vertex(m_cdt.ccw(i))->point(), &q = f->vertex(m_cdt.cw(i))->point();
        throw std::invalid_argument(
          "Bubble_relaxation_2: the edge from " + in_words(CGAL::to_double(p.x()), CGAL::to_double(p.y())) +
          " to " + in_words(CGAL::to_double(q.x()), CGAL::to_double(q.y())) +
          " bounds the domain and must be constrained");
      }
    }
  }

  [[noreturn]] static void throw_seed(double x, double y, const char* what)
  {
    throw std::invalid_argument("Bubble_relaxation_2: parameter seeds: " + in_words(x, y) + " " + what);
  }

  const Cdt& m_cdt;
  Unique_hash_map<Face_handle, bool> m_inside;
  std::size_t m_number_of_faces = 0;
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DOMAIN_DOMAIN_MARKS_2_H
