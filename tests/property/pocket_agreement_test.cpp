// Merge trees and pockets by the fast implementation against the oracle's (FC-TREE, FC-POCK), on all families.
//
// Guarantees: trees, pockets, depths, volumes, widest paths, and what each is for a probe are compared exactly, at
// persistences at which something changes. Doubles beside roots are judged exactly. The oracle makes its tree from
// Voronoi vertices and their edges; the fast implementation from where the flow leads. The test fails too when too few
// inputs had several pockets, merged ones, or some that stayed apart.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "flowcert/pockets.h"
#include "flowcert/stable_manifolds.h"
#include "fuzz/judge/root_sum.h"
#include "geometry/difference_of_roots.h"
#include "oracle/connections.h"
#include "oracle/merge_tree.h"
#include "oracle/persistence.h"
#include "oracle/pockets.h"
#include "oracle/stable_pieces.h"
#include "tests/chambers.h"
#include "tests/cites.h"
#include "tests/property/family_run.h"
#include "tests/property/orbit_subject.h"
#include "tests/property/root_differences.h"

namespace flowcert::property::pocket_agreement_test {
namespace {

constexpr int kInputsPerFamily = 7;
constexpr int kInputsMadeForThis = 8;  // of each of the families for stable sets
constexpr std::size_t kMostRows = 10;  // the oracle's time grows with a high power of them
constexpr std::uint64_t kInputsOfChambers = 15;

struct Totals {
  std::size_t inputs = 0, pockets = 0, merged = 0, apart = 0, outside = 0, gates = 0, areas = 0;

  void add(const Totals& part) {
    inputs += part.inputs;
    pockets += part.pockets;
    merged += part.merged;
    apart += part.apart;
    outside += part.outside;
    gates += part.gates;
    areas += part.areas;
  }
  void print_row(const std::string& name) const {
    std::printf(
        "%-24s %5zu inputs, %5zu pockets, %4zu of several maxima, %4zu apart; %4zu maxima outside, %5zu gates, "
        "%5zu areas\n",
        name.c_str(), inputs, pockets, merged, apart, outside, gates, areas);
  }
};

// Both implementations list stationary points in one order, so that places are compared as they are.
struct Landscape {
  explicit Landscape(const Subject& all)
      : subject(all),
        stationary(oracle::stationary_points(all.set).stationary),
        above(oracle::peaks_above(all.set, stationary)),
        trees(all.complex.merge_trees()) {}

  [[nodiscard]] const oracle::Rational& value(std::size_t record) const { return stationary[record].squared_distance; }
  void require(bool is_right, const std::string& what) const { require_none(subject.input, is_right ? "" : what, ""); }

  const Subject& subject;
  std::vector<oracle::StationaryPoint> stationary;
  oracle::PeaksAbove above;
  const MergeTrees& trees;
};

using Places = std::vector<std::size_t>;
Places places_of(const std::vector<std::uint32_t>& records) { return {records.begin(), records.end()}; }

void require_same_tree(const Landscape& land, const MergeTree& fast, const oracle::MergeTree& truth,
                       const std::string& what) {
  land.require(fast.leaves == truth.leaves, "other leaves in the tree of " + what);
  land.require(fast.nodes.size() == truth.nodes.size(), "another number of nodes in the tree of " + what);
  for (std::size_t k = 0; k < truth.nodes.size(); ++k) {
    const std::string where = "node " + std::to_string(k) + " in the tree of " + what;
    land.require(places_of(fast.nodes[k].parts) == truth.nodes[k].parts, "other parts of " + where);
    land.require(places_of(fast.nodes[k].points) == truth.nodes[k].points, "other points of " + where);
    land.require(land.value(fast.nodes[k].points.front()) == truth.nodes[k].value, "another value of " + where);
  }
}

// The squares of 0, and of lengths of pairs, exactly where they are rational and from above: that of a part is the root
// of its greatest value less that of the node's.
std::vector<Rational> squared_persistences(const Landscape& land, const oracle::MergeTree& tree) {
  const Places maxima = oracle::maxima_places(land.stationary);
  std::set<Rational> lengths;
  for (const oracle::MergeNode& node : tree.nodes) {
    for (const std::size_t part : node.parts) {
      Rational greatest = 0;
      for (const std::size_t leaf : oracle::leaves_of(tree, part)) {
        if (leaf < maxima.size()) greatest = std::max(greatest, land.value(maxima[leaf]));
      }
      if (greatest > 0) lengths.insert(geometry::square_from_above({greatest, node.value}));
    }
  }
  const std::vector<Rational> sorted(lengths.begin(), lengths.end());
  std::vector<Rational> all = {0};
  if (sorted.size() > 1) all.push_back(sorted[sorted.size() / 2 - 1]);
  if (!sorted.empty()) all.push_back(sorted[sorted.size() - 1 - sorted.size() / 4]);
  return all;
}

// Radii at which something passes just so, or just not.
std::vector<Rational> squared_probes(const Landscape& land, const oracle::Pocket& truth) {
  std::set<Rational> values = {0, truth.to_infinity.value, truth.to_infinity.value + Rational(1, 1000)};
  for (const std::size_t mouth : truth.mouths) values.insert(land.value(mouth));
  return {values.begin(), values.end()};
}

// By the shares of the oracle's volumes (FC-VOL-02).
std::vector<PointId> lining_of(const Landscape& land, const oracle::Pocket& truth) {
  const oracle::PointSet& set = land.subject.set;
  std::set<PointId> samples;
  for (const std::size_t place : truth.cell) {
    if (land.stationary[place].hull_dimension < 2) continue;
    const std::vector<oracle::Rational> shares = oracle::shares(set, oracle::stable_set(set, land.stationary[place]));
    for (std::size_t k = 0; k < shares.size(); ++k) {
      if (shares[k] != 0) samples.insert(static_cast<PointId>(set.names[k]));
    }
  }
  return {samples.begin(), samples.end()};
}

void require_same_pocket(const Landscape& land, const Pockets& pockets, const Pocket& fast,
                         const oracle::Pocket& truth) {
  land.require(places_of(fast.maxima) == truth.maxima, "other maxima of a pocket");
  land.require(places_of(fast.peaks) == truth.peaks, "other peaks of a pocket");
  land.require(places_of(fast.cell) == truth.cell, "another cell of a pocket");
  land.require(places_of(fast.mouths) == truth.mouths, "other mouths of a pocket");
  land.require(places_of(fast.neighbours) == truth.neighbours, "other neighbours of a pocket");
  land.require(places_of(fast.to_infinity.gates) == truth.to_infinity.gates, "other gates of the widest path");
  land.require(land.value(fast.to_infinity.gates.front()) == truth.to_infinity.value, "another widest path");
  land.require(pockets.difference_of_squares(fast) == truth.height - truth.highest_mouth,
               "another difference of squares");
  land.require(land.value(fast.highest_mouth) == truth.highest_mouth, "another highest mouth");
  const StableVolumes& volumes = land.subject.complex.volumes();
  land.require(volumes.exact_sum(fast.cell) == truth.volume, "another volume of a pocket");
  land.require(volumes.nearest_sum(fast.cell) == nearest_or_infinity(truth.volume), "a volume rounded otherwise");
  land.require(oracle::is_nearest_root_difference(pockets.depth(fast), truth.height, truth.highest_mouth),
               "another depth of a pocket");
  land.require(Pockets::lining(fast, volumes) == lining_of(land, truth), "other samples line a pocket");
  for (const Rational& squared_radius : squared_probes(land, truth)) {
    const auto expected = oracle::passage(land.stationary, truth, squared_radius);
    land.require(static_cast<int>(pockets.passage(fast, squared_radius)) == static_cast<int>(expected),
                 "something else for a probe with the squared radius " + squared_radius.str());
  }
}

// FC-POCK-03, of all stationary points but samples.
void require_same_above(const Landscape& land, const Pockets& pockets, const oracle::Pockets& truth) {
  const Places maxima = oracle::maxima_places(land.stationary);
  Places number_of(maxima.size() + 1, truth.pockets.size());
  for (std::size_t number = 0; number < truth.pockets.size(); ++number) {
    for (const std::size_t maximum : truth.pockets[number].maxima) {
      number_of[static_cast<std::size_t>(std::ranges::find(maxima, maximum) - maxima.begin())] = number;
    }
  }
  for (std::size_t record = 0; record < land.stationary.size(); ++record) {
    std::set<std::size_t> above;
    for (const std::size_t leaf : land.above.of[record]) above.insert(number_of[leaf]);
    land.require(places_of(pockets.above(record)) == Places(above.begin(), above.end()),
                 "other pockets above a stationary point");
  }
}

void require_same_pockets(const Landscape& land, const Rational& squared_persistence, Totals& totals) {
  const Pockets pockets(land.trees, squared_persistence);
  const oracle::Pockets truth = oracle::pockets(land.subject.set, land.stationary, squared_persistence);
  land.require(pockets.size() == truth.pockets.size(), "another number of pockets");
  land.require(places_of(pockets.outside()) == truth.outside, "other maxima outside");
  for (std::size_t k = 0; k < pockets.size(); ++k) {
    require_same_pocket(land, pockets, pockets[k], truth.pockets[k]);
    totals.merged += pockets[k].maxima.size() > 1 ? 1 : 0;
    const auto& [height, mouth] = std::tie(truth.pockets[k].height, truth.pockets[k].highest_mouth);
    totals.apart += oracle::is_root_difference_up_to(height, mouth, squared_persistence) ? 1 : 0;
    totals.gates += pockets[k].to_infinity.gates.size();
  }
  require_same_above(land, pockets, truth);
  const auto widest = oracle::widest_path(truth);
  land.require(pockets.widest_path().has_value() == widest.has_value(), "a widest path, or none");
  land.require(!widest || places_of(pockets.widest_path()->gates) == widest->gates, "other gates of the whole");
  land.require(places_of(pockets.largest_balls()) == oracle::largest_balls(land.stationary, truth),
               "other largest balls");
  totals.pockets += pockets.size();
  totals.outside += pockets.outside().size();
}

// FC-POCK-11, also for areas at both ends of the doubles.
bool is_right_area(double area, const std::vector<oracle::Rational>& squares) {
  oracle::Rational greatest = 0;
  for (const oracle::Rational& square : squares) greatest = std::max(greatest, square);
  const oracle::Rational count = 1 + squares.size();
  if (std::isinf(area)) return greatest * count * count > oracle::Rational(0x1p1023) * oracle::Rational(0x1p1023);
  // All of them together are less than 2^-1060.
  const oracle::Rational tiny = oracle::Rational(0x1p-1060) / count;
  if (area < 0x1p-1060 && greatest < tiny * tiny) return true;
  return judge::is_root_sum(area, squares);
}

void require_right_areas(const Landscape& land, Totals& totals) {
  const StableManifolds& stable = land.subject.complex.stable();
  for (std::size_t i = 0; i < stable.size(); ++i) {
    const auto set = oracle::stable_set(land.subject.set, land.stationary[stable.record(i)]);
    const double area = surface_area(land.subject.complex.points(), stable, i);
    land.require(is_right_area(area, oracle::squared_areas(land.subject.set, set)), "another area of an S2");
    ++totals.areas;
  }
}

void require_right_landscape(const Subject& subject, Totals& totals) {
  ++totals.inputs;
  if (subject.complex.points().empty()) {
    RC_ASSERT(subject.complex.merge_trees().pockets().leaves == 0U);
    RC_ASSERT(Pockets(subject.complex.merge_trees(), 0).size() == 0U);
    return;
  }
  const Landscape land(subject);
  const oracle::MergeTree tree = oracle::superlevel_tree(subject.set, land.stationary);
  require_same_tree(land, land.trees.pockets(), tree, "pockets");
  require_same_tree(land, land.trees.components(), oracle::sublevel_tree(subject.set, land.stationary), "components");
  for (const Rational& square : squared_persistences(land, tree)) require_same_pockets(land, square, totals);
  require_right_areas(land, totals);
}

bool expect_in_chambers(Totals& all) {
  Totals totals;
  const auto inputs = static_cast<std::uint64_t>(static_cast<double>(kInputsOfChambers) * scale_of_run());
  bool is_right = true;
  for (std::uint64_t seed = 0; seed < inputs; ++seed) {
    const fuzz::Input input = fuzz::input_with_pockets(seed);
    is_right = expect_holds("pockets, chambers", parameters_of_one_input(),
                            [&] { require_right_landscape(Subject(input), totals); }) &&
               is_right;
  }
  totals.print_row("chambers");
  all.add(totals);
  return is_right;
}

TEST(PocketAgreement, TreesAndPocketsAreTheOracles) {
  CITES("FC-TREE-01", "FC-TREE-02", "FC-TREE-03", "FC-TREE-06", "FC-TREE-07", "FC-POCK-01", "FC-POCK-02", "FC-POCK-03",
        "FC-POCK-04", "FC-POCK-05", "FC-POCK-06", "FC-POCK-07", "FC-POCK-08", "FC-POCK-11");
  Totals all;
  const auto of_few_rows = [](const Subject& drawn, Totals& totals) {
    if (drawn.input.rows.size() <= kMostRows) return require_right_landscape(drawn, totals);
    fuzz::Input cut = drawn.input;
    cut.rows.resize(kMostRows);
    require_right_landscape(Subject(cut), totals);
  };
  const bool in_chambers = expect_in_chambers(all);
  const bool in_families = expect_in_all_families("pockets", {kInputsPerFamily, kInputsMadeForThis}, of_few_rows, all);
  if (in_chambers && in_families && scale_of_run() >= 1) {
    EXPECT_GE(all.inputs, 250U);
    EXPECT_GE(all.pockets, 200U);
    EXPECT_GE(all.merged, 12U);
    EXPECT_GE(all.apart, 10U);
    EXPECT_GE(all.outside, 100U);
  }
}

}  // namespace
}  // namespace flowcert::property::pocket_agreement_test
