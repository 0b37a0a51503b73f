// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DOMAIN_DOMAIN_MARKS_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DOMAIN_DOMAIN_MARKS_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/Plane_2.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Progress.h>
#include <CGAL/Bubble_relaxation_2/internal/core/vocabulary.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/flatten_triangulation.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/locate_straight.h>

#include <CGAL/Bubble_relaxation_parameters.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

template <class Face, class = void>
struct Has_domain_mark : std::false_type {};

template <class Face>
struct Has_domain_mark<Face, std::void_t<decltype(std::declval<Face&>().set_in_domain(true)),
                                         decltype(std::declval<const Face&>().is_in_domain())>>
  : std::true_type
{};

/// The faces of a triangulation that count: those that are marked as the domain's, all if none is, or if faces have no
/// marks.
template <class Triangulation>
class Faces_that_count
{
public:
  explicit Faces_that_count(const Triangulation& t)
  {
    if constexpr (has_marks)
      m_is_any_marked = std::any_of(t.finite_faces_begin(), t.finite_faces_end(),
                                    [](const auto& f) { return f.is_in_domain(); });
  }

  bool operator()(typename Triangulation::Face_handle f) const
  {
    if constexpr (has_marks)
      return !m_is_any_marked || f->is_in_domain();
    else
      return f != typename Triangulation::Face_handle();
  }

private:
  static constexpr bool has_marks = Has_domain_mark<typename Triangulation::Face>::value;

  bool m_is_any_marked = false;
};

/// Which triangles of a user's triangulation form the domain, found in arrays.
class Marked_copy_2 : public Triangulation_copy_2
{
public:
  /// some faces of a triangulation, which all are inside. `is_rim(face, i)`: whether a side that has none of them
  /// behind it is to stay as it is; then it counts as constrained
  /// \throws std::invalid_argument as `check_coordinates()` does
  template <class Cdt, class Is_rim>
  Marked_copy_2(const Cdt& cdt, const std::vector<typename Cdt::Face_handle>& some, const Is_rim& is_rim)
    : Triangulation_copy_2(cdt, some)
  {
    check_coordinates(tr.points);
    tr.inside.assign(tr.number_of_triangles(), 1);
    m_number_of_faces = tr.number_of_triangles();
    for (std::size_t t = 0; t < m_number_of_faces; ++t) {
      tick(t);
      const auto f = Handles<Cdt>::face(faces.addresses()[t]);
      int rim = 0;
      for (int i = 0; i < 3; ++i)
        rim |= tr.neighbors[t][i] == no_index && is_rim(f, i) ? 1 << i : 0;
      m_rim.push_back(static_cast<char>(rim));
      add_constraints(f->is_constrained(0) || (rim & 1), f->is_constrained(1) || (rim & 2),
                      f->is_constrained(2) || (rim & 4));
    }
  }

  /// whether the side `i` of a triangle is constrained
  bool is_constrained(Index t, int i) const { return (m_constrained[t] >> i & 1) != 0; }

  bool is_inside(Index t) const { return t != no_index && tr.inside[t]; }

  /// whether the side `i` of a triangle parts what is copied from what is not, and is to stay as it is
  bool is_rim(Index t, int i) const { return !m_rim.empty() && (m_rim[t] >> i & 1) != 0; }

  std::size_t number_of_faces() const { return m_number_of_faces; }

  /// \throws std::invalid_argument if there is no domain, if a constraint is missing around it, where bubbles could
  /// leave it, or if vertices are nearer to each other than the least length
  void check_domain() const;

  /// \throws std::invalid_argument if vertices are nearer to each other than the least length
  void check_lengths() const;

protected:
  /// \throws std::invalid_argument if there are no triangles, or as `check_coordinates()` does
  template <class Cdt>
  explicit Marked_copy_2(const Cdt& cdt)
    : Triangulation_copy_2(check_dimension(cdt, cdt.dimension(), cdt.number_of_vertices()))
  {
    check_coordinates(tr.points);
    tr.inside.assign(tr.number_of_triangles(), 0);
    m_constrained.reserve(tr.number_of_triangles());
    for (void* f : faces.addresses()) {
      tick(m_constrained.size());
      const auto& face = *static_cast<typename Cdt::Face*>(f);
      add_constraints(face.is_constrained(0), face.is_constrained(1), face.is_constrained(2));
    }
  }

  void set_inside(Index t)
  {
    tr.inside[t] = 1;
    ++m_number_of_faces;
  }

  /// \param seeds the triangles of the seeds, `no_index` for those beyond the hull
  void mark_by_seeds(const std::vector<Index>& seeds, bool seeds_are_in_domain);

  void mark_by_nesting();

  static void check_seed(const Point& seed);

  /// \throws std::invalid_argument if constraints part the triangles around a seed: which of them the seed means would
  /// depend on how the triangulation came about
  void check_region(const Point& seed, const std::vector<Index>& around) const;

  [[noreturn]] static void throw_seed(const Point& seed, const char* what);

private:
  /// whether no constraint parts triangles around a point
  bool hang_together(const std::vector<Index>& triangles) const;

  void add_constraints(bool side_0, bool side_1, bool side_2)
  {
    m_constrained.push_back(static_cast<char>(side_0 | side_1 << 1 | side_2 << 2));
  }

  template <class Cdt>
  static const Cdt& check_dimension(const Cdt& cdt, int dimension, std::size_t number_of_vertices)
  {
    if (dimension < 2)
      throw_dimension(dimension, number_of_vertices);
    return cdt;
  }

  /// a place where an outline may have been meant to go on; empty if there is none
  std::string open_end_in_words() const;

  [[noreturn]] void throw_side(Index t, int i, const std::string& what) const;

  [[noreturn]] static void throw_dimension(int dimension, std::size_t number_of_vertices);

  static void reach(Index t, std::vector<char>& is_reached, std::vector<Index>& reached);

  /// the triangles that no constraint separates from what lies beyond the hull; `behind`: others at the hull
  void reach_from_beyond_hull(std::vector<char>& is_reached, std::vector<Index>& reached,
                              std::vector<Index>& behind) const;

  /// reaches all triangles that no constraint separates from those that are reached
  void flood(std::vector<char>& is_reached, std::vector<Index>& reached) const;

  std::vector<char> m_constrained;
  std::vector<char> m_rim; // sides of the triangles, if some faces were copied only
  std::size_t m_number_of_faces = 0;
};

/// Which faces of a triangulation form the domain: those that the seeds reach, as in Mesh_2; without
/// seeds those that are marked; if none is marked, those in an odd number of outlines.
template <class Cdt>
class Domain_marks_2 : public Marked_copy_2
{
public:
  using Face_handle = typename Cdt::Face_handle;

  /// whether faces carry a mark, as models of `DelaunayMeshFaceBase_2` do
  static constexpr bool has_marks = Has_domain_mark<typename Cdt::Face>::value;

  /// \throws std::invalid_argument if a coordinate is out of bounds, or as `check_domain()` does
  template <class NamedParameters>
  Domain_marks_2(const Cdt& cdt, const NamedParameters& np) : Marked_copy_2(cdt)
  {
    if constexpr (Is_given<NamedParameters, internal_np::seeds_t>::value) {
      const bool seeds_are_in_domain =
        parameters::choose_parameter(parameters::get_parameter(np, internal_np::seeds_are_in_domain), false);
      mark_by_seeds(locate(cdt, parameters::get_parameter(np, internal_np::seeds), seeds_are_in_domain),
                    seeds_are_in_domain);
    } else if (!copy_marks()) {
      mark_by_nesting();
    }
    check_domain();
  }

  bool operator()(Face_handle f) const { return is_inside(faces(&*f)); }

private:
  template <class Range>
  std::vector<Index> locate(const Cdt& cdt, const Range& seeds, bool seeds_are_in_domain) const
  {
    std::vector<Index> located;
    typename Cdt::Vertex_handle near = cdt.finite_vertices_begin(); // seeds that follow each other mostly are
    for (const auto& seed : seeds) {
      const typename Cdt::Point q = as_point(seed);
      const Point p = point_in_double<Cdt>(q);
      check_seed(p);
      const std::vector<Index> around = triangles_around(cdt, q, near);
      check_region(p, around);
      located.push_back(around.front());
      if (located.back() == no_index && seeds_are_in_domain)
        throw_seed(p, "lies outside of all outlines and cannot be in the domain");
    }
    return located;
  }

  /// a seed of a terrain may be given by its place alone
  template <class Seed>
  static typename Cdt::Point as_point(const Seed& seed)
  {
    if constexpr (std::is_convertible<const Seed&, typename Cdt::Point>::value)
      return seed;
    else
      return Plane_2<Cdt>::point(seed.x(), seed.y(), 0);
  }

  /// the triangles that a point lies in, or on the boundary of, `no_index` for what is beyond the hull; `near`: a vertex to
  /// search from, and then one next to the point
  std::vector<Index> triangles_around(const Cdt& cdt, const typename Cdt::Point& p,
                                      typename Cdt::Vertex_handle& near) const
  {
    typename Cdt::Locate_type where{};
    int i = 0;
    const Face_handle f = locate_straight(cdt, p, near, where, i);
    if (!cdt.is_infinite(f))
      near = f->vertex(0);
    std::vector<Index> around{faces(&*f)};
    if (where == Cdt::EDGE) {
      around.push_back(faces(&*f->neighbor(i)));
    } else if (where == Cdt::VERTEX) {
      around.clear();
      auto face = cdt.incident_faces(f->vertex(i)), first = face;
      do
        around.push_back(faces(&*face));
      while (++face != first);
    }
    return around;
  }

  bool copy_marks()
  {
    if constexpr (has_marks)
      for (std::size_t t = 0; t < tr.inside.size(); ++t)
        if (static_cast<typename Cdt::Face*>(faces.addresses()[t])->is_in_domain())
          set_inside(static_cast<Index>(t));
    return number_of_faces() > 0;
  }
};

} // namespace CGAL::Bubble_relaxation_2::internal

#ifndef CGAL_BUBBLE_RELAXATION_2_COMPILED
#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_marks_2_impl.h>
#endif

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DOMAIN_DOMAIN_MARKS_2_H
