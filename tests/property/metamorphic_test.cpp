// Relations between answers of the fast implementation that need no oracle: rows permuted, axes permuted and
// mirrored, everything scaled by a power of two or translated, where that is exact on the doubles.
//
// Guarantees: the transformed answer is compared with the answer of the transformed input exactly, order and
// names included (a merged class is named by its smallest row, so a permutation renames classes too). The
// test fails too when hardly any transformation was other than the identity.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "fuzz/inputs/families.h"
#include "fuzz/inputs/transformations.h"
#include "tests/cites.h"
#include "tests/property/property_parameters.h"
#include "tests/property/stationary_answers.h"
#include "tests/property/transformed_answers.h"
#include "tests/transformed_inputs.h"

namespace flowcert::property::metamorphic_test {
namespace {

constexpr int kInputsPerFamily = 100;

void sort_records(StationaryAnswer& answer) {
  std::sort(answer.records.begin(), answer.records.end(),
            [](const Record& a, const Record& b) { return order_key(a) < order_key(b); });
}

StationaryAnswer renamed(StationaryAnswer answer, const std::vector<std::size_t>& names) {
  for (Record& record : answer.records) {
    for (std::size_t& name : record.contact) {
      name = names[name];
    }
    std::sort(record.contact.begin(), record.contact.end());
  }
  sort_records(answer);
  return answer;
}

StationaryAnswer moved(StationaryAnswer answer, const std::function<RationalPoint(const RationalPoint&)>& move,
                       const Rational& squared_factor) {
  for (Record& record : answer.records) {
    record.center = move(record.center);
    record.squared_distance *= squared_factor;
  }
  return answer;
}

void require_same(const StationaryAnswer& transformed_answer, const fuzz::Input& transformed_input) {
  const std::string complaint = difference(fast_answer(transformed_input), transformed_answer);
  if (!complaint.empty()) {
    std::ostringstream text;
    text << "answer of the transformed input against the transformed answer: " << complaint << "\ntransformed input:\n"
         << transformed_input;
    RC_FAIL(text.str());
  }
}

class Metamorphic : public ::testing::TestWithParam<fuzz::Family> {
 protected:
  void expect_for_inputs(const std::function<void(const fuzz::Input&)>& relation) {
    const rc::Gen<fuzz::Input> inputs = GetParam().generate();
    expect_holds(GetParam().name, parameters_of_run(kInputsPerFamily), [&] { relation(*inputs); });
  }
};

TEST_P(Metamorphic, PermutedRowsPermuteNames) {
  CITES("FC-INV-04", "FC-IN-03", "FC-OUT-02");
  expect_for_inputs([](const fuzz::Input& input) {
    const auto order = *fuzz::row_orders(input.rows.size());
    require_same(renamed(fast_answer(input), names_after(input, order)), fuzz::permuted(input, order));
  });
}

TEST_P(Metamorphic, SignedAxisPermutationMovesCentres) {
  CITES("FC-INV-04");
  expect_for_inputs([](const fuzz::Input& input) {
    const fuzz::AxisMap map = *fuzz::axis_maps().as("axes");
    const auto move = [&map](const RationalPoint& x) { return image_of(x, map); };
    require_same(moved(fast_answer(input), move, 1), fuzz::mapped(input, map));
  });
}

TEST_P(Metamorphic, PowerOfTwoScalesCentres) {
  CITES("FC-INV-04");
  int other_than_identity = 0;
  expect_for_inputs([&](const fuzz::Input& input) {
    const int exponent = *fuzz::exact_scalings(input).as("exponent");
    const Rational factor = power_of_two(exponent);
    const auto move = [&factor](const RationalPoint& x) { return scaled_by(x, factor); };
    require_same(moved(fast_answer(input), move, factor * factor), fuzz::scaled(input, exponent).value());
    other_than_identity += exponent != 0 ? 1 : 0;
  });
  EXPECT_GT(other_than_identity, 0);
}

TEST_P(Metamorphic, ExactTranslationMovesCentres) {
  CITES("FC-INV-04");
  int other_than_identity = 0;
  expect_for_inputs([&](const fuzz::Input& input) {
    const fuzz::Row offset = *fuzz::exact_translations(input).as("offset");
    const auto move = [&offset](const RationalPoint& x) { return translated_by(x, offset); };
    require_same(moved(fast_answer(input), move, 1), fuzz::translated(input, offset).value());
    other_than_identity += offset != fuzz::Row{0, 0, 0} ? 1 : 0;
  });
  // Coordinates with all bits in use, or of mixed magnitudes, hardly ever can be translated exactly.
  const std::string& name = GetParam().name;
  if (name != "general-position" && name != "mixed-magnitudes" && !name.starts_with("rounded")) {
    EXPECT_GT(other_than_identity, 0);
  }
}

std::string test_name(const ::testing::TestParamInfo<fuzz::Family>& info) {
  std::string name = info.param.name;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Families, Metamorphic, ::testing::ValuesIn(fuzz::families()), test_name);

}  // namespace
}  // namespace flowcert::property::metamorphic_test
