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

// src/viewer/page.html, without data, as it was when the program was compiled.
[[nodiscard]] std::string_view viewer_template();

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
// The input's bounding box becomes a box within [-1, 1]^3, which it fits in its longest direction.
//
// Guarantees: positions are finite floats, whatever the scale of the input. They are for drawing alone.
class ViewerFrame {
 public:
  // What is unbounded is cut at the box [-kClip, kClip]^3.
  static constexpr double kClip = 3;

  explicit ViewerFrame(const PointSet& points);

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
