// What the parts of a viewer page are made of, and the parts that have files of their own (src/cli/manual/view.md).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "flowcert/flow_complex.h"
#include "flowcert/pockets.h"
#include "io/json_fields.h"
#include "io/layer.h"

namespace flowcert::io {

// src/viewer/page.html, without data, as it was when the program was compiled. A program that has the page elsewhere
// defines this function itself: what it returns has kPlaceOfData once.
[[nodiscard]] std::string_view viewer_template();
inline constexpr std::string_view kPlaceOfData = R"(<script type="application/json" id="flowcert-data">null</script>)";

// ---- Arrays ----
// Planes of bytes, compressed, in base64.
//
// Guarantees: the page gets the same numbers, to the bit. Planes make the compressed text a third shorter, because
// neighbouring numbers have the same leading bytes.
[[nodiscard]] Json viewer_blob(std::span<const double> numbers);
[[nodiscard]] Json viewer_blob(std::span<const float> numbers);
[[nodiscard]] Json viewer_blob(std::span<const std::uint32_t> numbers);
[[nodiscard]] Json viewer_blob(std::span<const std::uint8_t> numbers);

// ---- The frame ----
// The bounding box of points becomes a box within [-1, 1]^3, which it fits in its longest direction.
//
// Guarantees: positions are finite floats, whatever the scale of the input. They are for drawing alone.
class ViewerFrame {
 public:
  // What is unbounded is cut at the box [-kClip, kClip]^3.
  static constexpr double kClip = 3;

  explicit ViewerFrame(std::span<const Point> points);

  [[nodiscard]] const std::array<double, 3>& origin() const { return origin_; }
  [[nodiscard]] double unit() const { return unit_; }

  [[nodiscard]] std::array<double, 3> placed(const Point& point) const;
  [[nodiscard]] std::array<double, 3> placed(const RationalPoint& point) const;
  void append(std::vector<float>& to, const Point& point) const {
    for (const double x : placed(point)) to.push_back(static_cast<float>(x));
  }
  // A length, such as a radius.
  [[nodiscard]] double scaled(double length) const;

 private:
  std::array<double, 3> origin_{};
  double unit_ = 1;
};

// ---- Cycles ----
// What stands for a pair of dimension 1 or 2 at the levels from its death down to its birth (io/cycles.h).
struct ViewerCycle {
  struct Chain {
    std::vector<std::uint32_t> surface, edges;  // of a loop; of a void its walls alone
    std::vector<std::uint32_t> maxima, cell;    // of a void

    friend bool operator==(const Chain&, const Chain&) = default;
  };
  // From the percent of the way, in squared distances, on down. That of the first step is 100: right below the death.
  struct Step {
    std::uint8_t percent = 0;
    Chain chain;
  };

  PersistencePair pair;
  std::vector<Step> steps;
};

// The hundred longest pairs of dimension 1, and of dimension 2, among those of these that have a death.
// Makes merge trees.
//
// Guarantees: exact at each whole percent, and the same for any number of threads.
[[nodiscard]] std::vector<ViewerCycle> viewer_cycles(const FlowComplex& complex,
                                                     const std::vector<const PersistencePair*>& pairs);

// ---- The selection ----
// Which stationary points a page has, all of them or, of a large complex, those with the longest pairs; and of which of
// them it draws the cells and the unstable sets.
//
// Guarantees: where something is left out, the same is left out in every run. Points that a kept one leads to are kept.
// The lengths of pairs are compared as doubles, since this only decides what is drawn. Samples are always kept.
struct ViewerSelection {
  static constexpr std::uint32_t kNone = 0xffffffffu;

  std::vector<std::size_t> records;           // kept places in the list, ascending, without index 0
  std::vector<std::uint32_t> place;           // by record: where it is in `records`, or kNone
  std::vector<std::size_t> sets;              // kept critical points of index 2, by number in StableManifolds
  std::vector<const PersistencePair*> pairs;  // those whose ends are kept
  std::vector<ViewerCycle> cycles;            // of these pairs; loops are whole from 25% up
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

// ---- Fields ----
// A whole complex has volumes of stable sets, connections, the faces of cells, and unstable sets, if they are asked for.
//
// Guarantees: connections are exact, volumes are the nearest doubles, and faces are closed around each cell.
[[nodiscard]] Json viewer_cells_field(const FlowComplex& complex, const ViewerFrame& frame,
                                      const ViewerSelection& selection);

// The chains of the selection's cycles, from the death down to the level below which the page lacks points of them.
// s2_vertices: those that the page has of its surfaces, in the frame.
//
// Guarantees: mod 2, the boundary of a loop's triangles is its edges, and a void's triangles are closed.
[[nodiscard]] Json viewer_cycles_field(const FlowComplex& complex, const ViewerFrame& frame,
                                       const ViewerSelection& selection, const std::vector<float>& s2_vertices);

// The unstable sets U1 that a page draws. Made by as many threads as the complex.
//
// Guarantees: of the sets that are chosen, every sheet, segment and run is there, cut at the frame's box.
[[nodiscard]] Json viewer_surfaces_field(const FlowComplex& complex, const ViewerFrame& frame,
                                         const ViewerSelection& selection);

// So many pockets, the deepest, with their surfaces and mouths. Makes volumes and stable manifolds. Throws InvalidInput
// for a coordinate beyond the doubles.
//
// Guarantees: what belongs to which pocket is exact. Depths and volumes are the nearest doubles.
[[nodiscard]] Json viewer_pockets_field(const FlowComplex& complex, const ViewerFrame& frame, const Pockets& pockets,
                                        std::size_t most);

}  // namespace flowcert::io
