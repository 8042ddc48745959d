#include "cli/profile_report.h"

#include <fmt/format.h>

#include <optional>

#include "cli/wrapped_text.h"
#include "cli/xml_text.h"

namespace flowcert::cli {

namespace {

constexpr std::size_t kIndent = 4;

std::optional<std::string> statement_of(const JudgedProfile& judged) {
  const auto text = conformity_text(judged.verdict, judged.profile, judged.tolerance);
  return text ? std::optional(*text + judged.note) : std::nullopt;
}

}  // namespace

void print_conformity(const JudgedProfile& judged) {
  const auto statement = statement_of(judged);
  const auto text = statement ? statement : no_conformity_text(judged.verdict, judged.profile, judged.tolerance);
  if (text) fmt::print("{}\n", wrapped(*text, kIndent));
}

Json profile_field(const JudgedProfile& judged) {
  const auto statement = statement_of(judged);
  return {{"specification", kSpecVersion},
          {"parts", judged.profile.parts()},
          {"grade", judged.profile.grade()},
          {"statement", statement ? Json(*statement) : Json(nullptr)}};
}

std::string junit_properties(const JudgedProfile& judged) {
  const auto statement = statement_of(judged);
  if (!statement) return "";
  return fmt::format("    <properties><property name=\"profile\" value=\"{}\"/></properties>\n", xml_text(*statement));
}

}  // namespace flowcert::cli
