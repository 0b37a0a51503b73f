// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// Markers of constraints and regions of faces on ranks: those of npbs_relax() on one, and in the files for ParaView.

#include "same_exception.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constraint_marker_map_2.h>
#include <CGAL/Distributed/npbs_mesh.h>
#include <CGAL/Distributed/triangulate.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Face_region_map_2.h>
#include <CGAL/Region_sizing_field_2.h>
#include <CGAL/npbs_relax.h>

#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Messages.h>
#include <CGAL/Point_set_3.h>

#include <boost/property_map/function_property_map.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace test_distributed_tags {

using CGAL::Bubble_relaxation_2::internal::Communicator;
using CGAL::Bubble_relaxation_2::internal::gather_records;
using distributed::expect_same_exception;
using distributed::last_rank;
using distributed::rank;
using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = K::Point_2;
using Cdt = CGAL::Constrained_Delaunay_triangulation_2<K>;
using Vertex = Cdt::Vertex_handle;
using Points = CGAL::Point_set_3<K::Point_2, K::Vector_2>;
namespace parameters = CGAL::Bubble_relaxation_parameters;

/// A slanted plate of two materials with a crack, a corner of 20 degrees, and a marker that changes on a straight line.
struct Plate
{
  Cdt cdt;
  CGAL::Constraint_marker_map_2<Cdt> markers;
  CGAL::Face_region_map_2<Cdt, double> regions;

  Plate()
  {
    const Vertex a = at(0, 0.1), change = at(0.5, 0.3), b = at(1, 0.5), c = at(0.97, 1.03), d = at(0.4, 1),
                 e = at(0.05, 0.9), tip = at(2, 0.86), inside = at(0.3, 0.5), crack = at(0.2, 0.7);
    insert(a, change, 1);
    insert(change, b, 2);
    insert(b, tip, 3);
    insert(tip, c, 4);
    insert(c, d, 5);
    insert(d, e, 6);
    insert(e, a, 7);
    insert(b, d, 8); // between the materials
    insert(inside, crack, 9);
    regions.set_all_around(cdt.locate(Point(0.1, 0.5)), 0.5);
    regions.set_all_around(cdt.locate(Point(0.9, 0.8)), -7);
  }

  Vertex at(double x, double y) { return cdt.insert(Point(x, y)); }

  void insert(Vertex u, Vertex v, int marker)
  {
    cdt.insert_constraint(u, v);
    markers.set(u, v, marker);
  }

  /// by region, before anything is meshed
  auto sizes() const
  {
    return CGAL::Region_sizing_field_2<Cdt>(cdt, regions, [](double region) { return region < 0 ? 0.06 : 0.04; });
  }

  template <class Sizes>
  auto parameters_with(const Sizes& sizes) const
  {
    return parameters::sizing_function(sizes).edge_marker_map(markers).face_region_map(regions);
  }
};

/// a triangle by its corners, the smallest first, the markers of the sides opposite to them or 0, and its region
using Triangle = std::array<double, 10>;

template <class Point_of, class Marker_of>
Triangle triangle(const Point_of& point, const Marker_of& marker, double region)
{
  int first = 0;
  for (int k : {1, 2})
    if (point(k) < point(first))
      first = k;
  Triangle result{};
  for (int k = 0; k < 3; ++k) {
    const int i = (first + k) % 3;
    result[static_cast<std::size_t>(2 * k)] = point(i).x();
    result[static_cast<std::size_t>(2 * k + 1)] = point(i).y();
    result[static_cast<std::size_t>(6 + k)] = marker(i);
  }
  result[9] = region;
  return result;
}

std::vector<Triangle> triangles(const Plate& plate)
{
  std::vector<Triangle> result;
  for (auto f : plate.cdt.finite_face_handles())
    if (plate.regions(f) != 0)
      result.push_back(triangle([&](int i) { return f->vertex(i)->point(); },
                                [&](int i) {
                                  const Vertex u = f->vertex(Cdt::ccw(i)), v = f->vertex(Cdt::cw(i));
                                  return f->is_constrained(i) ? plate.markers(u, v) : 0;
                                },
                                plate.regions(f)));
  std::sort(result.begin(), result.end());
  return result;
}

/// Collective. Those that ranks own, on all ranks.
template <class Mesh>
std::vector<Triangle> triangles_of_all(const Mesh& mesh)
{
  std::vector<Triangle> own;
  for (std::size_t t = 0; t < mesh.number_of_owned_triangles(); ++t) {
    const auto& v = mesh.vertices(t);
    own.push_back(
      triangle([&](int i) { return mesh.point(static_cast<std::size_t>(v[static_cast<std::size_t>(i)])); },
               [&](int i) { return mesh.is_constrained(t, i) ? mesh.marker(t, i) : 0; }, mesh.region(t)));
  }
  std::vector<Triangle> all = gather_records(Communicator(MPI_COMM_WORLD), own);
  std::sort(all.begin(), all.end());
  return all;
}

TEST(Distributed_tags, are_those_of_one_rank)
{
  Plate plate;
  const auto np = plate.parameters_with(plate.sizes());
  Points points;
  const auto result = CGAL::Distributed::npbs_mesh(points, plate.cdt, MPI_COMM_WORLD, np);
  const auto all = triangles_of_all(result.mesh);
  const auto again = triangles_of_all(CGAL::Distributed::triangulate(points, plate.cdt, MPI_COMM_WORLD, np));
  CGAL::npbs_relax(plate.cdt, np);
  const auto expected = triangles(plate);
  EXPECT_GT(expected.size(), 800u);
  EXPECT_TRUE(all == expected);
  EXPECT_TRUE(again == expected);
}

TEST(Distributed_tags, constraints_of_a_marker_stay)
{
  Plate plate;
  const auto is_protected = boost::make_function_property_map<std::pair<Vertex, Vertex>, bool>(
    [&](const auto& edge) { return plate.markers(edge.first, edge.second) == 9; });
  const auto sizes = plate.sizes();
  const auto np = plate.parameters_with(sizes).protect_constraints(is_protected);
  Points points;
  const auto all = triangles_of_all(CGAL::Distributed::npbs_mesh(points, plate.cdt, MPI_COMM_WORLD, np).mesh);
  CGAL::npbs_relax(plate.cdt, np);
  EXPECT_GT(all.size(), 500u);
  EXPECT_TRUE(all == triangles(plate));
  std::size_t on_protected = 0;
  for (const Triangle& t : all)
    for (std::size_t i = 6; i < 9; ++i)
      on_protected += t[i] == 9;
  EXPECT_EQ(on_protected, 2u); // the triangles beside it
}

TEST(Distributed_tags, are_known_of_all_triangles_of_a_rank)
{
  const Plate plate;
  Points points;
  const auto mesh =
    CGAL::Distributed::npbs_mesh(points, plate.cdt, MPI_COMM_WORLD, plate.parameters_with(plate.sizes())).mesh;
  EXPECT_TRUE(mesh.has_markers());
  EXPECT_TRUE(mesh.has_regions());
  for (std::size_t t = 0; t < mesh.number_of_triangles(); ++t) {
    EXPECT_TRUE(mesh.region(t) == 0.5 || mesh.region(t) == -7);
    for (int i = 0; i < 3; ++i) {
      EXPECT_EQ(mesh.edge(t, i) != -1, mesh.is_constrained(t, i));
      EXPECT_TRUE(!mesh.is_constrained(t, i) || (mesh.marker(t, i) >= 1 && mesh.marker(t, i) <= 9));
    }
  }
}

TEST(Distributed_tags, without_any)
{
  const Plate plate;
  Points points;
  const auto mesh =
    CGAL::Distributed::npbs_mesh(points, plate.cdt, MPI_COMM_WORLD, parameters::sizing_function(0.1)).mesh;
  EXPECT_FALSE(mesh.has_markers());
  EXPECT_FALSE(mesh.has_regions());
}

TEST(Distributed_tags, in_files)
{
  const Plate plate;
  Points points;
  const auto mesh =
    CGAL::Distributed::npbs_mesh(points, plate.cdt, MPI_COMM_WORLD, plate.parameters_with(plate.sizes())).mesh;
  const std::string stem = ::testing::TempDir() + "distributed_tags_" + std::to_string(last_rank() + 1);
  const auto x = [&](std::size_t i) { return 10 * mesh.point(i).x(); };
  const auto twice = [&](std::size_t t) { return 2. * static_cast<double>(t); };
  mesh.write_pvtu(stem + ".pvtu", {{"ten<x", x}}, {{"twice", twice}});
  MPI_Barrier(MPI_COMM_WORLD);
  if (rank() == 0 && std::system("python3 -c 'import xml' 2> /dev/null") == 0) {
    // lengths by marker and areas by region, of all files together
    std::ofstream(stem + ".py") << R"(
import base64, collections, math, os, sys, xml.etree.ElementTree as tree
path = sys.argv[1]
kinds = {"Float64": "d", "Int64": "q", "Int32": "i", "UInt8": "B"}
def values(array):
    return memoryview(base64.b64decode(array.text)[8:]).cast(kinds[array.get("type")]).tolist()
def shoelace(*p):
    return sum(a[0] * b[1] - a[1] * b[0] for a, b in zip(p, p[1:] + p[:1])) / 2
names = [a.get("Name") for a in tree.parse(path).iter("PDataArray")]
assert names == ["marker", "global_id", "rank", "size", "ten<x",
                 "q", "dimension", "marker", "rank", "region", "twice", "Points"], names
length, area = collections.Counter(), collections.Counter()
for piece in tree.parse(path).iter("Piece"):
    part = tree.parse(os.path.join(os.path.dirname(path), piece.get("Source"))).find(".//Piece")
    arrays = {a.get("Name"): values(a) for a in part.iter("DataArray")}
    assert {*arrays} == {*names, "connectivity", "offsets", "types"}
    n = int(part.get("NumberOfCells"))
    for name in ("q", "dimension", "marker", "region", "twice", "offsets", "types"):
        assert len(arrays[name]) == n, name
    p = arrays["Points"]
    assert [10 * x for x in p[::3]] == arrays["ten<x"]
    begin = 0
    for c in range(n):
        end = arrays["offsets"][c]
        v = [(p[3 * i], p[3 * i + 1]) for i in arrays["connectivity"][begin:end]]
        begin = end
        assert len(v) == arrays["dimension"][c] + 1 and arrays["types"][c] == (3 if len(v) == 2 else 5)
        if len(v) == 2:
            length[arrays["marker"][c]] += math.dist(*v)
            assert math.isnan(arrays["region"][c]) and math.isnan(arrays["twice"][c])
        else:
            area[arrays["region"][c]] += shoelace(*v)
            assert arrays["marker"][c] == 0 and arrays["twice"][c] == 2 * c
ends = {1: ((0, .1), (.5, .3)), 2: ((.5, .3), (1, .5)), 3: ((1, .5), (2, .86)), 4: ((2, .86), (.97, 1.03)),
        5: ((.97, 1.03), (.4, 1)), 6: ((.4, 1), (.05, .9)), 7: ((.05, .9), (0, .1)), 8: ((1, .5), (.4, 1)),
        9: ((.3, .5), (.2, .7))}
assert sorted(length) == sorted(ends), length
for k in ends:
    assert abs(length[k] - math.dist(*ends[k])) < 1e-9, (k, length[k])
assert sorted(area) == [-7, .5], area
assert abs(area[-7] - shoelace((1, .5), (2, .86), (.97, 1.03), (.4, 1))) < 1e-9
assert abs(area[.5] - shoelace((0, .1), (1, .5), (.4, 1), (.05, .9))) < 1e-9
)";
    EXPECT_EQ(std::system(("python3 " + stem + ".py " + stem + ".pvtu").c_str()), 0);
  }
  if (last_rank() > 0)
    expect_same_exception<std::invalid_argument>("not the same names on all ranks", [&] {
      mesh.write_pvtu(stem + ".pvtu", {{rank() == 0 ? "u" : "v", x}});
    });
}

/// of files that are not there
std::string stem_of(const char* name)
{
  const std::string stem = ::testing::TempDir() + "distributed_tags_" + name + std::to_string(last_rank() + 1);
  std::filesystem::remove(stem + ".pvtu");
  std::filesystem::remove(stem + "_" + std::to_string(rank()) + ".vtu");
  MPI_Barrier(MPI_COMM_WORLD);
  return stem;
}

/// neither the file nor this rank's part
void expect_no_files(const std::string& stem)
{
  MPI_Barrier(MPI_COMM_WORLD);
  EXPECT_FALSE(std::filesystem::is_regular_file(stem + ".pvtu"));
  EXPECT_FALSE(std::filesystem::is_regular_file(stem + "_" + std::to_string(rank()) + ".vtu"));
  MPI_Barrier(MPI_COMM_WORLD);
}

TEST(Distributed_tags, that_files_cannot_have)
{
  const Plate plate;
  const std::string stem = stem_of("bad");
  const auto expect_refused = [&](const std::string& message, const auto& np) {
    Points points;
    const auto mesh = CGAL::Distributed::npbs_mesh(points, plate.cdt, MPI_COMM_WORLD, np).mesh;
    expect_same_exception<std::invalid_argument>(message, [&] { mesh.write_pvtu(stem + ".pvtu"); });
    expect_no_files(stem);
  };
  const auto np = parameters::sizing_function(0.1);
  for (double bad : {1.5, 5e9}) {
    CGAL::Constraint_marker_map_2<Cdt, double> markers;
    for (const auto& e : plate.cdt.constrained_edges())
      markers.set(e.first->vertex(Cdt::ccw(e.second)), e.first->vertex(Cdt::cw(e.second)), 3);
    const auto a = plate.cdt.locate(Point(0, 0.1)); // any constraint will do
    for (int i = 0; i < 3; ++i)
      if (a->is_constrained(i))
        markers.set(a->vertex(Cdt::ccw(i)), a->vertex(Cdt::cw(i)), bad);
    expect_refused("edge_marker_map: the marker " + std::string(bad < 2 ? "1.5" : "5e+09"),
                   np.edge_marker_map(markers));
  }
  CGAL::Face_region_map_2<Cdt, std::int64_t> regions;
  for (const auto f : plate.cdt.finite_face_handles())
    regions.set(f, (std::int64_t(1) << 53) + 1);
  expect_refused("face_region_map: 9007199254740992 must be less than 2^53", np.face_region_map(regions));
}

TEST(Distributed_tags, data_have_names_of_their_own)
{
  const Plate plate;
  Points points;
  const auto mesh =
    CGAL::Distributed::npbs_mesh(points, plate.cdt, MPI_COMM_WORLD, plate.parameters_with(plate.sizes())).mesh;
  const std::string stem = stem_of("names");
  const auto zero = [](std::size_t) { return 0.; };
  using Data = std::vector<CGAL::Distributed::Mesh_data>;
  const auto expect_refused = [&](const std::string& name, const Data& of_points, const Data& of_triangles) {
    const bool is_here = rank() == last_rank();
    expect_same_exception<std::invalid_argument>("the data '" + name + "' of write_pvtu()", [&] {
      mesh.write_pvtu(stem + ".pvtu", is_here ? of_points : Data(), is_here ? of_triangles : Data());
    });
    expect_no_files(stem);
  };
  for (const char* name : {"global_id", "size", "rank", "marker"})
    expect_refused(name, {{name, zero}}, {});
  for (const char* name : {"rank", "region", "marker", "q", "dimension"})
    expect_refused(name, {}, {{name, zero}});
  expect_refused("u", {{"u", zero}, {"u", zero}}, {});
}

TEST(Distributed_tags, files_are_written_by_all_ranks_or_by_none)
{
  const Plate plate;
  Points points;
  const auto mesh =
    CGAL::Distributed::npbs_mesh(points, plate.cdt, MPI_COMM_WORLD, parameters::sizing_function(0.1)).mesh;
  const std::string stem = stem_of("none"), last = stem + "_" + std::to_string(last_rank()) + ".vtu";
  for (const std::string& in_the_way : {last, stem + ".pvtu"}) {
    for (bool is_there : {false, true}) { // files of old
      if (is_there)
        mesh.write_pvtu(stem + ".pvtu");
      MPI_Barrier(MPI_COMM_WORLD);
      if (rank() == 0) {
        std::filesystem::remove(in_the_way);
        std::filesystem::create_directory(in_the_way);
      }
      MPI_Barrier(MPI_COMM_WORLD);
      expect_same_exception<std::runtime_error>("cannot be written", [&] { mesh.write_pvtu(stem + ".pvtu"); });
      MPI_Barrier(MPI_COMM_WORLD);
      if (rank() == 0)
        std::filesystem::remove(in_the_way);
      if (last_rank() > 0 || in_the_way != last)
        expect_no_files(stem);
    }
    MPI_Barrier(MPI_COMM_WORLD);
    if (rank() == 0)
      std::filesystem::remove(stem + ".pvtu");
  }
}

TEST(Distributed_tags, a_map_that_throws_on_one_rank)
{
  const Plate plate;
  Points points;
  const auto failing = boost::make_function_property_map<Cdt::Face_handle, int>([](Cdt::Face_handle) {
    if (rank() == last_rank())
      throw std::invalid_argument("no region");
    return 1;
  });
  expect_same_exception<std::invalid_argument>("no region", [&] {
    CGAL::Distributed::npbs_mesh(points, plate.cdt, MPI_COMM_WORLD,
                                 parameters::sizing_function(0.1).face_region_map(failing));
  });
  EXPECT_EQ(points.size(), 0u);
}

} // namespace test_distributed_tags
