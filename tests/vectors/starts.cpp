// Candidates come from the orbits of a few starts around the points: their ends are Voronoi vertices and
// points of Voronoi edges and facets, and their segments cross the others.
#include "tests/vectors/starts.h"

#include <algorithm>
#include <random>
#include <set>
#include <string>

#include "oracle/orbit.h"
#include "oracle/program/answer_fields.h"

namespace oracle::vectors {

namespace {

Point between(const Point& a, const Point& b, const Rational& part) { return moved(a, part, minus(b, a)); }

// The largest difference of a coordinate from the first point's, or 1 if there is no difference.
Rational extent(const PointSet& set) {
  Rational most = 0;
  for (const Point& p : set.points) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      most = std::max(most, Rational(abs(p[axis] - set.points.front()[axis])));
    }
  }
  if (most == 0) most = 1;
  return most;
}

class Candidates {
 public:
  Candidates(const PointSet& set, const Answer& answer, std::uint64_t seed) : set_(set), engine_(seed) {
    constexpr int kNearby = 12, kPairs = 6, kFar = 2;
    const Rational reach = extent(set);
    for (int k = 0; k < kNearby; ++k) add(offset_from(any_point(), reach / 16));
    for (int k = 0; k < kPairs; ++k) {
      const Point middle = between(any_point(), any_point(), Rational(1, 2));
      add(middle);
      add(between(any_point(), middle, Rational(1, 3)));
      add(between(any_point(), middle, Rational(2, 3)));
    }
    for (int k = 0; k < kFar; ++k) add(offset_from(any_point(), reach));
    add_from_orbits(answer);
    add_stationary(answer);
  }

  [[nodiscard]] const std::vector<Point>& all() const { return all_; }

 private:
  std::size_t below(std::size_t bound) { return static_cast<std::size_t>(engine_() % bound); }
  const Point& any_point() { return set_.points[below(set_.points.size())]; }
  void add(const Point& x) {
    if (std::find(all_.begin(), all_.end(), x) == all_.end()) all_.push_back(x);
  }

  Point offset_from(Point x, const Rational& step) {
    for (Rational& coordinate : x) coordinate += step * (static_cast<int>(below(13)) - 6);
    return x;
  }

  // A point on a way that goes on without end.
  static Point on_the_way(const FlowSegment& segment) {
    return between(segment.driver, segment.start, segment.start == segment.driver ? Rational(1) : Rational(3));
  }

  void add_segments(const Orbit& path, std::vector<Point>& vertices) {
    for (const FlowSegment& segment : path.segments) {
      if (!segment.end) {
        add(on_the_way(segment));
        continue;
      }
      add(between(segment.start, *segment.end, Rational(1, 3)));
      add(*segment.end);
      if (face_letter(set_, segment.end_contact) == 'V') vertices.push_back(*segment.end);
    }
  }

  void add_from_orbits(const Answer& answer) {
    constexpr std::size_t kSaddles = 4, kAverages = 8, kAims = 8;
    std::vector<Point> vertices;
    const std::vector<Point> starts = all_;
    for (const Point& start : starts) add_segments(orbit(set_, start), vertices);
    std::size_t saddles = 0;
    for (const StationaryPoint& x : answer.stationary) {
      if (x.face_dimension != 2 || x.hull_dimension != 2 || ++saddles > kSaddles) continue;
      for (const Orbit& path : unstable_orbits(set_, x)) add_segments(path, vertices);
    }
    for (std::size_t k = 0; k < kAims && !vertices.empty(); ++k) {
      add_aimed_at(vertices[below(vertices.size())]);
    }
    for (std::size_t k = 0; k < kAverages && !vertices.empty(); ++k) {
      const Point& a = vertices[below(vertices.size())];
      const Point& b = vertices[below(vertices.size())];
      add(between(a, b, Rational(1, 4)));
      add(between(between(a, b, Rational(1, 2)), vertices[below(vertices.size())], Rational(1, 3)));
    }
  }

  // Adds points on ways across facets to this Voronoi vertex: the place where such a way comes in, or a place
  // inside if the way begins at the middle of the two points.
  void add_aimed_at(const Point& vertex) {
    constexpr std::size_t kContacts = 4;
    const std::vector<std::size_t> contact = set_.nearest_places(vertex);
    for (std::size_t j = 1; j < std::min(contact.size(), kContacts); ++j) {
      for (std::size_t i = 0; i < j; ++i) {
        const Point& p = set_.points[contact[i]];
        const Point back = minus(between(p, set_.points[contact[j]], Rational(1, 2)), vertex);
        const Rational entrance = way_out(p, vertex, back);
        if (entrance <= 0) continue;
        add(moved(vertex, entrance < 1 ? entrance : Rational(1, 3), back));
      }
    }
  }

  // The largest t up to 1 such that, for all s up to t, no point is nearer to x + s u than p.
  [[nodiscard]] Rational way_out(const Point& p, const Point& x, const Point& u) const {
    Rational least = 1;
    for (const Point& q : set_.points) {
      const Rational approach = 2 * dot(u, minus(q, p));
      if (approach <= 0) continue;
      const Rational lead = squared_distance(x, q) - squared_distance(x, p);
      least = std::min(least, Rational(lead / approach));
    }
    return least;
  }

  // Adds the first stationary point of each kind.
  void add_stationary(const Answer& answer) {
    std::set<std::pair<int, int>> kinds;
    for (const StationaryPoint& x : answer.stationary) {
      if (kinds.emplace(x.face_dimension, x.hull_dimension).second) add(x.center);
    }
  }

  const PointSet& set_;
  std::mt19937_64 engine_;
  std::vector<Point> all_;
};

std::string kind_text(const std::optional<StationaryPoint>& x) {
  if (!x) return "infinity";
  return std::to_string(x->face_dimension) + std::to_string(x->hull_dimension);
}

// What an orbit shows.
std::set<std::string> features_of(const PointSet& set, const Point& start, const Orbit& path) {
  std::set<std::string> features;
  if (path.segments.empty()) {
    features.insert("stays at " + kind_text(path.limit));
    return features;
  }
  features.insert(std::string("from ") + face_letter(set, contact_set(set, start)));
  features.insert("to " + kind_text(path.limit));
  for (const FlowSegment& segment : path.segments) {
    features.insert(segment_type(set, segment));
    if (&segment != &path.segments.front() && face_letter(set, segment.start_contact) == 'V') {
      features.insert("through a vertex");
    }
  }
  if (path.segments.size() > 4) features.insert("long");
  return features;
}

struct Offer {
  Point start;
  std::set<std::string> features;
  std::size_t length = 0;  // of the text; the shorter of two equal offers is taken
};

std::size_t novelty(const Offer& offer, const std::set<std::string>& seen) {
  return static_cast<std::size_t>(std::count_if(offer.features.begin(), offer.features.end(),
                                                [&](const auto& feature) { return !seen.contains(feature); }));
}

}  // namespace

std::vector<Point> chosen_starts(const PointSet& set, const Answer& answer, std::size_t count, std::uint64_t seed) {
  if (set.points.empty()) return {};
  std::vector<Offer> offers;
  const Candidates candidates(set, answer, seed);
  for (const Point& start : candidates.all()) {
    const Orbit path = orbit(set, start);
    offers.push_back({start, features_of(set, start, path), orbit_field(set, start, path).dump().size()});
  }
  std::vector<Point> starts;
  std::set<std::string> seen;
  while (starts.size() < count && !offers.empty()) {
    const auto best = std::max_element(offers.begin(), offers.end(), [&](const Offer& a, const Offer& b) {
      const std::size_t new_in_a = novelty(a, seen), new_in_b = novelty(b, seen);
      return new_in_a != new_in_b ? new_in_a < new_in_b : a.length > b.length;
    });
    if (novelty(*best, seen) == 0) break;
    starts.push_back(best->start);
    seen.insert(best->features.begin(), best->features.end());
    offers.erase(best);
  }
  return starts;
}

}  // namespace oracle::vectors
