// Tables for people, on standard output.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "cli/layer.h"

namespace flowcert::cli {

// "critical points of index 1      97,790   saddles on Gabriel edges"
void print_row(const std::string& name, const std::string& value, const std::string& remark = "");

// Columns as wide as their widest cell, two blanks before each. alignment has a letter a column, 'l' or 'r';
// rows may have fewer cells.
void print_columns(const std::vector<std::vector<std::string>>& rows, std::string_view alignment);

// The same with a line of titles, and filled cell by cell.
class Table {
 public:
  explicit Table(std::string_view alignment) : alignment_(alignment) {}
  Table(std::string_view alignment, std::initializer_list<const char*> titles);

  // Begins a row; what follows fills it from the left.
  Table& row(std::string first);
  Table& cell(std::string text);
  Table& cell(std::size_t number);  // with commas

  // The titles count.
  [[nodiscard]] std::size_t height() const { return rows_.size(); }
  void print() const { print_columns(rows_, alignment_); }

 private:
  std::string_view alignment_;
  std::vector<std::vector<std::string>> rows_;
};

// "69.7 ms", "1.23 s"
[[nodiscard]] std::string seconds_text(double seconds);

}  // namespace flowcert::cli
