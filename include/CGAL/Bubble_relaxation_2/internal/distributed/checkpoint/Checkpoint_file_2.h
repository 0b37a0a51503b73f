// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_CHECKPOINT_CHECKPOINT_FILE_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_CHECKPOINT_CHECKPOINT_FILE_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/Relaxation_options.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/input/read_same_input.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Communicator.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/parts/bubble_records.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Problem_2.h>

#include <mpi.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <tuple>
#include <type_traits>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// A file that all ranks read or write together. All calls are collective; where one fails on any rank, all ranks
/// throw `std::runtime_error`.
class Shared_file
{
public:
  enum Use { READ, WRITE };

  Shared_file(Communicator& comm, const std::string& path, Use use)
    : m_comm(comm), m_path(path), m_use(use)
  {
    const int mode = use == READ ? MPI_MODE_RDONLY : MPI_MODE_WRONLY | MPI_MODE_CREATE;
    const int result = MPI_File_open(comm.handle(), path.c_str(), mode, MPI_INFO_NULL, &m_file);
    if (comm.any(result != MPI_SUCCESS))
      m_file = MPI_FILE_NULL; // to close it would take all ranks
    check(result);
  }

  ~Shared_file()
  {
    if (m_file != MPI_FILE_NULL)
      MPI_File_close(&m_file);
  }

  Shared_file(const Shared_file&) = delete;
  Shared_file& operator=(const Shared_file&) = delete;

  std::int64_t size()
  {
    MPI_Offset bytes = 0;
    check(MPI_File_get_size(m_file, &bytes));
    return bytes;
  }

  void resize(std::int64_t bytes) { check(MPI_File_set_size(m_file, bytes)); }

  /// fills the records from so many bytes after the beginning
  template <class Record>
  void read(std::int64_t offset, std::vector<Record>& records)
  {
    const Record_type<Record> type;
    const int n = static_cast<int>(records.size());
    MPI_Status status;
    const int result = MPI_File_read_at_all(m_file, offset, records.data(), n, type.handle, &status);
    check(result, result != MPI_SUCCESS || type.count(status) == n);
  }

  template <class Record>
  void write(std::int64_t offset, const std::vector<Record>& records)
  {
    const Record_type<Record> type;
    const int n = static_cast<int>(records.size());
    MPI_Status status;
    const int result = MPI_File_write_at_all(m_file, offset, records.data(), n, type.handle, &status);
    check(result, result != MPI_SUCCESS || type.count(status) == n);
  }

  /// all that was written is on the disk, and the file is closed
  void finish()
  {
    check(MPI_File_sync(m_file));
    check(MPI_File_close(&m_file));
  }

private:
  /// More records than an `int` has bytes can be read and written at once.
  template <class Record>
  struct Record_type
  {
    static_assert(std::is_trivially_copyable<Record>::value, "records are written as bytes");

    Record_type()
    {
      check_mpi(MPI_Type_contiguous(static_cast<int>(sizeof(Record)), MPI_BYTE, &handle));
      check_mpi(MPI_Type_commit(&handle));
    }
    ~Record_type() { MPI_Type_free(&handle); }
    Record_type(const Record_type&) = delete;
    Record_type& operator=(const Record_type&) = delete;

    int count(MPI_Status& status) const
    {
      int n = 0;
      MPI_Get_count(&status, handle, &n);
      return n;
    }

    MPI_Datatype handle;
  };

  void check(int result, bool is_complete = true)
  {
    m_comm.agree_after([&] {
      if (result == MPI_SUCCESS && is_complete)
        return;
      throw std::runtime_error("Bubble_relaxation_2: the file " + m_path + " cannot be " +
                               (m_use == READ ? "read" : "written") + ": " +
                               (is_complete ? mpi_error_text(result) : std::string("it ends too early")));
    });
  }

  Communicator& m_comm;
  std::string m_path;
  Use m_use;
  MPI_File m_file = MPI_FILE_NULL;
};

/// What stands at the beginning of a checkpoint. After it come the states of bubbles, along the curve.
struct Checkpoint_header_2
{
  static constexpr std::uint32_t own_byte_order = 0x01020304, own_version = 1;
  static constexpr std::array<char, 8> own_magic{{'N', 'P', 'B', 'S', '2', 'D', '\r', '\n'}};

  std::array<char, 8> magic;
  std::uint32_t byte_order, version;
  std::int64_t record_size, number_of_records;
  std::uint64_t hash_of_records, hash_of_domain;
  std::array<double, std::tuple_size<decltype(steering_parameters(Relaxation_options()))>::value> parameters;

  std::int64_t number_of_all; ///< that ever were, which is the number of the next
  std::int32_t is_coarse, is_roused;
  std::int64_t initial_bubbles, rounds, steps, force_evaluations, renewals;
  std::array<std::int64_t, 4> moves_returns_insertions_deletions;

  std::uint64_t hash_of_header; ///< of all before

  std::int64_t file_size() const
  {
    return static_cast<std::int64_t>(sizeof(Checkpoint_header_2)) + number_of_records * record_size;
  }

  std::uint64_t own_hash() const
  {
    Hash_of_numbers hash;
    hash.add_bytes(this, offsetof(Checkpoint_header_2, hash_of_header));
    return hash.value();
  }
};

static_assert(sizeof(Checkpoint_header_2) ==
                8 + 2 * 4 + 4 * 8 + sizeof(Checkpoint_header_2::parameters) + 8 + 2 * 4 + 9 * 8 + 8,
              "a header must not have gaps");

/// A record at its position among all. The sum over all records modulo 2^64 does not depend on who adds which.
inline std::uint64_t hash_of(const Bubble_state_2& record, std::int64_t position)
{
  Hash_of_numbers hash;
  hash.add(position);
  hash.add_bytes(&record, sizeof record);
  return hash.value();
}

/// All that bubbles refer to by indices: the outline, its triangles, and pinned vertices.
inline std::uint64_t hash_of_places(const Domain_2& domain, const Given_mesh_2& given)
{
  Hash_of_numbers hash;
  hash.add(hash_of(domain));
  for (const auto& vertices : domain.triangulation().vertices)
    for (Index v : vertices)
      hash.add(v);
  for (const Point& p : given.pinned)
    hash.add(p);
  return hash.value();
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_CHECKPOINT_CHECKPOINT_FILE_2_H
