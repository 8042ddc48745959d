// Claims are read the same in a process whose locale has a decimal comma, as Python's may.
//
// Few machines have such a locale. So this program has a localeconv() of its own, which JSON's parser asks, and which
// tells of a comma while a test wants it.
#include <gtest/gtest.h>

#include <clocale>
#include <string>

#include "flowcert/claim.h"
#include "tests/cites.h"

namespace {

bool has_comma = false;

}  // namespace

// The C library's declaration says that it throws nothing.
extern "C" lconv* localeconv() noexcept {
  static char point[] = ".", comma[] = ",", nothing[] = "";
  static lconv convention = {};
  convention.decimal_point = has_comma ? comma : point;
  convention.thousands_sep = convention.grouping = nothing;
  return &convention;
}

namespace flowcert::claim_locale_test {
namespace {

TEST(ClaimLocale, ADecimalCommaChangesNoNumber) {
  CITES("FC-CLAIM-05");
  const std::string claim =
      "{\"format\":\"flowcert-stationary-points\",\"format_version\":1}\n"
      "{\"index\":1,\"contact\":[0,1],\"center\":[0.5,1e-3,-2.25E+1],\"squared_distance\":0.25}\n";
  const auto positions = [&] {
    std::string text;
    for (const ClaimedPoint& point : read_claim_from(claim, "claim").points) {
      for (const ClaimedNumber& number : *point.center) text += to_text(number.value) + ' ';
    }
    return text;
  };
  const std::string right = positions();
  EXPECT_EQ(right, "1/2 1/1000 -45/2 ");
  has_comma = true;
  EXPECT_EQ(positions(), right);
  has_comma = false;
}

}  // namespace
}  // namespace flowcert::claim_locale_test
