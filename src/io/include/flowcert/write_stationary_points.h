// Writes stationary points as JSON Lines: a header, then one record a point with its exact centre
// (spec/formats.md, section 2).
#pragma once

#include <functional>
#include <ostream>
#include <string>

#include "flowcert/stationary_points.h"

namespace flowcert {

// input_sha256: coordinates_sha256() of the rows that the point set was made of. progress, if given, is told
// now and then how many records are written. The stream's state tells whether all was written. O(records), a
// few microseconds each for the rationals.
void write_stationary_points(std::ostream& out, const PointSet& points, const StationaryPoints& stationary,
                             const std::string& input_sha256,
                             const std::function<void(std::size_t done, std::size_t total)>& progress = {});

}  // namespace flowcert
