// Spheres prove what is said: the claimed one, with the samples inside, and the true one, which is empty.
#include "certify/viewer_claim.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>

#include "certify/claimed_geometry.h"
#include "certify/layer.h"
#include "geometry/floating_point.h"
#include "geometry/keep_unique.h"
#include "geometry/rational_point.h"
#include "io/viewer_parts.h"

namespace flowcert {

using namespace certify;

namespace {

constexpr std::size_t kMostInside = 20;
constexpr std::size_t kMostOn = 200;

std::vector<std::size_t> ordinals_of(const PointSet& points, const std::vector<PointId>& rows) {
  std::vector<std::size_t> ordinals;
  for (const PointId row : rows) {
    if (row < points.row_count()) ordinals.push_back(points.ordinal_of_row(row));
  }
  geometry::keep_unique(ordinals);
  return ordinals;
}

// A difference of coordinates is wrong by at most 2^-51 of the largest one, and is at most twice that. So a sum of three
// squares is wrong by less than 2^-45 of its square.
constexpr double kSquaresShare = 0x1p-44;
// What is below it may underflow, and is decided exactly.
constexpr double kLeastSlack = std::numeric_limits<double>::min() * 0x1p60;

// Tells most samples far outside a sphere by doubles. It says so only where rounding cannot matter.
class FarOutside {
 public:
  explicit FarOutside(const ExactSphere& sphere)
      : center_(as_doubles(sphere.center)), squared_radius_(as_double(sphere.squared_radius)) {}

  [[nodiscard]] bool operator()(const Point& p) const {
    const double x = p.x - center_[0], y = p.y - center_[1], z = p.z - center_[2];
    const double largest = std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z), std::abs(center_[0]),
                                     std::abs(center_[1]), std::abs(center_[2])});
    const double slack = largest * largest * kSquaresShare + squared_radius_ * kSquaresShare;
    if (!(slack > kLeastSlack)) return false;
    return x * x + y * y + z * z > squared_radius_ + slack;
  }

 private:
  std::array<double, 3> center_;
  double squared_radius_;
};

// A sphere that proves a finding, with the samples that matter.
Json sphere_field(const PointSet& points, const ViewerFrame& frame, const ExactSphere& sphere, bool is_claimed) {
  std::vector<std::size_t> inside, on;  // ordinals, the first of them
  std::size_t inside_count = 0;         // with those that are not listed
  const FarOutside is_far_outside(sphere);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (is_far_outside(points[i])) continue;
    const Rational squared = squared_distance(sphere.center, points[i]);
    if (squared < sphere.squared_radius) {
      ++inside_count;
      if (inside.size() < kMostInside) inside.push_back(i);
    } else if (squared == sphere.squared_radius && on.size() < kMostOn) {
      on.push_back(i);
    }
  }
  return {{"center", frame.placed(sphere.center)},
          {"radius", frame.scaled(std::sqrt(rounded_sphere(sphere).squared_radius))},
          {"role", is_claimed ? "claimed" : "true"},
          {"empty", inside_count == 0},
          {"inside", inside},
          {"inside_count", inside_count},
          {"on", on}};
}

// The sphere that a claimed point stands for. It has the claimed centre and distance, or else those of the contact set.
std::optional<ExactSphere> claimed_sphere(const PointSet& points, const ClaimedPoint& point) {
  std::optional<ExactSphere> of_contact;
  if (const std::vector<std::size_t> contact = ordinals_of(points, point.contact); !contact.empty()) {
    std::vector<PointId> names;
    names.reserve(contact.size());
    for (const std::size_t ordinal : contact) names.push_back(points.name(ordinal));
    of_contact = exact_sphere(points, names);
  }
  ExactSphere sphere;
  if (point.center) {
    sphere.center = values_of(*point.center);
  } else if (of_contact) {
    return of_contact;
  } else {
    return std::nullopt;
  }
  if (point.squared_distance) {
    sphere.squared_radius = point.squared_distance->value;
  } else if (point.distance) {
    sphere.squared_radius = point.distance->value * point.distance->value;
  } else if (of_contact) {
    sphere.squared_radius = of_contact->squared_radius;
  } else {
    // Only a position is claimed. The sphere reaches to the nearest sample.
    std::optional<FarOutside> is_farther;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (is_farther && (*is_farther)(points[i])) continue;
      const Rational squared = squared_distance(sphere.center, points[i]);
      if (is_farther && squared >= sphere.squared_radius) continue;
      sphere.squared_radius = squared;
      is_farther.emplace(sphere);
    }
  }
  return sphere;
}

std::optional<RationalPoint> position_of(const PointSet& points, const ClaimedTarget& target) {
  if (target.is_infinity) return std::nullopt;
  ClaimedPoint point;
  point.contact = target.contact;
  const auto sphere = claimed_sphere(points, point);
  return sphere ? std::optional(sphere->center) : std::nullopt;
}

using Line = std::vector<RationalPoint>;

// What is claimed to flow from a point: the polylines, or else straight lines to where they are said to end.
std::vector<Line> claimed_lines(const PointSet& points, const ClaimedPoint& point, const RationalPoint& from) {
  std::vector<Line> lines;
  if (point.u2) {
    for (const ClaimedPolyline& polyline : *point.u2) {
      Line line = {from};
      for (const ClaimedSegment& segment : polyline) {
        if (segment.end) line.push_back(values_of(*segment.end));
      }
      lines.push_back(std::move(line));
    }
  } else if (point.successors) {
    for (const ClaimedTarget& target : *point.successors) {
      if (auto end = position_of(points, target)) lines.push_back({from, std::move(*end)});
    }
  }
  return lines;
}

class FindingFields {
 public:
  FindingFields(const FlowComplex& complex, const Claim& claim)
      : complex_(complex), points_(complex.points()), frame_(points_.points()) {
    for (const ClaimedPoint& point : claim.points) point_at_line_.try_emplace(point.line, &point);
  }

  // The index is as claimed, or the true one of what is missing.
  [[nodiscard]] Json field_of(const Finding& finding) const {
    Json field = {{"level", finding.level},
                  {"reason", reason_text(finding.reason)},
                  {"variation", finding.is_variation},
                  {"clause", finding.clause},
                  {"claimed", finding.claimed},
                  {"truth", finding.truth},
                  {"sentence", finding.sentence},
                  {"contact", ordinals_of(points_, finding.contact)},
                  {"line", nullptr},
                  {"index", nullptr},
                  {"record", nullptr},
                  {"position", nullptr},
                  {"spheres", Json::array()},
                  {"lines", Json::array()}};
    if (finding.line) {
      field["line"] = *finding.line;
      place_claimed(*finding.line, finding, field);
    }
    if (finding.record) {
      const ExactSphere truth = complex_.sphere(*finding.record);
      field["record"] = *finding.record;
      if (field["position"].is_null()) field["position"] = frame_.placed(truth.center);
      if (field["index"].is_null()) field["index"] = complex_.stationary().index(*finding.record).face_dimension;
      field["spheres"].push_back(sphere_field(points_, frame_, truth, false));
    }
    return field;
  }

 private:
  void place_claimed(std::size_t line, const Finding& finding, Json& field) const {
    const auto found = point_at_line_.find(line);
    if (found == point_at_line_.end()) return;
    const ClaimedPoint& point = *found->second;
    field["index"] = point.index;
    const auto sphere = claimed_sphere(points_, point);
    if (!sphere) return;
    field["position"] = frame_.placed(sphere->center);
    field["spheres"].push_back(sphere_field(points_, frame_, *sphere, true));
    if (finding.level < 4) return;
    for (const Line& claimed : claimed_lines(points_, point, sphere->center)) {
      Json positions = Json::array();
      for (const RationalPoint& position : claimed) positions.push_back(frame_.placed(position));
      field["lines"].push_back({{"role", "claimed"}, {"positions", std::move(positions)}});
    }
  }

  const FlowComplex& complex_;
  const PointSet& points_;
  ViewerFrame frame_;
  std::map<std::size_t, const ClaimedPoint*> point_at_line_;
};

// What is wrong comes before what varies. The first of each reason come first, and then the others as they are.
std::vector<const Finding*> listed_findings(const std::vector<Finding>& findings, std::size_t most) {
  constexpr std::size_t kOfEachReason = 10;
  std::map<FindingReason, std::size_t> count;
  std::vector<const Finding*> first, others;
  for (const bool is_variation : {false, true}) {
    for (const Finding& finding : findings) {
      if (finding.is_variation != is_variation) continue;
      (count[finding.reason]++ < kOfEachReason ? first : others).push_back(&finding);
    }
  }
  others.resize(std::min(others.size(), most));
  first.insert(first.end(), others.begin(), others.end());
  return first;
}

}  // namespace

Json viewer_claim(const FlowComplex& complex, const Claim& claim, const CheckReport& report,
                  const ViewerClaimOptions& options) {
  const geometry::IeeeDoubles ieee;
  Json field = {{"name", options.name},
                {"verdict", verdict_text(report.verdict)},
                {"tolerance", options.tolerance},
                {"findings", Json::array()},
                {"findings_count", report.findings.size()},
                {"not_judged", report.not_judged},
                {"not_decided", report.not_decided}};
  const FindingFields fields(complex, claim);
  for (const Finding* finding : listed_findings(report.findings, options.most)) {
    field["findings"].push_back(fields.field_of(*finding));
  }
  return field;
}

namespace {

Json judged_text(const FlowComplex& complex, const ClaimText& text, const CheckOptions& options) {
  const ViewerClaimOptions shown = {.name = text.name, .tolerance = options.tolerance};
  try {
    const Claim claim = read_claim_from(text.bytes, text.name);
    require_rows(claim, complex.points(), text.name);
    return viewer_claim(complex, claim, check(complex, claim, options), shown);
  } catch (const InvalidInput& error) {
    Json unreadable = viewer_claim(complex, Claim{}, CheckReport{}, shown);
    unreadable["verdict"] = std::string("cannot be read: ") + error.what();
    return unreadable;
  }
}

}  // namespace

void write_claim_page(std::ostream& out, const PointSet& points, const std::string& name,
                      const std::optional<ClaimText>& claim, const CheckOptions& options) {
  const geometry::IeeeDoubles ieee;
  const FlowComplex complex(points);
  ViewerOptions content;
  content.name = name;
  if (claim) content.claim = judged_text(complex, *claim, options);
  write_viewer_page(out, complex, content);
}

}  // namespace flowcert
