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
#include <optional>
#include <string>
#include <vector>

#include "flowcert/claim.h"
#include "flowcert/point_set.h"
#include "flowcert/profile.h"

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
// The largest one that the commands, Python and JavaScript take: with a larger one, nearly every claim is ambiguous.
inline constexpr double kLargestTolerance = 1e-3;
inline constexpr int kLevels = 5;

struct CheckOptions {
  // Positions and radii in decimals match within this part of the critical point's radius (FC-CLAIM-05).
  // It may be up to 1, and should be at most kLargestTolerance: many stationary points are within a large one, and then
  // it takes long to find out which of them is claimed.
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

// Takes time in proportion to the size of the claim, plus the time for the parts of the complex that it needs. Each
// wrong claimed point costs a scan of all points in floating point. Throws InvalidInput for a tolerance that is not
// between 0 and 1, and std::runtime_error where this thread does not compute with doubles as IEEE 754 says. The first
// computes the complex of the points itself.
[[nodiscard]] CheckReport check(const PointSet& points, const Claim& claim, const CheckOptions& options = {});
[[nodiscard]] CheckReport check(const FlowComplex& complex, const Claim& claim, const CheckOptions& options = {});

}  // namespace flowcert
