// Choices of starts of orbits, drawn by RapidCheck.
//
// Guarantees: a choice is drawn without looking at the input, so both shrink, alone or together. It shrinks towards
// small numbers and the first kind. Apart from orbit_starts.h, because fuzz targets make choices of bytes, and link no
// RapidCheck.
#pragma once

#include <rapidcheck.h>

#include <cstddef>
#include <vector>

#include "fuzz/inputs/integer_points.h"
#include "fuzz/properties/orbit_starts.h"

namespace flowcert::property {

inline constexpr std::size_t kNumbersOfChoice = 12;

inline rc::Gen<StartChoice> start_choice() {
  using Numbers = std::vector<fuzz::Integer>;
  return rc::gen::apply(
      [](fuzz::Integer kind, const Numbers& numbers) {
        return StartChoice{static_cast<StartKind>(kind), {numbers.begin(), numbers.end()}};
      },
      fuzz::whole(0, kStartKindCount - 1),
      rc::gen::container<Numbers>(kNumbersOfChoice, fuzz::whole(0, fuzz::Integer{1} << 30)));
}

}  // namespace flowcert::property
