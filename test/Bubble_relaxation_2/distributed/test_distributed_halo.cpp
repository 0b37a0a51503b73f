// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// The halo: what bubbles of this rank look at is known here, however bubbles wander, and owners tell of their sets

#include "../random_seeds.h"
#include "union_of_ranks.h"

#include <CGAL/Bubble_relaxation_2/internal/distributed/simulation/Halo_2.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/simulation/Migration_2.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <random>
#include <set>
#include <vector>

namespace test_distributed_halo {

using namespace CGAL::Bubble_relaxation_2::internal;

/// Bubbles that all ranks know in this test, with the halo of what a rank would know of them.
class Halo : public testing::Test
{
protected:
  Halo() : m_engine(random_seeds::seed(1)), m_halo(m_comm, m_traffic, radius)
  {
    for (int i = 0; i < 300; ++i)
      m_all.add(Point(uniform(), uniform()), 0.02 * std::pow(4, uniform()), Bubbles_2::FACE, 0);
    m_partition = distributed::partition(CGAL::Bbox_2(0, 0, 1, 1), m_all, m_comm.size(), true);
    distribute();
  }

  static constexpr double radius = 1.7, needed_reach = 3.5;

  double uniform() { return std::uniform_real_distribution<double>(0, 1)(m_engine); }

  /// each bubble comes to the rank that owns its place
  void distribute()
  {
    m_here = Bubbles_2();
    m_here.rank = m_comm.rank();
    m_halo.start(m_here, m_partition);
    for (std::size_t i = 0; i < m_all.size(); ++i)
      if (m_partition.owner(m_all.x[i], m_all.y[i]) == m_comm.rank())
        add_here(record(m_all, i, static_cast<std::int64_t>(i)), m_comm.rank());
    std::vector<Index> own(m_here.size());
    std::iota(own.begin(), own.end(), Index(0));
    m_number_of_own = own.size();
    look_after(own);
  }

  void add_here(const Bubble_record_2& r, int owner)
  {
    add(m_here, r, owner);
    m_halo.add(m_here, static_cast<Index>(m_here.size()) - 1);
  }

  void look_after(const std::vector<Index>& those)
  {
    Neighbor_sets_2 finder(Neighbor_sets_2::without_skin);
    finder.build(m_here);
    m_halo.look_after(
      m_here, those, finder,
      [&](Index i) { return Bubble_state_2{record(m_here, static_cast<std::size_t>(i)), {}}; },
      [&](const Bubble_state_2& s, int owner) {
        add_here(s.bubble, owner);
        finder.add(m_here, static_cast<Index>(m_here.size()) - 1);
      });
  }

  /// whether what is around the bubbles of this rank is known here, and they are not far from its part
  void expect_good_halo() const
  {
    const std::set<std::int64_t> known(m_here.id.begin(), m_here.id.end());
    for (std::size_t k = 0; k < m_number_of_own; ++k) {
      const std::size_t i = static_cast<std::size_t>(m_here.id[k]);
      for (std::size_t j = 0; j < m_all.size(); ++j) {
        const double distance = std::hypot(m_all.x[i] - m_all.x[j], m_all.y[i] - m_all.y[j]);
        const bool is_needed = distance < needed_reach * (std::max)(m_all.d[i], m_all.d[j]);
        ASSERT_TRUE(!is_needed || known.count(static_cast<std::int64_t>(j)) == 1) << i << " does not see " << j;
      }
      constexpr double farthest = Halo_2::away_from_part;
      const auto owners = m_partition.owners_in_disc(m_all.x[i], m_all.y[i], farthest * m_all.d[i]);
      ASSERT_NE(std::find(owners.begin(), owners.end(), m_comm.rank()), owners.end()) << i << " is far away";
    }
  }

  std::mt19937 m_engine; // the same numbers on all ranks
  Communicator m_comm{MPI_COMM_WORLD};
  Traffic_2 m_traffic;
  Halo_2 m_halo;
  Hilbert_partition_2 m_partition{Hilbert_curve_2(CGAL::Bbox_2(0, 0, 1, 1)), {}};
  Bubbles_2 m_all, m_here; // of these the first ones are own
  std::size_t m_number_of_own = 0;
};

TEST_F(Halo, is_good_however_bubbles_wander)
{
  std::vector<double> ux, uy, pace; // a direction of each, and how far it goes in a step
  for (std::size_t i = 0; i < m_all.size(); ++i) {
    const double angle = 2 * CGAL_PI * uniform();
    ux.push_back(std::cos(angle));
    uy.push_back(std::sin(angle));
    pace.push_back(0.2 * uniform() * uniform());
  }
  int times_distributed = 0, times_looked_after = 0;
  for (int step = 0; step < 80; ++step) {
    for (std::size_t i = 0; i < m_all.size(); ++i) {
      const double x = m_all.x[i] + pace[i] * m_all.d[i] * ux[i], y = m_all.y[i] + pace[i] * m_all.d[i] * uy[i];
      if (!(x > 0 && x < 1))
        ux[i] = -ux[i];
      else if (!(y > 0 && y < 1))
        uy[i] = -uy[i];
      else {
        m_all.x[i] = x;
        m_all.y[i] = y;
      }
      if (step % 8 == static_cast<int>(i % 8)) // grows, or gets smaller
        m_all.d[i] *= step % 16 < 8 ? 1.04 : 0.97;
    }
    std::vector<Index> outgrown;
    bool is_far = false;
    for (std::size_t k = 0; k < m_here.size(); ++k) {
      const std::size_t i = static_cast<std::size_t>(m_here.id[k]);
      m_here.x[k] = m_all.x[i];
      m_here.y[k] = m_all.y[i];
      m_here.d[k] = m_all.d[i];
      if (m_halo.is_outgrown_by(m_here, static_cast<Index>(k))) {
        outgrown.push_back(static_cast<Index>(k));
        is_far = is_far || m_halo.is_far_from_home(m_here, static_cast<Index>(k));
      }
    }
    expect_good_halo();
    if (m_comm.any(is_far || m_halo.has_gone_far())) {
      distribute();
      ++times_distributed;
    } else if (m_comm.any(!outgrown.empty())) {
      look_after(m_halo.almost_outgrown(m_here, outgrown));
      ++times_looked_after;
    }
    expect_good_halo();
  }
  if (m_comm.size() > 1) {
    EXPECT_GT(times_distributed, 0);
    EXPECT_GT(times_looked_after, 0);
  }
}

TEST_F(Halo, has_no_bubbles_that_are_gone)
{
  std::vector<Index> all_here(m_here.size());
  std::iota(all_here.begin(), all_here.end(), Index(0));
  for (Index i : all_here) {
    m_here.x[i] += 0.5 * m_here.d[i];
    if (m_here.id[i] % 2 == 0)
      m_here.remove(i);
  }
  const std::vector<Index> those = m_halo.almost_outgrown(m_here, all_here);
  EXPECT_TRUE(std::none_of(those.begin(), those.end(), [&](Index i) { return m_here.is_gone(i); }));
  EXPECT_EQ(std::set<Index>(those.begin(), those.end()).size(), those.size()) << "one twice";
}

TEST_F(Halo, sets_of_others_are_those_of_their_owners)
{
  Neighbor_sets_2 sets(radius), expected(radius);
  sets.build(m_here);
  expected.build(m_here);
  for (std::size_t i = m_number_of_own; i < m_here.size(); ++i)
    sets.assign(static_cast<Index>(i), {});
  share_sets(m_comm, m_halo, m_here, sets);
  for (std::size_t i = 0; i < m_here.size(); ++i)
    EXPECT_EQ(std::vector<Index>(sets.begin(i), sets.end(i)),
              std::vector<Index>(expected.begin(i), expected.end(i)));
}

TEST_F(Halo, neighbors_tell_where_they_are_at_a_stage)
{
  Neighbor_sets_2 sets(radius);
  for (int turn = 0; turn < 2; ++turn) { // the second with other neighbours
    sets.build(m_here);
    std::vector<double> x = m_here.x, y = m_here.y;
    for (std::size_t i = 0; i < m_number_of_own; ++i) {
      x[i] = 3 * m_here.x[i] + 1;
      y[i] = 2 * m_here.y[i];
    }
    share_values(m_comm, m_halo.lists(), x);
    share_values(m_comm, m_halo.lists(), y);
    for (std::size_t i = 0; i < m_number_of_own; ++i)
      for (const Index *j = sets.begin(i), *end = sets.end(i); j != end; ++j) {
        EXPECT_EQ(x[*j], 3 * m_here.x[*j] + 1);
        EXPECT_EQ(y[*j], 2 * m_here.y[*j]);
      }
    for (double& d : m_here.d)
      d *= 1.5;
  }
}

} // namespace test_distributed_halo
