// Manual pages, in roff's man macros: one of the program, and one of each command.
//
// Guarantees: pages say what --help says, and name the same options. They are ASCII, and lines are short.
//
// The code is our own. Debian's help2man reads the text of --help, and expects GNU's layout in it. It knows no
// commands below a program, and takes our headings and broken lines for prose. Here the same facts are at hand.
#pragma once

#include <string>

#include "cli/described_command.h"
#include "cli/layer.h"

namespace flowcert::cli {

// "flowcert-fuzz-merge": the name of its page, without ".1".
[[nodiscard]] std::string page_name(const DescribedCommand& command);
// `version` stands below each page: "flowcert 1.0.0".
[[nodiscard]] std::string manual_page(const DescribedCommand& program, const DescribedCommand& command,
                                      const std::string& version);

}  // namespace flowcert::cli
