// Stable sets, boundaries and persistence of an input and of the same input transformed: rows permuted, axes
// permuted and mirrored, scaled by powers of two, translated, and turned by rational rotations of integer
// points. No oracle is needed.
//
// Guarantees: the transformed answer is compared with the answer of the transformed input, exactly and name
// by name; boundaries in the chain complex only where no tie leaves a choice. The test fails too when too few
// transformations were other than the identity, or too few of the sets had anything to them.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cstdio>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "flowcert/flow_complex.h"
#include "fuzz/inputs/stable_configurations.h"
#include "fuzz/inputs/transformations.h"
#include "fuzz/properties/stable_pieces.h"
#include "tests/cites.h"
#include "tests/property/alpha_persistence.h"
#include "tests/property/orbit_subject.h"
#include "tests/property/property_parameters.h"
#include "tests/property/transformed_answers.h"
#include "tests/transformed_inputs.h"

namespace flowcert::property::stable_metamorphic_test {
namespace {

constexpr int kInputsPerFamily = 35;

struct SetAnswer {
  StableSet<> pieces;
  std::optional<std::set<Ids>> boundary;  // where no tie is broken

  friend bool operator==(const SetAnswer&, const SetAnswer&) = default;
};

struct StableAnswer {
  std::map<Ids, SetAnswer> sets;  // by the contact set of the stationary point
  std::vector<ExactPair> pairs;
};

// Empty names leave all names as they are.
using Names = std::vector<std::size_t>;

struct Transformation {
  std::function<RationalPoint(const RationalPoint&)> move;
  Rational squared_factor = 1;
  Names names;
  bool is_identity = false;
};

bool has_tie(const StableManifolds& manifolds, std::size_t i, const StableSet<>& set) {
  return manifolds.has_vertex(i) || std::any_of(set.segments.begin(), set.segments.end(),
                                                [](const auto& s) { return s.back_kind == BackKind::kRegular; });
}

StableAnswer answer_of(const fuzz::Input& input) {
  const FlowComplex complex(point_set_of(input));
  const StationaryPoints& stationary = complex.stationary();
  const StableManifolds& stable = complex.stable();
  StableAnswer answer{{}, exact_pairs(complex.persistence())};
  for (std::size_t i = 0; i < stable.size(); ++i) {
    const std::size_t record = stable.record(i);
    const StableSet<> set = stable.set(i);
    SetAnswer& own = answer.sets[ids(stationary.contact(record))];
    own.pieces = set;
    if (!stationary.index(record).is_critical() || has_tie(stable, i, set)) continue;
    own.boundary.emplace();
    for (const std::uint32_t cell : stable.boundary(i)) own.boundary->insert(ids(stationary.contact(cell)));
  }
  return answer;
}

Ids renamed(Ids contact, const Names& names) {
  for (std::size_t& name : contact) name = names.empty() ? name : names[name];
  std::sort(contact.begin(), contact.end());
  return contact;
}

template <class List>
void rename(List& contact, const Names& names) {
  for (PointId& name : contact) name = names.empty() ? name : static_cast<PointId>(names[name]);
  std::ranges::sort(contact);
}

void move(Corner<>& corner, const Transformation& by) { corner.position = by.move(corner.position); }

// The moved corners, from the least one towards the lesser of its neighbours.
void move(std::vector<Corner<>>& corners, const Transformation& by) {
  for (Corner<>& corner : corners) move(corner, by);
  std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  if (corners.back() < corners[1]) std::reverse(corners.begin() + 1, corners.end());
}

StableSet<> moved(StableSet<> set, const Transformation& by) {
  for (BackwardSegment<>& segment : set.segments) {
    rename(segment.samples, by.names), rename(segment.front_contact, by.names), rename(segment.back_contact, by.names);
    move(segment.front, by), move(segment.back, by);
  }
  for (BackwardInterval<>& interval : set.intervals) {
    rename(interval.polygon, by.names);
    move(interval.front, by), move(interval.back, by);
  }
  for (Region<>& sector : set.sectors) rename(sector.samples, by.names), move(sector.corners, by);
  std::ranges::sort(set.segments, {}, [](const auto& s) { return std::tie(s.samples, s.front); });
  std::ranges::sort(set.intervals, {}, [](const auto& i) { return std::tie(i.polygon, i.front); });
  std::ranges::sort(set.sectors, {}, [](const auto& s) { return std::tie(s.samples, s.corners); });
  return set;
}

StableAnswer moved(const StableAnswer& answer, const Transformation& by) {
  StableAnswer result{{}, answer.pairs};
  for (const auto& [contact, set] : answer.sets) {
    SetAnswer& own = result.sets[renamed(contact, by.names)];
    own.pieces = moved(set.pieces, by);
    if (!set.boundary) continue;
    own.boundary.emplace();
    for (const Ids& edge : *set.boundary) own.boundary->insert(renamed(edge, by.names));
  }
  for (ExactPair& pair : result.pairs) {
    pair.birth *= by.squared_factor;
    if (pair.death) *pair.death *= by.squared_factor;
  }
  return result;
}

void require_same(const fuzz::Input& transformed, const StableAnswer& own, const StableAnswer& expected) {
  for (const auto& [contact, set] : expected.sets) {
    const auto found = own.sets.find(contact);
    require_none(transformed, found == own.sets.end() ? "no set of " + text_of(contact) : "", "");
    require_none(
        transformed, found->second == set ? "" : "the set of " + text_of(contact),
        "of the transformed input:\n" + text_of(found->second.pieces) + "transformed:\n" + text_of(set.pieces));
  }
  require_none(transformed, own.sets.size() == expected.sets.size() ? "" : "more sets than expected", "");
  require_none(transformed, difference(own.pairs, expected.pairs), "");
}

struct Seen {
  int inputs = 0, not_identity = 0;
  std::size_t segments = 0, intervals = 0, sectors = 0, boundaries = 0, pairs = 0;

  void add(const StableAnswer& answer) {
    for (const auto& [contact, set] : answer.sets) {
      segments += set.pieces.segments.size();
      intervals += set.pieces.intervals.size();
      sectors += set.pieces.sectors.size();
      boundaries += set.boundary ? 1 : 0;
    }
    pairs += answer.pairs.size();
  }
};

// The transformed input, if there is an exact one.
using Draw = std::function<std::optional<fuzz::Input>(const fuzz::Input&, Transformation&)>;

void expect_equivariance(const char* what, const Draw& draw_transformation, int least_percent) {
  Seen seen;
  bool held = true;
  for (const fuzz::Family& family : fuzz::families_and_stable_ones()) {
    const rc::Gen<fuzz::Input> generator = family.generate();
    const auto property = [&] {
      const fuzz::Input input = *generator;
      Transformation by{[](const RationalPoint& x) { return x; }, 1, {}, false};
      ++seen.inputs;
      const std::optional<fuzz::Input> transformed = draw_transformation(input, by);
      if (!transformed || by.is_identity) return;
      ++seen.not_identity;
      const StableAnswer answer = answer_of(input);
      seen.add(answer);
      require_same(*transformed, answer_of(*transformed), moved(answer, by));
    };
    held = expect_holds(family.name + ", " + what, parameters_of_run(kInputsPerFamily, held), property) && held;
  }
  std::printf(
      "%s: %d of %d inputs transformed; %zu segments, %zu intervals, %zu sectors, %zu boundaries, %zu "
      "pairs\n",
      what, seen.not_identity, seen.inputs, seen.segments, seen.intervals, seen.sectors, seen.boundaries, seen.pairs);
  if (!held || scale_of_run() < 1) return;
  EXPECT_GE(seen.not_identity * 100, seen.inputs * least_percent);
  EXPECT_GE(seen.segments, 4000U);
  EXPECT_GE(seen.intervals, 200U);
  EXPECT_GE(seen.sectors, 800U);
  EXPECT_GE(seen.boundaries, 800U);
  EXPECT_GE(seen.pairs, 4000U);
}

TEST(StableMetamorphic, PermutedRowsPermuteNames) {
  CITES("FC-STAB-01", "FC-PERS-01", "FC-PERS-04", "FC-IN-03");
  expect_equivariance(
      "permuted",
      [](const fuzz::Input& input, Transformation& by) -> std::optional<fuzz::Input> {
        const auto order = *fuzz::row_orders(input.rows.size());
        by.names = names_after(input, order);
        by.is_identity = std::is_sorted(order.begin(), order.end());
        return fuzz::permuted(input, order);
      },
      80);
}

TEST(StableMetamorphic, SignedAxisPermutationMovesSets) {
  CITES("FC-STAB-01", "FC-PERS-01");
  expect_equivariance(
      "axes",
      [](const fuzz::Input& input, Transformation& by) -> std::optional<fuzz::Input> {
        const fuzz::AxisMap map = *fuzz::axis_maps().as("axes");
        const fuzz::AxisMap identity;
        by.move = [map](const RationalPoint& x) { return image_of(x, map); };
        by.is_identity = map.axis == identity.axis && map.sign == identity.sign;
        return fuzz::mapped(input, map);
      },
      80);
}

TEST(StableMetamorphic, PowerOfTwoScalesSetsAndValues) {
  CITES("FC-STAB-01", "FC-PERS-01");
  expect_equivariance(
      "scaled",
      [](const fuzz::Input& input, Transformation& by) {
        const int exponent = *fuzz::exact_scalings(input).as("exponent");
        const Rational factor = power_of_two(exponent);
        by.move = [factor](const RationalPoint& x) { return scaled_by(x, factor); };
        by.squared_factor = factor * factor;
        by.is_identity = exponent == 0;
        return fuzz::scaled(input, exponent);
      },
      80);
}

TEST(StableMetamorphic, ExactTranslationMovesSets) {
  CITES("FC-STAB-01", "FC-PERS-01");
  expect_equivariance(
      "translated",
      [](const fuzz::Input& input, Transformation& by) {
        const fuzz::Row offset = *fuzz::exact_translations(input).as("offset");
        by.move = [offset](const RationalPoint& x) { return translated_by(x, offset); };
        by.is_identity = offset == fuzz::Row{0, 0, 0};
        return fuzz::translated(input, offset);
      },
      60);
}

RationalPoint image_of(const RationalPoint& x, const fuzz::IntegerRotation& turn) {
  RationalPoint image;
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t axis = 0; axis < 3; ++axis) image[k] += Rational(turn.rows[k][axis]) * x[axis];
  }
  return image;
}

TEST(StableMetamorphic, RationalRotationTurnsSetsOfIntegerPoints) {
  CITES("FC-STAB-01", "FC-PERS-01");
  expect_equivariance(
      "turned",
      [](const fuzz::Input& input, Transformation& by) {
        const std::array<fuzz::Integer, 4> quaternion = {*fuzz::whole(-3, 3).as("a"), *fuzz::whole(-3, 3).as("b"),
                                                         *fuzz::whole(-3, 3).as("c"), *fuzz::whole(-3, 3).as("d")};
        const fuzz::IntegerRotation turn = fuzz::rotation_of_quaternion(quaternion);
        by.move = [turn](const RationalPoint& x) { return image_of(x, turn); };
        by.squared_factor = Rational(turn.norm * turn.norm);
        by.is_identity = turn.norm == turn.rows[0][0] && turn.norm == turn.rows[1][1];
        return fuzz::turned(input, turn);
      },
      50);
}

}  // namespace
}  // namespace flowcert::property::stable_metamorphic_test
