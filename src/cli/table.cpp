#include "cli/table.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/algorithm/string.hpp>

#include "cli/command.h"
#include "cli/wrapped_text.h"

namespace flowcert::cli {

namespace {

using Rows = std::vector<std::vector<std::string>>;

// "name", 14 columns for the value, and three blanks come before a remark.
constexpr std::size_t kRemarks = 51;
// What a column keeps of its width. Words are broken only beyond the second.
constexpr std::size_t kNarrowest = 12;
constexpr std::size_t kLongestWord = 30;

// The width below which a cell's words would be broken.
std::size_t narrowest_of(const std::string& cell) {
  std::size_t narrowest = kNarrowest;
  std::vector<std::string> words;
  boost::algorithm::split(words, cell, [](char c) { return c == ' '; });
  for (const std::string& word : words) narrowest = std::max(narrowest, std::min(columns_of(word), kLongestWord));
  return narrowest;
}

std::vector<std::size_t> widths_of(const Rows& rows, std::string_view alignment) {
  std::vector<std::size_t> widths(alignment.size(), 0);
  for (const auto& row : rows) {
    for (std::size_t k = 0; k < row.size(); ++k) widths[k] = std::max(widths[k], columns_of(row[k]));
  }
  std::size_t total = 2 * widths.size();
  for (const std::size_t width : widths) total += width;
  if (total <= kLineWidth) return widths;
  std::vector<std::size_t> narrowest(alignment.size(), 0);
  for (const auto& row : rows) {
    for (std::size_t k = 0; k < row.size(); ++k) narrowest[k] = std::max(narrowest[k], narrowest_of(row[k]));
  }
  for (; total > kLineWidth; --total) {
    std::size_t widest = widths.size();
    for (std::size_t k = 0; k < widths.size(); ++k) {
      const bool is_candidate = alignment[k] == 'l' && widths[k] > narrowest[k];
      if (is_candidate && (widest == widths.size() || widths[k] > widths[widest])) widest = k;
    }
    if (widest == widths.size()) break;
    --widths[widest];
  }
  return widths;
}

std::vector<std::string> lines_of_cell(const std::string& cell, std::size_t width) {
  if (columns_of(cell) <= width && cell.find(kFixedBlank) == std::string::npos) return {cell};
  return split_lines(wrapped(cell, 0, width));
}

void print_table_row(const std::vector<std::string>& row, const std::vector<std::size_t>& widths,
                     std::string_view alignment) {
  std::vector<std::vector<std::string>> cells;
  std::size_t height = 1;
  for (std::size_t k = 0; k < row.size(); ++k) {
    cells.push_back(lines_of_cell(row[k], widths[k]));
    height = std::max(height, cells.back().size());
  }
  for (std::size_t line = 0; line < height; ++line) {
    std::string text;
    for (std::size_t k = 0; k < cells.size(); ++k) {
      const std::string cell = line < cells[k].size() ? cells[k][line] : "";
      const std::string blanks(widths[k] - std::min(widths[k], columns_of(cell)), ' ');
      text += "  " + (alignment[k] == 'r' ? blanks + cell : cell + blanks);
    }
    fmt::print("{}\n", text.substr(0, text.find_last_not_of(' ') + 1));
  }
}

}  // namespace

void print_wrapped(std::string_view text, std::size_t indent) { fmt::print("{}\n", wrapped(text, indent)); }

void print_row(const std::string& name, const std::string& value, const std::string& remark) {
  const std::string row = fmt::format("{:<34}{:>14}{}{}", name, value, remark.empty() ? "" : "   ", remark);
  print_wrapped(row, kRemarks);
}

void print_columns(const Rows& rows, std::string_view alignment) {
  const std::vector<std::size_t> widths = widths_of(rows, alignment);
  for (const auto& row : rows) print_table_row(row, widths, alignment);
}

Table::Table(std::string_view alignment, std::initializer_list<const char*> titles) : alignment_(alignment) {
  rows_.emplace_back(titles.begin(), titles.end());
}

Table& Table::row(std::string first) {
  rows_.emplace_back();
  return cell(std::move(first));
}

Table& Table::cell(std::string text) {
  rows_.back().push_back(std::move(text));
  return *this;
}

void Table::leave_out_zeros(std::size_t from) {
  for (std::size_t k = alignment_.size(); k-- > from;) {
    const bool has_zeros =
        std::all_of(rows_.begin() + 1, rows_.end(), [&](const auto& row) { return k < row.size() && row[k] == "0"; });
    if (!has_zeros) continue;
    const auto place = static_cast<std::ptrdiff_t>(k);
    alignment_.erase(k, 1);
    for (auto& row : rows_) row.erase(row.begin() + place);
  }
}

void Table::print_in_parts() const {
  std::size_t width = 0;
  for (std::size_t k = 0; k < alignment_.size(); ++k) {
    std::size_t widest = 0;
    for (const auto& row : rows_) widest = std::max(widest, columns_of(row.at(k)));
    width += 2 + widest;
  }
  if (width <= kLineWidth) return print();
  const std::size_t half = (alignment_.size() + 1) / 2;
  const auto print_part = [&](std::size_t from, std::size_t to) {
    Rows part;
    for (const auto& row : rows_) {
      part.push_back({row.front()});
      for (std::size_t k = from; k < to; ++k) part.back().push_back(row.at(k));
    }
    print_columns(part, alignment_.substr(0, 1) + alignment_.substr(from, to - from));
  };
  print_part(1, half);
  fmt::print("\n");
  print_part(half, alignment_.size());
}

Table& Table::cell(std::size_t number) { return cell(with_commas(number)); }

std::string seconds_text(double seconds) {
  return seconds < 1 ? fmt::format("{:.1f} ms", 1e3 * seconds) : fmt::format("{:.2f} s", seconds);
}

}  // namespace flowcert::cli
