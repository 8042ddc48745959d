#include "fuzz/commands/fuzz_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "certify/programs/command_run.h"
#include "cli/check_report.h"
#include "cli/command.h"
#include "cli/reason_table.h"
#include "cli/shortened_numbers.h"
#include "cli/table.h"
#include "cli/wrapped_text.h"
#include "fuzz/commands/fuzz_options.h"
#include "io/json_fields.h"

namespace flowcert::commands {

namespace {

using nlohmann::ordered_json;
using Rows = std::vector<std::vector<std::string>>;

constexpr std::size_t kFuzzIndent = 4;
constexpr double kFastRate = 10;  // of cases a second
constexpr char kEndedBefore[] = "the run ended before";

double rate_of(const fuzz::RowsTally& tally) {
  return tally.seconds > 0 ? static_cast<double>(tally.cases) / tally.seconds : 0;
}

template <typename Counts>
Rows rows_of(const Counts& counts) {
  Rows rows;
  for (const auto& [name, count] : counts) rows.push_back({name, with_commas(count)});
  return rows;
}

void print_part(const char* title, const Rows& rows, std::string_view alignment) {
  if (rows.empty()) return;
  fmt::print("\n{}\n", title);
  print_columns(rows, alignment);
}

void print_sizes(const fuzz::Tally& tally) {
  Rows rows{{"points", "cases", "cases/s of one job"}};
  const auto add = [&](const std::string& points, const fuzz::RowsTally& of) {
    rows.push_back({points, with_commas(of.cases), fmt::format("{:.0f}", rate_of(of))});
  };
  fuzz::RowsTally large;
  for (const auto& [count, of] : tally.by_rows) {
    if (count <= fuzz::kMostRowsOfTrial) add(std::to_string(count), of);
    if (count > fuzz::kMostRowsOfTrial) large = {large.cases + of.cases, large.seconds + of.seconds};
  }
  if (large.cases > 0) add("more", large);
  print_part("By number of points:", rows, "rrr");
}

std::size_t share_of(const fuzz::CampaignPlan& plan, const std::string& name) {
  const property::Property* property = property::property_named(name);
  return property == nullptr || !plan.properties.empty() ? 1 : property->one_in;
}

void print_properties(const fuzz::Campaign& campaign) {
  Rows rows;
  const auto all = campaign.failures();
  for (const auto& [name, cases] : campaign.tally().by_property) {
    std::size_t failures = 0;
    for (const auto& [kind, numbers] : all) {
      if (kind.starts_with(name + ' ')) failures += numbers.size();
    }
    const std::size_t share = share_of(campaign.plan(), name);
    rows.push_back({name, counted(cases, "case"), fmt::format("{} failing", with_commas(failures)),
                    share == 1 ? "" : fmt::format("(one case in {})", share)});
  }
  print_part("By property:", rows, "lrrl");
}

// "cluster      none 120, 4 30, 5 11"
void print_reached(const fuzz::Campaign& campaign) {
  Rows rows;
  const auto& components = fuzz::signature_components();
  for (std::size_t k = 0; k < components.size(); ++k) {
    std::string values;
    const auto& reached = campaign.tally().reached[k];
    if (!components[k].is_set) {
      for (const auto& [value, cases] : reached) {
        values += fmt::format("{}{}: {}", values.empty() ? "" : ",  ", fuzz::value_text(k, value), with_commas(cases));
      }
    } else {
      for (std::size_t bit = 0; bit < components[k].texts.size(); ++bit) {
        std::size_t with = 0;
        for (const auto& [value, cases] : reached) with += (value >> bit & 1) != 0 ? cases : 0;
        values += fmt::format("{}{}: {}", values.empty() ? "" : ",  ", components[k].texts[bit], with_commas(with));
      }
    }
    rows.push_back({components[k].name, values});
  }
  print_part("Degeneracy reached, by component of the signature, in cases:", rows, "ll");
}

// ---- Findings

// A kind of failing cases, and the smallest of its findings.
struct Kind {
  std::string name;
  std::size_t cases = 0;
  const fuzz::Counterexample* smallest = nullptr;  // one that the known findings do not explain, if there is any
  bool is_explained = false;
};

struct ListedFinding {
  const fuzz::Counterexample* finding;
  bool is_explained;
};

// The first is what a reader should look at first: what is not explained, and small. Whether a finding is explained
// takes its signature, and so is asked once.
std::vector<ListedFinding> in_order(const FuzzRun& run) {
  std::vector<ListedFinding> findings;
  for (const auto& [key, finding] : run.campaign.counterexamples()) {
    findings.push_back({&finding, run.known.explain(finding)});
  }
  std::ranges::stable_sort(findings, {}, [](const ListedFinding& listed) {
    return std::pair(listed.is_explained, listed.finding->trial.input.rows.size());
  });
  return findings;
}

// Kinds that are not explained come first, and of these the most frequent one.
std::vector<Kind> kinds_of(const FuzzRun& run, const std::vector<ListedFinding>& findings) {
  std::vector<Kind> kinds;
  for (const auto& [name, cases] : run.campaign.failures()) {
    Kind kind{name, cases.size()};
    const auto first = std::ranges::find(findings, name, [](const auto& listed) { return kind_of(*listed.finding); });
    if (first != findings.end()) {
      kind.smallest = first->finding;
      kind.is_explained = first->is_explained;
    }
    kinds.push_back(kind);
  }
  std::ranges::stable_sort(kinds, [](const Kind& a, const Kind& b) {
    return a.is_explained != b.is_explained ? b.is_explained : a.cases > b.cases;
  });
  return kinds;
}

void print_kinds(const FuzzRun& run, const std::vector<Kind>& kinds) {
  if (kinds.empty()) return;
  Table table(run.known.is_empty() ? "lrl" : "lrll", {"kind", "cases", "smallest example"});
  for (const Kind& kind : kinds) {
    table.row(kind.name).cell(kind.cases);
    const auto* smallest = kind.smallest;
    table.cell(smallest == nullptr
                   ? ""
                   : fmt::format("case {}, {}", smallest->number, points_text(smallest->trial.input.rows.size())));
    if (kind.is_explained) table.cell("known");
  }
  table.print();
}

// Why a finding of this run is not small yet.
std::string unless_small(const FuzzRun& run) {
  if (run.is_interrupted) return "stopped by a signal";
  return run.is_time_up ? "time was up" : kEndedBefore;
}

struct PrintedFindings {
  std::vector<const fuzz::Counterexample*> findings;
  std::size_t equal = 0;  // findings that look like one of these, or like one that was printed
};

// One finding of each kind, and then the others, but for those that were printed and those that are explained.
PrintedFindings findings_to_print(const FuzzRun& run, const std::vector<Kind>& kinds,
                                  const std::vector<ListedFinding>& findings) {
  PrintedFindings printed;
  FindingKeys done;
  std::set<ShownFinding> shown;
  if (run.printed != nullptr) done = *run.printed;
  for (const FindingKey& key : done) shown.insert(shown_of(run.campaign.counterexamples().at(key)));
  const auto add = [&](const fuzz::Counterexample& finding, bool is_explained) {
    if (is_explained || !done.insert(key_of(finding)).second) return;
    if (shown.insert(shown_of(finding)).second) {
      printed.findings.push_back(&finding);
    } else {
      ++printed.equal;
    }
  };
  for (const Kind& kind : kinds) {
    if (kind.smallest != nullptr) add(*kind.smallest, kind.is_explained);
  }
  for (const ListedFinding& listed : findings) add(*listed.finding, listed.is_explained);
  return printed;
}

// Those that were not printed before. Known ones are counted.
void print_counterexamples(const FuzzRun& run, const std::vector<Kind>& kinds,
                           const std::vector<ListedFinding>& findings) {
  const fuzz::Campaign& campaign = run.campaign;
  if (campaign.counterexamples().empty()) return;
  const PrintedFindings printed = findings_to_print(run, kinds, findings);
  const std::size_t all = printed.findings.size(), most = kinds.size() + kMostFindingsPrinted;
  const auto explained = static_cast<std::size_t>(std::ranges::count(findings, true, &ListedFinding::is_explained));
  const bool is_first = run.printed == nullptr || run.printed->empty();
  fmt::print("\n");
  if (all > 0 || explained > 0) fmt::print("{}:\n", is_first ? "Findings" : "Other findings");
  for (std::size_t k = 0; k < std::min(all, most); ++k) {
    print_finding(campaign, *printed.findings[k], unless_small(run));
  }
  if (all > most) fmt::print("  ... and {} more\n", with_commas(all - most));
  if (printed.equal > 0) {
    fmt::print("  {} more with the same points as one above\n", with_commas(printed.equal));
  }
  if (explained > 0) {
    fmt::print("  {} of {}: explained by known ones\n", with_commas(explained),
               counted(campaign.counterexamples().size(), "finding"));
  }
  const fuzz::CampaignPlan& plan = campaign.plan();
  fmt::print("Again: flowcert fuzz --replay FILE{}\n",
             plan.against.empty() ? "" : fmt::format(" {} {}", against_option(plan), shell_word(plan.against)));
}

void print_fuzz_text(const FuzzRun& run) {
  const fuzz::Campaign& campaign = run.campaign;
  const fuzz::Tally& tally = campaign.tally();
  const fuzz::CampaignPlan& plan = campaign.plan();
  const auto expected = campaign.expected_cases();
  const std::vector<ListedFinding> findings = in_order(run);
  const std::vector<Kind> kinds = kinds_of(run, findings);
  if (run.printed != nullptr && !run.printed->empty()) fmt::print("\n");
  print_kinds(run, kinds);
  print_counterexamples(run, kinds, findings);
  if (!kinds.empty()) fmt::print("\n");
  print_row("cases", with_commas(tally.cases), expected ? "of " + with_commas(*expected) : "");
  print_row("seed", std::to_string(plan.seed));
  if (campaign.made_by().size() > 1) {
    print_row("programs", std::to_string(campaign.made_by().size()), "different ones: they may have drawn other cases");
  }
  if (plan.shard.count > 1) print_row("shard", fmt::format("{}/{}", plan.shard.index + 1, plan.shard.count));
  if (run.seconds) {
    const double rate = static_cast<double>(run.cases) / *run.seconds;
    print_row(
        "cases a second", fmt::format("{:.{}f}", rate, rate < kFastRate ? 1 : 0),
        fmt::format("{} in {}, {}", counted(run.cases, "case"), seconds_text(*run.seconds), counted(run.jobs, "job")));
  }
  print_row("signatures", with_commas(campaign.signatures().size()), "distinct degeneracies of inputs");
  print_row("failing cases", with_commas(campaign.failing_cases()),
            counted(campaign.counterexamples().size(), "finding"));
  if (!plan.ignored.empty()) print_row("ignored", "", fmt::format("{}", fmt::join(plan.ignored, ", ")));
  print_properties(campaign);
  print_sizes(tally);
  print_part("By family:", rows_of(tally.by_source), "lr");
  print_part("Mutants by their moves:", rows_of(tally.by_mutation), "lr");
  print_reached(campaign);
  if (run.is_interrupted) fmt::print("\nStopped by a signal.\n");
}

// ---- JSON

ordered_json counterexample_json(const fuzz::Campaign& campaign, const fuzz::Counterexample& counterexample,
                                 const std::string& unless_small) {
  const std::string why = why_not_fully_shrunk(counterexample, unless_small);
  return {{"case", counterexample.number},
          {"source", counterexample.source},
          {"property", counterexample.property},
          {"kind", counterexample.disagreement.kind},
          {"clause", counterexample.disagreement.clause},
          {"complaint", counterexample.disagreement.complaint},
          {"points", counterexample.trial.input.rows.size()},
          {"points_before", counterexample.rows_before},
          {"not_fully_shrunk", why.empty() ? ordered_json(nullptr) : ordered_json(why)},
          {"file", campaign.file_of(counterexample).string()}};
}

ordered_json reached_json(const fuzz::Tally& tally) {
  ordered_json components = ordered_json::object();
  for (std::size_t k = 0; k < fuzz::signature_components().size(); ++k) {
    ordered_json values = ordered_json::object();
    for (const auto& [value, cases] : tally.reached[k]) values[fuzz::value_text(k, value)] = cases;
    components[fuzz::signature_components()[k].name] = values;
  }
  return components;
}

// In the order of the table.
ordered_json kinds_json(const FuzzRun& run) {
  ordered_json kinds = ordered_json::array();
  for (const Kind& kind : kinds_of(run, in_order(run))) {
    ordered_json object = {{"kind", kind.name}, {"cases", kind.cases}, {"explained", kind.is_explained}};
    object["smallest"] = kind.smallest == nullptr ? ordered_json(nullptr) : ordered_json(kind.smallest->number);
    object["smallest_points"] =
        kind.smallest == nullptr ? ordered_json(nullptr) : ordered_json(kind.smallest->trial.input.rows.size());
    kinds.push_back(object);
  }
  return kinds;
}

void print_fuzz_json(const FuzzRun& run) {
  const fuzz::Campaign& campaign = run.campaign;
  const fuzz::Tally& tally = campaign.tally();
  ordered_json rows = ordered_json::array();
  for (const auto& [count, of] : tally.by_rows) {
    rows.push_back({{"points", count}, {"cases", of.cases}, {"cases_per_second_of_one_job", rate_of(of)}});
  }
  const auto failing = campaign.failures();
  ordered_json failures = ordered_json::object();
  for (const auto& [kind, numbers] : failing) failures[kind] = numbers.size();
  ordered_json counterexamples = ordered_json::array();
  for (const auto& [key, counterexample] : campaign.counterexamples())
    counterexamples.push_back(counterexample_json(campaign, counterexample, unless_small(run)));
  ordered_json report = io::header_fields("flowcert-fuzz-report", 1);
  report.update({{"cases", tally.cases},
                 {"seed", campaign.plan().seed},
                 {"shard", {campaign.plan().shard.index + 1, campaign.plan().shard.count}},
                 {"interrupted", run.is_interrupted},
                 {"signatures", campaign.signatures().size()},
                 {"failing_cases", campaign.failing_cases()},
                 {"failures", failures},
                 {"failing", failing},
                 {"by_property", tally.by_property},
                 {"by_family", tally.by_source},
                 {"by_mutation", tally.by_mutation},
                 {"by_points", rows},
                 {"reached", reached_json(tally)},
                 {"findings", counterexamples},
                 {"kinds", kinds_json(run)}});
  if (!run.known.is_empty()) report["explained"] = run.known.explained_of(campaign);
  if (!campaign.plan().ignored.empty()) report["ignored"] = campaign.plan().ignored;
  if (run.seconds) {
    report["seconds"] = *run.seconds;
    report["cases_per_second"] = static_cast<double>(run.cases) / *run.seconds;
    report["jobs"] = run.jobs;
  }
  print_report_json(report, 2);
}

constexpr std::size_t kMostPointsPrinted = 5;

// "(0, 0, 0) (1, 0.5, 0)", exact
std::string rows_text(const std::vector<fuzz::Row>& rows) {
  std::string text;
  for (const auto& [x, y, z] : rows) text += fmt::format("{}({}, {}, {})", text.empty() ? "" : " ", x, y, z);
  return text;
}

}  // namespace

void print_finding(const fuzz::Campaign& campaign, const fuzz::Counterexample& finding,
                   const std::string& unless_small) {
  const std::string file = campaign.file_of(finding).string();
  const std::string text = fmt::format("  case {}, {} of {} ({}, before {}): {}", finding.number,
                                       finding.disagreement.kind, points_text(finding.trial.input.rows.size()),
                                       finding.source, finding.rows_before, one_line(finding.disagreement.complaint));
  fmt::print("{}\n", wrapped(with_short_numbers(text), kFuzzIndent));
  if (finding.trial.input.rows.size() <= kMostPointsPrinted) {
    fmt::print("    {}\n", wrapped(rows_text(finding.trial.input.rows), kFuzzIndent));
  }
  const std::string why = why_not_fully_shrunk(finding, unless_small);
  if (!why.empty()) fmt::print("    not fully shrunk: {}\n", why);
  if (!file.empty()) fmt::print("    {}\n", file);
}

void print_fuzz(const FuzzRun& run, bool json) {
  if (json) {
    print_fuzz_json(run);
  } else {
    print_fuzz_text(run);
  }
}

int print_case(const fuzz::Campaign& campaign, const fuzz::OneCase& one, bool json) {
  const bool holds = one.counterexamples().empty();
  ordered_json findings = ordered_json::array();
  if (!json) fmt::print("case {} of seed {}{}\n", one.number(), campaign.plan().seed, holds ? ": holds" : "");
  for (const auto& [kind, counterexample] : one.counterexamples()) {
    if (json) {
      findings.push_back(counterexample_json(campaign, counterexample, kEndedBefore));
    } else {
      print_finding(campaign, counterexample, kEndedBefore);
    }
  }
  if (json) {
    ordered_json report = io::header_fields("flowcert-fuzz-case", 1);
    report["case"] = one.number();
    report["seed"] = campaign.plan().seed;
    report["findings"] = findings;
    print_report_json(report, 2);
  }
  return holds ? kRight : kNegativeVerdict;
}

int verdict_of(const FuzzRun& run) {
  const bool are_explained = run.known.explained_of(run.campaign) == run.campaign.counterexamples().size();
  return are_explained ? kRight : kNegativeVerdict;
}

}  // namespace flowcert::commands
