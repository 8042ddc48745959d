// A vector that is made with items that nobody has set.
//
// The system clears each page of a large array when it is first written to. Where threads fill the parts of an array,
// they share that work, too, and nothing is written twice.
#pragma once

#include <boost/core/noinit_adaptor.hpp>
#include <memory>
#include <vector>

namespace flowcert::geometry {

template <typename Item>
using UnsetVector = std::vector<Item, boost::noinit_adaptor<std::allocator<Item>>>;

}  // namespace flowcert::geometry
