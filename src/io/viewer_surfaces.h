// The unstable sets U1 that a page draws (src/cli/manual/view.md, `cells.u1`).
//
// Guarantees: of the sets that are chosen, every sheet, segment and run is there, cut at the frame's box.
#pragma once

#include <vector>

#include "flowcert/flow_complex.h"
#include "io/json_fields.h"
#include "io/layer.h"
#include "io/viewer_frame.h"
#include "io/viewer_selection.h"

namespace flowcert::io {

// Made by as many threads as the complex.
[[nodiscard]] Json viewer_surfaces_field(const FlowComplex& complex, const ViewerFrame& frame,
                                         const ViewerSelection& selection);

}  // namespace flowcert::io
