// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// Figures 14 to 16 of the paper: the ring of eq. 8, d = r/6, by several ranks. Prints statistics, and whether the
// nodes are those that one rank makes.
//
//   mpirun -n 4 distributed_ring
//
// Pictures: distributed_ring_parts.svg, _initial.svg and _result.svg. Colours tell the rank.

#include "mpi_session.h"
#include "paper_domains.h"
#include "svg_picture.h"

#include <CGAL/Distributed/npbs_mesh.h>
#include <CGAL/Point_set_3.h>
#include <CGAL/npbs_relax.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <string>
#include <vector>

namespace P = CGAL::parameters;
using paper::Point;
using Points = CGAL::Point_set_3<Point, paper::K::Vector_2>;
using Mesh = CGAL::Distributed::Mesh_2<paper::K>;

/// what a picture shows of a node
struct Node
{
  double x, y, d;
  int rank;
};

/// what a picture shows of a triangle
struct Triangle
{
  std::array<double, 6> corners; // x and y of each
  int rank;
};

// the nodes of all ranks on the first one
std::vector<Node> gather_nodes(const Mpi_session& session, const Points& points)
{
  const auto size = points.property_map<double>("size").first;
  std::vector<Node> own;
  for (const auto& i : points)
    own.push_back(Node{points.point(i).x(), points.point(i).y(), size[i], session.rank()});
  return session.gather(own);
}

// the triangles of all ranks on the first one, each from its owner
std::vector<Triangle> gather_triangles(const Mpi_session& session, const Mesh& mesh)
{
  std::vector<Triangle> own;
  for (std::size_t t = 0; t < mesh.number_of_owned_triangles(); ++t) {
    Triangle triangle{{}, session.rank()};
    for (std::size_t k = 0; k < 3; ++k) {
      const Point& p = mesh.point(static_cast<std::size_t>(mesh.vertices(t)[k]));
      triangle.corners[2 * k] = p.x();
      triangle.corners[2 * k + 1] = p.y();
    }
    own.push_back(triangle);
  }
  return session.gather(own);
}

// a square around the ring or its middle, with room for discs
CGAL::Bbox_2 square(double radius)
{
  return CGAL::Bbox_2(-1.1 * radius, -1.1 * radius, 1.1 * radius, 1.1 * radius);
}

// the whole ring, and its middle
template <class Draw>
void write_picture(const std::string& name, const std::string& caption, const Draw& draw)
{
  Svg_picture picture;
  draw(picture, 1.01, caption);
  draw(picture, 0.09, "the middle");
  picture.write("distributed_ring_" + name + ".svg");
}

void draw_nodes(const std::string& name, const std::string& caption, const std::vector<Node>& nodes)
{
  write_picture(name, caption, [&](Svg_picture& picture, double radius, const std::string& text) {
    picture.start_panel(text, square(radius));
    for (const Node& n : nodes)
      if (std::hypot(n.x, n.y) < radius)
        picture.add_disc_of_rank(Point(n.x, n.y), n.d / 2, n.rank);
  });
}

void draw_parts(const std::vector<Triangle>& triangles)
{
  write_picture("parts", "parts of ranks", [&](Svg_picture& picture, double radius, const std::string& text) {
    picture.start_panel(text, square(radius));
    for (const Triangle& t : triangles) {
      const auto& c = t.corners;
      if (std::hypot(c[0], c[1]) < radius && std::hypot(c[2], c[3]) < radius && std::hypot(c[4], c[5]) < radius)
        picture.add_triangle_of_rank(Point(c[0], c[1]), Point(c[2], c[3]), Point(c[4], c[5]), t.rank);
    }
  });
}

// whether one rank makes the same nodes, to the last bit
bool are_those_of_one_rank(const std::vector<Node>& nodes, paper::CDT cdt, const paper::Sizing& d)
{
  CGAL::npbs_relax(cdt, P::sizing_function(d));
  std::vector<Point> distributed, expected;
  for (const Node& n : nodes)
    distributed.emplace_back(n.x, n.y);
  for (const auto v : cdt.finite_vertex_handles())
    expected.push_back(v->point());
  std::sort(distributed.begin(), distributed.end());
  std::sort(expected.begin(), expected.end());
  return distributed == expected;
}

int run(const Mpi_session& session)
{
  const paper::Domain ring = paper::ring(1);
  const paper::CDT cdt = paper::triangulate(ring); // all ranks have the domain
  const auto np = P::sizing_function(ring.d);

  Points initial, points; // those of this rank
  CGAL::Distributed::npbs_mesh(initial, cdt, MPI_COMM_WORLD, np.number_of_rounds(0));
  const auto result = CGAL::Distributed::npbs_mesh(points, cdt, MPI_COMM_WORLD, np);

  const std::vector<Node> first = gather_nodes(session, initial), nodes = gather_nodes(session, points);
  const std::vector<Triangle> triangles = gather_triangles(session, result.mesh);
  bool is_equal = true;
  session.all_or_none([&] {
    if (!session.is_first())
      return;
    draw_parts(triangles);
    draw_nodes("initial", "initial nodes", first);
    draw_nodes("result", "result", nodes);
    is_equal = are_those_of_one_rank(nodes, cdt, ring.d);
    std::cout << result.report << session.number_of_ranks() << " ranks: "
              << (is_equal ? "the same nodes as one rank, bit for bit" : "NOT the nodes of one rank") << std::endl;
  });
  return is_equal ? 0 : 1;
}

int main(int argc, char** argv)
{
  return run_with_mpi(argc, argv, "distributed_ring", run);
}
