// See statistics_tables.h.
#include "cli/statistics_tables.h"

#include <fmt/format.h>

namespace flowcert::cli {

Json distribution_field(const Distribution& distribution) {
  Json field;
  field["count"] = distribution.count();
  field["mean"] = distribution.mean();
  field["max"] = distribution.max();
  field["stddev"] = distribution.standard_deviation();
  field["mode"] = distribution.mode();
  field["median"] = distribution.median();
  Json& histogram = field["histogram"] = Json::array();
  for (const auto& [value, times] : distribution.times()) histogram.push_back(std::array{value, times});
  return field;
}

Json primitives_field(const KernelTally& tally) {
  Json primitives = Json::object();
  for (std::size_t k = 0; k < kFlowPrimitiveCount; ++k) {
    Json& field = primitives[kFlowPrimitiveNames[k]];
    field["calls"] = tally.counts[k].calls;
    field["failures"] = tally.counts[k].failures;
  }
  return primitives;
}

Table distribution_table() {
  return Table("lrrrrrr", {"", "count", "mean", "max", "stddev", "mode", "median"});
}

void add_distribution(Table& table, const char* name, const Distribution& distribution) {
  table.row(name).cell(distribution.count()).cell(fmt::format("{:.2f}", distribution.mean()));
  table.cell(distribution.max()).cell(fmt::format("{:.2f}", distribution.standard_deviation()));
  table.cell(distribution.mode()).cell(fmt::format("{:g}", distribution.median()));
}

void print_primitives(const KernelTally& tally) {
  fmt::print("\nfilter failures of predicates and constructions (paper, Table 4)\n");
  Table table("lrr", {"", "failures", "calls"});
  for (std::size_t k = 0; k < kFlowPrimitiveCount; ++k) {
    table.row(kFlowPrimitiveNames[k]).cell(tally.counts[k].failures).cell(tally.counts[k].calls);
  }
  table.print();
}

}  // namespace flowcert::cli
