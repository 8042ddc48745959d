// The fast implementation's stable set as the oracle's structure, so that the oracle's functions can be asked
// about it: triangles, and which points it contains.
//
// Guarantees: exact. Everything comes from the fast set's own pieces and from contact sets. The fast set does
// not list points, nor the intervals through which the rays of sectors leave. Its sectors' corners give both,
// by FC-STAB-05. No orbit is computed here.
#pragma once

#include <cstddef>

#include "flowcert/stable_manifolds.h"
#include "oracle/stable_set.h"

namespace flowcert::property {

oracle::StableSet skeleton_of(const oracle::PointSet& set, const oracle::StationaryPoint& z, const StableSet<>& fast);

}  // namespace flowcert::property
