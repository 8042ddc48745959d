// The checks, each of which compares two ways to one answer, and the table of properties.
#include "fuzz/properties/property.h"

#include <algorithm>
#include <array>
#include <exception>
#include <system_error>
#include <utility>

#include "flowcert/flow_complex.h"
#include "flowcert/orbit.h"
#include "flowcert/stable_manifolds.h"
#include "flowcert/unstable_manifolds.h"
#include "fuzz/properties/account_of_parts.h"
#include "fuzz/properties/certificate.h"
#include "fuzz/properties/orbit_comparison.h"
#include "fuzz/properties/stable_pieces.h"
#include "fuzz/properties/stationary_comparison.h"
#include "fuzz/properties/subject.h"
#include "geometry/contract.h"
#include "oracle/fast/point_set.h"
#include "oracle/orbit.h"
#include "oracle/persistence.h"
#include "oracle/stable_set.h"

namespace flowcert::property {

namespace {

constexpr FlowOptions kCascadeBinary = {ConstructionKernel::kCascade, FacetSearch::kBinary};
constexpr FlowOptions kCascadeLinear = {ConstructionKernel::kCascade, FacetSearch::kLinear};
constexpr FlowOptions kLazyBinary = {ConstructionKernel::kLazy, FacetSearch::kBinary};
constexpr FlowOptions kLazyLinear = {ConstructionKernel::kLazy, FacetSearch::kLinear};
constexpr FlowOptions kExactBinary = {ConstructionKernel::kExact, FacetSearch::kBinary};
constexpr FlowOptions kExactLinear = {ConstructionKernel::kExact, FacetSearch::kLinear};

// Each orbit by itself.
constexpr FlowOptions unshared(FlowOptions options) {
  options.share = false;
  return options;
}
constexpr const char* kFast = "the fast answer";
// Whatever the usual kernel is, this pair is compared with the oracle too.
constexpr const char* kLazy = "the fast answer, lazy, binary";
constexpr const char* kOracle = "the oracle's answer";

// ---- Critical points ----

struct KindAndClause {
  std::string kind;
  std::string clause;
};

// Both lists are sorted, but not by contact set alone. No two records of a list have the same contact set.
KindAndClause difference_kind(const StationaryAnswer& fast, const StationaryAnswer& oracle) {
  if (fast.points != oracle.points || fast.merged_duplicates != oracle.merged_duplicates) {
    return {"points", "FC-IN-03"};
  }
  const auto find = [](const StationaryAnswer& answer, const std::vector<std::size_t>& contact) {
    const auto found = std::find_if(answer.records.begin(), answer.records.end(),
                                    [&](const Record& one) { return one.contact == contact; });
    return found == answer.records.end() ? nullptr : &*found;
  };
  for (const Record& record : oracle.records) {
    if (find(fast, record.contact) == nullptr) return {"missing", "FC-CRIT-05"};
  }
  for (const Record& record : fast.records) {
    const Record* same = find(oracle, record.contact);
    if (same == nullptr) return {"not-stationary", "FC-CRIT-05"};
    if (order_key(*same) != order_key(record)) return {"index", "FC-CRIT-02"};
    if (*same != record) return {"position", "FC-OUT-01"};
  }
  return fast.records == oracle.records ? KindAndClause{"counts", "FC-OUT-01"} : KindAndClause{"order", "FC-OUT-02"};
}

// Splits "FC-INV-01: ..." into the clause and the complaint.
std::optional<Disagreement> broken_law(const StationaryAnswer& answer, const char* whose) {
  const std::string complaint = broken_clause(answer);
  if (complaint.empty()) return std::nullopt;
  return Disagreement{"law", complaint.substr(0, complaint.find(':')), complaint, whose, to_text(answer), "", ""};
}

// ---- Orbits ----

// Empty if both are the same.
std::string difference_kind(const SegmentRecord& a, const SegmentRecord& b) {
  if (a.type != b.type) return "segment-type";
  if (a.start != b.start || a.start_contact != b.start_contact) return "start";
  if (a.driver != b.driver) return "driver";
  if (a.crossed_contact != b.crossed_contact) return "crossed-face";
  return a == b ? "" : "end";
}

std::string difference_kind(const OrbitRecord& a, const OrbitRecord& b) {
  for (std::size_t k = 0; k < std::min(a.segments.size(), b.segments.size()); ++k) {
    std::string kind = difference_kind(a.segments[k], b.segments[k]);
    if (!kind.empty()) return kind;
  }
  return a.segments.size() != b.segments.size() ? "length" : "limit";
}

struct NamedOrbit {
  std::string name;
  OrbitRecord orbit;
};

std::optional<Disagreement> difference_of_orbits(const std::string& what, const NamedOrbit& a, const NamedOrbit& b) {
  const std::string found = difference(a.orbit, b.orbit);
  if (found.empty()) return std::nullopt;
  const std::string kind = difference_kind(a.orbit, b.orbit);
  return Disagreement{kind,
                      kind == "limit" ? "FC-FLOW-05" : "FC-FLOW-02",
                      what + ": " + found,
                      a.name,
                      to_text(a.orbit),
                      b.name,
                      to_text(b.orbit)};
}

// ---- Unstable manifolds ----

std::string name_of_orbit(const StationaryPoints& stationary, std::size_t record, std::size_t side) {
  return "the orbit of " + text_of(ids(stationary.contact(record))) + " on side " + std::to_string(side);
}

// Compares fast orbits of U2 that were computed in two ways.
std::optional<Disagreement> difference_of_unstable(const Subject& subject, const StationaryPoints& stationary,
                                                   const UnstableManifolds& usual, const FlowOptions& options,
                                                   const char* name) {
  const UnstableManifolds other(subject.complex.diagram(), stationary, options);
  for (std::size_t i = 0; i < usual.size(); ++i) {
    for (const std::size_t side : {std::size_t{0}, std::size_t{1}}) {
      const std::string what = name_of_orbit(stationary, usual.saddle(i), side);
      if (auto found = difference_of_orbits(what, {"lazy, binary, shared", record_of(usual.orbit(i, side))},
                                            {name, record_of(other.orbit(i, side))})) {
        return found;
      }
      if (usual.limit(i, side) != other.limit(i, side)) {
        return Disagreement{"limit", "FC-FLOW-07", what + ": another limit", "", "", "", ""};
      }
    }
  }
  return std::nullopt;
}

// ---- Stable sets ----

std::optional<Disagreement> difference_of_pieces(const std::string& what, const StableSet<>& a, const char* a_name,
                                                 const StableSet<>& b, const char* b_name) {
  if (a == b) return std::nullopt;
  const std::string kind = a.segments != b.segments ? "segments" : a.intervals != b.intervals ? "intervals" : "sectors";
  return Disagreement{kind,      kind == "segments" ? "FC-STAB-04" : "FC-STAB-05", what, a_name, text_of(a), b_name,
                      text_of(b)};
}

// Checks what the list of stable sets says of a set without building it.
std::optional<Disagreement> wrong_summary(const StableManifolds& manifolds, std::size_t i, const std::string& what,
                                          const StableSet<>& pieces, bool has_vertex) {
  const auto wrong = [&](const char* said) {
    return Disagreement{"summary", "FC-STAB-02", what + ": " + said + " is wrong", kOracle, text_of(pieces), "", ""};
  };
  if (manifolds.has_vertex(i) != has_vertex) return wrong("has_vertex()");
  if (manifolds.has_interval(i) == pieces.intervals.empty()) return wrong("has_interval()");
  if (pieces.intervals.empty() && manifolds.segment_count(i) != pieces.segments.size()) {
    return wrong("segment_count()");
  }
  return std::nullopt;
}

std::optional<Disagreement> wrong_boundary(const StationaryPoints& stationary, const StableManifolds& manifolds,
                                           std::size_t i, const std::string& what, const StableSet<>& pieces,
                                           bool has_vertex) {
  const auto expected = boundary_of(pieces, has_vertex);
  if (!expected || !stationary.index(manifolds.record(i)).is_critical()) return std::nullopt;
  std::vector<Ids> edges;
  for (const std::uint32_t record : manifolds.boundary(i)) edges.push_back(ids(stationary.contact(record)));
  std::sort(edges.begin(), edges.end());
  if (edges == *expected) return std::nullopt;
  std::string text;
  for (const Ids& edge : edges) text += text_of(edge) + '\n';
  return Disagreement{"boundary", "FC-STAB-07",   what + ": its boundary is wrong", kFast, text,
                      kOracle,    text_of(pieces)};
}

// ---- The checks ----
// The empty input passes those that need a start or a stationary point.

std::optional<Disagreement> check_critical_points(const Trial& trial) {
  const Subject& subject = subject_of(trial.input);
  const StationaryAnswer fast = fast_answer(subject.complex);
  const StationaryAnswer oracle = oracle_answer(subject.set);
  const std::string found = difference(fast, oracle);
  if (!found.empty()) {
    const auto [kind, clause] = difference_kind(fast, oracle);
    return Disagreement{kind, clause, found, kFast, to_text(fast), kOracle, to_text(oracle)};
  }
  if (auto broken = broken_law(fast, kFast)) return broken;
  return broken_law(oracle, kOracle);
}

std::optional<Disagreement> check_orbit(const Trial& trial) {
  const Subject& subject = subject_of(trial.input);
  if (subject.complex.points().empty()) return std::nullopt;
  const RationalPoint start = start_of(trial);
  const NamedOrbit truth{kOracle, record_of(subject.set, start, oracle::orbit(subject.set, start))};
  for (const auto& [name, options] : {std::pair{kFast, FlowOptions{}}, std::pair{kLazy, kLazyBinary}}) {
    Flow flow(subject.complex.diagram(), options);
    if (auto found = difference_of_orbits("the orbit", {name, record_of(flow.orbit(start))}, truth)) return found;
  }
  return std::nullopt;
}

std::optional<Disagreement> check_unstable_manifolds(const Trial& trial) {
  const Subject& subject = subject_of(trial.input);
  const StationaryPoints& stationary = subject.complex.stationary();
  const UnstableManifolds& manifolds = subject.complex.unstable();
  const UnstableManifolds lazy(subject.complex.diagram(), stationary, kLazyBinary);
  for (std::size_t i = 0; i < manifolds.size(); ++i) {
    const oracle::StationaryPoint saddle = oracle_point(subject.complex.points(), stationary, manifolds.saddle(i));
    for (const std::size_t side : {std::size_t{0}, std::size_t{1}}) {
      const OrbitRecord truth =
          record_of(subject.set, saddle.center, oracle::unstable_orbit(subject.set, saddle, static_cast<int>(side)));
      const std::string what = name_of_orbit(stationary, manifolds.saddle(i), side);
      for (const auto& [name, fast] : {std::pair{kFast, &manifolds}, std::pair{kLazy, &lazy}}) {
        if (auto found = difference_of_orbits(what, {name, record_of(fast->orbit(i, side))}, {kOracle, truth})) {
          return found;
        }
        const auto limit = fast->limit(i, side);
        const bool right = limit.has_value() == truth.limit.has_value() &&
                           (!limit || ids(stationary.contact(*limit)) == truth.limit->contact);
        if (!right) {
          return Disagreement{"limit", "FC-FLOW-07", what + ": limit() is wrong", kOracle, to_text(truth), "", ""};
        }
      }
    }
  }
  return std::nullopt;
}

std::optional<Disagreement> check_stable_sets(const Trial& trial) {
  const Subject& subject = subject_of(trial.input);
  const StationaryPoints& stationary = subject.complex.stationary();
  const StableManifolds& manifolds = subject.complex.stable();
  const StableManifolds lazy(subject.complex.diagram(), stationary, kLazyBinary);
  for (std::size_t i = 0; i < manifolds.size(); ++i) {
    const auto z = oracle_point(subject.complex.points(), stationary, manifolds.record(i));
    const oracle::StableSet truth = oracle::stable_set(subject.set, z);
    const StableSet<> pieces = to_fast(subject.set, truth);
    const std::string what = "the stable set of " + text_of(z.contact);
    for (const auto& [name, fast] : {std::pair{kFast, &manifolds}, std::pair{kLazy, &lazy}}) {
      if (auto found = difference_of_pieces(what, fast->set(i), name, pieces, kOracle)) return found;
      if (auto found = wrong_summary(*fast, i, what, pieces, truth.has_vertex)) return found;
      if (auto found = wrong_boundary(stationary, *fast, i, what, pieces, truth.has_vertex)) return found;
    }
  }
  return std::nullopt;
}

std::optional<Disagreement> check_persistence(const Trial& trial) {
  const Subject& subject = subject_of(trial.input);
  const auto fast = persistence_pairs(subject.complex);
  const auto truth = oracle::persistence_pairs(subject.set);
  if (fast == truth) return std::nullopt;
  return Disagreement{"pairs", "FC-PERS-05", "other persistence pairs", kFast, to_text(fast), kOracle, to_text(truth)};
}

std::optional<Disagreement> check_orbit_kernels(const Trial& trial) {
  const Subject& subject = subject_of(trial.input);
  if (subject.complex.points().empty()) return std::nullopt;
  const RationalPoint start = start_of(trial);
  Flow usual(subject.complex.diagram(), kLazyBinary);
  const OrbitRecord orbit = record_of(usual.orbit(start));
  for (const auto& [name, options] :
       {std::pair{"cascade, binary", kCascadeBinary}, std::pair{"cascade, linear", kCascadeLinear},
        std::pair{"lazy, linear", kLazyLinear}, std::pair{"exact, binary", kExactBinary},
        std::pair{"exact, linear", kExactLinear}}) {
    Flow other(subject.complex.diagram(), options);
    if (auto found =
            difference_of_orbits("the orbit", {"lazy, binary", orbit}, {name, record_of(other.orbit(start))})) {
      return found;
    }
  }
  return std::nullopt;
}

std::optional<Disagreement> check_unstable_kernels(const Trial& trial) {
  const Subject& subject = subject_of(trial.input);
  const StationaryPoints& stationary = subject.complex.stationary();
  const UnstableManifolds usual(subject.complex.diagram(), stationary, kLazyBinary);
  for (const auto& [name, options] :
       {std::pair{"lazy, binary, alone", unshared(kLazyBinary)}, std::pair{"cascade, binary, shared", kCascadeBinary},
        std::pair{"cascade, linear, alone", unshared(kCascadeLinear)},
        std::pair{"exact, linear, shared", kExactLinear}}) {
    if (auto found = difference_of_unstable(subject, stationary, usual, options, name)) return found;
  }
  return std::nullopt;
}

std::optional<Disagreement> check_stable_kernels(const Trial& trial) {
  const Subject& subject = subject_of(trial.input);
  const StationaryPoints& stationary = subject.complex.stationary();
  const auto sets_by = [&](const FlowOptions& flow) {
    return StableManifolds(subject.complex.diagram(), stationary, flow);
  };
  const StableManifolds usual = sets_by(kLazyBinary);
  for (const auto& [name, options] :
       {std::pair{"cascade, binary", kCascadeBinary}, std::pair{"cascade, linear", kCascadeLinear},
        std::pair{"exact, linear", kExactLinear}}) {
    const StableManifolds other = sets_by(options);
    for (std::size_t i = 0; i < usual.size(); ++i) {
      const std::string what = "the stable set of " + text_of(ids(stationary.contact(usual.record(i))));
      if (auto found = difference_of_pieces(what, usual.set(i), "lazy, binary", other.set(i), name)) {
        return found;
      }
      if (!std::ranges::equal(usual.boundary(i), other.boundary(i))) {
        return Disagreement{"boundary", "FC-STAB-07", what + ": another boundary, " + name, "", "", "", ""};
      }
    }
  }
  return std::nullopt;
}

std::optional<Disagreement> check_certificate(const Trial& trial) {
  return disproof(trial.input, certified_answer(subject_of(trial.input).complex));
}

std::optional<Disagreement> check_threads(const Trial& trial) {
  const auto with = [&](unsigned threads) {
    return account_of_parts(FlowComplex(point_set_of(trial.input), {.threads = threads}));
  };
  const std::string alone = with(1);
  for (const unsigned threads : {2U, 3U, 8U}) {
    const std::string together = with(threads);
    if (together == alone) continue;
    const std::string name = std::to_string(threads) + " threads";
    return Disagreement{"threads", "FC-OUT-02", "other parts with " + name, name, together, "one thread", alone};
  }
  return std::nullopt;
}

}  // namespace

// ---- The table ----

oracle::Point start_of(const Trial& trial) {
  FLOWCERT_REQUIRES(!trial.input.rows.empty());
  if (const auto* point = std::get_if<oracle::Point>(&trial.start)) return *point;
  return start_of(oracle::fast::PointSet(trial.input.rows), std::get<StartChoice>(trial.start));
}

const std::vector<Property>& properties() {
  static const std::vector<Property> table = {
      {.name = "critical-points",
       .description = "all stationary points, fast against oracle, and the laws that either must keep",
       .check = check_critical_points},
      {.name = "orbit",
       .description = "the orbit of one start, segment by segment, fast (usual; lazy and binary) against oracle",
       .check = check_orbit},
      {.name = "unstable-manifolds",
       .description = "both orbits of every index-2 point, fast (usual; lazy and binary) against oracle",
       .one_in = 4,
       .check = check_unstable_manifolds},
      {.name = "stable-sets",
       .description =
           "the stable sets of all index-2 and regular stationary points, fast (usual; lazy and binary) against "
           "oracle",
       .most_rows = 10,
       .one_in = 8,
       .check = check_stable_sets},
      {.name = "persistence",
       .description = "persistence pairs, fast against the oracle's of the Čech filtration",
       .most_rows = 8,
       .one_in = 16,
       .check = check_persistence},
      {.name = "orbit-kernels",
       .description = "the orbit by the kernels cascade, lazy and exact, by binary and linear search",
       .one_in = 8,
       .check = check_orbit_kernels},
      {.name = "unstable-kernels",
       .description = "orbits of index-2 points, lazy against cascade and exact, shared against each alone",
       .one_in = 8,
       .check = check_unstable_kernels},
      {.name = "stable-kernels",
       .description = "stable sets and boundaries, the lazy kernel against cascade and exact",
       .one_in = 8,
       .check = check_stable_kernels},
      {.name = "certificate",
       .description = "all stationary points and persistence pairs, proved from the certificate by its checker",
       .most_rows = kAnyRows,
       .check = check_certificate},
      {.name = "threads",
       .description = "all parts of the complex, made by 2, 3 and 8 threads, against one thread",
       .one_in = 0,
       .check = check_threads},
  };
  return table;
}

const Property* property_named(std::string_view name) {
  const auto found =
      std::find_if(properties().begin(), properties().end(), [&](const Property& one) { return one.name == name; });
  return found == properties().end() ? nullptr : &*found;
}

std::optional<Disagreement> disagreement(const Property& property, const Trial& trial) {
  if (trial.input.rows.size() > property.most_rows) return std::nullopt;
  try {
    return property.check(trial);
  } catch (const MachineFailure&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw;  // the machine's failure, too
  } catch (const std::system_error& failure) {
    throw MachineFailure(failure.what());
  } catch (const std::exception& error) {
    return Disagreement{"throws", "FC-IN-01", error.what(), "the exception", error.what(), "", ""};
  }
}

}  // namespace flowcert::property
