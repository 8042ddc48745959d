// The id of a vector is made of a digest over all that the vectors say, so that verify never judges by others than
// those that were asked.
#include "certify/programs/asked_cases.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <system_error>
#include <utility>

#include "certify/finding_words.h"
#include "certify/programs/command_run.h"
#include "certify/programs/vector_cases.h"
#include "geometry/mixed_bits.h"
#include "io/number_text.h"

namespace flowcert::certify {

namespace {

[[noreturn]] void reject_unknown(const std::string& id) { throw InvalidInput("no case is called " + in_quotes(id)); }

std::string hexadecimal_text(double value) {
  std::array<char, 40> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), std::fabs(value), std::chars_format::hex).ptr;
  return (std::signbit(value) ? "-0x" : "0x") + std::string(text.data(), end);
}

// ---- Vectors ----

std::uint64_t digest_on(std::uint64_t digest, std::string_view text) {
  for (const char c : text) digest = geometry::mixed_bits(digest ^ static_cast<unsigned char>(c));
  return digest;
}

// "vector:NAME:2d1e" for "vector:NAME/8:2d1e".
std::string without_most_points(const std::string& id) {
  const std::size_t slash = id.find('/');
  return slash == std::string::npos ? id : id.substr(0, slash) + id.substr(std::min(id.find(':', slash), id.size()));
}

// The most points, as such an id says.
std::optional<std::size_t> most_points_in(const std::string& id) {
  const std::size_t slash = id.find('/');
  std::size_t most = 0;
  if (slash == std::string::npos) return std::nullopt;
  const auto result = std::from_chars(id.data() + slash + 1, id.data() + id.size(), most);
  return result.ec == std::errc() ? std::optional(most) : std::nullopt;
}

class VectorsToAsk final : public AskedCases {
 public:
  VectorsToAsk(const std::string& given, const DrawnCasesOf& drawn, std::optional<std::size_t> most_points)
      : given_(given),
        drawn_(drawn),
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
    return fmt::format("{} conformance vector{}{}", size(), size() == 1 ? "" : "s", what_is_left_out());
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
    if (drawn_(id)) reject_other_run(id);
    reject_name(id);
  }
  [[nodiscard]] std::string id(const AskedCase& one) const override { return ids_.at(one.number); }
  [[nodiscard]] AskedCase numbered(std::size_t number) const override {
    return {number, vectors_.cases.at(number).rows};
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
    return (given_.empty() ? "--vectors" : "--vectors " + shell_word(given_)) + most_points_option();
  }
  [[nodiscard]] bool is_stored() const override { return true; }
  [[nodiscard]] const VectorCase* stored(std::size_t number) const override { return &vectors_.cases.at(number); }

 private:
  std::string given_;
  DrawnCasesOf drawn_;
  std::string folder_;
  std::optional<std::size_t> most_points_;
  Vectors vectors_;
  std::vector<std::string> ids_;                  // by number
  std::map<std::string, std::size_t> number_of_;  // by id without the most points
};

}  // namespace

bool AskedCases::asks(const AskedCase& one) const { return one.rows.size() <= most_points().value_or(one.rows.size()); }

std::vector<std::size_t> AskedCases::asked_numbers() const {
  std::vector<std::size_t> numbers;
  for (std::size_t number = 0; number < size(); ++number) {
    if (!most_points() || asks(numbered(number))) numbers.push_back(number);
  }
  if (numbers.empty()) throw InvalidInput("--most-points: every case has more points than that");
  return numbers;
}

std::string AskedCases::generate_command(std::optional<std::size_t> number) const {
  return "flowcert generate " + run_options() + (number ? fmt::format(" --case {}", *number) : "");
}

std::string AskedCases::points_command(std::size_t number) const { return generate_command(number) + " --xyz"; }

void AskedCases::reject_name(const std::string& id) { reject_unknown(id); }

void AskedCases::reject_other_run(const std::string& id) {
  throw InvalidInput("a case of another run: " + in_quotes(id));
}

std::string AskedCases::what_is_left_out() const {
  const std::optional<std::size_t> most = most_points();
  return most ? fmt::format(", without those of more than {} point{}", *most, *most == 1 ? "" : "s") : "";
}

std::string AskedCases::most_points_option() const {
  return most_points() ? fmt::format(" --most-points {}", *most_points()) : "";
}

std::string points_text(const std::vector<Point>& rows, NumberForm form) {
  const auto& number = form == NumberForm::kDecimal ? shortest_text : hexadecimal_text;
  std::string text;
  for (const Point& p : rows) text += number(p.x) + ' ' + number(p.y) + ' ' + number(p.z) + '\n';
  return text;
}

std::string case_text(const std::string& id, const std::vector<Point>& rows, NumberForm form) {
  return "case " + id + ' ' + std::to_string(rows.size()) + '\n' + points_text(rows, form);
}

std::unique_ptr<AskedCases> vectors_to_ask(const std::string& given, const DrawnCasesOf& drawn,
                                           std::optional<std::size_t> most_points) {
  return std::make_unique<VectorsToAsk>(given, drawn, most_points);
}

std::unique_ptr<AskedCases> cases_with(const std::string& id, const DrawnCasesOf& drawn) {
  if (id.starts_with(kVectorPrefix)) return vectors_to_ask("", drawn, most_points_in(id));
  std::unique_ptr<AskedCases> cases = drawn(id);
  if (!cases) reject_unknown(id);
  return cases;
}

}  // namespace flowcert::certify
