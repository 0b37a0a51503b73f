// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// the union of what ranks own is the triangulation of all bubbles

#include "../random_seeds.h"
#include "bubbles.h"
#include "union_of_ranks.h"

#include <gtest/gtest.h>

#include <numeric>
#include <random>
#include <stdexcept>
#include <string>

namespace test_distributed_triangulation {

using namespace bubbles;

struct Options
{
  double reach = 3;
  bool with_gaps = false;
  bool shuffle_numbers = false;
};

struct Ranks
{
  Communicator comm{MPI_COMM_WORLD};

  Distributed_mesh_2 triangulate(const Case& c, const std::vector<std::int64_t>& numbers,
                                 const Options& options)
  {
    const Hilbert_partition_2 partition =
      distributed::partition(c.domain().bbox(), c.bubbles, comm.size(), options.with_gaps);
    return distributed_triangulate(c.domain(),
                                   distributed::own_part(c.bubbles, numbers, partition, comm.rank()),
                                   partition, comm, options.reach);
  }
};

std::vector<std::int64_t> numbers_of(const Case& c, const Options& options)
{
  std::vector<std::int64_t> numbers(c.bubbles.size());
  std::iota(numbers.begin(), numbers.end(), 0);
  if (options.shuffle_numbers) {
    std::mt19937 engine(random_seeds::seed(5));
    std::shuffle(numbers.begin(), numbers.end(), engine);
    for (std::int64_t& n : numbers)
      n = 10000000000 * (n % 3) + 7 * n; // neither dense nor small
  }
  return numbers;
}

void expect_union_is_the_whole(const Case& c, const Options& options = Options())
{
  Ranks ranks;
  const std::vector<std::int64_t> numbers = numbers_of(c, options);
  const Distributed_mesh_2 part = ranks.triangulate(c, numbers, options);
  const Marked_triangles_2 whole = mesh_of(c).triangles;
  const auto all = distributed::triangles(whole, numbers, whole.inside);

  auto owned = gather_records(
    ranks.comm, distributed::triangles(part.triangles, part.bubbles.id, part.is_owned));
  std::sort(owned.begin(), owned.end());
  EXPECT_EQ(owned.size(), all.size());
  EXPECT_TRUE(owned == all);

  // and around its own bubbles a rank sees all that there is
  std::vector<std::int64_t> own;
  for (std::size_t i = 0; i < part.bubbles.size(); ++i)
    if (part.bubbles.owner[i] == ranks.comm.rank())
      own.push_back(part.bubbles.id[i]);
  std::vector<distributed::Triangle> around;
  for (const auto& t : all)
    for (std::int64_t v : t.vertices)
      if (std::binary_search(own.begin(), own.end(), v)) {
        around.push_back(t);
        break;
      }
  EXPECT_TRUE(around == distributed::triangles(part.triangles, part.bubbles.id, part.is_final));
  EXPECT_TRUE(std::is_sorted(part.bubbles.id.begin(), part.bubbles.id.end()));
}

const Options with_gaps{3, true, false}, with_shuffled_numbers{3, false, true};

TEST(Distributed_triangulation, relaxed_bubbles)
{
  for (const paper::Domain& domain : paper::all_domains(1)) {
    SCOPED_TRACE(domain.name);
    const Case c = relaxed(domain);
    expect_union_is_the_whole(c);
    expect_union_is_the_whole(c, with_gaps);
  }
}

TEST(Distributed_triangulation, whatever_numbers)
{
  expect_union_is_the_whole(relaxed(paper::square_with_hole(2)), with_shuffled_numbers);
  expect_union_is_the_whole(random(paper::trunk(1), 500, 3), with_shuffled_numbers);
}

TEST(Distributed_triangulation, whatever_reach)
{
  const Case c = relaxed(paper::graded_square(2));
  for (double r : {0., 0.5, 1., 20.}) {
    SCOPED_TRACE(r);
    expect_union_is_the_whole(c, Options{r, false, false});
  }
}

TEST(Distributed_triangulation, with_a_third_of_the_bubbles_removed)
{
  for (const paper::Domain& domain : {paper::ring(1.5), paper::l_shape(1), paper::comb(1.5)}) {
    SCOPED_TRACE(domain.name);
    Case c = relaxed(domain);
    thin_out(c.bubbles, 0.33, 11);
    expect_union_is_the_whole(c);
    thin_out(c.bubbles, 0.8, 12);
    expect_union_is_the_whole(c);
  }
}

TEST(Distributed_triangulation, random_points)
{
  for (unsigned seed = 1; seed <= 6; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    for (const paper::Domain& domain : {paper::octagram(1), paper::comb(1), paper::non_convex(1)}) {
      SCOPED_TRACE(domain.name);
      const Case c = random(domain, 400, seed);
      expect_union_is_the_whole(c);
      expect_union_is_the_whole(c, Options{0, false, false});
    }
  }
}

TEST(Distributed_triangulation, points_on_circles_and_edges_through_them)
{
  const Case c = lattice(20);
  expect_union_is_the_whole(c);
  expect_union_is_the_whole(c, with_gaps);
  expect_union_is_the_whole(c, with_shuffled_numbers);
  for (double r : {0., 0.2, 0.4, 0.6, 0.8})
    expect_union_is_the_whole(c, Options{r, false, false}); // the fourth point of a square may be unknown
}

TEST(Distributed_triangulation, a_question_is_about_all_that_matters)
{
  std::mt19937 engine(random_seeds::seed(3));
  std::uniform_real_distribution<double> uniform(0, 1), flatness(-18, 0);
  const CGAL::Bbox_2 domain(0, 0, 1, 1);
  std::size_t in_discs = 0;
  for (int k = 0; k < 3000; ++k) {
    Bubble_mesh_2 mesh;
    const Point p(uniform(engine), uniform(engine)), q(uniform(engine), uniform(engine));
    const double t = uniform(engine), off = std::pow(10, flatness(engine));
    const Point r(p.x() + t * (q.x() - p.x()) - off * (q.y() - p.y()),
                  p.y() + t * (q.y() - p.y()) + off * (q.x() - p.x()));
    if (CGAL::orientation(p, q, r) != CGAL::LEFT_TURN)
      continue;
    const Index hidden = static_cast<Index>(engine() % 4); // the last one: none
    for (const Point& vertex : {p, q, r})
      mesh.bubbles.add(vertex, 1, Bubbles_2::FACE, 0);
    mesh.triangles.vertices = {{0, 1, 2}};
    mesh.triangles.edges = {{no_index, no_index, no_index}};
    if (hidden < 3)
      mesh.triangles.edges[0][hidden] = 0;
    const Disc_2 disc = disc_of_triangle(mesh, 0, domain);
    const Triangle_question_2 question = make_question(mesh, 0, disc, 0, 0);
    for (int i = 0; i < 50; ++i) {
      // at all distances from the vertices
      const double d = std::pow(10, flatness(engine) / 6), angle = 7 * uniform(engine);
      const Point near = mesh.bubbles.point(engine() % 3);
      const Point x(near.x() + d * std::cos(angle), near.y() + d * std::sin(angle));
      const bool is_in_domain = x.x() >= 0 && x.x() <= 1 && x.y() >= 0 && x.y() <= 1;
      if (!is_in_domain || !question.concerns(x, i % 2 == 0))
        continue;
      ++in_discs;
      EXPECT_LE(std::hypot(x.x() - disc.x, x.y() - disc.y), disc.radius);
    }
  }
  EXPECT_GT(in_discs, 1000u);
}

TEST(Distributed_triangulation, fewer_bubbles_than_ranks)
{
  expect_union_is_the_whole(random(paper::non_convex(1), 0, 1));
  Case square = read(paper::graded_square(1));
  add_outline(square, 0, 1);
  expect_union_is_the_whole(square);
  expect_union_is_the_whole(square, with_gaps);
  add_inside(square, Point(0.1, 0.3), 1);
  expect_union_is_the_whole(square, Options{0, false, false});
}

TEST(Distributed_triangulation, one_rank_has_all)
{
  Ranks ranks;
  const Case c = random(paper::trunk(1), 300, 4);
  const std::vector<std::int64_t> numbers = numbers_of(c, Options());
  const std::vector<Hilbert_partition_2::Key> none_but_the_first(ranks.comm.size() - 1, ~Hilbert_partition_2::Key(0));
  const Hilbert_partition_2 partition(hilbert_curve(c.domain()), none_but_the_first);
  const Distributed_mesh_2 part = distributed_triangulate(
    c.domain(), distributed::own_part(c.bubbles, numbers, partition, ranks.comm.rank()), partition, ranks.comm);
  const Marked_triangles_2 whole = mesh_of(c).triangles;
  const auto owned = gather_records(
    ranks.comm, distributed::triangles(part.triangles, part.bubbles.id, part.is_owned));
  EXPECT_TRUE(owned == distributed::triangles(whole, numbers, whole.inside));
}

TEST(Distributed_triangulation, a_rank_holds_no_more_than_it_needs)
{
  const Case c = random(paper::graded_square(1), 4000, 9);
  Ranks ranks;
  const Distributed_mesh_2 part = ranks.triangulate(c, numbers_of(c, Options()), Options());
  const double n = double(c.bubbles.size()), p = ranks.comm.size();
  EXPECT_LT(double(part.bubbles.size()), n / p + 25 * std::sqrt(n / p) + 20);
}

TEST(Distributed_triangulation, a_rank_holds_the_outline_where_it_is)
{
  Case c = read(paper::comb(1));
  add_outline(c, 400, 0.002);
  Ranks ranks;
  const Distributed_mesh_2 part = ranks.triangulate(c, numbers_of(c, Options()), Options());
  const double n = double(c.bubbles.size()), p = ranks.comm.size();
  ASSERT_GT(n, 4000);
  EXPECT_LT(double(part.bubbles.size()), n / p + 0.3 * n); // with those near to its part
  expect_union_is_the_whole(c);
}

TEST(Distributed_triangulation, bubbles_in_one_place_are_found_on_all_ranks)
{
  Case c = random(paper::trunk(1), 200, 2);
  const std::size_t last = c.bubbles.size() - 1;
  c.bubbles.add(c.bubbles.point(last), 0.1, Bubbles_2::FACE, c.bubbles.host[last]);
  Ranks ranks;
  EXPECT_THROW(ranks.triangulate(c, numbers_of(c, Options()), Options()), std::runtime_error);
}

TEST(Distributed_triangulation, a_bubble_of_a_face_on_an_edge_is_found_on_all_ranks)
{
  Case c = read(paper::graded_square(1));
  add_outline(c, 1, 0.3);
  c.bubbles.add(Point(-0.5, 0.75), 0.1, Bubbles_2::FACE, 0);
  Ranks ranks;
  EXPECT_THROW(ranks.triangulate(c, numbers_of(c, Options()), Options()), std::runtime_error);
}

} // namespace test_distributed_triangulation
