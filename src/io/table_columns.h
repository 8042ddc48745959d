// Which columns of a table are x, y and z: by the user's word, by names above the first row, or the first three.
//
// Guarantees: names count where there are as many as columns, whether commas, semicolons, tabs or blanks part them.
// A comment that mentions x, y and z otherwise is refused, unless they are the first three. Source: spec clause
// FC-FILE-39.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/layer.h"
#include "io/line_reader.h"

namespace flowcert::io {

// A name of a column does not.
[[nodiscard]] bool begins_as_number(std::string_view field);

// The separators of the fields of a line, by what is in it.
[[nodiscard]] Separators separators_of(std::string_view line);

// Names as a line lists them, without units in brackets.
struct ColumnNames {
  std::vector<std::string> names;
  // COLMAP's TRACK[] stands for any number of columns, and is not among the names.
  bool is_open = false;

  // Whether rows of so many columns can have these.
  [[nodiscard]] bool fits(std::size_t columns) const {
    return is_open ? names.size() <= columns : names.size() == columns;
  }
  [[nodiscard]] bool has_axes(std::size_t count) const;
  // Where this name is, in any case. Two columns of one name are refused.
  [[nodiscard]] std::optional<std::size_t> find(std::string_view name, const LinePlace& place) const;

  friend bool operator==(const ColumnNames&, const ColumnNames&) = default;
};

// All that a line may list, which has no mark of a comment: between commas or semicolons, or between tabs or blanks.
[[nodiscard]] std::vector<ColumnNames> lists_of_names(std::string_view text);

// Whether the words of a text have x, y and z, or such words as tx, ty and tz, so that these are not the first columns.
[[nodiscard]] bool names_other_columns(std::string_view text, std::size_t columns);

// The three columns, counted from 0. With `z` given, the last is not looked at.
using ColumnPlaces = std::array<std::size_t, 3>;

// What the user says: "2,3,4" or "x,y,z". `count`: 3, or 2 where z is given.
class ChosenColumns {
 public:
  // Throws InvalidInput unless there are `count` different ones.
  ChosenColumns(const std::string& text, std::size_t count);

  [[nodiscard]] bool are_names() const { return are_names_; }
  // names: those above the first row, if there are any.
  [[nodiscard]] ColumnPlaces places(const std::optional<ColumnNames>& names, const LinePlace& place) const;

 private:
  std::vector<std::string> words_;
  bool are_names_;
};

}  // namespace flowcert::io
