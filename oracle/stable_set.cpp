// The search of backward_search.h, from z. No piece has an end at infinity: all that is found flows to z, and what goes
// on for ever does not.
#include "oracle/stable_set.h"

#include "oracle/backward_search.h"

namespace oracle {

StableSet stable_set(const PointSet& set, const StationaryPoint& z) {
  BackwardSearch search(set);
  search.add_point(z.center);
  return std::move(search).sorted().bounded;
}

}  // namespace oracle
