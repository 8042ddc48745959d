#include "fuzz/commands/known_findings.h"

#include <algorithm>
#include <filesystem>

#include "flowcert/point_set.h"
#include "fuzz/commands/fuzz_options.h"

namespace flowcert::commands {

namespace {

fuzz::Counterexample known_finding(const std::filesystem::path& path) {
  fuzz::Counterexample finding = read_counterexample(path);
  if (finding.property.empty() || finding.disagreement.kind.empty()) {
    throw InvalidInput(path.string() + ": it does not say of which property and kind the finding is");
  }
  return finding;
}

}  // namespace

KnownFindings::KnownFindings(const std::vector<std::string>& paths) {
  for (const std::string& path : paths) {
    if (std::filesystem::is_directory(path)) {
      add_folder(path);
    } else {
      known_.insert(way_of(known_finding(path)));
    }
  }
}

void KnownFindings::add_folder(const std::string& path) {
  if (std::filesystem::exists(std::filesystem::path(path) / fuzz::kPlanName)) {
    const fuzz::Campaign campaign = fuzz::Campaign::read(path);
    for (const auto& [key, finding] : campaign.counterexamples()) known_.insert(way_of(finding));
    return;
  }
  std::error_code failure;
  for (const auto& entry : std::filesystem::directory_iterator(path, failure)) {
    if (entry.path().extension() == ".xyz") known_.insert(way_of(known_finding(entry.path())));
  }
  if (failure) throw InvalidInput(path + ": " + failure.message());
}

KnownFindings::Way KnownFindings::way_of(const fuzz::Counterexample& finding) {
  return {kind_of(finding), combinatorial_part(signature_of(finding.trial.input))};
}

bool KnownFindings::explain(const fuzz::Counterexample& finding) const {
  return !known_.empty() && known_.contains(way_of(finding));
}

std::size_t KnownFindings::explained_of(const fuzz::Campaign& campaign) const {
  return static_cast<std::size_t>(
      std::ranges::count_if(campaign.counterexamples(), [&](const auto& one) { return explain(one.second); }));
}

}  // namespace flowcert::commands
