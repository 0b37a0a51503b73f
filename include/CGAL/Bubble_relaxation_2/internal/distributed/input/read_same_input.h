// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_INPUT_READ_SAME_INPUT_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_INPUT_READ_SAME_INPUT_H

#include <CGAL/Bubble_relaxation_2/internal/core/Relaxation_options.h>
#include <CGAL/Bubble_relaxation_2/internal/core/in_words.h>
#include <CGAL/Bubble_relaxation_2/internal/core/vocabulary.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Communicator.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Messages.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_2.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Problem_2.h>
#include <CGAL/Bubble_relaxation_2/internal/reading/read_input.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// a hash of numbers in their order, and of what is made of such
class Hash_of_numbers
{
public:
  void add(std::uint64_t number) { m_hash = hash_of_two(m_hash, number); }
  void add(const Point& p) { add(hash_of_place(p.x(), p.y())); }

  void add(const Domain_edge_2& e)
  {
    for (Index number : {e.source, e.target, Index(e.inside_left), Index(e.inside_right), Index(e.kind)})
      add(static_cast<std::uint64_t>(number));
  }

  /// of something with a size
  template <class Range>
  auto add(const Range& values) -> decltype(values.begin(), void())
  {
    add(std::uint64_t(values.size()));
    for (const auto& value : values)
      add(value);
  }

  std::uint64_t value() const { return m_hash; }

private:
  std::uint64_t m_hash = 0;
};

/// Collective. \throws std::invalid_argument on all ranks, with the words `what`, if not all have the same hash
inline void check_same(const Communicator& comm, std::uint64_t hash, const std::string& what)
{
  if (comm.smallest(hash) == comm.largest(hash))
    return;
  comm.throw_on_all(std::invalid_argument("Bubble_relaxation_2: " + what));
}

inline void check_same_domain(const Communicator& comm, const Domain_2& domain)
{
  Hash_of_numbers hash;
  hash.add(domain.corners());
  hash.add(domain.edges());
  check_same(comm, hash.value(), "the domain is not the same on all ranks");
}

/// the value of a parameter, in a form that any rank can compare and put into words
struct Named_value
{
  const char* name;
  double value;
  std::string (*text)(double) = [](double v) { return in_words(v); };
};

inline std::string choose_word(double value, std::initializer_list<const char*> words)
{
  const std::size_t k = static_cast<std::size_t>(value);
  return k < words.size() ? words.begin()[k] : in_words(value);
}

inline std::string true_or_false(double value) { return choose_word(value, {"false", "true"}); }

/// Collective. All ranks have values of the same parameters, in the same order.
/// \throws std::invalid_argument on all ranks if a value is not the same on all, naming the first such parameter
/// and two of its values
inline void check_same_values(const Communicator& comm, const std::vector<Named_value>& values)
{
  std::vector<double> own;
  for (const Named_value& p : values)
    own.push_back(p.value);
  std::vector<double> least = own, most = own;
  comm.reduce_each(least, MPI_MIN);
  comm.reduce_each(most, MPI_MAX);
  if (least == most)
    return;
  const std::vector<double> all = gather_records(comm, own);
  const std::size_t n = values.size();
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t rank = 1; rank * n < all.size(); ++rank)
      if (all[rank * n + k] != all[k])
        comm.throw_on_all(std::invalid_argument(std::string("Bubble_relaxation_2: parameter ") + values[k].name +
                                                " = " + values[k].text(all[k]) + " on rank 0, but " +
                                                values[k].text(all[rank * n + k]) + " on rank " +
                                                std::to_string(rank)));
}

/// Collective. Callbacks need not be the same, nor be there on all ranks.
/// \throws std::invalid_argument on all ranks if another parameter is not the same on all
inline void check_same_options(const Communicator& comm, const Relaxation_options& o)
{
  check_same_values(
    comm,
    {{"integrator", static_cast<double>(o.integrator), // other defaults depend on it
      [](double v) { return choose_word(v, {"RUNGE_KUTTA_4", "SEMI_IMPLICIT_EULER"}); }},
     {"force_coefficient", o.force_coefficient}, {"mass", o.mass}, {"damping", o.damping}, {"time_step", o.time_step},
     {"number_of_iterations", static_cast<double>(o.number_of_iterations)},
     {"neighbor_radius", o.neighbor_radius},
     {"renewal_interval", static_cast<double>(o.renewal_interval)},
     {"initial_placement", static_cast<double>(o.placement),
      [](double v) { return choose_word(v, {"KEEP", "RHOMBIC", "FRONTAL"}); }},
     {"initial_placement", static_cast<double>(o.placement_is_given),
      [](double v) { return choose_word(v, {"the default", "given"}); }},
     {"population_control", static_cast<double>(o.population),
      [](double v) { return choose_word(v, {"NONE", "OVERLAP_RATIO", "DELAUNAY"}); }},
     {"limit_by_outline", static_cast<double>(o.limit_by_outline), true_or_false},
     {"size_growth", o.size_growth}, {"minimum_angle", o.minimum_angle},
     {"displacement_tolerance", o.displacement_tolerance},
     {"exchange_interval", static_cast<double>(o.exchange_interval)},
     {"number_of_rounds", static_cast<double>(o.number_of_rounds)},
     {"defect_treatment", static_cast<double>(o.defect_treatment), true_or_false},
     {"maximum_number_of_bubbles", static_cast<double>(o.maximum_number_of_bubbles)}});
}

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

/// Collective. What `Input_2` reads, the same on all ranks; the callback need not be the same, nor be there on all.
/// \throws std::invalid_argument on all ranks if a parameter is out of its range on any rank, or if one has no domain,
/// telling which; and if parameters, the domain, or how many bubbles the sizing functions ask for are not the same
template <class Cdt, class NamedParameters>
std::unique_ptr<Input_2<Cdt>> read_same_input(const Cdt& cdt, const NamedParameters& np, Communicator& comm)
{
  std::unique_ptr<Input_2<Cdt>> input;
  comm.agree_after([&] {
    try {
      input = std::make_unique<Input_2<Cdt>>(cdt, np, std::make_shared<Progress>());
    } catch (const std::invalid_argument& e) {
      throw std::invalid_argument(std::string(e.what()) + " (on rank " + std::to_string(comm.rank()) + ")");
    }
  });
  check_same_options(comm, input->options);
  check_same_domain(comm, input->reading.domain);
  Hash_of_numbers hash; // of vertices in the domain and on edges
  hash.add(input->reading.given.pinned);
  hash.add(input->reading.given.free);
  hash.add(input->reading.given.on_edge);
  check_same(comm, hash.value(), "the domain has not the same vertices on all ranks, or not the same are pinned");
  // a sizing function cannot be compared, but how many bubbles it asks for in the domain, alone and with the outline
  const auto text = [](double v) { return "one that asks for " + in_words(v) + " bubbles"; };
  check_same_values(comm, {{"sizing_function", input->wanted.expected_number, text},
                           {"sizing_function", input->limits.sizes.expected_number, text}});
  comm.agree_after([&] { // no rank can stop alone, so all is told from here on only, and stops are remembered
    Progress& progress = *input->options.progress;
    progress = Progress(agreed_callback(read_callback(np), comm));
    progress.remember_stop();
  });
  return input;
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_INPUT_READ_SAME_INPUT_H
