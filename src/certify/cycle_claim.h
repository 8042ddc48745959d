// Cycles that a program claims to stand for persistence pairs, in JSON or in lines (FC-FILE-52, FC-FILE-53,
// spec/formats/cycles.md).
//
// Guarantees: a claim is kept as it was made, right or wrong, and its rows are as claimed. A file in neither format
// throws InvalidInput, and for lines the message names the line.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "flowcert/claimed_number.h"
#include "flowcert/loop_classes.h"

namespace flowcert {

// Where a pair begins or ends: by one of these at least.
struct ClaimedPairEnd {
  std::vector<PointId> contact;  // empty where not claimed
  std::optional<ClaimedNumber> squared_distance;
};

using SampleTriangle = std::array<PointId, 3>;

struct ClaimedCycle {
  std::size_t line = 0;  // of lines; 0 in JSON
  ClaimedPairEnd birth, death;
  std::optional<ClaimedNumber> squared_level;  // none: that of the birth
  // The loop, in dimension 1. JSON may have it twice, and `polygons` is then the second one.
  std::vector<SampleEdge> edges;
  std::optional<std::vector<SampleEdge>> polygons;
  std::optional<std::vector<std::vector<PointId>>> saddles;  // of a surface
  // They are a surface in dimension 1, and go around a void in dimension 2.
  std::optional<std::vector<SampleTriangle>> triangles;
  // Contact sets of points of the void, in dimension 2.
  std::optional<std::vector<std::vector<PointId>>> maxima, walls, cell;
  // Their samples, in dimension 0.
  std::vector<std::vector<PointId>> components;
};

struct CycleClaim {
  int dimension = 1;
  bool is_whole = false;             // it has a cycle of each pair of its dimension
  std::optional<std::size_t> pairs;  // so many are said to be there
  std::vector<ClaimedCycle> cycles;
};

// Whether a file is such a claim: JSON that says so, or lines of which the first one has "cycles".
[[nodiscard]] bool is_cycle_claim(std::string_view bytes, const std::string& name);

// Reads what a program has written, without a byte order mark. name: of the file, for messages.
[[nodiscard]] CycleClaim claimed_cycles_of(std::string_view bytes, const std::string& name);

// Throws InvalidInput for a row that the input does not have.
void require_rows(const CycleClaim& claim, const PointSet& points, const std::string& name);

}  // namespace flowcert
