// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef BUBBLE_RELAXATION_2_TEST_DISTRIBUTED_BUBBLES_H
#define BUBBLE_RELAXATION_2_TEST_DISTRIBUTED_BUBBLES_H

#include "../../../demo/Bubble_relaxation_2/paper_domains.h"
#include "../random_seeds.h"

#include <CGAL/Bubble_relaxation_2/internal/domain/outline.h>
#include <CGAL/Bubble_relaxation_2/internal/reading/read_input.h>
#include <CGAL/Bubble_relaxation_2/internal/relaxation/relax_bubbles.h>
#include <CGAL/Bubble_relaxation_2/internal/sizes/Outline_sizes_2.h>
#include <CGAL/npbs_relax.h>

#include <cmath>
#include <memory>
#include <random>
#include <vector>

/// Domains with bubbles in them, the same on all ranks.
namespace bubbles {

using namespace CGAL::Bubble_relaxation_2::internal;
using Input = Input_2<paper::CDT>;

/// d at coordinates
inline Sizes_2 sizes_of(const paper::Sizing& d)
{
  return Sizes_2([d](double x, double y) { return d(Point(x, y)); });
}

struct Case
{
  paper::CDT cdt;
  std::unique_ptr<Input> input;
  Bubbles_2 bubbles;

  /// reads the domain and the parameters, which have to exist as long as the input is asked for sizes
  template <class NamedParameters>
  void read(const NamedParameters& np)
  {
    input = std::make_unique<Input>(cdt, np, std::make_shared<Progress>());
    *input->options.progress = Progress(read_callback(np)); // nothing is told of the reading
  }

  const Domain_2& domain() const { return input->problem().domain; }
  const Given_mesh_2& given() const { return input->problem().given; }
};

inline Case read(const paper::Domain& domain)
{
  Case c{paper::triangulate(domain), nullptr, {}};
  c.read(CGAL::parameters::sizing_function(domain.d).limit_by_outline(false));
  return c;
}

/// d as a simulation in the domain of `c` asks it \pre `d` outlives this
template <class Size>
Sizes_2 sizes_in(const Case& c, const Size& d)
{
  Sizes_2 result([&d](double x, double y) { return d(Point(x, y)); });
  count_bubbles(c.domain(), default_maximum_number_of_bubbles, "d", result);
  return result;
}

/// bubbles that have almost come to rest, or had little time for it
inline Case relaxed(const paper::Domain& domain, int rounds = 2, int iterations = 20)
{
  Case c{paper::triangulate(domain), nullptr, {}};
  const auto np =
    CGAL::parameters::sizing_function(domain.d).number_of_rounds(rounds).number_of_iterations(iterations);
  c.read(np);
  Report report;
  c.bubbles = relax_bubbles(c.input->problem(), report);
  return c;
}

/// the mesh of all bubbles
inline Bubble_mesh_2 mesh_of(const Case& c)
{
  Bubble_mesh_2 result{c.bubbles, {}};
  triangulate(c.domain(), result);
  return result;
}

/// corners, and `cuts` bubbles on each edge at equal distances
inline void add_outline(Case& c, int cuts, double d)
{
  const Domain_2& domain = c.domain();
  for (std::size_t i = 0; i < domain.corners().size(); ++i)
    c.bubbles.add(domain.corners()[i], d, Bubbles_2::CORNER, static_cast<Index>(i));
  for (std::size_t e = 0; e < domain.edges().size(); ++e)
    for (int k = 1; k <= cuts; ++k) {
      const double s = double(k) / (cuts + 1);
      const Index edge = static_cast<Index>(e);
      c.bubbles.add(domain.point_on_edge(edge, s), d, Bubbles_2::EDGE, edge, s);
    }
}

/// adds a bubble to the inside if it is there and not on an edge
inline void add_inside(Case& c, const Point& p, double d)
{
  Index hint = 0;
  const Index t = c.domain().locate_inside(p, hint);
  if (t == no_index)
    return;
  for (std::size_t e = 0; e < c.domain().edges().size(); ++e) {
    const Point &a = c.domain().source(Index(e)), &b = c.domain().target(Index(e));
    if (CGAL::orientation(a, b, p) == CGAL::COLLINEAR && CGAL::collinear_are_ordered_along_line(a, p, b))
      return;
  }
  c.bubbles.add(p, d, Bubbles_2::FACE, t);
}

/// n random points in the box of the domain, those of them that are in it
inline Case random(const paper::Domain& domain, int n, unsigned seed)
{
  Case c = read(domain);
  const CGAL::Bbox_2 box = c.domain().bbox();
  const double d = std::sqrt((box.xmax() - box.xmin()) * (box.ymax() - box.ymin()) / n);
  add_outline(c, 3, d);
  std::mt19937 engine(random_seeds::seed(seed));
  std::uniform_real_distribution<double> x(box.xmin(), box.xmax()), y(box.ymin(), box.ymax());
  for (int i = 0; i < n; ++i) {
    const double px = x(engine);
    add_inside(c, Point(px, y(engine)), d);
  }
  return c;
}

/// A triangle with sides of length n, and the points of the lattice of triangles with sides of length 1 in it: all
/// triangles are equilateral.
inline Case equilateral(int n)
{
  const double s = n, height = std::sqrt(0.75);
  Case c = read(paper::Domain{0, "equilateral", {{{0, 0}, {s, 0}, {s / 2, s * height}}}, 
                                [](const Point&) { return 1.; }, 1, 1});
  add_outline(c, n - 1, 1);
  for (int row = 1; row < n; ++row)
    for (int k = 1; k < n - row; ++k)
      add_inside(c, Point(k + row / 2., row * height), 1);
  return c;
}

/// a square from 0 to n with edges through it, and the points with integer coordinates
inline Case lattice(int n)
{
  const double s = n, m = n / 2;
  // straight, and slanted ones that cut the squares of the lattice
  const paper::Domain square{0, "lattice",
                             {{{0, 0}, {s, 0}, {s, s}, {0, s}}}, [](const Point&) { return 1.; }, 1, 1};
  Case c{paper::triangulate(square), nullptr, {}};
  c.cdt.insert_constraint(Point(2, m), Point(s - 3, m));
  c.cdt.insert_constraint(Point(1, 1), Point(2, s - 2));
  c.cdt.insert_constraint(Point(m, 2), Point(s - 2, m - 2));
  c.cdt.insert_constraint(Point(m, m + 2), Point(s - 1.5, s - 1.5));
  c.read(CGAL::parameters::sizing_function(square.d).limit_by_outline(false));
  for (std::size_t i = 0; i < c.domain().corners().size(); ++i)
    c.bubbles.add(c.domain().corners()[i], 1, Bubbles_2::CORNER, Index(i));
  for (int row = 0; row <= n; ++row)
    for (int column = 0; column <= n; ++column) {
      const Point p(column, row);
      bool is_corner = false;
      for (const Point& q : c.domain().corners())
        is_corner = is_corner || p == q;
      for (std::size_t e = 0; e < c.domain().edges().size() && !is_corner; ++e) {
        const Index edge = Index(e);
        const Point &a = c.domain().source(edge), &b = c.domain().target(edge);
        if (CGAL::collinear(a, b, p) && CGAL::collinear_are_strictly_ordered_along_line(a, p, b)) {
          c.bubbles.add(p, 1, Bubbles_2::EDGE, edge,
                        std::hypot(p.x() - a.x(), p.y() - a.y()) / c.domain().length(edge));
          is_corner = true;
        }
      }
      if (!is_corner)
        add_inside(c, p, 1);
    }
  return c;
}

/// forgets some of the bubbles that are not on the outline
inline void thin_out(Bubbles_2& b, double share, unsigned seed)
{
  std::mt19937 engine(random_seeds::seed(seed));
  std::uniform_real_distribution<double> uniform(0, 1);
  for (std::size_t i = 0; i < b.size(); ++i)
    if (b.is_in_face(i) && uniform(engine) < share)
      b.remove(i);
  b.forget_gone();
}

} // namespace bubbles

#endif // BUBBLE_RELAXATION_2_TEST_DISTRIBUTED_BUBBLES_H
