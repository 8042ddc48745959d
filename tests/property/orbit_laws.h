// What spec section 8 says of every orbit, checked from the definitions on one orbit at a time: no second
// orbit to compare it with is needed.
//
// Guarantees: exact. All laws are checked: contact sets before, during and after each segment (FC-FLOW-01),
// types (FC-FLOW-02), drivers as nearest points of hulls, by search and by the plane that separates
// (FC-DIST-02, FC-FLOW-04), which change (FC-FLOW-09), growth of d and of the enclosing balls, and the end
// (FC-FLOW-05), what comes from outside of the hull (FC-STAB-08), and that no cell is entered again (FC-STAB-09).
#pragma once

#include <string>
#include <vector>

#include "fuzz/properties/orbit_comparison.h"
#include "oracle/stationary_points.h"

namespace flowcert::property {

// The points of a contact set.
std::vector<oracle::Point> points_of(const oracle::PointSet& set, const std::vector<std::size_t>& names);

// The first law that an orbit breaks, with its clause; empty if none.
std::string broken_law(const oracle::PointSet& set, const OrbitRecord& orbit);

}  // namespace flowcert::property
