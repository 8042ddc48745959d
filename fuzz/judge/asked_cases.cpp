// The id of a vector is made of a digest over all that the vectors say, so that verify never judges by others than
// those that were asked.
#include "fuzz/judge/asked_cases.h"

#include <fmt/format.h>

#include <map>
#include <utility>

#include "fuzz/judge/command_run.h"
#include "fuzz/judge/oracle_truth.h"
#include "fuzz/judge/vector_cases.h"
#include "fuzz/judge/vectors_folder.h"
#include "io/number_text.h"

namespace flowcert::judge {

namespace {

constexpr std::string_view kVectorPrefix = "vector:";

[[noreturn]] void reject_name(const std::string& id) { throw InvalidInput("no case is called " + in_quotes(id)); }
[[noreturn]] void reject_other_run(const std::string& id) {
  throw InvalidInput("a case of another run: " + in_quotes(id));
}

// ---- Drawn cases ----

class DrawnCases final : public AskedCases {
 public:
  explicit DrawnCases(fuzz::CaseRun run) : run_(std::move(run)) {}

  [[nodiscard]] std::size_t size() const override { return run_.cases; }
  [[nodiscard]] std::string description() const override {
    return fmt::format("{} case{}, level {}, seed {}", run_.cases, run_.cases == 1 ? "" : "s", run_.level, run_.seed);
  }

  [[nodiscard]] AskedCase named(const std::string& id) const override {
    if (id.starts_with(kVectorPrefix)) reject_other_run(id);
    std::optional<fuzz::NamedCase> named = fuzz::case_named(id);
    if (!named) reject_name(id);
    if (named->run != run_) reject_other_run(id);
    return {named->number, std::move(named->input)};
  }
  [[nodiscard]] std::string id(const AskedCase& one) const override {
    return fuzz::case_id(run_, one.number, one.input);
  }
  [[nodiscard]] AskedCase numbered(std::size_t number) const override {
    return {number, fuzz::input_of_case(run_, number)};
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
    return options;
  }
  [[nodiscard]] bool is_stored() const override { return false; }
  [[nodiscard]] std::unique_ptr<Truth> stored_truth(std::size_t /*number*/) const override { return nullptr; }
  [[nodiscard]] std::optional<std::vector<ListedPair>> stored_pairs(std::size_t /*number*/) const override {
    return std::nullopt;
  }

 private:
  fuzz::CaseRun run_;
};

// ---- Vectors ----

std::uint64_t digest_on(std::uint64_t digest, std::string_view text) {
  for (const char c : text) digest = fuzz::mixed(digest ^ static_cast<unsigned char>(c));
  return digest;
}

class VectorsToAsk final : public AskedCases {
 public:
  explicit VectorsToAsk(const std::string& given)
      : given_(given), folder_(given.empty() ? usual_vectors_folder() : given), vectors_(read_vectors(folder_)) {
    std::erase_if(vectors_.cases, [](const VectorCase& one) { return one.is_invalid(); });
    if (vectors_.cases.empty()) throw InvalidInput(folder_ + ": no conformance vectors but invalid cases");
    std::uint64_t digest = 0;
    for (const VectorCase& one : vectors_.cases) digest = digest_on(digest, one.json);
    for (const VectorCase& one : vectors_.cases) {
      ids_.push_back(fmt::format("{}{}:{:04x}", kVectorPrefix, one.id, digest_on(digest, one.id) & 0xffff));
      number_of_.emplace(ids_.back(), ids_.size() - 1);
    }
  }

  [[nodiscard]] std::size_t size() const override { return ids_.size(); }
  [[nodiscard]] std::string description() const override {
    return fmt::format("{} conformance vector{}", size(), size() == 1 ? "" : "s");
  }

  [[nodiscard]] AskedCase named(const std::string& id) const override {
    const auto found = number_of_.find(id);
    if (found != number_of_.end()) return numbered(found->second);
    if (id.starts_with(kVectorPrefix)) {
      throw InvalidInput(fmt::format("no case of the vectors in {} is called {}", folder_, in_quotes(id)));
    }
    if (fuzz::case_named(id)) reject_other_run(id);
    reject_name(id);
  }
  [[nodiscard]] std::string id(const AskedCase& one) const override { return ids_.at(one.number); }
  [[nodiscard]] AskedCase numbered(std::size_t number) const override {
    AskedCase result{number, {}};
    for (const Point& p : vectors_.cases.at(number).rows) result.input.rows.push_back({p.x, p.y, p.z});
    return result;
  }

  [[nodiscard]] std::string family(std::size_t number) const override { return vectors_.cases.at(number).group; }
  [[nodiscard]] std::vector<std::string> families() const override { return vectors_.groups; }
  [[nodiscard]] std::vector<std::string> flags(std::size_t number) const override {
    return vectors_.cases.at(number).flags;
  }
  [[nodiscard]] std::vector<std::string> flags() const override {
    std::vector<std::string> names;
    names.reserve(vectors_.flags.size());
    for (const VectorFlag& flag : vectors_.flags) names.push_back(flag.name);
    return names;
  }

  [[nodiscard]] std::string file_name(std::size_t number) const override { return vectors_.cases.at(number).id; }
  [[nodiscard]] std::string run_options() const override {
    return given_.empty() ? "--vectors" : "--vectors " + shell_word(given_);
  }
  [[nodiscard]] bool is_stored() const override { return true; }
  [[nodiscard]] std::unique_ptr<Truth> stored_truth(std::size_t number) const override {
    return vector_truth(vectors_.cases.at(number));
  }
  [[nodiscard]] std::optional<std::vector<ListedPair>> stored_pairs(std::size_t number) const override {
    return vectors_.cases.at(number).persistence;
  }

 private:
  std::string given_;
  std::string folder_;
  Vectors vectors_;
  std::vector<std::string> ids_;  // by number
  std::map<std::string, std::size_t> number_of_;
};

}  // namespace

std::string AskedCases::generate_command(std::optional<std::size_t> number) const {
  return "flowcert generate " + run_options() + (number ? fmt::format(" --only {}", *number) : "");
}

std::unique_ptr<AskedCases> drawn_cases(const fuzz::CaseRun& run) { return std::make_unique<DrawnCases>(run); }

std::unique_ptr<AskedCases> vectors_to_ask(const std::string& given) { return std::make_unique<VectorsToAsk>(given); }

std::unique_ptr<AskedCases> cases_with(const std::string& id) {
  if (id.starts_with(kVectorPrefix)) return vectors_to_ask("");
  const std::optional<fuzz::NamedCase> named = fuzz::case_named(id);
  if (!named) reject_name(id);
  return drawn_cases(named->run);
}

}  // namespace flowcert::judge
