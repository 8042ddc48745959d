// Sorts by a key of 64 bits, on several threads.
//
// Apart from the headers that the file of the R-tree reads: in Boost 1.92 those for sorting and for that tree exclude
// each other.
#pragma once

#include <algorithm>
#include <boost/sort/spreadsort/integer_sort.hpp>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/parallel_for.h"

namespace flowcert::geometry {

// Each thread sorts one part; then they are merged. Items of equal keys come in any order.
template <typename Item>
void sort_in_parts(std::vector<Item>& items, unsigned threads, const auto& key) {
  const std::size_t part = std::max<std::size_t>((items.size() + threads - 1) / threads, 1);
  const auto at = [&](std::size_t k) {
    return items.begin() + static_cast<std::ptrdiff_t>(std::min(k * part, items.size()));
  };
  const auto is_less = [&key](const Item& one, const Item& other) { return key(one) < key(other); };
  const auto shifted = [&key](const Item& one, unsigned bits) -> std::uint64_t { return key(one) >> bits; };
  parallel_for(threads, threads,
               [&](std::size_t k) { boost::sort::spreadsort::integer_sort(at(k), at(k + 1), shifted, is_less); });
  for (std::size_t width = 1; width < threads; width *= 2) {
    for (std::size_t k = 0; k < threads; k += 2 * width) {
      std::inplace_merge(at(k), at(k + width), at(k + 2 * width), is_less);
    }
  }
}

}  // namespace flowcert::geometry
