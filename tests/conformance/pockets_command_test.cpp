// `flowcert pockets` as a user calls it: the JSON of spec/formats/pockets.md, the table and the trees of
// src/cli/manual/pockets.md, files, and what it refuses. Known radii of lattices and hollow spheres are in it.
//
// Guarantees: what is expected was worked out by hand, but for the hollow spheres, whose holes are what they were made
// with.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "flowcert/rational.h"
#include "tests/cites.h"
#include "tests/conformance/program_run.h"

namespace flowcert::conformance::pockets_command_test {
namespace {

using nlohmann::ordered_json;
using Words = std::vector<std::string>;

constexpr char kOctahedron[] = "1 0 0\n-1 0 0\n0 1 0\n0 -1 0\n0 0 1\n0 0 -1\n";

ordered_json pockets_of(const std::string& points, const Words& options = {}) {
  const Scratch scratch;
  Words words = {"pockets", scratch.file("points.xyz", points), "--json"};
  if (std::ranges::find(options, "--persistence") == options.end()) words.insert(words.end(), {"--persistence", "0"});
  words.insert(words.end(), options.begin(), options.end());
  const Finished done = flowcert(words);
  EXPECT_EQ(done.status, 0) << done.err;
  return ordered_json::parse(done.out);
}

std::size_t count_of(const ordered_json& json, const std::string& what) {
  std::size_t count = 0;
  for (const ordered_json& pocket : json["pockets"]) count += pocket["is"] == what ? 1 : 0;
  return count;
}

TEST(PocketsCommand, TellsAllOfAnOctahedron) {
  CITES("FC-POCK-03", "FC-POCK-04", "FC-POCK-05", "FC-POCK-06", "FC-POCK-07", "FC-POCK-08", "FC-POCK-11", "FC-NUM-02",
        "FC-FILE-24");
  const ordered_json json = pockets_of(kOctahedron, {"--volumes", "exact", "--probe", "3/4"});
  EXPECT_EQ(json["format"], "flowcert-pockets");
  EXPECT_EQ(json["probe"], "3/4");
  EXPECT_EQ(json["pore_limiting_radius"]["squared_radius"], "2/3");
  EXPECT_EQ(json["pore_limiting_radius"]["gates"].size(), 8U);
  EXPECT_EQ(json["largest_cavity_radius"]["squared_radius"], "1");
  ASSERT_EQ(json["pockets"].size(), 1U);
  const ordered_json& pocket = json["pockets"][0];
  EXPECT_EQ(pocket["difference_of_squares"], "1/3");
  EXPECT_EQ(pocket["depth"], 1 - std::sqrt(2.0 / 3));
  EXPECT_EQ(pocket["lining"], (ordered_json{0, 1, 2, 3, 4, 5}));
  EXPECT_FALSE(pocket.contains("atoms"));
  EXPECT_EQ(pocket["volume"], "4/3");
  EXPECT_EQ(pocket["neighbours"], (ordered_json{-1}));
  EXPECT_EQ(pocket["is"], "channel");
  ASSERT_EQ(pocket["mouths"].size(), 8U);
  for (const ordered_json& mouth : pocket["mouths"]) {
    EXPECT_NEAR(mouth["area"].get<double>(), std::sqrt(3.0) / 2, 1e-12);
    EXPECT_EQ(mouth["between"], (ordered_json{0, -1}));
  }
}

// All points of a lattice in a box of so many cells. Between the points of a cell there may be one more, or those of
// its faces.
std::string cubic_lattice(int cells) {
  std::string rows;
  for (int x = 0; x <= cells; ++x) {
    for (int y = 0; y <= cells; ++y) {
      for (int z = 0; z <= cells; ++z) rows += fmt::format("{} {} {}\n", x, y, z);
    }
  }
  return rows;
}
std::string face_centred_lattice(int cells) {
  std::string rows;
  for (int x = 0; x <= 2 * cells; ++x) {
    for (int y = 0; y <= 2 * cells; ++y) {
      for (int z = 0; z <= 2 * cells; ++z) {
        if ((x + y + z) % 2 == 0) rows += fmt::format("{} {} {}\n", x, y, z);
      }
    }
  }
  return rows;
}

TEST(PocketsCommand, KnowsTheRadiiOfLattices) {
  CITES("FC-POCK-02", "FC-POCK-07", "FC-POCK-08");
  const ordered_json cubic = pockets_of(cubic_lattice(4));
  EXPECT_EQ(cubic["pockets"].size(), 64U);
  EXPECT_EQ(cubic["pore_limiting_radius"]["squared_radius"], "1/2");
  EXPECT_EQ(cubic["largest_cavity_radius"]["squared_radius"], "3/4");
  EXPECT_EQ(cubic["largest_cavity_radius"]["balls"].size(), 64U);
  // The edge of the cell is 2, so that octahedral holes have the radius 1, and tetrahedral ones the root of 3/4.
  const ordered_json face_centred = pockets_of(face_centred_lattice(3), {"--volumes", "exact"});
  EXPECT_EQ(face_centred["pore_limiting_radius"]["squared_radius"], "2/3");
  EXPECT_EQ(face_centred["largest_cavity_radius"]["squared_radius"], "1");
  std::set<std::string> volumes;
  for (const ordered_json& pocket : face_centred["pockets"]) {
    volumes.insert(pocket["peaks"][0]["squared_radius"].get<std::string>() + ": " +
                   pocket["volume"].get<std::string>());
  }
  EXPECT_TRUE(volumes.contains("1: 4/3"));
  EXPECT_TRUE(volumes.contains("3/4: 1/3"));
}

// Points of a sphere of radius 10, but for those nearer than 4 to one of the directions.
std::string hollow_sphere(const std::vector<std::array<double, 3>>& holes) {
  constexpr int kPoints = 1200;
  std::string rows;
  for (int k = 0; k < kPoints; ++k) {
    const double z = 1 - (2 * k + 1.0) / kPoints, turn = k * M_PI * (3 - std::sqrt(5.0));
    const double r = std::sqrt(1 - z * z);
    const std::array<double, 3> x = {10 * r * std::cos(turn), 10 * r * std::sin(turn), 10 * z};
    bool is_open = false;
    for (const auto& hole : holes) {
      is_open = is_open || std::hypot(x[0] - hole[0], x[1] - hole[1], x[2] - hole[2]) < 4;
    }
    if (!is_open) rows += fmt::format("{} {} {}\n", x[0], x[1], x[2]);
  }
  return rows;
}

TEST(PocketsCommand, TellsCavitiesPocketsAndChannels) {
  CITES("FC-POCK-02", "FC-POCK-06", "FC-POCK-07");
  struct Case {
    std::vector<std::array<double, 3>> holes;
    const char* is;
  };
  for (const Case& one :
       {Case{{}, "cavity"}, Case{{{0, 0, 10}}, "pocket"}, Case{{{0, 0, 10}, {0, -10, 0}}, "channel"}}) {
    const ordered_json json = pockets_of(hollow_sphere(one.holes), {"--persistence", "0.5", "--probe", "2"});
    ASSERT_EQ(json["pockets"].size(), 1U) << one.is;
    EXPECT_EQ(count_of(json, one.is), 1U) << one.is;
    EXPECT_NEAR(json["largest_cavity_radius"]["radius"].get<double>(), 10, 0.2);
    const double widest = json["pore_limiting_radius"]["radius"];
    EXPECT_LT(widest, one.holes.empty() ? 1 : 4.6);
    EXPECT_GT(widest, one.holes.empty() ? 0.2 : 3.8);
  }
}

TEST(PocketsCommand, TellsTheSameOfMovedPoints) {
  CITES("FC-POCK-10");
  // The same points in the reverse order, turned by a right angle, moved, and twice as large.
  std::string rows, images;
  std::uint64_t state = 7;
  for (int k = 0; k < 200; ++k) {
    std::array<int, 3> x{};
    for (int& c : x) c = static_cast<int>((state = state * 6364136223846793005U + 1442695040888963407U) >> 60U);
    rows += fmt::format("{} {} {}\n", x[0], x[1], x[2]);
    images = fmt::format("{} {} {}\n", 2 * x[1] + 5, -2 * x[0] + 1, 2 * x[2]) + images;
  }
  const ordered_json one = pockets_of(rows, {"--persistence", "1/4", "--probe", "1.5"});
  const ordered_json other = pockets_of(images, {"--persistence", "1/2", "--probe", "3"});
  EXPECT_GT(one["pockets"].size(), 3U);
  EXPECT_EQ(one["pockets"].size(), other["pockets"].size());
  const auto facts = [](const ordered_json& json, int scale) {
    std::multiset<std::string> all;
    for (const ordered_json& pocket : json["pockets"]) {
      all.insert(fmt::format("{} {} {} {} {}",
                             Rational(scale * Rational(pocket["difference_of_squares"].get<std::string>())).str(),
                             pocket["maxima"].size(), pocket["mouths"].size(), pocket["widest_path"]["gates"].size(),
                             pocket["is"].get<std::string>()));
    }
    return all;
  };
  EXPECT_EQ(facts(one, 4), facts(other, 1));
}

TEST(PocketsCommand, IsJudgedByCheck) {
  CITES("FC-CLAIM-18", "FC-FILE-14");
  const Scratch scratch;
  const std::string points = scratch.file("points.xyz", kOctahedron);
  const std::string claim =
      flowcert({"pockets", points, "--json", "--persistence", "0", "--probe", "0.8", "--volumes", "exact"}).out;
  const std::string file = scratch.file("pockets.json", claim);
  for (const Words& options : {Words{}, Words{"--oracle"}, Words{"--tolerance", "0"}}) {
    Words words = {"check", points, file, "--json"};
    words.insert(words.end(), options.begin(), options.end());
    const Finished done = flowcert(words);
    EXPECT_EQ(done.status, 0) << done.out << done.err;
    const ordered_json report = ordered_json::parse(done.out);
    EXPECT_EQ(report["verdict"], "conforms");
    EXPECT_EQ(report["grade"], "exact");
    EXPECT_EQ(report["claim_format"], "pockets");
    EXPECT_EQ(report["levels"]["3"]["conforms"], true);
    EXPECT_EQ(report["levels"]["5"]["conforms"], true);
    EXPECT_TRUE(report["levels"]["4"]["conforms"].is_null());
    EXPECT_TRUE(report["not_judged"].empty());
  }
  // Another program could print the claim on several lines. One number is changed.
  ordered_json wrong = ordered_json::parse(claim);
  wrong["pockets"][0]["difference_of_squares"] = "1/2";
  const Finished done = flowcert({"check", points, scratch.file("wrong.json", wrong.dump(2))});
  EXPECT_EQ(done.status, 1);
  EXPECT_NE(done.out.find("[FC-POCK-05]: claimed pocket 0, a difference of squares of 1/2"), std::string::npos)
      << done.out;
  // A claim about other points.
  EXPECT_EQ(flowcert({"check", scratch.file("cube.xyz", cubic_lattice(1)), file}).status, 1);
}

TEST(PocketsCommand, PrintsTrees) {
  CITES("FC-TREE-02", "FC-TREE-06", "FC-TREE-07");
  const Scratch scratch;
  const std::string points = scratch.file("points.xyz", kOctahedron);
  EXPECT_EQ(flowcert({"pockets", points, "--tree", "pockets"}).out,
            "(0-1-2-3-4-5:0.3333333333333333,infinity)0-2-4;\n");
  EXPECT_EQ(flowcert({"pockets", points, "--tree", "components"}).out, "(0:0.5,1:0.5,2:0.5,3:0.5,4:0.5,5:0.5)0-2;\n");
  const ordered_json tree = ordered_json::parse(flowcert({"pockets", points, "--tree", "pockets", "--json"}).out);
  EXPECT_EQ(tree["format"], "flowcert-merge-tree");
  EXPECT_EQ(tree["leaves"].size(), 2U);
  EXPECT_TRUE(tree["leaves"][1]["contact"].is_null());
  EXPECT_EQ(tree["nodes"][0]["squared_distance"], "2/3");
  EXPECT_EQ(tree["nodes"][0]["parts"], (ordered_json{0, 1}));
  EXPECT_EQ(tree["nodes"][0]["joined_by"].size(), 8U);
  const std::string line = scratch.file("line.xyz", "0 0 0\n1 0 0\n3 0 0\n");
  EXPECT_EQ(flowcert({"pockets", line, "--tree", "components"}).out, "(2:1,(0:0.25,1:0.25)0-1:0.75)1-2;\n");
  EXPECT_EQ(flowcert({"pockets", line, "--tree", "pockets"}).out, "infinity;\n");
  EXPECT_EQ(flowcert({"pockets", scratch.file("none.xyz", "# none\n"), "--tree", "pockets"}).out, ";\n");
}

TEST(PocketsCommand, WritesFiles) {
  CITES("FC-POCK-03");
  const Scratch scratch;
  const std::string points = scratch.file("points.xyz", cubic_lattice(2)), folder = scratch.path("out");
  const Finished done = flowcert({"pockets", points, "--persistence", "0", "--export", folder, "--probe", "0.7"});
  EXPECT_EQ(done.status, 0) << done.err;
  EXPECT_NE(done.out.find("all pockets, from the deepest one"), std::string::npos) << done.out;
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) names.insert(entry.path().filename());
  EXPECT_EQ(names, (std::set<std::string>{"components_tree.json", "components_tree.nwk", "pocket_0.ply", "pocket_1.ply",
                                          "pocket_2.ply", "pocket_3.ply", "pocket_4.ply", "pocket_5.ply",
                                          "pocket_6.ply", "pocket_7.ply", "pockets.json", "pockets.vtu",
                                          "pockets_tree.json", "pockets_tree.nwk"}));
  EXPECT_NE(content_of(folder + "/pocket_3.ply").find("element face 48\n"), std::string::npos);
  EXPECT_EQ(ordered_json::parse(content_of(folder + "/pockets.json"))["pockets"].size(), 8U);
}

// The block after <!-- example: pockets --> is a command line after a dollar, and all that it prints.
TEST(PocketsCommand, TheReadmesExampleIsRight) {
  CITES("FC-POCK-07");
  const Words lines = lines_of(content_of(FLOWCERT_CLI_README));
  auto line = std::find(lines.begin(), lines.end(), "<!-- example: pockets -->");
  ASSERT_GT(lines.end() - line, 3);
  line += 2;  // the mark, the fence
  ASSERT_TRUE(line->starts_with("$ ")) << *line;
  std::string command = line->substr(2);
  const std::string program = "build/flowcert";
  ASSERT_NE(command.find(program), std::string::npos) << command;
  command.replace(command.find(program), program.size(), "\"$0\"");
  std::string expected;
  while (++line != lines.end() && *line != "```") expected += *line + "\n";
  EXPECT_EQ(RunningProgram({"/bin/sh", "-c", command, FLOWCERT_PROGRAM}).finish().out, expected);
}

// ---- Molecules ----

// An octahedron of atoms, 4 from its centre.
std::string octahedron_pdb() {
  constexpr std::array<std::array<int, 3>, 6> kPlaces = {
      {{4, 0, 0}, {-4, 0, 0}, {0, 4, 0}, {0, -4, 0}, {0, 0, 4}, {0, 0, -4}}};
  std::string text;
  for (std::size_t k = 0; k < kPlaces.size(); ++k) {
    text += fmt::format("ATOM  {:>5}  {:<3} GLY A{:>4}    {:>8.3f}{:>8.3f}{:>8.3f}  1.00  0.00           {}\n", k + 1,
                        k % 2 == 0 ? "CA" : "N", 7 + k / 2, static_cast<double>(kPlaces[k][0]),
                        static_cast<double>(kPlaces[k][1]), static_cast<double>(kPlaces[k][2]), k % 2 == 0 ? "C" : "N");
  }
  return text;
}

TEST(PocketsOfMolecules, AreLinedByNamedAtoms) {
  CITES("FC-POCK-03", "FC-FILE-24");
  const Scratch scratch;
  const std::string file = scratch.file("octahedron.pdb", octahedron_pdb()), rows = scratch.path("rows.csv"),
                    atoms = scratch.path("atoms.csv");
  const Finished done =
      flowcert({"pockets", file, "--persistence", "0", "--probe", "3.1", "--csv", rows, "--atoms-csv", atoms});
  ASSERT_EQ(done.status, 0) << done.err;
  EXPECT_NE(done.out.find("asks for water"), std::string::npos) << done.out;
  EXPECT_NE(done.out.find(" 1.400\n"), std::string::npos) << done.out;
  EXPECT_NE(done.out.find("A GLY 7, A GLY 8, A GLY 9"), std::string::npos) << done.out;
  EXPECT_EQ(content_of(rows),
            "pocket,x,y,z,radius,depth,volume,maxima,mouths,widest,lining,open_mouths,kind,residues\n"
            "0,0,0,0,4,0.7340136762890959,85.33333333333333,1,8,3.265986323710904,6,8,channel,"
            "A GLY 7; A GLY 8; A GLY 9\n");
  const Words lines = lines_of(content_of(atoms));
  ASSERT_EQ(lines.size(), 7U);
  EXPECT_EQ(lines[0], "pocket,row,chain,residue,number,atom,element,x,y,z");
  EXPECT_EQ(lines[1], "0,0,A,GLY,7,CA,C,4,0,0");
  EXPECT_EQ(lines[6], "0,5,A,GLY,9,N,N,0,0,-4");
  EXPECT_EQ(flowcert({"pockets", file, "--persistence", "0", "--atoms-csv", "-"}).out, content_of(atoms));
  const ordered_json json = ordered_json::parse(flowcert({"pockets", file, "--persistence", "0", "--json"}).out);
  const ordered_json& pocket = json["pockets"][0];
  EXPECT_EQ(pocket["lining"], (ordered_json{0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(pocket["atoms"][1], ordered_json::parse(R"({"chain": "A", "residue": "GLY", "number": "7", "atom": "N",
                                                         "element": "N"})"));
  EXPECT_EQ(pocket["residues"], (ordered_json{"A GLY 7", "A GLY 8", "A GLY 9"}));
  EXPECT_EQ(flowcert({"check", file, scratch.file("claim.json", json.dump())}).status, 0);
}

// The rounding of its file makes eight maxima of a barrel differ, which are equal. An open tunnel is no pocket.
TEST(PocketsOfMolecules, AnOpenBarrelHasNone) {
  CITES("FC-POCK-02");
  const std::string barrel = std::string(FLOWCERT_USER_INPUTS) + "/barrel.pdb";
  const Finished done = flowcert({"pockets", barrel, "--atoms", "no water"});
  EXPECT_EQ(done.status, 0) << done.err;
  EXPECT_NE(done.out.find("valley of lengths                           none"), std::string::npos) << done.out;
  EXPECT_NE(done.out.find("no pocket; an open tunnel is a pair of dimension 1: see flowcert persistence.\nThe longest "
                          "one has the length 4.711, from 1.289 to 6.000"),
            std::string::npos)
      << done.out;
  const auto count_at = [&](const Words& options) {
    Words words = {"pockets", barrel, "--json"};
    words.insert(words.end(), options.begin(), options.end());
    return ordered_json::parse(flowcert(words).out)["pockets"].size();
  };
  EXPECT_EQ(count_at({"--persistence", "0"}), 140U);
  EXPECT_EQ(count_at({}), 0U);
  EXPECT_EQ(count_at({"--persistence", "1/2spacing"}), 0U);
}

// Of HIV protease, from Debian's pymol-data.
TEST(PocketsOfMolecules, OfAProteinAreFewAndInOrder) {
  CITES("FC-POCK-05", "FC-POCK-06");
  const std::string protein = "/usr/share/pymol/data/tut/1hpv.pdb";
  const Finished done = flowcert({"pockets", protein, "--atoms", "protein", "--probe", "3.1"});
  ASSERT_EQ(done.status, 0) << done.err;
  std::vector<double> depths;
  for (const std::string& line : lines_of(done.out)) {
    EXPECT_LE(line.size(), 80U) << line;
    std::istringstream words(line);
    const Words row{std::istream_iterator<std::string>(words), std::istream_iterator<std::string>()};
    const bool is_pocket = row.size() == 9 && (row[8] == "cavity" || row[8] == "pocket" || row[8] == "channel");
    if (is_pocket) depths.push_back(std::stod(row[5]));
  }
  EXPECT_GT(depths.size(), 0U) << done.out;
  EXPECT_LT(depths.size(), 20U) << done.out;
  EXPECT_TRUE(std::ranges::is_sorted(depths, std::ranges::greater{})) << done.out;
  EXPECT_NE(done.out.find("ASP 25"), std::string::npos) << done.out;  // of the active site
}

TEST(PocketsCommand, RefusesWhatItCannotUse) {
  CITES("FC-POCK-02");
  const Scratch scratch;
  const std::string points = scratch.file("points.xyz", kOctahedron), file = scratch.file("file", "");
  const auto refuses = [&](Words words, const std::string& reason) {
    words.insert(words.begin(), {"pockets", points});
    const Finished done = flowcert(words);
    EXPECT_EQ(done.status, 2);
    EXPECT_TRUE(done.out.empty()) << done.out;
    EXPECT_NE(done.err.find(reason), std::string::npos) << done.err;
  };
  refuses({"--persistence", "-1"}, "--persistence: not 0 or more");
  refuses({"--persistence", "many"}, "not a number: 'many'");
  refuses({"--persistence", "3spacing^2"}, "a length is a multiple of spacing, not of its square: '3spacing^2'");
  refuses({"--atoms-csv", scratch.path("atoms.csv")},
          "--atoms-csv is for PDB, CIF and chemical XYZ, and this is table");
  refuses({"--csv", "-", "--json"}, "only one of --csv, --atoms-csv and --json");
  refuses({"--probe", "-1/2"}, "--probe: not 0 or more");
  refuses({"--probe", "nan"}, "not a finite number");
  refuses({"--tree", "maxima"}, "maxima");
  refuses({"--tree", "pockets", "--export", file}, "excludes");
  refuses({"--export", file}, "cannot be made");
}

// ---- With radii ----

const std::string kCage = std::string(FLOWCERT_USER_INPUTS) + "/cage.xyz";
// Four balls of radius 1, of FC-BALL-07.
constexpr char kFourBalls[] = "2 2 2 1\n2 -2 -2 1\n-2 2 -2 1\n-2 -2 2 1\n";

Finished cavities(const std::string& file, const std::string& radii, const std::string& probe, Words options = {}) {
  options.insert(options.begin(), {"pockets", file, "--radii", radii, "--probe", probe});
  return flowcert(options);
}

TEST(PocketsCommand, TellsTheCavityOfTheCage) {
  CITES("FC-BALL-07", "FC-FILE-55");
  const auto count = [](const char* probe) {
    const Finished done = cavities(kCage, "bondi", probe, {"--csv", "-"});
    EXPECT_EQ(done.status, 0) << done.err;
    return lines_of(done.out).size() - 1;
  };
  // Its windows have the diameter 3.628998, and it has 5.397020.
  EXPECT_EQ(count("1.0"), 0U);
  EXPECT_EQ(count("1.8144"), 0U);
  EXPECT_EQ(count("1.8145"), 1U);
  EXPECT_EQ(count("2.6985"), 1U);
  EXPECT_EQ(count("2.7"), 0U);
  const Finished done = cavities(kCage, "bondi", "2.6985");
  EXPECT_EQ(done.status, 0) << done.err;
  EXPECT_NE(done.out.find("measured to the surfaces of the balls"), std::string::npos) << done.out;
  EXPECT_NE(done.out.find("\nprobe                                     2.6985\n"), std::string::npos) << done.out;
  EXPECT_NE(done.out.find("\ncavities                                       1\n"), std::string::npos) << done.out;
  EXPECT_NE(done.out.find("       0     12  1 C, 15 C, 29 C, "), std::string::npos) << done.out;
  for (const std::string& line : lines_of(done.out)) EXPECT_LE(line.size(), 80U) << line;
  const Finished none = cavities(kCage, "bondi", "3");
  EXPECT_EQ(none.status, 0) << none.err;
  EXPECT_NE(none.out.find("\nno cavity: "), std::string::npos) << none.out;
}

TEST(PocketsCommand, WritesCavitiesOfBalls) {
  CITES("FC-BALL-07", "FC-FILE-57");
  const Scratch scratch;
  const std::string file = scratch.file("balls.csv", std::string(kFourBalls) + "2 2 2 1\n2 2 2 0.5\n");
  const std::string rows = scratch.path("rows.csv"), atoms = scratch.path("atoms.csv");
  const Finished done = cavities(file, "column:4", "2.4", {"--json", "--csv", rows, "--atoms-csv", atoms});
  ASSERT_EQ(done.status, 0) << done.err;
  ordered_json json = ordered_json::parse(done.out);
  for (const char* key : {"version", "commit", "kernel", "compiler", "cgal"}) EXPECT_EQ(json.erase(key), 1U) << key;
  EXPECT_EQ(json.dump(),
            "{\"format\":\"flowcert-cavities\",\"format_version\":1,\"radii\":\"column:4\",\"balls\":6,"
            "\"hidden\":[4,5],\"probe\":\"12/5\",\"cavities\":[{\"lining\":[0,1,2,3,4]}]}");
  EXPECT_EQ(content_of(rows), "cavity,lining,atoms\n0,5,0;1;2;3;4\n");
  EXPECT_EQ(content_of(atoms),
            "cavity,row,x,y,z,radius\n0,0,2,2,2,1\n0,1,2,-2,-2,1\n0,2,-2,2,-2,1\n0,3,-2,-2,2,1\n0,4,2,2,2,1\n");
}

TEST(PocketsCommand, NamesTheAtomsOfACavity) {
  CITES("FC-FILE-57");
  const Scratch scratch;
  const std::string file =
      scratch.file("cage.pdb",
                   "HETATM    1  C1  LIG A   7       2.000   2.000   2.000  1.00  0.00           C\n"
                   "HETATM    2  C2  LIG A   7       2.000  -2.000  -2.000  1.00  0.00           C\n"
                   "HETATM    3  C3  LIG A   7      -2.000   2.000  -2.000  1.00  0.00           C\n"
                   "HETATM    4  N4  LIG A   7      -2.000  -2.000   2.000  1.00  0.00           N\n");
  const Finished json = cavities(file, "1", "2.3", {"--json"});
  ASSERT_EQ(json.status, 0) << json.err;
  const ordered_json cavity = ordered_json::parse(json.out)["cavities"][0];
  EXPECT_EQ(cavity["lining"], (ordered_json{0, 1, 2, 3}));
  EXPECT_EQ(cavity["names"], (ordered_json{"A LIG 7 C1", "A LIG 7 C2", "A LIG 7 C3", "A LIG 7 N4"}));
  EXPECT_EQ(cavities(file, "1", "2.3", {"--csv", "-"}).out,
            "cavity,lining,atoms,names\n0,4,0;1;2;3,A LIG 7 C1; A LIG 7 C2; A LIG 7 C3; A LIG 7 N4\n");
  EXPECT_EQ(lines_of(cavities(file, "1", "2.3", {"--atoms-csv", "-"}).out).back(), "0,3,A,LIG,7,N4,N,-2,-2,2,1");
}

TEST(PocketsCommand, RefusesWhatIsNoneOfBalls) {
  CITES("FC-FILE-55");
  const auto refuses = [](Words options, const std::string& reason) {
    options.insert(options.begin(), {"pockets", kCage});
    const Finished done = flowcert(options);
    EXPECT_EQ(done.status, 2) << done.out;
    EXPECT_TRUE(done.out.empty()) << done.out;
    EXPECT_NE(done.err.find(reason), std::string::npos) << done.err;
    EXPECT_EQ(lines_of(done.err).size(), 1U) << done.err;
  };
  refuses({"--radii", "bondi"},
          "--radii needs --probe R, a radius beyond the surfaces of atoms; for all probes at once");
  const Words two_words[] = {{"--persistence", "0"}, {"--volumes", "double"}, {"--tree", "pockets"}, {"--export", "x"}};
  for (const Words& one : two_words) {
    refuses({"--radii", "bondi", "--probe", "2", one[0], one[1]},
            one[0] + " is for pockets between points, and --radii takes atoms for balls");
  }
  refuses({"--finite", "--probe", "2"}, "--finite requires --radii");
  refuses({"--radii", "bondi", "--probe", "-1"}, "--probe: not 0 or more: -1");
  refuses({"--radii", "bondi", "--probe", "2", "--csv", "-", "--json"}, "only one of --csv, --atoms-csv and --json");
}

// Without radii, distances are to the centres, and the table says so.
TEST(PocketsCommand, SaysThatAProbeIsMeasuredToCentres) {
  CITES("FC-FILE-46");
  const Finished atoms = flowcert({"pockets", kCage, "--probe", "3.1"});
  EXPECT_NE(atoms.out.find("Distances are measured to the centres of atoms"), std::string::npos);
  EXPECT_NE(atoms.out.find("   its distance to all centres\n"), std::string::npos) << atoms.out;
  const Scratch scratch;
  const Finished points = flowcert({"pockets", scratch.file("octahedron.xyz", kOctahedron), "--probe", "0.9"});
  EXPECT_NE(points.out.find("Distances are measured to the points, which have no radii"), std::string::npos);
  EXPECT_NE(points.out.find("its distance to all points"), std::string::npos) << points.out;
}

}  // namespace
}  // namespace flowcert::conformance::pockets_command_test
