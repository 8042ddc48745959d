// How the facets, shells and cascades of large_configurations.h are made. All is done in integers, except for one
// correctly rounded division.
//
// Facets: v in the plane z = 0 belongs to the facet of p0p1 iff 2<v,q> <= |q|² - h² for all neighbours q. For
// q = c + w with |w| = R, and v = c + y, that is 2<y,w> + 2<y,c> <= R² - h² - |c|². The lines of all w touch
// the conic 2R|y| + 2<y,c> = R² - h² - |c|²: an ellipse with a focus in c, if |c| < R and h² + |c|² < R². So
// none of them is redundant, however many there are. Where the circle comes nearer to the origin than h, q is
// obtuse.
#include "fuzz/inputs/large_configurations.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <stdexcept>
#include <vector>

#include "fuzz/inputs/gaussian_circle.h"
#include "fuzz/inputs/integer_points.h"

namespace flowcert::fuzz {
namespace {

// It uses the raw output of std::mt19937_64, which the standard fixes, and none of its distributions.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : engine_(seed) {}

  Integer between(Integer low, Integer high) {
    return low + static_cast<Integer>(engine_() % (static_cast<std::uint64_t>(high - low) + 1));
  }

 private:
  std::mt19937_64 engine_;
};

void require(bool served, const char* complaint) {
  if (!served) {
    throw std::invalid_argument(complaint);
  }
}

// The primes are multiplied in this order to a norm N. x² + y² = N has four times as many solutions as N has
// divisors, 120,960 in the end, with coordinates below 2^48.
constexpr std::array<std::size_t, 23> kOrder{0, 1, 2, 3, 0, 4, 5, 1, 6, 0, 2, 7, 3, 0, 4, 1, 5, 0, 6, 2, 3, 1, 0};

// A norm whose circle has at least so many points. It is given by the exponents of the primes.
PrimeExponents norm_with_points(std::size_t least) {
  PrimeExponents exponents{};
  std::size_t points = 4;
  for (const std::size_t prime : kOrder) {
    if (points >= least) {
      break;
    }
    const auto before = static_cast<std::size_t>(++exponents[prime]);
    points = points / before * (before + 1);
  }
  return exponents;
}

// All integer points of a circle with at least so many, or with as many as the tables give, by angle.
std::vector<Gaussian> circle_with_points(std::size_t least) { return integer_circle(norm_with_points(least)); }

// Cuts a list into so many equal parts, and chooses one of each.
std::vector<Gaussian> spread_choice(const std::vector<Gaussian>& list, std::size_t count, Dice& dice) {
  std::vector<Gaussian> chosen;
  for (std::size_t k = 0; k < count; ++k) {
    const auto first = static_cast<Integer>(k * list.size() / count);
    const auto last = static_cast<Integer>((k + 1) * list.size() / count) - 1;
    chosen.push_back(list[static_cast<std::size_t>(dice.between(first, last))]);
  }
  return chosen;
}

// With so many points the radius is large enough for a choice of centres.
constexpr std::size_t kLeastCircle = 1000;

constexpr Integer kRadius = Integer{1} << 47;

Integer rounded(double value) { return static_cast<Integer>(std::floor(value + 0.5)); }

// Rounded points of the circle of kRadius, by angle. Each quarter has the parameters k / n of the rational
// parametrisation, so neighbours are at angles from 1/n to 2/n.
std::vector<Gaussian> rounded_circle(std::size_t count) {
  std::vector<Gaussian> circle;
  for (std::size_t quarter = 0; quarter < 4; ++quarter) {
    const auto n = static_cast<Integer>(count / 4 + (quarter < count % 4 ? 1 : 0));
    for (Integer k = 0; k < n; ++k) {
      const auto norm = static_cast<double>(n * n + k * k);
      const Gaussian point{rounded(static_cast<double>(n * n - k * k) / norm * static_cast<double>(kRadius)),
                           rounded(static_cast<double>(2 * n * k) / norm * static_cast<double>(kRadius))};
      circle.push_back(product(point, power({0, 1}, static_cast<int>(quarter))));
    }
  }
  return circle;
}

// 0.45 to 0.55 radii from the origin, so that there are obtuse neighbours, and the circle surrounds the origin.
Gaussian off_centre(Integer radius, Dice& dice) {
  const Integer unit = radius / 100;
  const auto is_in_ring = [](const Gaussian& c) {
    const Integer norm = c[0] * c[0] + c[1] * c[1];
    return norm >= Integer{45} * 45 && norm <= Integer{55} * 55;
  };
  Gaussian centre{0, 0};
  while (!is_in_ring(centre)) {
    centre = {dice.between(-55, 55), dice.between(-55, 55)};
  }
  // The centre is not a multiple of the unit, so that nothing is symmetric.
  return {centre[0] * unit + dice.between(0, unit / 100), centre[1] * unit + dice.between(0, unit / 100)};
}

// Takes so many of the list, each as likely as any other, and keeps their order.
Input choice_of(const IntegerPoints& list, std::size_t count, Dice& dice) {
  IntegerPoints chosen;
  for (std::size_t k = 0; k < list.size(); ++k) {
    const auto left = static_cast<Integer>(list.size() - k), wanted = static_cast<Integer>(count - chosen.size());
    if (dice.between(1, left) <= wanted) chosen.push_back(list[k]);
  }
  return to_input(chosen);
}

void require_ties(std::size_t points) { require(points >= 1 && points <= 100'000, "1 to 100,000 points"); }

constexpr Integer kCell = 64;                // of the shell's grid
constexpr Integer kStep = Integer{1} << 24;  // from tooth to tooth

}  // namespace

Input high_degree_facet(std::size_t degree, bool perturbed, std::uint64_t seed) {
  require(degree >= 10 && degree <= 100'000, "high_degree_facet: degrees are 10 to 100,000");
  Dice dice(seed);
  const std::vector<Gaussian> circle =
      perturbed ? rounded_circle(degree)
                : spread_choice(circle_with_points(std::max(4 * degree, kLeastCircle)), degree, dice);
  Integer radius = 0;
  for (const Gaussian& w : circle) {
    radius = std::max(radius, std::abs(w[0]));
  }
  // In the polar dual the lines of a circle's points are points of a circle. Neighbours at an angle g leave a
  // point between them g²/2 radii before it sinks below their chord, and all errors count less than 50 times
  // as much there. Here g is about 4 / degree.
  const auto whole_degree = static_cast<Integer>(degree);
  const Integer reach = perturbed ? radius / (16 * whole_degree * whole_degree) : 0;
  const Gaussian centre = off_centre(radius, dice);
  const Integer h = radius / 4 * 3;
  IntegerPoints points{{0, 0, -h}, {0, 0, h}};
  for (const Gaussian& w : circle) {
    const Integer x = centre[0] + w[0] + dice.between(-reach, reach);
    const Integer y = centre[1] + w[1] + dice.between(-reach, reach);
    points.push_back({x, y, dice.between(-reach, reach)});
  }
  return to_input(points);
}

Input half_shell(std::size_t points, std::uint64_t seed) {
  require(points <= 100'000'000, "half_shell: at most 100,000,000 points");
  Dice dice(seed);
  Integer side = 1;
  while (static_cast<std::size_t>(side * side) < points) {
    ++side;
  }
  IntegerPoints sheet;
  for (std::size_t k = 0; k < points; ++k) {
    const auto cell = static_cast<Integer>(k);
    const Integer x = (cell % side) * kCell - side * kCell / 2 + dice.between(0, kCell / 2);
    const Integer y = (cell / side) * kCell - side * kCell / 2 + dice.between(0, kCell / 2);
    sheet.push_back({x, y, (2 * x * x + 3 * y * y) / (side * kCell)});
  }
  return to_input(sheet);
}

Input long_cascade(std::size_t points, std::uint64_t seed) {
  require(points >= 8 && points <= 100'000, "long_cascade: at least 8, at most 100,000 points");
  Dice dice(seed);
  const auto teeth = static_cast<Integer>(points - 2);
  // The teeth lie near the lines (t, 2t, 0) and (t, -2t, 0) in turn, with t from `start` to twice that.
  const Integer start = teeth * kStep;
  const Integer reach = kStep / (32 * teeth);
  const auto tooth = [&](Integer k) {
    const Integer t = start + k * kStep + dice.between(-kStep / 2, kStep / 2);
    const Integer side = k % 2 == 0 ? 2 : -2;
    const Integer y = side * t + dice.between(-reach, reach);
    return IntegerPoint{t, y, dice.between(-reach, reach)};
  };
  IntegerPoints combs{tooth(0), tooth(1), {start, 0, start / 4 * 9}, {20 * start, 0, 0}};
  for (Integer k = 2; k < teeth; ++k) {
    combs.push_back(tooth(k));
  }
  return to_input(combs);
}

// ---- Ties everywhere ----

Input lattice_piece(std::size_t points, std::uint64_t seed) {
  require_ties(points);
  Dice dice(seed);
  const auto least = static_cast<Integer>(points) * 8 / 7 + 1;
  Integer side = 1;
  while (side * side * side < least) ++side;
  const Integer a = dice.between(side / 2 + 1, 2 * side), b = dice.between(side / 2 + 1, 2 * side);
  const Integer c = least / (a * b) + 1;
  const IntegerPoint edges{dice.between(1, 3), dice.between(1, 3), dice.between(1, 3)};
  IntegerPoints box;
  for (Integer x = 0; x < a; ++x) {
    for (Integer y = 0; y < b; ++y) {
      for (Integer z = 0; z < c; ++z) box.push_back({x * edges[0], y * edges[1], z * edges[2]});
    }
  }
  return choice_of(box, points, dice);
}

Input lattice_layers(std::size_t points, std::uint64_t seed) {
  require_ties(points);
  Dice dice(seed);
  const Integer layers = dice.between(2, 6);
  const auto of_layer = static_cast<Integer>(points) * 8 / 7 / layers + 1;
  const auto side = static_cast<Integer>(std::sqrt(static_cast<double>(of_layer))) + 1;
  IntegerPoints all;
  Integer z = 0;
  for (Integer layer = 0; layer < layers; ++layer) {
    const Integer shift_x = dice.between(0, 3), shift_y = dice.between(0, 3);
    z += dice.between(1, 6);
    for (Integer x = 0; x < side; ++x) {
      for (Integer y = 0; y < side; ++y) all.push_back({2 * x + shift_x, 2 * y + shift_y, z});
    }
  }
  return choice_of(all, points, dice);
}

Input integer_spheres(std::size_t points, std::uint64_t seed) {
  require_ties(points);
  Dice dice(seed);
  const Integer first = dice.between(100, 10'000);
  IntegerPoints all;
  for (Integer norm = first; all.size() < points; ++norm) {
    const auto reach = static_cast<Integer>(std::sqrt(static_cast<double>(norm)));
    for (Integer x = -reach; x <= reach; ++x) {
      for (Integer y = -reach; y <= reach; ++y) {
        const Integer square = norm - x * x - y * y;
        const Integer z = square < 0 ? 0 : rounded(std::sqrt(static_cast<double>(square)));
        if (z * z != square) continue;
        all.push_back({x, y, z});
        if (z > 0) all.push_back({x, y, -z});
      }
    }
  }
  return choice_of(all, points, dice);
}

// The circle and the sphere are parametrised rationally, with parameters u / kParts and v / kParts.
Input rounded_capsule(std::size_t points, std::uint64_t seed) {
  require_ties(points);
  constexpr Integer kParts = 1000;
  Dice dice(seed);
  const Integer radius = dice.between(16, 200), half_length = dice.between(0, 2 * radius);
  IntegerPoints all;
  while (all.size() < points) {
    const Integer u = dice.between(-2 * kParts, 2 * kParts), v = dice.between(-2 * kParts, 2 * kParts);
    const bool is_on_cylinder = dice.between(0, 2) == 0, is_below = dice.between(0, 1) == 0;
    const Integer norm = kParts * kParts + u * u + (is_on_cylinder ? 0 : v * v);
    const Integer y = nearest_integer(2 * kParts * u * radius, norm);
    const Integer along = nearest_integer((norm - 2 * kParts * kParts) * radius, norm);
    if (is_on_cylinder) {
      all.push_back({along, y, dice.between(-half_length, half_length)});
    } else {
      const Integer z = std::abs(along) + half_length;
      all.push_back({nearest_integer(2 * kParts * v * radius, norm), y, is_below ? -z : z});
    }
  }
  return to_input(all);
}

}  // namespace flowcert::fuzz
