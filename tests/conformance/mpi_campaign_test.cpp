// `flowcert-fuzz-mpi` as a shell sees it: a campaign shared out over ranks of one machine has the account of
// `flowcert fuzz`, whatever their number, and whichever of them is killed.
//
// Guarantees: a rank is killed when the campaign's files say that it is under way.
#include "tests/conformance/campaign_account.h"

namespace flowcert::conformance::mpi_campaign_test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using Words = std::vector<std::string>;

// Four batches.
const Words kPlan{"--count", "3500", "--seed", "3", "--property", "critical-points", "--points", "0-5"};

Words joined(const std::vector<Words>& parts) {
  Words all;
  for (const Words& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

// Open MPI runs as root, and with more ranks than cores, only if it is told to.
class MpiCampaign : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    for (const char* name : {"OMPI_ALLOW_RUN_AS_ROOT", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM",
                             "OMPI_MCA_rmaps_base_oversubscribe", "OMPI_MCA_hwloc_base_binding_policy"}) {
      const bool is_policy = std::string(name).ends_with("policy");
      ::setenv(name, is_policy ? "none" : "1", 1);
    }
  }

  // Each rank leaves the number of its process in a file.
  Words job(int ranks, const Words& arguments, const Words& mpirun_options = {}) const {
    const std::string start = "echo $$ >" + scratch_.path("rank-") + "$OMPI_COMM_WORLD_RANK; exec \"$@\"";
    return joined({{FLOWCERT_MPIRUN, "-n", std::to_string(ranks)},
                   mpirun_options,
                   {"/bin/sh", "-c", start, "sh", FLOWCERT_MPI_PROGRAM, "--json"},
                   arguments});
  }
  Finished run(int ranks, const Words& arguments) const { return RunningProgram(job(ranks, arguments)).finish(); }
  void signal_rank(int rank, int number) const {
    const std::string process = content_of(scratch_.path("rank-" + std::to_string(rank)));
    ASSERT_NE(process, "");
    ASSERT_EQ(::kill(std::stoi(process), number), 0);
  }

  // What the campaign is to come to, however it is run.
  static const json& expected() {
    static const json account = account_of(flowcert(joined({{"fuzz", "--json"}, kPlan})));
    return account;
  }
  // The ranks may need a moment to be gone.
  static Finished resumed(const std::string& folder) {
    Finished finished = flowcert({"fuzz", "--json", "--resume", folder});
    for (int k = 0; k < 50 && finished.status == 2; ++k) {
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
      finished = flowcert({"fuzz", "--json", "--resume", folder});
    }
    return finished;
  }

  Scratch scratch_;
};

TEST_F(MpiCampaign, IsTheSameWithAnyNumberOfRanks) {
  for (const int ranks : {2, 3, 4}) {
    const Finished finished = run(ranks, kPlan);
    EXPECT_EQ(finished.status, 0) << ranks << finished.err;
    EXPECT_EQ(finished.err, "") << ranks;
    ASSERT_NE(finished.out, "") << ranks;
    EXPECT_EQ(account_of(finished), expected()) << ranks;
  }
}

TEST_F(MpiCampaign, HasTheFindingsAndTheStatusOfTheCommand) {
  const Words plan{"--count", "120",       "--points",
                   "4-6",     "--against", std::string(FLOWCERT_PEER) + " {in} {out} --strict"};
  const Finished alone = flowcert(joined({{"fuzz", "--json"}, plan, {"--out", scratch_.path("alone")}}));
  const Finished finished = run(3, joined({plan, {"--out", scratch_.path("shared")}}));
  EXPECT_EQ(finished.status, 1) << finished.err;
  ASSERT_NE(finished.out, "");
  EXPECT_EQ(account_of(finished), account_of(alone));
  EXPECT_GE(account_of(finished).at("findings").size(), 1U);
  // The files are the same, too.
  for (const auto& entry : fs::directory_iterator(scratch_.path("alone") + "/findings")) {
    const std::string name = entry.path().filename().string();
    EXPECT_EQ(content_of(scratch_.path("shared") + "/findings/" + name), content_of(entry.path().string())) << name;
  }
}

// What happens to rank 2 of four, and what mpirun is told.
struct Loss {
  int signal;
  Words mpirun_options;
};
class MpiCampaignLosesARank : public MpiCampaign, public testing::WithParamInterface<Loss> {};

TEST_P(MpiCampaignLosesARank, AndGoesOnToTheSameEnd) {
  const std::string folder = scratch_.path("campaign");
  const Words arguments = joined({kPlan, {"--out", folder, "--silence", "2"}});
  RunningProgram program(job(4, arguments, GetParam().mpirun_options));
  wait_for_a_batch(program, folder);
  signal_rank(2, GetParam().signal);
  const Finished finished = program.finish();
  EXPECT_EQ(finished.status, 0) << finished.err;
  EXPECT_NE(finished.err.find("rank 2 "), std::string::npos) << finished.err;
  ASSERT_NE(finished.out, "") << finished.err;
  EXPECT_EQ(account_of(finished), expected());
  EXPECT_EQ(account_of(resumed(folder)), expected());
}

// Rank 2 is killed while mpirun goes on, or stopped like a machine that no longer answers, or asked to end.
INSTANTIATE_TEST_SUITE_P(Signals, MpiCampaignLosesARank,
                         testing::Values(Loss{SIGKILL, {"--enable-recovery"}}, Loss{SIGSTOP, {}}, Loss{SIGTERM, {}}));

TEST_F(MpiCampaign, IsResumedAfterMpirunHasEndedAllRanks) {
  const std::string folder = scratch_.path("campaign");
  RunningProgram program(job(4, joined({kPlan, {"--out", folder}})));
  wait_for_a_batch(program, folder);
  signal_rank(2, SIGKILL);
  EXPECT_NE(program.finish().status, 0);
  const std::string copy = scratch_.path("copy");
  fs::copy(folder, copy, fs::copy_options::recursive);
  EXPECT_EQ(account_of(resumed(folder)), expected());
  const Finished finished = run(3, {"--resume", copy});
  EXPECT_EQ(finished.status, 0) << finished.err;
  ASSERT_NE(finished.out, "") << finished.err;
  EXPECT_EQ(account_of(finished), expected());
}

TEST_F(MpiCampaign, RefusesWhatItCannotUseInOneLine) {
  const std::vector<std::pair<int, Words>> wrong = {
      {1, kPlan},
      {2, joined({kPlan, {"--jobs", "2"}})},
      {2, {"--resume", scratch_.path("none")}},
  };
  for (const auto& [ranks, arguments] : wrong) {
    const Finished finished = run(ranks, arguments);
    EXPECT_EQ(finished.status, 2) << finished.err;
    EXPECT_EQ(finished.out, "");
    std::size_t ours = 0;
    for (const std::string& line : lines_of(finished.err)) ours += line.starts_with("flowcert-fuzz-mpi: ");
    EXPECT_EQ(ours, 1U) << finished.err;
    EXPECT_EQ(finished.err.find("needs at least 2 ranks") != std::string::npos, ranks == 1) << finished.err;
  }
}

}  // namespace
}  // namespace flowcert::conformance::mpi_campaign_test
