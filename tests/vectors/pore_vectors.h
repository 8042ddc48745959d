// Conformance vectors of balls as JSON: spec/formats/vectors.md.
//
// Guarantees: as those of vectors.h. What is expected are the oracle's critical points, by search over all subsets of
// near balls, and its chambers, as pores.md writes them.
#pragma once

#include <vector>

#include "oracle/program/answer_fields.h"
#include "tests/vectors/pore_recipes.h"

namespace oracle::vectors {

Json pore_case(const PoreRecipe& recipe);
Json pore_file(const std::vector<Json>& cases);

}  // namespace oracle::vectors
