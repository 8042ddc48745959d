// The search over all subsets, the linear scan, and the judgement of a claim against FC-CRIT-05.
//
// The search finds every stationary point. x is stationary iff x is in conv C(x) (FC-CRIT-01). By Caratheodory's
// theorem, x then has positive barycentric coordinates in an affinely independent subset T of C(x) of at most four
// points. x is in aff T and equally far from all points of T, so it is the circumcentre of T.
#include "oracle/stationary_points.h"

#include <algorithm>
#include <functional>
#include <map>
#include <tuple>

namespace oracle {

namespace {

std::string text(const Point& x) { return std::string("(") + x[0].str() + ", " + x[1].str() + ", " + x[2].str() + ")"; }

std::string index_text(const StationaryPoint& x) {
  const std::string face = std::to_string(x.face_dimension), hull = std::to_string(x.hull_dimension);
  return x.is_critical() ? "critical of index " + hull : "regular stationary of kind (" + face + "," + hull + ")";
}

// FC-OUT-02: critical points by index, then regular stationary points by kind. Equal ones are ordered by contact.
bool output_order(const StationaryPoint& a, const StationaryPoint& b) {
  const auto key = [](const StationaryPoint& s) {
    return std::make_tuple(!s.is_critical(), s.face_dimension, s.hull_dimension);
  };
  return key(a) != key(b) ? key(a) < key(b) : a.contact < b.contact;
}

// FC-OUT-01: a list of class names, ascending.
std::optional<Fault> check_names(const PointSet& set, const std::vector<std::size_t>& contact) {
  if (contact.empty()) return Fault{"FC-OUT-01", "the claimed contact set is empty"};
  for (const std::size_t name : contact) {
    if (std::binary_search(set.names.begin(), set.names.end(), name)) continue;
    return Fault{"FC-IN-03", "contact names " + std::to_string(name) + ", which is no class of the input"};
  }
  if (std::adjacent_find(contact.begin(), contact.end(), std::greater_equal<>()) == contact.end()) {
    return std::nullopt;
  }
  return Fault{"FC-OUT-01", "the claimed contact set is not strictly ascending"};
}

// Checks FC-CRIT-05 (a) to (d) for the points at `places`. Their circumcentre is z, if they have one.
std::optional<Fault> check_contact(const PointSet& set, const Places& places, const Point& z) {
  const Rational radius = squared_distance(z, set.points[places[0]]);
  const auto describe = [&](std::size_t place) {
    return "point " + std::to_string(set.names[place]) + " is at squared distance " +
           squared_distance(z, set.points[place]).str() + " from " + text(z) + ", and the claimed point " +
           std::to_string(set.names[places[0]]) + " at " + radius.str();
  };
  for (const std::size_t place : places) {
    if (squared_distance(z, set.points[place]) != radius) {
      return Fault{"FC-CRIT-05 (a)", "the claimed contact set is on no sphere centred in its hull: " + describe(place)};
    }
  }
  const Places nearest = set.nearest_places(z);
  if (squared_distance(z, set.points[nearest[0]]) < radius) {
    return Fault{"FC-CRIT-05 (b)", "the sphere of the claimed contact set is not empty: " + describe(nearest[0])};
  }
  for (const std::size_t place : nearest) {
    if (!std::binary_search(places.begin(), places.end(), place)) {
      return Fault{"FC-CRIT-05 (c)", "the claimed contact set is not complete: " + describe(place)};
    }
  }
  if (!face_dimension(select(set.points, places), z)) {
    return Fault{"FC-CRIT-05 (d)", "the centre " + text(z) + " is outside the hull of the claimed contact set"};
  }
  return std::nullopt;
}

}  // namespace

std::size_t Answer::count(int face_dimension, int hull_dimension) const {
  return static_cast<std::size_t>(std::count_if(stationary.begin(), stationary.end(), [&](const StationaryPoint& s) {
    return s.face_dimension == face_dimension && s.hull_dimension == hull_dimension;
  }));
}

std::array<std::size_t, 4> Answer::critical_counts() const {
  return {count(0, 0), count(1, 1), count(2, 2), count(3, 3)};
}

std::array<std::size_t, 3> Answer::regular_counts() const { return {count(1, 2), count(1, 3), count(2, 3)}; }

StationaryPoint stationary_point(const PointSet& set, const Point& x, const Places& contact) {
  const std::vector<Point> points = select(set.points, contact);
  return {x, squared_distance(x, points[0]), select(set.names, contact), face_dimension(points, x).value(),
          affine_dimension(points)};
}

Answer stationary_points(const PointSet& set) {
  std::map<Places, Point> found;  // contact set -> stationary point (FC-CRIT-06)
  for_each_subset(set.points.size(), 4, [&](const Places& subset) {
    const auto center = set.inner_circumcentre(subset);
    if (!center) return;
    // The subset's points are equally far from the centre. So if one is nearest, all are, and no point is nearer.
    const Places nearest = set.nearest_places(*center);
    if (std::binary_search(nearest.begin(), nearest.end(), subset[0])) found.emplace(nearest, *center);
  });
  Answer answer{set.points.size() + set.merged_duplicates, set.merged_duplicates, {}};
  for (const auto& [contact, x] : found) answer.stationary.push_back(stationary_point(set, x, contact));
  std::sort(answer.stationary.begin(), answer.stationary.end(), output_order);
  return answer;
}

Answer stationary_points(const std::vector<std::array<double, 3>>& rows) { return stationary_points(PointSet(rows)); }

std::optional<Fault> certify(const PointSet& set, const StationaryPoint& claim) {
  if (auto fault = check_names(set, claim.contact)) return fault;
  const Places places = places_of(set, claim.contact);
  const std::vector<Point> contact = select(set.points, places);
  const Point z = circumcentre(spanning_subset(contact))->center;  // independent points always have one
  if (auto fault = check_contact(set, places, z)) return fault;

  const StationaryPoint truth = stationary_point(set, z, places);
  if (claim.center != z) {
    return Fault{"FC-OUT-01", "center is claimed to be " + text(claim.center) + ", and is " + text(z)};
  }
  if (claim.squared_distance != truth.squared_distance) {
    return Fault{"FC-OUT-01", "squared_distance is claimed to be " + claim.squared_distance.str() + ", and is " +
                                  truth.squared_distance.str()};
  }
  if (claim != truth) {
    return Fault{truth.is_critical() ? "FC-CRIT-02" : "FC-CRIT-03",
                 "claimed to be " + index_text(claim) + ", and is " + index_text(truth)};
  }
  return std::nullopt;
}

}  // namespace oracle
