// Which stationary points a viewer page has, all of them or, of a large complex, those with the longest pairs; and of
// which of them it draws the cells and the unstable sets.
//
// Guarantees: where something is left out, the same is left out in every run. Points that a kept one leads to are kept.
// The lengths of pairs are compared as doubles, since this only decides what is drawn. Samples are always kept.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "flowcert/flow_complex.h"
#include "io/layer.h"

namespace flowcert::io {

struct ViewerSelection {
  static constexpr std::uint32_t kNone = 0xffffffffu;

  std::vector<std::size_t> records;           // kept places in the list, ascending, without index 0
  std::vector<std::uint32_t> place;           // by record: where it is in `records`, or kNone
  std::vector<std::size_t> sets;              // kept critical points of index 2, by number in StableManifolds
  std::vector<const PersistencePair*> pairs;  // those whose ends are kept
  std::size_t all_records = 0;                // with those that are left out, without index 0
  std::vector<std::size_t> cells;             // records whose cells are drawn, ascending
  std::size_t all_cells = 0;                  // stable sets of dimension 3
  std::vector<std::size_t> surfaces;          // records whose U1 is drawn, ascending
  std::size_t all_surfaces = 0;               // sets U1
};

// most: of each index. The points that these need come on top.
[[nodiscard]] ViewerSelection viewer_selection(const FlowComplex& complex, std::size_t most);
// Chooses so many cells and surfaces of the kept records: the largest cells, by their rounded volumes, and the
// surfaces of regular points and of the longest pairs.
void choose_cells(const FlowComplex& complex, std::size_t most_cells, std::size_t most_surfaces,
                  ViewerSelection& selection);

}  // namespace flowcert::io
