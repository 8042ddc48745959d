// Compares segment by segment, and puts the first difference into words.
#include "certify/orbit_difference.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "certify/finding_words.h"
#include "certify/leaving_segment.h"
#include "certify/truth.h"
#include "geometry/floating_point.h"
#include "geometry/nearest_samples.h"

namespace flowcert {

using namespace certify;

namespace {

using Contact = std::optional<std::vector<PointId>>;

// A message shows at most this many characters of a number.
constexpr std::size_t kLongest = 40;

// ---- In words

std::string number_words(const Rational& value) { return shortened(to_text(value), kLongest); }

std::string position_words(const std::optional<RationalPoint>& position) {
  if (!position) return "infinity";
  return fmt::format("({}, {}, {})", number_words((*position)[0]), number_words((*position)[1]),
                     number_words((*position)[2]));
}

std::string contact_words(const Contact& contact) {
  return contact ? fmt::format("contact set {}", fmt::join(*contact, " ")) : "no contact set";
}

std::string limit_words(const std::optional<PathLimit>& limit) {
  if (!limit) return "infinity";
  return fmt::format("{} point of index {} at {}", shortened(limit->kind, kLongest), shortened(limit->index, kLongest),
                     position_words(limit->position));
}

PathDifference wrong(std::size_t k, const std::string& claimed, const std::string& truth) {
  return {false, fmt::format("segment {}: {}", k + 1, claimed), truth};
}

// ---- Comparing

std::optional<PathDifference> contact_difference(std::size_t k, const char* what, const Contact& claimed,
                                                 const Contact& truth) {
  if (!claimed || claimed == truth) return std::nullopt;
  return wrong(k, fmt::format("{}, {}", what, contact_words(claimed)), contact_words(truth));
}

// All but the type and the contact set of the end.
std::optional<PathDifference> inner_difference(std::size_t k, const PathSegment& claimed, const PathSegment& truth) {
  if (claimed.driver != truth.driver) {
    return wrong(k, "driver " + position_words(claimed.driver), position_words(truth.driver));
  }
  if (claimed.end != truth.end) return wrong(k, "end " + position_words(claimed.end), position_words(truth.end));
  auto found = contact_difference(k, "start", claimed.start_contact, truth.start_contact);
  return found ? found : contact_difference(k, "on the way", claimed.crossed_contact, truth.crossed_contact);
}

std::optional<PathDifference> type_difference(std::size_t k, const PathSegment& claimed, const std::string& truth) {
  if (claimed.type == truth) return std::nullopt;
  return wrong(k, "type " + shortened(claimed.type, kLongest), truth);
}

std::optional<PathDifference> segment_difference(std::size_t k, const PathSegment& claimed, const PathSegment& truth) {
  auto found = type_difference(k, claimed, truth.type);
  if (!found) found = inner_difference(k, claimed, truth);
  return found ? found : contact_difference(k, "end", claimed.end_contact, truth.end_contact);
}

// A perturbation leaves some of C(y) together, with all that the segment crosses.
std::optional<PathDifference> arrival_difference(std::size_t k, const PathSegment& claimed, const PathSegment& truth) {
  if (!can_arrive_as(claimed.type, truth.type)) return type_difference(k, claimed, truth.type);
  auto found = inner_difference(k, claimed, truth);
  if (found || !claimed.end_contact) return found;
  const bool is_part = !truth.end_contact || std::ranges::includes(*truth.end_contact, *claimed.end_contact);
  const bool has_crossed =
      !truth.crossed_contact || std::ranges::includes(*claimed.end_contact, *truth.crossed_contact);
  if (is_part && has_crossed) return std::nullopt;
  return contact_difference(k, "end", claimed.end_contact, truth.end_contact);
}

std::optional<PathDifference> limit_difference(const std::optional<PathLimit>& claimed,
                                               const std::optional<PathLimit>& truth) {
  if (!claimed && !truth) return std::nullopt;
  const bool is_same_point = claimed && truth && claimed->kind == truth->kind && claimed->index == truth->index &&
                             claimed->position == truth->position;
  if (!is_same_point) return PathDifference{false, "limit " + limit_words(claimed), limit_words(truth)};
  if (claimed->contact != truth->contact) {
    return PathDifference{false, "limit, " + contact_words(claimed->contact), contact_words(truth->contact)};
  }
  if (claimed->squared_distance != truth->squared_distance) {
    return PathDifference{false, "limit, squared distance " + number_words(claimed->squared_distance),
                          number_words(truth->squared_distance)};
  }
  return std::nullopt;
}

PathDifference length_difference(std::size_t claimed, std::size_t truth) {
  return {false, fmt::format("{} segments", claimed), fmt::format("{}", truth)};
}

std::optional<PathDifference> strict_difference(const OrbitPath& claimed, const OrbitPath& truth) {
  const std::size_t count = truth.segments.size();
  for (std::size_t k = 0; k < std::min(claimed.segments.size(), count); ++k) {
    auto found = segment_difference(k, claimed.segments[k], truth.segments[k]);
    if (found) return found;
  }
  if (claimed.segments.size() != count) return length_difference(claimed.segments.size(), count);
  return limit_difference(claimed.limit, truth.limit);
}

// ---- Beyond a regular stationary point

bool is_regular(const std::optional<PathLimit>& limit) { return limit && limit->kind == "regular"; }

// Judges an orbit that may go on beyond regular stationary points.
class PerturbedOrbit {
 public:
  PerturbedOrbit(const OrbitPath& claimed, const PointSet& points, Truth& flow)
      : claimed_(claimed), points_(points), flow_(flow) {}

  // The first difference that no perturbation explains.
  std::optional<PathDifference> difference(OrbitPath truth) {
    while (true) {
      auto found = take(truth);
      if (found) return found;
      if (done_ == claimed_.segments.size()) return limit_difference(claimed_.limit, truth.limit);
      if (!is_regular(truth.limit)) return length_difference(claimed_.segments.size(), done_);
      if (!claimed_.segments[done_].end) return difference_to_infinity(*truth.limit);
      const auto beyond = path_beyond(*truth.limit);
      if (!beyond) {
        return wrong(done_, "end " + position_words(claimed_.segments[done_].end),
                     "no perturbation lets the orbit go there from " + position_words(truth.limit->position));
      }
      truth = *beyond;
    }
  }

 private:
  // Takes the segments of a path from the claim.
  std::optional<PathDifference> take(const OrbitPath& truth) {
    for (std::size_t k = 0; k < truth.segments.size(); ++k) {
      if (done_ == claimed_.segments.size()) return length_difference(done_, done_ + truth.segments.size() - k);
      const PathSegment& claimed = claimed_.segments[done_];
      const bool is_arrival = k + 1 == truth.segments.size() && is_regular(truth.limit);
      auto found = is_arrival ? arrival_difference(done_, claimed, truth.segments[k])
                              : segment_difference(done_, claimed, truth.segments[k]);
      if (found) return found;
      ++done_;
    }
    return std::nullopt;
  }

  // The next claimed segment, from y on, and the orbit of its end. Nothing if the flow cannot go there.
  std::optional<OrbitPath> path_beyond(const PathLimit& y) {
    const RationalPoint& end = *claimed_.segments[done_].end;
    const LeavingSegment leaving(points_, y.contact, y.position, end);
    if (!leaving.is_flow()) return std::nullopt;
    OrbitPath path{{{leaving.type(), y.position, end, y.contact, leaving.crossed(), leaving.at_end()}}, std::nullopt};
    const TruePath further = flow_.orbit(end);
    RationalPoint start = end;
    for (const TrueSegment& segment : further.segments) {
      path.segments.push_back(with_contacts(start, segment));
      if (segment.end) start = *segment.end;
    }
    if (further.limit) path.limit = limit_at(*further.limit);
    return path;
  }

  // Infinity gives no direction.
  std::optional<PathDifference> difference_to_infinity(const PathLimit& y) {
    const PathSegment& claimed = claimed_.segments[done_];
    const char first = face_letter(points_, y.contact);
    if (!is_segment_type(claimed.type) || !claimed.type.starts_with(first) || !claimed.type.ends_with("inf")) {
      return type_difference(done_, claimed, fmt::format("{} to infinity", first));
    }
    const PathSegment truth{claimed.type, y.position, std::nullopt, y.contact, claimed.crossed_contact, std::nullopt};
    auto found = segment_difference(done_, claimed, truth);
    if (found) return found;
    ++done_;
    if (done_ != claimed_.segments.size()) return length_difference(claimed_.segments.size(), done_);
    return limit_difference(claimed_.limit, std::nullopt);
  }

  [[nodiscard]] PathSegment with_contacts(const RationalPoint& start, const TrueSegment& segment) const {
    RationalPoint inside;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      inside[axis] = segment.end ? (start[axis] + (*segment.end)[axis]) / 2 : 2 * start[axis] - segment.driver[axis];
    }
    PathSegment all{segment.type, segment.driver, segment.end, contact_of(start), contact_of(inside), std::nullopt};
    if (segment.end) all.end_contact = contact_of(*segment.end);
    return all;
  }
  [[nodiscard]] std::vector<PointId> contact_of(const RationalPoint& x) const {
    return nearest_samples(points_, x).names;
  }

  [[nodiscard]] PathLimit limit_at(std::size_t record) const {
    const StationaryIndex index = flow_.index(record);
    const ExactSphere sphere = flow_.sphere(record);
    const auto contact = flow_.contact(record);
    return {index.is_critical() ? "critical" : "regular",
            index.is_critical() ? fmt::format("{}", index.face_dimension)
                                : fmt::format("[{},{}]", index.face_dimension, index.hull_dimension),
            sphere.center,
            {contact.begin(), contact.end()},
            sphere.squared_radius};
  }

  const OrbitPath& claimed_;
  const PointSet& points_;
  Truth& flow_;
  std::size_t done_ = 0;  // so many of the claimed segments
};

}  // namespace

std::optional<PathDifference> path_difference(const OrbitPath& claimed, const OrbitPath& truth, const PointSet& points,
                                              Truth& flow) {
  const geometry::IeeeDoubles ieee;
  std::optional<PathDifference> difference = strict_difference(claimed, truth);
  if (!difference || !is_regular(truth.limit)) return difference;
  auto unexplained = PerturbedOrbit(claimed, points, flow).difference(truth);
  if (unexplained) return unexplained;
  difference->is_permitted = true;
  return difference;
}

}  // namespace flowcert
