// Pores of balls by the fast implementation against the oracle's (FC-BALL), on degenerate sets.
//
// Guarantees: all critical points with their exact values, positions, indices and contacts; chambers with peaks, gates,
// exits, windows and handles; vestibules; and cavities are compared exactly, at depths at which something changes. The
// oracle's cavities come twice: from its ends, and from the nerve of the open balls by homology. For some probes, the
// balls that line each cavity are compared, too. The test fails too when too few sets had chambers, ties, gates below 0,
// or two different values with one nearest double, or when too few balls line cavities.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>
#include <vector>

#include "flowcert/ball_cavities.h"
#include "flowcert/pores.h"
#include "oracle/ball_linings.h"
#include "oracle/pores.h"
#include "tests/cites.h"
#include "tests/property/ball_sets.h"
#include "tests/run_scale.h"

namespace flowcert::property::pore_agreement_test {
namespace {

using Ids = std::vector<std::uint32_t>;

oracle::Quadratic told(const QuadraticNumber& x) {
  const auto number = [](const Rational& value) { return oracle::Rational(flowcert::to_text(value)); };
  return {number(x.a), number(x.b), number(x.d)};
}

std::vector<oracle::Ball> told(const std::vector<Ball>& balls) {
  const auto number = [](const Rational& value) { return oracle::Rational(flowcert::to_text(value)); };
  std::vector<oracle::Ball> same;
  for (const Ball& ball : balls) {
    same.push_back({{number(ball.center[0]), number(ball.center[1]), number(ball.center[2])}, number(ball.radius)});
  }
  return same;
}

oracle::Places places(const Ids& numbers) { return {numbers.begin(), numbers.end()}; }

struct Totals {
  std::size_t points = 0, chambers = 0, windows = 0, vestibules = 0, ties = 0, below = 0, lining = 0;
  std::size_t one_double = 0;  // sets
};

void expect_same_points(const Pores& fast, const oracle::Pores& right) {
  ASSERT_EQ(fast.points().size(), right.points.size());
  for (std::uint32_t number = 0; number < right.points.size(); ++number) {
    const oracle::BallPoint& point = right.points[number];
    EXPECT_EQ(fast.points()[number].index, point.index);
    EXPECT_EQ(places(fast.points()[number].contact), point.contacts);
    EXPECT_EQ(told(fast.value(number)), point.value);
    const auto position = fast.center(number);
    for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(told(position[k]), point.position[k]);
  }
}

oracle::Places rooms_of(const oracle::Pores& right, const Ids& rooms) {
  oracle::Places same;
  for (const std::uint32_t room : rooms) {
    same.push_back(room == Pores::kOutside ? oracle::outside_room(right) : static_cast<std::size_t>(room));
  }
  return same;
}

void expect_same_rooms(const Pores& fast, const oracle::Pores& right) {
  ASSERT_EQ(fast.chambers().size(), right.chambers.size());
  for (std::size_t number = 0; number < right.chambers.size(); ++number) {
    const Chamber& mine = fast.chambers()[number];
    const oracle::Chamber& chamber = right.chambers[number];
    EXPECT_EQ(places(mine.peaks), chamber.peaks);
    EXPECT_EQ(places(mine.gates), chamber.gates);
    ASSERT_EQ(mine.exit.has_value(), chamber.exit.has_value());
    if (mine.exit) {
      EXPECT_EQ(told(fast.value(*mine.exit)), *chamber.exit);
    }
    EXPECT_EQ(places(mine.windows), chamber.windows);
    EXPECT_EQ(places(mine.handles), chamber.handles);
  }
  ASSERT_EQ(fast.windows().size(), right.windows.size());
  for (std::size_t number = 0; number < right.windows.size(); ++number) {
    EXPECT_EQ(fast.windows()[number].point, right.windows[number].point);
    EXPECT_EQ(rooms_of(right, fast.windows()[number].rooms), right.windows[number].rooms);
  }
  ASSERT_EQ(fast.vestibules().size(), right.vestibules.size());
  for (std::size_t number = 0; number < right.vestibules.size(); ++number) {
    EXPECT_EQ(places(fast.vestibules()[number]), right.vestibules[number].peaks);
  }
}

std::vector<oracle::Cavity> cavities_of(const Pores& fast) {
  std::vector<oracle::Cavity> cavities;
  for (const CavityInterval& each : fast.cavities()) {
    oracle::Cavity cavity{std::nullopt, told(fast.value(each.peak))};
    if (each.gate) cavity.gate = told(fast.value(*each.gate));
    cavities.push_back(cavity);
  }
  std::sort(cavities.begin(), cavities.end());  // the oracle has < alone
  return cavities;
}

bool has_values_of_one_double(const Pores& fast) {
  for (std::uint32_t number = 1; number < fast.points().size(); ++number) {
    const QuadraticNumber above = fast.value(number - 1), below = fast.value(number);
    if (above != below && nearest_or_infinity(above) == nearest_or_infinity(below)) return true;
  }
  return false;
}

void count(const Pores& fast, Totals& totals) {
  totals.one_double += has_values_of_one_double(fast);
  totals.points += fast.points().size();
  totals.chambers += fast.chambers().size();
  totals.windows += fast.windows().size();
  totals.vestibules += fast.vestibules().size();
  for (const Chamber& chamber : fast.chambers()) {
    totals.ties += chamber.peaks.size() > 1;
    totals.below += chamber.gates.empty();
  }
}

// The depths of all chambers: at each one more is told.
std::set<Rational> depths_of(const Pores& all) {
  std::set<Rational> depths;
  for (const Chamber& chamber : all.chambers()) {
    const QuadraticNumber gate = chamber.gates.empty() ? QuadraticNumber() : all.value(chamber.gates[0]);
    depths.insert(Rational(nearest_difference(all.value(chamber.peaks[0]), gate)));
  }
  return depths;
}

// With few binary digits. 0 <= low < high.
double between(double low, double high) {
  double scale = 1;
  while ((std::floor(low * scale) + 1) / scale >= high) scale *= 2;
  return (std::floor(low * scale) + 1) / scale;
}

// All values that are rational, and numbers between values.
std::set<oracle::Rational> probes_of(const oracle::Pores& right) {
  std::set<oracle::Rational> probes = {0};
  double above = 0;
  for (const oracle::BallPoint& point : right.points) {
    const auto& [a, b, d] = point.value;
    if (b == 0) probes.insert(a);
    const double near = a.convert_to<double>() + b.convert_to<double>() * std::sqrt(d.convert_to<double>());
    if (near >= 0 && near < above) probes.insert(oracle::Rational(between(near, above)));
    above = near;
  }
  return probes;
}

std::size_t cavities_at(const oracle::Pores& right, const oracle::Rational& probe) {
  return static_cast<std::size_t>(std::ranges::count_if(right.cavities, [&](const oracle::Cavity& each) {
    return (!each.gate || *each.gate < probe) && each.peak >= probe;
  }));
}

void expect_same_cavities(const BallSet& balls, const std::vector<oracle::Ball>& same, const oracle::Pores& right,
                          Totals& totals) {
  for (const oracle::Rational& probe : probes_of(right)) {
    SCOPED_TRACE("probe " + probe.str());
    std::vector<oracle::Places> mine;
    for (const BallCavity& cavity : ball_cavities(balls, Rational(probe.str()))) mine.push_back(places(cavity.lining));
    ASSERT_EQ(mine.size(), cavities_at(right, probe));
    if (mine.empty()) continue;
    EXPECT_EQ(mine, oracle::cavity_linings(same, right, probe));
    for (const oracle::Places& each : mine) totals.lining += each.size();
  }
}

TEST(PoreAgreement, FastIsTheOracleOnDegenerateBalls) {
  CITES("FC-BALL-02", "FC-BALL-03", "FC-BALL-05", "FC-BALL-07", "FC-BALL-09");
  const auto sets = static_cast<std::uint64_t>(
      flowcert_tests::is_whole_run() ? 2000 : std::max(20.0, 200 * flowcert_tests::scale_of_run()));
  Totals totals;
  for (std::uint64_t number = 0; number < sets; ++number) {
    const DegenerateBalls drawn = degenerate_balls(number);
    SCOPED_TRACE("set " + std::to_string(number) + ", " + drawn.family);
    const BallSet balls(drawn.balls);
    const std::vector<oracle::Ball> same = told(drawn.balls);
    const Pores all(balls, 0);
    const oracle::Pores right = oracle::pores(same, 0);
    expect_same_points(all, right);
    expect_same_rooms(all, right);
    EXPECT_EQ(cavities_of(all), right.cavities);
    EXPECT_EQ(cavities_of(all), oracle::cavities_by_homology(same));
    count(all, totals);
    expect_same_cavities(balls, same, right, totals);
    const std::set<Rational> depths = depths_of(all);
    if (depths.empty()) continue;
    const Rational depth = *std::next(depths.begin(), static_cast<std::ptrdiff_t>(number % depths.size()));
    expect_same_rooms(Pores(balls, depth), oracle::pores(same, oracle::Rational(flowcert::to_text(depth))));
  }
  std::printf(
      "%llu sets: %zu points, %zu chambers, %zu windows, %zu vestibules, %zu unions of ties, %zu gates < 0, "
      "%zu with values of one double, %zu balls line cavities\n",
      static_cast<unsigned long long>(sets), totals.points, totals.chambers, totals.windows, totals.vestibules,
      totals.ties, totals.below, totals.one_double, totals.lining);
  EXPECT_GE(totals.chambers, sets / 4);
  EXPECT_GE(totals.ties, sets / 50);
  EXPECT_GE(totals.below, sets / 50);
  EXPECT_GE(totals.one_double, sets / 20);
  EXPECT_GE(totals.lining, sets);
}

}  // namespace
}  // namespace flowcert::property::pore_agreement_test
