// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_INPUT_WITH_SAME_SIZING_FIELD_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_INPUT_WITH_SAME_SIZING_FIELD_H

#include <CGAL/Bubble_relaxation_2/internal/core/in_words.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/input/read_same_domain.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Agreement.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Communicator.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Flat_triangulation_2.h>
#include <CGAL/Bubble_relaxation_2/internal/sizes/read_sizes.h>

#include <cstdint>
#include <cstring>
#include <string>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// The user's d on one of several ranks. What it throws is kept until all ranks can throw it; until then d is
/// large, so that little is done in vain.
template <class Sizing>
class Agreed_sizing_field_2
{
public:
  Agreed_sizing_field_2(const Sizing& sizing, Agreement& agreement, double large)
    : expected_number(sizing.expected_number), m_sizing(sizing), m_agreement(agreement), m_large(large)
  {}

  double operator()(double x, double y) const
  {
    double d = m_large;
    if (!m_agreement.has_failed())
      m_agreement.keep([&] { d = m_sizing(x, y); });
    return d;
  }

  double operator()(const Point& p) const { return (*this)(p.x(), p.y()); }

  const double expected_number; ///< of bubbles

private:
  const Sizing& m_sizing;
  Agreement& m_agreement;
  double m_large;
};

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

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_INPUT_WITH_SAME_SIZING_FIELD_H
