// Whether a witness shows that a persistence pair of dimension 1 occurs (FC-CYC-08), without any other pair.
//
// Each point that the witness names is certified, and boundaries.h tells the rest. Exact, for any finite point set.
#pragma once

#include <string>
#include <vector>

#include "oracle/boundaries.h"

namespace oracle {

// `birth` and `death` are points of index 1 and 2 that have these values.
struct Witness {
  Contact birth, death;
  std::vector<Contact> loop, surface, cocycle;
  std::vector<Contact> met;  // the index-2 points of values below the death's whose boundary meets the cocycle
};

// What is wrong with a witness; "" if nothing is. It is the first of these:
// - "repeated" for a point that a list has twice, "no-critical-point" for one that is none of its index;
// - "not-a-cycle", "born-later" for an edge of the loop beyond the birth;
// - "surface-too-late" for a point of the surface beyond the death;
// - "cocycle-too-early" for an edge of the cocycle before the birth, "even-on-loop";
// - "odd-boundary" for an index-2 point before the death whose boundary has an odd number of the cocycle's edges;
// - "met" if `met` is another list;
// - "surface-boundary" if the boundaries of the surface do not sum up to the loop.
// Ties below: the cocycle has to be even by every choice of FC-CHAIN-02. The boundaries of the surface have to sum up
// to the loop by one choice, up to cycles that ties can add (boundaries.h). A point with a tie may be in `met` or not,
// if some choice meets the cocycle.
std::string fault(const PointSet& set, const Witness& witness);

}  // namespace oracle
