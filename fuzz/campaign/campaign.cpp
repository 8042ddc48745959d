#include "fuzz/campaign/campaign.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>

#include "flowcert/reproducibility.h"
#include "fuzz/campaign/child_process.h"

namespace flowcert::fuzz {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

constexpr const char* kBatchesName = "batches.jsonl";
constexpr const char* kFindingsName = "findings.jsonl";
constexpr const char* kSignaturesName = "signatures.jsonl";
// This is the order of absorbing, since a batch is done only when its counterexamples are known.
constexpr const char* kLineFiles[] = {kFindingsName, kSignaturesName, kBatchesName};
constexpr const char* kFindingsFolder = "findings";

// A failing case is reported as it was, and then once more, small, or smaller if it was stopped meanwhile. If someone
// asked for it again, that result is the latest one.
bool replaces(const Counterexample& one, const Counterexample& known) {
  if (one.is_asked || known.is_small) return one.is_asked;
  return one.is_small || one.trial.input.rows.size() < known.trial.input.rows.size();
}

[[noreturn]] void refuse(const fs::path& path, const std::string& why) {
  throw UnusableFolder(path.string() + ": " + why);
}

// A file that lines are added to, each at once and whole.
class LineFile {
 public:
  explicit LineFile(const fs::path& path)
      : path_(path), descriptor_(::open(path.c_str(), O_WRONLY | O_APPEND | O_CREAT | O_CLOEXEC, 0644)) {
    if (descriptor_ < 0) refuse(path_, fmt::format("cannot be written: {}", std::strerror(errno)));
  }
  ~LineFile() { ::close(descriptor_); }
  LineFile(const LineFile&) = delete;
  LineFile& operator=(const LineFile&) = delete;

  void add(const std::string& line) {
    if (!write_line(descriptor_, line)) refuse(path_, fmt::format("cannot be written: {}", std::strerror(errno)));
  }

 private:
  fs::path path_;
  int descriptor_;
};

void write_file(const fs::path& path, const std::string& text) {
  const fs::path unfinished = path.string() + ".part";
  std::ofstream file(unfinished, std::ios::binary);
  file << text;
  file.close();
  if (!file) refuse(path, "cannot be written");
  fs::rename(unfinished, path);
}

void make_folder(const fs::path& path) {
  std::error_code failure;
  fs::create_directories(path, failure);
  if (failure) refuse(path, "cannot be made: " + failure.message());
}

// The whole lines of a file. What stands after the last of them is left out: a kill came in between.
std::string whole_lines(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::stringstream buffer;
  buffer << file.rdbuf();
  std::string text = buffer.str();
  text.resize(text.rfind('\n') + 1);  // npos + 1 is 0
  return text;
}

// Reports files that exist but are not those of a campaign.
template <typename Open>
auto unless_unreadable(const fs::path& folder, const Open& open) {
  try {
    return open();
  } catch (const json::exception&) {
    refuse(folder, "its files cannot be read");
  } catch (const std::invalid_argument& error) {
    refuse(folder, error.what());
  }
}

}  // namespace

struct Campaign::Files {
  explicit Files(const fs::path& path)
      : folder(path),
        lock(::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)),
        batches(path / kBatchesName),
        counterexamples(path / kFindingsName),
        signatures(path / kSignaturesName) {
    if (lock < 0 || ::flock(lock, LOCK_EX | LOCK_NB) != 0) refuse(path, "another campaign is using it");
  }
  ~Files() { ::close(lock); }
  Files(const Files&) = delete;
  Files& operator=(const Files&) = delete;

  fs::path folder;
  int lock;
  LineFile batches, counterexamples, signatures;
};

std::string program_version() {
  const Reproducibility made_by = reproducibility();
  return fmt::format("{} ({}; {}; CGAL {})", made_by.version, made_by.commit, made_by.compiler, made_by.cgal);
}

Campaign::Campaign(CampaignPlan plan, std::optional<std::size_t> total_cases, fs::path findings_folder)
    : plan_(std::move(plan)), total_cases_(total_cases), findings_folder_(std::move(findings_folder)) {}
Campaign::~Campaign() = default;
Campaign::Campaign(Campaign&&) noexcept = default;

Campaign Campaign::begun(CampaignPlan plan, std::optional<std::size_t> total_cases, const fs::path& folder) {
  make_folder(folder);
  if (fs::exists(folder / kPlanName)) {
    refuse(folder, "there is a campaign in it already; --resume goes on with it");
  }
  if (!fs::is_empty(folder)) refuse(folder, "it is not empty");
  Campaign campaign(std::move(plan), total_cases, folder / kFindingsFolder);
  campaign.files_ = std::make_unique<Files>(folder);
  campaign.made_by_.insert(program_version());
  campaign.write_plan();
  return campaign;
}

void Campaign::write_plan() {
  const json cases = total_cases_ ? json(*total_cases_) : json(nullptr);
  const json object = {{"plan", to_text(plan_)}, {"cases", cases}, {"made_by", made_by_}};
  write_file(files_->folder / kPlanName, object.dump() + '\n');
}

Campaign Campaign::with_plan_in(const fs::path& folder, std::optional<std::size_t> total_cases) {
  std::ifstream file(folder / kPlanName);
  if (!file) refuse(folder, "there is no campaign in it");
  const json object = json::parse(file);
  const json& cases = object.at("cases");
  const bool is_number = cases.is_number_unsigned() && cases.get<std::size_t>() <= kMostCasesOfCampaign;
  if (!cases.is_null() && !is_number) refuse(folder, "its number of cases cannot be read");
  if (!total_cases && is_number) total_cases = cases.get<std::size_t>();
  Campaign campaign(plan_of(object.at("plan").get<std::string>()), total_cases, folder / kFindingsFolder);
  object.at("made_by").get_to(campaign.made_by_);
  return campaign;
}

Campaign Campaign::resumed(const fs::path& folder, std::optional<std::size_t> total_cases) {
  return unless_unreadable(folder, [&] {
    Campaign campaign = with_plan_in(folder, total_cases);
    campaign.files_ = std::make_unique<Files>(folder);  // from here on nobody else can use it
    campaign.load(folder);
    const auto expected = campaign.expected_cases();
    if (expected && campaign.tally().cases > *expected) refuse(folder, "more cases than that are done");
    campaign.made_by_.insert(program_version());
    campaign.write_plan();
    return campaign;
  });
}

Campaign Campaign::read(const fs::path& folder) {
  return unless_unreadable(folder, [&] {
    Campaign campaign = with_plan_in(folder, std::nullopt);
    campaign.findings_folder_.clear();
    campaign.load(folder);
    return campaign;
  });
}

void Campaign::load(const fs::path& folder) {
  is_loading_ = true;
  // Batches are read first, because whoever may be writing writes a batch after its counterexamples.
  std::vector<std::string> texts;
  for (auto name = std::rbegin(kLineFiles); name != std::rend(kLineFiles); ++name) {
    texts.insert(texts.begin(), whole_lines(folder / *name));
    if (files_) fs::resize_file(folder / *name, texts.front().size());
  }
  for (const std::string& text : texts) {
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) absorb(line);
  }
  is_loading_ = false;
}

std::optional<BatchOrder> Campaign::next_batch() {
  while (const auto batch = batch_from(plan_, total_cases_, first_open_)) {
    if (!done_.contains(*batch)) break;
    first_open_ = *batch + 1;
  }
  std::optional<std::size_t> batch = batch_from(plan_, total_cases_, first_open_);
  while (batch && (done_.contains(*batch) || handed_out_.contains(*batch))) {
    batch = batch_from(plan_, total_cases_, *batch + 1);
  }
  if (!batch) return std::nullopt;
  handed_out_.insert(*batch);
  return order_of(*batch);
}

BatchOrder Campaign::order_of(std::size_t batch) const {
  BatchOrder order{batch, cases_of_batch(plan_, total_cases_, batch), {}};
  const auto first = left_out_.lower_bound(batch * plan_.batch_cases);
  order.left_out.insert(first, left_out_.lower_bound((batch + 1) * plan_.batch_cases));
  return order;
}

std::optional<Counterexample> Campaign::next_crash() {
  for (const auto& [key, counterexample] : counterexamples_) {
    if (ends_process(counterexample) && !counterexample.is_small && crashes_handed_out_.insert(key).second)
      return counterexample;
  }
  return std::nullopt;
}

void Campaign::absorb(const std::string& message) {
  const json object = json::parse(message);
  if (object.contains("finding")) return absorb(counterexample_of(object.at("finding")));
  if (object.contains("discovery")) return absorb(discovery_of(object.at("discovery")));
  const auto batch = object.at("batch").get<std::size_t>();
  Tally tally = tally_of(object.at("tally"));
  if (!object.at("complete").get<bool>()) {
    handed_out_.erase(batch);
    unfinished_.add(tally);
    return sum_.add(tally);
  }
  absorb_batch(batch, std::move(tally));
}

void Campaign::absorb_batch(std::size_t batch, Tally tally) {
  handed_out_.erase(batch);
  // If a campaign has become longer, its last batch is done again with more cases.
  const auto known = done_.find(batch);
  const std::size_t cases = tally.cases + tally.left_out;
  if (known != done_.end() && known->second.cases + known->second.left_out >= cases) return;
  if (keeps_lines()) files_->batches.add(message_of(batch, {tally, true}));
  if (cases < cases_of_batch(plan_, total_cases_, batch)) return;
  if (known == done_.end()) {
    sum_.add(tally);
    done_.emplace(batch, std::move(tally));
    return;
  }
  known->second = std::move(tally);
  sum_ = unfinished_;
  for (const auto& [number, each] : done_) sum_.add(each);
}

void Campaign::absorb(const Counterexample& counterexample) {
  const std::pair key(counterexample.number, kind_of(counterexample));
  if (ends_process(counterexample) && !counterexample.is_asked) left_out_.insert(counterexample.number);
  const auto known = counterexamples_.find(key);
  if (known != counterexamples_.end() && !replaces(counterexample, known->second)) return;
  // Whoever works on the campaign already makes this crash small.
  if (!is_loading_) crashes_handed_out_.insert(key);
  counterexamples_.insert_or_assign(key, counterexample);
  if (keeps_lines()) files_->counterexamples.add(message_of(counterexample));
  if (!findings_folder_.empty()) offer_point_file(counterexample);
}

bool Campaign::keeps_lines() const { return files_ && !is_loading_; }

fs::path Campaign::path_of(const Counterexample& counterexample) const {
  return findings_folder_ / (name_of(counterexample) + ".xyz");
}

void Campaign::write_point_file(const Counterexample& counterexample) const {
  make_folder(findings_folder_);
  write_file(path_of(counterexample), file_text(counterexample));
}

void Campaign::write_asked(const Counterexample& counterexample) {
  asked_[kind_of(counterexample)].insert(counterexample.number);
  write_point_file(counterexample);
}

void Campaign::offer_point_file(const Counterexample& counterexample) {
  std::set<std::size_t>& least = least_[kind_of(counterexample)];
  std::set<std::size_t>& asked = asked_[kind_of(counterexample)];
  if (counterexample.is_asked) asked.insert(counterexample.number);
  least.insert(counterexample.number);
  if (least.size() > kMostCounterexamplesOfKind) {
    const std::size_t last = *least.rbegin();
    least.erase(last);
    if (last != counterexample.number && !asked.contains(last)) {
      Counterexample other = counterexample;
      other.number = last;
      fs::remove(path_of(other));
      fs::remove(path_of(other).replace_extension(".html"));  // its page, if an earlier run has made one
    }
  }
  if (least.contains(counterexample.number) || asked.contains(counterexample.number)) write_point_file(counterexample);
}

void Campaign::absorb(const Discovery& discovery) {
  const auto known = signatures_.find(discovery.signature);
  if (known != signatures_.end() && known->second.number <= discovery.number) return;
  if (keeps_lines()) files_->signatures.add(message_of(discovery));
  signatures_.insert_or_assign(discovery.signature, discovery);
}

void Campaign::absorb(const Campaign& part) {
  CampaignPlan plan = part.plan_;
  plan.shard = plan_.shard;
  if (plan != plan_) throw std::invalid_argument("a part of another campaign");
  for (const auto& [key, counterexample] : part.counterexamples_) absorb(counterexample);
  for (const auto& [signature, discovery] : part.signatures_) absorb(discovery);
  for (const auto& [batch, tally] : part.done_) absorb_batch(batch, tally);
  made_by_.insert(part.made_by_.begin(), part.made_by_.end());
  if (files_) write_plan();
}

std::map<std::string, std::set<std::size_t>> Campaign::failures() const {
  auto failures = sum_.failures;
  for (const auto& [key, counterexample] : counterexamples_) failures[key.second].insert(key.first);
  return failures;
}

std::size_t Campaign::failing_cases() const {
  std::set<std::size_t> all;
  for (const auto& [kind, numbers] : sum_.failures) all.insert(numbers.begin(), numbers.end());
  for (const auto& [key, counterexample] : counterexamples_) all.insert(key.first);
  return all.size();
}

std::optional<std::size_t> Campaign::expected_cases() const {
  if (!total_cases_) return std::nullopt;
  return cases_of_shard(plan_, *total_cases_);
}

fs::path Campaign::file_of(const Counterexample& counterexample) const {
  const auto is_in = [&](const auto& numbers) {
    const auto of_kind = numbers.find(kind_of(counterexample));
    return of_kind != numbers.end() && of_kind->second.contains(counterexample.number);
  };
  return is_in(least_) || is_in(asked_) ? path_of(counterexample) : fs::path();
}

// ---- One case ----

OneCase::OneCase(Campaign& campaign, std::size_t number) : campaign_(campaign), number_(number) {
  const Shard& shard = plan().shard;
  const std::size_t total = campaign.total_cases().value_or(kMostCasesOfCampaign);
  if (number >= total || number / plan().batch_cases % shard.count != shard.index) {
    throw std::invalid_argument("the campaign has no case " + std::to_string(number));
  }
}

std::optional<BatchOrder> OneCase::next_batch() {
  if (is_done_ || is_handed_out_) return std::nullopt;
  is_handed_out_ = true;
  BatchOrder order = campaign_.order_of(number_ / plan().batch_cases);
  order.only = number_;
  return order;
}

void OneCase::absorb(const std::string& message) {
  const auto object = nlohmann::json::parse(message);
  if (object.contains("finding")) return absorb(counterexample_of(object.at("finding")));
  if (object.contains("batch")) is_done_ = is_done_ || tally_of(object.at("tally")).cases > 0;
}

void OneCase::absorb(Counterexample counterexample) {
  if (counterexample.number != number_) return campaign_.absorb(counterexample);  // this earlier case ended its process
  counterexample.is_asked = true;
  const std::string kind = kind_of(counterexample);
  counterexamples_.insert_or_assign(kind, counterexample);
  is_done_ = is_done_ || ends_process(counterexample);
  if (!campaign_.is_done(number_ / plan().batch_cases)) return campaign_.write_asked(counterexample);
  // A small counterexample is replaced by another small one only.
  if (counterexample.is_small || !campaign_.counterexamples().contains({number_, kind}))
    campaign_.absorb(counterexample);
}

}  // namespace flowcert::fuzz
