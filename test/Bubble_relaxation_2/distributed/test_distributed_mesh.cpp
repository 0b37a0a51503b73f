// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// CGAL::Distributed::triangulate(): points come from any rank, all ranks get their part, or all throw the same

#include "../random_seeds.h"
#include "bubbles.h"
#include "same_exception.h"
#include "union_of_ranks.h"

#include <CGAL/Distributed/triangulate.h>

#include <CGAL/Bubble_relaxation_2/internal/distributed/input/point_set_bubbles.h>
#include <CGAL/Bubble_relaxation_2/internal/quality/evaluate.h>
#include <CGAL/Point_set_3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

namespace test_distributed_mesh {

using namespace bubbles;
using distributed::expect_same_exception;
using distributed::last_rank;
using distributed::rank;
using distributed::size;
using Points = CGAL::Point_set_3<paper::K::Point_2, paper::K::Vector_2>;
using Mesh = CGAL::Distributed::Mesh_2<paper::K>;
namespace parameters = CGAL::parameters;

enum class Spread { ROUND_ROBIN, ALL_ON_LAST, RANDOM };

/// whether this rank has the point `i`
bool is_here(std::size_t i, Spread spread)
{
  const unsigned p = static_cast<unsigned>(size()), r = static_cast<unsigned>(rank());
  switch (spread) {
  case Spread::ROUND_ROBIN:
    return i % p == r;
  case Spread::ALL_ON_LAST:
    return r + 1 == p;
  default:
    std::mt19937 engine(random_seeds::seed(static_cast<unsigned>(i)));
    return engine() % p == r;
  }
}

Points bare_points(const Case& c, Spread spread)
{
  Points points;
  for (std::size_t i = 0; i < c.bubbles.size(); ++i)
    if (is_here(i, spread))
      points.insert(c.bubbles.point(i));
  return points;
}

Points with_properties(const Case& c, const std::vector<std::int64_t>& numbers, Spread spread)
{
  Bubbles_2 own;
  for (std::size_t i = 0; i < c.bubbles.size(); ++i)
    if (is_here(i, spread))
      add_own(own, record(c.bubbles, i, numbers[i]));
  Points points;
  write_bubbles(own, points);
  return points;
}

/// the numbers that points get along the curve
std::vector<std::int64_t> numbers_along_curve(const Case& c)
{
  std::vector<Point> points;
  for (std::size_t i = 0; i < c.bubbles.size(); ++i)
    points.push_back(c.bubbles.point(i));
  const std::vector<Index> order = hilbert_order(hilbert_curve(c.domain()), points);
  std::vector<std::int64_t> numbers(points.size());
  for (std::size_t k = 0; k < order.size(); ++k)
    numbers[order[k]] = static_cast<std::int64_t>(k);
  return numbers;
}

void expect_whole(const Mesh& mesh, const Case& c, const std::vector<std::int64_t>& numbers)
{
  const Marked_triangles_2 whole = mesh_of(c).triangles;
  EXPECT_TRUE(distributed::triangles_of_all(mesh) == distributed::triangles(whole, numbers, whole.inside));
  EXPECT_EQ(mesh.rank(), rank());
  EXPECT_EQ(mesh.number_of_ranks(), size());
  const std::map<std::int64_t, std::size_t> index = [&] {
    std::map<std::int64_t, std::size_t> result;
    for (std::size_t i = 0; i < numbers.size(); ++i)
      result[numbers[i]] = i;
    return result;
  }();
  for (std::size_t i = 0; i < mesh.number_of_points(); ++i) {
    ASSERT_EQ(index.count(mesh.global_id(i)), 1u);
    EXPECT_EQ(mesh.point(i), c.bubbles.point(index.at(mesh.global_id(i))));
    EXPECT_EQ(mesh.is_ghost(i), mesh.owner(i) != mesh.rank());
    EXPECT_EQ(mesh.dimension(i), int(c.bubbles.dimension[index.at(mesh.global_id(i))]));
  }
  Communicator comm(MPI_COMM_WORLD);
  const std::int64_t n = static_cast<std::int64_t>(numbers.size());
  EXPECT_EQ(comm.sum(static_cast<std::int64_t>(mesh.number_of_owned_points())), n);
  EXPECT_LE(static_cast<std::int64_t>(mesh.number_of_owned_points()), n / size() + 1);
  for (std::size_t t = 0; t < mesh.number_of_triangles(); ++t) {
    const auto ids = mesh.triangle(t);
    const std::size_t first = static_cast<std::size_t>(std::min_element(ids.begin(), ids.end()) - ids.begin());
    EXPECT_EQ(mesh.is_owned_triangle(t), !mesh.is_ghost(static_cast<std::size_t>(mesh.vertices(t)[first])));
  }
}

TEST(Distributed_mesh, of_bare_points)
{
  for (const paper::Domain& domain : {paper::square_with_hole(1), paper::comb(1.5), paper::ring(2)}) {
    SCOPED_TRACE(domain.name);
    const Case c = relaxed(domain);
    for (Spread spread : {Spread::ROUND_ROBIN, Spread::ALL_ON_LAST, Spread::RANDOM})
      expect_whole(CGAL::Distributed::triangulate(bare_points(c, spread), c.cdt, MPI_COMM_WORLD), c,
                   numbers_along_curve(c));
  }
}

TEST(Distributed_mesh, of_points_with_properties)
{
  const paper::Domain domain = paper::l_shape(1);
  const Case c = relaxed(domain);
  std::vector<std::int64_t> numbers(c.bubbles.size());
  std::iota(numbers.begin(), numbers.end(), 0);
  std::shuffle(numbers.begin(), numbers.end(), std::mt19937(random_seeds::seed(1)));
  for (std::int64_t& number : numbers)
    number = number * 1000000007 + 5;
  const Mesh mesh = CGAL::Distributed::triangulate(with_properties(c, numbers, Spread::RANDOM), c.cdt,
                                                   MPI_COMM_WORLD, parameters::sizing_function(domain.d));
  expect_whole(mesh, c, numbers);
  Report report;
  const Relaxation_options options;
  evaluate(mesh_of(c), Problem_2{c.domain(), c.given(), options, sizes_of(domain.d), sizes_of(domain.d)}, report);
  EXPECT_EQ(mesh.quality().mean_quality(), report.quality.mean_quality());
  EXPECT_EQ(mesh.quality().length_ratio_deviation(), report.quality.length_ratio_deviation());
  EXPECT_EQ(mesh.quality().number_of_triangles(), report.quality.number_of_triangles());
}

TEST(Distributed_mesh, corners_of_the_domain_need_not_be_among_the_points)
{
  Case c = read(paper::trunk(1));
  const Mesh mesh = CGAL::Distributed::triangulate(Points(), c.cdt, MPI_COMM_WORLD);
  add_outline(c, 0, 1);
  expect_whole(mesh, c, numbers_along_curve(c));

  Points points;
  auto id = points.add_property_map<std::int64_t>("global_id", 0).first;
  if (rank() == 0)
    id[*points.insert(Point(0.01, 0.3))] = 41;
  add_inside(c, Point(0.01, 0.3), 1);
  std::vector<std::int64_t> numbers(c.bubbles.size(), 41);
  std::iota(numbers.begin(), numbers.end() - 1, 42);
  expect_whole(CGAL::Distributed::triangulate(points, c.cdt, MPI_COMM_WORLD), c, numbers);
}

TEST(Distributed_mesh, point_sets_keep_bubbles)
{
  const Case c = relaxed(paper::graded_square(1));
  Bubbles_2 before;
  for (std::size_t i = 0; i < c.bubbles.size(); ++i) {
    add_own(before, record(c.bubbles, i, 3 * static_cast<std::int64_t>(i)));
    before.vx[i] = 0.1 * double(i);
  }
  Points points;
  write_bubbles(before, points);
  const auto no_size = [](const Point&) -> double { throw std::logic_error("there is a property"); };
  const Bubbles_2 after = read_bubbles(points, c.domain(), no_size);
  EXPECT_EQ(after.id, before.id);
  EXPECT_EQ(after.x, before.x);
  EXPECT_EQ(after.y, before.y);
  EXPECT_EQ(after.d, before.d);
  EXPECT_EQ(after.vx, before.vx);
  EXPECT_EQ(after.dimension, before.dimension);
  for (std::size_t i = 0; i < c.bubbles.size(); ++i) {
    if (!c.bubbles.is_in_face(i)) {
      EXPECT_EQ(after.host[i], before.host[i]);
    }
    if (c.bubbles.is_on_edge(i)) {
      EXPECT_EQ(after.s[i], before.s[i]);
    }
  }
}

TEST(Distributed_mesh, bubbles_are_found_where_they_are_without_properties)
{
  for (const paper::Domain& domain : paper::all_domains(1)) {
    SCOPED_TRACE(domain.name);
    const Case c = relaxed(domain);
    const Bubbles_2 found =
      read_bubbles(bare_points(c, Spread::ROUND_ROBIN), c.domain(), [](const Point&) { return 0.5; });
    std::size_t k = 0;
    for (std::size_t i = 0; i < c.bubbles.size(); ++i) {
      if (!is_here(i, Spread::ROUND_ROBIN))
        continue;
      EXPECT_EQ(int(found.dimension[k]), int(c.bubbles.dimension[i]));
      if (!c.bubbles.is_in_face(i)) {
        EXPECT_EQ(found.host[k], c.bubbles.host[i]);
      }
      if (c.bubbles.is_on_edge(i)) {
        EXPECT_NEAR(found.s[k], c.bubbles.s[i], 1e-12);
      }
      ++k;
    }
  }
}

TEST(Distributed_mesh, is_written_for_paraview)
{
  const Case c = relaxed(paper::square_with_hole(1));
  const Mesh mesh =
    CGAL::Distributed::triangulate(bare_points(c, Spread::RANDOM), c.cdt, MPI_COMM_WORLD);
  const std::string stem = ::testing::TempDir() + "distributed_mesh_" + std::to_string(size());
  mesh.write_pvtu(stem + ".pvtu");
  MPI_Barrier(MPI_COMM_WORLD);
  if (rank() == 0 && std::system("python3 -c 'import xml' 2> /dev/null") == 0) {
    const std::string script = R"(
import base64, os, sys, xml.etree.ElementTree as tree
path, triangles = sys.argv[1], int(sys.argv[2])
kinds = {"Float64": "d", "Int64": "q", "Int32": "i", "UInt8": "B"}
def values(array):
    return memoryview(base64.b64decode(array.text)[8:]).cast(kinds[array.get("type")]).tolist()
cells = 0
for piece in tree.parse(path).iter("Piece"):
    part = tree.parse(os.path.join(os.path.dirname(path), piece.get("Source"))).find(".//Piece")
    arrays = {a.get("Name"): values(a) for a in part.find("CellData")}
    arrays.update({a.get("Name"): values(a) for a in part.find("Cells")})
    n, points = int(part.get("NumberOfCells")), int(part.get("NumberOfPoints"))
    lines = arrays["types"].count(3)
    assert len(arrays["q"]) == len(arrays["types"]) == n and len(arrays["connectivity"]) == 3 * n - lines
    assert all(0 < q <= 1 for q in arrays["q"][:n - lines])
    assert all(0 <= v < points for v in arrays["connectivity"])
    assert len(values(part.find("Points/DataArray"))) == 3 * points
    assert len(values(part.find("PointData/DataArray"))) == points
    cells += n - lines
assert cells == triangles, cells
)";
    std::ofstream(stem + ".py") << script;
    const std::string command = "python3 " + stem + ".py " + stem + ".pvtu " +
                                std::to_string(mesh.quality().number_of_triangles());
    EXPECT_EQ(std::system(command.c_str()), 0) << command;
  }
  expect_same_exception<std::runtime_error>("cannot be written",
                                            [&] { mesh.write_pvtu("/no/such/directory/mesh.pvtu"); });
  expect_same_exception<std::invalid_argument>(".pvtu", [&] { mesh.write_pvtu("mesh.vtu"); });
}

TEST(Distributed_mesh_bad_input, points_out_of_the_domain_on_one_rank)
{
  const Case c = random(paper::square_with_hole(1), 100, 1);
  for (const Point& bad : {Point(0.01, 0.02), Point(7, 0), Point(1, 1.0000001)}) {
    Points points = bare_points(c, Spread::ROUND_ROBIN);
    if (rank() == last_rank())
      points.insert(bad);
    expect_same_exception<std::invalid_argument>(
      "is not in the domain", [&] { CGAL::Distributed::triangulate(points, c.cdt, MPI_COMM_WORLD); });
  }
}

TEST(Distributed_mesh_bad_input, points_that_are_not_finite)
{
  const Case c = random(paper::square_with_hole(1), 100, 1);
  for (double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    Points points = bare_points(c, Spread::ROUND_ROBIN);
    if (rank() == 0)
      points.insert(Point(0.7, bad));
    expect_same_exception<std::invalid_argument>(
      "must be finite", [&] { CGAL::Distributed::triangulate(points, c.cdt, MPI_COMM_WORLD); });
  }
}

TEST(Distributed_mesh_bad_input, a_point_twice)
{
  const Case c = random(paper::square_with_hole(1), 100, 1);
  Points points = bare_points(c, Spread::ROUND_ROBIN);
  if (rank() == last_rank())
    points.insert(c.bubbles.point(50)); // which another rank has, or this one
  expect_same_exception<std::invalid_argument>(
    "two points have the coordinates", [&] { CGAL::Distributed::triangulate(points, c.cdt, MPI_COMM_WORLD); });
}

TEST(Distributed_mesh_bad_input, ids)
{
  const Case c = random(paper::square_with_hole(1), 100, 1);
  std::vector<std::int64_t> numbers(c.bubbles.size());
  std::iota(numbers.begin(), numbers.end(), 0);
  numbers[17] = 60;
  const auto run = [&](const Points& points) {
    CGAL::Distributed::triangulate(points, c.cdt, MPI_COMM_WORLD);
  };
  expect_same_exception<std::invalid_argument>("two points have the global_id 60", [&] {
    run(with_properties(c, numbers, Spread::ROUND_ROBIN));
  });
  numbers[17] = -4;
  expect_same_exception<std::invalid_argument>("property global_id = -4", [&] {
    run(with_properties(c, numbers, Spread::ROUND_ROBIN));
  });
  numbers[17] = 17;
  if (size() > 1)
    expect_same_exception<std::invalid_argument>("points of others have not", [&] {
      run(rank() == 0 ? bare_points(c, Spread::ROUND_ROBIN) : with_properties(c, numbers, Spread::ROUND_ROBIN));
    });
}

TEST(Distributed_mesh_bad_input, properties_out_of_range)
{
  const Case c = relaxed(paper::graded_square(1));
  std::vector<std::int64_t> numbers(c.bubbles.size());
  std::iota(numbers.begin(), numbers.end(), 0);
  const auto expect = [&](const std::string& text, const auto& change) {
    Points points = with_properties(c, numbers, Spread::ROUND_ROBIN);
    const auto dimension = points.property_map<int>("dimension").first;
    const auto on_edge =
      std::find_if(points.begin(), points.end(), [&](const auto& i) { return dimension[i] == 1; });
    if (rank() == last_rank())
      change(points, *on_edge);
    expect_same_exception<std::invalid_argument>(
      text, [&] { CGAL::Distributed::triangulate(points, c.cdt, MPI_COMM_WORLD); });
  };
  expect("property size = 0", [](Points& p, auto i) { p.property_map<double>("size").first[i] = 0; });
  expect("property dimension = 3", [](Points& p, auto i) { p.property_map<int>("dimension").first[i] = 3; });
  expect("property edge = 9999", [](Points& p, auto i) { p.property_map<int>("edge").first[i] = 9999; });
  expect("property position = 1.5", [](Points& p, auto i) { p.property_map<double>("position").first[i] = 1.5; });
  expect("is another point of the edge",
         [](Points& p, auto i) { p.property_map<double>("position").first[i] *= 0.9; });
}

TEST(Distributed_mesh_bad_input, domains)
{
  const Case c = random(paper::square_with_hole(1), 100, 1);
  const paper::CDT other = paper::triangulate(paper::square_with_hole(2));
  const Points points = bare_points(c, Spread::ROUND_ROBIN);
  if (size() > 1)
    expect_same_exception<std::invalid_argument>("not the same on all ranks", [&] {
      CGAL::Distributed::triangulate(points, rank() == last_rank() ? other : c.cdt, MPI_COMM_WORLD);
    });
  expect_same_exception<std::invalid_argument>("bounds no domain", [&] {
    CGAL::Distributed::triangulate(points, rank() == last_rank() ? paper::CDT() : c.cdt, MPI_COMM_WORLD);
  });
}

TEST(Distributed_mesh_bad_input, sizing_functions)
{
  const Case c = random(paper::square_with_hole(1), 100, 1);
  const Points points = bare_points(c, Spread::ROUND_ROBIN);
  const auto throws = [](const Point&) -> double {
    if (rank() == last_rank())
      throw std::domain_error("no size on this rank");
    return 0.1;
  };
  expect_same_exception<std::domain_error>("no size on this rank", [&] {
    CGAL::Distributed::triangulate(points, c.cdt, MPI_COMM_WORLD, parameters::sizing_function(throws));
  });
  const auto negative = [](const Point& p) { return p.x() > 0.9 ? -1. : 1.; };
  expect_same_exception<std::invalid_argument>("must be positive and finite", [&] {
    CGAL::Distributed::triangulate(points, c.cdt, MPI_COMM_WORLD, parameters::sizing_function(negative));
  });
}

TEST(Distributed_mesh_bad_input, communicators)
{
  const Case c = random(paper::square_with_hole(1), 10, 1);
  EXPECT_THROW(CGAL::Distributed::triangulate(Points(), c.cdt, MPI_COMM_NULL), std::invalid_argument);
}

} // namespace test_distributed_mesh
