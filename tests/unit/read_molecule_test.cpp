// Reading PDB and mmCIF files: which atoms are points, chains, models and alternate locations, and each error with its
// message.
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <string>

#include "tests/cites.h"
#include "tests/unit/point_file_samples.h"

namespace flowcert::read_molecule_test {
namespace {

// The first 54 columns of an atom, and what may come after them.
std::string atom(const std::string& numbers, const std::string& record = "ATOM  ", char chain = 'A',
                 char location = ' ', const std::string& name = " CA ") {
  return record + "    1 " + name + location + "ALA " + chain + "   1    " + numbers + "  1.00 20.00           C\n";
}
const std::string kOne = "   1.000   2.000   3.000", kTwo = "  -1.500  12.250   0.001",
                  kThree = "   7.000   8.000   9.000";

PointFile read(const std::string& bytes, const std::string& name, const std::vector<std::string>& chains = {}) {
  return read_points_from(bytes, name, {.chains = chains});
}
TEST(ReadPdb, AtomsAndHeteroAtomsInTheirOrder) {
  CITES("FC-IN-02");
  const std::string text = "HEADER    A MOLECULE\r\nREMARK   1 ATOM\r\n" + atom(kOne) + atom(kTwo, "HETATM", 'B') +
                           "TER\nANISOU    1  CA  ALA A   1     2406   1892   1614    198    519   -328\n" +
                           atom("-100.000-200.125-300.000", "ATOM  ", 'C') + "END\n";
  const Rows expected = {{1, 2, 3}, {-1.5, 12.25, 0.001}, {-100, -200.125, -300}};
  for (const std::string name : {"a.pdb", "a.ent", "A.PDB", "-"}) EXPECT_EQ(rows_of(text, name), expected) << name;
  EXPECT_EQ(rows_of(gzipped(text), "a.pdb.gz"), expected);
  EXPECT_EQ(read(text, "a.pdb").format, "pdb");
  EXPECT_EQ(read(text, "a.pdb", {"B", "C"}).rows, (Rows{expected[1], expected[2]}));
  EXPECT_EQ(rows_of(atom(kOne).substr(0, 54), "a.pdb"), Rows{expected[0]});
}

TEST(ReadPdb, TheFirstModelAndTheFirstLocation) {
  CITES("FC-IN-02");
  const std::string text = "MODEL        1\n" + atom(kOne, "ATOM  ", 'A', 'B') + atom(kTwo, "ATOM  ", 'A', 'A') +
                           atom(kTwo, "ATOM  ", 'A', 'A', " CB ") + "ENDMDL\nMODEL        2\n" + atom(kThree) +
                           "ENDMDL\nMODEL        3\nENDMDL\n";
  const PointFile file = read(text, "a.pdb");
  EXPECT_EQ(file.rows, (Rows{{1, 2, 3}, {-1.5, 12.25, 0.001}}));
  EXPECT_EQ(notes_of(file), (Notes{"only the first model is read; 2 others are left out",
                                   "of an atom with alternate locations the first is read; 1 other is left out"}));
}

TEST(ReadPdb, DecimalsAreTheNearestDoubles) {
  CITES("FC-IN-02");
  std::string text;
  Rows expected;
  for (int k = -999999; k <= 9999999; k += 12347) {
    char number[16];
    std::snprintf(number, sizeof number, "%8.3f", k / 1000.0);
    text += atom(std::string(number) + number + number);
    const double x = std::strtod(number, nullptr);
    expected.push_back({x, x, x});
  }
  EXPECT_EQ(rows_of(text, "a.pdb"), expected);
}

TEST(ReadPdb, Errors) {
  CITES("FC-IN-01", "FC-IN-05");
  EXPECT_EQ(refusal("HEADER\n", "a.pdb"), "a.pdb: there are no atoms");
  EXPECT_EQ(refusal(atom(kOne) + atom("   1.000   2.0.0   3.000"), "a.pdb"),
            "a.pdb:2: not a number: '2.0.0', in columns 39 to 46");
  EXPECT_EQ(refusal(atom("   1.000           3.000"), "a.pdb"), "a.pdb:1: no coordinate y in columns 39 to 46");
  EXPECT_EQ(refusal(atom("   1.000   2.000********"), "a.pdb"),
            "a.pdb:1: not a number: '********', in columns 47 to 54");
  EXPECT_EQ(refusal(atom("   1.000   2.000     nan"), "a.pdb"),
            "a.pdb:1: not a finite number: 'nan'; --skip-invalid leaves such rows out");
  EXPECT_EQ(refusal(atom(kOne).substr(0, 50), "a.pdb"), "a.pdb:1: an atom's line ends before column 54");
  EXPECT_EQ(refusal(atom(kOne) + atom(kTwo, "ATOM  ", 'B'), "a.pdb", {.chains = {"A", "X"}}),
            "a.pdb: there is no chain 'X'; there are 'A', 'B'");
  EXPECT_EQ(refusal("1 2 3\n", "a.xyz", {.chains = {"A"}}),
            "a.xyz: --chains is for PDB, PQR and CIF, and this is table");
}

const std::string kCif =
    "data_1ABC\n#\n_entry.id 1ABC\n_struct.title 'it''s a \"title\"; loop_'\n_cell.text\n;\nloop_\n_atom_site.id\n;\n"
    "loop_\n_atom_site.group_PDB\n_atom_site.id\n_atom_site.label_atom_id\n_atom_site.label_alt_id\n"
    "_atom_site.label_asym_id\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\n_atom_site.auth_asym_id\n"
    "_atom_site.pdbx_PDB_model_num\n";

TEST(ReadMmcif, AtomsOfTheTable) {
  CITES("FC-IN-02");
  const std::string rows =
      "ATOM 1 CA . A 1.000 2.000 3.000 X 1 # a comment\nATOM 2 \"C'\" . A\n -1.500 12.250 1e-3 X 1\n"
      "HETATM 3 'O5''' . B 7 8 9 Y 1\n#\nloop_\n_other.id\n1\n2\n";
  const Rows expected = {{1, 2, 3}, {-1.5, 12.25, 0.001}, {7, 8, 9}};
  for (const std::string name : {"a.cif", "a.mmcif", "-"}) EXPECT_EQ(rows_of(kCif + rows, name), expected) << name;
  EXPECT_EQ(rows_of(gzipped(kCif + rows), "a.cif.gz"), expected);
  EXPECT_EQ(read(kCif + rows, "a.cif").format, "cif");
  EXPECT_EQ(read(kCif + rows, "a.cif", {"Y"}).rows, Rows{expected[2]});
}

TEST(ReadMmcif, TheFirstModelAndTheFirstLocation) {
  CITES("FC-IN-02");
  const std::string rows =
      "ATOM 1 CA B A 1 2 3 A 1\nATOM 2 CA A A 4 5 6 A 1\nATOM 3 CB ? A 7 8 9 A 1\nATOM 4 CA . A 0 0 0 A 2\n"
      "ATOM 5 CB . A 0 0 1 A 2\n";
  const PointFile file = read(kCif + rows, "a.cif");
  EXPECT_EQ(file.rows, (Rows{{1, 2, 3}, {7, 8, 9}}));
  EXPECT_EQ(notes_of(file), (Notes{"only the first model is read; 1 other is left out",
                                   "of an atom with alternate locations the first is read; 1 other is left out"}));
}

TEST(ReadMmcif, Errors) {
  CITES("FC-IN-01", "FC-IN-05");
  EXPECT_EQ(refusal("data_x\n_a.b 1\n", "a.cif"), "a.cif: there is no table _atom_site with coordinates");
  EXPECT_EQ(refusal(kCif, "a.cif"), "a.cif: there are no atoms");
  EXPECT_EQ(refusal(kCif + "ATOM 1 CA . A 1 2\n", "a.cif"),
            "a.cif:21: the last row of the table _atom_site is not complete");
  EXPECT_EQ(refusal(kCif + "ATOM 1 CA . A 1 2x 3 A 1\n", "a.cif"), "a.cif:21: not a number: '2x'");
  EXPECT_EQ(refusal(kCif + "ATOM 1 CA . A 1 ? 3 A 1\n", "a.cif"), "a.cif:21: an atom without cartn_y");
  EXPECT_EQ(refusal(kCif + "ATOM 1 'CA . A 1 2 3 A 1\n", "a.cif"), "a.cif:21: a quote that does not end in its line");
  EXPECT_EQ(refusal("data_x\n_a.b\n;\ntext\n", "a.cif"), "a.cif:3: a text field that does not end");
  EXPECT_EQ(refusal("data_x\nloop_\n_atom_site.id\n_atom_site.Cartn_x\n1 2\n", "a.cif"),
            "a.cif:5: the table _atom_site has no column cartn_y");
  EXPECT_EQ(refusal("data_x\nloop_\n_atom_site.Cartn_x\n_b\n1 2\n", "a.cif"),
            "a.cif:5: a column of another table: '_b'");
  EXPECT_EQ(refusal(kCif + "ATOM 1 CA . A 1 2 3 A 1\n", "a.cif", {.chains = {"B"}}),
            "a.cif: there is no chain 'B'; there are 'A'");
  const std::string table = kCif + "ATOM 1 CA . A 1 2 3 A 1\n";
  EXPECT_EQ(refusal(table + table, "a.cif"), "accepted, 1 rows") << "a second block is a second model";
  const std::string second = kCif.substr(kCif.find("loop_\n_atom_site.group_PDB"));
  EXPECT_NE(refusal(table + second, "a.cif").find("a second table _atom_site"), std::string::npos);
}

}  // namespace
}  // namespace flowcert::read_molecule_test
