// Invariants on inputs that are too large for the oracle's own search: the Euler sum, and the counts of full
// lattices; and the signatures of single tetrahedra.
//
// Guarantees: exact. On the large inputs the oracle certifies records spread over the whole list, one by one
// (each by a scan over all points), so that two errors do not pass for a right Euler sum.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <set>
#include <string>

#include "fuzz/inputs/input.h"
#include "fuzz/inputs/integer_points.h"
#include "oracle/fast/point_set.h"
#include "oracle/stationary_points.h"
#include "tests/cites.h"
#include "tests/property/property_parameters.h"
#include "tests/property/stationary_answers.h"
#include "voronoi/delaunay.h"

namespace flowcert::property::invariants_test {
namespace {

using fuzz::Integer;
using fuzz::IntegerPoints;

constexpr std::size_t kCertifiedRecords = 60;

class Dice {
 public:
  explicit Dice(std::uint64_t stream) : random_(rc::Random(seed_of_run() + stream)) {}
  Integer between(Integer low, Integer high) {
    return low + static_cast<Integer>(random_.next() % static_cast<std::uint64_t>(high - low + 1));
  }

 private:
  rc::Random random_;
};

Integer integer_root(Integer value) {
  auto root = static_cast<Integer>(std::sqrt(static_cast<double>(value)));
  while (root * root > value) {
    --root;
  }
  while ((root + 1) * (root + 1) <= value) {
    ++root;
  }
  return root;
}

IntegerPoints lattice_subset(Dice& dice, std::size_t count, Integer width) {
  IntegerPoints points;
  while (points.size() < count) {
    points.push_back({dice.between(0, width), dice.between(0, width), dice.between(0, width)});
  }
  return points;
}

// Heights of a sphere over a grid, rounded down.
IntegerPoints grid_rounded_sphere(Dice& dice, std::size_t count, Integer radius) {
  IntegerPoints points;
  while (points.size() < count) {
    const Integer x = dice.between(-radius, radius);
    const Integer y = dice.between(-radius, radius);
    const Integer rest = radius * radius - x * x - y * y;
    if (rest >= 0) {
      points.push_back({x, y, dice.between(0, 1) == 0 ? integer_root(rest) : -integer_root(rest)});
    }
  }
  return points;
}

// All integer points of a sphere.
IntegerPoints whole_integer_sphere(Integer norm) {
  const Integer reach = integer_root(norm);
  IntegerPoints points;
  for (Integer x = -reach; x <= reach; ++x) {
    for (Integer y = -reach; y <= reach; ++y) {
      const Integer rest = norm - x * x - y * y;
      const Integer z = rest < 0 ? -1 : integer_root(rest);
      if (z >= 0 && z * z == rest) {
        points.push_back({x, y, z});
        if (z > 0) {
          points.push_back({x, y, -z});
        }
      }
    }
  }
  return points;
}

fuzz::Input in_general_position(Dice& dice, std::size_t count) {
  constexpr Integer kReach = Integer{1} << 53;
  fuzz::Input input = fuzz::to_input(lattice_subset(dice, count, kReach));
  for (fuzz::Row& row : input.rows) {
    for (double& coordinate : row) {
      coordinate = std::ldexp(coordinate, -53);
    }
  }
  return input;
}

void expect_sound(const std::string& name, const fuzz::Input& input) {
  const StationaryAnswer answer = fast_answer(input);
  EXPECT_EQ(broken_clause(answer), "") << name;
  const oracle::fast::PointSet points(input.rows);
  const std::size_t stride = answer.records.size() / kCertifiedRecords + 1;
  for (std::size_t i = 0; i < answer.records.size(); i += stride) {
    const auto fault = oracle::certify(points, answer.records[i]);
    EXPECT_FALSE(fault.has_value()) << name << ", " << to_text(answer.records[i]) << ": "
                                    << (fault ? fault->clause + ": " + fault->explanation : "");
  }
}

TEST(Invariants, EulerSumOfLargerInputs) {
  CITES("FC-INV-01", "FC-CRIT-04", "FC-CRIT-05", "FC-CRIT-06", "FC-OUT-02");
  Dice dice(1);
  for (const std::size_t count : {std::size_t{200}, std::size_t{700}, std::size_t{2000}}) {
    const std::string size = ", " + std::to_string(count) + " points";
    for (const Integer width : {6, 12, 30}) {
      expect_sound("lattice" + size, fuzz::to_input(lattice_subset(dice, count, width)));
    }
    for (const Integer radius : {9, 25, 80}) {
      expect_sound("grid-rounded sphere" + size, fuzz::to_input(grid_rounded_sphere(dice, count, radius)));
    }
    expect_sound("general position" + size, in_general_position(dice, count));
  }
}

TEST(Invariants, EulerSumOfWholeIntegerSpheres) {
  CITES("FC-INV-01", "FC-CRIT-05", "FC-OUT-02");
  // All points of each are one cluster, and many share circles.
  for (const Integer norm : {1001, 2009, 5009, 10001, 20006, 50009}) {
    const IntegerPoints points = whole_integer_sphere(norm);
    EXPECT_GE(points.size(), 200U) << norm;
    EXPECT_LE(points.size(), 3000U) << norm;
    const fuzz::Input input = fuzz::to_input(points);
    expect_sound("norm " + std::to_string(norm), input);
    // The points are invariant under a change of all signs, so the origin is inside their hull, and a
    // maximum.
    const StationaryAnswer answer = fast_answer(input);
    EXPECT_EQ(answer.critical[3], 1U);
    EXPECT_EQ(answer.records.back().contact.size(), points.size());
  }
}

std::array<std::size_t, 4> lattice_counts(std::size_t k) {
  const std::size_t c = k - 1;
  return {k * k * k, 3 * c * k * k, 3 * c * c * k, c * c * c};
}

fuzz::Input full_lattice(Integer k) {
  IntegerPoints points;
  for (Integer code = 0; code < k * k * k; ++code) {
    points.push_back({code / (k * k) + 1, code / k % k + 1, code % k + 1});
  }
  return fuzz::to_input(points);
}

TEST(Invariants, FullLattices) {
  CITES("FC-INV-05", "FC-INV-01");
  for (Integer k = 1; k <= 8; ++k) {
    const StationaryAnswer answer = fast_answer(full_lattice(k));
    EXPECT_EQ(answer.critical, lattice_counts(static_cast<std::size_t>(k))) << k;
    EXPECT_EQ(answer.regular, (std::array<std::size_t, 3>{})) << k;
    EXPECT_EQ(broken_clause(answer), "") << k;
  }
  for (Integer k = 1; k <= 2; ++k) {
    const StationaryAnswer answer = oracle_answer(full_lattice(k));
    EXPECT_EQ(answer.critical, lattice_counts(static_cast<std::size_t>(k))) << k;
    EXPECT_EQ(answer.regular, (std::array<std::size_t, 3>{})) << k;
  }
}

TEST(Invariants, SignaturesOfTetrahedra) {
  CITES("FC-INV-03");
  std::set<std::array<std::size_t, 4>> signatures;
  expect_holds("signature", parameters_of_run(2000), [&] {
    const auto points = *rc::gen::container<IntegerPoints>(4, fuzz::integer_point(-6, 6));
    const fuzz::Input input = fuzz::to_input(points);
    const Comparison both = compare(input);
    if (!both.complaint.empty()) {
      RC_FAIL(both.complaint);
    }
    const PointSet merged = point_set_of(input);
    if (Delaunay(merged).dimension() < 3) {
      return;
    }
    const auto& signature = both.fast.critical;
    RC_ASSERT(signature[0] == 4U);
    RC_ASSERT(signature[0] + signature[2] == 1 + signature[1] + signature[3]);
    signatures.insert(signature);
  });
  // Signatures go from (4,3,0,0) to (4,6,4,1). A run that sees one or two has not drawn what it meant to.
  EXPECT_GE(signatures.size(), 5U);
}

}  // namespace
}  // namespace flowcert::property::invariants_test
