#include "cli/reason_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "cli/glossary.h"
#include "cli/table.h"

namespace flowcert::cli {

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

// ---- Outcomes ----

std::size_t OutcomeRow::cases() const { return std::accumulate(counts.begin(), counts.end(), std::size_t{0}); }

void print_outcomes(const char* what, const std::vector<std::string>& outcomes, const std::vector<OutcomeRow>& rows) {
  Table table("l" + std::string(outcomes.size() + 1, 'r'), {what, "cases"});
  for (const std::string& outcome : outcomes) table.cell(outcome_title(outcome));
  for (const OutcomeRow& row : rows) {
    table.row(row.name).cell(row.cases());
    for (const std::size_t count : row.counts) table.cell(count);
  }
  table.leave_out_zeros(3);
  table.print_in_parts();
}

std::string outcome_title(const std::string& outcome) {
  return outcome == "conforms where determined" ? "determined" : outcome;
}

std::string outcome_key(std::string outcome) {
  std::ranges::replace(outcome, ' ', '_');
  return outcome;
}

void add_outcomes(Json& object, const std::vector<std::string>& outcomes, const OutcomeRow& row) {
  object["cases"] = row.cases();
  for (std::size_t k = 0; k < outcomes.size(); ++k) object[outcome_key(outcomes[k])] = row.counts.at(k);
}

Json outcome_rows_field(const char* what, const std::vector<std::string>& outcomes,
                        const std::vector<OutcomeRow>& rows) {
  Json field = Json::array();
  for (const OutcomeRow& row : rows) {
    Json& object = field.emplace_back();
    object[what] = row.name;
    add_outcomes(object, outcomes, row);
  }
  return field;
}

}  // namespace flowcert::cli
