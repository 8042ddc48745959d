// Text is escaped word by word. A hyphen is written as a minus, because what is copied from a page must be one.
#include "cli/manual_page.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <boost/algorithm/string.hpp>
#include <cstdint>
#include <map>

#include "cli/wrapped_text.h"

namespace flowcert::cli {

namespace {

// Lines of the source are so wide. Escaped text is somewhat wider.
constexpr std::size_t kSourceWidth = 72;
constexpr char kExitStatus[] =
    "0 if all is right, 1 for a negative verdict, 2 for unusable input or usage, with one line on standard error.";

// The character of UTF-8 that begins at `at`, as roff writes it.
std::string roff_character(const std::string& text, std::size_t& at) {
  const auto first = static_cast<unsigned char>(text[at]);
  const std::size_t more = first >= 0xf0 ? 3 : first >= 0xe0 ? 2 : 1;
  std::uint32_t code = first & (0x3fU >> more);
  for (std::size_t k = 0; k < more && at + 1 < text.size(); ++k) {
    code = code << 6 | (static_cast<unsigned char>(text[++at]) & 0x3fU);
  }
  return fmt::format("\\[u{:04X}]", code);
}

std::string roff(const std::string& text) {
  static const std::map<char, std::string> escapes = {{'\\', "\\e"},  {'-', "\\-"},   {'\'', "\\(aq"},
                                                      {'`', "\\(ga"}, {'^', "\\(ha"}, {'~', "\\(ti"}};
  std::string escaped;
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (const auto escape = escapes.find(text[at]); escape != escapes.end()) {
      escaped += escape->second;
    } else if (static_cast<unsigned char>(text[at]) >= 0x80) {
      escaped += roff_character(text, at);
    } else {
      escaped += text[at];
    }
  }
  return escaped;
}

// A line that begins with a dot would be a request.
std::string roff_line(const std::string& text) { return (text.starts_with('.') ? "\\&" : "") + roff(text) + '\n'; }

// Text that roff fills again.
std::string roff_lines(const std::string& text) {
  std::string page;
  for (const std::string& line : split_lines(wrapped(text, 0, kSourceWidth))) page += roff_line(line);
  return page;
}

// Filled text, with a line for each part of a sentence. Lines that begin with blanks stay as they are.
std::string filled(const std::string& text) {
  std::string page;
  const std::vector<std::string> lines = split_lines(text);
  bool is_fixed = false;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const std::string& line = lines[k];
    const bool is_indented = line.starts_with(' ');
    if (is_indented != is_fixed) page += is_indented ? ".EX\n" : ".EE\n";
    is_fixed = is_indented;
    if (line.empty()) {
      page += ".PP\n";
    } else if (!is_indented && k > 0 && !lines[k - 1].empty() && !lines[k - 1].starts_with(' ')) {
      page += ".br\n" + roff_lines(line);
    } else {
      page += is_indented ? roff_line(line) : roff_lines(line);
    }
  }
  return page + (is_fixed ? ".EE\n" : "");
}

// "[OPTIONS] POINTS CLAIM"
std::string synopsis_of(const DescribedCommand& command) {
  std::string text = fmt::format(".B {}\n[\\fIoptions\\fR]\n", roff(command.name));
  for (const DescribedOption& option : command.options) {
    if (!option.is_positional) continue;
    const std::string name = fmt::format("\\fI{}\\fR{}", roff(option.names.front()), option.takes_many ? "..." : "");
    text += (option.is_required ? name : "[" + name + "]") + '\n';
  }
  if (!command.commands.empty()) text += command.name.find(' ') == std::string::npos ? "\\fIcommand\\fR\n" : "";
  return text;
}

// ".B \-o, \-\-output FILE"
std::string option_tag(const DescribedOption& option) {
  std::vector<std::string> names;
  names.reserve(option.names.size());
  for (const std::string& name : option.names) {
    names.push_back(fmt::format("\\f{}{}\\fR", option.is_positional ? 'I' : 'B', roff(name)));
  }
  std::string tag = fmt::format("{}", fmt::join(names, ", "));
  if (option.is_positional || option.is_flag()) return tag + '\n';
  std::string value = fmt::format("\\fI{}\\fR", roff(option.value()));
  if (option.completed == Completed::kFiles) value = "\\fIFILE\\fR";
  if (option.completed == Completed::kFolders) value = "\\fIFOLDER\\fR";
  if (!option.choices.empty()) value = roff(fmt::format("{}", fmt::join(option.choices, option.is_list ? "," : "|")));
  if (option.is_value_optional) value = "[" + value + "]";
  return tag + ' ' + value + '\n';
}

std::string option_text(const DescribedOption& option) {
  std::string text = roff_lines(option.description + ".");
  if (!option.default_value.empty()) text += roff_line("Without it: " + option.default_value + ".");
  if (option.is_required && !option.is_positional) text += "It is required.\n";
  return text;
}

std::string options_of(const DescribedCommand& command) {
  std::string text = ".SH OPTIONS\n";
  for (const bool positional : {true, false}) {
    for (const DescribedOption& option : command.options) {
      if (option.is_positional == positional) text += ".TP\n" + option_tag(option) + option_text(option);
    }
  }
  return text;
}

std::string commands_of(const DescribedCommand& command) {
  std::string text;
  std::string group;
  for (const DescribedCommand& sub : command.commands) {
    if (text.empty()) text = ".SH COMMANDS\n";
    if (sub.group != group && command.name.find(' ') == std::string::npos)
      text += fmt::format(".SS {}\n", roff(sub.group));
    group = sub.group;
    text += fmt::format(".TP\n.BR {} (1)\n{}", roff(page_name(sub)), roff_lines(sub.description + "."));
  }
  return text;
}

std::string examples_of(const DescribedCommand& command) {
  if (command.footer.examples.empty()) return "";
  std::string text = ".SH EXAMPLES\n.EX\n";
  for (const std::string& example : command.footer.examples) {
    for (const std::string& line : split_lines(example)) text += roff_line(line);
  }
  return text + ".EE\n";
}

std::string see_also(const DescribedCommand& program, const DescribedCommand& command) {
  std::vector<std::string> pages;
  for (const DescribedCommand* other : with_all_below(program)) {
    if (other != &command) pages.push_back(fmt::format(".BR {} (1)", roff(page_name(*other))));
  }
  return fmt::format(".SH SEE ALSO\n{}\n", fmt::join(pages, " ,\n"));
}

}  // namespace

std::string page_name(const DescribedCommand& command) {
  return boost::algorithm::replace_all_copy(command.name, " ", "-");
}

std::string manual_page(const DescribedCommand& program, const DescribedCommand& command, const std::string& version) {
  std::string what = command.description.substr(0, command.description.find_last_not_of('.') + 1);
  std::string page = fmt::format(".\\\" Written by: {} manual\n", program.name);
  // No date, so that a version makes the same pages on any day.
  page += fmt::format(".TH {} 1 \"\" \"{}\" \"Flowcert manual\"\n",
                      roff(boost::algorithm::to_upper_copy(page_name(command))), roff(version));
  page += fmt::format(".SH NAME\n{} \\- {}\n", roff(page_name(command)), roff(what));
  page += ".SH SYNOPSIS\n" + synopsis_of(command);
  if (!command.footer.notes.empty()) page += ".SH DESCRIPTION\n" + filled(command.footer.notes);
  page += commands_of(command) + options_of(command) + examples_of(command);
  page += fmt::format(".SH EXIT STATUS\n{}", roff_lines(kExitStatus));
  return page + see_also(program, command);
}

}  // namespace flowcert::cli
