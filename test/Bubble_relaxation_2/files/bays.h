// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef BUBBLE_RELAXATION_2_TEST_BAYS_H
#define BUBBLE_RELAXATION_2_TEST_BAYS_H

#include "domains.h"

#include <CGAL/Constraint_marker_map_2.h>
#include <CGAL/Face_region_map_2.h>
#include <CGAL/Mesh_arrays_2.h>
#include <CGAL/npbs_relax.h>

#include <cstddef>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>
#include <unistd.h>

/// A mesh with all that files keep, and where to write it.
namespace bays {

/// a folder of this process, which goes with it: tests run at the same time
struct Folder
{
  std::filesystem::path path = std::filesystem::temp_directory_path() / ("test_files_" + std::to_string(getpid()));

  Folder() { std::filesystem::create_directories(path); }
  ~Folder() { std::filesystem::remove_all(path); }
  std::string operator/(const std::string& name) const { return (path / name).string(); }
  bool is_empty() const { return std::filesystem::is_empty(path); }
};

/// A bay, meshed: 5 is the open sea to the right, 2 the coast, 3 an island, 4 a wall that parts two regions, and a
/// second island has no marker. Coordinates have many digits, and are as large as those of maps.
template <class Marker = int, class Region = int>
struct Bay
{
  domains::CDT cdt;
  CGAL::Constraint_marker_map_2<domains::CDT, Marker> markers;
  CGAL::Face_region_map_2<domains::CDT, Region> regions;

  Bay(Marker sea, Marker coast, Marker island, Marker wall, Region left, Region right)
  {
    const auto insert = [&](const domains::Outline& outline, std::size_t first, std::size_t n, const Marker& marker) {
      for (std::size_t k = first; k < first + n; ++k) {
        const auto at = [&](std::size_t i) { return cdt.insert(place(outline[i % outline.size()])); };
        const auto u = at(k), v = at(k + 1);
        cdt.insert_constraint(u, v);
        markers.set(u, v, marker);
      }
    };
    const domains::Outline bay{{0, 0}, {1, 0}, {2, 0}, {2, 1}, {1, 1}, {0, 1}};
    insert(bay, 2, 1, sea);
    insert(bay, 3, 5, coast);
    insert({{1, 0}, {1, 1}}, 0, 1, wall);
    insert(domains::polygon(0.5, 0.5, 0.2, 7), 0, 7, island);
    insert(domains::square(1.4, 0.4, 0.2), 0, 4, Marker());
    const std::vector<domains::Point> holes{place({0.5, 0.5}), place({1.5, 0.5})};
    for (auto f : cdt.finite_face_handles())
      regions.set(f, CGAL::centroid(cdt.triangle(f)).x() < place({1, 0}).x() ? left : right);
    CGAL::npbs_relax(
      cdt, CGAL::parameters::sizing_function(0.1 / 3 * 1000).seeds(holes).edge_marker_map(markers).face_region_map(
             regions));
  }

  static domains::Point place(const std::pair<double, double>& p)
  {
    return domains::Point(500000.1 + 1000 * p.first / 3, 6e6 + 1000 * p.second / 3);
  }

  CGAL::Mesh_arrays_2 mesh() const
  {
    return {cdt, CGAL::parameters::edge_marker_map(markers).face_region_map(regions)};
  }
};

inline const Bay<>& bay()
{
  static const Bay<> bay(5, 2, 3, 4, 10, 20);
  return bay;
}

inline CGAL::Mesh_arrays_2 tagged_bay()
{
  CGAL::Mesh_arrays_2 mesh = bay().mesh();
  mesh.marker_names = {{5, "open sea"}, {3, "a \"small\" island"}, {77, "not there"}};
  mesh.region_names = {{10, "sand"}};
  for (const auto& p : mesh.points)
    mesh.vertex_data["depth"].push_back((p.x() - 500000) / 7);
  return mesh;
}

} // namespace bays

#endif // BUBBLE_RELAXATION_2_TEST_BAYS_H
