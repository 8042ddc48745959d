// See s2_report.h.
#include "cli/s2_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/command.h"
#include "cli/statistics_tables.h"

namespace flowcert::cli {

void print_s2_rows(const StationaryPoints& stationary, const StableManifolds& s2) {
  const StableStatistics& statistics = s2.statistics();
  print_row("triangles of S2", with_commas(statistics.triangle_count), "where it is a surface");
  if (statistics.largest) {
    print_row(
        "triangles of the largest S2", with_commas(statistics.triangles.max()),
        fmt::format("of contact set {}", fmt::join(stationary.contact(s2.record(*statistics.largest)), " ")));
  }
  print_row("S2 through Voronoi vertices", with_commas(statistics.with_vertex));
  print_row("S2 with parts of dimension 3", with_commas(statistics.with_interval));
  print_row("branches to regular points", with_commas(statistics.ends_at_regular),
            "where critical points of two indices collide");
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
  Json object;
  object["kernel"] = choice.flow.kernel;
  object["search"] = choice.flow.search;
  object["sets"] = s2.size();
  object["triangles"] = statistics.triangle_count;
  object["largest_triangles"] = statistics.triangles.max();
  Json& largest = object["largest_contact"] = nullptr;
  if (statistics.largest) largest = stationary.contact(s2.record(*statistics.largest));
  object["through_vertex"] = statistics.with_vertex;
  object["with_interval"] = statistics.with_interval;
  object["to_regular"] = statistics.ends_at_regular;
  if (!choice.with_statistics) return object;
  object["n_s2"] = distribution_field(statistics.n_s2);
  object["triangles_of_set"] = distribution_field(statistics.triangles);
  object["primitives"] = primitives_field(statistics.tally);
  return object;
}

}  // namespace flowcert::cli
