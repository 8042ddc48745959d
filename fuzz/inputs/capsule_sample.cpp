// All is done in integers. Points of the half spheres are made of two circles whose radii have the capsule's radius as
// their product: (c u, c v, s r) with c² + s² = q², u² + v² = r² and q r = kCapsuleRadius.
#include "fuzz/inputs/capsule_sample.h"

#include <algorithm>
#include <cstdlib>
#include <stdexcept>
#include <vector>

#include "fuzz/inputs/gaussian_circle.h"

namespace flowcert::fuzz {
namespace {

// Radii as products of the primes of gaussian_circle.h.
constexpr PrimeExponents kWhole{2, 2, 2, 1, 1, 1, 1, 1};     // kCapsuleRadius
constexpr PrimeExponents kMeridian{1, 1, 1, 1, 0, 0, 0, 0};  // q
constexpr PrimeExponents kParallel{1, 1, 1, 0, 1, 1, 1, 1};  // r
constexpr Integer kMeridianRadius = Integer{5} * 13 * 17 * 29;
constexpr Integer kParallelRadius = kCapsuleRadius / kMeridianRadius;
static_assert(kMeridianRadius * kParallelRadius == kCapsuleRadius);

std::vector<Gaussian> circle_of_radius(PrimeExponents radius) {
  for (int& exponent : radius) {
    exponent *= 2;
  }
  return integer_circle(radius);
}

// ---- The strip ----
// It is about the line (kCapsuleRadius, 0, z), half as wide at its narrow end as at its wide one.

constexpr Integer kNarrow = kCapsuleRadius / 1000 * 26;  // half the width
constexpr Integer kLean = 4;                             // the strip is so many times as long as it widens to one side
constexpr Integer kStripStart = -kLean * kNarrow;
constexpr Integer kCloser = 3 * kNarrow;

// The teeth of one side have y > 0; the others are their mirror images, and stand a little further along.
IntegerPoints teeth_of_strip(std::size_t count) {
  std::vector<Gaussian> side;
  for (const Gaussian& p : circle_of_radius(kWhole)) {
    if (p[0] > 0 && p[1] >= kNarrow && p[1] <= 2 * kNarrow) {
      side.push_back(p);
    }
  }
  const std::size_t pairs = count / 2;
  IntegerPoints teeth;
  for (std::size_t k = 0; k < pairs; ++k) {
    const auto& [x, y] = side[k * (side.size() - 1) / (pairs - 1)];
    const Integer z = kStripStart + kLean * (y - kNarrow);
    teeth.push_back({x, y, z});
    teeth.push_back({x, -y, z + kNarrow / 2000});
  }
  std::sort(teeth.begin(), teeth.end(), [](const auto& a, const auto& b) { return a[2] < b[2]; });
  return teeth;
}

// No other sample may lie in the balls around the strip.
bool is_near_strip(const IntegerPoint& p) {
  const auto& [x, y, z] = p;
  return x > 0 && 10 * std::abs(y) < 26 * kNarrow && z > kStripStart - kNarrow && 2 * z < 2 * kCloser + kNarrow;
}

// ---- The rest of the capsule ----

constexpr std::size_t kAroundCylinder = 126;  // points of a circle of the cylinder
constexpr Integer kCylinderRings = 10;        // along the cylinder

// `count` of the circle's points, evenly by their places in it, all multiplied by the factor.
void add_ring(IntegerPoints& points, const std::vector<Gaussian>& circle, std::size_t count, Integer factor,
              Integer z) {
  for (std::size_t k = 0; k < count; ++k) {
    const auto& [x, y] = circle[k * circle.size() / count];
    points.push_back({x * factor, y * factor, z});
  }
}

Integer squared_distance(const Gaussian& a, const Gaussian& b) {
  const Integer x = a[0] - b[0], y = a[1] - b[1];
  return x * x + y * y;
}

// From the cylinder's end to the pole, as far apart as 0.055 radii allow.
std::vector<Gaussian> meridian() {
  constexpr Integer kStep = kMeridianRadius * 55 / 1000;
  const Gaussian pole{0, kMeridianRadius};
  std::vector<Gaussian> chosen;
  const std::vector<Gaussian> circle = circle_of_radius(kMeridian);
  for (std::size_t k = 0; k + 1 < circle.size() && circle[k] != pole; ++k) {
    const Gaussian& last = chosen.empty() ? circle.front() : chosen.back();
    if (squared_distance(circle[k + 1], last) > kStep * kStep) {
      chosen.push_back(circle[k]);
    }
  }
  chosen.push_back(pole);
  return chosen;
}

IntegerPoints rest_of_capsule() {
  const std::vector<Gaussian> parallel = circle_of_radius(kParallel);
  IntegerPoints points;
  for (Integer ring = -kCylinderRings / 2; ring <= kCylinderRings / 2; ++ring) {
    add_ring(points, parallel, kAroundCylinder, kMeridianRadius, kCapsuleHalfLength * 2 / kCylinderRings * ring);
  }
  for (const auto& [c, s] : meridian()) {
    const auto share = kAroundCylinder * static_cast<std::size_t>(c) / static_cast<std::size_t>(kMeridianRadius);
    for (const Integer side : {1, -1}) {
      const Integer z = side * (s * kParallelRadius + kCapsuleHalfLength);
      if (c == 0) {
        points.push_back({0, 0, z});
      } else {
        add_ring(points, parallel, share + 3, c, z);
      }
    }
  }
  std::erase_if(points, is_near_strip);
  return points;
}

}  // namespace

Input capsule_sample(std::size_t teeth) {
  if (teeth < 20 || teeth > kMostCapsuleTeeth || teeth % 2 != 0) {
    throw std::invalid_argument("capsule_sample: 20 to 1,000 teeth, an even number");
  }
  IntegerPoints points = teeth_of_strip(teeth);
  points.push_back({kCapsuleRadius, 0, kCloser});
  const IntegerPoints rest = rest_of_capsule();
  points.insert(points.end(), rest.begin(), rest.end());
  return to_input(points);
}

}  // namespace flowcert::fuzz
