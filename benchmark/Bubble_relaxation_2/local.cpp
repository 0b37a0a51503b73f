// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// What it costs to mesh a part of a mesh anew, in comparison to meshing that part alone, and how that grows with the
// whole: CPU time, and the most memory beyond what there was. `adapt` finds the part by one sweep over all faces,
// which is a column of its own.
//
//   local [number of vertices ...]
//
// And whether meshes get worse by many changes: random places are refined and given back again, and at the end the
// mesh is compared with one that is made at once for the same sizes.
//
//   local drift [number of changes] [seed]

#include "../../demo/Bubble_relaxation_2/paper_domains.h"

#include <CGAL/npbs_adapt.h>
#include <CGAL/npbs_relax.h>

#include <malloc.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <iomanip>
#include <iostream>
#include <map>
#include <new>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace {

std::size_t bytes_in_use = 0, most_bytes = 0;

} // namespace

void* operator new(std::size_t size)
{
  void* p = std::malloc(size);
  if (p == nullptr)
    throw std::bad_alloc();
  bytes_in_use += malloc_usable_size(p);
  most_bytes = (std::max)(most_bytes, bytes_in_use);
  return p;
}

void operator delete(void* p) noexcept
{
  bytes_in_use -= malloc_usable_size(p);
  std::free(p);
}

void operator delete(void* p, std::size_t) noexcept { operator delete(p); }

namespace {

using paper::CDT;
using paper::Point;
namespace P = CGAL::parameters;

const paper::Outline square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};

template <class Sizes>
CDT mesh(const paper::Outline& outline, const Sizes& d)
{
  CDT cdt;
  cdt.insert_constraint(outline.begin(), outline.end(), true);
  CGAL::npbs_relax(cdt, P::sizing_function(d));
  return cdt;
}

struct Cost
{
  double seconds = 1e9, megabytes = 0;
};

/// the least time of some calls of `f`, each after one of `prepare`
template <class Prepare, class Function>
Cost cost(const Prepare& prepare, const Function& f)
{
  Cost result;
  for (int k = 0; k < 5; ++k) {
    prepare();
    const std::size_t before = most_bytes = bytes_in_use;
    const std::clock_t start = std::clock();
    f();
    result.seconds = (std::min)(result.seconds, double(std::clock() - start) / CLOCKS_PER_SEC);
    result.megabytes = 1e-6 * double(most_bytes - before);
  }
  return result;
}

/// the faces within a distance of the middle, found from there
std::vector<CDT::Face_handle> part(const CDT& cdt, double radius)
{
  std::vector<CDT::Face_handle> faces{cdt.locate(Point(0.5, 0.5))};
  std::set<CDT::Face_handle> seen(faces.begin(), faces.end());
  for (std::size_t k = 0; k < faces.size(); ++k)
    for (int i = 0; i < 3; ++i) {
      const CDT::Face_handle n = faces[k]->neighbor(i);
      if (!cdt.is_infinite(n) && paper::distance(CGAL::centroid(cdt.triangle(n)), 0.5, 0.5) < radius &&
          seen.insert(n).second)
        faces.push_back(n);
    }
  return faces;
}

/// the outline of a part, as vertices of the mesh
paper::Outline outline(const std::vector<CDT::Face_handle>& part)
{
  const std::set<CDT::Face_handle> inside(part.begin(), part.end());
  std::map<CDT::Vertex_handle, CDT::Vertex_handle> next;
  for (CDT::Face_handle f : part)
    for (int i = 0; i < 3; ++i)
      if (inside.count(f->neighbor(i)) == 0)
        next[f->vertex(CDT::ccw(i))] = f->vertex(CDT::cw(i));
  paper::Outline result;
  for (auto v = next.begin()->first; result.size() < next.size(); v = next[v])
    result.push_back(v->point());
  return result;
}

void print(double whole, std::size_t vertices, const Cost& faces, const Cost& alone, const Cost& sweep,
           const Cost& adapt)
{
  std::cout << std::setw(9) << whole << std::setw(9) << vertices << std::fixed << std::setprecision(2) << std::setw(9)
            << 1e3 * faces.seconds << std::setw(9) << 1e3 * alone.seconds << std::setw(8)
            << faces.seconds / alone.seconds << std::setw(9) << faces.megabytes << std::setw(9) << alone.megabytes
            << std::setw(9) << 1e3 * sweep.seconds << std::setw(9) << 1e3 * adapt.seconds << std::setw(9)
            << adapt.megabytes << std::defaultfloat << std::endl;
}

void measure(double number_of_vertices)
{
  const double d = std::sqrt(1.15 / number_of_vertices), radius = 22 * d;
  CDT cdt = mesh(square, d);
  const auto fine = [=](const Point& p) { // half as large in the middle
    return (std::max)(0.5 * d, (std::min)(d, 0.5 * d + 0.1 * (paper::distance(p, 0.5, 0.5) - 12 * d)));
  };
  const auto refine = P::sizing_function(fine);
  std::size_t vertices = 0;
  std::vector<CDT::Face_handle> faces;
  const auto coarsen = [&] {
    CGAL::npbs_remesh_faces(cdt, part(cdt, radius), P::sizing_function(d));
    faces = part(cdt, radius);
  };
  const Cost of_faces =
    cost(coarsen, [&] { vertices = CGAL::npbs_remesh_faces(cdt, faces, refine).number_of_vertices; });
  coarsen();
  const paper::Outline rim = outline(faces);
  const Cost alone = cost([] {}, [&] { mesh(rim, fine); });
  const Cost sweep = cost(coarsen, [&] { CGAL::npbs_misfit_faces(cdt, refine); });
  const Cost adapt = cost(coarsen, [&] { CGAL::npbs_adapt(cdt, refine); });
  print(number_of_vertices, vertices, of_faces, alone, sweep, adapt);
}

/// A size, and places where it is smaller.
struct Refined_places
{
  struct Place
  {
    double x, y, factor;
  };

  double d = 0.02;
  std::vector<Place> places;

  double operator()(const Point& p) const
  {
    double result = d;
    for (const Place& a : places)
      result = (std::min)(result, a.factor * d + 0.2 * paper::distance(p, a.x, a.y));
    return result;
  }
};

template <class Sizes>
void judge(const std::string& name, const CDT& cdt, const Sizes& d)
{
  const auto q = CGAL::mesh_quality_2(cdt, P::sizing_function(d));
  std::cout << std::left << std::setw(22) << name << std::right << std::setw(9) << q.number_of_vertices() << std::fixed
            << std::setprecision(4) << std::setw(9) << q.minimum_quality() << std::setw(9) << q.mean_quality()
            << std::setw(9) << q.mean_length_ratio() << std::setw(9) << q.length_ratio_deviation() << std::setw(9)
            << q.irregular_share() << std::defaultfloat << std::endl;
}

/// each change refines a place and gives back the oldest one but seven
void drift(int number_of_changes, unsigned seed)
{
  std::mt19937 random(seed);
  const auto uniform = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(random); };
  Refined_places sizes;
  CDT cdt = mesh(square, sizes);
  std::cout << "mesh                   vertices    min q   mean q      L/d     dev.   irreg.\n";
  judge("before", cdt, sizes);
  for (int k = 1; k <= number_of_changes; ++k) {
    if (sizes.places.size() == 8)
      sizes.places.erase(sizes.places.begin());
    const double x = uniform(0, 1), y = uniform(0, 1);
    sizes.places.push_back({x, y, uniform(0.2, 0.5)});
    CGAL::npbs_adapt(cdt, P::sizing_function(sizes));
    if (k % (std::max)(1, number_of_changes / 4) == 0)
      judge("after " + std::to_string(k) + " changes", cdt, sizes);
  }
  judge("made at once", mesh(square, sizes), sizes);
  if (!cdt.is_valid())
    std::cout << "the triangulation is not valid\n";
}

} // namespace

int main(int argc, char** argv)
{
  if (argc > 1 && std::string(argv[1]) == "drift") {
    drift(argc > 2 ? std::atoi(argv[2]) : 1000, argc > 3 ? static_cast<unsigned>(std::atoi(argv[3])) : 1);
    return 0;
  }
  std::vector<double> numbers{1e4, 1e5, 1e6};
  if (argc > 1)
    numbers.clear();
  for (int k = 1; k < argc; ++k)
    numbers.push_back(std::atof(argv[k]));
  std::cout << "                     milliseconds         ratio  megabytes         milliseconds   megabytes\n"
               "    whole     part    faces    alone            faces    alone    sweep    adapt    adapt\n";
  for (double n : numbers)
    measure(n);
}
