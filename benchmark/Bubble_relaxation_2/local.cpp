// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// What it costs to mesh a part of a mesh anew, in comparison to meshing that part alone, and how that grows with the
// whole: CPU time, and the most memory beyond what there was. `adapt` finds the part by one sweep over all faces,
// which is a column of its own; `given` is told where to look (`faces_to_check`).
//
//   local [number of vertices ...]
//
// Then the same in a domain with many holes, whose outline `adapt` reads as a whole, and `given` near the part only.
//
// And whether meshes get worse by many changes: random places are refined and given back again, pinned vertices and a
// hole are moved, and on the way and at the end the mesh is compared with one that is made at once for the same sizes,
// outline and pins.
//
//   local drift [number of changes] [seed]

#include "../../demo/Bubble_relaxation_2/moving_hole.h"
#include "../../demo/Bubble_relaxation_2/paper_domains.h"
#include "../../test/Bubble_relaxation_2/counted_memory.h"

#include <CGAL/npbs_adapt.h>
#include <CGAL/npbs_relax.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <iomanip>
#include <iostream>
#include <map>
#include <optional>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace {

using paper::CDT;
using paper::Point;
namespace P = CGAL::parameters;

const paper::Outline square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};

template <class Sizes>
CDT mesh(const paper::Outline& outline, const Sizes& d)
{
  CDT cdt = paper::triangulate({outline});
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
    const std::size_t before = counted_memory::most_memory = counted_memory::memory;
    const std::clock_t start = std::clock();
    f();
    result.seconds = (std::min)(result.seconds, double(std::clock() - start) / CLOCKS_PER_SEC);
    result.megabytes = 1e-6 * double(counted_memory::most_memory - before);
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
           const Cost& adapt, const Cost& given)
{
  std::cout << std::setw(9) << whole << std::setw(9) << vertices << std::fixed << std::setprecision(2) << std::setw(9)
            << 1e3 * faces.seconds << std::setw(9) << 1e3 * alone.seconds << std::setw(8)
            << faces.seconds / alone.seconds << std::setw(9) << faces.megabytes << std::setw(9) << alone.megabytes
            << std::setw(9) << 1e3 * sweep.seconds << std::setw(9) << 1e3 * adapt.seconds << std::setw(9)
            << 1e3 * given.seconds << std::setw(9) << adapt.megabytes << std::defaultfloat << std::endl;
}

/// `lengths`: the radius of the part, in edges
void measure(double number_of_vertices, double lengths)
{
  const double d = std::sqrt(1.15 / number_of_vertices), radius = lengths * d;
  CDT cdt = mesh(square, d);
  const auto fine = [=](const Point& p) { // half as large in the middle
    return (std::max)(0.5 * d, (std::min)(d, 0.5 * d + 0.1 * (paper::distance(p, 0.5, 0.5) - radius + 10 * d)));
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
  const Cost given = cost(coarsen, [&] { CGAL::npbs_adapt(cdt, refine.faces_to_check(std::cref(faces))); });
  print(number_of_vertices, vertices, of_faces, alone, sweep, adapt, given);
}

/// a square with `n` times `n` octagons, in whose middle some hundred faces get half as large
void measure_among_holes(int n)
{
  const double d = 0.15, middle = 0.5 * n;
  std::vector<paper::Outline> outlines{{{0, 0}, {1. * n, 0}, {1. * n, 1. * n}, {0, 1. * n}}};
  for (int k = 0; k < n * n; ++k) {
    outlines.emplace_back();
    for (double angle : {0., 0.25, 0.5, 0.75, 1., 1.25, 1.5, 1.75})
      outlines.back().push_back(Point(k % n + 0.5 + 0.2 * std::cos(angle * CGAL_PI),
                                      k / n + 0.5 + 0.2 * std::sin(angle * CGAL_PI)));
  }
  CDT cdt = paper::triangulate(outlines);
  CGAL::npbs_relax(cdt, P::sizing_function(d));
  const std::size_t whole = cdt.number_of_vertices();
  const auto fine = [=](const Point& p) {
    return (std::max)(0.5 * d, (std::min)(d, 0.5 * d + 0.1 * (paper::distance(p, middle, middle) - 1)));
  };
  const auto refine = P::sizing_function(fine);
  std::vector<CDT::Face_handle> faces;
  const auto coarsen = [&] {
    faces.clear();
    CGAL::npbs_adapt(cdt, P::sizing_function(d));
    for (CDT::Face_handle f : cdt.finite_face_handles())
      if (f->is_in_domain() && fine(CGAL::centroid(cdt.triangle(f))) < d)
        faces.push_back(f);
  };
  std::size_t vertices = 0;
  const Cost adapt = cost(coarsen, [&] { vertices = CGAL::npbs_adapt(cdt, refine).number_of_vertices; });
  const Cost given = cost(coarsen, [&] { CGAL::npbs_adapt(cdt, refine.faces_to_check(std::cref(faces))); });
  std::cout << std::setw(9) << n * n << std::setw(9) << whole << std::setw(9) << vertices << std::fixed
            << std::setprecision(2) << std::setw(9) << 1e3 * adapt.seconds << std::setw(9) << 1e3 * given.seconds
            << std::setw(9) << adapt.megabytes << std::setw(9) << given.megabytes << std::defaultfloat << std::endl;
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

/// number of vertices, smallest q, mean q, mean L/d, deviation of L/d, share of irregular vertices
using Judgement = std::array<double, 6>;

template <class Sizes>
Judgement judge(const CDT& cdt, const Sizes& d)
{
  const auto q = CGAL::mesh_quality_2(cdt, P::sizing_function(d));
  return {double(q.number_of_vertices()), q.minimum_quality(), q.mean_quality(), q.mean_length_ratio(),
          q.length_ratio_deviation(), q.irregular_share()};
}

void print(const std::string& name, const Judgement& judgement)
{
  std::cout << std::left << std::setw(22) << name << std::right << std::fixed << std::setprecision(0) << std::setw(9)
            << judgement[0] << std::setprecision(4);
  for (std::size_t k = 1; k < judgement.size(); ++k)
    std::cout << std::setw(9) << judgement[k];
  std::cout << std::defaultfloat << std::endl;
}

using Pins = std::vector<CDT::Vertex_handle>;

/// which vertices are pinned
struct Pin_map
{
  using key_type = CDT::Vertex_handle;
  using value_type = bool;
  using reference = bool;
  using category = boost::readable_property_map_tag;

  const Pins* pins;

  friend bool get(const Pin_map& map, key_type v)
  {
    return std::find(map.pins->begin(), map.pins->end(), v) != map.pins->end();
  }
};

auto drift_parameters(const Refined_places& sizes, const Pins& pins)
{
  return P::sizing_function(sizes).vertex_is_constrained_map(Pin_map{&pins});
}

/// A square with a hole, some pinned vertices and some refined places, of which one is changed at a time.
class Drift
{
public:
  explicit Drift(unsigned seed) : m_random(seed)
  {
    m_hole_place = Point(0.5, 0.5);
    for (int k = 0; k < 8; ++k)
      m_pin_places.push_back(free_place());
    m_cdt = make(m_pins);
    m_hole.emplace(m_cdt, outline_of_hole());
  }

  /// refines a place and gives back the oldest one but seven
  void refine()
  {
    if (m_sizes.places.size() == 8)
      m_sizes.places.erase(m_sizes.places.begin());
    const double x = uniform(0, 1), y = uniform(0, 1);
    m_sizes.places.push_back({x, y, uniform(0.2, 0.5)});
  }

  /// somewhere else; the vertex that was pinned stays as one of many
  void move_pin()
  {
    const std::size_t k = m_next_pin++ % m_pins.size();
    m_pins[k] = CDT::Vertex_handle();
    m_pin_places[k] = Point(-9, -9); // it is not in the way of itself
    m_pin_places[k] = free_place();
    m_pins[k] = m_cdt.insert(m_pin_places[k]);
    mark_around(m_pins[k]);
  }

  /// by some triangles, where no pin is in the way
  void move_hole()
  {
    const Point before = m_hole_place;
    do
      m_hole_place = Point(before.x() + uniform(-0.08, 0.08), before.y() + uniform(-0.08, 0.08));
    while (!has_room_for_hole());
    m_hole->move(outline_of_hole(), 0.8 * m_sizes.d, [this](CDT::Vertex_handle v) { return is_pinned(v); });
  }

  void change(int k)
  {
    if (k % 3 == 0)
      refine();
    else if (k % 3 == 1)
      move_pin();
    else
      move_hole();
    CGAL::npbs_adapt(m_cdt, drift_parameters(m_sizes, m_pins).misfit_quality(0.88));
  }

  Judgement judge() const { return ::judge(m_cdt, m_sizes); }

  Judgement judge_at_once() const
  {
    Pins pins;
    return ::judge(make(pins), m_sizes);
  }

  bool is_valid() const { return m_cdt.is_valid(); }

private:
  static constexpr double radius = 0.08;

  double uniform(double a, double b) { return std::uniform_real_distribution<double>(a, b)(m_random); }

  bool is_pinned(CDT::Vertex_handle v) const { return get(Pin_map{&m_pins}, v); }

  paper::Outline outline_of_hole() const
  {
    paper::Outline result = paper::circle(radius, m_sizes.d);
    for (Point& p : result)
      p = Point(p.x() + m_hole_place.x(), p.y() + m_hole_place.y());
    return result;
  }

  /// as far from the outline and from other pins that none asks for smaller triangles
  Point free_place()
  {
    const double room = 3 * m_sizes.d;
    for (;;) {
      const Point p(uniform(room, 1 - room), uniform(room, 1 - room));
      if (paper::distance(p, m_hole_place.x(), m_hole_place.y()) > radius + room &&
          std::all_of(m_pin_places.begin(), m_pin_places.end(),
                      [&](const Point& q) { return paper::distance(p, q.x(), q.y()) > room; }))
        return p;
    }
  }

  bool has_room_for_hole() const
  {
    const double room = radius + 3 * m_sizes.d, x = m_hole_place.x(), y = m_hole_place.y();
    return (std::min)(x, y) > room && (std::max)(x, y) < 1 - room &&
           std::all_of(m_pin_places.begin(), m_pin_places.end(),
                       [&](const Point& p) { return paper::distance(p, x, y) > room; });
  }

  /// faces that an insertion has made do not know that they are in the domain
  static void mark_around(CDT::Vertex_handle v)
  {
    CDT::Face_circulator f = v->incident_faces(), first = f;
    do
      f->set_in_domain(true);
    while (++f != first);
  }

  CDT make(Pins& pins) const
  {
    CDT cdt = paper::triangulate({square, outline_of_hole()});
    for (const Point& p : m_pin_places)
      pins.push_back(cdt.insert(p));
    CGAL::npbs_relax(cdt, drift_parameters(m_sizes, pins));
    return cdt;
  }

  std::mt19937 m_random;
  Refined_places m_sizes;
  Point m_hole_place;
  std::vector<Point> m_pin_places;
  CDT m_cdt;
  Pins m_pins; // of `m_cdt`
  std::size_t m_next_pin = 0;
  std::optional<Moving_hole<CDT>> m_hole;
};

/// The smallest of thousands of q differs from mesh to mesh, however they are made: means of twenty comparisons.
void drift(int number_of_changes, unsigned seed)
{
  Drift drift(seed);
  std::cout << std::left << std::setw(22) << "mesh, seed " + std::to_string(seed) << std::right
            << " vertices    min q   mean q      L/d     dev.   irreg.\n";
  print("before", drift.judge());
  const int interval = (std::max)(1, number_of_changes / 20);
  Judgement changed{}, at_once{}, means{}, means_at_once{};
  int comparisons = 0;
  for (int k = 1; k <= number_of_changes; ++k) {
    drift.change(k);
    if (k % interval != 0)
      continue;
    changed = drift.judge();
    at_once = drift.judge_at_once();
    ++comparisons;
    for (std::size_t i = 0; i < means.size(); ++i) {
      means[i] += (changed[i] - means[i]) / comparisons;
      means_at_once[i] += (at_once[i] - means_at_once[i]) / comparisons;
    }
  }
  print("after " + std::to_string(number_of_changes) + " changes", changed);
  print("made at once", at_once);
  print("mean on the way", means);
  print("made at once", means_at_once);
  if (!drift.is_valid())
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
  std::cout << "                     milliseconds         ratio  megabytes         milliseconds              megabytes\n"
               "    whole     part    faces    alone            faces    alone    sweep    adapt    given    adapt\n";
  for (double lengths : {11., 22.})
    for (double n : numbers)
      measure(n, lengths);
  std::cout << "                             milliseconds       megabytes\n"
               "    holes    whole     part    adapt    given    adapt    given\n";
  for (int n : {10, 30, 100})
    measure_among_holes(n);
}
