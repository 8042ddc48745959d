// Let c be the middle of a cube, and h the distance of its corners from it. For x in the cube |d(x) - d(c)| <= h, and so
// |c - p| - r <= d(c) + 2 h for each contact of x. With d(c) + h < 0 no place of the cube has a value of 0 or more.
#include "oracle/fast/near_balls.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace oracle::fast {

namespace {

constexpr std::size_t kFewBalls = 8;  // a cube with so few balls stays whole
constexpr int kMostCuts = 7;
constexpr double kRoomToSpare = 1e-6;  // of the side of all

using Place = std::array<double, 3>;

class Cubes {
 public:
  explicit Cubes(const std::vector<Ball>& balls) {
    if (balls.empty()) return;
    Place low, high;
    low.fill(HUGE_VAL);
    high.fill(-HUGE_VAL);
    for (const Ball& ball : balls) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double coordinate = ball.centre[axis].convert_to<double>();
        low[axis] = std::min(low[axis], coordinate);
        high[axis] = std::max(high[axis], coordinate);
      }
      centres_.push_back({ball.centre[0].convert_to<double>(), ball.centre[1].convert_to<double>(),
                          ball.centre[2].convert_to<double>()});
      radii_.push_back(ball.radius.convert_to<double>());
    }
    double half = *std::max_element(radii_.begin(), radii_.end());
    Place middle;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      middle[axis] = (low[axis] + high[axis]) / 2;
      half = std::max(half, (high[axis] - low[axis]) / 2 * (1 + kRoomToSpare));
    }
    spare_ = half * kRoomToSpare;
    Places all(balls.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    see(middle, half, all, 0);
  }

  const std::set<Places>& subsets() const { return subsets_; }

 private:
  double beyond(const Place& x, std::size_t ball) const {
    const Place& p = centres_[ball];
    return std::hypot(x[0] - p[0], x[1] - p[1], x[2] - p[2]) - radii_[ball];
  }

  // `some` are the balls that can be contacts in a cube around this one.
  void see(const Place& middle, double half, const Places& some, int cuts) {
    const double corner = half * std::sqrt(3.0) + spare_;
    double least = HUGE_VAL;
    for (const std::size_t ball : some) least = std::min(least, beyond(middle, ball));
    if (least + corner < 0) return;
    Places near;
    std::copy_if(some.begin(), some.end(), std::back_inserter(near),
                 [&](std::size_t ball) { return beyond(middle, ball) <= least + 2 * corner; });
    if (near.size() <= kFewBalls || cuts == kMostCuts) {
      for_each_subset(near.size(), 4, [&](const Places& subset) { subsets_.insert(select(near, subset)); });
      return;
    }
    for (int part = 0; part < 8; ++part) {
      Place there = middle;
      for (std::size_t axis = 0; axis < 3; ++axis) there[axis] += (part >> axis) % 2 == 0 ? -half / 2 : half / 2;
      see(there, half / 2, near, cuts + 1);
    }
  }

  std::vector<Place> centres_;
  std::vector<double> radii_;
  double spare_ = 0;
  std::set<Places> subsets_;
};

}  // namespace

std::set<Places> near_subsets(const std::vector<Ball>& balls) { return Cubes(balls).subsets(); }

std::vector<BallPoint> critical_points(const std::vector<Ball>& balls) {
  return oracle::critical_points(balls, near_subsets(balls));
}

}  // namespace oracle::fast
