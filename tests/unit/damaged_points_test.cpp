// Damaged point files: every format cut at every byte, and 10,000 files with bytes changed, inserted and deleted.
//
// A reader returns all rows or throws. A cut may leave a legal file: text whose last number just got shorter. The file
// does not show that, so the tests then ask only that the other rows are right.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "flowcert/read_points.h"
#include "tests/cites.h"
#include "tests/run_scale.h"
#include "tests/unit/point_file_samples.h"

namespace flowcert::damaged_points_test {
namespace {

enum class AfterCut {
  kAlwaysRefused,         // binary: the header says how much there is
  kRefusedOrAllRows,      // text that ends with ignored rows: they are counted
  kRefusedOrAPrefix,      // lines without a count: the last number may have become shorter
  kRefusedOrLastShorter,  // a count, and nothing after the points: all rows, the last number may be shorter
};

struct Seed {
  const char* name;
  std::string bytes;
  AfterCut after_cut;
};

std::vector<Seed> seeds() {
  const std::string rows = "1.25 -2 3e1\n0x1.8p1 5 6.75\n-7 8.5 9.125";
  const std::string atom = "ATOM      1  CA  ALA A   1    ";
  const std::string cif =
      "data_x\nloop_\n_atom_site.group_PDB\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\n";
  const std::string pcd =
      "VERSION 0.7\nFIELDS x y z\nSIZE 8 8 8\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 3\nHEIGHT 1\nPOINTS 3\nDATA ";
  std::string numbers;
  for (const double value : {1.25, -2.0, 30.0, 1.5, 5.0, 6.75, -7.0, 8.5, 9.125}) numbers += bytes_of(value, false);
  std::string header = "{'descr': '<f8', 'fortran_order': False, 'shape': (3, 3), }";
  header.append(117 - header.size(), ' ').append(1, '\n');
  const std::string npy = "\x93NUMPY" + std::string("\x01\x00\x76\x00", 4) + header + numbers;
  const std::string xyz = "property double x\nproperty double y\nproperty double z\n";
  return {
      {"a.xyz", "# points\n" + rows + "\n", AfterCut::kRefusedOrAPrefix},
      {"a.csv", "1.5,2,3\r\n4 , 5,6 # c\r\n", AfterCut::kRefusedOrAPrefix},
      {"b.csv", "id,x,y,z\n1,1.5,2,3\n2,4,5,6\n", AfterCut::kRefusedOrAPrefix},
      {"a.pts", "3\n" + rows, AfterCut::kRefusedOrLastShorter},
      {"b.xyz", "3\nthree atoms\nC 1.25 -2 3e1\nH 1.5 5 6.75\n8 -7 8.5 9.125\n", AfterCut::kRefusedOrLastShorter},
      {"c.xyz", "2\nProperties=species:S:1:pos:R:3:q:R:1\nC 1.25 -2 3e1 1\nH 1.5 5 6.75 1\n",
       AfterCut::kRefusedOrAllRows},
      {"a.pdb", atom + "   1.250  -2.000  30.000\n" + atom + "   1.500   5.000   6.750\nEND\n",
       AfterCut::kRefusedOrAPrefix},
      {"a.pqr", "ATOM 1 N ALA 1 1.25 -2 3e1 0.1 1.8\nATOM 2 CA ALA A 1 1.5 5 6.75 -0.1 2\nTER\n",
       AfterCut::kRefusedOrAPrefix},
      {"a.cif", cif + "ATOM 1.25 -2 3e1\nATOM 1.5 5 6.75\n", AfterCut::kRefusedOrAPrefix},
      {"a.pcd", pcd + "ascii\n" + rows, AfterCut::kRefusedOrLastShorter},
      {"b.pcd", pcd + "binary\n" + numbers, AfterCut::kAlwaysRefused},
      {"a.npy", npy, AfterCut::kAlwaysRefused},
      {"a.off", "OFF\n3 2 0\n" + rows + "\n3 0 1 2\n3 0 2 1\n", AfterCut::kRefusedOrAllRows},
      {"b.off", "NOFF 3 0 0 # c\n" + rows, AfterCut::kRefusedOrLastShorter},
      {"a.obj", "o a\nv 1.25 -2 3e1\nvn 0 0 1\nv 4 5 6.75 1\nf 1 2 3\n", AfterCut::kRefusedOrAPrefix},
      {"a.ply", ply_ascii(), AfterCut::kRefusedOrAllRows},
      {"b.ply", "ply\nformat ascii 1.0\nelement vertex 3\n" + xyz + "end_header\n" + rows,
       AfterCut::kRefusedOrLastShorter},
      {"c.ply", ply_binary<double>(false, "double"), AfterCut::kAlwaysRefused},
      {"d.ply", ply_binary<float>(true, "float"), AfterCut::kAlwaysRefused},
      {"a.xyz.gz", gzipped(rows), AfterCut::kAlwaysRefused},
      {"a.ply.gz", gzipped(ply_binary<std::int16_t>(true, "short")), AfterCut::kAlwaysRefused},
  };
}

void expect_honest_rows(const Seed& seed, const Rows& all, const Rows& rows, std::size_t cut) {
  SCOPED_TRACE(std::string(seed.name) + " cut at " + std::to_string(cut));
  EXPECT_NE(seed.after_cut, AfterCut::kAlwaysRefused);
  ASSERT_LE(rows.size(), all.size());
  if (seed.after_cut != AfterCut::kRefusedOrAPrefix) {
    ASSERT_EQ(rows.size(), all.size());
  }
  if (seed.after_cut == AfterCut::kRefusedOrAllRows) {
    EXPECT_EQ(rows, all);
  } else if (!rows.empty()) {
    const std::size_t last = rows.size() - 1;
    EXPECT_TRUE(std::equal(rows.begin(), rows.end() - 1, all.begin()));
    EXPECT_EQ(rows[last].x, all[last].x);
    EXPECT_EQ(rows[last].y, all[last].y);
  }
}

TEST(DamagedPoints, CutAnywhereAFileIsRefusedOrHonest) {
  CITES("FC-IN-05");
  for (const Seed& seed : seeds()) {
    const Rows all = rows_of(seed.bytes, seed.name);
    ASSERT_GE(all.size(), 2U) << seed.name;
    std::size_t refused = 0;
    for (std::size_t cut = 0; cut < seed.bytes.size(); ++cut) {
      try {
        expect_honest_rows(seed, all, rows_of(seed.bytes.substr(0, cut), seed.name), cut);
      } catch (const InvalidInput& error) {
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
        ++refused;
      }
    }
    EXPECT_GT(refused, 0U) << seed.name;
  }
}

// Bytes that mean something in one of the formats are likelier to get far than random ones.
const std::string kMeaningful = "0123456789.-+eExXp#,;:'\"_ \t\r\n\\vfninaOFFplyATOM\x1f\x8b\xff\x7f\x80";

std::string mutated(std::string bytes, std::mt19937_64& random) {
  const std::uint64_t changes = 1 + random() % 4;
  for (std::uint64_t k = 0; k < changes; ++k) {
    const std::size_t place = bytes.empty() ? 0 : random() % bytes.size();
    const char byte =
        random() % 2 == 0 ? kMeaningful[random() % kMeaningful.size()] : static_cast<char>(random() & 0xff);
    switch (random() % 4) {
      case 0:
        if (!bytes.empty()) bytes[place] = static_cast<char>(bytes[place] ^ (1 << random() % 8));
        break;
      case 1:
        if (!bytes.empty()) bytes[place] = byte;
        break;
      case 2:
        bytes.insert(place, 1 + random() % 3, byte);
        break;
      default:
        bytes.erase(place, 1 + random() % 5);
    }
  }
  return bytes;
}

TEST(DamagedPoints, DamagedFilesAreRefusedOrGiveFiniteRows) {
  CITES("FC-IN-01", "FC-IN-05");
  const std::vector<Seed> originals = seeds();
  std::mt19937_64 random(97);
  std::size_t refused = 0;
  const std::size_t rounds = flowcert_tests::is_whole_run() ? 100000 : 10000;
  for (std::size_t round = 0; round < rounds; ++round) {
    const Seed& seed = originals[round % originals.size()];
    const std::string bytes = mutated(seed.bytes, random);
    try {
      const Rows rows = rows_of(bytes, seed.name);
      EXPECT_LE(rows.size(), bytes.size());
      for (const Point& row : rows) {
        ASSERT_TRUE(std::isfinite(row.x) && std::isfinite(row.y) && std::isfinite(row.z)) << seed.name << " " << round;
      }
    } catch (const InvalidInput& error) {
      ASSERT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
      ++refused;
    }
  }
  // Both outcomes are frequent, so that the test covers both.
  EXPECT_GT(refused, rounds / 10);
  EXPECT_LT(refused, rounds * 9 / 10);
}

}  // namespace
}  // namespace flowcert::damaged_points_test
