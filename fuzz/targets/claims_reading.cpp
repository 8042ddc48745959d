// Claims; see reading.h for what is asked of them.
#include <algorithm>
#include <array>

#include "certify/claims/claim_formats.h"
#include "flowcert/check.h"
#include "fuzz/targets/reading.h"
#include "io/line_reader.h"

namespace flowcert::fuzz {

using namespace certify;
namespace {

// The name of a row is less than the largest number of rows.
constexpr PointId kLargestId = 2147483646;

const ClaimFormat& format_named(std::string_view name) {
  const std::array formats = {&kPocketClaims, &kExchangeClaims, &kVtpClaims, &kGiesenKuehneClaims, &kCsvClaims};
  return **std::find_if(formats.begin(), formats.end(),
                        [&](const ClaimFormat* format) { return format->name == name; });
}

// These points have stationary points of nearly every kind, a repeated row, and orbits that end at infinity.
const PointSet& judged_points() {
  static const PointSet points(
      std::vector<Point>{{0, 0, 1}, {1, 0, 0}, {0, 0, 0}, {1, 1, 1}, {1, 0, 1}, {0, 0, 1}, {0.1, 5, 0.2}, {3, 4, -1}});
  return points;
}

std::string senseless_part(const ClaimedPoint& point) {
  if (point.index < 0 || point.index > 3) return "an index that does not exist";
  if (!point.center && point.contact.empty()) return "a point that is nowhere";
  if (std::any_of(point.contact.begin(), point.contact.end(), [](PointId id) { return id > kLargestId; })) {
    return "an id that no row can have";
  }
  if (point.squared_distance && point.squared_distance->value < 0) return "a negative squared distance";
  if (point.distance && point.distance->value < 0) return "a negative distance";
  if (point.u2 && point.u2->size() != 2) return "a number of orbits that is not two";
  if (!point.surface) return {};
  for (const auto& triangle : point.surface->triangles) {
    for (const std::size_t vertex : triangle) {
      if (vertex >= point.surface->vertices.size()) return "a triangle of a vertex that is not there";
    }
  }
  return {};
}

std::string complaint_about_judging(const Claim& claim) {
  try {
    require_rows(claim, judged_points(), "a");
  } catch (const InvalidInput& error) {
    return complaint_about_refusal(error);
  }
  const CheckReport report = check(judged_points(), claim);
  for (const Finding& finding : report.findings) {
    if (finding.level < 1 || finding.level > kLevels) return "a finding of no level";
  }
  const bool fails = std::any_of(report.findings.begin(), report.findings.end(),
                                 [](const Finding& finding) { return !finding.is_variation; });
  return fails == (report.verdict == Verdict::kFails) ? "" : "the verdict is not that of the findings";
}

}  // namespace

std::string complaint_about_claim(Bytes bytes, std::string_view format) {
  const std::string_view text = text_of(bytes);
  if (std::all_of(text.begin(), text.end(), is_blank)) return {};
  Claim claim;
  try {
    claim = format_named(format).read(text, "a", false);
  } catch (const InvalidInput& error) {
    return complaint_about_refusal(error);
  }
  for (const ClaimedPoint& point : claim.points) {
    const std::string senseless = senseless_part(point);
    if (!senseless.empty()) return "read " + senseless + ", line " + std::to_string(point.line);
  }
  return complaint_about_judging(claim);
}

}  // namespace flowcert::fuzz
