// What check() found wrong with a claim, at its place in a viewer page.
//
// Guarantees: the samples inside a sphere and on it are found exactly. A finding with no place, such as a wrong count,
// has none.
#pragma once

#include <optional>
#include <ostream>
#include <string>

#include "flowcert/check.h"
#include "flowcert/flow_complex.h"
#include "io/viewer_page.h"

namespace flowcert {

struct ViewerClaimOptions {
  std::string name;  // of the claim
  double tolerance = kDefaultTolerance;
  // After the first findings of each reason, so many findings are listed at most.
  std::size_t most = 500;
};

// The report must be of this claim, checked against this complex or one of the same points. Each listed finding takes a
// scan of all points.
[[nodiscard]] io::Json viewer_claim(const FlowComplex& complex, const Claim& claim, const CheckReport& report,
                                    const ViewerClaimOptions& options);

// What a program has written, whether it can be read or not.
struct ClaimText {
  std::string bytes;
  std::string name;  // for messages
};

// The page of a few points and of what is wrong with a claim of them, made by this thread alone. A claim
// that cannot be read is not shown, and the page says why. Throws what write_viewer_page() throws.
void write_claim_page(std::ostream& out, const PointSet& points, const std::string& name,
                      const std::optional<ClaimText>& claim, const CheckOptions& options = {});

}  // namespace flowcert
