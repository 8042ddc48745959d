// Signatures of inputs: on inputs whose degeneracy is known each component says what it is named after. On
// all families there are many signatures, but not too many.
#include "fuzz/campaign/degeneracy_signature.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <numeric>
#include <set>
#include <string>
#include <vector>

#include "flowcert/flow_complex.h"
#include "flowcert/point_set.h"
#include "fuzz/inputs/configurations.h"
#include "fuzz/inputs/large_configurations.h"
#include "fuzz/inputs/stable_configurations.h"
#include "fuzz/properties/input_points.h"
#include "tests/transformed_inputs.h"

namespace flowcert::fuzz::degeneracy_signature_test {
namespace {

std::string text_of(const Input& input) { return to_text(combinatorial_part(signature_of(input))); }

// For example "1+" for "duplicates".
std::string value_of(SignaturePart part, const Input& input) {
  return value_text(static_cast<std::size_t>(part), signature_of(input)[part]);
}

// The values that a component takes on so many draws of a configuration.
std::set<std::string> values_of(SignaturePart part, const rc::Gen<IntegerPoints>& points) {
  std::set<std::string> values;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    values.insert(value_of(part, to_input(distinct(points(rc::Random(seed), 100).value()))));
  }
  return values;
}

const Input& cube() {
  static const Input rows{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}}};
  return rows;
}
// No sphere, circle, plane or right angle is met exactly.
const Input& generic() {
  static const Input rows{{{0, 0, 0}, {10, 1, 2}, {3, 9, -1}, {2, 3, 11}, {7, -8, 5}}};
  return rows;
}

TEST(Signature, OfACube) {
  EXPECT_EQ(text_of(cube()),
            "dimension=3 duplicates=0 cluster=7-8 polygon=4 12=0 23=0 13=0 chain=0 vertex-starts=0 "
            "vertex-hits=0 ends-regular=0 ends-infinity=1+ cascade=1 descent=1 s2-vertex=0 s2-interval=0 "
            "ties=0 exact=none exact-flow=none");
}

TEST(Signature, OfASquare) {
  EXPECT_EQ(text_of({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}}),
            "dimension=2 duplicates=0 cluster=0-4 polygon=4 12=0 23=0 13=0 chain=0 vertex-starts=0 "
            "vertex-hits=0 ends-regular=0 ends-infinity=1+ cascade=1 descent=1 s2-vertex=0 s2-interval=0 "
            "ties=0 exact=none exact-flow=none");
}

TEST(Signature, OfARightTriangle) {
  EXPECT_EQ(text_of({{{0, 0, 0}, {3, 0, 0}, {0, 4, 0}}}),
            "dimension=2 duplicates=0 cluster=0-4 polygon=0-3 12=1 23=0 13=0 chain=1 vertex-starts=0 "
            "vertex-hits=0 ends-regular=0 ends-infinity=0 cascade=0 descent=0 s2-vertex=0 s2-interval=0 "
            "ties=0 exact=none exact-flow=none");
}

// The arithmetic is generic too: filters and intervals decide everything.
TEST(Signature, OfGenericPoints) {
  EXPECT_EQ(to_text(signature_of(generic())),
            "dimension=3 duplicates=0 cluster=0-4 polygon=0-3 12=0 23=0 13=0 chain=0 vertex-starts=0 "
            "vertex-hits=0 ends-regular=0 ends-infinity=1+ cascade=1 descent=1 s2-vertex=0 s2-interval=0 "
            "ties=0 exact=none exact-flow=none");
}

TEST(Signature, OfNothingAndOfOnePoint) {
  EXPECT_EQ(value_of(SignaturePart::kDimension, {}), "none");
  EXPECT_EQ(value_of(SignaturePart::kDimension, {{{1, 2, 3}}}), "0");
  EXPECT_EQ(value_of(SignaturePart::kDimension, {{{1, 2, 3}, {2, 4, 6}, {0, 0, 0}}}), "1");
}

TEST(Signature, RefusesWhatIsNotFinite) {
  EXPECT_THROW((void)signature_of({{{0, std::numeric_limits<double>::infinity(), 0}}}), InvalidInput);
  EXPECT_THROW((void)signature_of({{{0, std::numeric_limits<double>::quiet_NaN(), 0}}}), InvalidInput);
}

TEST(Signature, SeesDuplicates) {
  Input twice = generic();
  EXPECT_EQ(value_of(SignaturePart::kDuplicates, twice), "0");
  const std::string once = text_of(twice);
  twice.rows.push_back(twice.rows[2]);
  EXPECT_EQ(value_of(SignaturePart::kDuplicates, twice), "1+");
  DegeneracySignature signature = combinatorial_part(signature_of(twice));
  signature[SignaturePart::kDuplicates] = 0;
  EXPECT_EQ(to_text(signature), once);
}

TEST(Signature, SeesClustersAndPolygonsBySize) {
  // Points of one circle, and two off its plane.
  const IntegerPoints circle{{5, 0, 0}, {3, 4, 0}, {-3, 4, 0}, {-5, 0, 0}, {-4, -3, 0}, {0, -5, 0}, {4, -3, 0}};
  const std::vector<std::string> polygons{"0-3", "4", "5-6", "5-6", "7+"};
  const std::vector<std::string> clusters{"0-4", "5", "6", "7-8", "7-8"};
  for (std::size_t corners = 3; corners <= 7; ++corners) {
    IntegerPoints points(circle.begin(), circle.begin() + static_cast<std::ptrdiff_t>(corners));
    EXPECT_EQ(value_of(SignaturePart::kPolygon, to_input(points)), polygons[corners - 3]) << corners;
    points.push_back({1, 0, 20});
    EXPECT_EQ(value_of(SignaturePart::kPolygon, to_input(points)), polygons[corners - 3]) << corners;
    EXPECT_EQ(value_of(SignaturePart::kCluster, to_input(points)), clusters[corners - 3]) << corners;
  }
  EXPECT_EQ(value_of(SignaturePart::kCluster, cube()), "7-8");
}

// Where all points of right_angles_13() lie in one plane, the kind is (1,2).
TEST(Signature, SeesRegularStationaryPointsByKind) {
  const auto reaches_none = [](SignaturePart part, const rc::Gen<IntegerPoints>& points) {
    return values_of(part, points).count("0") > 0;
  };
  EXPECT_FALSE(reaches_none(SignaturePart::kKind12, right_angles_12()));
  EXPECT_FALSE(reaches_none(SignaturePart::kKind23, right_angles_23()));
  EXPECT_GT(values_of(SignaturePart::kKind13, right_angles_13()).count("1"), 0U);
  EXPECT_TRUE(reaches_none(SignaturePart::kKind13, right_angles_12()));
  EXPECT_TRUE(reaches_none(SignaturePart::kKind12, right_angles_23()));
  EXPECT_TRUE(reaches_none(SignaturePart::kKind23, right_angles_13()));
}

TEST(Signature, CountsChainsOfRightAngledVoronoiEdges) {
  const auto chain = [](const Input& input) { return value_of(SignaturePart::kChain, input); };
  // Tetrahedra with no right triangle, one, two and three.
  EXPECT_EQ(chain({{{-5, 0, 0}, {5, 0, 0}, {2, 6, 0}, {1, 1, 30}}}), "0");
  const Input one{{{-5, 0, 0}, {5, 0, 0}, {3, 4, 0}, {1, 1, 30}}};
  EXPECT_EQ(chain(one), "1");
  EXPECT_EQ(chain({{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 1, 4}}}), "2");
  EXPECT_EQ(chain({{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}}}), "3+");
  // Right triangles that are far apart form no chain.
  Input apart = one;
  for (const auto& [x, y, z] : one.rows) apart.rows.push_back({x + 1000, y + 37, z + 11});
  EXPECT_EQ(value_of(SignaturePart::kKind12, apart), "2+");
  EXPECT_EQ(chain(apart), "1");
  // The cube's right triangles are halves of squares, which have their centres inside.
  EXPECT_EQ(chain(cube()), "0");
  EXPECT_EQ(chain({{{0, 0, 0}, {3, 0, 0}, {0, 4, 0}}}), "1");
}

TEST(Signature, SeesOrbitsThatMeetVoronoiVertices) {
  EXPECT_EQ(value_of(SignaturePart::kVertexHits, generic()), "0");
  EXPECT_GT(values_of(SignaturePart::kVertexHits, rings_of_pairs()).count("2+"), 0U);
  EXPECT_GT(values_of(SignaturePart::kVertexStarts, rings_of_pairs()).count("2+"), 0U);
  EXPECT_EQ(value_of(SignaturePart::kVertexStarts, cube()), "0");
}

TEST(Signature, SeesWhereOrbitsEnd) {
  EXPECT_EQ(value_of(SignaturePart::kEndsAtInfinity, cube()), "1+");
  EXPECT_EQ(value_of(SignaturePart::kEndsAtRegular, cube()), "0");
  // An orbit goes from the small square up to the sphere's centre, which is the large square's centre as well.
  const Input frustum{{{5, 0, 0}, {0, 5, 0}, {-5, 0, 0}, {0, -5, 0}, {3, 0, -4}, {0, 3, -4}, {-3, 0, -4}, {0, -3, -4}}};
  EXPECT_EQ(value_of(SignaturePart::kKind23, frustum), "1");
  EXPECT_EQ(value_of(SignaturePart::kEndsAtRegular, frustum), "1+");
  EXPECT_EQ(value_of(SignaturePart::kEndsAtInfinity, {{{0, 0, 0}, {4, 0, 0}, {2, 3, 0}}}), "1+");
  EXPECT_EQ(value_of(SignaturePart::kEndsAtInfinity, {{{0, 0, 0}, {3, 0, 0}, {0, 4, 0}}}), "0");
}

TEST(Signature, MeasuresCascadesBothWays) {
  const std::array<std::string, 2> both{value_of(SignaturePart::kCascade, long_cascade(40, 1)),
                                        value_of(SignaturePart::kDescent, long_cascade(40, 1))};
  EXPECT_EQ(both, (std::array<std::string, 2>{"9+", "9+"}));
  EXPECT_EQ(value_of(SignaturePart::kCascade, cube()), "1");
  EXPECT_EQ(value_of(SignaturePart::kCascade, {{{0, 0, 0}, {1, 0, 0}}}), "0");
}

TEST(Signature, SeesWhatStableManifoldsAreMadeOf) {
  EXPECT_GT(values_of(SignaturePart::kStableVertex, aimed_points()).count("1+"), 0U);
  EXPECT_GT(values_of(SignaturePart::kStableInterval, aimed_points()).count("1+"), 0U);
  EXPECT_EQ(value_of(SignaturePart::kStableVertex, generic()), "0");
  EXPECT_EQ(value_of(SignaturePart::kStableInterval, generic()), "0");
  EXPECT_EQ(value_of(SignaturePart::kTies, generic()), "0");
}

// Each component comes from its own number, and not from another one that is often zero at the same time.
TEST(Signature, SaysOfStableManifoldsWhatTheirStatisticsSay) {
  const auto yes_or_no = [](std::size_t count) { return std::string(count > 0 ? "1+" : "0"); };
  for (const Family& family : families_and_stable_ones()) {
    for (std::uint64_t seed = 0; seed < 25; ++seed) {
      const Input input = draw(family, seed, 60);
      const PointSet points = property::point_set_of(input);
      const FlowComplex complex(points);
      const StableManifolds& stable = complex.stable();
      const StableStatistics& statistics = stable.statistics();
      EXPECT_EQ(value_of(SignaturePart::kStableVertex, input), yes_or_no(statistics.with_vertex)) << input;
      EXPECT_EQ(value_of(SignaturePart::kStableInterval, input), yes_or_no(statistics.with_interval)) << input;
      EXPECT_EQ(value_of(SignaturePart::kTies, input), yes_or_no(statistics.broken_ties)) << input;
    }
  }
}

TEST(Signature, SeesWhatExactArithmeticDecided) {
  const auto asked = [](const Input& input) { return value_of(SignaturePart::kExact, input); };
  EXPECT_EQ(asked(generic()), "none");
  EXPECT_EQ(asked({{{0, 0, 0}, {3, 0, 0}, {0, 4, 0}}}), "angle");
  EXPECT_NE(asked(cube()).find("cospherical"), std::string::npos);
  // An angle that is nearly right is as hard for a filter.
  EXPECT_EQ(asked({{{0, 0, 0}, {3, 0, 0}, {0x1p-80, 4, 0}}}), "angle");
  // Orbits that meet Voronoi vertices run exactly on the sides of facets' rays.
  EXPECT_GT(values_of(SignaturePart::kExactFlow, rings_of_pairs()).count("side_of_ray"), 0U);
}

// ---- The list of components, and how many signatures there are ----

TEST(Signature, ComponentsHaveNamesAndWords) {
  ASSERT_EQ(signature_components().size(), kSignatureSize);
  ASSERT_EQ(static_cast<std::size_t>(SignaturePart::kExactFlow) + 1, kSignatureSize);
  std::set<std::string> names;
  for (std::size_t k = 0; k < kSignatureSize; ++k) {
    const SignatureComponent& component = signature_components()[k];
    EXPECT_TRUE(names.insert(component.name).second) << component.name;
    EXPECT_EQ(component.description.back(), '.') << component.name;
    std::set<std::string> texts;
    for (std::size_t value = 0; value < value_count(k); ++value) {
      texts.insert(value_text(k, static_cast<std::uint8_t>(value)));
    }
    EXPECT_EQ(texts.size(), value_count(k)) << component.name;
    EXPECT_LE(value_count(k), 256U);
  }
}

TEST(Signature, TextsTellSignaturesApart) {
  std::set<DegeneracySignature> signatures;
  std::set<std::string> texts;
  for (const Family& family : families_and_stable_ones()) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      const DegeneracySignature signature = signature_of(draw(family, seed, 50));
      signatures.insert(signature);
      texts.insert(to_text(signature));
    }
  }
  EXPECT_EQ(signatures.size(), texts.size());
}

std::vector<std::size_t> reversed_order(std::size_t rows) {
  std::vector<std::size_t> order(rows);
  std::iota(order.rbegin(), order.rend(), std::size_t{0});
  return order;
}

TEST(Signature, CombinatorialPartDoesNotDependOnTheOrderOfRows) {
  for (const Family& family : families_and_stable_ones()) {
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
      const Input input = draw(family, seed, 70);
      const std::size_t rows = input.rows.size();
      const std::string text = text_of(input);
      EXPECT_EQ(text_of(permuted(input, reversed_order(rows))), text) << family.name << '\n' << input;
      const auto order = row_orders(rows)(rc::Random(seed), 100).value();
      EXPECT_EQ(text_of(permuted(input, order)), text) << family.name << '\n' << input;
    }
  }
}

// Every component has to take all of its values (a set: three at least), and there must be hundreds of
// signatures, but far fewer than inputs.
TEST(Signature, AreManyAndNotTooMany) {
  std::set<DegeneracySignature> signatures;
  std::array<std::set<std::uint8_t>, kSignatureSize> reached;
  const std::vector<Family> all = families_and_stable_ones();
  const std::size_t inputs = 8000;
  for (std::size_t k = 0; k < inputs; ++k) {
    const auto size = static_cast<int>(k / all.size() % 101);
    const DegeneracySignature signature = signature_of(draw(all[k % all.size()], k, size));
    signatures.insert(signature);
    for (std::size_t part = 0; part < kSignatureSize; ++part) reached[part].insert(signature.values[part]);
  }
  EXPECT_GE(signatures.size(), 800U);
  EXPECT_LE(signatures.size(), inputs / 3);
  for (std::size_t part = 0; part < kSignatureSize; ++part) {
    const SignatureComponent& component = signature_components()[part];
    EXPECT_GE(reached[part].size(), component.is_set ? 3 : value_count(part)) << component.name;
  }
  RecordProperty("signatures", static_cast<int>(signatures.size()));
}

}  // namespace
}  // namespace flowcert::fuzz::degeneracy_signature_test
