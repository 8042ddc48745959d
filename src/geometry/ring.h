// Rings of corners, which have no first one of their own.
//
// Guarantees: two lists of one ring become equal in canonical form.
#pragma once

#include <algorithm>
#include <functional>
#include <vector>

namespace flowcert::geometry {

// Keeps one of corners that follow one another around the ring and are the same.
template <typename Corner, typename IsSame = std::equal_to<>>
void merge_repeated(std::vector<Corner>& ring, const IsSame& is_same = {}) {
  ring.erase(std::unique(ring.begin(), ring.end(), is_same), ring.end());
  while (ring.size() > 1 && is_same(ring.front(), ring.back())) ring.pop_back();
}

// From the least corner on, in the same sense.
template <typename Corner>
void begin_with_least(std::vector<Corner>& ring) {
  merge_repeated(ring);
  std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end()), ring.end());
}

// From the least corner towards the lesser of its neighbours.
template <typename Corner>
void make_canonical(std::vector<Corner>& ring) {
  begin_with_least(ring);
  if (ring.size() > 2 && ring.back() < ring[1]) std::reverse(ring.begin() + 1, ring.end());
}

}  // namespace flowcert::geometry
