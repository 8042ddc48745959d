// The id of a vector is made of a digest over all that the vectors say, so that verify never judges by others than
// those that were asked.
#include "fuzz/judge/asked_cases.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <map>
#include <system_error>
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

// "", or ", without those of more than 8 points"
std::string what_is_left_out(const std::optional<std::size_t>& most_points) {
  return most_points
             ? fmt::format(", without those of more than {} point{}", *most_points, *most_points == 1 ? "" : "s")
             : "";
}
std::string most_points_option(const std::optional<std::size_t>& most_points) {
  return most_points ? fmt::format(" --most-points {}", *most_points) : "";
}

// ---- Drawn cases ----

class DrawnCases final : public AskedCases {
 public:
  explicit DrawnCases(fuzz::CaseRun run) : run_(std::move(run)) {}

  [[nodiscard]] std::size_t size() const override { return run_.cases; }
  [[nodiscard]] std::optional<std::size_t> most_points() const override { return run_.most_points; }
  [[nodiscard]] std::string description() const override {
    return fmt::format("{} case{}, level {}, seed {}{}", run_.cases, run_.cases == 1 ? "" : "s", run_.level, run_.seed,
                       what_is_left_out(run_.most_points));
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
    return options + most_points_option(run_.most_points);
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

// "vector:NAME:2d1e" for "vector:NAME/8:2d1e".
std::string without_most_points(const std::string& id) {
  const std::size_t slash = id.find('/');
  return slash == std::string::npos ? id : id.substr(0, slash) + id.substr(std::min(id.find(':', slash), id.size()));
}

// The most points that such an id tells.
std::optional<std::size_t> most_points_in(const std::string& id) {
  const std::size_t slash = id.find('/');
  std::size_t most = 0;
  if (slash == std::string::npos) return std::nullopt;
  const auto result = std::from_chars(id.data() + slash + 1, id.data() + id.size(), most);
  return result.ec == std::errc() ? std::optional(most) : std::nullopt;
}

class VectorsToAsk final : public AskedCases {
 public:
  VectorsToAsk(const std::string& given, std::optional<std::size_t> most_points)
      : given_(given),
        folder_(given.empty() ? usual_vectors_folder() : given),
        most_points_(most_points),
        vectors_(read_vectors(folder_)) {
    std::erase_if(vectors_.cases, [](const VectorCase& one) { return one.is_invalid(); });
    if (vectors_.cases.empty()) throw InvalidInput(folder_ + ": no conformance vectors but invalid cases");
    std::uint64_t digest = 0;
    for (const VectorCase& one : vectors_.cases) digest = digest_on(digest, one.json);
    const std::string which = most_points_ ? fmt::format("/{}", *most_points_) : "";
    for (const VectorCase& one : vectors_.cases) {
      ids_.push_back(fmt::format("{}{}{}:{:04x}", kVectorPrefix, one.id, which, digest_on(digest, one.id) & 0xffff));
      number_of_.emplace(without_most_points(ids_.back()), ids_.size() - 1);
    }
  }

  [[nodiscard]] std::size_t size() const override { return ids_.size(); }
  [[nodiscard]] std::optional<std::size_t> most_points() const override { return most_points_; }
  [[nodiscard]] std::string description() const override {
    return fmt::format("{} conformance vector{}{}", size(), size() == 1 ? "" : "s", what_is_left_out(most_points_));
  }

  [[nodiscard]] AskedCase named(const std::string& id) const override {
    const auto found = number_of_.find(without_most_points(id));
    if (found != number_of_.end()) {
      AskedCase one = numbered(found->second);
      if (ids_.at(one.number) != id || !asks(one)) reject_other_run(id);
      return one;
    }
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
    return (given_.empty() ? "--vectors" : "--vectors " + shell_word(given_)) + most_points_option(most_points_);
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
  std::optional<std::size_t> most_points_;
  Vectors vectors_;
  std::vector<std::string> ids_;                  // by number
  std::map<std::string, std::size_t> number_of_;  // by id without the most points
};

}  // namespace

bool AskedCases::asks(const AskedCase& one) const {
  const std::size_t points = one.input.rows.size();
  return points <= most_points().value_or(points);
}

std::vector<std::size_t> AskedCases::asked_numbers() const {
  std::vector<std::size_t> numbers;
  for (std::size_t number = 0; number < size(); ++number) {
    if (!most_points() || asks(numbered(number))) numbers.push_back(number);
  }
  if (numbers.empty()) throw InvalidInput("--most-points: every case has more points than that");
  return numbers;
}

std::string AskedCases::generate_command(std::optional<std::size_t> number) const {
  return "flowcert generate " + run_options() + (number ? fmt::format(" --only {}", *number) : "");
}

std::string AskedCases::points_command(std::size_t number) const { return generate_command(number) + " --xyz"; }

std::unique_ptr<AskedCases> drawn_cases(const fuzz::CaseRun& run) { return std::make_unique<DrawnCases>(run); }

std::unique_ptr<AskedCases> vectors_to_ask(const std::string& given, std::optional<std::size_t> most_points) {
  return std::make_unique<VectorsToAsk>(given, most_points);
}

std::unique_ptr<AskedCases> cases_with(const std::string& id) {
  if (id.starts_with(kVectorPrefix)) return vectors_to_ask("", most_points_in(id));
  const std::optional<fuzz::NamedCase> named = fuzz::case_named(id);
  if (!named) reject_name(id);
  return drawn_cases(named->run);
}

}  // namespace flowcert::judge
