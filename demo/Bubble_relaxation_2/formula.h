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

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

/// the values of rasters at places, by the names that they have in formulas
using Rasters = std::map<std::string, std::function<double(double x, double y)>>;

inline bool is_function(const std::string& name)
{
  return mu::Parser().GetFunDef().count(name) > 0;
}

/// A formula in x, y, the attribute `region`, the values of rasters and the `distance` to the outline, as muParser reads it.
/// Each thread has a parser of its own, which holds the place that it is at.
class Formula
{
public:
  /// \param option that has it, for messages
  /// \param rasters their names
  /// \throws std::runtime_error with one line if `text` is not one formula
  Formula(const std::string& option, const std::string& text, const std::vector<std::string>& rasters)
    : m_option(option), m_text(std::make_shared<const Text>(Text{text, rasters}))
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

  /// sets where the variables of rasters come from
  /// \throws std::runtime_error if one is used and there is none
  void set_rasters(const Rasters& rasters)
  {
    for (std::size_t k = 0; k < m_text->rasters.size(); ++k) {
      const std::string& name = m_text->rasters[k];
      if (!uses(name))
        continue;
      if (rasters.count(name) == 0)
        throw std::runtime_error(m_option + ": the variable " + name + " needs --raster");
      m_rasters.emplace_back(k, rasters.at(name));
    }
  }

  /// sets where the variable `distance` comes from, before it is asked for
  void set_distance(const std::function<double(double x, double y)>& distance) { m_distance = distance; }

  double operator()(double x, double y, double region = 0) const
  {
    State& s = state();
    for (const auto& raster : m_rasters)
      s.rasters[raster.first] = raster.second(x, y);
    if (m_distance)
      s.distance = m_distance(x, y);
    s.x = x;
    s.y = y;
    s.region = region;
    return s.parser.Eval();
  }

private:
  struct Text
  {
    std::string formula;
    std::vector<std::string> rasters;
  };

  struct State
  {
    explicit State(std::shared_ptr<const Text> t) : text(std::move(t)), rasters(text->rasters.size())
    {
      parser.DefineVar("x", &x);
      parser.DefineVar("y", &y);
      parser.DefineVar("region", &region);
      parser.DefineVar("distance", &distance);
      for (std::size_t k = 0; k < rasters.size(); ++k)
        parser.DefineVar(text->rasters[k], &rasters[k]);
      parser.SetExpr(text->formula);
    }

    std::shared_ptr<const Text> text;
    mu::Parser parser;
    double x = 0, y = 0, region = 0, distance = 0;
    std::vector<double> rasters; // as many as names
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
  std::shared_ptr<const Text> m_text;
  std::vector<std::pair<std::size_t, Rasters::mapped_type>> m_rasters; // those that it uses, by their numbers
  std::function<double(double x, double y)> m_distance;
};

#endif // BUBBLE_RELAXATION_2_DEMO_FORMULA_H
