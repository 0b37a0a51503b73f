// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_ADAPTATION_PART_CHECK_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_ADAPTATION_PART_CHECK_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/Progress.h>
#include <CGAL/Bubble_relaxation_2/internal/core/check_call.h>
#include <CGAL/Bubble_relaxation_2/internal/core/in_words.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_marks_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/flatten_triangulation.h>

#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// Whether a face is in the domain, as far as the face itself can tell.
template <class Cdt>
struct Is_in_domain
{
  const Cdt& cdt;

  bool operator()(typename Cdt::Face_handle f) const
  {
    if constexpr (Has_domain_mark<typename Cdt::Face>::value)
      return f->is_in_domain();
    else
      return !cdt.is_infinite(f);
  }
};

/// Checks faces that a parameter of this name gives: they shall be of the domain.
template <class Cdt>
class Part_check_2
{
  using Face_handle = typename Cdt::Face_handle;

public:
  Part_check_2(const Cdt& cdt, std::string parameter)
    : m_cdt(cdt), m_parameter(std::move(parameter)), m_faces(sizeof(typename Cdt::Face))
  {}

  /// Each face once. It may be called once.
  /// \throws std::invalid_argument if one is not, or if there is none and there shall be some
  template <class Face_range, class Is_inside>
  std::vector<Face_handle> operator()(const Face_range& range, const Is_inside& is_in_domain, bool may_be_none)
  {
    if constexpr (check_faces<Face_range>())
      take(range);
    if (m_part.empty() && !may_be_none)
      throw_faces("is empty");
    check_owner();
    for (Face_handle f : m_part)
      check(f, is_in_domain);
    return std::move(m_part);
  }

private:
  template <class Face_range>
  void take(const Face_range& range)
  {
    if (m_cdt.dimension() < 2)
      throw_faces("cannot be of this triangulation, whose dimension is " + std::to_string(m_cdt.dimension()));
    for (Face_handle f : range) {
      tick(); // the user's range may be slow
      if (f == Face_handle())
        throw_faces("has an empty handle");
      if (m_faces(&*f) == no_index) {
        m_faces.add(&*f);
        m_part.push_back(f);
      }
    }
  }

  [[noreturn]] void throw_faces(const std::string& what) const
  {
    throw std::invalid_argument("Bubble_relaxation_2: parameter " + m_parameter + ' ' + what);
  }

  template <class Is_inside>
  void check(Face_handle f, const Is_inside& is_in_domain) const
  {
    if (m_cdt.is_infinite(f))
      throw_faces("has an infinite face");
    if (is_in_domain(f))
      return;
    const Point p = point_in_double<Cdt>(f->vertex(0)->point());
    constexpr bool has_mark = Has_domain_mark<typename Cdt::Face>::value;
    constexpr const char* what = has_mark ? "marked as one of the domain" : "in the domain";
    throw_faces(std::string("has a face that is not ") + what + ", with a vertex at " + in_words(p.x(), p.y()));
  }

  /// Of faces that hang together one tells of all whether they are this triangulation's: asking the triangulation takes
  /// longer, the larger it is.
  void check_owner() const
  {
    std::vector<char> is_reached(m_part.size(), 0);
    std::vector<Index> reached;
    for (std::size_t k = 0; k < m_part.size(); ++k) {
      if (is_reached[k])
        continue;
      if (!m_cdt.tds().faces().owns_dereferencable(m_part[k]))
        throw_faces("has a face that is none of this triangulation; a change may have replaced it");
      is_reached[k] = 1;
      reached.assign(1, static_cast<Index>(k));
      while (!reached.empty()) {
        tick();
        const Face_handle f = m_part[reached.back()];
        reached.pop_back();
        for (int i = 0; i < 3; ++i) {
          const Index n = m_faces(&*f->neighbor(i));
          if (n != no_index && !is_reached[n]) {
            is_reached[n] = 1;
            reached.push_back(n);
          }
        }
      }
    }
  }

  const Cdt& m_cdt;
  std::string m_parameter;
  Address_numbers m_faces;
  std::vector<Face_handle> m_part;
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_ADAPTATION_PART_CHECK_2_H
