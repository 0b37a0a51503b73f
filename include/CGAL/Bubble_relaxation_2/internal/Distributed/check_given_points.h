// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_CHECK_GIVEN_POINTS_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_CHECK_GIVEN_POINTS_H

#include <CGAL/Bubble_relaxation_2/internal/Distributed/Communicator.h>
#include <CGAL/Bubble_relaxation_2/internal/Relaxation_options.h>
#include <CGAL/Bubble_relaxation_2/internal/place_bubbles.h>

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// Collective. `here`: points that this rank was given.
/// \throws std::invalid_argument on all ranks if there are any and something that goes with them is missing, or if
/// they would not be used
inline void check_given_points(const Communicator& comm, std::size_t here, bool has_sizing_function,
                               const Relaxation_options& options)
{
  const std::int64_t n = comm.sum(static_cast<std::int64_t>(here));
  if (n == 0)
    return;
  const std::string points = "Bubble_relaxation_2: parameter points has " + std::to_string(n) + " points on all ranks "
                             "together";
  if (!has_sizing_function) {
    comm.all_throw();
    throw std::invalid_argument(points + ", but there is no sizing_function; no rank has their mesh to take sizes from");
  }
  if (!options.restart_path.empty() && !keeps_given_bubbles(options)) {
    comm.all_throw();
    throw std::invalid_argument(points + ", but the simulation starts from the file restart_from = " +
                                options.restart_path);
  }
}

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_CHECK_GIVEN_POINTS_H
