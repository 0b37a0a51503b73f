// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef BUBBLE_RELAXATION_2_DEMO_LOG_LOG_PLOT_H
#define BUBBLE_RELAXATION_2_DEMO_LOG_LOG_PLOT_H

#include "svg_picture.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iomanip>
#include <limits>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

/// A plot of panels side by side with two logarithmic axes each: a line is a power law. Series of the same name
/// look alike in all panels and share an entry of the legend.
class Log_log_plot
{
public:
  using Points = std::vector<std::pair<double, double>>; ///< (x, y), both positive

  explicit Log_log_plot(std::string title) : m_title(std::move(title)) {}

  void start_panel(std::string caption, std::string x_title, std::string y_title)
  {
    m_panels.push_back(Panel{std::move(caption), std::move(x_title), std::move(y_title), {}, {}});
  }

  void add_series(const std::string& name, const Points& points)
  {
    if (std::find(m_names.begin(), m_names.end(), name) == m_names.end())
      m_names.push_back(name);
    m_panels.back().series.push_back(Series{name, points});
  }

  /// A right triangle that shows y ~ x^`order`, `below` times under the middle of the line between two points; over
  /// it if `below` is less than 1.
  void add_slope(double order, const std::pair<double, double>& p, const std::pair<double, double>& q,
                 double below = 1.8)
  {
    const double x = std::sqrt(p.first * q.first), y = std::sqrt(p.second * q.second) / below;
    m_panels.back().slopes.push_back(Slope{order, x, y});
  }

  void write(const std::string& file_name)
  {
    const double width = static_cast<double>(m_panels.size()) * (size + gap) + 30;
    std::size_t longest = 0;
    for (const std::string& name : m_names)
      longest = (std::max)(longest, name.size());
    const double entry_width = 60 + 7.5 * static_cast<double>(longest);
    const std::size_t columns = (std::max)(std::size_t(1), static_cast<std::size_t>((width - gap) / entry_width));
    const double legend_height = 24 * static_cast<double>((m_names.size() + columns - 1) / columns);
    const double height = top + size + 70 + legend_height;
    m_body.str("");
    m_body << std::fixed << std::setprecision(2);
    m_body.add_text(width / 2, 28, m_title, 17, "middle");
    for (std::size_t k = 0; k < m_panels.size(); ++k)
      draw_panel(m_panels[k], gap + static_cast<double>(k) * (size + gap));
    for (std::size_t k = 0; k < m_names.size(); ++k)
      draw_entry(k, gap + entry_width * static_cast<double>(k % columns),
                 top + size + 75 + 24 * static_cast<double>(k / columns));
    write_svg(file_name, width, height, m_body.str());
  }

private:
  struct Series { std::string name; Points points; };
  struct Slope { double order, x, y; };
  struct Panel
  {
    std::string caption, x_title, y_title;
    std::vector<Series> series;
    std::vector<Slope> slopes;
  };

  /// One axis: decimal logarithms between two ends, on so many pixels from the first one.
  struct Axis
  {
    double low = (std::numeric_limits<double>::max)(), high = std::numeric_limits<double>::lowest();
    double first = 0, length = size;

    void take(double value)
    {
      low = (std::min)(low, std::log10(value));
      high = (std::max)(high, std::log10(value));
    }

    void widen()
    {
      const double more = (std::max)(0.04 * (high - low), 0.05);
      low -= more;
      high += more;
    }

    bool has(double value) const { return std::log10(value) >= low && std::log10(value) <= high; }
    double at(double value) const { return first + length * (std::log10(value) - low) / (high - low); }
  };

  static constexpr double slope_width = 1.5; ///< of a triangle, as a ratio of x

  void draw_panel(const Panel& panel, double left)
  {
    Axis x, y;
    for (const Series& s : panel.series)
      for (const auto& p : s.points) {
        x.take(p.first);
        y.take(p.second);
      }
    for (const Slope& s : panel.slopes)
      for (double side : {std::sqrt(slope_width), 1 / std::sqrt(slope_width)})
        y.take(s.y * std::pow(side, s.order));
    x.widen();
    y.widen();
    x.first = left;
    y.first = top + size;
    y.length = -size;
    draw_grid(x, y);
    m_body.add_text(left + size / 2, top + size + 42, panel.x_title, 13, "middle");
    m_body << "<g transform=\"translate(" << left - 50 << ' ' << top + size / 2 << ") rotate(-90)\">";
    m_body.add_text(0, 0, panel.y_title, 13, "middle");
    m_body << "</g>\n";
    m_body.add_text(left + size / 2, top - 10, panel.caption, 14, "middle");
    for (const Slope& s : panel.slopes)
      draw_slope(s, x, y);
    for (const Series& s : panel.series)
      draw_series(s, x, y);
  }

  void draw_grid(const Axis& x, const Axis& y)
  {
    for_each_tick(x, [&](double value, int digit, bool is_labelled) {
      const double at = x.at(value);
      m_body.add_line(at, top, at, top + size, digit == 1 ? "#bbb" : "#eee");
      if (is_labelled)
        m_body.add_text(at, top + size + 18, in_short(value), 12, "middle");
    });
    for_each_tick(y, [&](double value, int digit, bool is_labelled) {
      const double at = y.at(value);
      m_body.add_line(x.first, at, x.first + size, at, digit == 1 ? "#bbb" : "#eee");
      if (is_labelled)
        m_body.add_text(x.first - 6, at + 4, in_short(value), 12, "end");
    });
    m_body << "<rect x=\"" << x.first << "\" y=\"" << top << "\" width=\"" << size << "\" height=\"" << size
           << "\" fill=\"none\" stroke=\"black\"/>\n";
  }

  /// `use(value, leading digit, whether it has a number beside it)`
  template <class Use>
  static void for_each_tick(const Axis& axis, const Use& use)
  {
    const double decades = axis.high - axis.low;
    for (int e = static_cast<int>(std::floor(axis.low)); e <= axis.high; ++e)
      for (int digit = 1; digit < 10; ++digit) {
        const double value = digit * std::pow(10., e);
        const bool is_round = digit == 1 || (decades < 3 && (digit == 2 || digit == 5));
        if (axis.has(value))
          use(value, digit, is_round);
      }
  }

  void draw_series(const Series& s, const Axis& x, const Axis& y)
  {
    const std::size_t number =
      static_cast<std::size_t>(std::find(m_names.begin(), m_names.end(), s.name) - m_names.begin());
    m_body << "<path fill=\"none\" stroke-width=\"1.8\" stroke=\"" << color(number) << "\" d=\"";
    for (std::size_t k = 0; k < s.points.size(); ++k)
      m_body << (k == 0 ? 'M' : 'L') << x.at(s.points[k].first) << ' ' << y.at(s.points[k].second);
    m_body << "\"/>\n";
    for (const auto& p : s.points)
      add_mark(x.at(p.first), y.at(p.second), number);
  }

  void draw_slope(const Slope& s, const Axis& x, const Axis& y)
  {
    const double half = std::sqrt(slope_width), rise = std::pow(half, s.order);
    const double left = x.at(s.x / half), right = x.at(s.x * half), from = y.at(s.y / rise), to = y.at(s.y * rise);
    m_body << "<path d=\"M" << left << ' ' << from << 'H' << right << 'V' << to
           << "Z\" fill=\"#eee\" stroke=\"#555\"/>\n";
    std::ostringstream order;
    order << s.order;
    m_body.add_text(right + 5, (from + to) / 2 + 4, order.str(), 12, "start");
  }

  void draw_entry(std::size_t number, double left, double y)
  {
    m_body.add_line(left, y - 5, left + 30, y - 5, color(number));
    add_mark(left + 15, y - 5, number);
    m_body.add_text(left + 38, y, m_names[number], 13, "start");
  }

  /// colours are told apart with the common colour-vision deficiencies too, and so are shapes without colour
  void add_mark(double x, double y, std::size_t number)
  {
    const std::string style =
      std::string("\" fill=\"") + color(number) + "\" stroke=\"white\" stroke-width=\"0.8\"/>\n";
    switch (number % 4) {
    case 0:
      m_body << "<circle cx=\"" << x << "\" cy=\"" << y << "\" r=\"5" << style;
      break;
    case 1:
      m_body << "<path d=\"M" << x - 4.5 << ' ' << y - 4.5 << "h9v9h-9Z" << style;
      break;
    case 2:
      m_body << "<path d=\"M" << x - 5.5 << ' ' << y + 4.5 << "h11l-5.5 -10Z" << style;
      break;
    default:
      m_body << "<path d=\"M" << x << ' ' << y - 6 << "l6 6l-6 6l-6 -6Z" << style;
    }
  }

  static const char* color(std::size_t number)
  {
    static const char* const colors[] = {"#0072b2", "#d62728", "#009e73", "#e69f00",
                                         "#7f7f7f", "#56b4e9", "#7a4f00", "#cc79a7"};
    return colors[number % 8];
  }

  static std::string in_short(double value)
  {
    std::ostringstream text;
    if (value >= 0.01 && value < 10000) {
      text << value;
    } else {
      const double exponent = std::floor(std::log10(value) + 1e-9);
      text << std::lround(value / std::pow(10., exponent)) << 'e' << exponent;
    }
    return text.str();
  }

  static constexpr double size = 400, gap = 80, top = 75;

  std::string m_title;
  std::vector<Panel> m_panels;
  std::vector<std::string> m_names; ///< of the series, in the order of the legend
  Svg_body m_body;
};

#endif // BUBBLE_RELAXATION_2_DEMO_LOG_LOG_PLOT_H
