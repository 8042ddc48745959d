// See fast_persistence.h.
#include "fuzz/properties/fast_persistence.h"

#include <algorithm>
#include <optional>

#include "flowcert/persistence.h"

namespace flowcert::property {

FastPersistence fast_persistence(const PointSet& points, std::uint64_t seed) {
  const VoronoiDiagram diagram{Delaunay(points)};
  const StationaryPoints stationary = stationary_points(diagram);
  UnstableManifolds unstable(diagram, stationary);
  const StableManifolds stable(diagram, stationary, {.flow = {}, .seed = seed});
  const ChainComplex complex(points, stationary, unstable, stable, seed);
  const Persistence persistence(points, stationary, complex);
  FastPersistence answer{{}, complex.broken_ties() > 0 || stable.statistics().broken_ties > 0};
  for (const PersistencePair& pair : persistence.pairs()) {
    answer.pairs.push_back({pair.dimension, persistence.squared_value(pair.birth), std::nullopt});
    if (pair.death) answer.pairs.back().death = persistence.squared_value(*pair.death);
  }
  std::sort(answer.pairs.begin(), answer.pairs.end());
  return answer;
}

std::string to_text(const std::vector<oracle::PersistencePair>& pairs) {
  std::string text;
  for (const oracle::PersistencePair& pair : pairs) {
    text += std::to_string(pair.dimension) + ' ' + pair.birth.str() + ' ' +
            (pair.death ? pair.death->str() : "inf") + '\n';
  }
  return text;
}

}  // namespace flowcert::property
