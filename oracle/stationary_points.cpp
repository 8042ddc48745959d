// The search over all subsets, the linear scan, and the judgement of a claim against FC-CRIT-05.
//
// Why the search finds every stationary point: x is stationary iff x is in conv C(x) (FC-CRIT-01). Then, by
// Caratheodory's theorem, x has positive barycentric coordinates in an affinely independent T, a subset of
// C(x) of at most four points. As x is in aff T and at the same distance from all points of T, it is the
// circumcentre of T.
#include "oracle/stationary_points.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <stdexcept>
#include <tuple>

namespace oracle {

namespace {

std::string text(const Point& x) {
  return std::string("(") + x[0].str() + ", " + x[1].str() + ", " + x[2].str() + ")";
}

std::string index_text(int face, int hull) {
  if (face == hull) return "critical of index " + std::to_string(hull);
  return "regular stationary of kind (" + std::to_string(face) + "," + std::to_string(hull) + ")";
}

// FC-OUT-02: critical points by index, then regular stationary ones by kind; each by contact.
bool output_order(const StationaryPoint& a, const StationaryPoint& b) {
  const auto key = [](const StationaryPoint& s) {
    return std::make_tuple(s.face_dimension != s.hull_dimension, s.face_dimension, s.hull_dimension);
  };
  return key(a) != key(b) ? key(a) < key(b) : a.contact < b.contact;
}

}  // namespace

PointSet::PointSet(const std::vector<std::array<double, 3>>& rows) {
  std::set<std::array<double, 3>> seen;  // compares -0.0 and 0.0 as equal, which is FC-IN-02
  for (std::size_t id = 0; id < rows.size(); ++id) {
    for (const double coordinate : rows[id]) {
      if (!std::isfinite(coordinate)) {
        throw std::invalid_argument("point " + std::to_string(id) + " has a coordinate that is not finite");
      }
    }
    if (!seen.insert(rows[id]).second) {
      ++merged_duplicates;
      continue;
    }
    points.push_back(exact(rows[id]));
    names.push_back(id);
    // The denominators are powers of two, so the greatest is a common one.
    for (const Rational& coordinate : points.back())
      scale = std::max(scale, Integer(denominator(coordinate)));
  }
  for (const Point& point : points) {
    std::array<Integer, 4> row;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      row[axis] = scale / denominator(point[axis]);
      row[axis] *= numerator(point[axis]);
      row[3] += row[axis] * row[axis];
    }
    lifted.push_back(row);
  }
}

std::vector<std::size_t> places_of(const PointSet& set, const std::vector<std::size_t>& names) {
  std::vector<std::size_t> places;
  for (const std::size_t name : names) {
    const auto position = std::lower_bound(set.names.begin(), set.names.end(), name);
    places.push_back(static_cast<std::size_t>(position - set.names.begin()));
  }
  return places;
}

Integer value(const Form& form, const std::array<Integer, 4>& lifted) {
  Integer sum;
  for (std::size_t k = 0; k < 4; ++k) {
    mpz_addmul(sum.backend().data(), form[k].backend().data(), lifted[k].backend().data());
  }
  return sum;
}

// |p - x|^2 - |x|^2 is |p|^2 - 2 <p, x>, linear in p and |p|^2.
Form distance_form(const PointSet& set, const Point& x) {
  Form form;
  form[3] = 1;
  for (const Rational& coordinate : x) form[3] = lcm(form[3], Integer(denominator(coordinate)));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    form[axis] = form[3] / denominator(x[axis]);
    form[axis] *= -2 * set.scale;
    form[axis] *= numerator(x[axis]);
  }
  return form;
}

std::vector<std::size_t> nearest_places(const PointSet& set, const Point& x) {
  const Form distance = distance_form(set, x);
  std::vector<std::size_t> nearest;
  Integer least;
  for (std::size_t place = 0; place < set.lifted.size(); ++place) {
    const Integer there = value(distance, set.lifted[place]);
    if (nearest.empty() || there < least) {
      nearest.clear();
      least = there;
    }
    if (there == least) nearest.push_back(place);
  }
  return nearest;
}

std::vector<std::size_t> contact_set(const PointSet& set, const Point& x) {
  return select(set.names, nearest_places(set, x));
}

std::size_t Answer::count(int face_dimension, int hull_dimension) const {
  return static_cast<std::size_t>(
      std::count_if(stationary.begin(), stationary.end(), [&](const StationaryPoint& s) {
        return s.face_dimension == face_dimension && s.hull_dimension == hull_dimension;
      }));
}

std::array<std::size_t, 4> Answer::critical_counts() const {
  return {count(0, 0), count(1, 1), count(2, 2), count(3, 3)};
}

std::array<std::size_t, 3> Answer::regular_counts() const { return {count(1, 2), count(2, 3), count(1, 3)}; }

Answer stationary_points(const std::vector<std::array<double, 3>>& rows) {
  const PointSet set(rows);
  std::map<std::vector<std::size_t>, Point>
      found;  // contact set (as places) -> stationary point (FC-CRIT-06)
  for_each_subset(set.points.size(), 4, [&](const std::vector<std::size_t>& subset) {
    const auto center = inner_circumcentre(select(set.points, subset));
    if (!center) return;
    // The subset is at one distance from the centre: if one of it is nearest, all are, and no point is
    // nearer.
    const auto nearest = nearest_places(set, *center);
    if (std::binary_search(nearest.begin(), nearest.end(), subset[0])) found.emplace(nearest, *center);
  });

  Answer answer{rows.size(), set.merged_duplicates, {}};
  for (const auto& [places, center] : found) {
    const std::vector<Point> contact = select(set.points, places);
    StationaryPoint& x = answer.stationary.emplace_back();
    x.center = center;
    x.squared_distance = squared_distance(center, contact[0]);
    x.contact = select(set.names, places);
    x.face_dimension = face_dimension(contact, center).value();
    x.hull_dimension = affine_dimension(contact);
  }
  std::sort(answer.stationary.begin(), answer.stationary.end(), output_order);
  return answer;
}

namespace {

// FC-OUT-01: a list of class names, ascending. Fills in where in `points` they are.
std::optional<Finding> check_names(const PointSet& set, const std::vector<std::size_t>& contact,
                                   std::vector<std::size_t>& places) {
  if (contact.empty()) return Finding{"FC-OUT-01", "the claimed contact set is empty"};
  for (const std::size_t name : contact) {
    const auto position = std::lower_bound(set.names.begin(), set.names.end(), name);
    if (position == set.names.end() || *position != name) {
      return Finding{"FC-IN-03",
                     "contact names " + std::to_string(name) + ", which is no class of the input"};
    }
    places.push_back(static_cast<std::size_t>(position - set.names.begin()));
  }
  if (std::adjacent_find(contact.begin(), contact.end(), std::greater_equal<>()) != contact.end()) {
    return Finding{"FC-OUT-01", "the claimed contact set is not strictly ascending"};
  }
  return std::nullopt;
}

// FC-CRIT-05 (a) to (d) for the set of the points at `places`, whose circumcentre is z if it has one.
std::optional<Finding> check_contact(const PointSet& set, const std::vector<std::size_t>& places,
                                     const Point& z) {
  const Rational radius = squared_distance(z, set.points[places[0]]);
  const auto describe = [&](std::size_t place) {
    return "point " + std::to_string(set.names[place]) + " is at squared distance " +
           squared_distance(z, set.points[place]).str() + " from " + text(z) + ", and the claimed point " +
           std::to_string(set.names[places[0]]) + " at " + radius.str();
  };
  for (const std::size_t place : places) {
    if (squared_distance(z, set.points[place]) != radius) {
      return Finding{"FC-CRIT-05 (a)",
                     "the claimed contact set is on no sphere centred in its hull: " + describe(place)};
    }
  }
  const auto nearest = nearest_places(set, z);
  if (squared_distance(z, set.points[nearest[0]]) < radius) {
    return Finding{"FC-CRIT-05 (b)",
                   "the sphere of the claimed contact set is not empty: " + describe(nearest[0])};
  }
  for (const std::size_t place : nearest) {
    if (!std::binary_search(places.begin(), places.end(), place)) {
      return Finding{"FC-CRIT-05 (c)", "the claimed contact set is not complete: " + describe(place)};
    }
  }
  if (!face_dimension(select(set.points, places), z)) {
    return Finding{"FC-CRIT-05 (d)",
                   "the centre " + text(z) + " is outside the hull of the claimed contact set"};
  }
  return std::nullopt;
}

}  // namespace

std::optional<Finding> certify(const PointSet& set, const StationaryPoint& claim) {
  std::vector<std::size_t> places;
  if (const auto finding = check_names(set, claim.contact, places)) return finding;
  const std::vector<Point> contact = select(set.points, places);
  const Point z = circumcentre(spanning_subset(contact))->center;  // independent points always have one
  if (const auto finding = check_contact(set, places, z)) return finding;

  if (claim.center != z) {
    return Finding{"FC-OUT-01", "center is claimed to be " + text(claim.center) + ", and is " + text(z)};
  }
  const Rational radius = squared_distance(z, contact[0]);
  if (claim.squared_distance != radius) {
    return Finding{"FC-OUT-01", "squared_distance is claimed to be " + claim.squared_distance.str() +
                                    ", and is " + radius.str()};
  }
  const int face = face_dimension(contact, z).value();
  const int hull = affine_dimension(contact);
  if (claim.face_dimension != face || claim.hull_dimension != hull) {
    return Finding{face == hull ? "FC-CRIT-02" : "FC-CRIT-03",
                   "claimed to be " + index_text(claim.face_dimension, claim.hull_dimension) + ", and is " +
                       index_text(face, hull)};
  }
  return std::nullopt;
}

}  // namespace oracle
