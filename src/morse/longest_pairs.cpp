#include "morse/longest_pairs.h"

#include <utility>

#include "morse/value_order.h"

namespace flowcert::morse {

std::vector<PersistencePair> longest_pairs(const SquaredDistances& values, const std::vector<PersistencePair>& pairs,
                                           std::size_t count) {
  if (pairs.empty() || count == 0) return {};
  std::vector<PairEnds> ends;
  ends.reserve(pairs.size());
  for (const PersistencePair& pair : pairs) ends.push_back({pair.birth, pair.death.value()});
  ends = perhaps_longest(values, std::move(ends), count);
  const ValueOrder order = length_order(values, ends);
  std::vector<PersistencePair> longest;
  for (std::size_t k = order.size(); k > 0 && longest.size() < count; --k) {
    const auto& [birth, death] = ends[order.at(k - 1)];
    longest.push_back({pairs.front().dimension, static_cast<std::uint32_t>(birth), static_cast<std::uint32_t>(death)});
  }
  return longest;
}

}  // namespace flowcert::morse
