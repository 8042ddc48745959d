// What pores.cpp and pore_windows.cpp share: how leaves come together. Leaves are the points of index 3, by their
// places in the list of points, and the outside, which has the list's length.
#pragma once

#include "oracle/pores.h"

namespace oracle {

// By leaf, the same number for those of one component. What is at the places of other points means nothing.
using Components = std::vector<std::size_t>;

// An index-2 point, and the leaves that are its ends.
struct Link {
  std::size_t point = 0;
  Ends ends;  // of both sides
};

// Makes one of all components that hold these ends.
void join(Components& components, const Ends& ends);
// The components that hold them, ascending.
Places components_at(const Components& components, const Ends& ends);

// By falling value, the links of each value.
std::vector<std::vector<Link>> links_by_value(const Pores& pores);

// From the points, the ends and the chambers: vestibules, windows and handles.
void find_windows(Pores& pores);

}  // namespace oracle
