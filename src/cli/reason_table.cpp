#include "cli/reason_table.h"

#include <fmt/format.h>

#include <algorithm>

#include "cli/glossary.h"
#include "cli/table.h"

namespace flowcert::cli {

void ReasonTally::add(const std::string& reason, std::size_t size, std::size_t example) {
  const auto [place, is_new] = by_reason_.try_emplace(reason, ReasonRow{reason, 0, size, example});
  ReasonRow& row = place->second;
  ++row.count;
  if (is_new || size >= row.size) return;
  row.size = size;
  row.example = example;
}

std::vector<ReasonRow> ReasonTally::rows() const {
  std::vector<ReasonRow> rows;
  rows.reserve(by_reason_.size());
  for (const auto& [reason, row] : by_reason_) rows.push_back(row);
  sort_reasons(rows);
  return rows;
}

void sort_reasons(std::vector<ReasonRow>& rows) {
  std::ranges::sort(rows, [](const ReasonRow& a, const ReasonRow& b) {
    return a.count != b.count ? a.count > b.count : a.reason < b.reason;
  });
}

std::string points_text(std::size_t count) { return fmt::format("{} point{}", count, count == 1 ? "" : "s"); }

Json reasons_field(const std::vector<ReasonRow>& rows, const std::function<Json(const ReasonRow&)>& smallest) {
  Json reasons = Json::array();
  for (const ReasonRow& row : rows) {
    reasons.push_back(
        {{"reason", row.reason}, {"cases", row.count}, {"smallest", smallest(row)}, {"smallest_points", row.size}});
  }
  return reasons;
}

void print_meanings(const std::vector<ReasonRow>& rows) {
  for (const ReasonRow& row : rows) {
    if (const GlossaryEntry* const entry = entry_of(row.reason)) {
      print_wrapped(fmt::format("  {}: {}", entry->word, entry->meaning), 4);
    }
  }
}

void print_reasons(const std::vector<ReasonRow>& rows, const char* counted,
                   const std::function<std::string(const ReasonRow&)>& name) {
  if (rows.empty()) return;
  Table table("lrl", {"reason", counted, "smallest example"});
  for (const ReasonRow& row : rows) table.row(row.reason).cell(row.count).cell(name(row));
  table.print();
  print_meanings(rows);
  fmt::print("\n");
}

}  // namespace flowcert::cli
