// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_MESH_DISTRIBUTED_TRIANGULATE_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_MESH_DISTRIBUTED_TRIANGULATE_H

#include <CGAL/Bubble_relaxation_2/internal/distributed/mesh/Distributed_mesh_2.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Communicator.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Messages.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/parts/Hilbert_partition_2.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/parts/bubble_records.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/parts/distribute_bubbles.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/outline.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Bubble_buckets_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/disc_of_triangle.h>

#include <CGAL/Kernel/global_functions_2.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// The question whether any point that a rank does not know lies where it would change one of its triangles: in the
/// circumscribed disc, and not beyond a side that is a constraint, unless it lies on that, and is beyond by a rounding.
struct Triangle_question_2
{
  std::array<double, 3> x, y; ///< the vertices, counterclockwise
  Disc_2 disc; ///< all that matters lies in it
  std::array<std::int32_t, 3> is_hidden; ///< for each vertex, what lies beyond the opposite side
  std::int32_t vertex; ///< points near to this one matter first
  std::int32_t number; ///< of the question, among those of its rank

  Point point(int i) const { return Point(x[i], y[i]); }

  /// exact
  bool concerns(const Point& q, bool is_on_edge) const
  {
    const Point a = point(0), b = point(1), c = point(2);
    if (CGAL::side_of_bounded_circle(a, b, c, q) == ON_UNBOUNDED_SIDE)
      return false;
    for (int i = 0; i < 3; ++i)
      if (!is_on_edge && is_hidden[i] && CGAL::orientation(point(ccw(i)), point(cw(i)), q) == RIGHT_TURN)
        return false;
    return true;
  }
};

inline Triangle_question_2 make_question(const Bubble_mesh_2& mesh, Index t, const Disc_2& disc, int vertex,
                                         std::int32_t number)
{
  Triangle_question_2 question{};
  for (int i = 0; i < 3; ++i) {
    question.x[i] = mesh.point(t, i).x();
    question.y[i] = mesh.point(t, i).y();
    question.is_hidden[i] = mesh.triangles.edges[t][i] != no_index;
  }
  question.disc = disc;
  question.vertex = vertex;
  question.number = number;
  return question;
}

/// a bubble that the asker of a question did not know
struct Bubble_answer_2
{
  Bubble_record_2 bubble;
  std::int64_t question;
};

/// Answers the questions of other ranks from the bubbles of this one, and none twice to the same rank. A
/// triangle over a part of the domain that its rank hardly knows has a huge disc, so an answer names only
/// some bubbles, those next to the asker; if the triangle outlives them it will be asked about again, and the next answers
/// name twice as many.
class Query_answers_2
{
public:
  /// keeps a reference to this rank's bubbles
  explicit Query_answers_2(const Bubbles_2& own) : m_own(own) {}

  /// all ranks get what is on edges; returns whether they had that before
  bool note_outline_known()
  {
    m_inner.reset();
    return std::exchange(m_is_outline_known, true);
  }

  /// the bubble `i` was sent to `rank`
  void note_sent(int rank, Index i) { m_sent[rank].insert(i); }

  /// all that was asked at once is answered
  void end_round()
  {
    if (m_most_bubbles < m_own.size())
      m_most_bubbles *= 2;
  }

  /// adds what a question of `rank` asks for
  void operator()(int rank, const Triangle_question_2& question, std::vector<Bubble_answer_2>& answers)
  {
    if (!m_inner)
      collect();
    std::unordered_set<Index>& sent = m_sent[rank];
    std::vector<std::pair<double, Index>> found; // by distances
    m_inner->for_each_within(question.disc.x, question.disc.y, question.disc.radius, [&](const auto& e, double) {
      const std::size_t i = static_cast<std::size_t>(e.id);
      if (sent.count(e.id) == 0 && question.concerns(m_own.point(i), m_own.is_on_edge(i))) {
        const double dx = e.x - question.x[question.vertex], dy = e.y - question.y[question.vertex];
        found.emplace_back(dx * dx + dy * dy, e.id);
      }
      return true;
    });
    const std::size_t n = (std::min)(found.size(), m_most_bubbles);
    std::partial_sort(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(n), found.end());
    for (std::size_t k = 0; k < n; ++k) {
      answers.push_back({record(m_own, static_cast<std::size_t>(found[k].second)), question.number});
      sent.insert(found[k].second);
    }
  }

private:
  void collect()
  {
    const Bubbles_2& b = m_own;
    const bool is_empty = b.size() == 0;
    m_inner.emplace(1., is_empty ? 1. : b.d[0], is_empty ? 0. : b.x[0], is_empty ? 0. : b.y[0], b.size());
    for (std::size_t i = 0; i < b.size(); ++i)
      if (!b.is_corner(i) && !(m_is_outline_known && b.is_on_edge(i)))
        m_inner->insert(static_cast<Index>(i), b.x[i], b.y[i], b.d[i]);
  }

  const Bubbles_2& m_own;
  std::size_t m_most_bubbles = 12; // in one answer: about two stars at first
  bool m_is_outline_known = false;
  std::optional<Bubble_buckets_2> m_inner; // those that others may not know
  std::map<int, std::unordered_set<Index>> m_sent;
};

/// Makes each rank's part of the constrained Delaunay triangulation of the bubbles of all ranks.
///
/// All ranks get all corners, so each knows all edges and which sides of them lie in the domain. Of the others a
/// rank gets those that are near to its piece of the plane; an edge elsewhere has long pieces. It
/// triangulates what it knows and asks, for each of its triangles whose disc reaches into other pieces, their
/// owners for bubbles there; and again with what it gets, until no rank asks. A triangle about which nothing
/// unknown was found is one of the whole, and stays: no unknown bubble is in its disc. Of points on one circle
/// CGAL triangulates any subset in the same way, in whatever order they come. Where edges are nearer to each other than
/// their rounding, long pieces may cross: then all ranks get all of the outline.
class Distributed_triangulation_2
{
public:
  /// \pre bubbles `own` lie in this rank's piece or not farther than `stray` from it, and their numbers ascend
  Distributed_triangulation_2(const Domain_2& domain, const Bubbles_2& own, const Hilbert_partition_2& partition,
                              Communicator& comm, double reach, double stray)
    : m_domain(domain), m_own(own), m_partition(partition), m_comm(comm), m_stray(stray), m_answers(own)
  {
    m_mesh.bubbles = with_owner(m_own, m_comm.rank());
    get_outline(false);
    get_nearby(reach);
  }

  /// Collective.
  Distributed_mesh_2 operator()()
  {
    for (;;) {
      bool is_made = true;
      m_comm.agree_after([&] { is_made = !m_is_new || try_to_triangulate(); });
      if (m_comm.any(!is_made)) {
        get_all_of_outline();
        continue;
      }
      const Messages<Triangle_question_2> questions = questions_about_triangles();
      if (!m_comm.any(!questions.empty()))
        break;
      ask(questions);
    }
    m_mesh.mark_triangles(m_comm.rank());
    return std::move(m_mesh);
  }

private:
  /// adds what is not known of it \pre with edges: bubbles are sorted
  void get_outline(bool with_edges)
  {
    std::vector<Bubble_record_2> unknown;
    for (const Bubble_record_2& r : gather_outline(m_comm, m_own, with_edges))
      if (r.owner != m_comm.rank() && (!with_edges || m_mesh.bubbles.index_of(r.id) == no_index))
        unknown.push_back(r);
    for (const Bubble_record_2& r : unknown)
      add(m_mesh.bubbles, r, r.owner);
  }

  void get_all_of_outline()
  {
    if (m_answers.note_outline_known())
      m_comm.throw_on_all(Edges_too_near(m_domain));
    get_outline(true);
    m_is_new = true;
    m_mesh.bubbles.sort_by_id();
  }

  /// of strays it may get too few: then it will ask
  void get_nearby(double reach)
  {
    Messages<Bubble_record_2> out;
    const Bubbles_2& b = m_own;
    Clearance_2 clearance(m_partition, m_comm.rank());
    for (std::size_t i = 0; i < b.size(); ++i)
      if (!b.is_corner(i))
        for (int rank : clearance.others_in_disc(b.x[i], b.y[i], reach * b.d[i])) {
          out[rank].push_back(record(b, i));
          m_answers.note_sent(rank, static_cast<Index>(i));
        }
    deliver(m_comm, out, [&](int owner, const Bubble_record_2& r) { add(m_mesh.bubbles, r, owner); });
    m_mesh.bubbles.sort_by_id();
  }

  /// whether bubbles that follow each other are near to each other, as they are unless users have numbered them
  bool follow_space() const
  {
    constexpr double far = 30;
    const Bubbles_2& b = m_mesh.bubbles;
    double steps = 0, sizes = 0;
    for (std::size_t i = 1; i < b.size(); ++i) {
      tick(i);
      steps += length_at_most(b.x[i] - b.x[i - 1], b.y[i] - b.y[i - 1]);
      sizes += b.d[i];
    }
    return steps <= far * sizes;
  }

  /// along the curve, since CGAL searches each point from the last one
  bool try_to_triangulate()
  {
    m_is_new = false;
    if (follow_space())
      return internal::try_to_triangulate(cut_edges(m_domain, m_mesh.bubbles), m_mesh);
    Bubble_mesh_2 sorted{m_mesh.bubbles, {}};
    const std::vector<Index> order = hilbert_order(m_partition.curve(), points_of(sorted.bubbles));
    sorted.bubbles.select(order);
    const bool is_made = internal::try_to_triangulate(cut_edges(m_domain, sorted.bubbles), sorted);
    m_mesh.triangles = std::move(sorted.triangles);
    for (std::array<Index, 3>& vertices : m_mesh.triangles.vertices)
      for (Index& v : vertices)
        v = order[v];
    return is_made;
  }

  Messages<Triangle_question_2> questions_about_triangles()
  {
    Messages<Triangle_question_2> questions;
    m_asked.clear();
    if (m_comm.size() == 1)
      return questions;
    Clearance_2 clearance(m_partition, m_comm.rank());
    for (std::size_t k = 0; k < m_mesh.triangles.number_of_triangles(); ++k) {
      tick(k);
      const Index t = static_cast<Index>(k);
      const int vertex = m_mesh.triangles.inside[k] ? own_vertex(t) : -1;
      if (vertex == -1)
        continue;
      const Disc_2 disc = disc_of_triangle(m_mesh, t, m_domain.bbox());
      const auto ranks = clearance.others_in_disc(disc.x, disc.y, disc.radius + m_stray);
      if (ranks.empty() || m_is_certain.count(triangle(t)) != 0)
        continue;
      const auto question = make_question(m_mesh, t, disc, vertex, static_cast<std::int32_t>(m_asked.size()));
      m_asked.push_back(triangle(t));
      for (int rank : ranks)
        questions[rank].push_back(question);
    }
    for (auto& message : questions) // what large triangles get answers small ones too, so that less is sent
      std::sort(message.second.begin(), message.second.end(),
                [](const auto& a, const auto& b) { return a.disc.radius > b.disc.radius; });
    return questions;
  }

  /// a vertex of the triangle that this rank owns, -1 if there is none
  int own_vertex(Index t) const
  {
    for (int i = 0; i < 3; ++i)
      if (m_mesh.bubbles.is_ours(m_mesh.triangles.vertices[t][i]))
        return i;
    return -1;
  }

  Numbers_of_triangle triangle(Index t) const { return sorted_numbers(m_mesh.bubbles, m_mesh.triangles.vertices[t]); }

  void ask(const Messages<Triangle_question_2>& questions)
  {
    Messages<Bubble_answer_2> answers;
    deliver(m_comm, questions, [&](int rank, const Triangle_question_2& question) {
      m_answers(rank, question, answers[rank]);
    });
    m_answers.end_round();
    m_is_new = false;
    std::vector<char> is_open(m_asked.size(), 0);
    deliver(m_comm, answers, [&](int owner, const Bubble_answer_2& answer) {
      add(m_mesh.bubbles, answer.bubble, owner);
      is_open[static_cast<std::size_t>(answer.question)] = 1;
      m_is_new = true;
    });
    for (std::size_t k = 0; k < m_asked.size(); ++k)
      if (!is_open[k])
        m_is_certain.insert(m_asked[k]);
    if (m_is_new)
      m_mesh.bubbles.sort_by_id();
  }

  const Domain_2& m_domain;
  const Bubbles_2& m_own;
  const Hilbert_partition_2& m_partition;
  Communicator& m_comm;
  const double m_stray;
  Query_answers_2 m_answers;
  Distributed_mesh_2 m_mesh;
  bool m_is_new = true;          // there are bubbles that are not in the triangulation
  std::vector<Numbers_of_triangle> m_asked; // in this round
  std::set<Numbers_of_triangle> m_is_certain; // of those that were asked about
};

/// Collective. The part of this rank of the constrained Delaunay triangulation of the bubbles of all ranks:
/// the union of the triangles that ranks own is `triangulate(domain, all bubbles)`.
/// \param own this rank's bubbles, whose keys lie in its piece of the partition; their numbers are different
/// on all ranks and ascend
/// \param reach how far from the piece of a rank it gets the bubbles at once, in units of their own d; no
/// result depends on it, but for the ghosts
/// \param stray how far bubbles of any rank are from its piece at most
/// \throws std::runtime_error on all ranks if `triangulate()` would throw
inline Distributed_mesh_2 distributed_triangulate(const Domain_2& domain, const Bubbles_2& own,
                                                  const Hilbert_partition_2& partition, Communicator& comm,
                                                  double reach = 3, double stray = 0)
{
  return Distributed_triangulation_2(domain, own, partition, comm, reach, stray)();
}

/// Collective. The mesh of bubbles with numbers below `end`, wherever they are, as `remove_coincident()` leaves them.
inline Distributed_mesh_2 triangulate_from_anywhere(const Domain_2& domain, const Hilbert_partition_2& partition,
                                                    Communicator& comm, std::int64_t end, Bubbles_2 bubbles)
{
  remove_confusing_of_ours(comm, domain, bubbles);
  const Bubbles_2 own = bring_home_and_number(comm, partition, end, std::move(bubbles));
  return distributed_triangulate(domain, own, partition, comm);
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_MESH_DISTRIBUTED_TRIANGULATE_H
