// Whether a claimed flow complex is right, and exactly where it is wrong.
//
// Guarantees: judgements are made by exact arithmetic (spec clauses FC-CRIT and FC-FLOW; FC-CLAIM says what may
// vary). Decimals in a claim are matched within a stated tolerance, and such a claim is never graded exact. No wrong
// claim conforms and no right claim fails, except in what the report lists as not judged.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "flowcert/claim.h"
#include "flowcert/connections.h"
#include "flowcert/flow_limits.h"
#include "flowcert/pockets.h"
#include "flowcert/point_set.h"
#include "flowcert/profile.h"
#include "flowcert/rational.h"
#include "flowcert/stable_manifolds.h"
#include "flowcert/stationary_points.h"
#include "flowcert/unstable_surfaces.h"

namespace flowcert {

class FlowComplex;

// From right to wrong.
enum class Verdict {
  kConforms,
  kConformsWhereDetermined,
  kPerturbed,  // differs only by what a perturbation of the samples makes (FC-CLAIM-04)
  kFails,
};
// "conforms", "conforms where determined", "perturbed", "fails"
[[nodiscard]] const char* verdict_text(Verdict verdict);

// Why a claim is wrong, or how it varies where it may.
enum class FindingReason {
  kMalformed,            // ids out of range, repeated ids, an index that does not exist, another input, ...
  kNotCospherical,       // the contact set lies on no common sphere centred in its affine hull
  kBallNotEmpty,         // a sample lies inside the claimed ball
  kContactIncomplete,    // further samples lie on the sphere
  kOutsideHull,          // the centre lies outside the hull of its contact set
  kCollisionAsCritical,  // a regular stationary point is claimed as critical, in a way that no
                         // perturbation explains
  kWrongIndex,
  kWrongPosition,    // centre or distance
  kRounding,         // wrong by no more than rounding explains (FC-CLAIM-05)
  kMissing,          // a critical point that nobody claims
  kMissedByCluster,  // the same, in a cospherical or cocircular set of samples
  kClaimedTwice,
  kAmbiguous,    // several stationary points within the tolerance of one claim
  kWrongCounts,  // header counts, Euler sum
  kWrongIncidence,
  kWrongPolyline,
  kWrongSurface,      // a skeleton, a boundary walk, or triangles
  kWrongLambdaList,   // limits of directions, or where their rays leave the Voronoi face
  kWrongConnections,  // numbers of orbits and families, or whether the input is Morse-Smale
  kWrongVolume,       // of a stable set, a share of it, or of the convex hull
  kWrongUnstableSet,  // a part of an unstable set of dimension 2
  kWrongPocket,       // a pocket, its mouths, or what leads out of it
  // Permitted variations; kAmbiguous is one too.
  kSpanningPart,          // an affinely independent spanning part of the contact set
  kTieBreak,              // a boundary that another way to break ties gives (FC-CLAIM-09)
  kSymbolicPerturbation,  // what a perturbation makes of a stationary point, of an orbit that ends at a point that is
                          // no maximum, or of a stable set
};
// A word or two with hyphens, "missed-by-cluster".
[[nodiscard]] const char* reason_text(FindingReason reason);

struct Finding {
  int level = 0;  // 1 to 5
  FindingReason reason = FindingReason::kMalformed;
  bool is_variation = false;             // permitted
  std::string clause = {};               // "FC-CRIT-05 (b)"
  std::optional<std::size_t> line = {};  // of the claim; none for what is missing
  std::vector<PointId> contact = {};     // of the critical point: as claimed, or the true one if it is missing
  std::string claimed = {};              // in words
  std::string truth = {};
  // False for a variation of which only necessary conditions are known to hold (FC-CLAIM-04).
  bool is_decided = true;
  // The stationary point that it is about, by its place in the truth's list, where one is known.
  std::optional<std::size_t> record = std::nullopt;
  // What is wrong, in a plain sentence or two, and whether it is a bug or a convention.
  std::string sentence = {};
};
// What this finding alone would make of a claim.
[[nodiscard]] Verdict verdict_on(const Finding& finding);

inline constexpr double kDefaultTolerance = 1e-9;
inline constexpr int kLevels = 5;

struct CheckOptions {
  // Positions and radii in decimals match within this part of the critical point's radius (FC-CLAIM-05).
  // It should be small. Many stationary points are within a large tolerance, and then it takes long to find out which
  // of them is claimed.
  double tolerance = kDefaultTolerance;
  // Levels beyond this one are not checked.
  int highest_level = kLevels;
  // Critical points of other indices are not judged, whatever is claimed of them (FC-CLAIM-12).
  ClaimedIndices indices = {true, true, true, true};
  // Called with how much of a level is done; may throw to stop. A level that has nothing to judge may be left out.
  std::function<void(int level, std::size_t done, std::size_t total)> progress = {};
};

struct CheckReport {
  Verdict verdict = Verdict::kConforms;
  // [0] to [4] are for levels 1 to 5. A value is false iff a finding of its level is no variation. There is no value
  // if nothing is claimed at that level, or the level is not checked.
  std::array<std::optional<bool>, kLevels> conforms;
  // All claimed positions, vectors, radii and volumes are exact and were judged exactly, and none was needed to find
  // out which point is claimed. Otherwise the claim is graded approximate.
  bool is_exact = true;
  // Sorted by level, then line (findings without a line last), then contact.
  std::vector<Finding> findings;
  // What was claimed and is not judged, in words.
  std::vector<std::string> not_judged;
  // What was judged by necessary conditions alone, in words. The claim is then perturbed, or it fails.
  std::vector<std::string> not_decided;
  ClaimedIndices indices{};                     // the indices that were judged
  std::array<std::size_t, 4> claimed_counts{};  // of critical points by index, as listed
  std::array<std::size_t, 4> true_counts{};
  Profile profile;  // what the claim covers (FC-CLAIM-22), whatever the verdict
};

struct TrueSegment {
  std::string type;  // "E-F-V"
  RationalPoint driver;
  std::optional<RationalPoint> end;  // none: infinity
};

// An orbit, or what is left of it.
struct TruePath {
  std::vector<TrueSegment> segments;
  std::optional<std::size_t> limit;  // a stationary point; none: infinity
};

// What StableManifolds counts of one stable set.
struct StableSummary {
  std::size_t segments = 0;
  bool has_vertex = false;
  bool has_interval = false;
};

// All pockets at one persistence (FC-POCK-02 to 08). Points are places in the truth's list.
struct TruePockets {
  std::vector<Pocket> pockets;
  std::vector<std::uint32_t> outside;        // maxima, ascending
  std::vector<std::uint32_t> largest_balls;  // empty iff there is no pocket
  std::optional<WidestPath> widest;
  // The numbers of the pockets above each mouth, ascending. The outside has the number of pockets.
  std::map<std::uint32_t, std::vector<std::uint32_t>> above_mouths;
};

// The true flow complex, as the fast implementation or the oracle finds it. It has all stationary points, in the
// order of FC-OUT-02, and what flows from and to them. A check asks only for what a claim needs.
class Truth {
 public:
  virtual ~Truth() = default;

  [[nodiscard]] virtual std::size_t size() const = 0;
  [[nodiscard]] virtual StationaryIndex index(std::size_t i) const = 0;
  [[nodiscard]] virtual std::span<const PointId> contact(std::size_t i) const = 0;
  [[nodiscard]] virtual ExactSphere sphere(std::size_t i) = 0;

  // For an index-2 critical point: where its two orbits end (FC-FLOW-07), by side; none: infinity.
  [[nodiscard]] virtual std::array<std::optional<std::size_t>, 2> limits(std::size_t i) = 0;
  [[nodiscard]] virtual std::vector<TrueSegment> polyline(std::size_t i, std::size_t side) = 0;
  // The orbit of any position. It has no segments if the position is stationary.
  [[nodiscard]] virtual TruePath orbit(const RationalPoint& start) = 0;

  // For an index-2 critical point: records of index 1, mod 2, ascending. If a tie leaves the boundary open, this is
  // one choice that FC-CHAIN-02 allows. A truth that breaks no ties then gives none.
  [[nodiscard]] virtual std::optional<std::vector<std::uint32_t>> boundary(std::size_t i) = 0;
  // Both are for an index-2 critical point or a regular stationary point.
  [[nodiscard]] virtual StableSummary stable_summary(std::size_t i) = 0;
  [[nodiscard]] virtual StableSet<> stable_set(std::size_t i) = 0;
  [[nodiscard]] virtual StableSet<> set_of_infinity() = 0;

  // All three are for a stationary point whose face has dimension 1 or 2. Arcs and directions of the second one are in
  // the order of some λ-list. The third one is sorted by `to`; infinity comes last.
  [[nodiscard]] virtual LambdaList lambda_list(std::size_t i) = 0;
  [[nodiscard]] virtual std::vector<FlowLimits::Entry> lambda_entries(std::size_t i) = 0;
  [[nodiscard]] virtual std::vector<Connection> connections(std::size_t i) = 0;
  [[nodiscard]] virtual bool is_morse_smale() = 0;

  // Of the stable set of any stationary point (FC-VOL-01, 02): the volume, exactly; the nearest double, or an infinity
  // where it would overflow; the shares that are not 0, by names of samples, ascending.
  [[nodiscard]] virtual Rational volume(std::size_t i) = 0;
  [[nodiscard]] virtual double nearest_volume(std::size_t i) = 0;
  [[nodiscard]] virtual std::vector<std::pair<PointId, Rational>> shares(std::size_t i) = 0;
  // The same samples, with the nearest doubles.
  [[nodiscard]] virtual std::vector<std::pair<PointId, double>> nearest_shares(std::size_t i) = 0;
  // Of the convex hull of all points.
  [[nodiscard]] virtual Rational hull_volume() = 0;

  // For a stationary point whose face has dimension 1 (FC-UNST-04). All lists are sorted, as in UnstableSurface.
  [[nodiscard]] virtual UnstableSurface<> unstable_surface(std::size_t i) = 0;

  // The square of a persistence, which is a difference of distances.
  [[nodiscard]] virtual TruePockets pockets(const Rational& squared_persistence) = 0;
  // The area is that of the S2 of an index-2 critical point, as FC-POCK-11 permits.
  [[nodiscard]] virtual double area(std::size_t i) = 0;
  // The double nearest to the sum of some volumes, or an infinity where it would overflow.
  [[nodiscard]] virtual double nearest_volume_of(const std::vector<std::uint32_t>& points) = 0;
};

// The truth by the fast implementation, of points or of a complex that must outlive it. This takes as long as computing
// the critical points. U2 is computed when it is first asked for.
[[nodiscard]] std::unique_ptr<Truth> fast_truth(const PointSet& points, unsigned threads = 1);
[[nodiscard]] std::unique_ptr<Truth> fast_truth(const FlowComplex& complex);
std::unique_ptr<Truth> fast_truth(FlowComplex&&) = delete;

// Takes time in proportion to the size of the claim, plus the time for the truth's answers. Each wrong claimed point
// costs a scan of all points in floating point. Throws InvalidInput for a tolerance that is not between 0 and 1, and
// std::runtime_error where this thread does not compute with doubles as IEEE 754 says.
[[nodiscard]] CheckReport check(const PointSet& points, const Claim& claim, Truth& truth,
                                const CheckOptions& options = {});
// Judges by fast_truth(points).
[[nodiscard]] CheckReport check(const PointSet& points, const Claim& claim, const CheckOptions& options = {});

}  // namespace flowcert
