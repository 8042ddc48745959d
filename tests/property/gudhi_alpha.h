// The alpha complex and its persistence as GUDHI computes them, behind an interface without GUDHI's headers:
// one file pays for compiling them.
//
// Guarantees: the simplices are those of GUDHI's alpha complex (of its three-dimensional one, exact; of the
// one for any dimension where the points are flat, which the former refuses). GUDHI keeps filtration values
// in doubles, in which different values can be equal, and equal ones different; so the pairs are those of a
// filtration that the caller gives as ranks.
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
  // Distinct points. Throws std::runtime_error if GUDHI makes no complex, or not of these points.
  explicit GudhiAlpha(std::span<const Point> points);
  ~GudhiAlpha();

  // Faces before what they are faces of.
  [[nodiscard]] const std::vector<GudhiSimplex>& simplices() const;
  // Of all dimensions, over Z/2. rank: of each simplex, not less than those of its faces; below 2^53.
  [[nodiscard]] std::vector<GudhiPair> persistence(const std::vector<std::size_t>& rank);

 private:
  struct Complex;
  std::unique_ptr<Complex> complex_;
};

}  // namespace flowcert::property
