// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// ranks treat the defects of a mesh as one does

#include "../random_seeds.h"
#include "bubbles.h"
#include "union_of_ranks.h"

#include <CGAL/Bubble_relaxation_2/internal/distributed/treatment/treat_distributed.h>
#include <CGAL/Bubble_relaxation_2/internal/treatment/treat_defects.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <random>
#include <vector>

namespace test_distributed_treatment {

using namespace bubbles;

struct Options
{
  double reach = 8;
  bool with_gaps = false;
};

std::vector<std::int64_t> numbers_of(const Bubbles_2& b)
{
  std::vector<std::int64_t> numbers(b.size());
  std::iota(numbers.begin(), numbers.end(), 0);
  return numbers;
}

void expect_bubbles_are_those(const Bubbles_2& whole, const Bubbles_2& part)
{
  std::size_t different = 0;
  for (std::size_t i = 0; i < part.size(); ++i) {
    ASSERT_LT(static_cast<std::size_t>(part.id[i]), whole.size());
    const Bubble_record_2 a = record(part, i),
                          b = record(whole, static_cast<std::size_t>(part.id[i]), 0);
    different += a.x != b.x || a.y != b.y || a.d != b.d || a.s != b.s || a.host != b.host ||
                 a.dimension != b.dimension;
  }
  EXPECT_EQ(different, 0u);
}

/// A case as one rank treats it, and the parts of it that ranks treat. All sizes are `d`.
struct Ranks
{
  explicit Ranks(const Case& whole, const Relaxation_options& o = {}, double d = 1, bool with_gaps = false)
    : c(whole), options(o), sizes([d](double, double) { return d; }),
      partition(distributed::partition(c.domain().bbox(), c.bubbles, comm.size(), with_gaps))
  {}

  Ranks(const Ranks&) = delete; // the problem refers to what is here

  /// the part of this rank
  Distributed_mesh_2 own_mesh(const Distributed_treatment_2& treat) const
  {
    return treat.triangulate_own(distributed::own_part(c.bubbles, numbers_of(c.bubbles), partition, comm.rank()));
  }

  const Case& c;
  const Relaxation_options options;
  const Sizes_2 sizes;
  const Problem_2 problem{c.domain(), c.given(), options, sizes, sizes};
  Communicator comm{MPI_COMM_WORLD};
  const Hilbert_partition_2 partition;
  const Bubbles_2 no_points;
};

struct Outcome
{
  Treatment_counts counts;
  std::size_t number_of_renewals;
};

/// the triangles that ranks own, by the numbers of their vertices
auto owned_triangles(const Communicator& comm, const Distributed_mesh_2& mesh)
{
  auto owned = gather_records(comm, distributed::triangles(mesh.triangles, mesh.bubbles.id, mesh.is_owned));
  std::sort(owned.begin(), owned.end());
  return owned;
}

/// `first`: triangles with a vertex from there on are treated
Outcome expect_same_treatment(const Case& c, const Options& options = Options(), std::int64_t first = 0)
{
  Ranks ranks(c, {}, 1, options.with_gaps);
  Communicator& comm = ranks.comm;
  const Hilbert_partition_2& partition = ranks.partition;
  Bubble_mesh_2 whole = mesh_of(c);
  Outline_care care{false};
  const Treatment_counts expected = treat_defects(Whole_treatment_2(ranks.problem), whole, care, first);

  const Distributed_treatment_2 treat(ranks.problem, ranks.no_points, partition, comm, options.reach);
  Distributed_mesh_2 mesh = ranks.own_mesh(treat);
  const Treatment_counts counts = treat_defects(treat, mesh, care, first);
  EXPECT_EQ(counts.treated, expected.treated);
  EXPECT_EQ(counts.inserted, expected.inserted);
  EXPECT_EQ(counts.deleted, expected.deleted);
  EXPECT_EQ(treat.smallest_quality(mesh), smallest_quality(whole));

  const Bubbles_2 part = send_home(comm, partition, own_bubbles(mesh.bubbles));
  EXPECT_EQ(comm.sum(static_cast<std::int64_t>(part.size())), static_cast<std::int64_t>(whole.bubbles.size()));
  expect_bubbles_are_those(whole.bubbles, part);
  for (std::size_t i = 0; i < part.size(); ++i)
    EXPECT_EQ(partition.owner(part.x[i], part.y[i]), comm.rank());

  // the mesh has become that of the bubbles where they are now
  const Marked_triangles_2& t = whole.triangles;
  const auto all_triangles = distributed::triangles(t, numbers_of(whole.bubbles), t.inside);
  EXPECT_TRUE(owned_triangles(comm, mesh) == all_triangles);
  if (counts.treated > 0) { // also those that are known of other ranks are of that mesh
    const auto known = distributed::triangles(mesh.triangles, mesh.bubbles.id, mesh.triangles.inside);
    EXPECT_TRUE(std::includes(all_triangles.begin(), all_triangles.end(), known.begin(), known.end()));
  }
  return Outcome{expected, treat.number_of_renewals};
}

/// The bubbles that are so far from other ranks' parts, and not much farther, by their owners.
std::map<int, std::vector<Index>> bubbles_by_clearance(const Case& c, double least, double most)
{
  const int ranks = Communicator(MPI_COMM_WORLD).size();
  const Hilbert_partition_2 partition = distributed::partition(c.domain().bbox(), c.bubbles, ranks, false);
  std::map<int, std::vector<Index>> result;
  for (std::size_t i = 0; i < c.bubbles.size(); ++i) {
    const double x = c.bubbles.x[i], y = c.bubbles.y[i];
    const int owner = partition.owner(x, y);
    if (c.bubbles.can_move(i) && partition.owns_disc(owner, x, y, least) &&
        (ranks == 1 || !partition.owns_disc(owner, x, y, most)))
      result[owner].push_back(static_cast<Index>(i));
  }
  return result;
}

/// moves a bubble of the lattice
void make_defect(Case& c, Index i, double dx = 0.3, double dy = 0.1)
{
  Bubbles_2& b = c.bubbles;
  Point p(b.x[i] + dx, b.y[i] + dy);
  if (b.is_on_edge(i)) {
    b.s[i] += dx / c.domain().length(b.host[i]);
    p = c.domain().point_on_edge(b.host[i], b.s[i]);
  }
  b.x[i] = p.x();
  b.y[i] = p.y();
}

class Treated_paper_domain : public testing::TestWithParam<int>
{};

TEST_P(Treated_paper_domain, is_treated_as_by_one_rank)
{
  const paper::Domain d = paper::all_domains(1)[GetParam()];
  SCOPED_TRACE(d.name);
  EXPECT_GT(expect_same_treatment(relaxed(d)).counts.treated, 0u);
}

INSTANTIATE_TEST_SUITE_P(Some, Treated_paper_domain, testing::Values(1, 4, 7));

TEST(Distributed_treatment, operations)
{
  const Treatment_counts counts = expect_same_treatment(relaxed(paper::all_domains(0.7)[1], 1, 3)).counts;
  EXPECT_GT(counts.inserted, 0u);
  EXPECT_GT(counts.deleted, 0u);
}

TEST(Distributed_treatment, random_points)
{
  const Treatment_counts counts = expect_same_treatment(random(paper::all_domains(1)[0], 600, 3)).counts;
  EXPECT_GT(counts.treated, 300u);
  EXPECT_GT(counts.inserted + counts.deleted, 20u);
}

TEST(Distributed_treatment, triangles_with_some_of_the_vertices)
{
  const Case c = relaxed(paper::all_domains(0.7)[1], 1, 3);
  const auto number = static_cast<std::int64_t>(c.bubbles.size());
  const Treatment_counts all = expect_same_treatment(c).counts;
  for (const Options& options : {Options(), Options{0.1, false}}) {
    const Treatment_counts half = expect_same_treatment(c, options, number / 2).counts;
    EXPECT_GT(half.inserted + half.deleted, 0u);
    EXPECT_LT(half.treated, all.treated);
    EXPECT_EQ(expect_same_treatment(c, options, number).counts.treated, 0u);
  }
}

// pieces are made anew between sweeps, and after operations
TEST(Distributed_treatment, random_points_in_narrow_pieces)
{
  const Outcome outcome = expect_same_treatment(random(paper::all_domains(1)[0], 600, 5), Options{0.1, false});
  EXPECT_GT(outcome.counts.treated, 300u);
  EXPECT_EQ(outcome.number_of_renewals > 1, Communicator(MPI_COMM_WORLD).size() > 1);
}

TEST(Distributed_treatment, operations_in_narrow_pieces)
{
  EXPECT_GT(expect_same_treatment(relaxed(paper::all_domains(0.7)[1], 1, 3), Options{0.1, false}).counts.inserted, 0u);
}

TEST(Distributed_treatment, vertices_on_circles) { expect_same_treatment(lattice(16)); }

TEST(Distributed_treatment, pieces_that_are_too_narrow_at_first)
{
  expect_same_treatment(relaxed(paper::all_domains(1)[3]), Options{0.5, false});
}

TEST(Distributed_treatment, defects_far_from_other_ranks)
{
  Case c = equilateral(64);
  for (const auto& bubbles : bubbles_by_clearance(c, 4, 100)) // one of each rank that has such
    make_defect(c, bubbles.second[bubbles.second.size() / 2]);
  const Outcome outcome = expect_same_treatment(c, Options{3, false});
  EXPECT_GT(outcome.counts.treated, 0u);
  EXPECT_EQ(outcome.number_of_renewals, 0u);
}

TEST(Distributed_treatment, a_defect_on_an_edge_far_from_other_ranks)
{
  Case c = equilateral(64);
  for (const auto& bubbles : bubbles_by_clearance(c, 4, 100)) {
    const auto on_edge = std::find_if(bubbles.second.begin(), bubbles.second.end(),
                                      [&c](Index i) { return c.bubbles.is_on_edge(i); });
    if (on_edge != bubbles.second.end())
      make_defect(c, *on_edge);
  }
  const Outcome outcome = expect_same_treatment(c, Options{3, false});
  EXPECT_GT(outcome.counts.treated, 0u);
  EXPECT_EQ(outcome.number_of_renewals, 0u);
}

TEST(Distributed_treatment, moves_that_come_too_near_to_other_ranks)
{
  Case c = equilateral(48);
  make_defect(c, bubbles_by_clearance(c, 0.3, 1.2).begin()->second.front());
  const Outcome outcome = expect_same_treatment(c, Options{0.1, false}); // it does not look near
  EXPECT_GT(outcome.counts.treated, 0u);
  const bool is_alone = Communicator(MPI_COMM_WORLD).size() == 1;
  EXPECT_EQ(outcome.number_of_renewals > 0, !is_alone);
}

// candidates of several ranks may meet where none of them moves
TEST(Distributed_treatment, defects_at_any_distance_from_other_ranks)
{
  std::mt19937 random(random_seeds::seed(7)); // the same on all ranks
  std::uniform_real_distribution<double> shift(-0.35, 0.35);
  std::size_t wide_enough = 0, renewed = 0;
  for (double clearance : {1.5, 2.5, 3.5, 4.5, 5.5}) {
    Case c = equilateral(64);
    for (const auto& bubbles : bubbles_by_clearance(c, clearance, clearance + 1))
      for (int k = 0; k < 2; ++k) {
        const double dx = shift(random), dy = shift(random);
        make_defect(c, bubbles.second[random() % bubbles.second.size()], dx, dy);
      }
    for (double reach : {0.1, 8.})
      ++(expect_same_treatment(c, Options{reach, false}).number_of_renewals == 0 ? wide_enough : renewed);
  }
  EXPECT_GT(wide_enough, 0u);
  EXPECT_EQ(renewed > 0, Communicator(MPI_COMM_WORLD).size() > 1);
}

struct Border_outcome
{
  bool has_forgotten; ///< whether any rank had to forget triangles
  bool is_unknown;    ///< whether any rank does not know the vertex that moves
};

/// One vertex goes far in two sweeps, and all ranks restore what they know of the mesh.
Border_outcome move_in_two_sweeps(Ranks& ranks, Index i, double dx, double dy, const Distributed_treatment_2& treat)
{
  const Case& c = ranks.c;
  Communicator& comm = ranks.comm;
  Bubble_mesh_2 whole{c.bubbles, {}};
  Mesh_piece_2 piece = treat.piece_of(ranks.own_mesh(treat));
  Bubbles_2& b = piece.mesh.bubbles;
  const std::vector<char>& inside = piece.mesh.triangles.inside;
  const auto number_before = std::count(inside.begin(), inside.end(), 1);
  const Index here = b.index_of(i);
  Treatment_team_2 team(comm, c.domain(), piece, [] {});
  Editable_triangulation_2 mesh(piece.mesh);
  std::vector<Index> moved, neighbors;
  std::vector<char> was_moved(b.size(), 0);
  if (here != no_index && b.is_ours(here)) {
    moved.push_back(here);
    was_moved[here] = 1;
  }
  for (int sweep = 0; sweep < 2; ++sweep) {
    whole.bubbles.x[i] += dx / 2;
    whole.bubbles.y[i] += dy / 2;
    triangulate(c.domain(), whole);
    for (Index v : moved) {
      b.x[v] = whole.bubbles.x[i];
      b.y[v] = whole.bubbles.y[i];
    }
    team.share_moved(piece.mesh, moved);
    mesh.restore_delaunay(moved);
    if (team.restore_border(mesh, moved, was_moved))
      return {true, comm.any(here == no_index)};
    team.add_neighbors_of_others(mesh, neighbors);
    const auto all = distributed::triangles(whole.triangles, numbers_of(whole.bubbles), whole.triangles.inside);
    const auto known = distributed::triangles(piece.mesh.triangles, b.id, inside);
    EXPECT_TRUE(std::includes(all.begin(), all.end(), known.begin(), known.end())) << "bubble " << i;
  }
  return {comm.any(std::count(inside.begin(), inside.end(), 1) < number_before), comm.any(here == no_index)};
}

// Those who do not know the vertex know triangles into whose circles it comes, and others that it has nothing to do with.
// Those who know it may have lost all its triangles.
TEST(Distributed_treatment, moves_beyond_the_end_of_a_piece)
{
  const Case c = equilateral(24);
  Ranks ranks(c);
  const Distributed_treatment_2 treat(ranks.problem, ranks.no_points, ranks.partition, ranks.comm, 2);
  std::size_t forgotten = 0, kept = 0;
  for (const auto& bubbles : bubbles_by_clearance(c, 1, 3.5))
    for (Index i : bubbles.second)
      for (int k = 0; k < 6 && c.bubbles.is_in_face(i); ++k) {
        const Border_outcome outcome =
          move_in_two_sweeps(ranks, i, 0.75 * std::cos(0.3 + k), 0.75 * std::sin(0.3 + k), treat);
        forgotten += outcome.is_unknown && outcome.has_forgotten;
        kept += outcome.is_unknown && !outcome.has_forgotten;
      }
  EXPECT_EQ(forgotten > 0, ranks.comm.size() > 1);
  EXPECT_EQ(kept > 0, ranks.comm.size() > 1);
}

// Vacancies are filled where others' pieces end: what these know is still of the mesh of all ranks, and they have not become
// so narrow by seven operations and six sweeps that they are made anew.
TEST(Distributed_treatment, operations_at_the_end_of_a_piece)
{
  std::mt19937 random(random_seeds::seed(11)); // the same on all ranks
  std::size_t inserted = 0;
  for (double clearance = 4; clearance < 9; clearance += 0.5) {
    Case c = equilateral(64);
    for (const auto& bubbles : bubbles_by_clearance(c, clearance, clearance + 1)) {
      const Index i = bubbles.second[random() % bubbles.second.size()];
      if (c.bubbles.is_in_face(i))
        c.bubbles.remove(i);
    }
    c.bubbles.forget_gone();
    const Outcome outcome = expect_same_treatment(c, Options{6, false});
    inserted += outcome.counts.inserted;
    EXPECT_EQ(outcome.number_of_renewals, 0u);
  }
  EXPECT_GT(inserted, 0u);
}

TEST(Distributed_treatment, ranks_without_bubbles)
{
  expect_same_treatment(relaxed(paper::all_domains(2)[1]), Options{8, true});
}

/// Which piece of an edge a new vertex comes too near to is known to ranks that have nothing of this edge.
TEST(Distributed_treatment, refinement_knows_of_edges_far_away)
{
  for (int k : {3, 4}) {
    SCOPED_TRACE(k);
    Case c = relaxed(paper::all_domains(1)[k]);
    Bubbles_2& b = c.bubbles;
    for (std::size_t i = 0; i < b.size(); ++i)
      if (b.is_in_face(i) && i % 97 == 0)
        make_defect(c, static_cast<Index>(i), 0.6 * b.d[i], 0.3 * b.d[i]);
    Relaxation_options options;
    options.minimum_angle = 25;
    Ranks ranks(c, options, 0.05);
    Bubble_mesh_2 whole = mesh_of(c);
    Outline_care care{false};
    const std::size_t expected = refine_small_angles(Whole_treatment_2(ranks.problem), whole, care);
    EXPECT_GT(expected, 30u);

    const Distributed_treatment_2 treat(ranks.problem, ranks.no_points, ranks.partition, ranks.comm);
    Distributed_mesh_2 mesh = ranks.own_mesh(treat);
    EXPECT_EQ(refine_small_angles(treat, mesh, care), expected);
    expect_bubbles_are_those(whole.bubbles, send_home(ranks.comm, ranks.partition, own_bubbles(mesh.bubbles)));
  }
}

// they would make it worse than the state says it is
TEST(Distributed_treatment, changes_are_taken_back)
{
  const Case c = random(paper::square_with_hole(1), 600, 1);
  Ranks ranks(c);
  const Distributed_treatment_2 treat(ranks.problem, ranks.no_points, ranks.partition, ranks.comm);
  Distributed_mesh_2 mesh = ranks.own_mesh(treat);
  const auto triangles = owned_triangles(ranks.comm, mesh);
  Mesh_piece_2 piece = treat.piece_of(std::move(mesh));
  Outline_care care{false};
  Treatment_state better{0.949, 0, care}, good{0.899, 0, care};
  treat.smooth(piece, usual_sweeps, better);
  treat.operate(piece, good);
  EXPECT_EQ(better.counts.treated, 0u);
  EXPECT_EQ(better.smallest, 0.949);
  EXPECT_EQ(good.counts.inserted + good.counts.deleted, 0u);
  EXPECT_GE(treat.number_of_renewals, 2u);
  expect_bubbles_are_those(c.bubbles, own_bubbles(piece.mesh.bubbles));
  EXPECT_TRUE(owned_triangles(ranks.comm, piece.mesh) == triangles);
  Treatment_state bad{0, 0, care};
  treat.smooth(piece, usual_sweeps, bad);
  EXPECT_GT(bad.counts.treated, 300u); // that is what was taken back
}

/// says at the end that the outline crosses itself
struct Treatment_found_broken : Distributed_treatment_2
{
  using Distributed_treatment_2::Distributed_treatment_2;
  bool closes_outline(const Mesh&) const { return ++number_of_looks, false; }
  mutable int number_of_looks = 0;
};

/// finds that on the way
struct Treatment_that_throws : Distributed_treatment_2
{
  Treatment_that_throws(const Problem_2& problem, const Bubbles_2& points, const Hilbert_partition_2& partition,
                        Communicator& comm)
    : Distributed_treatment_2(problem, points, partition, comm), m_comm(comm)
  {}

  void operate(Piece& piece, Treatment_state& state) const
  {
    if (!state.care.is_careful)
      m_comm.throw_on_all(Edges_too_near(this->problem().domain));
    Distributed_treatment_2::operate(piece, state);
  }

  Communicator& m_comm;
};

TEST(Distributed_treatment, all_is_done_carefully_once_more_when_the_outline_is_found_broken)
{
  const Case c = random(paper::square_with_hole(1), 600, 1);
  Relaxation_options options;
  options.minimum_angle = 30;
  Ranks ranks(c, options, 0.05);
  Bubble_mesh_2 whole = mesh_of(c);
  const Treatment_counts expected = treat_and_refine(Whole_treatment_2(ranks.problem), whole);
  EXPECT_GT(expected.inserted, 10u);

  const auto expect_the_same = [&](const auto& treatment) {
    Distributed_mesh_2 mesh = ranks.own_mesh(treatment);
    const Treatment_counts counts = treat_and_refine(treatment, mesh);
    EXPECT_EQ(counts.treated, expected.treated);
    EXPECT_EQ(counts.inserted, expected.inserted);
    EXPECT_EQ(counts.deleted, expected.deleted);
    expect_bubbles_are_those(whole.bubbles, own_bubbles(mesh.bubbles));
  };
  expect_the_same(Distributed_treatment_2(ranks.problem, ranks.no_points, ranks.partition, ranks.comm));
  const Treatment_found_broken broken(ranks.problem, ranks.no_points, ranks.partition, ranks.comm);
  expect_the_same(broken);
  EXPECT_EQ(broken.number_of_looks, 1);
  expect_the_same(Treatment_that_throws(ranks.problem, ranks.no_points, ranks.partition, ranks.comm));
}

} // namespace test_distributed_treatment
