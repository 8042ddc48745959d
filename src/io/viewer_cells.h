// What a page has of the whole complex, if it is asked for: volumes of stable sets, connections, the faces of cells,
// and unstable sets U1 (src/cli/manual/view.md, `cells`).
//
// Guarantees: connections are exact, volumes are the nearest doubles, and faces are closed around each cell.
#pragma once

#include "flowcert/flow_complex.h"
#include "io/json_fields.h"
#include "io/layer.h"
#include "io/viewer_frame.h"
#include "io/viewer_selection.h"

namespace flowcert::io {

[[nodiscard]] Json viewer_cells_field(const FlowComplex& complex, const ViewerFrame& frame,
                                      const ViewerSelection& selection);

}  // namespace flowcert::io
