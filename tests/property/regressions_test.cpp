// Every input that ever failed, and the classic traps, replayed: held to every property.
//
// Guarantees: all files of fuzz/regressions/ are run, each from the start that it names, and from some
// others; a directory that cannot be read, a file that cannot, or one without points, fails.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>

#include "fuzz/campaign/campaign_plan.h"
#include "fuzz/campaign/counterexample.h"
#include "fuzz/properties/property.h"
#include "tests/cites.h"

namespace flowcert::property::regressions_test {
namespace {

constexpr std::uint64_t kStarts = 20;

std::set<std::filesystem::path> regression_files() {
  std::set<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(FLOWCERT_REGRESSIONS)) {
    if (entry.path().extension() == ".xyz") {
      files.insert(entry.path());
    }
  }
  return files;
}

fuzz::Counterexample read_counterexample(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return fuzz::counterexample_of(text.str());
}

void expect_holds(const Property& property, const Trial& trial, const std::filesystem::path& path) {
  EXPECT_LE(trial.input.rows.size(), property.most_rows) << path << ": too large for " << property.name;
  const auto found = disagreement(property, trial);
  if (!found) return;
  ADD_FAILURE() << path << ", " << property.name << ": " << found->complaint << '\n'
                << found->first_name << '\n'
                << found->first << '\n'
                << found->second_name << '\n'
                << found->second;
}

TEST(Regressions, EveryPropertyHolds) {
  CITES("FC-CERT-02", "FC-CERT-03", "FC-CERT-06", "FC-CRIT-02", "FC-CRIT-03", "FC-CRIT-05", "FC-FLOW-02", "FC-FLOW-07",
        "FC-INV-01", "FC-OUT-02", "FC-PERS-05", "FC-STAB-04", "FC-STAB-05");
  const auto files = regression_files();
  EXPECT_GE(files.size(), 3U);
  for (const std::filesystem::path& path : files) {
    const fuzz::Counterexample counterexample = read_counterexample(path);
    EXPECT_FALSE(counterexample.trial.input.rows.empty()) << path;
    for (const Property& property : properties()) {
      expect_holds(property, counterexample.trial, path);
      const bool has_start = property.name == "orbit" || property.name == "orbit-kernels";
      for (std::uint64_t seed = 0; has_start && seed < kStarts; ++seed) {
        expect_holds(property, {counterexample.trial.input, fuzz::TrialMix::draw_start(seed)}, path);
      }
    }
  }
}

}  // namespace
}  // namespace flowcert::property::regressions_test
