// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_WRITE_CHECKPOINT_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_WRITE_CHECKPOINT_H

#include <CGAL/Bubble_relaxation_2/internal/Distributed/Checkpoint_format_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Distributed/Shared_file.h>

#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// where a checkpoint is written before it takes the place of the last one
inline std::string path_of_unfinished(const std::string& path) { return path + ".part"; }

/// Collective. \throws std::invalid_argument on all ranks if no checkpoint can be written there
inline void check_checkpoint_path(const Communicator& comm, Agreement& agreement, const std::string& path)
{
  agreement.reach_after([&] {
    if (comm.rank() != 0)
      return;
    const std::string unfinished = path_of_unfinished(path);
    if (!std::ofstream(unfinished, std::ios::app))
      throw std::invalid_argument("Bubble_relaxation_2: parameter checkpoint = " + path + ": the file " +
                                  unfinished + " cannot be written");
    std::remove(unfinished.c_str());
  });
}

/// Puts a file that is whole into the place of another: at each moment there is the one or the other.
inline void replace_file(const Communicator& comm, Agreement& agreement, const std::string& from,
                         const std::string& to)
{
  agreement.reach_after([&] {
    if (comm.rank() == 0 && std::rename(from.c_str(), to.c_str()) != 0)
      throw std::runtime_error("Bubble_relaxation_2: the file " + from + " cannot be renamed to " + to + ": " +
                               std::error_code(errno, std::generic_category()).message());
  });
}

/// Collective. Writes the records of all ranks. The last checkpoint stays until the new one is on the disk.
/// \param header with all that is not of the records
/// \pre the records of each rank are sorted along the curve, and come before those of the next
inline void write_checkpoint(const Communicator& comm, Agreement& agreement, const std::string& path,
                             Checkpoint_header_2 header, const std::vector<Checkpoint_record_2>& records)
{
  const std::int64_t n = static_cast<std::int64_t>(records.size()), first = comm.sum_before(n);
  std::uint64_t hash = 0;
  for (std::size_t k = 0; k < records.size(); ++k)
    hash += hash_of(records[k], first + static_cast<std::int64_t>(k));
  header.magic = Checkpoint_header_2::own_magic;
  header.byte_order = Checkpoint_header_2::own_byte_order;
  header.version = Checkpoint_header_2::own_version;
  header.record_size = static_cast<std::int64_t>(sizeof(Checkpoint_record_2));
  header.number_of_records = comm.sum(n);
  header.hash_of_records = comm.sum_modulo(hash);
  header.hash_of_header = header.own_hash();

  const std::string unfinished = path_of_unfinished(path);
  Shared_file file(comm, agreement, unfinished, Shared_file::WRITE);
  try {
    file.resize(header.file_size()); // there may be one that was left by a crash
    file.write(0, std::vector<Checkpoint_header_2>(comm.rank() == 0 ? 1 : 0, header));
    file.write(static_cast<std::int64_t>(sizeof(header)) + first * header.record_size, records);
    file.finish();
    replace_file(comm, agreement, unfinished, path);
  } catch (...) { // on all ranks
    if (comm.rank() == 0)
      std::remove(unfinished.c_str());
    throw;
  }
}

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_WRITE_CHECKPOINT_H
