// Mutations of inputs: the relation that each is named after holds exactly, on many parents of every family.
// Nothing else changes, and each applies often enough to be of use.
//
// Guarantees: relations are checked in rationals, from the definitions; seeds are fixed.
#include "fuzz/campaign/mutation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <limits>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "fuzz/inputs/input.h"
#include "fuzz/inputs/large_configurations.h"
#include "fuzz/inputs/stable_configurations.h"
#include "tests/unit/rational_geometry.h"

namespace flowcert::fuzz::mutation_test {
namespace {

using flowcert_tests::circle_center;
using flowcert_tests::circumcenter;
using flowcert_tests::inner;
using flowcert_tests::minus;
using flowcert_tests::normal_of;
using flowcert_tests::squared_distance;

constexpr std::uint64_t kSeeds = 6;
const RationalPoint kOrigin{0, 0, 0};

RationalPoint exactly(const Row& row) { return {Rational(row[0]), Rational(row[1]), Rational(row[2])}; }

// The points that a mutation speaks of: the moved one, and those that it was placed by.
std::vector<RationalPoint> points_of(const Mutant& mutant) {
  std::vector<RationalPoint> points;
  points.reserve(mutant.rows.size());
  for (const std::size_t row : mutant.rows) points.push_back(exactly(mutant.input.rows.at(row)));
  return points;
}

const Mutation& mutation_named(const std::string& name) {
  const auto found = std::find_if(mutations().begin(), mutations().end(),
                                  [&](const Mutation& mutation) { return mutation.name == name; });
  EXPECT_NE(found, mutations().end()) << name;
  return *found;
}

// Calls check(parent, seed) for parents of all families, which have from no point to twelve.
template <typename Check>
void for_each_parent(const Check& check) {
  std::uint64_t parents = 0;
  for (const Family& family : families_and_stable_ones()) {
    for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
      for (const int size : {0, 40, 100}) check(draw(family, seed, size), ++parents);
    }
  }
}

// Applies one mutation to all parents and checks what it gives. Returns in how many percent it applied.
template <typename Check>
std::size_t percent_applied(const std::string& name, const Check& check) {
  std::size_t parents = 0;
  std::size_t applied = 0;
  for_each_parent([&](const Input& parent, std::uint64_t seed) {
    rc::Random random(seed);
    const auto mutant = mutation_named(name).apply(parent, random);
    ++parents;
    if (!mutant) return;
    ++applied;
    EXPECT_EQ(mutant->by, name);
    check(parent, *mutant);
  });
  return 100 * applied / parents;
}

// All rows but the one that was moved are the parent's, times one positive number.
void expect_others_are_scaled(const Input& parent, const Mutant& mutant) {
  Rational factor = 0;
  for (std::size_t row = 0; row < parent.rows.size(); ++row) {
    if (row == mutant.rows.front()) continue;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const Rational before(parent.rows[row][axis]);
      const Rational after(mutant.input.rows[row][axis]);
      if (before == 0) {
        EXPECT_EQ(after, 0) << parent;
        continue;
      }
      if (factor == 0) factor = after / before;
      EXPECT_EQ(after, factor * before) << parent << mutant.input;
    }
  }
  EXPECT_GE(factor, 0);
}

// A relation between the moved point, x[0], and the others.
using Relation = std::function<bool(const std::vector<RationalPoint>& x)>;

struct Move {
  std::string name;
  std::size_t others;
  std::size_t least_percent;
  Relation holds;
};

const std::vector<Move>& moves() {
  static const std::vector<Move> all{
      {"onto-circumsphere", 4, 60,
       [](const auto& x) {
         const RationalPoint z = circumcenter(x[1], x[2], x[3], x[4]);
         return squared_distance(x[0], z) == squared_distance(x[1], z);
       }},
      {"onto-circumcircle", 3, 70,
       [](const auto& x) {
         const RationalPoint z = circle_center(x[1], x[2], x[3]);
         return squared_distance(x[0], z) == squared_distance(x[1], z) &&
                inner(minus(x[0], z), normal_of(x[1], x[2], x[3])) == 0;
       }},
      {"onto-great-sphere", 3, 70,
       [](const auto& x) {
         const RationalPoint z = circle_center(x[1], x[2], x[3]);
         return squared_distance(x[0], z) == squared_distance(x[1], z);
       }},
      {"onto-diameter-sphere", 2, 85, [](const auto& x) { return inner(minus(x[1], x[0]), minus(x[2], x[0])) == 0; }},
      {"onto-foot", 2, 80, [](const auto& x) { return inner(minus(x[1], x[0]), minus(x[2], x[0])) == 0; }},
      {"onto-leg", 2, 80, [](const auto& x) { return inner(minus(x[0], x[1]), minus(x[2], x[1])) == 0; }},
      {"onto-bisector", 2, 80,
       [](const auto& x) { return squared_distance(x[0], x[1]) == squared_distance(x[0], x[2]); }},
      {"onto-mirror-image", 3, 75,
       [](const auto& x) {
         return squared_distance(x[0], x[1]) == squared_distance(x[3], x[2]) &&
                squared_distance(x[0], x[2]) == squared_distance(x[3], x[1]) &&
                normal_of(kOrigin, minus(x[0], x[3]), minus(x[1], x[2])) == kOrigin;
       }},
      {"onto-parallelogram", 3, 85, [](const auto& x) { return minus(x[0], x[1]) == minus(x[2], x[3]); }},
      {"onto-line", 2, 85, [](const auto& x) { return normal_of(x[0], x[1], x[2]) == kOrigin; }},
  };
  return all;
}

TEST(Mutations, PutPointsWhereTheySay) {
  for (const Move& move : moves()) {
    const std::size_t percent = percent_applied(move.name, [&](const Input& parent, const Mutant& mutant) {
      ASSERT_EQ(mutant.rows.size(), move.others + 1) << move.name;
      const std::set<std::size_t> rows(mutant.rows.begin(), mutant.rows.end());
      EXPECT_EQ(rows.size(), mutant.rows.size()) << move.name;
      EXPECT_TRUE(move.holds(points_of(mutant))) << move.name << '\n' << parent << '\n' << mutant.input;
      const std::size_t added = mutant.input.rows.size() - parent.rows.size();
      EXPECT_EQ(mutant.rows.front() == parent.rows.size(), added == 1) << move.name;
      expect_others_are_scaled(parent, mutant);
    });
    EXPECT_GE(percent, move.least_percent) << move.name;
    RecordProperty(move.name, static_cast<int>(percent));
  }
}

// A move's relation does not hold for arbitrary points, so the tests of moves do assert something.
TEST(Mutations, RelationsOfMovesDoNotHoldByThemselves) {
  const std::vector<RationalPoint> points{exactly({7, 1, 3}), exactly({0, 0, 1}), exactly({5, -2, 0}),
                                          exactly({1, 4, 9}), exactly({-3, 2, 2})};
  for (const Move& move : moves()) EXPECT_FALSE(move.holds(points)) << move.name;
}

// ---- Changes of other sorts ----

double largest_coordinate(const Input& input) {
  double largest = 0;
  for (const Row& row : input.rows) {
    for (const double x : row) largest = std::max(largest, std::abs(x));
  }
  return largest;
}

Rational power_of_two(int exponent) {
  const Rational power(boost::multiprecision::mpz_int(1) << static_cast<unsigned>(std::abs(exponent)));
  return exponent < 0 ? Rational(1 / power) : power;
}

TEST(Mutations, SnapGoesToTheNearestLatticePoint) {
  const auto check = [](const Input& parent, const Mutant& mutant) {
    int top = 0;
    std::frexp(largest_coordinate(parent), &top);
    ASSERT_EQ(mutant.input.rows.size(), parent.rows.size());
    EXPECT_TRUE(mutant.rows.size() == 1 || mutant.rows.size() == parent.rows.size());
    // One of the six lattices holds all coordinates.
    bool is_found = false;
    for (int exponent = top - 5; exponent <= top; ++exponent) {
      const Rational step = power_of_two(exponent);
      bool fits = true;
      for (const std::size_t row : mutant.rows) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
          const Rational x(mutant.input.rows[row][axis]);
          const Rational moved = x - Rational(parent.rows[row][axis]);
          fits = fits && denominator(Rational(x / step)) == 1 && 2 * abs(moved) <= step;
        }
      }
      is_found = is_found || fits;
    }
    EXPECT_TRUE(is_found) << parent << '\n' << mutant.input;
  };
  EXPECT_GE(percent_applied("snap", check), 40U);
}

TEST(Mutations, DuplicateCopiesARow) {
  const auto check = [](const Input& parent, const Mutant& mutant) {
    ASSERT_EQ(mutant.rows.size(), 2U);
    EXPECT_NE(mutant.rows[0], mutant.rows[1]);
    EXPECT_EQ(mutant.input.rows[mutant.rows[0]], mutant.input.rows[mutant.rows[1]]);
    expect_others_are_scaled(parent, mutant);
  };
  EXPECT_GE(percent_applied("duplicate", check), 80U);
}

// The axes on which the row that a mutation speaks of has changed.
std::vector<std::size_t> changed_axes(const Input& parent, const Mutant& mutant) {
  std::vector<std::size_t> axes;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t row = mutant.rows.front();
    if (mutant.input.rows[row][axis] != parent.rows[row][axis]) axes.push_back(axis);
  }
  return axes;
}

TEST(Mutations, NudgeIsOneUlpOfOneCoordinate) {
  const auto check = [](const Input& parent, const Mutant& mutant) {
    const auto axes = changed_axes(parent, mutant);
    ASSERT_EQ(axes.size(), 1U);
    const double before = parent.rows[mutant.rows[0]][axes[0]];
    const double after = mutant.input.rows[mutant.rows[0]][axes[0]];
    EXPECT_TRUE(after == nudged(before, 1) || after == nudged(before, -1));
    expect_others_are_scaled(parent, mutant);
  };
  EXPECT_GE(percent_applied("nudge", check), 90U);
}

TEST(Mutations, CopyCoordinateTakesOne) {
  const auto check = [](const Input& parent, const Mutant& mutant) {
    const auto axes = changed_axes(parent, mutant);
    ASSERT_EQ(axes.size(), 1U);
    const Row& giver = mutant.input.rows[mutant.rows.at(1)];
    const double taken = mutant.input.rows[mutant.rows[0]][axes[0]];
    EXPECT_NE(std::find(giver.begin(), giver.end(), taken), giver.end());
    expect_others_are_scaled(parent, mutant);
  };
  EXPECT_GE(percent_applied("copy-coordinate", check), 50U);
}

TEST(Mutations, RemoveTakesOneRowAndAddBringsOne) {
  const auto is_one_less = [](const Input& less, const Input& more) {
    bool is_found = false;
    for (std::size_t row = 0; row < more.rows.size(); ++row) {
      Input without = more;
      without.rows.erase(without.rows.begin() + static_cast<std::ptrdiff_t>(row));
      is_found = is_found || without == less;
    }
    return is_found;
  };
  EXPECT_GE(percent_applied("remove",
                            [&](const Input& parent, const Mutant& mutant) {
                              EXPECT_TRUE(is_one_less(mutant.input, parent)) << parent << mutant.input;
                            }),
            85U);
  EXPECT_GE(percent_applied("add",
                            [&](const Input& parent, const Mutant& mutant) {
                              EXPECT_TRUE(is_one_less(parent, mutant.input)) << parent << mutant.input;
                            }),
            60U);
}

TEST(Mutations, ScaleIsByAPowerOfTwo) {
  const auto check = [](const Input& parent, const Mutant& mutant) {
    const Rational before(largest_coordinate(parent));
    const Rational factor = Rational(largest_coordinate(mutant.input)) / before;
    const auto is_power = [](const boost::multiprecision::mpz_int& value) { return lsb(value) == msb(value); };
    EXPECT_TRUE(is_power(numerator(factor)) && is_power(denominator(factor))) << factor;
    for (std::size_t row = 0; row < parent.rows.size(); ++row) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        EXPECT_EQ(Rational(mutant.input.rows[row][axis]), factor * Rational(parent.rows[row][axis]));
      }
    }
  };
  EXPECT_GE(percent_applied("scale", check), 70U);
}

// All distances grow by one factor. So do volumes with their sign: a turn is no reflection.
TEST(Mutations, TurnKeepsShapes) {
  const auto check = [](const Input& parent, const Mutant& mutant) {
    ASSERT_EQ(mutant.input.rows.size(), parent.rows.size());
    Rational factor = 0;
    for (std::size_t a = 0; a < parent.rows.size(); ++a) {
      for (std::size_t b = 0; b < parent.rows.size(); ++b) {
        const Rational before = inner(exactly(parent.rows[a]), exactly(parent.rows[b]));
        const Rational after = inner(exactly(mutant.input.rows[a]), exactly(mutant.input.rows[b]));
        if (before == 0) {
          EXPECT_EQ(after, 0);
        } else {
          if (factor == 0) factor = after / before;
          EXPECT_EQ(after, factor * before);
        }
      }
    }
    EXPECT_GE(factor, 1);
  };
  EXPECT_GE(percent_applied("turn", check), 45U);
}

// ---- All of them ----

void expect_valid(const Mutant& mutant, const Input& parent) {
  EXPECT_FALSE(mutant.input.rows.empty());
  EXPECT_LE(mutant.input.rows.size(), std::max(parent.rows.size(), kMostMutantRows));
  EXPECT_NE(mutant.input, parent) << mutant.by;
  for (const Row& row : mutant.input.rows) {
    for (const double x : row) EXPECT_TRUE(std::isfinite(x)) << mutant.by;
  }
  for (const std::size_t row : mutant.rows) EXPECT_LT(row, mutant.input.rows.size()) << mutant.by;
}

TEST(Mutations, NamesAreUniqueAndAllOfThemComeUp) {
  std::set<std::string> names;
  for (const Mutation& mutation : mutations()) {
    EXPECT_TRUE(names.insert(mutation.name).second) << mutation.name;
    EXPECT_FALSE(mutation.description.empty());
  }
  std::map<std::string, std::size_t> times;
  std::size_t all = 0;
  for_each_parent([&](const Input& parent, std::uint64_t seed) {
    const Mutant mutant = mutated(parent, seed);
    ++times[mutant.by];
    ++all;
    expect_valid(mutant, parent);
  });
  // Each one comes up at least a third as often as it would if all applied always.
  for (const std::string& name : names) EXPECT_GE(3 * names.size() * times[name], all) << name;
}

TEST(Mutations, StayValidOverManyGenerations) {
  for (const Family& family : families_and_stable_ones()) {
    Input input = draw(family, 5, 60);
    for (std::uint64_t generation = 0; generation < 40; ++generation) {
      Mutant mutant = mutated(input, generation);
      expect_valid(mutant, input);
      input = std::move(mutant.input);
    }
  }
}

TEST(Mutations, ApplyToWhateverThereIs) {
  const double most = std::numeric_limits<double>::max();
  const double least = std::numeric_limits<double>::denorm_min();
  const std::vector<Input> parents{{},
                                   {{{0, 0, 0}}},
                                   {{{most, -most, least}}},
                                   {std::vector<Row>(12, Row{0, 0, 0})},
                                   {std::vector<Row>(20, Row{1, 2, 3})},
                                   {{{most, most, most}, {-most, least, 0}, {-least, 0, most}, {1, 2, 3}}},
                                   long_cascade(300, 1)};
  for (const Input& parent : parents) {
    for (std::uint64_t seed = 0; seed < 60; ++seed) expect_valid(mutated(parent, seed), parent);
  }
}

TEST(Mutations, SameParentAndSeedSameMutant) {
  std::set<std::vector<Row>> seen;
  const Input parent = draw(families().front(), 3, 80);
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const Mutant mutant = mutated(parent, seed);
    const Mutant again = mutated(parent, seed);
    EXPECT_EQ(mutant.input, again.input);
    EXPECT_EQ(mutant.by, again.by);
    EXPECT_EQ(mutant.rows, again.rows);
    seen.insert(mutant.input.rows);
  }
  EXPECT_GE(seen.size(), 80U);
}

// Pins the mutants: if these lines change, seeds in old reports name other mutants.
TEST(Mutations, SeedsNameTheSameMutantsForGood) {
  const Input parent{{{0, 0, 0}, {4, 1, 0}, {1, 3, -2}, {0, 2, 5}, {-1, -1, 2}}};
  std::ostringstream text;
  for (std::uint64_t seed = 0; seed < 8; ++seed) text << mutated(parent, seed).by << ' ';
  for (const Mutation& mutation : mutations()) {
    rc::Random random(7);
    const Mutant mutant = mutation.apply(parent, random).value();
    // The row that has moved or come, or the last row, and then row 1, which shows a common factor.
    const std::size_t row = mutant.rows.empty() ? mutant.input.rows.size() - 1 : mutant.rows[0];
    text << '\n' << mutation.name << ' ' << Input{{mutant.input.rows[row], mutant.input.rows[1]}};
  }
  EXPECT_EQ(text.str(),
            "scale scale scale duplicate turn remove onto-leg onto-bisector \n"
            "onto-circumsphere 0 10 -1\n124 31 0\n\n"
            "onto-circumcircle -47 80 43\n84 21 0\n\n"
            "onto-great-sphere 0 -73 56\n172 43 0\n\n"
            "onto-diameter-sphere 0 0 5\n4 1 0\n\n"
            "onto-foot -1 -1 -2\n4 1 0\n\n"
            "onto-leg -13 5 2\n4 1 0\n\n"
            "onto-bisector -12 7 0\n4 1 0\n\n"
            "onto-mirror-image 1 -4 1\n12 3 0\n\n"
            "onto-parallelogram 1 3 3\n1 3 3\n\n"
            "onto-line 0 1 2.5\n4 1 0\n\n"
            "snap 0 0 0\n4 1 0\n\n"
            "duplicate 0 0 0\n4 1 0\n\n"
            "nudge 0 2 5.000000000000001\n4 1 0\n\n"
            "copy-coordinate 4 2 5\n4 1 0\n\n"
            "remove -1 -1 2\n4 1 0\n\n"
            "add 1 -1 1\n4 1 0\n\n"
            "scale -0.00390625 -0.00390625 0.0078125\n0.015625 0.00390625 0\n\n"
            "turn 10 22 -4\n-10 -24 -32\n");
}

}  // namespace
}  // namespace flowcert::fuzz::mutation_test
