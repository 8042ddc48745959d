// What the tests of `flowcert conformance` share: cases to know by name, and a folder of few vectors to run
// programs against.
//
// Guarantees: every test runs with a folder for temporary files whose name a shell would take apart, and
// fails if anything is left there.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <nlohmann/json.hpp>

#include "tests/conformance/program_run.h"

namespace flowcert::conformance {

namespace fs = std::filesystem;
using nlohmann::json;
using Words = std::vector<std::string>;

// A regular tetrahedron: each of its four points of index 2 has the maximum and infinity as limits.
inline constexpr char kTetrahedron[] = "unstable-manifolds-0002";
inline constexpr char kTetrahedronOrbits[] = "orbits-0003";
// A right triangle: two of the orbits end at its regular stationary point.
inline constexpr char kTriangleOrbits[] = "orbits-0004";
// An acute triangle: edges of squared length 10, 16 and 18, and a circle of squared radius 5.
inline constexpr char kTrianglePairs[] = "persistence-0005";

inline const std::string kCompute = std::string(FLOWCERT_PROGRAM) + " compute {in} -o {out} --manifolds u2";
inline const std::string kPersistence = std::string(FLOWCERT_PROGRAM) + " persistence {in} -o {out}";
inline const std::string kOrbit = std::string(FLOWCERT_PROGRAM) + " orbit {in} --from {start} --json > {out}";

// The only case of a report. If there is not exactly one, this is an object with empty fields.
inline json only_case_of(const json& report) {
  const json cases = report.value("cases", json::array());
  EXPECT_EQ(cases.size(), 1U) << report;
  if (cases.size() == 1) return cases[0];
  return {{"outcome", ""},
          {"level", ""},
          {"message", ""},
          {"findings", json::array()},
          {"orbit_findings", json::array()},
          {"persistence_findings", json::array()}};
}

// A folder with the first cases of some groups, because reading all cases takes long.
class FewVectors {
 public:
  FewVectors() {
    fs::copy_file(fs::path(FLOWCERT_VECTORS) / "flags.json", scratch_.path("flags.json"));
    fs::copy_file(fs::path(FLOWCERT_VECTORS) / "invalid-input.json", scratch_.path("invalid-input.json"));
    for (const std::string group :
         {"flat-inputs", "orbits", "persistence", "regular-stationary-points", "unstable-manifolds"}) {
      json file = json::parse(content_of(std::string(FLOWCERT_VECTORS) + "/" + group + ".json"));
      file["cases"].erase(file["cases"].begin() + kCases, file["cases"].end());
      std::ofstream(scratch_.path(group + ".json")) << file;
    }
  }
  [[nodiscard]] std::string folder() const { return scratch_.path(""); }

 private:
  static constexpr std::ptrdiff_t kCases = 6;
  Scratch scratch_;
};

class ConformanceCommand : public testing::Test {
 protected:
  static void SetUpTestSuite() { few_vectors = new FewVectors; }
  static void TearDownTestSuite() { delete few_vectors; }

  void SetUp() override {
    temporary_ = scratch_.path("it's temporary");
    fs::create_directory(temporary_);
    ::setenv("TMPDIR", temporary_.c_str(), 1);
  }
  void TearDown() override {
    EXPECT_TRUE(fs::is_empty(temporary_)) << "left behind";
    ::unsetenv("TMPDIR");
  }

  static Words command(Words words, const std::string& vectors = few_vectors->folder()) {
    words.insert(words.begin(), {"conformance", "--vectors", vectors});
#ifdef __SANITIZE_ADDRESS__
    // The sanitizer's shadow memory takes terabytes of addresses.
    words.insert(words.end(), {"--memory-limit", "0"});
#endif
    return words;
  }
  static Finished run(const Words& words, const std::string& vectors = few_vectors->folder()) {
    return flowcert(command(words, vectors));
  }
  // The report. The exit status is checked against the verdict.
  static json as_json(Words words, const std::string& vectors = few_vectors->folder()) {
    words.emplace_back("--json");
    const Finished finished = run(words, vectors);
    json report = json::parse(finished.out, nullptr, false);
    EXPECT_TRUE(report.is_object()) << finished.out << finished.err;
    if (!report.is_object()) return json::object();
    EXPECT_EQ(finished.status, report["verdict"] == "fails" ? 1 : 0);
    return report;
  }

  // A program as a shell script: $1 is the file of points, $2 the file for the claim.
  [[nodiscard]] std::string script(const std::string& lines) const {
    return "sh " + scratch_.file("program.sh", lines + "\n") + " {in} {out}";
  }
  // What the report says of the tetrahedron, or of another case, when a script answers it.
  [[nodiscard]] json outcome_of(const std::string& lines, const std::string& id = kTetrahedron,
                                const std::string& time_limit = "60") const {
    const json report = as_json({"--against", script(lines), "--case", id, "--time-limit", time_limit});
    return only_case_of(report);
  }
  void expect_outcome(const std::string& lines, const std::string& outcome, const std::string& message) const {
    const json one = outcome_of(lines, kTetrahedron, outcome == "timed out" ? "1" : "60");
    EXPECT_EQ(one["outcome"], outcome) << lines << one;
    EXPECT_NE(one["message"].get<std::string>().find(message), std::string::npos) << lines << one;
  }

  static inline const FewVectors* few_vectors = nullptr;
  Scratch scratch_;
  std::string temporary_;
};

}  // namespace flowcert::conformance
