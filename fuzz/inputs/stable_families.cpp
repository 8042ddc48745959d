// The table of families for stable sets; see stable_families.h for what they guarantee.
#include "fuzz/inputs/stable_families.h"

#include "fuzz/inputs/stable_configurations.h"

namespace flowcert::fuzz {
namespace {

rc::Gen<Input> placed_distinct(const rc::Gen<IntegerPoints>& points) {
  return input_of(rc::gen::map(placed(points), distinct));
}

std::vector<Family> table() {
  return {{"aimed-at-vertices",
           "a side of a triangle, and points below it that make a Voronoi vertex on the branch of S2 there",
           [] { return placed_distinct(aimed_points()); },
           {.four_points = 90, .tie = 10}},
          {"aimed-at-stars",
           "the same, where three edges lead to the Voronoi vertex that have one of its samples in common",
           [] { return placed_distinct(aimed_at_a_star()); },
           {.four_points = 100}},
          {"crowded-sectors",
           "four points around a regular stationary centre, and others that cut off its sectors",
           [] { return placed_distinct(crowded_points()); },
           {.four_points = 100, .tie = 100}}};
}

}  // namespace

const std::vector<Family>& stable_families() {
  static const std::vector<Family> families = table();
  return families;
}

std::vector<Family> families_and_stable_ones() {
  std::vector<Family> all = families();
  all.insert(all.end(), stable_families().begin(), stable_families().end());
  return all;
}

}  // namespace flowcert::fuzz
