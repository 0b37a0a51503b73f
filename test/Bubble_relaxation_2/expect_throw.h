// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef BUBBLE_RELAXATION_2_TEST_EXPECT_THROW_H
#define BUBBLE_RELAXATION_2_TEST_EXPECT_THROW_H

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

/// expects an exception of the type whose message contains all of `words`
template <class Exception, class Function>
void expect_throw(const Function& f, const std::vector<std::string>& words)
{
  try {
    f();
    ADD_FAILURE() << "no exception";
  } catch (const Exception& e) {
    for (const std::string& word : words)
      EXPECT_NE(std::string(e.what()).find(word), std::string::npos) << e.what() << " has no " << word;
  }
}

/// expects that an argument is refused, in these words among others
template <class Function>
void expect_invalid(const Function& f, const std::vector<std::string>& words)
{
  expect_throw<std::invalid_argument>(f, words);
}

#endif // BUBBLE_RELAXATION_2_TEST_EXPECT_THROW_H
