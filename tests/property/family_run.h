// A property of the fast implementation on inputs of many families, with totals of what was seen.
//
// Guarantees: each family is drawn from the seed of the run, so that a family's inputs depend on no other. A row is
// printed for each family, also where the property failed. Totals have add(totals) and print_row(name).
#pragma once

#include <string>
#include <vector>

#include "fuzz/inputs/stable_configurations.h"
#include "fuzz/properties/subject.h"
#include "tests/property/property_parameters.h"

namespace flowcert::property {

// Calls require(subject, totals), which fails with RC_FAIL, on so many inputs of each family. Returns whether it never
// did.
template <class Totals, class Require>
bool expect_in_families(const std::string& name, const std::vector<fuzz::Family>& families, int inputs,
                        const Require& require, Totals& all) {
  bool is_right = true;
  for (const fuzz::Family& family : families) {
    Totals totals;
    const rc::Gen<fuzz::Input> generator = family.generate();
    const bool holds = expect_holds(name + ", " + family.name, parameters_of_run(inputs), [&] {
      const fuzz::Input input = *generator;
      require(Subject(input), totals);
    });
    is_right = is_right && holds;
    totals.print_row(family.name);
    all.add(totals);
  }
  return is_right;
}

// In the families of all tests, and in those for stable sets.
struct InputsPerFamily {
  int of_all, for_stable_sets;
};
template <class Totals, class Require>
bool expect_in_all_families(const std::string& name, InputsPerFamily inputs, const Require& require, Totals& all) {
  const bool in_first = expect_in_families(name, fuzz::families(), inputs.of_all, require, all);
  const bool in_second = expect_in_families(name, fuzz::stable_families(), inputs.for_stable_sets, require, all);
  all.print_row("all");
  return in_first && in_second;
}

}  // namespace flowcert::property
