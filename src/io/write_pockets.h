// Pockets and merge trees as text for other programs (spec/formats/pockets.md, src/cli/manual/pockets.md).
//
// Guarantees: rationals are exact, doubles are the nearest ones, but for areas (FC-POCK-11). The text depends on the
// points and what is asked for alone, but for times, which are not part of it.
#pragma once

#include <optional>
#include <ostream>
#include <string>

#include "flowcert/atom_names.h"
#include "flowcert/flow_complex.h"
#include "flowcert/pockets.h"

namespace flowcert {

// A radius as people give it, with its exact square.
struct Probe {
  Rational radius = 0;
  [[nodiscard]] Rational squared_radius() const { return radius * radius; }
};

struct PocketsToWrite {
  const FlowComplex& complex;
  const Pockets& pockets;
  std::optional<Probe> probe;
  bool has_exact_volumes = false;    // exact ones take as long as those of `compute --volumes exact`
  const AtomNames* atoms = nullptr;  // of a molecule
};

// One JSON object, written pocket by pocket. Makes volumes and stable manifolds.
void write_pockets(std::ostream& out, const PocketsToWrite& what);

// Tables in CSV, with a line of names: a row for each pocket, and a row for each pocket and each atom that lines it.
// Numbers are the nearest doubles, and empty beyond them. The second needs the names of atoms.
void write_pocket_csv(std::ostream& out, const PocketsToWrite& what);
void write_lining_csv(std::ostream& out, const PocketsToWrite& what);

enum class TreeKind : std::uint8_t { kPockets, kComponents };

// A merge tree as one JSON object, or as one line of Newick text, whose branches are as long as the difference of
// squared distances. A leaf without a value, infinity, has no length. The text ends with a line's end.
void write_merge_tree(std::ostream& out, const FlowComplex& complex, TreeKind kind);
void write_newick(std::ostream& out, const FlowComplex& complex, TreeKind kind);

}  // namespace flowcert
