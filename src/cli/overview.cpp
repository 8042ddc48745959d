// Groups, lines and examples are those of --help. Commands that set up a shell are only there. All fits 24 lines,
// without blank ones.
#include "cli/overview.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "cli/described_command.h"

namespace flowcert::cli {

std::string overview(const CLI::App& app) {
  const DescribedCommand program = described(app);
  std::size_t width = 0;
  for (const DescribedCommand& command : program.commands) width = std::max(width, command.last_name().size());
  std::string text = fmt::format("{}\n{} COMMAND --help tells more.\n", program.description, program.name);
  // A group stands where its first command does, and has all of its commands.
  std::vector<std::pair<std::string, std::string>> groups;
  for (const DescribedCommand& command : program.commands) {
    if (command.group == kSetUpGroup) continue;
    auto group = std::ranges::find(groups, command.group, &std::pair<std::string, std::string>::first);
    if (group == groups.end()) group = groups.insert(group, {command.group, ""});
    group->second += fmt::format("  {:<{}}  {}\n", command.last_name(), width, command.description);
  }
  for (const auto& [name, lines] : groups) text += name + '\n' + lines;
  text += "Begin with\n";
  for (const std::string& example : program.footer.examples) text += fmt::format("  {}\n", example);
  return text;
}

}  // namespace flowcert::cli
