// The tables of reports of many cases. One says why something is wrong, counted: for each reason how often it comes,
// and the smallest example of it. The other says how many cases have which outcome.
//
// Guarantees: the order in which examples are added decides only between examples of one size; the first is kept.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "cli/layer.h"
#include "io/json_fields.h"

namespace flowcert::cli {

struct ReasonRow {
  std::string reason;
  std::size_t count = 0;    // of cases, or of findings in one claim
  std::size_t size = 0;     // of the smallest example, in points
  std::size_t example = 0;  // which one it is, as the caller counts
};

class ReasonTally {
 public:
  void add(const std::string& reason, std::size_t size, std::size_t example);
  // What comes most often is first. Reasons that come equally often are in alphabetical order.
  [[nodiscard]] std::vector<ReasonRow> rows() const;

 private:
  std::map<std::string, ReasonRow> by_reason_;
};

// Rows as ReasonTally gives them, whoever counted.
void sort_reasons(std::vector<ReasonRow>& rows);

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
