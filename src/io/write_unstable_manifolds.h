// Writes stationary points as JSON Lines, with what flows out of them and what they flow out of: the samples
// of index-1 points, the limits of index-2 points and, if wanted, their U2 as exact polylines
// (spec/formats.md, section 2).
#pragma once

#include <functional>
#include <ostream>
#include <string>

#include "flowcert/unstable_manifolds.h"

namespace flowcert {

// As write_stationary_points(). Polylines take the time of exact coordinates, all of them.
void write_unstable_manifolds(std::ostream& out, const PointSet& points, const StationaryPoints& stationary,
                              UnstableManifolds& u2, bool polylines, const std::string& input_sha256,
                              const std::function<void(std::size_t done, std::size_t total)>& progress = {});

}  // namespace flowcert
