// The samples with the largest <u,p> are those of the face that the segment crosses.
#include "certify/leaving_segment.h"

#include <algorithm>
#include <array>
#include <optional>

#include "certify/claimed_geometry.h"
#include "geometry/nearest_samples.h"
#include "geometry/rational_point.h"

namespace flowcert::certify {

namespace {

constexpr std::size_t kLettersBeforeLast = std::string_view("E-F-").size();

}  // namespace

bool is_segment_type(std::string_view type) {
  constexpr std::array<std::string_view, 17> kTypes = {"V-E-V",   "V-E-inf", "E-E-V", "E-E-inf", "V-F-V",  "V-F-E",
                                                       "V-F-inf", "E-F-V",   "E-F-E", "E-F-inf", "F-F-V",  "F-F-E",
                                                       "F-F-inf", "C-C-V",   "C-C-E", "C-C-F",   "C-C-inf"};
  return std::ranges::find(kTypes, type) != kTypes.end();
}

bool can_arrive_as(std::string_view claimed, std::string_view truth) {
  return is_segment_type(claimed) && !claimed.ends_with("inf") &&
         claimed.substr(0, kLettersBeforeLast) == truth.substr(0, kLettersBeforeLast);
}

char face_letter(const PointSet& points, std::span<const PointId> contact) {
  return "CFEV"[affine_dimension(points, contact)];
}

LeavingSegment::LeavingSegment(const PointSet& points, std::span<const PointId> contact, const RationalPoint& y,
                               const RationalPoint& end)
    : at_end_(geometry::nearest_samples(points, end).names) {
  const RationalPoint way = end - y;
  std::optional<Rational> most;
  for (const PointId name : contact) {
    const Rational along = dot(way, exact_position(sample(points, name)) - y);
    if (most && along < *most) continue;
    if (!most || along > *most) crossed_.clear();
    most = along;
    crossed_.push_back(name);
  }
  is_flow_ =
      end != y && std::ranges::includes(at_end_, crossed_) && at_end_ != crossed_ && has_in_hull(points, crossed_, y);
  type_ = {face_letter(points, contact), '-', face_letter(points, crossed_), '-', face_letter(points, at_end_)};
}

}  // namespace flowcert::certify
