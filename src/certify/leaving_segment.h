// The types of flow segments, and the first segment that an orbit takes beyond a regular stationary point, once a
// perturbation lets it pass (FC-CLAIM-08).
//
// Guarantees: exact.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "certify/layer.h"
#include "flowcert/point_set.h"
#include "flowcert/rational.h"

namespace flowcert::certify {

// Whether it is a type of FC-FLOW-02, "E-F-V" or "E-F-inf".
[[nodiscard]] bool is_segment_type(std::string_view type);
// Whether a segment of the type `claimed` can come to a stationary point y, where without a perturbation one of the
// type `truth` does: its last letter may be another one, V, E or F.
[[nodiscard]] bool can_arrive_as(std::string_view claimed, std::string_view truth);
// "C", "F", "E" or "V", as the affine hull of these samples on one sphere has dimension 0 to 3.
[[nodiscard]] char face_letter(const PointSet& points, std::span<const PointId> contact);

// From a regular stationary point y, which has this contact set, to `end`.
class LeavingSegment {
 public:
  LeavingSegment(const PointSet& points, std::span<const PointId> contact, const RationalPoint& y,
                 const RationalPoint& end);

  // Whether the flow may take it. It then has y as its driver, and is whole.
  [[nodiscard]] bool is_flow() const { return is_flow_; }
  [[nodiscard]] const std::string& type() const { return type_; }
  // Contact sets: just after y, and of the end.
  [[nodiscard]] const std::vector<PointId>& crossed() const { return crossed_; }
  [[nodiscard]] const std::vector<PointId>& at_end() const { return at_end_; }

 private:
  std::vector<PointId> at_end_;
  std::vector<PointId> crossed_;
  bool is_flow_ = false;
  std::string type_;
};

}  // namespace flowcert::certify
