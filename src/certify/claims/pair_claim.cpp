// Reads persistence pairs from JSON and from text.
#include "certify/pair_claim.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "certify/claims/named_format.h"
#include "certify/layer.h"
#include "flowcert/write_persistence.h"
#include "geometry/floating_point.h"
#include "io/json_fields.h"
#include "io/line_reader.h"
#include "io/number_text.h"

namespace flowcert {

using namespace certify;

namespace {

// ---- JSON

int dimension_of(const Json& pair) {
  const Json& value = required_field(pair, "dimension");
  const std::int64_t dimension = value.is_number_integer() ? value.get<std::int64_t>() : -1;
  if (dimension < 0 || dimension >= kPairDimensions) throw InvalidInput("'dimension' is not 0, 1 or 2");
  return static_cast<int>(dimension);
}

std::vector<ClaimedPair> pairs_of_json(const Json& object) {
  std::vector<ClaimedPair> pairs;
  const auto value = [](const Json& point) {
    return ClaimedNumber{required_rational(required_field(point, "squared_distance"), "squared_distance"), true};
  };
  for (const Json& pair : required_array(required_field(object, "pairs"), "pairs")) {
    pairs.push_back({dimension_of(pair), value(required_field(pair, "birth")), std::nullopt});
    const Json& death = required_field(pair, "death");
    if (!death.is_null()) pairs.back().death = value(death);
  }
  return pairs;
}

// ---- Text

int dimension_of(std::string_view word, const LinePlace& place) {
  const int dimension = word.size() == 1 && is_digit(word[0]) ? word[0] - '0' : kPairDimensions;
  if (dimension >= kPairDimensions) place.reject("no dimension 0, 1 or 2: " + in_quotes(word));
  return dimension;
}

// GUDHI's tools write in front of each pair the characteristic of the field over which homology was taken. The pairs
// are the same over all fields.
void expect_characteristic(std::string_view word, const LinePlace& place) {
  int value = 0;
  const char* end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, value);
  if (!is_integer(word) || error != std::errc() || stop != end || value < 2) {
    place.reject("no characteristic of a field: " + in_quotes(word));
  }
}

ClaimedPair pair_of_words(std::vector<std::string_view> words, const LinePlace& place) {
  if (words.size() != 3 && words.size() != 4) {
    place.reject("not the words dimension, birth, death, with the characteristic of a field before them or not");
  }
  if (words.size() == 4) {
    expect_characteristic(words.front(), place);
    words.erase(words.begin());
  }
  const auto value = [&](std::string_view word) { return claimed_number(word, PlainInteger::kDecimal, place); };
  ClaimedPair pair{dimension_of(words[0], place), value(words[1]), std::nullopt, place.line};
  if (words[2] != "inf") pair.death = value(words[2]);
  return pair;
}

std::vector<ClaimedPair> pairs_of_text(std::string_view bytes, const std::string& name) {
  std::vector<ClaimedPair> pairs;
  if (bytes.find(kPlainValuesMark) != std::string_view::npos) {
    reject_file(name, "the values are plain distances (persistence --plain); squared ones are judged");
  }
  LineReader lines(bytes, name);
  for (std::string_view line; lines.next_uncommented(line);) {
    pairs.push_back(pair_of_words(words_of(line), lines.place()));
  }
  return pairs;
}

}  // namespace

bool is_before(const ListedPair& a, const ListedPair& b) {
  const geometry::IeeeDoubles ieee;
  if (a.dimension != b.dimension) return a.dimension < b.dimension;
  if (a.birth != b.birth) return a.birth < b.birth;
  return a.death && (!b.death || *a.death < *b.death);
}

bool is_pair_claim(std::string_view bytes, const std::string& name) {
  const geometry::IeeeDoubles ieee;
  const std::string ending = name.ends_with(".gz") ? ".pers.gz" : ".pers";
  if (name.ends_with(ending)) return true;
  const std::string_view text = trimmed(bytes);
  if (text.starts_with('{')) return names_format(text, "flowcert-persistence");
  LineReader lines(text, name);
  bool lasts = false;
  std::size_t columns = 0;
  for (std::string_view line; lines.next_uncommented(line);) {
    const std::vector<std::string_view> words = words_of(line);
    if (columns == 0) columns = words.size();
    if (words.size() != columns || columns < 3 || columns > 4) return false;
    const std::string_view dimension = words[columns - 3];
    if (dimension != "0" && dimension != "1" && dimension != "2") return false;
    lasts = lasts || words.back() == "inf";
  }
  if (lasts && columns == 4) {
    reject_file(name, "four columns, and inf in the last: --claim-format pers reads it as a persistence diagram");
  }
  return lasts;
}

std::vector<ClaimedPair> claimed_pairs_of(std::string_view bytes, const std::string& name) {
  const geometry::IeeeDoubles ieee;
  if (is_all_blank(bytes)) reject_file(name, "empty");
  if (!trimmed(bytes).starts_with('{')) return pairs_of_text(bytes, name);
  const Json object = parse_foreign_json(bytes, name);
  try {
    return pairs_of_json(object);
  } catch (const InvalidInput& error) {
    throw InvalidInput(fmt::format("{}: {}", name, error.what()));
  }
}

}  // namespace flowcert
