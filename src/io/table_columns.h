// Which columns of a table are x, y and z: by the user's word, by names above the first row, or the first three.
//
// Guarantees: a name is one word, in any case. Text in a comment that only mentions x, y and z is no list of names: a
// list between blanks has as many names as there are columns, and a list between commas has single words up to the last
// of the three. Source: spec clause FC-FILE-01.
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

// Names as a line lists them. `text` has no mark of a comment.
class ColumnNames {
 public:
  explicit ColumnNames(std::string_view text);

  // Where this name is, in any case. Two columns of one name are refused.
  [[nodiscard]] std::optional<std::size_t> find(std::string_view name, const LinePlace& place) const;
  [[nodiscard]] bool has_xyz() const;
  [[nodiscard]] std::size_t size() const { return names_.size(); }
  // How many names at the front are single words.
  [[nodiscard]] std::size_t words() const;
  // Whether blanks alone separate the names.
  [[nodiscard]] bool is_blank_separated() const { return is_blank_separated_; }

  friend bool operator==(const ColumnNames&, const ColumnNames&) = default;

 private:
  std::vector<std::string> names_;
  bool is_blank_separated_;
};

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
