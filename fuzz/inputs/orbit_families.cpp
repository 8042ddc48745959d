// Families made for the flow: orbits that cross facet after facet, facets of many sides, and orbits that run
// exactly along Voronoi edges or into Voronoi vertices.
//
// Guarantees: see families.h; what the configurations guarantee is said in configurations.h. Larger ones of
// some are in large_configurations.h.
#include "fuzz/inputs/configurations.h"
#include "fuzz/inputs/family_groups.h"
#include "fuzz/inputs/integer_points.h"

namespace flowcert::fuzz {
namespace {

rc::Gen<Input> placed_distinct(const rc::Gen<IntegerPoints>& points) {
  return input_of(rc::gen::map(placed(points), distinct));
}

}  // namespace

std::vector<Family> orbit_families() {
  return {
      {"long-cascade",
       "two combs that lean away from each other: the flow between them crosses facet after facet",
       [] { return placed_distinct(opening_combs()); },
       {.four_points = 100}},
      {"half-shell",
       "a half sphere, half cylinder or paraboloid rounded to a grid, open at the top",
       [] { return placed_distinct(open_shell()); },
       {.four_points = 90, .kind12 = 20, .tie = 20}},
      {"high-degree-facet",
       "an edge, and neighbours of it on a circle around it, off centre, or close to such a circle",
       [] { return placed_distinct(rc::gen::oneOf(neighbours_on_a_circle(), neighbours_near_a_circle())); },
       {.four_points = 100, .kind12 = 8, .tie = 9}},
      {"right-angle-chain",
       "right triangles about one axis: the flow runs up along their Voronoi edges",
       [] { return placed_distinct(rings_of_right_triangles()); },
       {.four_points = 100, .cluster = 8, .kind12 = 100, .tie = 100}},
      {"through-vertex",
       "points symmetric to an axis or to two planes, where the flow across facets runs into Voronoi "
       "vertices",
       [] {
         return placed_distinct(
             rc::gen::weightedOneOf<IntegerPoints>({{3, rings_of_pairs()}, {1, mirrored_points()}}));
       },
       {.four_points = 95, .cluster = 65, .kind12 = 30, .tie = 75}},
  };
}

}  // namespace flowcert::fuzz
