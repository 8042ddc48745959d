#include "cli/profile_report.h"

#include <fmt/format.h>

#include "cli/wrapped_text.h"
#include "cli/xml_text.h"

namespace flowcert::cli {

namespace {

constexpr std::size_t kIndent = 4;

}  // namespace

void print_conformity(Verdict verdict, const Profile& profile, const std::string& note) {
  if (const auto text = conformity_text(verdict, profile)) fmt::print("{}\n", wrapped(*text + note, kIndent));
}

Json profile_field(Verdict verdict, const Profile& profile, const std::string& note) {
  const auto text = conformity_text(verdict, profile);
  Json field;
  field["specification"] = kSpecVersion;
  field["parts"] = profile.parts();
  field["grade"] = profile.grade();
  field["statement"] = text ? Json(*text + note) : Json(nullptr);
  return field;
}

std::string junit_properties(Verdict verdict, const Profile& profile, const std::string& note) {
  const auto text = conformity_text(verdict, profile);
  if (!text) return "";
  return fmt::format("    <properties><property name=\"profile\" value=\"{}\"/></properties>\n",
                     xml_text(*text + note));
}

}  // namespace flowcert::cli
