// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_READING_TAGS_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_READING_TAGS_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/Progress.h>
#include <CGAL/Bubble_relaxation_2/internal/core/check_call.h>
#include <CGAL/Bubble_relaxation_2/internal/core/flood_faces.h>
#include <CGAL/Bubble_relaxation_2/internal/core/in_words.h>
#include <CGAL/Bubble_relaxation_2/internal/core/vocabulary.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_marks_2.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/outline.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Marked_triangulation_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/flatten_triangulation.h>
#include <CGAL/Bubble_relaxation_2/internal/reading/Constraint_graph_2.h>

#include <CGAL/Bubble_relaxation_parameters.h>
#include <CGAL/property_map.h>
#include <CGAL/utility.h>

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <type_traits>
#include <unordered_set>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

template <class Map, class Key, class = void>
struct Can_forget : std::false_type {};

template <class Map, class Key>
struct Can_forget<Map, Key, std::void_t<decltype(forget(std::declval<const Map&>(), std::declval<const Key&>()))>>
  : std::true_type
{};

/// takes a key that is about to go out of a map, if the map is of a kind that can do this
template <class Map, class Key>
void forget_if_possible([[maybe_unused]] const Map& map, [[maybe_unused]] const Key& key)
{
  if constexpr (Can_forget<Map, Key>::value)
    forget(map, key);
}

/// of a user's map of markers or regions; of `int` if there is none
template <class NamedParameters, class Tag, class Map = Value_of<NamedParameters, Tag>>
using Tag_traits = boost::property_traits<std::conditional_t<is_missing<Map>, int*, Map>>;

template <class NamedParameters, class Tag>
using Tag_type = typename Tag_traits<NamedParameters, Tag>::value_type;

/// The maps of a user's tags; `markers()` and `regions()` are there if they were given. A constrained edge is a key in
/// one order of its ends, that of `make_sorted_pair()`, so that any map will do.
template <class NamedParameters>
class Tag_maps
{
  template <class Tag> // what goes
  using Forgets = Can_forget<Value_of<NamedParameters, Tag>, typename Tag_traits<NamedParameters, Tag>::key_type>;

public:
  static constexpr bool has_markers = Is_given<NamedParameters, internal_np::edge_marker_t>::value,
                        has_regions = Is_given<NamedParameters, internal_np::face_region_t>::value,
                        markers_forget = Forgets<internal_np::edge_marker_t>::value,
                        regions_forget = Forgets<internal_np::face_region_t>::value;

  explicit Tag_maps(const NamedParameters& np) : m_np(np) {}

  auto markers() const { return parameters::get_parameter(m_np, internal_np::edge_marker); }
  auto regions() const { return parameters::get_parameter(m_np, internal_np::face_region); }

private:
  const NamedParameters& m_np;
};

/// \throws std::invalid_argument if regions of the user's meet where no constraint is, which no mesh would keep
template <class Cdt, class NamedParameters>
void check_regions([[maybe_unused]] const NamedParameters& np, [[maybe_unused]] const Marked_copy_2& marks)
{
  if constexpr (Tag_maps<NamedParameters>::has_regions) {
    const auto map = Tag_maps<NamedParameters>(np).regions();
    using Region = Tag_type<NamedParameters, internal_np::face_region_t>;
    std::vector<std::optional<Region>> region(marks.tr.number_of_triangles());
    for (std::size_t t = 0; t < region.size(); ++t)
      if (marks.is_inside(static_cast<Index>(t)))
        region[t] = get(map, Handles<Cdt>::face(marks.faces.addresses()[t]));
    for (std::size_t k = 0; k < region.size(); ++k)
      for (int i = 0; i < 3; ++i) {
        const Index t = static_cast<Index>(k), n = marks.tr.neighbors[k][i];
        if (n < t || !marks.is_inside(t) || !marks.is_inside(n) || marks.is_constrained(t, i) ||
            *region[t] == *region[n])
          continue;
        const Point &p = marks.tr.point(t, ccw(i)), &q = marks.tr.point(t, cw(i));
        throw std::invalid_argument("Bubble_relaxation_2: parameter face_region_map: the edge from " +
                                    in_words(p.x(), p.y()) + " to " + in_words(q.x(), q.y()) +
                                    " lies between two regions and must be constrained; faces beside a vertex that "
                                    "was inserted since have none");
      }
  }
}

/// The user's tags of constraints and faces, read before a triangulation is changed, and written when it is.
template <class Cdt, class NamedParameters>
class Tags_2
{
  using Maps = Tag_maps<NamedParameters>;
  using Vertex_handle = typename Cdt::Vertex_handle;
  using Face_handle = typename Cdt::Face_handle;
  using Chain = Constraint_graph_2::Chain;

public:
  using Marker = Tag_type<NamedParameters, internal_np::edge_marker_t>;
  using Region = Tag_type<NamedParameters, internal_np::face_region_t>;

  static constexpr bool has_markers = Maps::has_markers, has_regions = Maps::has_regions;

  /// `reading`: of the triangulation, whose chains get what their first edges have, and the faces beside these
  template <class Reading>
  Tags_2(const NamedParameters& np, [[maybe_unused]] const Cdt& cdt, [[maybe_unused]] const Reading& reading)
    : m_maps(np)
  {
    if constexpr (Maps::has_markers || Maps::has_regions)
      for (const Chain& c : reading.graph->chains())
        read(cdt, c, path_of(reading, c));
  }

  /// of each chain
  const std::vector<std::optional<Marker>>& markers() const { return m_markers; }

  /// on the sides of each chain that lie in the domain, seen from its source
  const std::vector<std::optional<Region>>& left() const { return m_left; }
  const std::vector<std::optional<Region>>& right() const { return m_right; }

  /// What the domain has before it is changed: `visit_edge(key, marker)` and `visit_face(face, region)`.
  template <class Reading, class Visit_edge, class Visit_face>
  void visit_old([[maybe_unused]] const Cdt& cdt, [[maybe_unused]] const Reading& reading,
                 [[maybe_unused]] const Visit_edge& visit_edge, [[maybe_unused]] const Visit_face& visit_face) const
  {
    if constexpr (Maps::has_markers || Maps::has_regions) {
      std::unordered_set<const void*> reached;
      if constexpr (Maps::has_regions)
        reached.reserve(cdt.number_of_faces()); // to enter them all anew takes longer than the callback may wait
      for (std::size_t k = 0; k < reading.graph->chains().size(); ++k) {
        const Chain& c = reading.graph->chains()[k];
        const std::vector<Vertex_handle> path = path_of(reading, c);
        if constexpr (Maps::has_markers)
          for (std::size_t i = 1; i < path.size(); ++i)
            visit_edge(CGAL::make_sorted_pair(path[i - 1], path[i]), *m_markers[k]); // a whole domain has no rim
        if constexpr (Maps::has_regions) {
          const Sides sides = sides_of(cdt, path);
          if (c.inside_left)
            flood_faces(sides.left, reached, [&](Face_handle f) { visit_face(f, *m_left[k]); });
          if (c.inside_right)
            flood_faces(sides.right, reached, [&](Face_handle f) { visit_face(f, *m_right[k]); });
        }
      }
    }
  }

  /// Takes what is about to go out of the user's maps, which else would hold more and more.
  template <class Reading>
  void forget_old(const Cdt& cdt, const Reading& reading) const
  {
    visit_old(
      cdt, reading, [this](const auto& edge, const Marker&) { forget_if_possible(m_maps.markers(), edge); },
      [this](Face_handle f, const Region&) { forget_if_possible(m_maps.regions(), f); });
  }

  /// Gives the constraints of the domain, and its faces, what they had.
  /// \param for_each_piece `for_each_piece(visit)` calls `visit(edge, source, chain)` for the edges on constraints of
  /// the domain: `source` is the end from which the number `chain` of the reading's chains goes on along the edge
  template <class For_each_piece>
  void write([[maybe_unused]] const For_each_piece& for_each_piece) const
  {
    if constexpr (Maps::has_markers || Maps::has_regions) {
      std::unordered_set<const void*> reached;
      for_each_piece([&](const typename Cdt::Edge& edge, Vertex_handle source, std::size_t chain) {
        const auto [f, i] = edge;
        const Vertex_handle u = f->vertex(Cdt::ccw(i)), v = f->vertex(Cdt::cw(i));
        if constexpr (Maps::has_markers)
          put(m_maps.markers(), CGAL::make_sorted_pair(u, v), *m_markers[chain]);
        if constexpr (Maps::has_regions) {
          spread(f, (u == source ? m_left : m_right)[chain], reached);
          spread(f->neighbor(i), (u == source ? m_right : m_left)[chain], reached);
        }
      });
    }
  }

  /// The same for a part that is meshed anew: takes what goes out of the maps.
  template <class Reading>
  void forget_part([[maybe_unused]] const Reading& reading, [[maybe_unused]] const std::vector<Face_handle>& part) const
  {
    if constexpr (Maps::has_markers)
      for (const Chain& c : reading.graph->chains()) {
        const std::vector<Vertex_handle> path = path_of(reading, c);
        for (std::size_t k = 1; k < path.size() && c.kind != Edge_kind::RIM; ++k)
          forget_if_possible(m_maps.markers(), CGAL::make_sorted_pair(path[k - 1], path[k]));
      }
    if constexpr (Maps::has_regions)
      for (Face_handle f : part)
        forget_if_possible(m_maps.regions(), f);
  }

  /// Gives the new faces of a part, and its constraints, what they had.
  /// \param vertex `vertex(bubble)`, and \param face `face(triangle)`: the handles
  template <class Vertex, class Face>
  void write_part([[maybe_unused]] const Domain_2& domain, [[maybe_unused]] const Bubble_mesh_2& mesh,
                  [[maybe_unused]] const Vertex& vertex, [[maybe_unused]] const Face& face) const
  {
    if constexpr (Maps::has_markers || Maps::has_regions) {
      const Marked_triangles_2& tr = mesh.triangles;
      std::vector<const std::optional<Region>*> region(tr.number_of_triangles(), nullptr);
      std::vector<Index> stack;
      const auto reach = [&](Index t, const std::optional<Region>* value) {
        if (tr.inside[t] && region[t] == nullptr) {
          region[t] = value;
          stack.push_back(t);
        }
      };
      for_each_piece(domain, mesh, [&](Index t, int i, Index e, bool is_left) {
        if constexpr (Maps::has_markers)
          if (tr.inside[t] && m_markers[e])
            put(m_maps.markers(), CGAL::make_sorted_pair(vertex(tr.vertices[t][ccw(i)]), vertex(tr.vertices[t][cw(i)])),
                *m_markers[e]);
        if constexpr (Maps::has_regions)
          reach(t, is_left ? &m_left[e] : &m_right[e]);
      });
      while (!stack.empty()) {
        const Index t = stack.back();
        stack.pop_back();
        if constexpr (Maps::has_regions)
          put(m_maps.regions(), face(t), **region[t]);
        for (int i = 0; i < 3; ++i)
          if (tr.edges[t][i] == no_index && tr.neighbors[t][i] != no_index)
            reach(tr.neighbors[t][i], region[t]);
      }
    }
  }

private:
  struct Sides { Face_handle left, right; };

  /// the faces beside the first edge of a path
  static Sides sides_of(const Cdt& cdt, const std::vector<Vertex_handle>& path)
  {
    Face_handle f;
    int i = 0;
    cdt.is_edge(path[0], path[1], f, i);
    return f->vertex(Cdt::ccw(i)) == path[0] ? Sides{f, f->neighbor(i)} : Sides{f->neighbor(i), f};
  }

  void read([[maybe_unused]] const Cdt& cdt, [[maybe_unused]] const Chain& c, const std::vector<Vertex_handle>& path)
  {
    if constexpr (Maps::has_markers) {
      m_markers.emplace_back(); // a rim of a part is no constraint, or stays
      if (c.kind != Edge_kind::RIM)
        m_markers.back() = get(m_maps.markers(), CGAL::make_sorted_pair(path[0], path[1]));
    }
    if constexpr (Maps::has_regions) {
      const Sides sides = sides_of(cdt, path);
      m_left.emplace_back();
      m_right.emplace_back();
      if (c.inside_left)
        m_left.back() = get(m_maps.regions(), sides.left);
      if (c.inside_right)
        m_right.back() = get(m_maps.regions(), sides.right);
    }
  }

  /// gives the faces around one of a region its value
  template <class Value>
  void spread(Face_handle f, const Value& region, std::unordered_set<const void*>& reached) const
  {
    if (region)
      flood_faces(f, reached, [&](Face_handle g) { put(m_maps.regions(), g, *region); });
  }

  Maps m_maps;
  std::vector<std::optional<Marker>> m_markers;       // of the chains
  std::vector<std::optional<Region>> m_left, m_right; // of the faces beside them
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_READING_TAGS_2_H
