// The conformance vectors of spec/vectors/, against the fast implementation.
//
// Guarantees: every case of every file is run, under all kernels; whatever is expected there is compared as
// JSON, exactly.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "flowcert/connections.h"
#include "flowcert/flow_complex.h"
#include "flowcert/read_points.h"
#include "io/json_fields.h"
#include "io/manifold_fields.h"
#include "io/number_text.h"
#include "oracle/program/read_records.h"
#include "tests/cites.h"
#include "tests/conformance/fast_landscape.h"
#include "tests/conformance/vector_files.h"

namespace flowcert::conformance::vectors_fast_test {

using namespace io;
namespace {

PointSet fast_points(const Json& one) { return PointSet(read_points_from(xyz_text(one), "case.xyz").rows); }

Json fast_records(const FlowComplex& complex) {
  const StationaryPoints& stationary = complex.stationary();
  Json records = Json::array();
  for (std::size_t i = 0; i < stationary.size(); ++i) {
    const StationaryIndex index = stationary.index(i);
    const ExactSphere sphere = complex.sphere(i);
    records.push_back({{"index", index_field(index)},
                       {"kind", index.is_critical() ? "critical" : "regular"},
                       {"contact", stationary.contact(i)},
                       {"center", center_field(sphere.center)},
                       {"squared_distance", to_text(sphere.squared_radius)}});
  }
  return records;
}

void add_fast_limits(const FlowComplex& complex, Json& records) {
  const UnstableManifolds& manifolds = complex.unstable();
  for (std::size_t i = 0; i < manifolds.size(); ++i) {
    Json limits = Json::array();
    for (const std::size_t side : {0U, 1U}) {
      const auto limit = manifolds.limit(i, side);
      limits.push_back(limit ? Json(complex.stationary().contact(*limit)) : Json());
    }
    records[manifolds.saddle(i)]["limits"] = limits;
  }
}

// Adds the contact sets of all index-1 points to which a connecting orbit comes down from it.
Json incidences_of_saddle(const FlowComplex& complex, std::size_t saddle, std::set<Json>& reached) {
  std::map<Json, std::size_t> orbits_to;
  bool has_tie = false;
  for (const BackwardSegment<>& segment : complex.stable().set_of_record(complex.unstable().saddle(saddle)).segments) {
    has_tie = has_tie || segment.back_kind == BackKind::kRegular || segment.back_kind == BackKind::kVertex;
    if (segment.back_kind == BackKind::kCritical) ++orbits_to[segment.back_contact];
  }
  Json ends = Json::array(), boundary = Json::array(), limits = Json::array();
  for (const auto& [contact, count] : orbits_to) {
    reached.insert(contact);
    ends.push_back(contact);
    if (count % 2 == 1) boundary.push_back(contact);
  }
  for (const std::size_t side : {0U, 1U}) {
    const auto limit = complex.unstable().limit(saddle, side);
    limits.push_back(limit ? Json(complex.stationary().contact(*limit)) : Json());
  }
  return {{"limits", limits}, {"ends", ends}, {"boundary", has_tie ? Json() : boundary}};
}

void add_fast_incidences(const FlowComplex& complex, Json& records) {
  std::set<Json> reached;
  for (std::size_t i = 0; i < complex.unstable().size(); ++i) {
    records[complex.unstable().saddle(i)]["incidences"] = incidences_of_saddle(complex, i, reached);
  }
  const FlowLimits& lists = complex.limits();
  for (std::size_t i = 0; i < lists.size(); ++i) {
    Json& record = records[lists.record(i)];
    if (record["index"] != 1 || reached.contains(record["contact"])) continue;
    std::set<Json> finite;
    bool has_infinity = false;
    for (const FlowLimits::Entry& entry : lists.entries(i)) {
      if (entry.limit == FlowLimits::Entry::kInfinity) {
        has_infinity = true;
      } else {
        finite.insert(complex.stationary().contact(entry.limit));
      }
    }
    Json limits = finite;
    if (has_infinity) limits.push_back(nullptr);
    record["incidences"]["limits"] = limits;
  }
}

Json fast_orbit(const FlowComplex& complex, const Json& start) {
  const Orbit path = complex.orbit(parse_rational_point(words_in_a_row(start)));
  Json segments = Json::array();
  for (const FlowSegment& segment : path.segments) segments.push_back(segment_with_contacts_field(segment));
  return {{"start", center_field(path.start)},
          {"segments", segments},
          {"limit", limit_field(complex.points(), path.limit)}};
}

bool any_has(const Json& stationary, const char* key) {
  return std::any_of(stationary.begin(), stationary.end(), [&](const Json& x) { return x.contains(key); });
}

// The sides that a boundary walk goes along, as far as the skeleton knows: those at whose midpoint their
// segment ends, and the side whose midpoint is the regular stationary point itself.
std::multiset<Json> sides_by_skeleton(const Json& record) {
  std::multiset<Json> sides;
  std::map<Json, std::size_t> of_polygon;
  for (const Json& segment : record["skeleton"]["segments"]) {
    if (segment["back_kind"] == "critical" || segment["back_kind"] == "regular") sides.insert(segment["samples"]);
    if (segment["front"] == record["center"]) {
      for (const Json& sample : segment["samples"]) ++of_polygon[sample];
    }
  }
  Json open = Json::array();
  for (const auto& [sample, count] : of_polygon) {
    if (count == 1) open.push_back(sample);
  }
  if (!open.empty()) sides.insert(open);
  return sides;
}

std::multiset<Json> sides_of_walk(const Json& walk) {
  std::multiset<Json> sides;
  for (std::size_t k = 0; k < walk.size(); ++k) {
    const Json &a = walk[k], &b = walk[(k + 1) % walk.size()];
    sides.insert(a < b ? Json{a, b} : Json{b, a});
  }
  return sides;
}

bool any_has_regular_back(const Json& skeleton) {
  return std::any_of(skeleton["segments"].begin(), skeleton["segments"].end(),
                     [](const Json& segment) { return segment["back_kind"] == "regular"; });
}

// The fast implementation has no walk of its own, and a boundary even where there is a tie.
void add_fast_stable_sets(const FlowComplex& complex, const Json& expected, Json& records) {
  const StableManifolds& manifolds = complex.stable();
  for (std::size_t i = 0; i < manifolds.size(); ++i) {
    Json& record = records[manifolds.record(i)];
    const Json& wanted = expected[manifolds.record(i)]["stable"];
    Json stable = stable_field(complex.stationary(), manifolds, i);
    const Json skeleton = skeleton_field(manifolds.set(i));
    const bool has_tie = manifolds.has_vertex(i) || any_has_regular_back(skeleton);
    if (stable.contains("boundary") && has_tie) stable["boundary"] = Json();
    stable["walk"] = Json();
    record["stable"] = stable;
    record["skeleton"] = skeleton;
    if (manifolds.has_vertex(i)) continue;
    const bool is_right = sides_of_walk(wanted["walk"]) == sides_by_skeleton(record);
    record["stable"]["walk"] = is_right ? wanted["walk"] : Json("not along the sides of the skeleton");
  }
}

Json fast_persistence(const Persistence& persistence) {
  Json pairs = Json::array();
  for (const PersistencePair& pair : persistence.pairs()) {
    pairs.push_back({{"dimension", pair.dimension},
                     {"birth", to_text(persistence.squared_value(pair.birth))},
                     {"death", pair.death ? Json(to_text(persistence.squared_value(*pair.death))) : Json()}});
  }
  return pairs;
}

// Pairs come by dimension and birth. Among equal births any order will do.
Json in_order(const Json& pairs) {
  std::vector<Json> sorted = pairs;
  const auto number = [](const Json& text) { return oracle::parse_rational(text)->value; };
  std::sort(sorted.begin(), sorted.end(), [&](const Json& a, const Json& b) {
    if (a["dimension"] != b["dimension"]) return a["dimension"] < b["dimension"];
    if (a["birth"] != b["birth"]) return number(a["birth"]) < number(b["birth"]);
    return !a["death"].is_null() && (b["death"].is_null() || number(a["death"]) < number(b["death"]));
  });
  return sorted;
}

// Without the doubles.
Json fast_lambda(const FlowComplex& complex, std::size_t i) {
  Json field = lambda_field(complex.stationary(), complex.limits().list(i));
  for (Json& direction : field["directions"]) {
    direction.erase("exit_double");
    direction.erase("vector_double");
  }
  return field;
}

void add_fast_lists(const FlowComplex& complex, const Json& expected, Json& records) {
  const FlowLimits& limits = complex.limits();
  const bool has_lambda = any_has(expected, "lambda"), has_connections = any_has(expected, "connections");
  for (std::size_t i = 0; i < limits.size(); ++i) {
    Json& record = records[limits.record(i)];
    if (has_lambda) record["lambda"] = fast_lambda(complex, i);
    if (has_connections) record["connections"] = connections_field(complex.stationary(), connections_of(limits, i));
  }
}

void add_fast_volumes(const FlowComplex& complex, Json& records) {
  const StableVolumes& volumes = complex.volumes();
  for (std::size_t i = 0; i < records.size(); ++i) {
    records[i]["volume"] = to_text(volumes.exact(i));
    for (const auto& [sample, share] : volumes.shares(i)) {
      records[i]["shares"].push_back(Json::array({sample, to_text(share)}));
    }
  }
}

void add_fast_surfaces(const FlowComplex& complex, Json& records) {
  const UnstableSurfaces& surfaces = complex.unstable_surfaces();
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    records[surfaces.record(i)]["u1"] = unstable_surface_field(surfaces.set(i));
  }
}

Json fast_answer(const Json& one, ConstructionKernel kernel) {
  const FlowComplex complex(fast_points(one), {kernel, FacetSearch::kBinary});
  Json answer;
  add_counts(answer, complex.points(), complex.stationary());
  answer.erase("points");
  answer["stationary"] = fast_records(complex);
  const Json& expected = one["expected"]["stationary"];
  if (any_has(expected, "limits")) add_fast_limits(complex, answer["stationary"]);
  if (any_has(expected, "stable")) add_fast_stable_sets(complex, expected, answer["stationary"]);
  if (any_has(expected, "lambda") || any_has(expected, "connections")) {
    add_fast_lists(complex, expected, answer["stationary"]);
  }
  if (any_has(expected, "volume")) add_fast_volumes(complex, answer["stationary"]);
  if (any_has(expected, "u1")) add_fast_surfaces(complex, answer["stationary"]);
  add_fast_incidences(complex, answer["stationary"]);
  if (has(one, "morse_smale")) {
    answer["morse_smale"] = is_morse_smale(complex.stationary(), complex.limits(), complex.stable());
  }
  if (has(one, "persistence")) answer["persistence"] = in_order(fast_persistence(complex.persistence()));
  add_fast_landscape(complex, one["expected"], answer);
  if (!has(one, "orbits")) return answer;
  answer["orbits"] = Json::array();
  for (const Json& path : one["expected"]["orbits"]) {
    answer["orbits"].push_back(fast_orbit(complex, path["start"]));
  }
  return answer;
}

void expect_all_cases(const char* name, ConstructionKernel kernel) {
  for (const Json& one : all_cases()) {
    if (!is_invalid(one)) expect_same(one, name, fast_answer(one, kernel), one["expected"]);
  }
}

TEST(Vectors, TheFastImplementationPassesUnderTheLazyKernel) {
  CITES("FC-IN-02", "FC-IN-03", "FC-IN-04", "FC-CRIT-02", "FC-CRIT-03", "FC-CRIT-04", "FC-CRIT-05", "FC-NUM-01",
        "FC-OUT-01", "FC-OUT-02", "FC-FLOW-01", "FC-FLOW-02", "FC-FLOW-03", "FC-FLOW-05", "FC-FLOW-07", "FC-STAB-01",
        "FC-STAB-04", "FC-STAB-05", "FC-STAB-06", "FC-STAB-07", "FC-PERS-01", "FC-PERS-05", "FC-UNST-01", "FC-UNST-02",
        "FC-CONN-01", "FC-CONN-03", "FC-VOL-01", "FC-VOL-02", "FC-UNST-04", "FC-UNST-05", "FC-UNST-06", "FC-LOC-01",
        "FC-LOC-03", "FC-TREE-02", "FC-TREE-03", "FC-TREE-06", "FC-TREE-07", "FC-POCK-01", "FC-POCK-02", "FC-POCK-03",
        "FC-POCK-04", "FC-POCK-05", "FC-POCK-06", "FC-POCK-07", "FC-POCK-08", "FC-MED-01", "FC-MED-02", "FC-MED-03",
        "FC-STAB-08", "FC-STAT-01", "FC-DIST-01", "FC-DIST-02", "FC-FLOW-09");
  expect_all_cases("lazy", ConstructionKernel::kLazy);
}

TEST(Vectors, TheFastImplementationPassesUnderTheCascadeKernel) {
  CITES("FC-IN-02", "FC-IN-03", "FC-IN-04", "FC-CRIT-02", "FC-CRIT-03", "FC-CRIT-04", "FC-CRIT-05", "FC-NUM-01",
        "FC-OUT-01", "FC-OUT-02", "FC-FLOW-01", "FC-FLOW-02", "FC-FLOW-03", "FC-FLOW-05", "FC-FLOW-07", "FC-STAB-01",
        "FC-STAB-04", "FC-STAB-05", "FC-STAB-06", "FC-STAB-07", "FC-PERS-01", "FC-PERS-05", "FC-UNST-01", "FC-UNST-02",
        "FC-CONN-01", "FC-CONN-03", "FC-VOL-01", "FC-VOL-02", "FC-UNST-04", "FC-UNST-05", "FC-UNST-06");
  expect_all_cases("cascade", ConstructionKernel::kCascade);
}

// It also disagrees where it has not the very same thing to compare with, as for the walk.
TEST(Vectors, TheFastImplementationDisagreesWithWhatIsWrong) {
  CITES("FC-STAB-04", "FC-STAB-07", "FC-PERS-01", "FC-UNST-02", "FC-CONN-01", "FC-CONN-03", "FC-VOL-01", "FC-VOL-02",
        "FC-UNST-04", "FC-LOC-01", "FC-TREE-02", "FC-TREE-06", "FC-POCK-02", "FC-POCK-03", "FC-POCK-06", "FC-MED-02",
        "FC-MED-03", "FC-STAB-08", "FC-STAT-01");
  const std::map<std::string, std::vector<const char*>> wrong = {
      {"stable-manifolds-0005",
       {R"([{"op":"replace","path":"/stationary/6/stable/walk","value":[0,1,2,1]}])",
        R"([{"op":"replace","path":"/stationary/6/stable/walk","value":null}])",
        R"([{"op":"replace","path":"/stationary/6/stable/boundary","value":null}])",
        R"([{"op":"remove","path":"/stationary/6/stable/boundary/0"}])",
        R"([{"op":"replace","path":"/stationary/6/stable/segments","value":4}])",
        R"([{"op":"replace","path":"/stationary/6/stable/has_interval","value":true}])",
        R"([{"op":"replace","path":"/stationary/6/skeleton/segments/1/back/0","value":"1/3"}])",
        R"([{"op":"remove","path":"/stationary/6/skeleton/segments/2"}])"}},
      {"stable-manifolds-0007",
       {R"([{"op":"replace","path":"/stationary/5/stable/walk","value":[0,2,1,2]}])",
        R"([{"op":"replace","path":"/stationary/5/stable/walk","value":[]}])"}},
      {"persistence-0005",
       {R"([{"op":"replace","path":"/persistence/0/death","value":null}])",
        R"([{"op":"replace","path":"/persistence/3/birth","value":"1/3"}])",
        R"([{"op":"remove","path":"/persistence/2"}])"}},
      {"lambda-lists-0017",
       {R"([{"op":"replace","path":"/stationary/5/lambda/directions/0/limit","value":null}])",
        R"([{"op":"replace","path":"/stationary/5/lambda/directions/0/exit/0","value":"1/3"}])",
        R"([{"op":"remove","path":"/stationary/5/lambda/arcs/0"}])"}},
      {"connections-0017",
       {R"([{"op":"replace","path":"/morse_smale","value":true}])",
        R"([{"op":"replace","path":"/stationary/5/connections/0/families","value":7}])",
        R"([{"op":"remove","path":"/stationary/5/connections/0"}])"}},
      {"volumes-0017",
       {R"([{"op":"replace","path":"/stationary/1/volume","value":"1/3"}])",
        R"([{"op":"replace","path":"/stationary/17/volume","value":"49"}])",
        R"([{"op":"remove","path":"/stationary/17/shares/0"}])",
        R"([{"op":"replace","path":"/stationary/17/shares/0/1","value":"1/3"}])"}},
      {"unstable-surfaces-0012",
       {R"([{"op":"replace","path":"/stationary/8/u1/vertices/0/0","value":"1/3"}])",
        R"([{"op":"remove","path":"/stationary/8/u1/traces/0"}])",
        R"([{"op":"replace","path":"/stationary/8/u1/traces/0/to","value":["0","0","-1"]}])",
        R"([{"op":"replace","path":"/stationary/8/u1/sheets/0/samples/1","value":2}])"}},
      {"locations-0006",
       {R"([{"op":"replace","path":"/locations/0/contact/0","value":1}])",
        R"([{"op":"replace","path":"/locations/0/nearest","value":[1]}])",
        R"([{"op":"replace","path":"/locations/0/index","value":2}])"}},
      {"merge-trees-0042",
       {R"([{"op":"replace","path":"/merge_trees/pockets/nodes/0/squared_distance","value":"1/3"}])",
        R"([{"op":"replace","path":"/merge_trees/pockets/nodes/0/parts/0","value":7}])",
        R"([{"op":"remove","path":"/merge_trees/pockets/nodes/0/joined_by/0"}])",
        R"([{"op":"remove","path":"/merge_trees/components/nodes/0"}])",
        R"([{"op":"replace","path":"/merge_trees/components/leaves/0/squared_distance","value":"1"}])"}},
      {"pockets-0042",
       {R"([{"op":"replace","path":"/pockets/0/pockets/0/difference_of_squares","value":"1/3"}])",
        R"([{"op":"replace","path":"/pockets/0/pockets/0/volume","value":"1/3"}])",
        R"([{"op":"remove","path":"/pockets/0/pockets/0/mouths/0"}])",
        R"([{"op":"replace","path":"/pockets/0/pockets/0/mouths/0/between/0","value":-2}])",
        R"([{"op":"remove","path":"/pockets/0/pockets/0/widest_path/gates/0"}])",
        R"([{"op":"replace","path":"/pockets/0/probes/0/is/0","value":"hole"}])",
        R"([{"op":"replace","path":"/pockets/0/pore_limiting_radius","value":null}])",
        R"([{"op":"replace","path":"/pockets/0/outside","value":[[0,1]]}])"}},
      {"medial-axes-0012",
       {R"([{"op":"remove","path":"/medial_axes/angles/0/above/0"}])",
        R"([{"op":"replace","path":"/medial_axes/persistences/0/levels/0/above","value":0}])",
        R"([{"op":"replace","path":"/medial_axes/persistences/0/levels/0/points","value":1}])"}},
      {"infinity-0012",
       {R"([{"op":"remove","path":"/infinity/unbounded_segments/0"}])",
        R"([{"op":"replace","path":"/infinity/unbounded_segments/0/vector/0","value":"1/3"}])",
        R"([{"op":"remove","path":"/infinity/unbounded_sectors/0"}])"}},
      {"cycles-0003",
       {R"([{"op":"replace","path":"/cycles/0/reasons","value":["missing"]}])",
        R"([{"op":"remove","path":"/cycles/0/claim/2"}])",
        R"([{"op":"replace","path":"/cycles/0/claim/1","value":"pair 1/1 3/1"}])"}},
      {"statistics-0012",
       {R"([{"op":"replace","path":"/statistics/n_u2/0/1","value":1}])",
        R"([{"op":"remove","path":"/statistics/n_s2/0"}])",
        R"([{"op":"replace","path":"/statistics/n_wcc","value":[[1,1]]}])"}}};
  std::size_t found = 0;
  for (const Json& one : all_cases()) {
    const auto changes = wrong.find(one["id"]);
    if (changes == wrong.end()) continue;
    ++found;
    for (const char* change : changes->second) {
      Json changed = one;
      changed["expected"] = one["expected"].patch(Json::parse(change));
      EXPECT_NE(fast_answer(changed, ConstructionKernel::kLazy).dump(), changed["expected"].dump()) << change;
    }
  }
  EXPECT_EQ(found, wrong.size());
}

TEST(Vectors, TheFastImplementationPassesUnderTheExactKernel) {
  CITES("FC-NUM-01", "FC-FLOW-01", "FC-FLOW-02", "FC-FLOW-03", "FC-FLOW-05", "FC-FLOW-07");
  expect_all_cases("exact", ConstructionKernel::kExact);
}

TEST(Vectors, TheFastImplementationRefusesWhatIsInvalid) {
  CITES("FC-IN-01", "FC-IN-02", "FC-IN-05", "FC-FLOW-10", "FC-LOC-02");
  for (const Json& one : all_cases()) {
    if (!is_invalid(one)) continue;
    if (one["refused"] == "points") {
      EXPECT_THROW(fast_points(one), InvalidInput) << one["id"];
    } else if (one["points"] == Json::array()) {
      const FlowComplex complex(fast_points(one));
      const RationalPoint start = parse_rational_point(words_in_a_row(one["start"]));
      EXPECT_THROW(static_cast<void>(complex.orbit(start)), InvalidInput) << one["id"];
      EXPECT_THROW(static_cast<void>(complex.step(start)), InvalidInput) << one["id"];
      EXPECT_THROW(static_cast<void>(complex.locate(start)), InvalidInput) << one["id"];
    } else {
      EXPECT_EQ(fast_points(one).size(), one["points"].size()) << one["id"];
      EXPECT_THROW(static_cast<void>(parse_rational_point(words_in_a_row(one["start"]))), InvalidInput) << one["id"];
    }
  }
}

}  // namespace
}  // namespace flowcert::conformance::vectors_fast_test
