// Pockets as some program claims them (spec/formats/pockets.md; FC-CLAIM-18).
//
// Guarantees: as flowcert/claim.h. What is not claimed is empty. Contact sets are rows of the input, as claimed.
// Pockets are named by their places in the claim, and -1 is the outside.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "flowcert/claimed_number.h"
#include "flowcert/point_set.h"

namespace flowcert {

// A stationary point with its values.
struct ClaimedWitness {
  std::vector<PointId> contact;
  std::optional<ClaimedPosition> center;
  std::optional<ClaimedNumber> squared_radius;
  std::optional<ClaimedDouble> radius;
};

// A stationary point of any index, or regular.
struct ClaimedCellPart {
  int index = 0;                      // or the first number of the kind
  std::optional<int> hull_dimension;  // set: claimed to be regular
  std::vector<PointId> contact;
};

struct ClaimedMouth {
  ClaimedWitness at;
  std::optional<ClaimedDouble> area;
  std::optional<std::vector<std::int64_t>> between;
};

// A widest path with its gates, or the largest cavity radius with its balls.
struct ClaimedRadius {
  std::optional<ClaimedNumber> squared_radius;
  std::optional<ClaimedDouble> radius;
  std::vector<ClaimedWitness> witnesses;
};

struct ClaimedPocket {
  std::vector<std::vector<PointId>> maxima;  // one at least
  std::optional<std::vector<ClaimedWitness>> peaks;
  std::optional<ClaimedDouble> depth;
  std::optional<ClaimedNumber> difference_of_squares;
  std::optional<ClaimedDouble> volume;  // exact, too
  std::optional<std::vector<ClaimedCellPart>> cell;
  std::optional<std::vector<ClaimedMouth>> mouths;
  std::optional<std::vector<PointId>> lining;  // rows
  std::optional<std::vector<std::int64_t>> neighbours;
  std::optional<ClaimedRadius> widest_path;
  std::string passage;  // "cavity", "pocket", "channel"; empty where not claimed
};

// A radius of the whole. Without a value, it says that there is no pocket.
struct ClaimedWhole {
  std::optional<ClaimedRadius> radius;
};

struct ClaimedPockets {
  std::size_t line = 0;           // of the file, 1-based
  Rational squared_persistence;   // 0 or more
  std::optional<Rational> probe;  // a radius, 0 or more; set if a passage is claimed
  std::vector<ClaimedPocket> pockets;
  std::optional<std::vector<std::vector<PointId>>> outside;  // maxima
  std::optional<ClaimedWhole> pore_limiting_radius, largest_cavity_radius;
  std::optional<std::array<std::size_t, 4>> critical_counts;
  std::optional<std::array<std::size_t, 3>> regular_counts;  // of kinds 1-2, 1-3, 2-3
};

}  // namespace flowcert
