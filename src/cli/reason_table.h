// The tables of reports of many cases. One says why something is wrong, counted (certify/reason_tally.h). The other
// says how many cases have which outcome.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "certify/reason_tally.h"
#include "cli/layer.h"
#include "io/json_fields.h"

namespace flowcert::cli {

// "1 point", "4 points"
[[nodiscard]] std::string points_text(std::size_t count);

// Reports for programs have the table as this array. smallest: the name or number of the example.
[[nodiscard]] Json reasons_field(const std::vector<ReasonRow>& rows,
                                 const std::function<Json(const ReasonRow&)>& smallest);

// Prints what each reason means, where the glossary has it.
void print_meanings(const std::vector<ReasonRow>& rows);

// Prints a line for each reason, if there is any: "missed-by-cluster  148  stationary-0003"; below what they mean; and
// an empty line. counted: the title of the numbers, "cases". name: of the example.
void print_reasons(const std::vector<ReasonRow>& rows, const char* counted,
                   const std::function<std::string(const ReasonRow&)>& name);

// ---- Outcomes ----

// How many cases of a flag, a group or a family have which outcome.
struct OutcomeRow {
  std::string name;
  std::vector<std::size_t> counts;  // by outcome
  std::size_t skipped = 0;          // cases beside these

  // Without the skipped ones.
  [[nodiscard]] std::size_t cases() const;
};

// The columns of outcomes, as "conforms where determined", that no case has are left out, but not the first.
void print_outcomes(const char* what, const std::vector<std::string>& outcomes, const std::vector<OutcomeRow>& rows);
// "determined", "timed out"
[[nodiscard]] std::string outcome_title(const std::string& outcome);
// "conforms_where_determined", "timed_out"
[[nodiscard]] std::string outcome_key(std::string outcome);
// `cases`, and a key for each outcome, appended to an object.
void add_outcomes(Json& object, const std::vector<std::string>& outcomes, const OutcomeRow& row);
// An array of such objects, each with its name first.
[[nodiscard]] Json outcome_rows_field(const char* what, const std::vector<std::string>& outcomes,
                                      const std::vector<OutcomeRow>& rows);

}  // namespace flowcert::cli
