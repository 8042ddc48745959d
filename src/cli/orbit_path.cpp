// See orbit_path.h.
#include "cli/orbit_path.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "io/number_text.h"
#include "oracle/read_records.h"

namespace flowcert {

namespace {

using Contact = std::optional<std::vector<PointId>>;

// As much of a number as a message shows.
constexpr std::size_t kLongest = 40;

// ---- Reading

const Json& value_of(const Json& object, const char* key) {
  if (!object.is_object()) throw InvalidInput(fmt::format("no object that could have '{}'", key));
  const auto value = object.find(key);
  if (value == object.end()) throw InvalidInput(fmt::format("no key '{}'", key));
  return *value;
}

const Json::string_t& text_of(const Json& value, const char* what) {
  if (!value.is_string()) throw InvalidInput(fmt::format("'{}' is no string", what));
  return value.get_ref<const Json::string_t&>();
}

RationalPoint position_of(const Json& value, const char* what) {
  if (!value.is_array() || value.size() != 3) {
    throw InvalidInput(fmt::format("'{}' is no array of three rationals", what));
  }
  RationalPoint position;
  for (std::size_t k = 0; k < 3; ++k) position.at(k) = exact_rational(text_of(value[k], what));
  return position;
}

std::vector<PointId> ids_of(const Json& value, const char* what) {
  std::vector<PointId> ids;
  if (!value.is_array()) throw InvalidInput(fmt::format("'{}' is no array", what));
  for (const Json& id : value) {
    if (!id.is_number_unsigned() || id.get<std::uint64_t>() >= (std::uint64_t{1} << 31)) {
      throw InvalidInput(fmt::format("'{}' has something that is no id", what));
    }
    ids.push_back(id.get<PointId>());
  }
  std::ranges::sort(ids);
  return ids;
}

Contact contact_of(const Json& segment, const char* key) {
  const auto value = segment.find(key);
  if (value == segment.end() || value->is_null()) return std::nullopt;
  return ids_of(*value, key);
}

PathSegment segment_of(const Json& object) {
  PathSegment segment;
  segment.type = text_of(value_of(object, "type"), "type");
  segment.driver = position_of(value_of(object, "driver"), "driver");
  const Json& end = value_of(object, "end");
  if (!end.is_null()) segment.end = position_of(end, "end");
  segment.start_contact = contact_of(object, "start_contact");
  segment.crossed_contact = contact_of(object, "crossed_contact");
  segment.end_contact = contact_of(object, "end_contact");
  return segment;
}

std::optional<PathLimit> limit_of(const Json& object) {
  const std::string kind = text_of(value_of(object, "kind"), "kind");
  if (kind == "infinity") return std::nullopt;
  return PathLimit{kind, value_of(object, "index"), position_of(value_of(object, "position"), "position"),
                   ids_of(value_of(object, "contact"), "contact"),
                   exact_rational(text_of(value_of(object, "squared_distance"), "squared_distance"))};
}

// ---- In words

std::string shortened(std::string text) {
  if (text.size() <= kLongest) return text;
  text.resize(kLongest);
  return text + "...";
}

std::string number_words(const Rational& value) { return shortened(to_text(value)); }

std::string position_words(const std::optional<RationalPoint>& position) {
  if (!position) return "infinity";
  return fmt::format("({}, {}, {})", number_words((*position)[0]), number_words((*position)[1]),
                     number_words((*position)[2]));
}

std::string contact_words(const Contact& contact) {
  return contact ? fmt::format("contact set {}", fmt::join(*contact, " ")) : "no contact set";
}

std::string index_words(const Json& index) {
  return shortened(index.dump(-1, ' ', false, Json::error_handler_t::replace));
}

std::string limit_words(const std::optional<PathLimit>& limit) {
  if (!limit) return "infinity";
  return fmt::format("{} point of index {} at {}", shortened(limit->kind), index_words(limit->index),
                     position_words(limit->position));
}

PathDifference wrong(std::size_t k, const std::string& claimed, const std::string& truth) {
  return {false, fmt::format("segment {}: {}", k + 1, claimed), truth};
}

// ---- Comparing

bool are_same_where_claimed(const Contact& claimed, const Contact& truth) {
  return !claimed || claimed == truth;
}

// The parts of a segment that say how it arrives are left out if is_arrival_free.
std::optional<PathDifference> segment_difference(std::size_t k, const PathSegment& claimed,
                                                 const PathSegment& truth, bool is_arrival_free) {
  const std::size_t letters = is_arrival_free ? std::string_view("E-F-").size() : std::string::npos;
  if (claimed.type.substr(0, letters) != truth.type.substr(0, letters)) {
    return wrong(k, "type " + shortened(claimed.type), truth.type);
  }
  if (claimed.driver != truth.driver) {
    return wrong(k, "driver " + position_words(claimed.driver), position_words(truth.driver));
  }
  if (claimed.end != truth.end)
    return wrong(k, "end " + position_words(claimed.end), position_words(truth.end));
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
  const bool is_same_point = claimed && truth && claimed->kind == truth->kind &&
                             claimed->index == truth->index && claimed->position == truth->position;
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

Rational exact_rational(const std::string& text) {
  const auto written = oracle::parse_rational(text);
  if (!written) throw InvalidInput("no rational: " + in_quotes(text));
  return written->value;
}

OrbitPath orbit_path_of(const Json& object) {
  OrbitPath path;
  const Json& segments = value_of(object, "segments");
  if (!segments.is_array()) throw InvalidInput("'segments' is no array");
  for (const Json& segment : segments) path.segments.push_back(segment_of(segment));
  path.limit = limit_of(value_of(object, "limit"));
  return path;
}

std::optional<PathDifference> path_difference(const OrbitPath& claimed, const OrbitPath& truth) {
  std::optional<PathDifference> difference = strict_difference(claimed, truth, false);
  const bool ends_at_regular = truth.limit && truth.limit->kind == "regular";
  if (difference && ends_at_regular && !strict_difference(claimed, truth, true)) {
    difference->is_permitted = true;
  }
  return difference;
}

}  // namespace flowcert
