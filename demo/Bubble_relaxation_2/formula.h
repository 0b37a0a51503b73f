// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef BUBBLE_RELAXATION_2_DEMO_FORMULA_H
#define BUBBLE_RELAXATION_2_DEMO_FORMULA_H

#include <muParser.h>

#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

/// the values of a raster at places, if there is one
using Raster_values = std::function<double(double x, double y)>;

/// A formula in x, y, the attribute `region`, the value `raster` and the `distance` to the outline, as muParser reads it.
/// Each thread has a parser of its own, which holds the place that it is at.
class Formula
{
public:
  /// \param option that has it, for messages
  /// \throws std::runtime_error with one line if `text` is not one formula
  Formula(const std::string& option, const std::string& text)
    : m_option(option), m_text(std::make_shared<const std::string>(text))
  {
    check_that_nothing_is_assigned(option, text);
    int number_of_values = 0;
    try {
      const mu::Parser& parser = state().parser;
      parser.Eval();
      number_of_values = parser.GetNumResults();
    } catch (const mu::Parser::exception_type& e) {
      throw std::runtime_error(option + ": '" + text + "': " + e.GetMsg() +
                               " (a formula of x, y, region, raster and distance; with conditions as x < 1 ? 2 : 3)");
    }
    // muParser takes the last of several values, and so a decimal comma for another number
    if (number_of_values != 1)
      throw std::runtime_error(option + ": '" + text + "' has " + std::to_string(number_of_values) +
                               " values; one formula is needed, and numbers have a decimal point");
  }

  bool uses(const std::string& variable) const { return state().parser.GetUsedVar().count(variable) > 0; }

  /// sets where the variable `raster` comes from
  /// \throws std::runtime_error if it is used and there is none
  void set_raster(const Raster_values& raster)
  {
    if (!uses("raster"))
      return;
    if (!raster)
      throw std::runtime_error(m_option + ": the variable raster needs --raster");
    m_raster = raster;
  }

  /// sets where the variable `distance` comes from, before it is asked for
  void set_distance(const std::function<double(double x, double y)>& distance) { m_distance = distance; }

  double operator()(double x, double y, double region = 0) const
  {
    State& s = state();
    if (m_raster)
      s.raster = m_raster(x, y);
    if (m_distance)
      s.distance = m_distance(x, y);
    s.x = x;
    s.y = y;
    s.region = region;
    return s.parser.Eval();
  }

private:
  struct State
  {
    explicit State(std::shared_ptr<const std::string> t) : text(std::move(t))
    {
      parser.DefineVar("x", &x);
      parser.DefineVar("y", &y);
      parser.DefineVar("region", &region);
      parser.DefineVar("raster", &raster);
      parser.DefineVar("distance", &distance);
      parser.SetExpr(*text);
    }

    std::shared_ptr<const std::string> text;
    mu::Parser parser;
    double x = 0, y = 0, region = 0, raster = 0, distance = 0;
  };

  State& state() const
  {
    thread_local std::unique_ptr<State> state; // of the formula that this thread asked last
    if (!state || state->text != m_text)
      state = std::make_unique<State>(m_text);
    return *state;
  }

  /// `x = 0.1` would overwrite the place and be its own value, which nobody means
  static void check_that_nothing_is_assigned(const std::string& option, const std::string& text)
  {
    const auto is_comparison = [](char c) { return c == '<' || c == '>' || c == '!'; };
    for (std::size_t k = text.find('='); k != std::string::npos; k = text.find('=', k + 1)) {
      if (k + 1 < text.size() && text[k + 1] == '=')
        ++k;
      else if (k == 0 || !is_comparison(text[k - 1]))
        throw std::runtime_error(option + ": '" + text + "' assigns a value; a formula in x and y is needed");
    }
  }

  std::string m_option;
  std::shared_ptr<const std::string> m_text;
  Raster_values m_raster;
  std::function<double(double x, double y)> m_distance;
};

#endif // BUBBLE_RELAXATION_2_DEMO_FORMULA_H
