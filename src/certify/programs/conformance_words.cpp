#include "certify/programs/conformance_words.h"

#include <fmt/format.h>

#include "io/foreign_text.h"

namespace flowcert::certify {

namespace {

constexpr std::size_t kLongestLine = 300;

}  // namespace

const char* run_outcome_text(RunOutcome outcome) {
  constexpr std::array<const char*, kRunOutcomes> kTexts = {"conforms",  "conforms where determined",
                                                            "perturbed", "properly refused",
                                                            "skipped",   "fails",
                                                            "accepted",  "refused",
                                                            "crashed",   "timed out",
                                                            "unreadable"};
  return kTexts.at(static_cast<std::size_t>(outcome));
}

std::string one_line(const std::string& text) {
  const std::string line = io::on_one_line(io::front_of(text, kLongestLine));
  return text.size() > kLongestLine ? line + "..." : line;
}

std::string finding_words(const Finding& finding) {
  return one_line(fmt::format("level {}: {} [{}]: claimed {}; truth: {}", finding.level, reason_text(finding.reason),
                              finding.clause, finding.claimed, finding.truth));
}

std::string orbit_finding_words(const OrbitFinding& finding) {
  return one_line(fmt::format("orbit from {}: claimed {}; truth: {}", finding.start, finding.difference.claimed,
                              finding.difference.truth));
}

std::string persistence_finding_words(const PairDifference& difference) {
  return one_line(fmt::format("persistence{}: claimed {}; truth: {}", difference.by_rounding ? ", rounding" : "",
                              difference.claimed, difference.truth));
}

}  // namespace flowcert::certify
