// Finds stationary points by position, for claims that name no contact set.
//
// Guarantees: nothing within the tolerance is overlooked; whether it really is within, the caller decides
// exactly. Expected constant time a question where positions are spread evenly.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "certify/layer.h"
#include "flowcert/check.h"

namespace flowcert::certify {

class PositionGrid {
 public:
  // O(truth.size()) exact centres.
  PositionGrid(Truth& truth, double tolerance);

  [[nodiscard]] const ExactSphere& sphere(std::size_t record) const { return spheres_[record]; }
  // All that are within the tolerance, and few more; ascending.
  [[nodiscard]] std::vector<std::size_t> near(const ClaimedPosition& position) const;

 private:
  using Cell = std::array<std::int64_t, 3>;
  struct Hash {
    std::size_t operator()(const Cell& cell) const;
  };
  [[nodiscard]] Cell cell_of(const std::array<double, 3>& position) const;

  struct Reach {
    std::array<double, 3> center;  // rounded
    double length;                 // at least the tolerance, and what rounding may add to it
  };

  std::vector<ExactSphere> spheres_;
  std::vector<Reach> reaches_;
  double cell_size_ = 1;
  std::unordered_map<Cell, std::vector<std::size_t>, Hash> cells_;
};

}  // namespace flowcert::certify
