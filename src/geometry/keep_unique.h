// Guarantees: a list becomes the set of its items.
#pragma once

#include <algorithm>
#include <vector>

namespace flowcert::geometry {

// Sorts the items, and keeps each once.
template <typename Item>
void keep_unique(std::vector<Item>& items) {
  std::sort(items.begin(), items.end());
  items.erase(std::unique(items.begin(), items.end()), items.end());
}

}  // namespace flowcert::geometry
