#include "cli/automatic_threshold.h"

#include <fmt/format.h>

#include "cli/command.h"
#include "cli/rough_number.h"
#include "cli/table.h"

namespace flowcert::cli {

void print_automatic(const std::string& what, const AutomaticThreshold& found, const std::string& without) {
  const std::string name = "valley of " + what;
  if (!found.valley) {
    print_row(name, "none", "their histogram has one heap alone: " + without);
    return;
  }
  const auto& [bin, below, beyond] = *found.valley;
  print_row(name, with_commas(bin.count),
            fmt::format("from {} to {} x the spacing; {} below the threshold, {} beyond", rough_text(bin.from),
                        rough_text(bin.to), with_commas(below), with_commas(beyond)));
}

io::Json automatic_field(const AutomaticThreshold& found) {
  io::Json valley;
  if (found.valley) {
    const auto& [bin, below, beyond] = *found.valley;
    valley = {{"from", to_text(bin.from)},
              {"to", to_text(bin.to)},
              {"count", bin.count},
              {"below", below},
              {"beyond", beyond}};
  }
  io::Json field;
  field["valley"] = std::move(valley);
  return field;
}

}  // namespace flowcert::cli
