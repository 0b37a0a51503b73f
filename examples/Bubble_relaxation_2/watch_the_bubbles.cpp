// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// A visitor that sees bubbles move, while a callback is told how far the work is. It prints what each round has done, and
// writes bubbles.svg, a picture that moves: bubbles are placed, pushed apart, pulled together, inserted and deleted, until
// they rest; then their mesh appears.

#include "svg_picture.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Default_relaxation_visitor_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/npbs_relax.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = K::Point_2;
using Fb = CGAL::Delaunay_mesh_face_base_2<K>;
using CDT = CGAL::Constrained_Delaunay_triangulation_2<
  K, CGAL::Triangulation_data_structure_2<CGAL::Triangulation_vertex_base_2<K>, Fb>>;

/// The bubbles of every other step as circles that move from one place to the next, then what is left of them as a mesh.
class Film : public CGAL::Default_relaxation_visitor_2
{
public:
  void step_ends(const CGAL::Bubble_view_2& bubbles)
  {
    if (m_number_of_steps++ % 2 == 0)
      add_frame(bubbles);
  }

  void round_ends(const CGAL::Bubble_relaxation_report_2<double>& so_far)
  {
    std::cout << "round " << so_far.number_of_rounds << ": " << so_far.number_of_steps << " steps, "
              << so_far.number_of_moves << " moves, " << so_far.number_of_insertions << " bubbles inserted, "
              << so_far.number_of_deletions << " deleted so far\n";
  }

  void write(const std::string& file_name, const CDT& cdt) const
  {
    std::ostringstream out;
    out << "<g stroke=\"#1f5fa8\" stroke-width=\"0.7\" fill=\"#9cc3e6\" fill-opacity=\"0.45\">\n";
    for (const Track& track : m_tracks)
      add_track(out, track);
    out << "</g>\n<path fill=\"none\" stroke=\"#333\" stroke-width=\"0.8\" opacity=\"0\" d=\"";
    for (const auto& e : cdt.finite_edges())
      if (e.first->is_in_domain() || e.first->neighbor(e.second)->is_in_domain()) {
        const auto [x, y] = at(e.first->vertex(cdt.cw(e.second))->point());
        const auto [to_x, to_y] = at(e.first->vertex(cdt.ccw(e.second))->point());
        out << 'M' << x << ' ' << y << 'L' << to_x << ' ' << to_y;
      }
    const double rest = share(m_number_of_frames);
    out << "\">" << animate("opacity", "0;0;1;1", {0, rest, 0.5 * (1 + rest), 1}) << "</path>\n";
    write_svg(file_name, 2 * side, side, out.str());
  }

private:
  /// a bubble from its first frame on
  struct Track
  {
    std::size_t first = 0;
    std::vector<std::array<int, 2>> places;
    double diameter = 0;
    bool is_deleted = false;
  };

  static constexpr double side = 480;        // of the unit square, in pixels
  static constexpr std::size_t last = 30;    // frames in which the mesh is shown
  static constexpr double per_second = 12.5; // frames

  void add_frame(const CGAL::Bubble_view_2& bubbles)
  {
    m_tracks.resize(bubbles.size());
    for (std::size_t i = 0; i < bubbles.size(); ++i) {
      Track& track = m_tracks[i];
      if (bubbles.is_deleted(i)) {
        track.is_deleted = true;
        continue;
      }
      if (track.places.empty())
        track.first = m_number_of_frames;
      track.places.push_back(at(Point(bubbles.x(i), bubbles.y(i))));
      track.diameter = bubbles.diameter(i);
    }
    ++m_number_of_frames;
  }

  double share(std::size_t frame) const { return double(frame) / double(m_number_of_frames + last); }

  /// in pixels, downwards
  static std::array<int, 2> at(const Point& p)
  {
    return {int(std::lround(side * p.x())), int(std::lround(side * (1 - p.y())))};
  }

  std::string animate(const std::string& what, const std::string& values, const std::vector<double>& times) const
  {
    std::ostringstream out;
    out << "<animate attributeName=\"" << what << "\" dur=\"" << double(m_number_of_frames + last) / per_second
        << "s\" repeatCount=\"indefinite\" values=\"" << values << "\" keyTimes=\"";
    for (std::size_t k = 0; k < times.size(); ++k)
      out << (k == 0 ? "" : ";") << std::round(1e3 * times[k]) / 1e3;
    out << "\"/>";
    return out.str();
  }

  /// a circle along its places, in the frames in which the bubble is there; while it rests nothing is said
  void add_track(std::ostream& out, const Track& track) const
  {
    if (track.places.empty())
      return;
    const double begin = share(track.first), end = share(track.first + track.places.size());
    std::vector<double> times{0};
    std::string xs = std::to_string(track.places[0][0]), ys = std::to_string(track.places[0][1]);
    const auto add = [&](double time, const std::array<int, 2>& place) {
      times.push_back(time);
      xs += ';' + std::to_string(place[0]);
      ys += ';' + std::to_string(place[1]);
    };
    for (std::size_t k = 1; k < track.places.size(); ++k)
      if (track.places[k] != track.places[k - 1] || (k > 1 && track.places[k] != track.places[k - 2]))
        add(share(track.first + k), track.places[k]);
    add(1, track.places.back());
    out << "<circle r=\"" << std::lround(0.5 * side * track.diameter) << "\">" << animate("cx", xs, times)
        << animate("cy", ys, times);
    if (track.is_deleted)
      out << animate("opacity", "0;1;0;0", {0, begin, end, 1});
    else if (track.first > 0)
      out << animate("opacity", "0;1;1", {0, begin, 1});
    out << "</circle>\n";
  }

  std::vector<Track> m_tracks;
  std::size_t m_number_of_steps = 0, m_number_of_frames = 0;
};

int main()
{
  CDT cdt;
  const auto insert = [&cdt](const std::vector<Point>& ring) { cdt.insert_constraint(ring.begin(), ring.end(), true); };
  insert({{0.02, 0.02}, {1.98, 0.02}, {1.98, 0.98}, {0.02, 0.98}});
  std::vector<Point> hole;
  for (int k = 0; k < 24; ++k)
    hole.push_back(Point(0.6 + 0.17 * std::cos(CGAL_PI * k / 12), 0.5 + 0.17 * std::sin(CGAL_PI * k / 12)));
  insert(hole);

  const auto d = [](const Point& p) { return 0.042 + 0.1 * std::abs(std::hypot(p.x() - 0.6, p.y() - 0.5) - 0.17); };
  int percent = -1;
  const auto progress = [&percent](double share) {
    if (const int now = int(100 * share); now / 10 > percent / 10)
      std::cout << now << " % " << std::flush;
    percent = int(100 * share);
    return true;
  };
  Film film;
  const auto report =
    CGAL::npbs_relax(cdt, CGAL::Bubble_relaxation_parameters::sizing_function(d)
                            .initial_placement(CGAL::Bubble_placement::RHOMBIC) // where there is most to be seen
                            .visitor(std::ref(film))
                            .callback(progress));
  std::cout << '\n' << report;
  film.write("bubbles.svg", cdt);
}
