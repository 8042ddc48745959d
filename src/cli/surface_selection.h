// Which surfaces S2 `flowcert surface` writes: expressions of --select, all of which must hold
// (spec/formats.md, "Surfaces").
//
// Guarantees: thresholds are the decimals or fractions that are written, and compared exactly.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/surface_run.h"
#include "io/line_reader.h"

namespace flowcert::cli {

class SurfaceSelection {
 public:
  // Throws InvalidInput, one line, for what is no expression.
  explicit SurfaceSelection(const std::vector<std::string>& expressions);

  // Critical points of index 2, by their numbers in StableManifolds, ascending.
  [[nodiscard]] std::vector<std::size_t> sets(const SurfaceRun& run) const;

 private:
  // place: which of the options it is, for messages.
  void add(const std::string& expression, const LinePlace& place);

  std::optional<Rational> persistence_above_;
  std::optional<Rational> radius_below_;
  std::optional<std::size_t> largest_gaps_;
};

}  // namespace flowcert::cli
