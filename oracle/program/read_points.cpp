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

}  // namespace

// ---- Words ----

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

// ---- Formats ----

namespace {

using Lines = std::vector<std::string>;
using Rows = std::vector<std::array<double, 3>>;

std::string place(const std::string& name, std::size_t line) { return name + ":" + std::to_string(line + 1) + ": "; }

// OBJ knows no commas.
Lines blank_separated(const std::string& line) {
  std::istringstream in(line);
  Lines words;
  for (std::string word; in >> word;) words.push_back(word);
  return words;
}

std::string lower_case(std::string text) {
  for (char& c : text) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return text;
}

// Whether a heading or a comment above the rows names columns x, y and z.
bool names_columns(const Lines& words) {
  const auto has = [&](const char* name) {
    return std::any_of(words.begin(), words.end(), [&](const std::string& word) { return lower_case(word) == name; });
  };
  return has("x") && has("y") && has("z");
}

// They have to be the columns that the oracle reads.
void check_names(const Lines& words, const std::string& where) {
  if (words.size() == 3 && lower_case(words[0] + words[1] + words[2]) == "xyz") return;
  throw UnusableInput(where + "columns are named; flowcert-oracle reads x, y, z alone");
}

// A comma between two numbers, where blanks part others, might be a decimal point.
std::array<double, 3> table_row(const std::string& text, const Lines& words, const std::string& where) {
  if (words.size() != 3) {
    throw UnusableInput(where + "three columns expected, found " + std::to_string(words.size()));
  }
  const auto commas = std::count(text.begin(), text.end(), ',');
  if (commas != 0 && commas != 2) throw UnusableInput(where + "commas part some columns, and blanks others");
  return {number(words[0], where), number(words[1], where), number(words[2], where)};
}

// Where a comment begins. In 1.#INF there is none, and a line with a carriage return inside may be two.
std::size_t comment_in(const std::string& line, const std::string& where) {
  const std::size_t at = std::min(line.find('#'), line.size());
  if (at > 0 && at < line.size() && line[at - 1] == '.') throw UnusableInput(where + "a # behind a point");
  const std::size_t last = line.find_last_not_of('\r');
  if (last != std::string::npos && line.find('\r') < last) {
    throw UnusableInput(where + "a carriage return inside of a line");
  }
  return at;
}

Rows read_table(const Lines& lines, const std::string& name) {
  Rows points;
  bool has_heading = false;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const std::size_t comment = comment_in(lines[k], place(name, k));
    const std::string text = lines[k].substr(0, comment);
    const Lines words = fields(text);
    if (words.empty()) {
      const Lines said = fields(lines[k].substr(std::min(comment + 1, lines[k].size())));
      if (points.empty() && names_columns(said)) check_names(said, place(name, k));
    } else if (points.empty() && !has_heading && names_columns(words)) {
      check_names(words, place(name, k));
      has_heading = true;
    } else {
      points.push_back(table_row(text, words, place(name, k)));
    }
  }
  return points;
}

Rows read_obj(const Lines& lines, const std::string& name) {
  static const Lines keywords = {"v", "vt", "vn", "f", "l", "p", "o", "g", "s", "mtllib", "usemtl"};
  Rows points;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const std::string where = place(name, k);
    const Lines words = blank_separated(lines[k].substr(0, comment_in(lines[k], where)));
    if (words.empty()) continue;
    if (std::find(keywords.begin(), keywords.end(), words[0]) == keywords.end()) {
      throw UnusableInput(where + "flowcert-oracle does not know '" + words[0] + "' in OBJ");
    }
    if (words.back().back() == '\\') throw UnusableInput(where + "flowcert-oracle reads no line that goes on");
    if (words[0] != "v") continue;
    if (words.size() < 4) {
      throw UnusableInput(where + "three numbers expected, found " + std::to_string(words.size() - 1));
    }
    points.push_back({number(words[1], where), number(words[2], where), number(words[3], where)});
  }
  if (points.empty()) throw UnusableInput(name + ": no line begins with v");
  return points;
}

}  // namespace

std::vector<std::array<double, 3>> read_points(std::istream& in, const std::string& name, PointFormat format) {
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  if (in.bad()) throw UnusableInput(name + ": cannot be read");
  const auto is_blank = [](const std::string& line) { return line.find_first_not_of(kBlanks) == std::string::npos; };
  if (std::all_of(lines.begin(), lines.end(), is_blank)) throw UnusableInput(name + ": empty");
  return format == PointFormat::kObj ? read_obj(lines, name) : read_table(lines, name);
}

std::vector<std::array<double, 3>> read_point_file(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) throw UnusableInput(path + ": cannot be opened");
  return read_points(in, path, path.ends_with(".obj") ? PointFormat::kObj : PointFormat::kTable);
}

}  // namespace oracle
