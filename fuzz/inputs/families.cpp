// The table of families, in the order of its groups.
//
// Guarantees: see families.h. Names are unique (families_test checks it), so that a report can name an input
// by family, seed and size.
#include "fuzz/inputs/families.h"

#include <ostream>
#include <utility>

#include "fuzz/inputs/family_groups.h"

namespace flowcert::fuzz {
namespace {

std::vector<Family> all_groups() {
  std::vector<Family> all;
  for (auto* group : {lattice_families, spherical_families, flat_families, right_angle_families,
                      scan_families, orbit_families, rounding_families, magnitude_families}) {
    for (Family& family : group()) {
      all.push_back(std::move(family));
    }
  }
  return all;
}

}  // namespace

std::ostream& operator<<(std::ostream& out, const Family& family) { return out << family.name; }

const std::vector<Family>& families() {
  static const std::vector<Family> table = all_groups();
  return table;
}

Input draw(const Family& family, std::uint64_t seed, int size) {
  return family.generate()(rc::Random(seed), size).value();
}

}  // namespace flowcert::fuzz
