// CLI11 says of every error only what it was, and of an unknown command nothing but that there has to be one.
#include "cli/command_line.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <boost/algorithm/string.hpp>
#include <numeric>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "cli/described_command.h"
#include "cli/wrapped_text.h"
#include "io/number_text.h"

namespace flowcert::cli {

// ---- Help ----

namespace {

constexpr std::size_t kNames = 26, kCommands = 15;  // columns
constexpr std::size_t kFirstExamples = 2;

// Where the lines go on that `line` is broken into: below its second column, if it has one, or below its first word.
std::size_t indent_of(std::string_view line) {
  const std::size_t first = std::min(line.find_first_not_of(' '), line.size());
  const std::size_t gap = line.find("  ", first);
  if (first == 0 || gap == std::string_view::npos) return first;
  return line.find_first_not_of(' ', gap);
}

std::string below_heading(const char* heading, std::span<const std::string> examples) {
  if (examples.empty()) return "";
  std::string text = fmt::format("{}:\n", heading);
  for (const std::string& example : examples) {
    text += fmt::format("  {}\n", boost::algorithm::replace_all_copy(example, "\n", "\n  "));
  }
  return text;
}

// Two columns; what is too long for the first has a line of its own.
std::string two_columns(const std::string& left, std::size_t width, const std::string& right) {
  const bool is_long = left.size() >= width && !right.empty();
  return fmt::format("{:<{}}{}{}\n", left, width, is_long ? "\n" + std::string(width, ' ') : "", right);
}

// "-o,--output TEXT=default ... REQUIRED"
std::string words_of(const DescribedOption& option) {
  std::string words = fmt::format("{}", fmt::join(option.names, ","));
  if (!option.is_flag()) {
    words += ' ' + option.type;
    if (!option.default_value.empty()) words += '=' + option.default_value;
    if (option.is_repeated) words += " ...";
    if (option.is_required) words += " REQUIRED";
  }
  if (!option.needs.empty()) words += fmt::format(" Needs: {}", fmt::join(option.needs, " "));
  if (!option.excludes.empty()) words += fmt::format(" Excludes: {}", fmt::join(option.excludes, " "));
  return words;
}

std::string list_of_options(const DescribedCommand& command, const std::string& group, const std::string& heading) {
  std::string text = fmt::format("\n{}:\n", heading);
  for (const DescribedOption& option : command.options) {
    if (option.group == group) text += two_columns("  " + words_of(option), kNames, option.description);
  }
  return text;
}

// In their groups, in the order in which they were added; positional arguments come first.
std::string lists_of_options(const DescribedCommand& command) {
  std::string lists;
  for (const bool are_positional : {true, false}) {
    std::vector<std::string> groups;
    for (const DescribedOption& option : command.options) {
      const bool is_known = std::ranges::find(groups, option.group) != groups.end();
      if (option.is_positional == are_positional && !option.is_alternative && !is_known) groups.push_back(option.group);
    }
    for (const std::string& group : groups) lists += list_of_options(command, group, group);
  }
  return lists;
}

std::string list_of_groups(const DescribedCommand& command) {
  std::string text;
  for (const DescribedGroup& group : command.option_groups) {
    std::string options = list_of_options(command, group.name, "Options");
    options.pop_back();
    text += fmt::format("[Option Group: {}]\n  {} \n  [Exactly 1 of the following options is required]{}\n", group.name,
                        group.description, boost::algorithm::replace_all_copy(options, "\n", "\n  "));
  }
  return text;
}

// Groups of commands, each with a line for every command of it, in the order in which their first ones were added.
std::vector<std::pair<std::string, std::string>> lines_by_group(const DescribedCommand& program, std::size_t width) {
  std::vector<std::pair<std::string, std::string>> groups;
  for (const DescribedCommand& command : program.commands) {
    auto group = std::ranges::find(groups, command.group, &std::pair<std::string, std::string>::first);
    if (group == groups.end()) group = groups.insert(group, {command.group, ""});
    group->second += two_columns("  " + command.last_name(), width, command.description);
  }
  return groups;
}

// The names of commands are short, so that each has one line.
std::string list_of_commands(const DescribedCommand& command) {
  std::string text;
  for (const auto& [group, lines] : lines_by_group(command, kCommands)) text += fmt::format("\n{}:\n{}", group, lines);
  return text;
}

std::string usage_of(const DescribedCommand& command) {
  std::string text = fmt::format("Usage: {} [OPTIONS]", command.name);
  for (const DescribedOption& option : command.options) {
    if (!option.is_positional) continue;
    const std::string word = option.names.front() + (option.takes_many ? "..." : "");
    text += option.is_required ? ' ' + word : fmt::format(" [{}]", word);
  }
  if (!command.commands.empty()) text += command.needs_command ? " SUBCOMMAND" : " [SUBCOMMAND]";
  return text + '\n';
}

// All of the text is made here, because versions of CLI11 lay it out differently. Two examples come before the options,
// and further ones at the end.
class HelpFormatter : public CLI::Formatter {
 public:
  std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode) const override {
    DescribedCommand command = described(*app);
    command.name = std::move(name);  // with the program's
    const std::span examples(command.footer.examples);
    const std::size_t first = std::min(kFirstExamples, examples.size());
    const std::string& notes = command.footer.notes;
    std::string help = command.description + '\n' + usage_of(command) + (first == 0 ? "" : "\n") +
                       below_heading("Examples", examples.first(first)) + lists_of_options(command) +
                       list_of_groups(command) + list_of_commands(command) + '\n' + notes +
                       (notes.empty() ? "" : "\n\n") + below_heading("More examples", examples.subspan(first));
    help.erase(help.find_last_not_of('\n') + 1);
    help += '\n';
    std::vector<std::string> lines = split_lines(help);
    for (std::string& line : lines) line = wrapped(line, indent_of(line));
    return boost::algorithm::join(lines, "\n");
  }
};

}  // namespace

std::shared_ptr<CLI::FormatterBase> help_formatter() { return std::make_shared<HelpFormatter>(); }

// ---- Without a command ----

// Groups, lines and the example are those of --help. Commands that set up a shell and further examples are only there.
// All fits 24 lines, without blank ones.
std::string overview(const CLI::App& app) {
  const DescribedCommand program = described(app);
  std::size_t width = 0;
  for (const DescribedCommand& command : program.commands) width = std::max(width, command.last_name().size());
  std::string text;
  for (const auto& [group, lines] : lines_by_group(program, width + 4)) {
    if (group != kSetUpGroup) text += group + '\n' + lines;
  }
  text += fmt::format("Begin with this; {} COMMAND --help tells more\n", program.name);
  return text + fmt::format("  {}\n", program.footer.examples.at(0));
}

// ---- The nearest name ----

// Neither Boost nor CLI11 has it.
std::size_t edits_between(std::string_view one, std::string_view other) {
  std::vector<std::size_t> row(other.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < one.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i + 1);
    for (std::size_t k = 0; k < other.size(); ++k) {
      const std::size_t replaced = diagonal + (one[i] == other[k] ? 0 : 1);
      diagonal = std::exchange(row[k + 1], std::min({replaced, row[k] + 1, row[k + 1] + 1}));
    }
  }
  return row.back();
}

namespace {

using Names = std::vector<std::string>;

// Letters alone, so that "-v" and "version" are near "--version".
std::string letters_of(const std::string& name) {
  return boost::algorithm::to_lower_copy(name.substr(std::min(name.find_first_not_of('-'), name.size())));
}

// Options had these names before version 1.0. Others are nearer to them than what they are called now.
constexpr std::pair<std::string_view, std::string_view> kFormerNames[] = {
    {"--levels", "--highest-level"}, {"--only", "--case"}, {"--points", "--positions"}, {"--search", "--mutants"}};

// "; did you mean --json?", or nothing if no name is near. A name that begins with the word is nearest.
std::string suggestion(const std::string& word, const Names& names) {
  for (const auto& [former, name] : kFormerNames) {
    if (word == former && std::ranges::count(names, name) > 0) return fmt::format("; did you mean {}?", name);
  }
  const std::string asked = letters_of(word);
  std::size_t fewest = std::min<std::size_t>(asked.size() / 2, 3) + 1;
  const std::string* nearest = nullptr;
  for (const std::string& name : names) {
    const std::string letters = letters_of(name);
    const std::size_t edits = !asked.empty() && letters.starts_with(asked) ? 0 : edits_between(asked, letters);
    if (edits >= fewest) continue;
    fewest = edits;
    nearest = &name;
  }
  return nearest == nullptr ? "" : fmt::format("; did you mean {}?", *nearest);
}

Names options_of(const CLI::App& app) {
  Names names;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    for (const std::string& name : option->get_snames()) names.push_back("-" + name);
  }
  // Option groups are commands without a name.
  for (const CLI::App* group : app.get_subcommands([](const CLI::App* sub) { return sub->get_name().empty(); })) {
    for (std::string& name : options_of(*group)) names.push_back(std::move(name));
  }
  return names;
}

Names commands_of(const CLI::App& app) {
  Names names;
  for (const CLI::App* sub : app.get_subcommands([](const CLI::App*) { return true; })) {
    if (!sub->get_name().empty()) names.push_back(sub->get_name());
  }
  return names;
}

// ---- What is wrong ----

bool is_number(const std::string& word) {
  try {
    (void)parse_rational(word);
    return true;
  } catch (const InvalidInput&) {
    return false;
  }
}

bool is_option(const std::string& word) {
  return word.size() > 1 && word[0] == '-' && word != "--" && !is_number(word);
}

// An option whose value has commas, such as X,Y,Z, was given several words instead. Returns what to write.
std::optional<std::string> joined_value(const CLI::App& command, std::span<const std::string> words) {
  for (std::size_t k = 0; k < words.size(); ++k) {
    const CLI::Option* option = is_option(words[k]) ? command.get_option_no_throw(words[k]) : nullptr;
    if (option == nullptr) continue;
    const std::string type = option->get_type_name();
    if (type.substr(0, type.find(':')).find(',') == std::string::npos) continue;
    std::string value;
    std::size_t count = 0;
    for (; k + 1 < words.size() && is_number(words[k + 1]); ++k) value += (count++ == 0 ? "" : ",") + words[k + 1];
    if (count > 1) return fmt::format("{} takes one word: write {} {}", words[k - count], words[k - count], value);
  }
  return std::nullopt;
}

std::string complaint_about_option(const CLI::App& app, const CLI::App& command, const std::string& word) {
  const std::string name = word.substr(0, word.find('='));
  const bool is_before_command = &command != &app && std::ranges::count(app.remaining(), word) > 0;
  if (is_before_command && command.get_option_no_throw(name) != nullptr) {
    return fmt::format("{} has to stand after {}", name, command.get_name());
  }
  const CLI::App& asked = is_before_command ? app : command;
  return fmt::format("{} has no option {}{}", asked.get_name(), in_quotes(name), suggestion(name, options_of(asked)));
}

std::string complaint_about_words(const CLI::App& app, const CLI::App& command, const CLI::ParseError& error,
                                  std::span<const std::string> words) {
  Names left = app.remaining(true);
  std::erase(left, "--");
  const bool lacks_command = &command == &app && !commands_of(app).empty();
  if (lacks_command && left.empty()) return "a command is required";
  // What follows an unknown command may well be its options.
  if (lacks_command && !is_option(left[0])) {
    Names names = commands_of(app);
    for (std::string& name : options_of(app)) names.push_back(std::move(name));
    return fmt::format("there is no command {}{}", in_quotes(left[0]), suggestion(left[0], names));
  }
  const auto option = std::ranges::find_if(left, is_option);
  if (option != left.end()) return complaint_about_option(app, command, *option);
  if (left.empty()) return error.what();
  if (const auto value = joined_value(command, words)) return *value;
  for (std::string& word : left) word = in_quotes(word);
  return fmt::format("unexpected argument{}: {}", left.size() == 1 ? "" : "s", fmt::join(left, " "));
}

}  // namespace

std::string complaint_about(const CLI::App& app, const CLI::ParseError& error, std::span<const std::string> words) {
  const CLI::App* command = &app;
  std::string help = app.get_name();
  while (!command->get_subcommands().empty()) {
    command = command->get_subcommands().back();
    help += ' ' + command->get_name();
  }
  return fmt::format("{} (see {} --help)", complaint_about_words(app, *command, error, words), help);
}

}  // namespace flowcert::cli
