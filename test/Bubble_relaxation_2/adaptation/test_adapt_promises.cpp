// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// What is promised of parts that are meshed anew: the same bits whatever the order and the threads, nothing left
// behind by errors, visitors that are told all, the part that sizes ask for, and quality that does not drift.

#include "adaptation_checks.h"
#include "counted_memory.h"
#include "domains.h"
#include "expect_throw.h"
#include "validation.h"

#include <CGAL/Default_adaptation_visitor_2.h>
#include <CGAL/Mesh_quality_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/npbs_adapt.h>
#include <CGAL/npbs_relax.h>
#include <CGAL/transfer_2.h>

#include <boost/range/adaptor/transformed.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <map>
#include <random>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace test_adapt_promises {

using adaptation::faces_near;
using adaptation::Plus;
using adaptation::size;
using counted_memory::allocations_left;
using domains::CDT;
using domains::hole;
using domains::Outline;
using domains::Point;
using domains::slanted;
using validation::Content;
using Faces = std::vector<CDT::Face_handle>;

template <class Cdt = CDT>
Cdt mesh(double d = 0.05)
{
  return domains::mesh<Cdt>({slanted, hole}, d);
}

struct Stop : std::exception {};

/// throws in one of its functions, and remembers that it came so far
struct Throwing_visitor : CGAL::Default_adaptation_visitor_2<CDT>
{
  int where = 0;

  void before_change(const Faces&, const Vertices&) { stop_at(1); }
  void while_both_exist(const Faces&, const Vertices&, const Faces&, const Vertices&) { stop_at(2); }
  void after_change(const Faces&, const Vertices&) { stop_at(3); }

private:
  void stop_at(int place) const
  {
    if (where == place)
      throw Stop();
  }
};

TEST(Adapt_determinism, bits_do_not_depend_on_the_order_of_faces)
{
  std::vector<std::vector<validation::Triangle>> results;
  std::mt19937 random(5);
  for (int turn = 0; turn < 4; ++turn) {
    CDT cdt = mesh();
    Faces part = faces_near(cdt, 0.5, 0.2, 0.3);
    std::shuffle(part.begin(), part.end(), random);
    if (turn == 3)
      part.insert(part.end(), part.begin(), part.begin() + 7); // twice
    CGAL::npbs_remesh_faces(cdt, part, size(0.03));
    results.push_back(validation::triangles(cdt));
  }
  EXPECT_TRUE(results[0] == results[1]);
  EXPECT_TRUE(results[0] == results[2]);
  EXPECT_TRUE(results[0] == results[3]);
  EXPECT_FALSE(results[0] == validation::triangles(mesh()));
}

/// the same mesh, whose faces number their corners in another way
CDT turned(const CDT& cdt)
{
  CDT result(cdt);
  std::mt19937 random(7);
  for (CDT::Face_handle f : result.all_face_handles())
    for (auto k = random() % 3; k > 0; --k)
      f->ccw_permute();
  return result;
}

TEST(Adapt_determinism, bits_do_not_depend_on_how_faces_number_their_corners)
{
  const auto expect_same = [](CDT& cdt, const auto& d) {
    CDT other = turned(cdt);
    ASSERT_TRUE(validation::triangles(other) == validation::triangles(cdt));
    EXPECT_GT(CGAL::npbs_adapt(cdt, size(d)).number_of_triangles, 0u);
    CGAL::npbs_adapt(other, size(d));
    EXPECT_TRUE(validation::triangles(other) == validation::triangles(cdt));
  };
  CDT sharp = domains::mesh({Outline{{0, 0}, {1, 0}, {1, 0.25}}}, 0.05);
  expect_same(sharp, 0.025);
  for (double reach : {0.25, 0.3}) {
    const auto jump = [&reach](const Point& p) {
      return std::hypot(p.x() - 0.45, p.y() - 0.5) < reach ? 0.06 / 1.8 : 0.06;
    };
    CDT cdt = domains::mesh({domains::square(0, 0, 1)}, std::cref(jump));
    reach += 0.05;
    expect_same(cdt, std::cref(jump));
  }
}

TEST(Adapt_determinism, hierarchies_do_not_change_the_mesh)
{
  CDT plain = mesh();
  Plus plus = mesh<Plus>();
  for (double d : {0.03, 0.08}) {
    CGAL::npbs_remesh_faces(plain, faces_near(plain, 1, 0.1, 0.4), size(d));
    CGAL::npbs_remesh_faces(plus, faces_near(plus, 1, 0.1, 0.4), size(d));
    EXPECT_TRUE(validation::triangles(plain) == validation::triangles(plus));
  }
}

/// constraints keep their identifiers and consist of edges of the triangulation
TEST(Adapt_hierarchy, constraints_keep_their_identifiers)
{
  Plus cdt;
  std::vector<Plus::Constraint_id> ids;
  for (const Outline& outline : {slanted, hole})
    for (std::size_t k = 0; k < outline.size(); ++k) {
      const auto &p = outline[k], &q = outline[(k + 1) % outline.size()];
      ids.push_back(cdt.insert_constraint(Point(p.first, p.second), Point(q.first, q.second)));
    }
  CGAL::npbs_relax(cdt, size(0.05));
  std::size_t last = 0;
  for (double d : {0.02, 0.1, 0.04}) {
    CGAL::npbs_remesh_faces(cdt, faces_near(cdt, 1.1, 0.9, 0.4), size(d));
    CGAL::npbs_remesh_faces(cdt, faces_near(cdt, 0.5, 0.4, 0.25), size(d));
    ASSERT_EQ(cdt.number_of_constraints(), ids.size());
    std::size_t vertices = 0, edges = 0;
    for (const Plus::Constraint_id& id : ids) {
      auto before = cdt.vertices_in_constraint_begin(id), v = before;
      for (++v; v != cdt.vertices_in_constraint_end(id); ++v, ++before) {
        Plus::Face_handle f;
        int i = 0;
        ASSERT_TRUE(cdt.is_edge(*before, *v, f, i));
        EXPECT_TRUE(f->is_constrained(i));
        ++edges;
      }
      vertices += static_cast<std::size_t>(
        std::distance(cdt.points_in_constraint_begin(id), cdt.points_in_constraint_end(id)));
    }
    EXPECT_EQ(edges, validation::snapshot(cdt).constraints.size());
    EXPECT_EQ(vertices, edges + ids.size()); // no points of vertices that are gone
    EXPECT_NE(edges, last);
    last = edges;
  }
}

TEST(Adapt_errors, nothing_is_left_behind_by_what_users_throw)
{
  CDT cdt = mesh();
  const Faces part = faces_near(cdt, 0.5, 0.1, 0.3);
  const Content<CDT> before(cdt);
  std::size_t calls = 0;
  const auto throwing_d = [&calls](const Point&) {
    if (++calls == 2000)
      throw Stop();
    return 0.03;
  };
  EXPECT_THROW(CGAL::npbs_remesh_faces(cdt, part, size(std::cref(throwing_d))), Stop);
  EXPECT_TRUE(Content<CDT>(cdt) == before);
  const std::function<bool(double)> callback = [](double progress) { return progress == 1 ? throw Stop() : true; };
  EXPECT_THROW(CGAL::npbs_remesh_faces(cdt, part, size(0.03).callback(callback)), Stop);
  EXPECT_TRUE(Content<CDT>(cdt) == before);
  Throwing_visitor visitor;
  for (visitor.where = 1; visitor.where <= 2; ++visitor.where) {
    EXPECT_THROW(CGAL::npbs_remesh_faces(cdt, part, size(0.03).visitor(visitor)), Stop);
    EXPECT_TRUE(Content<CDT>(cdt) == before);
  }
  EXPECT_TRUE(cdt.is_valid());
  // the last one comes when all is done
  EXPECT_THROW(CGAL::npbs_remesh_faces(cdt, part, size(0.03).visitor(visitor)), Stop);
  EXPECT_FALSE(Content<CDT>(cdt) == before);
  validation::expect_valid_mesh(cdt);
}

/// in triangulations with and without polylines of constraints
template <class Cdt>
struct Adapt_writing : testing::Test
{
  Cdt cdt = mesh<Cdt>();
  std::vector<typename Cdt::Face_handle> part = faces_near(cdt, 0.5, 0.1, 0.3);
  std::vector<double> calls; // while the part is written

  /// `obey(calls)`: what the callback returns while the part is written. It is slow there at first, so that it is
  /// called wherever it may be.
  template <class Obey>
  auto remesh(const Obey& obey, bool restores)
  {
    constexpr double begin_of_writing = 0.95;
    calls.clear();
    const auto callback = [&](double progress) {
      if (progress < begin_of_writing)
        return true;
      if (calls.size() < 12)
        std::this_thread::sleep_for(std::chrono::milliseconds(45));
      calls.push_back(progress);
      return obey(calls);
    };
    return CGAL::npbs_remesh_faces(cdt, part, size(0.03).callback(callback).restore_when_stopped(restores));
  }
};

using Adapted = testing::Types<CDT, Plus>;
TYPED_TEST_SUITE(Adapt_writing, Adapted, );

TYPED_TEST(Adapt_writing, tells_that_it_goes_on)
{
  const auto report = this->remesh([](const auto&) { return true; }, true);
  EXPECT_EQ(report.stop_reason, CGAL::Bubble_stop_reason::CONVERGED);
  EXPECT_GE(this->calls.size(), 10u);
  EXPECT_TRUE(std::is_sorted(this->calls.begin(), this->calls.end()));
  EXPECT_GT(std::set<double>(this->calls.begin(), this->calls.end()).size(), 4u);
  EXPECT_EQ(this->calls.back(), 1);
  EXPECT_EQ(std::count(this->calls.begin(), this->calls.end(), 1.), 1);
}

TYPED_TEST(Adapt_writing, a_stop_or_an_exception_leaves_all_handles)
{
  TypeParam other = this->cdt;
  const Content<TypeParam> before(this->cdt);
  for (std::size_t last : {1u, 2u, 5u, 10u, 1000u}) { // the last time when all is done
    SCOPED_TRACE(last);
    const auto goes_on = [last](const auto& calls) { return calls.size() < last && calls.back() < 1; };
    const auto report = this->remesh(goes_on, true);
    EXPECT_EQ(report.stop_reason, CGAL::Bubble_stop_reason::STOPPED_BY_CALLBACK);
    EXPECT_EQ(report.number_of_vertices, 0u);
    EXPECT_TRUE(this->calls.size() == last || this->calls.back() == 1);
    EXPECT_TRUE(Content<TypeParam>(this->cdt) == before);
    EXPECT_THROW(this->remesh([&](const auto& calls) { return goes_on(calls) ? true : throw Stop(); }, false), Stop);
    EXPECT_TRUE(Content<TypeParam>(this->cdt) == before);
  }
  CGAL::npbs_remesh_faces(this->cdt, this->part, size(0.03));
  CGAL::npbs_remesh_faces(other, faces_near(other, 0.5, 0.1, 0.3), size(0.03));
  EXPECT_EQ(validation::triangles(this->cdt), validation::triangles(other));
}

TYPED_TEST(Adapt_writing, a_stop_without_restoring_leaves_the_whole_part)
{
  TypeParam other = this->cdt;
  const auto report = this->remesh([](const auto& calls) { return calls.size() < 3; }, false);
  EXPECT_EQ(report.stop_reason, CGAL::Bubble_stop_reason::CONVERGED);
  EXPECT_EQ(this->calls.size(), 3u); // it is not called again
  CGAL::npbs_remesh_faces(other, faces_near(other, 0.5, 0.1, 0.3), size(0.03));
  EXPECT_EQ(validation::triangles(this->cdt), validation::triangles(other));
}

/// a user who looks at the mesh, for long, when it can no more be given back
template <class Cdt>
struct Late_looker : CGAL::Default_adaptation_visitor_2<Cdt>
{
  using Base = CGAL::Default_adaptation_visitor_2<Cdt>;

  const Cdt& cdt;
  explicit Late_looker(const Cdt& t) : cdt(t) {}

  void look() const
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(45));
    EXPECT_GT(CGAL::mesh_quality_2(cdt).mean_quality(), 0.5);
  }

  void while_both_exist(const typename Base::Faces&, const typename Base::Vertices&, const typename Base::Faces&,
                        const typename Base::Vertices&)
  {
    look();
  }

  void after_change(const typename Base::Faces&, const typename Base::Vertices&) { look(); }
};

TYPED_TEST(Adapt_writing, nothing_is_told_when_all_is_done)
{
  std::size_t calls_at_end = 0;
  const auto callback = [&](double progress) {
    calls_at_end += progress == 1;
    return calls_at_end < 2; // which would leave half of the work done
  };
  const auto report = CGAL::npbs_remesh_faces(
    this->cdt, this->part,
    size(0.03).callback(callback).restore_when_stopped(true).visitor(Late_looker<TypeParam>(this->cdt)));
  EXPECT_EQ(calls_at_end, 1u);
  EXPECT_EQ(report.stop_reason, CGAL::Bubble_stop_reason::CONVERGED);
  validation::expect_valid_mesh(this->cdt);
}

TEST(Adapt_errors, nothing_is_left_behind_where_memory_ends)
{
  CDT cdt = mesh(0.1);
  const Faces part = faces_near(cdt, 0.4, 0.1, 0.25);
  const Content<CDT> before(cdt);
  std::size_t failures = 0;
  for (long n = 0;; n += 1 + n / 60) {
    bool has_failed = false;
    allocations_left = n;
    try {
      CGAL::npbs_remesh_faces(cdt, part, size(0.07));
    } catch (const std::bad_alloc&) {
      has_failed = true;
    }
    allocations_left = -1;
    if (!has_failed)
      break;
    ++failures;
    ASSERT_TRUE(Content<CDT>(cdt) == before) << n;
  }
  EXPECT_GT(failures, 100u);
  EXPECT_FALSE(Content<CDT>(cdt) == before);
  validation::expect_valid_mesh(cdt);
}

/// The callback is asked while the faces are looked at, too, which may be millions.
TEST(Adapt_errors, a_stop_before_all_faces_are_known)
{
  CDT cdt = mesh();
  const CDT other = mesh();
  const Content<CDT> before(cdt);
  Faces part = faces_near(cdt, 0.5, 0.2, 0.2);
  part.push_back(other.infinite_face()); // which is an error, if it is reached
  const auto slowly = part | boost::adaptors::transformed([](CDT::Face_handle f) {
                        std::this_thread::sleep_for(std::chrono::milliseconds(1));
                        return f;
                      });
  int calls = 0;
  const auto report =
    CGAL::npbs_remesh_faces(cdt, slowly, size(0.03).callback([&calls](double) { return ++calls == 1; }));
  EXPECT_EQ(calls, 2);
  EXPECT_EQ(report.stop_reason, CGAL::Bubble_stop_reason::STOPPED_BY_CALLBACK);
  EXPECT_EQ(report.number_of_triangles, 0u);
  EXPECT_TRUE(Content<CDT>(cdt) == before);
}

TEST(Adapt_errors, bad_input_is_told_before_any_change)
{
  CDT cdt = mesh();
  const CDT other = mesh();
  const Content<CDT> before(cdt);
  const Faces part = faces_near(cdt, 0.5, 0.2, 0.2);
  const auto remesh = [&](const Faces& faces) {
    return [&cdt, faces] { CGAL::npbs_remesh_faces(cdt, faces, size(0.03)); };
  };
  expect_invalid(remesh({}), {"faces", "empty"});
  expect_invalid(remesh({part[0], CDT::Face_handle()}), {"faces", "empty handle"});
  expect_invalid(remesh({part[0], cdt.tds().faces().end()}), {"faces", "none of this triangulation"});
  expect_invalid(remesh({part[0], cdt.infinite_face()}), {"faces", "infinite"});
  expect_invalid(remesh(faces_near(other, 0.5, 0.2, 0.2)), {"faces", "none of this triangulation"});
  expect_invalid(remesh({part[0], faces_near(other, 0.5, 0.2, 0.2)[0]}), {"faces", "none of this triangulation"});
  expect_invalid(remesh({part[0], cdt.locate(Point(0.52, 0.5))}), {"faces", "not marked", "(0."});
  expect_invalid([&] { CGAL::npbs_remesh_faces(cdt, part, size(-1.)); }, {"sizing_function", "-1"});
  expect_invalid([&] { CGAL::npbs_remesh_faces(cdt, part, size(0.1).time_step(-2.)); }, {"time_step", "-2"});
  expect_invalid([&] { CGAL::npbs_adapt(cdt, size(0.1).longest_edge(0.5)); }, {"longest_edge", "0.5", "greater"});
  expect_invalid([&] { CGAL::npbs_adapt(cdt, size(0.1).shortest_edge(1.5)); }, {"shortest_edge", "1.5", "less than 1"});
  expect_invalid([&] { CGAL::npbs_adapt(cdt, size(0.1).misfit_angle(60.)); }, {"misfit_angle", "60", "33"});
  expect_invalid([&] { CGAL::npbs_adapt(cdt, size(0.1).misfit_quality(1.)); }, {"misfit_quality", "1", "0.9"});
  expect_invalid([&] { CGAL::npbs_adapt(cdt, size(0.1).number_of_rings(-1)); }, {"number_of_rings", "-1"});
  expect_throw<std::length_error>(
    [&] { CGAL::npbs_remesh_faces(cdt, faces_near(cdt, 0, 0, 9), size(1e-6).maximum_number_of_bubbles(1000)); },
    {"maximum_number_of_bubbles", "1000"});
  CDT line;
  line.insert(Point(0, 0));
  line.insert(Point(1, 0));
  expect_invalid([&] { CGAL::npbs_remesh_faces(line, part, size(0.1)); }, {"faces", "dimension is 1"});
  EXPECT_TRUE(Content<CDT>(cdt) == before);
  for (CDT::Face_handle f : cdt.finite_face_handles())
    f->set_in_domain(false);
  expect_invalid([&] { CGAL::npbs_adapt(cdt, size(0.1)); }, {"no face", "marked", "npbs_relax"});
}

/// counts what it is told, and checks what exists when
struct Accountant : CGAL::Default_adaptation_visitor_2<CDT>
{
  const CDT& cdt;
  int calls = 0;
  Faces old_faces, new_faces;
  Vertices removed, added;

  explicit Accountant(const CDT& t) : cdt(t) {}

  void before_change(const Faces& faces, const Vertices& vertices)
  {
    EXPECT_EQ(calls++, 0);
    old_faces = faces;
    removed = vertices;
    EXPECT_TRUE(cdt.is_valid());
  }

  void while_both_exist(const Faces& faces, const Vertices& vertices, const Faces& now, const Vertices& created)
  {
    EXPECT_EQ(calls++, 1);
    EXPECT_TRUE(faces == old_faces && vertices == removed);
    new_faces = now;
    added = created;
    EXPECT_NEAR(area(old_faces), area(new_faces), 1e-13);
  }

  void after_change(const Faces& now, const Vertices& created)
  {
    EXPECT_EQ(calls++, 2);
    EXPECT_TRUE(now == new_faces && created == added);
    EXPECT_TRUE(cdt.is_valid());
  }

  static double area(const Faces& faces)
  {
    double sum = 0;
    for (CDT::Face_handle f : faces)
      sum += CGAL::area(f->vertex(0)->point(), f->vertex(1)->point(), f->vertex(2)->point());
    return sum;
  }
};

TEST(Adapt_visitor, is_told_all)
{
  for (double radius : {0.2, 9.}) {
    CDT cdt = mesh();
    const Content<CDT> before(cdt);
    const Faces part = faces_near(cdt, 0.5, 0.1, radius);
    Accountant account(cdt);
    CGAL::npbs_remesh_faces(cdt, part, size(0.03).visitor(std::ref(account)));
    EXPECT_EQ(account.calls, 3);
    EXPECT_TRUE(account.old_faces == part);
    const Content<CDT> after(cdt);
    std::size_t in_domain_before = 0, in_domain_after = 0;
    for (const auto& [f, c] : before.faces)
      in_domain_before += c.flags.back();
    for (const auto& [f, c] : after.faces)
      in_domain_after += c.flags.back();
    EXPECT_EQ(in_domain_after + part.size(), in_domain_before + account.new_faces.size());
    EXPECT_EQ(after.vertices.size() + account.removed.size(), before.vertices.size() + account.added.size());
    EXPECT_GT(account.removed.size(), 0u);
    for (CDT::Vertex_handle v : account.added)
      EXPECT_EQ(after.vertices.count(v), 1u);
    for (CDT::Face_handle f : account.new_faces) {
      ASSERT_EQ(after.faces.count(f), 1u);
      EXPECT_TRUE(after.faces.at(f).flags.back());
    }
    // what is neither removed nor new has kept its place
    const std::set<CDT::Vertex_handle> removed(account.removed.begin(), account.removed.end());
    for (const auto& [v, p] : before.vertices)
      if (removed.count(v) == 0) {
        ASSERT_EQ(after.vertices.count(v), 1u);
        EXPECT_EQ(after.vertices.at(v), p);
      }
  }
}

/// a vertex that comes out where it was is the same one
TEST(Adapt_visitor, vertices_at_their_old_places_keep_their_handles)
{
  CDT cdt = mesh();
  const Faces part = faces_near(cdt, 0.25, 0.3, 0.15);
  const Content<CDT> before(cdt);
  Accountant account(cdt);
  const auto np = size(0.05).initial_placement(CGAL::Bubble_placement::KEEP).number_of_rounds(0);
  CGAL::npbs_remesh_faces(cdt, part, np.visitor(std::ref(account)));
  EXPECT_EQ(account.calls, 3);
  EXPECT_TRUE(account.removed.empty());
  EXPECT_TRUE(account.added.empty());
  EXPECT_TRUE(Content<CDT>(cdt).vertices == before.vertices);
}

/// values in faces go from the old ones to the new ones while both exist
TEST(Adapt_visitor, can_transfer_values)
{
  struct Transfer : CGAL::Default_adaptation_visitor_2<CDT>
  {
    const CDT* cdt = nullptr;
    std::map<CDT::Face_handle, double>* values = nullptr;

    void while_both_exist(const Faces& old_faces, const Vertices&, const Faces& new_faces, const Vertices&) const
    {
      std::map<CDT::Face_handle, double> result;
      CGAL::transfer_face_values_2(*cdt, boost::make_assoc_property_map(*values), *cdt,
                                   boost::make_assoc_property_map(result),
                                   CGAL::parameters::source_faces(old_faces).target_faces(new_faces));
      for (CDT::Face_handle f : old_faces)
        values->erase(f);
      values->insert(result.begin(), result.end());
    }
  };
  CDT cdt = mesh();
  std::map<CDT::Face_handle, double> values;
  const auto integral = [&] {
    double sum = 0;
    for (const auto& [f, value] : values)
      sum += value * CGAL::to_double(cdt.triangle(f).area());
    return sum;
  };
  for (CDT::Face_handle f : cdt.finite_face_handles())
    if (f->is_in_domain())
      values[f] = 1 + f->vertex(0)->point().x();
  const double before = integral();
  Transfer transfer;
  transfer.cdt = &cdt;
  transfer.values = &values;
  for (double d : {0.02, 0.06})
    CGAL::npbs_remesh_faces(cdt, faces_near(cdt, 0.5, 0.2, 0.2), size(d).visitor(transfer));
  EXPECT_NEAR(integral(), before, 1e-12);
  std::size_t faces = 0;
  for (CDT::Face_handle f : cdt.finite_face_handles())
    faces += f->is_in_domain() && values.count(f) == 1;
  EXPECT_EQ(faces, values.size());
}

} // namespace test_adapt_promises
