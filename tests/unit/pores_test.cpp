// Balls, chambers between them, and what probes find: small sets whose answers are known.
#include "flowcert/pores.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <stdexcept>

#include "flowcert/ball_cavities.h"
#include "flowcert/flow_complex.h"
#include "tests/cites.h"

namespace flowcert::pores_test {
namespace {

using Ids = std::vector<std::uint32_t>;
using Text = std::vector<std::string>;

Ball ball(Rational x, Rational y, Rational z, Rational r) { return {{x, y, z}, r}; }

// (±x, ±y, ±z), each once.
std::vector<Ball> box(Rational x, Rational y, Rational z, Rational r) {
  std::vector<Ball> balls;
  const auto signs = [](const Rational& c) { return c == 0 ? std::vector<int>{1} : std::vector<int>{-1, 1}; };
  for (const int i : signs(x)) {
    for (const int j : signs(y)) {
      for (const int k : signs(z)) balls.push_back(ball(i * x, j * y, k * z, r));
    }
  }
  return balls;
}

std::vector<Ball> operator+(std::vector<Ball> some, const std::vector<Ball>& others) {
  some.insert(some.end(), others.begin(), others.end());
  return some;
}

std::vector<Ball> cage() { return {ball(2, 2, 2, 1), ball(2, -2, -2, 1), ball(-2, 2, -2, 1), ball(-2, -2, 2, 1)}; }

std::vector<Ids> contacts_of_index(const Pores& pores, int index) {
  std::vector<Ids> found;
  for (const BallPoint& point : pores.points()) {
    if (point.index == index) found.push_back(point.contact);
  }
  return found;
}

TEST(BallSet, HidesWhatIsInside) {
  CITES("FC-BALL-02");
  // Inside, tangent inside, equal, apart, and one inside of a hidden one.
  const BallSet balls({ball(0, 0, 0, 3), ball(1, 0, 0, 1), ball(0, 1, 0, 2), ball(6, 0, 0, 1), ball(6, 0, 0, 1),
                       ball(0, Rational(5, 2), 0, Rational(1, 2))});
  EXPECT_EQ(balls.visible(), (Ids{0, 3}));
  EXPECT_EQ(Ids(balls.tangent_inside(0).begin(), balls.tangent_inside(0).end()), (Ids{2, 5}));
  EXPECT_EQ(Ids(balls.tangent_inside(3).begin(), balls.tangent_inside(3).end()), (Ids{4}));
  EXPECT_THROW(BallSet({ball(0, 0, 0, 0)}), std::invalid_argument);
  EXPECT_THROW(BallSet({ball(0, 0, 0, -1)}), std::invalid_argument);
  EXPECT_TRUE(BallSet({}).visible().empty());
}

TEST(BallSet, TakesDecimalsExactly) {
  CITES("FC-BALL-01");
  // 1/10 is no double: two of three balls touch exactly.
  const BallSet balls({ball(Rational(1, 10), 0, 0, Rational(1, 10)), ball(Rational(3, 10), 0, 0, Rational(1, 10))});
  const Pores pores(balls, 0);
  ASSERT_EQ(pores.points().size(), 1u);
  EXPECT_EQ(pores.value(0), QuadraticNumber());
  EXPECT_EQ(pores.center(0)[0], QuadraticNumber(Rational(1, 5)));
}

TEST(Pores, OfTheCage) {
  CITES("FC-BALL-05", "FC-BALL-06", "FC-BALL-07", "FC-BALL-08");
  const BallSet balls(cage());
  const Pores pores(balls, 0);
  ASSERT_EQ(pores.chambers().size(), 1u);
  const Chamber& chamber = pores.chambers()[0];
  EXPECT_EQ(primitive_polynomial(pores.value(chamber.peaks[0])).coefficients, (Text{"1", "2", "-11"}));
  ASSERT_EQ(chamber.gates.size(), 4u);
  for (const std::uint32_t gate : chamber.gates) {
    EXPECT_EQ(primitive_polynomial(pores.value(gate)).coefficients, (Text{"3", "6", "-29"}));
    EXPECT_EQ(pores.points()[gate].contact.size(), 3u);
  }
  ASSERT_TRUE(chamber.exit);
  EXPECT_EQ(pores.value(*chamber.exit), pores.value(chamber.gates[0]));
  EXPECT_EQ(chamber.windows.size(), 4u);
  EXPECT_EQ(pores.status(chamber, Rational(22, 10)), ChamberStatus::kOpen);
  EXPECT_EQ(pores.status(chamber, Rational(24, 10)), ChamberStatus::kClosed);
  EXPECT_EQ(pores.status(chamber, Rational(25, 10)), ChamberStatus::kTooSmall);
  EXPECT_EQ(pores.cavities_at(Rational(22, 10)), 0u);
  EXPECT_EQ(pores.cavities_at(Rational(24, 10)), 1u);
  EXPECT_EQ(pores.cavities_at(Rational(25, 10)), 0u);
  ASSERT_EQ(pores.cavity_steps().size(), 2u);
  EXPECT_EQ(pores.cavity_steps()[0].count, 1u);
  EXPECT_EQ(pores.cavity_steps()[1].count, 0u);
}

TEST(Pores, FindsPointsOnLowFaces) {
  CITES("FC-BALL-03", "FC-BALL-04");
  // The octahedron's peak is inside of a diagonal.
  const BallSet octahedron(box(2, 0, 0, Rational(1, 2)) + box(0, 2, 0, Rational(1, 2)) + box(0, 0, 2, Rational(1, 2)));
  const Pores of_octahedron(octahedron, 0);
  EXPECT_EQ(contacts_of_index(of_octahedron, 3), (std::vector<Ids>{{0, 1, 2, 3, 4, 5}}));
  EXPECT_EQ(of_octahedron.value(of_octahedron.chambers().at(0).peaks[0]), QuadraticNumber(Rational(3, 2)));
  // A rectangle, with a plug on one side, and on both.
  const std::vector<Ball> rectangle = box(4, 3, 0, 1);
  const auto at_four = [](const Pores& pores) {
    std::vector<std::pair<int, Ids>> found;
    for (std::uint32_t number = 0; number < pores.points().size(); ++number) {
      const BallPoint& point = pores.points()[number];
      if (pores.value(number) == QuadraticNumber(Rational(4))) found.emplace_back(point.index, point.contact);
    }
    return found;
  };
  const BallSet open(rectangle), once(rectangle + std::vector{ball(0, 0, 6, 2)}),
      twice(rectangle + std::vector{ball(0, 0, 6, 2), ball(0, 0, -6, 2)});
  EXPECT_EQ(at_four(Pores(open, 0)), (std::vector<std::pair<int, Ids>>{{2, {0, 1, 2, 3}}}));
  EXPECT_TRUE(at_four(Pores(once, 0)).empty());
  EXPECT_EQ(at_four(Pores(twice, 0)), (std::vector<std::pair<int, Ids>>{{3, {0, 1, 2, 3, 4, 5}}}));
}

TEST(Pores, HasEveryChamberOfATie) {
  CITES("FC-BALL-05", "FC-BALL-09");
  const Rational half(1, 2), side(5, 4);
  const BallSet balls(box(2, 1, 1, half) + box(0, side, side, half));
  const Pores pores(balls, 0);
  ASSERT_EQ(pores.chambers().size(), 3u);
  std::vector<std::pair<std::string, std::size_t>> found;  // gate and peaks
  for (const Chamber& chamber : pores.chambers()) {
    EXPECT_NEAR(nearest_or_infinity(pores.value(chamber.peaks[0])), 1.4083, 5e-5);
    EXPECT_NEAR(nearest_or_infinity(pores.value(chamber.exit.value())), 1.0220, 5e-5);
    found.emplace_back(std::to_string(nearest_or_infinity(pores.value(chamber.gates[0]))).substr(0, 4),
                       chamber.peaks.size());
  }
  std::ranges::sort(found);
  EXPECT_EQ(found, (std::vector<std::pair<std::string, std::size_t>>{{"1.02", 2}, {"1.26", 1}, {"1.26", 1}}));
  // One of the two highest is left out.
  EXPECT_EQ(pores.cavities().size(), 2u);
}

// Two chambers of one peak, and a low room between them and the outside.
TEST(Pores, MakesAVestibuleOfWhatIsBetween) {
  CITES("FC-BALL-09");
  const Rational half(1, 2), side(11, 8);
  const BallSet balls(box(4, 1, 1, half) + box(1, side, side, half));
  const Pores pores(balls, Rational(3, 10)), deeper(balls, Rational(345, 1000));
  ASSERT_EQ(pores.chambers().size(), 3u);
  ASSERT_EQ(pores.vestibules().size(), 1u);
  ASSERT_EQ(deeper.chambers().size(), 1u);
  EXPECT_TRUE(deeper.vestibules().empty());
  const auto both =
      std::ranges::max_element(pores.chambers(), {}, [](const Chamber& each) { return each.peaks.size(); });
  EXPECT_EQ(both->windows.size(), 14u);
  EXPECT_EQ(deeper.chambers()[0].windows.size(), 14u);
}

TEST(Pores, IsTheSameInAnyOrder) {
  CITES("FC-BALL-04", "FC-BALL-09");
  const Rational half(1, 2), side(5, 4);
  const std::vector<Ball> balls =
      box(2, 1, 1, half) + box(0, side, side, half) + std::vector{ball(5, 0, 0, 1), ball(0, 0, 4, 2)};
  const BallSet first(balls);
  const Pores expected(first, 0);
  std::mt19937 random(1);
  for (int round = 0; round < 5; ++round) {
    Ids order(balls.size());
    for (std::uint32_t k = 0; k < order.size(); ++k) order[k] = k;
    std::ranges::shuffle(order, random);
    std::vector<Ball> moved;
    for (const std::uint32_t id : order) moved.push_back(balls[id]);
    const BallSet second(moved);
    const Pores pores(second, 0);
    ASSERT_EQ(pores.points().size(), expected.points().size());
    for (std::uint32_t number = 0; number < pores.points().size(); ++number) {
      EXPECT_EQ(pores.value(number), expected.value(number));
    }
    std::vector<std::pair<std::size_t, std::size_t>> mine, theirs;
    for (const Chamber& each : pores.chambers()) mine.emplace_back(each.windows.size(), each.handles.size());
    for (const Chamber& each : expected.chambers()) theirs.emplace_back(each.windows.size(), each.handles.size());
    std::ranges::sort(mine);
    std::ranges::sort(theirs);
    EXPECT_EQ(mine, theirs);
  }
}

std::vector<Ball> cloud(std::size_t count, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<Ball> balls;
  for (std::size_t k = 0; k < count; ++k) {
    const auto number = [&](int range) { return Rational(static_cast<int>(random() % static_cast<unsigned>(range))); };
    const Rational x = number(7), y = number(7), z = number(7);
    balls.push_back(ball(x, y, z, (number(4) + 1) / 4));
  }
  return balls;
}

// One triangulation for each probe: at every critical value, and between each two of them.
TEST(BallCavities, AreAsManyAsTheIntervalsSay) {
  CITES("FC-BALL-07");
  for (unsigned seed = 0; seed < 4; ++seed) {
    const BallSet balls(cloud(24, seed));
    const Pores pores(balls, 0);
    std::vector<Rational> probes = {0};
    for (std::uint32_t number = 0; number < pores.points().size(); ++number) {
      const QuadraticNumber value = pores.value(number);
      if (value.is_rational()) probes.push_back(value.a);
      probes.push_back(Rational(nearest_or_infinity(value)));
    }
    for (const Rational& probe : probes) EXPECT_EQ(ball_cavities(balls, probe).size(), pores.cavities_at(probe));
  }
}

std::vector<Ids> linings(const std::vector<Ball>& balls, const Rational& probe) {
  std::vector<Ids> found;
  for (const BallCavity& cavity : ball_cavities(BallSet(balls), probe)) found.push_back(cavity.lining);
  return found;
}

// Six balls whose centres are 8 from the middle, and that leave a room there for a probe of radius 1/4.
std::vector<Ball> shell() {
  const Rational r(27, 4);
  return box(8, 0, 0, r) + box(0, 8, 0, r) + box(0, 0, 8, r);
}

TEST(BallCavities, AreLinedByAllThatTouchThem) {
  CITES("FC-BALL-07");
  const Rational half(1, 2), quarter(1, 4);
  const std::vector<Ball> octahedron = box(2, 0, 0, half) + box(0, 2, 0, half) + box(0, 0, 2, half);
  const std::vector<Ids> six = {{0, 1, 2, 3, 4, 5}};
  EXPECT_EQ(linings(octahedron, Rational(6, 5)), six);
  EXPECT_EQ(linings(octahedron, Rational(3, 2)), six);  // a place alone
  EXPECT_TRUE(linings(octahedron, Rational(1501, 1000)).empty());
  EXPECT_EQ(linings(box(1, 1, 1, half), 1), (std::vector<Ids>{{0, 1, 2, 3, 4, 5, 6, 7}}));
  // A ball in the middle of the room, one that fills the room, and one outside of it.
  const std::vector<Ids> seven = {{0, 1, 2, 3, 4, 5, 6}};
  EXPECT_EQ(linings(shell() + std::vector{ball(0, 0, 0, Rational(1, 8))}, quarter), seven);
  EXPECT_TRUE(linings(shell() + std::vector{ball(0, 0, 0, 2)}, quarter).empty());
  EXPECT_EQ(linings(shell() + std::vector{ball(0, 0, 30, 2)}, quarter), six);
}

// The third ball is between the first two, in whose union it is, and touches the room above them at (0,4,0) or not. It
// is the nearest ball in a part of the room in both cases.
TEST(BallCavities, AreNotLinedByWhatOthersCover) {
  CITES("FC-BALL-07");
  const auto crease = [](const Rational& radius) {
    return linings({ball(3, 0, 0, 5), ball(-3, 0, 0, 5), ball(0, 3, 0, radius), ball(0, 13, 0, 5), ball(7, 7, 0, 6),
                    ball(-7, 7, 0, 6), ball(0, 7, 7, 6), ball(0, 7, -7, 6)},
                   0);
  };
  EXPECT_EQ(crease(1), (std::vector<Ids>{{0, 1, 2, 3, 4, 5, 6, 7}}));
  EXPECT_EQ(crease(Rational(999, 1000)), (std::vector<Ids>{{0, 1, 3, 4, 5, 6, 7}}));
}

TEST(BallCavities, AreLinedByWhatIsTangentInside) {
  CITES("FC-BALL-02", "FC-BALL-07");
  const Rational quarter(1, 4), inner(27, 8), x = 8 - inner;
  // It touches the first ball at the side of the room; the next ones do so elsewhere, or do not touch it.
  std::vector<Ball> balls = shell() + std::vector{ball(-x, 0, 0, inner), ball(-8 - inner, 0, 0, inner),
                                                  ball(-8, inner, 0, inner), ball(-8, 0, 0, inner)};
  EXPECT_EQ(linings(balls, quarter), (std::vector<Ids>{{0, 1, 2, 3, 4, 5, 6}}));
  // Equal ones line what their twins do.
  balls.push_back(balls[6]);
  balls.push_back(balls[1]);
  balls.push_back(balls[7]);
  EXPECT_EQ(linings(balls, quarter), (std::vector<Ids>{{0, 1, 2, 3, 4, 5, 6, 10, 11}}));
}

// Grown by 1, the middle one of three balls has the plane between the others for its cell.
TEST(BallCavities, AreLinedByABallWhoseCellIsFlat) {
  CITES("FC-BALL-07");
  std::vector<Ball> balls = box(3, 0, 6, 4);
  balls.erase(balls.begin() + 2);  // (3,0,-6)
  balls.erase(balls.begin());      // (-3,0,-6)
  const std::vector<Ball> others = box(6, 0, 0, 4) + box(0, 6, 0, 4) + std::vector{ball(0, 0, -6, 4)};
  EXPECT_EQ(linings(balls + others + std::vector{ball(0, 0, 6, 3)}, 1), (std::vector<Ids>{{0, 1, 2, 3, 4, 5, 6, 7}}));
  EXPECT_EQ(linings(std::vector{ball(0, 0, 6, 3)} + balls + others, 1), (std::vector<Ids>{{0, 1, 2, 3, 4, 5, 6, 7}}));
}

// Peaks and gates are those of the merge tree of the centres, less the radius.
TEST(Pores, OfEqualRadiiAreThoseOfTheFlowComplex) {
  CITES("FC-BALL-10");
  const Rational radius(1, 2);
  for (unsigned seed = 0; seed < 10; ++seed) {
    std::vector<Ball> balls = cloud(30, 100 + seed);
    std::vector<Point> rows;
    for (Ball& each : balls) {
      each.radius = radius;
      rows.push_back({each.center[0].convert_to<double>(), each.center[1].convert_to<double>(),
                      each.center[2].convert_to<double>()});
    }
    const BallSet set(balls);
    const Pores pores(set, 0);
    std::map<std::pair<std::string, std::string>, int> mine, theirs;
    for (const CavityInterval& each : pores.cavities()) {
      const auto text = [&](std::uint32_t point) {
        const QuadraticNumber distance = pores.value(point) + QuadraticNumber(radius);
        return to_text((distance * distance).a);
      };
      ++mine[{each.gate ? text(*each.gate) : "", text(each.peak)}];
    }
    const FlowComplex complex(rows);
    const Persistence& persistence = complex.persistence();
    for (const PersistencePair& pair : persistence.pairs()) {
      if (pair.dimension != 2) continue;
      const Rational gate = persistence.squared_value(pair.birth), peak = persistence.squared_value(pair.death.value());
      if (peak < radius * radius || gate == peak) continue;
      ++theirs[{gate < radius * radius ? "" : to_text(gate), to_text(peak)}];
    }
    EXPECT_EQ(mine, theirs);
  }
}

TEST(Pores, OfFewBalls) {
  CITES("FC-BALL-01", "FC-BALL-03");
  const BallSet none({}), one({ball(0, 0, 0, 1)}), two({ball(-2, 0, 0, 1), ball(2, 0, 0, 1)});
  EXPECT_TRUE(Pores(none, 0).points().empty());
  EXPECT_TRUE(Pores(one, 0).points().empty());
  const Pores pores(two, 0);
  ASSERT_EQ(pores.points().size(), 1u);
  EXPECT_EQ(pores.points()[0].index, 1);
  EXPECT_EQ(pores.value(0), QuadraticNumber(Rational(1)));
  EXPECT_TRUE(pores.chambers().empty());
  EXPECT_TRUE(ball_cavities(two, 0).empty());
  EXPECT_THROW(Pores(two, -1), std::invalid_argument);
}

}  // namespace
}  // namespace flowcert::pores_test
