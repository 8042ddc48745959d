// CSV: index,x,y,z[,squared_distance[,contact ids...]], one critical point for each line, separated by commas or
// blanks. '#' starts a comment. A first line that begins with `index` names the columns.
//
// An integer is a decimal here, because a program may print 5.0000001 as 5; but 5/1 is exact. An empty
// squared_distance is not claimed, and neither is a position of three empty fields. Spreadsheets pad lines with empty
// fields at the end.
#include <algorithm>
#include <array>
#include <optional>
#include <string>

#include "certify/claims/claim_formats.h"
#include "io/number_text.h"

namespace flowcert::certify {
namespace {

void expect_columns(std::string_view line, const LinePlace& place) {
  std::vector<std::string_view> names = fields_of(line, Separators::kBlanksAndCommas);
  while (!names.empty() && names.back().empty()) names.pop_back();
  const std::array<std::string_view, 5> all = {"index", "x", "y", "z", "squared_distance"};
  for (std::size_t k = 0; k < std::clamp<std::size_t>(names.size(), 4, 5); ++k) {
    if (k < names.size() && names[k] == all[k]) continue;
    place.reject("no column " + in_quotes(all[k]) + " where it belongs");
  }
}

std::vector<PointId> contact_of(Fields& fields, const LinePlace& place) {
  std::vector<PointId> contact;
  std::string_view field;
  bool is_padding = false;
  while (fields.next(field)) {
    if (!field.empty() && is_padding) place.reject("an empty field before " + in_quotes(field));
    is_padding = field.empty();
    if (!is_padding) contact.push_back(claimed_id(field, place));
  }
  return contact;
}

// None where all three fields are empty.
std::optional<ClaimedPosition> position_of(Fields& fields, const LinePlace& place) {
  std::array<std::string_view, 3> texts;
  for (std::size_t k = 0; k < 3; ++k) {
    if (!fields.next(texts[k])) place.reject("too few numbers: " + std::to_string(k) + " of 3 after the index");
  }
  if (texts[0].empty() && texts[1].empty() && texts[2].empty()) return std::nullopt;
  ClaimedPosition position;
  for (std::size_t k = 0; k < 3; ++k) position[k] = claimed_number(texts[k], PlainInteger::kDecimal, place);
  return position;
}

ClaimedPoint point_of(std::string_view line, const LinePlace& place) {
  ClaimedPoint point;
  point.line = place.line;
  Fields fields(line, Separators::kBlanksAndCommas);
  std::string_view field;
  fields.next(field);
  point.index = claimed_index(field, place);
  point.center = position_of(fields, place);
  if (fields.next(field) && !field.empty())
    point.squared_distance = claimed_distance(field, PlainInteger::kDecimal, place);
  point.contact = contact_of(fields, place);
  if (!point.center && point.contact.empty()) place.reject("neither a position nor contact ids");
  return point;
}

// This format is tried last, so it takes every file.
bool recognises_csv(std::string_view /*bytes*/) { return true; }

Claim read_csv(std::string_view text, std::string_view file, bool /*is_unlimited*/) {
  Claim claim;
  LineReader lines(text, file);
  std::string_view line;
  bool is_first = true;
  while (lines.next_uncommented(line)) {
    std::string_view word;
    Fields(line, Separators::kBlanksAndCommas).next(word);
    if (is_first && word == "index") {
      expect_columns(line, lines.place());
    } else {
      claim.points.push_back(point_of(line, lines.place()));
    }
    is_first = false;
  }
  return claim;
}

}  // namespace

const ClaimFormat kCsvClaims = {.name = "csv", .recognises = recognises_csv, .read = read_csv};

}  // namespace flowcert::certify
