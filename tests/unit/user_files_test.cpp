// Files as users have them, which were read wrongly once or refused: what is read now is what they say.
//
// tests/inputs/ has them. Facts of published files are rebuilt in them; nothing is copied. They are read by their paths
// and, without one, by their content alone.
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <set>

#include "io/input_bytes.h"
#include "tests/cites.h"
#include "tests/unit/point_file_samples.h"

namespace flowcert::user_files_test {
namespace {

struct UserFile {
  const char* format;
  Rows rows;
  Notes notes;
  ReadingOptions options = {};
};

const Rows kTetrahedron = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

Rows with(Rows rows, const Point& last) {
  rows.push_back(last);
  return rows;
}

std::map<std::string, UserFile> small_files() {
  return {
      {"serial_in_column_6.pdb", {"pdb", with(with(kTetrahedron, {1, 1, 1}), {2, 2, 2}), {}}},
      {"coordinates_over_columns.pdb",
       {"pdb",
        {{31256.965, 32685.064, 60403.930},
         {31257.488, 32684.459, 60405.148},
         {31257.420, 32682.938, 60405.070},
         {31256.300, 32682.430, 60404.170},
         {31258.700, 32684.920, 60405.370}},
        {}}},
      {"serial_shifts_line.pdb",
       {"pdb",
        {{1000.123, 1200.456, 1300.789},
         {1001.523, 1200.456, 1300.789},
         {1000.123, 1201.856, 1300.789},
         {1000.123, 1200.456, 1302.189}},
        {}}},
      {"colmap_points3D.txt",
       {"table",
        {{2511673.6174896946, 1438633.7145349307, 5664733.7249137033},
         {2511666.3578093471, 1438642.1278939964, 5664735.1046567764},
         {2511684.153320163, 1438613.6351842196, 5664733.8963125348},
         {2511687.5584940584, 1438650.2878824188, 5664723.3419733597},
         {2511670.5, 1438630.25, 5664729.125}},
        {}}},
      {"chemical.xyz",
       {"chemical",
        {{0, 0, 1.2e-16},
         {1.56, 0, -7.22293142224e-06},
         {-1.56, 0, 7.2e-06},
         {0, 1.56, 0},
         {0, -1.56, 0},
         {0, 0, 1.56},
         {0, 0, -1.56}},
        {}}},
      {"extended.xyz",
       {"chemical",
        {{0, 0, 0}, {1.4, 0, 0}, {0, 1.4, 0}, {0, 0, 1.4}},
        {"the lattice is ignored; the points are not periodic"}}},
      {"qm9_methane.xyz",
       {"chemical",
        {{-0.0126981359, 1.0858041578, 0.0080009958},
         {0.002150416, -0.0060313176, 0.0019761204},
         {1.0117308433, 1.4637511618, 2.765748e-4},
         {-0.540815069, 1.4475266138, -0.8766437152},
         {-0.5238136345, 1.4379326443, 0.9063972942}},
        {"3 lines after the atoms are ignored",
         "the 5 atoms include 4 hydrogens; --atoms \"no hydrogens\" leaves such out"}}},
      {"cloud.pcd", {"pcd", with(kTetrahedron, {1, 1, 1}), {}}},
      {"short_lines.pqr",
       {"pqr",
        {{1.5, 2.25, -3}, {2.5, 2.25, -3}, {-1e-3, 0.5, 12.125}},
        {"the 3 atoms include 1 hydrogen, 1 of ligands; --atoms \"no hydrogens,no ligands\" leaves all of these out"}}},
      {"leica.pts",
       {"pts",
        {{0.5, 0.5, 0.5}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}},
        {"more than three columns; those after the third are ignored"}}},
      {"cloudcompare.asc", {"table", kTetrahedron, {}}},
      {"glued_header.off",
       {"off", {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}, {}}},
      {"nOFF.off", {"off", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 1}}, {}}},
      {"nan_rows.ply",
       {"ply",
        with(kTetrahedron, {1, 1, 1}),
        {"declared as float, but decimals: taken as the nearest doubles, not floats"},
        {.skip_invalid = true}}},
  };
}

std::string path_of(const std::string& name) { return FLOWCERT_USER_INPUTS "/" + name; }

TEST(UserFiles, AreReadAsTheyMean) {
  CITES("FC-IN-02", "FC-IN-05", "FC-FILE-01", "FC-FILE-02");
  for (const auto& [name, expected] : small_files()) {
    SCOPED_TRACE(name);
    const PointFile file = read_points(path_of(name), expected.options);
    EXPECT_EQ(file.format, expected.format);
    EXPECT_EQ(file.rows, expected.rows);
    EXPECT_EQ(notes_of(file), expected.notes);
    EXPECT_EQ(rows_of(io::read_bytes(path_of(name)), "f", expected.options), expected.rows);
  }
}

TEST(UserFiles, LargeOnesHaveAllOfTheirPoints) {
  CITES("FC-IN-02");
  const PointFile cage = read_points(path_of("cage.xyz"));
  EXPECT_EQ(cage.format, "chemical");
  EXPECT_EQ(cage.rows.size(), 168U);
  EXPECT_EQ(cage.rows.front(), (Point{11.496, 13.515, 17.91}));
  const PointFile barrel = read_points(path_of("barrel.pdb"));
  EXPECT_EQ(barrel.format, "pdb");
  EXPECT_EQ(barrel.rows.size(), 129U);
  EXPECT_EQ(barrel.rows[1], (Point{5.406, 2.603, 0}));
  const PointFile cap = read_points(path_of("open_cap.xyz"));
  EXPECT_EQ(cap.format, "table");
  EXPECT_EQ(cap.rows.size(), 382U);
  const PointFile ligand = read_points(path_of("ligand_and_water.pdb"));
  EXPECT_EQ(ligand.rows.size(), 34U);
  EXPECT_EQ(
      notes_of(ligand),
      Notes{"the 34 atoms include 1 of ligands, 1 of water; --atoms \"no ligands,no water\" leaves all of these out"});
}

TEST(UserFiles, AllOfThemAreTriedHere) {
  std::set<std::string> names = {"cage.xyz", "barrel.pdb", "open_cap.xyz", "ligand_and_water.pdb"};
  for (const auto& [name, file] : small_files()) names.insert(name);
  std::set<std::string> found;
  for (const auto& entry : std::filesystem::directory_iterator(FLOWCERT_USER_INPUTS)) {
    found.insert(entry.path().filename().string());
  }
  EXPECT_EQ(found, names);
}

}  // namespace
}  // namespace flowcert::user_files_test
