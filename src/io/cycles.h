// The cycles that stand for persistence pairs, of those pairs that somebody asks for, at the level asked for.
//
// Guarantees: exact, and the same for any number of threads. A pair of dimension 1 has a loop and its surface
// (loops.h), one of dimension 2 a void, and one of dimension 0 the two components that its death joins (voids.h).
// Numbers of stationary points are places in the list. Source: spec section 18 (clauses FC-CYC).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "flowcert/flow_complex.h"
#include "flowcert/loops.h"
#include "flowcert/progress.h"
#include "flowcert/voids.h"
#include "morse/length_bound.h"

namespace flowcert {

// At which level between birth and death cycles are shown.
struct CycleLevel {
  enum class Kind : std::uint8_t {
    kShare,     // of the way from the birth to the death, in squared distances: at least 0, and less than 1
    kDistance,  // a distance, not squared, for the pairs that are there at it
    kDeath      // the least level with nothing but the death point's own stable manifold
  };
  Kind kind = Kind::kShare;
  Rational number{1, 4};
};

// "25%", a number for a distance, "birth" for 0%, or "death". Throws InvalidInput; the message begins with the option.
[[nodiscard]] CycleLevel cycle_level_of(std::string_view text, const std::string& option);

// The two contact sets of a pair, "3,17/5,8,20": that of the birth first. Throws InvalidInput likewise.
using PairName = std::array<std::vector<PointId>, 2>;
[[nodiscard]] PairName pair_name_of(std::string_view text, const std::string& option);

// Which pairs are meant. A class that lasts is none of them.
struct CycleChoice {
  int dimension = 1;  // 0 to 2
  CycleLevel level;   // dimension 0 has none
  // One of these three.
  std::size_t longest = 10;
  std::optional<LengthBound> longer_than;
  std::optional<PairName> pair;
};

struct LoopCycle {
  std::vector<std::uint32_t> surface, edges;  // of index 2 and index 1, ascending
  std::vector<LoopPolygon> polygons;
};

// The samples of the two components that the death of a pair joins, ascending (components_at).
using JoinedComponents = std::array<std::vector<std::uint32_t>, 2>;

struct Cycle {
  PersistencePair pair;               // it has a death
  std::optional<SquaredLevel> level;  // none in dimension 0
  std::variant<LoopCycle, Void, JoinedComponents> chain;
};

// The longest pairs come first; of equal lengths the first in the list. Makes persistence, and the merge trees for
// dimensions 0 and 2. Throws InvalidInput for a pair that is none, or is not there at the level.
[[nodiscard]] std::vector<Cycle> cycles(const FlowComplex& complex, const CycleChoice& choice,
                                        const Progress& progress = {});

// The length of a loop in doubles: of its edges, each the nearest double, one after the other.
[[nodiscard]] double loop_length(const FlowComplex& complex, const LoopCycle& loop);

}  // namespace flowcert
