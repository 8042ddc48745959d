// A campaign under way: which batches are done, what came of them, and its folder on disk, from which it goes
// on after any interruption.
//
// Guarantees: whatever has been absorbed is in the folder before `absorb` returns: a kill -9 loses the
// batches under way at most, which are done again, and no counterexample. Absorbing the same again changes nothing.
// Who does the batches, in what order and how many at a time, makes no difference to what is there in the
// end.
//
// The folder: plan.json, the plan and the number of cases; batches.jsonl, a line for each finished batch;
// findings.jsonl and signatures.jsonl, a line for each counterexample and each signature; findings/, with point files
// of counterexamples.
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

// Of each property and kind, so many counterexamples have a point file: those of the least numbers. findings.jsonl has
// all.
inline constexpr std::size_t kMostCounterexamplesOfKind = 10;

// A campaign's folder that cannot be used. what() is one line.
class UnusableFolder : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// What made this program: of two that are the same the cases are, and ranks work together only then.
[[nodiscard]] std::string program_version();

struct Discovered {
  std::size_t number = 0;
  Input input;
};

class Campaign : public BatchSource {
 public:
  // In memory alone. Where `findings_folder` is not empty, counterexamples go there as point files.
  // The folder is made when there is one.
  Campaign(CampaignPlan plan, std::optional<std::size_t> total_cases, std::filesystem::path findings_folder);
  // In a new folder.
  static Campaign begun(CampaignPlan plan, std::optional<std::size_t> total_cases,
                        const std::filesystem::path& folder);
  // From its folder; with another number of cases, if given. Lines that were cut short are left out.
  static Campaign resumed(const std::filesystem::path& folder, std::optional<std::size_t> total_cases);
  // What is in a folder, somebody else's perhaps, who may be at it: nothing is written there.
  static Campaign read(const std::filesystem::path& folder);
  ~Campaign() override;
  Campaign(Campaign&&) noexcept;
  Campaign& operator=(Campaign&&) = delete;

  [[nodiscard]] const CampaignPlan& plan() const override { return plan_; }
  [[nodiscard]] std::optional<std::size_t> total_cases() const { return total_cases_; }

  // The next batch that is not done and not handed out; nothing: no such batch is left.
  [[nodiscard]] std::optional<BatchOrder> next_batch() override;
  [[nodiscard]] BatchOrder order_of(std::size_t batch) const;
  [[nodiscard]] std::optional<Counterexample> next_crash() override;
  // To be handed out again.
  void give_back(std::size_t batch) override { handed_out_.erase(batch); }
  // Whether all that was handed out has come back.
  [[nodiscard]] bool is_settled() const { return handed_out_.empty(); }

  // One line from whoever does a batch (batch.h). Throws UnusableFolder if the folder cannot be written.
  void absorb(const std::string& message) override;
  void absorb(const Counterexample& counterexample);
  // Writes its point file, and nothing else: the campaign does not have it.
  void write_asked(const Counterexample& counterexample);
  // All of another part of the same campaign. Throws std::invalid_argument for a part of another one.
  void absorb(const Campaign& part);

  // Of all batches that are done, and of those that were stopped half-way since the campaign was opened.
  [[nodiscard]] const Tally& tally() const { return sum_; }
  [[nodiscard]] std::size_t done_batches() const { return done_.size(); }
  [[nodiscard]] bool is_done(std::size_t batch) const { return done_.contains(batch); }
  // Of the shard, if there is a number of cases: all its cases.
  [[nodiscard]] std::optional<std::size_t> expected_cases() const;
  [[nodiscard]] const std::map<DegeneracySignature, Discovered>& signatures() const { return signatures_; }
  // By number, then "PROPERTY KIND".
  [[nodiscard]] const std::map<std::pair<std::size_t, std::string>, Counterexample>& counterexamples() const {
    return counterexamples_;
  }
  // The programs that have worked on it: more than one may have drawn other cases.
  [[nodiscard]] const std::set<std::string>& made_by() const { return made_by_; }
  // Empty if it was not written.
  [[nodiscard]] std::filesystem::path file_of(const Counterexample& counterexample) const;

 private:
  struct Files;

  void absorb(const Discovery& discovery);
  void absorb_batch(std::size_t batch, Tally tally);
  // Of plan.json, and of the other files.
  static Campaign with_plan_in(const std::filesystem::path& folder, std::optional<std::size_t> total_cases);
  void load(const std::filesystem::path& folder);
  void write_plan();
  // Whether what is absorbed is written to files, and not read from them.
  [[nodiscard]] bool keeps_lines() const;
  [[nodiscard]] std::filesystem::path path_of(const Counterexample& counterexample) const;
  void write_point_file(const Counterexample& counterexample) const;
  // If it is one of the least, or asked for.
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
  std::map<DegeneracySignature, Discovered> signatures_;
  std::map<std::pair<std::size_t, std::string>, Counterexample> counterexamples_;
  // Numbers of cases by "PROPERTY KIND": those that have files for being the least, or for being asked for.
  std::map<std::string, std::set<std::size_t>> least_, asked_;
  std::set<std::pair<std::size_t, std::string>> crashes_handed_out_;
  std::set<std::size_t> left_out_;  // cases that ended a process in their batch
  std::set<std::string> made_by_;
  bool is_loading_ = false;
};

// ---- One case ----
// One case of a campaign, once more or for the first time, and nothing else.
//
// Guarantees: the case is what it is in the campaign, as far as the cases are known that ended a process in
// its batch before it: the batch's later cases do not know of those. What is found has a point file with
// those of the campaign. The campaign has it as well if the batch is done, instead of what it had of the case
// before; otherwise the batch will find it by itself.
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
  [[nodiscard]] const std::map<std::string, Counterexample>& counterexamples() const {
    return counterexamples_;
  }

 private:
  void absorb(Counterexample counterexample);

  Campaign& campaign_;
  std::size_t number_;
  bool is_handed_out_ = false;
  bool is_done_ = false;
  std::map<std::string, Counterexample> counterexamples_;
};

}  // namespace flowcert::fuzz
