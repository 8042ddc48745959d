#include "flowcert/ball_set.h"

#include <algorithm>
#include <boost/multiprecision/integer.hpp>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "geometry/floating_point.h"
#include "geometry/integer_grid.h"

namespace flowcert {

namespace {

// A double is within 2^-53 of the number that it stands for, and a difference of two within 2^-53 more. This share of
// the numbers is more than all of that.
constexpr double kReachShare = 0x1p-40;

}  // namespace

BallSet::BallSet(std::vector<Ball> balls) : balls_(std::move(balls)), tangent_(balls_.size()) {
  const geometry::IeeeDoubles ieee;
  for (const Ball& ball : balls_) {
    if (ball.radius <= 0) throw std::invalid_argument("a radius is not positive: " + to_text(ball.radius));
  }
  scale_all();
  find_hidden();
}

void BallSet::scale_all() {
  using geometry::BigInteger;
  BigInteger scale = 1;
  const auto widen = [&scale](const Rational& number) {
    const BigInteger bottom(denominator(number));
    if (scale % bottom != 0) scale = lcm(scale, bottom);
  };
  for (const Ball& ball : balls_) {
    for (const Rational& coordinate : ball.center) widen(coordinate);
    widen(ball.radius);
  }
  scale_ = Rational(scale);
  scaled_.reserve(size());
  rounded_.reserve(size());
  for (const Ball& ball : balls_) {
    scaled_.push_back(
        {ball.center[0] * scale_, ball.center[1] * scale_, ball.center[2] * scale_, ball.radius * scale_});
    std::array<double, 4> near{};
    for (std::size_t k = 0; k < 4; ++k) {
      near[k] = nearest_or_infinity(scaled_.back()[k]);
      are_doubles_ = are_doubles_ && std::isfinite(near[k]) && Rational(near[k]) == scaled_.back()[k];
    }
    rounded_.push_back(near);
  }
}

// Compares the distance of the centres with the outer radius less the inner one, which is not negative.
int BallSet::compare_reach(std::uint32_t inner, std::uint32_t outer) const {
  Rational square = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Rational difference = scaled_[inner][k] - scaled_[outer][k];
    square += difference * difference;
  }
  const Rational reach = scaled_[outer][3] - scaled_[inner][3];
  return square.compare(reach * reach);
}

// A ball that hides another one has a centre that is nearer to it than the difference of their radii.
void BallSet::find_hidden() {
  std::vector<std::uint32_t> order(size());
  std::iota(order.begin(), order.end(), 0u);
  std::ranges::sort(order, [&](std::uint32_t i, std::uint32_t j) {
    const int sign = scaled_[i][0].compare(scaled_[j][0]);
    return sign != 0 ? sign < 0 : i < j;
  });
  double greatest = 0;
  for (const std::array<double, 4>& ball : rounded_) greatest = std::max(greatest, ball[3]);
  std::vector<char> is_hidden(size(), 0);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> touching;  // outer, inner
  for (std::size_t place = 0; place < size(); ++place) {
    const std::uint32_t inner = order[place];
    const auto& [x, y, z, r] = rounded_[inner];
    const double reach = (greatest - r) + (std::fabs(x) + greatest) * kReachShare;
    const auto see = [&](std::uint32_t outer) {
      const auto& [u, v, w, s] = rounded_[outer];
      if (u < x - reach || u > x + reach) return false;
      if (std::fabs(v - y) > reach + std::fabs(y) * kReachShare ||
          std::fabs(w - z) > reach + std::fabs(z) * kReachShare) {
        return true;
      }
      const int radii = scaled_[outer][3].compare(scaled_[inner][3]);
      if (radii < 0) return true;
      const int sign = compare_reach(inner, outer);
      if (sign > 0 || (sign == 0 && radii == 0 && outer > inner)) return true;
      is_hidden[inner] = 1;
      if (sign == 0) touching.emplace_back(outer, inner);
      return true;
    };
    for (std::size_t other = place; other-- > 0 && see(order[other]);) {
    }
    for (std::size_t other = place + 1; other < size() && see(order[other]); ++other) {
    }
  }
  for (const auto& [outer, inner] : touching) {
    if (!is_hidden[outer]) tangent_[outer].push_back(inner);
  }
  for (std::uint32_t id = 0; id < size(); ++id) {
    std::ranges::sort(tangent_[id]);
    if (!is_hidden[id]) visible_.push_back(id);
  }
}

}  // namespace flowcert
