// Larger inputs; see orbit_inputs.h for what they guarantee.
#include "tests/property/orbit_inputs.h"

#include <cmath>
#include <utility>

#include "fuzz/inputs/integer_points.h"

namespace flowcert::property {
namespace {

using fuzz::Integer;
using fuzz::IntegerPoint;
using fuzz::IntegerPoints;

// Inputs of so many points made of random triples.
template <typename Make>
rc::Gen<fuzz::Input> drawn_points(std::size_t count, Integer low, Integer high, Make make) {
  return fuzz::input_of(rc::gen::map(rc::gen::container<IntegerPoints>(count, fuzz::integer_point(low, high)),
                                     [make](IntegerPoints points) {
                                       for (IntegerPoint& point : points) {
                                         point = make(point);
                                       }
                                       return points;
                                     }));
}

IntegerPoint itself(const IntegerPoint& point) { return point; }

constexpr Integer kDomeRadius = 30;

IntegerPoint onto_dome(const IntegerPoint& point) {
  const Integer rest = kDomeRadius * kDomeRadius - point[0] * point[0] - point[1] * point[1];
  return {point[0], point[1], rest <= 0 ? 0 : static_cast<Integer>(std::floor(std::sqrt(static_cast<double>(rest))))};
}

IntegerPoint onto_plane(const IntegerPoint& point) { return {point[0], point[1], 2 * point[0] - point[1]}; }

}  // namespace

std::vector<fuzz::Family> larger_families() {
  constexpr std::size_t kPoints = 250;
  return {
      {"lattice", "of {0..6}^3", [] { return drawn_points(kPoints, 0, 6, itself); }, {}},
      {"dome",
       "a grid-rounded half sphere",
       [] { return drawn_points(kPoints, -kDomeRadius, kDomeRadius, onto_dome); },
       {}},
      {"plane", "a lattice in a tilted plane", [] { return drawn_points(kPoints, -9, 9, onto_plane); }, {}},
      {"general position",
       "40 bits a coordinate",
       [] { return drawn_points(kPoints, -(Integer{1} << 40), Integer{1} << 40, itself); },
       {}},
  };
}

}  // namespace flowcert::property
