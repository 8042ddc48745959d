// The text format of the public implementation of Giesen and Kühne's algorithm. A line `inf 3` stands for the maximum
// at infinity and gives the dimension. Each other line has one critical point:
//
//   contact ids | distance | contact ids of a successor | ... |
//
// The index is the number of contact ids minus one, because the program lists only a spanning part of a larger
// cospherical set. A successor is a critical point above, or `inf`. Distances are not squared.
#include <algorithm>
#include <string>

#include "certify/claims/claim_formats.h"
#include "io/number_text.h"

namespace flowcert::certify {
namespace {

constexpr std::string_view kInfinity = "inf";

std::vector<PointId> ids_of(std::string_view text, const LinePlace& place) {
  std::vector<PointId> ids;
  for (const std::string_view word : words_of(text)) ids.push_back(claimed_id(word, place));
  if (ids.empty()) place.reject("no ids between two bars");
  if (ids.size() > 4) place.reject("a critical point of " + std::to_string(ids.size()) + " ids, not 1 to 4");
  return ids;
}

// Takes the part before the next bar off the front of the line. False if only blanks are left.
bool next_part(std::string_view& line, std::string_view& part) {
  if (is_all_blank(line)) return false;
  part = line.substr(0, line.find('|'));
  line.remove_prefix(std::min(part.size() + 1, line.size()));
  return true;
}

// The only word of a part.
std::string_view word_of(std::string_view part, const LinePlace& place) {
  const std::vector<std::string_view> words = words_of(part);
  if (words.empty()) place.reject("nothing between two bars");
  if (words.size() > 1) place.reject("more than one number between two bars: " + in_quotes(part));
  return words[0];
}

// Whether the first word stands for infinity.
bool is_infinite(std::string_view part) {
  std::string_view word;
  Fields(part, Separators::kBlanks).next(word);
  return word == kInfinity;
}

ClaimedTarget target_of(std::string_view part, const LinePlace& place) {
  if (!is_infinite(part)) return {.is_infinity = false, .contact = ids_of(part, place)};
  (void)word_of(part, place);
  return {.is_infinity = true, .contact = {}};
}

ClaimedPoint point_of(std::string_view line, const LinePlace& place) {
  ClaimedPoint point;
  point.line = place.line;
  std::string_view part;
  next_part(line, part);
  point.contact = ids_of(part, place);
  point.index = static_cast<int>(point.contact.size()) - 1;
  if (!next_part(line, part)) place.reject("cut short: no distance");
  point.distance = claimed_distance(word_of(part, place), PlainInteger::kDecimal, place);
  point.successors.emplace();
  while (next_part(line, part)) point.successors->push_back(target_of(part, place));
  return point;
}

void expect_three_dimensions(std::string_view line, const LinePlace& place) {
  const std::vector<std::string_view> words = words_of(line);
  if (words.size() < 2) place.reject("no dimension after 'inf'");
  if (words[1] != "3") place.reject("a flow complex of dimension " + in_quotes(words[1]) + ", not 3");
  if (words.size() > 2) place.reject("more than the dimension after 'inf': " + in_quotes(words[2]));
}

bool recognises_giesen_kuehne(std::string_view bytes) {
  LineReader lines(bytes, "");
  std::string_view line;
  return lines.next_uncommented(line) && (is_infinite(line) || line.find('|') != std::string_view::npos);
}

Claim read_giesen_kuehne(std::string_view text, std::string_view file, bool /*is_unlimited*/) {
  Claim claim;
  LineReader lines(text, file);
  std::string_view line;
  bool has_infinity = false;
  while (lines.next_filled(line)) {
    if (!is_infinite(line)) {
      claim.points.push_back(point_of(line, lines.place()));
      continue;
    }
    expect_three_dimensions(line, lines.place());
    if (has_infinity) lines.place().reject("a second maximum at infinity");
    has_infinity = true;
  }
  return claim;
}

}  // namespace

const ClaimFormat kGiesenKuehneClaims = {
    .name = "giesen-kuehne", .recognises = recognises_giesen_kuehne, .read = read_giesen_kuehne};

}  // namespace flowcert::certify
