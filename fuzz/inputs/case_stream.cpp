// Seeds are mixed, so that neighbouring cases of neighbouring runs have nothing in common.
#include "fuzz/inputs/case_stream.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <stdexcept>
#include <system_error>

#include "fuzz/inputs/input.h"
#include "fuzz/inputs/large_configurations.h"
#include "geometry/mixed_bits.h"

namespace flowcert::fuzz {
namespace {

constexpr std::array<std::size_t, kCaseLevels> kUsualCases{500, 5'000, 20'000};
// RapidCheck's sizes. At 50 most families have up to 8 points, at 75 up to 10, at 100 up to 12.
constexpr std::array<int, kCaseLevels> kLargestSize{50, 75, 100};

// ---- Large inputs ----

// On level 3 one in so many cases is large, for families that can be made larger.
constexpr std::uint64_t kOneInSoMany = 4;
constexpr std::size_t kFewestOfLarge = 101;
constexpr std::size_t kMostOfLarge = 400;

struct LargeFamily {
  std::string_view name;
  Input (*make)(std::size_t points, std::uint64_t seed);
};

Input large_facet(std::size_t points, std::uint64_t seed) { return high_degree_facet(points - 2, seed % 2 == 1, seed); }

constexpr std::array<LargeFamily, 3> kLargeFamilies{
    {{"half-shell", half_shell}, {"high-degree-facet", large_facet}, {"long-cascade", long_cascade}}};

std::optional<Input> large_input(const Family& family, std::uint64_t seed) {
  const auto* const large = std::find_if(kLargeFamilies.begin(), kLargeFamilies.end(),
                                         [&](const LargeFamily& one) { return one.name == family.name; });
  const std::uint64_t dice = geometry::mixed_bits(seed);
  if (large == kLargeFamilies.end() || dice % kOneInSoMany != 0) return std::nullopt;
  return large->make(kFewestOfLarge + geometry::mixed_bits(dice) % (kMostOfLarge - kFewestOfLarge + 1), seed);
}

// ---- Ids ----

// 16 bits of a digest of the doubles' bits and the other parts of the id.
std::uint64_t digest_of(const Input& input, std::string_view text) {
  std::uint64_t digest = 0;
  for (const char c : text) digest = geometry::mixed_bits(digest ^ static_cast<unsigned char>(c));
  for (const Row& row : input.rows) {
    for (const double coordinate : row)
      digest = geometry::mixed_bits(digest ^ std::bit_cast<std::uint64_t>(coordinate));
  }
  return digest & 0xffff;
}

std::string four_hexadecimal_digits(std::uint64_t value) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string text;
  for (int shift = 12; shift >= 0; shift -= 4) text += kDigits[value >> shift & 0xf];
  return text;
}

// Takes the text before a separator, and the separator, off the front. Takes all if there is no separator.
std::string_view next_part(std::string_view& text, char separator) {
  const std::string_view part = text.substr(0, text.find(separator));
  text.remove_prefix(std::min(part.size() + 1, text.size()));
  return part;
}

template <typename Number>
bool read_number(std::string_view text, Number& number) {
  const char* const end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, number);
  return result.ec == std::errc() && result.ptr == end;
}

std::vector<std::size_t> families_listed(std::string_view list) {
  std::vector<std::string> names;
  while (!list.empty()) names.emplace_back(next_part(list, ','));
  return chosen_families(names);
}

// "500", or "500/8".
bool read_cases(std::string_view text, CaseRun& run) {
  const bool leaves_out = text.find('/') != std::string_view::npos;
  return read_number(next_part(text, '/'), run.cases) && (!leaves_out || read_number(text, run.most_points.emplace()));
}

// Throws std::invalid_argument for a family that does not exist.
std::optional<NamedCase> parsed(std::string_view id) {
  NamedCase result;
  const bool has_numbers = read_number(next_part(id, ':'), result.run.level) &&
                           read_number(next_part(id, ':'), result.run.seed) &&
                           read_number(next_part(id, '/'), result.number) && read_cases(next_part(id, ':'), result.run);
  if (!has_numbers || result.run.level < 1 || result.run.level > kCaseLevels || result.run.cases > kMostCases ||
      result.number >= result.run.cases) {
    return std::nullopt;
  }
  (void)next_part(id, ':');
  result.run.chosen = families_listed(id);
  return result;
}

}  // namespace

std::size_t usual_cases(int level) { return kUsualCases.at(static_cast<std::size_t>(level - 1)); }

std::vector<std::size_t> chosen_families(const std::vector<std::string>& names) {
  std::vector<std::size_t> chosen;
  for (std::size_t place = 0; place < families().size(); ++place) {
    const bool is_named = std::find(names.begin(), names.end(), families()[place].name) != names.end();
    if (is_named) chosen.push_back(place);
  }
  for (const std::string& name : names) {
    const bool exists =
        std::any_of(families().begin(), families().end(), [&](const Family& family) { return family.name == name; });
    if (!exists) throw std::invalid_argument("no family is called '" + name + "'");
  }
  if (chosen.size() == families().size()) chosen.clear();
  return chosen;
}

std::vector<std::string> family_names(const CaseRun& run) {
  const std::size_t count = run.chosen.empty() ? families().size() : run.chosen.size();
  std::vector<std::string> names;
  names.reserve(count);
  for (std::size_t number = 0; number < count; ++number) names.push_back(family_of_case(run, number).name);
  return names;
}

const Family& family_of_case(const CaseRun& run, std::size_t number) {
  if (run.chosen.empty()) return families()[number % families().size()];
  return families()[run.chosen[number % run.chosen.size()]];
}

Input input_of_case(const CaseRun& run, std::size_t number) {
  const auto level = static_cast<std::size_t>(run.level);
  const std::uint64_t seed =
      geometry::mixed_bits(geometry::mixed_bits(geometry::mixed_bits(run.seed) ^ level) ^ number);
  const Family& family = family_of_case(run, number);
  if (run.level == kCaseLevels) {
    if (std::optional<Input> large = large_input(family, seed)) return *std::move(large);
  }
  const auto sizes = static_cast<std::uint64_t>(kLargestSize.at(level - 1)) + 1;
  return draw(family, seed, static_cast<int>(geometry::mixed_bits(~seed) % sizes));
}

std::string case_id(const CaseRun& run, std::size_t number, const Input& input) {
  const std::string numbers = std::to_string(run.level) + ':' + std::to_string(run.seed) + ':' +
                              std::to_string(number) + '/' + std::to_string(run.cases) +
                              (run.most_points ? '/' + std::to_string(*run.most_points) : "");
  std::string list;
  for (const std::size_t place : run.chosen) {
    list += (list.empty() ? ':' : ',') + families()[place].name;
  }
  return numbers + ':' + four_hexadecimal_digits(digest_of(input, numbers + list)) + list;
}

std::optional<NamedCase> case_named(std::string_view id) {
  try {
    std::optional<NamedCase> named = parsed(id);
    if (!named) return std::nullopt;
    named->input = input_of_case(named->run, named->number);
    if (named->input.rows.size() > named->run.most_points.value_or(named->input.rows.size())) return std::nullopt;
    // This compares the digest, and makes sure that each case has only one spelling.
    if (case_id(named->run, named->number, named->input) != id) return std::nullopt;
    return named;
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

}  // namespace flowcert::fuzz
