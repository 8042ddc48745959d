// What the files of molecules call their atoms, by every reader that knows names.
#include "flowcert/atom_names.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "flowcert/read_points.h"
#include "tests/cites.h"

namespace flowcert::atom_names_test {
namespace {

std::vector<std::string> texts_of(const std::string& file, const ReadingOptions& options = {}) {
  const PointFile read = read_points_from(file, "file", options);
  EXPECT_EQ(read.atoms.size(), read.atoms.empty() ? 0 : read.rows.size());
  std::vector<std::string> texts;
  for (PointId row = 0; row < read.atoms.size(); ++row) texts.push_back(read.atoms.text(row));
  return texts;
}

using Texts = std::vector<std::string>;

constexpr char kPdb[] =
    "ATOM      1  N   MET A   1      27.340  24.430   2.614  1.00  9.67           N\n"
    "ATOM      2  CA AMET A   1A     26.266  25.413   2.842  0.50 10.38           C\n"
    "ATOM      3  CA BMET A   1A     26.300  25.500   2.900  0.50 10.38           C\n"
    "HETATM    4  O   HOH B 302       1.000   2.000   3.000  1.00 10.00           O\n"
    "END\n";

TEST(AtomNames, OfPdb) {
  CITES("FC-FILE-41");
  EXPECT_EQ(texts_of(kPdb), (Texts{"A MET 1 N", "A MET 1A CA", "B HOH 302 O"}));
  EXPECT_EQ(texts_of(kPdb, {.atoms = {"no water"}}), (Texts{"A MET 1 N", "A MET 1A CA"}));
  const PointFile read = read_points_from(kPdb, "file");
  const AtomName name = read.atoms[1];
  EXPECT_EQ(name.chain, "A");
  EXPECT_EQ(name.residue, "MET");
  EXPECT_EQ(name.number, "1A");
  EXPECT_EQ(name.atom, "CA");
  EXPECT_EQ(name.element, "C");
  EXPECT_EQ(read.atoms.residue_text(0), "A MET 1");
  const std::vector<PointId> rows = {2, 1, 0, 2};
  EXPECT_EQ(read.atoms.residue_texts(rows), (Texts{"B HOH 302", "A MET 1A", "A MET 1"}));
}

TEST(AtomNames, OfCif) {
  CITES("FC-FILE-42");
  const std::string mmcif =
      "data_x\nloop_\n_atom_site.group_PDB\n_atom_site.type_symbol\n_atom_site.label_atom_id\n"
      "_atom_site.label_comp_id\n_atom_site.label_asym_id\n_atom_site.auth_seq_id\n_atom_site.pdbx_PDB_ins_code\n"
      "_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\n"
      "ATOM C CA GLY A 7 ? 1 2 3\nATOM O \"O5'\" DA B 8 B 4 5 6\n";
  EXPECT_EQ(texts_of(mmcif), (Texts{"A GLY 7 CA", "B DA 8B O5'"}));
  // Fractional coordinates wait for the cell; their names wait, too.
  const std::string small =
      "data_y\nloop_\n_atom_site_label\n_atom_site_type_symbol\n_atom_site_fract_x\n_atom_site_fract_y\n"
      "_atom_site_fract_z\nNa1 Na 0 0 0\nCl2 Cl 0.5 0.5 0.5\n"
      "_cell_length_a 5\n_cell_length_b 5\n_cell_length_c 5\n_cell_angle_alpha 90\n_cell_angle_beta 90\n"
      "_cell_angle_gamma 90\n_space_group_name_H-M_alt 'P 1'\n";
  EXPECT_EQ(texts_of(small), (Texts{"Na1", "Cl2"}));
}

TEST(AtomNames, OfChemicalXyz) {
  CITES("FC-FILE-40");
  EXPECT_EQ(texts_of("3\nwater\nO 0 0 0\nH1 1 0 0\nH2 0 1 0\n"), (Texts{"O", "H1", "H2"}));
  EXPECT_EQ(texts_of("2\n\nC 0 0 nan\nN 1 0 0\n", {.skip_invalid = true}), Texts{"N"});
}

TEST(AtomNames, OtherFilesHaveNone) {
  EXPECT_EQ(texts_of("0 0 0\n1 0 0\n"), Texts{});
  EXPECT_EQ(texts_of("OFF\n1 0 0\n1 2 3\n"), Texts{});
}

// Names are other people's text.
TEST(AtomNames, AreOneLineOfText) {
  AtomNames names;
  names.add({.chain = "\x1b[2J",
             .residue = "\xff",
             .number = "1\n",
             .atom = std::string(300, 'C'),
             .element = "C\xe2\x80\xae"});
  EXPECT_EQ(names[0].chain, "\\x1b[2J");
  EXPECT_EQ(names[0].residue, "\\xff");
  EXPECT_EQ(names[0].number, "1\\n");
  EXPECT_EQ(names[0].atom, std::string(255, 'C'));
  EXPECT_EQ(names[0].element, "C\\u202e");
}

}  // namespace
}  // namespace flowcert::atom_names_test
