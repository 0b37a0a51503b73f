// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_PLACEMENT_PLACEMENT_TEAM_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_PLACEMENT_PLACEMENT_TEAM_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/Bubbles_2.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Team.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Communicator.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Messages.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/parts/Hilbert_partition_2.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/parts/Part_team_2.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/parts/bubble_records.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Hilbert_curve_2.h>
#include <CGAL/Bubble_relaxation_2/internal/placement/Crystal_2.h>
#include <CGAL/Bubble_relaxation_2/internal/placement/Growth_proposals_2.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <unordered_map>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// The ranks that place bubbles together, each in its part of the domain, and grow one crystal. What comes out is what
/// one rank would have placed, to the last bit.
///
/// A bubble belongs to the rank in whose part it came in. The owner proposes places around it, decides about
/// these proposals, and settles it. Two bubbles nearer to each other than `needed_reach` times the size of the
/// larger one are known to the owners of both: each is sent to the ranks whose parts a disc around it meets,
/// and a rank that gets to know one that is larger than its own sends those to its owner. All that a proposal or
/// a bubble depends on lies within.
class Placement_team_2 : public Part_team_2
{
public:
  explicit Placement_team_2(Communicator& comm) : Part_team_2(comm) {}

  /// whether this rank brings a placed bubble home, as one does of each
  bool brings(std::size_t i) const
  {
    return i < m_owner.size() ? owns(static_cast<Index>(i))
                              : i >= m_number_of_common || static_cast<int>(i) % m_comm.size() == m_comm.rank();
  }

  /// of a bubble that was common or a seed
  std::int64_t number_of(std::size_t i) const { return m_numbers.empty() ? std::int64_t(i) : m_numbers[i]; }

  void note_common(const Bubbles_2& bubbles) override
  {
    m_number_of_common = bubbles.size();
    m_owner.clear();
    m_places.clear();
    m_holders.clear();
    m_key.clear();
    m_seeds.clear();
    m_numbers.clear();
    m_grown.clear();
    m_generation = 0;
  }

  void divide(const Domain_2& domain, const Bubbles_2& large) override
  {
    const Hilbert_curve_2 curve = hilbert_curve(domain);
    std::vector<Hilbert_curve_2::Key> keys, first;
    for (std::size_t i = 0; i < large.size(); ++i)
      keys.push_back(curve.key(large.x[i], large.y[i]));
    std::sort(keys.begin(), keys.end());
    for (std::size_t rank = 1, ranks = static_cast<std::size_t>(m_comm.size()); rank < ranks; ++rank)
      first.push_back(keys[keys.size() * rank / ranks]);
    m_division = std::make_unique<Hilbert_partition_2>(curve, first);
    m_partition = m_division.get();
  }

  void share_seeds(Bubbles_2& bubbles, std::vector<double>& directions) override
  {
    Messages<Seed> out;
    std::int64_t number = m_comm.sum_before(static_cast<std::int64_t>(bubbles.size() - m_number_of_common));
    for (std::size_t i = m_number_of_common; i < bubbles.size(); ++i) {
      const Seed s{bubbles.x[i], bubbles.y[i], bubbles.d[i], directions[i], number++, bubbles.host[i]};
      for (int rank : m_partition->owners_in_disc(s.x, s.y, reach * s.d))
        out[rank].push_back(s);
    }
    bubbles.select(indices_below(m_number_of_common));
    directions.resize(m_number_of_common);
    deliver(m_comm, out, [&](int, const Seed& s) { // from lower ranks come lower numbers
      bubbles.add(Point(s.x, s.y), s.d, Bubbles_2::FACE, s.triangle);
      directions.push_back(s.direction);
      m_seeds.push_back(s.number);
    });
  }

  std::vector<Index> keep_near(const Bubbles_2& b) override
  {
    const std::size_t n = m_number_of_common;
    std::vector<Index> near;
    for (std::size_t i = 0; i < b.size(); ++i) {
      if (i < n && !is_among(m_partition->owners_in_disc(b.x[i], b.y[i], reach * b.d[i]), m_comm.rank()))
        continue;
      near.push_back(static_cast<Index>(i));
      m_numbers.push_back(static_cast<std::int64_t>(i < n ? i : n) + (i < n ? 0 : m_seeds[i - n]));
    }
    m_number_of_common = static_cast<std::size_t>(std::lower_bound(near.begin(), near.end(), Index(n)) - near.begin());
    return near;
  }

  std::size_t part_of(double number) const override
  {
    constexpr double uneven = 1.1; // parts differ, and each has some bubbles of others
    return static_cast<std::size_t>(uneven * number / m_comm.size());
  }

  void start_growth(Crystal_2& crystal, std::size_t expected) override
  {
    const Bubbles_2& b = crystal.bubbles();
    const std::size_t all = crystal.size() + expected;
    crystal.make_room_for_births(all);
    reserve_each(all, m_owner, m_places, m_key);
    for (std::size_t i = 0; i < b.size(); ++i)
      enter(crystal, Growth_birth_2{0, static_cast<double>(m_numbers[i]), b.x[i], b.y[i]}, b.d[i], 0, no_index);
    for (std::size_t i = 0, n = b.size(); i < n; ++i)
      tell_those_who_need(crystal, static_cast<Index>(i));
    std::vector<Growth_proposal_2> late; // beside larger bubbles of this rank; they have their turn
    exchange_late(crystal, late);
  }

  double start_generation(double key) override
  {
    const double result = m_comm.smallest(m_comm.has_failed() ? -1. : key);
    if (result < 0)
      m_comm.agree();
    ++m_generation;
    return result;
  }

  void take(const std::vector<Growth_proposer>& generation) override
  {
    for (const Growth_proposer& p : generation)
      m_key[p.index] = -1;
  }

  bool owns(Index i) const override { return m_owner[i] == m_comm.rank(); }

  void share_proposals(std::vector<Growth_proposal_2>& proposals) override
  {
    const std::size_t own = proposals.size();
    m_candidates = share_around(m_comm, reach, proposals, [this](const Growth_proposal_2& p, double radius) {
      return owners_within(p.x, p.y, radius, p.from);
    });
    for (std::size_t k = own; k < proposals.size(); ++k)
      proposals[k].from = foreign;
  }

  /// Others' proposals were told for the sake of ours as well: such bubbles come in late if they are needed.
  void forget_far(std::vector<Growth_proposal_2>& bubbles) const override
  {
    const auto is_far = [this](const Growth_proposal_2& p) {
      const auto owners = owners_within(p.x, p.y, reach * p.d, p.from);
      return !owners.empty() && !is_among(owners, m_comm.rank());
    };
    bubbles.erase(std::remove_if(bubbles.begin(), bubbles.end(), is_far), bubbles.end());
  }

  void complete(Crystal_2& crystal, std::vector<Growth_proposal_2>& bubbles) override
  {
    m_first = static_cast<Index>(crystal.size() - bubbles.size());
    for (const Growth_proposal_2& p : bubbles)
      enter(crystal, Growth_birth_2{m_generation, p.misfit, p.x, p.y}, p.d, p.key, p.from);
    for (Index i = m_first, n = static_cast<Index>(crystal.size()); i < n; ++i)
      tell_those_who_need(crystal, i);
    exchange_late(crystal, bubbles);
    list_new(crystal);
  }

  void share_settled(std::vector<Point>& settled) override { share_values(m_comm, m_new, settled); }

  /// A bubble has its place and its size. Where d jumps, it may be larger than it was thought to be.
  void enter_front(const Crystal_2& crystal, Index i, double key) override
  {
    m_key[i] = key;
    const Bubbles_2& b = crystal.bubbles();
    if (!owns(i))
      return;
    const auto owners = owners_within(b.x[i], b.y[i], needed_reach * b.d[i], i);
    if (std::any_of(owners.begin(), owners.end(), [&](int rank) { return !has(i, rank); }))
      m_grown.push_back(i);
  }

  /// Makes bubbles that have grown known to those who need them, and others to them; adds those that come to this rank.
  void catch_up(Crystal_2& crystal, std::vector<Growth_proposal_2>& late) override
  {
    if (!m_comm.any(!m_grown.empty()))
      return;
    const Bubbles_2& b = crystal.bubbles();
    for (Index i : m_grown)
      for (int rank : m_partition->owners_in_disc(b.x[i], b.y[i], reach * b.d[i]))
        send_late(crystal, i, rank);
    m_grown.clear();
    exchange_late(crystal, late);
    // whoever has one that has grown knows what it needs
    for (std::size_t i = m_number_of_common, n = crystal.size(); i < n; ++i)
      if (m_key[i] >= 0)
        tell_those_who_need(crystal, static_cast<Index>(i));
    exchange_late(crystal, late);
  }

private:
  /// A bubble of a face that is there before the growth begins, and its place among all such.
  struct Seed
  {
    double x, y, d;
    double direction; // angle of the lattice
    std::int64_t number;
    Index triangle;   // of the domain
  };

  /// a bubble that another rank needs only now
  struct Late
  {
    Growth_birth_2 birth;
    Growth_proposal_2 bubble; ///< as it is now; the key is negative if it has left the front; `triangle`: the host
    Bubbles_2::Dimension dimension;
    char turn;
  };

  /// where a bubble came in, and how far from there nothing belongs to other ranks; 0 if that is not known
  struct Place
  {
    double x, y, clearance;
  };

  /// In sizes of the larger of two bubbles: links and proposals depend on what is nearer than the first, and
  /// until they have settled bubbles may come nearer to each other.
  static constexpr double needed_reach = 2.8, reach = 3.6;

  /// instead of the bubble that proposes, if another rank owns it
  static constexpr Index foreign = (std::numeric_limits<Index>::max)();

  /// how far from (x, y) all is of this rank, as far as that is known from `parent`, a bubble nearby, or none
  double clearance_at(double x, double y, Index parent) const
  {
    if (parent == no_index || parent == foreign || m_places[parent].clearance == 0)
      return 0;
    const Place& p = m_places[parent];
    constexpr double rounding = 1e-9;
    return (std::max)(0., (1 - rounding) * p.clearance - length_at_most(x - p.x, y - p.y));
  }

  /// looks ahead, for all that come after it
  double find_clearance(double x, double y, double radius) const
  {
    for (double factor : {4., 1.2})
      if (m_partition->owns_disc(m_comm.rank(), x, y, factor * radius))
        return factor * radius;
    return 0;
  }

  /// the ranks of which something lies within `radius`, none if it is known to be this one only
  Hilbert_partition_2::Ranks owners_within(double x, double y, double radius, Index parent) const
  {
    if (clearance_at(x, y, parent) >= radius)
      return {};
    return m_partition->owners_in_disc(x, y, radius);
  }

  /// the next bubble of the crystal comes in: it is known within `reach`, by its owner and those whose parts are near
  void enter(Crystal_2& crystal, const Growth_birth_2& birth, double d, double key, Index parent)
  {
    const Index i = static_cast<Index>(m_owner.size());
    double clearance = clearance_at(birth.x, birth.y, parent);
    if (clearance < reach * d)
      clearance = find_clearance(birth.x, birth.y, reach * d);
    m_places.push_back(Place{birth.x, birth.y, clearance});
    m_owner.push_back(clearance > 0 ? m_comm.rank() : m_partition->owner(birth.x, birth.y));
    m_key.push_back(key);
    crystal.add_birth(birth);
    if (clearance == 0 && owns(i))
      for (int rank : m_partition->owners_in_disc(birth.x, birth.y, reach * d))
        add_holder(i, rank);
  }

  bool has(Index i, int rank) const
  {
    const auto holders = m_holders.find(i);
    return rank == m_comm.rank() || (holders != m_holders.end() && is_among(holders->second, rank));
  }

  /// returns whether it is a new one
  bool add_holder(Index i, int rank) { return rank != m_comm.rank() && add_once(m_holders[i], rank); }

  /// Tells of a bubble of ours the owners of larger ones near it, and the owner of another's of those of ours
  /// that are smaller and near it.
  void tell_those_who_need(const Crystal_2& crystal, Index i)
  {
    const Bubbles_2& b = crystal.bubbles();
    const double least = (std::max)(b.d[i], m_places[i].clearance / reach);
    const auto tell = [&](Index ours, Index others) {
      if (owns(ours) && !owns(others))
        send_late(crystal, ours, m_owner[others]);
      return true;
    };
    if (owns(i))
      crystal.buckets().for_each_large(b.x[i], b.y[i], least, reach,
                                       [&](const auto& e, double) { return tell(i, e.id); });
    else
      crystal.buckets().for_each_within(b.x[i], b.y[i], reach * b.d[i],
                                        [&](const auto& e, double) { return tell(e.id, i); });
  }

  void send_late(const Crystal_2& crystal, Index i, int rank)
  {
    if (!add_holder(i, rank))
      return;
    const Bubbles_2& b = crystal.bubbles();
    const bool is_new = crystal.birth(i).generation == m_generation;
    m_late[rank].push_back(Late{crystal.birth(i), Growth_proposal_2{0, m_key[i], b.x[i], b.y[i], b.d[i],
                                                                    crystal.direction(i), b.host[i],
                                                                    is_new ? foreign : no_index},
                               static_cast<Bubbles_2::Dimension>(b.dimension[i]), crystal.turn(i)});
  }

  /// adds the bubbles that this rank gets to know to the crystal and to `bubbles`
  void exchange_late(Crystal_2& crystal, std::vector<Growth_proposal_2>& bubbles)
  {
    deliver(m_comm, m_late, [&](int, const Late& late) {
      const Growth_proposal_2& p = late.bubble;
      crystal.add_known(Point(p.x, p.y), p.d, late.dimension, p.triangle, p.direction, late.turn);
      enter(crystal, late.birth, p.d, p.key, no_index);
      bubbles.push_back(p);
    });
    m_late.clear();
  }

  /// who tells whom where new bubbles settle, which are counted from the first
  void list_new(const Crystal_2& crystal)
  {
    m_new = {};
    for (std::size_t i = static_cast<std::size_t>(m_first); i < crystal.size(); ++i) {
      const Index index = static_cast<Index>(i);
      if (crystal.birth(i).generation != m_generation)
        continue;
      if (!owns(index))
        m_new.received[m_owner[i]].push_back(index - m_first);
      else if (const auto holders = m_holders.find(index); holders != m_holders.end())
        for (int rank : holders->second)
          m_new.sent[rank].push_back(index - m_first);
    }
    for (auto* lists : {&m_new.sent, &m_new.received})
      for (auto& list : *lists)
        std::sort(list.second.begin(), list.second.end(),
                  [&](Index i, Index j) { return crystal.came_before(m_first + i, m_first + j); });
  }

  std::unique_ptr<Hilbert_partition_2> m_division;
  std::vector<int> m_owner;     // of each bubble: the rank in whose part it came in
  std::vector<Place> m_places;
  std::unordered_map<Index, Hilbert_partition_2::Ranks> m_holders; // the other ranks that have a bubble of ours
  std::vector<double> m_key;    // in the front; negative if it has left it
  std::size_t m_number_of_common = 0; // as far as they are kept here
  std::vector<std::int64_t> m_seeds;   // numbers of those that this rank has, in the order of the crystal's bubbles
  std::vector<std::int64_t> m_numbers; // of all that are there before the growth begins
  std::int64_t m_generation = 0;
  std::vector<Index> m_grown;   // of ours, not known to all that need them
  Messages<Late> m_late;
  // of the present generation
  Index m_first = 0; // of the new bubbles
  Shared_lists m_new;
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_PLACEMENT_PLACEMENT_TEAM_2_H
