// A function for each command, which passes its options and arguments to _arguments.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <boost/algorithm/string.hpp>

#include "cli/completion_scripts.h"

namespace flowcert::cli {

namespace {

std::string function_name(const DescribedCommand& command) {
  return "_" + boost::algorithm::replace_all_copy(command.name, " ", "_");
}

// Inside single quotes, and inside the brackets or between the colons of a specification.
std::string in_specification(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '\'') {
      escaped += "'\\''";
      continue;
    }
    if (c == '[' || c == ']' || c == ':' || c == '\\') escaped += '\\';
    escaped += c == '\n' ? ' ' : c;
  }
  return escaped;
}

std::string action_in_zsh(const DescribedOption& option) {
  switch (option.completed) {
    case Completed::kNothing:
      return " ";
    case Completed::kChoices:
      if (option.is_list) return fmt::format("_values -s , value {}", fmt::join(option.choices, " "));
      return fmt::format("({})", fmt::join(option.choices, " "));
    case Completed::kFiles:
      if (option.endings.empty()) return "_files";
      return fmt::format("_files -g \"*.({})\"", fmt::join(option.endings, "|"));
    case Completed::kFolders:
      break;
  }
  return "_files -/";
}

std::string specification(const DescribedOption& option, const std::string& name) {
  if (option.is_positional) {
    return fmt::format("{}:{}:{}", option.takes_many ? "*" : "", in_specification(option.names.front()),
                       action_in_zsh(option));
  }
  std::string text = "*" + name;
  if (!option.is_flag() && !option.is_value_optional) text += name.starts_with("--") ? "=" : "+";
  text += fmt::format("[{}]", in_specification(option.description));
  if (option.is_flag()) return text;
  return text + fmt::format("{}{}:{}", option.is_value_optional ? "::" : ":", in_specification(option.value()),
                            action_in_zsh(option));
}

std::string command_function(const DescribedCommand& command) {
  std::string text = fmt::format("\n{}() {{\n", function_name(command));
  if (!command.commands.empty()) {
    text += "  local context state state_descr line curcontext=$curcontext\n  local -a commands=(\n";
    for (const DescribedCommand& sub : command.commands) {
      text += fmt::format("    '{}:{}'\n", sub.last_name(), in_specification(sub.description));
    }
    text += "  )\n";
  }
  text += command.commands.empty() ? "  _arguments" : "  _arguments -C";
  for (const DescribedOption& option : command.options) {
    for (const std::string& name : option.names) text += fmt::format(" \\\n    '{}'", specification(option, name));
  }
  if (!command.commands.empty()) {
    text += " \\\n    '1: :->command' \\\n    '*:: :->words' && return\n  case $state in\n";
    text += "    (command) _describe -t commands command commands ;;\n    (words)\n      case $line[1] in\n";
    for (const DescribedCommand& sub : command.commands) {
      text += fmt::format("        ({}) {} ;;\n", sub.last_name(), function_name(sub));
    }
    text += "      esac ;;\n  esac";
  }
  return text + "\n}\n";
}

}  // namespace

std::string zsh_completion(const DescribedCommand& program) {
  std::string text =
      fmt::format("#compdef {0}\n# What zsh completes of {0}. Written by: {0} completion zsh\n", program.name);
  for (const DescribedCommand* command : with_all_below(program)) text += command_function(*command);
  // The file is read once as a function of the path, and by `source` otherwise.
  text += fmt::format("\nif [[ $funcstack[1] == _{0} ]]; then\n  _{0} \"$@\"\nelse\n  compdef _{0} {0}\nfi\n",
                      program.name);
  return text;
}

}  // namespace flowcert::cli
