// A page that shows a flow complex: one HTML file that a browser opens from disk, with nothing else
// (src/cli/manual/view.md).
//
// Guarantees: the page has the exact samples, and computes exact positions of stationary points from them. What it
// draws is rounded to floats. All combinatorial facts in it, such as contact sets, limits of orbits and pairs, are
// exact. Text of a claim, of a molecule or of a file's name cannot become markup. Nothing is loaded from elsewhere.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <ostream>
#include <span>
#include <string>
#include <vector>

#include "flowcert/atom_names.h"
#include "flowcert/flow_complex.h"
#include "flowcert/pockets.h"
#include "flowcert/progress.h"

namespace flowcert {

// A sphere that proves a finding, with the samples that matter.
struct ViewerSphere {
  ExactSphere sphere;
  bool is_claimed = false;          // otherwise it is the sphere of a stationary point
  std::vector<std::size_t> inside;  // ordinals of samples, the first of them
  std::vector<std::size_t> on;      // the same
  std::size_t inside_count = 0;     // how many there are, with those that are not listed
};

// A line that is claimed to be an orbit, or to lead to where one ends.
using ViewerLine = std::vector<RationalPoint>;

// What is wrong with a claim, at its place. The texts are for people.
struct ViewerFinding {
  int level = 0;
  std::string reason;  // "missed-by-cluster"
  bool is_variation = false;
  std::string clause;
  std::optional<std::size_t> line;  // of the claim
  std::string claimed, truth, sentence;
  std::optional<int> index;               // as claimed, or the true one of what is missing
  std::optional<std::size_t> record;      // the stationary point that it is about, by its place in the list
  std::optional<RationalPoint> position;  // where it is drawn; none: it has no place
  std::vector<std::size_t> contact;       // ordinals of samples
  std::vector<ViewerSphere> spheres;
  std::vector<ViewerLine> claimed_lines;
};

struct ViewerClaim {
  std::string name;
  std::string verdict;
  double tolerance = 0;
  std::vector<ViewerFinding> findings;
  std::size_t findings_count = 0;  // with those that are not listed
  std::vector<std::string> not_judged, not_decided;
};

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
  std::optional<ViewerClaim> claim;
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

}  // namespace flowcert
