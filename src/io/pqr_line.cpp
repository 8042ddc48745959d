#include "io/pqr_line.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>

#include "io/number_text.h"
#include "io/point_formats.h"

namespace flowcert::io {

namespace {

constexpr std::size_t kFewest = 10, kMost = 11;  // fields, without and with a chain

// No more are looked at than show that there are too many.
struct Words {
  std::array<std::string_view, kMost + 1> words;
  std::size_t count = 0;
};

Words words_at(std::string_view line) {
  Words found;
  Fields fields(line, Separators::kBlanks);
  while (found.count < found.words.size() && fields.next(found.words[found.count])) ++found.count;
  return found;
}

// "12", "-3" or "52A", with an insertion code.
bool is_residue_number(std::string_view word) {
  if (word.starts_with('-')) word.remove_prefix(1);
  if (!word.empty() && is_letter(word.back())) word.remove_suffix(1);
  return is_integer(word);
}

// What is wrong with the fields, or nothing.
std::string complaint_about(const Words& line) {
  const auto& words = line.words;
  if (words[0] != "ATOM" && words[0] != "HETATM") return "no blank after ATOM or HETATM: " + in_quotes(words[0]);
  if (line.count < kFewest || line.count > kMost) {
    return fmt::format("{}{} fields, and an atom of PQR has 10, or 11 with a chain",
                       line.count > kMost ? "more than " : "", std::min(line.count, kMost));
  }
  const std::size_t number = line.count - 6;
  if (!is_residue_number(words[number])) return "not a residue's number: " + in_quotes(words[number]);
  for (std::size_t k = line.count - 2; k < line.count; ++k) {
    if (const char* const fault = coordinate_of(words[k]).fault; fault != nullptr) {
      return fmt::format("the {}: {}: {}", k + 1 == line.count ? "radius" : "charge", fault, in_quotes(words[k]));
    }
  }
  return "";
}

// Of a name in doubt hydrogen alone, as hydrogens are chosen by their element.
std::string_view element_by_name(std::string_view name, std::string_view residue) {
  const MeantElement meant = element_of({name, ElementSource::kName}, residue);
  if (meant.other.empty()) return meant.symbol;
  return meant.other == "H" ? meant.other : std::string_view();
}

}  // namespace

PdbAtom pqr_atom(std::string_view line, const LinePlace& place) {
  const Words fields = words_at(line);
  if (const std::string complaint = complaint_about(fields); !complaint.empty()) place.reject(complaint);
  const auto& words = fields.words;
  const std::size_t number = fields.count - 6;
  PdbAtom atom;
  atom.is_hetatm = words[0] == "HETATM";
  atom.name = atom.place_name = words[2];
  atom.residue = words[3];
  if (fields.count == kMost) atom.chain = words[4];
  atom.number = atom.place_residue = words[number];
  atom.element = element_by_name(atom.name, atom.residue);
  atom.said_element = {atom.name, ElementSource::kName};
  atom.position = {words[number + 1], words[number + 2], words[number + 3]};
  atom.radius = words[number + 5];
  return atom;
}

bool begins_as_pqr(std::string_view text) {
  LineReader lines(text, "");
  for (std::string_view line; lines.next_filled(line);) {
    if (line.starts_with("ATOM") || line.starts_with("HETATM")) {
      const Words fields = words_at(line);
      return line.size() < kShortestPdbAtom && complaint_about(fields).empty() &&
             std::all_of(
                 fields.words.begin() + static_cast<std::ptrdiff_t>(fields.count) - 5,
                 fields.words.begin() + static_cast<std::ptrdiff_t>(fields.count),
                 [](std::string_view word) { return coordinate_of(word).is_number(); });
    }
    if (!is_pdb_record(line)) return false;
  }
  return false;
}

}  // namespace flowcert::io
