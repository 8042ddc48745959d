// How many inputs a property test draws, and from which seed.
//
// Guarantees: the same inputs in every run unless the environment says otherwise: FLOWCERT_PROPERTY_SCALE
// multiplies the number of inputs, FLOWCERT_PROPERTY_SEED changes the seed. Both are printed, so that a log
// is enough to run it again.
#pragma once

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <sstream>
#include <string>
#include <utility>

#include "tests/run_scale.h"

namespace flowcert::property {

inline std::uint64_t seed_of_run() {
  const char* text = std::getenv("FLOWCERT_PROPERTY_SEED");
  return text == nullptr ? 20080609 : std::strtoull(text, nullptr, 10);
}

using flowcert_tests::is_whole_run;
using flowcert_tests::scale_of_run;

// Parameters for so many inputs of sizes 0 to 100. Shrinking a large input takes longer than anybody waits.
inline rc::detail::TestParams parameters_of_run(int inputs, bool shrinks = true) {
  rc::detail::TestParams parameters;
  parameters.disableShrinking = !shrinks;
  parameters.seed = seed_of_run();
  parameters.maxSuccess = std::max(1, static_cast<int>(inputs * scale_of_run()));
  return parameters;
}

// For an input that is not drawn: once, at any scale.
inline rc::detail::TestParams parameters_of_one_input() {
  rc::detail::TestParams parameters = parameters_of_run(1);
  parameters.maxSuccess = 1;
  return parameters;
}

// Runs a property, which is a callable that draws with *gen and fails with RC_FAIL. A failure is shrunk
// before it is reported. Returns whether the property held.
template <typename Property>
bool expect_holds(const std::string& name, const rc::detail::TestParams& parameters, Property&& property) {
  // RapidCheck announces the seed of its own configuration, which would be a random one, on first use.
  ::setenv("RC_PARAMS", ("seed=" + std::to_string(parameters.seed)).c_str(), 0);
  const auto result =
      rc::detail::checkTestable(std::forward<Property>(property), rc::detail::TestMetadata{name, name}, parameters);
  if (result.template is<rc::detail::SuccessResult>()) {
    return true;
  }
  std::ostringstream text;
  rc::detail::printResultMessage(result, text);
  ADD_FAILURE() << name << ", FLOWCERT_PROPERTY_SEED=" << parameters.seed << '\n' << text.str();
  return false;
}

}  // namespace flowcert::property
