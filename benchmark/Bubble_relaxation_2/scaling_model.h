// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef BUBBLE_RELAXATION_2_BENCHMARK_SCALING_MODEL_H
#define BUBBLE_RELAXATION_2_BENCHMARK_SCALING_MODEL_H

#include "rank_counts.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <string>
#include <vector>

/// What the steps of a simulation would cost on many ranks: a model, since no machine at hand has them. Of counts on
/// many ranks those are taken where a rank has about as many bubbles. Ghosts and bytes grow from there with the length
/// of the border of a rank's part, the root of its number of bubbles, and ranks have as many neighbours, moves of a
/// bubble, and imbalance of moves as they have in the counts; the time of a move is measured on one rank. Nothing
/// is taken to overlap. Efficiency is printed as it would be with as many moves on each rank, and with their
/// imbalance. The placement, the control of the population, the treatment and the statistics are left out.
class Scaling_model
{
public:
  /// \name Assumptions
  /// @{
  static constexpr double latency = 2e-6;            ///< seconds of a message, and of each level of a reduction
  static constexpr double bytes_per_second = 25e9;   ///< of a node, in and out
  static constexpr int ranks_of_node = 64;           ///< that share it
  /// @}

  /// `counts`: with many ranks, of few bubbles and of many; `seconds_of_move`: of one bubble in one step, with its share
  /// of renewals
  Scaling_model(const std::vector<Rank_counts>& counts, double seconds_of_move)
    : m_counts(counts), m_seconds_of_move(seconds_of_move)
  {}

  static void print_assumptions()
  {
    std::cout << "\nmodel of the steps, with assumed latency " << std::setprecision(1) << 1e6 * latency
              << " us, bandwidth " << bytes_per_second / 1e9 << " GB/s for each " << ranks_of_node
              << " ranks, and no overlap; nothing is measured but counts and the time of a move, here in us\n"
              << std::left << std::setw(20) << "domain" << std::right << std::setw(9) << "N" << std::setw(9) << "ranks"
              << std::setw(10) << "bubbles" << std::setw(8) << "a move" << std::setw(13) << "compute, us"
              << std::setw(9) << "ghosts" << std::setw(13) << "messages, us" << std::setw(11) << "bytes, us"
              << std::setw(15) << "reduction, us"
              << std::setw(12) << "efficiency" << std::setw(13) << "unbalanced\n";
  }

  void print(const std::string& domain, double n, double ranks) const
  {
    const double own = n / ranks;
    const Rank_counts& c = counts_near(own);
    const double growth = std::sqrt(own / c.bubbles.mean);
    const double moves = c.all_moves / (c.steps * c.bubbles.mean * c.number_of_ranks); // of a bubble in a step
    const double compute = own * moves * m_seconds_of_move;
    const double messages = c.messages.mean * latency;
    const double bytes = c.bytes.mean * growth / (bytes_per_second / ranks_of_node);
    const double reduction = latency * std::ceil(std::log2(ranks));
    const double others = messages + bytes + reduction;
    std::cout << std::left << std::setw(20) << domain << std::right << std::scientific << std::setprecision(0)
              << std::setw(9) << n << std::setw(9) << ranks << std::setw(10) << own << std::fixed
              << std::setprecision(3) << std::setw(8) << 1e6 * m_seconds_of_move
              << std::setprecision(1) << std::setw(13) << 1e6 * compute << std::setprecision(0) << std::setw(9)
              << c.ghosts.mean * growth << std::setprecision(1) << std::setw(13) << 1e6 * messages
              << std::setw(11) << 1e6 * bytes << std::setw(15) << 1e6 * reduction << std::setprecision(2)
              << std::setw(12) << compute / (compute + others) << std::setw(12)
              << compute / (compute * c.moves.imbalance() + others) << '\n';
  }

private:
  /// those with a number of bubbles of a rank that is the least times more or less
  const Rank_counts& counts_near(double own) const
  {
    const auto far = [own](const Rank_counts& c) { return std::abs(std::log(c.bubbles.mean / own)); };
    return *std::min_element(m_counts.begin(), m_counts.end(),
                             [&far](const Rank_counts& c, const Rank_counts& d) { return far(c) < far(d); });
  }

  std::vector<Rank_counts> m_counts;
  double m_seconds_of_move;
};

#endif // BUBBLE_RELAXATION_2_BENCHMARK_SCALING_MODEL_H
