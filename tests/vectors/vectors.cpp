#include "tests/vectors/vectors.h"

#include <algorithm>
#include <cstdio>
#include <stdexcept>

#include "oracle/fast/point_set.h"
#include "oracle/program/read_points.h"
#include "oracle/stable_pieces.h"
#include "tests/vectors/flags.h"
#include "tests/vectors/incidences.h"
#include "tests/vectors/landscape_fields.h"
#include "tests/vectors/manifold_fields.h"
#include "tests/vectors/starts.h"

namespace oracle::vectors {

namespace {

constexpr int kFormatVersion = 1;

// The number as printf's %a writes it: the shortest digits, one before the point.
std::string hexadecimal(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%a", value);
  return text;
}

Json points_field(const Rows& rows) {
  Json points = Json::array();
  for (const Row& row : rows) {
    Json point;
    for (const double coordinate : row) point.push_back(hexadecimal(coordinate));
    points.push_back(point);
  }
  return points;
}

bool is_saddle(const StationaryPoint& x) { return x.face_dimension == 2 && x.hull_dimension == 2; }

// A case's starts stay the same while its points do.
std::uint64_t seed_of(const std::string& id) {
  std::uint64_t seed = 14695981039346656037U;
  for (const char letter : id) seed = (seed ^ static_cast<unsigned char>(letter)) * 1099511628211U;
  return seed;
}

// Whether the point has a stable set whose skeleton is worth telling.
bool has_stable_field(const StationaryPoint& x) { return is_saddle(x) || x.face_dimension != x.hull_dimension; }

// Whether finitely many arcs and directions lead out of the point.
bool has_directions(const StationaryPoint& x) { return x.face_dimension == 1 || x.face_dimension == 2; }

Findings findings_of(const Recipe& recipe, const Answer& answer, const std::vector<Point>& starts) {
  Findings found{recipe.points, PointSet(recipe.points), answer, {}, starts, {}, {}, {}};
  const std::vector<StationaryPoint>& all = answer.stationary;
  for (const StationaryPoint& x : all) {
    if (recipe.asks.limits && is_saddle(x)) found.unstable.push_back(unstable_orbits(found.set, x));
  }
  for (std::size_t i = 0; recipe.asks.stable && i < all.size(); ++i) {
    if (has_stable_field(all[i])) found.stable.emplace(i, stable_set(found.set, all[i]));
  }
  for (std::size_t i = 0; recipe.asks.lambda && i < all.size(); ++i) {
    if (has_directions(all[i])) found.lambda.emplace(i, lambda_list(found.set, all[i]));
  }
  if (recipe.asks.connections) {
    found.connections = connections(found.set, all);
    found.morse_smale = is_morse_smale(found.set, all);
  }
  for (std::size_t i = 0; recipe.asks.volumes && i < all.size(); ++i) {
    const StableSet set = stable_set(found.set, all[i]);
    found.volumes.push_back({volume(found.set, set), shares(found.set, set)});
  }
  for (std::size_t i = 0; recipe.asks.surfaces && i < all.size(); ++i) {
    if (all[i].face_dimension == 1) found.surfaces.emplace(i, unstable_surface(found.set, all[i]));
  }
  if (recipe.asks.persistence) found.persistence = persistence_pairs(found.set);
  if (recipe.asks.trees) found.trees = trees_of(found.set, all);
  if (recipe.asks.pockets) found.pockets = pocket_answers(found.set, all);
  if (recipe.asks.medial) found.medial = medial_answer(found.set, all);
  if (recipe.asks.infinity) found.infinity = stable_set_of_infinity(found.set);
  if (recipe.asks.statistics) found.statistics = statistics_answer(found.set, all);
  if (recipe.asks.cycles) found.cycle_claims = cycle_claims(found.set, all);
  found.cycle_claims.insert(found.cycle_claims.end(), recipe.cycle_claims.begin(), recipe.cycle_claims.end());
  for (const Point& start : starts) {
    if (recipe.asks.locations) {
      found.locations.push_back(locate(found.set, start));
    } else {
      found.orbits.push_back(orbit(found.set, start));
    }
  }
  return found;
}

// With the first three starts also a point of the ray to each from its first nearest sample (FC-LOC-03).
void add_points_on_rays(const PointSet& set, std::vector<Point>& starts) {
  const std::vector<Point> before(starts.begin(), starts.begin() + std::min<std::ptrdiff_t>(3, std::ssize(starts)));
  for (const Point& x : before) {
    const Point& p = set.points[set.nearest_places(x).front()];
    const Point on_ray = moved(p, Rational(1, 3), minus(x, p));
    if (std::find(starts.begin(), starts.end(), on_ray) == starts.end()) starts.push_back(on_ray);
  }
}

std::vector<Point> starts_of(const Recipe& recipe, const Answer& answer) {
  const fast::PointSet set(recipe.points);
  std::vector<Point> starts = recipe.starts;
  for (const Point& start : chosen_starts(set, answer, recipe.asks.own_starts, seed_of(recipe.id))) {
    if (std::find(starts.begin(), starts.end(), start) == starts.end()) starts.push_back(start);
  }
  if (recipe.asks.locations) add_points_on_rays(set, starts);
  return starts;
}

// Null for infinity.
Json limit_contact(const Orbit& path) {
  if (!path.limit) return nullptr;
  return path.limit->contact;
}

// What --manifolds all says of the point at this place, as far as it is asked for.
void add_whole_complex(const Recipe& recipe, const Findings& found, std::size_t place, Json& record) {
  const StationaryPoint& x = found.answer.stationary[place];
  if (const auto list = found.lambda.find(place); list != found.lambda.end()) {
    record["lambda"] = lambda_field(found.set, x, list->second);
  }
  if (recipe.asks.connections && has_directions(x)) record["connections"] = connections_field(x, found.connections);
  if (const auto surface = found.surfaces.find(place); surface != found.surfaces.end()) {
    record["u1"] = unstable_surface_field(surface->second);
  }
  if (!recipe.asks.volumes) return;
  const auto& [all, parts] = found.volumes[place];
  record["volume"] = all.str();
  if (all != 0) record["shares"] = shares_field(found.set, parts);
}

Json stationary_field(const Recipe& recipe, const Findings& found) {
  Json records = Json::array();
  std::size_t saddle = 0;
  const std::vector<Json> incident = incidences(found.set, found.answer.stationary);
  for (const StationaryPoint& x : found.answer.stationary) {
    Json record = record_field(x);
    if (recipe.asks.limits && is_saddle(x)) {
      Json limits = Json::array();
      for (const Orbit& path : found.unstable[saddle]) limits.push_back(limit_contact(path));
      record["limits"] = limits;
      ++saddle;
    }
    if (const auto stable = found.stable.find(records.size()); stable != found.stable.end()) {
      record["stable"] = stable_field(found.set, x, stable->second);
      record["skeleton"] = skeleton_field(found.set, stable->second);
    }
    add_whole_complex(recipe, found, records.size(), record);
    if (!incident[records.size()].is_null()) record["incidences"] = incident[records.size()];
    records.push_back(record);
  }
  return records;
}

// The sign of the cosine of a tetrahedron's angle at its edge through the centre. It is 0 for more than four samples,
// because a perturbation can then leave any tetrahedron.
int sign_at_edge(const PointSet& set, const StationaryPoint& x) {
  if (x.contact.size() != 4) return 0;
  std::vector<Point> from;  // the centre
  for (const std::size_t place : places_of(set, x.contact)) from.push_back(minus(set.points[place], x.center));
  const Point zero = {0, 0, 0};
  for (std::size_t k = 1; k < 4; ++k) {
    // The edge is that of samples 0 and k, or that of the two others.
    const std::size_t one = k == 1 ? 2 : 1, other = k == 3 ? 2 : 3;
    for (const auto& [a, b, r, s] :
         {std::array{from[0], from[k], from[one], from[other]}, std::array{from[one], from[other], from[0], from[k]}}) {
      if (minus(a, minus(zero, b)) != zero) continue;
      const Rational cosine = dot(r, s) * dot(a, a) - dot(r, a) * dot(s, a);
      return cosine > 0 ? 1 : cosine < 0 ? -1 : 0;
    }
  }
  throw std::logic_error("a regular stationary point of kind 1-3 without an edge through it");
}

// What a perturbation may make of a regular stationary point (FC-CLAIM-04).
Json alternatives_field(const PointSet& set, const Answer& answer) {
  using Claims = std::vector<std::vector<int>>;  // each the indices that are claimed there
  Json alternatives = Json::array();
  for (const StationaryPoint& x : answer.stationary) {
    if (x.face_dimension == x.hull_dimension) continue;
    const bool is_kind_13 = x.face_dimension == 1 && x.hull_dimension == 3;
    const int angle = is_kind_13 ? sign_at_edge(set, x) : 0;
    Claims claims(1);  // none
    if (x.face_dimension == 1 && angle >= 0) claims.push_back({1, 2});
    if (x.hull_dimension == 3 && angle <= 0) claims.push_back({2, 3});
    if (is_kind_13) claims.push_back({1, 2, 2, 3});
    Json alternative;
    alternative["contact"] = x.contact;
    alternative["claims"] = claims;
    alternatives.push_back(alternative);
  }
  return alternatives;
}

// What cases of all sorts begin with.
Json head_of(const Group& group, const std::string& id, const std::string& comment,
             const std::vector<std::string>& flags) {
  Json made;
  made["id"] = id;
  made["comment"] = comment;
  made["flags"] = flags;
  made["clauses"] = clauses_of(flags, group.clauses);
  return made;
}

Json head_of_file(const char* format) {
  Json file;
  file["format"] = format;
  file["format_version"] = kFormatVersion;
  file["generator"] = "flowcert-make-vectors";
  return file;
}

// The width of a line of a file for people.
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
  const Answer answer = stationary_points(fast::PointSet(recipe.points));
  return case_of(group, recipe, answer, starts_of(recipe, answer));
}

Json case_of(const Group& group, const Recipe& recipe, const Answer& answer, const std::vector<Point>& starts) {
  const Findings found = findings_of(recipe, answer, starts);
  const std::vector<std::string> flags = flags_of(found, recipe.aims);
  const Json alternatives = alternatives_field(found.set, found.answer);
  Json made = head_of(group, recipe.id, recipe.comment, flags);
  made["points"] = points_field(recipe.points);
  made["result"] = alternatives.empty() ? "determined" : "acceptable";
  Json expected = counts_field(found.answer);
  expected["stationary"] = stationary_field(recipe, found);
  if (found.morse_smale) expected["morse_smale"] = *found.morse_smale;
  if (recipe.asks.persistence) expected["persistence"] = persistence_field(found.persistence);
  if (found.trees) expected["merge_trees"] = trees_field(found.answer.stationary, *found.trees);
  if (recipe.asks.pockets) expected["pockets"] = pockets_field(found.answer.stationary, found.pockets);
  if (found.medial) expected["medial_axes"] = medial_field(found.answer.stationary, *found.medial);
  if (found.infinity) expected["infinity"] = infinity_field(found.set, *found.infinity);
  if (found.statistics) expected["statistics"] = statistics_field(*found.statistics);
  for (const CycleClaim& claim : found.cycle_claims) {
    Json& one = expected["cycles"].emplace_back();
    one["claim"] = claim.lines;
    one["reasons"] = claim.reasons;
  }
  for (std::size_t k = 0; k < found.orbits.size(); ++k) {
    expected["orbits"].push_back(orbit_field(found.set, found.starts[k], found.orbits[k]));
  }
  for (std::size_t k = 0; k < found.locations.size(); ++k) {
    expected["locations"].push_back(location_field(found.starts[k], found.locations[k]));
  }
  made["expected"] = expected;
  if (!alternatives.empty()) made["alternatives"] = alternatives;
  return made;
}

Json case_of(const Group& group, const InvalidRecipe& recipe) {
  Json made = head_of(group, recipe.id, recipe.comment, recipe.aims);
  if (recipe.text) made["text"] = *recipe.text;
  if (!recipe.text) made["points"] = recipe.points;
  if (recipe.start) made["start"] = *recipe.start;
  made["result"] = "invalid";
  made["refused"] = recipe.start ? "start" : "points";
  return made;
}

Json group_file(const Group& group, const std::vector<Json>& cases) {
  Json file = head_of_file("flowcert-vectors");
  file["group"] = group.name;
  file["title"] = group.title;
  file["cases"] = cases;
  return file;
}

Json flag_file() {
  Json file = head_of_file("flowcert-vector-flags");
  for (const Flag& flag : all_flags()) {
    Json field;
    field["flag"] = flag.name;
    field["meaning"] = flag.meaning;
    field["clauses"] = fields(flag.clauses);
    file["flags"].push_back(field);
  }
  return file;
}

std::string text_of(const Json& file) {
  std::string text;
  write(file, "", text);
  return text + "\n";
}

}  // namespace oracle::vectors
