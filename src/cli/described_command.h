// What a command line offers, read off its App: commands, options and their values, examples. Help, completion scripts
// and manual pages are made of it, so none of them is ever out of date.
//
// Guarantees: everything that is not hidden is there, in the order of its definition. Options of an option group are
// options of its command.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "cli/layer.h"

namespace CLI {
class App;
}  // namespace CLI

namespace flowcert::cli {

// What a shell completes a value with.
enum class Completed { kNothing, kChoices, kFiles, kFolders };

struct DescribedOption {
  std::vector<std::string> names;  // "-o", "--output"; a positional argument has one, "INPUT"
  std::string type;                // as help says it: "X,Y,Z", "TEXT:{cascade,lazy,exact}"; empty for a flag
  std::string default_value;
  std::string description;
  bool is_positional = false;
  bool is_required = false;
  bool is_value_optional = false;
  bool takes_many = false;      // all values that follow
  bool is_list = false;         // of values with commas between
  bool is_alternative = false;  // of a group of which exactly one option has to be given
  bool is_repeated = false;     // has any number of values, in one of these ways or because it may stand again
  Completed completed = Completed::kNothing;
  std::vector<std::string> choices;
  std::vector<std::string> endings;          // of file names, without the dot; empty: any
  std::vector<std::string> needs, excludes;  // other options
  std::string group;                         // below whose name help lists it: "Options"

  [[nodiscard]] bool is_flag() const { return type.empty(); }
  // The type without what is checked: "TEXT"
  [[nodiscard]] std::string value() const { return type.substr(0, type.find(':')); }
};

// A footer is notes, and examples below a line "Examples:". An example that goes on has a backslash and a line's end
// inside.
struct DescribedFooter {
  std::string notes;
  std::vector<std::string> examples;
};

// Options of which exactly one has to be given.
struct DescribedGroup {
  std::string name;
  std::string description;
};

struct DescribedCommand {
  std::string name;  // with all that comes before: "flowcert fuzz merge"
  std::string description;
  std::string group;
  DescribedFooter footer;
  std::vector<DescribedOption> options;
  std::vector<DescribedGroup> option_groups;
  bool needs_command = false;  // one of those below
  std::vector<DescribedCommand> commands;

  // "merge"
  [[nodiscard]] std::string last_name() const { return name.substr(name.rfind(' ') + 1); }
};
[[nodiscard]] DescribedCommand described(const CLI::App& app);

// The command and all below it, each before its own.
[[nodiscard]] std::vector<const DescribedCommand*> with_all_below(const DescribedCommand& command);

}  // namespace flowcert::cli
