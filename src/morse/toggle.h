// Guarantees: a set is a sum mod 2 of what is added to it.
#pragma once

#include <set>

namespace flowcert::morse {

// Adds an item that is not there, and takes away one that is.
template <class Item>
void toggle(std::set<Item>& items, const Item& item) {
  if (const auto [at, is_new] = items.insert(item); !is_new) items.erase(at);
}

}  // namespace flowcert::morse
