// Pairs are ordered by exact values. If the values are equal, the records decide.
#include "flowcert/write_persistence.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <span>
#include <tuple>

#include "flowcert/reproducibility.h"
#include "geometry/difference_of_roots.h"
#include "geometry/floating_point.h"
#include "io/ordered_text.h"

namespace flowcert {

namespace {

std::size_t critical_count(const StationaryPoints& stationary) {
  const auto& counts = stationary.critical_counts();
  return std::accumulate(counts.begin(), counts.end(), std::size_t{0});
}

// Sorting is quick if what it compares lies together.
struct RankedPair {
  int dimension = 0;
  std::uint32_t birth = 0, death = 0;  // ranks of the values
  PersistencePair pair;
};

void sort_pairs(const SquaredDistances& values, std::vector<PersistencePair>& pairs) {
  constexpr std::uint32_t kLast = 0xffffffffu;
  std::vector<RankedPair> ranked;
  ranked.reserve(pairs.size());
  for (const PersistencePair& pair : pairs) {
    ranked.push_back({pair.dimension, values.rank(pair.birth), pair.death ? values.rank(*pair.death) : kLast, pair});
  }
  std::ranges::sort(ranked, {}, [](const RankedPair& one) {
    return std::tuple(one.dimension, one.birth, one.death, one.pair.birth);
  });
  std::ranges::transform(ranked, pairs.begin(), &RankedPair::pair);
}

std::string double_text(double value) {
  if (!std::isfinite(value)) {
    throw InvalidInput(
        "a squared distance is beyond the largest double, which a .pers file cannot say; --json has it "
        "exactly");
  }
  return fmt::format("{}", value);
}

}  // namespace

PersistenceDiagram::PersistenceDiagram(const FlowComplex& complex, bool with_zero)
    : complex_(complex), has_zero_(with_zero), pairs_(complex.persistence().pairs()) {
  const geometry::IeeeDoubles ieee;
  if (with_zero) add_regular();
  sort_pairs(complex.persistence().squared_distances(), pairs_);
}

void PersistenceDiagram::add_regular() {
  const StationaryPoints& stationary = complex_.stationary();
  for (std::size_t record = critical_count(stationary); record < stationary.size(); ++record) {
    const StationaryIndex index = stationary.index(record);
    for (int dimension = index.face_dimension; dimension < index.hull_dimension; ++dimension) {
      pairs_.push_back({dimension, static_cast<std::uint32_t>(record), static_cast<std::uint32_t>(record)});
    }
  }
}

double PersistenceDiagram::rounded_value(std::size_t record) const {
  const geometry::IeeeDoubles ieee;
  return geometry::nearest_difference_of_roots(squared_value(record), 0);
}

std::string pers_text(const PersistenceDiagram& diagram, PersistenceValues values) {
  const geometry::IeeeDoubles ieee;
  const Reproducibility made_by = reproducibility();
  const bool is_squared = values == PersistenceValues::kSquared;
  std::string text = fmt::format(
      "# Persistence of the distance function: dimension, birth, death. The values are {}.\n"
      "# flowcert {} (commit {}; kernel: {}; compiler: {}; CGAL {}), input_sha256 {}\n",
      is_squared ? "squared distances" : "distances", made_by.version, made_by.commit, made_by.kernel, made_by.compiler,
      made_by.cgal, coordinates_sha256(diagram.complex().points()));
  if (const auto& left_out = diagram.complex().points().left_out(); !left_out.empty()) {
    text += fmt::format("# Rows of the file that were left out: {}\n", fmt::join(left_out, " "));
  }
  text += diagram.has_zero() ? "# With regular stationary points, as pairs of length zero.\n"
                             : "# Without pairs of length zero.\n";
  if (!is_squared) text += fmt::format("{}\n", kPlainValuesMark);
  const auto value = [&](std::size_t record) {
    return double_text(is_squared ? diagram.rounded_squared_value(record) : diagram.rounded_value(record));
  };
  const auto make = [&](std::size_t first, std::size_t last, std::string& lines) {
    for (const PersistencePair& pair : std::span(diagram.pairs()).subspan(first, last - first)) {
      lines += fmt::format("{} {} {}\n", pair.dimension, value(pair.birth), pair.death ? value(*pair.death) : "inf");
    }
  };
  const auto write = [&text](const std::string& lines, std::size_t) {
    text += lines;
    return true;
  };
  io::write_in_order(diagram.pairs().size(), io::kShortRecords, diagram.complex().threads(), make, write);
  return text;
}

}  // namespace flowcert
