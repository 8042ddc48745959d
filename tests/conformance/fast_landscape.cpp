#include "tests/conformance/fast_landscape.h"

#include <map>
#include <set>
#include <sstream>
#include <string>
#include <utility>

#include "certify/cycle_differences.h"
#include "flowcert/pockets.h"
#include "io/json_fields.h"
#include "io/manifold_fields.h"
#include "io/medial_points.h"
#include "io/number_text.h"
#include "io/write_pockets.h"

namespace flowcert::conformance {

using namespace io;

namespace {

Rational number(const Json& text) { return exact_rational(text.get<std::string>()); }

Json tree(const FlowComplex& complex, TreeKind kind) {
  std::ostringstream out;
  write_merge_tree(out, complex, kind);
  const Json written = Json::parse(out.str());
  return {{"leaves", written["leaves"]}, {"nodes", written["nodes"]}};
}

// ---- Pockets ----

// The doubles are left out, which the vectors have not.
void erase_doubles(Json& value) {
  for (const char* key : {"radius", "depth", "area", "lining"}) {
    if (value.is_object()) value.erase(key);
  }
  for (Json& part : value) {
    if (part.is_structured()) erase_doubles(part);
  }
}

Json pockets_at(const FlowComplex& complex, const Json& wanted) {
  const Pockets pockets(complex.merge_trees(), number(wanted["squared_persistence"]));
  const auto written = [&](std::optional<Probe> probe) {
    std::ostringstream out;
    write_pockets(out, {complex, pockets, std::move(probe), true});
    Json json = Json::parse(out.str());
    erase_doubles(json);
    return json;
  };
  const Json all = written({});
  Json answer;
  for (const char* key :
       {"squared_persistence", "pore_limiting_radius", "largest_cavity_radius", "outside", "pockets"}) {
    answer[key] = all[key];
  }
  answer["probes"] = Json::array();
  for (const Json& probe : wanted["probes"]) {
    Json words = Json::array();
    const Json probed = written(Probe{number(probe["probe"])});
    for (const Json& pocket : probed["pockets"]) words.push_back(pocket["is"]);
    answer["probes"].push_back({{"probe", probe["probe"]}, {"is", words}});
  }
  return answer;
}

// ---- The medial axis ----

Json contacts(const FlowComplex& complex, const std::vector<std::size_t>& places) {
  Json field = Json::array();
  for (const std::size_t place : places) field.push_back(complex.stationary().contact(place));
  return field;
}

// All critical points of index 1 and 2 by index and value, and how many of each are chosen.
Json levels(const FlowComplex& complex, const std::vector<std::size_t>& chosen) {
  std::map<std::pair<int, Rational>, std::pair<std::size_t, std::size_t>> counts;
  const auto level_of = [&](std::size_t place) {
    return std::pair(complex.stationary().index(place).hull_dimension, complex.sphere(place).squared_radius);
  };
  for (std::size_t place = 0; place < complex.stationary().size(); ++place) {
    const StationaryIndex index = complex.stationary().index(place);
    if (index.is_critical() && (index.hull_dimension == 1 || index.hull_dimension == 2)) {
      ++counts[level_of(place)].first;
    }
  }
  for (const std::size_t place : chosen) ++counts[level_of(place)].second;
  Json field = Json::array();
  for (const auto& [level, count] : counts) {
    field.push_back({{"index", level.first},
                     {"squared_distance", to_text(level.second)},
                     {"points", count.first},
                     {"above", count.second}});
  }
  return field;
}

// The persistences of vectors are rational, so that a command can be asked for them.
Rational root_of(const Rational& square) {
  const auto root = [](const auto& number) { return boost::multiprecision::mpz_int(sqrt(number)); };
  return {root(boost::multiprecision::mpz_int(numerator(square))),
          root(boost::multiprecision::mpz_int(denominator(square)))};
}

Json medial_axes(const FlowComplex& complex, const Json& wanted) {
  Json answer = {{"angles", Json::array()}, {"persistences", Json::array()}};
  for (const Json& one : wanted["angles"]) {
    const auto chosen = medial_points(complex, {{}, number(one["angle"]), {}}).records;
    answer["angles"].push_back({{"angle", one["angle"]}, {"above", contacts(complex, chosen)}});
  }
  for (const Json& one : wanted["persistences"]) {
    const Rational length = root_of(number(one["squared_persistence"]));
    const LengthBound bound{LengthBound::Unit::kInput, length};
    const auto chosen = medial_points(complex, {bound, {}, {}}).records;
    answer["persistences"].push_back(
        {{"squared_persistence", to_text(length * length)}, {"levels", levels(complex, chosen)}});
  }
  return answer;
}

// ---- Others ----

Json times(const Distribution& counted) {
  Json field = Json::array();
  for (const auto& [value, count] : counted.times()) field.push_back(Json::array({value, count}));
  return field;
}

Json statistics(const FlowComplex& complex) {
  const FlowStatistics& flow = complex.unstable().statistics();
  return {
      {"n_u2", times(flow.n_u2)}, {"n_s2", times(complex.stable().statistics().n_s2)}, {"n_wcc", times(flow.n_wcc)}};
}

Json infinity(const FlowComplex& complex) {
  std::ostringstream out;
  write_skeleton_of_infinity(out, complex.stable().set_of_infinity());
  return Json::parse(out.str());
}

Json location(const FlowComplex& complex, const Json& position) {
  const FlowPlace place = complex.locate(parse_rational_point(words_in_a_row(position)));
  Json field = {{"position", position}, {"kind", "infinity"}, {"index", nullptr}, {"contact", nullptr}};
  if (place.limit) {
    const StationaryIndex index = complex.stationary().index(*place.limit);
    field["kind"] = index.is_critical() ? "critical" : "regular";
    field["index"] = index_field(index);
    field["contact"] = complex.stationary().contact(*place.limit);
  }
  field["nearest"] = place.nearest;
  return field;
}

// The claim with the reasons for what is wrong, each once.
Json judged_cycles(const FlowComplex& complex, const Json& lines) {
  std::string text;
  for (const Json& line : lines) text += line.get<std::string>() + '\n';
  std::set<std::string> reasons;
  for (const PairDifference& difference : cycle_differences(complex, claimed_cycles_of(text, "claim"), 1e-9)) {
    reasons.insert(difference.reason);
  }
  return {{"claim", lines}, {"reasons", reasons}};
}

}  // namespace

void add_fast_landscape(const FlowComplex& complex, const Json& expected, Json& answer) {
  if (expected.contains("merge_trees")) {
    answer["merge_trees"] = {{"pockets", tree(complex, TreeKind::kPockets)},
                             {"components", tree(complex, TreeKind::kComponents)}};
  }
  if (expected.contains("pockets")) {
    answer["pockets"] = Json::array();
    for (const Json& one : expected["pockets"]) answer["pockets"].push_back(pockets_at(complex, one));
  }
  if (expected.contains("medial_axes")) answer["medial_axes"] = medial_axes(complex, expected["medial_axes"]);
  if (expected.contains("infinity")) answer["infinity"] = infinity(complex);
  if (expected.contains("statistics")) answer["statistics"] = statistics(complex);
  if (expected.contains("cycles")) {
    answer["cycles"] = Json::array();
    for (const Json& one : expected["cycles"]) answer["cycles"].push_back(judged_cycles(complex, one["claim"]));
  }
  if (!expected.contains("locations")) return;
  answer["locations"] = Json::array();
  for (const Json& one : expected["locations"]) answer["locations"].push_back(location(complex, one["position"]));
}

}  // namespace flowcert::conformance
