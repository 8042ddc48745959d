// The union of the open balls grown by s has the homology of their nerve. Sets of balls are sorted by the s at which
// they enter, a set after its subsets. Columns of quadruples, each the sum of its triples, are reduced from left to
// right: a triple at which one ends is a birth, and the quadruple its death.
#include "oracle/ball_nerve.h"

#include <algorithm>
#include <map>
#include <stdexcept>

#include "oracle/persistence.h"

namespace oracle {

namespace {

std::vector<Places> subsets_without_one(const Places& set) {
  std::vector<Places> subsets;
  for (std::size_t i = 0; i < set.size() && set.size() > 1; ++i) {
    subsets.push_back(set);
    subsets.back().erase(subsets.back().begin() + static_cast<std::ptrdiff_t>(i));
  }
  return subsets;
}

bool is_reached(const Ball& ball, const Touching& x) {
  return (x.s + ball.radius).sign() >= 0 && power(ball, x.position, x.s).sign() <= 0;
}

// The first common point of each set of at most four balls. If that of a subset is in the ball that the subset lacks,
// it is also that of the whole set. If no subset's is, every ball is needed. Then the point touches all of them, inside
// of the centres' simplex.
std::map<Places, Touching> first_common_points(const std::vector<Ball>& balls) {
  std::map<Places, Touching> points;
  const auto point_of = [&](const Places& set) -> Touching {
    for (const Places& subset : subsets_without_one(set)) {
      const Touching& x = points.at(subset);
      if (std::all_of(set.begin(), set.end(), [&](std::size_t ball) { return is_reached(balls[ball], x); })) return x;
    }
    const auto touching = touching_inside(select(balls, set));
    if (!touching)
      throw std::logic_error("balls that are all needed, and have no common point inside of their simplex");
    return *touching;
  };
  for (std::size_t size = 1; size <= 4; ++size) {  // subsets first
    for_each_subset(balls.size(), size, [&](const Places& set) {
      if (set.size() == size) points.emplace(set, point_of(set));
    });
  }
  return points;
}

struct Entry {
  Quadratic s;
  Places set;
};

std::vector<Entry> filtration(const std::vector<Ball>& balls) {
  std::vector<Entry> entries;
  for (const auto& [set, point] : first_common_points(balls)) entries.push_back({point.s, set});
  std::sort(entries.begin(), entries.end(), [](const Entry& one, const Entry& other) {
    const auto order = one.s <=> other.s;
    if (order != 0) return order < 0;
    if (one.set.size() != other.set.size()) return one.set.size() < other.set.size();
    return one.set < other.set;
  });
  return entries;
}

}  // namespace

bool operator<(const Cavity& one, const Cavity& other) {
  if (one.peak != other.peak) return one.peak > other.peak;
  return one.gate && (!other.gate || *one.gate > *other.gate);
}

std::vector<Cavity> cavities_by_homology(const std::vector<Ball>& balls) {
  const std::vector<Entry> entries = filtration(balls);
  std::map<Places, std::size_t> place_of;
  std::map<std::size_t, Column> reduced;  // by their last places
  std::vector<Cavity> cavities;
  for (std::size_t place = 0; place < entries.size(); ++place) {
    const auto& [s, set] = entries[place];
    place_of[set] = place;
    if (set.size() < 4) continue;
    Column column;
    for (const Places& triple : subsets_without_one(set)) column.push_back(place_of.at(triple));
    std::sort(column.begin(), column.end());
    while (!column.empty() && reduced.contains(column.back())) column = sum_mod_2(column, reduced[column.back()]);
    if (column.empty()) continue;
    const Quadratic& birth = entries[column.back()].s;
    reduced[column.back()] = column;
    if (birth == s || s.sign() < 0) continue;
    cavities.push_back({birth.sign() < 0 ? std::nullopt : std::optional(birth), s});
  }
  std::sort(cavities.begin(), cavities.end());
  return cavities;
}

}  // namespace oracle
