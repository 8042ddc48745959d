// Volumes of stable sets, and their shares, by the fast implementation against the oracle's (FC-VOL-01, 02), on all
// families.
//
// Guarantees: volumes and shares are compared as rationals. The oracle adds up sectors of Voronoi facets that it found
// by searching against the flow. The fast implementation adds up arcs of Voronoi edges, which it found by dividing
// facets. The double is compared with the one nearest to the rational.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "flowcert/stable_volumes.h"
#include "fuzz/properties/stable_pieces.h"
#include "oracle/stable_pieces.h"
#include "tests/cites.h"
#include "tests/property/family_run.h"
#include "tests/property/orbit_subject.h"

namespace flowcert::property::volume_agreement_test {
namespace {

constexpr int kInputsPerFamily = 32;
constexpr int kInputsMadeForThis = 80;     // of each of the families for stable sets
constexpr std::size_t kSetsByOracle = 30;  // at most so many of an input

struct Totals {
  std::size_t inputs = 0, sets = 0, positive = 0, not_of_maxima = 0, rounded = 0, whole_hulls = 0, shares = 0,
              rounded_shares = 0;

  void add(const Totals& part) {
    inputs += part.inputs;
    sets += part.sets;
    positive += part.positive;
    not_of_maxima += part.not_of_maxima;
    rounded += part.rounded;
    whole_hulls += part.whole_hulls;
    shares += part.shares;
    rounded_shares += part.rounded_shares;
  }
  void print_row(const std::string& name) const {
    std::printf(
        "%-24s %5zu inputs, %6zu sets, %5zu of positive volume, %4zu no maximum's; %4zu no doubles, %4zu hulls; "
        "%5zu shares, %5zu no doubles\n",
        name.c_str(), inputs, sets, positive, not_of_maxima, rounded, whole_hulls, shares, rounded_shares);
  }
};

std::string name_of(const StationaryPoints& stationary, std::size_t record) {
  return "the volume of " + text_of(ids(stationary.contact(record)));
}

// Each double is the nearest one to the exact share, and they are of the same samples.
void require_rounded_shares(const Subject& subject, const StationaryPoints& stationary, std::size_t record,
                            const std::vector<std::pair<PointId, Rational>>& exact,
                            const std::vector<std::pair<PointId, double>>& rounded, Totals& totals) {
  bool is_right = exact.size() == rounded.size();
  for (std::size_t k = 0; k < exact.size() && is_right; ++k) {
    is_right =
        rounded[k].first == exact[k].first && rounded[k].second == nearest_double(exact[k].second).value_or(HUGE_VAL);
    ++totals.shares;
    const bool is_finite = std::isfinite(rounded[k].second);
    totals.rounded_shares += is_finite && Rational(rounded[k].second) != exact[k].second ? 1 : 0;
  }
  require_none(subject.input, is_right ? "" : "a share is rounded otherwise, in " + name_of(stationary, record), "");
}

// The shares in the order of the samples that have some.
std::vector<std::pair<PointId, Rational>> shares_of(const oracle::PointSet& points, const oracle::StableSet& set) {
  std::vector<std::pair<PointId, Rational>> shares;
  const std::vector<oracle::Rational> all = oracle::shares(points, set);
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (all[k] != 0) shares.emplace_back(static_cast<PointId>(points.names[k]), all[k]);
  }
  return shares;
}

void require_right_volumes(const Subject& subject, Totals& totals) {
  const StationaryPoints& stationary = subject.complex.stationary();
  const FlowLimits limits(subject.complex.diagram(), stationary);
  const StableVolumes volumes(subject.complex.diagram(), stationary, limits);
  Rational sum = 0;
  std::size_t candidates = 0;
  for (std::size_t i = 0; i < stationary.size(); ++i) candidates += stationary.index(i).hull_dimension > 1 ? 1 : 0;
  const std::size_t step = 1 + candidates / kSetsByOracle;
  for (std::size_t i = 0, k = 0; i < stationary.size(); ++i) {
    const Rational fast = volumes.exact(i);
    sum += fast;
    require_none(subject.input, fast >= 0 ? "" : name_of(stationary, i) + " is negative", "");
    const auto nearest = nearest_double(fast);
    const bool is_nearest = volumes.nearest(i) == nearest_or_infinity(fast);
    require_none(subject.input, is_nearest ? "" : name_of(stationary, i) + " is rounded to another double", "");
    totals.rounded += nearest && Rational(*nearest) != fast ? 1 : 0;
    Rational shared = 0;
    const auto shares = volumes.shares(i);
    for (const auto& [name, share] : shares) shared += share;
    require_rounded_shares(subject, stationary, i, shares, volumes.rounded_shares(i), totals);
    require_none(subject.input, shared == fast ? "" : name_of(stationary, i) + " is not the sum of its shares", "");
    if (stationary.index(i).hull_dimension < 2) {
      require_none(subject.input, fast == 0 ? "" : name_of(stationary, i) + " is positive", "");
      continue;
    }
    if (k++ % step != 0) continue;
    const auto z = oracle_point(subject.complex.points(), stationary, i);
    const oracle::StableSet set = oracle::stable_set(subject.set, z);
    const oracle::Rational its = oracle::volume(subject.set, set);
    require_none(subject.input,
                 shares_of(subject.set, set) == shares ? "" : "other shares of " + name_of(stationary, i), "");
    require_none(subject.input, its == fast ? "" : name_of(stationary, i) + " is another one",
                 "the fast implementation's: " + fast.str() + "\nthe oracle's: " + its.str() + "\n");
    ++totals.sets;
    totals.positive += fast > 0 ? 1 : 0;
    totals.not_of_maxima += fast > 0 && stationary.index(i) != StationaryIndex{3, 3} ? 1 : 0;
  }
  require_none(subject.input, sum <= volumes.hull() ? "" : "the volumes are more than that of the hull", "");
  totals.whole_hulls += sum > 0 && sum == volumes.hull() ? 1 : 0;
  ++totals.inputs;
}

TEST(VolumeAgreement, VolumesAreTheOracles) {
  CITES("FC-VOL-01", "FC-VOL-02");
  Totals all;
  const bool agreed =
      expect_in_all_families("volumes", {kInputsPerFamily, kInputsMadeForThis}, require_right_volumes, all);
  if (agreed && scale_of_run() >= 1) {
    EXPECT_GE(all.inputs, 1100U);
    EXPECT_GE(all.positive, 600U);
    EXPECT_GE(all.not_of_maxima, 200U);
    EXPECT_GE(all.rounded, 300U);
    EXPECT_GE(all.whole_hulls, 65U);
    EXPECT_GE(all.rounded_shares, 1000U);
  }
}

}  // namespace
}  // namespace flowcert::property::volume_agreement_test
