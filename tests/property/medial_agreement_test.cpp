// The saddles of a medial axis by the fast implementation against the oracle's definitions (FC-MED-02, 03), on all
// families.
//
// Guarantees: angles are compared with bounds that are equal to some, between some, and with 60, 90, 120 and 180
// degrees. Which points of one value are in longer pairs may vary, and their number may not.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>
#include <string>
#include <vector>

#include "geometry/difference_of_roots.h"
#include "io/medial_points.h"
#include "oracle/medial_axis.h"
#include "tests/cites.h"
#include "tests/property/family_run.h"
#include "tests/property/orbit_subject.h"

namespace flowcert::property::medial_agreement_test {
namespace {

constexpr int kInputsPerFamily = 40;
constexpr int kInputsMadeForThis = 40;  // of each of the families for stable sets
constexpr std::size_t kMostRows = 12;

struct Totals {
  std::size_t inputs = 0, angles = 0, equal = 0, lengths = 0, radii = 0;

  void add(const Totals& part) {
    inputs += part.inputs;
    angles += part.angles;
    equal += part.equal;
    lengths += part.lengths;
    radii += part.radii;
  }
  void print_row(const std::string& name) const {
    std::printf("%-24s %5zu inputs, %5zu angles, %4zu of them equal to some; %5zu lengths, %5zu radii\n", name.c_str(),
                inputs, angles, equal, lengths, radii);
  }
};

using Places = std::vector<std::size_t>;

void require_right_angles(const Subject& subject, const std::vector<oracle::StationaryPoint>& all, Totals& totals) {
  struct Known {
    int degrees;
    Rational cosine;
  };
  for (const Known& known :
       {Known{0, 1}, Known{60, Rational(1, 2)}, Known{90, 0}, Known{120, Rational(-1, 2)}, Known{180, -1}}) {
    const Places truth = oracle::above_angle(subject.set, all, known.cosine);
    const Places fast = medial_points(subject.complex, {{}, Rational(known.degrees), {}}).records;
    require_none(subject.input, fast == truth ? "" : "other points above " + std::to_string(known.degrees), "");
    ++totals.angles;
    totals.equal += std::ranges::any_of(all,
                                        [&](const oracle::StationaryPoint& z) {
                                          const bool is_saddle =
                                              z.is_critical() && (z.hull_dimension == 1 || z.hull_dimension == 2);
                                          return is_saddle && oracle::contact_cosine(subject.set, z) == known.cosine;
                                        })
                        ? 1
                        : 0;
  }
  // Just beside the angle of a point, by a rational number of degrees that is near it.
  for (const oracle::StationaryPoint& z : all) {
    if (!z.is_critical() || z.hull_dimension != 2) continue;
    const double cosine = oracle::contact_cosine(subject.set, z).convert_to<double>();
    // Near 180 degrees a double's cosine does not tell them to twelve digits.
    if (std::fabs(cosine) > 0.99) continue;
    const double degrees = std::acos(cosine) * 180 / M_PI;
    for (const double beside : {degrees * (1 - 1e-12), degrees * (1 + 1e-12)}) {
      if (!(beside < 180)) continue;
      const bool is_above = is_above_angle(oracle::contact_cosine(subject.set, z), Rational(beside));
      require_none(subject.input, is_above == (beside < degrees) ? "" : "an angle is on the wrong side", "");
      ++totals.angles;
    }
    break;
  }
}

void require_right_lengths(const Subject& subject, const std::vector<oracle::StationaryPoint>& all, Totals& totals) {
  const std::vector<oracle::PersistencePair> pairs = oracle::persistence_pairs(subject.set);
  // Numbers just beside lengths, and lengths themselves where they are numbers of few digits.
  std::set<Rational> lengths = {0};
  for (const oracle::PersistencePair& pair : pairs) {
    if (!pair.death) continue;
    const double length = geometry::nearest_difference_of_roots(*pair.death, pair.birth);
    if (std::isfinite(length)) lengths.insert(Rational(length));
  }
  const std::size_t step = 1 + lengths.size() / 4;
  std::size_t k = 0;
  for (const Rational& length : lengths) {
    if (k++ % step != 0) continue;
    const Places chosen =
        medial_points(subject.complex, {LengthBound{LengthBound::Unit::kInput, length}, {}, {}}).records;
    std::set<std::pair<int, Rational>> values;
    for (const oracle::StationaryPoint& z : all) {
      if (z.is_critical() && (z.hull_dimension == 1 || z.hull_dimension == 2)) {
        values.emplace(z.hull_dimension, z.squared_distance);
      }
    }
    for (const auto& [index, value] : values) {
      const auto count = std::ranges::count_if(chosen, [&, of_index = index, of_value = value](std::size_t place) {
        return all[place].hull_dimension == of_index && all[place].squared_distance == of_value;
      });
      const bool is_right =
          static_cast<std::size_t>(count) == oracle::count_above_persistence(pairs, index, value, length * length);
      require_none(subject.input, is_right ? "" : "another number of points in longer pairs", length.str());
    }
    ++totals.lengths;
  }
}

// Radii just beside those of points, and half numbers, which many radii are.
void require_right_radii(const Subject& subject, const std::vector<oracle::StationaryPoint>& all, Totals& totals) {
  std::set<Rational> radii = {0, Rational(1, 2), 1, Rational(3, 2)};
  for (const oracle::StationaryPoint& z : all) {
    const double root = std::sqrt(z.squared_distance.convert_to<double>());
    if (radii.size() < 12 && std::isfinite(root)) radii.insert({Rational(root * (1 - 1e-12)), Rational(root * 1.5)});
  }
  for (const Rational& radius : radii) {
    const Places chosen =
        medial_points(subject.complex, {{}, {}, LengthBound{LengthBound::Unit::kInput, radius}}).records;
    Places expected;
    for (std::size_t place = 0; place < all.size(); ++place) {
      const oracle::StationaryPoint& z = all[place];
      const bool is_saddle = z.is_critical() && (z.hull_dimension == 1 || z.hull_dimension == 2);
      if (is_saddle && z.squared_distance > radius * radius) expected.push_back(place);
    }
    require_none(subject.input, chosen == expected ? "" : "other points are farther", radius.str());
    ++totals.radii;
  }
}

void require_right_points(const Subject& drawn, Totals& totals) {
  fuzz::Input cut = drawn.input;
  cut.rows.resize(std::min(cut.rows.size(), kMostRows));
  const Subject subject(cut);
  const auto all = oracle::stationary_points(subject.set).stationary;
  require_right_angles(subject, all, totals);
  require_right_lengths(subject, all, totals);
  require_right_radii(subject, all, totals);
  ++totals.inputs;
}

TEST(MedialAgreement, ChosenPointsAreTheOracles) {
  CITES("FC-MED-02", "FC-MED-03");
  Totals all;
  const bool agreed =
      expect_in_all_families("medial axis", {kInputsPerFamily, kInputsMadeForThis}, require_right_points, all);
  if (agreed && scale_of_run() >= 1) {
    EXPECT_GE(all.inputs, 1400U);
    EXPECT_GE(all.equal, 500U);
    EXPECT_GE(all.lengths, 1000U);
    EXPECT_GE(all.radii, 5000U);
  }
}

}  // namespace
}  // namespace flowcert::property::medial_agreement_test
