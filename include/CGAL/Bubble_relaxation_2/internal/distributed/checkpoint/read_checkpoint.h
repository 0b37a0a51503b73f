// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_CHECKPOINT_READ_CHECKPOINT_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_CHECKPOINT_READ_CHECKPOINT_H

#include <CGAL/Bubble_relaxation_2/internal/core/Sizes_2.h>
#include <CGAL/Bubble_relaxation_2/internal/core/in_words.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/checkpoint/Checkpoint_format_2.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/checkpoint/Shared_file.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/parts/distribute_bubbles.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

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
  Checkpoint_reader_2(const Communicator& comm, Agreement& agreement, const Relaxation_options& options,
                      std::uint64_t hash_of_domain, const Sizes_2& sizing)
    : m_comm(comm), m_agreement(agreement), m_options(options), m_hash_of_domain(hash_of_domain), m_sizing(sizing)
  {}

  /// Collective. Each bubble comes to the rank that owns its place.
  Restart_2 operator()(Sparse_exchange& exchange, const Hilbert_curve_2& curve)
  {
    Shared_file file(m_comm, m_agreement, m_options.restart_path, Shared_file::READ);
    const Checkpoint_header_2 header = read_header(file);
    std::vector<Keyed_checkpoint_record_2> keyed;
    for (const Checkpoint_record_2& r : read_records(file, header))
      keyed.push_back(Keyed_checkpoint_record_2{curve.key(r.x, r.y), r});
    const auto places = places_on_curve(keyed);
    Restart_2 result{header, even_partition(m_comm, curve, places), {}};
    const auto home = bring_home(result.partition, exchange, m_comm.rank(), places);
    for (const auto& place : home.places)
      result.states.push_back(bubble_state(place.record->record));
    std::sort(result.states.begin(), result.states.end());
    return result;
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
    m_agreement.reach_after([&] {
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
    if (header.record_size != static_cast<std::int64_t>(sizeof(Checkpoint_record_2)))
      refuse("has records of " + std::to_string(header.record_size) + " bytes, not " +
             std::to_string(sizeof(Checkpoint_record_2)));
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
        refuse(std::string("was written with another ") + now[k].name + ": " + in_words(header.parameters[k]) +
               ", and now it is " + in_words(now[k].value));
    if (static_cast<std::uint64_t>(header.rounds) >= m_options.number_of_rounds)
      refuse("was written after " + std::to_string(header.rounds) + " rounds, and number_of_rounds is " +
             std::to_string(m_options.number_of_rounds));
  }

  std::vector<Checkpoint_record_2> read_records(Shared_file& file, const Checkpoint_header_2& header)
  {
    const auto first_of = [&](std::int64_t rank) { return header.number_of_records * rank / m_comm.size(); };
    const std::int64_t first = first_of(m_comm.rank()), last = first_of(m_comm.rank() + 1);
    std::vector<Checkpoint_record_2> records;
    m_agreement.reach_after([&] { records.resize(static_cast<std::size_t>(last - first)); });
    file.read(static_cast<std::int64_t>(sizeof(header)) + first * header.record_size, records);
    std::uint64_t hash = 0;
    for (std::size_t k = 0; k < records.size(); ++k)
      hash += hash_of(records[k], first + static_cast<std::int64_t>(k));
    const std::uint64_t hash_of_all = m_comm.sum_modulo(hash);
    m_agreement.reach_after([&] {
      if (hash_of_all != header.hash_of_records)
        tell_damage("was altered: its records have another checksum");
    });
    check_sizes(records);
    return records;
  }

  /// A function cannot be written to a file. But each bubble tells what d was at one place.
  void check_sizes(const std::vector<Checkpoint_record_2>& records)
  {
    constexpr double rounding = 1e-9; // another compiler's mathematical functions may have another last bit
    m_agreement.reach_after([&] {
      for (const Checkpoint_record_2& r : records) {
        const double d = m_sizing(r.asked_x, r.asked_y);
        if (m_agreement.has_failed())
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

  const Communicator& m_comm;
  Agreement& m_agreement;
  const Relaxation_options& m_options;
  std::uint64_t m_hash_of_domain;
  const Sizes_2& m_sizing;
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_CHECKPOINT_READ_CHECKPOINT_H
