// Pockets: the stable sets of maxima, merged by persistence, and what leads out of them.
//
// Guarantees: exact, on every input. Infinity counts as a maximum without end, and its pocket is the outside. Neither
// ids nor the order of the input decide. Numbers of stationary points are places in the list. Source: spec section 15
// (clauses FC-POCK).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "flowcert/merge_trees.h"
#include "flowcert/rational.h"
#include "flowcert/stable_volumes.h"

namespace flowcert {

// A widest path to infinity. Its least squared distance is that of its gates.
struct WidestPath {
  std::vector<std::uint32_t> gates;  // where such paths come to the outside (FC-POCK-07): one at least, ascending

  friend bool operator==(const WidestPath&, const WidestPath&) = default;
};

struct Pocket {
  std::vector<std::uint32_t> maxima;      // ascending, here and below
  std::vector<std::uint32_t> peaks;       // the highest of them: the pocket's position
  std::vector<std::uint32_t> cell;        // the stationary points whose stable sets make the pocket (FC-POCK-03)
  std::vector<std::uint32_t> mouths;      // one at least (FC-POCK-04)
  std::vector<std::uint32_t> neighbours;  // pockets, by number; the outside has the number of pockets
  std::uint32_t highest_mouth = 0;        // the first of those that are highest
  WidestPath to_infinity;

  friend bool operator==(const Pocket&, const Pocket&) = default;
};

// What a pocket is for a probe (FC-POCK-06).
enum class Passage : std::uint8_t { kCavity, kPocket, kChannel };
// "cavity", "pocket", "channel"
[[nodiscard]] const char* passage_text(Passage passage);

// Const access is safe from several threads.
class Pockets {
 public:
  // The trees must outlive this. A persistence is a difference of distances; its square is given, which is rational
  // where it is a multiple of the samples' spacing. Throws std::invalid_argument for a negative one. O(n log n), but
  // for the sets of maxima above one point (MergeTrees).
  Pockets(const MergeTrees& trees, const Rational& squared_persistence);

  [[nodiscard]] std::size_t size() const { return pockets_.size(); }
  // They come in the order of their first maxima.
  [[nodiscard]] const Pocket& operator[](std::size_t number) const { return pockets_[number]; }
  // The cell of each, as long as this lives.
  [[nodiscard]] std::vector<std::span<const std::uint32_t>> cells() const;
  // The maxima that belong to the outside, ascending.
  [[nodiscard]] const std::vector<std::uint32_t>& outside() const { return outside_; }
  [[nodiscard]] const Rational& squared_persistence() const { return squared_persistence_; }

  // The numbers of the pockets above a stationary point, ascending; the outside has the number size(). What flows to
  // the point is in a pocket iff it is the only one. There is none above a sample.
  [[nodiscard]] std::vector<std::uint32_t> above(std::size_t record) const;

  // The double nearest to the distance at the peaks less that at the highest mouth, which are not squared.
  [[nodiscard]] double depth(const Pocket& pocket) const;
  // The same difference of squared distances, which is positive.
  [[nodiscard]] Rational difference_of_squares(const Pocket& pocket) const;
  // The radius is not negative, and what is equal passes.
  [[nodiscard]] Passage passage(const Pocket& pocket, const Rational& squared_radius) const;

  // The samples nearest to some point inside of the pocket: those in whose Voronoi cells parts of it with a volume lie
  // (FC-POCK-03). Names, ascending.
  [[nodiscard]] static std::vector<PointId> lining(const Pocket& pocket, const StableVolumes& volumes);

  // Of the whole. Nothing iff there is no pocket.
  [[nodiscard]] std::optional<WidestPath> widest_path() const;
  // The maxima of the largest balls (FC-POCK-08), ascending. Empty iff there is no pocket.
  [[nodiscard]] std::vector<std::uint32_t> largest_balls() const;

  // Distances are compared here, too.
  [[nodiscard]] const SquaredDistances& squared_distances() const { return trees_->squared_distances(); }

 private:
  void add_peaks();
  void add_cells_and_mouths();

  const MergeTrees* trees_;
  Rational squared_persistence_;
  std::vector<std::uint32_t> number_of_;  // by leaf of the tree of pockets
  std::vector<Pocket> pockets_;
  std::vector<std::uint32_t> outside_;
};

}  // namespace flowcert
