// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef BUBBLE_RELAXATION_2_TEST_FILE_READERS_H
#define BUBBLE_RELAXATION_2_TEST_FILE_READERS_H

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

/// Readers of what the package writes, as strict as its formats.
namespace file_readers {

/// cells with the tag of each, by their points, whatever their order in the file
using Tagged = std::map<std::vector<std::pair<double, double>>, double>;

struct Mesh
{
  std::map<std::size_t, std::array<double, 3>> points; ///< by their numbers
  std::vector<std::pair<std::vector<std::size_t>, double>> lines, triangles;
  std::map<std::pair<int, int>, std::string> names; ///< by dimension and group
  std::map<std::string, std::map<std::size_t, double>> data;

  Tagged tagged(const std::vector<std::pair<std::vector<std::size_t>, double>>& cells) const
  {
    Tagged result;
    for (const auto& cell : cells) {
      std::vector<std::pair<double, double>> places;
      for (const std::size_t v : cell.first)
        places.push_back({points.at(v)[0], points.at(v)[1]});
      std::sort(places.begin(), places.end());
      result[places] = cell.second;
    }
    return result;
  }
};

inline std::string text_of(const std::string& name)
{
  std::ifstream in(name, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

template <class Write>
std::string written(const Write& write)
{
  std::ostringstream out;
  write(out);
  return out.str();
}

/// numbers and words, one after the other
class Words
{
public:
  explicit Words(const std::string& text) : m_in(text) {}

  template <class T>
  T next()
  {
    T value{};
    if (!(m_in >> value))
      throw std::runtime_error("the file ends, or a number is none");
    return value;
  }

  std::size_t count() { return next<std::size_t>(); }
  double number() { return next<double>(); }

  void expect(const std::string& word) { EXPECT_EQ(next<std::string>(), word); }

  bool is_at_end()
  {
    m_in >> std::ws;
    return m_in.eof();
  }

  std::string rest_of_line()
  {
    std::string line;
    std::getline(m_in, line);
    return line;
  }

private:
  std::istringstream m_in;
};

inline std::string in_quotes(Words& words)
{
  const std::string line = words.rest_of_line();
  const std::size_t first = line.find('"'), last = line.rfind('"');
  EXPECT_LT(first, last);
  return line.substr(first + 1, last - first - 1);
}

inline void read_names(Words& words, Mesh& mesh)
{
  for (std::size_t n = words.count(); n > 0; --n) {
    const int dimension = words.next<int>(), group = words.next<int>();
    mesh.names[{dimension, group}] = in_quotes(words);
  }
  words.expect("$EndPhysicalNames");
}

inline void read_node_data(Words& words, Mesh& mesh)
{
  words.expect("1");
  words.rest_of_line();
  const std::string name = in_quotes(words);
  for (const char* word : {"1", "0", "3", "0", "1"})
    words.expect(word);
  for (std::size_t n = words.count(); n > 0; --n) {
    const std::size_t v = words.count();
    mesh.data[name][v] = words.number();
  }
  words.expect("$EndNodeData");
}

inline void read_point(Words& words, std::size_t v, Mesh& mesh)
{
  const double x = words.number(), y = words.number(), z = words.number();
  EXPECT_TRUE(mesh.points.insert({v, {x, y, z}}).second) << v;
}

/// `type`: 1 for a line, 2 for a triangle
inline void read_cell(Words& words, int type, double group, Mesh& mesh)
{
  std::vector<std::size_t> nodes(type == 1 ? 2 : 3);
  for (std::size_t& v : nodes)
    v = words.count();
  (type == 1 ? mesh.lines : mesh.triangles).push_back({nodes, group});
}

/// `.msh` 2.2
inline Mesh read_msh2(const std::string& text)
{
  Words words(text);
  Mesh mesh;
  for (const char* word : {"$MeshFormat", "2.2", "0", "8", "$EndMeshFormat"})
    words.expect(word);
  while (!words.is_at_end()) {
    const auto section = words.next<std::string>();
    if (section == "$PhysicalNames") {
      read_names(words, mesh);
    } else if (section == "$Nodes") {
      for (std::size_t n = words.count(); n > 0; --n) {
        const std::size_t v = words.count();
        read_point(words, v, mesh);
      }
      words.expect("$EndNodes");
    } else if (section == "$Elements") {
      const std::size_t elements = words.count();
      for (std::size_t n = 1; n <= elements; ++n) {
        EXPECT_EQ(words.count(), n);
        const int type = words.next<int>();
        words.expect("2");
        const double group = words.number();
        EXPECT_GT(words.count(), 0u); // its entity
        read_cell(words, type, group, mesh);
      }
      words.expect("$EndElements");
    } else {
      EXPECT_EQ(section, "$NodeData");
      read_node_data(words, mesh);
    }
  }
  return mesh;
}

/// The sections of `.msh` 4.1 that have entities.
class Msh4_reader
{
public:
  explicit Msh4_reader(const std::string& text) : m_words(text)
  {
    for (const char* word : {"$MeshFormat", "4.1", "0", "8", "$EndMeshFormat"})
      m_words.expect(word);
    while (!m_words.is_at_end()) {
      const auto section = m_words.next<std::string>();
      if (section == "$PhysicalNames") {
        read_names(m_words, mesh);
      } else if (section == "$Entities") {
        read_entities();
      } else if (section == "$Nodes") {
        read_nodes();
      } else if (section == "$Elements") {
        read_elements();
      } else {
        EXPECT_EQ(section, "$NodeData");
        read_node_data(m_words, mesh);
      }
    }
  }

  Mesh mesh;

private:
  struct Entity
  {
    std::array<double, 6> box;
    double group;
  };

  void read_entities()
  {
    m_words.expect("0");
    const std::size_t curves = m_words.count(), surfaces = m_words.count();
    m_words.expect("0");
    for (std::size_t k = 0; k < curves + surfaces; ++k) {
      Entity& e = m_entities[{k < curves ? 1 : 2, m_words.count()}];
      for (double& c : e.box)
        c = m_words.number();
      const std::size_t groups = m_words.count();
      EXPECT_EQ(groups, 1u); // meshio wants all to have one
      e.group = m_words.number();
      m_words.expect("0");
    }
    m_words.expect("$EndEntities");
  }

  void read_nodes()
  {
    const std::size_t blocks = m_words.count(), nodes = m_words.count();
    m_words.expect("1");
    EXPECT_EQ(m_words.count(), nodes);
    for (std::size_t b = 0; b < blocks; ++b) {
      const int dimension = m_words.next<int>();
      const Entity& e = m_entities.at({dimension, m_words.count()});
      m_words.expect("0");
      std::vector<std::size_t> numbers(m_words.count());
      EXPECT_GT(numbers.size(), 0u);
      for (std::size_t& v : numbers)
        v = m_words.count();
      for (const std::size_t v : numbers) {
        read_point(m_words, v, mesh);
        for (std::size_t c = 0; c < 3; ++c) {
          EXPECT_GE(mesh.points[v][c], e.box[c]);
          EXPECT_LE(mesh.points[v][c], e.box[c + 3]);
        }
      }
    }
    EXPECT_EQ(mesh.points.size(), nodes);
    m_words.expect("$EndNodes");
  }

  void read_elements()
  {
    const std::size_t blocks = m_words.count(), elements = m_words.count();
    m_words.expect("1");
    EXPECT_EQ(m_words.count(), elements);
    std::size_t number = 0;
    for (std::size_t b = 0; b < blocks; ++b) {
      const int dimension = m_words.next<int>();
      const Entity& e = m_entities.at({dimension, m_words.count()});
      const int type = m_words.next<int>();
      EXPECT_EQ(type, dimension);
      for (std::size_t n = m_words.count(); n > 0; --n) {
        EXPECT_EQ(m_words.count(), ++number);
        read_cell(m_words, type, e.group, mesh);
      }
    }
    EXPECT_EQ(number, elements);
    m_words.expect("$EndElements");
  }

  Words m_words;
  std::map<std::pair<int, std::size_t>, Entity> m_entities;
};

/// an array of a `.vtu`
template <class T>
std::vector<T> array_of_vtu(const std::string& text, const std::string& name)
{
  const std::size_t at = text.find("Name=\"" + name + "\"");
  if (at == std::string::npos)
    throw std::runtime_error("there is no array " + name);
  const std::size_t begin = text.find("\"binary\">", at) + 9, end = text.find('<', begin);
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  for (std::size_t k = begin; k < end; k += 4) {
    std::uint32_t four = 0;
    for (std::size_t i = 0; i < 4; ++i)
      four = four << 6 | (text[k + i] == '=' ? 0 : static_cast<std::uint32_t>(digits.find(text[k + i])));
    const std::size_t n = text[k + 2] == '=' ? 1 : text[k + 3] == '=' ? 2 : 3;
    for (std::size_t i = 0; i < n; ++i)
      bytes += static_cast<char>(four >> (16 - 8 * i) & 255);
  }
  std::uint64_t size = 0;
  std::memcpy(&size, bytes.data(), sizeof size);
  EXPECT_EQ(size, bytes.size() - sizeof size);
  std::vector<T> values(size / sizeof(T));
  std::memcpy(values.data(), bytes.data() + sizeof size, size);
  return values;
}

} // namespace file_readers

#endif // BUBBLE_RELAXATION_2_TEST_FILE_READERS_H
