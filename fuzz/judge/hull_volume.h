// The volume of a convex hull, from the definition: a scan over all planes through three points. It is for the oracle's
// truth, and the fast implementation has no part in it. Exact.
#pragma once

#include <vector>

#include "fuzz/judge/layer.h"
#include "oracle/exact_geometry.h"

namespace flowcert::judge {

// 0 where the points do not span space. Takes time n^3 for most sets, and n^4 at worst.
[[nodiscard]] oracle::Rational oracle_hull_volume(const std::vector<oracle::Point>& points);

}  // namespace flowcert::judge
