// The fast implementation against the oracle, on every family of degenerate inputs.
//
// Guarantees: equality of everything: merged points, contact sets, indices, kinds, exact centres and
// distances, order. A family that no longer produces what its name promises fails too, so that agreement is
// not agreement on harmless inputs. A failure is shrunk to a minimal input, printed with both answers; it
// belongs into fuzz/regressions/.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cstdio>
#include <iostream>
#include <string>

#include "fuzz/inputs/stable_configurations.h"
#include "tests/cites.h"
#include "tests/property/property_parameters.h"
#include "tests/property/stationary_answers.h"

namespace flowcert::property::stationary_agreement_test {
namespace {

constexpr int kInputsPerFamily = 300;

// How many of a family's inputs have what (see fuzz::Promise).
struct Distribution {
  int inputs = 0;
  int four_points = 0;
  int cluster = 0;
  int kind12 = 0;
  int kind23 = 0;
  int kind13 = 0;
  int coplanar = 0;
  int collinear = 0;
  int duplicates = 0;
  int degenerate = 0;

  void add(const fuzz::Input& input, const StationaryAnswer& answer);
  [[nodiscard]] int percent(int count) const { return inputs == 0 ? 0 : 100 * count / inputs; }
};

bool has_cluster(const StationaryAnswer& answer) {
  return std::any_of(answer.records.begin(), answer.records.end(), [](const Record& record) {
    return static_cast<int>(record.contact.size()) > record.hull_dimension + 1;
  });
}

void Distribution::add(const fuzz::Input& input, const StationaryAnswer& answer) {
  const std::size_t classes = answer.points - answer.merged_duplicates;
  std::vector<oracle::Point> points;
  points.reserve(input.rows.size());
  for (const fuzz::Row& row : input.rows) points.push_back(oracle::exact(row));
  const int dimension = oracle::affine_dimension(points);
  const bool clustered = has_cluster(answer);
  const bool regular = answer.regular != std::array<std::size_t, 3>{};
  inputs += 1;
  four_points += classes >= 4 ? 1 : 0;
  cluster += clustered ? 1 : 0;
  kind12 += answer.regular[0] > 0 ? 1 : 0;
  kind13 += answer.regular[1] > 0 ? 1 : 0;
  kind23 += answer.regular[2] > 0 ? 1 : 0;
  coplanar += dimension == 2 ? 1 : 0;
  collinear += dimension == 1 && classes >= 3 ? 1 : 0;
  duplicates += answer.merged_duplicates > 0 ? 1 : 0;
  degenerate += clustered || regular ? 1 : 0;
}

void print_row(const std::string& name, const Distribution& seen) {
  std::printf("%-22s %6d %6d %7d %5d %5d %5d %8d %9d %10d %10d\n", name.c_str(), seen.inputs,
              seen.percent(seen.four_points), seen.percent(seen.cluster), seen.percent(seen.kind12),
              seen.percent(seen.kind23), seen.percent(seen.kind13), seen.percent(seen.coplanar),
              seen.percent(seen.collinear), seen.percent(seen.duplicates), seen.percent(seen.degenerate));
}

void expect_promise_kept(const fuzz::Family& family, const Distribution& seen) {
  const auto& promise = family.promise;
  EXPECT_GE(seen.percent(seen.four_points), promise.four_points);
  EXPECT_GE(seen.percent(seen.cluster), promise.cluster);
  EXPECT_GE(seen.percent(seen.kind12), promise.kind12);
  EXPECT_GE(seen.percent(seen.kind23), promise.kind23);
  EXPECT_GE(seen.percent(seen.kind13), promise.kind13);
  EXPECT_GE(seen.percent(seen.coplanar), promise.coplanar);
  EXPECT_GE(seen.percent(seen.collinear), promise.collinear);
  EXPECT_GE(seen.percent(seen.duplicates), promise.duplicates);
  EXPECT_GE(seen.percent(seen.degenerate), promise.degenerate);
}

class StationaryAgreement : public ::testing::TestWithParam<fuzz::Family> {
 public:
  static void SetUpTestSuite() {
    std::printf("FLOWCERT_PROPERTY_SEED=%llu, percent of the inputs:\n",
                static_cast<unsigned long long>(seed_of_run()));
    std::printf("%-22s %6s %6s %7s %5s %5s %5s %8s %9s %10s %10s\n", "family", "inputs", "n >= 4", "cluster", "1-2",
                "2-3", "1-3", "coplanar", "collinear", "duplicates", "degenerate");
  }
};

TEST_P(StationaryAgreement, FastAnswerIsTheOracles) {
  CITES("FC-IN-03", "FC-IN-04", "FC-CRIT-02", "FC-CRIT-03", "FC-CRIT-04", "FC-CRIT-05", "FC-CRIT-06", "FC-INV-01",
        "FC-NUM-01", "FC-OUT-01", "FC-OUT-02");
  const fuzz::Family& family = GetParam();
  const rc::Gen<fuzz::Input> inputs = family.generate();
  Distribution seen;
  const bool agreed = expect_holds(family.name, parameters_of_run(kInputsPerFamily), [&] {
    const fuzz::Input input = *inputs;
    const Comparison both = compare(input);
    if (!both.complaint.empty()) {
      RC_FAIL(both.complaint);
    }
    seen.add(input, both.oracle);
  });
  print_row(family.name, seen);
  // A run that was cut short, by a failure or on purpose, says nothing about shares.
  if (agreed && seen.inputs >= kInputsPerFamily / 2) {
    expect_promise_kept(family, seen);
  }
}

std::string test_name(const ::testing::TestParamInfo<fuzz::Family>& info) {
  std::string name = info.param.name;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Families, StationaryAgreement, ::testing::ValuesIn(fuzz::families_and_stable_ones()),
                         test_name);

}  // namespace
}  // namespace flowcert::property::stationary_agreement_test
