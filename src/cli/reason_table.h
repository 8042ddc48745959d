// Why something is wrong, counted: for each reason how often it comes, and the smallest example of it.
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

}  // namespace flowcert::cli
