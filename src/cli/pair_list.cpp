// See pair_list.h.
#include "cli/pair_list.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <iterator>
#include <sstream>

#include "cli/orbit_path.h"
#include "io/number_text.h"

namespace flowcert {

namespace {

constexpr int kDimensions = 3;
// As much of a number as a message shows.
constexpr std::size_t kLongest = 60;

bool is_before(const ListedPair& a, const ListedPair& b) {
  if (a.dimension != b.dimension) return a.dimension < b.dimension;
  if (a.birth != b.birth) return a.birth < b.birth;
  return a.death && (!b.death || *a.death < *b.death);
}

// ---- JSON

const Json& value_of(const Json& object, const char* key) {
  if (!object.is_object()) throw InvalidInput(fmt::format("no object that could have '{}'", key));
  const auto value = object.find(key);
  if (value == object.end()) throw InvalidInput(fmt::format("no key '{}'", key));
  return *value;
}

const Json& array_of(const Json& value, const char* what) {
  if (!value.is_array()) throw InvalidInput(fmt::format("'{}' is no array", what));
  return value;
}

int dimension_of(const Json& pair) {
  const Json& value = value_of(pair, "dimension");
  if (!value.is_number_unsigned() || value.get<std::uint64_t>() >= kDimensions) {
    throw InvalidInput("'dimension' is not 0, 1 or 2");
  }
  return value.get<int>();
}

Rational rational_of(const Json& value, const char* what) {
  if (!value.is_string()) throw InvalidInput(fmt::format("'{}' is no string", what));
  return exact_rational(value.get_ref<const Json::string_t&>());
}

PairList pairs_of_json(const std::string& bytes) {
  const Json object = Json::parse(bytes);
  PairList list;
  const auto value = [](const Json& point) {
    return rational_of(value_of(point, "squared_distance"), "squared_distance");
  };
  for (const Json& pair : array_of(value_of(object, "pairs"), "pairs")) {
    list.pairs.push_back({dimension_of(pair), value(value_of(pair, "birth")), std::nullopt});
    const Json& death = value_of(pair, "death");
    if (!death.is_null()) list.pairs.back().death = value(death);
  }
  return list;
}

// ---- Text

int dimension_of(const std::string& word) {
  int dimension = 0;
  const char* end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, dimension);
  if (error != std::errc() || stop != end || dimension < 0 || dimension >= kDimensions) {
    throw InvalidInput("no dimension 0, 1 or 2: " + in_quotes(word));
  }
  return dimension;
}

Rational double_of(const std::string& word) {
  const NumberText number = parse_number(word);
  if (number.fault != nullptr) throw InvalidInput("no squared distance: " + in_quotes(word));
  return Rational(number.value);
}

std::optional<ListedPair> pair_of_line(const std::string& line) {
  std::istringstream in(line.substr(0, line.find('#')));
  const std::vector<std::string> words(std::istream_iterator<std::string>(in), {});
  if (words.empty()) return std::nullopt;
  if (words.size() != 3) throw InvalidInput("not the three words dimension, birth, death");
  ListedPair pair{dimension_of(words[0]), double_of(words[1]), std::nullopt};
  if (words[2] != "inf") pair.death = double_of(words[2]);
  return pair;
}

PairList pairs_of_text(const std::string& bytes, const std::string& name) {
  PairList list{{}, true};
  std::istringstream in(bytes);
  std::string line;
  for (std::size_t number = 1; std::getline(in, line); ++number) {
    try {
      if (const auto pair = pair_of_line(line)) list.pairs.push_back(*pair);
    } catch (const InvalidInput& error) {
      throw InvalidInput(fmt::format("{}:{}: {}", name, number, error.what()));
    }
  }
  return list;
}

// ---- Comparing

// Beyond the doubles stays what it is, which no text can say.
Rational rounded(const Rational& value) {
  const std::optional<double> nearest = nearest_double(value);
  return nearest ? Rational(*nearest) : value;
}

std::vector<ListedPair> in_order(std::vector<ListedPair> pairs, bool is_rounded) {
  for (ListedPair& pair : pairs) {
    if (!is_rounded) break;
    pair.birth = rounded(pair.birth);
    if (pair.death) pair.death = rounded(*pair.death);
  }
  std::erase_if(pairs, [](const ListedPair& pair) { return pair.death == pair.birth; });
  std::ranges::sort(pairs, is_before);
  return pairs;
}

std::string number_words(const Rational& value, bool is_rounded) {
  std::string text =
      is_rounded && nearest_double(value) ? fmt::format("{}", *nearest_double(value)) : to_text(value);
  if (text.size() <= kLongest) return text;
  text.resize(kLongest);
  return text + "...";
}

// What only one side has, by dimension: the first with the first, and so on.
std::vector<PairDifference> differences_of(const std::vector<ListedPair>& claimed,
                                           const std::vector<ListedPair>& truth, bool is_rounded) {
  const auto words = [&](const std::vector<ListedPair>& pairs, std::size_t k) -> std::string {
    if (k >= pairs.size()) return "no such pair";
    const ListedPair& pair = pairs[k];
    return fmt::format("dimension {}, birth {}, death {}", pair.dimension,
                       number_words(pair.birth, is_rounded),
                       pair.death ? number_words(*pair.death, is_rounded) : "inf");
  };
  std::vector<PairDifference> differences;
  for (int dimension = 0; dimension < kDimensions; ++dimension) {
    std::vector<ListedPair> a, b;
    const auto is_of = [&](const ListedPair& pair) { return pair.dimension == dimension; };
    std::ranges::copy_if(claimed, std::back_inserter(a), is_of);
    std::ranges::copy_if(truth, std::back_inserter(b), is_of);
    for (std::size_t k = 0; k < std::max(a.size(), b.size()); ++k) {
      differences.push_back({words(a, k), words(b, k)});
    }
  }
  return differences;
}

}  // namespace

std::vector<ListedPair> expected_pairs_of(const Json& array) {
  std::vector<ListedPair> pairs;
  for (const Json& value : array_of(array, "persistence")) {
    pairs.push_back({dimension_of(value), rational_of(value_of(value, "birth"), "birth"), std::nullopt});
    const Json& death = value_of(value, "death");
    if (!death.is_null()) pairs.back().death = rational_of(death, "death");
    const bool is_positive = !pairs.back().death || pairs.back().birth < *pairs.back().death;
    if (!is_positive) throw InvalidInput("a persistence pair of no length");
  }
  if (!std::ranges::is_sorted(pairs, is_before))
    throw InvalidInput("persistence pairs that are not in order");
  return pairs;
}

PairList claimed_pairs_of(const std::string& bytes, const std::string& name) {
  const std::size_t first = bytes.find_first_not_of(" \t\r\n");
  if (first == std::string::npos) throw InvalidInput(name + ": empty");
  if (bytes[first] != '{') return pairs_of_text(bytes, name);
  try {
    return pairs_of_json(bytes);
  } catch (const InvalidInput& error) {
    throw InvalidInput(fmt::format("{}: {}", name, error.what()));
  }
}

std::vector<PairDifference> pair_differences(const PairList& claimed, const std::vector<ListedPair>& truth) {
  const std::vector<ListedPair> a = in_order(claimed.pairs, claimed.is_rounded);
  const std::vector<ListedPair> b = in_order(truth, claimed.is_rounded);
  std::vector<ListedPair> only_a, only_b;
  std::ranges::set_difference(a, b, std::back_inserter(only_a), is_before);
  std::ranges::set_difference(b, a, std::back_inserter(only_b), is_before);
  return differences_of(only_a, only_b, claimed.is_rounded);
}

}  // namespace flowcert
