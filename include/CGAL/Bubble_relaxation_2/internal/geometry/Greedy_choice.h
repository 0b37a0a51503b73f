// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_GEOMETRY_GREEDY_CHOICE_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_GEOMETRY_GREEDY_CHOICE_H

#include <CGAL/Bubble_relaxation_2/internal/core/vocabulary.h>

#include <boost/container/small_vector.hpp>

#include <cstddef>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// Chooses among candidates the best first, and none that touches a better one that was chosen: the one rule for all
/// that is deleted or operated on, and in `Hole_choice_2`, without lists of rivals, for all that is inserted. What becomes
/// of a candidate depends on better ones only, its rivals, and is decided when theirs is. So several ranks that each
/// decide on their own candidates, and tell each other what was decided, choose what one of them alone would, see
/// `decide_together()`.
class Greedy_choice
{
public:
  enum State : char { UNDECIDED, REFUSED, CHOSEN };

  using Rivals = boost::container::small_vector<Index, 6>;

  /// starts anew, with candidates among so many things
  void start(std::size_t number_of_things)
  {
    m_states.assign(number_of_things, UNDECIDED);
    m_candidates.clear();
  }

  /// The next candidate to be decided on here, none better than those that were added before; returns its position
  /// among them.
  std::size_t add(Index candidate)
  {
    const std::size_t k = m_candidates.size();
    m_candidates.push_back(candidate);
    if (k == m_rivals.size())
      m_rivals.emplace_back();
    m_rivals[k].clear();
    return k;
  }

  const std::vector<Index>& candidates() const { return m_candidates; }

  /// The better ones in the way of the candidate at a position, whoever decides on them. To be filled in; twice is no
  /// harm.
  Rivals& rivals(std::size_t position) { return m_rivals[position]; }

  /// of all things: what was decided here, and what others told
  std::vector<char>& states() { return m_states; }

  bool is_chosen(Index candidate) const { return m_states[candidate] == CHOSEN; }

  /// Decides on all that can be decided on now: those with a rival that is chosen are refused, and of those whose
  /// rivals are all refused `is_worth_it(candidate)` is asked once. Returns whether any is still undecided.
  template <class Predicate>
  bool decide(const Predicate& is_worth_it)
  {
    return decide_on_each([&](Index c, const Rivals& rivals) -> char {
      bool may_be_chosen = true;
      for (Index r : rivals) {
        if (m_states[r] == CHOSEN)
          return REFUSED;
        may_be_chosen = may_be_chosen && m_states[r] == REFUSED;
      }
      return !may_be_chosen ? UNDECIDED : is_worth_it(c) ? CHOSEN : REFUSED;
    });
  }

  /// The same where it takes more than one rival to refuse: when all are decided, `judge(candidate, rivals)` tells the
  /// state.
  template <class Judge>
  bool decide_by(const Judge& judge)
  {
    return decide_on_each([&](Index c, const Rivals& rivals) -> char {
      for (Index r : rivals)
        if (m_states[r] == UNDECIDED)
          return UNDECIDED;
      return judge(c, rivals);
    });
  }

private:
  /// in order: with no other ranks this is all there is to do
  template <class State_of>
  bool decide_on_each(const State_of& state_of)
  {
    bool is_open = false;
    for (std::size_t k = 0; k < m_candidates.size(); ++k) {
      char& state = m_states[m_candidates[k]];
      if (state == UNDECIDED)
        state = state_of(m_candidates[k], m_rivals[k]);
      is_open = is_open || state == UNDECIDED;
    }
    return is_open;
  }

  std::vector<char> m_states;       // of all things
  std::vector<Index> m_candidates;  // ours, the best first
  std::vector<Rivals> m_rivals;     // of these, and some to be used again
};

/// Decides until nothing is open on any rank. `all`: the ranks; `decide()`: decides on what it can, and returns
/// whether any is left; `share()` puts in the states of candidates on which other ranks decide.
template <class Ranks, class Decide, class Share>
void decide_together(const Ranks& all, const Decide& decide, const Share& share)
{
  for (bool is_open = true; is_open; is_open = all.any(is_open)) {
    is_open = decide();
    share();
  }
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_GEOMETRY_GREEDY_CHOICE_H
