// Compares a file of pairs with all pairs: .pers, their nearest doubles, or the JSON of flowcert persistence, exactly.
#pragma once

#include <tuple>

#include "list.h"
#include "pairs.h"

// Compares multisets.
template <class Pair>
void compare_pairs(std::vector<Pair> written, std::vector<Pair> expected) {
  std::sort(written.begin(), written.end());
  std::sort(expected.begin(), expected.end());
  if (written == expected) return;
  std::vector<Pair> right;
  std::set_intersection(written.begin(), written.end(), expected.begin(), expected.end(), std::back_inserter(right));
  refute("pairs refuted: " + std::to_string(right.size()) + " of " + std::to_string(written.size()) +
         " pairs are right, and all are " + std::to_string(expected.size()));
}

using RoundedPair = std::tuple<int, double, double>;  // dimension, birth and death
inline bool read_pair(const char*& at, RoundedPair& pair) {
  auto& [dimension, birth, death] = pair;
  if (*at < '0' || *at > '9' || at[1] != ' ') return false;
  dimension = *at - '0';
  if (!read_decimal(at += 2, birth) || *at++ != ' ') return false;
  if (std::strncmp(at, "inf", 3) != 0) return read_decimal(at, death) && std::isfinite(death);
  death = HUGE_VAL;
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
  const auto nearest = [&](Rank rank) {
    if (rank == 0 || rank == kNone) return rank == 0 ? 0 : HUGE_VAL;
    auto [n, d] = pairs.squared_diameter(rank);
    const double value = Fraction{std::move(n.value), std::move(d.value), 2 * points.grid_exponent() - 2}.nearest();
    if (std::isinf(value)) cannot_decide(path + ": a squared distance is beyond the doubles");
    return value;
  };
  for (const auto& [dimension, birth, death] : pairs.all())
    expected.emplace_back(dimension, nearest(birth), nearest(death));
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
    const bool is_right = word == std::to_string(record) && record < is_used.size() &&
                          stationary.all()[record].kind == index && !is_used[record];
    if (!is_right) file.refute_here("record " + word + " has another index, or is in another pair");
    is_used[record] = true;
    const StationaryPoint& point = stationary.all()[record];
    file.compare_fields(point, {"contact", "center", "center_double", "squared_distance", "squared_distance_double"});
    reader.need_key("");
    return pairs.rank_of(point.simplex);
  };
  std::vector<PersistencePair> written;
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
  compare_pairs(written, pairs.all());
  return file.skipped;
}
