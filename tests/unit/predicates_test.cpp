// The predicates, rung against rung, on every kind of input (tests/unit/point_tuples.h). A rung may leave a
// sign open, but what it says is what the next one says. The last one says what the definition says, which
// the test writes down itself, in rationals.
//
// Also which rung decides: the double filter on practically every generic input, the fixed-size integers on
// ties and near ties, GMP where the points span more than kWideBits bits, and that the tally counts just
// that.
#include "geometry/predicates.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <ostream>
#include <string>
#include <tuple>

#include "tests/cites.h"
#include "tests/unit/point_tuples.h"
#include "tests/unit/portable_random.h"
#include "tests/unit/rational_geometry.h"

namespace flowcert::geometry {

// GoogleTest finds this for its messages.
static void PrintTo(Sign sign, std::ostream* out) { *out << static_cast<int>(sign); }

}  // namespace flowcert::geometry

namespace flowcert::predicates_test {

using namespace geometry;

namespace {

using flowcert_tests::circle_center;
using flowcert_tests::circumcenter;
using flowcert_tests::determinant;
using flowcert_tests::draw_tuple;
using flowcert_tests::exactly;
using flowcert_tests::flatten;
using flowcert_tests::inner;
using flowcert_tests::kTupleKinds;
using flowcert_tests::minus;
using flowcert_tests::normal_of;
using flowcert_tests::PortableRandom;
using flowcert_tests::TupleKind;

Sign sign_of_int(int sign) { return static_cast<Sign>(sign); }

// How often each rung was the first to answer.
struct Decided {
  std::uint64_t by_double = 0, by_small = 0, by_narrow = 0, by_wide = 0, by_big = 0, zeros = 0;
  [[nodiscard]] std::uint64_t total() const { return by_double + by_fixed() + by_big; }
  // The number decided by integers of a fixed size.
  [[nodiscard]] std::uint64_t by_fixed() const { return by_small + by_narrow + by_wide; }
};

// Compares each rung that is not silent with the last one.
template <class Query>
void compare_rungs(const Query& query, Decided& decided) {
  const MaybeSign by_double = sign_on_rung(query, Rung::kDouble);
  const MaybeSign by_small = sign_on_rung(query, Rung::kSmall);
  const MaybeSign by_narrow = sign_on_rung(query, Rung::kNarrow);
  const MaybeSign by_wide = sign_on_rung(query, Rung::kWide);
  const MaybeSign by_big = sign_on_rung(query, Rung::kBig);
  ASSERT_TRUE(by_big.has_value());
  if (by_small) {
    ASSERT_EQ(*by_small, *by_big);
    ASSERT_TRUE(by_narrow.has_value());
  }
  if (by_narrow) {
    ASSERT_EQ(*by_narrow, *by_big);
    ASSERT_TRUE(by_wide.has_value());
  }
  if (by_wide) {
    ASSERT_EQ(*by_wide, *by_big);
  }
  if (by_double) {
    ASSERT_EQ(*by_double, *by_big);
    ASSERT_NE(*by_double, Sign::kZero) << "a filter with an error bound cannot know a zero";
  }
  ASSERT_EQ(unfiltered_sign(query), *by_big);
  FilterTally tally;
  ASSERT_EQ(exact_sign(query, tally), *by_big);
  FilterTally expected;
  expected[Query::kPredicate] = {1, by_double ? 0u : 1u};
  ASSERT_EQ(tally.counts, expected.counts);
  decided.zeros += *by_big == Sign::kZero ? 1 : 0;
  ++(by_double   ? decided.by_double
     : by_small  ? decided.by_small
     : by_narrow ? decided.by_narrow
     : by_wide   ? decided.by_wide
                 : decided.by_big);
}

// What is asked of each predicate: a query made of a tuple, and its answer by definition. OutsideCircle takes
// coplanar points only, see flatten().
struct AskAngle {
  using Tuple = std::array<Point, 3>;
  static constexpr const char* kName = "Angle";
  static Angle query(const Tuple& t) { return {t[0], t[1], t[2]}; }
  static bool prepare(Tuple&, PortableRandom&) { return true; }
  static Sign by_definition(const Tuple& t) {
    const RationalPoint p = exactly(t[0]), q = exactly(t[1]), r = exactly(t[2]);
    return sign_of(inner(minus(p, q), minus(r, q)));
  }
};

struct AskOrientation {
  using Tuple = std::array<Point, 4>;
  static constexpr const char* kName = "Orientation";
  static Orientation query(const Tuple& t) { return {t[0], t[1], t[2], t[3]}; }
  static bool prepare(Tuple&, PortableRandom&) { return true; }
  static Sign by_definition(const Tuple& t) {
    const RationalPoint p0 = exactly(t[0]);
    return sign_of(determinant(minus(exactly(t[1]), p0), minus(exactly(t[2]), p0), minus(exactly(t[3]), p0)));
  }
};

bool is_flat(const Point& p0, const Point& p1, const Point& p2, const Point& p3) {
  return unfiltered_sign(Orientation{p0, p1, p2, p3}) == Sign::kZero;
}

struct AskSideOfPlane {
  using Tuple = std::array<Point, 4>;
  static constexpr const char* kName = "SideOfPlane";
  static SideOfPlane query(const Tuple& t) { return {t[0], t[1], t[2], t[3]}; }
  static bool prepare(Tuple& t, PortableRandom&) { return !is_flat(t[0], t[1], t[2], t[3]); }
  static Sign by_definition(const Tuple& t) {
    const RationalPoint f0 = exactly(t[0]), f1 = exactly(t[1]), f2 = exactly(t[2]), apex = exactly(t[3]);
    const RationalPoint center = circumcenter(f0, f1, f2, apex);
    const RationalPoint normal = normal_of(f0, f1, f2);
    const int of_apex = flowcert_tests::sign_of(inner(normal, minus(apex, f0)));
    const int of_center = flowcert_tests::sign_of(inner(normal, minus(center, f0)));
    return sign_of_int(of_apex * of_center);
  }
};

struct AskOutsideSphere {
  using Tuple = std::array<Point, 5>;
  static constexpr const char* kName = "OutsideSphere";
  static OutsideSphere query(const Tuple& t) { return {t[0], t[1], t[2], t[3], t[4]}; }
  static bool prepare(Tuple& t, PortableRandom&) { return !is_flat(t[0], t[1], t[2], t[3]); }
  static Sign by_definition(const Tuple& t) {
    const RationalPoint p0 = exactly(t[0]), p1 = exactly(t[1]), p2 = exactly(t[2]), p3 = exactly(t[3]);
    const RationalPoint center = circumcenter(p0, p1, p2, p3);
    const Rational outside =
        flowcert_tests::squared_distance(exactly(t[4]), center) - flowcert_tests::squared_distance(p0, center);
    const int orientation = flowcert_tests::sign_of(determinant(minus(p1, p0), minus(p2, p0), minus(p3, p0)));
    return sign_of_int(flowcert_tests::sign_of(outside) * orientation);
  }
};

// Whether q and r lie strictly on different sides of p0p1, in their common plane.
bool are_opposite(const Point& p0, const Point& p1, const Point& q, const Point& r) {
  const RationalPoint u = exactly(p0), v = exactly(p1);
  return inner(normal_of(u, v, exactly(q)), normal_of(u, v, exactly(r))) < 0;
}

struct AskOutsideCircle {
  using Tuple = std::array<Point, 4>;
  static constexpr const char* kName = "OutsideCircle";
  static OutsideCircle query(const Tuple& t) { return {t[0], t[1], t[2], t[3]}; }
  static bool prepare(Tuple& t, PortableRandom& random) {
    flatten(t, random);
    for (std::size_t k = 1; k < 4; ++k) {
      Tuple paired{t[0], t[k], t[k % 3 + 1], t[(k + 1) % 3 + 1]};
      if (!are_opposite(paired[0], paired[1], paired[2], paired[3])) continue;
      t = paired;
      return true;
    }
    return false;
  }
  static Sign by_definition(const Tuple& t) {
    const RationalPoint p0 = exactly(t[0]);
    const RationalPoint center = circle_center(p0, exactly(t[1]), exactly(t[2]));
    return sign_of(Rational(flowcert_tests::squared_distance(exactly(t[3]), center) -
                            flowcert_tests::squared_distance(p0, center)));
  }
};

template <class Ask>
typename Ask::Tuple draw_prepared(TupleKind kind, PortableRandom& random) {
  constexpr std::size_t kCount = std::tuple_size_v<typename Ask::Tuple>;
  for (;;) {
    typename Ask::Tuple tuple = draw_tuple<kCount>(kind, random);
    if (Ask::prepare(tuple, random)) return tuple;
  }
}

template <class Ask>
class PredicateTest : public testing::Test {};
using AllPredicates = testing::Types<AskAngle, AskOrientation, AskSideOfPlane, AskOutsideSphere, AskOutsideCircle>;
class PredicateNames {
 public:
  template <class Ask>
  static std::string GetName(int) {
    return Ask::kName;
  }
};
TYPED_TEST_SUITE(PredicateTest, AllPredicates, PredicateNames);

// 5 predicates, 11 kinds, 3,000 queries each, and at least 3 comparisons a query: 495,000 and more.
TYPED_TEST(PredicateTest, NoRungContradictsTheNext) {
  CITES("FC-NUM-01");
  constexpr std::uint64_t kQueries = 3000;
  PortableRandom random(20080101);
  std::map<TupleKind, Decided> seen;
  for (const TupleKind kind : kTupleKinds) {
    for (std::uint64_t k = 0; k < kQueries; ++k) {
      const auto tuple = draw_prepared<TypeParam>(kind, random);
      compare_rungs(TypeParam::query(tuple), seen[kind]);
      if (this->HasFatalFailure()) return;
    }
    ASSERT_EQ(seen[kind].total(), kQueries);
  }
  // The kinds are what they are meant to be.
  EXPECT_EQ(seen[TupleKind::kGeneric].zeros, 0u);
  EXPECT_GT(seen[TupleKind::kLattice].zeros, 30u);
  EXPECT_GT(seen[TupleKind::kSpherical].zeros, 30u);
  EXPECT_GT(seen[TupleKind::kRounded].by_fixed(), seen[TupleKind::kRounded].zeros);
  EXPECT_GT(seen[TupleKind::kOneUlp].by_fixed(), 100u);
  EXPECT_GT(seen[TupleKind::kFarOff].zeros, 30u);
  EXPECT_GT(seen[TupleKind::kMagnitudes].by_big, kQueries / 2);
  EXPECT_EQ(seen[TupleKind::kSubnormal].by_fixed(), kQueries) << "such norms are outside the filter's range";
  EXPECT_GT(seen[TupleKind::kSubnormal].zeros, 30u);
}

TYPED_TEST(PredicateTest, TheFilterDecidesGenericInput) {
  CITES("FC-NUM-01");
  constexpr std::uint64_t kQueries = 20000;
  PortableRandom random(7);
  std::uint64_t decided = 0;
  for (std::uint64_t k = 0; k < kQueries; ++k) {
    const auto tuple = draw_prepared<TypeParam>(TupleKind::kGeneric, random);
    const MaybeSign by_double = sign_on_rung(TypeParam::query(tuple), Rung::kDouble);
    if (!by_double) continue;
    ++decided;
    ASSERT_EQ(*by_double, *sign_on_rung(TypeParam::query(tuple), Rung::kWide));
  }
  EXPECT_GT(decided * 1000, kQueries * 999);
}

TYPED_TEST(PredicateTest, TheLastRungIsTheDefinition) {
  CITES("FC-SIGN-01", "FC-SIGN-03", "FC-NUM-01");
  PortableRandom random(42);
  std::map<Sign, int> seen;
  for (const TupleKind kind : kTupleKinds) {
    for (int k = 0; k < 400; ++k) {
      const auto tuple = draw_prepared<TypeParam>(kind, random);
      const Sign expected = TypeParam::by_definition(tuple);
      ASSERT_EQ(*sign_on_rung(TypeParam::query(tuple), Rung::kBig), expected);
      ++seen[expected];
    }
  }
  for (const Sign sign : {Sign::kNegative, Sign::kZero, Sign::kPositive}) EXPECT_GT(seen[sign], 50);
}

// The rung gives the sign that GMP gives if the points span exactly so many bits. With one bit more it is
// silent.
template <class Ask>
void expect_end(TupleKind kind, Rung rung, int bits) {
  PortableRandom random(82);
  int inside = 0, beyond = 0;
  for (int k = 0; k < 4000; ++k) {
    const auto tuple = draw_prepared<Ask>(kind, random);
    double largest = 0;
    double smallest = HUGE_VAL;
    for (Point p : tuple) {
      for (std::size_t c = 0; c < 3; ++c) {
        const double value = std::fabs(flowcert_tests::coordinate_of(p, c));
        largest = std::max(largest, value);
        smallest = std::min(smallest, value);
      }
    }
    if (smallest != 1) continue;  // flatten() may have dropped the 1
    const MaybeSign sign = sign_on_rung(Ask::query(tuple), rung);
    const bool fits = largest < std::ldexp(1.0, bits);
    ASSERT_EQ(sign.has_value(), fits);
    if (fits) {
      ASSERT_EQ(*sign, *sign_on_rung(Ask::query(tuple), Rung::kBig));
    }
    ++(fits ? inside : beyond);
  }
  EXPECT_GT(inside, 300);
  EXPECT_GT(beyond, 300);
}

TYPED_TEST(PredicateTest, TheFixedSizeIntegersEndWhereTheySay) {
  CITES("FC-NUM-01");
  expect_end<TypeParam>(TupleKind::kSmall, Rung::kSmall, kSmallBits);
  expect_end<TypeParam>(TupleKind::kNarrow, Rung::kNarrow, kNarrowBits);
  expect_end<TypeParam>(TupleKind::kWidest, Rung::kWide, kWideBits);
}

constexpr Point kOrigin{0, 0, 0};

// What three rungs say of a query made by hand.
struct Answers {
  MaybeSign by_double, by_wide, by_big;
};
template <class Query>
Answers answers(const Query& query) {
  return {sign_on_rung(query, Rung::kDouble), sign_on_rung(query, Rung::kWide), sign_on_rung(query, Rung::kBig)};
}

TEST(RungsTest, ClearSignsAreTheFiltersOwn) {
  CITES("FC-NUM-01", "FC-SIGN-01", "FC-SIGN-03");
  const Point x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1}, far{3, 3, 3}, near{0.5, 0.5, 0.25};
  EXPECT_EQ(answers(Angle{x, y, z}).by_double, Sign::kPositive);
  EXPECT_EQ(answers(Angle{x, Point{0.25, 0.25, 0}, y}).by_double, Sign::kNegative);
  EXPECT_EQ(answers(Orientation{kOrigin, x, y, z}).by_double, Sign::kPositive);
  EXPECT_EQ(answers(Orientation{kOrigin, y, x, z}).by_double, Sign::kNegative);
  // Only the slanted facet has the centre (1/2, 1/2, 1/2) and its opposite vertex on different sides.
  EXPECT_EQ(answers(SideOfPlane{x, y, z, kOrigin}).by_double, Sign::kNegative);
  EXPECT_EQ(answers(SideOfPlane{kOrigin, x, y, z}).by_double, Sign::kPositive);
  EXPECT_EQ(answers(OutsideSphere{kOrigin, x, y, z, far}).by_double, Sign::kPositive);
  EXPECT_EQ(answers(OutsideSphere{kOrigin, x, y, z, near}).by_double, Sign::kNegative);
  EXPECT_EQ(answers(OutsideSphere{kOrigin, y, x, z, far}).by_double, Sign::kNegative);
  EXPECT_EQ(answers(OutsideCircle{x, y, kOrigin, Point{2, 2, 0}}).by_double, Sign::kPositive);
  EXPECT_EQ(answers(OutsideCircle{x, y, kOrigin, Point{0.75, 0.75, 0}}).by_double, Sign::kNegative);
}

// The filter still answers not far above its bound: an angle is open only below about 2^-50.
TEST(RungsTest, TheFilterIsSharp) {
  CITES("FC-NUM-01");
  const Point x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  for (const double sign : {-1.0, 1.0}) {
    const MaybeSign expected = sign > 0 ? Sign::kPositive : Sign::kNegative;
    EXPECT_EQ(answers(Angle{x, kOrigin, Point{sign * 0x1p-49, 1, 0}}).by_double, expected);
    EXPECT_EQ(answers(Orientation{kOrigin, x, y, Point{1, 1, sign * 0x1p-47}}).by_double, expected);
    EXPECT_EQ(answers(SideOfPlane{x, Point{-1, 0, 0}, y, Point{0, 0, 1 + sign * 0x1p-44}}).by_double, expected);
    EXPECT_EQ(answers(OutsideSphere{kOrigin, x, y, z, Point{1, 1, 1 + sign * 0x1p-44}}).by_double, expected);
    EXPECT_EQ(answers(OutsideCircle{x, y, kOrigin, Point{1, 1 + sign * 0x1p-46, 0}}).by_double, expected);
  }
}

TEST(RungsTest, TiesAreLeftToTheIntegers) {
  CITES("FC-NUM-01");
  const Point x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1}, xyz{1, 1, 1}, xy{1, 1, 0};
  const auto expect_tie = [](const auto& query) {
    const Answers a = answers(query);
    EXPECT_EQ(a.by_double, std::nullopt);
    EXPECT_EQ(a.by_wide, Sign::kZero);
    EXPECT_EQ(a.by_big, Sign::kZero);
  };
  expect_tie(Angle{x, kOrigin, y});
  expect_tie(Orientation{kOrigin, x, y, xy});
  // The facet has a right angle, and its hypotenuse is a diameter of the sphere.
  expect_tie(SideOfPlane{x, Point{-1, 0, 0}, y, z});
  expect_tie(OutsideSphere{kOrigin, x, y, z, xyz});
  expect_tie(OutsideCircle{x, y, kOrigin, xy});
}

TEST(RungsTest, NearTiesAreLeftToTheFixedSizeIntegers) {
  CITES("FC-NUM-01");
  const Point x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  const double up = std::nextafter(1.0, 2.0), down = std::nextafter(1.0, 0.0);
  const auto expect_wide = [](const auto& query, Sign sign) {
    const Answers a = answers(query);
    EXPECT_EQ(a.by_double, std::nullopt);
    EXPECT_EQ(a.by_wide, sign);
    EXPECT_EQ(a.by_big, sign);
  };
  expect_wide(Angle{x, kOrigin, Point{0x1p-60, 1, 0}}, Sign::kPositive);
  expect_wide(Angle{x, kOrigin, Point{-0x1p-60, 1, 0}}, Sign::kNegative);
  expect_wide(Orientation{kOrigin, x, y, Point{1, 1, 0x1p-60}}, Sign::kPositive);
  expect_wide(Orientation{kOrigin, x, y, Point{1, 1, -0x1p-60}}, Sign::kNegative);
  expect_wide(SideOfPlane{Point{up, 0, 0}, Point{-1, 0, 0}, y, z},
              AskSideOfPlane::by_definition({Point{up, 0, 0}, Point{-1, 0, 0}, y, z}));
  expect_wide(OutsideSphere{kOrigin, x, y, z, Point{1, 1, up}}, Sign::kPositive);
  expect_wide(OutsideSphere{kOrigin, x, y, z, Point{1, 1, down}}, Sign::kNegative);
  expect_wide(OutsideCircle{x, y, kOrigin, Point{1, up, 0}}, Sign::kPositive);
  expect_wide(OutsideCircle{x, y, kOrigin, Point{1, down, 0}}, Sign::kNegative);
}

TEST(RungsTest, MixedMagnitudesAreLeftToGmp) {
  CITES("FC-NUM-01", "FC-IN-04");
  const Point x{1e300, 0, 0}, y{0, 1e300, 0}, z{0, 0, 1e300};
  const auto expect_big = [](const auto& query, Sign sign) {
    const Answers a = answers(query);
    EXPECT_EQ(a.by_double, std::nullopt);
    EXPECT_EQ(a.by_wide, std::nullopt);
    EXPECT_EQ(a.by_big, sign);
  };
  expect_big(Angle{x, kOrigin, Point{1e-300, 1e300, 0}}, Sign::kPositive);
  expect_big(Angle{x, kOrigin, Point{-1e-300, 1e300, 0}}, Sign::kNegative);
  expect_big(Orientation{kOrigin, x, y, Point{0, 0, -1e-300}}, Sign::kNegative);
  expect_big(SideOfPlane{kOrigin, x, y, Point{0, 0, 1e-300}}, Sign::kPositive);
  expect_big(OutsideSphere{kOrigin, x, y, z, Point{1e300, 1e300, -1e-300}}, Sign::kPositive);
  expect_big(OutsideSphere{kOrigin, x, y, z, Point{1e300, 1e300, 1e-300}}, Sign::kNegative);
  expect_big(OutsideCircle{x, y, kOrigin, Point{1e300, 1e-300, 0}}, Sign::kNegative);
}

// The filter's range, from both sides: one and the same angle, at lengths that the filter takes and at
// lengths that it refuses. Nothing that overflows on the way is taken for a sign.
TEST(RungsTest, TheFilterIsSilentOutsideOfItsRange) {
  CITES("FC-NUM-01");
  for (const double unit : {2 * kSmallestNorm, kLargestNorm / 2}) {
    EXPECT_EQ(sign_on_rung(Angle{Point{unit, 0, 0}, kOrigin, Point{unit, unit, 0}}, Rung::kDouble), Sign::kPositive);
  }
  const double largest = std::numeric_limits<double>::max();
  for (const double unit : {kSmallestNorm / 2, kLargestNorm, largest, std::numeric_limits<double>::denorm_min()}) {
    const Angle query{Point{unit, 0, 0}, kOrigin, Point{unit, unit, 0}};
    EXPECT_EQ(sign_on_rung(query, Rung::kDouble), std::nullopt) << unit;
    EXPECT_EQ(sign_on_rung(query, Rung::kWide), Sign::kPositive) << unit;
  }
  // One difference is itself beyond the largest double.
  const Point left{-largest, 0, 0}, right{largest, 0, 0};
  const Angle straight{left, Point{0, 1e308, 0}, right}, sharp{left, right, Point{0, 1e308, 0}};
  EXPECT_EQ(sign_on_rung(straight, Rung::kDouble), std::nullopt);
  EXPECT_EQ(sign_on_rung(straight, Rung::kBig), Sign::kNegative);
  EXPECT_EQ(sign_on_rung(sharp, Rung::kDouble), std::nullopt);
  EXPECT_EQ(sign_on_rung(sharp, Rung::kBig), Sign::kPositive);
}

TEST(RungsTest, TheTallyCountsEachPredicateByItself) {
  CITES("FC-NUM-01");
  const Point x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1}, xy{1, 1, 0}, far{4, 5, 6};
  FilterTally tally;
  for (int k = 0; k < 5; ++k) EXPECT_EQ(exact_sign(Angle{x, y, z}, tally), Sign::kPositive);
  for (int k = 0; k < 3; ++k) EXPECT_EQ(exact_sign(Angle{x, kOrigin, y}, tally), Sign::kZero);
  EXPECT_EQ(exact_sign(SideOfPlane{kOrigin, x, y, z}, tally), Sign::kPositive);
  EXPECT_EQ(exact_sign(OutsideSphere{kOrigin, x, y, z, far}, tally), Sign::kPositive);
  EXPECT_EQ(exact_sign(OutsideSphere{kOrigin, x, y, z, xy}, tally), Sign::kZero);
  EXPECT_EQ(exact_sign(Orientation{kOrigin, x, y, xy}, tally), Sign::kZero);
  EXPECT_EQ(exact_sign(Orientation{kOrigin, x, y, Point{0, 0, 0x1p-70}}, tally), Sign::kPositive);
  EXPECT_EQ(exact_sign(OutsideCircle{x, y, kOrigin, xy}, tally), Sign::kZero);
  EXPECT_EQ(tally[Predicate::kAngle], (FilterCount{8, 3}));
  EXPECT_EQ(tally[Predicate::kSideOfPlane], (FilterCount{1, 0}));
  EXPECT_EQ(tally[Predicate::kCospherical], (FilterCount{2, 1}));
  EXPECT_EQ(tally[Predicate::kCoplanar].calls, 2u);
  EXPECT_EQ(tally[Predicate::kCocircular], (FilterCount{1, 1}));
}

}  // namespace
}  // namespace flowcert::predicates_test
