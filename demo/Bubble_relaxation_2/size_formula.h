// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef BUBBLE_RELAXATION_2_DEMO_SIZE_FORMULA_H
#define BUBBLE_RELAXATION_2_DEMO_SIZE_FORMULA_H

#include "files/domain.h"

#include <CGAL/Region_sizing_field_2.h>

#include <muParser.h>

#include <cmath>
#include <functional>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>

/// d as a formula in x, y and the attribute `region`, as muParser reads it. Each thread has a parser of its own, which
/// holds the place that it is at.
class Size_formula
{
public:
  /// \throws std::runtime_error with one line if `text` is not one formula
  explicit Size_formula(const std::string& text) : m_text(std::make_shared<const std::string>(text))
  {
    check_that_nothing_is_assigned(text);
    int number_of_values = 0;
    try {
      const mu::Parser& parser = state().parser;
      parser.Eval();
      number_of_values = parser.GetNumResults();
    } catch (const mu::Parser::exception_type& e) {
      throw std::runtime_error("--size: " + e.GetMsg());
    }
    // muParser takes the last of several values, and so a decimal comma for another number
    if (number_of_values != 1)
      throw std::runtime_error("--size: '" + text + "' has " + std::to_string(number_of_values) +
                               " values; one formula is needed, and numbers have a decimal point");
  }

  /// whether it depends on the region
  bool has_region() const { return state().parser.GetUsedVar().count("region") > 0; }

  /// \throws std::runtime_error if d is not positive and finite
  template <class Point_2>
  double operator()(const Point_2& p, double region = 0) const
  {
    State& s = state();
    s.x = p.x();
    s.y = p.y();
    s.region = region;
    const double d = s.parser.Eval();
    if (!(d > 0) || !std::isfinite(d)) {
      std::ostringstream message;
      message << "--size: d(" << p.x() << ", " << p.y() << ") = "
              << (std::isnan(d) ? std::nan("") : d) // not "-nan", as 0/0 is printed
              << " must be positive and finite";
      throw std::runtime_error(message.str());
    }
    return d;
  }

private:
  struct State
  {
    explicit State(std::shared_ptr<const std::string> t) : text(std::move(t))
    {
      parser.DefineVar("x", &x);
      parser.DefineVar("y", &y);
      parser.DefineVar("region", &region);
      parser.SetExpr(*text);
    }

    std::shared_ptr<const std::string> text;
    mu::Parser parser;
    double x = 0, y = 0, region = 0;
  };

  State& state() const
  {
    thread_local std::unique_ptr<State> state; // of the formula that this thread asked last
    if (!state || state->text != m_text)
      state = std::make_unique<State>(m_text);
    return *state;
  }

  /// `x = 0.1` would overwrite the place and be its own value, which nobody means
  static void check_that_nothing_is_assigned(const std::string& text)
  {
    const auto is_comparison = [](char c) { return c == '<' || c == '>' || c == '!'; };
    for (std::size_t k = text.find('='); k != std::string::npos; k = text.find('=', k + 1)) {
      if (k + 1 < text.size() && text[k + 1] == '=')
        ++k;
      else if (k == 0 || !is_comparison(text[k - 1]))
        throw std::runtime_error("--size: '" + text + "' assigns a value; a formula in x and y is needed");
    }
  }

  std::shared_ptr<const std::string> m_text;
};

/// the sizes that a formula asks for in a domain as it is now
inline std::function<double(const Point&)> size_in_domain(const Size_formula& formula, const Domain& domain)
{
  if (!formula.has_region())
    return formula;
  return CGAL::Region_sizing_field_2<CDT>(domain.cdt, region_attributes(domain),
                                          [formula](double region, const Point& p) { return formula(p, region); });
}

#endif // BUBBLE_RELAXATION_2_DEMO_SIZE_FORMULA_H
