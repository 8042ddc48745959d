#include "certify/finding_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "certify/claimed_geometry.h"
#include "geometry/contract.h"
#include "geometry/rational_point.h"

namespace flowcert::certify {

namespace {

constexpr std::size_t kNamesShown = 16;
constexpr std::size_t kDigitsShown = 20;

}  // namespace

std::string shortest_text(double value) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value);
  return {text.data(), end.ptr};
}

std::string shortened(std::string text, std::size_t longest) {
  if (text.size() <= longest) return text;
  text.resize(longest);
  return text + "...";
}

std::string names_text(std::span<const PointId> names) {
  std::string text;
  for (std::size_t k = 0; k < names.size() && k < kNamesShown; ++k) {
    text.append(k == 0 ? "" : " ").append(std::to_string(names[k]));
  }
  return names.size() <= kNamesShown ? text : text + " ... (" + std::to_string(names.size()) + " points)";
}

std::string index_text(StationaryIndex index) {
  std::string text = index.is_critical() ? "critical point of index " : "regular stationary point of kind ";
  text += std::to_string(index.face_dimension);
  if (!index.is_critical()) text.append("-").append(std::to_string(index.hull_dimension));
  return text;
}

std::string target_text(const ClaimedTarget& target) {
  return target.is_infinity ? "infinity" : names_text(target.contact);
}

std::string claim_text(const ClaimedPoint& point) {
  std::string text = point.hull_dimension ? "regular, kind " : "index ";
  text += std::to_string(point.index);
  if (point.hull_dimension) text.append("-").append(std::to_string(*point.hull_dimension));
  if (!point.contact.empty()) text += ", contact set " + names_text(point.contact);
  if (point.contact.empty() && point.center) text += ", at " + position_text(*point.center);
  return text;
}

std::string stationary_text(const Truth& truth, std::size_t record) {
  return index_text(truth.index(record)) + ", contact set " + names_text(truth.contact(record));
}

std::string number_text(const Rational& value) {
  std::string exact = to_text(value);
  if (exact.size() <= kDigitsShown) return exact;
  const std::optional<double> nearest = nearest_double(value);
  if (!nearest) return value > 0 ? "> 1.8e308" : "< -1.8e308";
  return std::string("~").append(shortest_text(*nearest));
}

std::string position_text(const RationalPoint& x) {
  return number_text(x[0]) + " " + number_text(x[1]) + " " + number_text(x[2]);
}

std::string number_text(const ClaimedNumber& number) {
  if (!number.is_exact) {
    Rational scaled = abs(number.value);
    for (std::size_t places = 0; places <= kDigitsShown; ++places, scaled *= 10) {
      if (denominator(scaled) != 1) continue;
      std::string digits = numerator(scaled).str();
      if (digits.size() > kDigitsShown) break;
      if (places == 0) return (number.value < 0 ? "-" : "") + digits;
      if (digits.size() <= places) digits.insert(0, places + 1 - digits.size(), '0');
      digits.insert(digits.size() - places, 1, '.');
      return (number.value < 0 ? "-" : "") + digits;
    }
  }
  return number_text(number.value);
}

std::string position_text(const ClaimedPosition& x) {
  return number_text(x[0]) + " " + number_text(x[1]) + " " + number_text(x[2]);
}

std::string offset_text(const ClaimedPosition& claimed, const RationalPoint& truth, const ValueScale& scale) {
  const Rational off = squared_distance(values_of(claimed), truth);
  if (!nearest_double(off)) return "farther away than doubles reach";
  std::string text =
      off > 0 && as_double(off) == 0 ? "less than 1e-160 away" : fmt::format("{:.3g} away", std::sqrt(as_double(off)));
  const Rational allowed = scale.squared_allowance();
  if (is_exact(claimed) || allowed == 0) return text;
  return text + fmt::format(", {:.3g} times the tolerance", std::sqrt(as_double(Rational(off / allowed))));
}

const Finding& telling_finding(const std::vector<Finding>& findings) {
  FLOWCERT_REQUIRES(!findings.empty() && std::ranges::is_sorted(findings, {}, [](const Finding& finding) {
    return std::pair(finding.is_variation, finding.level);
  }));
  const auto of_a_point = std::ranges::find_if(findings, [&](const Finding& finding) {
    return finding.is_variation == findings.front().is_variation && finding.level == findings.front().level &&
           !finding.contact.empty();
  });
  return of_a_point == findings.end() ? findings.front() : *of_a_point;
}

std::vector<Finding> first_of_each_reason(const std::vector<Finding>& findings) {
  std::vector<Finding> first;
  for (const Finding& finding : findings) {
    const bool is_known = std::ranges::find(first, finding.reason, &Finding::reason) != first.end();
    if (!finding.is_variation && !is_known) first.push_back(finding);
  }
  if (first.size() > 1) std::erase_if(first, [](const Finding& finding) { return finding.clause == kEulerClause; });
  return first;
}

}  // namespace flowcert::certify
