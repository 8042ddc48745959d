// `flowcert generate | PROGRAM | flowcert verify`, for the tests of both commands. The program in the middle is
// answering_program.cpp.
//
// Guarantees: the exit status of verify is held to its verdict, and the counts of its report to each other.
#pragma once

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "tests/conformance/case_texts.h"
#include "tests/conformance/conformance_fixture.h"

namespace flowcert::conformance {

// The three programs one after the other, with files between them.
class Pipe {
 public:
  explicit Pipe(const Words& generate = {}, const Words& middle = {"exchange"})
      : cases_(generated(generate)), run_(run_of(generate)) {
    RunningProgram program(joined({FLOWCERT_MIDDLE}, middle), {scratch_.file("cases", cases_), ""});
    const Finished finished = program.finish();
    EXPECT_EQ(finished.status, 0) << finished.err;
    answers_ = finished.out;
  }

  // verify is told the run.
  [[nodiscard]] Finished verify(const Words& options = {}) const {
    return verify_text(answers_, joined(options, run_));
  }
  // The options that say so.
  [[nodiscard]] const Words& run() const { return run_; }
  [[nodiscard]] Finished verify_text(const std::string& answers, const Words& options = {}) const {
    return flowcert(joined({"verify"}, options), {scratch_.file("answers", answers), ""});
  }
  // The report. The exit status is checked against the verdict, and the counts against each other.
  [[nodiscard]] json as_json(const Words& options = {}) const {
    const Finished finished = verify(joined(options, {"--json"}));
    EXPECT_EQ(lines_of(finished.out).size(), 1U) << finished.err;
    json report = json::parse(finished.out, nullptr, false);
    EXPECT_TRUE(report.is_object()) << finished.out << finished.err;
    if (!report.is_object()) return json::object();
    EXPECT_EQ(finished.status, report["verdict"] == "fails" ? 1 : 0);
    expect_counts_add_up(report);
    return report;
  }

  [[nodiscard]] const std::string& cases() const { return cases_; }
  [[nodiscard]] const std::string& answers() const { return answers_; }
  [[nodiscard]] const Scratch& scratch() const { return scratch_; }

 private:
  static void expect_counts_add_up(const json& report) {
    for (const char* outcome :
         {"cases", "conforms", "conforms_where_determined", "fails", "unreadable", "refused", "unanswered"}) {
      std::size_t sum = 0;
      for (const json& family : report["families"]) sum += family[outcome].get<std::size_t>();
      EXPECT_EQ(report[outcome], sum) << outcome;
    }
    const std::size_t right = report["conforms"].get<std::size_t>() +
                              report["conforms_where_determined"].get<std::size_t>() +
                              report["perturbed"].get<std::size_t>();
    EXPECT_EQ(right == report["cases"], report["verdict"] != "fails");
  }

  // What generate was given, without the form of numbers and the choice of one case.
  static Words run_of(const Words& generate) {
    Words run;
    for (std::size_t k = 0; k < generate.size(); ++k) {
      if (generate[k] == "--case")
        ++k;
      else if (generate[k] != "--hex")
        run.push_back(generate[k]);
    }
    return run.empty() ? Words{"--level", "1"} : run;
  }

  Scratch scratch_;
  std::string cases_;
  Words run_;
  std::string answers_;
};

}  // namespace flowcert::conformance
