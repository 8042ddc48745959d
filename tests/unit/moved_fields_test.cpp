// Fields of point files that are moved, cut or widened: what is read is the number that stands there, or a refusal,
// and never another one.
//
// Points are drawn and written in each text format, with the fields that usually stand around the coordinates. Then one
// coordinate's text is changed, or one blank is put in or taken out, as programs do whose numbers outgrow their columns
// and people who edit by hand. The test knows which numbers the file then has.
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <functional>
#include <random>
#include <regex>
#include <string>
#include <vector>

#include "flowcert/read_points.h"
#include "tests/cites.h"
#include "tests/run_scale.h"

namespace flowcert::moved_fields_test {
namespace {

using Engine = std::mt19937_64;
using Texts = std::vector<std::array<std::string, 3>>;

std::size_t below(Engine& engine, std::size_t count) { return static_cast<std::size_t>(engine() % count); }

// A number as its writer has it, in `width` columns if it fits.
std::string padded(const std::string& text, std::size_t width) {
  return text.size() < width ? std::string(width - text.size(), ' ') + text : text;
}

// How a format writes a point: what stands before the coordinates, each of them, and what comes after.
struct Format {
  const char* name;
  const char* before_all;
  std::function<std::string(std::size_t)> before;
  const char* between;
  std::size_t width;
  const char* after;
  const char* after_all;
  int decimals;
};

std::string atom(std::size_t k) {
  std::array<char, 64> text{};
  static constexpr std::array<const char*, 4> kNames = {" N  ", " CA ", "HG11", " O  "};
  std::snprintf(text.data(), text.size(), "ATOM  %5zu %4s ALA A%4zu    ", k + 1, kNames[k % 4], k / 4 + 1);
  return text.data();
}
std::string long_serial(std::size_t k) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "ATOM  %6zu  CA  ALA A%4zu    ", k + 100000, k + 1);
  return text.data();
}
std::string nothing(std::size_t) { return ""; }

std::vector<Format> formats() {
  const char* const cif =
      "data_x\nloop_\n_atom_site.group_PDB\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\n"
      "_atom_site.occupancy\n";
  return {
      {"table", "", nothing, " ", 0, "\n", "", 6},
      {"table with columns", "# x y z r g b\n", nothing, " ", 0, " 1 2 3\n", "", 4},
      {"csv", "x,y,z\n", nothing, ",", 0, "\n", "", 5},
      {"csv with names", "id,x,y,z,q\n", [](std::size_t k) { return std::to_string(k) + ","; }, ",", 0, ",0.5\n", "",
       3},
      {"semicolons", "", nothing, ";", 0, "\n", "", 3},
      {"pts", "6\n", nothing, " ", 0, " -1200\n", "", 3},
      {"chemical", "6\na comment\n", [](std::size_t) { return std::string("C "); }, " ", 12, "\n", "", 6},
      {"off", "OFF\n6 0 0\n", nothing, " ", 0, "\n", "", 3},
      {"obj", "o a\n", [](std::size_t) { return std::string("v "); }, " ", 0, "\n", "", 3},
      {"pcd",
       "VERSION .7\nFIELDS x y z i\nSIZE 4 4 4 4\nTYPE F F F F\nCOUNT 1 1 1 1\nWIDTH 6\nHEIGHT 1\nPOINTS 6\nDATA "
       "ascii\n",
       nothing, " ", 0, " 0.5\n", "", 3},
      {"ply",
       "ply\nformat ascii 1.0\nelement vertex 6\nproperty double x\nproperty double y\nproperty double z\n"
       "property uchar red\nend_header\n",
       nothing, " ", 0, " 7\n", "", 3},
      {"cif", cif, [](std::size_t) { return std::string("ATOM "); }, " ", 0, " 1.00\n", "", 3},
      {"pdb", "", atom, "", 8, "  1.00 20.00           C\n", "END\n", 3},
      {"pdb, bare", "", atom, "", 8, "\n", "", 3},
      {"pdb, long serials", "", long_serial, "", 8, "  1.00 20.00           C\n", "END\n", 3},
  };
}

// Texts of coordinates: some fill all of the columns.
Texts drawn(Engine& engine, const Format& format) {
  static constexpr std::array<double, 4> kScales = {9, 99, 999, 9999};
  Texts texts(6);
  for (auto& point : texts) {
    for (std::string& text : point) {
      const double scale = kScales[below(engine, format.width == 8 ? 4 : 3)];
      const double value = scale * (static_cast<double>(below(engine, 2000001)) / 1e6 - (scale > 1000 ? 0 : 1));
      std::array<char, 64> written{};
      std::snprintf(written.data(), written.size(), "%.*f", format.decimals, value);
      text = written.data();
      if (format.width == 8 && text.size() > 8) text = "1.000";
    }
  }
  return texts;
}

// One change of one coordinate: its text, and how many blanks are put before it (negative: taken away, where there are
// any).
struct Change {
  std::size_t row = 0, axis = 0;
  std::string text;
  int blanks = 0;
  bool keeps_columns = true;  // what comes after stays where it is, if there is room
};

Change drawn_change(Engine& engine, const Texts& texts) {
  Change change;
  change.row = below(engine, texts.size());
  change.axis = below(engine, 3);
  change.text = texts[change.row][change.axis];
  change.keeps_columns = below(engine, 2) == 0;
  const std::size_t size = change.text.size();
  switch (below(engine, 6)) {
    case 0:  // cut at its end
      change.text.resize(size - 1 - below(engine, size - 1));
      break;
    case 1:  // cut at its beginning
      change.text.erase(0, 1 + below(engine, size - 1));
      break;
    case 2:  // widened before the point
      change.text.insert(change.text.starts_with('-') ? 1 : 0, std::to_string(1 + below(engine, 99999)));
      break;
    case 3:  // widened behind it
      change.text += std::to_string(below(engine, 100));
      break;
    case 4:  // moved
      change.blanks = below(engine, 2) == 0 ? 1 : -1;
      break;
    default:  // taken away
      change.text.clear();
  }
  return change;
}

std::string written(const Format& format, const Texts& texts, const Change& change) {
  std::string file = format.before_all;
  for (std::size_t row = 0; row < texts.size(); ++row) {
    std::string line = format.before(row);
    std::size_t surplus = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (axis > 0) line += format.between;
      const std::string& text = texts[row][axis];
      const bool is_changed = row == change.row && axis == change.axis;
      if (!is_changed) {
        std::string field = padded(text, format.width);
        // What follows a wide field gives way as far as it has blanks.
        while (surplus > 0 && field.size() > text.size() + 0 && field.starts_with(' ')) {
          field.erase(0, 1);
          --surplus;
        }
        line += field;
        continue;
      }
      std::string field = change.keeps_columns
                              ? padded(change.text, format.width)
                              : std::string(padded(text, format.width).size() - text.size(), ' ') + change.text;
      if (change.blanks > 0) field.insert(0, 1, ' ');
      if (change.blanks < 0 && field.starts_with(' ')) field.erase(0, 1);
      line += field;
      if (change.keeps_columns && format.width > 0 && field.size() > format.width)
        surplus = field.size() - format.width;
    }
    file += line + format.after;
  }
  return file + format.after_all;
}

// The numbers that the file has, as far as its texts are numbers.
std::vector<std::array<double, 3>> numbers_of(const Texts& texts) {
  std::vector<std::array<double, 3>> numbers;
  for (const auto& point : texts) {
    auto& row = numbers.emplace_back();
    for (std::size_t axis = 0; axis < 3; ++axis) row[axis] = std::strtod(point[axis].c_str(), nullptr);
  }
  return numbers;
}

void expect_no_other_numbers(const Format& format, Engine& engine, std::size_t& accepted) {
  Texts texts = drawn(engine, format);
  const Change change = drawn_change(engine, texts);
  const std::string file = written(format, texts, change);
  texts[change.row][change.axis] = change.text;
  // Where no blank parts two numbers, PDB's end in three decimals. With more, the file says another number.
  const std::size_t decimals = change.text.size() - std::min(change.text.find('.'), change.text.size());
  if (format.width == 8 && decimals > 4 && std::regex_search(file, std::regex(change.text + "[0-9]"))) return;
  PointFile read;
  try {
    read = read_points_from(file, format.name);
  } catch (const InvalidInput&) {
    return;
  }
  ++accepted;
  const auto numbers = numbers_of(texts);
  ASSERT_EQ(read.rows.size(), numbers.size()) << file;
  EXPECT_NE(change.text, "") << file;
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    const Point& p = read.rows[k];
    EXPECT_EQ((std::array<double, 3>{p.x, p.y, p.z}), numbers[k]) << "row " << k << " of\n" << file;
  }
}

TEST(MovedFields, WhatIsReadStandsThere) {
  CITES("FC-IN-05", "FC-FILE-01", "FC-FILE-41");
  Engine engine(40);
  for (const Format& format : formats()) {
    SCOPED_TRACE(format.name);
    std::size_t accepted = 0;
    const auto files = static_cast<std::size_t>(1 + 7000 * std::min(1.0, flowcert_tests::scale_of_run()));
    for (std::size_t k = 0; k < files && !::testing::Test::HasFailure(); ++k) {
      expect_no_other_numbers(format, engine, accepted);
    }
    // Many changes leave a number, so a reader that refuses everything is no reader.
    EXPECT_GT(20 * accepted, files);
  }
}

}  // namespace
}  // namespace flowcert::moved_fields_test
