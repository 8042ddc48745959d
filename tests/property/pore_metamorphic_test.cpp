// Pores of balls that are moved, scaled and given in another order (FC-BALL).
//
// Guarantees: sets are degenerate, and moved by fractions that no double is. All that is said of them is the same,
// exactly: critical points, ranks of values, chambers, windows, vestibules and cavities, each named by its balls.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "flowcert/pores.h"
#include "tests/cites.h"
#include "tests/property/ball_sets.h"
#include "tests/run_scale.h"

namespace flowcert::property::pore_metamorphic_test {
namespace {

using Ids = std::vector<std::uint32_t>;
using Texts = std::multiset<std::string>;

struct Move {
  Ids ids;  // those of the balls before, by place after
  Rational scale;
  std::array<Rational, 3> offset;
};

std::vector<Ball> moved(const std::vector<Ball>& balls, const Move& move) {
  std::vector<Ball> after;
  for (const std::uint32_t id : move.ids) {
    Ball& ball = after.emplace_back(balls[id]);
    for (std::size_t k = 0; k < 3; ++k) ball.center[k] = ball.center[k] * move.scale + move.offset[k];
    ball.radius *= move.scale;
  }
  return after;
}

std::string text(const QuadraticNumber& number) {
  const PrimitivePolynomial name = primitive_polynomial(number);
  return fmt::format("{}, {}", name.coefficients, name.root);
}

// What is said of moved balls, as if they were not moved.
class Statements {
 public:
  Statements(const Pores& pores, const Move& move) : pores_(pores), move_(move) {}

  [[nodiscard]] Texts all() const {
    Texts texts;
    for (std::uint32_t point = 0; point < pores_.points().size(); ++point) texts.insert(of_point(point));
    for (const Chamber& chamber : pores_.chambers()) {
      Ids windows;
      for (const std::uint32_t place : chamber.windows) windows.push_back(pores_.windows()[place].point);
      texts.insert(fmt::format("chamber {} {} {} {} {}", names(chamber.peaks), names(chamber.gates),
                               chamber.exit ? rank(*chamber.exit) : "< 0", names(windows), names(chamber.handles)));
    }
    for (const Ids& peaks : pores_.vestibules()) texts.insert(fmt::format("vestibule {}", names(peaks)));
    for (const PoreWindow& window : pores_.windows()) {
      Texts rooms;
      for (const std::uint32_t room : window.rooms) rooms.insert(name_of_room(room));
      texts.insert(fmt::format("window {} {}", name(window.point), rooms));
    }
    for (const CavityInterval& cavity : pores_.cavities()) {
      texts.insert(fmt::format("cavity {} {}", cavity.gate ? rank(*cavity.gate) : "< 0", rank(cavity.peak)));
    }
    return texts;
  }

 private:
  [[nodiscard]] std::string rank(std::uint32_t point) const { return std::to_string(pores_.points()[point].rank); }

  [[nodiscard]] std::string name(std::uint32_t point) const {
    std::set<std::uint32_t> before;
    for (const std::uint32_t id : pores_.points()[point].contact) before.insert(move_.ids[id]);
    return fmt::format("{}", before);
  }

  [[nodiscard]] Texts names(const Ids& points) const {
    Texts texts;
    for (const std::uint32_t point : points) texts.insert(name(point));
    return texts;
  }

  [[nodiscard]] std::string name_of_room(std::uint32_t room) const {
    if (room == Pores::kOutside) return "outside";
    const std::size_t chambers = pores_.chambers().size();
    return fmt::format("{}",
                       names(room < chambers ? pores_.chambers()[room].peaks : pores_.vestibules()[room - chambers]));
  }

  [[nodiscard]] std::string of_point(std::uint32_t point) const {
    const Rational back = 1 / move_.scale;
    std::string texts = fmt::format("point {} {} {} {}", name(point), pores_.points()[point].index, rank(point),
                                    text(pores_.value(point) * QuadraticNumber(back)));
    const auto position = pores_.center(point);
    for (std::size_t k = 0; k < 3; ++k) {
      texts += ' ' + text((position[k] - QuadraticNumber(move_.offset[k])) * QuadraticNumber(back));
    }
    return texts;
  }

  const Pores& pores_;
  const Move& move_;
};

Texts statements(const std::vector<Ball>& balls, const Move& move, const Rational& depth) {
  const BallSet set(moved(balls, move));
  const Pores pores(set, depth * move.scale);
  return Statements(pores, move).all();
}

TEST(PoreMetamorphic, MovedBallsHaveTheSameRooms) {
  CITES("FC-BALL-01", "FC-BALL-03", "FC-BALL-05", "FC-BALL-07", "FC-BALL-09");
  const auto sets = static_cast<std::uint64_t>(200 * flowcert_tests::scale_of_run());
  std::size_t chambers = 0;
  for (std::uint64_t number = 0; number < sets; ++number) {
    const DegenerateBalls drawn = degenerate_balls(100000 + number);
    SCOPED_TRACE("set " + std::to_string(number) + ", " + drawn.family);
    Move none{Ids(drawn.balls.size()), 1, {0, 0, 0}};
    std::iota(none.ids.begin(), none.ids.end(), 0u);
    Move move{none.ids, Rational(3, 7), {Rational(-1, 3), 1000001, Rational(5, 11)}};
    std::mt19937_64 random(number);
    for (std::size_t k = move.ids.size(); k > 1; --k) std::swap(move.ids[k - 1], move.ids[random() % k]);
    for (const Rational& depth : {Rational(0), Rational(1, 50)}) {
      const Texts before = statements(drawn.balls, none, depth);
      EXPECT_EQ(statements(drawn.balls, move, depth), before);
      chambers += static_cast<std::size_t>(
          std::ranges::count_if(before, [](const std::string& statement) { return statement.starts_with("chamber"); }));
    }
  }
  EXPECT_GE(chambers, sets / 4);
}

}  // namespace
}  // namespace flowcert::property::pore_metamorphic_test
