// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef BUBBLE_RELAXATION_2_DEMO_MESH_ANIMATION_H
#define BUBBLE_RELAXATION_2_DEMO_MESH_ANIMATION_H

#include "linear_finite_elements.h"

#include <CGAL/Bbox_2.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <cstddef>
#include <cstring>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

/// Meshes one after the other as one animated picture in SVG. An edge is drawn once, with the frames in which it is
/// there: so what stays costs nothing. Over the triangles lie regions in which values are beyond some levels.
class Mesh_animation
{
public:
  explicit Mesh_animation(const CGAL::Bbox_2& box, double width = 1600)
    : m_box(box), m_scale(width / (box.xmax() - box.xmin()))
  {}

  /// adds a frame; `body` is painted over it
  template <class CDT, class Outline>
  void add(const Triangle_arrays<CDT>& mesh, const Eigen::VectorXd& values, const Outline& body)
  {
    std::map<Edge, std::size_t> edges;
    for (const auto& t : mesh.triangles)
      for (int i = 0; i < 3; ++i) {
        Edge e{at(mesh.points[t[i]]), at(mesh.points[t[(i + 1) % 3]])};
        if (e.second < e.first)
          std::swap(e.first, e.second);
        const auto before = m_edges.find(e);
        edges[e] = before == m_edges.end() ? m_frames.size() : before->second;
      }
    for (const auto& [edge, first] : m_edges)
      if (edges.count(edge) == 0)
        end(edge, first);
    m_edges.swap(edges);
    std::ostringstream frame;
    for (std::size_t k = 0; k < levels.size(); ++k)
      frame << "<path class=\"w\" d=\"" << region(mesh, values, levels[k]) << "\"/>";
    frame << "<path class=\"b\" d=\"";
    for (std::size_t k = 0; k < body.size(); ++k)
      frame << (k == 0 ? 'M' : 'L') << at(body[k])[0] << ' ' << at(body[k])[1];
    frame << "z\"/>";
    m_frames.push_back(frame.str());
  }

  /// \param seconds that all frames take, over and over again
  /// \throws std::runtime_error with the name and the system's reason
  void write(const std::string& file_name, double seconds)
  {
    for (const auto& [edge, first] : m_edges)
      end(edge, first);
    m_edges.clear();
    errno = 0;
    std::ofstream out(file_name);
    const int width = at_x(m_box.xmax()), height = at_y(m_box.ymin());
    out << "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"-4 -4 " << width + 8 << ' ' << height + 8
        << "\" width=\"" << (width + 8) / 2 << "\" height=\"" << (height + 8) / 2 << "\">\n<style>"
        << "path{fill:none;stroke:#456;stroke-width:.8}.w{fill:#e05a10;fill-opacity:.22;stroke:none}"
        << ".b{fill:#333;stroke:none}</style>\n"
        << "<rect x=\"-4\" y=\"-4\" width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n";
    for (std::size_t k = 0; k < m_frames.size(); ++k)
      out << "<g" << hidden(k) << shown(k, k + 1, seconds) << m_frames[k] << "</g>\n";
    for (const auto& [frames, edges] : m_ended)
      out << "<path d=\"" << lines(edges) << '"' << hidden(frames.first) << shown(frames.first, frames.second, seconds)
          << "</path>\n";
    out << "</svg>\n";
    if (!out.flush())
      throw std::runtime_error(file_name + ": cannot be written: " + std::strerror(errno));
  }

private:
  using Place = std::array<int, 2>;
  using Edge = std::pair<Place, Place>;

  static constexpr std::array<double, 3> levels{0.03, 0.15, 0.5};
  static constexpr int smallest_step = 6; ///< along the border of a region

  int at_x(double x) const { return static_cast<int>(std::lround(m_scale * (x - m_box.xmin()))); }
  int at_y(double y) const { return static_cast<int>(std::lround(m_scale * (m_box.ymax() - y))); }

  template <class Point_2>
  Place at(const Point_2& p) const
  {
    return {at_x(p.x()), at_y(p.y())};
  }

  /// an edge was there from the frame `first` to the last one
  void end(const Edge& e, std::size_t first)
  {
    auto& edges = m_ended[{first, m_frames.size()}];
    edges[e.first].insert(e.second);
    edges[e.second].insert(e.first);
  }

  /// `last` becomes `next`
  static void add_step(std::ostream& out, Place& last, const Place& next)
  {
    out << 'l' << next[0] - last[0] << (next[1] < last[1] ? "" : " ") << next[1] - last[1];
    last = next;
  }

  /// all edges, as few lines that are as long as can be
  static std::string lines(std::map<Place, std::set<Place>> edges)
  {
    std::ostringstream text;
    while (!edges.empty()) {
      auto from = edges.begin();
      for (auto e = edges.begin(); e != edges.end() && from->second.size() % 2 == 0; ++e)
        if (e->second.size() % 2 == 1) // one that a line must end at
          from = e;
      Place last = from->first;
      text << 'M' << last[0] << ' ' << last[1];
      for (auto found = edges.find(last); found != edges.end(); found = edges.find(last)) {
        const Place next = *found->second.begin();
        found->second.erase(next);
        if (found->second.empty())
          edges.erase(found);
        const auto other = edges.find(next);
        other->second.erase(last);
        if (other->second.empty())
          edges.erase(other);
        add_step(text, last, next);
      }
    }
    return text.str();
  }

  /// what moves nothing shows the first frame
  static const char* hidden(std::size_t first) { return first == 0 ? ">" : " display=\"none\">"; }

  /// what shows an element in the frames from `first` to, without, `last` only
  std::string shown(std::size_t first, std::size_t last, double seconds) const
  {
    const double all = static_cast<double>(m_frames.size());
    if (first == 0 && last == m_frames.size())
      return "";
    std::ostringstream text;
    const bool is_at_first = first == 0, is_to_last = last == m_frames.size();
    text << "<animate attributeName=\"display\" calcMode=\"discrete\" dur=\"" << seconds
         << "s\" repeatCount=\"indefinite\" values=\"" << (is_at_first ? "" : "none;") << "inline"
         << (is_to_last ? "" : ";none") << "\" keyTimes=\"0";
    if (!is_at_first)
      text << ';' << static_cast<double>(first) / all;
    if (!is_to_last)
      text << ';' << static_cast<double>(last) / all;
    text << "\"/>";
    return text.str();
  }

  /// The lines on which the values are `level`, as polygons. They are closed by straight lines where the values at the
  /// border of the mesh are on both sides of it.
  template <class CDT>
  std::string region(const Triangle_arrays<CDT>& mesh, const Eigen::VectorXd& values, double level) const
  {
    using Cut = std::pair<int, int>; // an edge of the mesh, by its ends
    std::map<Cut, Cut> next;
    for (const auto& t : mesh.triangles)
      for (int i = 0; i < 3; ++i) {
        const int a = t[i], b = t[(i + 1) % 3], c = t[(i + 2) % 3];
        const bool is_over = values[a] >= level;
        if (is_over == (values[b] >= level) || is_over == (values[c] >= level)) // else `a` has both edges that are cut
          continue;
        const Cut ab{(std::min)(a, b), (std::max)(a, b)}, ac{(std::min)(a, c), (std::max)(a, c)};
        if (is_over)
          next[ab] = ac;
        else
          next[ac] = ab;
      }
    std::ostringstream text;
    while (!next.empty()) {
      Place last{0, 0};
      bool is_first = true;
      for (auto found = next.begin(); found != next.end();) {
        const Cut cut = found->first, to = found->second;
        const Place place = at(crossing(mesh, values, level, cut));
        if (is_first)
          text << 'M' << place[0] << ' ' << place[1];
        else if (std::abs(place[0] - last[0]) + std::abs(place[1] - last[1]) >= smallest_step)
          add_step(text, last, place);
        if (is_first)
          last = place;
        is_first = false;
        next.erase(found);
        found = next.find(to);
      }
      text << 'z';
    }
    return text.str();
  }

  template <class CDT>
  static typename CDT::Point crossing(const Triangle_arrays<CDT>& mesh, const Eigen::VectorXd& values, double level,
                                      const std::pair<int, int>& edge)
  {
    const double u = values[edge.first], v = values[edge.second], s = (level - u) / (v - u);
    const auto &p = mesh.points[edge.first], &q = mesh.points[edge.second];
    return typename CDT::Point(p.x() + s * (q.x() - p.x()), p.y() + s * (q.y() - p.y()));
  }

  CGAL::Bbox_2 m_box;
  double m_scale;
  std::map<Edge, std::size_t> m_edges; // of the last frame, with their first ones
  /// what is no more: by the frames in which it was, neighbours of each place
  std::map<std::pair<std::size_t, std::size_t>, std::map<Place, std::set<Place>>> m_ended;
  std::vector<std::string> m_frames; // what is drawn in one frame alone
};

#endif // BUBBLE_RELAXATION_2_DEMO_MESH_ANIMATION_H
