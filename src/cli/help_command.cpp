// `flowcert help`: the help of a command, or what a word means.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <vector>

#include "cli/command.h"
#include "cli/glossary.h"
#include "cli/layer.h"
#include "cli/table.h"
#include "cli/wrapped_text.h"
#include "io/number_text.h"

namespace flowcert::cli {

namespace {

// "fuzz merge" is a command below another one.
const CLI::App* command_named(const CLI::App& app, const std::vector<std::string>& words) {
  const CLI::App* command = &app;
  for (const std::string& word : words) {
    const auto below = command->get_subcommands([&](const CLI::App* one) { return one->get_name() == word; });
    if (below.empty()) return nullptr;
    command = below.front();
  }
  return command;
}

void print_help(const CLI::App& app, const std::vector<std::string>& words) {
  if (words.empty()) {
    print_wrapped("flowcert COMMAND --help tells of a command, flowcert help WORD what a word means:");
    fmt::print("{}\n", words_of_glossary());
    return;
  }
  const std::string asked = fmt::format("{}", fmt::join(words, " "));
  if (const GlossaryEntry* const entry = entry_of(asked)) {
    return print_wrapped(fmt::format("{}: {}", entry->word, entry->meaning), 2);
  }
  if (const CLI::App* const command = command_named(app, words)) {
    fmt::print("{}", command->help(app.get_name()));
    return;
  }
  const std::string nearest = nearest_words(asked);
  throw InvalidInput(
      fmt::format("there is no word {}; {}", io::in_quotes(asked),
                  nearest.empty() ? "flowcert help lists those that there are" : "there are: " + nearest));
}

}  // namespace

void add_help_command(CLI::App& app) {
  auto words = std::make_shared<std::vector<std::string>>();
  CLI::App* command = app.add_subcommand("help", "What a word means, such as mouth or missed-by-cluster");
  command->add_option("WORD", *words, "This word, or the name of a command; all words, without it");
  command->footer("Examples:\n  flowcert help persistence\n  flowcert help pore limiting radius");
  command->callback([&app, words] { print_help(app, *words); });
}

}  // namespace flowcert::cli
