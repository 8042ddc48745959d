// See flowcert/connecting_orbits.h.
#include "flowcert/connecting_orbits.h"

#include <algorithm>
#include <map>

#include "morse/layer.h"

namespace flowcert {

using namespace morse;

std::vector<std::vector<std::size_t>> connecting_orbits(const StableSet& set,
                                                        const RationalPoint& stationary) {
  std::map<RationalPoint, std::size_t> by_back;
  for (std::size_t i = 0; i < set.segments.size(); ++i) by_back.emplace(set.segments[i].back, i);
  std::vector<std::vector<std::size_t>> orbits;
  for (std::size_t i = 0; i < set.segments.size(); ++i) {
    if (set.segments[i].back_kind != BackKind::kCritical) continue;
    std::vector<std::size_t> orbit = {i};
    while (set.segments[orbit.back()].front != stationary) {
      const auto next = by_back.find(set.segments[orbit.back()].front);
      if (next == by_back.end()) break;
      orbit.push_back(next->second);
    }
    if (set.segments[orbit.back()].front != stationary) continue;
    std::ranges::reverse(orbit);
    orbits.push_back(std::move(orbit));
  }
  return orbits;
}

}  // namespace flowcert
