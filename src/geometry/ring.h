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
template <typename Corner, typename IsLess = std::less<>>
void begin_with_least(std::vector<Corner>& ring, const IsLess& is_less = {}) {
  merge_repeated(ring);
  std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end(), is_less), ring.end());
}

// From the least corner towards the lesser of its neighbours.
template <typename Corner, typename IsLess = std::less<>>
void make_canonical(std::vector<Corner>& ring, const IsLess& is_less = {}) {
  begin_with_least(ring, is_less);
  if (ring.size() > 2 && is_less(ring.back(), ring[1])) std::reverse(ring.begin() + 1, ring.end());
}

}  // namespace flowcert::geometry
