// A limit has a greater value than the point below it. So the points are asked from the highest one on.
#include "oracle/peaks_above.h"

#include <algorithm>
#include <numeric>

#include "oracle/merge_tree.h"
#include "oracle/unstable_set.h"

namespace oracle {

PeaksAbove peaks_above(const PointSet& set, const std::vector<StationaryPoint>& all) {
  const std::vector<std::size_t> maxima = maxima_places(all);
  PeaksAbove above{std::vector<Peaks>(all.size()), std::vector<std::array<Peaks, 2>>(all.size())};
  for (std::size_t leaf = 0; leaf < maxima.size(); ++leaf) above.of[maxima[leaf]] = {leaf};
  const auto of_limit = [&](const std::optional<StationaryPoint>& limit) {
    if (!limit) return Peaks{maxima.size()};
    return above.of[static_cast<std::size_t>(std::find(all.begin(), all.end(), *limit) - all.begin())];
  };
  std::vector<std::size_t> places(all.size());
  std::iota(places.begin(), places.end(), std::size_t{0});
  std::sort(places.begin(), places.end(),
            [&](std::size_t a, std::size_t b) { return all[a].squared_distance > all[b].squared_distance; });
  for (const std::size_t place : places) {
    if (all[place].face_dimension == 0 || all[place].face_dimension == 3) continue;
    const std::vector<UnstableEntry> list = lambda_list(set, all[place]);
    for (const UnstableEntry& entry : list) above.of[place].merge(of_limit(entry.limit));
    if (all[place].face_dimension == 2 && all[place].is_critical()) {
      above.of_sides[place] = {of_limit(list[0].limit), of_limit(list[1].limit)};
    }
  }
  return above;
}

}  // namespace oracle
