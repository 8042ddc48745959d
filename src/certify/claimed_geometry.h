// Questions about a few samples on one sphere, answered exactly.
//
// Guarantees: all names are class names (PointSet::name), ascending.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "certify/layer.h"
#include "flowcert/claim.h"
#include "flowcert/stationary_points.h"

namespace flowcert::certify {

// ---- Contact sets ----

[[nodiscard]] const Point& sample(const PointSet& points, PointId name);

[[nodiscard]] bool all_on_sphere(const PointSet& points, std::span<const PointId> names, const ExactSphere& sphere);

// The dimension of the samples' affine hull, 0 to 3. There must be at least one sample, and all must lie on one
// sphere, so that no three are on a line.
[[nodiscard]] int affine_dimension(const PointSet& points, std::span<const PointId> names);

// The samples of `of` in the plane that the first three samples of `plane` span. The result is empty if `of` has
// samples on both sides of that plane.
[[nodiscard]] std::vector<PointId> supported_face(const PointSet& points, std::span<const PointId> plane,
                                                  std::span<const PointId> of);

// Whether the first three samples of two lists, which lie in one plane, turn the same way.
[[nodiscard]] bool turn_alike(const PointSet& points, std::span<const PointId> a, std::span<const PointId> b);

// Whether a position that is equally far from all of these samples lies in their convex hull.
[[nodiscard]] bool has_in_hull(const PointSet& points, std::span<const PointId> names, const RationalPoint& center);

// ---- Values ----
// Whether a claimed position or radius is the true one (FC-CLAIM-05). An exact claim has to be equal. A claim in
// decimals has to be near.
enum class ValueMatch {
  kEqual,     // exact, and equal
  kWithin,    // in decimals, and near enough
  kRounding,  // wrong, by no more than rounding explains
  kOff,
};

// The length that "near" refers to. It is the radius of the stationary point. If that is 0, the point is a sample,
// and the length is the sample's largest coordinate.
class ValueScale {
 public:
  // Computes nothing yet, because most values match without a tolerance.
  ValueScale(ExactSphere sphere, double tolerance) : sphere_(std::move(sphere)), tolerance_(tolerance) {}

  // The square of the length by which a position or distance in decimals may be off.
  [[nodiscard]] Rational squared_allowance() const;
  // As below.
  [[nodiscard]] Rational squared_rounding() const;

 private:
  ExactSphere sphere_;
  double tolerance_;
};

[[nodiscard]] ValueMatch match_position(const ClaimedPosition& claimed, const RationalPoint& truth,
                                        const ValueScale& scale);
// A vector may have any length; one of length 0 matches nothing. In decimals, the vectors may differ by the tolerance
// in each coordinate, scaled so that the greatest coordinate without the sign is 1.
[[nodiscard]] ValueMatch match_vector(const ClaimedPosition& claimed, const RationalPoint& truth, double tolerance);
[[nodiscard]] ValueMatch match_distance(const ClaimedNumber& claimed, const Rational& squared_radius,
                                        const ValueScale& scale);
[[nodiscard]] ValueMatch match_squared_distance(const ClaimedNumber& claimed, const Rational& squared_radius,
                                                const ValueScale& scale);

// A double that is claimed beside an exact coordinate. There must be none exactly where no double is near.
[[nodiscard]] ValueMatch match_double(const std::optional<ClaimedNumber>& claimed, const Rational& truth,
                                      const ValueScale& scale);

// A volume in decimals may be off by the tolerance times its true value (FC-CLAIM-15).
[[nodiscard]] ValueMatch match_volume(const ClaimedNumber& claimed, const Rational& truth, double tolerance);

[[nodiscard]] inline bool is_wrong(ValueMatch match) { return match >= ValueMatch::kRounding; }
[[nodiscard]] bool is_exact(const ClaimedPosition& claimed);
[[nodiscard]] RationalPoint values_of(const ClaimedPosition& claimed);

// The nearest double, or the largest one of its sign where none is near.
[[nodiscard]] double as_double(const Rational& value);
[[nodiscard]] std::array<double, 3> as_doubles(const RationalPoint& position);

// Whether two values have the same nearest double. A decimal for which this holds is as right as a double can be.
[[nodiscard]] bool rounds_alike(const Rational& a, const Rational& b);

// Rounding explains this part of the larger of the radius and the largest coordinate (FC-CLAIM-05), because rounding
// errors depend on both.
inline constexpr double kRoundingPart = 0x1p-44;
// The square of the length that rounding explains. Exact.
[[nodiscard]] Rational squared_rounding(const ExactSphere& sphere);
// Whether two lengths, given by their squares, differ by no more than rounding explains. Exact.
[[nodiscard]] bool is_rounding(const Rational& squared_a, const Rational& squared_b, const Rational& squared_rounding);
// The larger of the radius and the largest coordinate, to some bits; the largest double where it is beyond.
[[nodiscard]] double rounding_length(const ExactSphere& sphere);

}  // namespace flowcert::certify
