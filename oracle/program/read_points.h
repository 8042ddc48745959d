// Reads point files for the oracle: tables of the three columns x, y, z, and the vertices of OBJ (names ending in
// .obj).
//
// This is a second parser, written from spec/formats/points.md alone, so that a mistake in the fast program's readers
// cannot hide in both. It reads no other format, no compressed file, and no table of other columns: it refuses what it
// might read in another way than the fast program does. A file is read whole or not at all (FC-IN-05). Each number
// becomes the nearest double (FC-IN-02). Anything but a finite number is an error (FC-IN-01).
#pragma once

#include <array>
#include <istream>
#include <stdexcept>
#include <string>
#include <vector>

namespace oracle {

// Input that cannot be used. The message is one line: "FILE:LINE: reason" or "FILE: reason".
struct UnusableInput : std::runtime_error {
  using std::runtime_error::runtime_error;
};

enum class PointFormat { kTable, kObj };

// The fields of a table's line. Blanks separate them, or a comma with blanks around it. There is an empty field
// between two commas, and after a comma at the end. An empty field is no number.
std::vector<std::string> fields(const std::string& line);

// The double that a field means. `where` opens the message of an UnusableInput.
double number(const std::string& field, const std::string& where);

// `name` is for messages only.
std::vector<std::array<double, 3>> read_points(std::istream& in, const std::string& name, PointFormat format);

std::vector<std::array<double, 3>> read_point_file(const std::string& path);

}  // namespace oracle
