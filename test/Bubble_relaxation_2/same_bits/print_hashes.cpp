// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// Prints the hash of each mesh, and whether it is what it should be. It needs no other library than CGAL's headers, so
// it can be compiled for any machine: `scripts/same_bits.sh` does.

#include "meshes.h"

#include <cstdlib>
#include <iomanip>
#include <iostream>

int main()
{
  bool is_same = true;
  for (const same_bits::Case& c : same_bits::cases()) {
    const std::uint64_t hash = c();
    std::cout << std::hex << std::setfill('0') << "0x" << std::setw(16) << hash << ' ' << c.name
              << (hash == c.hash ? "" : " DIFFERS") << std::endl;
    is_same = is_same && hash == c.hash;
  }
  return is_same ? EXIT_SUCCESS : EXIT_FAILURE;
}
