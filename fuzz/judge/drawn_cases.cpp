#include "fuzz/judge/drawn_cases.h"

#include <fmt/format.h>

#include <utility>

#include "fuzz/properties/input_points.h"

namespace flowcert::judge {

namespace {

class DrawnCases final : public AskedCases {
 public:
  explicit DrawnCases(fuzz::CaseRun run) : run_(std::move(run)) {}

  [[nodiscard]] std::size_t size() const override { return run_.cases; }
  [[nodiscard]] std::optional<std::size_t> most_points() const override { return run_.most_points; }
  [[nodiscard]] std::string description() const override {
    return fmt::format("{} case{}, level {}, seed {}{}", run_.cases, run_.cases == 1 ? "" : "s", run_.level, run_.seed,
                       what_is_left_out());
  }

  [[nodiscard]] AskedCase named(const std::string& id) const override {
    if (id.starts_with(kVectorPrefix)) reject_other_run(id);
    std::optional<fuzz::NamedCase> named = fuzz::case_named(id);
    if (!named) reject_name(id);
    if (named->run != run_) reject_other_run(id);
    return {named->number, property::rows_of(named->input)};
  }
  [[nodiscard]] std::string id(const AskedCase& one) const override {
    return fuzz::case_id(run_, one.number, property::input_of(one.rows));
  }
  [[nodiscard]] AskedCase numbered(std::size_t number) const override {
    return {number, property::rows_of(fuzz::input_of_case(run_, number))};
  }

  [[nodiscard]] std::string family(std::size_t number) const override {
    return fuzz::family_of_case(run_, number).name;
  }
  [[nodiscard]] std::vector<std::string> families() const override { return fuzz::family_names(run_); }
  [[nodiscard]] std::vector<std::string> flags(std::size_t /*number*/) const override { return {}; }
  [[nodiscard]] std::vector<std::string> flags() const override { return {}; }

  [[nodiscard]] std::string file_name(std::size_t number) const override {
    return fmt::format("case-{}-{}-{}", run_.level, run_.seed, number);
  }
  [[nodiscard]] std::string run_options() const override {
    std::string options = fmt::format("--level {} --seed {}", run_.level, run_.seed);
    if (run_.cases != fuzz::usual_cases(run_.level)) options += fmt::format(" --cases {}", run_.cases);
    if (!run_.chosen.empty()) {
      for (const std::string& name : families()) options += " --family " + name;
    }
    return options + most_points_option();
  }
  [[nodiscard]] bool is_stored() const override { return false; }
  [[nodiscard]] const VectorCase* stored(std::size_t /*number*/) const override { return nullptr; }

 private:
  fuzz::CaseRun run_;
};

}  // namespace

std::unique_ptr<AskedCases> drawn_cases(const fuzz::CaseRun& run) { return std::make_unique<DrawnCases>(run); }

std::unique_ptr<AskedCases> drawn_cases_of(const std::string& id) {
  const std::optional<fuzz::NamedCase> named = fuzz::case_named(id);
  return named ? drawn_cases(named->run) : nullptr;
}

}  // namespace flowcert::judge
