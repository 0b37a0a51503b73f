// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// CGAL::Distributed::npbs_mesh(): the points of npbs_relax(), and the mesh that triangulate() makes of them

#include "paper_domains.h"
#include "same_exception.h"
#include "union_of_ranks.h"

#include <CGAL/Distributed/npbs_mesh.h>
#include <CGAL/Distributed/triangulate.h>
#include <CGAL/npbs_relax.h>

#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Messages.h>
#include <CGAL/Point_set_3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <set>
#include <stdexcept>
#include <vector>

namespace test_distributed_npbs_mesh {

using CGAL::Bubble_relaxation_2::internal::Communicator;
using CGAL::Bubble_relaxation_2::internal::Point_property;
using CGAL::Bubble_relaxation_2::internal::gather_records;
using distributed::expect_same_exception;
using distributed::last_rank;
using distributed::rank;
using distributed::Triangle;
using distributed::triangles_of_all;
using paper::Point;
using Points = CGAL::Point_set_3<paper::K::Point_2, paper::K::Vector_2>;
using Mesh = CGAL::Distributed::Mesh_2<paper::K>;
namespace parameters = CGAL::Bubble_relaxation_parameters;

/// a vertex as its rank has it
struct Vertex
{
  std::int64_t id;
  double x, y, size;
  std::int32_t dimension;

  bool operator==(const Vertex& v) const
  {
    return id == v.id && x == v.x && y == v.y && size == v.size && dimension == v.dimension;
  }
};

std::vector<Vertex> owned_points(const Mesh& mesh)
{
  std::vector<Vertex> result;
  for (std::size_t i = 0; i < mesh.number_of_owned_points(); ++i)
    result.push_back(Vertex{mesh.global_id(i), mesh.point(i).x(), mesh.point(i).y(), mesh.size(i), mesh.dimension(i)});
  return result;
}

std::vector<Vertex> vertices(const Points& points)
{
  const Point_property<Points, std::int64_t> id(points, "global_id");
  const Point_property<Points, double> size(points, "size");
  const Point_property<Points, int> dimension(points, "dimension");
  std::vector<Vertex> result;
  for (const auto& i : points)
    result.push_back(Vertex{id[i], points.point(i).x(), points.point(i).y(), size[i], dimension[i]});
  return result;
}

/// Collective.
template <class Record>
std::vector<Record> of_all(const std::vector<Record>& own)
{
  return gather_records(Communicator(MPI_COMM_WORLD), own);
}

struct Owned_vertex
{
  Vertex vertex;
  std::int32_t owner;
};

/// Collective. What a rank knows of ghosts is what their owners know.
void expect_ghosts_of_owners(const Mesh& mesh)
{
  std::vector<Owned_vertex> own;
  for (const Vertex& v : owned_points(mesh))
    own.push_back(Owned_vertex{v, rank()});
  std::vector<Owned_vertex> all = of_all(own);
  std::sort(all.begin(), all.end(),
            [](const Owned_vertex& v, const Owned_vertex& w) { return v.vertex.id < w.vertex.id; });
  for (std::size_t i = mesh.number_of_owned_points(); i < mesh.number_of_points(); ++i) {
    const Owned_vertex& v = all.at(static_cast<std::size_t>(mesh.global_id(i)));
    EXPECT_TRUE((v.vertex == Vertex{mesh.global_id(i), mesh.point(i).x(), mesh.point(i).y(), mesh.size(i),
                                    mesh.dimension(i)}));
    EXPECT_EQ(v.owner, mesh.owner(i));
  }
}

/// a rank knows all triangles around its points, and who owns what
void expect_ghost_layer(const Mesh& mesh, const std::vector<Triangle>& all)
{
  std::set<std::int64_t> own, ghosts, needed;
  for (std::size_t i = 0; i < mesh.number_of_points(); ++i) {
    EXPECT_EQ(mesh.is_ghost(i), mesh.owner(i) != rank());
    auto& ids = mesh.is_ghost(i) ? ghosts : own;
    EXPECT_TRUE(ids.empty() || *ids.rbegin() < mesh.global_id(i)); // in this order
    ids.insert(mesh.global_id(i));
  }
  std::set<Triangle> known;
  for (std::size_t t = 0; t < mesh.number_of_triangles(); ++t)
    known.insert(distributed::triangle(mesh, t));
  EXPECT_EQ(known.size(), mesh.number_of_triangles());
  std::size_t around = 0;
  for (const Triangle& t : all) {
    const auto is_own = [&own](std::int64_t id) { return own.count(id) != 0; };
    if (!std::any_of(t.vertices.begin(), t.vertices.end(), is_own))
      continue;
    ++around;
    EXPECT_EQ(known.count(t), 1u);
    std::remove_copy_if(t.vertices.begin(), t.vertices.end(), std::inserter(needed, needed.end()), is_own);
  }
  EXPECT_EQ(around, known.size());
  EXPECT_EQ(ghosts, needed);
}

/// the triangles are faces of the triangulation that one rank makes
void expect_faces(const std::vector<Triangle>& triangles, std::vector<Vertex> vertices, const paper::CDT& mesh)
{
  using Corners = std::set<std::array<double, 2>>;
  std::sort(vertices.begin(), vertices.end(), [](const Vertex& v, const Vertex& w) { return v.id < w.id; });
  ASSERT_EQ(vertices.size(), mesh.number_of_vertices());
  std::set<Corners> faces;
  for (const auto f : mesh.finite_face_handles()) {
    Corners corners;
    for (int k = 0; k < 3; ++k)
      corners.insert({f->vertex(k)->point().x(), f->vertex(k)->point().y()});
    faces.insert(corners);
  }
  for (const Triangle& t : triangles) {
    Corners corners;
    for (int k = 0; k < 3; ++k) {
      const Vertex& v = vertices.at(static_cast<std::size_t>(t.vertices[k]));
      corners.insert({v.x, v.y});
    }
    ASSERT_EQ(faces.count(corners), 1u);
  }
}

template <class NamedParameters>
CGAL::Bubble_relaxation_report_2<double> expect_mesh_of_one_rank(const paper::CDT& domain, const NamedParameters& np)
{
  Points points;
  const auto result = CGAL::Distributed::npbs_mesh(points, domain, MPI_COMM_WORLD, np);
  const std::vector<Vertex> own = vertices(points);
  EXPECT_TRUE(own == owned_points(result.mesh));
  const std::vector<Triangle> all = triangles_of_all(result.mesh);
  expect_ghost_layer(result.mesh, all);
  expect_ghosts_of_owners(result.mesh);
  const Mesh anew = CGAL::Distributed::triangulate(points, domain, MPI_COMM_WORLD, np);
  EXPECT_TRUE(all == triangles_of_all(anew));
  EXPECT_EQ(result.mesh.quality().mean_quality(), result.report.quality.mean_quality());
  EXPECT_EQ(result.mesh.quality().number_of_triangles(), all.size());
  EXPECT_EQ(result.mesh.quality().mean_quality(), anew.quality().mean_quality());
  EXPECT_EQ(result.mesh.quality().worst_x(), anew.quality().worst_x());
  const std::vector<Vertex> vertices_of_all = of_all(own);
  if (rank() != 0)
    return result.report;
  paper::CDT mesh = domain;
  const auto report = CGAL::npbs_relax(mesh, np);
  EXPECT_EQ(result.report.number_of_vertices, report.number_of_vertices);
  EXPECT_EQ(result.report.number_of_treated_vertices, report.number_of_treated_vertices);
  EXPECT_EQ(result.report.quality.mean_quality(), report.quality.mean_quality());
  EXPECT_EQ(all.size(), report.number_of_triangles);
  expect_faces(all, vertices_of_all, mesh);
  return result.report;
}

TEST(Npbs_mesh, of_the_papers_domains)
{
  std::size_t treated = 0;
  for (const paper::Domain& d : {paper::square_with_hole(1), paper::comb(1.5), paper::ring(1), paper::l_shape(0.7)}) {
    SCOPED_TRACE(d.name);
    const auto report = expect_mesh_of_one_rank(paper::triangulate(d), parameters::sizing_function(d.d));
    EXPECT_GT(report.number_of_vertices, 100u);
    treated += report.number_of_treated_vertices;
  }
  EXPECT_GT(treated, 0u); // so the mesh is not the one that the simulation left
}

TEST(Npbs_mesh, d_may_jump)
{
  const paper::Domain d = paper::graded_square(1);
  const auto jump = [&d](const Point& p) { return d.d(p) * (std::sin(7 * p.x() + 3 * p.y()) > 0.3 ? 3. : 1.); };
  const auto report = expect_mesh_of_one_rank(paper::triangulate(d), parameters::sizing_function(jump));
  EXPECT_GT(report.number_of_treated_vertices, 0u);
}

TEST(Npbs_mesh, without_treatment)
{
  const paper::Domain d = paper::ring(1);
  expect_mesh_of_one_rank(paper::triangulate(d),
                          parameters::sizing_function(d.d).defect_treatment(false).number_of_rounds(1));
}

TEST(Npbs_mesh, d_of_the_outline)
{
  expect_mesh_of_one_rank(paper::triangulate(paper::comb(1.5)), CGAL::parameters::default_values());
}

TEST(Npbs_mesh, ranks_may_have_nothing)
{
  paper::CDT cdt;
  const std::vector<Point> square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  cdt.insert_constraint(square.begin(), square.end(), true);
  expect_mesh_of_one_rank(cdt, parameters::sizing_function(2.));
}

TEST(Npbs_mesh, replaces_points_that_were_given)
{
  const paper::Domain d = paper::square_with_hole(1.5);
  const paper::CDT cdt = paper::triangulate(d);
  Points points;
  CGAL::Distributed::npbs_mesh(points, cdt, MPI_COMM_WORLD, parameters::sizing_function(d.d));
  const auto fine = [&d](const Point& p) { return 0.5 * d.d(p); };
  const auto result = CGAL::Distributed::npbs_mesh(points, cdt, MPI_COMM_WORLD, parameters::sizing_function(fine));
  EXPECT_TRUE(vertices(points) == owned_points(result.mesh));
  EXPECT_EQ(of_all(vertices(points)).size(), result.report.number_of_vertices);
}

TEST(Npbs_mesh, is_empty_after_cancellation)
{
  const paper::Domain d = paper::square_with_hole(1);
  Points points;
  const Point given(0.6 + 0.01 * rank(), 0.9);
  points.insert(given);
  const bool stops = rank() == last_rank();
  const auto result = CGAL::Distributed::npbs_mesh(
    points, paper::triangulate(d), MPI_COMM_WORLD,
    parameters::sizing_function(d.d).callback([stops](double) { return !stops; }));
  EXPECT_EQ(result.report.stop_reason, CGAL::Bubble_stop_reason::STOPPED_BY_CALLBACK);
  EXPECT_EQ(result.mesh.number_of_points(), 0u);
  EXPECT_EQ(result.mesh.number_of_triangles(), 0u);
  EXPECT_EQ(result.mesh.rank(), rank());
  EXPECT_EQ(result.mesh.number_of_ranks(), distributed::size());
  ASSERT_EQ(points.size(), 1u);
  EXPECT_EQ(points.point(*points.begin()), given);
  EXPECT_FALSE(points.has_property_map<std::int64_t>("global_id"));
}

TEST(Npbs_mesh, all_throw_what_d_throws_on_one_rank)
{
  const paper::Domain d = paper::square_with_hole(1);
  const paper::CDT cdt = paper::triangulate(d);
  Points points;
  const Point given(0.6 + 0.01 * rank(), 0.9);
  points.insert(given);
  const bool throws = rank() == last_rank();
  int calls = 0;
  const auto size = [&](const Point& p) {
    if (throws && ++calls > 300) // when there are bubbles
      throw std::domain_error("no size here");
    return d.d(p);
  };
  expect_same_exception<std::domain_error>("no size here", [&] {
    CGAL::Distributed::npbs_mesh(points, cdt, MPI_COMM_WORLD, parameters::sizing_function(size));
  });
  ASSERT_EQ(points.size(), 1u);
  EXPECT_EQ(points.point(*points.begin()), given);
  EXPECT_FALSE(points.has_property_map<std::int64_t>("global_id"));
}

} // namespace test_distributed_npbs_mesh
