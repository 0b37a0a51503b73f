// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_INFLUENCE_DOMAIN_2_H
#define CGAL_INFLUENCE_DOMAIN_2_H

#include <CGAL/license/Bubble_relaxation_2.h>

#include <CGAL/Bubble_relaxation_2/internal/core/disable_warnings.h>

#include <CGAL/Bubble_relaxation_2/internal/core/Relaxation_options.h>
#include <CGAL/Bubble_relaxation_2/internal/meshless/search/Influence_search_2.h>
#include <CGAL/Bubble_relaxation_enums.h>
#include <CGAL/Bubble_relaxation_parameters.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {

template <class Point_2>
struct Node_set_2;

/*!
\ingroup PkgBubbleRelaxation2Meshless

The nodes that have a say at a point: those in whose influence domain it lies. The influence domain of a node is the
open disc of its radius, which is one for all nodes, or one for each.

By default (`Influence_search::BUCKETS`) the plane is cut into cells about as wide as the radii there, each with a
list of the discs that meet it. A query goes through one list, so it takes no longer where sizes vary. It finds all
nodes, in whatever way they are placed, and whatever their radii, as long as none reaches farther than 10<sup>15</sup>
times the median radius.

With `Influence_search::EXPANSION` the nodes are found from the neighbour sets that the simulation leaves, as in
section 3.2 of the paper: a descent to the nearest node, then an expansion over the sets as far as nodes are near
enough. It takes several times longer than the default, to build and to ask, for the proof that nothing is missed
needs a Delaunay triangulation of the nodes.

In a convex domain an expansion is complete if R > 2 F. Here R is the radius of the neighbour sets, and F the fill
distance: the radius of the largest circle around a point of the domain that has no node inside. For sizes that vary
both are taken on the spot. Bubbles that are packed have 2 F of about 1.2 d and R of 1.7 d; a random set, or one with
a void, does not comply, and in other domains R > 2 F is not enough: a notch or a hole separates nodes that
are near to each other. What is tested here needs no domain, and it is a little weaker than R > 2 F: an expansion is
complete if no node that it meets has a Delaunay edge that the neighbour sets lack and whose Voronoi edge comes
nearer to the node than the expansion goes. If it may be incomplete the query is answered as by
default, so that both ways always find the same nodes. `Query::number_of_fallbacks()` tells how often that was.

A node lies in the influence domain if its squared distance is less than the squared radius, both computed with
`double`, to which coordinates of other number types are rounded once, when the object is made. Copies share all that
they hold, so they cost next to nothing.

\tparam Kernel_ a model of `Kernel`, that of the points

\sa `CGAL::npbs_place_nodes()`
*/
template <class Kernel_>
class Influence_domain_2
{
  using Search = Bubble_relaxation_2::internal::Influence_search_2;

public:
  using Kernel = Kernel_;
  using Point_2 = typename Kernel::Point_2; ///< the point type
  using Node_index = std::int32_t;          ///< a number that stands for a node

#ifndef DOXYGEN_RUNNING
  class Query;
#endif

  /*!
  gives each node a radius that is a multiple of its size, the distance from its neighbours.

  \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
  \param nodes the nodes, which are copied
  \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below

  \cgalNamedParamsBegin
    \cgalParamNBegin{support_factor}
      \cgalParamDescription{the radius of node i is this times `nodes.sizes[i]`}
      \cgalParamType{`double`, positive}
      \cgalParamDefault{2.5}
    \cgalParamNEnd
    \cgalParamNBegin{influence_search}
      \cgalParamDescription{how nodes are found}
      \cgalParamType{`Influence_search`}
      \cgalParamDefault{`BUCKETS`; the paper: `EXPANSION`}
    \cgalParamNEnd
  \cgalNamedParamsEnd

  \throws std::invalid_argument if a disc reaches farther from the first node than 10<sup>15</sup> times the median
  radius; if the factor or a size is not positive and finite, if there are not as many sizes as
  points, if a coordinate is not finite, or if neighbour sets that are asked for are missing or have indices that no
  node has
  */
#ifdef DOXYGEN_RUNNING
  template <class NamedParameters = parameters::Default_named_parameters>
#else
  template <class NamedParameters = parameters::Default_named_parameters,
            class = std::enable_if_t<!std::is_convertible<NamedParameters, double>::value &&
                                     !std::is_convertible<NamedParameters, std::vector<double>>::value>>
#endif
  explicit Influence_domain_2(const Node_set_2<Point_2>& nodes,
                              const NamedParameters& np = parameters::default_values())
    : Influence_domain_2(nodes.points, multiples_of_sizes(nodes, np))
  {
    use_neighbors(nodes, np);
  }

  /*!
  gives all nodes one radius.

  \param nodes as above
  \param radius the radius of the influence domains, in the units of the coordinates
  \param np `influence_search`, as above

  \throws std::invalid_argument as above, or if the radius is not positive and finite
  */
  template <class NamedParameters = parameters::Default_named_parameters>
  Influence_domain_2(const Node_set_2<Point_2>& nodes, double radius,
                     const NamedParameters& np = parameters::default_values())
    : Influence_domain_2(nodes.points, radius)
  {
    use_neighbors(nodes, np);
  }

  /*!
  gives each node a radius of its own.

  \param nodes, np as above
  \param radii node i is found at p if |p - x<sub>i</sub>| < `radii[i]`

  \throws std::invalid_argument as above, or if there are not as many radii as nodes
  */
  template <class NamedParameters = parameters::Default_named_parameters>
  Influence_domain_2(const Node_set_2<Point_2>& nodes, std::vector<double> radii,
                     const NamedParameters& np = parameters::default_values())
    : Influence_domain_2(nodes.points, std::move(radii))
  {
    use_neighbors(nodes, np);
  }

  /// gives all of any points one radius; they have no neighbour sets, so nodes are found by `BUCKETS`.
  Influence_domain_2(std::vector<Point_2> points, double radius) : m_points(share(std::move(points)))
  {
    Bubble_relaxation_2::internal::check_positive("radius", radius);
    m_search = make_search(*m_points, {radius});
  }

  /// gives each of any points a radius of its own.
  Influence_domain_2(std::vector<Point_2> points, std::vector<double> radii) : m_points(share(std::move(points)))
  {
    Bubble_relaxation_2::internal::check_numbers("radii", "radius", radii, m_points->size());
    m_search = make_search(*m_points, radii);
  }

  std::size_t size() const { return m_points->size(); } ///< the number of nodes

  const Point_2& point(Node_index i) const { return (*m_points)[static_cast<std::size_t>(i)]; } ///< where node `i` is

  /// the radius of node `i`
  double radius(Node_index i) const { return m_search->disc(static_cast<std::size_t>(i)).radius; }

#ifndef DOXYGEN_RUNNING
  /// places and radii in the very numbers of `double` that queries take
  std::shared_ptr<const Search> search() const { return m_search; }
#endif

  /*!
  writes the nodes i with |p - x<sub>i</sub>| < `factor` r<sub>i</sub> in ascending order, and returns the end. May
  be called by any number of threads. For a `factor` of at most 1 it takes the time of what it finds; for larger ones a
  few times longer, and the first such query prepares for them.

  \throws std::invalid_argument if a coordinate of `p` is not finite, or `factor` is not positive and finite
  */
  template <class OutputIterator>
  OutputIterator nodes_at(const Point_2& p, OutputIterator out, double factor = 1) const
  {
    const double x = CGAL::to_double(p.x()), y = CGAL::to_double(p.y());
    Bubble_relaxation_2::internal::check_point(x, y);
    Bubble_relaxation_2::internal::check_positive("factor", factor);
    std::vector<Node_index> result;
    m_search->find_once(x, y, factor, result);
    return std::copy(result.begin(), result.end(), out);
  }

  /// returns the node that is nearest to `p`, of several the first, and -1 if there is none.
  Node_index nearest_node(const Point_2& p) const
  {
    const double x = CGAL::to_double(p.x()), y = CGAL::to_double(p.y());
    Bubble_relaxation_2::internal::check_point(x, y);
    return m_search->nearest(x, y);
  }

  /// returns whether each query in some influence domain, with a factor of at most 1, is sure to be answered by
  /// expansion alone; `false` with `BUCKETS`.
  bool is_expansion_complete() const { return m_search->is_expansion_complete(); }

private:
  static std::shared_ptr<const std::vector<Point_2>> share(std::vector<Point_2> points)
  {
    return std::make_shared<const std::vector<Point_2>>(std::move(points));
  }

  template <class NamedParameters>
  static std::vector<double> multiples_of_sizes(const Node_set_2<Point_2>& nodes, const NamedParameters& np)
  {
    const double factor =
      parameters::choose_parameter(parameters::get_parameter(np, internal_np::support_factor), 2.5);
    Bubble_relaxation_2::internal::check_positive("support_factor", factor);
    Bubble_relaxation_2::internal::check_numbers("nodes.sizes", "size", nodes.sizes, nodes.points.size());
    std::vector<double> radii;
    radii.reserve(nodes.sizes.size());
    for (double d : nodes.sizes)
      radii.push_back(factor * d);
    return radii;
  }

  /// \param radii one for all, or one each
  static std::shared_ptr<Search> make_search(const std::vector<Point_2>& points, const std::vector<double>& radii)
  {
    std::vector<Bubble_relaxation_2::internal::Influence_disc_2> discs;
    discs.reserve(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
      discs.push_back({CGAL::to_double(points[i].x()), CGAL::to_double(points[i].y()),
                       radii[radii.size() > 1 ? i : 0]});
    return std::make_shared<Search>(std::move(discs));
  }

  template <class NamedParameters>
  void use_neighbors(const Node_set_2<Point_2>& nodes, const NamedParameters& np)
  {
    const Influence_search search = parameters::choose_parameter(
      parameters::get_parameter(np, internal_np::influence_search), Influence_search::BUCKETS);
    if (search == Influence_search::EXPANSION)
      m_search->use_neighbors(nodes.neighbor_offsets, nodes.neighbors);
  }

  std::shared_ptr<const std::vector<Point_2>> m_points;
  std::shared_ptr<Search> m_search; // has the radii
};

/*!
\ingroup PkgBubbleRelaxation2Meshless

Queries by one thread. They find what `nodes_at()` finds, without taking memory each time; with
`Influence_search::EXPANSION` each starts where the one before ended, so they are fast in an order in which
each point is near to the last, as quadrature points are. It may outlive the `Influence_domain_2`.
*/
template <class Kernel_>
class Influence_domain_2<Kernel_>::Query
{
public:
  /// prepares for queries of `influence`.
  explicit Query(const Influence_domain_2& influence) : m_query(influence.m_search) {}

  /// replaces what `result` has by the nodes i with |p - x<sub>i</sub>| < `factor` r<sub>i</sub>, in ascending order.
  void operator()(const Point_2& p, double factor, std::vector<Node_index>& result)
  {
    const double x = CGAL::to_double(p.x()), y = CGAL::to_double(p.y());
    Bubble_relaxation_2::internal::check_point(x, y);
    Bubble_relaxation_2::internal::check_positive("factor", factor);
    m_query(x, y, factor, result);
  }

  /// returns how many of the queries an expansion might not have answered in full, so that they were answered as
  /// by default.
  std::size_t number_of_fallbacks() const { return m_query.number_of_fallbacks(); }

#ifndef DOXYGEN_RUNNING
  Bubble_relaxation_2::internal::Influence_query_2& query() { return m_query; }
#endif

private:
  Bubble_relaxation_2::internal::Influence_query_2 m_query;
};

} // namespace CGAL

#include <CGAL/Bubble_relaxation_2/internal/core/enable_warnings.h>

#endif // CGAL_INFLUENCE_DOMAIN_2_H
