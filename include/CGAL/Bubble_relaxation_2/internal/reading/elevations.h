// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_READING_ELEVATIONS_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_READING_ELEVATIONS_H

#include <CGAL/Bubble_relaxation_2/internal/core/Plane_2.h>
#include <CGAL/Bubble_relaxation_2/internal/core/in_words.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/outline.h>
#include <CGAL/Bubble_relaxation_2/internal/reading/read_domain.h>

#include <CGAL/Bubble_relaxation_parameters.h>
#include <CGAL/Interpolated_elevation_2.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// the user's elevations, if there are any
template <class Cdt, class NamedParameters>
Elevation_function<Cdt> given_elevation([[maybe_unused]] const NamedParameters& np)
{
  if constexpr (Is_given<NamedParameters, internal_np::elevation_function_t>::value) {
    return [f = parameters::get_parameter(np, internal_np::elevation_function)](const Place_2<Cdt>& p) {
      return static_cast<typename Cdt::Geom_traits::FT>(f(p));
    };
  } else {
    return nullptr;
  }
}

/// The elevations of bubbles of a terrain. They are found while it is as it was read, and by its own vertices and faces.
template <class Cdt, class Reading>
class Elevation_search_2
{
  using Plane = Plane_2<Cdt>;
  using FT = typename Cdt::Geom_traits::FT;
  using Vertex_handle = typename Cdt::Vertex_handle;

public:
  Elevation_search_2(const Cdt& cdt, const Reading& reading, const Bubbles_2& bubbles)
    : m_cdt(cdt), m_reading(reading), m_bubbles(bubbles)
  {}

  /// \throws std::invalid_argument if an elevation is not finite
  Elevations<Cdt> operator()(const Elevation_function<Cdt>& given)
  {
    m_elevations.assign(m_bubbles.size(), FT(0));
    if (!given)
      interpolate_on_edges();
    // a part of a terrain is to be found however large the rest is
    const Interpolated_elevation_2<Cdt> surface(m_cdt, m_reading.vertex(m_reading.graph->corners().front())->face());
    for (std::size_t i = 0; i < m_bubbles.size(); ++i) {
      if (m_bubbles.is_corner(i))
        m_elevations[i] = Plane::elevation(vertex_of_corner(m_reading, m_bubbles, i)->point());
      else if (given)
        m_elevations[i] = given(place(i));
      else if (m_bubbles.is_in_face(i))
        m_elevations[i] = surface(place(i));
      check(i);
    }
    return std::move(m_elevations);
  }

private:
  Place_2<Cdt> place(std::size_t i) const { return Place_2<Cdt>(m_bubbles.x[i], m_bubbles.y[i]); }

  void check(std::size_t i) const
  {
    const double z = CGAL::to_double(m_elevations[i]);
    if (!std::isfinite(z))
      throw std::invalid_argument("Bubble_relaxation_2: the elevation " + in_words(z) + " at " +
                                  in_words(m_bubbles.x[i], m_bubbles.y[i]) + " must be finite");
  }

  /// Not in the faces beside an edge: bubbles on it lie beside it by a rounding, where a face may be steep.
  void interpolate_on_edges()
  {
    const std::vector<std::vector<Index>> on_edge = bubbles_on_edges(m_reading.domain, m_bubbles);
    for (std::size_t e = 0; e < on_edge.size(); ++e) {
      if (on_edge[e].empty())
        continue;
      const std::vector<Profile_point> profile = profile_of(m_reading.graph->chains()[e]);
      std::size_t k = 1;
      for (Index i : on_edge[e]) {
        const double s = m_bubbles.s[i];
        while (k + 1 < profile.size() && profile[k].s < s)
          ++k;
        const Profile_point &a = profile[k - 1], &b = profile[k];
        const double t = b.s > a.s ? (std::min)(1., (std::max)(0., (s - a.s) / (b.s - a.s))) : 0;
        m_elevations[static_cast<std::size_t>(i)] = FT((1 - t) * a.elevation + t * b.elevation);
      }
    }
  }

  struct Profile_point
  {
    double s, elevation; // how far it is on the way from source to target
  };

  /// the elevations of a chain's vertices, in order
  std::vector<Profile_point> profile_of(const Constraint_graph_2::Chain& chain) const
  {
    const std::vector<Vertex_handle> path = path_of(m_reading, chain);
    const auto place_of = [](Vertex_handle v) { return point_in_double<Cdt>(v->point()); };
    const Point source = place_of(path.front());
    const auto way = place_of(path.back()) - source;
    std::vector<Profile_point> profile;
    for (Vertex_handle v : path)
      profile.push_back({(place_of(v) - source) * way / way.squared_length(),
                         CGAL::to_double(Plane::elevation(v->point()))});
    return profile;
  }

  const Cdt& m_cdt;
  const Reading& m_reading;
  const Bubbles_2& m_bubbles;
  Elevations<Cdt> m_elevations;
};

/// the elevations of bubbles that become vertices; none where points lie in the plane
template <class Cdt, class Reading>
Elevations<Cdt> find_elevations([[maybe_unused]] const Cdt& cdt, [[maybe_unused]] const Reading& reading,
                                [[maybe_unused]] const Bubbles_2& bubbles,
                                [[maybe_unused]] const Elevation_function<Cdt>& given)
{
  if constexpr (Plane_2<Cdt>::has_elevation)
    return Elevation_search_2<Cdt, Reading>(cdt, reading, bubbles)(given);
  else
    return {};
}

/// the elevations of bubbles that are the vertices of a mesh
template <class Cdt>
Elevations<Cdt> surface_elevations([[maybe_unused]] const Cdt& mesh, [[maybe_unused]] const Bubbles_2& bubbles)
{
  Elevations<Cdt> elevations;
  if constexpr (Plane_2<Cdt>::has_elevation) {
    const Interpolated_elevation_2<Cdt> surface(mesh);
    for (std::size_t i = 0; i < bubbles.size(); ++i)
      elevations.push_back(surface(Place_2<Cdt>(bubbles.x[i], bubbles.y[i])));
  }
  return elevations;
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_READING_ELEVATIONS_H
