// Chemical XYZ: a count, a comment, and a line for each atom: its element, or a number, and three coordinates.
//
// Extended XYZ says in its comment what the columns are (Properties=) and the cell (Lattice=), which is ignored, with a
// note. Files of QM9 write exponents as *^ and go on with lines of other facts after the atoms. No library of Debian
// reads all of these and refuses what is damaged. Source: spec clause FC-FILE-40.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "io/atom_selection.h"
#include "io/number_text.h"
#include "io/point_formats.h"

namespace flowcert::io {

namespace {

// An element with or without more behind it, as C, C1 or Fe3+; or an atomic number.
bool is_label(std::string_view word) {
  if (word.empty()) return false;
  if (is_letter(word[0])) return true;
  return word.size() <= 3 && is_integer(word);
}

bool is_count(std::string_view line) {
  const std::vector<std::string_view> words = words_of(line);
  return words.size() == 1 && is_integer(words[0]);
}

// Where the columns of an atom's line are.
struct AtomColumns {
  std::size_t label = 0;
  std::size_t position = 1;
  std::size_t least = 4;
  bool are_said = false;  // by Properties=
};

// "species:S:1:pos:R:3:forces:R:3"
AtomColumns columns_of(std::string_view properties, const LinePlace& place) {
  const std::vector<std::string_view> parts = split_at(properties, ':');
  if (parts.size() % 3 != 0) place.reject("Properties= is not made of name:type:columns");
  AtomColumns columns{.label = SIZE_MAX, .position = SIZE_MAX, .least = 0, .are_said = true};
  for (std::size_t k = 0; k < parts.size(); k += 3) {
    const std::uint64_t count = written_count(parts[k + 2], place);
    if (count == 0 || count > 1000) place.reject("a property of " + in_quotes(parts[k + 2]) + " columns");
    const bool is_position = parts[k] == "pos";
    if (is_position && (columns.position != SIZE_MAX || count != 3 || parts[k + 1] != "R")) {
      place.reject("Properties= has no positions of three columns, pos:R:3");
    }
    if (is_position) columns.position = columns.least;
    if (parts[k] == "species" || (parts[k] == "Z" && columns.label == SIZE_MAX)) columns.label = columns.least;
    columns.least += count;
  }
  if (columns.position == SIZE_MAX) place.reject("Properties= has no positions, pos:R:3");
  return columns;
}

// The value of KEY=value in a comment of extended XYZ, in any case, with or without quotes; empty if there is none.
std::string_view value_of_key(std::string_view comment, std::string_view key) {
  const std::string lower = lower_case(comment);
  for (std::size_t at = lower.find(key); at != std::string::npos; at = lower.find(key, at + 1)) {
    std::string_view value = trimmed(comment.substr(at + key.size()));
    if ((at > 0 && is_letter(comment[at - 1])) || !value.starts_with('=')) continue;
    value = trimmed(value.substr(1));
    const char quote = value.empty() ? ' ' : value.front();
    if (quote == '"' || quote == '\'') return value.substr(1, value.find(quote, 1) - 1);
    return value.substr(0, static_cast<std::size_t>(std::ranges::find_if(value, is_blank) - value.begin()));
  }
  return {};
}

class ChemicalReader {
 public:
  ChemicalReader(std::string_view text, PointRows& rows)
      : lines_(text, rows.file()), rows_(rows), selection_(rows.options(), rows.file(), false) {}

  void read() {
    const std::size_t wanted = std::max<std::size_t>(rows_.options().frame, 1);
    std::string_view line;
    std::size_t frames = 0;
    while (lines_.next_filled(line)) {
      if (is_count(line)) {
        read_frame(line, ++frames == wanted);
      } else {
        see_trailing_line(line);
      }
    }
    if (frames < wanted) {
      reject_file(rows_.file(),
                  fmt::format("there is no frame {}; there {} {}", wanted, frames == 1 ? "is" : "are", frames));
    }
    tell(frames);
  }

 private:
  void read_frame(std::string_view first, bool is_wanted) {
    const std::uint64_t count = written_count(trimmed(first), lines_.place());
    std::string_view line;
    if (!lines_.next(line)) reject_file(rows_.file(), "cut short: no comment after the count of atoms");
    const std::string_view properties = value_of_key(line, "properties");
    const AtomColumns columns = properties.empty() ? AtomColumns{} : columns_of(properties, lines_.place());
    if (is_wanted && !value_of_key(line, "lattice").empty()) {
      if (rows_.balls() != nullptr) rows_.balls()->see_crystal(lines_.place().line);
      rows_.note(lines_.place().line, "the lattice is ignored; the points are not periodic");
    }
    if (is_wanted) rows_.reserve(count, lines_.rest().size(), 8);
    for (std::uint64_t atom = 0; atom < count; ++atom) {
      if (!lines_.next(line)) reject_missing(rows_.file(), count, "atoms", atom);
      read_atom(words_of(line), columns, is_wanted);
    }
  }

  void read_atom(const std::vector<std::string_view>& words, const AtomColumns& columns, bool is_wanted) {
    const LinePlace place = lines_.place();
    if (words.size() < columns.least) {
      place.reject(fmt::format("{} columns, and an atom has {}", words.size(), columns.least));
    }
    if (columns.are_said && words.size() > columns.least) {
      place.reject(fmt::format("{} columns, and Properties= says {}", words.size(), columns.least));
    }
    const std::string_view label = columns.label < words.size() ? words[columns.label] : std::string_view();
    if (columns.label != SIZE_MAX && !is_label(label)) place.reject("not an element: " + in_quotes(label));
    if (!is_wanted) return;
    check_length(words.size(), place);
    if (!selection_.takes(Atom{.element = element_of_label(label)})) return;
    if (rows_.add({words[columns.position], words[columns.position + 1], words[columns.position + 2]}, place)) {
      rows_.name({.atom = label, .element = element_of_label(label)}, {label, ElementSource::kLabel});
    }
  }

  // A number that a blank cuts in two moves all that follow it.
  void check_length(std::size_t count, const LinePlace& place) {
    if (columns_ == 0) columns_ = count;
    if (count != columns_) place.reject(fmt::format("{} columns, and the first atom has {}", count, columns_));
  }

  void see_trailing_line(std::string_view line) {
    if (is_chemical_atom(line)) lines_.place().reject("a line that may be an atom, after all that the count announces");
    ++trailing_;
  }

  void tell(std::size_t frames) {
    if (frames > 1 && rows_.options().frame == 0) {
      rows_.note(0, fmt::format("the first of {} frames is read; --frame says which", frames));
    }
    if (trailing_ > 0) {
      rows_.note(0, fmt::format("{} line{} after the atoms {} ignored", trailing_, trailing_ == 1 ? "" : "s",
                                trailing_ == 1 ? "is" : "are"));
    }
    selection_.finish(rows_);
  }

  LineReader lines_;
  PointRows& rows_;
  AtomSelection selection_;
  std::size_t columns_ = 0, trailing_ = 0;
};

}  // namespace

void read_chemical(std::string_view text, PointRows& rows) { ChemicalReader(text, rows).read(); }

bool is_chemical_atom(std::string_view line) {
  const std::vector<std::string_view> words = words_of(line);
  return words.size() >= 4 && is_label(words[0]) &&
         std::all_of(words.begin() + 1, words.begin() + 4, [](auto word) { return coordinate_of(word).is_number(); });
}

}  // namespace flowcert::io
