// Claims made of the truth: all that can be claimed of stable sets, polylines, incidences, directions and volumes.
//
// Guarantees: exact, and so right. Point k is record k. The points' lines follow each other from a first one on.
#pragma once

#include <cstddef>
#include <map>
#include <vector>

#include "certify/boundaries.h"
#include "certify/truth.h"

namespace flowcert {

using namespace certify;

inline ClaimedNumber number(const Rational& value) { return {value, true}; }
inline ClaimedPosition exactly(const RationalPoint& x) { return {number(x[0]), number(x[1]), number(x[2])}; }

inline std::vector<PointId> contact_of(const Truth& truth, std::size_t i) {
  const auto names = truth.contact(i);
  return {names.begin(), names.end()};
}

inline ClaimedPolyline polyline_of(const std::vector<TrueSegment>& truth) {
  ClaimedPolyline line;
  for (const TrueSegment& segment : truth) {
    line.push_back({segment.type, exactly(segment.driver), std::nullopt});
    if (segment.end) line.back().end = exactly(*segment.end);
  }
  return line;
}

// ---- Pieces ----

inline Corner<ClaimedPosition> claimed(const Corner<>& corner) {
  return {exactly(corner.position), corner.at_infinity};
}
inline EdgePart<ClaimedPosition> claimed(const EdgePart<>& part) {
  return {part.polygon, claimed(part.front), claimed(part.back)};
}
inline Crossing<ClaimedPosition> claimed(const Crossing<>& crossing) {
  return {crossing.samples, claimed(crossing.front), claimed(crossing.back)};
}
inline Region<ClaimedPosition> claimed(const Region<>& region) {
  Region<ClaimedPosition> made{region.samples, {}};
  for (const Corner<>& corner : region.corners) made.corners.push_back(claimed(corner));
  return made;
}
inline BackwardInterval<ClaimedPosition> claimed(const BackwardInterval<>& interval) {
  return {claimed(static_cast<const EdgePart<>&>(interval)), interval.back_is_stationary};
}
inline BackwardSegment<ClaimedPosition> claimed(const BackwardSegment<>& segment) {
  BackwardSegment<ClaimedPosition> made{
      claimed(static_cast<const Crossing<>&>(segment)), {}, segment.back_contact, segment.back_kind};
  if (!segment.front.at_infinity) made.front_contact = segment.front_contact;
  return made;
}
template <class Piece>
auto claimed(const std::vector<Piece>& pieces) {
  std::vector<decltype(claimed(pieces.front()))> made;
  for (const Piece& piece : pieces) made.push_back(claimed(piece));
  return made;
}

inline StableSet<ClaimedPosition> skeleton_of(const StableSet<>& set) {
  return {claimed(set.segments), claimed(set.intervals), claimed(set.sectors)};
}

inline ClaimedSurface surface_of(const PointSet& points, const StableSet<>& set) {
  ClaimedSurface surface;
  for (const BackwardSegment<>& s : set.segments) {
    for (const PointId name : s.samples) {
      const std::size_t first = surface.vertices.size();
      surface.vertices.push_back(exactly(exact_sphere(points, std::vector<PointId>{name}).center));
      surface.vertices.push_back(exactly(s.front.position));
      surface.vertices.push_back(exactly(s.back.position));
      surface.triangles.push_back({first, first + 1, first + 2});
    }
  }
  return surface;
}

inline ClaimedInfinity infinity_of(const StableSet<>& set) {
  ClaimedInfinity infinity;
  const auto part = [](auto& bounded, auto& unbounded, const auto& pieces) {
    for (const auto& piece : pieces) (is_unbounded(piece) ? unbounded : bounded).push_back(claimed(piece));
  };
  part(infinity.bounded.segments, infinity.unbounded.segments, set.segments);
  part(infinity.bounded.intervals, infinity.unbounded.intervals, set.intervals);
  part(infinity.bounded.sectors, infinity.unbounded.sectors, set.sectors);
  return infinity;
}

// A claim of all stationary points by their contact sets, with all that can be claimed of stable sets. Point
// k is record k.
inline Claim stable_claim(const PointSet& points, Truth& truth, std::size_t first_line) {
  Claim claim;
  claim.format = "exchange";
  std::map<std::vector<PointId>, std::vector<ClaimedTarget>> saddles;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const StationaryIndex index = truth.index(i);
    ClaimedPoint point;
    point.line = first_line + i;
    point.index = index.face_dimension;
    if (!index.is_critical()) point.hull_dimension = index.hull_dimension;
    point.contact = contact_of(truth, i);
    if (index == StationaryIndex{2, 2} || !index.is_critical()) {
      const StableSet<> set = truth.stable_set(i);
      const StableSummary summary = truth.stable_summary(i);
      point.stable = ClaimedStable{summary.segments, summary.has_vertex, summary.has_interval, {}, {}};
      point.stable->walk = boundary_walk(set, index, point.contact);
      point.skeleton = skeleton_of(set);
      if (index.is_critical()) point.orbits = connecting_orbits(set, truth.sphere(i).center);
      if (set.intervals.empty()) point.surface = surface_of(points, set);
      if (index.is_critical()) {
        point.stable->boundary.emplace();
        const auto boundary = truth.boundary(i);
        for (const std::uint32_t record : *boundary) {
          point.stable->boundary->push_back(contact_of(truth, record));
        }
        for (const BackwardSegment<>& s : set.segments) {
          if (s.back_kind == BackKind::kCritical) saddles[s.back_contact].push_back({false, point.contact});
        }
      }
    }
    claim.points.push_back(std::move(point));
  }
  for (ClaimedPoint& point : claim.points) {
    if (point.index == 1 && !point.hull_dimension) point.successors = saddles[point.contact];
  }
  return claim;
}

// stable_claim(), with the limits and polylines of the index-2 points and the samples of the index-1 points.
inline Claim true_claim(const PointSet& points, Truth& truth) {
  Claim claim = stable_claim(points, truth, 1);
  for (std::size_t i = 0; i < truth.size(); ++i) {
    ClaimedPoint& point = claim.points[i];
    if (truth.index(i) == StationaryIndex{1, 1}) point.samples = point.contact;
    if (truth.index(i) != StationaryIndex{2, 2}) continue;
    point.successors.emplace();
    point.u2.emplace();
    for (std::size_t side = 0; side < 2; ++side) {
      const auto limit = truth.limits(i).at(side);
      point.successors->push_back(limit ? ClaimedTarget{false, contact_of(truth, *limit)} : ClaimedTarget{true, {}});
      point.u2->push_back(polyline_of(truth.polyline(i, side)));
    }
    point.successors_by_side = true;
  }
  return claim;
}

inline ClaimedTarget target_of(const Truth& truth, const std::optional<std::size_t>& limit) {
  return limit ? ClaimedTarget{false, contact_of(truth, *limit)} : ClaimedTarget{true, {}};
}

inline std::optional<ClaimedNumber> rounded_number(const Rational& value) {
  const std::optional<double> nearest = nearest_double(value);
  return nearest ? std::optional(ClaimedNumber{Rational(*nearest), false}) : std::nullopt;
}

inline ClaimedLambdaList lambda_of(const Truth& truth, const LambdaList& list) {
  ClaimedLambdaList claimed;
  for (const LambdaList::Direction& one : list.directions) {
    claimed.directions.push_back({target_of(truth, one.limit), exactly(one.exit), one.is_vector, {}});
    auto& rounded = claimed.directions.back().rounded_exit.emplace();
    for (std::size_t axis = 0; axis < 3; ++axis) rounded.at(axis) = rounded_number(one.exit.at(axis));
  }
  for (const auto& arc : list.arcs) claimed.arcs.push_back(target_of(truth, arc));
  return claimed;
}

inline UnstableSurface<ClaimedPosition> unstable_surface_of(const UnstableSurface<>& surface) {
  UnstableSurface<ClaimedPosition> made{
      {}, claimed(surface.traces), claimed(surface.runs), claimed(surface.sheets), claimed(surface.segments)};
  for (const RationalPoint& vertex : surface.vertices) made.vertices.push_back(exactly(vertex));
  return made;
}

// Adds all that can be claimed of unstable sets of dimension 2. Point k must be record k.
inline void add_unstable_sets(Claim& claim, Truth& truth) {
  for (std::size_t i = 0; i < truth.size(); ++i) {
    if (truth.index(i).face_dimension == 1) claim.points[i].u1 = unstable_surface_of(truth.unstable_surface(i));
  }
}

// Adds all that can be claimed of directions, connections and volumes. Point k must be record k.
inline void add_directions_and_volumes(Claim& claim, Truth& truth) {
  claim.morse_smale = truth.is_morse_smale();
  claim.hull_volume = number(truth.hull_volume());
  for (std::size_t i = 0; i < truth.size(); ++i) {
    ClaimedPoint& point = claim.points[i];
    point.volume = number(truth.volume(i));
    point.rounded_volume = rounded_number(truth.volume(i));
    point.has_rounded_volume = true;
    if (point.volume->value > 0) point.shares.emplace();
    for (const auto& [name, share] : truth.shares(i)) point.shares->push_back({name, number(share)});
    const std::uint8_t face_dimension = truth.index(i).face_dimension;
    if (face_dimension != 1 && face_dimension != 2) continue;
    point.lambda = lambda_of(truth, truth.lambda_list(i));
    point.connections.emplace();
    for (const Connection& one : truth.connections(i)) {
      const auto to = one.to == Connection::kInfinity ? std::optional<std::size_t>() : one.to;
      point.connections->push_back({target_of(truth, to), one.orbits, one.families});
    }
  }
}

}  // namespace flowcert
