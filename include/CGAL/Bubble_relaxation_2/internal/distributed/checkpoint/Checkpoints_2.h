// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_CHECKPOINT_CHECKPOINTS_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_CHECKPOINT_CHECKPOINTS_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/in_words.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/input/read_same_input.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/parts/distribute_bubbles.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Problem_2.h>
#include <CGAL/Bubble_relaxation_2/internal/simulation/Simulation_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <stdexcept>
#include <string>
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

/// what the report counts: what all ranks count alike comes first
inline std::array<std::size_t*, 9> counts_of(Report& report)
{
  const auto of_rank = counts_of_rank(report);
  return {{&report.number_of_initial_bubbles, &report.number_of_rounds, &report.number_of_steps,
           &report.number_of_force_evaluations, &report.number_of_renewals, of_rank[0], of_rank[1], of_rank[2],
           of_rank[3]}};
}

/// What stands at the beginning of a checkpoint. After it come the states of bubbles, along the curve: so the file has
/// the same bytes for any number of ranks.
struct Checkpoint_header_2
{
  std::array<char, 8> magic{{'N', 'P', 'B', 'S', '2', 'D', '\r', '\n'}};
  std::uint32_t byte_order = 0x01020304, version = 1;
  std::int64_t record_size = sizeof(Bubble_state_2), number_of_records = 0;
  std::uint64_t hash_of_records = 0, hash_of_domain = 0;
  std::array<double, std::tuple_size<decltype(steering_parameters(Relaxation_options()))>::value> parameters{};
  std::int64_t number_of_all = 0; ///< that ever were, which is the number of the next
  std::int32_t is_coarse = 0, is_roused = 0;
  std::array<std::int64_t, 9> counts{}; ///< of all ranks
  std::uint64_t hash_of_header = 0;              ///< of all before

  std::int64_t offset(std::int64_t record) const { return std::int64_t(sizeof *this) + record * record_size; }

  std::uint64_t own_hash() const
  {
    Hash_of_numbers hash;
    hash.add_bytes(this, sizeof *this - sizeof hash_of_header);
    return hash.value();
  }
};

static_assert(sizeof(Checkpoint_header_2) == 8 * 18 + sizeof(Checkpoint_header_2::parameters), "there must be no gaps");

/// All that bubbles refer to by indices: the outline, its triangles, and pinned vertices.
inline std::uint64_t hash_of_places(const Domain_2& domain, const Given_mesh_2& given)
{
  Hash_of_numbers hash;
  hash.add(hash_of(domain));
  hash.add(domain.triangulation().vertices);
  hash.add(given.pinned);
  return hash.value();
}

/// The sum modulo 2^64 over records at their positions among all, so that it does not matter who adds which.
inline std::uint64_t hash_of(const std::vector<Bubble_state_2>& states, std::int64_t position)
{
  std::uint64_t sum = 0;
  for (const Bubble_state_2& s : states) {
    Hash_of_numbers hash;
    hash.add(position++);
    hash.add_bytes(&s, sizeof s);
    sum += hash.value();
  }
  return sum;
}

/// The checkpoints of a simulation by several ranks: when they are written, and the one that it started with. All
/// members are collective, and what fails on one rank is thrown on all.
class Checkpoints_2
{
public:
  /// \throws std::invalid_argument if no checkpoint can be written where it is to be
  Checkpoints_2(Communicator& comm, std::uint64_t hash_of_domain, const Relaxation_options& options)
    : m_comm(comm), m_hash_of_domain(hash_of_domain), m_options(options),
      m_unfinished(options.checkpoint_path + ".part")
  {
    Hash_of_numbers hash;
    hash.add(options.rounds_per_checkpoint);
    for (const std::string& path : {options.checkpoint_path, options.restart_path})
      hash.add_bytes(path.c_str(), path.size() + 1);
    check_same(comm, hash.value(), "the parameter checkpoint or restart_from is not the same on all ranks");
    comm.agree_after([&] {
      if (options.rounds_per_checkpoint == 0 || comm.rank() != 0)
        return;
      if (!std::ofstream(m_unfinished, std::ios::app))
        throw std::invalid_argument("Bubble_relaxation_2: parameter checkpoint = " + options.checkpoint_path +
                                    ": the file " + m_unfinished + " cannot be written");
      std::remove(m_unfinished.c_str());
    });
  }

  bool is_restart() const { return !m_options.restart_path.empty(); }

  /// Reads this rank's bubbles, sorted by numbers. `resume()` brings back the rest.
  /// \throws std::runtime_error if the file is not whole, std::invalid_argument if it is not of this simulation
  Placed_part_2 read(const Hilbert_curve_2& curve, const Sizes_2& sizes)
  {
    std::vector<Bubble_state_2> states;
    std::int64_t first = 0;
    m_comm.agree_after([&] {
      std::ifstream in(m_options.restart_path, std::ios::binary);
      read_header(in);
      first = m_header.number_of_records * m_comm.rank() / m_comm.size();
      states.resize(std::size_t(m_header.number_of_records * (m_comm.rank() + 1) / m_comm.size() - first));
      read_bytes(in, m_header.offset(first), states.data(), std::int64_t(states.size() * sizeof(Bubble_state_2)));
    });
    const bool is_whole = m_comm.sum(hash_of(states, first)) == m_header.hash_of_records;
    m_comm.agree_after([&] {
      if (!is_whole)
        refuse<std::runtime_error>("was altered: its records have another checksum");
      check_sizes(states, sizes);
    });
    const auto key = [&curve](const Bubble_state_2& s) { return curve.key(s.x, s.y); };
    const Hilbert_partition_2 partition = even_partition(m_comm, curve, states, key);
    states = send_home(m_comm, partition, std::move(states));
    std::sort(states.begin(), states.end());
    Bubbles_2 bubbles;
    for (const Bubble_state_2& s : states) {
      add_own(bubbles, s.bubble());
      m_memories.push_back(s.memory());
    }
    return Placed_part_2{std::move(bubbles), partition};
  }

  /// how many bubbles there ever were, in the simulation that goes on
  std::int64_t number_of_all() const { return m_header.number_of_all; }

  /// Brings a simulation of the bubbles that were read, and its report, to where they were.
  void resume(Simulation_2& simulation, Report& report) const
  {
    if (!m_header.is_coarse)
      simulation.rest_finely();
    simulation.restart(m_memories, m_header.is_roused != 0);
    const auto counts = counts_of(report);
    for (std::size_t k = 0; k < counts.size(); ++k)
      if (k < number_of_common || m_comm.rank() == 0) // the others are nobody's
        *counts[k] = static_cast<std::size_t>(m_header.counts[k]);
  }

  /// Writes a checkpoint if it is time, after a round and what it did to the population.
  void end_round(const Simulation_2& simulation, const Bubbles_2& bubbles, const Hilbert_partition_2& partition,
                 std::int64_t number_of_all, Report& report)
  {
    if (m_options.rounds_per_checkpoint == 0 || report.number_of_rounds % m_options.rounds_per_checkpoint != 0)
      return;
    const std::vector<Bubble_state_2> states = along_curve(simulation, bubbles, partition);
    const std::int64_t n = static_cast<std::int64_t>(states.size()), first = m_comm.sum_before(n);
    Checkpoint_header_2 h;
    h.number_of_records = m_comm.sum(n);
    h.hash_of_records = m_comm.sum(hash_of(states, first));
    h.hash_of_domain = m_hash_of_domain;
    for (std::size_t k = 0; k < h.parameters.size(); ++k)
      h.parameters[k] = steering_parameters(m_options)[k].value;
    h.number_of_all = number_of_all;
    h.is_coarse = simulation.rests_coarsely();
    h.is_roused = simulation.is_roused();
    for (std::size_t k = 0; k < h.counts.size(); ++k) {
      const std::int64_t count = static_cast<std::int64_t>(*counts_of(report)[k]);
      h.counts[k] = k < number_of_common ? count : m_comm.sum(count);
    }
    h.hash_of_header = h.own_hash();
    replace_file(h, first, states);
  }

private:
  static constexpr std::size_t number_of_common = 5; // of the counts: those that all ranks count alike

  std::vector<Bubble_state_2> along_curve(const Simulation_2& simulation, const Bubbles_2& bubbles,
                                          const Hilbert_partition_2& partition) const
  {
    std::vector<Bubble_state_2> states;
    for (std::size_t i = 0; i < bubbles.size(); ++i)
      if (bubbles.is_ours(i) && !bubbles.is_gone(i))
        states.push_back(bubble_state(bubbles, i, simulation.memory(static_cast<Index>(i))));
    std::vector<std::pair<Hilbert_curve_2::Key, Bubble_state_2>> places; // equal keys: by numbers
    for (const Bubble_state_2& s : send_home(m_comm, partition, std::move(states)))
      places.emplace_back(partition.curve().key(s.x, s.y), s);
    std::sort(places.begin(), places.end());
    states.clear();
    for (const auto& place : places)
      states.push_back(place.second);
    return states;
  }

  /// \throws std::invalid_argument or std::runtime_error unless it is whole and this simulation could have written it
  void read_header(std::ifstream& in)
  {
    Checkpoint_header_2& h = m_header;
    const Checkpoint_header_2 own;
    const std::int64_t size = in.seekg(0, std::ios::end).tellg(), size_of_header = std::int64_t(sizeof h);
    h.magic = {};
    read_bytes(in, 0, &h, (std::min)(size, size_of_header));
    if (h.magic != own.magic)
      refuse("is no checkpoint of bubbles");
    if (size < size_of_header)
      refuse<std::runtime_error>("is truncated: it has " + std::to_string(size) + " bytes, less than its header");
    if (h.byte_order != own.byte_order)
      refuse("was written on a machine with another order of bytes");
    if (h.version != own.version)
      refuse("has version " + std::to_string(h.version) + " of the format, not " + std::to_string(own.version));
    if (h.hash_of_header != h.own_hash())
      refuse<std::runtime_error>("was altered: its header has another checksum");
    const std::int64_t whole = h.offset(h.number_of_records);
    if (size != whole)
      refuse<std::runtime_error>((size < whole ? "is truncated: it has " : "was altered: it has ") +
                                 std::to_string(size) + " bytes, not " + std::to_string(whole));
    if (h.hash_of_domain != m_hash_of_domain)
      refuse("was written for another domain");
    const auto now = steering_parameters(m_options);
    for (std::size_t k = 0; k < now.size(); ++k)
      if (h.parameters[k] != now[k].value)
        refuse(std::string("was written with another ") + now[k].name + ": " + now[k].text(h.parameters[k]) +
               ", and now it is " + now[k].text(now[k].value));
    const auto rounds = static_cast<std::size_t>(h.counts[1]);
    if (rounds >= m_options.number_of_rounds)
      refuse("was written after " + std::to_string(rounds) + " rounds, and number_of_rounds is " +
             std::to_string(m_options.number_of_rounds));
  }

  void read_bytes(std::ifstream& in, std::int64_t offset, void* bytes, std::int64_t size) const
  {
    if (!in.seekg(offset).read(static_cast<char*>(bytes), size))
      refuse<std::runtime_error>("cannot be read");
  }

  /// A function cannot be written to a file. But each bubble tells what d was at one place.
  void check_sizes(const std::vector<Bubble_state_2>& states, const Sizes_2& sizes) const
  {
    constexpr double rounding = 1e-9; // another compiler's mathematical functions may have another last bit
    for (const Bubble_state_2& s : states) {
      const double d = sizes(s.asked_x, s.asked_y);
      if (m_comm.has_failed())
        return; // the function has thrown
      if (!(std::abs(d - s.d) <= rounding * s.d))
        refuse("was written with another sizing function: at " + in_words(s.asked_x, s.asked_y) + " it was " +
               in_words(s.d) + ", and now it is " + in_words(d));
    }
  }

  template <class Exception = std::invalid_argument>
  [[noreturn]] void refuse(const std::string& why) const
  {
    throw Exception("Bubble_relaxation_2: parameter restart_from = " + m_options.restart_path + ": the file " + why);
  }

  /// The last checkpoint stays until the new one is on the disk: at each moment there is the one file or the other.
  /// `first`: the position of our states among all
  void replace_file(const Checkpoint_header_2& header, std::int64_t first, const std::vector<Bubble_state_2>& states)
  {
    const auto agree = [&](bool has_failed, const std::string& what) {
      m_comm.agree_after([&] {
        if (has_failed)
          throw std::runtime_error("Bubble_relaxation_2: the file " + m_unfinished + " cannot be " + what);
      });
    };
    try {
      const int failure = write_file(header, first, states);
      agree(failure != MPI_SUCCESS, "written: " + mpi_error_text(failure));
      agree(m_comm.rank() == 0 && std::rename(m_unfinished.c_str(), m_options.checkpoint_path.c_str()) != 0,
            "renamed to " + m_options.checkpoint_path);
    } catch (...) { // on all ranks
      if (m_comm.rank() == 0)
        std::remove(m_unfinished.c_str());
      throw;
    }
  }

  /// returns what failed on this rank; all make all calls until the end
  int write_file(const Checkpoint_header_2& header, std::int64_t first, const std::vector<Bubble_state_2>& states)
  {
    MPI_File file = MPI_FILE_NULL;
    int failure = MPI_File_open(m_comm.handle(), m_unfinished.c_str(), MPI_MODE_WRONLY | MPI_MODE_CREATE,
                                MPI_INFO_NULL, &file);
    if (m_comm.any(failure != MPI_SUCCESS))
      return failure;
    const int size = m_comm.rank() == 0 ? int(sizeof header) : 0;
    MPI_Datatype state; // more of them can be written at once than an `int` has bytes
    MPI_Status status;
    int written = 0;
    for (int result : {MPI_Type_contiguous(int(sizeof(Bubble_state_2)), MPI_BYTE, &state), MPI_Type_commit(&state),
                       MPI_File_set_size(file, header.offset(header.number_of_records)), // a crash may have left more
                       MPI_File_write_at_all(file, 0, &header, size, MPI_BYTE, MPI_STATUS_IGNORE),
                       MPI_File_write_at_all(file, header.offset(first), states.data(), int(states.size()), state,
                                             &status),
                       MPI_Get_count(&status, state, &written), MPI_File_sync(file), MPI_File_close(&file),
                       MPI_Type_free(&state)})
      failure = failure == MPI_SUCCESS ? result : failure;
    return failure == MPI_SUCCESS && written != int(states.size()) ? MPI_ERR_NO_SPACE : failure;
  }

  Communicator& m_comm;
  const std::uint64_t m_hash_of_domain;
  const Relaxation_options& m_options;
  const std::string m_unfinished; // where one is written before it takes the place of the last
  Checkpoint_header_2 m_header;   // of the one that was read
  std::vector<Bubble_memory_2> m_memories;
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_CHECKPOINT_CHECKPOINTS_2_H
