// An orbit has the limit, and one scan has the samples.
#include "oracle/location.h"

#include <stdexcept>

#include "oracle/orbit.h"

namespace oracle {

Location locate(const PointSet& set, const Point& x) {
  if (set.points.empty()) throw std::invalid_argument("without samples no point has a location");
  return {orbit(set, x).limit, contact_set(set, x)};
}

}  // namespace oracle
