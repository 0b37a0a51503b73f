// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef BUBBLE_RELAXATION_2_DEMO_WKT_FILE_H
#define BUBBLE_RELAXATION_2_DEMO_WKT_FILE_H

#include "domain.h"
#include "in_quotes.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <istream>
#include <iterator>

/// Reads WKT: polygons with holes are outlines, lines are inner constraints, points stay where they are.
/// CGAL's reader wants upper case and a line a geometry, and is silent about what it does not read.
class Wkt_reader
{
public:
  explicit Wkt_reader(std::istream& in)
    : m_text(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>())
  {}

  Domain read()
  {
    if (m_text.compare(0, 3, "\xEF\xBB\xBF") == 0) // the byte order mark of UTF-8
      m_at = 3;
    for (skip_space(); m_at < m_text.size(); skip_space())
      read_geometry();
    if (m_domain.cdt.number_of_vertices() == 0)
      throw std::runtime_error("there are no points, lines or polygons in it");
    pin_lonely_points(m_domain);
    return std::move(m_domain);
  }

private:
  void read_geometry()
  {
    skip_space();
    m_start = m_at;
    std::string type = word();
    if (type == "SRID") { // of PostGIS; the coordinates are used as they are
      m_at = (std::min)(m_text.find(';', m_at), m_text.size() - 1) + 1;
      type = word();
    }
    const std::string whole = type;
    while (!type.empty() && (type.back() == 'Z' || type.back() == 'M'))
      type.pop_back(); // POINTZ
    std::size_t before = m_at;
    for (std::string more = word(); more == "Z" || more == "M" || more == "ZM"; more = word())
      before = m_at; // POINT Z
    m_at = before;
    if (type == "POINT" || type == "MULTIPOINT")
      list([&] { read_point(); });
    else if (type == "LINESTRING")
      read_line(false);
    else if (type == "MULTILINESTRING")
      list([&] { read_line(false); });
    else if (type == "POLYGON")
      read_polygon();
    else if (type == "MULTIPOLYGON")
      list([&] { read_polygon(); });
    else if (type == "GEOMETRYCOLLECTION")
      list([&] { read_geometry(); });
    else if (whole.empty())
      fail("a geometry is missing" + what_is_there());
    else
      fail(in_quotes(whole) + " is not WKT of points, lines and polygons");
  }

  /// calls `read` for what stands between parentheses with commas between, unless it is EMPTY
  template <class Read>
  void list(const Read& read)
  {
    const std::size_t before = m_at;
    if (word() == "EMPTY")
      return;
    m_at = before;
    expect('(');
    do {
      read();
    } while (is_next(','));
    expect(')');
  }

  void read_polygon()
  {
    list([&] { read_line(true); });
  }

  /// a point, in parentheses of its own or not
  void read_point()
  {
    const bool has_parenthesis = is_next('(');
    m_domain.cdt.insert(coordinates());
    if (has_parenthesis)
      expect(')');
  }

  void read_line(bool is_ring)
  {
    skip_space();
    m_start = m_at;
    std::vector<Point> points;
    list([&] { points.push_back(coordinates()); });
    if (is_ring && !points.empty() && points.front() != points.back()) {
      m_domain.warnings.push_back(place() + "a ring is not closed; a segment from its end to its start "
                                            "closes it");
      points.push_back(points.front());
    }
    try {
      for (std::size_t k = 1; k < points.size(); ++k)
        insert_segment(m_domain, m_domain.cdt.insert(points[k - 1]), m_domain.cdt.insert(points[k]));
    } catch (const std::runtime_error& e) {
      fail(e.what());
    }
  }

  /// x and y; z and m are left out
  Point coordinates()
  {
    const double x = number(), y = number();
    for (skip_space(); m_at < m_text.size() && m_text[m_at] != ',' && m_text[m_at] != ')'; skip_space()) {
      number();
      if (!m_has_heights)
        m_domain.warnings.push_back(place() + "only x and y of points are used");
      m_has_heights = true;
    }
    return Point(x, y);
  }

  double number()
  {
    skip_space();
    m_start = m_at;
    char* end;
    const char* const begin = m_text.c_str() + m_at;
    const double value = std::strtod(begin, &end);
    if (end == begin || !std::isfinite(value))
      fail("a finite number is missing" + what_is_there());
    m_at += static_cast<std::size_t>(end - begin);
    return value;
  }

  bool is_next(char c)
  {
    skip_space();
    if (m_at >= m_text.size() || m_text[m_at] != c)
      return false;
    ++m_at;
    return true;
  }

  void expect(char c)
  {
    if (is_next(c))
      return;
    m_start = m_at;
    fail(std::string("a '") + c + "' is missing" + what_is_there());
  }

  std::string what_is_there() const
  {
    if (m_at >= m_text.size())
      return " at the end of the file";
    return " before " + in_quotes(m_text.substr(m_at, m_text.find_first_of(" ,)\r\n", m_at + 1) - m_at));
  }

  /// letters, in upper case
  std::string word()
  {
    skip_space();
    std::string result;
    for (; m_at < m_text.size() && std::isalpha(static_cast<unsigned char>(m_text[m_at])); ++m_at)
      result += static_cast<char>(std::toupper(static_cast<unsigned char>(m_text[m_at])));
    return result;
  }

  void skip_space()
  {
    while (m_at < m_text.size() && std::isspace(static_cast<unsigned char>(m_text[m_at])))
      ++m_at;
  }

  std::string place() const
  {
    const auto end = m_text.begin() + static_cast<std::ptrdiff_t>((std::min)(m_start, m_text.size()));
    return "line " + std::to_string(1 + std::count(m_text.begin(), end, '\n')) + ": ";
  }

  [[noreturn]] void fail(const std::string& what) const { throw std::runtime_error(place() + what); }

  std::string m_text;
  std::size_t m_at = 0;    // what is read next
  std::size_t m_start = 0; // where that begins which a message is about
  bool m_has_heights = false;
  Domain m_domain;
};

#endif // BUBBLE_RELAXATION_2_DEMO_WKT_FILE_H
