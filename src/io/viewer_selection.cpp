#include <algorithm>
#include <limits>
#include <utility>

#include "io/viewer_parts.h"

namespace flowcert::io {

namespace {

double length_of(const FlowComplex& complex, const PersistencePair& pair) {
  if (!pair.death) return std::numeric_limits<double>::infinity();
  return complex.persistence().squared_distances().length(pair.birth, *pair.death).value;
}

// The pairs with the greatest lengths, at most so many of them that have a point of index 2, and of the others.
std::vector<const PersistencePair*> longest_pairs(const FlowComplex& complex, std::size_t most) {
  std::vector<std::pair<double, const PersistencePair*>> of_components, of_others;
  for (const PersistencePair& pair : complex.persistence().pairs()) {
    (pair.dimension == 0 ? of_components : of_others).emplace_back(length_of(complex, pair), &pair);
  }
  std::vector<const PersistencePair*> longest;
  for (auto* of_kind : {&of_components, &of_others}) {
    std::ranges::stable_sort(*of_kind, [](const auto& a, const auto& b) { return a.first > b.first; });
    if (of_kind->size() > most) of_kind->resize(most);
    for (const auto& entry : *of_kind) longest.push_back(entry.second);
  }
  std::ranges::sort(longest);  // the order of the list of pairs
  return longest;
}

// Loops at lower levels have more points than a thin page should.
constexpr std::uint8_t kLowestLoop = 25;

void keep_loops(const std::vector<ViewerCycle>& cycles, std::vector<bool>& is_kept) {
  for (const ViewerCycle& cycle : cycles) {
    if (cycle.pair.dimension != 1) continue;
    for (const ViewerCycle::Step& step : cycle.steps) {
      if (step.percent < kLowestLoop) break;
      for (const auto* points : {&step.chain.surface, &step.chain.edges}) {
        for (const std::uint32_t point : *points) is_kept[point] = true;
      }
    }
  }
}

// Marks what the kept points of index 2 lead to.
void keep_limits(const FlowComplex& complex, std::vector<bool>& is_kept) {
  const UnstableManifolds& u2 = complex.unstable();
  for (std::size_t i = 0; i < u2.size(); ++i) {
    if (!is_kept[u2.saddle(i)]) continue;
    for (const std::size_t side : {std::size_t{0}, std::size_t{1}}) {
      if (const auto limit = u2.limit(i, side)) is_kept[*limit] = true;
    }
  }
}

// Stationary points with a stable set of dimension 3. A volume can be too small for a double.
std::vector<bool> have_cells(const FlowComplex& complex) {
  const StationaryPoints& stationary = complex.stationary();
  std::vector<bool> has_cell(stationary.size());
  for (std::size_t i = 0; i < stationary.size(); ++i) {
    has_cell[i] = stationary.index(i).is_critical() && stationary.index(i).face_dimension == 3;
  }
  const StableManifolds& stable = complex.stable();
  for (std::size_t set = 0; set < stable.size(); ++set) {
    if (stable.has_interval(set)) has_cell[stable.record(set)] = true;
  }
  return has_cell;
}

// So many of the records, those with the greatest values, ascending.
template <typename Value>
std::vector<std::size_t> greatest(std::vector<std::size_t> records, std::size_t most, const Value& value) {
  std::ranges::stable_sort(records, [&](std::size_t a, std::size_t b) { return value(a) > value(b); });
  if (records.size() > most) records.resize(most);
  std::ranges::sort(records);
  return records;
}

}  // namespace

void choose_cells(const FlowComplex& complex, std::size_t most_cells, std::size_t most_surfaces,
                  ViewerSelection& selection) {
  const std::vector<bool> has_cell = have_cells(complex);
  selection.all_cells = static_cast<std::size_t>(std::ranges::count(has_cell, true));
  const auto has_surface = [&](std::size_t record) { return complex.stationary().index(record).face_dimension == 1; };
  for (std::size_t i = 0; i < has_cell.size(); ++i) selection.all_surfaces += has_surface(i) ? 1 : 0;
  std::vector<std::size_t> cells, surfaces;
  for (const std::size_t record : selection.records) {
    if (has_cell[record]) cells.push_back(record);
    if (has_surface(record)) surfaces.push_back(record);
  }
  selection.cells =
      greatest(std::move(cells), most_cells, [&](std::size_t record) { return complex.volumes().nearest(record); });
  // Regular stationary points are in no pair.
  std::vector<double> length(complex.stationary().size(), std::numeric_limits<double>::infinity());
  for (const PersistencePair* pair : selection.pairs) {
    length[pair->birth] = length_of(complex, *pair);
    if (pair->death) length[*pair->death] = length[pair->birth];
  }
  selection.surfaces = greatest(std::move(surfaces), most_surfaces, [&](std::size_t record) { return length[record]; });
}

ViewerSelection viewer_selection(const FlowComplex& complex, std::size_t most) {
  const StationaryPoints& stationary = complex.stationary();
  const std::size_t samples = stationary.critical_counts()[0];
  ViewerSelection selection;
  selection.all_records = stationary.size() - samples;
  std::vector<bool> is_kept(stationary.size(), true);
  if (std::ranges::all_of(stationary.critical_counts().begin() + 1, stationary.critical_counts().end(),
                          [most](std::size_t count) { return count <= most; })) {
    for (const PersistencePair& pair : complex.persistence().pairs()) selection.pairs.push_back(&pair);
    selection.cycles = viewer_cycles(complex, selection.pairs);
  } else {
    selection.pairs = longest_pairs(complex, most);
    selection.cycles = viewer_cycles(complex, selection.pairs);
    for (std::size_t i = samples; i < stationary.size(); ++i) is_kept[i] = !stationary.index(i).is_critical();
    for (const PersistencePair* pair : selection.pairs) {
      is_kept[pair->birth] = true;
      if (pair->death) is_kept[*pair->death] = true;
    }
    keep_loops(selection.cycles, is_kept);
    keep_limits(complex, is_kept);
  }
  selection.place.assign(stationary.size(), ViewerSelection::kNone);
  for (std::size_t i = samples; i < stationary.size(); ++i) {
    if (!is_kept[i]) continue;
    selection.place[i] = static_cast<std::uint32_t>(selection.records.size());
    selection.records.push_back(i);
  }
  for (std::size_t i = 0; i < stationary.critical_counts()[2]; ++i) {
    if (is_kept[complex.stable().record(i)]) selection.sets.push_back(i);
  }
  return selection;
}

}  // namespace flowcert::io
