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

#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

/// A formula in x, y and the attribute `region`, as muParser reads it. Each thread has a parser of its own, which holds
/// the place that it is at.
class Formula
{
public:
  /// \param option that has it, for messages
  /// \throws std::runtime_error with one line if `text` is not one formula
  Formula(const std::string& option, const std::string& text) : m_text(std::make_shared<const std::string>(text))
  {
    check_that_nothing_is_assigned(option, text);
    int number_of_values = 0;
    try {
      const mu::Parser& parser = state().parser;
      parser.Eval();
      number_of_values = parser.GetNumResults();
    } catch (const mu::Parser::exception_type& e) {
      throw std::runtime_error(option + ": " + e.GetMsg());
    }
    // muParser takes the last of several values, and so a decimal comma for another number
    if (number_of_values != 1)
      throw std::runtime_error(option + ": '" + text + "' has " + std::to_string(number_of_values) +
                               " values; one formula is needed, and numbers have a decimal point");
  }

  bool uses(const std::string& variable) const { return state().parser.GetUsedVar().count(variable) > 0; }

  double operator()(double x, double y, double region = 0) const
  {
    State& s = state();
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

  std::shared_ptr<const std::string> m_text;
};

#endif // BUBBLE_RELAXATION_2_DEMO_FORMULA_H
