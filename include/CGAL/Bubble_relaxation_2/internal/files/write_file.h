// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_FILES_WRITE_FILE_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_FILES_WRITE_FILE_H

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <ios>
#include <locale>
#include <ostream>
#include <stdexcept>
#include <string>
#include <system_error>

namespace CGAL::Bubble_relaxation_2::internal {

/// Numbers in a user's stream as all programs read them, with all digits, as long as this lives.
class Plain_numbers
{
public:
  explicit Plain_numbers(std::ostream& out)
    : m_out(out), m_flags(out.flags(std::ios_base::dec)), m_precision(out.precision(17)), m_locale(out.getloc())
  {
    set_locale(std::locale::classic());
    out.width(0);
  }

  ~Plain_numbers()
  {
    m_out.flags(m_flags);
    m_out.precision(m_precision);
    if (!m_out.bad()) // a file that could not be written can throw in here
      set_locale(m_locale);
  }

  Plain_numbers(const Plain_numbers&) = delete;
  Plain_numbers& operator=(const Plain_numbers&) = delete;

private:
  void set_locale(const std::locale& locale)
  {
    if (m_out.getloc() != locale)
      m_out.imbue(locale);
  }

  std::ostream& m_out;
  std::ios_base::fmtflags m_flags;
  std::streamsize m_precision;
  std::locale m_locale;
};

/// \throws std::runtime_error with the name and the system's reason
[[noreturn]] inline void throw_not_written(const std::string& name, int reason)
{
  throw std::runtime_error("Bubble_relaxation_2: " + name + ": cannot be written: " + std::strerror(reason));
}

/// removes a file if there is one, not a device or a directory
inline void remove_file(const std::string& name)
{
  std::error_code ignored;
  if (std::filesystem::is_regular_file(name, ignored))
    std::filesystem::remove(name, ignored);
}

/// Writes a file with `write(stream)`, whole or not at all: what is there when that fails is removed.
/// \throws std::runtime_error with the name and the system's reason
template <class Write>
void write_file(const std::string& name, const Write& write)
{
  errno = 0;
  std::ofstream out;
  out.imbue(std::locale::classic());
  out.open(name);
  if (!out)
    throw_not_written(name, errno);
  const auto remove_part = [&] {
    out.close();
    remove_file(name);
  };
  try {
    write(out);
  } catch (...) {
    remove_part();
    throw;
  }
  out.close(); // some file systems tell only now that there is no room
  if (!out) {
    const int reason = errno;
    remove_part();
    throw_not_written(name, reason);
  }
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_FILES_WRITE_FILE_H
