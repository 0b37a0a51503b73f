// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef BUBBLE_RELAXATION_2_DEMO_CARRIED_VALUES_H
#define BUBBLE_RELAXATION_2_DEMO_CARRIED_VALUES_H

#include "linear_finite_elements.h"

#include <CGAL/Default_adaptation_visitor_2.h>
#include <CGAL/property_map.h>
#include <CGAL/transfer_2.h>

#include <Eigen/Core>

#include <cstddef>
#include <ctime>
#include <unordered_map>

/// Values at the vertices of a mesh of which parts are meshed anew: vertices that stay keep theirs, new ones get what
/// the old faces have in their place.
template <class CDT>
struct Carried_values : CGAL::Default_adaptation_visitor_2<CDT>
{
  using Base = CGAL::Default_adaptation_visitor_2<CDT>;
  using Faces = typename Base::Faces;
  using Vertices = typename Base::Vertices;
  using Values = std::unordered_map<typename CDT::Vertex_handle, double>;

  explicit Carried_values(const CDT& t) : cdt(t) {}

  void while_both_exist(const Faces& old_faces, const Vertices& removed, const Faces& new_faces,
                        const Vertices& new_vertices)
  {
    number_of_new_vertices += new_vertices.size();
    if (values.empty())
      return;
    const std::clock_t start = std::clock();
    Values result;
    CGAL::transfer_vertex_values_2(
      cdt, boost::make_assoc_property_map(values), cdt, boost::make_assoc_property_map(result),
      CGAL::parameters::source_faces(old_faces).target_faces(new_faces).transfer_method(
        CGAL::Vertex_transfer::INTERPOLATION));
    for (auto v : removed)
      values.erase(v);
    for (auto v : new_vertices)
      values[v] = result.at(v);
    seconds += double(std::clock() - start) / CLOCKS_PER_SEC;
  }

  /// those of a mesh in its order, 0 where there are none
  Eigen::VectorXd in_order(const Triangle_arrays<CDT>& mesh) const
  {
    Eigen::VectorXd u = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(mesh.vertices.size()));
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
      if (const auto found = values.find(mesh.vertices[v]); found != values.end())
        u[static_cast<Eigen::Index>(v)] = found->second;
    return u;
  }

  void set(const Triangle_arrays<CDT>& mesh, const Eigen::VectorXd& u)
  {
    values.clear();
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
      values[mesh.vertices[v]] = u[static_cast<Eigen::Index>(v)];
  }

  const CDT& cdt;
  Values values;
  std::size_t number_of_new_vertices = 0; ///< in all changes
  double seconds = 0;                     ///< of all transfers
};

#endif // BUBBLE_RELAXATION_2_DEMO_CARRIED_VALUES_H
