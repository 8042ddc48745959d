// Chambers between balls, their gates, exits and windows, for probes of all radii at once.
//
// Guarantees: exact, on every input. d(x) is the least |x - p| - r over the balls. A critical point of it is known by
// the balls that attain d(x); no tolerance decides, and no order of the input. Points with values below 0 are left out,
// where balls vanish one by one. Numbers of points are places in points(), which descend by value; equal values have
// one rank. Source: spec section 19 (clauses FC-BALL).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "flowcert/ball_set.h"
#include "flowcert/quadratic_number.h"

namespace flowcert {

// A critical point of d (FC-BALL-03).
struct BallPoint {
  std::uint8_t index = 0;              // 1 to 3
  std::uint32_t rank = 0;              // of its value, d(x); 0 for the greatest one
  std::vector<std::uint32_t> contact;  // the balls that are nearest, by id, ascending
};

// Where the widest ways between two rooms are narrowest (FC-BALL-09).
struct PoreWindow {
  std::uint32_t point = 0;           // of index 2
  std::vector<std::uint32_t> rooms;  // two at least, ascending: numbers of rooms
};

// A room apart (FC-BALL-05).
struct Chamber {
  std::vector<std::uint32_t> peaks;    // the points where it is widest, all of one value: one at least, ascending
  std::vector<std::uint32_t> gates;    // those that end it, all of one value; none where it ends below 0
  std::optional<std::uint32_t> exit;   // a point whose value is the exit; nothing where that is below 0
  std::vector<std::uint32_t> windows;  // places in Pores::windows, ascending
  std::vector<std::uint32_t> handles;  // points of index 2 with both ends in this room alone, ascending
};

// What a chamber is for a probe (FC-BALL-06).
enum class ChamberStatus : std::uint8_t { kOpen, kClosed, kTooSmall };
// "open", "closed", "too small"
[[nodiscard]] const char* status_text(ChamberStatus status);

// Cavities whose value is between these: g < s <= h (FC-BALL-07). No gate: it is below 0.
struct CavityInterval {
  std::optional<std::uint32_t> gate;
  std::uint32_t peak = 0;
};

// The number of cavities for probes up to the value of this point, and above that of the next step, or from 0.
struct CavityStep {
  std::uint32_t point = 0;
  std::size_t count = 0;
};

// Const access is safe from several threads.
class Pores {
 public:
  static constexpr std::uint32_t kOutside = std::numeric_limits<std::uint32_t>::max();

  // The balls must outlive this. Expected O(n log n) for atoms, and what exact numbers take at ties. Throws
  // std::invalid_argument for a negative depth.
  Pores(const BallSet& balls, const Rational& depth, unsigned threads = 1);
  explicit Pores(BallSet&&, const Rational&, unsigned = 1) = delete;

  [[nodiscard]] const BallSet& balls() const { return *balls_; }
  [[nodiscard]] const std::vector<BallPoint>& points() const { return points_; }
  // d(x) and x of a point, in the units of the balls. Made anew each time.
  [[nodiscard]] QuadraticNumber value(std::uint32_t point) const;
  [[nodiscard]] std::array<QuadraticNumber, 3> center(std::uint32_t point) const;
  // Of the depth or deeper, the deepest first; equally deep ones by their first peaks. One whose gate is below 0 is
  // taken where its peak is as high as the depth, and comes as if its gate were 0.
  [[nodiscard]] const std::vector<Chamber>& chambers() const { return chambers_; }
  // By falling value. Their rooms are numbers of chambers; behind those, of vestibules; and kOutside.
  [[nodiscard]] const std::vector<PoreWindow>& windows() const { return windows_; }
  // The peaks of each vestibule, an unmarked room that is between rooms of one value (FC-BALL-09), ascending.
  [[nodiscard]] const std::vector<std::vector<std::uint32_t>>& vestibules() const { return vestibules_; }
  // All chambers, whatever their depth, with one of those that are highest at a tie left out, by falling peak and gate.
  [[nodiscard]] const std::vector<CavityInterval>& cavities() const { return cavities_; }

  [[nodiscard]] ChamberStatus status(const Chamber& chamber, const Rational& probe) const;
  [[nodiscard]] std::size_t cavities_at(const Rational& probe) const;
  // The same for all probes, from the greatest down. There is none above the first step.
  [[nodiscard]] std::vector<CavityStep> cavity_steps() const;

 private:
  friend class PoreSearch;
  // What makes a value: a point is inside of the simplex of some of its contacts, and its value is a root of it.
  struct Carrier {
    std::array<std::uint32_t, 4> balls{};
    std::uint8_t count = 0, root = 0;
  };

  const BallSet* balls_;
  std::vector<BallPoint> points_;
  std::vector<Carrier> carriers_;
  std::vector<Chamber> chambers_;
  std::vector<PoreWindow> windows_;
  std::vector<std::vector<std::uint32_t>> vestibules_;
  std::vector<CavityInterval> cavities_;
};

}  // namespace flowcert
