// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_FILES_VTU_FILE_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_FILES_VTU_FILE_H

#include <CGAL/Bubble_relaxation_2/internal/files/in_xml.h>
#include <CGAL/Bubble_relaxation_2/internal/files/write_file.h>

#include <cstddef>
#include <cstdint>
#include <ostream>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// that of this machine, in the words of VTK
inline const char* byte_order()
{
  const std::uint16_t one = 1;
  return *reinterpret_cast<const unsigned char*>(&one) == 1 ? "LittleEndian" : "BigEndian";
}

/// What the unstructured grids of VTK have in common: head and end, cells, and arrays in base64, in lines of XML that
/// any reader takes.
class Vtu_file
{
public:
  /// writes the head; the rest is to be written in the order of the functions
  Vtu_file(std::ostream& out, std::size_t number_of_points, std::size_t number_of_cells) : m_out(out), m_plain(out)
  {
    m_out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\""
          << byte_order() << "\" header_type=\"UInt64\">\n"
          << "<UnstructuredGrid>\n<Piece NumberOfPoints=\"" << number_of_points << "\" NumberOfCells=\""
          << number_of_cells << "\">\n";
  }

  /// `write()` writes arrays, `scalars` is the one that is shown at first, if it is not empty
  template <class Write>
  void data(const std::string& kind, const std::string& scalars, const Write& write)
  {
    m_out << '<' << kind << (scalars.empty() ? "" : " Scalars=\"" + in_xml(scalars) + '"') << ">\n";
    write();
    m_out << "</" << kind << ">\n";
  }

  /// \param coordinates x, y and z of each point
  void points(const std::vector<double>& coordinates)
  {
    data("Points", "", [&] { array("Points", coordinates, 3); });
  }

  /// cells of one type of VTK, which are ranges of numbers of points
  template <class Cells>
  void add_cells(const Cells& cells, std::uint8_t type)
  {
    for (const auto& cell : cells) {
      m_connectivity.insert(m_connectivity.end(), cell.begin(), cell.end());
      m_offsets.push_back(static_cast<std::int64_t>(m_connectivity.size()));
      m_types.push_back(type);
    }
  }

  /// writes the cells, and the end
  void end()
  {
    data("Cells", "", [this] {
      array("connectivity", m_connectivity);
      array("offsets", m_offsets);
      array("types", m_types);
    });
    m_out << "</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
  }

  template <class T>
  void array(const std::string& name, const std::vector<T>& values, int components = 1)
  {
    m_out << "<DataArray type=\"" << type_of<T>() << "\" Name=\"" << in_xml(name);
    if (components > 1)
      m_out << "\" NumberOfComponents=\"" << components;
    m_out << "\" format=\"binary\">";
    const std::uint64_t size = values.size() * sizeof(T);
    std::string bytes(reinterpret_cast<const char*>(&size), sizeof(size));
    bytes.append(reinterpret_cast<const char*>(values.data()), static_cast<std::size_t>(size));
    m_out << base64(bytes) << "</DataArray>\n";
  }

private:
  /// as VTK calls it
  template <class T>
  static std::string type_of()
  {
    static_assert(!std::is_floating_point<T>::value || sizeof(T) == 8, "numbers are Float64");
    return (std::is_floating_point<T>::value ? "Float" : std::is_signed<T>::value ? "Int" : "UInt") +
           std::to_string(8 * sizeof(T));
  }

  static std::string base64(const std::string& bytes)
  {
    static const char* const digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    const auto byte = [&](std::size_t k) -> unsigned {
      return k < bytes.size() ? static_cast<unsigned char>(bytes[k]) : 0;
    };
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t k = 0; k < bytes.size(); k += 3) {
      const unsigned three = byte(k) << 16 | byte(k + 1) << 8 | byte(k + 2);
      text += digits[three >> 18];
      text += digits[three >> 12 & 63];
      text += k + 1 < bytes.size() ? digits[three >> 6 & 63] : '=';
      text += k + 2 < bytes.size() ? digits[three & 63] : '=';
    }
    return text;
  }

  std::ostream& m_out;
  Plain_numbers m_plain;
  std::vector<std::int64_t> m_connectivity, m_offsets;
  std::vector<std::uint8_t> m_types;
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_FILES_VTU_FILE_H
