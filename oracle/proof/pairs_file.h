// Compares a file of pairs with all pairs: .pers, their nearest doubles, or the JSON of flowcert persistence, exactly.
#pragma once

#include "list.h"
#include "pairs.h"

// Compares multisets.
template <class Pair>
void compare_pairs(std::vector<Pair> written, std::vector<Pair> expected) {
  std::sort(written.begin(), written.end());
  std::sort(expected.begin(), expected.end());
  for (std::size_t k = 0; k < std::max(written.size(), expected.size()); ++k) {
    if (k < written.size() && k < expected.size() && written[k] == expected[k]) continue;
    const bool is_wrong = k == expected.size() || (k < written.size() && written[k] < expected[k]);
    refute("pairs refuted: " + std::string(is_wrong ? "too many pairs " : "too few pairs ") +
           (is_wrong ? written[k] : expected[k]).text());
  }
}

// The values are multiples of the grid's square.
inline double nearest_value(const Points& points, const PersistencePairs& pairs, PersistencePairs::Rank rank) {
  if (rank == 0) return 0;
  if (rank == kNone) return HUGE_VAL;
  const auto [center, denominator] = circumcenter<BigInteger>(points, pairs.simplex(rank));
  const mpz_class twice = 2 * denominator.value;
  return Fraction{dot(center, center).value, twice * twice, 2 * points.grid_exponent()}.nearest();
}

struct RoundedPair {
  std::uint32_t dimension;
  double birth, death;
  auto operator<=>(const RoundedPair&) const = default;
  std::string text() const {
    return "of dimension " + std::to_string(dimension) + " from " + std::to_string(birth) + " to " +
           std::to_string(death);
  }
};
inline bool read_pair(const char*& at, RoundedPair& pair) {
  if (*at < '0' || *at > '9' || at[1] != ' ') return false;
  pair.dimension = static_cast<std::uint32_t>(*at - '0');
  at += 2;
  if (!read_decimal(at, pair.birth) || *at != ' ') return false;
  ++at;
  if (std::strncmp(at, "inf", 3) != 0) return read_decimal(at, pair.death) && std::isfinite(pair.death);
  pair.death = HUGE_VAL;
  at += 3;
  return true;
}
inline void compare_rounded(const std::string& path, const Points& points, const PersistencePairs& pairs) {
  std::vector<RoundedPair> written, expected;
  const std::string bytes = bytes_of_file(path);
  std::size_t line = 1;
  for (const char* at = bytes.c_str(); at != bytes.c_str() + bytes.size(); ++at, ++line) {
    const auto fail = [&](const char* why) { cannot_decide(path + ":" + std::to_string(line) + ": " + why); };
    const std::string comment(at, *at == '#' ? std::strcspn(at, "\n") : 0);
    if (comment.starts_with("# With regular stationary points")) fail("it has pairs of length zero");
    if (comment == "# flowcert: plain values, not squared") fail("its values are not squared");
    at += comment.size();
    if (comment.empty() && !read_pair(at, written.emplace_back())) fail("not a dimension, a birth and a death");
    if (*at != '\n') fail("the line does not end");
  }
  for (const auto& [dimension, birth, death] : pairs.pairs()) {
    expected.push_back({dimension, nearest_value(points, pairs, birth), nearest_value(points, pairs, death)});
    const bool is_beyond = std::isinf(expected.back().birth) || (death != kNone && std::isinf(expected.back().death));
    if (is_beyond) cannot_decide(path + ": a squared distance is beyond the doubles");
  }
  compare_pairs(written, expected);
}

// Returns the keys that are not compared.
inline std::string compare_exact(const std::string& path, const Points& points, const StationaryPoints& stationary,
                                 const PersistencePairs& pairs) {
  Comparison file("pairs", path, points, stationary);
  JsonReader& reader = file.reader;
  file.compare_header("flowcert-persistence");
  const std::string key = file.skip(" counts ties_broken seed seconds ratio_to_delaunay ");
  if (key != "has_zero" || !reader.take("false")) reader.fail("it has pairs of length zero, or does not say so");
  std::vector<bool> is_used(stationary.all().size());
  const auto compare_point = [&](std::size_t index) {
    reader.need("{\"record\":");
    const std::string word = reader.word();
    const std::size_t record = std::strtoull(word.c_str(), nullptr, 10);
    if (word != std::to_string(record) || record >= is_used.size() || stationary.all()[record].kind != index) {
      file.refute_here("record " + word + " is no critical point of index " + std::to_string(index));
    }
    if (is_used[record]) file.refute_here("record " + word + " is in two pairs");
    is_used[record] = true;
    const StationaryPoint& point = stationary.all()[record];
    file.compare_fields(point, {"contact", "center", "center_double", "squared_distance", "squared_distance_double"});
    reader.need_key("");
    return pairs.rank_of(point.simplex);
  };
  std::vector<PersistencePairs::Pair> written;
  reader.need_key("pairs");
  reader.need("[");
  while (!reader.take(']')) {
    if (!written.empty()) reader.need(",");
    auto& [dimension, birth, death] = written.emplace_back();
    reader.need_key("dimension");
    const std::string word = reader.word();
    if (word != "0" && word != "1" && word != "2") file.refute_here("there is no pair of dimension " + word);
    dimension = static_cast<std::uint32_t>(word[0] - '0');
    reader.need_key("birth");
    birth = compare_point(dimension);
    reader.need_key("death");
    death = reader.next() == 'n' ? kNone : compare_point(dimension + 1);
    if (death == kNone) reader.need("null");
    reader.need_key("");
  }
  reader.need_key("");
  reader.need("\n");
  if (reader.next() != EOF) reader.fail("there is more than one object");
  compare_pairs(written, pairs.pairs());
  return file.skipped;
}
