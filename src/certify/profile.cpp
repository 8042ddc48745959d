// One table says which part concerns which points, and from which level on it is judged.
#include "flowcert/profile.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "certify/claim_profile.h"
#include "certify/layer.h"
#include "flowcert/check.h"

namespace flowcert {

namespace {

constexpr std::array<const char*, kProfileParts> kPartNames = {
    "points", "U2",       "S2",      "polylines", "skeletons",   "lambda-lists", "connections", "volumes",
    "U1",     "infinity", "pockets", "orbits",    "persistence", "cycles",       "pores"};

// A part that is claimed of single points.
struct PartOfPoints {
  ProfilePart part;
  int level;
  int first, last;  // the indices of the critical points that it concerns
  bool (*is_told)(const ClaimedPoint&);
};

constexpr std::array kPartsOfPoints = {
    PartOfPoints{ProfilePart::kU2, 4, 2, 2, [](const ClaimedPoint& x) { return x.successors.has_value(); }},
    PartOfPoints{ProfilePart::kS2, 4, 2, 2, [](const ClaimedPoint& x) { return x.stable && x.stable->boundary; }},
    PartOfPoints{ProfilePart::kPolylines, 5, 2, 2, [](const ClaimedPoint& x) { return x.u2.has_value(); }},
    PartOfPoints{ProfilePart::kSkeletons, 5, 2, 2, [](const ClaimedPoint& x) { return x.skeleton.has_value(); }},
    PartOfPoints{ProfilePart::kLambdaLists, 5, 1, 2, [](const ClaimedPoint& x) { return x.lambda.has_value(); }},
    PartOfPoints{ProfilePart::kConnections, 5, 1, 2, [](const ClaimedPoint& x) { return x.connections.has_value(); }},
    PartOfPoints{ProfilePart::kVolumes, 5, 2, 3, [](const ClaimedPoint& x) { return x.volume.has_value(); }},
    PartOfPoints{ProfilePart::kU1, 5, 1, 1, [](const ClaimedPoint& x) { return x.u1.has_value(); }},
};

Profile::State told_if(bool is_told) { return is_told ? Profile::State::kCovered : Profile::State::kNotCovered; }

Profile::State state_of(const PartOfPoints& part, const std::vector<ClaimedPoint>& points) {
  Profile::State state = Profile::State::kNothingToCover;
  for (const ClaimedPoint& point : points) {
    if (point.hull_dimension || point.index < part.first || part.last < point.index) continue;
    if (!part.is_told(point)) return Profile::State::kNotCovered;
    state = Profile::State::kCovered;
  }
  return state;
}

// Decimals that may be far off say little (FC-CLAIM-23). What fails does so with any tolerance.
bool is_too_far_off(Verdict verdict, const Profile& profile, double tolerance) {
  return verdict != Verdict::kFails && !profile.is_exact() && !(tolerance <= kLargestStatedTolerance);
}

bool is_any(const ClaimedIndices& indices) { return std::ranges::count(indices, true) > 0; }
bool is_all(const ClaimedIndices& indices) { return std::ranges::count(indices, false) == 0; }

}  // namespace

void Profile::join(const Profile& other) {
  for (std::size_t k = 0; k < kProfileParts; ++k) states_.at(k) = std::max(states_.at(k), other.states_.at(k));
  for (std::size_t k = 0; k < indices_.size(); ++k) indices_.at(k) = indices_.at(k) && other.indices_.at(k);
  is_exact_ = is_exact_ && other.is_exact_;
}

std::vector<std::string> Profile::parts() const {
  std::vector<std::string> names;
  for (std::size_t k = 0; k < kProfileParts; ++k) {
    if (states_.at(k) != State::kCovered) continue;
    if (k > 0 || is_all(indices_)) {
      names.emplace_back(kPartNames.at(k));
    } else if (is_any(indices_)) {
      std::vector<std::size_t> told;
      for (std::size_t index = 0; index < indices_.size(); ++index) {
        if (indices_.at(index)) told.push_back(index);
      }
      names.push_back(fmt::format("points of index {}", fmt::join(told, ", ")));
    }
  }
  return names;
}

Profile certify::profile_of(const Claim& claim, const ClaimedIndices& indices, bool has_points, bool is_exact,
                            int highest_level) {
  Profile profile;
  profile.set_exact(is_exact);
  profile.set_indices(indices);
  profile.set(ProfilePart::kPockets, claim.pockets ? told_if(highest_level >= 5) : Profile::State::kNotCovered);
  profile.set(ProfilePart::kPoints, told_if(!claim.pockets && highest_level >= 3));
  const bool has_more = !claim.pockets && is_all(indices);
  for (const PartOfPoints& part : kPartsOfPoints) {
    const bool is_judged = has_more && highest_level >= part.level;
    profile.set(part.part, is_judged ? state_of(part, claim.points) : Profile::State::kNotCovered);
  }
  const bool tells_infinity = has_more && highest_level >= 5 && claim.infinity;
  if (has_points || claim.pockets) profile.set(ProfilePart::kInfinity, told_if(tells_infinity));
  return profile;
}

std::optional<std::string> conformity_text(Verdict verdict, const Profile& profile, double tolerance) {
  if (verdict == Verdict::kFails) return fmt::format("does not conform to {}", kSpecVersion);
  const std::vector<std::string> parts = profile.parts();
  if (parts.empty() || is_too_far_off(verdict, profile, tolerance)) return std::nullopt;
  const char* words = verdict == Verdict::kConforms                  ? "conforms to"
                      : verdict == Verdict::kConformsWhereDetermined ? "conforms where determined to"
                                                                     : "is perturbed under";
  return fmt::format("{} {}, {}, {}{}", words, kSpecVersion, fmt::join(parts, " + "), profile.grade(),
                     profile.is_exact() ? "" : fmt::format(" within {}", tolerance));
}

std::optional<std::string> no_conformity_text(Verdict verdict, const Profile& profile, double tolerance) {
  if (profile.parts().empty() || !is_too_far_off(verdict, profile, tolerance)) return std::nullopt;
  return fmt::format("no statement: the tolerance {} is above {} (FC-CLAIM-23)", tolerance, kLargestStatedTolerance);
}

}  // namespace flowcert
