// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// The same domain gives the same mesh and the same statistics, to the last bit, wherever the memory
// allocator puts vertices and faces, and in whatever order the domain was inserted.

#include "domains.h"
#include "random_seeds.h"
#include "validation.h"

#include <CGAL/Constrained_triangulation_plus_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/npbs_relax.h>

#include <memory>
#include <set>
#include <vector>

namespace test_reproducibility {

using domains::Outline;
using domains::shuffled;

using Plus = CGAL::Constrained_triangulation_plus_2<domains::CDT>;
using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
using Exact_cdt = domains::Cdt_of<Exact>;

/// Allocates and frees at random, and keeps triangulations that have nothing to do with the test, so that
/// what is built next lies elsewhere in memory, and not in increasing addresses.
class Disturbed_heap
{
public:
  void disturb(std::mt19937& random)
  {
    std::uniform_int_distribution<std::size_t> size(1, 2048);
    for (int i = 0; i < 2000; ++i)
      m_blocks.push_back(std::make_unique<char[]>(size(random)));
    std::uniform_real_distribution<double> coordinate(0, 1);
    m_triangulations.emplace_back();
    for (int i = 0; i < 300; ++i)
      m_triangulations.back().insert(domains::Point(coordinate(random), coordinate(random)));
    std::shuffle(m_blocks.begin(), m_blocks.end(), random);
    m_blocks.resize(m_blocks.size() / 2);
    if (m_triangulations.size() > 3)
      m_triangulations.erase(m_triangulations.begin() + static_cast<std::ptrdiff_t>(random() % 3));
  }

private:
  std::vector<std::unique_ptr<char[]>> m_blocks;
  std::vector<domains::CDT> m_triangulations;
};

/// All that must be equal: points, triangles of the domain and statistics.
struct Outcome
{
  std::set<validation::Xy> points;
  std::vector<validation::Triangle> triangles;
  std::vector<double> numbers;
};

template <class Cdt, class Report>
Outcome outcome(const Cdt& cdt, const Report& report)
{
  std::vector<double> numbers = validation::all_numbers(report.quality);
  for (std::size_t n : {report.number_of_steps, report.number_of_insertions, report.number_of_deletions})
    numbers.push_back(double(n));
  return {validation::snapshot(cdt).vertices, validation::triangles(cdt), numbers};
}

void expect_equal(const Outcome& a, const Outcome& b)
{
  // not EXPECT_EQ, which would print it all
  EXPECT_TRUE(a.points == b.points) << a.points.size() << " and " << b.points.size() << " points";
  EXPECT_TRUE(a.triangles == b.triangles);
  EXPECT_EQ(a.numbers, b.numbers);
}

double size(double x, double y) { return 0.04 + 0.08 * std::abs(x - 0.3 * y); }

template <class Cdt>
auto relax(Cdt& cdt, double factor)
{
  return CGAL::npbs_relax(cdt, CGAL::parameters::sizing_function([=](const auto& p) {
    return factor * size(CGAL::to_double(p.x()), CGAL::to_double(p.y()));
  }));
}

/// from scratch, and then refined and coarsened
template <class Cdt>
std::vector<Outcome> relax_repeatedly(Cdt cdt)
{
  std::vector<Outcome> outcomes;
  Cdt bare = cdt;
  const auto bare_report = CGAL::npbs_relax(bare); // at the sizes of the outline
  outcomes.push_back(outcome(bare, bare_report));
  for (double factor : {1., 0.7, 1.4}) {
    const auto report = relax(cdt, factor);
    outcomes.push_back(outcome(cdt, report));
  }
  const auto report = CGAL::npbs_relax(cdt); // at the sizes that it has
  outcomes.push_back(outcome(cdt, report));
  return outcomes;
}

/// with many symmetries: where four points lie on a circle there is a choice of triangles
std::vector<Outline> symmetric_domain()
{
  return {domains::square(-1, -1, 2), domains::square(-0.25, -0.25, 0.5),
          domains::polygon(0.6, 0.6, 0.2, 12), domains::polygon(-0.6, 0.6, 0.2, 12)};
}

/// a domain and a constraint inside it
struct Test_domain
{
  std::vector<Outline> outlines;
  Outline inner;
};

/// the edges of a star come no nearer to its centre than 0.32
std::vector<Test_domain> test_domains(std::mt19937& random)
{
  return {{symmetric_domain(), {{0.2, 0.3}, {0.4, 0.2}}},
          {domains::random_star(random()), {{0.12, 0.18}, {0.24, 0.12}}}};
}

template <class Cdt>
Cdt make(const std::vector<Outline>& outlines, const Outline& inner)
{
  Cdt cdt = domains::make<Cdt>(outlines);
  domains::insert(cdt, inner, false);
  return cdt;
}

template <class Cdt>
class Reproducibility : public testing::Test
{};

using Triangulations = testing::Types<domains::CDT, Plus, Exact_cdt>;

TYPED_TEST_SUITE(Reproducibility, Triangulations);

TYPED_TEST(Reproducibility, does_not_depend_on_addresses)
{
  std::mt19937 random(random_seeds::seed());
  Disturbed_heap heap;
  for (const Test_domain& domain : test_domains(random)) {
    const auto first = relax_repeatedly(make<TypeParam>(domain.outlines, domain.inner));
    for (int run = 0; run < 4; ++run) {
      heap.disturb(random);
      const auto again = relax_repeatedly(make<TypeParam>(domain.outlines, domain.inner));
      for (std::size_t k = 0; k < first.size(); ++k) {
        SCOPED_TRACE(k);
        expect_equal(first[k], again[k]);
      }
    }
  }
}

TYPED_TEST(Reproducibility, does_not_depend_on_the_order_of_insertion)
{
  std::mt19937 random(random_seeds::seed());
  for (const Test_domain& domain : test_domains(random)) {
    const auto first = relax_repeatedly(make<TypeParam>(domain.outlines, domain.inner));
    for (int run = 0; run < 4; ++run) {
      const auto again =
        relax_repeatedly(
          make<TypeParam>(shuffled(domain.outlines, random), {domain.inner[1], domain.inner[0]}));
      for (std::size_t k = 0; k < first.size(); ++k) {
        SCOPED_TRACE(k);
        expect_equal(first[k], again[k]);
      }
    }
  }
}

TYPED_TEST(Reproducibility, does_not_depend_on_the_order_of_free_vertices)
{
  std::mt19937 random(random_seeds::seed());
  std::uniform_real_distribution<double> coordinate(-1, 1);
  std::vector<typename TypeParam::Point> points;
  for (int i = 0; i < 400; ++i)
    points.emplace_back(coordinate(random), coordinate(random));
  for (int i = -9; i < 10; ++i) // a lattice: all of its points lie on circles
    for (int k = -9; k < 0; ++k)
      points.emplace_back(0.1 * i, 0.1 * k);
  std::vector<Outcome> outcomes;
  for (int run = 0; run < 4; ++run) {
    TypeParam cdt;
    for (const auto& p : points)
      cdt.insert(p);
    for (const Outline& o : shuffled(symmetric_domain(), random))
      domains::insert(cdt, o);
    const auto report = relax(cdt, 0.9);
    outcomes.push_back(outcome(cdt, report));
    expect_equal(outcomes[0], outcomes.back());
    std::shuffle(points.begin(), points.end(), random);
  }
}

} // namespace test_reproducibility
