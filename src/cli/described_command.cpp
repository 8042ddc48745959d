// CLI11 knows a value's type and its choices, but not which values are names of files. A table says that.
#include "cli/described_command.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <boost/algorithm/string.hpp>
#include <set>
#include <string_view>

#include "cli/wrapped_text.h"

namespace flowcert::cli {

namespace {

using Words = std::vector<std::string>;

// ---- Names of files ----

struct FileValue {
  Words names;  // of options or positional arguments, of a command that is named before one, or of any
  Completed completed;
  Words endings;
};

Words also_compressed(Words endings) {
  const Words plain = endings;
  for (const std::string& ending : plain) endings.push_back(ending + ".gz");
  return endings;
}

const std::vector<FileValue>& file_values() {
  static const Words points = also_compressed(
      {"xyz", "txt", "asc", "csv", "pts", "off", "ply", "obj", "pcd", "npy", "pdb", "ent", "cif", "mmcif"});
  static const Words claims = also_compressed({"jsonl", "json", "csv", "vtp", "txt", "pers"});
  static const std::vector<FileValue> values = {
      {{"INPUT", "POINTS", "locate --positions", "--replay"}, Completed::kFiles, points},
      {{"CLAIM", "--claim"}, Completed::kFiles, claims},
      {{"compute --output"}, Completed::kFiles, {"jsonl"}},
      {{"locate --output"}, Completed::kFiles, {"txt", "jsonl"}},
      {{"persistence --output"}, Completed::kFiles, {"pers"}},
      {{"points --output"}, Completed::kFiles, {"f64"}},
      {{"--certificate"}, Completed::kFiles, {"fcert"}},
      {{"pockets --csv", "pockets --atoms-csv", "pores --csv", "pores --windows-csv"}, Completed::kFiles, {"csv"}},
      {{"pores --curve"}, Completed::kFiles, {"svg", "csv"}},
      {{"surface --output"}, Completed::kFiles, {"ply", "off"}},
      {{"view --output", "--report"}, Completed::kFiles, {"html"}},
      {{"--junit"}, Completed::kFiles, {"xml"}},
      {{"--known", "--asked"}, Completed::kFiles, {}},
      {{"--export", "--svg", "--keep", "--out", "--resume", "--corpus", "--vectors", "FOLDER", "DIR"},
       Completed::kFolders,
       {}}};
  return values;
}

void take_file_value(DescribedOption& option, const std::string& command) {
  const std::string& name = option.names.back();
  for (const FileValue& value : file_values()) {
    if (std::ranges::count(value.names, name) + std::ranges::count(value.names, command + ' ' + name) == 0) continue;
    option.completed = value.completed;
    option.endings = value.endings;
  }
}

// ---- Options ----

// CLI11's "TEXT:{cascade,lazy,exact}" is a type and its choices; other checks come after a colon, too.
void take_value(DescribedOption& option, const std::string& type) {
  const std::size_t colon = type.find(':');
  option.type = type;
  if (colon == std::string::npos) return;
  const std::size_t open = type.find('{', colon), close = type.find('}', colon);
  if (open == std::string::npos || close == std::string::npos) return;
  const std::string list = type.substr(open + 1, close - open - 1);
  boost::algorithm::split(option.choices, list, [](char c) { return c == ','; });
  option.completed = Completed::kChoices;
}

Words names_of(const std::set<CLI::Option*>& options) {
  Words names;
  names.reserve(options.size());
  for (const CLI::Option* option : options) names.push_back(option->get_name());
  return names;
}

DescribedOption described_option(const CLI::Option& option, const std::string& command) {
  DescribedOption result;
  result.is_positional = option.get_positional();
  if (result.is_positional) {
    result.names = {option.get_name(true, false)};
  } else {
    for (const std::string& name : option.get_snames()) result.names.push_back('-' + name);
    for (const std::string& name : option.get_lnames()) result.names.push_back("--" + name);
  }
  result.description = option.get_description();
  result.is_required = option.get_required();
  result.needs = names_of(option.get_needs());
  result.excludes = names_of(option.get_excludes());
  if (option.get_items_expected_max() == 0) return result;
  result.default_value = option.get_default_str();
  result.is_value_optional = option.get_items_expected_min() == 0;
  result.is_list = option.get_delimiter() == ',';
  result.is_repeated = option.get_expected_max() >= CLI::detail::expected_max_vector_size;
  result.takes_many = result.is_repeated && !result.is_list && (result.is_positional || option.get_allow_extra_args());
  take_value(result, option.get_type_name());
  take_file_value(result, command);
  return result;
}

// CLI11's own group has a name that depends on its version.
std::string group_of(const CLI::Option& option) {
  if (option.get_positional()) return "Positionals";
  return boost::algorithm::iequals(option.get_group(), "Options") ? "Options" : option.get_group();
}

// Option groups are commands without a name, with a help of their own.
void add_options(DescribedCommand& command, const CLI::App& app, const CLI::App& group) {
  const bool is_group = &group != &app;
  if (is_group) command.option_groups.push_back({group.get_group(), group.get_description()});
  for (const CLI::Option* option : group.get_options()) {
    if (option->get_group().empty() || (is_group && option == group.get_help_ptr())) continue;
    command.options.push_back(described_option(*option, app.get_name()));
    command.options.back().is_alternative = is_group;
    command.options.back().group = is_group ? group.get_group() : group_of(*option);
  }
  for (const CLI::App* below : group.get_subcommands([](const CLI::App* sub) { return sub->get_name().empty(); })) {
    add_options(command, app, *below);
  }
}

// ---- Commands ----

DescribedFooter footer_of(const CLI::App& command) {
  DescribedFooter footer;
  bool is_example = false;
  for (const std::string& line : split_lines(command.get_footer())) {
    if (line == "Examples:" || line == "Example:") {
      is_example = true;
    } else if (is_example && line.starts_with("    ") && !footer.examples.empty()) {
      footer.examples.back() += '\n' + line.substr(2);
    } else if (is_example && line.starts_with("  ")) {
      footer.examples.push_back(line.substr(2));
    } else {
      is_example = false;
      footer.notes += line + '\n';
    }
  }
  boost::algorithm::trim_if(footer.notes, [](char c) { return c == '\n'; });
  return footer;
}

bool is_shown(const CLI::App& command) { return !command.get_name().empty() && !command.get_group().empty(); }

DescribedCommand described_below(const CLI::App& app, const std::string& before) {
  DescribedCommand command;
  command.name = before + app.get_name();
  command.description = app.get_description();
  command.group = app.get_group();
  command.footer = footer_of(app);
  command.needs_command = app.get_require_subcommand_min() > 0;
  add_options(command, app, app);
  for (const CLI::App* sub : app.get_subcommands([](const CLI::App*) { return true; })) {
    if (is_shown(*sub)) command.commands.push_back(described_below(*sub, command.name + ' '));
  }
  return command;
}

void add_with_all_below(const DescribedCommand& command, std::vector<const DescribedCommand*>& all) {
  all.push_back(&command);
  for (const DescribedCommand& sub : command.commands) add_with_all_below(sub, all);
}

}  // namespace

DescribedCommand described(const CLI::App& app) { return described_below(app, ""); }

std::vector<const DescribedCommand*> with_all_below(const DescribedCommand& command) {
  std::vector<const DescribedCommand*> all;
  add_with_all_below(command, all);
  return all;
}

}  // namespace flowcert::cli
