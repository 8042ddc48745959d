// One line at a time, one word at a time; a word is a number iff strtod consumes all of it.
//
// strtod rather than std::from_chars: the latter reports 1e-400 and 1e400 alike as out of range, but the
// first is 0 (FC-IN-02) and the second an error (FC-IN-01). It rounds to nearest, ties to even, reads
// hexadecimal floats, and its decimal point is the C locale's, which this program never changes.
#include "oracle/read_points.h"

#include <cmath>
#include <cstdlib>
#include <fstream>

namespace oracle {

namespace {

constexpr char kSeparators[] = " \t,\r\v\f";  // \r: files with CR LF ends of line

std::vector<std::string> words_before_comment(const std::string& line) {
  const std::string content = line.substr(0, line.find('#'));
  std::vector<std::string> words;
  std::size_t end = 0;
  for (;;) {
    const std::size_t begin = content.find_first_not_of(kSeparators, end);
    if (begin == std::string::npos) return words;
    end = content.find_first_of(kSeparators, begin);
    words.push_back(content.substr(begin, end == std::string::npos ? end : end - begin));
    if (end == std::string::npos) return words;
  }
}

double number(const std::string& word, const std::string& where) {
  char* end = nullptr;
  const double value = std::strtod(word.c_str(), &end);
  if (end != word.c_str() + word.size()) throw UnusableInput(where + "'" + word + "' is not a number");
  if (!std::isfinite(value)) throw UnusableInput(where + "'" + word + "' is not a finite double");
  return value;
}

}  // namespace

std::vector<std::array<double, 3>> read_points(std::istream& in, const std::string& name,
                                               PointFormat format) {
  std::vector<std::array<double, 3>> points;
  bool only_white_space = true;
  std::size_t line_number = 0;
  for (std::string line; std::getline(in, line);) {
    const std::string where = name + ":" + std::to_string(++line_number) + ": ";
    if (line.find_first_not_of(" \t\r\v\f") != std::string::npos) only_white_space = false;
    std::vector<std::string> words = words_before_comment(line);
    if (words.empty()) continue;
    if (format == PointFormat::kObj) {
      if (words[0] != "v") continue;
      words.erase(words.begin());
    }
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
