// What `flowcert pockets` prints for people: how distances are meant, the counts, and tables of the deepest pockets,
// their mouths and, of a molecule, the residues that line them (src/cli/manual/pockets.md).
#pragma once

#include <optional>

#include "cli/command.h"
#include "cli/layer.h"
#include "flowcert/pockets.h"
#include "io/write_pockets.h"
#include "morse/length_bound.h"

namespace flowcert::cli {

struct PocketsReport {
  const Input& input;
  const PocketsToWrite& what;
  std::optional<AutomaticThreshold> automatic;
  bool shows_all = false;  // and not the deepest alone
  double delaunay_seconds = 0, other_seconds = 0;
};

// Makes persistence where there is no pocket, to say how long the longest tunnel is.
void print_pockets_report(const PocketsReport& report);

}  // namespace flowcert::cli
