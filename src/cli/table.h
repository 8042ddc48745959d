// Tables for people, on standard output.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "cli/layer.h"

namespace flowcert::cli {

// Prints the text within 80 columns, with a line's end. Lines that go on begin with `indent` blanks.
void print_wrapped(std::string_view text, std::size_t indent = 0);

// "critical points of index 1      97,790   saddles on Gabriel edges". A long remark goes on below its beginning.
void print_row(const std::string& name, const std::string& value, const std::string& remark = "");

// Each column is as wide as its widest cell, with two blanks before it. alignment has a letter for each column,
// 'l' or 'r'. A row may have fewer cells. If the table would be wider than 80 columns, the widest columns of 'l' become
// narrower, and their cells have several lines.
void print_columns(const std::vector<std::vector<std::string>>& rows, std::string_view alignment);

// A table as print_columns() prints it, filled cell by cell. It may have a line of titles.
class Table {
 public:
  explicit Table(std::string_view alignment) : alignment_(alignment) {}
  Table(std::string_view alignment, std::initializer_list<const char*> titles);

  // Begins a row. The cells added next fill it from the left.
  Table& row(std::string first);
  Table& cell(std::string text);
  Table& cell(std::size_t number);  // with commas

  // Leaves out each column from this one on (0 is the first) that has only zeros below its title.
  void leave_out_zeros(std::size_t from);

  // The number of rows, with the line of titles.
  [[nodiscard]] std::size_t height() const { return rows_.size(); }
  void print() const { print_columns(rows_, alignment_); }
  // Prints two tables that each have the first column, if one would be wider than a line.
  void print_in_parts() const;

 private:
  std::string alignment_;
  std::vector<std::vector<std::string>> rows_;
};

// "69.7 ms", "1.23 s"
[[nodiscard]] std::string seconds_text(double seconds);

}  // namespace flowcert::cli
