// A program in the middle, for tests of `flowcert generate | PROGRAM | flowcert verify`: answers each case by
// the fast implementation, in one of several formats, and is wrong on request.
//
//   answering_program FORM [FAULT NUMBER]...
//
// FORM is exchange, csv (exact), decimals, rounded (decimals of 8 digits), contacts (csv without positions),
// perturbed (csv, with an index-1 and an index-2 point for right triangles), giesen-kuehne (contact sets
// must be simplices; incidences are left out), or persistence pairs: pairs (exact) and diagram (lines of decimals).
// A FAULT is made at the case with that number in the stream:
// drop, index, unreadable, none (an answer without lines), refuse, skip, twice, other-id, stray, cut (ends in
// the answer).
#include <algorithm>
#include <charconv>
#include <cmath>
#include <iostream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "certify/pair_differences.h"
#include "flowcert/rational.h"
#include "flowcert/read_points.h"
#include "flowcert/write_stationary_points.h"

namespace {

using namespace flowcert;

struct Case {
  std::string id;
  PointSet points;
};

// The shortest decimal that reads back to the nearest double, or one of 8 digits. Empty where that overflows.
std::string decimal(const Rational& value, bool is_rounded) {
  const std::optional<double> nearest = nearest_double(value);
  if (!nearest) return "";
  char text[40];
  char* const end = text + sizeof(text);
  return {text, is_rounded ? std::to_chars(text, end, *nearest, std::chars_format::general, 8).ptr
                           : std::to_chars(text, end, *nearest).ptr};
}

// Every text has a slash, so that an integer is not taken for a decimal.
std::string fraction(const Rational& value) {
  const std::string text = to_text(value);
  return text.find('/') == std::string::npos ? text + "/1" : text;
}

std::string csv_line(const std::string& form, int index, const ExactSphere& sphere, std::span<const PointId> contact) {
  const auto number = [&](const Rational& value) {
    if (form == "contacts") return std::string();
    return form == "decimals" || form == "rounded" ? decimal(value, form == "rounded") : fraction(value);
  };
  std::vector<std::string> position;
  for (const Rational& coordinate : sphere.center) position.push_back(number(coordinate));
  // A coordinate that overflows leaves no position.
  if (std::find(position.begin(), position.end(), "") != position.end()) position.assign(3, "");
  std::string line = std::to_string(index);
  for (const std::string& coordinate : position) line.append(",").append(coordinate);
  line.append(",").append(number(sphere.squared_radius));
  for (const PointId id : contact) line.append(",").append(std::to_string(id));
  return line;
}

std::string giesen_kuehne_line(const ExactSphere& sphere, std::span<const PointId> contact) {
  std::string line;
  for (const PointId id : contact) line += std::to_string(id) + " ";
  std::ostringstream distance;
  distance.precision(17);
  distance << std::sqrt(*nearest_double(sphere.squared_radius));
  return line + "| " + distance.str() + " |";
}

// A symbolic perturbation turns a regular stationary point with three contacts, the centre of a right
// triangle, into two critical points: those of the hypotenuse and of the triangle.
void add_right_triangle(std::vector<std::string>& lines, const Case& one, std::span<const PointId> contact) {
  const ExactSphere sphere = exact_sphere(one.points, contact);
  for (std::size_t left_out = 0; left_out < contact.size(); ++left_out) {
    std::vector<PointId> side(contact.begin(), contact.end());
    side.erase(side.begin() + static_cast<std::ptrdiff_t>(left_out));
    if (exact_sphere(one.points, side).center == sphere.center) lines.push_back(csv_line("csv", 1, sphere, side));
  }
  lines.push_back(csv_line("csv", 2, sphere, contact));
}

// "0 0 1.25", or the same as a line of JSON.
std::string pair_line(const std::string& form, const ListedPair& pair) {
  if (form == "diagram") {
    const auto word = [](const Rational& value) { return decimal(value, false); };
    return std::to_string(pair.dimension) + ' ' + word(pair.birth) + ' ' + (pair.death ? word(*pair.death) : "inf");
  }
  const auto point = [](const Rational& value) { return R"({"squared_distance":")" + to_text(value) + R"("})"; };
  return R"({"dimension":)" + std::to_string(pair.dimension) + R"(,"birth":)" + point(pair.birth) + R"(,"death":)" +
         (pair.death ? point(*pair.death) : "null") + "}";
}

// One pair a line.
std::vector<std::string> pair_lines(const std::string& form, const FlowComplex& complex) {
  std::vector<std::string> lines;
  for (const ListedPair& pair : listed_pairs(complex)) lines.push_back(pair_line(form, pair));
  return lines;
}

// A list of JSON lines as one object.
void join_pairs(std::vector<std::string>& lines) {
  std::string object = R"({"pairs":[)";
  for (std::size_t k = 0; k < lines.size(); ++k) object += (k == 0 ? "" : ",") + lines[k];
  lines = {object + "]}"};
}

std::vector<std::string> lines_of(const std::string& form, const Case& one) {
  const FlowComplex complex(one.points);
  if (form == "pairs" || form == "diagram") return pair_lines(form, complex);
  const StationaryPoints& found = complex.stationary();
  std::vector<std::string> lines;
  if (form == "exchange") {
    std::stringstream text;
    write_stationary_points(text, complex);
    for (std::string line; std::getline(text, line);) lines.push_back(line);
    return lines;
  }
  if (form == "giesen-kuehne") lines.emplace_back("inf 3");
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (form == "perturbed" && found.index(i) == StationaryIndex{1, 2} && found.contact(i).size() == 3) {
      add_right_triangle(lines, one, found.contact(i));
    }
    if (!found.index(i).is_critical()) continue;
    const ExactSphere sphere = complex.sphere(i);
    lines.push_back(form == "giesen-kuehne" ? giesen_kuehne_line(sphere, found.contact(i))
                                            : csv_line(form, found.index(i).face_dimension, sphere, found.contact(i)));
  }
  return lines;
}

// Damages lines of csv.
void damage(std::vector<std::string>& lines, const std::string& fault) {
  if (fault == "none") lines.clear();
  if (lines.empty()) return;
  if (fault == "drop") lines.pop_back();
  if (fault == "index") lines.back().front() = lines.back().front() == '1' ? '2' : '1';
  if (fault == "unreadable") lines.back().insert(0, "saddle,");
}

// Returns false where the program ends here.
bool answer(const std::string& form, const Case& one, const std::string& fault) {
  if (fault == "skip") return true;
  if (fault == "refuse") {
    std::cout << "refused " << one.id << " too hard <for me>" << std::endl;
    return true;
  }
  if (fault == "stray") std::cout << "thinking about it" << std::endl;
  std::vector<std::string> lines = lines_of(form, one);
  damage(lines, fault);
  if (form == "pairs") join_pairs(lines);
  for (int time = 0; time < (fault == "twice" ? 2 : 1); ++time) {
    std::cout << "# here it is\n\nanswer " << (fault == "other-id" ? "0" : "") << one.id << '\n';
    for (const std::string& line : lines) std::cout << line << '\n';
    if (fault == "cut") return false;
    std::cout << "end" << std::endl;
  }
  return true;
}

// The library's own reader reads the numbers: every digit counts.
Case read_case(const std::string& head) {
  Case one;
  std::istringstream words(head);
  std::string word;
  std::size_t count = 0;
  words >> word >> one.id >> count;
  std::string text = "# points\n";
  for (std::string row; count > 0 && std::getline(std::cin, row); --count) text += row + '\n';
  one.points = PointSet(read_points_from(text, "case.xyz").rows);
  return one;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) return 2;
  std::map<std::size_t, std::string> faults;
  for (int k = 2; k + 1 < argc; k += 2) faults[std::stoul(argv[k + 1])] = argv[k];
  std::size_t place = 0;
  for (std::string line; std::getline(std::cin, line);) {
    if (!line.starts_with("case ")) continue;
    const auto fault = faults.find(place++);
    if (!answer(argv[1], read_case(line), fault == faults.end() ? "" : fault->second)) return 0;
  }
  return 0;
}
