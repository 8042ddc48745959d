// Which critical points of index 2 make a surface, by their radii or the lengths of their persistence pairs.
//
// Guarantees: a selection is decided exactly, also one without units. Points of one radius, or of one length, are
// chosen together, but by largest-gaps.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "flowcert/flow_complex.h"
#include "morse/length_bound.h"

namespace flowcert {

namespace morse {
class SaddleRadii;
}  // namespace morse

// What the conditions of a selection came to; nothing where there is no such condition, or where it holds for all.
struct SurfaceThresholds {
  std::optional<Rational> squared_radius_below;
  std::optional<Rational> squared_persistence_above;
  // What `auto` found, where it was asked for.
  std::optional<AutomaticThreshold> automatic_radius, automatic_persistence;
};

struct SelectedSets {
  std::vector<std::size_t> sets;  // by number in StableManifolds, ascending
  SurfaceThresholds thresholds;
};

// Chooses the critical points of index 2 that make a surface. All conditions have to hold, so of several alike
// the sharpest one decides.
class SurfaceSelection {
 public:
  // Conditions, as selected_sets() takes them (flowcert/surface.h).
  explicit SurfaceSelection(const std::vector<std::string>& expressions);

  // Conditions on persistence need the whole complex.
  [[nodiscard]] SelectedSets select(const FlowComplex& complex) const;
  // With radii of the same complex, for parts of this library that have them.
  [[nodiscard]] SelectedSets select(const FlowComplex& complex, const morse::SaddleRadii& radii) const;
  // Whether it chooses all of them, without a condition.
  [[nodiscard]] bool is_empty() const { return radii_below_.empty() && persistence_above_.empty() && !largest_gaps_; }

 private:
  // option: the ordinal of the expression, from 1, for messages.
  void add(const std::string& expression, std::size_t option);
  [[nodiscard]] static std::optional<Rational> squared_radius_of(const LengthBound& bound,
                                                                 const morse::SaddleRadii& radii,
                                                                 std::optional<AutomaticThreshold>& automatic);

  std::vector<LengthBound> radii_below_;
  std::vector<LengthBound> persistence_above_;
  std::optional<std::size_t> largest_gaps_;
};

}  // namespace flowcert
