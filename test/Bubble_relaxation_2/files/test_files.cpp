// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// Meshes go to files whole, with all that a format keeps: read back they are the same to the last bit.

#include "bays.h"
#include "expect_throw.h"
#include "file_readers.h"

#include <CGAL/Bubble_relaxation_2/IO/2DM.h>
#include <CGAL/Bubble_relaxation_2/IO/ADCIRC.h>
#include <CGAL/Bubble_relaxation_2/IO/MSH.h>
#include <CGAL/Bubble_relaxation_2/IO/VTU.h>
#include <CGAL/Bubble_relaxation_2/IO/triangle.h>
#include <CGAL/Projection_traits_xy_3.h>
#include <CGAL/npbs_relax.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <locale>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>
#include <sys/resource.h>

namespace test_files {

using bays::Bay;
using bays::Folder;
using bays::tagged_bay;
using file_readers::Mesh;
using file_readers::text_of;
using file_readers::Words;
using file_readers::written;
using CGAL::Mesh_arrays_2;

/// the mesh as a reader of a file of Gmsh should have it
Mesh expected(const Mesh_arrays_2& arrays)
{
  Mesh mesh;
  for (std::size_t k = 0; k < arrays.points.size(); ++k)
    mesh.points[k + 1] = {arrays.points[k].x(), arrays.points[k].y(), 0};
  for (std::size_t k = 0; k < arrays.edges.size(); ++k) {
    const double group = arrays.edge_markers[k] == 0 ? 6 : arrays.edge_markers[k]; // the next one that is free
    mesh.lines.push_back({{arrays.edges[k][0] + 1, arrays.edges[k][1] + 1}, group});
  }
  for (std::size_t k = 0; k < arrays.triangles.size(); ++k) {
    const auto& t = arrays.triangles[k];
    mesh.triangles.push_back({{t[0] + 1, t[1] + 1, t[2] + 1}, arrays.regions[k]});
  }
  return mesh;
}

void expect_gmsh_has_all(const Mesh& mesh, const Mesh_arrays_2& arrays)
{
  const Mesh all = expected(arrays);
  EXPECT_TRUE(mesh.points == all.points);
  EXPECT_TRUE(mesh.tagged(mesh.lines) == all.tagged(all.lines));
  EXPECT_TRUE(mesh.tagged(mesh.triangles) == all.tagged(all.triangles));
  EXPECT_EQ(mesh.lines.size(), arrays.edges.size());
  EXPECT_EQ(mesh.triangles.size(), arrays.triangles.size());
  const std::map<std::pair<int, int>, std::string> names{
    {{1, 5}, "open sea"}, {{1, 3}, "a 'small' island"}, {{1, 6}, "0"}, {{2, 10}, "sand"}};
  EXPECT_EQ(mesh.names, names);
  for (std::size_t k = 0; k < arrays.points.size(); ++k)
    EXPECT_EQ(mesh.data.at("depth").at(k + 1), arrays.vertex_data.at("depth")[k]);
}

TEST(Files, gmsh_4_1)
{
  const Mesh_arrays_2 arrays = tagged_bay();
  const std::string text = written([&](std::ostream& out) { CGAL::IO::write_MSH(out, arrays); });
  expect_gmsh_has_all(file_readers::Msh4_reader(text).mesh, arrays);
}

TEST(Files, gmsh_2_2)
{
  const Mesh_arrays_2 arrays = tagged_bay();
  const std::string text = written([&](std::ostream& out) { CGAL::IO::write_MSH2(out, arrays); });
  expect_gmsh_has_all(file_readers::read_msh2(text), arrays);
}

// what is no number of a group becomes one, and keeps its value as a name
TEST(Files, gmsh_of_tags_that_are_no_groups)
{
  const Bay<int, double> bay(5, -2, 3, 4, 0.5, 20);
  const Mesh mesh =
    file_readers::Msh4_reader(written([&](std::ostream& out) { CGAL::IO::write_MSH(out, bay.mesh()); })).mesh;
  const std::map<std::pair<int, int>, std::string> names{{{1, 6}, "-2"}, {{1, 7}, "0"}, {{2, 21}, "0.5"}};
  EXPECT_EQ(mesh.names, names);
  std::set<double> groups;
  for (const auto& line : mesh.lines)
    groups.insert(line.second);
  EXPECT_EQ(groups, (std::set<double>{3, 4, 5, 6, 7}));
}

// by the programs themselves, where they are
TEST(Files, gmsh_and_meshio_read_them)
{
  const Folder folder;
  const Mesh_arrays_2 arrays = tagged_bay();
  CGAL::IO::write_MSH(folder / "a.msh", arrays);
  CGAL::IO::write_MSH2(folder / "b.msh", arrays);
  CGAL::IO::write_VTU(folder / "c.vtu", arrays);
  bool is_tested = false;
  if (std::system("gmsh --version > /dev/null 2>&1") == 0) {
    is_tested = true;
    for (const char* name : {"a.msh", "b.msh"}) {
      const std::string log = folder / "log";
      EXPECT_EQ(std::system(("gmsh -check " + (folder / name) + " -parse_and_exit > " + log + " 2>&1").c_str()), 0);
      const std::string text = text_of(log);
      EXPECT_NE(text.find(std::to_string(arrays.points.size()) + " nodes"), std::string::npos) << text;
      EXPECT_EQ(text.find("Error"), std::string::npos) << text;
      EXPECT_EQ(text.find("Warning"), std::string::npos) << text;
    }
  }
  for (const std::string python : {"python3", "/usr/bin/python3"}) { // Debian's own has Debian's modules
    if (std::system((python + " -c 'import meshio' > /dev/null 2>&1").c_str()) != 0)
      continue;
    is_tested = true;
    std::ofstream(folder / "read.py") << R"(
import meshio, sys
for name in sys.argv[4:]:
    mesh = meshio.read(name)
    cells = {}
    for block in mesh.cells:
        cells[block.type] = cells.get(block.type, 0) + len(block.data)
    assert len(mesh.points) == int(sys.argv[1]), len(mesh.points)
    assert cells == {"line": int(sys.argv[2]), "triangle": int(sys.argv[3])}, cells
    assert len(mesh.point_data["depth"]) == len(mesh.points)
    if name.endswith(".msh"):
        assert list(mesh.field_data["open sea"]) == [5, 1], mesh.field_data
        assert list(mesh.field_data["sand"]) == [10, 2], mesh.field_data
        tags = {t for block in mesh.cell_data["gmsh:physical"] for t in block}
        assert tags >= {2, 3, 4, 5, 10, 20}, tags
)";
    const std::string command = python + " " + (folder / "read.py") + " " + std::to_string(arrays.points.size()) + " " +
                                std::to_string(arrays.edges.size()) + " " + std::to_string(arrays.triangles.size()) +
                                " " + (folder / "a.msh") + " " + (folder / "b.msh") + " " + (folder / "c.vtu");
    EXPECT_EQ(std::system(command.c_str()), 0) << command;
    break;
  }
  if (!is_tested)
    GTEST_SKIP() << "neither Gmsh nor meshio is here";
}

TEST(Files, vtu)
{
  Mesh_arrays_2 arrays = tagged_bay();
  arrays.vertex_data["<odd> & \"name\""] = arrays.vertex_data["depth"];
  const std::string text = written([&](std::ostream& out) { CGAL::IO::write_VTU(out, arrays); });
  const auto points = file_readers::array_of_vtu<double>(text, "Points");
  ASSERT_EQ(points.size(), 3 * arrays.points.size());
  for (std::size_t k = 0; k < arrays.points.size(); ++k)
    EXPECT_TRUE(points[3 * k] == arrays.points[k].x() && points[3 * k + 1] == arrays.points[k].y());
  EXPECT_EQ(file_readers::array_of_vtu<double>(text, "depth"), arrays.vertex_data["depth"]);
  EXPECT_EQ(file_readers::array_of_vtu<double>(text, "&lt;odd> &amp; &quot;name&quot;"), arrays.vertex_data["depth"]);
  auto markers = file_readers::array_of_vtu<int>(text.substr(text.find("<CellData")), "marker");
  markers.erase(markers.begin(), markers.begin() + static_cast<std::ptrdiff_t>(arrays.triangles.size()));
  EXPECT_EQ(markers, arrays.edge_markers);
  auto regions = file_readers::array_of_vtu<double>(text, "region");
  regions.resize(arrays.triangles.size());
  EXPECT_EQ(regions, arrays.regions);
}

/// that of the triangle around a place
double region_at(const Mesh_arrays_2& mesh, double x, double y)
{
  for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
    const auto& t = mesh.triangles[k];
    const Mesh_arrays_2::Point_2 p(x, y);
    if (CGAL::orientation(mesh.points[t[0]], mesh.points[t[1]], p) != CGAL::RIGHT_TURN &&
        CGAL::orientation(mesh.points[t[1]], mesh.points[t[2]], p) != CGAL::RIGHT_TURN &&
        CGAL::orientation(mesh.points[t[2]], mesh.points[t[0]], p) != CGAL::RIGHT_TURN)
      return mesh.regions[k];
  }
  return -1;
}

TEST(Files, triangle)
{
  const Folder folder;
  const Mesh_arrays_2 arrays = tagged_bay();
  CGAL::IO::write_triangle_files(folder / "bay.edge", arrays);
  Words node(text_of(folder / "bay.node"));
  ASSERT_EQ(node.count(), arrays.points.size());
  for (const char* word : {"2", "0", "1"})
    node.expect(word);
  for (std::size_t k = 0; k < arrays.points.size(); ++k) {
    EXPECT_EQ(node.count(), k + 1);
    EXPECT_EQ(node.number(), arrays.points[k].x());
    EXPECT_EQ(node.number(), arrays.points[k].y());
    EXPECT_EQ(node.next<int>(), arrays.vertex_markers[k]);
  }
  Words ele(text_of(folder / "bay.ele"));
  ASSERT_EQ(ele.count(), arrays.triangles.size());
  ele.expect("3");
  ele.expect("1");
  for (std::size_t k = 0; k < arrays.triangles.size(); ++k) {
    EXPECT_EQ(ele.count(), k + 1);
    for (const std::size_t v : arrays.triangles[k])
      EXPECT_EQ(ele.count(), v + 1);
    EXPECT_EQ(ele.number(), arrays.regions[k]);
  }
  Words poly(text_of(folder / "bay.poly"));
  for (const char* word : {"0", "2", "0", "1"})
    poly.expect(word);
  ASSERT_EQ(poly.count(), arrays.edges.size());
  poly.expect("1");
  for (std::size_t k = 0; k < 4 * arrays.edges.size(); ++k)
    poly.count();
  ASSERT_EQ(poly.count(), arrays.holes.size());
  for (std::size_t k = 0; k < 3 * arrays.holes.size(); ++k)
    poly.number();
  ASSERT_EQ(poly.count(), 2u); // the regions, of which a segment is the border
  for (std::size_t k = 1; k <= 2; ++k) {
    EXPECT_EQ(poly.count(), k);
    const double x = poly.number(), y = poly.number(), region = poly.number();
    EXPECT_EQ(region, region_at(arrays, x, y));
    EXPECT_EQ(poly.number(), -1);
  }
  Words edge(text_of(folder / "bay.edge"));
  // Euler: two holes
  EXPECT_EQ(edge.count(), arrays.points.size() + arrays.triangles.size() + 1);
}

TEST(Files, say_what_went_wrong_and_leave_nothing)
{
  const Folder folder;
  const Mesh_arrays_2 arrays = tagged_bay();
  const std::string nowhere = folder / "nowhere/a.msh";
  expect_throw<std::runtime_error>([&] { CGAL::IO::write_MSH(nowhere, arrays); },
                                   {nowhere, "cannot be written", "No such file"});
  // a file that cannot grow any more
  std::signal(SIGXFSZ, SIG_IGN);
  rlimit old{};
  getrlimit(RLIMIT_FSIZE, &old);
  rlimit small = old;
  small.rlim_cur = 8000;
  setrlimit(RLIMIT_FSIZE, &small);
  for (const std::string ending : {".msh", ".msh2", ".vtu", ".2dm", ".14", ".node"})
    expect_throw<std::runtime_error>(
      [&] {
        const std::string name = folder / ("a" + ending);
        ending == ".msh"    ? CGAL::IO::write_MSH(name, arrays)
        : ending == ".msh2" ? CGAL::IO::write_MSH2(name, arrays)
        : ending == ".vtu"  ? CGAL::IO::write_VTU(name, arrays)
        : ending == ".2dm"  ? CGAL::IO::write_2DM(name, arrays)
        : ending == ".14"   ? CGAL::IO::write_ADCIRC(name, arrays)
                            : CGAL::IO::write_triangle_files(name, arrays);
      },
      {folder / "a", "cannot be written", "File too large"});
  setrlimit(RLIMIT_FSIZE, &old);
  EXPECT_TRUE(folder.is_empty());
}

TEST(Files, names_of_data_are_not_those_of_other_arrays)
{
  const Folder folder;
  Mesh_arrays_2 mesh = tagged_bay();
  mesh.vertex_data["marker"].assign(mesh.points.size(), 1);
  expect_invalid([&] { CGAL::IO::write_VTU(folder / "a.vtu", mesh); }, {"'marker'", "write_VTU"});
  mesh.vertex_data.erase("marker");
  mesh.triangle_data["region"].assign(mesh.triangles.size(), 1);
  expect_invalid([&] { CGAL::IO::write_VTU(folder / "a.vtu", mesh); }, {"'region'"});
  EXPECT_TRUE(folder.is_empty());
}

TEST(Files, names_of_data_are_xml)
{
  Mesh_arrays_2 mesh = tagged_bay();
  mesh.vertex_data["a\x01<b\n"].assign(mesh.points.size(), 1);
  const std::string text = file_readers::written([&](std::ostream& out) { CGAL::IO::write_VTU(out, mesh); });
  EXPECT_NE(text.find("\"a?&lt;b&#10;\""), std::string::npos);
}

TEST(Files, refuse_arrays_that_do_not_belong_together)
{
  const Folder folder;
  const auto expect_refused = [&](const Mesh_arrays_2& mesh, const std::string& word) {
    expect_invalid([&] { CGAL::IO::write_VTU(folder / "a.vtu", mesh); }, {word});
    EXPECT_TRUE(folder.is_empty());
  };
  Mesh_arrays_2 mesh = tagged_bay();
  mesh.vertex_data["depth"].pop_back();
  expect_refused(mesh, "'depth' has");
  mesh = tagged_bay();
  mesh.triangles[3][1] = mesh.points.size();
  expect_refused(mesh, "triangles name the point " + std::to_string(mesh.points.size()));
  mesh = tagged_bay();
  mesh.points[5] = domains::Point(std::numeric_limits<double>::quiet_NaN(), 0);
  expect_refused(mesh, "(nan, 0) must be finite");
  expect_invalid([&] { CGAL::IO::write_ADCIRC(folder / "a.14", tagged_bay(), {}, 7); }, {"land_type = 7"});
  EXPECT_TRUE(folder.is_empty());
}

/// numbers as some countries write them
struct Commas : std::numpunct<char>
{
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

TEST(Files, do_not_depend_on_the_stream_and_leave_it_as_it_was)
{
  const Mesh_arrays_2 arrays = tagged_bay();
  std::ostringstream odd;
  odd.imbue(std::locale(odd.getloc(), new Commas));
  odd << std::hex << std::fixed;
  odd.precision(2);
  odd.width(60);
  CGAL::IO::write_MSH(odd, arrays);
  EXPECT_EQ(odd.str(), written([&](std::ostream& out) { CGAL::IO::write_MSH(out, arrays); }));
  odd.str("");
  odd << 0.5 << ' ' << 31;
  EXPECT_EQ(odd.str(), "0,50 1f");
}

TEST(Files, of_a_terrain_have_elevations)
{
  using Traits = CGAL::Projection_traits_xy_3<domains::K>;
  CGAL::Constrained_Delaunay_triangulation_2<Traits> terrain;
  const std::vector<Traits::Point_2> outline{{0, 0, 1}, {1, 0, 2}, {1, 1, 3}, {0, 1, 2}};
  terrain.insert_constraint(outline.begin(), outline.end(), true);
  CGAL::npbs_relax(terrain, 0.2);
  const Mesh_arrays_2 arrays = terrain;
  const Mesh mesh =
    file_readers::Msh4_reader(written([&](std::ostream& out) { CGAL::IO::write_MSH(out, arrays); })).mesh;
  EXPECT_EQ(mesh.points.size(), terrain.number_of_vertices());
  for (const auto& p : mesh.points)
    EXPECT_NEAR(p.second[2], 1 + p.second[0] + p.second[1], 1e-14);
  Words ocean(written([&](std::ostream& out) { CGAL::IO::write_ADCIRC(out, arrays); }));
  ocean.expect("mesh");
  ocean.count();
  const std::size_t n = ocean.count();
  for (std::size_t k = 0; k < n; ++k) {
    ocean.count();
    const double x = ocean.number(), y = ocean.number();
    EXPECT_NEAR(ocean.number(), -1 - x - y, 1e-14);
  }
}

TEST(Files, tell_if_a_stream_has_failed)
{
  const Mesh_arrays_2 mesh = tagged_bay();
  const auto expect_told = [&](const auto& write) {
    std::ostringstream out;
    EXPECT_TRUE(write(out));
    out.setstate(std::ios_base::badbit);
    EXPECT_FALSE(write(out));
  };
  expect_told([&](std::ostream& out) { return CGAL::IO::write_MSH(out, mesh); });
  expect_told([&](std::ostream& out) { return CGAL::IO::write_MSH2(out, mesh); });
  expect_told([&](std::ostream& out) { return CGAL::IO::write_VTU(out, mesh); });
  expect_told([&](std::ostream& out) { return CGAL::IO::write_2DM(out, mesh); });
  expect_told([&](std::ostream& out) { return CGAL::IO::write_ADCIRC(out, mesh); });
  expect_told([&](std::ostream& out) { return CGAL::IO::write_triangle_node(out, mesh); });
  expect_told([&](std::ostream& out) { return CGAL::IO::write_triangle_ele(out, mesh); });
  expect_told([&](std::ostream& out) { return CGAL::IO::write_triangle_poly(out, mesh); });
  expect_told([&](std::ostream& out) { return CGAL::IO::write_triangle_edge(out, mesh); });
}

// arrays that are filled by hand may have points of no triangle, or nothing at all
TEST(Files, gmsh_of_points_of_no_triangle)
{
  Mesh_arrays_2 mesh;
  const auto text = [&] { return written([&](std::ostream& out) { CGAL::IO::write_MSH(out, mesh); }); };
  EXPECT_NE(text().find("$Nodes\n0 0 0 0\n$EndNodes\n$Elements\n0 0 0 0\n$EndElements\n"), std::string::npos);
  mesh.points = {{0, 0}, {1, 0}, {0, 1}, {5, 7}};
  mesh.vertex_markers.assign(4, 0);
  EXPECT_NE(text().find("$Nodes\n1 4 1 4\n2 1 0 4\n1\n2\n3\n4\n0 0 0\n"), std::string::npos);
  mesh.triangles = {{0, 1, 2}};
  const Mesh all = file_readers::Msh4_reader(text()).mesh; // also tells whether boxes contain their points
  EXPECT_EQ(all.points.size(), 4u);
  EXPECT_EQ(all.triangles.size(), 1u);
  EXPECT_EQ(all.points.at(4)[1], 7);
}

// box.1 is the name of Triangle's first refinement of box
TEST(Files, of_triangle_have_names_with_points)
{
  using Names = std::vector<std::string>;
  EXPECT_EQ(CGAL::IO::triangle_files("box.1"), (Names{"box.1.node", "box.1.ele", "box.1.poly"}));
  EXPECT_EQ(CGAL::IO::triangle_files("a.b/box.1.EDGE"),
            (Names{"a.b/box.1.node", "a.b/box.1.ele", "a.b/box.1.poly", "a.b/box.1.edge"}));
  EXPECT_EQ(CGAL::IO::triangle_files("box.poly"), (Names{"box.node", "box.ele", "box.poly"}));
  EXPECT_EQ(CGAL::IO::triangle_files("box"), (Names{"box.node", "box.ele", "box.poly"}));
}

} // namespace test_files
