#include "cli/profile_report.h"

#include <fmt/format.h>

#include "cli/wrapped_text.h"
#include "cli/xml_text.h"

namespace flowcert::cli {

namespace {

constexpr std::size_t kIndent = 4;

}  // namespace

void print_conformity(const JudgedProfile& judged) {
  const auto statement = statement_of(judged);
  const auto text = statement ? statement : no_conformity_text(judged.verdict, judged.profile, judged.tolerance);
  if (text) fmt::print("{}\n", wrapped(*text, kIndent));
}

std::string junit_properties(const JudgedProfile& judged) {
  const auto statement = statement_of(judged);
  if (!statement) return "";
  return fmt::format("    <properties><property name=\"profile\" value=\"{}\"/></properties>\n", xml_text(*statement));
}

}  // namespace flowcert::cli
