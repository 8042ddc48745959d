// The truth as the oracle finds it, which shares nothing with this implementation. Code that judges takes it as
// functions, because src/ does not know the oracle.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

#include "certify/layer.h"
#include "certify/pair_differences.h"
#include "certify/truth.h"

namespace flowcert::certify {

struct VectorCase;

struct OtherTruth {
  std::size_t most_points = 0;
  // Throws InvalidInput for more points.
  std::function<std::unique_ptr<Truth>(const std::vector<Point>& rows)> of;
  std::size_t most_points_of_pairs = 0;
  // Persistence pairs. Throws InvalidInput for more points.
  std::function<std::vector<ListedPair>(const std::vector<Point>& rows)> pairs_of;
  // What a conformance vector says is right, and what follows from it. The vector must outlive it.
  std::function<std::unique_ptr<Truth>(const VectorCase& one)> of_vector;
};

}  // namespace flowcert::certify
