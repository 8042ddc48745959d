// Records in the order in which their Voronoi faces lie in space: neighbours share what is in the cache.
//
// Apart from record_finder.h, which the file of the R-tree reads (sort_in_parts.h).
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "flowcert/stationary_points.h"
#include "geometry/sort_in_parts.h"
#include "morse/layer.h"

namespace flowcert::morse {

// The numbers 0 to count - 1 in the order in which the faces of their records lie in space. record_of(i) is a place in
// the list.
[[nodiscard]] std::vector<std::uint32_t> along_the_curve(const StationaryPoints& list, std::size_t count,
                                                         const auto& record_of, unsigned threads) {
  // The key comes first, and then the number.
  std::vector<std::uint64_t> keyed(count);
  for (std::size_t i = 0; i < count; ++i) {
    keyed[i] = std::uint64_t{list.face(record_of(static_cast<std::uint32_t>(i)))} << 32 | i;
  }
  geometry::sort_in_parts(keyed, threads, [](std::uint64_t key) { return key; });
  std::vector<std::uint32_t> order(count);
  for (std::size_t i = 0; i < count; ++i) order[i] = static_cast<std::uint32_t>(keyed[i]);
  return order;
}

}  // namespace flowcert::morse
