// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_CHOICE_EXCHANGE_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_CHOICE_EXCHANGE_2_H

#include <CGAL/Bubble_relaxation_2/internal/Distributed/Communicator.h>
#include <CGAL/Bubble_relaxation_2/internal/Distributed/exchange_known.h>
#include <CGAL/Bubble_relaxation_2/internal/Distributed/sparse_exchange.h>
#include <CGAL/Bubble_relaxation_2/internal/Flat_triangulation_2.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// A greedy choice that several ranks make together, each of its own candidates. Each rank guesses what others
/// choose, is told, and chooses again as long as any guess was wrong. When none is, all is as one rank alone would
/// have chosen, by induction from the best candidate to the worst.
class Choice_exchange_2
{
public:
  explicit Choice_exchange_2(const Communicator& comm) : m_comm(comm) {}

  /// starts anew, with as many candidates of ours
  void start(std::size_t number_of_ours)
  {
    m_number_of_ours = static_cast<Index>(number_of_ours);
    m_sent.clear();
    m_received.clear();
  }

  void sent(int rank, Index candidate) { m_sent[rank].push_back(candidate); }
  void received(int rank, Index candidate) { m_received[rank].push_back(candidate); }

  template <class Choice>
  void decide(Choice& choice) const
  {
    choice.decide([](Index) { return true; });
    Messages<char> out, in;
    for (const auto& received : m_received)
      in[received.first].resize(received.second.size());
    for (bool was_wrong = true; was_wrong; was_wrong = m_comm.any(was_wrong)) {
      for (const auto& sent : m_sent) {
        out[sent.first].clear();
        for (Index k : sent.second)
          out[sent.first].push_back(choice.is_chosen(k));
      }
      exchange_known(m_comm, out, in);
      was_wrong = take_decisions(in, choice);
      if (was_wrong)
        choice.decide([this](Index k) { return k < m_number_of_ours; });
    }
  }

private:
  template <class Choice>
  bool take_decisions(const Messages<char>& in, Choice& choice) const
  {
    bool was_wrong = false;
    for (const auto& received : m_received)
      for (std::size_t n = 0; n < received.second.size(); ++n) {
        const Index k = received.second[n];
        const bool value = in.at(received.first)[n] != 0;
        was_wrong = was_wrong || choice.is_chosen(k) != value;
        choice.set_chosen(k, value);
      }
    return was_wrong;
  }

  const Communicator& m_comm;
  Index m_number_of_ours = 0;
  Messages<Index> m_sent, m_received; // candidates, in one order on both sides
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_CHOICE_EXCHANGE_2_H
