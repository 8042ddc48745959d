// Every public function of the library is called with every mode for doubles that another library may have set in the
// thread: its result has the bits that it always has, and the caller's modes are as they were.
//
// Guarantees: public_functions_test.py compares the names here with those in the public headers. Among the modes is
// one in which every inexact operation, and every one on a subnormal, ends the test program.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <cfenv>
#include <cstring>
#include <fstream>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "certify/viewer_claim.h"
#include "flowcert/ball_cavities.h"
#include "flowcert/connections.h"
#include "flowcert/loop_classes.h"
#include "flowcert/loops.h"
#include "flowcert/pores.h"
#include "flowcert/profile.h"
#include "flowcert/read_balls.h"
#include "flowcert/reproducibility.h"
#include "flowcert/stable_manifolds.h"
#include "flowcert/write_persistence.h"
#include "flowcert/write_stationary_points.h"
#include "io/clip_box.h"
#include "io/cycle_exports.h"
#include "io/region_exports.h"
#include "io/surface_selection.h"
#include "io/triangle_orientation.h"
#include "io/unstable_surface_export.h"
#include "io/viewer_page.h"
#include "io/write_cycles.h"
#include "io/write_pockets.h"
#include "io/write_pores.h"
#include "morse/flow_locator.h"
#include "morse/length_bound.h"
#include "morse/stable_regions.h"
#include "tests/cites.h"
#include "tests/result_text.h"

#if defined(__x86_64__) && defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace flowcert::every_mode_test {
namespace {

// ---- Modes ----

struct Mode {
  const char* name;
  void (*set)();
};

#if defined(__x86_64__) && defined(__SSE2__)
constexpr unsigned kFlushResults = 0x8000, kFlushOperands = 0x40, kAllTraps = 0x1f80;
void set_x87(unsigned short word) { __asm__ volatile("fldcw %0" : : "m"(word)); }
#endif

const Mode kModes[] = {
    {"upward", [] { std::fesetround(FE_UPWARD); }},
    {"downward", [] { std::fesetround(FE_DOWNWARD); }},
    {"toward zero", [] { std::fesetround(FE_TOWARDZERO); }},
#if defined(__x86_64__) && defined(__SSE2__)
    {"subnormal results flushed", [] { _mm_setcsr(_mm_getcsr() | kFlushResults); }},
    {"subnormal operands flushed", [] { _mm_setcsr(_mm_getcsr() | kFlushOperands); }},
    {"x87 with 24 bits", [] { set_x87(0x007f); }},
    {"traps", [] { _mm_setcsr(_mm_getcsr() & ~(kAllTraps | 0x3fU)); }},
#endif
};

// While it stands, this thread has the mode.
class InMode {
 public:
  explicit InMode(const Mode& mode) {
    std::fegetenv(&before_);
    mode.set();
    std::fegetenv(&set_);
  }
  ~InMode() { std::fesetenv(&before_); }
  InMode(const InMode&) = delete;
  InMode& operator=(const InMode&) = delete;
  [[nodiscard]] bool stands() const {
#if defined(__x86_64__) && defined(__SSE2__)
    std::fenv_t now;
    std::fegetenv(&now);
    // Flags tell what has happened, and are no mode.
    return now.__control_word == set_.__control_word && (now.__mxcsr & ~0x3fU) == (set_.__mxcsr & ~0x3fU);
#else
    return true;
#endif
  }

 private:
  std::fenv_t before_, set_;
};

const char* called = "";
void tell_trap(int) {
  const char before[] = "a trap was sprung in ";
  (void)!::write(STDERR_FILENO, before, sizeof before - 1);
  (void)!::write(STDERR_FILENO, called, std::strlen(called));
  (void)!::write(STDERR_FILENO, "\n", 1);
  ::_exit(1);
}

// ---- Calls ----

// Makes the text of a result, in the usual mode.
using Text = std::function<std::string()>;

class Calls {
 public:
  // `call` is made in each mode. What it returns is read with `text`.
  template <class Call, class ToText>
  void add(const char* name, Call call, ToText text) {
    all_.emplace_back(name, [call, text]() -> Text {
      auto result = std::make_shared<decltype(call())>(call());
      return [result, text] { return text(*result); };
    });
  }
  template <class Call>
  void add(const char* name, Call call) {
    add(name, call, [](const auto& result) { return result_text(result); });
  }
  // For what writes into a stream.
  template <class Write>
  void add_writer(const char* name, Write write) {
    add(
        name,
        [write] {
          auto out = std::make_unique<std::ostringstream>();
          write(*out);
          return out;
        },
        [](const auto& out) { return out->str(); });
  }
  [[nodiscard]] const std::vector<std::pair<const char*, std::function<Text()>>>& all() const { return all_; }

 private:
  std::vector<std::pair<const char*, std::function<Text()>>> all_;
};

// ---- Inputs ----

struct Input {
  const char* name;
  std::vector<Point> rows;
};

// Decimals, which no double is, and so every result is rounded; a regular grid's corner, for collisions; and the same
// near the smallest doubles, where coordinates and all squared distances are subnormal.
std::vector<Input> inputs() {
  const std::vector<Point> decimals = {{0.1, 0.7, 0.3}, {1.3, 0.2, 0.9}, {0.4, 1.9, 0.6}, {1.1, 1.2, 1.7},
                                       {0.6, 0.5, 2.3}, {2.1, 1.4, 0.2}, {1.7, 2.2, 1.1}, {0.2, 2.4, 1.9},
                                       {2.3, 0.1, 1.6}, {1.2, 1.1, 0.4}, {0.9, 1.6, 2.6}, {0.1, 0.7, 0.3}};
  std::vector<Point> grid;
  for (int k = 0; k < 12; ++k) grid.push_back({0.1 * (k % 2), 0.1 * (k / 2 % 2), 0.1 * (k / 4)});
  std::vector<Point> tiny;
  for (const Point& p : std::span(decimals).first(7))
    tiny.push_back({p.x * 0x1p-1068, p.y * 0x1p-1068, p.z * 0x1p-1068});
  return {{"decimals", decimals}, {"grid", grid}, {"tiny", tiny}};
}

// Everything that the calls take, made in the usual mode.
struct Made {
  explicit Made(std::vector<Point> of)
      : rows(std::move(of)),
        points(rows),
        complex(points, {.threads = 2}),
        pockets(complex.merge_trees(), Rational(0)),
        truth(fast_truth(complex)),
        saddle(complex.stationary().critical_counts()[0]),
        start{Rational(points[0].x) / 3, Rational(points[1].y) / 7, Rational(points[2].z) / 11} {
    for (std::size_t part = 0; part < kFlowComplexParts; ++part) complex.make(static_cast<FlowComplexPart>(part));
    std::ostringstream out;
    write_stationary_points(out, complex, {.u2 = true, .s2 = true, .all = true});
    claim_text = out.str();
    claim = read_claim_from(claim_text, "claim");
    pairs = listed_pairs(complex);
    claimed_pairs = claimed_pairs_of(pers_text(PersistenceDiagram(complex, false)), "pairs");
    for (std::size_t set = 0; set < complex.stationary().critical_counts()[2]; ++set) sets.push_back(set);
    mesh = surface_mesh(complex, sets);
    upper = complex.stationary().size() - 1;
  }
  [[nodiscard]] std::span<const PointId> contact() const { return complex.stationary().contact(saddle); }

  std::vector<Point> rows;
  PointSet points;
  FlowComplex complex;
  Pockets pockets;
  std::unique_ptr<Truth> truth;
  std::size_t saddle, upper = 0;
  RationalPoint start;
  std::string claim_text;
  Claim claim;
  std::vector<ListedPair> pairs;
  std::vector<ClaimedPair> claimed_pairs;
  std::vector<std::size_t> sets;
  SurfaceMesh mesh;
};

std::string whole_text(const FlowComplex& complex) {
  std::ostringstream out;
  write_stationary_points(out, complex, {.u2 = true, .polylines = true, .s2 = true, .skeletons = true, .all = true});
  write_merge_tree(out, complex, TreeKind::kPockets);
  return out.str() + pers_text(PersistenceDiagram(complex, true)) + result_text(complex.centers());
}

const std::string kDecimals = "0.1 0.7 0.3\n1e-320 0.2 4.9e-324\n1.1 123456.7 0.30000000000000004\n";
const std::string kOrbit =
    R"({"flowcert":"orbit","segments":[{"type":"E-F-V","driver":["1/10","1/5","3/10"],"end":["1/3","1/7","0"]}],)"
    R"("limit":{"kind":"critical","index":0,"position":["1/3","1/7","0"],"contact":[1],"squared_distance":"1/9"}})";

// ---- The functions, layer by layer ----

void add_geometry(Calls& calls, const Made& m) {
  calls.add(
      "PointSet::PointSet", [&] { return PointSet(m.rows); },
      [](const PointSet& set) { return result_text(set.points()) + result_text(set.repeated_classes()); });
  calls.add("exact_sphere", [&] { return exact_sphere(m.points, m.contact()); });
  calls.add("exact_squared_radius", [&] { return exact_squared_radius(m.points, m.contact()); });
  calls.add("nearest_double", [&] { return nearest_double(m.start[0]); });
  calls.add("nearest_or_infinity", [&] { return nearest_or_infinity(m.start[1]); });
  calls.add("rounded_point", [&] { return rounded_point(m.start); });
  calls.add("rounded_sphere", [&] { return rounded_sphere(m.points, m.contact(), 1); });
  calls.add("rounded_sphere", [&] { return rounded_sphere(m.complex.sphere(m.upper)); });
  calls.add("rounded_squared_radius", [&] { return rounded_squared_radius(m.points, m.contact(), 1); });
}

void add_voronoi_and_flow(Calls& calls, const Made& m) {
  const auto flow = std::make_shared<Flow>(m.complex.diagram());
  calls.add(
      "Flow::Flow", [&] { return std::make_unique<Flow>(m.complex.diagram()); },
      [&](const auto& made) { return result_text(made->orbit(m.start)); });
  calls.add("Flow::step", [&, flow] { return flow->step(m.start); });
  calls.add("Flow::orbit", [&, flow] { return flow->orbit(m.start); });
  calls.add("Flow::limit", [&, flow] { return flow->limit(m.start); });
  Distribution seven;
  for (const std::size_t value : {1, 2, 2, 5, 7, 7, 9}) seven.add(value);
  calls.add("Distribution::mean", [=] { return seven.mean(); });
  calls.add("Distribution::standard_deviation", [=] { return seven.standard_deviation(); });
  calls.add("Distribution::median", [=] { return seven.median(); });
}

void add_flow_complex(Calls& calls, const Made& m) {
  calls.add("FlowComplex::FlowComplex", [&] { return FlowComplex(m.rows); }, whole_text);
  calls.add(
      "FlowComplex::make",
      [&] {
        FlowComplex complex(m.points, {.threads = 2});
        for (std::size_t part = 0; part < kFlowComplexParts; ++part) complex.make(static_cast<FlowComplexPart>(part));
        return complex;
      },
      whole_text);
  // Each makes the parts below it.
  const auto from_nothing = [&](const char* name, const auto& ask, const auto& value) {
    const auto make = [&m, ask] {
      FlowComplex complex(m.points);
      ask(complex);
      return complex;
    };
    calls.add(name, make, [value](const FlowComplex& complex) { return result_text(value(complex)); });
  };
  using Complex = FlowComplex;
  from_nothing(
      "FlowComplex::diagram", [](const Complex& c) { (void)c.diagram(); },
      [](const Complex& c) { return c.centers(); });
  from_nothing(
      "FlowComplex::filter_tally", [](const Complex& c) { (void)c.filter_tally(); },
      [](const Complex& c) { return c.filter_tally()[Predicate::kCospherical].calls; });
  from_nothing(
      "FlowComplex::stationary", [](const Complex& c) { (void)c.stationary(); },
      [](const Complex& c) { return c.centers(); });
  from_nothing(
      "FlowComplex::unstable", [](const Complex& c) { (void)c.unstable(); },
      [](const Complex& c) { return c.unstable().orbit(0, 0); });
  from_nothing(
      "FlowComplex::stable", [](const Complex& c) { (void)c.stable(); },
      [](const Complex& c) { return c.stable().set(0); });
  from_nothing(
      "FlowComplex::chains", [](const Complex& c) { (void)c.chains(); },
      [](const Complex& c) { return c.chains().limits(); });
  from_nothing(
      "FlowComplex::links", [](const Complex& c) { (void)c.links(); },
      [](const Complex& c) { return c.links().upper(0); });
  from_nothing(
      "FlowComplex::persistence", [](const Complex& c) { (void)c.persistence(); },
      [](const Complex& c) { return c.persistence().pairs(); });
  from_nothing(
      "FlowComplex::limits", [](const Complex& c) { (void)c.limits(); },
      [](const Complex& c) { return c.limits().list(0); });
  from_nothing(
      "FlowComplex::volumes", [](const Complex& c) { (void)c.volumes(); },
      [](const Complex& c) { return c.volumes().nearest(0); });
  from_nothing(
      "FlowComplex::unstable_surfaces", [](const Complex& c) { (void)c.unstable_surfaces(); },
      [](const Complex& c) { return c.unstable_surfaces().size(); });
  from_nothing(
      "FlowComplex::merge_trees", [](const Complex& c) { (void)c.merge_trees(); },
      [](const Complex& c) { return c.merge_trees().pockets().parents(); });
  calls.add("FlowComplex::samples_of", [&] { return m.complex.samples_of(m.complex.limits().record(0)); });
  calls.add("FlowComplex::sphere", [&] { return m.complex.sphere(m.upper); });
  calls.add("FlowComplex::rounded_sphere", [&] { return m.complex.rounded_sphere(m.upper); });
  calls.add("FlowComplex::centers", [&] { return m.complex.centers(); });
  calls.add("FlowComplex::orbit", [&] { return m.complex.orbit(m.start); });
  calls.add("FlowComplex::limit", [&] { return m.complex.limit(m.start); });
  calls.add("FlowComplex::locate", [&] { return m.complex.locate(m.start); });
  calls.add("FlowComplex::locate", [&] { return m.complex.locate(m.rows[3]); });
  calls.add("FlowComplex::step", [&] { return m.complex.step(m.start); });
}

void add_manifolds(Calls& calls, const Made& m) {
  const VoronoiDiagram& diagram = m.complex.diagram();
  const StationaryPoints& stationary = m.complex.stationary();
  calls.add(
      "stationary_points", [&] { return stationary_points(diagram, 2); },
      [](const StationaryPoints& all) {
        return result_text(all.critical_counts()) + result_text(all.contact(all.size() - 1));
      });
  calls.add(
      "UnstableManifolds::UnstableManifolds", [&] { return std::make_unique<UnstableManifolds>(diagram, stationary); },
      [](const auto& made) { return result_text(made->orbit(0, 0)) + result_text(made->limit(0, 1)); });
  calls.add("UnstableManifolds::orbit", [&] { return m.complex.unstable().orbit(0, 0); });
  calls.add("UnstableManifolds::rounded_orbit", [&] { return m.complex.unstable().rounded_orbit(0, 1); });
  calls.add("UnstableManifolds::direction_to_infinity", [&] {
    std::vector<std::optional<Point>> all;
    for (std::size_t i = 0; i < m.complex.unstable().size(); ++i) {
      for (const std::size_t side : {0, 1}) {
        if (!m.complex.unstable().limit(i, side)) all.push_back(m.complex.unstable().direction_to_infinity(i, side));
      }
    }
    return all;
  });
  calls.add(
      "StableManifolds::StableManifolds", [&] { return std::make_unique<StableManifolds>(diagram, stationary); },
      [](const auto& made) { return result_text(made->set(0)) + result_text(made->boundary(0)); });
  calls.add("StableManifolds::set", [&] { return m.complex.stable().set(0); });
  calls.add("StableManifolds::set_of_record",
            [&] { return m.complex.stable().set_of_record(m.complex.stable().record(0)); });
  calls.add("StableManifolds::set_of_infinity", [&] { return m.complex.stable().set_of_infinity(); });
  calls.add("StableManifolds::rounded_segments", [&] { return m.complex.stable().rounded_segments(0); });
  calls.add("StableManifolds::segments_to_boundary", [&] { return m.complex.stable().segments_to_boundary(0); });
  const std::size_t record = m.complex.stable().record(0);
  const StableSet<> set = m.complex.stable().set(0);
  calls.add("boundary_walk", [&, set, record] {
    return boundary_walk(set, m.complex.stationary().index(record), m.complex.stationary().contact(record));
  });
  calls.add("connecting_orbits", [&, set, record] { return connecting_orbits(set, m.complex.sphere(record).center); });
  calls.add("surface_area", [&] { return surface_area(m.points, m.complex.stable(), 0); });
  calls.add(
      "ChainComplex::ChainComplex",
      [&] { return ChainComplex(m.points, stationary, m.complex.unstable(), m.complex.stable(), 1); },
      [&](const ChainComplex& made) { return result_text(made.boundary(m.upper)) + result_text(made.limits()); });
  const auto links_text = [](const SaddleLinks& made) {
    return result_text(made.lower(0)) + result_text(made.upper(0));
  };
  calls.add(
      "SaddleLinks::SaddleLinks", [&] { return SaddleLinks(diagram, stationary, m.complex.stable(), 2); }, links_text);
  calls.add("SaddleLinks::SaddleLinks", [&] { return SaddleLinks(stationary, m.complex.chains()); }, links_text);
  const auto pairs_text = [](const Persistence& made) { return result_text(made.pairs()); };
  calls.add(
      "Persistence::Persistence", [&] { return Persistence(m.points, stationary, m.complex.links()); }, pairs_text);
  calls.add(
      "Persistence::Persistence", [&] { return Persistence(m.points, stationary, m.complex.chains()); }, pairs_text);
  calls.add("Persistence::squared_value", [&] { return m.complex.persistence().squared_value(m.upper); });
  for (const PersistencePair& pair : m.complex.persistence().pairs()) {
    if (pair.dimension != 1) continue;
    calls.add("Loops::surface", [&, pair] {
      const Rational birth = m.complex.persistence().squared_value(pair.birth);
      return Loops(stationary, m.complex.links(), m.complex.persistence()).surface(pair, birth);
    });
    calls.add("Loops::witness",
              [&, pair] { return Loops(stationary, m.complex.links(), m.complex.persistence()).witness(pair); });
    // A loop of long edges, at the level of the longest.
    const std::vector<SampleEdge> loop = {{0, 1}, {1, 2}, {2, 0}};
    const SquaredLevel level(Rational(9));
    calls.add("LoopClasses::of", [&, loop, level, pair] {
      const LoopClass found = LoopClasses(m.complex).of(loop, pair, level);
      return result_text(found.dying) + reason_text(found.fault);
    });
    calls.add("LoopClasses::represent", [&, loop, level, pair] {
      return LoopClasses(m.complex).represent(std::vector<std::vector<SampleEdge>>{loop}, pair, level);
    });
    calls.add("LoopClasses::are_homologous",
              [&, loop, level] { return LoopClasses(m.complex).are_homologous(loop, {}, level); });
    calls.add("LoopClasses::as_index_1_points", [&, loop] { return LoopClasses(m.complex).as_index_1_points(loop); });
    calls.add("LoopClasses::deaths_of", [&, loop] {
      LoopClasses classes(m.complex);
      return classes.deaths_of(classes.as_index_1_points(loop)).value();
    });
  }
  const auto first_edge = static_cast<std::uint32_t>(stationary.critical_counts()[0]);
  calls.add("components_at", [&, first_edge] { return components_at(m.complex.merge_trees(), first_edge); });
  for (const PersistencePair& pair : m.complex.persistence().pairs()) {
    if (pair.dimension != 2) continue;
    calls.add("Voids::at", [&, pair] {
      return Voids(m.complex.merge_trees()).at(*pair.death, m.complex.persistence().squared_value(pair.birth));
    });
  }
  calls.add(
      "UnstableSurfaces::UnstableSurfaces", [&] { return std::make_unique<UnstableSurfaces>(diagram, stationary); },
      [](const auto& made) { return result_text(made->size() == 0 ? UnstableSurface{} : made->set(0)); });
  if (m.complex.unstable_surfaces().size() == 0) return;
  calls.add("UnstableSurfaces::set", [&] { return m.complex.unstable_surfaces().set(0); });
  calls.add("UnstableSurfaces::rounded_set", [&] { return m.complex.unstable_surfaces().rounded_set(0); });
  calls.add("UnstableSurfaces::size_of", [&] { return m.complex.unstable_surfaces().size_of(0); });
}

void add_limits_and_volumes(Calls& calls, const Made& m) {
  const VoronoiDiagram& diagram = m.complex.diagram();
  const StationaryPoints& stationary = m.complex.stationary();
  const FlowLimits& limits = m.complex.limits();
  const StableVolumes& volumes = m.complex.volumes();
  calls.add(
      "FlowLimits::FlowLimits", [&] { return std::make_unique<FlowLimits>(diagram, stationary); },
      [](const auto& made) { return result_text(made->list(0)) + result_text(made->entries(made->size() - 1)); });
  calls.add("FlowLimits::arc_count", [&] { return limits.arc_count(0); });
  calls.add("FlowLimits::direction_count", [&] { return limits.direction_count(0); });
  calls.add("FlowLimits::entries", [&] { return limits.entries(0); });
  calls.add("FlowLimits::list", [&] { return limits.list(0); });
  calls.add("FlowLimits::rounded_list", [&] { return limits.rounded_list(0); });
  calls.add(
      "FlowLocator::FlowLocator", [&] { return FlowLocator(diagram, stationary, limits); },
      [&](FlowLocator& made) { return result_text(made.locate(m.start)); });
  const auto locator = std::make_shared<FlowLocator>(diagram, stationary, limits);
  calls.add(
      "FlowLocator::FlowLocator", [=] { return FlowLocator(*locator); },
      [&](FlowLocator& made) { return result_text(made.locate(m.rows[1])); });
  calls.add("FlowLocator::locate", [&, locator] { return locator->locate(m.start); });
  calls.add("FlowLocator::locate", [&, locator] { return locator->locate(m.rows[2]); });
  calls.add("connections_of", [&] { return connections_of(limits, 0); });
  calls.add("connections", [&] { return connections(limits); });
  calls.add("orbits_that_end_elsewhere", [&] { return orbits_that_end_elsewhere(stationary, limits); });
  calls.add("is_morse_smale", [&] { return is_morse_smale(stationary, limits, m.complex.stable()); });
  calls.add(
      "StableVolumes::StableVolumes", [&] { return std::make_unique<StableVolumes>(diagram, stationary, limits, 2); },
      [&](const auto& made) { return result_text(made->nearest(m.saddle)) + result_text(made->hull()); });
  calls.add("StableVolumes::nearest", [&] { return volumes.nearest(m.upper); });
  calls.add("StableVolumes::exact", [&] { return volumes.exact(m.upper); });
  const std::vector<std::uint32_t> some = {0, 1, static_cast<std::uint32_t>(m.saddle)};
  calls.add("StableVolumes::nearest_sum", [&, some] { return volumes.nearest_sum(some); });
  calls.add("StableVolumes::exact_sum", [&, some] { return volumes.exact_sum(some); });
  calls.add("StableVolumes::shares", [&] { return volumes.shares(m.upper); });
  calls.add("StableVolumes::rounded_shares", [&] { return volumes.rounded_shares(m.upper); });
  const auto regions = std::make_shared<StableRegions>(diagram, limits);
  const auto all_of = [](StableRegions& of) {
    std::vector<StableRegion> all;
    of.visit([&](const StableRegion& region) { all.push_back(region); });
    return all;
  };
  calls.add(
      "StableRegions::StableRegions", [&] { return std::make_unique<StableRegions>(diagram, limits); },
      [=](const auto& made) { return result_text(all_of(*made)); });
  calls.add("StableRegions::visit", [=] { return all_of(*regions); });
  const StableRegion first = all_of(*regions).front();
  calls.add("StableRegions::exact", [=] { return regions->exact(first, first.corners.back()); });
  calls.add("StableRegions::rounded", [=] { return regions->rounded(first, first.corners.back()); });
}

void add_pockets(Calls& calls, const Made& m) {
  const MergeTrees& trees = m.complex.merge_trees();
  calls.add(
      "SquaredDistances::SquaredDistances", [&] { return SquaredDistances(m.points, m.complex.stationary()); },
      [&](const SquaredDistances& made) { return result_text(made.rank(m.upper)) + result_text(made.rank(0)); });
  calls.add("SquaredDistances::exact", [&] { return trees.squared_distances().exact(m.upper); });
  calls.add("SquaredDistances::compare",
            [&] { return trees.squared_distances().compare(m.upper, m.complex.sphere(m.upper).squared_radius) >= 0; });
  calls.add("SquaredLevel::SquaredLevel", [&] {
    const SquaredLevel level(trees.squared_distances(), 0, m.upper, Rational(1, 3));
    return trees.squared_distances().compare(m.upper, level) > 0;
  });
  calls.add("SquaredLevel::exact",
            [&] { return SquaredLevel(trees.squared_distances(), 0, m.upper, Rational(1, 3)).exact(); });
  calls.add("SquaredDistances::length", [&] {
    const auto [value, error] = trees.squared_distances().length(0, m.upper);
    return std::array{value, error};
  });
  calls.add(
      "MergeTrees::MergeTrees", [&] { return MergeTrees(m.points, m.complex.stationary(), m.complex.limits()); },
      [](const MergeTrees& made) { return result_text(made.pockets().parents()); });
  calls.add(
      "Pockets::Pockets", [&] { return Pockets(trees, Rational(1) / 1000); },
      [](const Pockets& made) { return result_text(made.outside()) + result_text(made.size()); });
  calls.add("Pockets::widest_path", [&] { return m.pockets.widest_path(); });
  calls.add("Pockets::largest_balls", [&] { return m.pockets.largest_balls(); });
  calls.add("Pockets::above", [&] { return m.pockets.above(m.upper); });
  calls.add("explain_points", [&] { return explain_points(m.points, m.contact()); });
  calls.add("explain_position", [&] { return explain_position(m.points, m.start); });
  if (m.pockets.size() == 0) return;
  calls.add("Pockets::depth", [&] { return m.pockets.depth(m.pockets[0]); });
  calls.add("Pockets::difference_of_squares", [&] { return m.pockets.difference_of_squares(m.pockets[0]); });
  calls.add("Pockets::lining", [&] { return Pockets::lining(m.pockets[0], m.complex.volumes()); });
  calls.add("Pockets::passage", [&] { return m.pockets.passage(m.pockets[0], Rational(1) / 7); });
}

// A fifth of the distance of two rows is the radius of all balls, but for a larger and a hidden one.
std::vector<Ball> balls_of(const Made& m) {
  const Rational unit = abs(Rational(m.rows[1].z) - Rational(m.rows[0].z)) + Rational(m.rows[4].z) / 7;
  std::vector<Ball> balls;
  for (const Point& p : m.rows) balls.push_back({{Rational(p.x), Rational(p.y), Rational(p.z)}, unit / 5});
  balls[2].radius = unit / 3;
  balls.push_back({balls[2].center, unit / 11});
  return balls;
}

std::string pores_text(const Pores& pores) {
  std::ostringstream out;
  write_pores(out, {pores, 0, Rational(1) / 7});
  return out.str();
}

void add_pores(Calls& calls, const Made& m) {
  const std::vector<Ball> balls = balls_of(m);
  calls.add(
      "BallSet::BallSet", [=] { return BallSet(balls); },
      [](const BallSet& made) { return result_text(made.visible()) + result_text(made.rounded(0)); });
  const auto set = std::make_shared<BallSet>(balls);
  const auto pores = std::make_shared<Pores>(*set, 0);
  calls.add("Pores::Pores", [=] { return Pores(*set, 0, 2); }, pores_text);
  for (std::uint32_t point = 0; point < pores->points().size(); ++point) {
    const QuadraticNumber value = pores->value(point);
    const auto text_of = [](const QuadraticNumber& number) {
      return result_text(primitive_polynomial(number).coefficients);
    };
    calls.add("Pores::value", [=] { return pores->value(point); }, text_of);
    calls.add(
        "Pores::center", [=] { return pores->center(point); },
        [=](const auto& made) { return text_of(made[0]) + text_of(made[1]) + text_of(made[2]); });
    calls.add("nearest_or_infinity", [=] { return nearest_or_infinity(value); });
    calls.add("nearest_difference", [=] { return nearest_difference(value, QuadraticNumber(Rational(1) / 3)); });
    calls.add("QuadraticNumber::sign", [=] { return value.sign(); });
  }
  const Rational probe = balls[0].radius;
  calls.add("Pores::cavities_at", [=] { return pores->cavities_at(probe); });
  calls.add(
      "Pores::cavity_steps", [=] { return pores->cavity_steps(); },
      [](const auto& made) {
        std::string text;
        for (const CavityStep& step : made) text += result_text(step.point) + result_text(step.count);
        return text;
      });
  for (const Chamber& chamber : pores->chambers()) {
    calls.add("Pores::status", [=] { return pores->status(chamber, probe); });
  }
  calls.add(
      "ball_cavities", [=] { return ball_cavities(*set, probe); },
      [](const auto& made) {
        std::string text;
        for (const BallCavity& cavity : made) text += result_text(cavity.lining);
        return text;
      });
  const PoresToWrite what{*pores, Rational(0), probe};
  calls.add_writer("write_pores", [=](std::ostream& out) { write_pores(out, what); });
  calls.add_writer("write_pores_csv", [=](std::ostream& out) { write_pores_csv(out, what); });
  calls.add_writer("write_windows_csv", [=](std::ostream& out) { write_windows_csv(out, what); });
  calls.add_writer("write_cavity_curve_csv", [=](std::ostream& out) { write_cavity_curve_csv(out, *pores); });
}

void add_readers(Calls& calls, const Made& m, const std::string& path) {
  calls.add("read_points", [=] { return read_points(path); });
  calls.add("read_points_from", [] { return read_points_from(kDecimals, "points"); });
  calls.add(
      "AtomRadii::AtomRadii", [] { return AtomRadii("bondi,Fe=0x1.8p0,Mn=2.04"); },
      [](const AtomRadii& made) { return result_text(*made.of_element("Fe")) + result_text(*made.of_element("Mn")); });
  const auto balls_text = [](const BallFile& file) {
    std::string text = result_text(file.file);
    for (const Ball& ball : file.balls) text += result_text(ball.center) + result_text(ball.radius);
    return text;
  };
  calls.add("read_balls", [=] { return read_balls(path, {}, AtomRadii("0.1")); }, balls_text);
  calls.add(
      "read_balls_from", [] { return read_balls_from(kDecimals, "points", {}, AtomRadii("1e-320")); }, balls_text);
  const auto is_as_before = [&](const Claim& claim) { return result_text(check(m.points, claim, *m.truth)); };
  calls.add("read_claim_from", [&] { return read_claim_from(m.claim_text, "claim"); }, is_as_before);
  calls.add("read_claim", [=] { return read_claim(path + ".jsonl"); }, is_as_before);
  calls.add("claimed_orbit_of", [] { return claimed_orbit_of(kOrbit, "orbit"); });
  const std::string pairs = "0 0 inf\n1 0.1 0.7\n2 4.9e-324 1e-320\n";
  calls.add("is_pair_claim", [=] { return is_pair_claim(pairs, "pairs"); });
  calls.add("claimed_pairs_of", [=] { return claimed_pairs_of(pairs, "pairs"); });
  calls.add("is_before", [&] { return is_before(m.pairs.front(), m.pairs.back()); });
}

void add_choices(Calls& calls, const Made& m) {
  calls.add(
      "ClipBox::ClipBox", [&] { return ClipBox(m.points, Rational(5) / 3); },
      [](const ClipBox& box) { return result_text(box.low()) + result_text(box.high()); });
  const ClipBox box(m.points, 3);
  calls.add("ClipBox::contains", [&, box] { return box.contains(m.rows[0]); });
  calls.add("ClipBox::exit", [&, box] { return box.exit(m.points[0], {Rational(1) / 3, 1, Rational(2) / 7}); });
  calls.add("medial_points", [&] {
    return medial_points(m.complex, {.persistence_above = {}, .angle_above = Rational(70), .radius_above = {}});
  });
  calls.add("is_above_angle", [] { return is_above_angle(Rational(1) / 3, Rational(705) / 10); });
  calls.add("pocket_persistence", [&] { return pocket_persistence(m.complex, "0.7spacing", "--persistence"); });
  const std::vector<std::string> words = {"index2-radius<1.7spacing", "persistence>0.001"};
  calls.add(
      "SurfaceSelection::SurfaceSelection", [=] { return SurfaceSelection(words); },
      [&](const SurfaceSelection& made) { return result_text(made.is_empty()); });
  const SurfaceSelection selection(words);
  calls.add("SurfaceSelection::select", [&, selection] { return selection.select(m.complex); });
  calls.add("selected_sets", [&, words] { return selected_sets(m.complex, words); });
  calls.add("coordinates_sha256", [&] { return coordinates_sha256(m.points); });
}

void add_writers(Calls& calls, const Made& m, const std::string& folder) {
  calls.add("surface_mesh", [&] { return surface_mesh(m.complex, m.sets); });
  const auto saddle = static_cast<std::uint32_t>(m.complex.stable().record(0));
  calls.add("loop_surface_mesh", [&, saddle] { return loop_surface_mesh(m.complex, std::vector{saddle}); });
  calls.add_writer("write_ply", [&](std::ostream& out) { write_ply(out, m.mesh, "comment"); });
  calls.add_writer("write_off", [&](std::ostream& out) { write_off(out, m.mesh, "comment"); });
  calls.add("orient", [&] {
    auto triangles = m.mesh.triangles;
    return orient(triangles, m.mesh.vertices.size());
  });
  calls.add("cell_surfaces", [&] { return cell_surfaces(m.complex, m.pockets.cells()); });
  const CellSurface pocket{m.mesh.vertices, m.mesh.triangles};
  calls.add_writer("write_ply", [=](std::ostream& out) { write_ply(out, pocket, "comment"); });
  calls.add("stable_cell_data", [&] { return stable_cell_data(m.complex); });
  calls.add("cell_grid", [&] { return cell_grid(m.complex, m.pockets.cells()).grid; });
  calls.add("pocket_cell_data", [&] { return pocket_cell_data(m.complex, m.pockets); });
  const ClipBox box(m.points, 3);
  calls.add("infinity_cell_data", [&, box] { return infinity_cell_data(m.complex, box); });
  calls.add("unstable_fan_data", [&] { return unstable_fan_data(m.complex); });
  calls.add("critical_point_data", [&] { return critical_point_data(m.complex); });
  calls.add("unstable_line_data", [&, box] { return unstable_line_data(m.complex, box); });
  calls.add("stable_surface_data", [&] { return stable_surface_data(m.complex, m.mesh); });
  calls.add_writer("write_vtp",
                   [&, data = critical_point_data(m.complex)](std::ostream& out) { write_vtp(out, data, "comment"); });
  calls.add_writer("write_vtu",
                   [&, data = stable_cell_data(m.complex)](std::ostream& out) { write_vtu(out, data, "comment"); });
  const auto to_text = [](const UnstableSurfaceExport& made) {
    std::ostringstream out;
    made.write_vtp(out, "comment");
    made.write_ply(out, "comment");
    return out.str();
  };
  calls.add(
      "UnstableSurfaceExport::UnstableSurfaceExport",
      [&, box, folder] { return std::make_unique<UnstableSurfaceExport>(m.complex, box, folder); },
      [=](const auto& made) { return to_text(*made); });
  const auto surfaces = std::make_shared<UnstableSurfaceExport>(m.complex, box, folder);
  calls.add_writer("UnstableSurfaceExport::write_vtp", [=](std::ostream& out) { surfaces->write_vtp(out, "comment"); });
  calls.add_writer("UnstableSurfaceExport::write_ply", [=](std::ostream& out) { surfaces->write_ply(out, "comment"); });
  calls.add_writer("write_viewer_page", [&](std::ostream& out) {
    (void)write_viewer_page(out, m.complex, {.name = "name", .has_cells = true, .pockets = &m.pockets, .claim = {}});
  });
  CycleChoice tunnels, voids;
  voids.dimension = 2;
  for (const CycleChoice& choice : {tunnels, voids}) {
    calls.add("cycles", [&, choice] { return cycles(m.complex, choice); });
  }
  const std::vector<Cycle> loops = cycles(m.complex, tunnels), spaces = cycles(m.complex, voids);
  calls.add("loop_data", [&, loops] { return loop_data(m.complex, loops); });
  calls.add("loop_surface_data", [&, loops] { return loop_surface_data(m.complex, loops); });
  for (const Cycle& cycle : loops) {
    calls.add("loop_length", [&, cycle] { return loop_length(m.complex, std::get<LoopCycle>(cycle.chain)); });
  }
  calls.add("void_data", [&, spaces] { return void_data(m.complex, spaces); });
  calls.add("void_surfaces", [&, spaces] { return void_surfaces(m.complex, spaces); });
  calls.add_writer("write_cycles", [&, loops](std::ostream& out) { write_cycles(out, {m.complex, 1, loops, true}); });
  calls.add_writer("write_cycles", [&, spaces](std::ostream& out) { write_cycles(out, {m.complex, 2, spaces}); });
  calls.add("cycle_level_of", [] { return cycle_level_of("12.5%", "--level").number; });
  calls.add_writer("write_pockets", [&](std::ostream& out) {
    write_pockets(out, {m.complex, m.pockets, Probe{Rational(1) / 7}, true});
  });
  calls.add_writer("write_pocket_csv", [&](std::ostream& out) {
    write_pocket_csv(out, {m.complex, m.pockets, Probe{Rational(1) / 7}, false});
  });
  calls.add_writer("write_lining_csv", [&](std::ostream& out) {
    AtomNames names;
    for (std::size_t row = 0; row < m.points.row_count(); ++row) names.add({.chain = "A", .atom = "C"});
    write_lining_csv(out, {m.complex, m.pockets, std::nullopt, false, &names});
  });
  for (const TreeKind kind : {TreeKind::kPockets, TreeKind::kComponents}) {
    calls.add_writer("write_merge_tree", [&, kind](std::ostream& out) { write_merge_tree(out, m.complex, kind); });
    calls.add_writer("write_newick", [&, kind](std::ostream& out) { write_newick(out, m.complex, kind); });
  }
  calls.add_writer("write_stationary_points", [&](std::ostream& out) {
    write_stationary_points(out, m.complex, {.polylines = true, .skeletons = true, .all = true});
  });
  calls.add_writer("write_certificate", [&](std::ostream& out) { write_certificate(out, m.complex); });
  calls.add(
      "PersistenceDiagram::PersistenceDiagram", [&] { return PersistenceDiagram(m.complex, true); },
      [](const PersistenceDiagram& made) { return result_text(made.pairs()); });
  const PersistenceDiagram diagram(m.complex, true);
  calls.add("PersistenceDiagram::squared_value", [&, diagram] { return diagram.squared_value(m.upper); });
  calls.add("PersistenceDiagram::rounded_squared_value",
            [&, diagram] { return diagram.rounded_squared_value(m.upper); });
  calls.add("PersistenceDiagram::rounded_value", [&, diagram] { return diagram.rounded_value(m.upper); });
  calls.add("write_pers", [diagram] {
    std::ostringstream out;
    write_pers(out, diagram);
    return out.str();
  });
  calls.add("pers_text", [diagram] { return pers_text(diagram) + pers_text(diagram, PersistenceValues::kPlain); });
}

void add_judgement(Calls& calls, const Made& m) {
  calls.add(
      "fast_truth", [&] { return fast_truth(m.points, 2); },
      [&](const std::unique_ptr<Truth>& truth) { return result_text(check(m.points, m.claim, *truth)); });
  calls.add("check", [&] { return check(m.points, m.claim, *m.truth); });
  calls.add("check", [&] { return check(m.points, m.claim); });
  calls.add("check", [&] { return check(m.complex, m.claim); });
  Truth& truth = *m.truth;
  const std::size_t upper = m.upper, saddle = m.complex.unstable().saddle(0);
  calls.add("Truth::sphere", [&, upper] { return truth.sphere(upper); });
  calls.add("Truth::limits", [&, saddle] { return truth.limits(saddle); });
  calls.add("Truth::orbit", [&] { return truth.orbit(m.start).limit; });
  calls.add("Truth::polyline", [&, saddle] { return truth.polyline(saddle, 0).back().end; });
  calls.add("Truth::boundary", [&, saddle] { return truth.boundary(saddle); });
  calls.add("Truth::stable_summary", [&, saddle] { return truth.stable_summary(saddle).segments; });
  calls.add("Truth::stable_set", [&, saddle] { return truth.stable_set(saddle); });
  calls.add("Truth::stable_set", [&] { return truth.stable_set(std::nullopt); });
  calls.add("Truth::lambda_list", [&, list = m.complex.limits().record(0)] { return truth.lambda_list(list); });
  calls.add("Truth::lambda_entries", [&, list = m.complex.limits().record(0)] { return truth.lambda_entries(list); });
  calls.add("Truth::connections", [&] { return truth.connections(m.saddle); });
  calls.add("Truth::is_morse_smale", [&] { return truth.is_morse_smale(); });
  calls.add("Truth::volume", [&, upper] { return truth.volume(upper); });
  calls.add("Truth::nearest_volume", [&, upper] { return truth.nearest_volume(upper); });
  calls.add("Truth::shares", [&, upper] { return truth.shares(upper); });
  calls.add("Truth::nearest_shares", [&, upper] { return truth.nearest_shares(upper); });
  calls.add("Truth::hull_volume", [&] { return truth.hull_volume(); });
  if (m.complex.unstable_surfaces().size() > 0) {
    calls.add("Truth::unstable_surface",
              [&, record = m.complex.unstable_surfaces().record(0)] { return truth.unstable_surface(record); });
  }
  calls.add("Truth::pockets", [&] { return truth.pockets(Rational(1) / 7).pockets; });
  calls.add("Truth::area", [&, saddle] { return truth.area(saddle); });
  calls.add("Truth::nearest_sum",
            [&, some = std::array{0U, static_cast<std::uint32_t>(upper)}] { return truth.nearest_sum(some); });
  Profile approximate;
  approximate.set(ProfilePart::kPoints, Profile::State::kCovered);
  approximate.set_exact(false);
  calls.add("conformity_text", [=] { return conformity_text(Verdict::kConforms, approximate, 1e-7).value_or(""); });
  calls.add("no_conformity_text",
            [=] { return no_conformity_text(Verdict::kConforms, approximate, 1e-5).value_or(""); });
  const OrbitPath path = claimed_orbit_of(kOrbit, "orbit");
  calls.add("path_difference", [&, path] { return path_difference(path, OrbitPath{}, m.points, truth); });
  calls.add("listed_pairs", [&] { return listed_pairs(m.complex); });
  calls.add("pair_differences", [&] { return pair_differences(m.claimed_pairs, m.pairs, 1e-9); });
  const CheckReport report = check(m.points, m.claim, *m.truth);
  calls.add(
      "viewer_claim", [&, report] { return viewer_claim(m.complex, m.claim, report, {.name = "claim"}); },
      [](const io::Json& made) { return made["verdict"].dump() + made["findings_count"].dump(); });
  calls.add_writer("write_claim_page", [&](std::ostream& out) {
    write_claim_page(out, m.points, "points", ClaimText{m.claim_text, "claim"});
  });
}

// These compute with no doubles: they hand out what is there, or work on ids and words.
const std::set<std::string> kWithoutDoubles = {
    // clang-format off
    "PointSet::row_count", "PointSet::merged_duplicates", "PointSet::left_out", "PointSet::size", "PointSet::empty",
    "PointSet::points", "PointSet::name", "PointSet::prefetch", "PointSet::ordinal_of_row", "PointSet::at_row",
    "PointSet::repeated_classes", "class_names", "Point::coordinates", "Point::is_finite",
    "AtomNames::add", "AtomNames::size", "AtomNames::empty", "AtomNames::residue_text", "AtomNames::text",
    "AtomNames::residue_texts", "to_text", "FlowComplex::dimension", "FlowComplex::delaunay_cells",
    "FlowComplex::forget_diagram", "usual_most_cells",
    "Distribution::add", "Distribution::times",
    "Distribution::count", "Distribution::max", "Distribution::mode", "FlowSegment::stays", "type_text", "Flow::tally",
    "StationaryIndex::is_critical", "FlowComplex::points", "FlowComplex::threads", "ChainComplex::boundary",
    "ChainComplex::limits", "ChainComplex::broken_ties", "ChainComplex::prefetch", "SaddleLinks::size",
    "SaddleLinks::lower", "SaddleLinks::upper", "SaddleLinks::prefetch_lower", "FlowLimits::size",
    "FlowLimits::record", "FlowLimits::point_count", "FlowLocator::followed", "MergeTree::parents",
    "MergeTree::leaves_of", "Voids::Voids",
    "MergeTrees::pockets", "MergeTrees::components", "MergeTrees::squared_distances", "MergeTrees::stationary",
    "MergeTrees::maxima", "MergeTrees::record_of", "MergeTrees::peaks_above", "MergeTrees::peaks_above_sides",
    "MergeTrees::limits_above", "MergeTrees::saddles_down", "MergeTrees::upper_points_down", "Persistence::pairs",
    "Persistence::squared_distances", "Persistence::partner", "Persistence::additions", "Loops::Loops",
    "Loops::boundary", "Loops::polygons", "Loops::whole_surface", "LoopClasses::LoopClasses", "odd_edges",
    "passage_text",
    "Pockets::size", "Pockets::cells", "Pockets::outside", "Pockets::squared_persistence", "Pockets::squared_distances",
    "SquaredDistances::ascending", "SquaredDistances::rank", "SquaredDistances::approximation",
    "SquaredDistances::prefetch", "back_kind_text",
    "StableManifolds::size",
    "StableManifolds::record", "StableManifolds::segment_count", "StableManifolds::has_vertex",
    "StableManifolds::has_interval", "StableManifolds::boundary", "StableManifolds::statistics", "StableVolumes::hull",
    "StableVolumes::decided_exactly", "StationaryPoints::size", "StationaryPoints::index", "StationaryPoints::contact",
    "StationaryPoints::critical_counts", "StationaryPoints::regular_counts", "StationaryPoints::euler_sum",
    "StationaryPoints::face", "StationaryPoints::prefetch",
    "UnstableManifolds::size", "UnstableManifolds::saddle", "UnstableManifolds::limit",
    "UnstableManifolds::limit_beyond", "UnstableManifolds::statistics", "UnstableSurfaces::size",
    "UnstableSurfaces::record", "verdict_text", "reason_text", "verdict_on", "Truth::size", "Truth::index",
    "Truth::contact", "pair_counts", "Profile::state", "Profile::set", "Profile::is_exact", "Profile::set_exact",
    "Profile::set_indices", "Profile::join", "Profile::parts", "Profile::grade",
    "require_rows", "sentence_of", "ClipBox::low", "ClipBox::high", "is_exact_pair", "reproducibility", "made_by_text",
    "SurfaceSelection::is_empty", "PersistenceDiagram::complex",
    "PersistenceDiagram::pairs", "PersistenceDiagram::has_zero", "Probe::squared_radius", "pair_name_of",
    "array_by_number", "AtomRadii::base", "AtomRadii::column", "AtomRadii::needs_elements", "AtomRadii::of_element",
    "AtomRadii::one", "AtomRadii::source", "AtomRadii::text", "BallSet::are_doubles", "BallSet::rounded",
    "BallSet::scale", "BallSet::scaled", "BallSet::size", "BallSet::tangent_inside", "BallSet::visible",
    "Pores::balls", "Pores::cavities", "Pores::chambers", "Pores::points", "Pores::vestibules", "Pores::windows",
    "QuadraticNumber::QuadraticNumber", "QuadraticNumber::is_rational", "primitive_polynomial", "roots_of",
    "status_text",
    // clang-format on
};

// ---- The test ----

class EveryMode : public testing::TestWithParam<Input> {
 protected:
  void SetUp() override {
    path_ = testing::TempDir() + "every_mode_" + std::to_string(::getpid());
    made_ = std::make_unique<Made>(GetParam().rows);
    std::ofstream(path_) << kDecimals;
    std::ofstream(path_ + ".jsonl") << made_->claim_text;
    add_geometry(calls_, *made_);
    add_voronoi_and_flow(calls_, *made_);
    add_flow_complex(calls_, *made_);
    add_manifolds(calls_, *made_);
    add_limits_and_volumes(calls_, *made_);
    add_pockets(calls_, *made_);
    add_pores(calls_, *made_);
    add_readers(calls_, *made_, path_);
    add_choices(calls_, *made_);
    add_writers(calls_, *made_, testing::TempDir());
    add_judgement(calls_, *made_);
    struct sigaction telling{};
    telling.sa_handler = tell_trap;
    ::sigaction(SIGFPE, &telling, &before_);
  }
  void TearDown() override {
    ::sigaction(SIGFPE, &before_, nullptr);
    ::unlink(path_.c_str());
    ::unlink((path_ + ".jsonl").c_str());
  }

  std::string path_;
  std::unique_ptr<Made> made_;
  Calls calls_;
  struct sigaction before_{};
};

TEST_P(EveryMode, HasTheSameResults) {
  CITES("FC-NUM-01", "FC-IN-02");
  for (const auto& [name, act] : calls_.all()) {
    called = name;
    EXPECT_FALSE(kWithoutDoubles.contains(name)) << name;
    const std::string usual = act()();
    for (const Mode& mode : kModes) {
      Text text;
      bool stands = false;
      {
        const InMode in(mode);
        text = act();
        stands = in.stands();
      }
      EXPECT_TRUE(stands) << name << " changes the mode: " << mode.name;
      EXPECT_TRUE(text() == usual) << name << ", " << mode.name << ": " << text().substr(0, 200) << "\nand not "
                                   << usual.substr(0, 200);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(, EveryMode, testing::ValuesIn(inputs()),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace flowcert::every_mode_test
