// Pairs are ordered by exact values. If the values are equal, the records decide.
#include "flowcert/write_persistence.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#include "flowcert/reproducibility.h"
#include "io/ordered_text.h"

namespace flowcert {

namespace {

std::size_t critical_count(const StationaryPoints& stationary) {
  const auto& counts = stationary.critical_counts();
  return std::accumulate(counts.begin(), counts.end(), std::size_t{0});
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
  if (with_zero) add_regular();
  std::ranges::sort(pairs_, [this](const PersistencePair& a, const PersistencePair& b) { return is_before(a, b); });
}

void PersistenceDiagram::add_regular() {
  const StationaryPoints& stationary = complex_.stationary();
  for (std::size_t record = critical_count(stationary); record < stationary.size(); ++record) {
    const StationaryIndex index = stationary.index(record);
    for (int dimension = index.face_dimension; dimension < index.hull_dimension; ++dimension) {
      pairs_.push_back({dimension, record, record});
    }
  }
}

// A strict order by values, then by records.
bool PersistenceDiagram::is_before(const PersistencePair& a, const PersistencePair& b) const {
  if (a.dimension != b.dimension) return a.dimension < b.dimension;
  const SquaredDistances& values = complex_.persistence().squared_distances();
  const std::uint32_t birth_a = values.rank(a.birth), birth_b = values.rank(b.birth);
  if (birth_a != birth_b) return birth_a < birth_b;
  if (!a.death || !b.death) return a.death.has_value();
  const std::uint32_t death_a = values.rank(*a.death), death_b = values.rank(*b.death);
  if (death_a != death_b) return death_a < death_b;
  return a.birth < b.birth;
}

std::string pers_text(const PersistenceDiagram& diagram) {
  const Reproducibility made_by = reproducibility();
  std::string text = fmt::format(
      "# Persistence of the distance function: dimension, birth, death. The values are squared distances.\n"
      "# flowcert {} (commit {}; kernel: {}; compiler: {}; CGAL {}), input_sha256 {}\n",
      made_by.version, made_by.commit, made_by.kernel, made_by.compiler, made_by.cgal,
      coordinates_sha256(diagram.complex().points()));
  text += diagram.has_zero() ? "# With regular stationary points, as pairs of length zero.\n"
                             : "# Without pairs of length zero.\n";
  const auto make = [&](std::size_t first, std::size_t last, std::string& lines) {
    for (const PersistencePair& pair : std::span(diagram.pairs()).subspan(first, last - first)) {
      lines += fmt::format("{} {} {}\n", pair.dimension, double_text(diagram.rounded_squared_value(pair.birth)),
                           pair.death ? double_text(diagram.rounded_squared_value(*pair.death)) : "inf");
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
