// The trial of the method had sixteen sets of balls; they are here, too. Sets of small integer centres were found by a
// search for what they have.
#include "tests/vectors/pore_recipes.h"

#include <random>
#include <utility>

#include "oracle/program/read_points.h"
#include "tests/vectors/recipes.h"

namespace oracle::vectors {

namespace {

using Rows4 = std::vector<BallWords>;

// "x y z r, x y z r"
Rows4 balls(const std::string& text) {
  Rows4 rows;
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t comma = std::min(text.find(',', from), text.size());
    const std::vector<std::string> words = fields(text.substr(from, comma - from));
    rows.push_back({words.at(0), words.at(1), words.at(2), words.at(3)});
    from = comma + 1;
  }
  return rows;
}

Rows4 operator+(Rows4 some, const Rows4& others) {
  some.insert(some.end(), others.begin(), others.end());
  return some;
}

// All with these coordinates and either sign.
Rows4 box(const BallWords& corner) {
  Rows4 rows = {corner};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (corner[axis] == "0") continue;
    const std::size_t count = rows.size();
    for (std::size_t k = 0; k < count; ++k) {
      rows.push_back(rows[k]);
      rows.back()[axis] = "-" + corner[axis];
    }
  }
  return rows;
}

Rows4 octahedron(const std::string& at, const std::string& radius) {
  return box({at, "0", "0", radius}) + box({"0", at, "0", radius}) + box({"0", "0", at, radius});
}

Rows4 tetrahedron(const std::string& at, const std::string& radius) {
  const std::string minus = "-" + at;
  return {{at, at, at, radius}, {at, minus, minus, radius}, {minus, at, minus, radius}, {minus, minus, at, radius}};
}

// Centres of {0..side-1}^3, radii of 1/4 to most/4.
Rows4 scattered_balls(std::uint64_t seed, std::size_t count, int side, int most) {
  const std::array<const char*, 6> kQuarters = {"0.25", "0.5", "0.75", "1", "1.25", "1.5"};
  std::mt19937_64 random(seed);
  const auto below = [&](int end) { return static_cast<std::size_t>(random() % static_cast<unsigned>(end)); };
  Rows4 rows;
  for (std::size_t k = 0; k < count; ++k) {
    BallWords& row = rows.emplace_back();
    for (std::size_t axis = 0; axis < 3; ++axis) row[axis] = std::to_string(below(side));
    row[3] = kQuarters.at(below(most));
  }
  return rows;
}

// A decimal with three places.
std::string thousandths(int count) {
  const std::string digits = std::to_string(1000 + count % 1000);
  return std::to_string(count / 1000) + "." + digits.substr(1);
}

// tests/inputs/cage.xyz with Bondi's radii: fourteen atoms, and what they become by the other turns of a tetrahedron.
Rows4 organic_cage() {
  struct Atom {
    const char* radius;
    std::array<int, 3> from_middle;  // thousandths
  };
  constexpr std::array<Atom, 14> kAtoms = {{{"1.55", {-904, 1115, 5510}},
                                            {"1.7", {-1331, 2733, 3179}},
                                            {"1.7", {-2096, 1627, 3515}},
                                            {"1.7", {-1773, 812, 4685}},
                                            {"1.7", {-707, 248, 6661}},
                                            {"1.7", {-977, 1056, 7921}},
                                            {"1.7", {-704, 216, 9161}},
                                            {"1.2", {-595, 2951, 3705}},
                                            {"1.2", {-2247, 22, 4814}},
                                            {"1.2", {-1324, -511, 6614}},
                                            {"1.2", {-1902, 1352, 7926}},
                                            {"1.2", {-409, 1843, 7931}},
                                            {"1.2", {-890, 734, 9960}},
                                            {"1.2", {-1285, -563, 9166}}}};
  constexpr std::array<std::array<int, 3>, 4> kSigns = {{{1, 1, 1}, {-1, -1, 1}, {1, -1, -1}, {-1, 1, -1}}};
  constexpr int kMiddle = 12400;
  Rows4 rows;
  for (std::size_t turn = 0; turn < 3; ++turn) {
    for (const auto& sign : kSigns) {
      for (const Atom& atom : kAtoms) {
        BallWords& row = rows.emplace_back();
        for (std::size_t axis = 0; axis < 3; ++axis) {
          const std::size_t from = (axis + turn) % 3;
          row[axis] = thousandths(kMiddle + sign[from] * atom.from_middle[from]);
        }
        row[3] = atom.radius;
      }
    }
  }
  return rows;
}

class PoreWriter {
 public:
  // At the depth 0 without a probe, and as it is asked further.
  void given(const std::string& comment, const Rows4& rows, const std::vector<PoreQuestion>& further = {}) {
    std::vector<PoreQuestion> questions = {{}};
    questions.insert(questions.end(), further.begin(), further.end());
    asked(comment, rows, questions);
  }
  void asked(const std::string& comment, const Rows4& rows, const std::vector<PoreQuestion>& questions) {
    recipes_.push_back({case_id("pores", recipes_.size() + 1), comment, rows, questions});
  }
  // The claim is of the recipe that was added last.
  void claimed(const std::vector<std::string>& lines, const std::vector<std::string>& reasons = {}) {
    recipes_.back().claims.push_back({lines, reasons});
  }
  void refused(const std::string& comment, const Rows4& rows) { asked(comment, rows, {}); }
  const std::vector<PoreRecipe>& recipes() const { return recipes_; }

 private:
  std::vector<PoreRecipe> recipes_;
};

void add_few(PoreWriter& cases) {
  cases.given("no ball", {}, {{"0", "1"}});
  cases.given("one ball", balls("1 2 3 1"));
  cases.given("two balls apart: there is no gate of two balls", balls("-2 0 0 1, 2 0 0 1"), {{"0", "1"}});
  cases.given("two balls that touch: a value of 0", balls("-2 0 0 3, 3 0 0 2"));
  cases.given("two balls that overlap: no critical point", balls("-2 0 0 2, 1 0 0 2"));
  cases.given("decimals that touch: as doubles, 0.1 + 0.2 is more than 0.3", balls("0 0 0 0.1, 0.3 0 0 0.2"));
  cases.given("decimals that overlap by 10^-40: no critical point",
              balls("0 0 0 0.1000000000000000000000000000000000000001, 0.3 0 0 0.2"));
  cases.given("numbers with exponents", balls("5e-1 0 0 25e-2, -0.50 +0 -0.0 2.5E-1, 0 1E0 0 1e-1"));
  cases.given("balls of a line", balls("0 0 0 1, 4 0 0 1, 9 0 0 0.5"));
  cases.given("balls of a plane: a square has a way through, and nothing is apart", box({"2", "2", "0", "1"}));
  cases.given("three balls that touch each other, and what is between them", balls("0 0 0 1.5, 3 0 0 1.5, 0 4 0 2.5"));
}

void add_hidden(PoreWriter& cases) {
  cases.given("ball 1 is strictly inside of ball 0, ball 2 tangent inside: neither changes anything",
              balls("0 0 0 3, 1 0 0 1, 0 1 0 2, 6 0 0 1"));
  cases.given("the same ball three times: the later ones are hidden, and all are contacts",
              balls("0 0 0 1, 0 0 0 1, 0 0 0 1, 4 0 0 1"));
  cases.given("an octahedron with one of its balls twice", octahedron("2", "0.5") + balls("2 0 0 0.5"));
  cases.given("an octahedron with a ball that is tangent inside of another one, on the way to the peak",
              octahedron("2", "0.5") + balls("1.75 0 0 0.25"));
  cases.given("the same, tangent on the other side", octahedron("2", "0.5") + balls("2.25 0 0 0.25"));
  cases.given("a hydrogen in a carbon, tangent inside as decimals, and not as doubles: 1.7 - 1.1 is 0.6",
              balls("0 0 0 1.7, 0.6 0 0 1.1, 6 0 0 1.7"));
  cases.given("methane with hydrogens of 0.4: all four are hidden in the carbon",
              balls("0 0 0 1.7") + tetrahedron("0.629", "0.4"));
  cases.given("methane with hydrogens of 1.2: they overlap the carbon, and nothing is hidden",
              balls("0 0 0 1.7") + tetrahedron("0.629", "1.2"));
  cases.given("a hydrogen that touches two carbons", balls("0 0 0 1.7, 2.9 0 0 1.2, 5.8 0 0 1.7"));
  cases.given("four carbons", tetrahedron("2.5", "1.7"), {{"0.1", std::nullopt}});
  cases.given("the same with hydrogens that point inwards: they make the peak",
              tetrahedron("2.5", "1.7") + tetrahedron("1.9", "1.2"), {{"0.1", std::nullopt}});
  cases.given("the same with hydrogens of 0.5, which are hidden",
              tetrahedron("2.5", "1.7") + tetrahedron("1.9", "0.5"));
}

void add_cages(PoreWriter& cases) {
  const Rows4 small = balls("0 0 0 0.5, 2 2 0 0.5, 2 0 2 0.5, 0 2 2 0.5");
  Rows4 between = small;
  for (BallWords& row : between) row[3] = "0.63250732421875";
  cases.given("a chamber for probes from 1.0005 to 1.0995: none of the multiples of 0.1 is in it", between,
              {{"0.0990576", "1"}, {"0.0990577", "1.1"}});
  cases.given("four equal windows of three balls", small, {{"0.099", std::nullopt}, {"0.1", std::nullopt}});
  cases.given("a cube: six equal windows of four balls, and a peak of eight", box({"1", "1", "1", "0.5"}));
  cases.given("an octahedron: the peak is on an edge of each triangulation, and at no other simplex",
              octahedron("2", "0.5"), {{"0", "1.5"}});
  cases.claimed({"cavity 3 at 0 0 0", "limiting 2.265986"});
  cases.claimed({"cavity 3 atoms 0 1"});
  cases.claimed({"cavity 3", "cavity 3"}, {"claimed-twice"});
  cases.claimed({"cavity 3 at 0 0 1"}, {"wrong-place"});
  cases.claimed({"all", "cavity 3"}, {"missing"});
  cases.given("three different radii at the widest gate", balls("0 0 0 0.5, 4 0 0 1, 1 4 0 1.5, 2 1 4 0.75"));
  cases.given("the same with a fifth ball near the gate",
              balls("0 0 0 0.5, 4 0 0 1, 1 4 0 1.25, 2 1 4 0.75, 2 2 -3 0.25"));
  cases.given("the cage of FC-BALL-07: a cavity for 2.2660 < s <= 2.4641 alone", tetrahedron("2", "1"),
              {{"0.1", "2.2"}, {"0.1", "2.3"}, {"0.1", "2.4641"}, {"0.2", "2.5"}});
  const std::string window = "window 4.531973";
  cases.claimed({"all", "cavity 4.928203", "limiting 4.531973", window, window, window, window});
  cases.claimed({"all", "cavity 4.928203", window, window, window}, {"missing"});
  cases.claimed({window, window, window, window, window}, {"claimed-twice"});
  cases.claimed({window + " atoms 0 1", window + " atoms 0 1 3"});
  cases.claimed({window + " atoms 0 1 2", window + " atoms 0 1 2"}, {"claimed-twice"});
  cases.claimed({"cavity 4.928203 at 1 0 0"}, {"wrong-place"});
  cases.claimed({"cavity 4928203/1000000"}, {"rounding"});
  cases.claimed({"cavity 2.4641016"}, {"radius"});
  cases.claimed({"cavity 6.928203"}, {"to-centres"});
  cases.claimed({"window 4.928203"}, {"wrong-kind"});
  cases.claimed({"limiting none"}, {"wrong-diameter"});
  cases.given("a rectangle: its point lies on one diagonal alone, and outside is on both sides",
              box({"4", "3", "0", "1"}));
  cases.given("the same with a ball that plugs it: five contacts, and no critical point",
              box({"4", "3", "0", "1"}) + balls("0 0 6 2"));
  cases.given("with balls that plug it on both sides, a peak", box({"4", "3", "0", "1"}) + box({"0", "0", "6", "2"}),
              {{"0", "4"}});
  cases.given("a flat box: two equal windows of four balls at 4", box({"4", "3", "1", "1"}), {{"0", "4"}});
  cases.given("the same with one of them plugged: the other one is the gate, of exactly 4",
              box({"4", "3", "1", "1"}) + balls("0 0 7 2"), {{"0", "4"}, {"0.1", std::nullopt}});
  cases.given("the same with both plugged: 4 is no value, and the gate is lower",
              box({"4", "3", "1", "1"}) + box({"0", "0", "7", "2"}), {{"0", "4"}});
  cases.given("the same with a plug that is a bit too small: 5 and 4 contacts become 4 and 3",
              box({"4", "3", "1", "1"}) + balls("0 0 7 1.99999999999999999999"));
  cases.given("two equal chambers side by side: all windows are equal, and both gates are the outside's",
              box({"2", "1", "1", "0.5"}) + box({"0", "1", "1", "0.5"}));
  cases.given("two equal chambers with a wider window between them: both are chambers, and both together",
              box({"2", "1", "1", "0.5"}) + box({"0", "1.25", "1.25", "0.5"}),
              {{"0.2", "1.25"}, {"0.3", std::nullopt}});
  cases.given(
      "the same with one of them wider: the other one ends at the window between them",
      balls("-2 -1 -1 0.5, -2 -1 1 0.5, -2 1 -1 0.5, -2 1 1 0.5, 2 -1 -1 0.4, 2 -1 1 0.4, 2 1 -1 0.4, 2 1 1 0.4") +
          box({"0", "1.25", "1.25", "0.5"}));
  cases.given("a low room between two chambers and the outside: a vestibule, or a part of one chamber",
              box({"4", "1", "1", "0.5"}) + box({"1", "1.375", "1.375", "0.5"}),
              {{"0.3", "1"}, {"0.345", std::nullopt}});
}

void add_signs_and_ties(PoreWriter& cases) {
  cases.given("balls that overlap all around: the gate is below 0", octahedron("2", "1.75"), {{"0", "0"}});
  cases.claimed({"all", "cavity 0.5", "gate none", "limiting none"});
  cases.claimed({"gate 0"}, {"wrong-diameter"});
  cases.claimed({"limiting 0.5"}, {"wrong-diameter"});
  cases.given("the same with a ball within: eight equal chambers, and all together one whose gate is below 0",
              octahedron("2", "1.75") + balls("0 0 0 0.25"));
  cases.given("all of it is below 0", octahedron("2", "2.5") + balls("0 0 0 0.25"));
  cases.given("a peak of exactly 0", octahedron("2", "2"), {{"0", "0"}});
  cases.given("a gate of exactly 0", box({"4", "3", "3", "5"}), {{"0", "0"}});
  cases.given("a gate and a peak of one double: the chamber has a depth of 2^-64 or so",
              box({"4", "3", "0.0000000003", "1"}), {{"1e-25", "4"}, {"1e-15", std::nullopt}});
  for (const auto& [what, radius] : {std::pair("comes short of", "2.5358983848622454129451073"),
                                     std::pair("reaches beyond", "2.5358983848622454129451074")}) {
    cases.given("the cage of FC-BALL-07 with a ball that " + std::string(what) + " its peak's probe, by 10^-25 or less",
                tetrahedron("2", "1") + balls("5 0 0 " + std::string(radius)));
  }
  const std::string tiny = "1.000000000000000000001";
  cases.given("four windows of two values that have one double: one ball is larger by 10^-21",
              tetrahedron("2", "1") + balls("2 2 2 " + tiny));
  Rows4 nearly = box({"4", "3", "1", "1"});
  nearly[3][3] = tiny;
  cases.given("a flat box with one ball larger by 10^-21: four contacts become three", nearly);
  cases.given("two cages apart whose peaks have one double",
              balls("2.69145488739013671875 1.065624237060546875 2.88368988037109375 1.485485076904296875, "
                    "2.69145488739013671875 -1.065624237060546875 -2.88368988037109375 1.485485076904296875, "
                    "-2.69145488739013671875 1.065624237060546875 -2.88368988037109375 1.485485076904296875, "
                    "-2.69145488739013671875 -1.065624237060546875 2.88368988037109375 1.485485076904296875, "
                    "42.18691158294677734375 1.20482635498046875 1.375164031982421875 0.25, "
                    "42.18691158294677734375 -1.20482635498046875 -1.375164031982421875 0.25, "
                    "37.81308841705322265625 1.20482635498046875 -1.375164031982421875 0.25, "
                    "37.81308841705322265625 -1.20482635498046875 1.375164031982421875 0.25"));
}

void add_scattered(PoreWriter& cases) {
  const auto drawn = [&](const std::string& what, std::uint64_t seed, std::size_t count, int side, int most,
                         const char* depth) {
    cases.given(std::to_string(count) + " balls of a lattice (seed " + std::to_string(seed) + "): " + what,
                scattered_balls(seed, count, side, most), {{depth, "0.5"}});
  };
  drawn("a vestibule", 31, 8, 4, 4, "0.0324");
  drawn("a vestibule", 109, 8, 4, 4, "0.01573");
  drawn("a vestibule", 32, 10, 4, 6, "0.0345");
  drawn("a handle", 245, 8, 4, 4, "0.0351");
  drawn("a handle", 368, 8, 4, 4, "0.0102");
  drawn("a handle", 70, 10, 4, 6, "0.0312");
  drawn("a gate below 0", 349, 8, 4, 4, "0.00005");
  drawn("gates below 0", 1003, 8, 4, 4, "0.0082");
  drawn("exits below gates", 130, 8, 4, 4, "0.0001");
  drawn("exits below gates", 133, 8, 4, 4, "0.01");
  drawn("chambers of two peaks", 512, 8, 4, 4, "0.0017");
  drawn("a chamber of two peaks", 433, 10, 4, 6, "0.0125");
  drawn("eight chambers, one in another", 3, 12, 5, 5, "0.0185");
}

void add_refused(PoreWriter& cases) {
  cases.refused("a radius of 0", balls("0 0 0 1, 4 0 0 0"));
  cases.refused("a radius below 0", balls("0 0 0 1, 4 0 0 -1"));
  cases.refused("a radius that is no number", balls("0 0 0 1, 4 0 0 nan"));
  cases.refused("a coordinate that is infinite", balls("0 0 0 1, 4 inf 0 1"));
  cases.refused("a coordinate that is no number", balls("0 0 0 1, 4 x 0 1"));
}

}  // namespace

std::vector<PoreRecipe> pore_recipes() {
  PoreWriter cases;
  add_few(cases);
  add_hidden(cases);
  add_cages(cases);
  add_signs_and_ties(cases);
  add_scattered(cases);
  cases.asked("a porous organic cage with Bondi's radii: four windows of 3.628998, exactly equal", organic_cage(),
              {{"0.5", "1.4"}});
  add_refused(cases);
  return cases.recipes();
}

}  // namespace oracle::vectors
