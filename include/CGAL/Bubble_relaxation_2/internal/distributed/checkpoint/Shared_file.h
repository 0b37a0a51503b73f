// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_CHECKPOINT_SHARED_FILE_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_CHECKPOINT_SHARED_FILE_H

#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Communicator.h>

#include <mpi.h>

#include <cstdint>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

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

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_CHECKPOINT_SHARED_FILE_H
