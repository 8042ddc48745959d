// The power diagram of all probe radii at once: a triangulation of R^4 (spec clause FC-BALL-04).
//
// Guarantees: exact. |x - p|^2 - (r + s)^2 less |x|^2 - s^2 is affine in (x, s), so that the power diagrams of the
// balls, each grown by s, are the slices of one power diagram, of the sites (p, r) with the weights 2 r^2. The cells are
// the full cells of a regular triangulation that refines its dual. Its vertices are the visible balls.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "flowcert/ball_set.h"

namespace flowcert {

class BallDiagram {
 public:
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  using Corners = std::array<std::uint32_t, 5>;

  // Expected O(n log n) for atoms; O(n^2) at worst. The balls must outlive this.
  explicit BallDiagram(const BallSet& balls);
  explicit BallDiagram(BallSet&&) = delete;

  [[nodiscard]] const BallSet& balls() const { return *balls_; }
  // Of the affine hull of the sites: -1 to 4. 3 at most where all radii are equal.
  [[nodiscard]] int dimension() const { return dimension_; }
  // The finite cells: dimension() + 1 balls each, ascending, and then kNone.
  [[nodiscard]] const std::vector<Corners>& cells() const { return cells_; }
  // Behind each corner: the number of the cell that has the others, or kNone.
  [[nodiscard]] const std::vector<Corners>& adjacent() const { return adjacent_; }
  // The balls that have a common cell with this one, ascending; the numbers of those cells.
  [[nodiscard]] std::span<const std::uint32_t> neighbours(std::uint32_t id) const { return part(neighbours_, id); }
  [[nodiscard]] std::span<const std::uint32_t> star(std::uint32_t id) const { return part(star_, id); }

 private:
  struct Lists {
    std::vector<std::uint32_t> starts, items;
  };
  [[nodiscard]] static std::span<const std::uint32_t> part(const Lists& lists, std::uint32_t id) {
    return std::span(lists.items).subspan(lists.starts[id], lists.starts[id + 1] - lists.starts[id]);
  }
  void triangulate();
  void sort_cells();
  void make_lists();

  const BallSet* balls_;
  int dimension_ = -1;
  std::vector<Corners> cells_, adjacent_;
  Lists neighbours_, star_;
};

}  // namespace flowcert
