// Findings in words.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "certify/layer.h"
#include "flowcert/check.h"

namespace flowcert::certify {

// "3 17 20"; long ones are cut short.
[[nodiscard]] std::string names_text(std::span<const PointId> names);
// "index 2, contact set 3 17 20"
[[nodiscard]] std::string claim_text(const ClaimedPoint& point);
// "critical point of index 2, contact set 0 1 2 3"
[[nodiscard]] std::string stationary_text(const Truth& truth, std::size_t record);
[[nodiscard]] std::string index_text(StationaryIndex index);
// As much of a text as a message shows: the first `longest` characters, and "..." where there are more.
[[nodiscard]] std::string shortened(std::string text, std::size_t longest);
// Exact where that is short, otherwise rounded and marked with ~.
[[nodiscard]] std::string number_text(const Rational& value);
[[nodiscard]] std::string position_text(const RationalPoint& x);
[[nodiscard]] std::string position_text(const ClaimedPosition& x);

// The one to tell first: the first of the lowest level that is about a point, since what is wrong with the
// whole, a count, mostly follows from that. The findings are not empty, and sorted as in a report.
[[nodiscard]] const Finding& telling_finding(const std::vector<Finding>& findings);

}  // namespace flowcert::certify
