// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef BUBBLE_RELAXATION_2_EXAMPLES_SVG_PICTURE_H
#define BUBBLE_RELAXATION_2_EXAMPLES_SVG_PICTURE_H

#include <CGAL/Mesh_quality_2.h>

#include <CGAL/Bbox_2.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <fstream>
#include <iomanip>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

/// Writes elements of SVG as a picture on a white ground.
/// \throws std::runtime_error with the name and the system's reason
inline void write_svg(const std::string& file_name, double width, double height, const std::string& elements)
{
  errno = 0;
  std::ofstream out(file_name);
  out << "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " << width << ' ' << height << "\" width=\"" << width
      << "\" height=\"" << height << "\" font-family=\"sans-serif\">\n"
      << "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n"
      << elements << "</svg>\n";
  if (!out.flush())
    throw std::runtime_error(file_name + ": cannot be written: " + std::strerror(errno));
}

/// Elements of SVG.
struct Svg_body : std::ostringstream
{
  void add_line(double x0, double y0, double x1, double y1, const char* color)
  {
    *this << "<path d=\"M" << x0 << ' ' << y0 << 'L' << x1 << ' ' << y1 << "\" stroke=\"" << color << "\"/>\n";
  }

  void add_text(double x, double y, const std::string& text, int font_size, const char* anchor = "middle")
  {
    *this << "<text x=\"" << x << "\" y=\"" << y << "\" font-size=\"" << font_size << "\" text-anchor=\"" << anchor
          << "\">" << text << "</text>\n";
  }
};

/// A picture of panels side by side: meshes, nodes, bubbles, histograms, parts of ranks.
class Svg_picture
{
public:
  /// begins a panel that shows what lies in `box`
  void start_panel(const std::string& caption, const CGAL::Bbox_2& box)
  {
    const double width = box.xmax() - box.xmin(), height = box.ymax() - box.ymin();
    m_scale = m_size / (std::max)(width, height);
    m_left = m_gap + m_number_of_panels * (m_size + m_gap);
    m_x0 = m_left + 0.5 * (m_size - m_scale * width) - m_scale * box.xmin();
    m_y0 = m_top + 0.5 * (m_size + m_scale * height) + m_scale * box.ymin();
    ++m_number_of_panels;
    m_body.add_text(m_left + 0.5 * m_size, m_top - 15, caption, 16);
  }

  /// triangles of the domain in the colour of their q, constraints in bold
  template <class CDT>
  void add_mesh(const CDT& cdt, const std::string& caption)
  {
    start_panel(caption, box_of(cdt));
    for (auto f : cdt.finite_face_handles()) {
      if (!f->is_in_domain())
        continue;
      const auto &p = f->vertex(0)->point(), &q = f->vertex(1)->point(), &r = f->vertex(2)->point();
      add_triangle(p, q, r, color(CGAL::radius_ratio_2(p, q, r)), thin_line(cdt.number_of_vertices()));
    }
    add_constraints(cdt);
  }

  /// the same, as far as it lies in `box`
  template <class CDT>
  void add_part_of_mesh(const CDT& cdt, const CGAL::Bbox_2& box, const std::string& caption)
  {
    start_panel(caption, box);
    m_body << "<svg x=\"" << m_left << "\" y=\"" << m_top << "\" width=\"" << m_size << "\" height=\"" << m_size
           << "\" viewBox=\"" << m_left << ' ' << m_top << ' ' << m_size << ' ' << m_size << "\">\n"; // clips
    for (auto f : cdt.finite_face_handles())
      if (f->is_in_domain() && CGAL::do_overlap(cdt.triangle(f).bbox(), box)) {
        const auto &p = f->vertex(0)->point(), &q = f->vertex(1)->point(), &r = f->vertex(2)->point();
        add_triangle(p, q, r, color(CGAL::radius_ratio_2(p, q, r)), 0.3);
      }
    add_constraints(cdt, box);
    m_body << "</svg>\n";
  }

  /// vertices of the domain as dots
  template <class CDT>
  void add_nodes(const CDT& cdt, const std::string& caption)
  {
    start_panel(caption, box_of(cdt));
    add_constraints(cdt);
    for (auto v : cdt.finite_vertex_handles())
      add_circle(v->point(), dot_radius(cdt.number_of_vertices()), "fill=\"#1f5fa8\"");
  }

  /// polygons, those of cells, in the outline of a triangulation, and its vertices as dots
  template <class CDT, class Polygon_soup>
  void add_cells(const CDT& cdt, const Polygon_soup& soup, const std::string& caption)
  {
    start_panel(caption, box_of(cdt));
    for (const auto& polygon : soup.polygons) {
      m_body << "<path d=\"";
      for (std::size_t corner : polygon)
        m_body << (corner == polygon.front() ? 'M' : 'L') << at(soup.points[corner]);
      m_body << "Z\" fill=\"#e4eef8\" stroke=\"#1f5fa8\" stroke-width=\"0.8\"/>\n";
    }
    add_constraints(cdt);
    for (auto v : cdt.finite_vertex_handles())
      add_circle(v->point(), 0.7 * dot_radius(cdt.number_of_vertices()), "fill=\"#c0392b\"");
  }

  /// points as circles of given diameters, and segments between pairs of them
  template <class Point_2, class Pairs>
  void add_bubbles(const std::vector<Point_2>& points, const std::vector<double>& diameters,
                   const Pairs& segments, const std::string& caption)
  {
    CGAL::Bbox_2 box;
    for (const Point_2& p : points)
      box += p.bbox();
    start_panel(caption, box);
    for (const auto& s : segments)
      m_body << "<path d=\"M" << at(points[s.first]) << 'L' << at(points[s.second])
             << "\" stroke=\"#c0392b\" stroke-width=\"0.8\"/>\n";
    for (std::size_t i = 0; i < points.size(); ++i)
      add_circle(points[i], 0.5 * diameters[i] * m_scale,
                 "fill=\"#9cc3e6\" fill-opacity=\"0.35\" stroke=\"#1f5fa8\" stroke-width=\"0.6\"");
  }

  /// points as dots, in the outline of a triangulation
  template <class CDT, class Point_2>
  void add_points(const CDT& cdt, const std::vector<Point_2>& points, const std::string& caption)
  {
    start_panel(caption, box_of(cdt));
    add_constraints(cdt);
    for (const Point_2& p : points)
      add_circle(p, dot_radius(points.size()), "fill=\"#9aa7b5\"");
  }

  /// a point as a cross, and those that belong to it, joined with it, in the colour of a number
  template <class Point_2>
  void add_star(const Point_2& center, const std::vector<Point_2>& points, std::size_t number_of_all, int number)
  {
    const std::string color = color_of_rank(number);
    for (const Point_2& p : points)
      m_body << "<path d=\"M" << at(center) << 'L' << at(p) << "\" stroke=\"" << color
             << "\" stroke-width=\"0.8\"/>\n";
    for (const Point_2& p : points)
      add_circle(p, 1.3 * dot_radius(number_of_all), "fill=\"" + color + "\" stroke=\"#333\" stroke-width=\"0.4\"");
    m_body << "<path d=\"M" << at(center) << "m-5 0h10m-5 -5v10\" stroke=\"black\" stroke-width=\"1.6\"/>\n";
  }

  /// the histogram of q
  template <class FT>
  void add_histogram(const CGAL::Mesh_quality_2<FT>& quality, const std::string& caption)
  {
    start_panel(caption, CGAL::Bbox_2(0, 0, 1, 1));
    const auto& bars = quality.histogram();
    const double highest = double(*std::max_element(bars.begin(), bars.end()));
    const double step = m_size / double(bars.size());
    for (std::size_t k = 0; k < bars.size(); ++k) {
      const double height = bars[k] == 0 ? 0 : 0.9 * m_size * double(bars[k]) / highest + 1;
      m_body << "<rect x=\"" << m_left + step * double(k) << "\" y=\"" << m_top + m_size - height
             << "\" width=\"" << step - 1 << "\" height=\"" << height << "\" fill=\""
             << color((double(k) + 0.5) / double(bars.size())) << "\" stroke=\"#555\"/>\n";
    }
    m_body << "<path d=\"M" << m_left << ' ' << m_top + m_size << 'h' << m_size
           << "\" stroke=\"black\"/>\n";
    for (int k = 0; k <= 5; ++k)
      m_body.add_text(m_left + m_size * k / 5, m_top + m_size + 15, std::to_string(0.2 * k).substr(0, 3), 12);
    std::ostringstream numbers;
    numbers << std::fixed << std::setprecision(3) << "mean " << quality.mean_quality() << ", smallest "
            << quality.minimum_quality();
    m_body.add_text(m_left + 0.35 * m_size, m_top + 20, numbers.str(), 14);
  }

  /// a disc in the colour of a rank
  template <class Point_2>
  void add_disc_of_rank(const Point_2& center, double radius, int rank)
  {
    add_circle(center, radius * m_scale,
               "fill=\"" + color_of_rank(rank) + "\" stroke=\"#555\" stroke-width=\"0.3\"");
  }

  /// a triangle in the colour of a rank
  template <class Point_2>
  void add_triangle_of_rank(const Point_2& p, const Point_2& q, const Point_2& r, int rank)
  {
    add_triangle(p, q, r, color_of_rank(rank), 0.3);
  }

  void write(const std::string& file_name) const
  {
    const double width = m_number_of_panels * (m_size + m_gap) + m_gap, height = m_size + 2 * m_top;
    write_svg(file_name, width, height, m_body.str());
  }

private:
  template <class CDT>
  static CGAL::Bbox_2 box_of(const CDT& cdt)
  {
    CGAL::Bbox_2 box;
    for (auto v : cdt.finite_vertex_handles())
      box += v->point().bbox();
    return box;
  }

  template <class CDT>
  void add_constraints(const CDT& cdt)
  {
    add_constraints(cdt, box_of(cdt));
  }

  template <class CDT>
  void add_constraints(const CDT& cdt, const CGAL::Bbox_2& box)
  {
    m_body << "<path stroke=\"black\" stroke-width=\"1.2\" stroke-linecap=\"round\" d=\"";
    for (const auto& e : cdt.finite_edges())
      if (cdt.is_constrained(e) && CGAL::do_overlap(cdt.segment(e).bbox(), box))
        m_body << 'M' << at(e.first->vertex(cdt.ccw(e.second))->point()) << 'L'
               << at(e.first->vertex(cdt.cw(e.second))->point());
    m_body << "\"/>\n";
  }

  template <class Point_2>
  void add_triangle(const Point_2& p, const Point_2& q, const Point_2& r, const std::string& fill, double line)
  {
    m_body << "<path d=\"M" << at(p) << 'L' << at(q) << 'L' << at(r) << "Z\" fill=\"" << fill
           << "\" stroke=\"#555\" stroke-width=\"" << line << "\"/>\n";
  }

  template <class Point_2>
  void add_circle(const Point_2& p, double radius, const std::string& style)
  {
    m_body << "<circle cx=\"" << m_x0 + m_scale * p.x() << "\" cy=\"" << m_y0 - m_scale * p.y()
           << "\" r=\"" << radius << "\" " << style << "/>\n";
  }

  template <class Point_2>
  std::string at(const Point_2& p) const
  {
    std::ostringstream text;
    text << std::fixed << std::setprecision(2) << m_x0 + m_scale * p.x() << ' '
         << m_y0 - m_scale * p.y();
    return text.str();
  }

  static double dot_radius(std::size_t number_of_points)
  {
    return 60 / std::sqrt(double(number_of_points) + 500);
  }

  static double thin_line(std::size_t number_of_vertices)
  {
    return (std::min)(0.5, 20 / std::sqrt(double(number_of_vertices)));
  }

  /// from dark red at 0.4 over yellow to light blue at 1
  static std::string color(double q)
  {
    const double s = (std::max)(0., (std::min)(1., (q - 0.4) / 0.6));
    const double stops[4][3] = {{192, 57, 43}, {241, 178, 80}, {250, 236, 180}, {214, 232, 247}};
    const int k = (std::min)(2, static_cast<int>(3 * s));
    const double t = 3 * s - k;
    std::ostringstream text;
    text << "rgb(";
    for (int c = 0; c < 3; ++c)
      text << static_cast<int>((1 - t) * stops[k][c] + t * stops[k + 1][c]) << (c < 2 ? "," : ")");
    return text.str();
  }

  /// neighbouring numbers look different, and so do any few
  static std::string color_of_rank(int rank)
  {
    const double golden_angle = 137.508;
    return "hsl(" + std::to_string(static_cast<int>(std::fmod(210 + golden_angle * rank, 360))) + ",60%,70%)";
  }

  static constexpr double m_size = 480, m_gap = 30, m_top = 40;
  double m_scale = 1, m_left = 0, m_x0 = 0, m_y0 = 0;
  int m_number_of_panels = 0;
  Svg_body m_body;
};

#endif // BUBBLE_RELAXATION_2_EXAMPLES_SVG_PICTURE_H
