// The alpha complex and its persistence as GUDHI computes them, behind an interface without GUDHI's headers:
// one file pays for compiling them.
//
// Guarantees: the simplices are those of GUDHI's exact alpha complex in three dimensions. That complex
// refuses flat points; they get GUDHI's complex for any dimension. GUDHI keeps filtration values in doubles,
// where different values can become equal, and equal ones different. So the caller gives the filtration as
// ranks.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "flowcert/point_set.h"

namespace flowcert::property {

struct GudhiSimplex {
  std::vector<std::size_t> vertices;  // places among the points, ascending
  std::vector<std::size_t> facets;    // places among the simplices
  double filtration = 0;              // GUDHI's own
};

struct GudhiPair {
  std::size_t birth = 0;  // places among the simplices
  std::optional<std::size_t> death;
};

class GudhiAlpha {
 public:
  // The points are distinct. Throws std::runtime_error if GUDHI makes no complex, or one of other points.
  explicit GudhiAlpha(std::span<const Point> points);
  ~GudhiAlpha();

  // Each face comes before the simplices that it is a face of.
  [[nodiscard]] const std::vector<GudhiSimplex>& simplices() const;
  // Pairs of all dimensions, over Z/2. Each simplex has a rank below 2^53, not less than its faces' ranks.
  [[nodiscard]] std::vector<GudhiPair> persistence(const std::vector<std::size_t>& rank);

 private:
  struct Complex;
  std::unique_ptr<Complex> complex_;
};

}  // namespace flowcert::property
