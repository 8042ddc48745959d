#include "certify/check_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "certify/judged_profile.h"
#include "io/foreign_text.h"

namespace flowcert::certify {

const char* truth_text(const CheckedFiles& files) { return files.by_oracle ? "oracle" : "fast implementation"; }

std::array<LevelCount, kLevels> count_levels(const CheckReport& report) {
  std::array<LevelCount, kLevels> counts{};
  for (const Finding& finding : report.findings) {
    LevelCount& count = counts.at(static_cast<std::size_t>(finding.level - 1));
    ++(finding.is_variation ? count.varied : count.wrong);
    count.undecided += finding.is_decided ? 0 : 1;
    count.verdict = std::max(count.verdict, verdict_on(finding));
  }
  return counts;
}

std::vector<ReasonRow> reasons_of(const CheckReport& report) {
  std::array<ReasonTally, 2> tallies;  // wrong, permitted
  for (std::size_t k = 0; k < report.findings.size(); ++k) {
    const Finding& finding = report.findings[k];
    tallies.at(finding.is_variation ? 1 : 0).add(reason_text(finding.reason), finding.contact.size(), k);
  }
  std::vector<ReasonRow> rows = tallies[0].rows();
  std::ranges::copy(tallies[1].rows(), std::back_inserter(rows));
  return rows;
}

namespace {

Json reasons_field(const CheckReport& report) {
  Json reasons = Json::array();
  for (const ReasonRow& row : reasons_of(report)) {
    reasons.push_back({{"reason", row.reason},
                       {"permitted", report.findings[row.example].is_variation},
                       {"findings", row.count},
                       {"example", row.example}});
  }
  return reasons;
}

Json levels_field(const CheckReport& report) {
  const auto counts = count_levels(report);
  Json levels = Json::object();
  for (std::size_t k = 0; k < kLevels; ++k) {
    const std::optional<bool>& conforms = report.conforms.at(k);
    levels[fmt::format("{}", k + 1)] = {{"conforms", conforms ? Json(*conforms) : Json(nullptr)},
                                        {"wrong", counts.at(k).wrong},
                                        {"permitted", counts.at(k).varied},
                                        {"not_decided", counts.at(k).undecided}};
  }
  return levels;
}

// The keys with which the JSON of every kind of claim begins.
Json judgement_fields(const CheckedFiles& files, Verdict verdict, const Profile& profile, const PointSet& points) {
  Json json = header_fields("flowcert-check", 1, points);
  json["verdict"] = verdict_text(verdict);
  json["grade"] = profile.grade();
  json["profile"] = profile_field({verdict, profile, files.check.tolerance});
  json["tolerance"] = files.check.tolerance;
  json["truth"] = truth_text(files);
  json["claim_format"] = files.claim_format;
  return json;
}

}  // namespace

Json finding_field(const Finding& finding, const AtomNames* atoms) {
  Json field = {{"level", finding.level},
                {"reason", reason_text(finding.reason)},
                {"permitted", finding.is_variation},
                {"decided", finding.is_decided},
                {"clause", finding.clause},
                {"line", finding.line ? Json(*finding.line) : Json(nullptr)},
                {"contact", finding.contact},
                {"claimed", finding.claimed},
                {"truth", finding.truth},
                {"sentence", finding.sentence}};
  if (atoms != nullptr) {
    field["names"] = Json::array();
    for (const PointId row : finding.contact) field["names"].push_back(atoms->text(row));
  }
  return field;
}

Json check_json(const CheckedFiles& files, const CheckReport& report, const PointSet& points) {
  Json json = judgement_fields(files, report.verdict, report.profile, points);
  json["indices"] = Json::array();
  for (std::size_t index = 0; index < 4; ++index) {
    if (report.indices.at(index)) json["indices"].push_back(index);
  }
  json["claimed"] = report.claimed_counts;
  json["critical"] = files.check.highest_level < 2 ? Json(nullptr) : Json(report.true_counts);
  json["levels"] = levels_field(report);
  json["reasons"] = reasons_field(report);
  json["not_judged"] = report.not_judged;
  json["not_decided"] = report.not_decided;
  Json& findings = json["findings"] = Json::array();
  for (const Finding& finding : report.findings) findings.push_back(finding_field(finding, files.atoms));
  return json;
}

Json check_json(const CheckedFiles& files, const PairReport& report, const PointSet& points) {
  Json json = judgement_fields(files, report.verdict, report.profile, points);
  const ListWords& words = list_words(report);
  Json& rows = json[words.key] = Json::array();
  for (std::size_t row = 0; row < report.truth.size(); ++row) {
    const DifferenceCounts counts = counts_of(report, row);
    rows.push_back({{words.row_key, words.row_keys[row]},
                    {"claimed", report.claimed.at(row)},
                    {"true", report.truth.at(row)},
                    {words.wrong, counts.spurious},
                    {"missing", counts.missing}});
    if (!report.left_out.empty()) rows.back()["not_claimed"] = report.left_out.at(row);
  }
  Json& findings = json["findings"] = Json::array();
  for (const PairDifference& difference : report.differences) {
    findings.push_back({{"reason", difference.reason},
                        {"clause", list_words(report).clause},
                        {"line", difference.line > 0 ? Json(difference.line) : Json(nullptr)},
                        {words.row_key, words.row_keys[static_cast<std::size_t>(difference.dimension)]},
                        {"claimed", difference.is_claimed ? Json(difference.claimed) : Json(nullptr)},
                        {"truth", difference.is_true ? Json(difference.truth) : Json(nullptr)},
                        {"sentence", sentence_of(difference)}});
  }
  return json;
}

std::string report_text(const Json& json, int indent) {
  return io::json_with_escapes(json.dump(indent, ' ', false, Json::error_handler_t::replace));
}

}  // namespace flowcert::certify
