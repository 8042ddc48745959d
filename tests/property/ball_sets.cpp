#include "tests/property/ball_sets.h"

#include <algorithm>
#include <array>
#include <bit>
#include <boost/multiprecision/gmp.hpp>
#include <cmath>
#include <set>

namespace flowcert::property {

namespace {

constexpr std::size_t kMostBalls = 9;
constexpr int kSide = 5;  // coordinates are 0 to 4
using Place = std::array<int, 3>;

// std::mt19937_64 gives the same numbers everywhere, and the distributions of the library do not.
class Draw {
 public:
  explicit Draw(std::uint64_t seed) : random_(seed) {}
  int below(int count) { return static_cast<int>(random_() % static_cast<unsigned>(count)); }
  Place place() {
    const int x = below(kSide), y = below(kSide), z = below(kSide);
    return {x, y, z};
  }
  // Quarters from 1/4 to 3/2.
  Rational radius(int most = 6) { return Rational(1 + below(most), 4); }

 private:
  std::mt19937_64 random_;
};

// With its images under turns by a half around the three axes through the middle, and a mirror.
void add_images(std::set<Place>& places, const Place& p) {
  const int last = kSide - 1;
  places.insert({p,
                 {last - p[0], p[1], p[2]},
                 {p[0], last - p[1], p[2]},
                 {p[0], p[1], last - p[2]},
                 {last - p[0], last - p[1], last - p[2]}});
}

std::set<Place> symmetric_places(Draw& draw) {
  std::set<Place> places;
  for (int k = 1 + draw.below(3); k > 0; --k) add_images(places, draw.place());
  return places;
}

std::set<Place> cage_places(Draw& draw) {
  constexpr std::array<Place, 6> kOctahedron{{{2, 2, 0}, {2, 2, 4}, {2, 0, 2}, {2, 4, 2}, {0, 2, 2}, {4, 2, 2}}};
  std::set<Place> places;
  const int left_out = draw.below(12);
  for (int k = 0; k < 6; ++k) {
    if (k != left_out) places.insert(kOctahedron[static_cast<std::size_t>(k)]);
  }
  for (int k = 1 + draw.below(3); k > 0; --k) places.insert(draw.place());
  return places;
}

std::set<Place> any_places(Draw& draw, bool is_flat) {
  std::set<Place> places;
  for (int k = 5 + draw.below(5); k > 0; --k) {
    Place place = draw.place();
    if (is_flat) place[2] = 2;
    places.insert(place);
  }
  return places;
}

// One radius or coordinate is other by 2^-60, so that what was equal is so no more, and has one nearest double still.
void move_a_little(Draw& draw, std::vector<Ball>& balls) {
  Ball& ball = balls[static_cast<std::size_t>(draw.below(static_cast<int>(balls.size())))];
  const Rational little = Rational(draw.below(2) == 0 ? 1 : -1) / Rational(0x1p60);
  const int choice = draw.below(4);
  (choice == 3 ? ball.radius : ball.center[static_cast<std::size_t>(choice)]) += little;
}

// Each second corner of a box, and a ball that touches the widest probe in its middle but for 2^-60.
std::vector<Ball> plugged_box(Draw& draw) {
  using Integer = boost::multiprecision::mpz_int;
  constexpr int kDigits = 60, kMiddle = 2;
  const std::array<int, 3> half{1 + draw.below(2), 1 + draw.below(2), 1 + draw.below(2)};
  const Rational radius = draw.radius(3);
  std::vector<Ball> balls;
  int square = 0;
  for (const int length : half) square += length * length;
  for (unsigned corner = 0; corner < 8; ++corner) {
    if (std::popcount(corner) % 2 == 1) continue;
    Ball& ball = balls.emplace_back(Ball{{kMiddle, kMiddle, kMiddle}, radius});
    for (std::size_t k = 0; k < 3; ++k) ball.center[k] += (corner >> k) % 2 == 0 ? half[k] : -half[k];
  }
  const Integer root = sqrt(Integer(Integer(square) << (2 * kDigits))) + draw.below(2);
  const Rational distance(root, Integer(1) << kDigits);
  balls.push_back({{kMiddle + 4, kMiddle, kMiddle}, 4 - distance + radius});
  return balls;
}

// A radius with which the ball touches an earlier one, from outside or inside, where that is rational.
void touch_some(Draw& draw, std::vector<Ball>& balls) {
  for (std::size_t i = 1; i < balls.size(); ++i) {
    const Ball& other = balls[static_cast<std::size_t>(draw.below(static_cast<int>(i)))];
    Rational square = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const Rational difference = balls[i].center[k] - other.center[k];
      square += difference * difference;
    }
    const int root = static_cast<int>(std::lround(std::sqrt(square.convert_to<double>())));
    if (Rational(root * root) != square) continue;
    const Rational outer = Rational(root) + other.radius, inner = abs(Rational(root) - other.radius);
    const int choice = draw.below(3);
    if (choice == 0) balls[i].radius = outer;
    if (choice == 1 && inner > 0) balls[i].radius = inner;
  }
}

}  // namespace

DegenerateBalls degenerate_balls(std::uint64_t number) {
  constexpr std::array<const char*, 11> kFamilies{"any",  "any",   "symmetric", "touching", "cage",   "hidden",
                                                  "flat", "equal", "nearly",    "closed",   "plugged"};
  Draw draw(number);
  DegenerateBalls made;
  made.family = kFamilies[static_cast<std::size_t>(draw.below(static_cast<int>(kFamilies.size())))];
  if (made.family == "plugged") {
    made.balls = plugged_box(draw);
    return made;
  }
  const bool is_closed = made.family == "closed", is_cage = made.family == "cage" || is_closed;
  const bool is_symmetric = made.family == "symmetric" || made.family == "nearly";
  std::set<Place> places = is_symmetric ? symmetric_places(draw)
                           : is_cage    ? cage_places(draw)
                                        : any_places(draw, made.family == "flat");
  const Rational one = draw.radius();
  for (const auto& [x, y, z] : places) {
    if (made.balls.size() == kMostBalls) break;
    Rational radius = is_symmetric ? one : draw.radius(is_cage ? 2 : 6);
    if (is_closed) radius += Rational(3, 2);
    made.balls.push_back({{x, y, z}, radius});
  }
  if (made.family == "nearly") move_a_little(draw, made.balls);
  if (made.family == "touching") touch_some(draw, made.balls);
  const auto any = [&] { return static_cast<std::size_t>(draw.below(static_cast<int>(made.balls.size()))); };
  if (made.family == "hidden") made.balls[any()].radius = Rational(2 + draw.below(3));
  if (made.family == "equal") made.balls.push_back(made.balls[any()]);
  return made;
}

}  // namespace flowcert::property
