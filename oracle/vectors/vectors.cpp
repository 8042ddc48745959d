// See vectors.h.
#include "oracle/vectors/vectors.h"

#include <cstdio>
#include <stdexcept>

#include "oracle/vectors/flags.h"
#include "oracle/vectors/starts.h"

namespace oracle::vectors {

namespace {

constexpr int kFormatVersion = 1;

// As printf's %a: the shortest digits, one before the point.
std::string hexadecimal(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%a", value);
  return text;
}

Json points_field(const Rows& rows) {
  Json points = Json::array();
  for (const Row& row : rows) {
    points.push_back({hexadecimal(row[0]), hexadecimal(row[1]), hexadecimal(row[2])});
  }
  return points;
}

bool is_saddle(const StationaryPoint& x) { return x.face_dimension == 2 && x.hull_dimension == 2; }

// The same starts whenever the points are.
std::uint64_t seed_of(const std::string& id) {
  std::uint64_t seed = 14695981039346656037U;
  for (const char letter : id) seed = (seed ^ static_cast<unsigned char>(letter)) * 1099511628211U;
  return seed;
}

// It has a stable set whose skeleton is worth telling.
bool has_stable_field(const StationaryPoint& x) {
  return is_saddle(x) || x.face_dimension != x.hull_dimension;
}

Findings findings_of(const Recipe& recipe, const Answer& answer, const std::vector<Point>& starts) {
  Findings found{PointSet(recipe.points), answer, {}, starts, {}, {}, {}};
  for (const StationaryPoint& x : answer.stationary) {
    if (recipe.limits && is_saddle(x)) found.unstable.push_back(unstable_orbits(found.set, x));
  }
  for (std::size_t i = 0; recipe.stable && i < answer.stationary.size(); ++i) {
    if (!has_stable_field(answer.stationary[i])) continue;
    found.stable.emplace(i, stable_set(found.set, answer.stationary[i]));
  }
  if (recipe.persistence) found.persistence = persistence_pairs(found.set);
  for (const Point& start : starts) found.orbits.push_back(orbit(found.set, start));
  return found;
}

Json stationary_field(const Recipe& recipe, const Findings& found) {
  Json records = Json::array();
  std::size_t saddle = 0;
  for (const StationaryPoint& x : found.answer.stationary) {
    Json record = record_field(x);
    if (recipe.limits && is_saddle(x)) {
      Json limits = Json::array();
      for (const Orbit& path : found.unstable[saddle]) {
        limits.push_back(path.limit ? Json(path.limit->contact) : Json());
      }
      record["limits"] = limits;
      ++saddle;
    }
    if (const auto stable = found.stable.find(records.size()); stable != found.stable.end()) {
      record["stable"] = stable_field(found.set, x, stable->second);
      record["skeleton"] = skeleton_field(found.set, stable->second);
    }
    records.push_back(record);
  }
  return records;
}

// What a symbolic perturbation may make of a regular stationary point: FC-INV-02 counts how many critical
// points collide there, and whichever meet may annihilate each other or stay.
Json alternatives_field(const Answer& answer) {
  Json alternatives = Json::array();
  for (const StationaryPoint& x : answer.stationary) {
    if (x.face_dimension == x.hull_dimension) continue;
    Json claims = Json::array({Json::array()});
    if (x.face_dimension == 1) claims.push_back({1, 2});
    if (x.hull_dimension == 3) claims.push_back({2, 3});
    if (x.face_dimension == 1 && x.hull_dimension == 3) claims.push_back({1, 2, 2, 3});
    alternatives.push_back({{"contact", x.contact}, {"claims", claims}});
  }
  return alternatives;
}

// Whether a value takes one line of a file for people.
constexpr std::size_t kLine = 140;

bool is_flat(const Json& value) {
  for (const Json& part : value) {
    if (part.is_structured() && !part.empty()) return false;
  }
  return true;
}

void write(const Json& value, const std::string& indent, std::string& text) {
  const std::string compact = value.dump();
  if (!value.is_structured() || value.empty() || indent.size() + compact.size() <= kLine ||
      (value.is_array() && is_flat(value))) {
    text += compact;
    return;
  }
  const std::string inner = indent + "  ";
  text += value.is_object() ? "{" : "[";
  const char* separator = "\n";
  for (const auto& [key, part] : value.items()) {
    text += separator + inner;
    if (value.is_object()) text += Json(key).dump() + ": ";
    write(part, inner, text);
    separator = ",\n";
  }
  text += "\n" + indent + (value.is_object() ? "}" : "]");
}

}  // namespace

Json case_of(const Group& group, const Recipe& recipe) {
  const Answer answer = stationary_points(recipe.points);
  std::vector<Point> starts = recipe.starts;
  if (recipe.own_starts > 0) {
    starts = chosen_starts(PointSet(recipe.points), answer, recipe.own_starts, seed_of(recipe.id));
  }
  return case_of(group, recipe, answer, starts);
}

Json case_of(const Group& group, const Recipe& recipe, const Answer& answer,
             const std::vector<Point>& starts) {
  const Findings found = findings_of(recipe, answer, starts);
  const std::vector<std::string> flags = flags_of(recipe.points, found, recipe.aims);
  const Json alternatives = alternatives_field(found.answer);
  Json made = {{"id", recipe.id},
               {"comment", recipe.comment},
               {"flags", flags},
               {"clauses", clauses_of(flags, group.clauses)},
               {"points", points_field(recipe.points)},
               {"result", alternatives.empty() ? "determined" : "acceptable"}};
  Json expected = counts_field(found.answer);
  expected["stationary"] = stationary_field(recipe, found);
  if (found.persistence) expected["persistence"] = persistence_field(*found.persistence);
  if (!found.starts.empty()) expected["orbits"] = Json::array();
  for (std::size_t k = 0; k < found.starts.size(); ++k) {
    expected["orbits"].push_back(orbit_field(found.set, found.starts[k], found.orbits[k]));
  }
  made["expected"] = expected;
  if (!alternatives.empty()) made["alternatives"] = alternatives;
  return made;
}

Json case_of(const Group& group, const InvalidRecipe& recipe) {
  Json made = {{"id", recipe.id},
               {"comment", recipe.comment},
               {"flags", recipe.aims},
               {"clauses", clauses_of(recipe.aims, group.clauses)}};
  made[recipe.text ? "text" : "points"] = recipe.text ? Json(*recipe.text) : Json(recipe.points);
  if (recipe.start) made["start"] = *recipe.start;
  made["result"] = "invalid";
  made["refused"] = recipe.start ? "start" : "points";
  return made;
}

Json group_file(const Group& group, const std::vector<Json>& cases) {
  return {{"format", "flowcert-vectors"},
          {"format_version", kFormatVersion},
          {"generator", "flowcert-make-vectors"},
          {"group", group.name},
          {"title", group.title},
          {"cases", cases}};
}

Json flag_file() {
  Json flags = Json::array();
  for (const Flag& flag : all_flags()) {
    flags.push_back({{"flag", flag.name}, {"meaning", flag.meaning}, {"clauses", flag.clauses}});
  }
  return {{"format", "flowcert-vector-flags"},
          {"format_version", kFormatVersion},
          {"generator", "flowcert-make-vectors"},
          {"flags", flags}};
}

std::string text_of(const Json& file) {
  std::string text;
  write(file, "", text);
  return text + "\n";
}

}  // namespace oracle::vectors
