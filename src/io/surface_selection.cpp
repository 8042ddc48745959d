// A condition becomes a threshold, and a threshold a place among the radii or lengths in ascending order.
#include "io/surface_selection.h"

#include <algorithm>
#include <numeric>
#include <string_view>

#include "geometry/floating_point.h"
#include "io/coordinate_rounding.h"
#include "io/line_reader.h"
#include "io/number_text.h"
#include "morse/log_histogram.h"
#include "morse/saddle_radii.h"

namespace flowcert {

using namespace io;

namespace {

constexpr std::string_view kPersistence = "persistence>";
constexpr std::string_view kRadius = "index2-radius<";
constexpr std::string_view kLargestGaps = "largest-gaps=";

std::string without_blanks(std::string text) {
  std::erase(text, ' ');
  return text;
}

// By number in StableManifolds.
std::vector<PairEnds> pairs_of_saddles(const FlowComplex& complex) {
  const auto& counts = complex.stationary().critical_counts();
  const std::size_t first = counts[0] + counts[1];
  std::vector<PairEnds> pairs(counts[2]);
  if (pairs.empty()) return pairs;
  // Every critical point of index 2 is in a pair that does not last (FC-PERS-02), as the death of a tunnel or the birth
  // of a void.
  for (const PersistencePair& pair : complex.persistence().pairs()) {
    if (pair.dimension == 0 || !pair.death) continue;
    const std::size_t record = pair.dimension == 1 ? *pair.death : pair.birth;
    pairs[record - first] = {pair.birth, *pair.death};
  }
  return pairs;
}

}  // namespace

SurfaceSelection::SurfaceSelection(const std::vector<std::string>& expressions) {
  const geometry::IeeeDoubles ieee;
  for (std::size_t k = 0; k < expressions.size(); ++k) add(expressions[k], k + 1);
}

void SurfaceSelection::add(const std::string& expression, std::size_t option) {
  const LinePlace place = {"--select", option};
  const std::string text = without_blanks(expression);
  const auto bound_of = [&](std::string_view number) { return length_bound_of(number, "--select", option); };
  const std::string_view rest(text);
  if (rest.starts_with(kPersistence)) {
    persistence_above_.push_back(bound_of(rest.substr(kPersistence.size())));
  } else if (rest.starts_with(kRadius)) {
    radii_below_.push_back(bound_of(rest.substr(kRadius.size())));
  } else if (rest.starts_with(kLargestGaps)) {
    const std::size_t count = written_size(rest.substr(kLargestGaps.size()), place);
    largest_gaps_ = largest_gaps_ ? std::min(*largest_gaps_, count) : count;
  } else {
    place.reject("none of persistence>X, index2-radius<R and largest-gaps=N: " + in_quotes(expression));
  }
}

// Nothing where the condition holds for all radii.
std::optional<Rational> SurfaceSelection::squared_radius_of(const LengthBound& bound, const SaddleRadii& radii,
                                                            std::optional<AutomaticThreshold>& automatic) {
  const Rational square = bound.number > 0 ? Rational(bound.number * bound.number) : Rational(0);
  switch (bound.unit) {
    case LengthBound::Unit::kInput:
      return square;
    case LengthBound::Unit::kSpacing:
      return square * radii.squared_spacing().value_or(0);
    case LengthBound::Unit::kQuantile: {
      const std::size_t place = part_of(radii.size(), bound.number);
      return place < radii.size() ? std::optional(radii.squared_radius(place)) : std::nullopt;
    }
    case LengthBound::Unit::kValley:
      break;
  }
  automatic.emplace(radii.valley());
  return automatic->valley ? std::optional(radii.squared_radius(automatic->valley->below)) : std::nullopt;
}

SelectedSets SurfaceSelection::select(const FlowComplex& complex) const {
  const geometry::IeeeDoubles ieee;
  return select(complex, SaddleRadii(complex));
}

SelectedSets SurfaceSelection::select(const FlowComplex& complex, const SaddleRadii& radii) const {
  const geometry::IeeeDoubles ieee;
  SelectedSets selected;
  std::vector<bool> is_chosen(radii.size(), true);
  auto& [radius, length, automatic_radius, automatic_length] = selected.thresholds;
  for (const LengthBound& bound : radii_below_) {
    const std::optional<Rational> square = squared_radius_of(bound, radii, automatic_radius);
    if (square) radius = radius ? std::min(*radius, *square) : *square;
  }
  if (radius) {
    for (std::size_t k = radii.count_below(*radius); k < radii.size(); ++k) is_chosen[radii.number(k)] = false;
  }
  if (!persistence_above_.empty() || largest_gaps_) {
    const ValueOrder order = length_order(complex.persistence().squared_distances(), pairs_of_saddles(complex));
    for (const LengthBound& bound : persistence_above_) {
      const auto [value, automatic] =
          threshold_of(bound, order, radii.squared_spacing(), length_rounding(complex.points()));
      if (value) length = length ? std::max(*length, *value) : *value;
      if (automatic) automatic_length = automatic;
    }
    // Equal lengths stand in descending order of the list, so that the first of them counts as the longest.
    std::size_t too_short = length ? order.count_up_to(*length) : 0;
    if (largest_gaps_) too_short = std::max(too_short, order.size() - std::min(*largest_gaps_, order.size()));
    for (std::size_t k = 0; k < too_short; ++k) is_chosen[order.at(k)] = false;
  }
  for (std::size_t i = 0; i < is_chosen.size(); ++i) {
    if (is_chosen[i]) selected.sets.push_back(i);
  }
  return selected;
}

std::vector<std::size_t> selected_sets(const FlowComplex& complex, const std::vector<std::string>& conditions) {
  const geometry::IeeeDoubles ieee;
  const SurfaceSelection selection(conditions);
  if (selection.is_empty()) {
    std::vector<std::size_t> all(complex.stationary().critical_counts()[2]);
    std::iota(all.begin(), all.end(), std::size_t{0});
    return all;
  }
  return selection.select(complex).sets;
}

}  // namespace flowcert
