// Families that look like scans: points of a sphere, a torus or a sheet, rounded to a grid, as a depth sensor
// or a file with few digits rounds them.
//
// Guarantees: see families.h. The curves are parametrised rationally (stereographic projection) and rounded
// in integer arithmetic: sines and cosines would differ between C libraries.
#include "fuzz/inputs/family_groups.h"
#include "fuzz/inputs/integer_points.h"

namespace flowcert::fuzz {
namespace {

// The parameter t = step / kSteps of the circle ((1-t²)/(1+t²), 2t/(1+t²)).
constexpr Integer kSteps = 8;

struct Fraction {
  Integer numerator;
  Integer denominator;  // positive
};

Fraction cosine(Integer step) { return {kSteps * kSteps - step * step, kSteps * kSteps + step * step}; }
Fraction sine(Integer step) { return {2 * kSteps * step, kSteps * kSteps + step * step}; }

IntegerPoint sphere_sample(Integer radius, Integer i, Integer j) {
  const Integer denominator = kSteps * kSteps + i * i + j * j;
  return {nearest_integer(radius * 2 * kSteps * i, denominator),
          nearest_integer(radius * 2 * kSteps * j, denominator),
          nearest_integer(radius * (denominator - 2 * kSteps * kSteps), denominator)};
}

IntegerPoint torus_sample(Integer core, Integer tube, Integer around, Integer across) {
  const Fraction c = cosine(around);
  const Fraction s = sine(around);
  const Fraction tube_c = cosine(across);
  const Fraction tube_s = sine(across);
  const Integer reach = core * tube_c.denominator + tube * tube_c.numerator;  // over tube_c.denominator
  return {nearest_integer(reach * c.numerator, tube_c.denominator * c.denominator),
          nearest_integer(reach * s.numerator, tube_c.denominator * s.denominator),
          nearest_integer(tube * tube_s.numerator, tube_s.denominator)};
}

template <typename Sample>
IntegerPoints samples(const IntegerPoints& parameters, const Sample& sample) {
  IntegerPoints points;
  for (const auto& [i, j, unused] : parameters) {
    points.push_back(sample(i, j));
  }
  return distinct(points);
}

rc::Gen<IntegerPoints> parameters(Integer reach) { return list_of(4, 12, integer_point(-reach, reach)); }

rc::Gen<IntegerPoints> sphere_scan() {
  return rc::gen::apply(
      [](const IntegerPoints& where, Integer radius) {
        return samples(where, [radius](Integer i, Integer j) { return sphere_sample(radius, i, j); });
      },
      parameters(20), whole(2, 6));
}

rc::Gen<IntegerPoints> torus_scan() {
  return rc::gen::apply(
      [](const IntegerPoints& where, Integer tube, Integer hole) {
        return samples(where, [&](Integer i, Integer j) { return torus_sample(tube + hole, tube, i, j); });
      },
      parameters(30), whole(1, 3), whole(1, 3));
}

// A quadratic height field over a grid, as a depth image is.
rc::Gen<IntegerPoints> sheet_scan() {
  return rc::gen::apply(
      [](const IntegerPoints& where, const IntegerPoint& form, Integer flatness) {
        return samples(where, [&](Integer x, Integer y) {
          const Integer height = form[0] * x * x + form[1] * x * y + form[2] * y * y;
          return IntegerPoint{x, y, nearest_integer(height, flatness)};
        });
      },
      parameters(2), integer_point(-2, 2), whole(3, 9));
}

}  // namespace

std::vector<Family> scan_families() {
  return {
      {"sphere-scan",
       "points of a sphere rounded to a grid of a few cells",
       [] { return input_of(sphere_scan()); },
       {.four_points = 85, .cluster = 1, .kind12 = 35, .kind13 = 3, .tie = 35}},
      {"torus-scan",
       "points of a torus rounded to a grid",
       [] { return input_of(torus_scan()); },
       {.four_points = 85, .cluster = 1, .kind12 = 35, .kind13 = 3, .tie = 35}},
      {"sheet-scan",
       "a quadratic height field rounded to a grid",
       [] { return input_of(sheet_scan()); },
       {.four_points = 75, .cluster = 1, .kind12 = 45, .kind13 = 5, .tie = 45}},
  };
}

}  // namespace flowcert::fuzz
