// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef BUBBLE_RELAXATION_2_DEMO_EFG_ERRORS_H
#define BUBBLE_RELAXATION_2_DEMO_EFG_ERRORS_H

#include "efg_node_sets.h"

#include <CGAL/Element_free_Galerkin_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iomanip>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

namespace efg {

using Vector = paper::K::Vector_2;

// eq. 9 of the paper: -Laplace(u) = -(x^2 + y^2) e^(xy), with u = e^(xy) on the boundary and so everywhere
inline double solution(const Point& p) { return std::exp(p.x() * p.y()); }
inline Vector gradient(const Point& p) { return solution(p) * Vector(p.y(), p.x()); }

inline CGAL::Poisson_problem_2<paper::K> problem()
{
  CGAL::Poisson_problem_2<paper::K> problem;
  problem.source = [](const Point& p) { return -(p.x() * p.x() + p.y() * p.y()) * solution(p); };
  problem.dirichlet = solution;
  return problem;
}

/// Errors in the norms of eq. 10.
struct Errors
{
  double l2, h1;
  std::size_t enlarged; ///< points whose support had to be enlarged
};

/// Solves eq. 9 with nodes in a domain and tells how far the result is from the solution.
template <class NamedParameters>
Errors solve(const CDT& cdt, const Nodes& nodes, const NamedParameters& np)
{
  const CGAL::Element_free_Galerkin_2<CDT> method(cdt, nodes, np);
  const auto result = method.solve(problem());
  const auto error = result.error(solution, gradient);
  return Errors{error.l2, error.h1, result.report().number_of_enlarged_points};
}

/// The errors of several node sets of one kind.
class Error_sample
{
public:
  void add(const Errors& e)
  {
    m_l2.push_back(e.l2);
    m_h1.push_back(e.h1);
    m_with_enlarged += e.enlarged > 0;
  }

  std::size_t size() const { return m_l2.size(); }
  const std::vector<double>& l2() const { return m_l2; }
  const std::vector<double>& h1() const { return m_h1; }

  /// of how many sets some point had too few nodes
  std::size_t with_enlarged() const { return m_with_enlarged; }

  /// how many sets are better than a given one in both norms
  std::size_t better_than(const Errors& e) const
  {
    std::size_t count = 0;
    for (std::size_t k = 0; k < size(); ++k)
      count += m_l2[k] < e.l2 && m_h1[k] < e.h1;
    return count;
  }

private:
  std::vector<double> m_l2, m_h1;
  std::size_t m_with_enlarged = 0;
};

inline double minimum(const std::vector<double>& values) { return *std::min_element(values.begin(), values.end()); }
inline double maximum(const std::vector<double>& values) { return *std::max_element(values.begin(), values.end()); }

inline double median(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  return 0.5 * (values[(n - 1) / 2] + values[n / 2]);
}

inline std::string in_short(double value)
{
  std::ostringstream text;
  text << std::scientific << std::setprecision(2) << value;
  return text.str();
}

/// median [least .. largest]; of one value only that
inline std::string in_short(const std::vector<double>& values)
{
  if (values.size() == 1)
    return in_short(values[0]);
  return in_short(median(values)) + " [" + in_short(minimum(values)) + " .. " + in_short(maximum(values)) + "]";
}

inline void print_row(std::ostream& out, const std::string& name, const Error_sample& errors,
                      const std::string& remark = "")
{
  out << std::left << std::setw(42) << name << std::setw(33) << in_short(errors.l2());
  if (!remark.empty())
    out << std::setw(33);
  out << in_short(errors.h1()) << remark << '\n';
}

} // namespace efg

#endif // BUBBLE_RELAXATION_2_DEMO_EFG_ERRORS_H
