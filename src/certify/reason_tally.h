// Why something is wrong, counted: for each reason how often it comes, and the smallest example of it.
//
// Guarantees: the order in which examples are added decides only between examples of one size; the first is kept.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "certify/layer.h"

namespace flowcert::certify {

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

}  // namespace flowcert::certify
