#include "tests/conformance/told_statements.h"

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <sstream>

#include "flowcert/flow_complex.h"
#include "flowcert/read_points.h"
#include "oracle/orbit.h"
#include "oracle/persistence.h"
#include "oracle/program/read_points.h"
#include "oracle/program/read_records.h"
#include "oracle/stable_pieces.h"
#include "oracle/stable_set.h"
#include "oracle/stationary_points.h"

namespace flowcert::conformance {
namespace {

using Words = std::vector<std::string>;

// ---- What is asked ----

std::size_t place_of(const Words& words, const std::string& word) {
  const auto found = std::ranges::find(words, word);
  if (found == words.end()) throw NotAnExample("no word '" + word + "' after '" + words[0] + "'");
  return static_cast<std::size_t>(found - words.begin());
}

RationalPoint position_in(const Words& words) {
  RationalPoint x;
  if (words.size() < 5) throw NotAnExample("no position after '" + words[0] + "'");
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto value = oracle::parse_rational(words[axis + 1]);
    if (!value || !value->canonical) throw NotAnExample("'" + words[axis + 1] + "' is no canonical rational");
    x.at(axis) = Rational(words[axis + 1]);
  }
  return x;
}

std::vector<std::size_t> contact_in(const Words& words, std::size_t end) {
  std::vector<std::size_t> contact;
  for (std::size_t i = 1; i < end; ++i) contact.push_back(std::stoul(words[i]));
  return contact;
}

// ---- What is told ----

template <typename Ids>
std::string ids_text(const Ids& ids) {
  std::string text;
  for (const auto id : ids) text += (text.empty() ? "" : " ") + std::to_string(id);
  return text;
}

std::string prefix(const Words& words, std::size_t count) {
  std::string text = words[0];
  for (std::size_t i = 1; i < count; ++i) text += " " + words[i];
  return text;
}

std::string orbit_text(const Words& words, const Words& types, const std::string& end) {
  std::string text = prefix(words, 4) + " types";
  if (types.empty()) text += " stays";
  for (const std::string& type : types) text += " " + type;
  return text + " ends " + end;
}

std::string limits_text(const Words& words, const std::array<std::string, 2>& ends) {
  return prefix(words, place_of(words, "sides")) + " sides " + ends[0] + " and " + ends[1];
}

// How often a pair with these words is there.
std::string pair_text(const Words& words, const std::multiset<std::string>& pairs) {
  if (words.size() != 6) throw NotAnExample("'pair' needs a dimension, two values and how often");
  return prefix(words, 4) + " times " + std::to_string(pairs.count(prefix(words, 4)));
}

template <typename Value>
std::string pair_key(int dimension, const Value& birth, const std::optional<Value>& death) {
  return "pair " + std::to_string(dimension) + " " + birth.str() + " " + (death ? death->str() : "never");
}

// The contact sets of the index-1 points are ascending.
std::string boundary_text(const Words& words, bool has_tie, const std::set<std::vector<std::size_t>>& edges) {
  std::string text = prefix(words, place_of(words, "edges")) + " edges";
  if (has_tie) return text + " open";
  for (const std::vector<std::size_t>& edge : edges) {
    text += " " + std::to_string(edge.front()) + "-" + std::to_string(edge.back());
  }
  return text;
}

// ---- The fast implementation ----

class FastTeller {
 public:
  explicit FastTeller(const std::string& points) : complex_(PointSet(read_points_from(points, "example.xyz").rows)) {}

  [[nodiscard]] std::string nearest(const Words& words) const {
    return prefix(words, 4) + " contact " + ids_text(complex_.locate(position_in(words)).nearest);
  }
  [[nodiscard]] std::string orbit(const Words& words) const {
    const Orbit found = complex_.orbit(position_in(words));
    Words types;
    for (const FlowSegment& segment : found.segments) types.emplace_back(type_text(segment.type));
    return orbit_text(words, types, found.limit ? ids_text(found.limit->contact) : "infinity");
  }
  [[nodiscard]] std::string limits(const Words& words) const {
    const auto asked = contact_in(words, place_of(words, "sides"));
    for (std::size_t k = 0; k < complex_.unstable().size(); ++k) {
      if (!std::ranges::equal(complex_.stationary().contact(complex_.unstable().saddle(k)), asked)) continue;
      return limits_text(words, {end_of(k, 0), end_of(k, 1)});
    }
    return "no critical point of index 2 with the contact set " + ids_text(asked);
  }
  [[nodiscard]] std::string boundary(const Words& words) const {
    const auto asked = contact_in(words, place_of(words, "edges"));
    const StableManifolds& stable = complex_.stable();
    for (std::size_t k = 0; k < stable.size(); ++k) {
      if (!std::ranges::equal(complex_.stationary().contact(stable.record(k)), asked)) continue;
      const bool has_regular_back = std::ranges::any_of(
          stable.set(k).segments, [](const auto& segment) { return segment.back_kind == BackKind::kRegular; });
      std::set<std::vector<std::size_t>> edges;
      for (const std::uint32_t record : stable.boundary(k)) {
        const auto contact = complex_.stationary().contact(record);
        edges.emplace(contact.begin(), contact.end());
      }
      return boundary_text(words, stable.has_vertex(k) || has_regular_back, edges);
    }
    return "no critical point of index 2 with the contact set " + ids_text(asked);
  }
  [[nodiscard]] std::string pair(const Words& words) const {
    std::multiset<std::string> pairs;
    for (const PersistencePair& one : complex_.persistence().pairs()) {
      std::optional<Rational> death;
      if (one.death) death = complex_.sphere(*one.death).squared_radius;
      pairs.insert(pair_key(one.dimension, complex_.sphere(one.birth).squared_radius, death));
    }
    return pair_text(words, pairs);
  }

 private:
  [[nodiscard]] std::string end_of(std::size_t k, std::size_t side) const {
    const auto limit = complex_.unstable().limit(k, side);
    return limit ? ids_text(complex_.stationary().contact(*limit)) : "infinity";
  }

  FlowComplex complex_;
};

// ---- The oracle ----

class OracleTeller {
 public:
  explicit OracleTeller(const std::string& points) : set_(rows_of(points)) {}

  [[nodiscard]] std::string nearest(const Words& words) const {
    return prefix(words, 4) + " contact " + ids_text(oracle::contact_set(set_, position_in(words)));
  }
  [[nodiscard]] std::string orbit(const Words& words) const {
    const oracle::Orbit found = oracle::orbit(set_, position_in(words));
    Words types;
    for (const oracle::FlowSegment& segment : found.segments) types.push_back(oracle::segment_type(set_, segment));
    return orbit_text(words, types, found.limit ? ids_text(found.limit->contact) : "infinity");
  }
  [[nodiscard]] std::string limits(const Words& words) const {
    const auto asked = contact_in(words, place_of(words, "sides"));
    for (const oracle::StationaryPoint& point : oracle::stationary_points(set_).stationary) {
      if (point.contact != asked || point.face_dimension != 2 || point.hull_dimension != 2) continue;
      return limits_text(words, {end_of(point, 0), end_of(point, 1)});
    }
    return "no critical point of index 2 with the contact set " + ids_text(asked);
  }
  [[nodiscard]] std::string boundary(const Words& words) const {
    const auto asked = contact_in(words, place_of(words, "edges"));
    for (const oracle::StationaryPoint& point : oracle::stationary_points(set_).stationary) {
      if (point.contact != asked || point.face_dimension != 2 || point.hull_dimension != 2) continue;
      const oracle::StableSet stable = oracle::stable_set(set_, point);
      std::set<std::vector<std::size_t>> edges;
      for (const oracle::BackwardSegment& segment : stable.segments) {
        if (segment.back_kind != oracle::BackKind::kCritical) continue;
        if (!edges.insert(segment.back_contact).second) edges.erase(segment.back_contact);
      }
      return boundary_text(words, oracle::has_tie(stable), edges);
    }
    return "no critical point of index 2 with the contact set " + ids_text(asked);
  }
  [[nodiscard]] std::string pair(const Words& words) const {
    std::multiset<std::string> pairs;
    for (const oracle::PersistencePair& one : oracle::persistence_pairs(set_)) {
      pairs.insert(pair_key(one.dimension, one.birth, one.death));
    }
    return pair_text(words, pairs);
  }

 private:
  static std::vector<std::array<double, 3>> rows_of(const std::string& points) {
    std::istringstream in(points);
    return oracle::read_points(in, "example", oracle::PointFormat::kTable);
  }
  [[nodiscard]] std::string end_of(const oracle::StationaryPoint& saddle, int side) const {
    const auto limit = oracle::unstable_orbit(set_, saddle, side).limit;
    return limit ? ids_text(limit->contact) : "infinity";
  }

  oracle::PointSet set_;
};

template <typename Teller>
std::string told(const std::string& points, const Words& words) {
  const Teller teller(points);
  if (words[0] == "nearest") return teller.nearest(words);
  if (words[0] == "orbit") return teller.orbit(words);
  if (words[0] == "boundary") return teller.boundary(words);
  return words[0] == "limits" ? teller.limits(words) : teller.pair(words);
}

}  // namespace

bool is_told(const std::string& keyword) {
  constexpr std::array kKeywords = {"nearest", "orbit", "limits", "boundary", "pair"};
  return std::ranges::find(kKeywords, keyword) != kKeywords.end();
}

std::string told_by_fast(const std::string& points, const Words& statement) {
  return told<FastTeller>(points, statement);
}
std::string told_by_oracle(const std::string& points, const Words& statement) {
  return told<OracleTeller>(points, statement);
}

}  // namespace flowcert::conformance
