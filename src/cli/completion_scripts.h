// Scripts by which shells complete the words of a command line. One is made of what the command line offers, so it
// names every command, option and value that can be listed, and no other.
//
// Guarantees: a script needs its shell alone, and starts no program. Names of files are completed by their endings, but
// any file is offered where none has such an ending.
#pragma once

#include <string>

#include "cli/described_command.h"
#include "cli/layer.h"

namespace flowcert::cli {

[[nodiscard]] std::string bash_completion(const DescribedCommand& program);
[[nodiscard]] std::string zsh_completion(const DescribedCommand& program);
[[nodiscard]] std::string fish_completion(const DescribedCommand& program);

}  // namespace flowcert::cli
