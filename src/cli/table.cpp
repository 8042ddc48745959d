#include "cli/table.h"

#include <fmt/format.h>

#include <algorithm>

#include "cli/command.h"

namespace flowcert::cli {

void print_row(const std::string& name, const std::string& value, const std::string& remark) {
  fmt::print("{:<34}{:>14}{}{}\n", name, value, remark.empty() ? "" : "   ", remark);
}

void print_columns(const std::vector<std::vector<std::string>>& rows, std::string_view alignment) {
  std::vector<std::size_t> width(alignment.size(), 0);
  for (const auto& row : rows) {
    for (std::size_t k = 0; k < row.size(); ++k) width[k] = std::max(width[k], row[k].size());
  }
  for (const auto& row : rows) {
    std::string line;
    for (std::size_t k = 0; k < row.size(); ++k) {
      line +=
          alignment[k] == 'r' ? fmt::format("  {:>{}}", row[k], width[k]) : fmt::format("  {:<{}}", row[k], width[k]);
    }
    fmt::print("{}\n", line.substr(0, line.find_last_not_of(' ') + 1));
  }
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

Table& Table::cell(std::size_t number) { return cell(with_commas(number)); }

std::string seconds_text(double seconds) {
  return seconds < 1 ? fmt::format("{:.1f} ms", 1e3 * seconds) : fmt::format("{:.2f} s", seconds);
}

}  // namespace flowcert::cli
