// Compares segment by segment, and tells the first difference in words.
#include "flowcert/orbit_difference.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "certify/finding_words.h"
#include "geometry/floating_point.h"

namespace flowcert {

using namespace certify;

namespace {

using Contact = std::optional<std::vector<PointId>>;

// A message shows at most this many characters of a number.
constexpr std::size_t kLongest = 40;

// ---- In words

std::string number_words(const Rational& value) { return shortened(to_text(value), kLongest); }

std::string position_words(const std::optional<RationalPoint>& position) {
  if (!position) return "infinity";
  return fmt::format("({}, {}, {})", number_words((*position)[0]), number_words((*position)[1]),
                     number_words((*position)[2]));
}

std::string contact_words(const Contact& contact) {
  return contact ? fmt::format("contact set {}", fmt::join(*contact, " ")) : "no contact set";
}

std::string limit_words(const std::optional<PathLimit>& limit) {
  if (!limit) return "infinity";
  return fmt::format("{} point of index {} at {}", shortened(limit->kind, kLongest), shortened(limit->index, kLongest),
                     position_words(limit->position));
}

PathDifference wrong(std::size_t k, const std::string& claimed, const std::string& truth) {
  return {false, fmt::format("segment {}: {}", k + 1, claimed), truth};
}

// ---- Comparing

bool are_same_where_claimed(const Contact& claimed, const Contact& truth) { return !claimed || claimed == truth; }

// If is_arrival_free, the last letter of the type and the contact set of the end are not compared.
std::optional<PathDifference> segment_difference(std::size_t k, const PathSegment& claimed, const PathSegment& truth,
                                                 bool is_arrival_free) {
  const std::size_t letters = is_arrival_free ? std::string_view("E-F-").size() : std::string::npos;
  if (claimed.type.substr(0, letters) != truth.type.substr(0, letters)) {
    return wrong(k, "type " + shortened(claimed.type, kLongest), truth.type);
  }
  if (claimed.driver != truth.driver) {
    return wrong(k, "driver " + position_words(claimed.driver), position_words(truth.driver));
  }
  if (claimed.end != truth.end) return wrong(k, "end " + position_words(claimed.end), position_words(truth.end));
  const auto differ = [&](const char* what, const Contact& of_claim, const Contact& of_truth) {
    return wrong(k, fmt::format("{}, {}", what, contact_words(of_claim)), contact_words(of_truth));
  };
  if (!are_same_where_claimed(claimed.start_contact, truth.start_contact)) {
    return differ("start", claimed.start_contact, truth.start_contact);
  }
  if (!are_same_where_claimed(claimed.crossed_contact, truth.crossed_contact)) {
    return differ("on the way", claimed.crossed_contact, truth.crossed_contact);
  }
  if (!is_arrival_free && !are_same_where_claimed(claimed.end_contact, truth.end_contact)) {
    return differ("end", claimed.end_contact, truth.end_contact);
  }
  return std::nullopt;
}

std::optional<PathDifference> limit_difference(const std::optional<PathLimit>& claimed,
                                               const std::optional<PathLimit>& truth) {
  if (!claimed && !truth) return std::nullopt;
  const bool is_same_point = claimed && truth && claimed->kind == truth->kind && claimed->index == truth->index &&
                             claimed->position == truth->position;
  if (!is_same_point) return PathDifference{false, "limit " + limit_words(claimed), limit_words(truth)};
  if (claimed->contact != truth->contact) {
    return PathDifference{false, "limit, " + contact_words(claimed->contact), contact_words(truth->contact)};
  }
  if (claimed->squared_distance != truth->squared_distance) {
    return PathDifference{false, "limit, squared distance " + number_words(claimed->squared_distance),
                          number_words(truth->squared_distance)};
  }
  return std::nullopt;
}

std::optional<PathDifference> strict_difference(const OrbitPath& claimed, const OrbitPath& truth,
                                                bool is_arrival_free) {
  for (std::size_t k = 0; k < std::min(claimed.segments.size(), truth.segments.size()); ++k) {
    const bool is_last = k + 1 == truth.segments.size();
    auto found = segment_difference(k, claimed.segments[k], truth.segments[k], is_last && is_arrival_free);
    if (found) return found;
  }
  const bool may_have_more = is_arrival_free && claimed.segments.size() > truth.segments.size();
  if (claimed.segments.size() != truth.segments.size() && !may_have_more) {
    return PathDifference{false, fmt::format("{} segments", claimed.segments.size()),
                          fmt::format("{}", truth.segments.size())};
  }
  return is_arrival_free ? std::nullopt : limit_difference(claimed.limit, truth.limit);
}

}  // namespace

std::optional<PathDifference> path_difference(const OrbitPath& claimed, const OrbitPath& truth) {
  const geometry::IeeeDoubles ieee;
  std::optional<PathDifference> difference = strict_difference(claimed, truth, false);
  const bool ends_at_regular = truth.limit && truth.limit->kind == "regular";
  if (difference && ends_at_regular && !strict_difference(claimed, truth, true)) {
    difference->is_permitted = true;
  }
  return difference;
}

}  // namespace flowcert
