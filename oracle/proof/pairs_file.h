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
  if (written != expected) refute("pairs refuted: they are not all pairs, each as often as it is one");
}

using RoundedPair = std::tuple<int, double, double>;  // dimension, birth and death
inline bool read_pair(const char* at, RoundedPair& pair) {
  auto& [dimension, birth, death] = pair;
  dimension = *at - '0';
  if (dimension < 0 || dimension > 9 || *++at != ' ' || !read_decimal(++at, birth) || *at++ != ' ') return false;
  death = HUGE_VAL;
  return std::strcmp(at, "inf") == 0 || (read_decimal(at, death) && *at == '\0' && std::isfinite(death));
}
inline void compare_rounded(const std::string& path, const Points& points, const PersistencePairs& pairs) {
  std::vector<RoundedPair> written, expected;
  std::ifstream file(path);
  std::string line;
  for (std::size_t number = 1; std::getline(file, line); ++number) {
    const auto fail = [&](const char* why) { cannot_decide(path + ":" + std::to_string(number) + ": " + why); };
    if (line.starts_with("# With regular stationary points")) fail("it has pairs of length zero");
    if (line == "# flowcert: plain values, not squared") fail("its values are not squared");
    if (line[0] == '#') continue;
    const bool is_text = line.find('\0') == std::string::npos;
    if (!is_text || !read_pair(line.c_str(), written.emplace_back())) fail("not a dimension, a birth and a death");
  }
  if (file.bad()) cannot_decide(path + ": cannot be read");
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
  file.compare_header("flowcert-persistence");
  // Programs before 1.0.0 wrote times, too.
  file.need_key("has_zero", {"counts", "ties_broken", "seed", "seconds", "ratio_to_delaunay"});
  if (!file.take("false")) file.fail("it has pairs of length zero");
  std::vector<bool> is_used(stationary.all().size());
  const auto compare_point = [&](std::size_t index) {
    file.need("{\"record\":");
    const std::string word = file.word();
    const std::size_t record = std::strtoull(word.c_str(), nullptr, 10);
    if (word != std::to_string(record) || record >= is_used.size()) file.refute_here("there is no record " + word);
    const StationaryPoint& point = stationary.all()[record];
    if (point.kind != index) file.refute_here("record " + word + " has another index");
    if (is_used[record]) file.refute_here("record " + word + " is in another pair, too");
    is_used[record] = true;
    file.compare_fields(point, {"contact", "center", "center_double", "squared_distance", "squared_distance_double"});
    file.need("}");
    return pairs.rank_of(point.simplex);
  };
  std::vector<PersistencePair> written;
  file.need_key("pairs");
  file.need("[");
  while (!file.take(']')) {
    if (!written.empty()) file.need(",");
    auto& [dimension, birth, death] = written.emplace_back();
    file.need("{");
    file.need_key("dimension");
    const std::string word = file.word();
    if (word != "0" && word != "1" && word != "2") file.refute_here("there is no pair of dimension " + word);
    dimension = static_cast<std::uint32_t>(word[0] - '0');
    file.need_key("birth");
    birth = compare_point(dimension);
    file.need_key("death");
    death = file.next() == 'n' ? kNone : compare_point(dimension + 1);
    if (death == kNone) file.need("null");
    file.need("}");
  }
  file.need("}\n");
  if (file.next() != EOF) file.fail("there is more than one object");
  compare_pairs(written, pairs.all());
  return file.skipped();
}
