// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// The cells of a dual go to files: for ParaView, and for codes of groundwater.

#include "bays.h"
#include "domains.h"
#include "expect_throw.h"
#include "file_readers.h"

#include <CGAL/Bubble_relaxation_2/IO/DISV.h>
#include <CGAL/Bubble_relaxation_2/IO/write_VTU_of_cells.h>
#include <CGAL/Constraint_marker_map_2.h>
#include <CGAL/Voronoi_dual_2.h>
#include <CGAL/npbs_relax.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace test_files_of_cells {

using domains::CDT;
using domains::Point;
using file_readers::array_of_vtu;
using file_readers::text_of;
using file_readers::written;
using Dual = CGAL::Voronoi_dual_2<CDT>;
namespace P = CGAL::parameters;

TEST(Files_of_cells, for_paraview)
{
  const CDT cdt = domains::mesh({domains::square(0, 0, 1)}, 0.2);
  const CGAL::Constraint_marker_map_2<CDT> markers(7);
  const Dual dual(cdt, P::edge_marker_map(markers));
  std::vector<double> values;
  for (const auto& c : dual.cells())
    values.push_back(c.center.x());
  std::ostringstream out;
  EXPECT_TRUE(CGAL::IO::write_VTU_of_cells(out, dual, values));
  const std::string vtu = out.str();
  const std::size_t cells = dual.cells().size(), lines = dual.boundary_parts().size();
  EXPECT_NE(vtu.find("NumberOfCells=\"" + std::to_string(cells + lines) + "\""), std::string::npos);
  const auto types = array_of_vtu<std::uint8_t>(vtu, "types");
  const auto offsets = array_of_vtu<std::int64_t>(vtu, "offsets"),
             connectivity = array_of_vtu<std::int64_t>(vtu, "connectivity"),
             cell = array_of_vtu<std::int64_t>(vtu, "cell");
  const auto points = array_of_vtu<double>(vtu, "Points"), area = array_of_vtu<double>(vtu, "area"),
             value = array_of_vtu<double>(vtu, "value");
  const auto marker = array_of_vtu<std::int32_t>(vtu, "marker"),
             dimension = array_of_vtu<std::int32_t>(vtu, "dimension");
  ASSERT_EQ(types.size(), cells + lines);
  ASSERT_EQ(offsets.size(), types.size());
  ASSERT_EQ(marker.size(), types.size());
  EXPECT_EQ(offsets.back(), std::int64_t(connectivity.size()));
  double sum = 0;
  for (std::size_t k = 0; k < types.size(); ++k) {
    const bool is_polygon = k < cells;
    EXPECT_EQ(types[k], is_polygon ? 7 : 3);
    EXPECT_EQ(dimension[k], is_polygon ? 2 : 1);
    EXPECT_EQ(marker[k], is_polygon ? 0 : 7);
    EXPECT_EQ(std::isnan(area[k]), !is_polygon);
    if (is_polygon) {
      EXPECT_EQ(value[k], values[std::size_t(cell[k])]);
      EXPECT_EQ(area[k], dual.cells()[std::size_t(cell[k])].area);
    }
    const std::int64_t begin = k == 0 ? 0 : offsets[k - 1], end = offsets[k];
    for (std::int64_t c = begin; is_polygon && c < end; ++c) {
      const auto p = 3 * std::size_t(connectivity[std::size_t(c)]),
                 q = 3 * std::size_t(connectivity[std::size_t(c + 1 < end ? c + 1 : begin)]);
      ASSERT_LT((std::max)(p, q) + 2, points.size());
      sum += 0.5 * (points[p] * points[q + 1] - points[p + 1] * points[q]);
    }
  }
  EXPECT_NEAR(sum, 1, 1e-13);
  expect_invalid([&] { CGAL::IO::write_VTU_of_cells(out, dual, {1.}); }, {"values", "1 for", "cells"});
}

/// the words of a block of MODFLOW's
std::vector<double> numbers_of_block(const std::string& text, const std::string& name)
{
  const std::size_t begin = text.find("BEGIN " + name + "\n"), end = text.find("END " + name + "\n");
  EXPECT_TRUE(begin != std::string::npos && begin < end) << name;
  std::istringstream in(text.substr(begin + 7 + name.size(), end - begin - 7 - name.size()));
  std::vector<double> numbers;
  std::string word;
  while (in >> word)
    if (std::isdigit(static_cast<unsigned char>(word.back())))
      numbers.push_back(std::stod(word));
  return numbers;
}

TEST(Files_of_cells, for_groundwater)
{
  const CDT cdt = domains::mesh({domains::square(0, 0, 1), domains::polygon(0.5, 0.5, 0.2, 12)}, 0.1);
  const Dual dual(cdt);
  std::ostringstream out;
  const auto top = [](const Point& p) { return 10 + p.x(); };
  CGAL::IO::write_DISV(out, dual, top, -2., 3);
  const std::size_t n = dual.cells().size();
  const std::vector<double> dimensions = numbers_of_block(out.str(), "DIMENSIONS"),
                            data = numbers_of_block(out.str(), "GRIDDATA"),
                            vertices = numbers_of_block(out.str(), "VERTICES"),
                            cells = numbers_of_block(out.str(), "CELL2D");
  ASSERT_EQ(dimensions, (std::vector<double>{3, double(n), double(dual.polygon_soup().points.size())}));
  ASSERT_EQ(data.size(), 4 * (n + 1)); // each array has a factor
  std::map<std::pair<double, double>, int> sides; // from one vertex to the next
  std::size_t at = 0;
  for (std::size_t k = 0; k < n; ++k) {
    const Point& center = dual.cells()[k].center;
    EXPECT_EQ(data[1 + k], top(center));
    EXPECT_NEAR(data[n + 2 + k], top(center) - (top(center) + 2) / 3, 1e-14);
    EXPECT_EQ(data[3 * (n + 1) + 1 + k], -2);
    ASSERT_EQ(cells[at], k + 1);
    EXPECT_EQ(Point(cells[at + 1], cells[at + 2]), center);
    const auto corners = static_cast<std::size_t>(cells[at + 3]);
    at += 4;
    double twice_area = 0;
    for (std::size_t i = 0; i < corners; ++i) {
      const double u = cells[at + i], v = cells[at + (i + 1) % corners];
      const auto place = [&](double number) { return 3 * (static_cast<std::size_t>(number) - 1); };
      ASSERT_EQ(vertices[place(u)], u);
      twice_area += vertices[place(u) + 1] * vertices[place(v) + 2] - vertices[place(u) + 2] * vertices[place(v) + 1];
      ++sides[{u, v}];
    }
    at += corners;
    EXPECT_NEAR(twice_area / 2, -dual.cells()[k].area, 1e-14); // clockwise
  }
  EXPECT_EQ(at, cells.size());
  std::size_t shared = 0;
  for (const auto& side : sides) {
    EXPECT_EQ(side.second, 1);
    shared += sides.count({side.first.second, side.first.first});
  }
  EXPECT_EQ(shared, 2 * dual.faces().size()); // cells with a face in common have two vertices in common
}

TEST(Files_of_cells, what_is_no_groundwater_is_refused)
{
  std::ostringstream out;
  const CDT square = domains::make({domains::square(0, 0, 1)}), obtuse = domains::make({{{0, 0}, {4, 0}, {2, 1}}}),
            touching = domains::mesh({domains::square(0, 0, 1), domains::square(1, 1, 1)}, 0.2);
  const auto write = [&out](const CDT& cdt, double top, double bottom, std::size_t layers) {
    CGAL::IO::write_DISV(out, Dual(cdt), top, bottom, layers);
  };
  expect_invalid([&] { write(square, 1, 0, 0); }, {"number_of_layers"});
  expect_invalid([&] { write(square, 1, 1, 1); }, {"top is not above bottom at (0, 0)"});
  expect_invalid([&] { write(square, std::nan(""), 1, 1); }, {"parameter top is not finite at (0, 0)"});
  expect_invalid([&] { write(obtuse, 1, 0, 1); }, {"1 faces", "negative lengths", "midpoint (2, 0)"});
  expect_invalid([&] { write(touching, 1, 0, 1); }, {"touches itself at (1, 1)"});
  EXPECT_EQ(out.str(), "");
}

// all is looked at before the file is opened
TEST(Files_of_cells, a_file_stays_if_what_is_to_be_written_is_refused)
{
  const bays::Folder folder;
  const std::string name = folder / "a";
  std::ofstream(name) << "precious";
  const Dual dual(domains::make({domains::square(0, 0, 1)}));
  expect_invalid([&] { CGAL::IO::write_DISV(name, dual, 0., 1.); }, {"top is not above bottom"});
  EXPECT_EQ(text_of(name), "precious");
  expect_invalid([&] { CGAL::IO::write_VTU_of_cells(name, dual, {1.}); }, {"values"});
  EXPECT_EQ(text_of(name), "precious");
  CGAL::IO::write_DISV(name, dual, 1., 0.);
  EXPECT_EQ(text_of(name), written([&](std::ostream& out) { CGAL::IO::write_DISV(out, dual, 1., 0.); }));
  CGAL::IO::write_VTU_of_cells(name, dual);
  EXPECT_EQ(text_of(name), written([&](std::ostream& out) { CGAL::IO::write_VTU_of_cells(out, dual); }));
}

TEST(Files_of_cells, do_not_depend_on_the_stream)
{
  const Dual dual(domains::make({domains::square(0, 0, 1)}));
  std::ostringstream odd;
  odd << std::hex << std::showbase;
  EXPECT_TRUE(CGAL::IO::write_VTU_of_cells(odd, dual));
  EXPECT_EQ(odd.str(), written([&](std::ostream& out) { CGAL::IO::write_VTU_of_cells(out, dual); }));
  odd.setstate(std::ios_base::badbit);
  EXPECT_FALSE(CGAL::IO::write_VTU_of_cells(odd, dual));
  EXPECT_FALSE(CGAL::IO::write_DISV(odd, dual, 1, 0));
}

TEST(Files_of_cells, markers_keep_their_digits)
{
  CDT cdt = domains::make({domains::square(0, 0, 1)});
  const CGAL::Constraint_marker_map_2<CDT, double> markers(2.5);
  const CGAL::Voronoi_dual_2<CDT, double> dual(cdt, P::edge_marker_map(markers));
  const std::string text = written([&](std::ostream& out) { CGAL::IO::write_VTU_of_cells(out, dual); });
  EXPECT_EQ(array_of_vtu<double>(text, "marker").back(), 2.5);
  const CGAL::Constraint_marker_map_2<CDT, std::int64_t> large(std::int64_t(4294967297));
  const CGAL::Voronoi_dual_2<CDT, std::int64_t> large_dual(cdt, P::edge_marker_map(large));
  EXPECT_EQ(array_of_vtu<std::int64_t>(
              written([&](std::ostream& out) { CGAL::IO::write_VTU_of_cells(out, large_dual); }), "marker")
              .back(),
            4294967297);
}

} // namespace test_files_of_cells
