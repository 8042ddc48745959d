// Chambers between balls: their gates, exits and windows, from the ends of index-2 points, value by value (FC-BALL-05,
// FC-BALL-07, FC-BALL-09).
//
// Points are named by their places in the list of critical points. Values below 0 are left out: what would happen there
// does not happen. Exact. This is meant for a dozen balls.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "oracle/ball_ends.h"
#include "oracle/ball_nerve.h"

namespace oracle {

// FC-BALL-05.
struct Chamber {
  Places peaks;                   // its peak points, ascending
  Places gates;                   // the points whose contacts are the gate's witnesses, ascending; none below 0
  std::optional<Quadratic> exit;  // nothing where it is below 0
  Places windows;                 // places in Pores::windows, ascending
  Places handles;                 // ascending
};

// An unmarked room between others (FC-BALL-09).
struct Vestibule {
  Places peaks;       // ascending
  Places neighbours;  // the rooms that were next to its cluster, ascending
};

// An index-2 point that stays between different rooms (FC-BALL-09).
struct Window {
  std::size_t point = 0;
  Places rooms;  // two at least, ascending
};

struct Pores {
  std::vector<BallPoint> points;          // the list of points
  std::vector<std::array<Ends, 2>> ends;  // by point; empty but for those of index 2
  std::vector<Chamber> chambers;          // the listed ones, in their order
  std::vector<Vestibule> vestibules;      // as they come; of one value, by their peaks
  std::vector<Window> windows;            // by their points
  std::vector<Cavity> cavities;           // of all chambers, ascending
};

// Rooms are numbers of chambers, and behind these of vestibules, and behind these of the outside.
std::size_t outside_room(const Pores& pores);

// Lists the chambers whose depth is `depth` or more, which is not negative.
Pores pores(const std::vector<Ball>& balls, const Rational& depth);
// Takes the list of points, where it is known.
Pores pores(const std::vector<Ball>& balls, const std::vector<BallPoint>& points, const Rational& depth);

}  // namespace oracle
