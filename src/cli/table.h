// Tables for people, on standard output.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace flowcert {

// "critical points of index 1      97,790   saddles on Gabriel edges"
void print_row(const std::string& name, const std::string& value, const std::string& remark = "");

// Columns as wide as their widest cell, two blanks before each. alignment has a letter a column, 'l' or 'r';
// rows may have fewer cells.
void print_columns(const std::vector<std::vector<std::string>>& rows, std::string_view alignment);

// "69.7 ms", "1.23 s"
[[nodiscard]] std::string seconds_text(double seconds);

}  // namespace flowcert
