#include "certify/boundaries.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <numeric>

#include "certify/finding_words.h"

namespace flowcert::certify {

namespace {

constexpr char kBoundaryClause[] = "FC-CHAIN-01";

using Chain = std::vector<std::uint32_t>;  // ascending, mod 2

Chain sum(const Chain& a, const Chain& b) {
  Chain result;
  std::ranges::set_symmetric_difference(a, b, std::back_inserter(result));
  return result;
}

std::string chain_text(const std::vector<std::vector<PointId>>& chain) {
  constexpr std::size_t kMost = 8;
  std::string text = chain.empty() ? "nothing" : "";
  for (std::size_t i = 0; i < chain.size() && i < kMost; ++i) {
    text += (i == 0 ? "" : ", ") + names_text(chain[i]);
  }
  return chain.size() > kMost ? text + ", and more" : text;
}

// Whether the edges, pairs of class names, form a cycle mod 2.
bool is_cycle(const std::vector<std::vector<PointId>>& edges) {
  std::map<PointId, std::size_t> degrees;
  for (const auto& edge : edges) {
    for (const PointId name : edge) ++degrees[name];
  }
  return std::ranges::all_of(degrees, [](const auto& entry) { return entry.second % 2 == 0; });
}

}  // namespace

bool has_tie(Truth& truth, std::size_t record) {
  if (truth.stable_summary(record).has_vertex) return true;
  const StableSet set = truth.stable_set(record);
  return std::ranges::any_of(set.segments,
                             [](const BackwardSegment<>& segment) { return segment.back_kind == BackKind::kRegular; });
}

void Boundaries::find(std::size_t k, int level, const std::string& claimed, const std::string& truth) {
  run_.find(level, level == 4 ? FindingReason::kWrongIncidence : FindingReason::kWrongSurface, kBoundaryClause, k,
            truth, claimed);
}

void Boundaries::check(std::size_t k, const std::vector<std::vector<PointId>>& chain, int level, bool is_walk) {
  const std::size_t record = run_.placed[k].place->record;
  const std::string claimed = (is_walk ? "walking along " : "bounded by ") + chain_text(chain);
  const Rational& value = run_.truth.sphere(record).squared_radius;
  std::map<std::uint32_t, std::size_t> times;
  std::vector<std::vector<PointId>> edges;
  bool has_regular = false;
  for (const auto& rows : chain) {
    edges.push_back(class_names(run_.points, rows));
    const std::optional<Placement> place = edges.back().empty() ? std::nullopt : placement_of(run_, edges.back());
    const bool is_made = place && run_.is_made(place->record, edges.back(), 1);
    const bool is_edge = place && (run_.index(place->record).face_dimension == 1 || is_made);
    if (!is_edge || edges.back().size() != 2) {
      return find(k, level, claimed, names_text(rows) + " is no critical point of index 1");
    }
    if (run_.truth.sphere(place->record).squared_radius >= value) {
      return find(k, level, claimed, names_text(rows) + " does not lie below it");
    }
    has_regular = has_regular || is_made || !run_.index(place->record).is_critical();
    if (++times[static_cast<std::uint32_t>(place->record)] > 1 && !is_walk) {
      return find(k, level, claimed, names_text(rows) + " is named twice");
    }
  }
  Chain records;
  for (const auto& [one, count] : times) {
    if (count % 2 == 1) records.push_back(one);
  }
  const std::optional<Chain> truth = run_.truth.boundary(record);
  if (truth && records == *truth) return;
  std::string right = "its boundary is ";
  if (truth) {
    std::vector<std::vector<PointId>> names;
    for (const std::uint32_t one : *truth) {
      const auto contact = run_.truth.contact(one);
      names.emplace_back(contact.begin(), contact.end());
    }
    right += chain_text(names);
  }
  if (!is_cycle(edges)) return find(k, level, claimed, truth ? right : "a boundary is a cycle");
  if (!has_tie(run_.truth, record)) return find(k, level, claimed, right);
  if (has_regular || !truth) {
    run_.leave_unjudged(
        "which of the boundaries that ties allow are claimed, where they pass regular "
        "stationary points or the truth breaks no ties (FC-CLAIM-09)");
    if (has_regular) run_.vary(level, FindingReason::kSymbolicPerturbation, "FC-CLAIM-09", k, right);
    return;
  }
  questions_.push_back({k, level, claimed, sum(records, *truth)});
}

bool Boundaries::bounds_below(Chain& cycle) const {
  while (!cycle.empty()) {
    const Chain& row = basis_[cycle.back()];
    if (row.empty()) return false;
    cycle = sum(cycle, row);
  }
  return true;
}

void Boundaries::add_to_basis(std::size_t record) {
  Chain column = run_.truth.boundary(record).value_or(Chain{});
  if (!bounds_below(column)) basis_[column.back()] = column;
}

void Boundaries::conclude() {
  if (questions_.empty()) return;
  std::map<std::size_t, Rational> values;
  for (std::size_t i = 0; i < run_.truth.size(); ++i) {
    if (run_.index(i) == kIndex2) values[i] = run_.truth.sphere(i).squared_radius;
  }
  std::vector<std::size_t> columns;
  columns.reserve(values.size());
  for (const auto& [record, value] : values) columns.push_back(record);
  std::ranges::stable_sort(columns, {}, [&](std::size_t i) -> const Rational& { return values.at(i); });
  const auto value_of = [&](const Question& question) -> const Rational& {
    return values.at(run_.placed[question.k].place->record);
  };
  std::ranges::stable_sort(questions_, {}, value_of);
  basis_.assign(run_.truth.size(), {});
  auto next = columns.begin();
  for (Question& question : questions_) {
    for (; next != columns.end() && values.at(*next) < value_of(question); ++next) add_to_basis(*next);
    if (bounds_below(question.cycle)) {
      run_.vary(question.level, FindingReason::kTieBreak, "FC-CLAIM-09", question.k, "another way to break ties",
                question.claimed);
    } else {
      find(question.k, question.level, question.claimed, "no way to break ties gives this boundary");
    }
  }
  questions_.clear();
}

}  // namespace flowcert::certify
