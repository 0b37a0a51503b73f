// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_ADAPTATION_FACE_EXCHANGE_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_ADAPTATION_FACE_EXCHANGE_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/in_words.h>
#include <CGAL/Bubble_relaxation_2/internal/core/vocabulary.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_marks_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/flatten_triangulation.h>

#include <array>
#include <cstddef>
#include <map>
#include <set>
#include <stdexcept>
#include <type_traits>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// Whether faces are numbered as they are created, as in triangulations for meshes: no two may have one number.
template <class Face, class = void>
struct Has_time_stamp : std::false_type {};

template <class Face>
struct Has_time_stamp<Face, std::void_t<decltype(std::declval<Face&>().set_time_stamp(0))>> : std::true_type {};

/// New faces of a triangulation that take the place of old ones, all at once. Until then new faces know each other and
/// the old ones around them, but no old face or vertex knows a new one: what fails before is forgotten without a trace.
/// The exchange itself does not throw, and can be undone until the old ones are deleted.
///
/// An old face that turns out to be in the way is copied: the copy is a new face. Sides with nothing behind them yet
/// are open.
template <class Cdt>
class Face_exchange_2
{
public:
  using Vertex_handle = typename Cdt::Vertex_handle;
  using Face_handle = typename Cdt::Face_handle;

  /// what is behind a side of a new face
  struct Side
  {
    Face_handle face; ///< none if the side is open
    int index;        ///< of the same side there
    bool is_constrained;
  };

  explicit Face_exchange_2(Cdt& cdt)
    : m_cdt(cdt), m_new_numbers(sizeof(typename Cdt::Face)), m_old_numbers(sizeof(typename Cdt::Face))
  {}

  Face_exchange_2(const Face_exchange_2&) = delete;
  Face_exchange_2& operator=(const Face_exchange_2&) = delete;

  ~Face_exchange_2()
  {
    if (m_is_finished)
      return;
    if (m_is_exchanged)
      undo();
    for (Face_handle f : m_new)
      m_cdt.tds().delete_face(f);
    for (Vertex_handle v : m_new_vertices)
      m_cdt.tds().delete_vertex(v);
  }

  Vertex_handle add_vertex(const typename Cdt::Point& p)
  {
    make_room_for(1, m_new_vertices);
    m_new_vertices.push_back(m_cdt.tds().create_vertex());
    m_new_vertices.back()->set_point(p);
    return m_new_vertices.back();
  }

  /// a new face with three open sides
  Face_handle add_face(Vertex_handle a, Vertex_handle b, Vertex_handle c)
  {
    make_room_for(1, m_new);
    return enter(m_cdt.tds().create_face(a, b, c));
  }

  /// an old face is to go
  void take(Face_handle old)
  {
    m_old_numbers.add(&*old);
    m_old.push_back(old);
    m_copies.push_back(Face_handle());
  }

  bool is_taken(Face_handle f) const { return m_old_numbers(&*f) != no_index; }

  bool is_new(Face_handle f) const { return m_new_numbers(&*f) != no_index; }

  /// the old face beside a part, or what has taken its place
  Face_handle copy(Face_handle old)
  {
    const Index known = m_old_numbers(&*old);
    if (known != no_index)
      return m_copies[known];
    check_is_outside(*old);
    make_room_for(1, m_new);
    const Face_handle f = enter(m_cdt.tds().create_face());
    if constexpr (Has_time_stamp<typename Cdt::Face>::value) { // with what the user's face base carries
      const auto stamp = f->time_stamp();
      *f = *old;
      f->set_time_stamp(stamp);
    } else {
      *f = *old;
    }
    take(old);
    m_copies.back() = f;
    const std::array<Front, 3> front = m_front.count(&*old) > 0 ? m_front[&*old] : std::array<Front, 3>();
    m_front.erase(&*old);
    for (int i = 0; i < 3; ++i) {
      const Face_handle n = old->neighbor(i);
      const bool is_constrained = old->is_constrained(i);
      if (front[i].face != Face_handle()) // a new face is in front of it
        link(f, i, Side{front[i].face, front[i].index, is_constrained});
      else if (m_old_numbers(&*n) != no_index)
        link(f, i, Side{Face_handle(), 0, is_constrained});
      else
        link(f, i, Side{n, mirror_index(old, i), is_constrained});
    }
    return f;
  }

  /// what is behind the side `i` of a new face, as a new face
  Face_handle across(Face_handle f, int i)
  {
    const Face_handle n = f->neighbor(i);
    return is_new(n) ? n : copy(n);
  }

  Side side(Face_handle f, int i) const
  {
    const Face_handle n = f->neighbor(i);
    return Side{n, n == Face_handle() ? 0 : mirror_index(f, i), f->is_constrained(i)};
  }

  /// puts `s` behind the side `i` of a new face, and the face in front of `s`
  void link(Face_handle f, int i, const Side& s)
  {
    f->set_neighbor(i, s.face);
    f->set_constraint(i, s.is_constrained);
    if (s.face == Face_handle()) {
      m_open[ends(f, i)] = Front{f, i};
    } else if (is_new(s.face)) {
      s.face->set_neighbor(s.index, f);
      s.face->set_constraint(s.index, s.is_constrained);
    } else {
      m_front[&*s.face][static_cast<std::size_t>(s.index)] = Front{f, i};
    }
  }

  /// the open side from one vertex to another, which has its face on the left; empty if there is none
  Side open_side(Vertex_handle from, Vertex_handle to) const
  {
    const auto found = m_open.find({&*from, &*to});
    return found == m_open.end() ? Side{Face_handle(), 0, false} : Side{found->second.face, found->second.index, true};
  }

  /// it is linked now, or gone
  void forget_open_side(Vertex_handle from, Vertex_handle to) { m_open.erase({&*from, &*to}); }

  bool has_open_sides() const { return !m_open.empty(); }

  /// a new face is not needed any more; its sides are to be linked with others
  void drop(Face_handle f) { m_is_dropped[m_new_numbers(&*f)] = 1; }

  bool is_dropped(Face_handle f) const { return m_is_dropped[m_new_numbers(&*f)] != 0; }

  /// turns the edge on the side `i` of a new face, which is not constrained, between two new faces
  void flip(Face_handle f, int i)
  {
    const Face_handle g = across(f, i);
    const int j = mirror_index(f, i);
    const Vertex_handle p = f->vertex(i), a = f->vertex(Cdt::ccw(i)), b = f->vertex(Cdt::cw(i)), q = g->vertex(j);
    const Side pa = side(f, Cdt::cw(i)), bp = side(f, Cdt::ccw(i)), qb = side(g, Cdt::cw(j)),
               aq = side(g, Cdt::ccw(j));
    f->set_vertices(p, a, q);
    g->set_vertices(p, q, b);
    link(f, 0, aq);
    link(f, 2, pa);
    link(g, 0, qb);
    link(g, 1, bp);
    link(f, 1, Side{g, 2, false});
  }

  /// Whether faces fit together: each knows the one behind a side of a new face by that side and by no other, and no
  /// vertex is without a face but those that are `removed`. Where vertices lie beside an edge by a rounding, what fits
  /// at one may not fit at the next.
  bool is_sound(const std::vector<Vertex_handle>& removed) const
  {
    for (Face_handle f : m_new) {
      tick();
      for (int i = 0; i < 3 && !is_dropped(f); ++i)
        if (f->neighbor(i) != Face_handle() && !is_sound(f, i))
          return false;
    }
    return has_all_vertices(removed);
  }

  const std::vector<Face_handle>& new_faces() const { return m_new; } ///< with dropped ones
  const std::vector<Vertex_handle>& new_vertices() const { return m_new_vertices; }

  /// When all new faces are made: notes which vertices refer to an old face, which is to be theirs again if there is a
  /// way back.
  void prepare()
  {
    for (Face_handle f : m_old)
      for (int i = 0; i < 3; ++i)
        if (f->vertex(i)->face() == f) {
          make_room_for(1, m_homes);
          m_homes.emplace_back(f->vertex(i), f);
        }
  }

  /// Puts the new faces into the place of the old ones. \pre it is prepared
  void exchange() noexcept
  {
    for (const auto& [v, f] : m_homes)
      v->set_face(Face_handle());
    for (const auto& [old, front] : m_front)
      for (int j = 0; j < 3; ++j)
        if (front[j].face != Face_handle())
          static_cast<typename Cdt::Face*>(old)->set_neighbor(j, front[j].face);
    for (Face_handle f : m_new)
      for (int i = 0; i < 3 && !is_dropped(f); ++i)
        if (f->vertex(i)->face() == Face_handle())
          f->vertex(i)->set_face(f);
    for (const auto& [v, f] : m_homes)
      if (v->face() == Face_handle()) // it goes
        v->set_face(f);
    m_is_exchanged = true;
  }

  /// deletes the old faces and what was dropped, and old vertices; then there is no way back
  void finish(const std::vector<Vertex_handle>& removed) noexcept
  {
    for (Face_handle f : m_new)
      if (is_dropped(f))
        m_cdt.tds().delete_face(f);
    for (Face_handle f : m_old)
      m_cdt.tds().delete_face(f);
    for (Vertex_handle v : removed)
      m_cdt.tds().delete_vertex(v);
    m_is_finished = true;
  }

private:
  /// a new face that has an open side, or an old face behind it
  struct Front
  {
    Face_handle face;
    int index = 0;
  };

  using Ends = std::pair<const void*, const void*>;

  static Ends ends(Face_handle f, int i) { return {&*f->vertex(Cdt::ccw(i)), &*f->vertex(Cdt::cw(i))}; }

  Face_handle enter(Face_handle f)
  {
    m_new.push_back(f); // there is room for it
    m_new_numbers.add(&*f);
    m_is_dropped.push_back(0);
    return f;
  }

  /// \throws std::invalid_argument if a face beside the part that is to change is one of the domain
  static void check_is_outside(const typename Cdt::Face& f)
  {
    if constexpr (Has_domain_mark<typename Cdt::Face>::value)
      if (f.is_in_domain()) {
        const Point p = point_in_double<Cdt>(f.vertex(0)->point());
        throw std::invalid_argument("Bubble_relaxation_2: the face with a vertex at " + in_words(p.x(), p.y()) +
                                    " is one of the domain, but has no constraint where that ends");
      }
  }

  /// of the side `i` of a face in the face behind it, which need not know that it is there
  static int mirror_index(Face_handle f, int i)
  {
    return Cdt::cw(f->neighbor(i)->index(f->vertex(Cdt::cw(i))));
  }

  /// whether all vertices of old faces that have copies, but the removed ones, are in faces that are not to go
  bool has_all_vertices(const std::vector<Vertex_handle>& removed) const
  {
    std::set<Vertex_handle> known(removed.begin(), removed.end());
    for (Face_handle f : m_new)
      for (int i = 0; i < 3 && !is_dropped(f); ++i)
        known.insert(f->vertex(i));
    for (std::size_t k = 0; k < m_old.size(); ++k)
      for (int i = 0; i < 3 && m_copies[k] != Face_handle(); ++i)
        if (known.count(m_old[k]->vertex(i)) == 0 && is_all_taken(m_old[k]->vertex(i)))
          return false;
    return true;
  }

  /// whether all faces around an old vertex are to go
  bool is_all_taken(Vertex_handle v) const
  {
    return are_all_around(m_cdt, v, [this](Face_handle f) { return is_taken(f); });
  }

  bool is_sound(Face_handle f, int i) const
  {
    const Face_handle n = f->neighbor(i);
    int j = 0;
    if (n == f->neighbor(Cdt::ccw(i)) || !n->has_vertex(f->vertex(Cdt::cw(i)), j))
      return false;
    j = Cdt::cw(j); // of the same side there
    if (n->vertex(Cdt::cw(j)) != f->vertex(Cdt::ccw(i)))
      return false;
    if (is_new(n))
      return !is_dropped(n) && n->neighbor(j) == f && n->is_constrained(j) == f->is_constrained(i);
    const auto found = m_front.find(&*n);
    return !is_taken(n) && found != m_front.end() && found->second[static_cast<std::size_t>(j)].face == f &&
           n->is_constrained(j) == f->is_constrained(i);
  }

  void undo() noexcept
  {
    for (Face_handle f : m_old)
      for (int i = 0; i < 3; ++i)
        f->neighbor(i)->set_neighbor(mirror_index(f, i), f);
    for (const auto& [v, f] : m_homes)
      v->set_face(f);
  }

  Cdt& m_cdt;
  std::vector<Face_handle> m_new, m_old;
  std::vector<Face_handle> m_copies; // of each old face, if it has one
  std::vector<char> m_is_dropped;    // of each new face
  Address_numbers m_new_numbers, m_old_numbers;
  std::vector<Vertex_handle> m_new_vertices;
  std::vector<std::pair<Vertex_handle, Face_handle>> m_homes;
  std::map<Ends, Front> m_open;
  std::unordered_map<void*, std::array<Front, 3>> m_front; // what old faces that stay have on their sides
  bool m_is_exchanged = false, m_is_finished = false;
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_ADAPTATION_FACE_EXCHANGE_2_H
