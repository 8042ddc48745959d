// The pieces of the fast implementation's stable and unstable sets in the oracle's form, so that the oracle can be
// asked about them.
//
// Guarantees: exact. Lists keep their order.
#pragma once

#include <vector>

#include "fuzz/properties/stable_pieces.h"

namespace flowcert::property {

inline oracle::Corner to_oracle(const Corner<>& corner) { return {corner.position, corner.at_infinity}; }
inline oracle::EdgePart to_oracle(const EdgePart<>& part) {
  return {ids(part.polygon), to_oracle(part.front), to_oracle(part.back)};
}
inline oracle::Crossing to_oracle(const Crossing<>& crossing) {
  return {{crossing.samples[0], crossing.samples[1]}, to_oracle(crossing.front), to_oracle(crossing.back)};
}
inline oracle::Region to_oracle(const Region<>& region);

template <class From>
auto all_to_oracle(const std::vector<From>& pieces) {
  std::vector<decltype(to_oracle(pieces.front()))> made;
  for (const From& piece : pieces) made.push_back(to_oracle(piece));
  return made;
}

inline oracle::Region to_oracle(const Region<>& region) {
  return {{region.samples[0], region.samples[1]}, all_to_oracle(region.corners)};
}
inline oracle::BackwardSegment to_oracle(const BackwardSegment<>& segment) {
  return {to_oracle(static_cast<const Crossing<>&>(segment)), ids(segment.front_contact), ids(segment.back_contact),
          static_cast<oracle::BackKind>(segment.back_kind)};
}
inline oracle::UnstableSurface to_oracle(const UnstableSurface<>& set) {
  return {{set.vertices.begin(), set.vertices.end()},
          all_to_oracle(set.traces),
          all_to_oracle(set.runs),
          all_to_oracle(set.sheets),
          all_to_oracle(set.segments)};
}

}  // namespace flowcert::property
