// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef BUBBLE_RELAXATION_2_TEST_DISTRIBUTED_RELAXED_POINTS_H
#define BUBBLE_RELAXATION_2_TEST_DISTRIBUTED_RELAXED_POINTS_H

#include "paper_domains.h"

#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Messages.h>
#include <CGAL/Distributed/npbs_relax.h>
#include <CGAL/Point_set_3.h>

#include <mpi.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

/// What `CGAL::Distributed::npbs_relax()` gives to a rank.
namespace relaxed_points {

using paper::Point;
using Points = CGAL::Point_set_3<paper::K::Point_2, paper::K::Vector_2>;
using Coordinates = std::array<double, 2>;

struct Part
{
  Points points;
  CGAL::Distributed::Relaxation_2<paper::K> relaxation;

  std::int64_t global_id(const Points::Index& i) const { return property<std::int64_t>("global_id", i); }
  double size(const Points::Index& i) const { return property<double>("size", i); }
  int dimension(const Points::Index& i) const { return property<int>("dimension", i); }

private:
  template <class T>
  T property(const char* name, const Points::Index& i) const
  {
    return CGAL::Bubble_relaxation_2::internal::Point_property<Points, T>(points, name)[i];
  }
};

/// a point as its rank has it
struct Node
{
  Coordinates place;
  double size;
  std::int64_t id;
  int dimension, owner;
  std::int64_t number_of_neighbors;
};

/// what all ranks have, in the order of the ids
struct All_parts
{
  std::vector<Node> nodes;
  std::vector<std::vector<std::int64_t>> neighbors;
};

/// Collective.
inline All_parts gather(const Part& part)
{
  using namespace CGAL::Bubble_relaxation_2::internal;
  Communicator comm(MPI_COMM_WORLD);
  const auto& offsets = part.relaxation.neighbor_offsets;
  std::vector<Node> own;
  for (const auto& i : part.points) {
    const std::size_t k = own.size();
    const Point& p = part.points.point(i);
    own.push_back(Node{{p.x(), p.y()}, part.size(i), part.global_id(i), part.dimension(i), comm.rank(),
                       static_cast<std::int64_t>(offsets.at(k + 1) - offsets[k])});
  }
  All_parts all;
  all.nodes = gather_records(comm, own);
  const std::vector<std::int64_t> neighbors = gather_records(comm, part.relaxation.neighbors);
  all.neighbors.resize(all.nodes.size());
  auto next = neighbors.begin();
  for (const Node& n : all.nodes) {
    all.neighbors.at(static_cast<std::size_t>(n.id)).assign(next, next + n.number_of_neighbors);
    next += n.number_of_neighbors;
  }
  std::sort(all.nodes.begin(), all.nodes.end(), [](const Node& n, const Node& m) { return n.id < m.id; });
  return all;
}

} // namespace relaxed_points

#endif // BUBBLE_RELAXATION_2_TEST_DISTRIBUTED_RELAXED_POINTS_H
