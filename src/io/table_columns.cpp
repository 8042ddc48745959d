#include "io/table_columns.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "io/point_rows.h"

namespace flowcert::io {

namespace {

constexpr std::array<std::string_view, 3> kAxes = {"x", "y", "z"};

// The name of a column of row numbers may be empty.
bool is_word(std::string_view name) { return std::ranges::none_of(name, is_blank); }

std::string_view without_quotes(std::string_view field) {
  const bool is_quoted = field.size() >= 2 && field.front() == '"' && field.back() == '"';
  return is_quoted ? trimmed(field.substr(1, field.size() - 2)) : field;
}

// Between commas or semicolons, a field of names may have blanks.
std::vector<std::string> fields_of_names(std::string_view text, char mark) {
  std::vector<std::string> names;
  for (const std::string_view part : split_at(text, mark)) names.emplace_back(without_quotes(part));
  return names;
}

}  // namespace

bool begins_as_number(std::string_view field) {
  return !field.empty() && (is_digit(field[0]) || field.find_first_of("+-.") == 0);
}

Separators separators_of(std::string_view line) {
  return line.find(';') != std::string_view::npos ? Separators::kSemicolons : Separators::kBlanksAndCommas;
}

ColumnNames::ColumnNames(std::string_view text)
    : is_blank_separated_(text.find_first_of(",;") == std::string_view::npos) {
  if (is_blank_separated_) {
    for (const std::string_view word : words_of(text)) names_.emplace_back(without_quotes(word));
  } else {
    names_ = fields_of_names(text, text.find(';') != std::string_view::npos ? ';' : ',');
  }
}

std::optional<std::size_t> ColumnNames::find(std::string_view name, const LinePlace& place) const {
  std::optional<std::size_t> found;
  for (std::size_t k = 0; k < names_.size(); ++k) {
    if (lower_case(names_[k]) != lower_case(name)) continue;
    if (found) place.reject(fmt::format("two columns are named {}: --columns says by number which is meant", name));
    found = k;
  }
  return found;
}

std::size_t ColumnNames::words() const {
  return static_cast<std::size_t>(std::ranges::find_if_not(names_, is_word) - names_.begin());
}

bool ColumnNames::has_xyz() const {
  return std::ranges::all_of(kAxes, [&](std::string_view axis) {
    const auto at = std::ranges::find(names_, axis, lower_case);
    return at != names_.end() && static_cast<std::size_t>(at - names_.begin()) < words();
  });
}

ChosenColumns::ChosenColumns(const std::string& text, std::size_t count) : words_(fields_of_names(text, ',')) {
  if (words_.size() != count) {
    throw InvalidInput(fmt::format("--columns takes {} columns, as {}; not {}", count,
                                   count == 2 ? "1,2 or x,y" : "2,3,4 or x,y,z", in_quotes(text)));
  }
  are_names_ = !std::ranges::all_of(words_, is_integer);
  std::vector<std::string> sorted = words_;
  std::ranges::sort(sorted);
  if (std::ranges::adjacent_find(sorted) != sorted.end() || std::ranges::find(sorted, "") != sorted.end()) {
    throw InvalidInput("--columns takes different columns, not " + in_quotes(text));
  }
}

ColumnPlaces ChosenColumns::places(const std::optional<ColumnNames>& names, const LinePlace& place) const {
  ColumnPlaces places{};
  for (std::size_t axis = 0; axis < words_.size(); ++axis) {
    const std::string& word = words_[axis];
    if (are_names_) {
      if (!names) place.reject("--columns names columns, and no line above the first row names them");
      const std::optional<std::size_t> found = names->find(word, place);
      if (!found) place.reject("no column is named " + in_quotes(word));
      places[axis] = *found;
      continue;
    }
    const std::uint64_t number = announced_count(word, place);
    if (number == 0) throw InvalidInput("--columns counts from 1: " + in_quotes(word));
    places[axis] = number - 1;
  }
  return places;
}

}  // namespace flowcert::io
