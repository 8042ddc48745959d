// Pockets as `flowcert pockets --json` writes them, or another program: one object of JSON (spec/formats/pockets.md).
//
// Guarantees: a known key has a right value, or the file is refused. The line of a message is the one where the object
// begins.
#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <string_view>

#include "certify/claims/claim_formats.h"
#include "certify/claims/exchange_value.h"
#include "flowcert/claim.h"
#include "io/line_reader.h"
#include "io/number_text.h"

namespace flowcert::certify {

namespace {

constexpr std::string_view kFormatKey = "\"format\"", kFormatName = "flowcert-pockets";

// The first key of this name has this value. In the exchange format it has another.
bool recognises_pockets(std::string_view bytes) {
  bytes = trimmed(bytes);
  const std::size_t key = bytes.find(kFormatKey);
  if (!bytes.starts_with('{') || key == std::string_view::npos) return false;
  bytes = trimmed(bytes.substr(key + kFormatKey.size()));
  if (!bytes.starts_with(':')) return false;
  bytes = trimmed(bytes.substr(1));
  return bytes.starts_with('"') && bytes.substr(1).starts_with(kFormatName);
}

// ---- Values ----

ClaimedDouble double_of(const ExchangeValue& value) {
  return value.is_null() ? ClaimedDouble{} : ClaimedDouble{distance_of(value)};
}

// Numbers that are asked for, not claimed, are exact in any form.
Rational given_number(const ExchangeValue& value) { return distance_of(value).value; }

void read_radii(const ExchangeValue& value, std::optional<ClaimedNumber>& squared_radius,
                std::optional<ClaimedDouble>& radius) {
  if (const auto number = value.find("squared_radius")) squared_radius = distance_of(*number);
  if (const auto number = value.find("radius")) radius = double_of(*number);
}

ClaimedWitness witness_of(const ExchangeValue& value) {
  ClaimedWitness witness;
  witness.contact = contact_of(value.get("contact"));
  if (const auto center = value.find("center")) witness.center = position_of(*center);
  read_radii(value, witness.squared_radius, witness.radius);
  return witness;
}

// witnesses: the key that has them.
ClaimedRadius radius_of(const ExchangeValue& value, const char* witnesses) {
  ClaimedRadius radius;
  read_radii(value, radius.squared_radius, radius.radius);
  radius.witnesses = list_of(value.get(witnesses), witness_of);
  if (radius.witnesses.empty()) value.get(witnesses).reject("one witness or more");
  return radius;
}

ClaimedWhole whole_of(const ExchangeValue& value, const char* witnesses) {
  if (value.is_null()) return {};
  return {radius_of(value, witnesses)};
}

ClaimedCellPart cell_part_of(const ExchangeValue& value) {
  ClaimedCellPart part;
  read_index(value.get("index"), part);
  part.contact = contact_of(value.get("contact"));
  return part;
}

// ---- Pockets ----

class PocketReader {
 public:
  PocketReader(std::size_t pockets, bool has_probe) : pockets_(pockets), has_probe_(has_probe) {}

  [[nodiscard]] ClaimedPocket pocket(const ExchangeValue& value) const {
    ClaimedPocket pocket;
    pocket.maxima = list_of(value.get("maxima"), contact_of);
    if (pocket.maxima.empty()) value.get("maxima").reject("one maximum or more");
    if (const auto peaks = value.find("peaks")) pocket.peaks = list_of(*peaks, witness_of);
    if (const auto depth = value.find("depth")) pocket.depth = double_of(*depth);
    if (const auto number = value.find("difference_of_squares")) pocket.difference_of_squares = distance_of(*number);
    if (const auto volume = value.find("volume")) pocket.volume = double_of(*volume);
    if (const auto cell = value.find("cell")) pocket.cell = list_of(*cell, cell_part_of);
    if (const auto all = value.find("mouths")) {
      pocket.mouths = list_of(*all, [this](const ExchangeValue& one) { return mouth(one); });
    }
    if (const auto rows = value.find("lining")) pocket.lining = ids_of(*rows);
    for (const char* names : {"atoms", "residues"}) (void)value.find(names);  // how a file calls the rows of the lining
    if (const auto all = value.find("neighbours")) pocket.neighbours = numbers(*all);
    if (const auto path = value.find("widest_path")) pocket.widest_path = radius_of(*path, "gates");
    if (const auto passage = value.find("is")) pocket.passage = passage_of(*passage);
    return pocket;
  }

 private:
  [[nodiscard]] ClaimedMouth mouth(const ExchangeValue& value) const {
    ClaimedMouth mouth{witness_of(value), std::nullopt, std::nullopt};
    if (const auto area = value.find("area")) mouth.area = double_of(*area);
    if (const auto between = value.find("between")) mouth.between = numbers(*between);
    return mouth;
  }

  // Pockets of the claim, or -1.
  [[nodiscard]] std::vector<std::int64_t> numbers(const ExchangeValue& value) const {
    return list_of(value, [this](const ExchangeValue& one) -> std::int64_t {
      if (one.number_text() == "-1") return -1;
      const std::size_t number = count_of(one);
      if (number >= pockets_) one.reject("numbers of pockets, or -1: there are " + std::to_string(pockets_));
      return static_cast<std::int64_t>(number);
    });
  }

  [[nodiscard]] std::string passage_of(const ExchangeValue& value) const {
    value.expect_one_of({"cavity", "pocket", "channel"}, "cavity, pocket or channel");
    if (!has_probe_) value.reject("there without a probe");
    return std::string(value.text());
  }

  std::size_t pockets_;
  bool has_probe_;
};

void read_header(const ExchangeValue& object, Claim& claim, ClaimedPockets& pockets) {
  const ExchangeValue format = object.get("format");
  if (format.text() != kFormatName) format.reject(in_quotes(kFormatName));
  const ExchangeValue version = object.get("format_version");
  if (version.number_text() == "1") version.reject("2; in 1 pockets were merged by differences of squared distances");
  if (version.number_text() != "2") version.reject("2, the only version that is known");
  read_input_fields(object, claim);
  if (const auto value = object.find("critical")) pockets.critical_counts = critical_counts_of(*value);
  if (const auto value = object.find("regular_stationary")) pockets.regular_counts = regular_counts_of(*value);
  if (const auto value = object.find("volumes")) value->expect_one_of({"double", "exact"}, "'double' or 'exact'");
}

ClaimedPockets pockets_of(const ExchangeValue& object, Claim& claim) {
  ClaimedPockets pockets;
  pockets.line = object.place().line;
  read_header(object, claim, pockets);
  pockets.squared_persistence = given_number(object.get("squared_persistence"));
  if (const auto probe = object.find("probe"); probe && !probe->is_null()) pockets.probe = given_number(*probe);
  if (const auto value = object.find("pore_limiting_radius")) pockets.pore_limiting_radius = whole_of(*value, "gates");
  if (const auto value = object.find("largest_cavity_radius")) {
    pockets.largest_cavity_radius = whole_of(*value, "balls");
  }
  if (const auto value = object.find("outside")) pockets.outside = list_of(*value, contact_of);
  const ExchangeValue all = object.get("pockets");
  const PocketReader reader(all.size(), pockets.probe.has_value());
  pockets.pockets = list_of(all, [&reader](const ExchangeValue& one) { return reader.pocket(one); });
  return pockets;
}

Claim read_pockets(std::string_view text, std::string_view file, bool /*is_unlimited*/) {
  const std::string_view before = text.substr(0, text.find('{'));  // all of it, where there is no brace
  const auto line = 1 + std::ranges::count(before, '\n');
  const LinePlace place{.file = file, .line = static_cast<std::size_t>(line)};
  const JsonDocument tree = parse_json(text, place);
  Claim claim;
  claim.pockets = pockets_of({tree, "pockets", place}, claim);
  claim.indices = ClaimedIndices{};
  UnknownKeys unknown;
  tree.add_unknown_keys(unknown);
  unknown.tell(claim);
  return claim;
}

}  // namespace

const ClaimFormat kPocketClaims = {.name = "pockets", .recognises = recognises_pockets, .read = read_pockets};

}  // namespace flowcert::certify
