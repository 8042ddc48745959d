// The centres from which balls are equally far, in doubles with a size: the exact numbers are within their bounds.
#include "morse/ball_touching.h"

#include <gtest/gtest.h>

#include <span>
#include <vector>

#include "flowcert/ball_set.h"
#include "tests/unit/portable_random.h"

namespace flowcert::ball_touching_test {
namespace {

using morse::SizedDouble;

// Grids of few places make flat and nearly flat simplices, and steps of many digits make doubles round.
std::vector<Ball> drawn(flowcert_tests::PortableRandom& random, bool is_exact) {
  const Rational step = is_exact ? Rational(1) : Rational(1) / 3 + Rational(1) / 1000000000000037;
  const Rational origin = random.between(-30, 30);
  std::vector<Ball> balls;
  for (int k = 0; k < 4; ++k) {
    const auto coordinate = [&] { return Rational(origin + random.between(0, 9) * step); };
    balls.push_back({{coordinate(), coordinate(), coordinate()}, Rational((1 + random.between(0, 9)) * step / 100)});
  }
  return balls;
}

bool is_within(const SizedDouble& near, const Rational& exact) {
  const auto [value, error] = near.bounded();
  return abs(Rational(Rational(value) - exact)) <= Rational(error);
}

TEST(BallTouching, ExactNumbersAreWithinTheBoundsOfSizedOnes) {
  flowcert_tests::PortableRandom random(1);
  std::size_t known = 0, rounded = 0;
  for (int round = 0; round < 600; ++round) {
    const BallSet balls(drawn(random, round % 2 == 0));
    if (!balls.are_doubles()) ++rounded;
    const std::array<std::uint32_t, 4> ids{0, 1, 2, 3};
    const std::span<const std::uint32_t> some(ids.data(), 2 + static_cast<std::size_t>(round % 3));
    const auto near = morse::touching<SizedDouble>(balls, some);
    if (!near) continue;
    const auto exact = morse::touching<Rational>(balls, some);
    ASSERT_TRUE(exact) << "a flat simplex has a certain inverse";
    ++known;
    EXPECT_TRUE(is_within(near->a.x, exact->a.x) && is_within(near->a.y, exact->a.y) &&
                is_within(near->a.z, exact->a.z));
    EXPECT_TRUE(is_within(near->b.x, exact->b.x) && is_within(near->b.y, exact->b.y) &&
                is_within(near->b.z, exact->b.z));
    EXPECT_TRUE(is_within(near->c2, exact->c2) && is_within(near->c1, exact->c1) && is_within(near->c0, exact->c0));
    for (std::size_t k = 0; k + 1 < some.size(); ++k) {
      EXPECT_TRUE(is_within(near->u[k], exact->u[k]) && is_within(near->v[k], exact->v[k]));
    }
  }
  EXPECT_GE(known, 400u);
  EXPECT_GE(rounded, 200u);
}

}  // namespace
}  // namespace flowcert::ball_touching_test
