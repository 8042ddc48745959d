// Small files of every format that is read, and of some that are not: right ones, odd ones, broken ones. Each has its
// points and what is said of them, or its message.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "tests/cites.h"
#include "tests/unit/point_file_samples.h"

namespace flowcert::point_examples_test {
namespace {

const Rows kThree = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0.5}};
const std::string kReadFormats =
    "; these formats are read: table, pts, chemical, off, ply, obj, pcd, npy, pdb, pqr, cif (--format says one)";

struct Example {
  const char* what;
  std::string text;
  Rows rows;         // none where it is refused
  std::string said;  // its message, or else the notes, one a line
  ReadingOptions options = {};
};

std::string pcd(const std::string& data, const std::string& rows, const std::string& points = "3") {
  return "# .PCD v0.7\nVERSION 0.7\nFIELDS x y z intensity\nSIZE 4 4 4 4\nTYPE F F F F\nCOUNT 1 1 1 1\nWIDTH " +
         points + "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " + points + "\nDATA " + data + "\n" + rows;
}

std::string pcd_bytes() {
  std::string bytes;
  for (const Point& p : kThree) {
    for (const double value : {p.x, p.y, p.z, 7.0}) bytes += bytes_of(static_cast<float>(value), false);
  }
  return bytes;
}

std::string npy(const std::string& type, const std::string& shape, const std::string& data,
                const std::string& order = "False") {
  std::string header = "{'descr': '" + type + "', 'fortran_order': " + order + ", 'shape': " + shape + ", }";
  header += std::string(64 - (10 + header.size() + 1) % 64, ' ') + "\n";
  return "\x93NUMPY" + std::string("\x01\x00", 2) + bytes_of(static_cast<std::uint16_t>(header.size()), false) +
         header + data;
}

template <class Number>
std::string numbers(const std::vector<double>& values, bool big_endian = false) {
  std::string bytes;
  for (const double value : values) bytes += bytes_of(static_cast<Number>(value), big_endian);
  return bytes;
}
const std::vector<double> kInRows = {0, 0, 0, 1, 0, 0, 0, 1, 0.5}, kInColumns = {0, 1, 0, 0, 0, 1, 0, 0, 0.5};

std::string pdb_atom(const std::string& start, const std::string& residue, const std::string& numbers,
                     const std::string& element = "C") {
  std::string line = start + residue + numbers;
  line.resize(76, ' ');
  return line + (element.size() == 1 ? " " : "") + element + "\n";
}
const std::string kOrigin = "   0.000   0.000   0.000  1.00 20.00", kX = "   1.000   0.000   0.000  1.00 20.00",
                  kY = "   0.000   1.000   0.500  1.00 20.00";

const std::string kCell =
    "data_x\n_cell_length_a 10.0\n_cell_length_b 10.0\n_cell_length_c 10.0\n_cell_angle_alpha 90\n_cell_angle_beta "
    "90\n_cell_angle_gamma 90\n";
const std::string kFractional = "loop_\n_atom_site_label\n_atom_site_fract_x\n_atom_site_fract_y\n_atom_site_fract_z\n";
const std::string kMmcif =
    "data_x\nloop_\n_atom_site.group_PDB\n_atom_site.type_symbol\n_atom_site.label_comp_id\n_atom_site.Cartn_x\n"
    "_atom_site.Cartn_y\n_atom_site.Cartn_z\n";

std::vector<Example> tables() {
  const std::string plain = "0 0 0\n1 0 0\n0 1 .5\n";
  return {
      {"blanks", plain, kThree, ""},
      {"tabs, an empty line, a comment", "# x\n0\t0\t0\n\n1 0 0 # here\n0 1 0.5", kThree, ""},
      {"commas", "0,0,0\n1,0,0\n0,1,0.5\n", kThree, ""},
      {"semicolons", "0;0;0\n1;0;0\n0;1;0.5\n", kThree, ""},
      {"semicolons and decimal commas", "0,0;0;0\n1;0;0\n", {}, "f:1: a decimal comma: '0,0'; numbers have a point"},
      {"blanks and decimal commas",
       "0,0 1,5 2,5\n",
       {},
       "f:1: a comma between digits, and blanks alone between other numbers: is it a decimal point?"},
      {"Fortran's exponents", "0D0 0.0D+00 0\n.1D1 0 0\n0d0 1 5d-1\n", kThree, ""},
      {"Fortran's exponents in a first row below 0", "-1.0D0 -2.0D0 -3.0D0\n", {{-1, -2, -3}}, ""},
      {"exponents of Mathematica", "0 0 0\n1.*^0 0 0\n0 1 5*^-1\n", kThree, ""},
      {"byte order mark, lines of Windows",
       "\xef\xbb\xbf"
       "0 0 0\r\n1 0 0\r\n0 1 .5\r\n",
       kThree, ""},
      {"names", "x y z\n" + plain, kThree, ""},
      {"names in another order", "q,z,y,x\n9,0,0,0\n9,0,0,1\n9,.5,1,0\n", kThree, ""},
      {"a comment that begins as VTK does", "# vtk DataFile of a scan\n0 0 0\n1 0 0\n0 1 .5\n", kThree, ""},
      {"a comment that ends as SDF's counts do", "# a scan\n0 0 0\n1 0 0\n0 1 .5 # since V2000\n", kThree, ""},
      {"a comment on lines", "# a\n# b\n# c\n# V3000\n0 0 0\n1 0 0\n0 1 .5\n", kThree, ""},
      {"names in a comment", "# y x z\n0 0 0\n0 1 0\n1 0 .5\n", kThree, ""},
      {"CloudCompare's names", "//X Y Z R G B\n0 0 0 1 2 3\n1 0 0 1 2 3\n0 1 .5 1 2 3\n", kThree, ""},
      {"names with quotes, and an index", "\"\",\"x\",\"y\",\"z\"\n1,0,0,0\n2,1,0,0\n3,0,1,.5\n", kThree, ""},
      {"names without x",
       "a,b,c\n0,0,0\n",
       {},
       "f:2: the columns above have names, and not x, y and z: --columns says which they are"},
      {"names without x, chosen", "a,b,c,d\n9,0,0,0\n9,1,0,0\n9,0,1,.5\n", kThree, "", {.columns = "b,c,d"}},
      {"columns chosen by number", "9 0 0 0\n9 1 0 0\n9 0 1 .5\n", kThree, "", {.columns = "2,3,4"}},
      {"columns chosen that are not there", plain, {}, "f:1: 3 columns, and column 4 is wanted", {.columns = "2,3,4"}},
      {"columns chosen twice", plain, {}, "--columns takes different columns, not '1,1,2'", {.columns = "1,1,2"}},
      {"two names alike",
       "x,y,z,X\n0,0,0,1\n",
       {},
       "f:2: two columns are named x: --columns says by number which is meant"},
      {"a name for each row",
       "1 0.5 0 0\n2 1 0 0\n3 0 1 0\n",
       {},
       "f: 4 columns without names, of which the first may be numbers of the rows: --columns 2,3,4 takes the next "
       "three, --columns 1,2,3 the first"},
      {"a colour for each row", "0 0 0 7\n1 0 0 7\n0 1 .5 7\n", kThree,
       "more than three columns; those after the third are ignored"},
      {"two columns", "0 0\n1 0\n", {}, "f:1: two columns, and points have three coordinates: --z 0 makes their z 0"},
      {"two columns and a third coordinate", "0 0\n1 0\n", {{0, 0, 2}, {1, 0, 2}}, "", {.z = 2}},
      {"a third coordinate too many", plain, {}, "f:1: --z is for two columns, and this row has 3", {.z = 0}},
      {"one column",
       "0\n1\n2\n",
       {},
       "f: begins with a count, but neither rows of numbers follow, as in PTS, nor a comment and atoms, as in chemical "
       "XYZ"},
      {"a row that is too short", "0 0 0\n1 0\n", {}, "f:2: too few numbers: 2 of 3"},
      {"a row that is too long", "0 0 0\n1 0 0 0\n", {}, "f:2: 4 columns, and the first row has 3"},
      {"NaN",
       "0 0 0\nnan 0 0\n1 0 0\n0 1 .5\n",
       {},
       "f:2: not a finite number: 'nan'; --skip-invalid leaves such rows out"},
      {"NaN left out", "0 0 0\nnan nan nan\n1 0 0\n0 1 .5\ninf 0 0\n", kThree, "", {.skip_invalid = true}},
      {"a word", "0 0 0\none 0 0\n", {}, "f:2: not a number: 'one'"},
  };
}

std::vector<Example> clouds() {
  const std::string vertices = "0 0 0\n1 0 0\n0 1 .5\n";
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\nproperty double z\n";
  return {
      {"PTS", "3\n0 0 0 -1200 1 2 3\n1 0 0 -1200 1 2 3\n0 1 .5 -1200 1 2 3\n", kThree,
       "more than three columns; those after the third are ignored"},
      {"PTS of two scans", "1\n0 0 0\n2\n1 0 0\n0 1 .5\n", kThree, ""},
      {"PTS cut short", "4\n0 0 0\n1 0 0\n0 1 .5\n", {}, "f: 4 points announced, 3 found"},
      {"PTS and more",
       "2\n0 0 0\n1 0 0\n0 1 .5\n",
       {},
       "f:4: a count of rows is missing, or there are more rows than announced"},
      {"OFF", "OFF\n3 1 0\n" + vertices + "3 0 1 2\n", kThree, ""},
      {"OFF, counts on its line", "OFF 3 0 0\n" + vertices, kThree, ""},
      {"OFF, a glued count", "OFF3 0 0\n" + vertices, kThree, ""},
      {"OFF, one count", "OFF\n3\n" + vertices, kThree, ""},
      {"OFF with colours", "COFF\n3 0 0\n0 0 0 1 0 0 1\n1 0 0 1 0 0 1\n0 1 .5 1 0 0 1\n", kThree, ""},
      {"nOFF of dimension 3", "nOFF\n3 3 0 0\n" + vertices, kThree, ""},
      {"nOFF of dimension 4", "nOFF\n4 3 0 0\n0 0 0 0\n", {}, "f:2: points of 4 dimensions, not of 3"},
      {"4OFF", "4OFF\n1 0 0\n0 0 0 0\n", {}, "f:1: points of four dimensions: 4OFF"},
      {"OFF cut short", "OFF\n4 0 0\n" + vertices, {}, "f: 4 vertices announced, 3 found"},
      {"OFF with rows too many",
       "OFF\n2 0 0\n" + vertices,
       {},
       "f:5: a row after the 2 vertices and 0 faces that the header announces"},
      {"OBJ", "v 0 0 0\nv 1 0 0\nv 0 1 .5\nf 1 2 3\n", kThree, ""},
      {"OBJ, a line that goes on", "v 0 0 \\\n 0\nv 1 0 0\nv 0 1 .5\n", kThree, ""},
      {"OBJ, two numbers", "v 0 0\n", {}, "f:1: too few numbers: 2 of 3"},
      {"PLY", ply + "end_header\n" + vertices, kThree, ""},
      {"PLY, a type that is not known", ply + "property half q\nend_header\n0 0 0 1\n1 0 0 1\n0 1 .5 1\n", kThree, ""},
      {"PLY cut short", ply + "end_header\n0 0 0\n", {}, "f: 3 vertices announced, 1 found"},
      {"PLY, a row that is too long",
       ply + "end_header\n0 0 0\n1 0 0 0\n0 1 .5\n",
       {},
       "f:9: more values than properties: '0'"},
      {"PCD", pcd("ascii", "0 0 0 1\n1 0 0 1\n0 1 .5 1\n"), kThree, ""},
      {"PCD, binary", pcd("binary", pcd_bytes()), kThree,
       "the coordinates are single precision, and are taken exactly as such"},
      {"PCD, compressed",
       pcd("binary_compressed", pcd_bytes()),
       {},
       "f:11: compressed binary PCD is not read: write it as ascii or binary"},
      {"PCD cut short", pcd("binary", pcd_bytes().substr(0, 40)), {}, "f: 3 points announced, 2 found"},
      {"PCD, rows that are missing", pcd("ascii", "0 0 0 1\n"), {}, "f: 3 points announced, 1 found"},
      {"NPY", npy("<f8", "(3, 3)", numbers<double>(kInRows)), kThree, ""},
      {"NPY of integers", npy("|i1", "(1, 3)", std::string("\x01\x02\xfd")), {{1, 2, -3}}, ""},
      {"NPY by columns", npy("<f8", "(3, 3)", numbers<double>(kInColumns), "True"), kThree, ""},
      {"NPY, big-endian", npy(">f8", "(3, 3)", numbers<double>(kInRows, true)), kThree, ""},
      {"NPY of floats", npy("<f4", "(3, 3)", numbers<float>(kInRows)), kThree,
       "the coordinates are single precision, and are taken exactly as such"},
      {"NPY of another shape",
       npy("<f8", "(9,)", numbers<double>(kInRows)),
       {},
       "f: an array of shape '(9,)'; points have the shape (n, 3)"},
      {"NPY of two columns",
       npy("<f8", "(2, 2)", numbers<double>({0, 0, 1, 0})),
       {},
       "f: points of two coordinates: --z 0 makes their z 0"},
      {"NPY cut short", npy("<f8", "(4, 3)", numbers<double>(kInRows)), {}, "f: 4 points announced, 3 found"},
      {"NPY of complex numbers",
       npy("<c16", "(1, 3)", numbers<double>({0, 0, 0, 0, 0, 0})),
       {},
       "f: an array of type '<c16'; f4, f8 and integers are read"},
  };
}

std::vector<Example> molecules() {
  const std::string in_p1 = kCell + "_symmetry_space_group_name_H-M 'P 1'\n" + kFractional;
  const std::string one = pdb_atom("ATOM      1  CA  ", "ALA A   1    ", kOrigin),
                    two = pdb_atom("ATOM      2  CB  ", "ALA A   1    ", kX),
                    three = pdb_atom("ATOM      3  C   ", "ALA A   1    ", kY),
                    water = pdb_atom("HETATM    4  O   ", "HOH A   2    ", "   5.000   5.000   5.000  1.00 20.00", "O");
  const std::string glued = pdb_atom("ATOM      1  CA  ", "ALA A   1    ", "-100.000-200.000-300.000  1.00 20.00");
  return {
      {"chemical XYZ", "3\nthree atoms\nC 0 0 0\nH 1 0 0\n8 0 1 .5\n", kThree,
       "the 3 atoms include 1 hydrogen; --atoms \"no hydrogens\" leaves such out"},
      {"chemical XYZ, a comment that is a number", "3\n1\nC 0 0 0\nH 1 0 0\n8 0 1 .5\n", kThree,
       "the 3 atoms include 1 hydrogen; --atoms \"no hydrogens\" leaves such out"},
      {"chemical XYZ, an empty comment", "3\n\nC 0 0 0\nH 1 0 0\nO 0 1 .5\n", kThree,
       "the 3 atoms include 1 hydrogen; --atoms \"no hydrogens\" leaves such out"},
      {"chemical XYZ cut short", "4\nfour atoms\nC 0 0 0\nH 1 0 0\nO 0 1 .5\n", {}, "f: 4 atoms announced, 3 found"},
      {"chemical XYZ with an atom too many",
       "2\ntwo atoms\nC 0 0 0\nH 1 0 0\nO 0 1 .5\n",
       {},
       "f:5: a line that may be an atom, after all that the count announces"},
      {"chemical XYZ, frames",
       "1\na\nC 0 0 0\n1\nb\nC 1 0 0\n",
       {{0, 0, 0}},
       "the first of 2 frames is read; --frame says which"},
      {"chemical XYZ, a frame", "1\na\nC 0 0 0\n1\nb\nC 1 0 0\n", {{1, 0, 0}}, "", {.frame = 2}},
      {"chemical XYZ, a frame that is not there",
       "1\na\nC 0 0 0\n",
       {},
       "f: there is no frame 2; there is 1",
       {.frame = 2}},
      {"extended XYZ",
       "1\nProperties=id:I:1:species:S:1:pos:R:3 Lattice=\"5 0 0 0 5 0 0 0 5\"\n7 C 1 2 3\n",
       {{1, 2, 3}},
       "the lattice is ignored; the points are not periodic"},
      {"extended XYZ, an atom of too few columns",
       "1\nProperties=species:S:1:pos:R:3:f:R:3\nC 1 2 3 4\n",
       {},
       "f:3: 5 columns, and an atom has 7"},
      {"PTS or atoms",
       "3\n1 0 0 0\n6 1 0 0\n",
       {},
       "f: can be read in two ways, as a count with rows (--format pts) or with atoms (--format chemical)"},
      {"atoms without a count",
       "C 0 0 0\nH 1 0 0\n",
       {},
       "f: looks like atoms without a count above: --columns 2,3,4 reads the numbers"},
      {"atoms without a count, chosen", "C 0 0 0\nH 1 0 0\nO 0 1 .5\n", kThree, "", {.columns = "2,3,4"}},
      {"PDB", one + two + three + "END\n", kThree, ""},
      {"PDB without blanks between numbers", glued, {{-100, -200, -300}}, ""},
      {"PDB, a record in small letters",
       one + "atom" + two.substr(4),
       {},
       "f:2: a line that looks like an atom, but begins neither with ATOM nor with HETATM: 'atom      2 '"},
      {"PDB with water",
       one + two + three + water,
       {{0, 0, 0}, {1, 0, 0}, {0, 1, 0.5}, {5, 5, 5}},
       "the 4 atoms include 1 of water; --atoms \"no water\" leaves such out"},
      {"PDB without its water",
       one + two + three + water,
       kThree,
       "1 atom is not chosen by --atoms",
       {.atoms = {"no water"}}},
      {"PDB, a word that is none",
       one,
       {},
       "--atoms: no word for atoms: 'proteins please'; there are all, protein, nucleic, water, ligands, hydrogens, "
       "hetatm, chain X, each also after 'no', and altloc X, model X, with commas between: --atoms \"no water,no "
       "ligands\"",
       {.atoms = {"proteins please"}}},
      {"PDB, models",
       "MODEL 1\n" + one + "ENDMDL\nMODEL 2\n" + two + three + "ENDMDL\n",
       kThree,
       "",
       {.models = "all"}},
      {"PDB, a model that is not there",
       "MODEL 1\n" + one + "ENDMDL\n",
       {},
       "f: there is no model '3'; there are '1'",
       {.models = "3"}},
      {"mmCIF", kMmcif + "ATOM C ALA 0 0 0\nATOM C ALA 1 0 0\nATOM C ALA 0 1 0.5(2)\n", kThree, ""},
      {"CIF with fractional coordinates", in_p1 + "C1 0 0 0\nC2 0.1(1) 0 0\nC3 0 0.1 0.05\n", kThree, ""},
      {"CIF with a symmetry",
       kCell + "_symmetry_space_group_name_H-M 'P 21/c'\n" + kFractional + "C1 0 0 0\n",
       {},
       "f: fractional coordinates are read in P 1 alone, and this is 'P 21/c'"},
      {"CIF, no symmetry said",
       kCell + kFractional + "C1 0 0 0\n",
       {},
       "f: fractional coordinates are read in P 1 alone, and the symmetry is not said"},
      {"CIF, fractional without a cell",
       "data_x\n_space_group_IT_number 1\n" + kFractional + "C1 0 0 0\n",
       {},
       "f: fractional coordinates, and no cell: there is no length_a"},
      {"CIF cut short", kMmcif + "ATOM C ALA 0 0\n", {}, "f:9: the last row of the table _atom_site is not complete"},
  };
}

std::vector<Example> others() {
  return {
      {"STL", "solid a\nfacet normal 0 0 1\n", {}, "f: looks like STL, which is not read" + kReadFormats},
      {"NPZ", "PK\x03\x04", {}, "f: looks like a ZIP archive, as NPZ is, which is not read" + kReadFormats},
      {"LAS", "LASF", {}, "f: looks like LAS or LAZ, which is not read" + kReadFormats},
      {"MOL2", "@<TRIPOS>MOLECULE\n", {}, "f: looks like MOL2, which is not read" + kReadFormats},
      {"SDF",
       "water\n  program\n\n  3  2  0  0  0  0  0  0  0  0999 V2000\n",
       {},
       "f: looks like SDF or MOL, which is not read" + kReadFormats},
      {"GRO",
       "water\n    1\n    1SOL     OW    1   0.000   0.000   0.000\n",
       {},
       "f: looks like GRO, which is not read" + kReadFormats},
      {"PTX", "2\n2\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n", {}, "f: looks like PTX, which is not read" + kReadFormats},
      {"VTK",
       "# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\nPOINTS 1 float\n0 0 0\n",
       {},
       "f: looks like VTK, which is not read" + kReadFormats},
      {"JSON", "[[0,0,0]]", {}, "f: looks like JSON, which is not read" + kReadFormats},
      {"text", "Dear reader,\n", {}, "f: not a known format" + kReadFormats},
      {"bytes",
       std::string("\x01\x00\x02\x00 1 2 3", 10),
       {},
       "f: looks like binary data, which is not read" + kReadFormats},
  };
}

// What real programs and people write, and what must not be read as something else.
std::vector<Example> strange_tables() {
  const std::string by_number = "--columns says by number which are x, y, z";
  const std::string seems = "f:1: this seems to name columns, but not all of them: " + by_number;
  const std::string numbered =
      "f: 4 columns without names, of which the first may be numbers of the rows: --columns 2,3,4 takes the next "
      "three, --columns 1,2,3 the first";
  const std::string ignored = "more than three columns; those after the third are ignored";
  return {
      {"a name for each row, whole numbers with points", "1 0. 0. 0.\n2 1. 0. 0.\n", {}, numbered},
      {"TetGen's nodes", "2 3 0 0\n1 0.0 0.0 0.0\n2 1.0 0.0 0.0\n", {}, numbered},
      {"a name for each row of PTS", "2\n1 0.5 1.5 2.5\n2 3.5 4.5 5.5\n", {}, numbered},
      {"names for rows of PTS, chosen",
       "2\n1 0.5 1.5 2.5\n2 1 2 3\n",
       {{0.5, 1.5, 2.5}, {1, 2, 3}},
       "",
       {.columns = "2,3,4"}},
      {"an infinity of Microsoft's", "0.5 0.25 1.#INF\n", {}, "f:1: not a number: '1.#INF'"},
      {"a trajectory", "# timestamp tx ty tz qw\n0.5 1 2 3 4\n", {}, seems},
      {"names with units", "# t[s] x[m] y[m] z[m]\n9 0 0 0\n9 1 0 0\n9 0 1 .5\n", kThree, ""},
      {"names with units, the other way", "# z[m] y[m] x[m]\n0 0 0\n0 0 1\n.5 1 0\n", kThree, ""},
      {"names in a sentence, the other way", "# z, y, x in meters\n0 0 0\n", {}, seems},
      {"names in a sentence", "# sampled at x, y and z\n0 0 0\n1 0 0\n0 1 .5\n", kThree, ""},
      {"names behind a word", "# columns: t x y z\n9 0 0 0\n9 1 0 0\n9 0 1 .5\n", kThree, ""},
      {"names of the first three behind a word", "# Points: x y z\n0 0 0 7\n1 0 0 7\n0 1 .5 7\n", kThree, ignored},
      {"names of two words", "Point ID,X,Y,Z\n9,0,0,0\n9,1,0,0\n9,0,1,.5\n", kThree, ""},
      {"names of two words in a comment", "# scan pos,X,Y,Z\n9,0,0,0\n9,1,0,0\n9,0,1,.5\n", kThree, ""},
      {"names between tabs, the first empty", "\tx\ty\tz\n9\t0\t0\t0\n9\t1\t0\t0\n9\t0\t1\t.5\n", kThree, ""},
      {"one name too many", "x y z w\n0 0 0\n", {}, "f:2: 3 columns, and 4 names above: " + by_number},
      {"names with a comma too many", "x,y,z,\n0,0,0\n1,0,0\n0,1,.5\n", kThree, ""},
      {"names behind a mark of TeX", "% x y z\n0 0 0\n1 0 0\n0 1 .5\n", kThree, ""},
      {"names in two comments", "# x y z\n# z y x\n0 0 0\n", {}, "f:2: two comments above name columns: " + by_number},
      {"two comments, chosen", "# x y z\n# z y x\n0 0 0\n1 0 0\n0 1 .5\n", kThree, "", {.columns = "1,2,3"}},
      {"names for rows, as R writes them",
       "\"x\" \"y\" \"z\"\n\"1\" 0 0 0\n",
       {},
       "f:2: 4 columns, and 3 names above: " + by_number},
      {"names for rows, chosen",
       "\"x\" \"y\" \"z\"\n\"1\" 0 0 0\n\"2\" 1 0 0\n\"3\" 0 1 .5\n",
       kThree,
       "",
       {.columns = "2,3,4"}},
      {"a title, chosen", "my points\n0 0 0\n1 0 0\n0 1 .5\n", kThree, "", {.columns = "1,2,3"}},
      {"two names", "x,y\n0.5,1.5\n", {}, "f:2: columns x and y, and none named z: --z 0 makes it 0"},
      {"two names and a third coordinate", "y,x\n0.5,1.5\n", {{1.5, 0.5, 0}}, "", {.z = 0}},
      {"three names and a third coordinate",
       "x y z\n0 0 0\n",
       {},
       "f:2: --z is for two columns, and one of these is named z",
       {.z = 0}},
      {"names that are numbers",
       "0,1,2\n0.5,1.5,2.5\n1.25,2.25,3.25\n",
       {},
       "f: the first row is 0,1,2, as some programs name columns: leave it out if it is no point"},
      {"decimal commas, and blanks behind others",
       "0,5, 1,5, 2,5\n",
       {},
       "f:1: a comma between digits, and blanks alone between other numbers: is it a decimal point?"},
      {"a label of two words",
       "P 0 0 0\nP 2 1 0 0\n",
       {},
       "f:2: 5 columns, and the first row has 4",
       {.columns = "2,3,4"}},
      {"a last name of two words",
       "X,Y,Z,Scalar field\n0,0,0,1\n1,0,0\n",
       {},
       "f:3: 3 columns, and the first row has 4"},
      {"names that are words of other formats", "MODEL X Y Z\n9 0 0 0\n9 1 0 0\n9 0 1 .5\n", kThree, ""},
      {"names that look like a block of CIF", "data_id,x,y,z\n9,0,0,0\n9,1,0,0\n9,0,1,.5\n", kThree, ""},
      {"Tecplot", "TITLE = \"a\"\n", {}, "f: looks like Tecplot, which is not read" + kReadFormats},
  };
}

std::vector<Example> strange_clouds() {
  const std::string xyz = "property double x\nproperty double y\nproperty double z\nend_header\n";
  const std::string two = "element vertex 2\n", three = "element vertex 3\n", rows = "0 0 0\n1 0 0\n0 1 .5\n";
  const std::string ascii = "ply\nformat ascii 1.0\n", binary = "ply\nformat binary_little_endian 1.0\n";
  const std::string large = bytes_of(std::int64_t{9007199254740993}, false) + std::string(16, '\0');
  return {
      {"CloudCompare's names and count", "//X Y Z\n3\n" + rows, kThree, ""},
      {"CloudCompare's count and names", "3\n//X Y Z\n" + rows, kThree, ""},
      {"PTS with names, and atoms by number",
       "2\nX Y Z I\n1 2 3 40\n2 3 4 50\n",
       {},
       "f: begins with a count, but neither rows of numbers follow, as in PTS, nor a comment and atoms, as in chemical "
       "XYZ"},
      {"PTS with a count too small, or atoms by number",
       "3\n1 2 3 40\n4 5 6 50\n7 8 9 60\n10 11 12 70\n",
       {},
       "f: can be read in two ways, as a count with rows (--format pts) or with atoms (--format chemical)"},
      {"PLY with rows too many", ascii + two + xyz + rows, {}, "f:10: a line after all rows announced"},
      {"PLY with bytes too many",
       binary + two + xyz + numbers<double>(kInRows),
       {},
       "f: there are more bytes than rows announced"},
      {"PLY with padding", binary + three + xyz + numbers<double>(kInRows) + std::string(5, '\0'), kThree, ""},
      {"PCD with bytes too many", pcd("binary", pcd_bytes(), "2"), {}, "f: there are more bytes than rows announced"},
      {"OFF with a vertex too many", "OFF\n2 1 0\n0 0 0\n1 0 0\n0.5 1 0\n", {}, "f:5: not a count: '0.5'"},
      {"OFF with a face too short", "OFF\n3 1 0\n" + rows + "3 0 1\n", {}, "f:6: a face lacks vertices"},
      {"OFF, MeshLab's keyword", "NCOFF\n1 0 0\n0 1 .5 0 0 1 9 9 9 9\n", {{0, 1, 0.5}}, ""},
      {"OFF in small letters", "off\n3 0 0\n" + rows, kThree, ""},
      {"OFF with an infinity of Microsoft's", "OFF\n1 0 0\n0 0 -1.#IND\n", {}, "f:3: not a number: '-1.#IND'"},
      {"OBJ without vertices", "0 0 0\n", {}, "f: no line begins with v", {.format = "obj"}},
      {"NPY with an integer that is no double", npy("<i8", "(1, 3)", large), {}, "f: row 0: not exactly a double"},
  };
}

std::vector<Example> strange_molecules() {
  const auto atom = [](const std::string& start, const std::string& residue, const std::string& numbers) {
    return pdb_atom(start, residue, numbers + "  1.00 20.00");
  };
  const std::string ca = "ATOM      1  CA  ", ca_a = "ATOM      1  CA A", ca_b = "ATOM      2  CA B";
  const std::string origin = "   0.000   0.000   0.000", x = "   1.000   0.000   0.000";
  const std::string triclinic =
      "data_x\n_cell_length_a 7\n_cell_length_b 8\n_cell_length_c 9\n_cell_angle_alpha 70\n_cell_angle_beta 80\n"
      "_cell_angle_gamma 100\n";
  const std::string operations = "loop_\n_space_group_symop_operation_xyz\n'x, y, z'\n'-x, -y, -z'\n";
  const std::string groups =
      "_space_group_IT_number 1\nloop_\n_atom_site_label\n_atom_site_disorder_group\n_atom_site_fract_x\n"
      "_atom_site_fract_y\n_atom_site_fract_z\n";
  const std::string first = "of an atom with alternate locations the first is read; ";
  return {
      {"PDB, a blank in a number",
       atom(ca, "GLY A  69    ", "  1 8.423  12.396   3.087"),
       {},
       "f:1: columns 31 to 54 cut a number, and no other places of the coordinates are certain"},
      {"PDB, numbers without a blank, and not at the ends of columns",
       atom(ca, "GLY A  69    ", "  10.000-20.000 -300.000"),
       {},
       "f:1: columns 31 to 54: no blank parts two numbers, and they do not end where columns end"},
      {"PDB, a number below -1000",
       atom(ca, "ALA A   1    ", "-1234.567 123.456  12.345"),
       {{-1234.567, 123.456, 12.345}},
       ""},
      {"PDB, a residue number of five digits",
       atom("HETATM    1  O   ", "HOH  10000    ", origin),
       {{0, 0, 0}},
       "the 1 atoms include 1 of water; --atoms \"no water\" leaves such out"},
      {"PDB, a serial that moves nothing",
       atom("ATOM  100000 CA  ", "ALA     1    ", origin),
       {{0, 0, 0}},
       "",
       {.atoms = {"protein"}}},
      {"PDB, selenomethionine", atom(ca, "MSE A   1    ", origin), {{0, 0, 0}}, "", {.atoms = {"protein"}}},
      {"PDB, residues in small letters", atom(ca, "ala A   1    ", origin), {{0, 0, 0}}, "", {.atoms = {"protein"}}},
      {"PDB, one residue of two kinds",
       atom(ca_a, "SER A   1    ", origin) + atom(ca_b, "THR A   1    ", x) +
           atom("ATOM      3  CG2B", "THR A   1    ", x),
       {{0, 0, 0}},
       first + "2 others are left out"},
      {"PDB, a location without a name",
       atom(ca, "SER A   1    ", origin) + atom(ca_b, "SER A   1    ", x),
       {{0, 0, 0}},
       first + "1 other is left out"},
      {"chemical XYZ, a row that is too long",
       "2\n\nC 0 0 0\nC 1 0 0 0\n",
       {},
       "f:4: 5 columns, and the first atom has 4"},
      {"extended XYZ in small letters",
       "1\nenergy=1;properties = species:S:1:f:R:3:pos:R:3\nC 9 9 9 1 2 3\n",
       {{1, 2, 3}},
       ""},
      {"chemical XYZ without hydrogens",
       "3\n\nh 9 9 9\nHW1 9 9 9\nHg 1 2 3\n",
       {{1, 2, 3}},
       "2 atoms are not chosen by --atoms",
       {.atoms = {"no hydrogens"}}},
      {"CIF with angles",
       triclinic + "_space_group_IT_number 1\n" + kFractional + "C1 0.25 0.5 0.75\n",
       {{2.2275324885840586, 6.490158707948766, 6.138516955060858}},
       ""},
      {"CIF with an operation",
       kCell + operations + kFractional + "C1 0 0 0\n",
       {},
       "f: fractional coordinates are read in P 1 alone, and this has the symmetry '-x,-y,-z'"},
      {"CIF with three groups",
       kCell + groups + "C1 1 0 0 0\nC2 2 .1 0 0\nC3 3 .2 0 0\n",
       {},
       "f:17: disorder groups without assemblies: --atoms \"altloc N\" or \"altloc all\" says which are read"},
  };
}

TEST(PointExamples, RowsLeftOutAreCountedFromZero) {
  CITES("FC-FILE-45");
  const std::string rows = "0 0 0\nnan 0 0\n1 0 0\ninf 0 0\n";
  const std::vector<std::size_t> left_out = {1, 3};
  EXPECT_EQ(read_points_from(rows, "f", {.skip_invalid = true}).left_out, left_out);
  const std::vector<double> values = {0, 0, 0, NAN, 0, 0, 1, 0, 0, INFINITY, 0, 0};
  EXPECT_EQ(read_points_from(npy("<f8", "(4, 3)", numbers<double>(values)), "f", {.skip_invalid = true}).left_out,
            left_out);
}

void expect_as_described(const Example& example) {
  SCOPED_TRACE(example.what);
  std::string said;
  Rows rows;
  try {
    const PointFile file = read_points_from(example.text, "f", example.options);
    rows = file.rows;
    for (const std::string& note : notes_of(file)) said += (said.empty() ? "" : "\n") + note;
  } catch (const InvalidInput& error) {
    said = error.what();
  }
  EXPECT_EQ(rows, example.rows);
  EXPECT_EQ(said, example.said);
}

TEST(PointExamples, AreReadOrRefusedAsDescribed) {
  CITES("FC-IN-01", "FC-IN-02", "FC-IN-05", "FC-FILE-01", "FC-FILE-02", "FC-FILE-38", "FC-FILE-39", "FC-FILE-40",
        "FC-FILE-41", "FC-FILE-42", "FC-FILE-43", "FC-FILE-45", "FC-FILE-46");
  for (const auto& examples :
       {tables(), strange_tables(), clouds(), strange_clouds(), molecules(), strange_molecules(), others()}) {
    for (const Example& example : examples) expect_as_described(example);
  }
}

}  // namespace
}  // namespace flowcert::point_examples_test
