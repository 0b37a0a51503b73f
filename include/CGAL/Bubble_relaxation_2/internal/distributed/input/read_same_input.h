// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_INPUT_READ_SAME_INPUT_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_INPUT_READ_SAME_INPUT_H

#include <CGAL/Bubble_relaxation_2/internal/core/Sizes_2.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/input/hash_of_domain.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/input/same_options.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Communicator.h>
#include <CGAL/Bubble_relaxation_2/internal/reading/read_input.h>

#include <functional>
#include <memory>
#include <stdexcept>
#include <string>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// What the user's callback throws on one rank stops all. It is kept until all ranks can throw it.
inline std::function<bool(double)> agreed_callback(const std::function<bool(double)>& callback, Communicator& comm)
{
  if (!callback)
    return callback;
  return [callback, &comm](double progress) {
    bool goes_on = false;
    comm.keep([&] { goes_on = callback(progress); });
    return goes_on;
  };
}

/// The user's d on one of several ranks. What it throws is kept until all ranks can throw it; until then d is `large`,
/// so that little is done in vain.
inline Sizes_2 agreed_sizes(const Sizes_2& users, Communicator& comm, double large)
{
  Sizes_2 result([users, &comm, large](double x, double y) {
    double d = large;
    if (!comm.has_failed())
      comm.keep([&] { d = users(x, y); });
    return d;
  });
  result.expected_number = users.expected_number;
  return result;
}

/// Collective. What `Input_2` reads, the same on all ranks; the callback need not be the same, nor be there on all.
/// \throws std::invalid_argument on all ranks if a parameter is out of its range on any rank, or if one has no domain,
/// telling which; and if parameters, the domain, or how many bubbles the sizing functions ask for are not the same
template <class Cdt, class NamedParameters>
std::unique_ptr<Input_2<Cdt>> read_same_input(const Cdt& cdt, const NamedParameters& np, Communicator& comm)
{
  std::unique_ptr<Input_2<Cdt>> input;
  comm.agree_after([&] {
    try {
      input = std::make_unique<Input_2<Cdt>>(cdt, np);
    } catch (const std::invalid_argument& e) {
      throw std::invalid_argument(std::string(e.what()) + " (on rank " + std::to_string(comm.rank()) + ")");
    }
  });
  check_same_options(comm, input->options);
  check_same_domain(comm, input->reading.domain);
  check_same_vertices(comm, input->reading.given);
  check_same_sizes(comm, input->sizes.expected_number);
  comm.agree_after([&] { input->options.callback = agreed_callback(input->options.callback, comm); });
  return input;
}

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_INPUT_READ_SAME_INPUT_H
