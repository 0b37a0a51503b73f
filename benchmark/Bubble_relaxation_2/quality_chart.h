// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef BUBBLE_RELAXATION_2_BENCHMARK_QUALITY_CHART_H
#define BUBBLE_RELAXATION_2_BENCHMARK_QUALITY_CHART_H

#include "../../examples/Bubble_relaxation_2/svg_picture.h"
#include "comparison.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

/// Quality over cost as SVG: two panels, mean q and smallest q, over the time in floors. A mesher is a colour,
/// a domain a small dot, and the mean of the domains a large one.
class Quality_chart
{
public:
  Quality_chart(const std::vector<Comparison_row>& rows, const std::vector<std::string>& meshers)
    : m_rows(rows), m_meshers(meshers)
  {
    for (const Comparison_row& r : rows) {
      m_logarithm = (std::max)(m_logarithm, std::log10(1.3 * r.floors));
      m_worst_mean = (std::min)(m_worst_mean, r.mean_q);
      m_best_mean = (std::max)(m_best_mean, r.mean_q);
      m_worst_min = (std::min)(m_worst_min, r.min_q);
      m_best_min = (std::max)(m_best_min, r.min_q);
    }
    m_worst_min = std::floor(10 * m_worst_min) / 10;
    m_best_min = std::ceil(10 * m_best_min) / 10;
  }

  void write(std::ostream& out, const std::string& title)
  {
    m_body.add_text(width() / 2, 28, title, 17, "middle");
    add_panel(0, "mean q (logarithmic in 1 - q)", mean_ticks(), [](const Comparison_row& r) { return r.mean_q; },
              [this](double q) { return height_of_mean(q); });
    add_panel(1, "smallest q", minimum_ticks(), [](const Comparison_row& r) { return r.min_q; },
              [this](double q) { return (q - m_worst_min) / (m_best_min - m_worst_min); });
    add_legend();
    out << "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " << width() << ' ' << height
        << "\" width=\"" << width() << "\" height=\"" << height << "\" font-family=\"sans-serif\">\n"
        << "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n"
        << m_body.str() << "</svg>\n";
  }

private:
  /// the share of the panel's height: each halving of 1 - q is as high
  double height_of_mean(double q) const
  {
    const double lowest = std::log(1.1 * (1 - m_worst_mean)), highest = std::log(0.8 * (1 - m_best_mean));
    return (std::log(1 - q) - lowest) / (highest - lowest);
  }

  std::vector<double> mean_ticks() const
  {
    std::vector<double> ticks;
    for (double q : {0.8, 0.9, 0.95, 0.98, 0.99, 0.995, 0.998, 0.999})
      if (height_of_mean(q) >= 0 && height_of_mean(q) <= 1)
        ticks.push_back(q);
    return ticks;
  }

  std::vector<double> minimum_ticks() const
  {
    std::vector<double> ticks;
    for (double q = m_worst_min; q < m_best_min + 0.01; q += 0.1)
      ticks.push_back(q);
    return ticks;
  }

  template <class Quality, class Height>
  void add_panel(int number, const std::string& name, const std::vector<double>& ticks,
                 const Quality& quality, const Height& share)
  {
    m_left = 70 + number * (size + 80);
    const auto y = [&](double q) { return top + size * (1 - share(q)); };
    for (double q : ticks) {
      m_body.add_line(m_left, y(q), m_left + size, y(q), "#ddd");
      std::ostringstream label;
      label << q;
      m_body.add_text(m_left - 6, y(q) + 4, label.str(), 12, "end");
    }
    for (double decade = 1; std::log10(decade) <= m_logarithm; decade *= 10)
      for (int i = 1; i < 10 && std::log10(i * decade) <= m_logarithm; ++i) {
        const double at = x(i * decade);
        m_body.add_line(at, top, at, top + size, i == 1 ? "#bbb" : "#eee");
        if (i == 1 || i == 2 || i == 5)
          m_body.add_text(at, top + size + 18, std::to_string(std::lround(i * decade)), 12, "middle");
      }
    m_body << "<rect x=\"" << m_left << "\" y=\"" << top << "\" width=\"" << size << "\" height=\"" << size
           << "\" fill=\"none\" stroke=\"black\"/>\n";
    m_body.add_text(m_left + size / 2, top + size + 40, "CPU time over that of the bare triangulation", 13, "middle");
    m_body.add_text(m_left, top - 10, name, 14, "start");
    for (std::size_t m = 0; m < m_meshers.size(); ++m)
      add_mesher(m, quality, y);
  }

  template <class Quality, class Y>
  void add_mesher(std::size_t mesher, const Quality& quality, const Y& y)
  {
    double floors = 0, sum = 0, n = 0;
    for (const Comparison_row& r : m_rows) {
      if (r.mesher != m_meshers[mesher])
        continue;
      add_dot(x(r.floors), y(quality(r)), 4, mesher, 0.45);
      floors += r.floors;
      sum += quality(r);
      ++n;
    }
    if (n > 0)
      add_dot(x(floors / n), y(sum / n), 8, mesher, 1);
  }

  void add_legend()
  {
    std::size_t shown = 0;
    for (std::size_t m = 0; m < m_meshers.size(); ++m) {
      if (std::none_of(m_rows.begin(), m_rows.end(),
                       [&](const Comparison_row& r) { return r.mesher == m_meshers[m]; }))
        continue;
      const double left = 75 + 300 * double(shown % 3), y = top + size + 72 + 24 * double(shown / 3);
      add_dot(left, y - 5, 8, m, 1);
      m_body.add_text(left + 16, y, m_meshers[m], 14, "start");
      ++shown;
    }
    m_body.add_text(width() - 10, height - 8, "small: a domain, large: the mean of the domains", 12, "end");
  }

  double x(double floors) const { return m_left + size * std::log10((std::max)(1., floors)) / m_logarithm; }

  void add_dot(double x, double y, double radius, std::size_t mesher, double opacity)
  {
    // told apart with the common colour-vision deficiencies too
    static const char* const colors[] = {"#d62728", "#7f7f7f", "#56b4e9", "#0072b2", "#e69f00", "#7a4f00"};
    m_body << "<circle cx=\"" << x << "\" cy=\"" << y << "\" r=\"" << radius << "\" fill=\""
           << colors[mesher % 6] << "\" fill-opacity=\"" << opacity << "\" stroke=\""
           << (opacity < 1 ? "none" : "black") << "\"/>\n";
  }

  static constexpr double size = 400, top = 75, height = top + size + 130;
  static double width() { return 70 + 2 * size + 80 + 30; }

  const std::vector<Comparison_row>& m_rows;
  const std::vector<std::string>& m_meshers;
  double m_left = 0, m_logarithm = 1;
  double m_worst_mean = 1, m_best_mean = 0, m_worst_min = 1, m_best_min = 0;
  Svg_body m_body;
};

#endif // BUBBLE_RELAXATION_2_BENCHMARK_QUALITY_CHART_H
