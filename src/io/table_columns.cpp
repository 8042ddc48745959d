#include "io/table_columns.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "io/point_rows.h"

namespace flowcert::io {

namespace {

constexpr std::array<std::string_view, 3> kAxes = {"x", "y", "z"};

std::string_view without_quotes(std::string_view field) {
  const bool is_quoted = field.size() >= 2 && field.front() == '"' && field.back() == '"';
  return is_quoted ? trimmed(field.substr(1, field.size() - 2)) : field;
}

// "x[m]" and "x (m)" are x.
std::string without_unit(std::string_view field) {
  field = without_quotes(field);
  const std::size_t bracket = field.find_first_of("[(");
  return std::string(bracket == 0 ? field : trimmed(field.substr(0, bracket)));
}

ColumnNames list_of(const std::vector<std::string_view>& fields) {
  ColumnNames list;
  for (const std::string_view field : fields) {
    list.is_open = list.is_open || field.find("[]") != std::string_view::npos;
    if (!list.is_open) list.names.push_back(without_unit(field));
  }
  return list;
}

// Other programs' marks of comments, and words with a colon, only introduce the names.
std::string_view without_introduction(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of("%!#"), text.size()));
  const std::size_t colon = text.find(':');
  const bool is_word = colon < text.size() && (colon + 1 == text.size() || is_blank(text[colon + 1]));
  return is_word ? text.substr(colon + 1) : text;
}

// Where the name with another axis is: ty for tx.
std::optional<std::size_t> place_of_axis(const std::vector<std::string>& names, std::string name, std::size_t at,
                                         char axis) {
  name[at] = axis;
  const auto found = std::ranges::find(names, name);
  if (found == names.end()) return std::nullopt;
  return static_cast<std::size_t>(found - names.begin());
}

}  // namespace

bool begins_as_number(std::string_view field) {
  return !field.empty() && (is_digit(field[0]) || field.find_first_of("+-.") == 0);
}

Separators separators_of(std::string_view line) {
  return line.find(';') != std::string_view::npos ? Separators::kSemicolons : Separators::kBlanksAndCommas;
}

bool ColumnNames::has_axes(std::size_t count) const {
  return std::all_of(kAxes.begin(), kAxes.begin() + static_cast<std::ptrdiff_t>(count),
                     [&](std::string_view axis) { return std::ranges::find(names, axis, lower_case) != names.end(); });
}

std::optional<std::size_t> ColumnNames::find(std::string_view name, const LinePlace& place) const {
  std::optional<std::size_t> found;
  for (std::size_t k = 0; k < names.size(); ++k) {
    if (lower_case(names[k]) != lower_case(name)) continue;
    if (found) place.reject(fmt::format("two columns are named {}: --columns says by number which is meant", name));
    found = k;
  }
  return found;
}

std::vector<ColumnNames> lists_of_names(std::string_view text) {
  text = without_introduction(text);
  for (const char mark : {';', ','}) {
    if (text.find(mark) == std::string_view::npos) continue;
    std::vector<std::string_view> fields = split_at(text, mark);
    if (fields.back().empty()) fields.pop_back();
    return {list_of(fields)};
  }
  std::vector<ColumnNames> lists = {list_of(words_of(text))};
  if (text.find('\t') != std::string_view::npos) lists.push_back(list_of(split_at(text, '\t')));
  return lists;
}

bool names_other_columns(std::string_view text, std::size_t columns) {
  std::string words = lower_case(without_introduction(text));
  std::ranges::replace_if(words, [](char c) { return c == ',' || c == ';'; }, ' ');
  const std::vector<std::string> names = list_of(words_of(words)).names;
  for (std::size_t k = 0; k < names.size(); ++k) {
    const std::size_t at = names[k].find('x');
    if (at == std::string::npos) continue;
    const auto y = place_of_axis(names, names[k], at, 'y'), z = place_of_axis(names, names[k], at, 'z');
    if (!y || (!z && columns > 2)) continue;
    const bool is_in_order = k < *y && (!z || *y < *z);
    return !is_in_order || (columns > 3 && (k != 0 || *y != 1 || (z && *z != 2)));
  }
  return false;
}

ChosenColumns::ChosenColumns(const std::string& text, std::size_t count) : words_(list_of(split_at(text, ',')).names) {
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
    const std::size_t number = written_size(word, place);
    if (number == 0) throw InvalidInput("--columns counts from 1: " + in_quotes(word));
    places[axis] = number - 1;
  }
  return places;
}

}  // namespace flowcert::io
