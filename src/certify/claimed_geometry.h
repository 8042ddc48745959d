// Questions about a few samples on one sphere, answered exactly.
//
// Guarantees: names are those of classes (PointSet::name), ascending.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "certify/layer.h"
#include "flowcert/claim.h"
#include "flowcert/stationary_points.h"

namespace flowcert::certify {

// ---- Contact sets ----

[[nodiscard]] const Point& sample(const PointSet& points, PointId name);

[[nodiscard]] bool all_on_sphere(const PointSet& points, std::span<const PointId> names,
                                 const ExactSphere& sphere);

// Of the affine hull, 0 to 3, of at least one sample; all of them on a sphere, so that no three are on a
// line.
[[nodiscard]] int affine_dimension(const PointSet& points, std::span<const PointId> names);

// All of `of` that is in the plane of `plane`, whose first three samples span it; nothing where `of` has
// samples on both sides of it.
[[nodiscard]] std::vector<PointId> supported_face(const PointSet& points, std::span<const PointId> plane,
                                                  std::span<const PointId> of);

// The samples nearest to x, and how far they are: C(x) and d(x)^2 (FC-DIST-01). A scan in double precision,
// and exact arithmetic for those that it cannot tell apart.
struct NearestSamples {
  std::vector<PointId> names;
  Rational squared_distance;
};
[[nodiscard]] NearestSamples nearest_samples(const PointSet& points, const RationalPoint& x);

// ---- Values ----
// Whether a claimed position or radius is the true one (FC-CLAIM-05): what is claimed exactly has to be
// equal, what is claimed in decimals has to be near.
enum class ValueMatch {
  kEqual,     // exact, and equal
  kWithin,    // in decimals, and near enough
  kRounding,  // wrong, by no more than rounding explains
  kOff,
};

// What "near" refers to: the radius of the point in question; where that is 0, the largest of the sample's
// coordinates.
class ValueScale {
 public:
  // Costs nothing: most values match without being compared by a tolerance.
  ValueScale(ExactSphere sphere, double tolerance) : sphere_(std::move(sphere)), tolerance_(tolerance) {}

  // By which a position or distance in decimals may be off, squared.
  [[nodiscard]] Rational squared_allowance() const;
  // As rounding does not care for the radius alone: radius and largest coordinate, roughly.
  [[nodiscard]] double rounding_length() const;

 private:
  ExactSphere sphere_;
  double tolerance_;
};

[[nodiscard]] ValueMatch match_position(const ClaimedPosition& claimed, const RationalPoint& truth,
                                        const ValueScale& scale);
[[nodiscard]] ValueMatch match_distance(const ClaimedNumber& claimed, const Rational& squared_radius,
                                        const ValueScale& scale);
[[nodiscard]] ValueMatch match_squared_distance(const ClaimedNumber& claimed, const Rational& squared_radius,
                                                const ValueScale& scale);

[[nodiscard]] inline bool is_wrong(ValueMatch match) { return match >= ValueMatch::kRounding; }
[[nodiscard]] bool is_exact(const ClaimedPosition& claimed);
[[nodiscard]] RationalPoint values_of(const ClaimedPosition& claimed);

// Whether two lengths, given by squares, differ by no more than rounding explains, on that scale.
inline constexpr double kRoundingPart = 0x1p-44;
[[nodiscard]] bool is_rounding(const Rational& squared_a, const Rational& squared_b, double rounding_length);
// As in ValueScale.
[[nodiscard]] double rounding_length(const ExactSphere& sphere);

}  // namespace flowcert::certify
