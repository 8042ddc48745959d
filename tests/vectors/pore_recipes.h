// The table of conformance vectors of balls: which balls there are, under which permanent ids, and what is asked.
//
// Guarantees: as those of recipes.h. Numbers are words of a point file: decimals.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace oracle::vectors {

using BallWords = std::array<std::string, 4>;  // x, y, z, and the radius

struct PoreQuestion {
  std::string depth = "0";
  std::optional<std::string> probe = std::nullopt;
};

// FC-CLAIM-26: lines, and the different reasons for what is wrong, ascending. The depth is 1/10.
struct PoreClaim {
  std::vector<std::string> lines, reasons;
};

struct PoreRecipe {
  std::string id;
  std::string comment;
  std::vector<BallWords> balls;
  std::vector<PoreQuestion> questions;  // none: the balls have to be refused
  std::vector<PoreClaim> claims = {};
};

// In the order of ids.
std::vector<PoreRecipe> pore_recipes();

}  // namespace oracle::vectors
