// The pockets that a page has, with their surfaces and mouths (src/cli/manual/view.md, `pockets`).
//
// Guarantees: what belongs to which pocket is exact. Depths and volumes are the nearest doubles.
#pragma once

#include <cstddef>

#include "flowcert/flow_complex.h"
#include "flowcert/pockets.h"
#include "io/json_fields.h"
#include "io/layer.h"
#include "io/viewer_frame.h"

namespace flowcert::io {

// most: so many pockets are there, the deepest. Makes volumes and stable manifolds. Throws InvalidInput for a
// coordinate beyond the doubles.
[[nodiscard]] Json viewer_pockets_field(const FlowComplex& complex, const ViewerFrame& frame, const Pockets& pockets,
                                        std::size_t most);

}  // namespace flowcert::io
