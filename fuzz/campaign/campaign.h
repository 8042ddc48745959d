// A campaign under way: which batches are done, and what came of them. It has a folder on disk, from which it goes on
// after any interruption.
//
// Guarantees: whatever has been absorbed is in the folder before `absorb` returns. So a kill -9 loses no
// counterexample, and at most the batches under way, which are done again. Absorbing a counterexample, a signature or
// a whole batch once more changes nothing. The result does not depend on who does the batches, in what order, or how
// many at a time.
//
// The folder: plan.json has the plan and the number of cases. batches.jsonl has a line for each finished batch.
// findings.jsonl and signatures.jsonl have a line for each counterexample and each signature. findings/ has point
// files of counterexamples.
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "fuzz/campaign/batch.h"

namespace flowcert::fuzz {

// A folder is a campaign's iff it has this file.
inline constexpr const char* kPlanName = "plan.json";

// So many counterexamples of each property and kind have a point file: those with the least numbers. findings.jsonl
// has all. A case that was asked for by its number has a point file as well.
inline constexpr std::size_t kMostCounterexamplesOfKind = 10;

// A campaign's folder that cannot be used. what() is one line.
class UnusableFolder : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// The program's version and build. Programs of the same version have the same cases; only such ranks work together.
[[nodiscard]] std::string program_version();

class Campaign : public BatchSource {
 public:
  // The campaign is in memory alone. If `findings_folder` is not empty, counterexamples go there as point files. The
  // folder is made for the first of them.
  Campaign(CampaignPlan plan, std::optional<std::size_t> total_cases, std::filesystem::path findings_folder);
  // In a new folder.
  static Campaign begun(CampaignPlan plan, std::optional<std::size_t> total_cases, const std::filesystem::path& folder);
  // Goes on from its folder, with `total_cases` if that is given. Lines that were cut short are left out.
  static Campaign resumed(const std::filesystem::path& folder, std::optional<std::size_t> total_cases);
  // Reads a folder, to which another process may be writing. Nothing is written there.
  static Campaign read(const std::filesystem::path& folder);
  ~Campaign() override;
  Campaign(Campaign&&) noexcept;
  Campaign& operator=(Campaign&&) = delete;

  [[nodiscard]] const CampaignPlan& plan() const override { return plan_; }
  [[nodiscard]] std::optional<std::size_t> total_cases() const { return total_cases_; }

  // The next batch that is not done and not handed out. Returns nothing if no such batch is left.
  [[nodiscard]] std::optional<BatchOrder> next_batch() override;
  [[nodiscard]] BatchOrder order_of(std::size_t batch) const;
  [[nodiscard]] std::optional<Counterexample> next_crash() override;
  // The batch will be handed out again.
  void give_back(std::size_t batch) override { handed_out_.erase(batch); }
  // Whether all that was handed out has come back.
  [[nodiscard]] bool is_settled() const { return handed_out_.empty(); }

  // Takes a message of whoever does a batch (batch.h). Throws UnusableFolder if the folder cannot be written.
  void absorb(const std::string& message) override;
  void absorb(const Counterexample& counterexample);
  // Only writes its point file; the campaign does not have the counterexample then.
  void write_asked(const Counterexample& counterexample);
  // Takes all of another part of the same campaign. Throws std::invalid_argument if the part is of another campaign.
  void absorb(const Campaign& part);

  // Sums over all batches that are done, and over those that were stopped half-way since the campaign was opened.
  [[nodiscard]] const Tally& tally() const { return sum_; }
  [[nodiscard]] std::size_t done_batches() const { return done_.size(); }
  [[nodiscard]] bool is_done(std::size_t batch) const { return done_.contains(batch); }
  // Cases that fail, by "PROPERTY KIND": those of the tally, and those with a counterexample that no batch has counted,
  // because they ended their process or are under way.
  [[nodiscard]] std::map<std::string, std::set<std::size_t>> failures() const;
  // A case counts once, even if it fails in several kinds.
  [[nodiscard]] std::size_t failing_cases() const;
  // The number of all cases of the shard, if the campaign has a number of cases.
  [[nodiscard]] std::optional<std::size_t> expected_cases() const;
  [[nodiscard]] const std::map<DegeneracySignature, Discovery>& signatures() const { return signatures_; }
  // By number, then "PROPERTY KIND".
  [[nodiscard]] const std::map<std::pair<std::size_t, std::string>, Counterexample>& counterexamples() const {
    return counterexamples_;
  }
  // The programs that have worked on it. If there is more than one, they may have drawn different cases.
  [[nodiscard]] const std::set<std::string>& made_by() const { return made_by_; }
  // Empty if it was not written.
  [[nodiscard]] std::filesystem::path file_of(const Counterexample& counterexample) const;

 private:
  struct Files;

  void absorb(const Discovery& discovery);
  void absorb_batch(std::size_t batch, Tally tally);
  // The first one reads plan.json, and `load` reads the other files.
  static Campaign with_plan_in(const std::filesystem::path& folder, std::optional<std::size_t> total_cases);
  void load(const std::filesystem::path& folder);
  void write_plan();
  // Whether what is absorbed has to be written to files. It has not while it is being read from them.
  [[nodiscard]] bool keeps_lines() const;
  [[nodiscard]] std::filesystem::path path_of(const Counterexample& counterexample) const;
  void write_point_file(const Counterexample& counterexample) const;
  // Writes its point file if its number is one of the least, or if it was asked for.
  void offer_point_file(const Counterexample& counterexample);

  CampaignPlan plan_;
  std::optional<std::size_t> total_cases_;
  std::filesystem::path findings_folder_;
  std::unique_ptr<Files> files_;  // none: in memory
  std::map<std::size_t, Tally> done_;
  Tally unfinished_;
  Tally sum_;  // of both
  std::size_t first_open_ = 0;
  std::set<std::size_t> handed_out_;
  std::map<DegeneracySignature, Discovery> signatures_;
  std::map<std::pair<std::size_t, std::string>, Counterexample> counterexamples_;
  // By "PROPERTY KIND": the least numbers of cases, and those that were asked for. These cases have point files.
  std::map<std::string, std::set<std::size_t>> least_, asked_;
  std::set<std::pair<std::size_t, std::string>> crashes_handed_out_;
  std::set<std::size_t> left_out_;  // cases that ended a process in their batch
  std::set<std::string> made_by_;
  bool is_loading_ = false;
};

// ---- One case ----
// One case of a campaign, done alone, for the first time or once more.
//
// Guarantees: the case is the same as in the campaign, if it is known which earlier cases of its batch ended a
// process. Those cases have no effect on later ones. The counterexample gets a point file beside those of the
// campaign. If the batch is done, the campaign takes it as well, in place of what it had of the case. Otherwise the
// batch will find it by itself.
class OneCase : public BatchSource {
 public:
  // Throws std::invalid_argument, one line, if the campaign has no such case.
  OneCase(Campaign& campaign, std::size_t number);

  [[nodiscard]] const CampaignPlan& plan() const override { return campaign_.plan(); }
  [[nodiscard]] std::optional<BatchOrder> next_batch() override;
  void give_back(std::size_t) override { is_handed_out_ = false; }
  void absorb(const std::string& message) override;

  [[nodiscard]] std::size_t number() const { return number_; }
  // False if it was stopped, or its process was killed.
  [[nodiscard]] bool is_done() const { return is_done_; }
  // By "PROPERTY KIND".
  [[nodiscard]] const std::map<std::string, Counterexample>& counterexamples() const { return counterexamples_; }

 private:
  void absorb(Counterexample counterexample);

  Campaign& campaign_;
  std::size_t number_;
  bool is_handed_out_ = false;
  bool is_done_ = false;
  std::map<std::string, Counterexample> counterexamples_;
};

}  // namespace flowcert::fuzz
