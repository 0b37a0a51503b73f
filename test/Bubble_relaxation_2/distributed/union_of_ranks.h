// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef BUBBLE_RELAXATION_2_TEST_DISTRIBUTED_UNION_OF_RANKS_H
#define BUBBLE_RELAXATION_2_TEST_DISTRIBUTED_UNION_OF_RANKS_H

#include <CGAL/Bubble_relaxation_2/internal/distributed/mesh/distributed_triangulate.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Messages.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <tuple>
#include <vector>

/// What all ranks have together, gathered: for tests, which are small.
namespace distributed {

using namespace CGAL::Bubble_relaxation_2::internal;

/// a triangle by the numbers of its vertices, from the smallest on, and which sides are constraints
struct Triangle
{
  std::array<std::int64_t, 3> vertices;
  std::array<std::int32_t, 3> is_constrained;
  std::int32_t inside;

  auto tie() const { return std::tie(vertices, is_constrained, inside); }
  bool operator<(const Triangle& other) const { return tie() < other.tie(); }
  bool operator==(const Triangle& other) const { return tie() == other.tie(); }
};

inline Triangle triangle(const Marked_triangles_2& mesh, std::size_t t,
                         const std::vector<std::int64_t>& numbers)
{
  const auto& v = mesh.vertices[t];
  int first = 0;
  for (int i = 1; i < 3; ++i)
    if (numbers[v[i]] < numbers[v[first]])
      first = i;
  Triangle result{};
  for (int i = 0; i < 3; ++i) {
    result.vertices[i] = numbers[v[(first + i) % 3]];
    result.is_constrained[i] = mesh.edges[t][(first + i) % 3] != no_index;
  }
  result.inside = mesh.inside[t];
  return result;
}

/// a triangle of a mesh of the user's, which has only those of the domain
template <class Mesh>
Triangle triangle(const Mesh& mesh, std::size_t t)
{
  const auto ids = mesh.triangle(t);
  const int first = static_cast<int>(std::min_element(ids.begin(), ids.end()) - ids.begin());
  Triangle result{};
  for (int i = 0; i < 3; ++i) {
    result.vertices[i] = ids[(first + i) % 3];
    result.is_constrained[i] = mesh.is_constrained(t, (first + i) % 3);
  }
  result.inside = 1;
  return result;
}

/// Collective. The triangles that ranks own, sorted.
template <class Mesh>
std::vector<Triangle> triangles_of_all(const Mesh& mesh)
{
  std::vector<Triangle> own;
  for (std::size_t t = 0; t < mesh.number_of_owned_triangles(); ++t)
    own.push_back(triangle(mesh, t));
  std::vector<Triangle> all = gather_records(Communicator(MPI_COMM_WORLD), own);
  std::sort(all.begin(), all.end());
  return all;
}

/// the triangles of the domain that are marked, sorted
inline std::vector<Triangle> triangles(const Marked_triangles_2& mesh,
                                       const std::vector<std::int64_t>& numbers,
                                       const std::vector<char>& marks)
{
  std::vector<Triangle> result;
  for (std::size_t t = 0; t < mesh.number_of_triangles(); ++t)
    if (marks[t])
      result.push_back(triangle(mesh, t, numbers));
  std::sort(result.begin(), result.end());
  return result;
}

/// this rank's bubbles
inline Bubbles_2 own_part(const Bubbles_2& all, const std::vector<std::int64_t>& numbers,
                          const Hilbert_partition_2& partition, int rank)
{
  Bubbles_2 result = all;
  result.id = numbers;
  std::vector<Index> own;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (partition.owner(all.x[i], all.y[i]) == rank)
      own.push_back(static_cast<Index>(i));
  result.select(own);
  result.sort_by_id();
  return result;
}

/// cuts the curve in pieces with as many bubbles each; with `with_gaps` every third rank gets none
inline Hilbert_partition_2 partition(const CGAL::Bbox_2& box, const Bubbles_2& b, int ranks, bool with_gaps)
{
  const Hilbert_curve_2 curve(box);
  std::vector<Hilbert_curve_2::Key> keys, first;
  for (std::size_t i = 0; i < b.size(); ++i)
    keys.push_back(curve.key(b.x[i], b.y[i]));
  std::sort(keys.begin(), keys.end());
  for (int r = 1; r < ranks; ++r) {
    const std::size_t k = keys.size() * static_cast<std::size_t>(r) / static_cast<std::size_t>(ranks);
    first.push_back(with_gaps && r % 3 == 2 && r > 1 ? first.back() : keys[k]);
  }
  return Hilbert_partition_2(curve, first);
}

} // namespace distributed

#endif // BUBBLE_RELAXATION_2_TEST_DISTRIBUTED_UNION_OF_RANKS_H
