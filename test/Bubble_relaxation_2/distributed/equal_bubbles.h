// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef BUBBLE_RELAXATION_2_TEST_DISTRIBUTED_EQUAL_BUBBLES_H
#define BUBBLE_RELAXATION_2_TEST_DISTRIBUTED_EQUAL_BUBBLES_H

#include <CGAL/Bubble_relaxation_2/internal/distributed/parts/bubble_records.h>

#include <gtest/gtest.h>

namespace bubbles {

/// all but the velocity and the identity
inline void expect_equal(const CGAL::Bubble_relaxation_2::internal::Bubble_record_2& a,
                         const CGAL::Bubble_relaxation_2::internal::Bubble_record_2& b)
{
  EXPECT_EQ(a.x, b.x);
  EXPECT_EQ(a.y, b.y);
  EXPECT_EQ(a.d, b.d);
  EXPECT_EQ(a.s, b.s);
  EXPECT_EQ(a.host, b.host);
  EXPECT_EQ(a.pin, b.pin);
  EXPECT_EQ(a.dimension, b.dimension);
}

} // namespace bubbles

#endif // BUBBLE_RELAXATION_2_TEST_DISTRIBUTED_EQUAL_BUBBLES_H
