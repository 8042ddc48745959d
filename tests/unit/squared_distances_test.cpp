// Squared distances of stationary points: the doubles lie within their bounds, and ranks are the order of the exact
// values, on inputs with many equal values, with nearly equal ones, and beyond the range of the filter.
#include "flowcert/squared_distances.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

#include "flowcert/flow_complex.h"
#include "fuzz/inputs/families.h"
#include "fuzz/properties/input_points.h"
#include "morse/value_order.h"
#include "tests/cites.h"
#include "tests/unit/portable_random.h"

namespace flowcert::squared_distances_test {
namespace {

struct Seen {
  std::size_t records = 0, equal = 0, inexact = 0;
};

// Any two records make a pair here. The longest ones, by their order among all of them, are never left out.
void expect_longest(const SquaredDistances& distances, const StationaryPoints& list) {
  std::vector<morse::PairEnds> pairs;
  for (std::size_t record = 0; record + 1 < list.size(); ++record) {
    const std::size_t other = (record * 7 + 3) % list.size();
    if (distances.rank(record) <= distances.rank(other)) pairs.push_back({record, other});
  }
  const auto longest = [&](const std::vector<morse::PairEnds>& ends, std::size_t count) {
    const morse::ValueOrder order = morse::length_order(distances, ends);
    std::vector<std::pair<std::size_t, std::size_t>> found;
    for (std::size_t k = order.size(); k > 0 && found.size() < count; --k) {
      found.emplace_back(ends[order.at(k - 1)].birth, ends[order.at(k - 1)].death);
    }
    return found;
  };
  for (const std::size_t count : {0U, 1U, 5U, 1000U}) {
    EXPECT_EQ(longest(morse::perhaps_longest(distances, pairs, count), count), longest(pairs, count));
  }
}

// A level is between two values, and some levels are values, too.
void expect_levels(const SquaredDistances& distances, const std::vector<Rational>& exact) {
  if (exact.empty() || exact[distances.ascending().back()] == 0) return;
  const std::uint32_t least = distances.ascending().front(), greatest = distances.ascending().back();
  const std::uint32_t middle = distances.ascending()[exact.size() / 2];
  for (const Rational& share : {Rational(0), Rational(1, 3), Rational(exact[middle] / exact[greatest]), Rational(1)}) {
    const SquaredLevel level(distances, least, greatest, share);
    const Rational number = exact[least] + share * (exact[greatest] - exact[least]);
    ASSERT_EQ(level.exact(), number);
    ASSERT_EQ(SquaredLevel(number).exact(), number);
    for (std::uint32_t record = 0; record < exact.size(); ++record) {
      const auto order = exact[record].compare(number) <=> 0;
      ASSERT_EQ(distances.compare(record, level), order);
      ASSERT_EQ(distances.compare(record, SquaredLevel(number)), order);
      ASSERT_EQ(distances.compare(record, number), order);
    }
  }
}

void expect_right(const FlowComplex& complex, Seen& seen) {
  const StationaryPoints& list = complex.stationary();
  const SquaredDistances distances(complex.points(), list);
  std::vector<Rational> exact;
  for (std::size_t record = 0; record < list.size(); ++record) {
    exact.push_back(complex.sphere(record).squared_radius);
    EXPECT_EQ(distances.exact(record), exact.back());
    const auto [value, error] = distances.approximation(record);
    if (!std::isfinite(error)) continue;
    EXPECT_LE(abs(Rational(value) - exact.back()), Rational(error));
    seen.inexact += error > 0 ? 1 : 0;
  }
  const std::set<Rational> different(exact.begin(), exact.end());
  std::size_t place = 0;
  std::map<Rational, std::size_t> rank_of;
  for (const Rational& value : different) rank_of[value] = place++;
  for (std::size_t record = 0; record < list.size(); ++record) {
    ASSERT_EQ(distances.rank(record), rank_of.at(exact[record])) << "record " << record;
  }
  std::vector<std::uint32_t> ascending(list.size());
  std::iota(ascending.begin(), ascending.end(), 0U);
  std::ranges::stable_sort(ascending, {}, [&](std::uint32_t record) { return rank_of.at(exact[record]); });
  for (const unsigned threads : {1U, 2U, 3U}) {
    const SquaredDistances again(complex.points(), list, threads);
    EXPECT_TRUE(std::ranges::equal(again.ascending(), ascending));
  }
  expect_longest(distances, list);
  expect_levels(distances, exact);
  seen.records += list.size();
  seen.equal += list.size() - different.size();
}

TEST(SquaredDistances, DoublesAreWithinTheirBoundsAndRanksAreExact) {
  CITES("FC-PERS-01", "FC-NUM-01");
  Seen seen;
  for (const fuzz::Family& family : fuzz::families()) {
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
      const fuzz::Input input = fuzz::draw(family, seed, static_cast<int>(10 + 4 * seed));
      expect_right(FlowComplex(property::point_set_of(input)), seen);
    }
  }
  EXPECT_GT(seen.records, 5000U);
  EXPECT_GT(seen.equal, 1000U);
  EXPECT_GT(seen.inexact, 3000U);
}

// One shape has many scales: squares of degree 8 overflow there, or underflow, or a double has few bits.
TEST(SquaredDistances, ScaleDoesNotMatter) {
  CITES("FC-PERS-01", "FC-NUM-01");
  flowcert_tests::PortableRandom random(3);
  std::vector<Point> unit;
  const auto number = [&] { return static_cast<double>(random.below(1000)); };
  unit.reserve(25);
  for (int k = 0; k < 25; ++k) unit.push_back({number(), number(), number()});
  Seen seen;
  for (const int exponent : {0, -1000, -400, -130, -60, 60, 120, 300, 480}) {
    std::vector<Point> rows;
    rows.reserve(unit.size());
    for (const Point& p : unit) {
      rows.push_back({std::ldexp(p.x, exponent), std::ldexp(p.y, exponent), std::ldexp(p.z, exponent)});
    }
    expect_right(FlowComplex(PointSet(rows)), seen);
  }
  EXPECT_GT(seen.records, 500U);
}

// Rounding errors that add up: these squared distances are off by more than a tenth of the bound of a circle, and by
// more than an eighteenth of that of a sphere. They are the worst of millions of drawn triangles and tetrahedra.
TEST(SquaredDistances, BoundsHoldWhereErrorsAddUp) {
  CITES("FC-NUM-01");
  for (const std::vector<Point>& rows :
       {std::vector<Point>{{0.458, 0.997, 0.171}, {0.71, 0.969, 0.13}, {0.769, 0.948, 0.513}},
        std::vector<Point>{{1.16294, 1.16892, 0.55577},
                           {0.67936, 0.68196, 1.24625},
                           {0.3441, 0.5479, -0.71812},
                           {-0.19188, -0.25002, 0.38569}}}) {
    const FlowComplex complex{PointSet(rows)};
    EXPECT_EQ(complex.stationary().contact(complex.stationary().size() - 1).size(), rows.size());
    Seen seen;
    expect_right(complex, seen);
    EXPECT_GT(seen.inexact, 0U);
  }
}

// The differences of coordinates of both short edges are 1 as doubles, and one of them is less by 2^-60.
TEST(SquaredDistances, EdgesThatAreCongruentInDoublesAreToldApart) {
  CITES("FC-PERS-01", "FC-NUM-01");
  const FlowComplex complex(
      PointSet(std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {0x1p-60, 100, 0}, {1, 100, 0}, {0, 200, 0}, {1, 200, 0}}));
  Seen seen;
  expect_right(complex, seen);
  EXPECT_GT(seen.equal, 0U);
}

// Two edges whose lengths differ by less than a double of their squares can tell.
TEST(SquaredDistances, NearlyEqualValuesAreToldApart) {
  CITES("FC-PERS-01", "FC-NUM-01");
  const double ulp = 0x1p-52;
  const FlowComplex complex(PointSet(std::vector<Point>{
      {0, 0, 0}, {1, 0, 0x1p-30}, {0, 100, 0}, {1, 100, 0x1p-30 * (1 + ulp)}, {0, 200, 0}, {1, 200, 0x1p-30}}));
  Seen seen;
  expect_right(complex, seen);
  const SquaredDistances distances(complex.points(), complex.stationary());
  std::vector<std::uint32_t> of_short_edges;
  for (std::size_t record = 6; record < complex.stationary().size(); ++record) {
    const auto contact = complex.stationary().contact(record);
    if (contact.size() == 2 && contact[1] == contact[0] + 1) of_short_edges.push_back(distances.rank(record));
  }
  EXPECT_EQ(of_short_edges, (std::vector<std::uint32_t>{1, 2, 1}));
}

}  // namespace
}  // namespace flowcert::squared_distances_test
