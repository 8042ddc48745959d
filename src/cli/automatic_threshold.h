// What `auto` chose among, and why.
#pragma once

#include <string>

#include "cli/layer.h"
#include "io/json_fields.h"
#include "morse/length_bound.h"

namespace flowcert::cli {

// A row of a table: where the valley is and how many are on both sides; or that there is none, and what follows.
// what: what the histogram is of, as "radii".
void print_automatic(const std::string& what, const AutomaticThreshold& found, const std::string& without);

// {"valley": {"from", "to", "count", "below", "beyond"}}, or null there.
[[nodiscard]] io::Json automatic_field(const AutomaticThreshold& found);

}  // namespace flowcert::cli
