#include "certify/judged_profile.h"

namespace flowcert::certify {

std::optional<std::string> statement_of(const JudgedProfile& judged) {
  const auto text = conformity_text(judged.verdict, judged.profile, judged.tolerance);
  return text ? std::optional(*text + judged.note) : std::nullopt;
}

Json profile_field(const JudgedProfile& judged) {
  const auto statement = statement_of(judged);
  return {{"specification", kSpecVersion},
          {"parts", judged.profile.parts()},
          {"grade", judged.profile.grade()},
          {"statement", statement ? Json(*statement) : Json(nullptr)}};
}

}  // namespace flowcert::certify
