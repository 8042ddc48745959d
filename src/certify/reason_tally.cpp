#include "certify/reason_tally.h"

#include <algorithm>

namespace flowcert::certify {

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

}  // namespace flowcert::certify
