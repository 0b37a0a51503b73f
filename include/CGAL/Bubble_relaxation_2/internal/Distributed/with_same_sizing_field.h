// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_WITH_SAME_SIZING_FIELD_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_WITH_SAME_SIZING_FIELD_H

#include <CGAL/Bubble_relaxation_2/internal/Distributed/Agreement.h>
#include <CGAL/Bubble_relaxation_2/internal/Distributed/Communicator.h>
#include <CGAL/Bubble_relaxation_2/internal/Distributed/check_same_values.h>
#include <CGAL/Bubble_relaxation_2/internal/Distributed/read_same_domain.h>
#include <CGAL/Bubble_relaxation_2/internal/in_words.h>
#include <CGAL/Bubble_relaxation_2/internal/with_sizing_field.h>

#include <cstdint>
#include <cstring>
#include <string>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// A function cannot be compared, but how many bubbles it asks for in the domain.
inline Parameter_value sizing_function_value(double expected_number)
{
  std::uint64_t bits;
  std::memcpy(&bits, &expected_number, sizeof(bits));
  return Parameter_value{"sizing_function", bits, [](std::uint64_t b) {
                           double number;
                           std::memcpy(&number, &b, sizeof(number));
                           return "one that asks for " + in_words(number) + " bubbles";
                         }};
}

/// Collective. Calls `use(sizing, wanted)` as `with_limited_sizing_field()` does, when all ranks have got there.
/// \throws on all ranks what making the fields throws on one, and std::invalid_argument if they are not the same
template <class Cdt, class NamedParameters, class Use>
void with_same_sizing_field(const Cdt& cdt, const NamedParameters& np, const Same_domain_2<Cdt>& domain,
                            const Relaxation_options& options, const Communicator& comm, Agreement& agreement,
                            const Use& use)
{
  bool is_made = false;
  try {
    with_limited_sizing_field(cdt, np, *domain.is_inside, *domain.reading, options,
                              [&](const auto& sizing, const auto& wanted) {
                                is_made = true;
                                agreement.reach();
                                check_same_values(comm, {sizing_function_value(sizing.expected_number)});
                                use(sizing, wanted);
                              });
  } catch (...) {
    if (is_made)
      throw; // on all ranks
    agreement.keep_current();
  }
  if (!is_made)
    agreement.reach();
}

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_WITH_SAME_SIZING_FIELD_H
