#include "io/pdb_line.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "io/atom_selection.h"
#include "io/number_text.h"
#include "io/point_formats.h"

namespace flowcert::io {

namespace {

// Columns are counted from 1, as the format's description does.
constexpr std::size_t kAfterSerial = 12, kFirstCoordinate = 31, kWidth = 8;

char at(std::string_view line, std::size_t column) { return column <= line.size() ? line[column - 1] : ' '; }

std::string_view columns(std::string_view line, std::size_t first, std::size_t last) {
  if (first > line.size()) return {};
  return line.substr(first - 1, last - first + 1);
}

bool is_of_number(char c) { return is_digit(c) || c == '.'; }

bool has_three_decimals(std::string_view field) {
  const std::size_t point = field.find('.');
  return point != std::string_view::npos && field.size() == point + 4 && is_integer(field.substr(point + 1));
}

bool is_plain_number(std::string_view field) { return parse_number(field).is_number(); }

// ---- Coordinates ----

using Fields3 = std::array<std::string_view, 3>;

// A column is where a number of its own ends, and not inside of one. `left` is the field before it.
bool cuts_number(std::string_view line, std::size_t column, std::string_view left) {
  return is_of_number(at(line, column)) && is_of_number(at(line, column + 1)) && !has_three_decimals(left);
}

struct Coordinates {
  Fields3 fields;
  bool is_cut = false;      // a column's end is inside of a number
  bool is_missing = false;  // a field is blank, or no number
  [[nodiscard]] bool is_valid() const { return !is_cut && !is_missing; }
};

// By columns, moved to the right by `shift`.
Coordinates by_columns(std::string_view line, std::size_t shift) {
  Coordinates found;
  const std::size_t first = kFirstCoordinate + shift;
  const bool begins_before = is_of_number(at(line, first - 1)) || at(line, first - 1) == '-';
  found.is_cut = begins_before && is_of_number(at(line, first));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t start = first + kWidth * axis;
    found.fields[axis] = trimmed(columns(line, start, start + kWidth - 1));
    found.is_missing = found.is_missing || !is_plain_number(found.fields[axis]);
    found.is_cut = found.is_cut || cuts_number(line, start + kWidth - 1, found.fields[axis]);
  }
  return found;
}

// The numbers with a point. Between two without a blank, a sign or three decimals end the first.
std::vector<std::string_view> numbers_with_points(std::string_view line) {
  std::vector<std::string_view> numbers;
  for (const std::string_view word : words_of(columns(line, kAfterSerial, line.size()))) {
    const NumberText whole = parse_number(word);
    if (!whole.is_finite || (whole.fault == nullptr && word.find('.') != std::string_view::npos)) {
      numbers.push_back(word);
      continue;
    }
    std::string_view rest = word;
    std::vector<std::string_view> parts;
    while (!rest.empty()) {
      const std::size_t point = rest.find('.');
      if (point == std::string_view::npos) break;
      std::size_t end = point + 1;
      while (end < rest.size() && is_digit(rest[end])) ++end;
      if (end < rest.size() && rest[end] == '.') end = point + 4;  // three decimals, then the next number's digits
      if (end > rest.size() || !is_plain_number(rest.substr(0, end))) break;
      parts.push_back(rest.substr(0, end));
      rest.remove_prefix(end);
    }
    if (rest.empty()) {
      numbers.insert(numbers.end(), parts.begin(), parts.end());
    } else if (!numbers.empty()) {
      break;
    }
  }
  return numbers;
}

std::size_t last_column(std::string_view line, std::string_view field) {
  return static_cast<std::size_t>(field.data() + field.size() - line.data());
}

bool is_alone(std::string_view line, std::string_view field) {
  const std::size_t last = last_column(line, field);
  return is_blank(at(line, last - field.size())) && is_blank(at(line, last + 1));
}

// How far the numbers' ends are to the right of their columns' ends, if all of them are equally far.
std::optional<std::size_t> common_shift(std::string_view line, const Fields3& fields) {
  std::optional<std::size_t> shift;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t end = last_column(line, fields[axis]), expected = kFirstCoordinate + kWidth * (axis + 1) - 1;
    if (end < expected || (shift && end - expected != *shift)) return std::nullopt;
    shift = end - expected;
  }
  return shift;
}

// ---- The fields before the coordinates ----

// How far a serial of more than five digits reaches beyond column 11.
std::size_t overflow_of_serial(std::string_view line) {
  std::size_t column = 7;
  while (is_blank(at(line, column)) && column < kAfterSerial) ++column;
  const std::size_t first = column;
  while (is_digit(at(line, column))) ++column;
  return column > first && column > kAfterSerial ? column - kAfterSerial : 0;
}

bool has_inner_blank(std::string_view field) { return std::ranges::any_of(trimmed(field), is_blank); }

// Whether residue and number are where the columns have them: a residue is one word, and a number is digits, or four
// letters and digits where it is in base 36.
bool fits_head(std::string_view line, std::size_t shift) {
  const std::string_view number = trimmed(columns(line, 23 + shift, 26 + shift));
  if (has_inner_blank(columns(line, 18 + shift, 21 + shift)) || has_inner_blank(number)) return false;
  const std::string_view digits = number.starts_with('-') ? number.substr(1) : number;
  return digits.empty() || is_integer(digits) || digits.size() == 4;
}

std::string_view element_of(std::string_view line, std::size_t shift, std::string_view name, std::string_view residue) {
  const std::string_view said = trimmed(columns(line, 77 + shift, 78 + shift));
  const auto is_letter = [](char c) { return c >= 'A' && c <= 'Z'; };
  if (!said.empty() && std::ranges::all_of(said, is_letter)) return said;
  // A name begins in column 14 where its element has one letter, and in column 13 where it has two letters, or where
  // the name has four characters.
  const std::string_view letters =
      trimmed(name).substr(std::min(trimmed(name).find_first_not_of("0123456789"), trimmed(name).size()));
  const AtomKind kind = kind_of_residue(residue);
  const bool is_hydrogen = letters.starts_with('H') && (kind == AtomKind::kProtein || kind == AtomKind::kNucleic);
  const bool may_have_two = !name.empty() && is_letter(name.front()) && trimmed(name).size() < 4 && !is_hydrogen;
  return letters.substr(0, may_have_two ? 2 : 1);
}

// of_coordinates: how far they are moved, and the element with them.
PdbAtom fields_before(std::string_view line, std::size_t shift, std::size_t of_coordinates) {
  PdbAtom atom;
  atom.is_hetatm = line.starts_with("HETATM");
  atom.place_name = columns(line, 13 + shift, 16 + shift);
  atom.location = trimmed(columns(line, 17 + shift, 17 + shift));
  atom.place_residue = columns(line, 22 + shift, 27 + shift);
  atom.name = trimmed(atom.place_name);
  atom.number = trimmed(columns(line, 23 + shift, 27 + shift));
  atom.residue = trimmed(columns(line, 18 + shift, 21 + shift));
  atom.chain = trimmed(columns(line, 22 + shift, 22 + shift));
  atom.element = element_of(line, of_coordinates, atom.place_name, atom.residue);
  const std::string_view symbol = trimmed(columns(line, 77 + of_coordinates, 78 + of_coordinates));
  const bool is_said = !symbol.empty() && std::ranges::all_of(symbol, is_letter);
  atom.said_element = is_said ? ElementText{symbol} : ElementText{atom.place_name, ElementSource::kPdbName};
  return atom;
}

[[noreturn]] void reject_two_ways(const Fields3& one, const Fields3& other, const LinePlace& place) {
  place.reject(fmt::format("can be read in two ways: columns 31 to 54 say {} {} {}, fields between blanks {} {} {}",
                           one[0], one[1], one[2], other[0], other[1], other[2]));
}

// The coordinates, and how far they are moved to the right.
struct PlacedCoordinates {
  Fields3 fields;
  std::size_t shift = 0;
};

// A line that lacks one of its numbers has the next one, the occupancy, in its place. That one has other decimals, and
// then only one number follows.
void check_decimals(std::string_view line, const PlacedCoordinates& read, std::size_t numbers, const LinePlace& place) {
  const auto decimals = [](std::string_view field) { return field.size() - std::min(field.find('.'), field.size()); };
  if (std::ranges::all_of(read.fields, [&](auto field) { return decimals(field) == decimals(read.fields[0]); })) return;
  if (numbers >= 5 && common_shift(line, read.fields) == read.shift) return;
  place.reject("columns 31 to 54: the numbers have different decimals, and fewer numbers follow than do in PDB");
}

// Numbers that are too long for their columns, as a writer has them who lets each take as many columns as it needs, and
// eight at least: all with three decimals, one after the other from column 31 on.
bool are_too_long(std::string_view line, const Fields3& fields, std::size_t shift) {
  std::size_t end = kFirstCoordinate - 1 + shift;
  for (const std::string_view field : fields) {
    const std::size_t start = end + 1;
    end += std::max(kWidth, field.size());
    if (last_column(line, field) != end || !has_three_decimals(field)) return false;
    if (!is_all_blank(columns(line, start, end).substr(0, end + 1 - start - field.size()))) return false;
  }
  return std::ranges::any_of(fields, [](std::string_view field) { return field.size() > kWidth; });
}

PlacedCoordinates coordinates_of(std::string_view line, const LinePlace& place) {
  const std::vector<std::string_view> numbers = numbers_with_points(line);
  std::optional<Fields3> blanks;
  if (numbers.size() >= 3) blanks = Fields3{numbers[0], numbers[1], numbers[2]};
  const std::size_t overflow = overflow_of_serial(line);
  std::vector<std::size_t> shifts = {0};
  if (overflow > 0) shifts.push_back(overflow);
  if (blanks && std::ranges::all_of(*blanks, has_three_decimals)) {
    if (const auto moved = common_shift(line, *blanks); moved && *moved > 0 && *moved != overflow)
      shifts.push_back(*moved);
  }
  std::optional<PlacedCoordinates> found;
  for (const std::size_t shift : shifts) {
    const Coordinates read = by_columns(line, shift);
    if (!read.is_valid()) continue;
    if (found && found->fields != read.fields) reject_two_ways(found->fields, read.fields, place);
    if (!found || common_shift(line, read.fields) == shift) found = PlacedCoordinates{read.fields, shift};
  }
  if (found) {
    if (blanks && found->fields != *blanks) reject_two_ways(found->fields, *blanks, place);
    const bool are_alone =
        std::ranges::all_of(found->fields, [&](std::string_view field) { return is_alone(line, field); });
    if (!are_alone && common_shift(line, found->fields) != found->shift) {
      place.reject("columns 31 to 54: no blank parts two numbers, and they do not end where columns end");
    }
    check_decimals(line, *found, numbers.size(), place);
    return *found;
  }
  const Coordinates usual = by_columns(line, overflow);
  if (!usual.is_cut) {
    static constexpr std::array<const char*, 3> kColumns = {"31 to 38", "39 to 46", "47 to 54"};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::string_view field = usual.fields[axis];
      if (field.empty()) place.reject(fmt::format("no coordinate {} in columns {}", "xyz"[axis], kColumns[axis]));
      if (!is_plain_number(field)) {
        place.reject(fmt::format("not a number: {}, in columns {}", in_quotes(field), kColumns[axis]));
      }
    }
  }
  for (const std::size_t shift : shifts) {
    if (blanks && are_too_long(line, *blanks, shift)) return {*blanks, shift};
  }
  place.reject("columns 31 to 54 cut a number, and no other places of the coordinates are certain");
}

// Where the fields before the coordinates are. They move with a long serial, or with the whole line.
std::size_t shift_of_head(std::string_view line, std::size_t shift, const LinePlace& place) {
  const std::size_t overflow = overflow_of_serial(line);
  if ((shift == 0 || shift == overflow) && fits_head(line, shift)) return shift;
  if (overflow > 0 && fits_head(line, overflow)) return overflow;
  // A number of five digits moves what is behind it.
  const bool has_long_number = overflow == 0 && is_digit(at(line, 26)) && is_digit(at(line, 27));
  if (has_long_number && fits_head(line, 0)) return 0;
  if (fits_head(line, shift)) {
    const bool is_certain = shift == 0 || !fits_head(line, 0) ||
                            (columns(line, 17, 17) == columns(line, 17 + shift, 17 + shift) &&
                             columns(line, 22, 22) == columns(line, 22 + shift, 22 + shift));
    if (!is_certain)
      place.reject(fmt::format("the line seems to be moved by {} columns: columns 17 and 22 are not certain", shift));
    return shift;
  }
  if (fits_head(line, 0)) return 0;
  place.reject("columns 18 to 26 do not have a residue, a chain and a number");
}

// All records of the format's description that are no atoms, and those of programs that follow it.
bool is_known_record(std::string_view line) {
  static constexpr auto kRecords = std::to_array<std::string_view>(
      {"HEADER", "OBSLTE", "TITLE",  "SPLIT",  "CAVEAT", "COMPND", "SOURCE", "KEYWDS", "EXPDTA", "NUMMDL", "MDLTYP",
       "AUTHOR", "REVDAT", "SPRSDE", "JRNL",   "REMARK", "DBREF",  "DBREF1", "DBREF2", "SEQADV", "SEQRES", "MODRES",
       "HET",    "HETNAM", "HETSYN", "FORMUL", "HELIX",  "SHEET",  "TURN",   "SSBOND", "LINK",   "CISPEP", "SITE",
       "CRYST1", "ORIGX1", "ORIGX2", "ORIGX3", "SCALE1", "SCALE2", "SCALE3", "MTRIX1", "MTRIX2", "MTRIX3", "MODEL",
       "ANISOU", "SIGATM", "SIGUIJ", "TER",    "ENDMDL", "CONECT", "MASTER", "END",    "LINKR",  "USER",   "ROOT",
       "ENDROO", "BRANCH", "ENDBRA", "TORSDO", "HYDBND", "SLTBRG", "TVECT",  "FTNOTE"});
  return std::ranges::find(kRecords, trimmed(line.substr(0, 6))) != kRecords.end();
}

bool looks_like_atom(std::string_view line) {
  const std::string start = lower_case(trimmed(line).substr(0, 6));
  return start.starts_with("atom") || start.starts_with("heta") || by_columns(line, 0).is_valid();
}

}  // namespace

bool is_pdb_record(std::string_view line) {
  if (line.starts_with("ATOM") || line.starts_with("HETATM")) return line.size() >= 27;
  return is_known_record(line) && line.substr(0, 6) != "USER";
}

PdbRecord pdb_record(std::string_view line, const LinePlace& place) {
  const bool is_atom = line.starts_with("ATOM") && (is_blank(at(line, 5)) || is_digit(at(line, 5)));
  if (is_atom || line.starts_with("HETATM")) return PdbRecord::kAtom;
  const std::string_view name = trimmed(line.substr(0, 6));
  if (name == "MODEL") return PdbRecord::kModel;
  if (name == "END") return PdbRecord::kEnd;
  if (!is_known_record(line) && looks_like_atom(line)) {
    place.reject("a line that looks like an atom, but begins neither with ATOM nor with HETATM: " +
                 in_quotes(line.substr(0, 12)));
  }
  return PdbRecord::kOther;
}

PdbAtom pdb_atom(std::string_view line, const LinePlace& place) {
  if (line.find('\t') != std::string_view::npos) place.reject("a tab in a line of fixed columns");
  if (line.size() < kShortestPdbAtom) place.reject("an atom's line ends before column 54");
  const PlacedCoordinates coordinates = coordinates_of(line, place);
  PdbAtom atom = fields_before(line, shift_of_head(line, coordinates.shift, place), coordinates.shift);
  atom.position = coordinates.fields;
  return atom;
}

}  // namespace flowcert::io
