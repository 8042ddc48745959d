// See statistics_tables.h.
#include "cli/statistics_tables.h"

#include <fmt/format.h>

#include "cli/command.h"
#include "cli/table.h"

namespace flowcert {

Json distribution_field(const Distribution& distribution) {
  Json field = {{"count", distribution.count()}, {"mean", distribution.mean()},
                {"max", distribution.max()},     {"stddev", distribution.standard_deviation()},
                {"mode", distribution.mode()},   {"median", distribution.median()},
                {"histogram", Json::array()}};
  for (const auto& [value, times] : distribution.times()) {
    field["histogram"].push_back(Json::array({value, times}));
  }
  return field;
}

Json primitives_field(const KernelTally& tally) {
  Json primitives = Json::object();
  for (std::size_t k = 0; k < kFlowPrimitiveCount; ++k) {
    const FilterCount& count = tally.counts[k];
    primitives[kFlowPrimitiveNames[k]] = {{"calls", count.calls}, {"failures", count.failures}};
  }
  return primitives;
}

std::vector<std::string> distribution_cells(const std::string& name, const Distribution& distribution) {
  return {name,
          with_commas(distribution.count()),
          fmt::format("{:.2f}", distribution.mean()),
          with_commas(distribution.max()),
          fmt::format("{:.2f}", distribution.standard_deviation()),
          with_commas(distribution.mode()),
          fmt::format("{:g}", distribution.median())};
}

void print_primitives(const KernelTally& tally) {
  fmt::print("\nfilter failures of predicates and constructions (paper, Table 4)\n");
  std::vector<std::vector<std::string>> lines = {{"", "failures", "calls"}};
  for (std::size_t k = 0; k < kFlowPrimitiveCount; ++k) {
    const FilterCount& count = tally.counts[k];
    lines.push_back({kFlowPrimitiveNames[k], with_commas(count.failures), with_commas(count.calls)});
  }
  print_columns(lines, "lrr");
}

}  // namespace flowcert
