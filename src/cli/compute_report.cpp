// Everything that `flowcert compute` says, from single distributions to the whole table.
#include "cli/compute_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>

#include "cli/command.h"
#include "cli/histogram.h"
#include "cli/rough_number.h"
#include "flowcert/connections.h"
#include "flowcert/orbit.h"

namespace flowcert::cli {

// ---- Distributions ----

Json distribution_field(const Distribution& distribution) {
  Json histogram = Json::array();
  for (const auto& [value, times] : distribution.times()) histogram.push_back(std::array{value, times});
  return {{"count", distribution.count()},    {"mean", distribution.mean()},
          {"max", distribution.max()},        {"stddev", distribution.standard_deviation()},
          {"mode", distribution.mode()},      {"median", distribution.median()},
          {"histogram", std::move(histogram)}};
}

Table distribution_table() { return Table("lrrrrrr", {"", "count", "mean", "max", "stddev", "mode", "median"}); }

void add_distribution(Table& table, const char* name, const Distribution& distribution) {
  table.row(name).cell(distribution.count()).cell(fmt::format("{:.2f}", distribution.mean()));
  table.cell(distribution.max()).cell(fmt::format("{:.2f}", distribution.standard_deviation()));
  table.cell(distribution.mode()).cell(fmt::format("{:g}", distribution.median()));
}

namespace {

Json primitives_field(const KernelTally& tally) {
  Json primitives = Json::object();
  for (std::size_t k = 0; k < kFlowPrimitiveCount; ++k) {
    primitives[kFlowPrimitiveNames[k]] = {{"calls", tally.counts[k].calls}, {"failures", tally.counts[k].failures}};
  }
  return primitives;
}

void print_primitives(const KernelTally& tally) {
  fmt::print("\nfilter failures of predicates and constructions (paper, Table 4)\n");
  Table table("lrr", {"", "failures", "calls"});
  for (std::size_t k = 0; k < kFlowPrimitiveCount; ++k) {
    table.row(kFlowPrimitiveNames[k]).cell(tally.counts[k].failures).cell(tally.counts[k].calls);
  }
  table.print();
}

// ---- U2 ----

using SegmentType = std::array<char, 3>;
using TypeCount = std::pair<SegmentType, std::size_t>;

// The types of segments that unstable manifolds are made of; the paper's Table 1 marks them [x].
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

// The counts of all kTypes, zeros too, and then of any other types that occurred.
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

void add_statistics(Json& object, const FlowStatistics& statistics) {
  object["n_u2"] = distribution_field(statistics.n_u2);
  object["n_wcc"] = distribution_field(statistics.n_wcc);
  Json& census = object["census"] = Json::object();
  for (const auto& [type, count] : full_census(statistics)) census[type_text(type)] = count;
  object["primitives"] = primitives_field(statistics.tally);
  const Distribution& bytes = statistics.exact_bytes;
  Json histogram = Json::array();
  for (const Bin& bin : doubling_bins(bytes)) histogram.push_back(std::array{bin.first, bin.count});
  object["exact_bytes"] = {
      {"count", bytes.count()}, {"mean", bytes.mean()}, {"max", bytes.max()}, {"histogram", std::move(histogram)}};
  object["depth"] = statistics.depth;
}

void print_lengths(const FlowStatistics& statistics) {
  fmt::print("\nlengths in flow segments (paper, Table 3)\n");
  Table table = distribution_table();
  add_distribution(table, "n_U2, orbits", statistics.n_u2);
  add_distribution(table, "n_WCC, cascades", statistics.n_wcc);
  table.print();
}

// Adds the types that start in this face, each in the column of the face that it crosses. Each type fills two cells.
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
  fmt::print("\nflow segments by the Voronoi faces where they start, cross, end (Table 1)\n");
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
  for (const Bin& bin : doubling_bins(bytes)) table.row(with_commas(bin.first)).cell(bin.count);
  table.print();
}

void print_u2_rows(const FlowStatistics& statistics) {
  print_row("orbits", with_commas(statistics.n_u2.count()), "two from each index-2 saddle");
  print_row("orbits to critical points", with_commas(statistics.to_critical));
  print_row("orbits to regular points", with_commas(statistics.to_regular), "where two indices collide");
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
  Json object = {{"kernel", choice.flow.kernel},
                 {"search", choice.flow.search},
                 {"sharing", !choice.alone},
                 {"orbits", statistics.n_u2.count()},
                 {"to_critical", statistics.to_critical},
                 {"to_regular", statistics.to_regular},
                 {"to_infinity", statistics.to_infinity},
                 {"segments_computed", statistics.segments_computed}};
  if (choice.with_statistics) add_statistics(object, statistics);
  return object;
}

// ---- S2 ----

void print_s2_rows(const StationaryPoints& stationary, const StableManifolds& s2) {
  const StableStatistics& statistics = s2.statistics();
  print_row("triangles of S2", with_commas(statistics.triangle_count), "where it is a surface");
  if (statistics.largest) {
    print_row("triangles of the largest S2", with_commas(statistics.triangles.max()),
              fmt::format("of contact set {}", fmt::join(stationary.contact(s2.record(*statistics.largest)), " ")));
  }
  print_row("S2 through Voronoi vertices", with_commas(statistics.with_vertex));
  print_row("S2 with parts of dimension 3", with_commas(statistics.with_interval));
  print_row("branches to regular points", with_commas(statistics.ends_at_regular), "where two indices collide");
}

void print_s2_statistics(const StableStatistics& statistics) {
  fmt::print("\nlengths in flow segments (paper, Table 3), and sizes\n");
  Table table = distribution_table();
  add_distribution(table, "n_S2, down to index 1", statistics.n_s2);
  add_distribution(table, "triangles of an S2", statistics.triangles);
  table.print();
  print_primitives(statistics.tally);
}

Json s2_field(const U2Choice& choice, const StationaryPoints& stationary, const StableManifolds& s2) {
  const StableStatistics& statistics = s2.statistics();
  Json largest;
  if (statistics.largest) largest = stationary.contact(s2.record(*statistics.largest));
  Json object = {{"kernel", choice.flow.kernel},
                 {"search", choice.flow.search},
                 {"sets", s2.size()},
                 {"triangles", statistics.triangle_count},
                 {"largest_triangles", statistics.triangles.max()},
                 {"largest_contact", std::move(largest)},
                 {"through_vertex", statistics.with_vertex},
                 {"with_interval", statistics.with_interval},
                 {"to_regular", statistics.ends_at_regular}};
  if (!choice.with_statistics) return object;
  object["n_s2"] = distribution_field(statistics.n_s2);
  object["triangles_of_set"] = distribution_field(statistics.triangles);
  object["primitives"] = primitives_field(statistics.tally);
  return object;
}

// ---- The whole complex ----

struct LimitTotals {
  std::size_t directions = 0, arcs = 0;
};

LimitTotals totals_of(const FlowLimits& limits) {
  LimitTotals totals;
  for (std::size_t i = 0; i < limits.size(); ++i) {
    totals.directions += limits.direction_count(i);
    totals.arcs += limits.arc_count(i);
  }
  return totals;
}

// Why the input is not Morse-Smale.
struct Obstacles {
  std::size_t regular, with_interval, ends_elsewhere;

  [[nodiscard]] bool are_none() const { return regular + with_interval + ends_elsewhere == 0; }
};

Obstacles obstacles_of(const FlowComplex& complex) {
  const RegularCounts& regular = complex.stationary().regular_counts();
  return {.regular = regular.kind12 + regular.kind13 + regular.kind23,
          .with_interval = complex.stable().statistics().with_interval,
          .ends_elsewhere = orbits_that_end_elsewhere(complex.stationary(), complex.limits())};
}

std::string obstacle_text(const Obstacles& obstacles) {
  std::vector<std::string> reasons;
  const auto add = [&reasons](std::size_t count, const char* what) {
    if (count > 0) reasons.push_back(fmt::format("{}: {}", what, with_commas(count)));
  };
  add(obstacles.regular, "regular points");
  add(obstacles.with_interval, "S2 of dimension 3");
  add(obstacles.ends_elsewhere, "orbits of U2 to no maximum");
  return fmt::format("{}", fmt::join(reasons, ", "));
}

// What flows to infinity is found from rounded volumes, because exact ones take long on large inputs. Their roundings
// add up to less than 2^-53 of the hull's volume, unless volumes are subnormal. Nothing if a volume is beyond the
// doubles.
std::optional<Rational> volume_to_infinity(const FlowComplex& complex) {
  const StableVolumes& volumes = complex.volumes();
  Rational rest = volumes.hull();
  for (std::size_t i = 0; i < complex.stationary().size(); ++i) {
    const double volume = volumes.nearest(i);
    if (!std::isfinite(volume)) return std::nullopt;
    if (volume != 0) rest -= Rational(volume);
  }
  return rest < 0 ? Rational(0) : rest;
}

Json nearest_field(const Rational& number) {
  const std::optional<double> nearest = nearest_double(number);
  return nearest ? Json(*nearest) : Json(nullptr);
}

void print_whole_complex_rows(const FlowComplex& complex) {
  const FlowLimits& limits = complex.limits();
  const LimitTotals totals = totals_of(limits);
  print_row("lists of limits", with_commas(limits.size()), "where all directions lead");
  print_row("single directions in them", with_commas(totals.directions));
  print_row("arcs of directions in them", with_commas(totals.arcs));
  print_row("connections", with_commas(connections(limits).size()), "to points and to infinity");
  const Obstacles obstacles = obstacles_of(complex);
  print_row("Morse-Smale", obstacles.are_none() ? "yes" : "no", obstacle_text(obstacles));
  const std::optional<Rational> rest = volume_to_infinity(complex);
  print_row("volume of the convex hull", rough_text(complex.volumes().hull()));
  print_row("volume that flows to infinity", rest ? rough_text(*rest) : "?", "hull - rounded volumes");
}

Json whole_complex_field(const FlowComplex& complex) {
  const FlowLimits& limits = complex.limits();
  const LimitTotals totals = totals_of(limits);
  const Obstacles obstacles = obstacles_of(complex);
  const Rational& hull = complex.volumes().hull();
  const std::optional<Rational> rest = volume_to_infinity(complex);
  return {{"lists", limits.size()},
          {"directions", totals.directions},
          {"arcs", totals.arcs},
          {"connections", connections(limits).size()},
          {"morse_smale", obstacles.are_none()},
          {"with_interval", obstacles.with_interval},
          {"ends_elsewhere", obstacles.ends_elsewhere},
          {"hull_volume", to_text(hull)},
          {"hull_volume_double", nearest_field(hull)},
          {"volume_to_infinity_double", rest ? nearest_field(*rest) : Json(nullptr)},
          {"volumes_decided_exactly", complex.volumes().decided_exactly()}};
}

// ---- The report ----

// In bytes; Linux counts kilobytes.
unsigned long long peak_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<unsigned long long>(usage.ru_maxrss) * 1024;
}

void print_counts(const PointSet& points, const StationaryPoints& stationary) {
  print_point_counts(points);
  constexpr const char* kMeaning[] = {"minima: the points themselves", "saddles on Gabriel edges",
                                      "saddles on Delaunay facets", "maxima"};
  for (std::size_t k = 0; k < 4; ++k) {
    print_row(fmt::format("critical points of index {}", k), with_commas(stationary.critical_counts()[k]), kMeaning[k]);
  }
  const RegularCounts& regular = stationary.regular_counts();
  print_row("regular stationary points 1-2", with_commas(regular.kind12), "indices 1 and 2 collide");
  print_row("regular stationary points 1-3", with_commas(regular.kind13), "indices 1, 2, 2 and 3 collide");
  print_row("regular stationary points 2-3", with_commas(regular.kind23), "indices 2 and 3 collide");
  print_row("Euler sum", fmt::format("{}", stationary.euler_sum()));
}

}  // namespace

void print_compute_table(const Input& input, const Measured& measured, const U2Choice& choice) {
  const FlowComplex& complex = *measured.last;
  print_input(input);
  print_counts(input.points, complex.stationary());
  if (measured.has_u2()) print_u2_rows(complex.unstable().statistics());
  if (measured.has_s2()) print_s2_rows(complex.stationary(), complex.stable());
  if (measured.has_all()) print_whole_complex_rows(complex);
  print_times(measured);
  for (std::size_t k = 0; k < kPredicateCount; ++k) {
    const FilterCount& count = complex.filter_tally().counts[k];
    print_row(fmt::format("filter failures, {}", kPredicateNames[k]), with_commas(count.failures),
              fmt::format("of {} calls", with_commas(count.calls)));
  }
  print_row("peak memory", fmt::format("{:.1f} MiB", static_cast<double>(peak_memory()) / (1024 * 1024)));
  if (measured.has_u2() && choice.with_statistics) print_u2_statistics(complex.unstable().statistics());
  if (measured.has_s2() && choice.with_statistics) print_s2_statistics(complex.stable().statistics());
}

Json compute_summary(const Input& input, const Measured& measured, const U2Choice& choice) {
  const FlowComplex& complex = *measured.last;
  Json summary = header_fields("flowcert-summary", 1, input.points);
  add_counts(summary, input.points, complex.stationary());
  summary["dimension"] = complex.dimension();
  summary["euler"] = complex.stationary().euler_sum();
  summary["runs"] = measured.runs;
  add_times(summary, measured);
  Json& filters = summary["filters"] = Json::object();
  for (std::size_t k = 0; k < kPredicateCount; ++k) {
    const FilterCount& count = complex.filter_tally().counts[k];
    filters[kPredicateNames[k]] = {{"calls", count.calls}, {"failures", count.failures}};
  }
  if (measured.has_u2()) summary["u2"] = u2_field(choice, complex.unstable().statistics());
  if (measured.has_s2()) summary["s2"] = s2_field(choice, complex.stationary(), complex.stable());
  if (measured.has_all()) summary["whole_complex"] = whole_complex_field(complex);
  summary["peak_memory_bytes"] = peak_memory();
  return summary;
}

void print_compute_summary(const Input& input, const Measured& measured, const U2Choice& choice) {
  fmt::print("{}\n", compute_summary(input, measured, choice).dump());
}

}  // namespace flowcert::cli
