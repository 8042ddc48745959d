// Gives `flowcert check` the oracle, which src/ does not know. In a program with this no command is absent.
#include "cli/check_command.h"
#include "fuzz/commands/commands.h"
#include "fuzz/judge/oracle_truth.h"

namespace flowcert::commands {

void add_check_command(CLI::App& app, int& status) {
  cli::add_check_command(app, status,
                         {kMostPointsForOracle, [](const std::vector<Point>& rows) { return oracle_truth(rows); },
                          [](const std::vector<Point>& rows) { return oracle_pairs(rows); }});
}

void put_absent_commands_apart(CLI::App& /*app*/) {}

}  // namespace flowcert::commands
