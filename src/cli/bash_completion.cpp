// Two tables of the command line, and one function that walks along the words before the cursor. The shell cuts words
// at an equals sign, so "--kernel=lazy" is three of them.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "cli/completion_scripts.h"

namespace flowcert::cli {

namespace {

// "merge" of "flowcert fuzz merge" is "fuzz merge" here, and the program itself is nothing.
std::string path_in_bash(const DescribedCommand& command) {
  const std::size_t blank = command.name.find(' ');
  return blank == std::string::npos ? "" : command.name.substr(blank + 1);
}

std::string words_case(const DescribedCommand& command) {
  std::vector<std::string> options, commands;
  for (const DescribedOption& option : command.options) {
    if (!option.is_positional) options.insert(options.end(), option.names.begin(), option.names.end());
  }
  for (const DescribedCommand& sub : command.commands) commands.push_back(sub.last_name());
  return fmt::format("    '{}')\n      options='{}'\n      commands='{}' ;;\n", path_in_bash(command),
                     fmt::join(options, " "), fmt::join(commands, " "));
}

const char* kind_in_bash(const DescribedOption& option) {
  switch (option.completed) {
    case Completed::kNothing:
      return "other";
    case Completed::kChoices:
      return option.is_list ? "list" : "choices";
    case Completed::kFiles:
      return "files";
    case Completed::kFolders:
      break;
  }
  return "folders";
}

std::string value_case(const DescribedCommand& command, const DescribedOption& option, std::size_t place) {
  std::vector<std::string> patterns;
  if (option.is_positional) {
    patterns.push_back(
        fmt::format("'{}:{}'", path_in_bash(command), option.takes_many ? "many" : fmt::format("{}", place)));
  } else {
    for (const std::string& name : option.names)
      patterns.push_back(fmt::format("'{}:{}'", path_in_bash(command), name));
  }
  const char* next = option.is_value_optional ? "maybe" : option.takes_many ? "many" : "one";
  return fmt::format("    {}) kind={} next={} words='{}' ;;\n", fmt::join(patterns, " | "), kind_in_bash(option), next,
                     fmt::join(option.choices.empty() ? option.endings : option.choices, " "));
}

std::string value_cases(const DescribedCommand& command) {
  std::string text;
  std::size_t place = 0;
  for (const DescribedOption& option : command.options) {
    if (option.is_positional) ++place;
    if (!option.is_flag()) text += value_case(command, option, place);
  }
  return text;
}

constexpr char kWalk[] = R"(
# Files with one of the endings in $words, and folders. Where there are none, the shell completes any file.
_@_files() {
  local file ending
  compopt -o filenames -o default 2>/dev/null
  while IFS= read -r file; do
    if [[ -d ${file/#\~/$HOME} ]]; then
      COMPREPLY+=("$file")
      continue
    fi
    [[ -n $words ]] || COMPREPLY+=("$file")
    for ending in $words; do
      if [[ $file == *".$ending" ]]; then
        COMPREPLY+=("$file")
        break
      fi
    done
  done < <(compgen -f -- "$1")
}

# Values with commas between, each once.
_@_list() {
  local before= one
  [[ $1 == *,* ]] && before=${1%,*},
  for one in $words; do
    [[ ,$before == *",$one,"* || $one != "${1##*,}"* ]] || COMPREPLY+=("$before$one")
  done
}

# The value of the option, or the argument, of this name, beginning with this word.
_@_value() {
  _@_kind "$1"
  case $kind in
    choices) COMPREPLY+=($(compgen -W "$words" -- "$2")) ;;
    list) _@_list "$2" ;;
    files) _@_files "$2" ;;
    folders)
      compopt -o filenames 2>/dev/null
      while IFS= read -r one; do COMPREPLY+=("$one"); done < <(compgen -d -- "$2") ;;
  esac
}

_@() {
  local word=${COMP_WORDS[COMP_CWORD]} command= asked= taken=0 place=1 at one options commands kind next words
  COMPREPLY=()
  for ((at = 1; at < COMP_CWORD; ++at)); do
    one=${COMP_WORDS[at]}
    if [[ -n $asked ]]; then
      [[ $one == '=' ]] && continue
      _@_kind "$command:$asked"
      if [[ $one != -* || ($next == one || $next == many && $taken == 0) ]]; then
        taken=1
        [[ $next == many ]] || asked=
        continue
      fi
      asked=
    fi
    if [[ $one == -?* ]]; then
      _@_kind "$command:$one"
      [[ -z $kind ]] || { asked=$one taken=0; }
      continue
    fi
    _@_words "$command"
    if [[ " $commands " == *" $one "* ]]; then
      command+=${command:+ }$one place=1
    else
      place=$((place + 1))
    fi
  done
  [[ $word == '=' ]] && word=
  if [[ -n $asked ]]; then
    _@_kind "$command:$asked"
    _@_value "$command:$asked" "$word"
    [[ $next == one || $next == many && $taken == 0 ]] && return
  fi
  _@_words "$command"
  if [[ $word == -* ]]; then
    COMPREPLY+=($(compgen -W "$options" -- "$word"))
    return
  fi
  COMPREPLY+=($(compgen -W "$commands" -- "$word"))
  [[ -n $asked ]] || _@_value "$command:$place" "$word"
  [[ -n $asked ]] || _@_value "$command:many" "$word"
  _@_kind "$command:$place"
  [[ -n $kind || -n $word || ${#COMPREPLY[@]} -gt 0 ]] || COMPREPLY=($(compgen -W "$options"))
}

complete -F _@ @
)";

std::string with_name(std::string text, const std::string& name) {
  for (std::size_t at = 0; (at = text.find('@', at)) != std::string::npos; at += name.size()) {
    if (text.compare(at, 3, "@]}") != 0) text.replace(at, 1, name);
  }
  return text;
}

}  // namespace

std::string bash_completion(const DescribedCommand& program) {
  std::string text = "# What bash completes of @. Written by: @ completion bash\n\n";
  text += "# What may follow a command, beside its arguments.\n_@_words() {\n  options= commands=\n  case $1 in\n";
  for (const DescribedCommand* command : with_all_below(program)) text += words_case(*command);
  text += "  esac\n}\n\n";
  text += "# The values of an option, or of an argument by its place. Flags have none.\n";
  text += "_@_kind() {\n  kind= next= words=\n  case $1 in\n";
  for (const DescribedCommand* command : with_all_below(program)) text += value_cases(*command);
  text += "  esac\n}\n";
  return with_name(text + kWalk, program.name);
}

}  // namespace flowcert::cli
