// The flow complex of a point set that has a cascade of a given length.
#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "flowcert/flow_complex.h"
#include "fuzz/inputs/large_configurations.h"
#include "fuzz/properties/input_points.h"

namespace flowcert::property {

// The flow crosses the first facets of the strip from vertex to vertex, an eighth of all. Then no vertex is met.
inline std::size_t points_of_cascade(std::size_t length) { return length + length / 6 + 8; }

struct CascadeOfLength {
  CascadeOfLength(std::size_t length, ConstructionKernel kernel)
      : complex(rows_of(fuzz::long_cascade(points_of_cascade(length), 1)), {kernel, FacetSearch::kBinary}) {}

  [[nodiscard]] const FlowStatistics& u2() const { return complex.unstable().statistics(); }

  FlowComplex complex;
};

// The same lengths, and the same ends.
inline void expect_the_same(const CascadeOfLength& one, const CascadeOfLength& other) {
  EXPECT_EQ(one.u2().n_u2, other.u2().n_u2);
  EXPECT_EQ(one.u2().n_wcc, other.u2().n_wcc);
  EXPECT_EQ(one.u2().census, other.u2().census);
  const UnstableManifolds &of_one = one.complex.unstable(), &of_other = other.complex.unstable();
  ASSERT_EQ(of_one.size(), of_other.size());
  for (std::size_t i = 0; i < of_one.size(); ++i) {
    for (const std::size_t side : {0U, 1U}) EXPECT_EQ(of_one.limit(i, side), of_other.limit(i, side));
  }
}

}  // namespace flowcert::property
