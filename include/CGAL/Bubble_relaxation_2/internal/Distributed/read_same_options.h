// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_READ_SAME_OPTIONS_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_READ_SAME_OPTIONS_H

#include <CGAL/Bubble_relaxation_2/internal/Distributed/Agreement.h>
#include <CGAL/Bubble_relaxation_2/internal/Distributed/Communicator.h>
#include <CGAL/Bubble_relaxation_2/internal/Distributed/check_same_options.h>
#include <CGAL/Bubble_relaxation_2/internal/Relaxation_options.h>
#include <CGAL/Bubble_relaxation_2/internal/read_options.h>

#include <functional>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// What the user's callback throws on one rank stops all. It is kept until all ranks can throw it.
inline std::function<bool(double)> agreed_callback(const std::function<bool(double)>& callback, Agreement& agreement)
{
  if (!callback)
    return callback;
  return [callback, &agreement](double progress) {
    bool goes_on = false;
    agreement.keep([&] { goes_on = callback(progress); });
    return goes_on;
  };
}

/// Collective. Reads the named parameters that steer the simulation.
/// \throws std::invalid_argument on all ranks if one is out of its range on any rank, is not the same on all, or is
/// for one rank only
template <class NamedParameters>
Relaxation_options read_same_options(const NamedParameters& np, const Communicator& comm, Agreement& agreement)
{
  Relaxation_options options;
  agreement.reach_after([&] { options = read_options(np); });
  check_same_options(comm, options);
  agreement.reach_after([&] { options.callback = agreed_callback(options.callback, agreement); });
  return options;
}

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_READ_SAME_OPTIONS_H
