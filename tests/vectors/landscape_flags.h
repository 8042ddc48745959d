// Which flags about locations, merge trees, pockets, the medial axis, infinity and statistics hold for a case.
//
// Guarantees: each is asked of what the case lists, and of nothing else.
#pragma once

#include "tests/vectors/flags.h"

namespace oracle::vectors {

// ---- Locations
bool has_location_at_start(const Findings& found);
bool has_location_at_regular(const Findings& found);
bool has_location_at_infinity(const Findings& found);
bool has_several_nearest(const Findings& found);
bool has_two_on_a_ray(const Findings& found);

// ---- Merge trees
bool joins_three_pockets(const Findings& found);
bool joins_three_components(const Findings& found);
bool has_gates_beyond_need(const Findings& found);
bool has_two_nodes_of_a_value(const Findings& found);
bool has_node_of_nodes(const Findings& found);
bool has_only_infinity(const Findings& found);

// ---- Pockets
bool lists_pocket(const Findings& found);
bool lists_no_pocket(const Findings& found);
bool has_merged_pocket(const Findings& found);
bool has_merged_outside(const Findings& found);
bool has_pocket_apart(const Findings& found);
bool has_several_peaks(const Findings& found);
bool has_wider_cell(const Findings& found);
bool has_neighbour_pocket(const Findings& found);
bool has_several_gates(const Findings& found);
bool has_several_largest_balls(const Findings& found);
bool has_cavity(const Findings& found);
bool has_narrow_pocket(const Findings& found);
bool has_channel(const Findings& found);
bool passes_exactly(const Findings& found);

// ---- The medial axis
bool has_angle_at_bound(const Findings& found);
bool has_angle_between(const Findings& found);
bool leaves_choice(const Findings& found);

// ---- Infinity
bool has_bounded_piece(const Findings& found);
bool has_sector_of_two_ends(const Findings& found);
bool has_ray_from_regular(const Findings& found);

// ---- Statistics
bool has_cascade(const Findings& found);
bool has_long_connecting_orbit(const Findings& found);

}  // namespace oracle::vectors
