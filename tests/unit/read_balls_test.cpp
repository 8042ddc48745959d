// Atoms as balls: what --radii can be, the radius that an atom gets in each format, exact numbers, PQR, and what is
// refused.
#include "flowcert/read_balls.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "io/elements.h"
#include "tests/cites.h"
#include "tests/run_scale.h"
#include "tests/unit/point_file_samples.h"

namespace flowcert::read_balls_test {
namespace {

using Texts = std::vector<std::string>;

BallFile read(const std::string& bytes, const std::string& radii, const ReadingOptions& options = {}) {
  return read_balls_from(bytes, "f", options, AtomRadii(radii));
}

Texts radii_of(const std::string& bytes, const std::string& radii, const ReadingOptions& options = {}) {
  Texts texts;
  for (const Ball& ball : read(bytes, radii, options).balls) texts.push_back(to_text(ball.radius));
  return texts;
}

Texts centres_of(const BallFile& file) {
  Texts texts;
  for (const Ball& ball : file.balls) {
    texts.push_back(to_text(ball.center[0]) + ' ' + to_text(ball.center[1]) + ' ' + to_text(ball.center[2]));
  }
  return texts;
}

std::string refused(const std::string& bytes, const std::string& radii, const ReadingOptions& options = {}) {
  try {
    return "accepted, " + std::to_string(read(bytes, radii, options).balls.size()) + " balls";
  } catch (const InvalidInput& error) {
    return error.what();
  }
}

// ---- The option ----

TEST(AtomRadii, AreWhatIsSaid) {
  CITES("FC-FILE-55");
  const AtomRadii bondi("bondi, Fe=2.04,D=11/10");
  EXPECT_EQ(bondi.source(), AtomRadii::Source::kElements);
  EXPECT_EQ(bondi.base(), "bondi");
  EXPECT_EQ(*bondi.of_element("Fe"), Rational(51) / 25);
  EXPECT_EQ(*bondi.of_element("H"), Rational(11) / 10);
  EXPECT_EQ(*bondi.of_element("C"), Rational(17) / 10);
  EXPECT_EQ(bondi.of_element("Mn"), nullptr);
  EXPECT_EQ(bondi.of_element(""), nullptr);
  EXPECT_EQ(AtomRadii("column:4").column(), 4U);
  EXPECT_FALSE(AtomRadii("column:4").needs_elements());
  EXPECT_TRUE(AtomRadii("pqr,H=1").needs_elements());
  EXPECT_EQ(AtomRadii("1.7").one(), Rational(17) / 10);
  EXPECT_EQ(AtomRadii("1/3").one(), Rational(1) / 3);
  EXPECT_EQ(AtomRadii("0x1p-3").one(), Rational(1) / 8);
}

TEST(AtomRadii, AnythingElseIsRefused) {
  CITES("FC-FILE-55");
  const std::string words =
      "bondi, alvarez, pqr, column:N, table:FILE or one radius, each also with overrides behind it as ,Fe=2.04; not ";
  const std::map<std::string, std::string> refusals = {
      {"", "1: " + words + "''"},
      {"Bondi", "1: " + words + "'Bondi'"},
      {"bondi,", "1: " + words + "'bondi,'"},
      {"bondi,Fe", "1: " + words + "'bondi,Fe'"},
      {"bondi,FE=2", "2: no element as the periodic table writes it: 'FE'"},
      {"bondi,=2", "2: no element as the periodic table writes it: ''"},
      {"bondi,H=1,T=2", "3: a second radius of H"},
      {"bondi,H=0", "2: a radius is above 0, not '0'"},
      {"bondi,H=1=2", "2: not a number: '1=2'"},
      {"-1.5", "1: a radius is above 0, not '-1.5'"},
      {"1.5.", "1: not a number: '1.5.'"},
      {"1e999999", "1: an exponent too large: '1e999999'"},
      {"column:0", "1: columns are counted from 1"},
      {"column:x", "1: not a count: 'x'"},
  };
  for (const auto& [text, reason] : refusals) {
    try {
      const AtomRadii radii(text);
      ADD_FAILURE() << text;
    } catch (const InvalidInput& error) {
      EXPECT_EQ(error.what(), "--radii:" + reason) << text;
    }
  }
}

class Table {
 public:
  explicit Table(const std::string& text) { std::ofstream(path_) << text; }
  ~Table() { std::filesystem::remove(path_); }
  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  std::string path_ = testing::TempDir() + "flowcert_radii,1.rad";
};

std::string refused_table(const std::string& text) {
  const Table table(text);
  try {
    const AtomRadii radii("table:" + table.path());
    return "accepted";
  } catch (const InvalidInput& error) {
    return std::string(error.what()).substr(table.path().size());
  }
}

TEST(AtomRadii, OfATable) {
  CITES("FC-FILE-55");
  const Table table("# of a framework\nSi 1.35\nO,1.52 # the oxygens\n");
  const AtomRadii radii("table:" + table.path() + ",O=1.5");
  EXPECT_EQ(*radii.of_element("Si"), Rational(27) / 20);
  EXPECT_EQ(*radii.of_element("O"), Rational(3) / 2);
  EXPECT_EQ(radii.of_element("C"), nullptr);
  EXPECT_EQ(refused_table("Si 1.35\nSi 1.4\n"), ":2: a second radius of Si");
  EXPECT_EQ(refused_table("Si 1.35\nSi1 1.4\n"), ":2: no element as the periodic table writes it: 'Si1'");
  EXPECT_EQ(refused_table("Si -1\n"), ":1: a radius is above 0, not '-1'");
  EXPECT_EQ(refused_table("Si 1 2\n"), ":1: an element and its radius, not 3 fields");
  EXPECT_EQ(refused_table("# nothing\n"), ": no line has an element and its radius");
}

// What Debian's python3-ase has, "SYMBOL bondi alvarez" in hundredths; none where it is not installed.
std::string tables_of_ase() {
  const char* const program =
      "/usr/bin/python3 -c 'from ase.data import vdw, vdw_alvarez, chemical_symbols as s\n"
      "def r(t, n): return \"%.6g\" % (100 * t.vdw_radii[n]) if n < len(t.vdw_radii) and t.vdw_radii[n] > 0 else "
      "\"0\"\n"
      "for n in range(1, len(s)): print(s[n], r(vdw, n), r(vdw_alvarez, n))' 2>/dev/null";
  std::FILE* const pipe = popen(program, "r");
  if (pipe == nullptr) return "";
  std::string text;
  std::array<char, 4096> part{};
  while (const std::size_t size = std::fread(part.data(), 1, part.size(), pipe)) text.append(part.data(), size);
  return pclose(pipe) == 0 ? text : "";
}

TEST(AtomRadii, TablesAreThoseOfAse) {
  CITES("FC-FILE-55");
  const std::string ase = tables_of_ase();
  if (ase.empty()) GTEST_SKIP() << "python3-ase is not installed";
  std::string ours;
  for (const io::Element& element : io::elements()) {
    ours += std::string(element.symbol) + ' ' + std::to_string(element.bondi) + ' ' + std::to_string(element.alvarez) +
            '\n';
  }
  EXPECT_EQ(ours, ase);
}

// ---- Exact numbers ----

TEST(ReadBalls, NumbersAreThoseThatAreWritten) {
  CITES("FC-FILE-55");
  const Texts tenths = {"1/10 -1/5 300", "1/1000 3/2 1/1024"};
  const std::string rows = "0.1 -.2 3D2\n1*^-3 0x1.8p0 0x1p-10\n";
  EXPECT_EQ(centres_of(read(rows, "1.5")), tenths);
  EXPECT_EQ(centres_of(read("2\n" + rows, "1.5", {.format = "pts"})), tenths);
  EXPECT_EQ(centres_of(read("OFF\n2 0 0\n" + rows, "1.5")), tenths);
  EXPECT_EQ(centres_of(read("v 0.1 -.2 3D2\nv 1*^-3 0x1.8p0 \\\n 0x1p-10\n", "1.5")), tenths);
  const BallFile ply = read(
      "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\nproperty float z\nend_header\n" +
          rows,
      "1.5");
  EXPECT_EQ(centres_of(ply), tenths);
  EXPECT_EQ(notes_of(ply.file), Notes{"declared as float, but decimals: taken as they are written, not floats"});
  EXPECT_EQ(radii_of(rows, "1.5"), (Texts{"3/2", "3/2"}));
  // Below the smallest double.
  EXPECT_EQ(centres_of(read("1e-330 0 0\n", "1")), Texts{"1/1" + std::string(330, '0') + " 0 0"});
}

TEST(ReadBalls, StoredFloatsAreTheDoublesThatTheyAre) {
  CITES("FC-FILE-55");
  const BallFile file = read(ply_binary<float>(false, "float", {{0.1, 1, 2}, {3, 4, 5}}), "2");
  EXPECT_EQ(centres_of(file), (Texts{"13421773/134217728 1 2", "3 4 5"}));
}

TEST(ReadBalls, NumbersAsLongAsNoDoubleAreRefused) {
  CITES("FC-FILE-55", "FC-IN-05");
  EXPECT_EQ(refused("0 0 1e-999999999\n", "1"), "f:1: an exponent too large: '1e-999999999'");
  EXPECT_EQ(refused("0 0 0\n0 0 0." + std::string(1500, '3') + "\n", "1"),
            "f:2: a number of more than a thousand decimals, which is refused where radii are asked for");
  EXPECT_EQ(refused("0 0 1e400\n", "1"), "f:1: out of range of a double: '1e400'; --skip-invalid leaves such rows out");
  EXPECT_EQ(radii_of("0 0 nan 1\n1 2 3 4\n", "column:4", {.skip_invalid = true}), Texts{"4"});
}

// The rows, names and notes are those without radii, and the centres round to them.
TEST(ReadBalls, RowsAreThoseWithoutRadii) {
  CITES("FC-FILE-55", "FC-IN-02");
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(FLOWCERT_USER_INPUTS)) {
    const std::string path = entry.path().string();
    SCOPED_TRACE(path);
    const PointFile points = read_points(path, {.skip_invalid = true});
    const BallFile balls = read_balls(path, {.skip_invalid = true, .finite = true}, AtomRadii("1.5"));
    EXPECT_EQ(balls.file.rows, points.rows);
    EXPECT_EQ(balls.file.format, points.format);
    EXPECT_EQ(balls.file.left_out, points.left_out);
    EXPECT_EQ(balls.file.atoms.size(), points.atoms.size());
    ASSERT_EQ(balls.balls.size(), points.rows.size());
    for (std::size_t k = 0; k < points.rows.size(); ++k) {
      const RationalPoint& centre = balls.balls[k].center;
      EXPECT_EQ((Point{*nearest_double(centre[0]), *nearest_double(centre[1]), *nearest_double(centre[2])}),
                points.rows[k]);
    }
    ++files;
  }
  EXPECT_GE(files, 18U);
}

// ---- Columns ----

TEST(ReadBalls, RadiiOfAColumn) {
  CITES("FC-FILE-55", "FC-FILE-39");
  const std::string rows = "0.1 0.2 0.3 1.5\n1.1 2 3 0.5\n";
  const BallFile file = read(rows, "column:4");
  EXPECT_EQ(centres_of(file), (Texts{"1/10 1/5 3/10", "11/10 2 3"}));
  EXPECT_EQ(notes_of(file.file), Notes{});
  EXPECT_EQ(radii_of(rows, "column:4"), (Texts{"3/2", "1/2"}));
  EXPECT_EQ(radii_of(rows, "column:1", {.columns = "2,3,4"}), (Texts{"1/10", "11/10"}));
  EXPECT_EQ(radii_of("r,x,y,z\n2,0,0,0\n3,1,0,0\n", "column:1"), (Texts{"2", "3"}));
  EXPECT_EQ(radii_of("2\n0 0 0 1\n1 0 0 2\n", "column:4"), (Texts{"1", "2"})) << "PTS";
  EXPECT_EQ(centres_of(read("1 2 7\n3 4 8\n", "column:3", {.z = 0.5})), (Texts{"1 2 1/2", "3 4 1/2"}));
  EXPECT_EQ(radii_of("1 2.5 3 4\n2 3 4 5\n", "column:4"), (Texts{"4", "5"})) << "no column is left for numbers of rows";
  EXPECT_EQ(notes_of(read("0 0 0 9 1\n0 1 0 9 2\n", "column:5").file),
            Notes{"more than three columns; those after the third are ignored but for the radius in 5"});
  EXPECT_EQ(refused(rows, "column:5"), "f:1: 4 columns, and column 5 is wanted");
  EXPECT_EQ(refused(rows, "column:18446744073709551615"), "f:1: 4 columns, and column 18446744073709551615 is wanted");
  EXPECT_EQ(refused(rows, "column:3"),
            "f:1: column 3 is a coordinate, and --radii takes it for the radius: --columns says which are x, y, z");
  EXPECT_EQ(refused("0 0 0 1\n1 0 0 0.0\n", "column:4"), "f:2: a radius is above 0, not '0.0'");
  EXPECT_EQ(refused("0 0 0 1\n1 0 0 1/2\n", "column:4"), "f:2: not a number: '1/2'");
  EXPECT_EQ(refused("1\n\nC 0 0 0 1.5\n", "column:5"), "f: --radii column:5 is for tables, and this is chemical");
}

// ---- Elements ----

std::string pdb_atom(const std::string& name, const std::string& residue, const std::string& element = "") {
  return "ATOM      1 " + name + " " + residue + " A   1       1.000   2.000   3.000  1.00 20.00          " + element +
         "\n";
}

TEST(ReadBalls, ElementsOfPdb) {
  CITES("FC-FILE-55", "FC-FILE-41");
  // The element that columns 77 and 78 have, whatever the name is.
  EXPECT_EQ(radii_of(pdb_atom(" CA ", "ALA", " C"), "bondi"), Texts{"17/10"});
  EXPECT_EQ(radii_of(pdb_atom("CA  ", " CA", "CA"), "bondi"), Texts{"231/100"});
  EXPECT_EQ(radii_of(pdb_atom(" X1 ", "LIG", "Cl"), "bondi"), Texts{"7/4"});
  EXPECT_EQ(radii_of(pdb_atom(" D1 ", "DOD", " D"), "bondi"), Texts{"6/5"});
  EXPECT_EQ(notes_of(read(pdb_atom(" CA ", "ALA", " C"), "bondi").file), Notes{});
  // Without them the name says it.
  const std::map<std::array<std::string, 2>, std::string> names = {
      {{" CA ", "ALA"}, "17/10"},   {{"CA  ", "ALA"}, "17/10"},   {{"1HB ", "ALA"}, "6/5"},
      {{"HG11", "VAL"}, "6/5"},     {{"SE  ", "MSE"}, "19/10"},   {{" P  ", " DA"}, "9/5"},
      {{" OH2", "HOH"}, "38/25"},   {{"CA  ", " CA"}, "231/100"}, {{"CL1 ", "LIG"}, "7/4"},
      {{" C1 ", "LIG"}, "17/10"},   {{"C1  ", "LIG"}, "17/10"},   {{"HO5'", "LIG"}, "6/5"},
      {{"ZN  ", " ZN"}, "139/100"}, {{"BR12", "LIG"}, ""},        {{"C112", "LIG"}, "17/10"}};
  for (const auto& [name, radius] : names) {
    const std::string text = pdb_atom(name[0], name[1]);
    if (radius.empty()) {
      EXPECT_EQ(refused(text, "bondi"),
                "f:1: atom 0 (A LIG 1 BR12): 'BR12' may mean Br or B: the file has to say which element it is");
      continue;
    }
    EXPECT_EQ(radii_of(text, "bondi"), Texts{radius}) << name[0] << ' ' << name[1];
    EXPECT_EQ(notes_of(read(text, "bondi").file).back(),
              "the file does not say the elements of 1 atom; they are taken from their names");
  }
}

TEST(ReadBalls, ElementsOfChemicalXyz) {
  CITES("FC-FILE-55", "FC-FILE-40");
  const auto radius = [](const std::string& label) { return refused("1\n\n" + label + " 0 0 0\n", "bondi"); };
  const auto radii = [](const std::string& label) { return radii_of("1\n\n" + label + " 0 0 0\n", "alvarez")[0]; };
  const std::map<std::string, std::string> labels = {
      {"C", "177/100"}, {"C12", "177/100"}, {"6", "177/100"}, {"Ca", "131/50"}, {"Fe3+", "61/25"}, {"FE", "61/25"},
      {"CL2", "91/50"}, {"D", "6/5"},       {"T", "6/5"},     {"O_w", "3/2"},   {"92", "271/100"}};
  for (const auto& [label, expected] : labels) EXPECT_EQ(radii(label), expected) << label;
  EXPECT_EQ(radius("CA"), "f:3: atom 0 (CA): 'CA' may mean Ca or C: the file has to say which element it is");
  EXPECT_EQ(radius("T1"), "f:3: atom 0 (T1): no element is known by 'T1', and --radii needs it");
  EXPECT_EQ(radius("Xx"), "f:3: atom 0 (Xx): no element is known by 'Xx', and --radii needs it");
  EXPECT_EQ(radius("ca"), "f:3: atom 0 (ca): no element is known by 'ca', and --radii needs it");
  EXPECT_EQ(radius("0"), "f:3: atom 0 (0): no element is known by '0', and --radii needs it");
  EXPECT_EQ(radius("119"), "f:3: atom 0 (119): no element is known by '119', and --radii needs it");
  EXPECT_EQ(refused("1\nProperties=pos:R:3\n0 0 0\n", "bondi"),
            "f:3: atom 0 (): its element is not said, and --radii needs it");
  EXPECT_EQ(refused("2\n\nC 0 0 0\nFe 1 0 0\n", "bondi,H=1"),
            "f:4: atom 1 (Fe): 'bondi' has no radius of Fe; --radii bondi,H=1,Fe=R says one");
  EXPECT_EQ(radii_of("2\n\nC 0 0 0\nFe 1 0 0\n", "bondi,Fe=2.04"), (Texts{"17/10", "51/25"}));
  EXPECT_EQ(radii_of("2\n\nC 0 0 0\nFe 1 0 0\n", "1.5,Fe=2.04"), (Texts{"3/2", "51/25"}));
  EXPECT_EQ(refused("1 2 3\n", "bondi"),
            "f: --radii bondi is for PDB, PQR, CIF and chemical XYZ, which have elements, and this is table");
  EXPECT_EQ(refused("1 2 3\n", "1,H=1"),
            "f: --radii 1,H=1 is for PDB, PQR, CIF and chemical XYZ, which have elements, and this is table");
}

const std::string kMmcif =
    "data_a\nloop_\n_atom_site.group_PDB\n_atom_site.type_symbol\n_atom_site.label_atom_id\n_atom_site.label_comp_id\n"
    "_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\n";

TEST(ReadBalls, ElementsOfCif) {
  CITES("FC-FILE-55", "FC-FILE-42");
  EXPECT_EQ(radii_of(kMmcif + "ATOM C CA ALA 0.1 2 3\nHETATM CA CA CA 4 5 6\nHETATM FE FE HEM 7 8 9\n", "alvarez"),
            (Texts{"177/100", "131/50", "61/25"}));
  EXPECT_EQ(radii_of(kMmcif + "ATOM ? CA ALA 0.1 2 3\n", "bondi"), Texts{"17/10"});
  EXPECT_EQ(refused(kMmcif + "HETATM ? CL1 LIG 0.1 2 3\n", "bondi"),
            "f:10: atom 0 (LIG CL1): 'CL1' may mean Cl or C: the file has to say which element it is");
}

// ---- PQR ----

const std::string kPqr =
    "REMARK   1 written by hand\nATOM 1 N ALA 1 1.25 -2 3e1 0.1 1.85\nTER\nATOM 2 HB1 ALA A -7B 0.1 5 6.75 -0.25 "
    "2.275\n"
    "HETATM 3 ZN ZN B 201 7 8 9 2 1.1\nEND\n";

TEST(ReadPqr, AtomsAndTheirRadii) {
  CITES("FC-FILE-54", "FC-FILE-55");
  const BallFile file = read(kPqr, "pqr");
  EXPECT_EQ(file.file.format, "pqr");
  EXPECT_EQ(centres_of(file), (Texts{"5/4 -2 30", "1/10 5 27/4", "7 8 9"}));
  EXPECT_EQ(radii_of(kPqr, "pqr"), (Texts{"37/20", "91/40", "11/10"}));
  EXPECT_EQ(file.file.atoms.text(0), "ALA 1 N");
  EXPECT_EQ(file.file.atoms.text(1), "A ALA -7B HB1");
  EXPECT_EQ(radii_of(kPqr, "pqr,H=1"), (Texts{"37/20", "1", "11/10"}));
  EXPECT_EQ(radii_of(kPqr, "bondi"), (Texts{"31/20", "6/5", "139/100"}));
  EXPECT_EQ(radii_of(gzipped(kPqr), "pqr"), (Texts{"37/20", "91/40", "11/10"}));
  EXPECT_EQ(radii_of(kPqr, "pqr", {.atoms = {"no hydrogens"}}), (Texts{"37/20", "11/10"}));
  EXPECT_EQ(radii_of(kPqr, "pqr", {.chains = {"A"}}), Texts{"91/40"});
}

TEST(ReadPqr, ContentIsPqrWherePdbWouldRefuseIt) {
  CITES("FC-FILE-38", "FC-FILE-54");
  EXPECT_EQ(read_points_from(kPqr, "f").format, "pqr");
  EXPECT_EQ(read_points_from("ATOM 1 C X 1 0 0 0 0 1\n", "f").format, "pqr");
  // By its columns this is PDB, too, and stays so.
  const std::string columns =
      "ATOM      1  N   LYS     1       3.000  15.000  14.000  0.0966 1.8240\n"
      "ATOM      2  HA  LYS     1       4.100  16.100  14.900  0.1425 0.0000\n";
  EXPECT_EQ(read_points_from(columns, "a.pqr").format, "pdb");
  EXPECT_EQ(read_points_from(columns, "a.pqr", {.format = "pqr"}).rows, read_points_from(columns, "a.pqr").rows);
  EXPECT_EQ(refused(columns, "pqr"), "f:2: a radius is above 0, not '0.0000'; --radii pqr,H=R gives hydrogens another");
  EXPECT_EQ(radii_of(columns, "pqr,H=1.2"), (Texts{"228/125", "6/5"}));
  EXPECT_EQ(refused(columns, "pqr", {.format = "pdb"}), "f: --radii pqr is for PQR, and this is pdb");
  // A table whose columns are named, and lines that lack a field.
  const std::string table = "# what n a r i x y z q d\nATOM 1 C X 1 0 0 0 0 1\n";
  EXPECT_EQ(read_points_from(table, "f").format, "table");
  EXPECT_EQ(refusal("REMARK\nATOM 1 C X 1 0 0 0 1\n", "f"), "f:2: an atom's line ends before column 54");
}

TEST(ReadPqr, Errors) {
  CITES("FC-FILE-54", "FC-IN-01", "FC-IN-05");
  const std::string first = "ATOM 1 C X 1 0 0 0 0 1\n";
  const auto said = [&](const std::string& line) { return refused(first + line + "\n", "pqr"); };
  EXPECT_EQ(said("ATOM 1 C X 1 0 0 0 1"), "f:2: 9 fields, and an atom of PQR has 10, or 11 with a chain");
  EXPECT_EQ(said("ATOM 1 C X A 1 0 0 0 0 1 C"),
            "f:2: more than 11 fields, and an atom of PQR has 10, or 11 with a chain");
  EXPECT_EQ(said("HETATM10 C X 1 0 0 0 0 1 1"), "f:2: no blank after ATOM or HETATM: 'HETATM10'");
  EXPECT_EQ(said("ATOM 1 C X A1 0 0 0 0 1"), "f:2: not a residue's number: 'A1'");
  EXPECT_EQ(said("ATOM 1 C X 1 0 0 0 q 1"), "f:2: the charge: not a number: 'q'");
  EXPECT_EQ(said("ATOM 1 C X 1 0 0 0 0 1r"), "f:2: the radius: not a number: '1r'");
  EXPECT_EQ(said("ATOM 1 C X 1 0 0 0 0 inf"), "f:2: the radius: not a finite number: 'inf'");
  EXPECT_EQ(said("ATOM 1 C X 1 0 0 0.0.1 0 1"), "f:2: not a number: '0.0.1'");
  EXPECT_EQ(said("ATOM 1 C X 1 0 0 0 0 -1"),
            "f:2: a radius is above 0, not '-1'; --radii pqr,H=R gives hydrogens another");
  EXPECT_NE(said(" ATOM 1 C X 1 0 0 0 0 1").find("looks like an atom"), std::string::npos);
  EXPECT_EQ(refused("1 2 3\n", "pqr"), "f: there are no atoms");
  EXPECT_EQ(said("END\nATOM 2 C X 2 0 0 0 0 1"), "accepted, 1 balls") << "another frame, as in PDB";
}

// ---- Cells ----

TEST(ReadBalls, CrystalsAreNoFiniteSets) {
  CITES("FC-FILE-55", "FC-FILE-40", "FC-FILE-42");
  const std::string reason =
      "the atoms of a crystal have no end, and balls are a finite set: --finite takes those of the file alone";
  const std::string note = "the cell is ignored: the atoms are a finite set, without periodic images";
  const std::string lattice = "1\nLattice=\"5 0 0 0 5 0 0 0 5\" Properties=species:S:1:pos:R:3\nC 0.1 0 0\n";
  EXPECT_EQ(refused(lattice, "1"), "f:2: " + reason);
  EXPECT_EQ(centres_of(read(lattice, "1", {.finite = true})), Texts{"1/10 0 0"});

  const std::string cell =
      "_cell_length_a 0.1\n_cell_length_b 10\n_cell_length_c 10\n_cell_angle_alpha 90\n"
      "_cell_angle_beta 90\n_cell_angle_gamma ";
  const std::string atoms =
      "\n_symmetry_Int_Tables_number 1\nloop_\n_atom_site_label\n_atom_site_fract_x\n"
      "_atom_site_fract_y\n_atom_site_fract_z\nC1 0.1 0.2 0.3\n";
  EXPECT_EQ(refused("data_a\n" + cell + "90" + atoms, "1"), "f: " + reason);
  const BallFile right = read("data_a\n" + cell + "90" + atoms, "bondi", {.finite = true});
  EXPECT_EQ(centres_of(right), Texts{"1/100 2 3"});
  EXPECT_EQ(notes_of(right.file), Notes{note});
  const BallFile other = read("data_a\n" + cell + "100" + atoms, "bondi", {.finite = true});
  EXPECT_EQ(other.balls[0].center[1], Rational(other.file.rows[0].y));
  EXPECT_EQ(notes_of(other.file), (Notes{note,
                                         "the cell has other angles than right ones: its Cartesian positions are "
                                         "the nearest doubles, taken exactly"}));
  const std::string cartesian =
      "loop_\n_atom_site_label\n_atom_site_Cartn_x\n_atom_site_Cartn_y\n_atom_site_Cartn_z\n"
      "C1 0.1 0.2 0.3\n";
  EXPECT_EQ(refused("data_a\n" + cell + "90\n" + cartesian, "1"), "f: " + reason);
  EXPECT_EQ(refused("data_a\n" + cartesian, "1"), "accepted, 1 balls");

  // Structures of macromolecules have cells, and are taken as they are.
  const std::string record = "CRYST1   50.000   50.000   50.000  90.00  90.00  90.00 P 1           1\n";
  const std::string atom = pdb_atom(" CA ", "ALA", " C");
  const BallFile pdb = read(record + atom, "1");
  EXPECT_EQ(notes_of(pdb.file), Notes{note});
  EXPECT_EQ(pdb.file.notes[0].line, 1U);
  EXPECT_EQ(notes_of(read_points_from(record + atom, "f")), Notes{});
  EXPECT_EQ(notes_of(read("CRYST1    1.000    1.000    1.000  90.00  90.00  90.00 P 1           1\n" + atom, "1").file),
            Notes{});
  EXPECT_EQ(notes_of(read(kMmcif + "ATOM C CA ALA 0.1 2 3\n_cell.length_a 50\n", "1").file), Notes{note});
  EXPECT_EQ(notes_of(read(kMmcif + "ATOM C CA ALA 0.1 2 3\n_cell.length_a 1\n", "1").file), Notes{});
  EXPECT_EQ(refusal(atom, "f", {.finite = true}), "f: --finite is for atoms with radii, and there are none");
}

// ---- Strangers ----

TEST(ReadBalls, DamagedFilesAreRefusedOrHaveRadii) {
  CITES("FC-FILE-54", "FC-FILE-55", "FC-IN-05");
  const std::vector<std::array<std::string, 2>> files = {
      {kPqr, "pqr"},
      {kPqr, "bondi,Zn=1"},
      {"0.1 0.2 0.3 1.5\n1.1 2 3 0.5\n", "column:4"},
      {"3\n\nC 1.25 -2 3e1\n8 1.5 5 6.75\nCl1 7 8 9\n", "bondi"},
      {pdb_atom(" CA ", "ALA", " C") + pdb_atom("CL1 ", "LIG"), "alvarez,C=1/3"},
      {kMmcif + "ATOM C CA ALA 0.1 2 3\nHETATM CA CA CA 4 5 6\n", "1.5,Ca=2"}};
  const std::string meaningful = "0123456789.-+eExXp#,; \t\r\nATOMHEDCaN\x7f\x80/=";
  std::mt19937_64 random(49);
  std::size_t refused = 0, read_well = 0;
  const std::size_t rounds = flowcert_tests::is_whole_run() ? 60000 : 6000;
  for (std::size_t round = 0; round < rounds; ++round) {
    const auto& [text, radii] = files[round % files.size()];
    std::string bytes = text;
    for (std::size_t changes = 1 + random() % 3; changes > 0; --changes) {
      const std::size_t place = random() % bytes.size();
      const char byte = meaningful[random() % meaningful.size()];
      if (random() % 3 == 0)
        bytes.insert(place, 1, byte);
      else if (random() % 2 == 0)
        bytes.erase(place, 1);
      else
        bytes[place] = byte;
    }
    try {
      const BallFile file = read(bytes, radii);
      ++read_well;
      ASSERT_EQ(file.balls.size(), file.file.rows.size()) << bytes;
      for (std::size_t k = 0; k < file.balls.size(); ++k) {
        ASSERT_GT(file.balls[k].radius, 0) << bytes;
        ASSERT_EQ(*nearest_double(file.balls[k].center[0]), file.file.rows[k].x) << bytes;
      }
    } catch (const InvalidInput& error) {
      ++refused;
      ASSERT_EQ(std::string(error.what()).find('\n'), std::string::npos) << bytes;
    }
  }
  EXPECT_GT(refused, rounds / 10);
  EXPECT_GT(read_well, rounds / 10);
}

}  // namespace
}  // namespace flowcert::read_balls_test
