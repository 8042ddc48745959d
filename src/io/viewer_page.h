// A page that shows a flow complex: one HTML file that a browser opens from disk, with nothing else
// (src/cli/manual/view.md).
//
// Guarantees: the page has the exact samples, and computes exact positions of stationary points from them. What it
// draws is rounded to floats. All combinatorial facts in it, such as contact sets, limits of orbits and pairs, are
// exact. Text of a claim, of a molecule or of a file's name cannot become markup. Nothing is loaded from elsewhere.
#pragma once

#include <cstddef>
#include <ostream>
#include <span>
#include <string>

#include "flowcert/atom_names.h"
#include "flowcert/flow_complex.h"
#include "flowcert/pockets.h"
#include "flowcert/progress.h"
#include "io/json_fields.h"
#include "io/write_pores.h"

namespace flowcert {

struct ViewerOptions {
  std::string name;  // of the input
  // Of a molecule: the names of its rows, which the page shows, and by whose elements it colours atoms.
  const AtomNames* atoms = nullptr;
  // A complex with more critical points of an index from 1 on is thinned: of the pairs of dimension 0, and of all
  // others, the page has so many, the longest, with their points and what these lead to.
  std::size_t most_of_an_index = 150000;
  // Also volumes of stable sets, where all directions lead, and to draw: so many cells S3, the largest, and so many
  // unstable sets U1, of regular stationary points and of the longest pairs.
  bool has_cells = false;
  std::size_t most_cells = 2000;
  std::size_t most_surfaces = 1000;
  // Also so many of these, the deepest.
  const Pockets* pockets = nullptr;
  std::size_t most_pockets = 500;
  // What is wrong with a claim, at its place (src/cli/manual/view.md, `claim`), or null. Its findings have a record by
  // its place in the list of stationary points.
  io::Json claim = nullptr;
};

struct ViewerCounts {
  struct Part {
    std::size_t kept = 0;
    std::size_t all = 0;
  };
  Part records;          // stationary points without those of index 0
  Part cells, surfaces;  // S3 and U1 that are drawn
  Part pockets;
};

// Writes the page. Makes all parts of the complex, and the surfaces once more. The time is that of the exports.
// Throws InvalidInput for a surface with a coordinate beyond the doubles.
ViewerCounts write_viewer_page(std::ostream& out, const FlowComplex& complex, const ViewerOptions& options,
                               const Progress& progress = {});

// A page of balls and what there is between them, without a flow complex. centres: the doubles nearest to those of the
// balls.
void write_viewer_page(std::ostream& out, const std::string& name, std::span<const Point> centres,
                       const PoresToWrite& what);

}  // namespace flowcert
