// A line for each command and each option.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <boost/algorithm/string.hpp>

#include "cli/completion_scripts.h"

namespace flowcert::cli {

namespace {

std::string quoted_in_fish(std::string text) {
  boost::algorithm::replace_all(text, "\\", "\\\\");
  boost::algorithm::replace_all(text, "'", "\\'");
  boost::algorithm::replace_all(text, "\n", " ");
  return "'" + text + "'";
}

// When a line holds: its commands are there, and none of those below it.
std::string condition(const DescribedCommand& command) {
  std::vector<std::string> words, below;
  boost::algorithm::split(words, command.name, [](char c) { return c == ' '; });
  for (const DescribedCommand& sub : command.commands) below.push_back(sub.last_name());
  std::string text;
  for (std::size_t k = 1; k < words.size(); ++k) {
    text += fmt::format("{}__fish_seen_subcommand_from {}", k == 1 ? "" : "; and ", words[k]);
  }
  if (below.empty()) return text;
  return text +
         fmt::format("{}not __fish_seen_subcommand_from {}", text.empty() ? "" : "; and ", fmt::join(below, " "));
}

// The arguments of `complete` that say the values.
std::string values_in_fish(const DescribedOption& option) {
  switch (option.completed) {
    case Completed::kNothing:
      return "";
    case Completed::kChoices: {
      const std::string choices = boost::algorithm::join(option.choices, " ");
      return option.is_list ? fmt::format(" -a '(__fish_append , {})'", choices) : fmt::format(" -a '{}'", choices);
    }
    case Completed::kFiles:
      if (option.endings.empty()) return " -a '(__fish_complete_path)'";
      return fmt::format(" -k -a '(__fish_complete_suffix .{})'", fmt::join(option.endings, " ."));
    case Completed::kFolders:
      break;
  }
  return " -a '(__fish_complete_directories)'";
}

std::string option_line(const std::string& start, const DescribedOption& option) {
  std::string text = start;
  if (!option.is_positional) {
    for (const std::string& name : option.names) {
      text += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
    }
    if (!option.is_flag()) text += " -x";
    return text + (option.is_flag() ? "" : values_in_fish(option)) + " -d " + quoted_in_fish(option.description) + '\n';
  }
  const std::string values = values_in_fish(option);
  return values.empty() ? "" : text + values + '\n';
}

}  // namespace

std::string fish_completion(const DescribedCommand& program) {
  std::string text =
      fmt::format("# What fish completes of {0}. Written by: {0} completion fish\ncomplete -c {0} -f\n", program.name);
  for (const DescribedCommand* command : with_all_below(program)) {
    const std::string start = fmt::format("complete -c {} -n '{}'", program.name, condition(*command));
    for (const DescribedCommand& sub : command->commands) {
      text += fmt::format("{} -a {} -d {}\n", start, sub.last_name(), quoted_in_fish(sub.description));
    }
    for (const DescribedOption& option : command->options) text += option_line(start, option);
  }
  return text;
}

}  // namespace flowcert::cli
