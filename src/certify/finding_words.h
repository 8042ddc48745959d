// Findings in words.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "certify/claimed_geometry.h"
#include "certify/layer.h"
#include "certify/truth.h"

namespace flowcert::certify {

// "3 17 20". Long lists are cut short.
[[nodiscard]] std::string names_text(std::span<const PointId> names);
// "index 2, contact set 3 17 20"
[[nodiscard]] std::string claim_text(const ClaimedPoint& point);
// "critical point of index 2, contact set 0 1 2 3"
[[nodiscard]] std::string stationary_text(const Truth& truth, std::size_t record);
[[nodiscard]] std::string index_text(StationaryIndex index);
// "infinity", or a contact set.
[[nodiscard]] std::string target_text(const ClaimedTarget& target);
// A text as a message shows it: the first `longest` characters, and "..." if there are more.
[[nodiscard]] std::string shortened(std::string text, std::size_t longest);
// The shortest decimal that reads back to the same double.
[[nodiscard]] std::string shortest_text(double value);
// The exact number if its text is short; otherwise the rounded number, marked with ~.
[[nodiscard]] std::string number_text(const Rational& value);
[[nodiscard]] std::string position_text(const RationalPoint& x);
// A claimed number as it was written: a decimal is no fraction.
[[nodiscard]] std::string number_text(const ClaimedNumber& number);
[[nodiscard]] std::string position_text(const ClaimedPosition& x);
// A std::optional or Boxed has no number where no double is near.
[[nodiscard]] std::string double_text(const auto& number) { return number ? number_text(*number) : "no double"; }
// "1.2e-07 away", and for decimals "1.2e-07 away, 120 times the tolerance".
[[nodiscard]] std::string offset_text(const ClaimedPosition& claimed, const RationalPoint& truth,
                                      const ValueScale& scale);

// The reason of a wrong value: this one, unless rounding explains the value.
[[nodiscard]] inline FindingReason rounding_or(FindingReason otherwise, bool by_rounding) {
  return by_rounding ? FindingReason::kRounding : otherwise;
}
[[nodiscard]] inline FindingReason rounding_or(FindingReason otherwise, ValueMatch match) {
  return rounding_or(otherwise, match == ValueMatch::kRounding);
}

// A plain sentence for people who do not know the clauses: what is wrong, and whether it is a bug or a convention that
// can be met otherwise. Every reason has one. It names points by their rows, and says nothing that the finding does not
// know.
[[nodiscard]] std::string finding_sentence(const Finding& finding, const Truth& truth);

// The finding to show first: the first one about a point at the lowest level, else the very first. A wrong total
// mostly follows from a wrong point. There must be a finding. What is wrong must come before variations,
// and both must be sorted by level.
[[nodiscard]] const Finding& telling_finding(const std::vector<Finding>& findings);

// The clause of the Euler sum.
inline constexpr char kEulerClause[] = "FC-INV-01";

// The first wrong finding of each reason. A wrong Euler sum follows from whatever else is wrong with the points. So it
// is a reason only if it is the only one.
[[nodiscard]] std::vector<Finding> first_of_each_reason(const std::vector<Finding>& findings);

}  // namespace flowcert::certify
