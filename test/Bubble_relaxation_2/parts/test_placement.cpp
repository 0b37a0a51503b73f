// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// bubbles on the outline of a domain, some edges of which take none

#include <CGAL/Bubble_relaxation_2/internal/placement/place_bubbles.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

namespace test_placement {

using namespace CGAL::Bubble_relaxation_2::internal;

TEST(Place_on_outline, edges_that_take_no_bubbles_ask_for_no_sizes)
{
  Domain_2 domain;
  const std::vector<Domain_edge_2> edges{
    {0, 1, true, false}, {1, 2, true, false, Edge_kind::RIM}, {2, 0, true, false, Edge_kind::PROTECTED}};
  ASSERT_EQ(domain.build({Point(0, 0), Point(1, 0), Point(0.5, 1)}, edges), Marking_error::NONE);
  std::size_t calls = 0;
  const Sizes_2 sizes([&calls](double, double y) {
    ++calls;
    return y > 0 ? 1e-4 : 0.1;
  });
  Given_mesh_2 given;
  given.on_edge.resize(edges.size());
  for (const On_edges way : {On_edges::PLACE_ANEW, On_edges::KEEP_THE_RIGHT_NUMBER}) {
    calls = 0;
    const Bubbles_2 bubbles = place_on_outline(domain, given, way, sizes);
    EXPECT_EQ(bubbles.size(), 3u + 9u);
    EXPECT_LT(calls, 200u);
  }
}

} // namespace test_placement
