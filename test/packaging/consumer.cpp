// What a user writes: a square, a size, a mesh.
#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/npbs_relax.h>

#include <vector>

int main()
{
  using K = CGAL::Exact_predicates_inexact_constructions_kernel;
  CGAL::Constrained_Delaunay_triangulation_2<K> cdt;
  const std::vector<K::Point_2> square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  cdt.insert_constraint(square.begin(), square.end(), true);
  const auto report = CGAL::npbs_relax(cdt, CGAL::parameters::sizing_function(0.2));
  return report.quality.mean_quality() > 0.9 && cdt.is_valid() ? 0 : 1;
}
