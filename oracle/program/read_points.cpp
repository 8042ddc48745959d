// Reads one line at a time, one word at a time. A word is a number iff strtod consumes all of it.
//
// std::from_chars is not used, because it reports 1e-400 and 1e400 alike as out of range. The first is 0 (FC-IN-02)
// and the second an error (FC-IN-01). strtod rounds to nearest, ties to even, and reads hexadecimal floats. Its
// decimal point is the C locale's, which this program never changes. strtod would also round a hexadecimal float, but
// FC-IN-02 asks for an error. This file checks that.
#include "oracle/program/read_points.h"

#include <algorithm>
#include <cfenv>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <utility>

namespace oracle {

namespace {

constexpr char kBlanks[] = " \t\r\v\f\n";  // \r: files with CR LF ends of line

double rounded(const std::string& word, int mode) {
  const int previous = std::fegetround();
  std::fesetround(mode);
  const double value = std::strtod(word.c_str(), nullptr);
  std::fesetround(previous);
  return value;
}

// For a word that strtod accepts. A number is a double iff rounding it up and rounding it down give the same.
bool is_inexact_hexadecimal(const std::string& word) {
  if (word.find_first_of("xX") == std::string::npos) return false;
  return rounded(word, FE_UPWARD) != rounded(word, FE_DOWNWARD);
}

// OBJ knows no commas.
std::vector<std::string> blank_separated(const std::string& line) {
  std::istringstream in(line);
  std::vector<std::string> words;
  for (std::string word; in >> word;) words.push_back(word);
  return words;
}

// "x,y,z", in any case. Further names of columns may follow.
bool names_columns(const std::vector<std::string>& words) {
  return words.size() >= 3 && (words[0] == "x" || words[0] == "X") && (words[1] == "y" || words[1] == "Y") &&
         (words[2] == "z" || words[2] == "Z");
}

}  // namespace

std::vector<std::string> fields(const std::string& line) {
  const auto skip_blanks = [&line](std::size_t at) {
    return std::min(line.find_first_not_of(kBlanks, at), line.size());
  };
  std::vector<std::string> words;
  bool after_comma = false;
  for (std::size_t at = skip_blanks(0); at < line.size() || after_comma;) {
    const std::size_t end = std::min(line.find_first_of(std::string(kBlanks) + ",", at), line.size());
    words.push_back(line.substr(at, end - at));
    at = skip_blanks(end);
    after_comma = at < line.size() && line[at] == ',';
    if (after_comma) at = skip_blanks(at + 1);
  }
  return words;
}

double number(const std::string& word, const std::string& where) {
  char* end = nullptr;
  const double value = std::strtod(word.c_str(), &end);
  if (word.empty() || end != word.c_str() + word.size()) throw UnusableInput(where + "'" + word + "' is not a number");
  if (!std::isfinite(value)) throw UnusableInput(where + "'" + word + "' is not a finite double");
  if (is_inexact_hexadecimal(word)) throw UnusableInput(where + "'" + word + "' is not exactly a double");
  return value;
}

std::vector<std::array<double, 3>> read_points(std::istream& in, const std::string& name, PointFormat format) {
  std::vector<std::array<double, 3>> points;
  bool only_white_space = true;
  bool is_first = true;
  std::size_t line_number = 0;
  for (std::string line; std::getline(in, line);) {
    const std::string where = name + ":" + std::to_string(++line_number) + ": ";
    if (line.find_first_not_of(" \t\r\v\f") != std::string::npos) only_white_space = false;
    const std::string text = line.substr(0, line.find('#'));
    std::vector<std::string> words = format == PointFormat::kObj ? blank_separated(text) : fields(text);
    if (words.empty()) continue;
    if (format == PointFormat::kObj) {
      if (words[0] != "v") continue;
      words.erase(words.begin());
    }
    if (std::exchange(is_first, false) && format == PointFormat::kXyz && names_columns(words)) continue;
    if (words.size() < 3) {
      throw UnusableInput(where + "three numbers expected, found " + std::to_string(words.size()));
    }
    points.push_back({number(words[0], where), number(words[1], where), number(words[2], where)});
  }
  if (in.bad()) throw UnusableInput(name + ": cannot be read");
  if (only_white_space) throw UnusableInput(name + ": empty");
  return points;
}

std::vector<std::array<double, 3>> read_point_file(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) throw UnusableInput(path + ": cannot be opened");
  return read_points(in, path, path.ends_with(".obj") ? PointFormat::kObj : PointFormat::kXyz);
}

}  // namespace oracle
