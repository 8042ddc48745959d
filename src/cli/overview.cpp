// Groups, lines and examples are those of --help. Commands that set up a shell are only there. All fits 24 lines,
// without blank ones.
#include "cli/overview.h"

#include <fmt/format.h>

#include <algorithm>

#include "cli/described_command.h"

namespace flowcert::cli {

std::string overview(const CLI::App& app) {
  const DescribedCommand program = described(app);
  std::size_t width = 0;
  for (const DescribedCommand& command : program.commands) width = std::max(width, command.last_name().size());
  std::string text = fmt::format("{}\n{} COMMAND --help tells more.\n", program.description, program.name);
  std::string group;
  for (const DescribedCommand& command : program.commands) {
    if (command.group == kSetUpGroup) continue;
    if (command.group != group) text += command.group + '\n';
    group = command.group;
    text += fmt::format("  {:<{}}  {}\n", command.last_name(), width, command.description);
  }
  text += "Begin with\n";
  for (const std::string& example : program.footer.examples) text += fmt::format("  {}\n", example);
  return text;
}

}  // namespace flowcert::cli
