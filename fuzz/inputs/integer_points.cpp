// Shrinking by removal is done once for all families here. A Shrinkable of the whole input is kept beside the list of
// rows that are still in. So rows can go first, and the generator's own shrinking comes afterwards.
#include "fuzz/inputs/integer_points.h"

#include <algorithm>
#include <iterator>
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
  // Every property would accept a change of rows that are gone, and it would lead nowhere.
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

IntegerPoint plus(const IntegerPoint& a, const IntegerPoint& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }

IntegerPoint times(Integer factor, const IntegerPoint& a) { return {factor * a[0], factor * a[1], factor * a[2]}; }

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
  return rc::gen::apply([](Integer x, Integer y, Integer z) { return IntegerPoint{x, y, z}; }, whole(low, high),
                        whole(low, high), whole(low, high));
}

rc::Gen<std::size_t> row_count(std::size_t least, std::size_t most) {
  return [least, most](const rc::Random& random, int size) {
    rc::Random dice(random);
    const auto share = static_cast<std::size_t>(std::clamp(size, 0, kFullSize));
    // This is rounded up, so that all but the smallest sizes have a choice.
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
  const auto any =
      rc::gen::apply([](Integer a, Integer b, Integer c, Integer d) { return rotation_of_quaternion({a, b, c, d}); },
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

IntegerPoints joined(IntegerPoints points, const IntegerPoints& more) {
  points.insert(points.end(), more.begin(), more.end());
  return points;
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

rc::Gen<Input> distinct_input(const rc::Gen<IntegerPoints>& points) { return input_of(rc::gen::map(points, distinct)); }

rc::Gen<Input> placed_distinct(const rc::Gen<IntegerPoints>& points) { return distinct_input(placed(points)); }

// ---- Points of spheres ----
// The tables are made once, by looking at every point of a cube.
namespace {

using Table = std::array<IntegerPoints, static_cast<std::size_t>(kLargestTabulatedNorm) + 1>;

constexpr Integer kReach = 12;  // 13² > kLargestTabulatedNorm

Table points_by_norm(Integer z_reach) {
  Table table;
  for (Integer x = -kReach; x <= kReach; ++x) {
    for (Integer y = -kReach; y <= kReach; ++y) {
      for (Integer z = -z_reach; z <= z_reach; ++z) {
        const Integer norm = x * x + y * y + z * z;
        if (norm <= kLargestTabulatedNorm) {
          table[static_cast<std::size_t>(norm)].push_back({x, y, z});
        }
      }
    }
  }
  return table;
}

}  // namespace

const IntegerPoints& sphere_points(Integer norm) {
  static const Table table = points_by_norm(kReach);
  return table.at(static_cast<std::size_t>(norm));
}

const IntegerPoints& circle_points(Integer norm) {
  static const Table table = points_by_norm(0);
  return table.at(static_cast<std::size_t>(norm));
}

rc::Gen<Integer> circle_norm() { return one_of(std::array<Integer, 9>{1, 2, 5, 10, 25, 50, 65, 85, 130}); }

rc::Gen<Integer> sphere_norm() {
  return one_of(std::array<Integer, 12>{5, 6, 9, 14, 17, 26, 29, 41, 65, 89, 101, 146});
}

rc::Gen<std::size_t> raw_index() {
  return rc::gen::map(whole(0, 1'000'000), [](Integer index) { return static_cast<std::size_t>(index); });
}

const IntegerPoint& at_raw_index(const IntegerPoints& list, std::size_t raw) { return list[raw % list.size()]; }

IntegerPoints at_raw_indices(IntegerPoints list, const std::vector<std::size_t>& raw) {
  IntegerPoints chosen;
  for (const std::size_t index : raw) {
    if (list.empty()) {
      break;
    }
    const auto at = list.begin() + static_cast<std::ptrdiff_t>(index % list.size());
    chosen.push_back(*at);
    list.erase(at);
  }
  return chosen;
}

IntegerPoints on_positive_side(const IntegerPoints& list, const IntegerPoint& normal) {
  IntegerPoints side;
  std::copy_if(list.begin(), list.end(), std::back_inserter(side),
               [&](const IntegerPoint& point) { return dot(normal, point) > 0; });
  return side;
}

IntegerPoint quarter_turn(const IntegerPoint& flat) { return {-flat[1], flat[0], 0}; }

IntegerPoints polygon_around_origin(Integer norm, std::size_t first, std::size_t third, bool square) {
  const IntegerPoint a = at_raw_index(circle_points(norm), first);
  const IntegerPoint b = quarter_turn(a);
  const IntegerPoint opposite = times(-1, a);
  IntegerPoints between;
  for (const IntegerPoint& point : circle_points(norm)) {
    if (dot(point, a) < 0 && dot(point, b) < 0) {
      between.push_back(point);
    }
  }
  if (square || between.empty()) {
    return {a, b, opposite, times(-1, b)};
  }
  return {a, b, at_raw_index(between, third)};
}

}  // namespace flowcert::fuzz
