// See u2_report.h.
#include "cli/u2_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <string_view>

#include "cli/command.h"
#include "cli/statistics_tables.h"
#include "flowcert/orbit.h"

namespace flowcert::cli {

namespace {

using SegmentType = std::array<char, 3>;
using TypeCount = std::pair<SegmentType, std::size_t>;

// Those of the paper's Table 1 that unstable manifolds are made of, marked [x] there.
constexpr std::array<SegmentType, 11> kTypes = {{{'V', 'V', 'V'},
                                                 {'V', 'E', 'V'},
                                                 {'V', 'E', 0},
                                                 {'V', 'F', 'V'},
                                                 {'V', 'F', 'E'},
                                                 {'V', 'F', 0},
                                                 {'E', 'E', 'V'},
                                                 {'E', 'E', 0},
                                                 {'E', 'F', 'V'},
                                                 {'E', 'F', 'E'},
                                                 {'E', 'F', 0}}};
constexpr std::string_view kFaces = "VEFC";

// Zeros too; behind them whatever else came.
std::vector<TypeCount> full_census(const FlowStatistics& statistics) {
  std::vector<TypeCount> census;
  for (const SegmentType& type : kTypes) {
    const auto found = statistics.census.find(type);
    census.emplace_back(type, found == statistics.census.end() ? 0 : found->second);
  }
  for (const auto& [type, count] : statistics.census) {
    if (std::find(kTypes.begin(), kTypes.end(), type) == kTypes.end()) census.emplace_back(type, count);
  }
  return census;
}

// How many numbers have at least 2^k bytes, and fewer than twice that; by 2^k, the empty ranges in between
// too.
std::vector<std::pair<std::size_t, std::size_t>> byte_histogram(const Distribution& bytes) {
  std::map<std::size_t, std::size_t> ranges;
  for (const auto& [value, times] : bytes.times()) ranges[std::bit_floor(value)] += times;
  std::vector<std::pair<std::size_t, std::size_t>> histogram;
  for (const auto& [from, count] : ranges) {
    while (!histogram.empty() && histogram.back().first > 0 && histogram.back().first * 2 < from) {
      histogram.emplace_back(histogram.back().first * 2, 0);
    }
    histogram.emplace_back(from, count);
  }
  return histogram;
}

void add_statistics(Json& object, const FlowStatistics& statistics) {
  object["n_u2"] = distribution_field(statistics.n_u2);
  object["n_wcc"] = distribution_field(statistics.n_wcc);
  Json& census = object["census"] = Json::object();
  for (const auto& [type, count] : full_census(statistics)) census[type_text(type)] = count;
  object["primitives"] = primitives_field(statistics.tally);
  const Distribution& bytes = statistics.exact_bytes;
  Json& sizes = object["exact_bytes"];
  sizes["count"] = bytes.count();
  sizes["mean"] = bytes.mean();
  sizes["max"] = bytes.max();
  Json& histogram = sizes["histogram"] = Json::array();
  for (const auto& [from, count] : byte_histogram(bytes)) histogram.push_back(std::array{from, count});
  object["depth"] = statistics.depth;
}

void print_lengths(const FlowStatistics& statistics) {
  fmt::print("\nlengths in flow segments (paper, Table 3)\n");
  Table table = distribution_table();
  add_distribution(table, "n_U2, orbits", statistics.n_u2);
  add_distribution(table, "n_WCC, cascades", statistics.n_wcc);
  table.print();
}

// A line for each type that starts in this face, under the face that it crosses; two cells a type.
void add_census_lines(Table& table, const std::vector<TypeCount>& census, char start) {
  std::array<std::vector<TypeCount>, kFaces.size()> by_crossed;
  for (const TypeCount& entry : census) {
    if (entry.first[0] == start) by_crossed[kFaces.find(entry.first[1])].push_back(entry);
  }
  std::size_t height = 0;
  for (const auto& entries : by_crossed) height = std::max(height, entries.size());
  for (std::size_t k = 0; k < height; ++k) {
    table.row(k == 0 ? std::string(1, start) : "");
    for (const auto& entries : by_crossed) {
      if (k < entries.size()) {
        table.cell(type_text(entries[k].first)).cell(entries[k].second);
      } else {
        table.cell("").cell("");
      }
    }
  }
}

void print_census(const FlowStatistics& statistics) {
  fmt::print("\nflow segments by the Voronoi faces where they start, cross, end (paper, Table 1)\n");
  const std::vector<TypeCount> census = full_census(statistics);
  Table table("llrlrlrlr", {"start", "cross V", "", "cross E", "", "cross F"});
  for (const char start : kFaces) add_census_lines(table, census, start);
  table.print();
}

void print_exact_numbers(const FlowStatistics& statistics) {
  const Distribution& bytes = statistics.exact_bytes;
  fmt::print("\nbytes of exact coordinates (paper, Figure 12): mean {:.1f}, at most {}\n", bytes.mean(),
             with_commas(bytes.max()));
  Table table("rr", {"from", "numbers"});
  for (const auto& [from, count] : byte_histogram(bytes)) table.row(with_commas(from)).cell(count);
  table.print();
}

}  // namespace

void print_u2_rows(const FlowStatistics& statistics) {
  print_row("orbits", with_commas(statistics.n_u2.count()), "two from each critical point of index 2");
  print_row("orbits to critical points", with_commas(statistics.to_critical));
  print_row("orbits to regular points", with_commas(statistics.to_regular),
            "where critical points of two indices collide");
  print_row("orbits to infinity", with_commas(statistics.to_infinity));
  print_row("flow segments computed", with_commas(statistics.segments_computed));
}

void print_u2_statistics(const FlowStatistics& statistics) {
  print_lengths(statistics);
  print_census(statistics);
  print_primitives(statistics.tally);
  print_exact_numbers(statistics);
  fmt::print("\ndeepest construction (paper, Table 5): {}\n", with_commas(statistics.depth));
}

Json u2_field(const U2Choice& choice, const FlowStatistics& statistics) {
  Json object;
  object["kernel"] = choice.flow.kernel;
  object["search"] = choice.flow.search;
  object["sharing"] = !choice.alone;
  object["orbits"] = statistics.n_u2.count();
  object["to_critical"] = statistics.to_critical;
  object["to_regular"] = statistics.to_regular;
  object["to_infinity"] = statistics.to_infinity;
  object["segments_computed"] = statistics.segments_computed;
  if (choice.with_statistics) add_statistics(object, statistics);
  return object;
}

}  // namespace flowcert::cli
