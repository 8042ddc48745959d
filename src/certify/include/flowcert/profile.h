// The profile of a claim, or of a program by its claims: which parts of the flow complex it covers, and how exactly
// (FC-CLAIM-22).
//
// Guarantees: a profile follows from what is claimed and judged alone. It says nothing of whether that is right, which
// is the verdict's to say. Profiles of several claims are joined in any order, in constant memory.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "flowcert/claim.h"

namespace flowcert {

enum class Verdict;

// The version of the specification, as the head of spec/flow_complex.md has it.
inline constexpr char kSpecVersion[] = "1.2";

// In the order in which a profile names them.
enum class ProfilePart : std::uint8_t {
  kPoints,
  kU2,
  kS2,
  kPolylines,
  kSkeletons,
  kLambdaLists,
  kConnections,
  kVolumes,
  kU1,
  kInfinity,
  kPockets,
  kOrbits,
  kPersistence,
  kCycles,
  kPores,
};
inline constexpr std::size_t kProfileParts = 15;

class Profile {
 public:
  enum class State : std::uint8_t {
    kNothingToCover,  // the input has no point to which this applies, or it was not asked for
    kCovered,         // claimed of every point that it concerns, and of one at least
    kNotCovered,
  };

  // Nothing is covered yet, and nothing is left out.
  Profile() = default;

  [[nodiscard]] State state(ProfilePart part) const { return states_.at(static_cast<std::size_t>(part)); }
  void set(ProfilePart part, State state) { states_.at(static_cast<std::size_t>(part)) = state; }
  [[nodiscard]] bool is_exact() const { return is_exact_; }
  void set_exact(bool is_exact) { is_exact_ = is_exact; }
  // The indices of the critical points that are claimed and judged.
  void set_indices(const ClaimedIndices& indices) { indices_ = indices; }

  // The profile of a program that has both: a part that one of them leaves out is left out, and one with a decimal is
  // approximate.
  void join(const Profile& other);

  // "points", "U2", or "points of index 0, 3". Empty if nothing is covered.
  [[nodiscard]] std::vector<std::string> parts() const;
  // "exact" or "approximate"
  [[nodiscard]] const char* grade() const { return is_exact_ ? "exact" : "approximate"; }

  friend bool operator==(const Profile&, const Profile&) = default;

 private:
  std::array<State, kProfileParts> states_{};
  ClaimedIndices indices_ = {true, true, true, true};
  bool is_exact_ = true;
};

// The largest tolerance with which what is approximate can be said to conform, or to be perturbed (FC-CLAIM-23).
inline constexpr double kLargestStatedTolerance = 1e-6;

// "conforms to 1.2, points + U2, exact" or "conforms to 1.2, points, approximate within 1e-09". It is "does not conform
// to 1.2" for what fails. Nothing if no part is covered, or if the tolerance of decimals is too large.
[[nodiscard]] std::optional<std::string> conformity_text(Verdict verdict, const Profile& profile, double tolerance);

// "no statement: the tolerance 0.001 is above 1e-06 (FC-CLAIM-23)". Nothing where the tolerance is not the reason.
[[nodiscard]] std::optional<std::string> no_conformity_text(Verdict verdict, const Profile& profile, double tolerance);

}  // namespace flowcert
