// Conformance vectors as JSON: spec/formats/vectors.md.
//
// Guarantees: what is expected comes from the oracle alone: stationary points by search over all subsets,
// orbits by linear scans, stable sets by following the flow backwards, persistence pairs by the Čech
// filtration. Deterministic, to the byte.
#pragma once

#include <string>
#include <vector>

#include "oracle/program/answer_fields.h"
#include "tests/vectors/recipes.h"

namespace oracle::vectors {

// Takes time n^5.
Json case_of(const Group& group, const Recipe& recipe);
// The same, for stationary points and starts that are known.
Json case_of(const Group& group, const Recipe& recipe, const Answer& answer, const std::vector<Point>& starts);
Json case_of(const Group& group, const InvalidRecipe& recipe);

Json group_file(const Group& group, const std::vector<Json>& cases);
Json flag_file();

// The file with line breaks where people want them: what fits on a line stays on one. Ends with a line break.
std::string text_of(const Json& file);

}  // namespace oracle::vectors
