// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DOMAIN_DOMAIN_MARKS_2_IMPL_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DOMAIN_DOMAIN_MARKS_2_IMPL_H

#include <CGAL/Bubble_relaxation_2/internal/core/Progress.h>
#include <CGAL/Bubble_relaxation_2/internal/core/in_words.h>
#include <CGAL/Bubble_relaxation_2/internal/core/magnitudes.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_marks_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <unordered_set>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

CGAL_BUBBLE_RELAXATION_2_INLINE
void Marked_copy_2::mark_by_seeds(const std::vector<Index>& seeds, bool seeds_are_in_domain)
{
  std::vector<char> is_reached(tr.inside.size(), 0);
  std::vector<Index> reached, behind;
  if (!seeds_are_in_domain)
    reach_from_beyond_hull(is_reached, reached, behind);
  for (Index t : seeds)
    if (t != no_index)
      reach(t, is_reached, reached);
  flood(is_reached, reached);
  for (std::size_t t = 0; t < tr.inside.size(); ++t)
    if ((is_reached[t] != 0) == seeds_are_in_domain)
      set_inside(static_cast<Index>(t));
}

CGAL_BUBBLE_RELAXATION_2_INLINE
void Marked_copy_2::mark_by_nesting()
{
  std::vector<char> is_reached(tr.inside.size(), 0);
  std::vector<Index> level, next_level;
  reach_from_beyond_hull(is_reached, level, next_level);
  for (bool is_odd = false; !level.empty() || !next_level.empty(); is_odd = !is_odd) {
    flood(is_reached, level);
    for (Index t : level) {
      if (is_odd)
        set_inside(t);
      next_level.insert(next_level.end(), tr.neighbors[t].begin(), tr.neighbors[t].end());
    }
    level.clear();
    for (Index t : next_level)
      reach(t, is_reached, level);
    next_level.clear();
  }
}

CGAL_BUBBLE_RELAXATION_2_INLINE
void Marked_copy_2::check_domain() const
{
  if (m_number_of_faces == 0)
    throw std::invalid_argument("Bubble_relaxation_2: no face lies in the domain: the constraints close no "
                                "region, or all regions are holes" + open_end_in_words());
  for (std::size_t t = 0; t < tr.inside.size(); ++t) {
    tick(t);
    for (int i = 0; i < 3 && tr.inside[t]; ++i)
      if (!is_constrained(static_cast<Index>(t), i) && !is_inside(tr.neighbors[t][i]))
        throw_side(static_cast<Index>(t), i, "bounds the domain and must be constrained; faces beside a vertex that "
                                             "was inserted since the domain was marked have no marks");
  }
  check_lengths();
}

CGAL_BUBBLE_RELAXATION_2_INLINE
void Marked_copy_2::check_lengths() const
{
  for (std::size_t t = 0; t < tr.inside.size(); ++t) {
    tick(t);
    for (int i = 0; i < 3 && tr.inside[t]; ++i) {
      const Point &p = tr.point(static_cast<Index>(t), ccw(i)), &q = tr.point(static_cast<Index>(t), cw(i));
      // what coincides in double is told elsewhere
      if (p != q && (std::max)(std::abs(q.x() - p.x()), std::abs(q.y() - p.y())) < smallest_length)
        throw_side(static_cast<Index>(t), i,
                   "is too short: x or y must differ by at least " + in_words(smallest_length));
    }
  }
}

CGAL_BUBBLE_RELAXATION_2_INLINE
std::string Marked_copy_2::open_end_in_words() const
{
  std::vector<int> number_of_constraints(tr.points.size(), 0);
  for (std::size_t t = 0; t < tr.inside.size(); ++t)
    for (int i = 0; i < 3; ++i)
      if (is_constrained(static_cast<Index>(t), i) && tr.neighbors[t][i] < static_cast<Index>(t)) // each once
        for (int end : {ccw(i), cw(i)})
          ++number_of_constraints[tr.vertices[t][end]];
  const Point* open = nullptr;
  for (std::size_t v = 0; v < tr.points.size(); ++v)
    if (number_of_constraints[v] == 1 && (open == nullptr || tr.points[v] < *open))
      open = &tr.points[v];
  return open == nullptr ? "" : "; only one constraint ends at " + in_words(open->x(), open->y());
}

CGAL_BUBBLE_RELAXATION_2_INLINE
void Marked_copy_2::throw_side(Index t, int i, const std::string& what) const
{
  const Point &p = tr.point(t, ccw(i)), &q = tr.point(t, cw(i));
  throw std::invalid_argument("Bubble_relaxation_2: the edge from " + in_words(p.x(), p.y()) + " to " +
                              in_words(q.x(), q.y()) + " " + what);
}

CGAL_BUBBLE_RELAXATION_2_INLINE
void Marked_copy_2::check_seed(const Point& seed)
{
  if (!is_coordinate(seed.x()) || !is_coordinate(seed.y()))
    throw_seed(seed, ("must be " + required_of_coordinates(seed.x(), seed.y())).c_str());
}

CGAL_BUBBLE_RELAXATION_2_INLINE
void Marked_copy_2::check_region(const Point& seed, const std::vector<Index>& around) const
{
  if (hang_together(around))
    return;
  std::vector<char> is_reached(tr.inside.size(), 0); // by a way around the end of a constraint
  std::vector<Index> reached, behind;
  if (std::find(around.begin(), around.end(), no_index) != around.end())
    reach_from_beyond_hull(is_reached, reached, behind);
  else
    reach(around.front(), is_reached, reached);
  flood(is_reached, reached);
  for (Index t : around)
    if (t != no_index && !is_reached[t])
      throw_seed(seed, "lies on a constraint and does not tell which side is meant");
}

CGAL_BUBBLE_RELAXATION_2_INLINE
bool Marked_copy_2::hang_together(const std::vector<Index>& triangles) const
{
  std::unordered_set<Index> others(triangles.begin() + 1, triangles.end());
  std::vector<Index> reached{triangles.front()};
  for (std::size_t k = 0; k < reached.size() && reached[k] != no_index; ++k)
    for (int i = 0; i < 3; ++i)
      if (const Index n = tr.neighbors[reached[k]][i]; !is_constrained(reached[k], i) && others.erase(n) > 0)
        reached.push_back(n);
  return others.empty();
}

CGAL_BUBBLE_RELAXATION_2_INLINE
void Marked_copy_2::throw_seed(const Point& seed, const char* what)
{
  throw std::invalid_argument("Bubble_relaxation_2: parameter seeds: " + in_words(seed.x(), seed.y()) + " " + what);
}

CGAL_BUBBLE_RELAXATION_2_INLINE
void Marked_copy_2::throw_dimension(int dimension, std::size_t number_of_vertices)
{
  throw std::invalid_argument("Bubble_relaxation_2: the triangulation has " + std::to_string(number_of_vertices) +
                              " vertices and the dimension " + std::to_string(dimension) +
                              ", so it bounds no domain");
}

CGAL_BUBBLE_RELAXATION_2_INLINE
void Marked_copy_2::reach(Index t, std::vector<char>& is_reached, std::vector<Index>& reached)
{
  if (t == no_index || is_reached[t])
    return;
  is_reached[t] = 1;
  reached.push_back(t);
}

CGAL_BUBBLE_RELAXATION_2_INLINE
void Marked_copy_2::reach_from_beyond_hull(std::vector<char>& is_reached, std::vector<Index>& reached,
                            std::vector<Index>& behind) const
{
  for (std::size_t t = 0; t < tr.inside.size(); ++t)
    for (int i = 0; i < 3; ++i) {
      const Index f = static_cast<Index>(t);
      if (tr.neighbors[t][i] != no_index)
        continue;
      if (is_constrained(f, i))
        behind.push_back(f);
      else
        reach(f, is_reached, reached);
    }
}

CGAL_BUBBLE_RELAXATION_2_INLINE
void Marked_copy_2::flood(std::vector<char>& is_reached, std::vector<Index>& reached) const
{
  for (std::size_t k = 0; k < reached.size(); ++k) {
    tick(k);
    for (int i = 0; i < 3; ++i)
      if (!is_constrained(reached[k], i))
        reach(tr.neighbors[reached[k]][i], is_reached, reached);
  }
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DOMAIN_DOMAIN_MARKS_2_IMPL_H
