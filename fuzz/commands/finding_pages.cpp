#include "fuzz/commands/finding_pages.h"

#include <unistd.h>

#include <exception>
#include <filesystem>
#include <sstream>

#include "certify/viewer_claim.h"
#include "fuzz/campaign/child_process.h"
#include "fuzz/judge/peer_property.h"
#include "fuzz/properties/input_points.h"
#include "io/output_file.h"

namespace flowcert::commands {

namespace {

// A finding has a few points, so this is long.
constexpr unsigned kMostSeconds = 20;

std::string page_of(const fuzz::Counterexample& counterexample) {
  std::optional<ClaimText> claim;
  if (counterexample.disagreement.first_name == judge::kClaimName) {
    claim = {counterexample.disagreement.first, judge::kClaimName};
  }
  std::ostringstream page;
  write_claim_page(page, property::point_set_of(counterexample.trial.input), fuzz::name_of(counterexample), claim);
  return page.str();
}

void write_page(const fuzz::Counterexample& counterexample, const std::filesystem::path& path) {
  try {
    ::alarm(kMostSeconds);
    const std::string page = page_of(counterexample);
    ::alarm(0);
    write_whole_file(path.string(), [&](std::ostream& out) { out << page; });
  } catch (const std::exception&) {
    // What is thrown is a finding already, or the disk is full, which shows in the point files.
  }
}

}  // namespace

void write_finding_pages(const fuzz::Campaign& campaign) {
  for (const auto& [key, counterexample] : campaign.counterexamples()) {
    const std::filesystem::path points = campaign.file_of(counterexample);
    if (points.empty() || fuzz::ends_process(counterexample)) continue;
    const std::filesystem::path page = std::filesystem::path(points).replace_extension(".html");
    const fuzz::Counterexample& finding = counterexample;  // clang 14 cannot capture what a binding names
    fuzz::wait_for_end(fuzz::start_child([&] { write_page(finding, page); }));
  }
}

}  // namespace flowcert::commands
