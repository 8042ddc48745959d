// Building blocks of the families; see integer_points.h for what they guarantee.
//
// Shrinking by removal is done once for all families here: a Shrinkable of the whole input is kept beside the
// list of rows that are still in, so that rows can go first and what generated the others can shrink
// afterwards.
#include "fuzz/inputs/integer_points.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace flowcert::fuzz {
namespace {

constexpr int kFullSize = 100;

std::vector<Row> rows_at(const Input& input, const std::vector<std::size_t>& kept) {
  std::vector<Row> rows;
  for (const std::size_t row : kept) {
    // A smaller version of the whole may have fewer rows.
    if (row < input.rows.size()) {
      rows.push_back(input.rows[row]);
    }
  }
  return rows;
}

rc::Shrinkable<Input> removable(const rc::Shrinkable<Input>& whole, const std::vector<std::size_t>& kept) {
  const auto fewer = [whole](const std::vector<std::size_t>& rows) { return removable(whole, rows); };
  const auto smaller = [kept](const rc::Shrinkable<Input>& inner) { return removable(inner, kept); };
  // What only changes rows that are gone would be accepted by every property, and lead nowhere.
  const auto differs = [whole, kept](const rc::Shrinkable<Input>& inner) {
    return rows_at(inner.value(), kept) != rows_at(whole.value(), kept);
  };
  return rc::shrinkable::lambda([whole, kept] { return Input{rows_at(whole.value(), kept)}; },
                                [whole, kept, fewer, smaller, differs] {
                                  return rc::seq::concat(
                                      rc::seq::map(rc::shrink::removeChunks(kept), fewer),
                                      rc::seq::map(rc::seq::filter(whole.shrinks(), differs), smaller));
                                });
}

}  // namespace

Integer dot(const IntegerPoint& a, const IntegerPoint& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

IntegerPoint cross(const IntegerPoint& a, const IntegerPoint& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

IntegerPoint plus(const IntegerPoint& a, const IntegerPoint& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

IntegerPoint times(Integer factor, const IntegerPoint& a) {
  return {factor * a[0], factor * a[1], factor * a[2]};
}

Integer nearest_integer(Integer numerator, Integer denominator) {
  const Integer doubled = 2 * numerator + denominator;
  const Integer quotient = doubled / (2 * denominator);
  return doubled % (2 * denominator) < 0 ? quotient - 1 : quotient;
}

rc::Gen<Integer> whole(Integer low, Integer high) {
  const Integer target = std::clamp<Integer>(0, low, high);
  return [low, high, target](const rc::Random& random, int) {
    const auto width = static_cast<std::uint64_t>(high - low) + 1;
    const Integer value = low + static_cast<Integer>(rc::Random(random).next() % width);
    return rc::shrinkable::shrinkRecur(value, [target](Integer v) { return rc::shrink::towards(v, target); });
  };
}

rc::Gen<IntegerPoint> integer_point(Integer low, Integer high) {
  return rc::gen::apply(
      [](Integer x, Integer y, Integer z) {
        return IntegerPoint{x, y, z};
      },
      whole(low, high), whole(low, high), whole(low, high));
}

rc::Gen<std::size_t> row_count(std::size_t least, std::size_t most) {
  return [least, most](const rc::Random& random, int size) {
    rc::Random dice(random);
    const auto share = static_cast<std::size_t>(std::clamp(size, 0, kFullSize));
    // Rounded up, so that all but the smallest sizes have a choice.
    const std::size_t width = ((most - least) * share + kFullSize - 1) / kFullSize + 1;
    const std::size_t first = dice.next() % width;
    const std::size_t second = dice.next() % width;
    return rc::shrinkable::just(least + std::min(first, second));
  };
}

IntegerPoint IntegerRotation::operator()(const IntegerPoint& point) const {
  return {dot(rows[0], point), dot(rows[1], point), dot(rows[2], point)};
}

IntegerRotation rotation_of_quaternion(const std::array<Integer, 4>& quaternion) {
  const auto& [a, b, c, d] = quaternion;
  const Integer norm = a * a + b * b + c * c + d * d;
  if (norm == 0) {
    return {};
  }
  return {{{{a * a + b * b - c * c - d * d, 2 * (b * c - a * d), 2 * (b * d + a * c)},
            {2 * (b * c + a * d), a * a - b * b + c * c - d * d, 2 * (c * d - a * b)},
            {2 * (b * d - a * c), 2 * (c * d + a * b), a * a - b * b - c * c + d * d}}},
          norm};
}

rc::Gen<IntegerRotation> integer_rotation(Integer reach) {
  const auto any = rc::gen::apply(
      [](Integer a, Integer b, Integer c, Integer d) {
        return rotation_of_quaternion({a, b, c, d});
      },
      whole(-reach, reach), whole(-reach, reach), whole(-reach, reach), whole(-reach, reach));
  return rc::gen::oneOf(rc::gen::just(IntegerRotation{}), any);
}

rc::Gen<IntegerPoints> placed(const rc::Gen<IntegerPoints>& points) {
  return rc::gen::apply(
      [](IntegerPoints all, const IntegerRotation& turn, const IntegerPoint& shift) {
        for (IntegerPoint& point : all) {
          point = plus(turn(point), shift);
        }
        return all;
      },
      points, integer_rotation(2), integer_point(-5, 5));
}

IntegerPoints distinct(const IntegerPoints& points) {
  IntegerPoints once;
  for (const IntegerPoint& point : points) {
    if (std::find(once.begin(), once.end(), point) == once.end()) {
      once.push_back(point);
    }
  }
  return once;
}

Input to_input(const IntegerPoints& points) {
  Input input;
  for (const auto& [x, y, z] : points) {
    input.rows.push_back({static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)});
  }
  return input;
}

rc::Gen<Input> shrink_by_removing(const rc::Gen<Input>& inputs) {
  return [inputs](const rc::Random& random, int size) {
    const rc::Shrinkable<Input> whole = inputs(random, size);
    std::vector<std::size_t> kept(whole.value().rows.size());
    std::iota(kept.begin(), kept.end(), std::size_t{0});
    return removable(whole, kept);
  };
}

rc::Gen<Input> input_of(const rc::Gen<IntegerPoints>& points) {
  return shrink_by_removing(rc::gen::map(points, to_input));
}

}  // namespace flowcert::fuzz
