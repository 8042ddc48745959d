// In which order points go into the triangulation, on which it depends how ties are broken (FC-CLAIM-09).
//
// Guarantees: the order is that of every other system: it was found with g++ 12, CGAL 5.5 and with g++ 14, CGAL 6.0. A
// C++ library's own std::nth_element gives another one.
#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "flowcert/point_set.h"
#include "flowcert/voronoi_diagram.h"
#include "tests/cites.h"
#include "voronoi/compact_delaunay.h"

namespace flowcert::voronoi::insertion_order_test {
namespace {

// FNV-1a of the ordinals.
std::uint64_t digest_of(const std::vector<Point>& rows) {
  const PointSet points(rows);
  const Delaunay delaunay(points);
  std::uint64_t digest = 14695981039346656037U;
  for (const std::uint32_t ordinal : compact_copy(delaunay).ordinals) digest = (digest ^ ordinal) * 1099511628211U;
  return digest;
}

// Many coordinates are equal, so that a selection has much to choose from.
TEST(InsertionOrder, OfAGridIsTheSameOnEverySystem) {
  CITES("FC-CLAIM-09");
  std::vector<Point> rows;
  for (int x = 0; x < 9; ++x) {
    for (int y = 0; y < 9; ++y) {
      for (int z = 0; z < 9; ++z) rows.push_back({double(x), double(y), double(z)});
    }
  }
  EXPECT_EQ(digest_of(rows), 8240845984678904037U);
}

}  // namespace
}  // namespace flowcert::voronoi::insertion_order_test
