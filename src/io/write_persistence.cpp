// Pairs are ordered by exact values. If the values are equal, the records decide.
#include "flowcert/write_persistence.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <numeric>
#include <span>
#include <sstream>
#include <tuple>
#include <utility>

#include "flowcert/reproducibility.h"
#include "geometry/difference_of_roots.h"
#include "geometry/floating_point.h"
#include "geometry/portions.h"
#include "geometry/prefetch.h"
#include "io/ordered_text.h"

namespace flowcert {

namespace {

std::size_t critical_count(const StationaryPoints& stationary) {
  const auto& counts = stationary.critical_counts();
  return std::accumulate(counts.begin(), counts.end(), std::size_t{0});
}

// Sorting is quick if what it compares lies together.
struct RankedPair {
  std::uint64_t ranks = 0;  // of the values of birth and death
  PersistencePair pair;
};

void sort_pairs(const SquaredDistances& values, std::vector<PersistencePair>& pairs) {
  constexpr std::uint32_t kLast = 0xffffffffu;
  std::vector<RankedPair> ranked;
  ranked.reserve(pairs.size());
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    geometry::prefetch_ahead(k, pairs.size(), [&](std::size_t later) {
      if (const auto& death = pairs[later].death) values.prefetch(*death);
    });
    const PersistencePair& pair = pairs[k];
    const std::uint32_t death = pair.death ? values.rank(*pair.death) : kLast;
    ranked.push_back({std::uint64_t{values.rank(pair.birth)} << 32 | death, pair});
  }
  std::ranges::sort(ranked, {},
                    [](const RankedPair& one) { return std::tuple(one.pair.dimension, one.ranks, one.pair.birth); });
  std::ranges::transform(ranked, pairs.begin(), &RankedPair::pair);
}

// By record: neighbours in the list have points in common.
std::vector<double> rounded_values(const PersistenceDiagram& diagram, PersistenceValues values) {
  const StationaryPoints& stationary = diagram.complex().stationary();
  std::vector<double> rounded(diagram.has_zero() ? stationary.size() : critical_count(stationary));
  constexpr std::size_t kPortion = geometry::portion_size(512);
  geometry::in_portions(diagram.complex().threads(), rounded.size(), kPortion, {}, [&](std::size_t, std::size_t k) {
    geometry::prefetch_ahead(
        k, rounded.size(), [&](std::size_t later) { diagram.complex().points().prefetch(stationary.contact(later)); });
    rounded[k] = values == PersistenceValues::kSquared ? diagram.rounded_squared_value(k) : diagram.rounded_value(k);
  });
  return rounded;
}

// Every record that was rounded is an end of a pair.
void require_doubles(const std::vector<double>& rounded) {
  if (std::ranges::all_of(rounded, [](double value) { return std::isfinite(value); })) return;
  throw InvalidInput(
      "a squared distance is beyond the largest double, which a .pers file cannot say; --json has it exactly");
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

void write_pers(std::ostream& out, const PersistenceDiagram& diagram, PersistenceValues values) {
  const geometry::IeeeDoubles ieee;
  const std::vector<double> rounded = rounded_values(diagram, values);
  require_doubles(rounded);
  const Reproducibility made_by = reproducibility();
  const bool is_squared = values == PersistenceValues::kSquared;
  out << fmt::format(
      "# Persistence of the distance function: dimension, birth, death. The values are {}.\n"
      "# flowcert {} (commit {}; kernel: {}; compiler: {}; CGAL {}), input_sha256 {}\n",
      is_squared ? "squared distances" : "distances", made_by.version, made_by.commit, made_by.kernel, made_by.compiler,
      made_by.cgal, coordinates_sha256(diagram.complex().points()));
  if (const auto& left_out = diagram.complex().points().left_out(); !left_out.empty()) {
    out << fmt::format("# Rows of the file that were left out: {}\n", fmt::join(left_out, " "));
  }
  out << (diagram.has_zero() ? "# With regular stationary points, as pairs of length zero.\n"
                             : "# Without pairs of length zero.\n");
  if (!is_squared) out << kPlainValuesMark << '\n';
  const auto prefetch = [&](std::size_t place) {
    const PersistencePair& pair = diagram.pairs()[place];
    __builtin_prefetch(&rounded[pair.birth]);
    if (pair.death) __builtin_prefetch(&rounded[*pair.death]);
  };
  const auto make = [&](std::size_t first, std::size_t last, std::string& lines) {
    const auto end = std::back_inserter(lines);
    for (std::size_t k = first; k < last; ++k) {
      geometry::prefetch_ahead(k, diagram.pairs().size(), prefetch);
      const PersistencePair& pair = diagram.pairs()[k];
      fmt::format_to(end, "{} {} ", pair.dimension, rounded[pair.birth]);
      pair.death ? fmt::format_to(end, "{}\n", rounded[*pair.death]) : fmt::format_to(end, "inf\n");
    }
  };
  const auto write = [&out](const std::string& lines, std::size_t) { return !(out << lines).fail(); };
  io::write_in_order(diagram.pairs().size(), io::kShortRecords, diagram.complex().threads(), make, write);
}

std::string pers_text(const PersistenceDiagram& diagram, PersistenceValues values) {
  std::ostringstream text;
  write_pers(text, diagram, values);
  return std::move(text).str();
}

}  // namespace flowcert
