// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef BUBBLE_RELAXATION_2_EXAMPLES_SIZE_FORMULA_H
#define BUBBLE_RELAXATION_2_EXAMPLES_SIZE_FORMULA_H

#include <muParser.h>

#include <cmath>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>

/// d as a formula in x and y, as muParser reads it.
class Size_formula
{
public:
  /// \throws std::runtime_error with one line if `text` is not one formula
  explicit Size_formula(const std::string& text) : m_text(text), m(std::make_shared<State>())
  {
    check_that_nothing_is_assigned();
    try {
      m->set(text);
      m->parser.Eval();
    } catch (const mu::Parser::exception_type& e) {
      throw std::runtime_error("--size: " + e.GetMsg());
    }
    // muParser takes the last of several values, and so a decimal comma for another number
    if (m->parser.GetNumResults() != 1)
      throw std::runtime_error("--size: '" + text + "' has " + std::to_string(m->parser.GetNumResults()) +
                               " values; one formula is needed, and numbers have a decimal point");
  }

  /// \throws std::runtime_error if d is not positive and finite
  template <class Point_2>
  double operator()(const Point_2& p) const
  {
    m->x = p.x();
    m->y = p.y();
    const double d = m->parser.Eval();
    if (!(d > 0) || !std::isfinite(d)) {
      std::ostringstream message;
      message << "--size: d(" << p.x() << ", " << p.y() << ") = " << d << " must be positive and finite";
      throw std::runtime_error(message.str());
    }
    return d;
  }

private:
  struct State
  {
    mu::Parser parser;
    double x = 0, y = 0;

    void set(const std::string& text)
    {
      parser.DefineVar("x", &x);
      parser.DefineVar("y", &y);
      parser.SetExpr(text);
    }
  };

  /// `x = 0.1` would overwrite the place and be its own value, which nobody means
  void check_that_nothing_is_assigned() const
  {
    const auto is_comparison = [](char c) { return c == '=' || c == '<' || c == '>' || c == '!'; };
    for (std::size_t k = m_text.find('='); k != std::string::npos; k = m_text.find('=', k + 1)) {
      if (k + 1 < m_text.size() && m_text[k + 1] == '=')
        ++k;
      else if (k == 0 || !is_comparison(m_text[k - 1]))
        throw std::runtime_error("--size: '" + m_text + "' assigns a value; a formula in x and y is needed");
    }
  }

  std::string m_text;
  std::shared_ptr<State> m; // the parser knows where its variables are
};

#endif // BUBBLE_RELAXATION_2_EXAMPLES_SIZE_FORMULA_H
