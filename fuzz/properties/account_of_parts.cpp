// The account; see account_of_parts.h for what it guarantees.
#include "fuzz/properties/account_of_parts.h"

#include <bit>
#include <cstdint>

#include "flowcert/persistence.h"
#include "flowcert/stable_manifolds.h"
#include "flowcert/unstable_manifolds.h"

namespace flowcert::property {

namespace {

std::string text_of(const Distribution& distribution) {
  std::string text;
  for (const auto& [value, times] : distribution.times()) {
    text += std::to_string(value) + ':' + std::to_string(times) + ' ';
  }
  return text + '\n';
}

std::string text_of(const KernelTally& tally) {
  std::string text;
  for (const FilterCount& count : tally.counts) {
    text += std::to_string(count.calls) + '/' + std::to_string(count.failures) + ' ';
  }
  return text + '\n';
}

}  // namespace

std::string account_of_parts(const FlowComplex& complex) {
  std::string text;
  const auto add = [&text](std::size_t number) { text += std::to_string(number) + ' '; };
  const StationaryPoints& points = complex.stationary();
  for (std::size_t i = 0; i < points.size(); ++i) {
    add(points.index(i).face_dimension), add(points.index(i).hull_dimension), add(points.face(i));
    add(points.contact(i).size());
    for (const PointId id : points.contact(i)) add(id);
  }
  for (const FilterCount& count : complex.filter_tally().counts) add(count.calls), add(count.failures);
  const FlowStatistics& u2 = complex.unstable().statistics();
  for (std::size_t i = 0; i < complex.unstable().size(); ++i) {
    for (const std::size_t side : {0U, 1U}) add(complex.unstable().limit(i, side).value_or(points.size()));
  }
  for (const auto& [type, count] : u2.census) text += type_text(type) + ' ' + std::to_string(count) + '\n';
  text += text_of(u2.n_u2) + text_of(u2.n_wcc) + text_of(u2.exact_bytes) + text_of(u2.tally);
  add(u2.segments_computed), add(u2.depth), add(u2.to_critical), add(u2.to_regular), add(u2.to_infinity);
  const StableManifolds& stable = complex.stable();
  for (std::size_t i = 0; i < stable.size(); ++i) {
    add(stable.segment_count(i)), add(stable.has_vertex(i)), add(stable.has_interval(i));
    if (!points.index(stable.record(i)).is_critical()) continue;
    add(stable.boundary(i).size());
    for (const std::uint32_t record : stable.boundary(i)) add(record);
  }
  const StableStatistics& s2 = stable.statistics();
  text += text_of(s2.n_s2) + text_of(s2.triangles) + text_of(s2.tally);
  add(s2.triangle_count), add(s2.largest.value_or(points.size())), add(s2.with_vertex), add(s2.with_interval);
  add(s2.ends_at_regular), add(s2.broken_ties);
  for (const PersistencePair& pair : complex.persistence().pairs()) {
    add(pair.birth), add(pair.death.value_or(points.size()));
  }
  for (std::size_t i = 0; i < points.size(); ++i) add(std::bit_cast<std::uint64_t>(complex.volumes().nearest(i)));
  add(complex.volumes().decided_exactly());
  return text;
}

}  // namespace flowcert::property
