// Writes stationary points as JSON Lines, with what flows out of them and into them: the samples of index-1
// points, the limits of index-2 points and, if wanted, their U2 as exact polylines; the size and boundary of
// S2's and, if wanted, their exact skeletons (spec/formats.md, section 2).
#pragma once

#include <functional>
#include <ostream>
#include <string>

#include "flowcert/stable_manifolds.h"
#include "flowcert/unstable_manifolds.h"
#include "io/layer.h"

namespace flowcert::io {

// None is written where there is none.
struct ManifoldsToWrite {
  UnstableManifolds* u2 = nullptr;
  bool polylines = false;
  StableManifolds* s2 = nullptr;
  bool skeletons = false;
};

// As write_stationary_points(). Polylines and skeletons take the time of exact coordinates, all of them.
void write_manifolds(std::ostream& out, const PointSet& points, const StationaryPoints& stationary,
                     const ManifoldsToWrite& manifolds, const std::string& input_sha256,
                     const std::function<void(std::size_t done, std::size_t total)>& progress = {});

}  // namespace flowcert::io
