// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_CHECKPOINT_CHECKPOINTS_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_CHECKPOINT_CHECKPOINTS_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/Sizes_2.h>
#include <CGAL/Bubble_relaxation_2/internal/core/in_words.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/checkpoint/Checkpoint_file_2.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/input/read_same_input.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/parts/distribute_bubbles.h>
#include <CGAL/Bubble_relaxation_2/internal/simulation/Simulation_2.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <string>
#include <system_error>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// what each rank counts for itself
inline std::array<std::size_t*, 4> counts_of_rank(Report& report)
{
  return {{&report.number_of_moves, &report.number_of_returns, &report.number_of_insertions,
           &report.number_of_deletions}};
}

/// what a simulation goes on with on one rank
struct Restart_2
{
  Checkpoint_header_2 header;
  Hilbert_partition_2 partition;
  std::vector<Bubble_state_2> states; ///< sorted by numbers
};

/// Reads a checkpoint by any number of ranks, and refuses one that is not whole, or not of this simulation.
class Checkpoint_reader_2
{
public:
  Checkpoint_reader_2(Communicator& comm, const Relaxation_options& options, std::uint64_t hash_of_domain,
                      const Sizes_2& sizing)
    : m_comm(comm), m_options(options), m_hash_of_domain(hash_of_domain), m_sizing(sizing)
  {}

  /// Collective. Each bubble comes to the rank that owns its place.
  Restart_2 operator()(const Hilbert_curve_2& curve)
  {
    Shared_file file(m_comm, m_options.restart_path, Shared_file::READ);
    const Checkpoint_header_2 header = read_header(file);
    std::vector<Bubble_state_2> states = read_records(file, header);
    std::vector<Hilbert_curve_2::Key> keys;
    for (const Bubble_state_2& state : states)
      keys.push_back(curve.key(state.x, state.y));
    std::sort(keys.begin(), keys.end());
    const Hilbert_partition_2 partition = even_partition(m_comm, curve, keys);
    states = send_home(m_comm, partition, std::move(states));
    std::sort(states.begin(), states.end());
    return Restart_2{header, partition, std::move(states)};
  }

private:
  Checkpoint_header_2 read_header(Shared_file& file)
  {
    const std::int64_t size = file.size();
    std::vector<char> bytes(static_cast<std::size_t>(
      (std::min)(size, static_cast<std::int64_t>(sizeof(Checkpoint_header_2)))));
    file.read(0, bytes);
    Checkpoint_header_2 header{};
    std::copy(bytes.begin(), bytes.end(), reinterpret_cast<char*>(&header));
    m_comm.agree_after([&] {
      check_format(header, size);
      check_origin(header);
    });
    return header;
  }

  void check_format(const Checkpoint_header_2& header, std::int64_t size) const
  {
    if (header.magic != Checkpoint_header_2::own_magic)
      refuse("is no checkpoint of bubbles");
    if (size < static_cast<std::int64_t>(sizeof(header)))
      tell_damage("is truncated: it has " + std::to_string(size) + " bytes, less than its header");
    if (header.byte_order != Checkpoint_header_2::own_byte_order)
      refuse("was written on a machine with another order of bytes");
    if (header.version != Checkpoint_header_2::own_version)
      refuse("has version " + std::to_string(header.version) + " of the format, not " +
             std::to_string(Checkpoint_header_2::own_version));
    if (header.hash_of_header != header.own_hash())
      tell_damage("was altered: its header has another checksum");
    if (header.record_size != static_cast<std::int64_t>(sizeof(Bubble_state_2)))
      refuse("has records of " + std::to_string(header.record_size) + " bytes, not " +
             std::to_string(sizeof(Bubble_state_2)));
    if (size != header.file_size())
      tell_damage((size < header.file_size() ? "is truncated: it has " : "was altered: it has ") +
                  std::to_string(size) + " bytes, not " + std::to_string(header.file_size()));
  }

  /// whether it was written by a simulation that this one could have been
  void check_origin(const Checkpoint_header_2& header) const
  {
    if (header.hash_of_domain != m_hash_of_domain)
      refuse("was written for another domain");
    const auto now = steering_parameters(m_options);
    for (std::size_t k = 0; k < now.size(); ++k)
      if (header.parameters[k] != now[k].value)
        refuse(std::string("was written with another ") + now[k].name + ": " + now[k].text(header.parameters[k]) +
               ", and now it is " + now[k].text(now[k].value));
    if (static_cast<std::uint64_t>(header.rounds) >= m_options.number_of_rounds)
      refuse("was written after " + std::to_string(header.rounds) + " rounds, and number_of_rounds is " +
             std::to_string(m_options.number_of_rounds));
  }

  std::vector<Bubble_state_2> read_records(Shared_file& file, const Checkpoint_header_2& header)
  {
    const auto first_of = [&](std::int64_t rank) { return header.number_of_records * rank / m_comm.size(); };
    const std::int64_t first = first_of(m_comm.rank()), last = first_of(m_comm.rank() + 1);
    std::vector<Bubble_state_2> records;
    m_comm.agree_after([&] { records.resize(static_cast<std::size_t>(last - first)); });
    file.read(static_cast<std::int64_t>(sizeof(header)) + first * header.record_size, records);
    std::uint64_t hash = 0;
    for (std::size_t k = 0; k < records.size(); ++k)
      hash += hash_of(records[k], first + static_cast<std::int64_t>(k));
    const std::uint64_t hash_of_all = m_comm.sum(hash);
    m_comm.agree_after([&] {
      if (hash_of_all != header.hash_of_records)
        tell_damage("was altered: its records have another checksum");
    });
    check_sizes(records);
    return records;
  }

  /// A function cannot be written to a file. But each bubble tells what d was at one place.
  void check_sizes(const std::vector<Bubble_state_2>& records)
  {
    constexpr double rounding = 1e-9; // another compiler's mathematical functions may have another last bit
    m_comm.agree_after([&] {
      for (const Bubble_state_2& r : records) {
        const double d = m_sizing(r.asked_x, r.asked_y);
        if (m_comm.has_failed())
          return; // the function has thrown
        if (!(std::abs(d - r.d) <= rounding * r.d))
          refuse("was written with another sizing function: at " + in_words(r.asked_x, r.asked_y) + " it was " +
                 in_words(r.d) + ", and now it is " + in_words(d));
      }
    });
  }

  [[noreturn]] void refuse(const std::string& why) const
  {
    throw std::invalid_argument("Bubble_relaxation_2: parameter restart_from = " + m_options.restart_path +
                                ": the file " + why);
  }

  [[noreturn]] void tell_damage(const std::string& what) const
  {
    throw std::runtime_error("Bubble_relaxation_2: the checkpoint " + m_options.restart_path + " " + what);
  }

  Communicator& m_comm;
  const Relaxation_options& m_options;
  std::uint64_t m_hash_of_domain;
  const Sizes_2& m_sizing;
};

/// where a checkpoint is written before it takes the place of the last one
inline std::string path_of_unfinished(const std::string& path) { return path + ".part"; }

/// Collective. \throws std::invalid_argument on all ranks if no checkpoint can be written there
inline void check_checkpoint_path(Communicator& comm, const std::string& path)
{
  comm.agree_after([&] {
    if (comm.rank() != 0)
      return;
    const std::string unfinished = path_of_unfinished(path);
    if (!std::ofstream(unfinished, std::ios::app))
      throw std::invalid_argument("Bubble_relaxation_2: parameter checkpoint = " + path + ": the file " +
                                  unfinished + " cannot be written");
    std::remove(unfinished.c_str());
  });
}

/// Collective. Writes the records of all ranks. The last checkpoint stays until the new one is on the disk.
/// \param header with all that is not of the records
/// \pre the records of each rank are sorted along the curve, and come before those of the next
inline void write_checkpoint(Communicator& comm, const std::string& path, Checkpoint_header_2 header,
                             const std::vector<Bubble_state_2>& records)
{
  const std::int64_t n = static_cast<std::int64_t>(records.size()), first = comm.sum_before(n);
  std::uint64_t hash = 0;
  for (std::size_t k = 0; k < records.size(); ++k)
    hash += hash_of(records[k], first + static_cast<std::int64_t>(k));
  header.magic = Checkpoint_header_2::own_magic;
  header.byte_order = Checkpoint_header_2::own_byte_order;
  header.version = Checkpoint_header_2::own_version;
  header.record_size = static_cast<std::int64_t>(sizeof(Bubble_state_2));
  header.number_of_records = comm.sum(n);
  header.hash_of_records = comm.sum(hash);
  header.hash_of_header = header.own_hash();

  const std::string unfinished = path_of_unfinished(path);
  Shared_file file(comm, unfinished, Shared_file::WRITE);
  try {
    file.resize(header.file_size()); // there may be one that was left by a crash
    file.write(0, std::vector<Checkpoint_header_2>(comm.rank() == 0 ? 1 : 0, header));
    file.write(static_cast<std::int64_t>(sizeof(header)) + first * header.record_size, records);
    file.finish();
    comm.agree_after([&] { // at each moment there is the one file or the other
      if (comm.rank() == 0 && std::rename(unfinished.c_str(), path.c_str()) != 0)
        throw std::runtime_error("Bubble_relaxation_2: the file " + unfinished + " cannot be renamed to " + path +
                                 ": " + std::error_code(errno, std::generic_category()).message());
    });
  } catch (...) { // on all ranks
    if (comm.rank() == 0)
      std::remove(unfinished.c_str());
    throw;
  }
}

/// The checkpoints of a simulation by several ranks: when they are written, and the one that it started with.
class Checkpoints_2
{
public:
  /// Collective. \throws std::invalid_argument on all ranks if no checkpoint can be written where it is to be
  Checkpoints_2(Communicator& comm, std::uint64_t hash_of_domain, const Relaxation_options& options)
    : m_comm(comm), m_hash_of_domain(hash_of_domain), m_options(options)
  {
    check_same(comm, hash_of(options), "the parameter checkpoint or restart_from is not the same on all ranks");
    if (options.rounds_per_checkpoint != 0)
      check_checkpoint_path(comm, options.checkpoint_path);
  }

  bool is_restart() const { return !m_options.restart_path.empty(); }

  /// Reads the bubbles of this rank. What the simulation remembers of them is kept for `resume()`.
  const Restart_2& read(const Hilbert_curve_2& curve, const Sizes_2& sizing)
  {
    Checkpoint_reader_2 reader(m_comm, m_options, m_hash_of_domain, sizing);
    m_restart = std::make_unique<Restart_2>(reader(curve));
    return *m_restart;
  }

  /// brings a simulation of these bubbles, and its report, to where they were; returns the rounds until then
  std::size_t resume(Simulation_2& simulation, Report& report)
  {
    const Checkpoint_header_2& h = m_restart->header;
    if (!h.is_coarse)
      simulation.rest_finely();
    std::vector<Bubble_memory_2> memories;
    for (const Bubble_state_2& s : m_restart->states)
      memories.push_back(s.memory());
    simulation.restart(memories, h.is_roused != 0);
    report.number_of_rounds = static_cast<std::size_t>(h.rounds);
    report.number_of_steps = static_cast<std::size_t>(h.steps);
    report.number_of_force_evaluations = static_cast<std::size_t>(h.force_evaluations);
    report.number_of_renewals = static_cast<std::size_t>(h.renewals);
    if (m_comm.rank() == 0) // each rank counts its own, and these are nobody's
      for (std::size_t k = 0; k < 4; ++k)
        *counts_of_rank(report)[k] = static_cast<std::size_t>(h.moves_returns_insertions_deletions[k]);
    const std::size_t rounds = report.number_of_rounds;
    m_restart.reset();
    return rounds;
  }

  /// Collective. Writes a checkpoint if it is time, after a round and what it did to the population.
  void end_round(const Simulation_2& simulation, const Bubbles_2& bubbles, const Hilbert_partition_2& partition,
                 std::int64_t number_of_all, Report& report)
  {
    if (m_options.rounds_per_checkpoint == 0 || report.number_of_rounds % m_options.rounds_per_checkpoint != 0)
      return;
    std::vector<Bubble_state_2> states;
    for (std::size_t i = 0; i < bubbles.size(); ++i)
      if (bubbles.is_ours(i) && !bubbles.is_gone(i))
        states.push_back(bubble_state(bubbles, i, simulation.memory(static_cast<Index>(i))));
    states = along_curve(partition.curve(), send_home(m_comm, partition, std::move(states)));
    write_checkpoint(m_comm, m_options.checkpoint_path, header(simulation, number_of_all, report), states);
  }

private:
  /// so that the file is the same for any number of ranks
  static std::vector<Bubble_state_2> along_curve(const Hilbert_curve_2& curve,
                                                 const std::vector<Bubble_state_2>& states)
  {
    std::vector<std::tuple<Hilbert_curve_2::Key, double, double, std::int64_t, std::size_t>> order;
    for (std::size_t k = 0; k < states.size(); ++k)
      order.emplace_back(curve.key(states[k].x, states[k].y), states[k].x, states[k].y, states[k].id, k);
    std::sort(order.begin(), order.end());
    std::vector<Bubble_state_2> result;
    for (const auto& place : order)
      result.push_back(states[std::get<4>(place)]);
    return result;
  }

  static std::uint64_t hash_of(const Relaxation_options& options)
  {
    Hash_of_numbers hash;
    hash.add(options.rounds_per_checkpoint);
    for (const std::string& path : {options.checkpoint_path, options.restart_path})
      for (std::size_t k = 0; k <= path.size(); ++k) // and the zero at its end
        hash.add(path.c_str()[k]);
    return hash.value();
  }

  Checkpoint_header_2 header(const Simulation_2& simulation, std::int64_t number_of_all, Report& report) const
  {
    Checkpoint_header_2 h{};
    h.hash_of_domain = m_hash_of_domain;
    const auto parameters = steering_parameters(m_options);
    for (std::size_t k = 0; k < parameters.size(); ++k)
      h.parameters[k] = parameters[k].value;
    h.number_of_all = number_of_all;
    h.is_coarse = simulation.rests_coarsely();
    h.is_roused = simulation.is_roused();
    h.initial_bubbles = static_cast<std::int64_t>(report.number_of_initial_bubbles);
    h.rounds = static_cast<std::int64_t>(report.number_of_rounds);
    h.steps = static_cast<std::int64_t>(report.number_of_steps);
    h.force_evaluations = static_cast<std::int64_t>(report.number_of_force_evaluations);
    h.renewals = static_cast<std::int64_t>(report.number_of_renewals);
    for (std::size_t k = 0; k < 4; ++k)
      h.moves_returns_insertions_deletions[k] = m_comm.sum(static_cast<std::int64_t>(*counts_of_rank(report)[k]));
    return h;
  }

  Communicator& m_comm;
  std::uint64_t m_hash_of_domain;
  const Relaxation_options& m_options;
  std::unique_ptr<Restart_2> m_restart;
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_CHECKPOINT_CHECKPOINTS_2_H
