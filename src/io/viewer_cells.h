// What a page says of the whole complex, if it is asked for: volumes of stable sets, and connections
// (spec/formats/view.md, `cells`).
//
// Guarantees: connections are exact, and volumes are the nearest doubles.
#pragma once

#include "flowcert/flow_complex.h"
#include "io/json_fields.h"
#include "io/layer.h"
#include "io/viewer_selection.h"

namespace flowcert::io {

[[nodiscard]] Json viewer_cells_field(const FlowComplex& complex, const ViewerSelection& selection);

}  // namespace flowcert::io
