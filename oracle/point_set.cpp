// Every question is a scan. A comment above each function says why it is right.
#include "oracle/point_set.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <stdexcept>
#include <string>

namespace oracle {

// Equal rows stand together when sorted, the least id first. -0.0 is not less than 0.0, nor greater (FC-IN-02).
PointSet::PointSet(const std::vector<std::array<double, 3>>& rows) : names(rows.size()) {
  for (std::size_t id = 0; id < rows.size(); ++id) {
    names[id] = id;
    if (std::all_of(rows[id].begin(), rows[id].end(), [](double x) { return std::isfinite(x); })) continue;
    throw std::invalid_argument("point " + std::to_string(id) + " has a coordinate that is not finite");
  }
  std::stable_sort(names.begin(), names.end(), [&](auto a, auto b) { return rows[a] < rows[b]; });
  const auto repeats = std::unique(names.begin(), names.end(), [&](auto a, auto b) { return rows[a] == rows[b]; });
  names.erase(repeats, names.end());
  std::sort(names.begin(), names.end());
  merged_duplicates = rows.size() - names.size();
  for (const std::size_t name : names) points.push_back(exact(rows[name]));
}

Places PointSet::nearest_places(const Point& x) const {
  Places nearest;
  Rational least;
  for (std::size_t place = 0; place < points.size(); ++place) {
    const Rational there = squared_distance(x, points[place]);
    if (nearest.empty() || there < least) {
      nearest.clear();
      least = there;
    }
    if (there == least) nearest.push_back(place);
  }
  return nearest;
}

// |x + t u - q|^2 - |x + t u - p|^2 = |x - q|^2 - |x - p|^2 - 2 t <u, q - p>. At t = 0 this is not negative, because
// p is in C(x). So q meets p iff <u, q - p> > 0, and then q is not in C(x).
std::optional<Rational> PointSet::first_meeting(std::size_t p, const Point& x, const Point& direction) const {
  std::optional<Rational> first;
  for (const Point& q : points) {
    const Rational approach = 2 * dot(direction, minus(q, points[p]));
    if (approach <= 0) continue;
    const Rational time = (squared_distance(x, q) - squared_distance(x, points[p])) / approach;
    if (!first || time < *first) first = time;
  }
  return first;
}

std::optional<Point> PointSet::inner_circumcentre(const Places& simplex) const {
  return oracle::inner_circumcentre(select(points, simplex));
}

Places places_of(const PointSet& set, const std::vector<std::size_t>& names) {
  Places places;
  for (const std::size_t name : names) {
    const auto found = std::lower_bound(set.names.begin(), set.names.end(), name);
    assert(found != set.names.end() && *found == name);
    places.push_back(static_cast<std::size_t>(found - set.names.begin()));
  }
  return places;
}

std::vector<std::size_t> contact_set(const PointSet& set, const Point& x) {
  return select(set.names, set.nearest_places(x));
}

// The nearest point lies in the relative interior of the simplex of some affinely independent points of C(x)
// (Caratheodory). It is the projection of x to the affine hull of that simplex. This is the simplex's circumcentre,
// because x is equally far from its points.
Point driver(const PointSet& set, const Places& contact, const Point& x) {
  std::optional<Point> nearest;
  for_each_subset(contact.size(), 4, [&](const Places& subset) {
    if (nearest == x) return;  // nothing is nearer
    const auto centre = set.inner_circumcentre(select(contact, subset));
    if (centre && (!nearest || squared_distance(x, *centre) < squared_distance(x, *nearest))) nearest = centre;
  });
  return nearest.value();
}

}  // namespace oracle
