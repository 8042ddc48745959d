// Writes stationary points as JSON Lines: a header, then one record a point with its exact centre and, if wanted,
// what flows out of it and into it (spec/formats/stationary_points.md).
//
// Guarantees: exact; the doubles beside the rationals are the nearest ones.
#pragma once

#include <functional>
#include <ostream>

#include "flowcert/flow_complex.h"

namespace flowcert {

// With u2, the samples of index-1 points and the limits of index-2 points; with polylines, their orbits as exact
// polylines. With s2, the size and boundary of stable sets; with skeletons, their exact skeletons.
struct RecordsToWrite {
  bool u2 = false;
  bool polylines = false;
  bool s2 = false;
  bool skeletons = false;
};

// progress, if given, is told now and then how many records are written. The stream's state tells whether all was
// written. O(records), a few microseconds each for the rationals; polylines and skeletons take the time of all
// their exact coordinates.
void write_stationary_points(std::ostream& out, const FlowComplex& complex, const RecordsToWrite& wanted = {},
                             const std::function<void(std::size_t done, std::size_t total)>& progress = {});

}  // namespace flowcert
